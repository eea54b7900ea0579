//! Shapes as data: checked when they come in, written and read with the scene.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use std::sync::Arc;

use nalgebra::{Point3, Vector3};
use vc_graph::asset::{AssetError, Joint, JointKind, Material, Part, Shape};
use vc_graph::format::native;
use vc_graph::{Asset, AssetLibrary, ClassTable, Draft, Pose, SceneBuilder};

fn oak() -> Material {
    Material {
        name: "oak".into(),
        colour: [0.4, 0.3, 0.2],
        density: 700.0,
        friction: 0.5,
        restitution: 0.1,
        roughness: 0.6,
        metallic: 0.0,
        transmission: 0.0,
        emission: [0.0; 3],
    }
}

fn part(shape: Shape) -> Part {
    Part { name: "part".into(), shape, material: 0, pose: Pose::translation(0.0, 0.0, 0.5), joint: None }
}

fn hinge(axis: Vector3<f32>, limits: (f32, f32)) -> Joint {
    Joint { kind: JointKind::Hinge, anchor: Point3::new(0.3, -0.3, 0.0), axis, limits }
}

fn shapes() -> Vec<Shape> {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Point3::from).to_vec();
    vec![
        Shape::Box { half: Vector3::new(0.3, 0.3, 0.5) },
        Shape::RoundedBox { half: Vector3::new(0.3, 0.3, 0.5), radius: 0.05 },
        Shape::Cylinder { radius: 0.1, half_height: 0.2 },
        Shape::Cone { radius: 0.1, half_height: 0.2 },
        Shape::Capsule { radius: 0.1, half_height: 0.2 },
        Shape::Sphere { radius: 0.1 },
        Shape::Hull { points: corners.clone() },
        Shape::Lathe { profile: vec![(0.0, 0.0), (0.1, 0.0), (0.05, 0.2)] },
        Shape::Extrusion { outline: vec![(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)], height: 0.1 },
        Shape::Mesh { vertices: corners, triangles: vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]] },
    ]
}

#[test]
fn a_scene_keeps_its_shapes() {
    let mut library = AssetLibrary::default();
    library.add_material(oak()).unwrap();
    let mut parts: Vec<Part> = shapes().into_iter().map(part).collect();
    parts[0].joint = Some(hinge(Vector3::z(), (0.0, 1.6)));
    let cabinet = library.add(Asset { name: "cabinet_1".into(), parts, ..Asset::default() }).unwrap();
    let mut scene = SceneBuilder::new("flat");
    scene.assets(Arc::new(library));
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let draft = Draft { asset: Some(cabinet), ..Draft::new("cabinet") };
    let id = scene.add_in(kitchen, draft).unwrap();
    let graph = scene.build();
    let again = native::read(&native::write(&graph), &ClassTable::builtin()).unwrap();
    assert_eq!(graph.assets(), again.assets());
    assert_eq!(again.node(id).unwrap().spec().asset, Some(cabinet));
    assert_eq!(again.assets().get(cabinet).unwrap().parts.len(), shapes().len());
}

#[test]
fn extents_enclose_the_shape() {
    for shape in shapes() {
        let (low, high) = shape.extent();
        assert!(low.iter().zip(high.iter()).all(|(l, h)| l < h), "{shape:?}: {low} {high}");
    }
    let (_, high) = Shape::Capsule { radius: 0.1, half_height: 0.2 }.extent();
    assert!((high.z - 0.3).abs() < 1e-6);
}

#[test]
fn unsound_parts_are_refused_by_name() {
    let mut library = AssetLibrary::default();
    library.add_material(oak()).unwrap();
    let mut add =
        |part: Part| library.add(Asset { name: "bad".into(), parts: vec![part], ..Asset::default() }).unwrap_err();
    let ball = || part(Shape::Sphere { radius: 0.1 });
    assert_eq!(add(Part { material: 7, ..ball() }).to_string(), "part `part` uses material 7, the library has 1");
    assert!(matches!(add(part(Shape::Sphere { radius: f32::NAN })), AssetError::BadMeasure(_)));
    assert!(matches!(add(part(Shape::Box { half: Vector3::new(0.1, 0.0, 0.1) })), AssetError::BadMeasure(_)));
    let loose = Shape::Mesh { vertices: vec![Point3::origin()], triangles: vec![[0, 0, 1]] };
    assert!(matches!(add(part(loose)), AssetError::BadTriangle(_)));
    let joint = |axis, limits| Part { joint: Some(hinge(axis, limits)), ..ball() };
    assert!(matches!(add(joint(Vector3::zeros(), (0.0, 1.0))), AssetError::BadJoint(_)));
    assert!(matches!(add(joint(Vector3::z(), (1.0, 0.0))), AssetError::BadJoint(_)));
}
