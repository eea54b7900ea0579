//! The areas of the floor that bodies cover.

use nalgebra::{Point2, Point3, Vector3};
use vc_geometry::outline::{Outline, contains, hull, rectangle};
use vc_graph::{NodeId, Pose};

use super::{DoorHandling, FloorOptions};
use crate::BodyRole;
use crate::shapes::{Footprint, Link, levels};
use crate::state::Thing;
use crate::world::PhysicsWorld;

/// Motion up to which a door counts as closed, metres.
const SAME: f32 = 0.005;
/// The largest depth of a floor piece below the floor's level, metres.
const BELOW: f32 = 0.1;
/// The largest horizontal quaternion component of an upright thing.
const LEVEL: f32 = 1e-3;
/// The largest number of things between a thing and its fixed support.
const STACKED: usize = 8;

/// The area that a node covers, and the poses for which it was computed.
#[derive(Debug, Clone)]
pub(crate) struct Cover {
    pub(crate) id: NodeId,
    pub(crate) outlines: Vec<Outline>,
    /// The parts that walkers move out of the way: the closed leaf of a door between rooms, the open parts of
    /// furniture.
    pub(crate) gate: Vec<Outline>,
    poses: Vec<Pose>,
    role: Option<BodyRole>,
    locked: bool,
}

impl Cover {
    pub(crate) fn fixed(outlines: Vec<Outline>) -> Self {
        let id = NodeId(u32::MAX);
        Self { id, outlines, gate: Vec::new(), poses: Vec::new(), role: None, locked: false }
    }

    fn new(world: &PhysicsWorld, thing: &Thing, options: &FloorOptions) -> Self {
        let poses = poses(world, thing);
        let locked = thing.state.moving.iter().any(|m| m.locked);
        let mut cover =
            Self { id: thing.id, outlines: Vec::new(), gate: Vec::new(), poses, role: Some(thing.state.role), locked };
        if thing.state.role == BodyRole::Carried || is_covered(world, thing, options) {
            return cover;
        }
        let base = cover.poses.first().copied().unwrap_or_else(Pose::identity);
        let outlines = |link: usize, pose: &Pose| {
            outlines(&thing.form.links[link], pose, |low, high| is_in_the_way(options, low, high))
        };
        for (link, pose) in cover.poses.iter().enumerate() {
            let (door, open) = (thing.state.door && link > 0, !near(pose, &base));
            let aside = options.doors == DoorHandling::Opened && !locked && (door || open);
            if door || aside {
                cover.gate.extend(outlines(link, if door { &base } else { pose }));
            }
            if !aside {
                cover.outlines.extend(outlines(link, pose));
            }
        }
        cover
    }

    fn is_current(&self, world: &PhysicsWorld, thing: &Thing) -> bool {
        let now = poses(world, thing);
        self.id == thing.id
            && self.role == Some(thing.state.role)
            && self.locked == thing.state.moving.iter().any(|m| m.locked)
            && self.poses == now
    }
}

/// Whether two poses agree within tolerance.
fn near(a: &Pose, b: &Pose) -> bool {
    (a.translation.vector - b.translation.vector).norm() < SAME && (a.rotation.coords - b.rotation.coords).norm() < SAME
}

/// Poses of a thing's links.
fn poses(world: &PhysicsWorld, thing: &Thing) -> Vec<Pose> {
    poses_at(world, thing, world.engine.pose(thing.state.base).unwrap_or_else(Pose::identity))
}

/// Poses of its links if it were at a pose.
fn poses_at(world: &PhysicsWorld, thing: &Thing, base: Pose) -> Vec<Pose> {
    let part = |(i, link): (usize, &Link)| {
        let position = world.part_position(thing, i).unwrap_or(0.0);
        link.joint.map_or(base, |j| base * j.motion(position))
    };
    let parts = thing.form.links.iter().skip(1).enumerate().map(part);
    std::iter::once(base).chain(parts).collect()
}

/// Whether some support in the graph's support chain of a thing is fixed and covers all of it: cups on a table
/// obstruct nobody. The contents of an open drawer move along when it is closed.
fn is_covered(world: &PhysicsWorld, thing: &Thing, options: &FloorOptions) -> bool {
    let below = |t: &Thing| world.thing(t.state.rests?.at).ok();
    let mut chain = std::iter::successors(below(thing), |t| below(t)).take(STACKED);
    let Some(at) = chain.find(|t| t.state.role == BodyRole::Fixed).filter(|_| thing.state.role != BodyRole::Fixed)
    else {
        return false;
    };
    let base = world.engine.pose(at.state.base).filter(is_upright);
    let (Some(base), Some(around)) = (base, world.aabb(thing.id)) else { return false };
    let local = |p: Point2<f32>| base.inverse_transform_point(&Point3::new(p.x, p.y, 0.0)).xy();
    let corners: Outline = rectangle(&around.min.xy(), &around.max.xy()).into_iter().map(local).collect();
    let (low, high) = corners.iter().fold((corners[0], corners[0]), |(l, h), p| (l.inf(p), h.sup(p)));
    let level = base.translation.z;
    let counts = |f: &&Footprint| is_in_the_way(options, level + f.levels().0, level + f.levels().1);
    let covers = at.form.links[0].footprints().iter().filter(counts).any(|f| f.covers(&corners, &low, &high));
    covers || goes_along(world, at, &around.centre().xy(), options)
}

/// Whether a point is over an open part of a thing that is closed in passing.
fn goes_along(world: &PhysicsWorld, thing: &Thing, point: &Point2<f32>, options: &FloorOptions) -> bool {
    let locked = thing.state.moving.iter().any(|m| m.locked);
    let poses = poses(world, thing);
    let Some(base) = poses.first().filter(|_| options.doors == DoorHandling::Opened && !locked) else { return false };
    let mut open = poses.iter().enumerate().skip(1).filter(|(_, pose)| !near(pose, base));
    let over = |outline: &Outline| contains(outline, std::slice::from_ref(point));
    let in_the_way = |low, high| is_in_the_way(options, low, high);
    open.any(|(link, pose)| outlines(&thing.form.links[link], pose, in_the_way).iter().any(over))
}

/// The area that a thing would cover at a pose.
pub(crate) fn outlines_at(world: &PhysicsWorld, thing: &Thing, pose: &Pose, options: &FloorOptions) -> Vec<Outline> {
    let poses = poses_at(world, thing, *pose);
    let links = thing.form.links.iter().zip(&poses);
    links.flat_map(|(link, pose)| outlines(link, pose, |low, high| is_in_the_way(options, low, high))).collect()
}

/// Outlines of the relevant pieces of a link, selected by their lower and upper heights.
fn outlines(link: &Link, pose: &Pose, counts: impl Fn(f32, f32) -> bool) -> Vec<Outline> {
    if is_upright(pose) { standing(link, pose, counts) } else { tilted(link, pose, counts) }
}

/// Whether a pose turns around the vertical only.
fn is_upright(pose: &Pose) -> bool {
    pose.rotation.i.abs() < LEVEL && pose.rotation.j.abs() < LEVEL
}

/// Whether a height range lies between floor and head.
fn is_in_the_way(options: &FloorOptions, low: f32, high: f32) -> bool {
    high > options.level + options.step && low < options.level + options.height
}

/// The precomputed footprints of an upright link, without those that others cover.
fn standing(link: &Link, pose: &Pose, counts: impl Fn(f32, f32) -> bool) -> Vec<Outline> {
    let (all, z) = (link.footprints(), pose.translation.z);
    let counts = |f: &Footprint| counts(z + f.levels().0, z + f.levels().1);
    let front = pose.rotation * Vector3::x();
    let (at, cos, sin) = (pose.translation.vector.xy(), front.x, front.y);
    let placed = |p: &Point2<f32>| Point2::new(cos * p.x - sin * p.y + at.x, sin * p.x + cos * p.y + at.y);
    let seen = all.iter().filter(|f| counts(f) && !f.within.is_some_and(|w| counts(&all[w])));
    seen.map(|f| f.outline().iter().map(placed).collect()).collect()
}

fn tilted(link: &Link, pose: &Pose, counts: impl Fn(f32, f32) -> bool) -> Vec<Outline> {
    let piece = |corners: &Vec<Point3<f32>>| {
        let placed: Vec<Point3<f32>> = corners.iter().map(|p| pose * p).collect();
        let (low, high) = levels(&placed);
        counts(low, high).then(|| hull(placed.iter().map(Point3::xy)))
    };
    link.hulls().iter().filter_map(piece).collect()
}

/// The covered areas of all nodes.
pub(crate) fn covers(world: &PhysicsWorld, options: &FloorOptions) -> Vec<Cover> {
    world.things.iter().map(|t| Cover::new(world, t, options)).collect()
}

/// Updates the covers; returns whether any outline changed. The covers depend only on the bodies' poses, not on
/// their history.
pub(crate) fn update(covers: &mut Vec<Cover>, world: &PhysicsWorld, options: &FloorOptions) -> bool {
    if covers.len() != world.things.len() || covers.iter().zip(&world.things).any(|(c, t)| c.id != t.id) {
        *covers = self::covers(world, options);
        return true;
    }
    let mut changed = false;
    for (cover, thing) in covers.iter_mut().zip(&world.things) {
        if !cover.is_current(world, thing) {
            let new = Cover::new(world, thing, options);
            changed |= new.outlines != cover.outlines || new.gate != cover.gate;
            *cover = new;
        }
    }
    changed
}

/// Outlines of the ground: pieces of the building whose top is the floor; the rooms' boxes if there are none.
pub(crate) fn ground(world: &PhysicsWorld, options: &FloorOptions) -> Vec<Outline> {
    let tops = options.level - BELOW..=options.level + options.step;
    let mut found = Vec::new();
    for thing in world.things.iter().filter(|t| t.state.structure && t.state.role == BodyRole::Fixed) {
        let Some(base) = world.engine.pose(thing.state.base) else { continue };
        found.extend(outlines(&thing.form.links[0], &base, |_, top| tops.contains(&top)));
    }
    if found.is_empty() {
        found = world.rooms.iter().map(|(_, room)| rectangle(&room.min.xy(), &room.max.xy())).collect();
    }
    found
}
