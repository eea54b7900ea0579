//! Maps and trips for tests.

use vc_graph::Seed;
use vc_map::{
    Building, BuildingId, Control, CrossSection, CrossingDraft, CrossingKind, DrivingSide, EntranceDraft, EntranceId,
    MapDraft,
};
use vc_map::{RoadClass, RoadId, StreetMap, Strip};
use vc_traffic::{Kerb, Trip, Walk};

/// A grid of streets: so many junctions in each direction, 200 m apart, with lanes for each direction.
pub(crate) fn grid(size: usize, lanes: usize, control: Control, side: DrivingSide) -> StreetMap {
    draft(size, lanes, control, side, &[]).build().unwrap()
}

/// The same with pavements, and a house on each side of each street.
pub(crate) fn town(size: usize, lanes: usize, control: Control, side: DrivingSide) -> StreetMap {
    let mut draft = draft(size, lanes, control, side, &[Strip::pavement(2.5)]);
    let middles: Vec<[f64; 2]> = draft
        .roads
        .iter()
        .map(|road| {
            let [a, b] = [road.from, road.to].map(|id| draft.junctions[id.index()].at);
            [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0]
        })
        .collect();
    if lanes > 1 && control != Control::Signals {
        // Over wide streets people cross where there are zebras.
        let ends = draft.roads.iter().enumerate().flat_map(|(number, road)| [(number, road.from), (number, road.to)]);
        let inner = ends.filter(|(_, at)| draft.junctions[at.index()].control == control);
        let road = |(number, at)| CrossingDraft {
            at,
            road: RoadId(number as u32),
            kind: CrossingKind::Marked,
            island: false,
            source: 0,
        };
        draft.crossings = inner.map(road).collect();
    }
    let away = 3.25 * lanes as f64 + 5.0;
    for (number, [x, y]) in middles.into_iter().enumerate() {
        // Streets run along X where their middle lies between junctions there.
        let along = (x / 200.0).fract() != 0.0;
        for side in [-1.0, 1.0] {
            let at = |along_by: f64, by: f64| {
                let by = (by + away) * side;
                let shift = if number % 2 == 0 { 20.0 } else { -35.0 };
                if along { [x + along_by + shift, y + by] } else { [x + by, y + along_by + shift] }
            };
            draft.buildings.push(Building::new(vec![at(-5.0, 0.0), at(5.0, 0.0), at(0.0, 8.0)], 3));
            let building = BuildingId(draft.buildings.len() as u32 - 1);
            draft.entrances.push(EntranceDraft { building, at: at(0.0, 0.0), kind: "main".into(), source: 0 });
        }
    }
    draft.build().unwrap()
}

/// Random walks over a map: so many, which begin within some seconds.
pub(crate) fn walks(map: &StreetMap, count: usize, seconds: f32, seed: Seed) -> Vec<Walk> {
    let mut numbers = seed.child("walks").stream();
    let doors = map.entrances().len();
    let walk = |_| {
        let from = numbers.below(doors);
        let to = (from + 1 + numbers.below(doors - 1)) % doors;
        let [from, to] = [from, to].map(|door| EntranceId(door as u32));
        Walk { departs: numbers.between(0.0, seconds), from, to }
    };
    (0..count).map(walk).collect()
}

fn draft(size: usize, lanes: usize, control: Control, side: DrivingSide, beside: &[Strip]) -> MapDraft {
    let mut draft = MapDraft::new("grid", 48.0, 11.0);
    draft.side = side;
    let at = |x: usize, y: usize| [x as f64 * 200.0, y as f64 * 200.0];
    let inner = |x: usize, y: usize| (1..=size).contains(&x) && (1..=size).contains(&y);
    let mut ids = vec![vec![None; size + 2]; size + 2];
    for (x, column) in ids.iter_mut().enumerate() {
        for (y, id) in column.iter_mut().enumerate() {
            let corner = !inner(x, y) && !(1..=size).contains(&x) && !(1..=size).contains(&y);
            if !corner {
                *id = Some(draft.junction(at(x, y), if inner(x, y) { control } else { Control::Edge }));
            }
        }
    }
    let strips = || {
        let mut strips = vec![Strip::driving(3.25, 13.9); lanes];
        strips.extend_from_slice(beside);
        strips
    };
    for x in 0..size + 2 {
        for y in 0..size + 2 {
            for (dx, dy) in [(1, 0), (0, 1)] {
                let (a, b) = ((x, y), (x + dx, y + dy));
                if b.0 > size + 1 || b.1 > size + 1 || !(inner(a.0, a.1) || inner(b.0, b.1)) {
                    continue;
                }
                if let (Some(from), Some(to)) = (ids[a.0][a.1], ids[b.0][b.1]) {
                    let section = CrossSection { forward: strips(), backward: strips(), median: 0.0 };
                    draft.road(from, to, RoadClass::Secondary, section);
                }
            }
        }
    }
    draft
}

/// Random trips over a map: so many, which begin within some seconds, of these kinds.
pub(crate) fn trips(map: &StreetMap, count: usize, seconds: f32, classes: &[u8], seed: Seed) -> Vec<Trip> {
    let sides: Vec<(RoadId, bool, f32)> = map
        .lanes()
        .iter()
        .filter(|lane| lane.users.has(vc_map::Users::CAR) && lane.line.length() > 30.0)
        .map(|lane| (lane.road, lane.forward, lane.line.length() as f32))
        .collect();
    let mut numbers = seed.stream();
    let mut kerb = || {
        let (road, forward, length) = sides[numbers.below(sides.len())];
        Kerb { road, forward, station: numbers.between(15.0, length - 12.0) }
    };
    let ends: Vec<(Kerb, Kerb)> = (0..count).map(|_| (kerb(), kerb())).collect();
    let mut numbers = seed.child("times").stream();
    ends.into_iter()
        .map(|(from, to)| Trip {
            class: classes[numbers.below(classes.len())],
            departs: numbers.between(0.0, seconds),
            from,
            to,
        })
        .collect()
}
