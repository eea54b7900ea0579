//! Whether and how an object fits into a place.

use nalgebra::{Isometry3, Quaternion, Translation3, UnitQuaternion, Vector3};
use vc_graph::asset::{Hold, Surface};
use vc_graph::class::Class;
use vc_graph::portable::Portable;
use vc_graph::{Aabb, AssetLibrary, Bounds, Node, NodeId, ObjectRole, Pose, Property, Relation, SceneGraph, Stream};

use super::error::PlacementReason;
use super::site::Site;
use super::solid::{Solids, meet, part_boxes};
use super::walk::Walk;

/// The gap between objects, and to a surface's edge, metres.
const GAP: f32 = 0.004;
/// The gap between furniture and the wall behind it, metres.
const WALL_GAP: f32 = 0.025;
/// The maximal distance from furniture to the wall behind it, metres.
const BEHIND: f32 = 0.15;
/// The height above the support at which objects are released, metres.
const LIFT: f32 = 0.001;
/// The space that stays free below the ceiling, metres.
const HEADROOM: f32 = 0.05;
/// The floor that stays free in front of a door, metres.
const DOORWAY: f32 = 0.85;
/// The floor that stays free in front of furniture that opens, metres: for its door, and for a
/// person who passes while it stands open.
const FRONT: f32 = 1.3;
/// The widest door for which the floor in front of other furniture stays free, metres.
const DOOR: f32 = 0.9;
/// The number of positions sampled on a surface before it is given up.
const TRIES: usize = 24;

/// The scene into which objects are fitted.
pub(super) struct Fit<'a> {
    pub(super) graph: &'a SceneGraph,
    pub(super) assets: &'a AssetLibrary,
    pub(super) solids: &'a Solids,
    pub(super) walk: Option<&'a Walk>,
}

impl Fit<'_> {
    /// Samples a pose for an object at a site; `None` where the scene or the object has no
    /// dimensions, so that no collision can be tested.
    pub(super) fn pose(
        &self,
        class: &Class,
        bounds: Option<Bounds>,
        site: &Site,
        stream: &mut Stream,
    ) -> Result<Option<Pose>, PlacementReason> {
        let Some(carrier) = self.graph.node(site.at) else { return Err(PlacementReason::Absent) };
        let (Some(bounds), Some(pose), Some(aabb)) = (bounds, carrier.pose(), carrier.aabb()) else { return Ok(None) };
        let own = carrier.spec().asset.and_then(|id| self.assets.get(id));
        let surface = own.zip(site.surface).and_then(|(asset, i)| asset.surfaces.get(i)).cloned();
        let surface = surface.unwrap_or_else(|| plain_surface(&aabb, pose, site.relation));
        let ways = Ways { class, bounds: &bounds, surface: &surface, carrier: carrier.spec().bounds };
        let mut why = PlacementReason::TooSmall;
        for _ in 0..TRIES {
            let Some(local) = ways.draw(self.is_floor(site), stream) else { return Err(why) };
            let world = pose * local;
            match self.obstacle(&bounds.aabb(&world), site, &surface) {
                None if self.is_in_the_way(class, &bounds, &world, site) => why = PlacementReason::Unreachable,
                None => return Ok(Some(world)),
                Some(reason) => why = reason,
            }
        }
        Err(why)
    }

    fn is_floor(&self, site: &Site) -> bool {
        let floor = |id| self.graph.node(id).is_some_and(|n| n.role() == ObjectRole::Floor);
        site.relation == Relation::InRoom || floor(site.at)
    }

    /// Whether furniture would stand away from any wall, as at an edge of the floor where the room
    /// goes on, or, once open, leave no way past its front, or stand before the door of other furniture.
    fn is_in_the_way(&self, class: &Class, bounds: &Bounds, pose: &Pose, site: &Site) -> bool {
        let opens = class.affordances.contains(Property::Openable);
        let before = beside(bounds, FRONT).aabb(pose);
        let is_shut_in = || self.solids.hit(self.graph, self.assets, &before, &[site.at]).is_some();
        let behind = beside(bounds, -BEHIND).aabb(pose);
        let walls: Vec<Aabb> = self.walls().collect();
        let stands_free = !walls.is_empty() && !walls.iter().any(|wall| meet(wall, &behind));
        self.is_floor(site)
            && !class.affordances.contains(Property::Graspable)
            && (stands_free || opens && is_shut_in() || self.is_before_a_door(&bounds.aabb(pose)))
    }

    /// Whether a box is where the doors and drawers of furniture open.
    fn is_before_a_door(&self, aabb: &Aabb) -> bool {
        let opens = |n: &&Node| {
            n.role() == ObjectRole::Furniture && n.affords(Property::Openable) && !n.affords(Property::Graspable)
        };
        let front = |n: &Node| {
            let bounds = n.spec().bounds?;
            Some(beside(&bounds, (2.0 * bounds.half.y).min(DOOR)).aabb(n.pose()?))
        };
        self.graph.nodes().filter(opens).filter_map(front).any(|front| meet(&front, aabb))
    }

    fn walls(&self) -> impl Iterator<Item = Aabb> + '_ {
        let walls = self.graph.of_role(ObjectRole::Wall);
        walls.flat_map(|wall| part_boxes(wall, self.assets))
    }

    /// The reason why an object cannot be where its bounding box would be.
    fn obstacle(&self, aabb: &Aabb, site: &Site, surface: &Surface) -> Option<PlacementReason> {
        let height = aabb.max.z - aabb.min.z;
        let room = self.graph.room_of(site.at);
        let ceiling = room.and_then(|r| self.graph.node(r)?.aabb()).map(|b| b.max.z - HEADROOM);
        let low = surface.hold != Hold::Hook && surface.clearance.is_some_and(|c| height > c - GAP);
        if low || ceiling.is_some_and(|c| aabb.max.z > c) {
            return Some(PlacementReason::TooLow);
        }
        let mut besides = self.graph.support_chain(site.at);
        besides.push(site.at);
        if self.solids.hit(self.graph, self.assets, aabb, &besides).is_some() {
            return Some(PlacementReason::Taken);
        }
        let doors = || self.graph.of_role(ObjectRole::Door).filter_map(Node::aabb);
        if self.is_floor(site) && doors().any(|door| meet(&before(&door), aabb)) {
            return Some(PlacementReason::Unreachable);
        }
        self.walk.filter(|walk| !walk.reaches(aabb, room)).map(|_| PlacementReason::Unreachable)
    }
}

/// The space of the given depth in front of an object; behind it if the depth is negative.
fn beside(bounds: &Bounds, depth: f32) -> Bounds {
    let half = Vector3::new(depth.abs() / 2.0, bounds.half.y, bounds.half.z);
    let offset = bounds.offset + Vector3::new((bounds.half.x + half.x) * depth.signum(), 0.0, 0.0);
    Bounds { offset, half, ..*bounds }
}

/// The bounding box of a door and of the floor on both sides of it.
fn before(door: &Aabb) -> Aabb {
    door.grown(DOORWAY, 0.0)
}

/// The top or the interior of a bounding box as a surface, in its owner's frame.
fn plain_surface(aabb: &Aabb, pose: &Pose, relation: Relation) -> Surface {
    let (centre, half) = (aabb.centre(), (aabb.max - aabb.min) / 2.0);
    // In an upright frame the world box has the right width and depth; in a rotated one the
    // smaller of the two is safe.
    let side = half.x.min(half.y);
    let level = if relation == Relation::On { aabb.max.z } else { aabb.min.z };
    let point = pose.inverse_transform_point(&nalgebra::Point3::new(centre.x, centre.y, level));
    let upright = pose.rotation.angle() < 1e-3;
    Surface {
        name: "box".into(),
        hold: if relation == Relation::Inside { Hold::Inside } else { Hold::On },
        centre: point,
        half: if upright { (half.x, half.y) } else { (side, side) },
        clearance: (relation == Relation::Inside).then_some(2.0 * half.z),
        joint: None,
    }
}

/// The ways in which an object could lie on a surface.
struct Ways<'a> {
    class: &'a Class,
    bounds: &'a Bounds,
    surface: &'a Surface,
    carrier: Option<Bounds>,
}

impl Ways<'_> {
    /// Samples one of them, in the frame of the surface's owner; `None` if the object is too large
    /// for all.
    fn draw(&self, floor: bool, stream: &mut Stream) -> Option<Pose> {
        match (self.surface.hold, floor && !self.class.affordances.contains(Property::Graspable)) {
            (Hold::Hook, _) => self.hung(),
            (_, true) => self.against_an_edge(stream),
            _ => self.lying(stream),
        }
    }

    fn lying(&self, stream: &mut Stream) -> Option<Pose> {
        let quarter = stream.below(4) as f32 * std::f32::consts::FRAC_PI_2;
        let free = self.surface.hold == Hold::On && stream.chance(0.5);
        let turned = quarter + if free { stream.between(-0.25, 0.25) } else { 0.0 };
        let other = quarter + std::f32::consts::FRAC_PI_2;
        // An object too long for one direction may fit the other.
        let (yaw, (rx, ry)) = [turned, quarter, other].into_iter().find_map(|yaw| Some((yaw, self.room(yaw)?)))?;
        let (x, y) = (stream.between(-rx, rx), stream.between(-ry, ry));
        Some(self.standing(x, y, yaw))
    }

    /// How far the object's centre may be from the surface's centre.
    fn room(&self, yaw: f32) -> Option<(f32, f32)> {
        let (hx, hy) = self.extent(yaw);
        let (rx, ry) = (self.surface.half.0 - hx - GAP, self.surface.half.1 - hy - GAP);
        (rx >= 0.0 && ry >= 0.0).then_some((rx, ry))
    }

    /// With its back to one of the surface's four edges, as furniture stands against walls.
    fn against_an_edge(&self, stream: &mut Stream) -> Option<Pose> {
        let side = stream.below(4);
        let yaw = side as f32 * std::f32::consts::FRAC_PI_2;
        let (rx, ry) = self.room(yaw)?;
        let (ex, ey) = ((rx - WALL_GAP).max(0.0), (ry - WALL_GAP).max(0.0));
        let (x, y) = match side {
            0 => (-ex, stream.between(-ry, ry)),
            1 => (stream.between(-rx, rx), -ey),
            2 => (ex, stream.between(-ry, ry)),
            _ => (stream.between(-rx, rx), ey),
        };
        Some(self.standing(x, y, yaw))
    }

    /// Below a hook, with the back off the wall; on a rod across it and within its wardrobe. `None`
    /// if the object would reach the ground.
    fn hung(&self) -> Option<Pose> {
        let (size, at) = (self.bounds.size(), self.surface.centre);
        let rod = self.surface.name.starts_with("rod");
        let yaw = if rod { std::f32::consts::FRAC_PI_2 } else { 0.0 };
        let (hx, hy) = self.extent(yaw);
        let within = |c: Bounds| hx + 0.03 < c.half.x && (at.y - c.offset.y).abs() + hy + 0.02 < c.half.y;
        let fits = !rod || self.carrier.is_none_or(within);
        let off_the_wall = self.carrier.map_or(0.0, |c| c.offset.x - c.half.x + hx + 0.002 - at.x);
        let mut pose = self.standing(if rod { 0.0 } else { off_the_wall.max(0.0) }, 0.0, yaw);
        pose.translation.z -= size.z + LIFT;
        let drop = self.surface.clearance.unwrap_or(f32::INFINITY);
        (fits && size.z <= drop).then_some(pose)
    }

    fn extent(&self, yaw: f32) -> (f32, f32) {
        let (sin, cos) = (yaw.sine().abs(), yaw.cosine().abs());
        let half = self.bounds.half;
        (half.x * cos + half.y * sin, half.x * sin + half.y * cos)
    }

    /// Standing with the centre of its bounding box at a point, measured from the surface's centre.
    fn standing(&self, x: f32, y: f32, yaw: f32) -> Pose {
        let turn = turned(yaw);
        let (centre, offset) = (self.surface.centre, turn * self.bounds.offset);
        let base = self.bounds.offset.z - self.bounds.half.z;
        let at = Vector3::new(centre.x + x - offset.x, centre.y + y - offset.y, centre.z + LIFT - base);
        Isometry3::from_parts(Translation3::from(at), turn)
    }
}

/// A rotation about Z that is the same on every machine.
pub(super) fn turned(yaw: f32) -> UnitQuaternion<f32> {
    let (sin, cos) = (yaw / 2.0).sine_cosine();
    UnitQuaternion::new_normalize(Quaternion::new(cos, 0.0, 0.0, sin))
}

/// Whether the transition rules forbid an agent to put an object there, whatever its pose.
pub(super) fn refused(graph: &SceneGraph, agent: NodeId, id: NodeId, site: &Site) -> bool {
    let floor = site.relation == Relation::InRoom || graph.node(site.at).is_some_and(|n| n.role() == ObjectRole::Floor);
    !floor && !vc_graph::Condition::Fits(id, site.at).holds(graph, agent)
}
