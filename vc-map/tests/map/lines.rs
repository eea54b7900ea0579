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
