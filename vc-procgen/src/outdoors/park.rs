//! Things in parks: benches and lamps along paths, playgrounds, courts.

use nalgebra::Vector2;
use vc_graph::portable::Portable;
use vc_map::Point;

use super::stock::Stock;
use super::{Outdoors, Place};
use crate::city::{Park, ParkFeature, left};
use crate::item::Item;

/// The distances of benches and of lamps along a path, and from its edge, metres.
const BENCHES: f64 = 28.0;
const LAMPS: f64 = 22.0;
const BESIDE: f64 = 0.6;
/// The first stands this far from a gate, metres.
const FIRST: f64 = 7.0;
/// The things of a playground, and where they stand: shares of its length and width from its middle.
const PLAYGROUND: [(&str, [f64; 2]); 6] = [
    ("swing_set", [-0.28, 0.0]),
    ("slide", [0.05, 0.22]),
    ("climbing_frame", [0.3, 0.15]),
    ("sandbox", [0.28, -0.25]),
    ("seesaw", [0.0, -0.25]),
    ("spring_rider", [0.12, -0.05]),
];
/// The hoops of a court stand so far from its middle, as a share of its length.
const HOOPS: f64 = 0.43;

/// All of it within the reach of a place.
pub(super) fn items(outdoors: &Outdoors<'_>, place: &Place, stock: &mut Stock<'_>) -> Vec<Item> {
    let blocks = outdoors.blocks.around(&place.at, place.reach);
    let parks = outdoors.city.parks().iter().filter(|park| blocks.contains(&park.block));
    let mut items = Vec::new();
    for park in parks {
        // Benches and lamps are alike in a park.
        let seed = outdoors.city.seed().child("park").nth(park.block as u64);
        let all = paths(park).into_iter().chain(features(park));
        for (class, at, heading) in all.filter(|(_, at, _)| place.distance(at) < place.reach) {
            items.extend(stock.instance((class, seed.child(class)), &at, heading, 0.0));
        }
    }
    items
}

fn heading(along: &Vector2<f64>) -> f64 {
    along.y.angle_to(along.x)
}

/// Benches on one side of each path, lamps on the other; both face it.
fn paths(park: &Park) -> Vec<(&'static str, Point, f64)> {
    let mut found = Vec::new();
    for gate in &park.gates {
        let (along, length) = ((park.middle - gate).normalize(), (park.middle - gate).norm() - park.path * 2.0);
        for (class, apart, side) in [("park_bench", BENCHES, 1.0), ("street_lamp", LAMPS, -1.0)] {
            let out = left(along) * side;
            let count = ((length - FIRST) / apart).floor().max(0.0) as usize;
            let at = |i: usize| gate + along * (FIRST + apart * i as f64) + out * (park.path / 2.0 + BESIDE);
            found.extend((0..=count).filter(|_| length > FIRST).map(|i| (class, at(i), heading(&-out))));
        }
    }
    found
}

fn features(park: &Park) -> Vec<(&'static str, Point, f64)> {
    let mut found = Vec::new();
    for (kind, ring) in &park.features {
        let Some([a, b]) = ring.windows(2).map(|ends| [ends[0], ends[1]]).max_by(longer) else { continue };
        let sum = ring.iter().fold(Vector2::zeros(), |sum, corner| sum + corner.coords);
        let middle = Point::from(sum / ring.len() as f64);
        let (along, length) = ((b - a).normalize(), (b - a).norm());
        let across = ring.iter().map(|corner| left(along).dot(&(corner - a))).fold(0.0, f64::max);
        let place = |[x, y]: [f64; 2]| middle + along * (x * length) + left(along) * (y * across);
        match kind {
            ParkFeature::Playground => {
                found.extend(PLAYGROUND.iter().map(|(class, at)| (*class, place(*at), heading(&along))));
            }
            ParkFeature::Court => found.extend(
                [-1.0, 1.0].map(|end| ("basketball_hoop", place([end * HOOPS, 0.0]), heading(&(along * -end)))),
            ),
            ParkFeature::Pond => {}
        }
    }
    found
}

fn longer(a: &[Point; 2], b: &[Point; 2]) -> std::cmp::Ordering {
    (a[1] - a[0]).norm().total_cmp(&(b[1] - b[0]).norm())
}
