//! Shapes as data: checked on input, written and read with the scene.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use std::sync::Arc;

use nalgebra::{Point3, Vector3};
use vc_graph::asset::{AssetError, Joint, JointKind, Material, Part, Shape, Texture};
use vc_graph::format::native;
use vc_graph::{Asset, AssetLibrary, ClassTable, Draft, Pose, SceneBuilder};

fn oak() -> Material {
    Material { density: 700.0, roughness: 0.6, ..Material::new("oak", [0.4, 0.3, 0.2]) }
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
        Shape::Mesh { vertices: corners, triangles: vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]], uvs: Vec::new() },
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

fn label() -> Texture {
    let pixels = vec![[255, 0, 0], [0, 255, 0], [0, 0, 255], [1, 2, 3], [16, 32, 64], [170, 187, 204]];
    Texture { name: "label".into(), width: 3, height: 2, pixels }
}

/// A textured square, with the texture reversed on its second triangle.
fn square(uvs: Vec<[[f32; 2]; 3]>) -> Shape {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]].map(Point3::from).to_vec();
    Shape::Mesh { vertices: corners, triangles: vec![[0, 1, 2], [0, 2, 3]], uvs }
}

const CORNERS: [[[f32; 2]; 3]; 2] = [[[0.0, 1.0], [1.0, 1.0], [1.0, 0.0]], [[1.0, 0.0], [0.0, 1.0], [0.5, -2.0]]];

#[test]
fn a_scene_keeps_its_textures() {
    let mut library = AssetLibrary::default();
    let texture = library.add_texture(Arc::new(label())).unwrap();
    library.add_material(Material { texture: Some(texture), ..oak() }).unwrap();
    let parts = vec![part(square(CORNERS.to_vec()))];
    library.add(Asset { name: "sign_1".into(), parts, ..Asset::default() }).unwrap();
    let mut scene = SceneBuilder::new("flat");
    scene.assets(Arc::new(library));
    scene.add(Draft::new("kitchen")).unwrap();
    let graph = scene.build();
    let text = native::write(&graph);
    let again = native::read(&text, &ClassTable::builtin()).unwrap();
    assert_eq!(graph.assets(), again.assets());
    assert_eq!(**again.assets().texture(0).unwrap(), label());
    assert_eq!(native::write(&again), text);
    for broken in ["ff000", "ff000g", "ff00é"] {
        let message = native::read(&text.replace("ff0000", broken), &ClassTable::builtin()).unwrap_err().to_string();
        assert!(message.contains("six hexadecimal digits"), "{message}");
    }
    let short = text.replace("\"width\":3", "\"width\":4");
    assert!(native::read(&short, &ClassTable::builtin()).unwrap_err().to_string().contains("texture `label`"));
}

#[test]
fn meshes_keep_their_place_in_a_texture() {
    let Shape::Mesh { vertices, mut triangles, mut uvs } = square(CORNERS.to_vec()) else { unreachable!() };
    // A triangle without area is left out, with its texture coordinates.
    triangles.insert(1, [0, 1, 1]);
    uvs.insert(1, [[9.0; 2]; 3]);
    let mut mesh = Shape::Mesh { vertices, triangles, uvs }.mesh(0.0);
    assert_eq!(mesh.uvs, CORNERS);
    let plain = Shape::Sphere { radius: 0.1 }.mesh(0.01);
    let count = plain.triangles.len();
    mesh.append(&plain);
    assert_eq!((mesh.uvs.len(), mesh.uvs[2]), (2 + count, [[0.0; 2]; 3]));
    let mut other = plain;
    other.append(&square(CORNERS.to_vec()).mesh(0.0));
    assert_eq!(other.uvs[count..], CORNERS);
}

#[test]
fn unsound_textures_are_refused_by_name() {
    let mut library = AssetLibrary::default();
    for bad in
        [Texture { width: 0, ..label() }, Texture { height: 3, ..label() }, Texture { width: u32::MAX, ..label() }]
    {
        assert_eq!(library.add_texture(Arc::new(bad)), Err(AssetError::BadTexture("label".into())));
    }
    let material = Material { texture: Some(0), ..oak() };
    let message = library.add_material(material).unwrap_err().to_string();
    assert_eq!(message, "material `oak` uses texture 0, the library has 0");
    library.add_material(oak()).unwrap();
    for bad in [vec![CORNERS[0]], vec![CORNERS[0], [[f32::NAN; 2]; 3]]] {
        let asset = Asset { name: "bad".into(), parts: vec![part(square(bad))], ..Asset::default() };
        assert_eq!(library.add(asset), Err(AssetError::BadCoordinates("part".into())));
    }
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
    let loose = Shape::Mesh { vertices: vec![Point3::origin()], triangles: vec![[0, 0, 1]], uvs: Vec::new() };
    assert!(matches!(add(part(loose)), AssetError::BadTriangle(_)));
    let joint = |axis, limits| Part { joint: Some(hinge(axis, limits)), ..ball() };
    assert!(matches!(add(joint(Vector3::zeros(), (0.0, 1.0))), AssetError::BadJoint(_)));
    assert!(matches!(add(joint(Vector3::z(), (1.0, 0.0))), AssetError::BadJoint(_)));
}

#[test]
fn libraries_are_merged_and_numbered_anew() {
    let texture = |name: &str| {
        let (name, pixels) = (name.into(), vec![[0, 0, 0], [255, 255, 255]]);
        Arc::new(Texture { name, width: 2, height: 1, pixels })
    };
    let mut other = AssetLibrary::default();
    let picture = other.add_texture(texture("picture")).unwrap();
    other.add_material(Material { name: "print".into(), texture: Some(picture), ..oak() }).unwrap();
    let own = other.add(Asset { name: "poster".into(), parts: vec![part(shapes()[0].clone())], ..Asset::default() });
    let mut home = AssetLibrary::default();
    home.add_texture(texture("rug")).unwrap();
    home.add_material(oak()).unwrap();
    let merged = home.merge(&other).unwrap();
    assert_eq!((merged.textures, merged.materials, merged.assets), (1, 1, 0));
    assert_eq!(home.material(1).unwrap().texture, Some(1));
    let poster = home.get(merged.asset(own.unwrap())).unwrap();
    assert_eq!((&*poster.name, poster.parts[0].material), ("poster", 1));
    let before = home.clone();
    assert_eq!(home.merge(&other), Ok(merged), "what is there is shared");
    assert_eq!(home, before);
    assert_eq!(home.merge(&AssetLibrary::default()).map(|_| ()), Ok(()));
}
