//! Writing and reading glTF: files that are written read back, and no input causes a panic.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

mod broken;
mod textures;

use std::sync::Arc;

use nalgebra::{Point3, Vector3};
use serde_json::Value;
use vc_gltf::{self as gltf, GltfError, ImportOptions, ModelSize};
use vc_graph::asset::{Hold, Joint, JointKind, Material, Part, Shape, Surface};
use vc_graph::{Asset, AssetLibrary, Draft, Pose, SceneBuilder};

fn library() -> AssetLibrary {
    let mut library = AssetLibrary::default();
    let oak = Material {
        density: 650.0,
        friction: 0.4,
        restitution: 0.3,
        roughness: 0.75,
        ..Material::new("oak", [0.5, 0.25, 0.125])
    };
    let lamp = Material { name: "lamp".into(), emission: [8.0, 4.0, 2.0], ..oak.clone() };
    let glass = Material { name: "glass".into(), transmission: 0.75, emission: [0.5, 0.0, 0.0], ..oak.clone() };
    for material in [oak, lamp, glass] {
        library.add_material(material).unwrap();
    }
    library
}

fn part(name: &str, shape: Shape, material: u32, at: [f32; 3]) -> Part {
    let pose = Pose::new(Vector3::from(at), Vector3::new(0.1, 0.2, 0.3));
    Part { name: name.into(), shape, material, pose, joint: None }
}

fn shapes() -> Vec<Shape> {
    let corners = [[0.0, 0.0, 0.0], [0.3, 0.0, 0.0], [0.0, 0.3, 0.0], [0.0, 0.0, 0.3]].map(Point3::from).to_vec();
    vec![
        Shape::Box { half: Vector3::new(0.1, 0.2, 0.3) },
        Shape::RoundedBox { half: Vector3::new(0.1, 0.2, 0.3), radius: 0.03 },
        Shape::Cylinder { radius: 0.1, half_height: 0.2 },
        Shape::Cone { radius: 0.1, half_height: 0.2 },
        Shape::Capsule { radius: 0.1, half_height: 0.2 },
        Shape::Sphere { radius: 0.2 },
        Shape::Hull { points: corners.clone() },
        Shape::Lathe { profile: vec![(0.1, 0.0), (0.1, 0.2), (0.09, 0.2), (0.09, 0.02)] },
        Shape::Extrusion { outline: vec![(0.0, 0.0), (0.3, 0.0), (0.1, 0.1), (0.0, 0.3)], height: 0.1 },
        Shape::Mesh { vertices: corners, triangles: vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]], uvs: Vec::new() },
    ]
}

/// Every shape, two links, three surfaces; the base is centred on the origin.
fn cabinet() -> Asset {
    let hinge =
        Joint { kind: JointKind::Hinge, anchor: Point3::new(0.5, -0.5, 0.2), axis: Vector3::z(), limits: (0.0, 1.6) };
    let slide = Joint { kind: JointKind::Slide, anchor: Point3::origin(), axis: Vector3::x(), limits: (0.0, 0.4) };
    let mut parts: Vec<Part> = (shapes().into_iter().zip(0..))
        .map(|(shape, i)| part(&format!("part_{i}"), shape, i % 3, [i as f32 * 0.5 - 2.25, 0.0, 0.6]))
        .collect();
    parts.push(part("ground", Shape::Box { half: Vector3::new(3.0, 1.0, 0.05) }, 0, [0.0; 3]));
    if let Some(ground) = parts.last_mut() {
        ground.pose = Pose::translation(0.0, 0.0, 0.05);
    }
    parts[0].joint = Some(hinge);
    parts[1].joint = Some(slide);
    parts[2].joint = Some(slide);
    let surface = |name: &str, joint, clearance| Surface {
        name: name.into(),
        hold: Hold::Inside,
        centre: Point3::new(0.1, 0.2, 0.3),
        half: (0.25, 0.5),
        clearance,
        joint,
    };
    let lid = Joint { kind: JointKind::Hinge, axis: Vector3::y(), ..hinge };
    let surfaces =
        vec![surface("top", None, None), surface("drawer", Some(slide), Some(0.25)), surface("lid", Some(lid), None)];
    Asset { name: "cabinet_1".into(), parts, surfaces, ..Asset::default() }
}

fn plain() -> ImportOptions {
    ImportOptions { hulls: 0, ..ImportOptions::default() }
}

fn volume(parts: &[Part]) -> f32 {
    parts.iter().map(|p| p.shape.mesh(gltf::TOLERANCE).volume()).sum()
}

fn size(asset: &Asset) -> Vector3<f32> {
    let (low, high) = asset.extent().unwrap();
    high - low
}

#[test]
fn an_asset_reads_back() {
    let (asset, library) = (cabinet(), library());
    let file = gltf::asset_of_class("kitchen_cabinet", &asset, &library).unwrap();
    assert_eq!(file, gltf::asset_of_class("kitchen_cabinet", &asset, &library).unwrap());
    let read = gltf::read(&file, &plain()).unwrap();
    assert_eq!(read.class.as_deref(), Some("kitchen_cabinet"));
    assert_eq!(read.asset.name, asset.name);
    assert!(read.closed);
    assert!((volume(&read.asset.parts) / volume(&asset.parts) - 1.0).abs() < 1e-3);
    assert!((size(&read.asset) - Vector3::new(6.0, 2.0, size(&read.asset).z)).norm() < 1e-4);
    let of = |name: &str| read.materials.iter().find(|m| &*m.name == name).unwrap();
    for index in 0..3 {
        let material = library.material(index).unwrap();
        assert_eq!(of(&material.name), material);
    }
    for surface in &asset.surfaces {
        let again = read.asset.surfaces.iter().find(|s| s.name == surface.name).unwrap();
        assert!((again.centre - surface.centre).norm() < 1e-5, "{again:?}");
        assert_eq!((again.hold, again.clearance), (surface.hold, surface.clearance));
        assert!((again.half.0 - surface.half.0).abs() < 1e-6);
        assert_eq!(again.joint.is_some(), surface.joint.is_some());
    }
    let hinge = asset.parts[0].joint.unwrap();
    let again = read.asset.parts.iter().filter_map(|p| p.joint).find(|j| j.kind == JointKind::Hinge).unwrap();
    assert!((again.anchor - hinge.anchor).norm() < 1e-5 && (again.axis - hinge.axis).norm() < 1e-5);
    assert_eq!(again.limits, hinge.limits);
    let mut mine = library.clone();
    let id = read.add_to(&mut mine).unwrap();
    assert!(mine.get(id).is_some());
}

#[test]
fn sizes_and_turns() {
    let (asset, library) = (cabinet(), library());
    let file = gltf::asset(&asset, &library).unwrap();
    let sized =
        |size, quarter_turns| gltf::read(&file, &ImportOptions { size, quarter_turns, ..plain() }).map(|i| i.asset);
    let own = size(&sized(ModelSize::AsIs, 0).unwrap());
    assert!((size(&sized(ModelSize::Times(0.01), 0).unwrap()) * 100.0 - own).norm() < 1e-3);
    assert!((size(&sized(ModelSize::Height(1.0), 0).unwrap()).z - 1.0).abs() < 1e-5);
    let fitted = size(&sized(ModelSize::Within(Vector3::new(1.0, 1.0, 1.0)), 0).unwrap());
    assert!((fitted.max() - 1.0).abs() < 1e-5);
    let turned = sized(ModelSize::AsIs, 1).unwrap();
    assert!((size(&turned) - Vector3::new(own.y, own.x, own.z)).norm() < 1e-4);
    let slide = turned.parts.iter().filter_map(|p| p.joint).find(|j| j.kind == JointKind::Slide).unwrap();
    assert!((slide.axis - Vector3::y()).norm() < 1e-6, "what slid to the front slides to the left");
    let half = sized(ModelSize::Times(0.5), 0).unwrap();
    assert!(half.parts.iter().filter_map(|p| p.joint).any(|j| j.kind == JointKind::Slide && j.limits == (0.0, 0.2)));
    for bad in [0.0, -1.0, f32::NAN, f32::INFINITY] {
        assert_eq!(sized(ModelSize::Times(bad), 0).unwrap_err(), GltfError::BadSize);
    }
}

#[test]
fn physics_gets_convex_pieces() {
    let library = library();
    let cup = Shape::Lathe { profile: vec![(0.1, 0.0), (0.1, 0.2), (0.08, 0.2), (0.08, 0.02)] };
    let one = |shape| Asset { name: "one".into(), parts: vec![part("one", shape, 0, [0.0; 3])], ..Asset::default() };
    let collision = |shape| {
        let file = gltf::asset(&one(shape), &library).unwrap();
        gltf::read(&file, &ImportOptions::default()).unwrap().asset.collision
    };
    let pieces = collision(cup.clone());
    assert!((4..=16).contains(&pieces.len()), "{}", pieces.len());
    let filled = Shape::Cylinder { radius: 0.1, half_height: 0.1 }.mesh(0.001).volume();
    let own = cup.mesh(0.001).volume();
    assert!(volume(&pieces) < (own + filled) / 2.0, "{} of {own} to {filled}", volume(&pieces));
    assert!(volume(&pieces) > own * 0.8, "{} of {own}", volume(&pieces));
    for shape in shapes() {
        let convex = shape.mesh(gltf::TOLERANCE).volume() / hull_volume(&shape) > 0.98;
        assert_eq!(collision(shape.clone()).len() == 1, convex, "{shape:?}");
    }
    let flat = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let rug = Shape::Mesh {
        vertices: flat.into_iter().map(Point3::from).collect(),
        triangles: vec![[0, 1, 2]],
        uvs: Vec::new(),
    };
    assert!((volume(&collision(rug)) - 0.0005).abs() < 1e-5);
}

fn hull_volume(shape: &Shape) -> f32 {
    Shape::Hull { points: shape.mesh(gltf::TOLERANCE).positions }.mesh(0.0).volume()
}

#[test]
fn a_scene_shares_meshes() {
    let mut library = library();
    let id = library.add(cabinet()).unwrap();
    let mut scene = SceneBuilder::new("flat");
    scene.assets(Arc::new(library));
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    for x in 0..3 {
        let draft = Draft { asset: Some(id), scale: Some(Vector3::new(1.0, 1.0, 0.5)), ..Draft::new("cabinet") };
        scene.add_in(kitchen, draft.at(Pose::translation(x as f32 * 7.0, 0.0, 0.0))).unwrap();
    }
    let graph = scene.build();
    let file = gltf::scene(&graph).unwrap();
    let document = document(&file);
    assert_eq!(document["meshes"].as_array().unwrap().len(), 3);
    let names: Vec<&str> = document["nodes"].as_array().unwrap().iter().filter_map(|n| n["name"].as_str()).collect();
    let labels = graph.nodes().filter(|n| n.spec().asset.is_some()).map(|n| n.label().to_string());
    labels.for_each(|label| assert!(names.contains(&label.as_str()), "{label}"));
    let read = gltf::read(&file, &plain()).unwrap();
    assert!((size(&read.asset).x - 20.0).abs() < 1e-3);
}

fn document(file: &[u8]) -> Value {
    let length = u32::from_le_bytes(file[12..16].try_into().unwrap()) as usize;
    serde_json::from_slice(&file[20..20 + length]).unwrap()
}

/// The file with its JSON edited.
fn edited(file: &[u8], edit: impl FnOnce(&mut Value)) -> Vec<u8> {
    let length = u32::from_le_bytes(file[12..16].try_into().unwrap()) as usize;
    let mut document = document(file);
    edit(&mut document);
    let json = serde_json::to_vec(&document).unwrap();
    let mut out = file[..12].to_vec();
    out.extend((json.len() as u32).to_le_bytes());
    out.extend(b"JSON");
    out.extend(json);
    out.extend(&file[20 + length..]);
    out
}

/// The last node is the root, which rotates all others.
fn root(document: &mut Value) -> &mut Value {
    document["nodes"].as_array_mut().unwrap().last_mut().unwrap()
}

#[test]
fn a_staged_scene_has_its_cameras_and_lights() {
    use nalgebra::{Point3, Vector3};
    use vc_gltf::{LightPlace, Stage, StageCamera, StageLight, staged_scene};
    let camera = |near| StageCamera {
        name: "door".into(),
        pose: vc_graph::Pose::translation(1.0, 2.0, 1.6),
        vertical_fov: 1.0,
        aspect: 1.5,
        near,
    };
    let light = |place| StageLight { name: "light".into(), colour: [1.0, 0.9, 0.8], place };
    let stage = Stage {
        cameras: vec![camera(0.01), camera(f32::NAN)],
        lights: vec![
            light(LightPlace::Directional { towards: Vector3::new(0.3, 0.2, 0.9), lux: 60_000.0 }),
            light(LightPlace::Point { point: Point3::new(1.0, 1.0, 2.4), candela: 80.0 }),
            light(LightPlace::Directional { towards: Vector3::zeros(), lux: 1.0 }),
        ],
    };
    let graph = vc_graph::SceneBuilder::new("flat").build();
    let file = staged_scene(&graph, &stage).unwrap();
    let text = String::from_utf8_lossy(&file);
    assert_eq!(text.matches("\"perspective\":{").count(), 1, "what is not finite is left out");
    assert_eq!(text.matches("\"intensity\":").count(), 2);
    assert!(text.contains("\"extensionsUsed\":[\"KHR_lights_punctual\"]"));
    assert!(text.contains("{\"KHR_lights_punctual\":{\"light\":0}}"), "the first light is named as well");
}
