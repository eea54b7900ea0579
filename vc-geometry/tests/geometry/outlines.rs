//! Outlines against definitions.

use nalgebra::Point2;
use proptest::prelude::*;
use vc_geometry::outline::{contains, crosses, hull, turn};

/// Points of a coarse raster: many coincide, and many lie on one line.
fn points(most: usize) -> impl Strategy<Value = Vec<Point2<f32>>> {
    prop::collection::vec(point(), 0..most)
}

fn point() -> impl Strategy<Value = Point2<f32>> {
    (0_u8..9, 0_u8..9).prop_map(|(x, y)| Point2::new(f32::from(x), f32::from(y)))
}

/// Whether some line has an outline on one side and a segment on the other, with whole numbers: a line along or across
/// the way between two of their points.
fn are_separate(outline: &[Point2<f32>], ends: &[Point2<f32>]) -> bool {
    let whole = |p: &Point2<f32>| (p.x as i64, p.y as i64);
    let (outline, ends): (Vec<_>, Vec<_>) = (outline.iter().map(whole).collect(), ends.iter().map(whole).collect());
    let all = || outline.iter().chain(&ends);
    let ways = all().flat_map(|p| all().map(move |q| (q.0 - p.0, q.1 - p.1))).flat_map(|(x, y)| [(x, y), (-y, x)]);
    let along = |way: (i64, i64), p: &(i64, i64)| way.0 * p.0 + way.1 * p.1;
    // Each way is tried in both directions.
    ways.into_iter().any(|way| outline.iter().map(|p| along(way, p)).max() < ends.iter().map(|p| along(way, p)).min())
}

proptest! {
    #![proptest_config(crate::cases(200))]
    #[test]
    fn a_hull_has_exactly_the_corners_that_no_others_enclose(all in points(24)) {
        let hull = hull(all.iter().copied());
        // A point is a corner if it is in no triangle or segment of other points.
        let corner = |p: &Point2<f32>| {
            let others: Vec<_> = all.iter().filter(|q| *q != p).collect();
            let inside = |a: &Point2<f32>, b: &Point2<f32>, c: &Point2<f32>| {
                turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0 && turn(a, b, c) > 0.0
            };
            let between = |a: &Point2<f32>, b: &Point2<f32>| turn(a, b, p) == 0.0 && (a - p).dot(&(b - p)) <= 0.0;
            !others.iter().any(|a| {
                others.iter().any(|b| between(a, b) || others.iter().any(|c| inside(a, b, c)))
            })
        };
        let mut corners: Vec<_> = all.iter().copied().filter(corner).collect();
        let order = |a: &Point2<f32>, b: &Point2<f32>| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y));
        corners.sort_by(order);
        corners.dedup();
        let mut sorted = hull.clone();
        sorted.sort_by(order);
        prop_assert_eq!(sorted, corners);
        let convex = |i: usize| turn(&hull[i], &hull[(i + 1) % hull.len()], &hull[(i + 2) % hull.len()]) > 0.0;
        prop_assert!(hull.len() < 3 || (0..hull.len()).all(convex));
        prop_assert!(hull.len() < 3 || contains(&hull, &all));
    }

    #[test]
    fn a_segment_crosses_an_outline_unless_a_line_separates_them(all in points(9), ends in [point(), point()]) {
        let outline = hull(all);
        prop_assert_eq!(crosses(&outline, &ends[0], &ends[1]), !are_separate(&outline, &ends));
    }
}
