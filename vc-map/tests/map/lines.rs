//! Lines against a slow obvious version.

use proptest::prelude::*;
use vc_map::{Point, Polyline};
use vc_testkit::cases;

fn line() -> impl Strategy<Value = Polyline> {
    let point = (-100.0..100.0, -100.0..100.0).prop_map(|(x, y): (f64, f64)| [x, y]);
    prop::collection::vec(point, 2..8).prop_filter_map("points differ", Polyline::new)
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn a_projection_is_the_nearest_of_many_points(line in line(), x in -150.0..150.0, y in -150.0..150.0) {
        let point = Point::new(x, y);
        let near = line.project(&point);
        let away = (near.point - point).norm();
        prop_assert!((away - near.left.abs()).abs() < 1e-6);
        prop_assert!((line.at(near.station) - near.point).norm() < 1e-6);
        let sampled = (0..=2000).map(|i| (line.at(line.length() * f64::from(i) / 2000.0) - point).norm()).fold(f64::INFINITY, f64::min);
        prop_assert!(away <= sampled + 1e-9 && sampled <= away + line.length() / 2000.0);
    }

    #[test]
    fn parts_make_up_the_line(line in line(), cut in 0.1..0.9) {
        let at = line.length() * cut;
        let (one, other) = (line.part(0.0, at).unwrap(), line.part(at, line.length()).unwrap());
        prop_assert!((one.length() + other.length() - line.length()).abs() < 1e-6);
        prop_assert_eq!(one.end(), other.start());
        prop_assert!((line.reversed().at(at) - line.at(line.length() - at)).norm() < 1e-6);
    }
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn an_offset_never_runs_backward_on_the_inside_of_a_bend(
        radius in 1.0..30.0f64,
        degrees in 20.0..170.0,
        steps in 2u32..30,
        left in 0.5..15.0,
        tail in 20.0..60.0,
        mirrored: bool,
    ) {
        // Straight along X, a bend to the left, and straight on.
        let angle = |i: u32| f64::to_radians(degrees) * f64::from(i) / f64::from(steps);
        let bend = (0..=steps).map(|i| [radius * angle(i).sin(), radius * (1.0 - angle(i).cos())]);
        let (last, (y, x)) = (bend.clone().next_back().unwrap(), f64::to_radians(degrees).sin_cos());
        let tail: f64 = tail + 20.0 * left;
        let points = [[-tail, 0.0]].into_iter().chain(bend).chain([[last[0] + tail * x, last[1] + tail * y]]);
        let sign = if mirrored { -1.0 } else { 1.0 };
        let line = Polyline::new(points.map(|[x, y]| [x, sign * y])).unwrap();
        let beside = line.offset(sign * left);
        // It turns all the way to one side, by no more than the bend, and keeps its distance.
        for pair in beside.points().windows(3) {
            let (one, two) = ((pair[1] - pair[0]).normalize(), (pair[2] - pair[1]).normalize());
            prop_assert!(sign * one.perp(&two) > -1e-6 && one.dot(&two) > f64::to_radians(degrees).cos() - 1e-6);
        }
        for point in beside.points() {
            let away = line.project(point).left.abs();
            prop_assert!(away > 0.99 * left * (f64::to_radians(degrees) / f64::from(steps) / 2.0).cos() - 1e-6, "{away} {left}");
        }
        // The outside is as it was.
        prop_assert_eq!(line.offset(-sign * left).points().len(), line.points().len());
    }
}

#[test]
fn an_offset_keeps_its_distance() {
    let line = Polyline::new([[0.0, 0.0], [50.0, 0.0], [50.0, 50.0]]).unwrap();
    for left in [-3.0, 3.0] {
        let beside = line.offset(left);
        for station in [5.0, 30.0, 70.0, 95.0] {
            let near = line.project(&beside.at(station));
            assert!((near.left - left).abs() < 0.05, "{near:?}");
        }
    }
    assert_eq!(Polyline::new([[0.0, f64::NAN], [1.0, 0.0]]), None);
    assert_eq!(Polyline::new([[1.0, 1.0], [1.0, 1.0]]), None);
}
