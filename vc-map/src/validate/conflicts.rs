//! Conflicts and phases, checked without the code that made them.

use crate::{ConflictTable, CrossingId, JunctionId, Light, Movement, Point, Polyline, Signal, StreetMap, Users};

/// The distance between two samples on a movement, metres.
const STEP: f64 = 0.25;
/// Those whose middles come nearer than this touch: half the widths of two bicycles, or of a bicycle and a car, or of two
/// cars, metres.
const TOUCH: [f64; 3] = [0.5, 1.0, 1.6];
/// A crossing lies within this of the junction, along the lanes, metres.
const NEAR: f64 = 15.0;
/// The speed of people who have begun to cross, metres per second.
const WALKING: f64 = 1.07;

/// The pairs of movements and crossings of a junction that meet and that a table lacks: places on one each quarter of a metre
/// are held against the other. Crossings are met by a movement or by its lanes close to the junction. Costs the places of all
/// movements times the pieces of those near them.
///
/// ```
/// use vc_map::validate::missing_conflicts;
/// use vc_map::{ConflictTable, Control, CrossSection, MapDraft, RoadClass, Strip};
/// let mut draft = MapDraft::new("crossroads", 48.1, 11.6);
/// let middle = draft.junction([0.0, 0.0], Control::Priority);
/// for end in [[90.0, 0.0], [0.0, 90.0], [-90.0, 0.0], [0.0, -90.0]] {
///     let end = draft.junction(end, Control::Edge);
///     let side = vec![Strip::driving(3.0, 8.3)];
///     draft.road(end, middle, RoadClass::Minor, CrossSection { forward: side.clone(), backward: side, median: 0.0 });
/// }
/// let map = draft.build()?;
/// let table = &map.junction(middle).ok_or("none")?.conflicts;
/// assert_eq!(missing_conflicts(&map, middle, table), []);
/// assert!(missing_conflicts(&map, middle, &ConflictTable::new(table.size())).len() > 20);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn missing_conflicts(map: &StreetMap, junction: JunctionId, table: &ConflictTable) -> Vec<(usize, usize)> {
    let Some(place) = map.junction(junction) else { return Vec::new() };
    let movements: Vec<&Movement> = place.movements.iter().filter_map(|id| map.movement(*id)).collect();
    let samples: Vec<Vec<Point>> = movements.iter().map(|movement| sampled(movement)).collect();
    let mut missing = Vec::new();
    for (one, a) in movements.iter().enumerate() {
        for (other, b) in movements.iter().enumerate().skip(one + 1) {
            let reach = TOUCH[usize::from(is_wide(a)) + usize::from(is_wide(b))];
            let touch = || samples[one].iter().any(|p| (b.line.project(p).point - p).norm() < reach);
            if a.from != b.from && !table.has(one, other) && near(a, b, reach) && touch() {
                missing.push((one, other));
            }
        }
        for (position, id) in place.crossings.iter().enumerate() {
            let met = map.crossing(*id).is_some_and(|crossing| meets(map, a, &crossing.line));
            if met && !table.has(one, movements.len() + position) {
                missing.push((one, movements.len() + position));
            }
        }
    }
    missing
}

/// Whether the boxes around two movements come nearer to each other than a distance.
fn near(a: &Movement, b: &Movement, distance: f64) -> bool {
    let ([low, high], [lower, upper]) = (a.line.bounds(), b.line.bounds());
    let gap = (low - upper).sup(&(lower - high));
    gap.x < distance && gap.y < distance
}

/// Whether a line crosses a movement or the ends of its lanes at the junction.
fn meets(map: &StreetMap, movement: &Movement, line: &Polyline) -> bool {
    let lane = |id| map.lane(id).map(|lane| &lane.line);
    let before = lane(movement.from).and_then(|line| line.part(line.length() - NEAR, line.length()));
    let after = lane(movement.to).and_then(|line| line.part(0.0, NEAR));
    before.iter().chain([&movement.line]).chain(&after).any(|part| part.crosses(line))
}

fn is_wide(movement: &Movement) -> bool {
    !movement.users.without(Users::BICYCLE).is_empty()
}

fn sampled(movement: &Movement) -> Vec<Point> {
    let steps = (movement.line.length() / STEP).ceil().clamp(1.0, 1000.0) as u32;
    (0..=steps).map(|step| movement.line.at(movement.line.length() * f64::from(step) / f64::from(steps))).collect()
}

/// The phases of a signal in which two that conflict have green and neither gives way: the phase and the pair. Costs the
/// pairs of the table for each phase; [`StreetMap::validate`] calls it for all signals.
///
/// ```
/// use vc_map::validate::unsafe_phases;
/// use vc_map::{ConflictTable, Control, CrossSection, Light, MapDraft, RoadClass, Strip};
/// let mut draft = MapDraft::new("crossroads", 48.1, 11.6);
/// let middle = draft.junction([0.0, 0.0], Control::Signals);
/// for end in [[90.0, 0.0], [0.0, 90.0], [-90.0, 0.0], [0.0, -90.0]] {
///     let end = draft.junction(end, Control::Edge);
///     let side = vec![Strip::driving(3.0, 8.3)];
///     draft.road(end, middle, RoadClass::Minor, CrossSection { forward: side.clone(), backward: side, median: 0.0 });
/// }
/// let map = draft.build()?;
/// let (mut signal, table) = (map.signals()[0].clone(), &map.junction(middle).ok_or("none")?.conflicts);
/// assert_eq!(unsafe_phases(&signal, table), []);
/// signal.phases[0].lights.fill(Light::Green);
/// assert!(unsafe_phases(&signal, table).len() > 20);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn unsafe_phases(signal: &Signal, table: &ConflictTable) -> Vec<(usize, (usize, usize))> {
    let mut found = Vec::new();
    for (phase, lights) in signal.phases.iter().map(|phase| &phase.lights).enumerate() {
        let green = |row: usize| lights.get(row) == Some(&Light::Green);
        found.extend(table.pairs().filter(|(a, b)| green(*a) && green(*b)).map(|pair| (phase, pair)));
    }
    found
}

/// The crossings whose green ends, with phase and seconds, so little before a vehicle that waited starts across them that
/// people who have just begun to cross are still under way, at 1.07 m/s. Costs the phases for each crossing.
pub fn short_clearances(map: &StreetMap, signal: &Signal) -> Vec<(usize, CrossingId, f64)> {
    let Some(junction) = map.junction(signal.junction) else { return Vec::new() };
    let (movements, count) = (junction.movements.len(), signal.phases.len());
    let lit = |phase: usize, row: usize| {
        let light = signal.phases[phase % count].lights.get(row);
        matches!(light, Some(Light::Green | Light::GreenYield))
    };
    let mut short = Vec::new();
    for (position, id) in junction.crossings.iter().enumerate() {
        let row = movements + position;
        let needed = map.crossing(*id).map_or(0.0, |crossing| crossing.line.length()) / WALKING;
        for phase in (0..count).filter(|phase| lit(*phase, row) && !lit(phase + 1, row)) {
            let starts = |later: &usize| {
                (0..movements).any(|m| junction.conflicts.has(m, row) && lit(*later, m) && !lit(later - 1, m))
            };
            let next = (phase + 1..=phase + count).find(starts).unwrap_or(phase + count);
            let seconds: f64 = (phase + 1..next).map(|later| signal.phases[later % count].seconds).sum();
            if seconds < needed - 1e-6 {
                short.push((phase, *id, seconds));
            }
        }
    }
    short
}
