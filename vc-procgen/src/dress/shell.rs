//! The building: floors, ceilings, walls with holes, doors and windows in them.

use nalgebra::{Isometry3, Point2, Point3, UnitQuaternion, Vector3};
use vc_graph::asset::{Hold, Surface};
use vc_graph::class::Category;
use vc_graph::{Aabb, Asset, Bounds, Frame, Node, NodeId, Pose, SceneGraph, Seed};

use super::compose::{block, moved};
use super::house::House;
use crate::Style;
use crate::furnish::Facing;
use crate::material::{self, Mat};
use crate::object::{self, Object};

/// What a floor or ceiling is made thick if it has no thickness, metres.
const SLAB: f32 = 0.1;
/// Walls this thick in both directions are corners: their box is what they stand around.
const CORNER: f32 = 0.6;
/// Thickness of a corner's arms, metres.
const ARM: f32 = 0.06;
/// How far trims overlap the wall beside an opening, metres.
const TRIM: f32 = 0.05;
/// How far from an opening's box the walls may be that it is in, metres.
const NEAR: f32 = 0.12;
/// Rooms with tiles.
const WET: [&str; 5] = ["bathroom", "kitchen", "laundry_room", "toilet_room", "shower_room"];

/// A hole in one wall or in two back to back.
#[derive(Debug, Clone)]
pub(super) struct Opening {
    hole: Aabb,
    /// Whether the wall runs along Y.
    along_y: bool,
    /// The frame around it, the door or window in it.
    frame: Option<NodeId>,
    filling: Option<NodeId>,
}

/// Something of the building as it is drawn.
pub(super) struct Built {
    pub(super) asset: Asset,
    pub(super) pose: Pose,
    pub(super) bounds: Bounds,
}

/// What the building has for a node; `None` if the node is no part of it.
pub(super) fn built(graph: &SceneGraph, house: &House, node: &Node, style: &Style, seed: Seed) -> Option<Built> {
    let room = graph.room_of(node.id()).and_then(|r| graph.node(r)).map_or("", |r| r.class());
    let wet = WET.contains(&room);
    match &**node.class() {
        "floor" => slab(node, if wet { style.tile } else { style.floor }, true),
        "ceiling" => slab(node, material::WALL_WHITE, false),
        "wall" => wall(house, node, if room == "bathroom" { style.tile } else { style.wall }),
        _ => {
            let opening = house.openings.iter().find(|o| [o.frame, o.filling].contains(&Some(node.id())))?;
            if opening.filling == Some(node.id()) {
                return filled(house, opening, node, style, seed);
            }
            match opening.filling {
                Some(_) => threshold(node, opening, style.joinery),
                None => filled(house, opening, node, style, seed),
            }
        }
    }
}

/// The pose whose axes a node's box is aligned with.
fn upright(pose: &Pose, bounds: &Bounds) -> Pose {
    match bounds.frame {
        Frame::Object => *pose,
        Frame::World => Isometry3::from_parts(pose.translation, UnitQuaternion::identity()),
    }
}

fn slab(node: &Node, mat: Mat, floor: bool) -> Option<Built> {
    let (bounds, pose) = (node.spec().bounds?, node.pose()?);
    let (mut low, mut high) = (Point3::from(bounds.offset - bounds.half), Point3::from(bounds.offset + bounds.half));
    if high.z - low.z < 0.01 {
        (low.z, high.z) = if floor { (high.z - SLAB, high.z) } else { (low.z, low.z + SLAB) };
    }
    let mut asset = of_blocks(node.class(), &[(low, high)], mat);
    if floor {
        let centre = Point3::new(bounds.offset.x, bounds.offset.y, high.z);
        let half = (bounds.half.x, bounds.half.y);
        asset.surfaces.push(Surface { name: "floor".into(), hold: Hold::On, centre, half, clearance: None, joint: None });
    }
    Some(Built { asset, pose: upright(pose, &bounds), bounds: around(low, high) })
}

fn around(low: Point3<f32>, high: Point3<f32>) -> Bounds {
    Bounds { offset: nalgebra::center(&low, &high).coords, half: (high - low) / 2.0, frame: Frame::Object }
}

fn of_blocks(name: &str, blocks: &[(Point3<f32>, Point3<f32>)], mat: Mat) -> Asset {
    let parts = blocks.iter().map(|&(low, high)| block(name, low, high, mat)).collect();
    Asset { name: name.into(), parts, ..Asset::default() }
}

fn wall(house: &House, node: &Node, mat: Mat) -> Option<Built> {
    let (bounds, pose) = (node.spec().bounds?, node.pose()?);
    let pose = upright(pose, &bounds);
    let (low, high) = (Point3::from(bounds.offset - bounds.half), Point3::from(bounds.offset + bounds.half));
    let mut blocks = Vec::new();
    for arm in arms(house, node) {
        cut(arm, &house.openings, &mut blocks);
    }
    // A wall that is askew has no holes: openings are cut along the world's axes.
    let mut own: Vec<(Point3<f32>, Point3<f32>)> = vec![(low, high)];
    if quarter(&pose.rotation) {
        let to_own = |b: &Aabb| {
            let (a, c) = (pose.inverse() * b.min, pose.inverse() * b.max);
            (a.inf(&c), a.sup(&c))
        };
        own = blocks.iter().map(to_own).collect();
    }
    Some(Built { asset: of_blocks("wall", &own, mat), pose, bounds: Bounds { frame: Frame::Object, ..bounds } })
}

/// Whether a turn takes the upright axes to upright axes.
fn quarter(turn: &UnitQuaternion<f32>) -> bool {
    turn.to_rotation_matrix().matrix().iter().all(|v| v.abs() < 1e-3 || v.abs() > 1.0 - 1e-3)
}

/// The straight pieces a wall is made of. A box that is thick both ways is a corner: it
/// has an arm at each of its sides beyond which its room has no floor.
pub(super) fn arms(house: &House, node: &Node) -> Vec<Aabb> {
    let Some(b) = node.aabb() else { return Vec::new() };
    let size = b.max - b.min;
    if size.x.min(size.y) < CORNER {
        return vec![b];
    }
    let room = house.graph.room_of(node.id());
    let centre = b.centre().xy();
    let half = size.xy() / 2.0;
    let within = |at: Point2<f32>| {
        let here = |f: &Aabb| (f.min.x..=f.max.x).contains(&at.x) && (f.min.y..=f.max.y).contains(&at.y);
        house.floors.iter().any(|(f, of)| *of == room && here(f))
    };
    let steps = [0, 1, 2, 3].map(|k| Facing(k).step());
    let beyond = |(x, y): (f32, f32)| centre + Vector3::new(x * (half.x + 0.3), y * (half.y + 0.3), 0.0).xy();
    let mut sides: Vec<(f32, f32)> = steps.into_iter().filter(|&s| !within(beyond(s))).collect();
    if sides.len() > 2 && !within(centre) || sides.is_empty() {
        // No floor of its room says more: the sides away from its middle.
        let middle = room.and_then(|r| house.graph.node(r)?.aabb()).map_or(centre, |r| r.centre().xy());
        let out = centre - middle;
        sides = vec![(out.x.signum(), 0.0), (0.0, out.y.signum())];
    }
    sides.into_iter().map(|side| arm(&b, side)).collect()
}

fn arm(b: &Aabb, (x, y): (f32, f32)) -> Aabb {
    let mut arm = *b;
    match (x > 0.5, x < -0.5, y > 0.5) {
        (true, _, _) => arm.min.x = b.max.x - ARM,
        (_, true, _) => arm.max.x = b.min.x + ARM,
        (_, _, true) => arm.min.y = b.max.y - ARM,
        _ => arm.max.y = b.min.y + ARM,
    }
    arm
}

/// A piece of wall, less the openings in it.
fn cut(piece: Aabb, openings: &[Opening], out: &mut Vec<Aabb>) {
    const LEAST: f32 = 1e-3;
    if (piece.max - piece.min).min() < LEAST {
        return;
    }
    let Some((first, rest)) = openings.split_first() else { return out.push(piece) };
    let size = piece.max - piece.min;
    let hole = first.hole;
    let same_way = (size.x < size.y) == first.along_y;
    let (low, high) = (piece.min.sup(&hole.min), piece.max.inf(&hole.max));
    if !same_way || (high - low).min() <= 0.0 {
        return cut(piece, rest, out);
    }
    let axis = if first.along_y { 1 } else { 0 };
    let part = |axis: usize, from: f32, to: f32, of: Aabb| {
        let mut part = of;
        (part.min[axis], part.max[axis]) = (from, to);
        part
    };
    let beside = [(piece.min[axis], low[axis]), (high[axis], piece.max[axis])];
    beside.into_iter().for_each(|(from, to)| cut(part(axis, from, to, piece), rest, out));
    let within = part(axis, low[axis], high[axis], piece);
    // What is left of a hair over a threshold is no wall.
    let under = if low.z - piece.min.z < 0.05 { piece.min.z } else { low.z };
    [(piece.min.z, under), (high.z, piece.max.z)].into_iter().for_each(|(from, to)| cut(part(2, from, to, within), rest, out));
}

/// The openings of a house: frames with what is in them, and doors and windows without frame.
pub(super) fn openings(house: &House) -> Vec<Opening> {
    let category = |n: &Node| house.graph.classes().get(n.class()).map(|c| c.category);
    let frames = house.graph.nodes().filter(|n| &**n.class() == "doorjamb");
    let mut all: Vec<Opening> = frames.filter_map(|n| opening(house, n, true)).collect();
    for node in house.graph.nodes() {
        let door = match category(node) {
            Some(Category::Door) => true,
            Some(Category::Window) => false,
            _ => continue,
        };
        let Some(own) = node.aabb() else { continue };
        let stands_in = |o: &&mut Opening| door && o.filling.is_none() && overlap(&o.hole, &own);
        match all.iter_mut().find(stands_in) {
            Some(framed) => framed.filling = Some(node.id()),
            None => all.extend(opening(house, node, door).map(|o| Opening { frame: None, filling: Some(node.id()), ..o })),
        }
    }
    all
}

fn overlap(a: &Aabb, b: &Aabb) -> bool {
    (0..3).all(|i| a.min[i] < b.max[i] && b.min[i] < a.max[i])
}

/// The hole that a frame, door or window is in.
fn opening(house: &House, node: &Node, door: bool) -> Option<Opening> {
    let b = node.aabb()?;
    let near = Aabb { min: b.min - Vector3::repeat(NEAR), max: b.max + Vector3::repeat(NEAR) };
    let shared = |w: &Aabb| (w.max.inf(&near.max) - w.min.sup(&near.min)).product();
    let around: Vec<&Aabb> = house.walls.iter().filter(|w| overlap(w, &near)).collect();
    let size = b.max - b.min;
    let most = around.iter().max_by(|p, q| shared(p).total_cmp(&shared(q)));
    let along_y = most.map_or(size.x < size.y, |w| w.max.x - w.min.x < w.max.y - w.min.y);
    let (thin, wide) = if along_y { (0, 1) } else { (1, 0) };
    let mut hole = b;
    let walls = around.into_iter().filter(|w| (w.max[thin] - w.min[thin] < CORNER) && (w.max.x - w.min.x < w.max.y - w.min.y) == along_y);
    if let Some((low, high)) = walls.map(|w| (w.min[thin], w.max[thin])).reduce(|p, q| (p.0.min(q.0), p.1.max(q.1))) {
        (hole.min[thin], hole.max[thin]) = (low, high);
        let trim = if door { TRIM.min(size[wide] * 0.1) } else { 0.0 };
        (hole.min[wide], hole.max[wide]) = (b.min[wide] + trim, b.max[wide] - trim);
        hole.max.z -= trim;
    }
    Some(Opening { hole, along_y, frame: Some(node.id()), filling: None })
}

/// A strip on the floor in place of a frame whose door has its own.
fn threshold(node: &Node, opening: &Opening, mat: Mat) -> Option<Built> {
    let (bounds, pose) = (node.spec().bounds?, node.pose()?);
    let pose = upright(pose, &bounds);
    if !quarter(&pose.rotation) {
        return None;
    }
    let hole = opening.hole;
    let top = Point3::new(hole.max.x, hole.max.y, hole.min.z + 0.004);
    let (a, c) = (pose.inverse() * hole.min, pose.inverse() * top);
    let asset = of_blocks("threshold", &[(a.inf(&c), a.sup(&c))], mat);
    Some(Built { asset, pose, bounds: Bounds { frame: Frame::Object, ..bounds } })
}

/// A door, window or empty frame as its generator makes it for the hole.
fn filled(house: &House, opening: &Opening, node: &Node, style: &Style, seed: Seed) -> Option<Built> {
    let generator = object::generator(node.class())?;
    let hole = opening.hole;
    let size = hole.max - hole.min;
    let size = if opening.along_y { size } else { Vector3::new(size.y, size.x, size.z) };
    let own = node.spec().name.as_deref().unwrap_or("opening");
    let made = generator.sized(size, style, seed.child(own));
    let (pose, bounds) = (node.pose()?, node.spec().bounds?);
    let known = Some(pose.rotation).filter(|turn| !super::is_unturned(&bounds) && quarter(turn));
    let (turn, mirrored) = hung(house, opening, node.id(), known);
    let made = if mirrored { made.mirrored() } else { made };
    let foot = Point3::new((hole.min.x + hole.max.x) / 2.0, (hole.min.y + hole.max.y) / 2.0, hole.min.z);
    let pose = Isometry3::from_parts(pose.translation, turn);
    let by = (pose.inverse() * foot).coords;
    let Object { asset, bounds, .. } = made;
    let bounds = Bounds { offset: bounds.offset + by, ..bounds };
    Some(Built { asset: moved(asset, by), pose, bounds })
}

/// Which way a door or window looks, and whether its hinge is on the right: it opens to the side
/// where there is more floor, and its open leaf stands where it is least in the way.
fn hung(house: &House, opening: &Opening, id: NodeId, known: Option<UnitQuaternion<f32>>) -> (UnitQuaternion<f32>, bool) {
    let hole = opening.hole;
    let centre = hole.centre().xy();
    let width = if opening.along_y { hole.max.y - hole.min.y } else { hole.max.x - hole.min.x };
    let level = house.level(&hole);
    let facings: [Facing; 2] = if opening.along_y { [Facing(0), Facing(2)] } else { [Facing(1), Facing(3)] };
    let free = |facing: Facing, hinge: f32| {
        let (x, y) = facing.step();
        let (ahead, left) = (nalgebra::Vector2::new(x, y), nalgebra::Vector2::new(-y, x));
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
