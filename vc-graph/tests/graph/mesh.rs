//! Triangle meshes of shapes: closed, of the right size, facing outwards.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use std::f32::consts::PI;

use nalgebra::{Isometry3, Point3, UnitQuaternion, Vector3};
use proptest::prelude::*;
use vc_graph::asset::{Material, Part, Shape};
use vc_graph::{Asset, AssetLibrary, Pose, TriangleMesh};

fn check(shape: &Shape, tolerance: f32) -> TriangleMesh {
    let mesh = shape.mesh(tolerance);
    assert!(mesh.is_closed(), "{shape:?} is open");
    assert!(mesh.volume() > 0.0, "{shape:?} has volume {}", mesh.volume());
    check_bounds(shape, &mesh);
    check_normals(shape, &mesh);
    assert_eq!(shape.mesh(tolerance), mesh);
    mesh
}

fn check_bounds(shape: &Shape, mesh: &TriangleMesh) {
    let (low, high) = shape.extent();
    let bounds = mesh.bounds().unwrap();
    let slack = 1e-5 * (high - low).norm();
    assert!((bounds.min - low).norm() <= slack && (bounds.max - high).norm() <= slack, "{shape:?}: {bounds:?}");
}

fn check_normals(shape: &Shape, mesh: &TriangleMesh) {
    assert_eq!(mesh.positions.len(), mesh.normals.len());
    assert!(mesh.normals.iter().all(|n| (n.norm() - 1.0).abs() < 1e-5), "{shape:?}");
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|v| mesh.positions[v as usize].cast::<f64>());
        let flat = (b - a).cross(&(c - a));
        let longest = (b - a).norm().max((c - b).norm()).max((a - c).norm());
        if flat.norm() < 1e-4 * longest * longest {
            continue; // too thin for a definite normal
        }
        for v in triangle {
            let normal = mesh.normals[*v as usize].cast::<f64>();
            assert!(normal.dot(&flat.normalize()) > 0.2, "{shape:?}: {triangle:?} {normal} {flat}");
        }
    }
}

fn near(found: f32, expected: f32, share: f32) {
    assert!((found - expected).abs() <= share * expected, "{found} instead of {expected}");
}

/// Extents of rotated parts equal those of their meshes, in any orientation.
fn check_turned(shape: &Shape, turn: UnitQuaternion<f32>) {
    let pose = Isometry3::from_parts(Vector3::new(1.0, -2.0, 0.5).into(), turn);
    let part = Part { name: "part".into(), shape: shape.clone(), material: 0, pose, joint: None };
    let (low, high) = part.extent();
    let size = (high - low).norm();
    let points = shape.mesh(1e-4 * size).positions.into_iter().map(|p| pose * p);
    let (least, most) = points.fold((high, low), |(l, h), p| (l.inf(&p), h.sup(&p)));
    let off = (least - low).norm() + (most - high).norm();
    assert!(off <= 2e-3 * size, "{shape:?} turned by {turn}: {low} {high}, its mesh {least} {most}");
}

#[test]
fn extents_of_turned_parts_are_exact() {
    let shapes = [
        Shape::Box { half: Vector3::new(0.1, 0.2, 0.3) },
        Shape::RoundedBox { half: Vector3::new(0.1, 0.2, 0.3), radius: 0.05 },
        Shape::Cylinder { radius: 0.2, half_height: 0.5 },
        Shape::Cone { radius: 0.2, half_height: 0.5 },
        Shape::Capsule { radius: 0.1, half_height: 0.3 },
        Shape::Lathe { profile: vec![(0.0, 0.0), (0.3, 0.1), (0.1, 0.5)] },
        Shape::Extrusion { outline: vec![(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)], height: 0.5 },
    ];
    let turns = [(0.3, 0.0, 0.0), (0.0, 0.7, 0.0), (1.1, -0.4, 2.0), (0.0, 0.0, 1.0), (3.1, 1.5, 0.2)];
    for (shape, (roll, pitch, yaw)) in shapes.iter().flat_map(|s| turns.map(|t| (s, t))) {
        check_turned(shape, UnitQuaternion::from_euler_angles(roll, pitch, yaw));
    }
}

#[test]
fn volumes_are_the_textbook_ones() {
    let fine = |shape: Shape| check(&shape, 1e-4).volume();
    near(fine(Shape::Box { half: Vector3::new(0.1, 0.2, 0.3) }), 0.048, 1e-5);
    near(fine(Shape::RoundedBox { half: Vector3::new(0.2, 0.2, 0.2), radius: 0.2 }), PI * 4.0 / 3.0 * 0.008, 0.01);
    near(fine(Shape::RoundedBox { half: Vector3::new(0.2, 0.3, 0.4), radius: 1e-4 }), 0.192, 1e-3);
    near(fine(Shape::Cylinder { radius: 0.2, half_height: 0.5 }), PI * 0.04, 0.01);
    near(fine(Shape::Cone { radius: 0.2, half_height: 0.5 }), PI * 0.04 / 3.0, 0.01);
    near(fine(Shape::Sphere { radius: 0.2 }), PI * 4.0 / 3.0 * 0.008, 0.01);
    near(fine(Shape::Capsule { radius: 0.2, half_height: 0.5 }), PI * 0.04 + PI * 4.0 / 3.0 * 0.008, 0.01);
    near(fine(Shape::Extrusion { outline: vec![(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)], height: 0.5 }), 0.25, 1e-5);
}

#[test]
fn a_profile_may_be_hollow_a_ring_or_backwards() {
    let (r, h, t) = (0.04, 0.1, 0.004);
    let mut cup = vec![(r, 0.0), (r, h), (r - t, h), (r - t, t)];
    let solid = PI * (r * r * h - (r - t) * (r - t) * (h - t));
    near(check(&Shape::Lathe { profile: cup.clone() }, 1e-5).volume(), solid, 0.01);
    cup.reverse();
    near(check(&Shape::Lathe { profile: cup }, 1e-5).volume(), solid, 0.01);
    let ring = vec![(1.0, 0.0), (1.2, 0.0), (1.2, 0.3), (1.0, 0.3), (1.0, 0.0)];
    near(check(&Shape::Lathe { profile: ring }, 1e-4).volume(), PI * 0.44 * 0.3, 0.01);
    let waist = vec![(0.1, 0.0), (0.0, 0.2), (0.1, 0.4)];
    check(&Shape::Lathe { profile: waist }, 1e-4);
}

#[test]
fn curves_are_smooth_and_edges_are_sharp() {
    let sphere = Shape::Sphere { radius: 2.0 }.mesh(0.01);
    assert!(sphere.positions.iter().zip(&sphere.normals).all(|(p, n)| (p.coords / 2.0 - n).norm() < 1e-5));
    let cylinder = Shape::Cylinder { radius: 1.0, half_height: 1.0 }.mesh(0.1);
    assert!(cylinder.normals.iter().all(|n| n.z.abs() == 1.0 || n.z == 0.0));
    let cube = Shape::Box { half: Vector3::repeat(1.0) };
    let vertices: Vec<_> = cube.mesh(0.1).positions;
    let triangles = cube.mesh(0.1).triangles;
    let again = check(&Shape::Mesh { vertices, triangles, uvs: Vec::new() }, 0.1);
    assert_eq!(again.positions.len(), 24);
    let vertices = sphere.positions.clone();
    let again = Shape::Mesh { vertices, triangles: sphere.triangles.clone(), uvs: Vec::new() }.mesh(0.1);
    let off = |(p, n): (&Point3<f32>, &Vector3<f32>)| (p.coords / 2.0 - n).norm();
    assert!(again.positions.iter().zip(&again.normals).all(|pair| off(pair) < 0.02));
}

#[test]
fn coplanar_points_make_a_hull() {
    let steps = || (0..5).map(|v| v as f32 * 0.1);
    let grid = steps().flat_map(|x| steps().flat_map(move |y| steps().map(move |z| Point3::new(x, y, z))));
    near(check(&Shape::Hull { points: grid.collect() }, 0.1).volume(), 0.064, 1e-5);
}

#[test]
fn every_corner_of_an_outline_is_kept() {
    // Straight corners on every side, and a comb with teeth that leave straight
    // corners behind once they are cut off.
    let square = vec![(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 1.0), (2.0, 2.0), (1.0, 2.0), (0.0, 2.0), (0.0, 1.0)];
    near(check(&Shape::Extrusion { outline: square, height: 1.0 }, 0.1).volume(), 4.0, 1e-5);
    let tooth = |i: i32| [(i as f32, 1.0), (i as f32, 2.0), (i as f32 - 0.5, 2.0), (i as f32 - 0.5, 1.0)];
    let mut comb = vec![(0.0, 0.0), (6.0, 0.0)];
    comb.extend((1..=6).rev().flat_map(tooth));
    comb.push((0.0, 1.0));
    near(check(&Shape::Extrusion { outline: comb, height: 1.0 }, 0.1).volume(), 9.0, 1e-5);
}

#[test]
fn shapes_without_volume_have_no_triangles() {
    let flat = (0..8).map(|i| Point3::new((i % 3) as f32, (i / 3) as f32, 1.0)).collect();
    let point = Point3::new(1.0, 2.0, 3.0);
    let shapes = [
        Shape::Hull { points: flat },
        Shape::Hull { points: vec![point; 5] },
        Shape::Lathe { profile: vec![(0.0, 0.0), (0.0, 1.0)] },
        Shape::Lathe { profile: vec![(1.0, 0.5), (2.0, 0.5)] },
        Shape::Extrusion { outline: vec![(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)], height: 1.0 },
        Shape::Sphere { radius: f32::NAN },
        Shape::Box { half: Vector3::new(1.0, -1.0, 1.0) },
        Shape::Capsule { radius: f32::MAX, half_height: f32::MAX },
    ];
    for shape in shapes {
        let mesh = shape.mesh(0.01);
        assert!(mesh.is_empty() && !mesh.is_closed() && mesh.volume() == 0.0, "{shape:?}");
    }
}

#[test]
fn meshes_are_moved_and_joined() {
    let mut mesh = Shape::Sphere { radius: 0.5 }.mesh(0.01);
    let volume = mesh.volume();
    let pose = Pose::new(Vector3::new(3.0, 0.0, 0.0), Vector3::new(0.3, 0.2, 0.1));
    mesh.append(&mesh.transformed(&pose));
    assert!(mesh.is_closed());
    near(mesh.volume(), 2.0 * volume, 1e-4);
    mesh.triangles.pop();
    assert!(!mesh.is_closed());
}

fn measure() -> impl Strategy<Value = f32> {
    prop_oneof![0.005f32..2.0, Just(0.1), Just(0.5)]
}

fn sound() -> impl Strategy<Value = Shape> {
    let half = || (measure(), measure(), measure()).prop_map(|(x, y, z)| Vector3::new(x, y, z));
    let star = (3usize..24, prop::collection::vec(0.2f32..1.0, 24)).prop_map(|(n, radii)| {
        let corner = |i: usize| (radii[i] * angle(i, n).cos(), radii[i] * angle(i, n).sin());
        (0..n).map(corner).collect::<Vec<_>>()
    });
    let vase = (prop::collection::vec((0.05f32..1.0, 0.01f32..0.3), 2..8), 0.01f32..0.04).prop_map(|(steps, wall)| {
        let mut height = 0.0;
        let outside = steps.iter().map(|&(r, step)| {
            height += step;
            (r, height)
        });
        let outside: Vec<_> = outside.collect();
        let inside: Vec<_> = outside[1..].iter().rev().map(|&(r, z)| (r - wall, z)).collect();
        [outside, inside].concat()
    });
    prop_oneof![
        half().prop_map(|half| Shape::Box { half }),
        (half(), 0.01f32..1.0).prop_map(|(half, share)| Shape::RoundedBox { half, radius: half.min() * share }),
        (measure(), measure()).prop_map(|(radius, half_height)| Shape::Cylinder { radius, half_height }),
        (measure(), measure()).prop_map(|(radius, half_height)| Shape::Cone { radius, half_height }),
        (measure(), measure()).prop_map(|(radius, half_height)| Shape::Capsule { radius, half_height }),
        measure().prop_map(|radius| Shape::Sphere { radius }),
        (star, measure()).prop_map(|(outline, height)| Shape::Extrusion { outline, height }),
        vase.prop_map(|profile| Shape::Lathe { profile }),
    ]
}

fn angle(i: usize, n: usize) -> f32 {
    2.0 * PI * i as f32 / n as f32
}

fn number() -> impl Strategy<Value = f32> {
    prop_oneof![
        -2.0f32..2.0,
        (-3i32..4).prop_map(|v| v as f32),
        any::<f32>().prop_filter("finite", |v| v.is_finite()),
        Just(f32::MIN_POSITIVE),
        Just(f32::MAX),
    ]
}

fn positive() -> impl Strategy<Value = f32> {
    number().prop_map(|v| if v == 0.0 { 1.0 } else { v.abs() })
}

fn point() -> impl Strategy<Value = Point3<f32>> {
    [number(), number(), number()].prop_map(Point3::from)
}

fn triangle(vertices: u32) -> impl Strategy<Value = [u32; 3]> {
    [0..vertices, 0..vertices, 0..vertices]
}

fn odd() -> impl Strategy<Value = Shape> {
    let half = || [positive(), positive(), positive()].prop_map(Vector3::from);
    let pairs = |least| prop::collection::vec((number(), number()), least..12);
    let outside = |p: Vec<(f32, f32)>| p.into_iter().map(|(r, z)| (r.abs(), z)).collect();
    prop_oneof![
        half().prop_map(|half| Shape::Box { half }),
        half().prop_map(|half| Shape::RoundedBox { half, radius: half.min() }),
        (positive(), positive()).prop_map(|(radius, half_height)| Shape::Cylinder { radius, half_height }),
        (positive(), positive()).prop_map(|(radius, half_height)| Shape::Capsule { radius, half_height }),
        pairs(2).prop_map(move |profile| Shape::Lathe { profile: outside(profile) }),
        (pairs(3), positive()).prop_map(|(outline, height)| Shape::Extrusion { outline, height }),
        prop::collection::vec(point(), 4..30).prop_map(|points| Shape::Hull { points }),
        (prop::collection::vec(point(), 6), prop::collection::vec(triangle(6), 0..20))
            .prop_map(|(vertices, triangles)| Shape::Mesh { vertices, triangles, uvs: Vec::new() }),
    ]
}

/// Points of a ball, a box or a lattice, many of them coplanar.
fn cloud() -> impl Strategy<Value = Vec<Point3<f32>>> {
    let lattice = (0i32..4, 0i32..4, 0i32..4).prop_map(|(x, y, z)| Point3::new(x as f32, y as f32, z as f32) * 0.1);
    let free = [-1.0f32..1.0, -1.0f32..1.0, -1.0f32..1.0].prop_map(Point3::from);
    let ball = free.clone().prop_map(|p| Point3::from(p.coords.try_normalize(0.01).unwrap_or_else(Vector3::x)));
    prop_oneof![
        prop::collection::vec(lattice, 4..80),
        prop::collection::vec(free, 4..80),
        prop::collection::vec(ball, 4..200),
    ]
}

proptest! {
    #[test]
    fn sound_shapes_are_closed_and_face_outwards(shape in sound(), tolerance in 0.0001f32..0.1) {
        check(&shape, tolerance);
    }

    #[test]
    fn hulls_contain_their_points(points in cloud(), turn in [-3.0f32..3.0, -3.0f32..3.0, -3.0f32..3.0]) {
        let pose = Pose::new(Vector3::zeros(), Vector3::from(turn));
        for points in [points.clone(), points.iter().map(|p| pose * p).collect()] {
            let shape = Shape::Hull { points: points.clone() };
            let mesh = shape.mesh(0.01);
            if mesh.volume() < 1e-6 {
                continue; // all points nearly coplanar
            }
            check(&shape, 0.01);
            for triangle in &mesh.triangles {
                let [a, b, c] = triangle.map(|v| mesh.positions[v as usize].cast::<f64>());
                let normal = (b - a).cross(&(c - a));
                let out = |p: &Point3<f32>| (p.cast::<f64>() - a).dot(&normal);
                prop_assert!(points.iter().all(|p| out(p) <= 1e-14), "a point is outside");
            }
        }
    }

    #[test]
    fn whatever_a_library_accepts_has_a_mesh(shape in odd(), tolerance in number()) {
        let mut library = AssetLibrary::default();
        let material = Material { density: 700.0, roughness: 0.6, ..Material::new("oak", [0.4; 3]) };
        library.add_material(material).unwrap();
        let part = Part { name: "part".into(), shape: shape.clone(), material: 0, pose: Pose::identity(), joint: None };
        prop_assume!(library.add(Asset { name: "asset".into(), parts: vec![part], ..Asset::default() }).is_ok());
        let mesh = shape.mesh(tolerance);
        prop_assert!(mesh.normals.iter().all(|n| (n.norm() - 1.0).abs() < 1e-5));
        prop_assert!(mesh.triangles.iter().flatten().all(|&v| (v as usize) < mesh.positions.len()));
        let _ = (mesh.is_closed(), mesh.volume(), mesh.bounds());
        if let Shape::Hull { .. } = shape {
            prop_assert!(mesh.is_empty() || mesh.is_closed());
        }
    }
}
