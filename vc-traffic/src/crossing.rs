//! Crossings as vehicles and people see them: where the carriageway begins, and how far beyond a junction a vehicle is clear of them.

use vc_map::{JunctionId, LaneId, Point, Polyline, RoadCrossing, StreetMap};

/// Lines are looked at in steps of so many metres.
const STEP: f64 = 0.25;
/// Kerbs are found to so many metres, and people wait so far before them.
pub(crate) const KERB: f32 = 0.05;
/// The sides of a vehicle are at most so far from the middle of its lane, metres.
const BESIDE: f64 = 1.4;
/// A vehicle is clear of a crossing when its rear is so far beyond, metres; further than this from a junction there is none.
const BEYOND: f64 = 0.5;
const FAR: f64 = 25.0;
/// A crossing over a junction's arm.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Crosswalk {
    pub(crate) junction: u32,
    /// Its row in the table of the junction.
    pub(crate) row: u32,
    /// The stations of its line between which it is on the carriageway, metres.
    pub(crate) kerbs: [f32; 2],
}

/// All crossings of a map.
pub(crate) fn crosswalks(map: &StreetMap) -> Vec<Crosswalk> {
    let of = |(number, crossing): (usize, &RoadCrossing)| {
        let own = map.junction(crossing.junction);
        let place = |junction: &vc_map::Junction| junction.crossings.iter().position(|id| id.index() == number);
        let row = own.map_or(0, |junction| junction.movements.len() + place(junction).unwrap_or(0));
        Crosswalk { junction: crossing.junction.0, row: row as u32, kerbs: kerbs(map, crossing) }
    };
    map.crossings().iter().enumerate().map(of).collect()
}

/// Stations along a line, with its end.
fn stations(length: f64) -> impl Iterator<Item = f64> {
    stations_by(length, STEP)
}

fn stations_by(length: f64, metres: f64) -> impl Iterator<Item = f64> {
    (0..=(length / metres).ceil() as u32).map(move |step| (f64::from(step) * metres).min(length))
}

fn kerbs(map: &StreetMap, crossing: &RoadCrossing) -> [f32; 2] {
    let roads: Vec<_> = crossing.roads.iter().filter_map(|id| map.road(*id)).collect();
    let on =
        |at: &Point| roads.iter().any(|road| road.line.project(at).left.abs() < road.draft.section.surface() / 2.0);
    let length = crossing.line.length();
    // All over its width, as a crossing may be askew.
    let across = |station: f64| [-0.5, 0.0, 0.5].map(|part| beside(&crossing.line, station, part * crossing.width));
    let step = f64::from(KERB);
    let mut over = stations_by(length, step).filter(|station| across(*station).iter().any(on));
    let first = over.next();
    let last = over.last().or(first);
    [(first.unwrap_or(0.0) - step).max(0.0) as f32, (last.unwrap_or(length) + step).min(length) as f32]
}

/// The point beside a station of a line, so far to its left, metres.
fn beside(line: &Polyline, station: f64, left: f64) -> Point {
    let along = line.direction(station);
    line.at(station) + nalgebra::Vector2::new(-along.y, along.x) * left
}

/// How far beyond the end of a movement the rear of a vehicle is clear of the crossings that it leads over, metres; 0 without one.
pub(crate) fn clear(map: &StreetMap, junction: JunctionId, row: usize) -> f32 {
    let Some(junction) = map.junction(junction) else { return 0.0 };
    let lane = junction.movements.get(row).and_then(|id| map.movement(*id)).and_then(|movement| map.lane(movement.to));
    let Some(lane) = lane else { return 0.0 };
    let rows = junction.crossings.iter().enumerate().map(|(place, id)| (junction.movements.len() + place, *id));
    let met = rows.filter(|(other, _)| junction.conflicts.has(row, *other)).filter_map(|(_, id)| map.crossing(id));
    let beyond = |crossing: &RoadCrossing| {
        let on =
            |station: &f64| crossing.line.project(&lane.line.at(*station)).left.abs() < crossing.width / 2.0 + BESIDE;
        stations(lane.line.length().min(FAR)).filter(on).last().map_or(0.0, |station| station + BEYOND)
    };
    met.map(beyond).fold(0.0, f64::max) as f32
}

/// Whether a movement passes a crossing before it waits at a station, or comes from its road.
pub(crate) fn is_before(map: &StreetMap, crossing: &RoadCrossing, from: LaneId, line: &Polyline, station: f64) -> bool {
    let own = map.lane(from).is_some_and(|lane| crossing.roads.contains(&lane.road));
    let on = |at: &Point| crossing.line.project(at).left.abs() < crossing.width / 2.0 + BESIDE;
    own || stations(station).any(|at| on(&line.at(at)))
}
