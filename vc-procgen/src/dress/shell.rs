//! The building: floors, ceilings, walls with openings, doors and windows in them.

use nalgebra::{Isometry3, Point3, UnitQuaternion, Vector2, Vector3};
use vc_geometry::WallOpening;
use vc_graph::{Aabb, Asset, Bounds, BoundsFrame, Node, NodeId, ObjectRole, Pose, Seed};
use vc_shapes::Style;
use vc_shapes::material::{self, MaterialId};
use vc_shapes::object::{Generator, Object};

use super::compose::{block, moved};
use super::house::{House, goes_around};
use crate::area::Facing;
use crate::room_kind::is_wet;

/// The thickness of a ceiling whose box has none, metres.
const SLAB: f32 = 0.1;
/// The greatest distance between an opening's box and the walls that contain it, metres.
const NEAR: f32 = 0.12;
/// How far beyond the walls of a doorway its room begins at most, metres.
const BEYOND: f32 = 0.5;
/// Thickness of a hole's walls at least, metres.
const THIN: f32 = 0.02;
/// How many doors or windows are made for one as deep as its box, with its handles and sill.
const LIKE: u64 = 8;
/// The height of the strip on the floor below a door, metres.
const STRIP: f32 = 0.004;

/// A part of the building with its shape.
pub(super) struct Built {
    pub(super) asset: Asset,
    pub(super) pose: Pose,
    pub(super) bounds: Bounds,
}

/// The shape of a node that is part of the building; `None` if it is not.
pub(super) fn built(house: &House, node: &Node, style: &Style, seed: Seed) -> Option<Built> {
    let room = house.graph.room_of(node.id()).and_then(|r| house.graph.node(r)).map_or("", |r| r.class());
    let (classes, is_a) = (house.graph.classes(), |class| house.graph.classes().is_a(room, class));
    match node.role() {
        ObjectRole::Floor if is_a("balcony") => painted(house, node, material::CONCRETE),
        ObjectRole::Floor if is_wet(classes, room) => painted(house, node, style.tile),
        ObjectRole::Floor => painted(house, node, style.floor),
        ObjectRole::Wall if is_a("bathroom") => painted(house, node, style.tile),
        ObjectRole::Wall => painted(house, node, style.wall),
        ObjectRole::Ceiling => ceiling(house, node),
        _ if goes_around(node) => painted(house, node, style.worktop),
        _ => {
            let opening = house.openings.iter().find(|o| o.door == node.id())?;
            let frames_door =
                || house.openings.iter().any(|o| o.door != node.id() && o.is_doorway && meet(&o.clear, &opening.clear));
            match node.role() {
                ObjectRole::DoorFrame if frames_door() => threshold(node, opening, style.joinery),
                _ => filled(house, opening, node, style, seed),
            }
        }
    }
}

/// Walls and floors with the shapes of `vc-geometry`, in a material.
fn painted(house: &House, node: &Node, mat: MaterialId) -> Option<Built> {
    let mut asset = house.shapes.get(&node.id())?.clone();
    asset.parts.iter_mut().for_each(|part| part.material = mat.0);
    let (low, high) = asset.extent()?;
    Some(Built { asset, pose: *node.pose()?, bounds: around(low, high) })
}

fn ceiling(house: &House, node: &Node) -> Option<Built> {
    let (bounds, pose) = (node.spec().bounds?, node.pose()?);
    let shape = house.shapes.get(&node.id()).filter(|asset| asset.parts.len() > 1);
    let (pose, pieces) = match shape {
        Some(asset) => (*pose, asset.parts.iter().map(vc_graph::asset::Part::extent).collect()),
        None => (upright(pose, &bounds), vec![corners(&bounds)]),
    };
    let thick = |(low, high): (Point3<f32>, Point3<f32>)| (low, Point3::new(high.x, high.y, high.z.max(low.z + SLAB)));
    let parts = pieces.into_iter().map(thick).map(|(low, high)| block(node.class(), low, high, material::WALL_WHITE));
    let asset = Asset { name: node.class().clone(), parts: parts.collect(), ..Asset::default() };
    let (low, high) = asset.extent()?;
    Some(Built { asset, pose, bounds: around(low, high) })
}

fn corners(bounds: &Bounds) -> (Point3<f32>, Point3<f32>) {
    (Point3::from(bounds.offset - bounds.half), Point3::from(bounds.offset + bounds.half))
}

/// The pose whose axes a node's box is aligned with.
fn upright(pose: &Pose, bounds: &Bounds) -> Pose {
    match bounds.frame {
        BoundsFrame::Object => *pose,
        BoundsFrame::World => Isometry3::from_parts(pose.translation, UnitQuaternion::identity()),
    }
}

fn around(low: Point3<f32>, high: Point3<f32>) -> Bounds {
    Bounds { offset: nalgebra::center(&low, &high).coords, half: (high - low) / 2.0, frame: BoundsFrame::Object }
}

fn one_block(name: &str, (low, high): (Point3<f32>, Point3<f32>), mat: MaterialId) -> Asset {
    Asset { name: name.into(), parts: vec![block(name, low, high, mat)], ..Asset::default() }
}

/// Whether a rotation maps coordinate axes to coordinate axes.
fn quarter(turn: &UnitQuaternion<f32>) -> bool {
    turn.to_rotation_matrix().matrix().iter().all(|v| v.abs() < 1e-3 || v.abs() > 1.0 - 1e-3)
}

fn meet(a: &Aabb, b: &Aabb) -> bool {
    (0..3).all(|i| a.min[i] < b.max[i] && b.min[i] < a.max[i])
}

/// The opening that a door, frame or window fills: as thick as the walls it is in.
fn hole(house: &House, opening: &WallOpening) -> Aabb {
    let (mut hole, thin) = (opening.clear, opening.across);
    // An open leaf says little about the opening; the frame in the same place has its exact box.
    let framed = house.openings.iter().find(|o| house.is_frame(o.door) && meet(&o.clear, &opening.clear));
    if let Some(frame) = framed {
        hole = frame.clear;
    }
    let near = Aabb { min: hole.min - Vector3::repeat(NEAR), max: hole.max + Vector3::repeat(NEAR) };
    let wide = 1 - thin;
    let along = |w: &&Aabb| w.max[thin] - w.min[thin] < w.max[wide] - w.min[wide] && w.max[thin] - w.min[thin] < 0.6;
    let walls = house.walls.iter().filter(|w| meet(w, &near)).filter(along);
    if let Some((low, high)) = walls.map(|w| (w.min[thin], w.max[thin])).reduce(|p, q| (p.0.min(q.0), p.1.max(q.1))) {
        (hole.min[thin], hole.max[thin]) = (low, high);
    }
    hole
}

/// A strip on the floor in place of a frame whose door has its own.
fn threshold(node: &Node, opening: &WallOpening, mat: MaterialId) -> Option<Built> {
    let (bounds, pose) = (node.spec().bounds?, node.pose()?);
    let pose = upright(pose, &bounds);
    if !quarter(&pose.rotation) {
        return None;
    }
    let clear = opening.clear;
    let top = Point3::new(clear.max.x, clear.max.y, clear.min.z + STRIP);
    let (a, c) = (pose.inverse() * clear.min, pose.inverse() * top);
    let asset = one_block("threshold", (a.inf(&c), a.sup(&c)), mat);
    Some(Built { asset, pose, bounds: Bounds { frame: BoundsFrame::Object, ..bounds } })
}

/// A door, window or empty frame, generated for its opening.
fn filled(house: &House, opening: &WallOpening, node: &Node, style: &Style, seed: Seed) -> Option<Built> {
    let hole = hole(house, opening);
    let shut = house.is_frame(node.id()) && leads_out(house, &hole, opening.across);
    let generator = house.generators.get(if shut { "main_door" } else { node.class() })?;
    let size = hole.max - hole.min;
    let size = if opening.across == 0 { size } else { Vector3::new(size.y, size.x, size.z) };
    let seed = seed.child(node.spec().name.as_deref().unwrap_or("opening"));
    let (pose, bounds) = (node.pose()?, node.spec().bounds?);
    let made = if super::is_unturned(&bounds) {
        generator.sized(size, style, seed)
    } else {
        nearest(generator, size, &bounds.size(), style, seed)
    };
    let known = Some(pose.rotation).filter(|turn| !super::is_unturned(&bounds) && quarter(turn));
    let (turn, mirrored) = hung(house, (&hole, opening.across), node.id(), known);
    let made = if mirrored { made.mirrored() } else { made };
    let made = if shut { fixed(made) } else { made };
    let foot = Point3::new((hole.min.x + hole.max.x) / 2.0, (hole.min.y + hole.max.y) / 2.0, hole.min.z);
    let pose = Isometry3::from_parts(pose.translation, turn);
    let by = (pose.inverse() * foot).coords;
    let Object { asset, bounds, .. } = made;
    let bounds = Bounds { offset: bounds.offset + by, ..bounds };
    Some(Built { asset: moved(asset, by), pose, bounds })
}

/// Whether there is a floor at one side of a hole only. A frame without a door would open into nothing there.
fn leads_out(house: &House, hole: &Aabb, across: usize) -> bool {
    let beyond = |way: f32| {
        let mut at = hole.centre().xy();
        at[across] += way * (BEYOND + 0.5 * (hole.max[across] - hole.min[across]));
        house.has_floor(at)
    };
    beyond(1.0) != beyond(-1.0)
}

/// The object with its doors and drawers fixed as they are.
fn fixed(mut object: Object) -> Object {
    let asset = &mut object.asset;
    asset.parts.iter_mut().chain(&mut asset.collision).for_each(|part| part.joint = None);
    asset.surfaces.iter_mut().for_each(|surface| surface.joint = None);
    object
}

/// The one for a hole that is as large as a box of its own, frame and handles included.
fn nearest(generator: &Generator, hole: Vector3<f32>, own: &Vector3<f32>, style: &Style, seed: Seed) -> Object {
    let first = generator.sized(hole, style, seed);
    let off = own - first.size();
    let hole = (hole + off).map(|side| side.max(THIN));
    let made = |n: u64| generator.sized(hole, style, if n == 0 { seed } else { seed.nth(n) });
    let misfit = |o: &Object| (own - o.size()).amax();
    (0..LIKE).map(made).min_by(|a, b| misfit(a).total_cmp(&misfit(b))).unwrap_or(first)
}

/// The facing direction of a door or window, and whether its hinge is on the right: it opens to the
/// side with more free floor, and its open leaf stands where it is least in the way.
fn hung(
    house: &House,
    (hole, across): (&Aabb, usize),
    id: NodeId,
    known: Option<UnitQuaternion<f32>>,
) -> (UnitQuaternion<f32>, bool) {
    let centre = hole.centre().xy();
    let width = hole.max[1 - across] - hole.min[1 - across];
    let level = house.level(hole);
    let facings: [Facing; 2] = if across == 0 { [Facing(0), Facing(2)] } else { [Facing(1), Facing(3)] };
    let free = |facing: Facing, hinge: f32| {
        let (x, y) = facing.step();
        let (ahead, left) = (Vector2::new(x, y), Vector2::new(-y, x));
        let at = |i: usize, side: f32| centre + ahead * (0.15 * i as f32 + 0.1) + left * (side * width * 0.45);
        let leaf = (1..=5).filter(|&i| house.is_free(at(i, hinge), level, id)).count();
        let way = (1..=5).filter(|&i| house.is_free(at(i, 0.0), level, id)).count();
        leaf + 2 * way
    };
    let turn = |facing: Facing| UnitQuaternion::from_axis_angle(&Vector3::z_axis(), facing.yaw());
    let wanted = |f: &Facing| known.is_none_or(|k| k.angle_to(&turn(*f)) < 0.1);
    let ways = facings.into_iter().filter(wanted).flat_map(|f| [(f, 1.0), (f, -1.0)]);
    let best = ways.map(|(f, hinge)| (free(f, hinge), f, hinge)).reduce(|p, q| if q.0 > p.0 { q } else { p });
    best.map_or((known.unwrap_or_default(), false), |(_, f, hinge)| (turn(f), hinge < 0.0))
}
