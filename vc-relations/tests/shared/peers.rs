//! The scenes used to compare physics with its peers: rooms of 25 objects, with the support and the container
//! of each given by the file. Doors are separate nodes here, attached by joints.

use std::sync::Arc;

use nalgebra::{UnitQuaternion, Vector3};
use serde::Deserialize;
use vc_graph::asset::{Part, Shape};
use vc_graph::{Asset, AssetId, AssetLibrary, Draft, NodeId, Pose, SceneBuilder, SceneGraph};
use vc_relations::{Attachment, Evidence};

#[derive(Deserialize)]
struct File {
    objs: Vec<Object>,
    walls: Vec<([f32; 3], [f32; 3])>,
    floor: ([f32; 3], [f32; 3]),
}

#[derive(Deserialize)]
struct Object {
    class: String,
    pos: [f32; 3],
    yaw: f32,
    parts: Vec<Piece>,
    hinge: Option<Hinge>,
    truth_support: i64,
    truth_inside: Option<usize>,
}

#[derive(Deserialize)]
struct Piece {
    pos: [f32; 3],
    geo: Geometry,
}

#[derive(Deserialize)]
enum Geometry {
    Box([f32; 3]),
    Cyl { r: f32, h: f32 },
    Ball(f32),
}

#[derive(Deserialize)]
struct Hinge {
    parent: usize,
}

/// A scene and its ground truth.
#[derive(Debug)]
pub(crate) struct Peers {
    pub(crate) graph: SceneGraph,
    /// The joints of its doors.
    pub(crate) evidence: Evidence,
    /// Each object with its support and its container.
    pub(crate) truth: Vec<(NodeId, NodeId, Option<NodeId>)>,
}

/// The scene with that many objects (100, 500 or 2000), from `../shared/peers/physics` or the folder that
/// `VC_PEERS` names; `None`, with a message, if there is none.
pub(crate) fn read(objects: u32) -> Option<Peers> {
    let beside = concat!(env!("CARGO_MANIFEST_DIR"), "/../../shared/peers/physics");
    let folder = std::env::var_os("VC_PEERS").map_or_else(|| beside.into(), std::path::PathBuf::from);
    let path = folder.join(format!("scene_{objects}.json.gz"));
    if !path.is_file() {
        vc_testkit::skipped(&format!("no scene at {}; set VC_PEERS to the folder that has it", path.display()));
        return None;
    }
    Some(build(&serde_json::from_str(&vc_testkit::data::read(&path)).unwrap()))
}

struct Making {
    scene: SceneBuilder,
    library: AssetLibrary,
    known: Vec<(Vec<Part>, AssetId)>,
}

impl Making {
    fn add(&mut self, class: &str, pos: [f32; 3], yaw: f32, parts: Vec<Part>) -> NodeId {
        let known = self.known.iter().find(|k| k.0 == parts).map(|k| k.1);
        let asset = known.unwrap_or_else(|| {
            let asset = Asset { name: class.into(), parts: parts.clone(), ..Asset::default() };
            let id = self.library.add(asset).unwrap();
            self.known.push((parts, id));
            id
        });
        let turn = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), yaw);
        let pose = Pose::from_parts(Vector3::from(pos).into(), turn);
        self.scene.add(Draft { asset: Some(asset), ..Draft::new(class).at(pose) }).unwrap()
    }
}

fn build(file: &File) -> Peers {
    let scene = SceneBuilder::new("peers");
    let mut making = Making { scene, library: super::library(), known: Vec::new() };
    let block = |half: [f32; 3]| vec![part([0.0; 3], Shape::Box { half: half.into() })];
    let floor = making.add("floor", file.floor.0, 0.0, block(file.floor.1));
    for (pos, half) in &file.walls {
        making.add("wall", *pos, 0.0, block(*half));
    }
    let mut add = |o: &Object| {
        // The leaf of a fridge, not a door between rooms.
        let class = if o.hinge.is_some() { "panel" } else { &o.class };
        making.add(class, o.pos, o.yaw, o.parts.iter().map(piece).collect())
    };
    let ids: Vec<NodeId> = file.objs.iter().map(&mut add).collect();
    let hinged =
        |(child, o): (&NodeId, &Object)| o.hinge.as_ref().map(|h| Attachment { child: *child, parent: ids[h.parent] });
    let attachments = ids.iter().zip(&file.objs).filter_map(hinged).collect();
    let carrier = |o: &Object| usize::try_from(o.truth_support).map_or(floor, |i| ids[i]);
    let truth = ids.iter().zip(&file.objs).map(|(id, o)| (*id, carrier(o), o.truth_inside.map(|i| ids[i]))).collect();
    making.scene.assets(Arc::new(making.library));
    Peers { graph: making.scene.build(), evidence: Evidence { attachments, ..Evidence::default() }, truth }
}

fn piece(piece: &Piece) -> Part {
    let shape = match piece.geo {
        Geometry::Box(half) => Shape::Box { half: half.into() },
        Geometry::Cyl { r, h } => Shape::Cylinder { radius: r, half_height: h },
        Geometry::Ball(radius) => Shape::Sphere { radius },
    };
    part(piece.pos, shape)
}

fn part(at: [f32; 3], shape: Shape) -> Part {
    Part { name: "part".into(), shape, material: 0, pose: Pose::translation(at[0], at[1], at[2]), joint: None }
}
