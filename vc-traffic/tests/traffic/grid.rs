//! Maps and trips for tests.

use vc_graph::Seed;
use vc_map::{Control, CrossSection, DrivingSide, MapDraft, RoadClass, RoadId, StreetMap, Strip};
use vc_traffic::{Kerb, Trip};

/// A grid of streets: so many junctions in each direction, 200 m apart, with lanes for each direction.
pub(crate) fn grid(size: usize, lanes: usize, control: Control, side: DrivingSide) -> StreetMap {
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
    let strips = || vec![Strip::driving(3.25, 13.9); lanes];
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
    draft.build().unwrap()
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
