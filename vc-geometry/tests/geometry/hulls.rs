//! Hulls of points in space.

use nalgebra::{Point3, Vector3};
use proptest::prelude::*;
use vc_geometry::hull::{HullTolerance, approximate, triangles};
use vc_graph::asset::Shape;
use vc_graph::portable::Portable;

/// The enclosed volume, and the distance of the farthest point outside.
fn judged(points: &[Point3<f32>], triangles: &[[u32; 3]]) -> (f64, f64) {
    let corner = |i: u32| points[i as usize].coords.cast::<f64>();
    let (mut volume, mut outside) = (0.0, f64::NEG_INFINITY);
    for t in triangles {
        let [a, b, c] = t.map(corner);
        let normal = (b - a).cross(&(c - a));
        volume += a.dot(&normal) / 6.0;
        let far = |p: &Point3<f32>| (p.coords.cast::<f64>() - a).dot(&normal.normalize());
        outside = points.iter().map(far).fold(outside, f64::max);
    }
    (volume, outside)
}

#[test]
fn a_box_with_points_all_over_its_faces_is_a_box() {
    let raster = || (0..5).map(|i| i as f32 * 0.1);
    let all = raster().flat_map(|x| raster().flat_map(move |y| raster().map(move |z| Point3::new(x, y, z))));
    let points: Vec<_> = all.collect();
    let triangles = triangles(&points).unwrap();
    let (volume, outside) = judged(&points, &triangles);
    assert!((volume - 0.064).abs() < 1e-6 && outside < 1e-6, "{volume} {outside}");
}

/// Points on a ball that is not at the origin.
fn round() -> Vec<Point3<f32>> {
    let point = |i: u32| {
        let (turn, rise) = (i as f32 * 2.4, (i as f32 + 0.5) / 150.0 - 1.0);
        let ring = (1.0 - rise * rise).max(0.0).sqrt();
        Point3::new(ring * turn.cosine(), ring * turn.sine(), rise) * 0.2 + Vector3::new(3.0, -2.0, 1.0)
    };
    (0..300).map(point).collect()
}

#[test]
fn a_rough_hull_is_as_true_as_asked_for() {
    let points = round();
    let corners = |triangles: &[[u32; 3]]| triangles.len() / 2 + 2;
    let first = [0, 40, 90, 140, 200, 299];
    let mut fewest = points.len();
    for by in [0.004, 0.008, 0.016] {
        let triangles = approximate(&points, &HullTolerance { first: &first, by, corners: usize::MAX }).unwrap();
        let (_, outside) = judged(&points, &triangles);
        assert!(outside <= f64::from(by) + 1e-6 && outside > 0.0, "{by}: {outside}");
        assert!(first.iter().all(|i| triangles.as_flattened().contains(i)));
        assert!(corners(&triangles) < fewest, "{by}");
        fewest = corners(&triangles);
    }
    let triangles = approximate(&points, &HullTolerance { first: &first, by: 0.0, corners: 40 }).unwrap();
    let (volume, outside) = judged(&points, &triangles);
    assert!(corners(&triangles) == 40 && volume > 0.025 && outside < 0.03, "{volume} {outside}");
}

#[test]
fn nothing_is_outside_of_round_things() {
    let points = round();
    let triangles = triangles(&points).unwrap();
    let (volume, outside) = judged(&points, &triangles);
    let ball = 4.0 / 3.0 * std::f64::consts::PI * 0.008;
    assert!(volume > 0.95 * ball && volume < ball && outside < 1e-5, "{volume} of {ball}, {outside}");
    // Euler's formula for a closed surface of triangles.
    let mut corners: Vec<u32> = triangles.as_flattened().to_vec();
    corners.sort_unstable();
    corners.dedup();
    assert_eq!(triangles.len(), 2 * corners.len() - 4);
}

#[test]
fn what_is_flat_has_no_hull() {
    let flat: Vec<_> = (0..9).map(|i| Point3::new((i % 3) as f32, (i / 3) as f32, (i % 3) as f32)).collect();
    assert!(triangles(&flat).is_none());
    assert!(triangles(&[]).is_none());
    assert!(triangles(&[Point3::origin(); 7]).is_none());
}

proptest! {
    #![proptest_config(crate::cases(200))]
    #[test]
    fn a_hull_encloses_what_the_exact_one_does(all in prop::collection::vec(prop::array::uniform3(-1.0_f32..1.0), 0..60)) {
        let points: Vec<Point3<f32>> = all.into_iter().map(Point3::from).collect();
        let exact = Shape::Hull { points: points.clone() }.mesh(0.0);
        match triangles(&points) {
            None => prop_assert!(exact.volume() < 1e-3),
            Some(found) => {
                let (volume, outside) = judged(&points, &found);
                prop_assert!((volume - f64::from(exact.volume())).abs() < 1e-4 && outside < 1e-5);
            }
        }
    }
}

#[test]
fn points_to_begin_with_that_do_not_exist_give_no_hull() {
    assert!(approximate(&round(), &HullTolerance { first: &[0, 1, 2, 9999], by: 0.0, corners: 40 }).is_none());
    let mut odd = round();
    odd[7].x = f32::NAN;
    let _ = triangles(&odd);
    assert!(triangles(&[Point3::new(f32::NAN, 0.0, 0.0); 5]).is_none());
}
