//! Profiles against the even-odd rule.

use proptest::prelude::*;
use vc_geometry::profile::{simplified, slabs};
use vc_graph::Seed;
use vc_graph::portable::Portable;

type At = (f32, f32);

/// An outline around a point that is seen from there as a whole.
fn star(seed: u64) -> Vec<At> {
    let mut stream = Seed(seed).stream();
    let count = stream.count(3, 12);
    let corner = |i: usize| {
        let (turn, far) = (std::f32::consts::TAU * i as f32 / count as f32, stream.between(0.3, 1.0));
        (far * turn.cosine(), far * turn.sine())
    };
    (0..count).map(corner).collect()
}

fn sides(outline: &[At]) -> impl Iterator<Item = (At, At)> + '_ {
    outline.iter().copied().zip(outline.iter().copied().cycle().skip(1))
}

/// Whether a point is inside: a line from it to the right crosses an odd number of sides.
fn is_inside(outline: &[At], (x, y): At) -> bool {
    let crosses = |(a, b): &(At, At)| (a.1 <= y) != (b.1 <= y) && x < a.0 + (b.0 - a.0) * (y - a.1) / (b.1 - a.1);
    sides(outline).filter(crosses).count() % 2 == 1
}

fn distance(outline: &[At], (x, y): At) -> f32 {
    let to_side = |(a, b): (At, At)| {
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let along = (((x - a.0) * dx + (y - a.1) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
        (a.0 + along * dx - x).hypot(a.1 + along * dy - y)
    };
    sides(outline).map(to_side).fold(f32::INFINITY, f32::min)
}

proptest! {
    #![proptest_config(crate::cases(200))]
    #[test]
    fn slabs_cover_what_is_inside(seed: u64, x in -1.0_f32..1.0, y in -1.0_f32..1.0) {
        let outline = star(seed);
        let cut = slabs(&outline);
        let over = cut.iter().filter(|s| {
            let up = (y - s.bottom) / (s.top - s.bottom);
            let end = |low: f32, high: f32| low + (high - low) * up;
            (0.0..1.0).contains(&up) && (end(s.low.0, s.high.0)..end(s.low.1, s.high.1)).contains(&x)
        });
        let over = over.count();
        prop_assume!(distance(&outline, (x, y)) > 1e-3);
        prop_assert_eq!(over, usize::from(is_inside(&outline, (x, y))));
        let area: f32 = cut.iter().map(|s| (s.top - s.bottom) * (s.low.1 - s.low.0 + s.high.1 - s.high.0) / 2.0).sum();
        let obvious: f32 = sides(&outline).map(|(a, b)| (a.0 * b.1 - b.0 * a.1) / 2.0).sum();
        prop_assert!((area - obvious).abs() < 1e-3, "{} {}", area, obvious);
    }

    #[test]
    fn simplified_outlines_stay_within_the_tolerance(seed: u64, tolerance in 0.0_f32..0.2) {
        let outline = star(seed);
        let few = simplified(&outline, tolerance);
        prop_assert!(few.iter().all(|p| outline.contains(p)) && few.len() <= outline.len());
        prop_assert!(outline.iter().all(|p| distance(&few, *p) <= tolerance + 1e-6));
        prop_assert_eq!((few.first(), few.last()), (outline.first(), outline.last()));
    }
}
