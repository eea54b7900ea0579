//! The scene on which physics is timed beside its peers: room modules of 25 objects each, in which everything
//! but floor and walls is loose.

#[path = "rooms.rs"]
mod rooms;

use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use flate2::Compression;
use flate2::read::GzDecoder;
use flate2::write::GzEncoder;
use nalgebra::{Point3, UnitQuaternion, Vector3};
use serde::{Deserialize, Serialize};
use virtualcity::graph::asset::{Joint, JointKind, Material, Part, Shape};
use virtualcity::graph::{Asset, AssetId, AssetLibrary, Draft, NodeId, Pose, SceneBuilder, SceneGraph};
use virtualcity::physics::{FixedThings, Settings};

#[derive(Deserialize, Serialize)]
struct File {
    objs: Vec<Object>,
    walls: Vec<([f32; 3], [f32; 3])>,
    floor: ([f32; 3], [f32; 3]),
}

#[derive(Deserialize, Serialize)]
struct Object {
    id: u32,
    class: String,
    pos: [f32; 3],
    yaw: f32,
    density: f32,
    parts: Vec<Piece>,
    hinge: Option<Hinge>,
}

#[derive(Deserialize, Serialize)]
struct Piece {
    pos: [f32; 3],
    geo: Geometry,
}

#[derive(Deserialize, Serialize)]
enum Geometry {
    Box([f32; 3]),
    Cyl { r: f32, h: f32 },
    Ball(f32),
}

#[derive(Deserialize, Serialize)]
struct Hinge {
    parent: u32,
    anchor: [f32; 3],
    anchor_child: [f32; 3],
    lim: (f32, f32),
}

/// The scene with that many objects (100, 500 or 2000): the one on which the figures in README were measured,
/// in `../shared/peers/physics` or in the folder that `VC_PEERS` names; otherwise generated rooms, which are
/// written to `target/peers` so that the peers find them.
pub(crate) fn read(objects: u32) -> SceneGraph {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = std::env::var("VC_PEERS").map_or_else(|_| root.join("../shared/peers/physics"), PathBuf::from);
    if let Ok(file) = std::fs::File::open(folder.join(format!("scene_{objects}.json.gz"))) {
        let mut text = String::new();
        GzDecoder::new(file).read_to_string(&mut text).unwrap();
        return build(&serde_json::from_str(&text).unwrap());
    }
    let (file, own) = (rooms::rooms(objects), root.join("target/peers"));
    std::fs::create_dir_all(&own).unwrap();
    let path = own.join(format!("scene_{objects}.json.gz"));
    let mut packed = GzEncoder::new(std::fs::File::create(&path).unwrap(), Compression::default());
    packed.write_all(serde_json::to_string(&file).unwrap().as_bytes()).unwrap();
    packed.finish().unwrap();
    eprintln!("no scene of {objects} objects in {}: rooms of our own, in {}", folder.display(), path.display());
    build(&file)
}

/// The peers' settings: only the building is fixed, doors swing freely, and masses follow from the shapes.
pub(crate) fn settings() -> Settings {
    Settings {
        fixing: FixedThings::Structure,
        latches: false,
        hinge_friction: 0.0,
        class_masses: false,
        ..Settings::default()
    }
}

/// The objects that are thrown when fifty bodies should be awake.
pub(crate) fn small_things(graph: &SceneGraph) -> Vec<NodeId> {
    let small = |class: &str| matches!(class, "cup" | "apple" | "toy" | "milk" | "plate");
    graph.nodes().filter(|n| small(n.class())).map(|n| n.id()).take(50).collect()
}

fn build(file: &File) -> SceneGraph {
    let mut library = AssetLibrary::default();
    let mut builder = SceneBuilder::new("peers");
    let stone = material(&mut library, 2000.0);
    for (name, (pos, half)) in std::iter::once(("floor", &file.floor)).chain(file.walls.iter().map(|w| ("wall", w))) {
        let part = part(name, Shape::Box { half: (*half).into() }, [0.0; 3], stone);
        let asset = library.add(Asset { name: name.into(), parts: vec![part], ..Asset::default() }).unwrap();
        add(&mut builder, name, asset, *pos, 0.0);
    }
    let mut known: Vec<(String, Asset, AssetId)> = Vec::new();
    for object in file.objs.iter().filter(|o| o.hinge.is_none()) {
        let door = file.objs.iter().find(|o| o.hinge.as_ref().is_some_and(|h| h.parent == object.id));
        let asset = asset(&mut library, object, door);
        let same = known.iter().find(|(class, a, _)| *class == object.class && *a == asset).map(|k| k.2);
        let id = same.unwrap_or_else(|| {
            let id = library.add(asset.clone()).unwrap();
            known.push((object.class.clone(), asset, id));
            id
        });
        add(&mut builder, &object.class, id, object.pos, object.yaw);
    }
    builder.assets(Arc::new(library));
    builder.build()
}

fn add(builder: &mut SceneBuilder, class: &str, asset: AssetId, pos: [f32; 3], yaw: f32) {
    let turn = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), yaw);
    let pose = Pose::from_parts(Vector3::from(pos).into(), turn);
    builder.add(Draft { asset: Some(asset), ..Draft::new(class).at(pose) }).unwrap();
}

/// An object's asset; its door, if it has one, is a part of it.
fn asset(library: &mut AssetLibrary, object: &Object, door: Option<&Object>) -> Asset {
    let stuff = material(library, object.density);
    let mut parts: Vec<Part> = object.parts.iter().map(|p| piece(&object.class, p, [0.0; 3], stuff)).collect();
    if let Some((door, hinge)) = door.and_then(|d| Some((d, d.hinge.as_ref()?))) {
        let stuff = material(library, door.density);
        let offset = [0, 1, 2].map(|i| hinge.anchor[i] - hinge.anchor_child[i]);
        let joint =
            Joint { kind: JointKind::Hinge, anchor: Point3::from(hinge.anchor), axis: Vector3::z(), limits: hinge.lim };
        parts.extend(door.parts.iter().map(|p| Part { joint: Some(joint), ..piece("door", p, offset, stuff) }));
    }
    Asset { name: object.class.as_str().into(), parts, ..Asset::default() }
}

fn piece(name: &str, piece: &Piece, offset: [f32; 3], material: u32) -> Part {
    let shape = match piece.geo {
        Geometry::Box(half) => Shape::Box { half: half.into() },
        Geometry::Cyl { r, h } => Shape::Cylinder { radius: r, half_height: h },
        Geometry::Ball(radius) => Shape::Sphere { radius },
    };
    part(name, shape, [0, 1, 2].map(|i| piece.pos[i] + offset[i]), material)
}

fn part(name: &str, shape: Shape, at: [f32; 3], material: u32) -> Part {
    Part { name: name.into(), shape, material, pose: Pose::translation(at[0], at[1], at[2]), joint: None }
}

/// The material of a density, with the peers' friction.
fn material(library: &mut AssetLibrary, density: f32) -> u32 {
    let same = (0..).map_while(|i| library.material(i)).position(|m| m.density == density);
    let fresh =
        Material { density, friction: 0.6, restitution: 0.0, ..Material::new(format!("{density} kg/m3"), [0.5; 3]) };
    same.map_or_else(|| library.add_material(fresh).unwrap(), |i| i as u32)
}
