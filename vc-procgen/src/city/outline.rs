//! The outline of a city.

use vc_graph::Seed;
use vc_graph::portable::Portable;
use vc_map::Point;

use super::convex::area as area_of;
use super::field::StreetPattern;

/// The outline of a city of an area in square metres about the origin, counter-clockwise: a rectangle with corners cut
/// off, or an octagon.
pub(super) fn outline(pattern: StreetPattern, heading: f64, area: f64, seed: Seed) -> Vec<Point> {
    let mut stream = seed.child("outline").stream();
    let wide = f64::from(stream.between(1.0, 1.25));
    let mut ring = Vec::new();
    for (index, [x, y]) in [[-wide, -1.0], [wide, -1.0], [wide, 1.0], [-wide, 1.0]].into_iter().enumerate() {
        let share = f64::from(stream.between(0.25, 0.55));
        // The corners at the water stay, but for those of an octagon.
        let cut = pattern == StreetPattern::Radial || (index > 1 && stream.chance(0.5));
        if cut {
            let [upright, level] = [[x, y - y.signum() * share], [x - x.signum() * share, y]];
            ring.extend(if index % 2 == 0 { [upright, level] } else { [level, upright] });
        } else {
            ring.push([x, y]);
        }
    }
    let (sine, cosine) = heading.sine_cosine();
    let ring: Vec<Point> =
        ring.into_iter().map(|[x, y]| Point::new(x * cosine - y * sine, x * sine + y * cosine)).collect();
    let scale = (area / area_of(&ring)).sqrt();
    ring.into_iter().map(|point| point * scale).collect()
}
