//! Conflicts and phases, checked without the code that made them.

use crate::{ConflictTable, JunctionId, Light, Movement, Point, Signal, StreetMap, Users};

/// The distance between two samples on a movement, metres.
const STEP: f64 = 0.25;
/// Those whose middles come nearer than this touch: half the widths of two bicycles, or of a bicycle and a car, or of two
/// cars, metres.
const TOUCH: [f64; 3] = [0.5, 1.0, 1.6];

/// The pairs of movements and crossings of a junction that meet and that a table lacks: places each quarter of a metre are
/// held against each other. Costs the product of the lengths.
pub fn missing_conflicts(map: &StreetMap, junction: JunctionId, table: &ConflictTable) -> Vec<(usize, usize)> {
    let Some(place) = map.junction(junction) else { return Vec::new() };
    let movements: Vec<&Movement> = place.movements.iter().filter_map(|id| map.movement(*id)).collect();
    let samples: Vec<Vec<Point>> = movements.iter().map(|movement| sampled(movement)).collect();
    let mut missing = Vec::new();
    for (one, a) in movements.iter().enumerate() {
        for (other, b) in movements.iter().enumerate().skip(one + 1) {
            let reach = TOUCH[usize::from(is_wide(a)) + usize::from(is_wide(b))];
            let touch = || samples[one].iter().any(|p| samples[other].iter().any(|q| (p - q).norm() < reach));
            if a.from != b.from && !table.has(one, other) && touch() {
                missing.push((one, other));
            }
        }
        for (position, id) in place.crossings.iter().enumerate() {
            let Some(crossing) = map.crossing(*id) else { continue };
            let road = |lane| map.lane(lane).map(|lane| lane.road);
            let over = [a.from, a.to].into_iter().filter_map(road).any(|road| crossing.roads.contains(&road));
            if over && !table.has(one, movements.len() + position) {
                missing.push((one, movements.len() + position));
            }
        }
    }
    missing
}

fn is_wide(movement: &Movement) -> bool {
    !movement.users.without(Users::BICYCLE).is_empty()
}

fn sampled(movement: &Movement) -> Vec<Point> {
    let steps = (movement.line.length() / STEP).ceil().clamp(1.0, 1000.0) as u32;
    (0..=steps).map(|step| movement.line.at(movement.line.length() * f64::from(step) / f64::from(steps))).collect()
}

/// The phases of a signal in which two that conflict have green and neither gives way: the phase and the pair.
pub fn unsafe_phases(signal: &Signal, table: &ConflictTable) -> Vec<(usize, (usize, usize))> {
    let mut found = Vec::new();
    for (phase, lights) in signal.phases.iter().map(|phase| &phase.lights).enumerate() {
        let green = |row: usize| lights.get(row) == Some(&Light::Green);
        found.extend(table.pairs().filter(|(a, b)| green(*a) && green(*b)).map(|pair| (phase, pair)));
    }
    found
}
