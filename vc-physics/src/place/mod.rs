//! Finding free places, and what is in the way.

mod close;
mod raster;
mod way;

use nalgebra::{Point3, UnitQuaternion, Vector3};
use rapier3d::geometry::{Collider, ColliderHandle, Ray, SharedShape};
use rapier3d::math::Pose as EnginePose;
use rapier3d::pipeline::QueryFilter;
use vc_graph::asset::{Hold, Surface};
use vc_graph::{NodeId, Pose, Seed};

use self::raster::{PITCH, is_burner, spots};
use self::way::{ACROSS, HEAP, INTO, ONTO, TURNTABLE, Tip, Way};
use crate::world::{PhysicsWorld, Thing};
use crate::{BodyRole, PhysicsError, convert, group};

/// Gap that is left between a thing and what it is put on, metres: it is at rest
/// after a millimetre's fall.
const GAP: f32 = 0.001;
/// How much smaller a thing is taken than it is when it is looked for overlaps,
/// metres: what stands in contact does not overlap.
const SKIN: f32 = 0.001;
/// Room that is left around a thing where it is put, metres: rims of plates do not touch, which are wider than the
/// polygons that stand for them here.
const AROUND: f32 = 0.015;
/// How far beside a surface the middle of a thing may be that is on it, metres.
const BESIDE: f32 = 0.005;
/// How far above a surface the bottom of a thing is that is on it, metres.
const LOW: f32 = 0.02;

/// A place that holds things, in the world's frame as it is now.
#[derive(Debug, Clone, PartialEq)]
pub struct Shelf {
    /// The node it belongs to.
    pub id: NodeId,
    /// Its position in the asset's list.
    pub surface: usize,
    /// How it holds things.
    pub hold: Hold,
    /// Middle of what carries; X and Y along its sides.
    pub pose: Pose,
    /// Half lengths along its X and Y, metres.
    pub half: (f32, f32),
    /// Free height above it, metres, if something is above.
    pub clearance: Option<f32>,
}

/// In which order the spots of a surface are tried.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Order {
    /// The middle first.
    Middle,
    /// Nearest to a point first.
    Near(Point3<f32>),
    /// At random, from a seed.
    Random(Seed),
}

impl PhysicsWorld {
    /// The surfaces of a node as they are now: those of a drawer move with it.
    pub fn shelves(&self, id: NodeId) -> Vec<Shelf> {
        let Ok(thing) = self.thing(id) else { return Vec::new() };
        (0..thing.form.surfaces.len()).filter_map(|s| self.shelf_of(thing, s)).collect()
    }

    fn shelf_of(&self, thing: &Thing, surface: usize) -> Option<Shelf> {
        let of: &Surface = thing.form.surfaces.get(surface)?;
        let moved = of.joint.map_or_else(Pose::identity, |j| self.part_motion(thing, &j));
        let pose =
            self.engine.pose(thing.state.base)? * moved * Pose::translation(of.centre.x, of.centre.y, of.centre.z);
        Some(Shelf { id: thing.id, surface, hold: of.hold, pose, half: of.half, clearance: of.clearance })
    }

    /// Things a node would overlap if it were at a pose; itself, what it carries and
    /// what is carried do not count. Touching is not overlapping.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`], [`PhysicsError::NotFinite`].
    pub fn overlaps(&self, id: NodeId, pose: &Pose) -> Result<Vec<NodeId>, PhysicsError> {
        let thing = self.thing(id)?;
        if !convert::is_sound(pose) {
            return Err(PhysicsError::NotFinite("the pose", id));
        }
        let mut found: Vec<NodeId> = Vec::new();
        self.for_overlaps(thing, pose, &mut |node| {
            found.push(node);
            true
        });
        found.sort_unstable();
        found.dedup();
        Ok(found)
    }

    /// Calls for what a thing would overlap at a pose, as long as more is wanted; whether all has been found.
    /// Where a thing was in another moment of this world, brought along with the thing that it was on or in, or with the
    /// part of that which carried it. `None` if anything overlaps it there that did not overlap it then, or one of
    /// them was not there.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`], [`PhysicsError::NotFinite`].
    pub fn spot_as(&self, then: &Self, id: NodeId, at: NodeId) -> Result<Option<Pose>, PhysicsError> {
        let link = then.link_below(id, at);
        let frame = |world: &Self| link.checked_sub(1).map_or_else(|| world.pose(at), |part| world.part_pose(at, part));
        let (Some(was), Some(before), Some(now)) = (then.pose(id), frame(then), frame(self)) else { return Ok(None) };
        let (spot, known) = (now * before.inverse() * was, then.overlaps(id, &was)?);
        let more = self.overlaps(id, &spot)?.iter().any(|other| !known.contains(other));
        Ok((!more).then_some(spot))
    }

    /// Which link of a thing another one rests on; none of those that move is zero.
    pub(crate) fn link_below(&self, id: NodeId, at: NodeId) -> usize {
        let pinned = self.thing(id).ok().and_then(|thing| thing.state.rides);
        let part = pinned.or_else(|| self.rides(id)).filter(|(below, _)| *below == at);
        part.map_or(0, |(_, link)| link)
    }

    fn for_overlaps(&self, thing: &Thing, pose: &Pose, found: &mut dyn FnMut(NodeId) -> bool) -> bool {
        let solid = thing.form.links.iter().filter_map(|link| link.solid.as_ref());
        let mut bodies = solid.map(|(shape, at)| (shape, convert::pose(pose) * *at));
        bodies.all(|(shape, at)| self.each_overlap(shape, &at, thing.id, found))
    }

    /// Calls for every solid thing but one that a shape would overlap, as long as more is wanted; whether all
    /// has been found.
    fn each_overlap(
        &self,
        shape: &SharedShape,
        at: &EnginePose,
        but: NodeId,
        found: &mut dyn FnMut(NodeId) -> bool,
    ) -> bool {
        let other = |_: ColliderHandle, c: &Collider| group::is_solid(c) && group::marked(c.user_data).0 != but;
        let queries = self.engine.queries(QueryFilter::default().exclude_sensors().predicate(&other));
        for (_, collider) in queries.intersect_shape(*at, &**shape) {
            let between = at.inv_mul(collider.position());
            let depth =
                rapier3d::parry::query::contact(&EnginePose::IDENTITY, &**shape, &between, collider.shape(), 0.0);
            let overlaps = depth.ok().flatten().is_none_or(|c| c.dist < -SKIN);
            if overlaps && !found(group::marked(collider.user_data).0) {
                return false;
            }
        }
        true
    }

    /// Whether a thing would overlap nothing at a pose.
    fn is_clear(&self, thing: &Thing, pose: &Pose) -> bool {
        self.for_overlaps(thing, pose, &mut |_| false)
    }

    /// Whether a box of half lengths at a pose overlaps nothing.
    pub fn is_free(&self, half: Vector3<f32>, pose: &Pose) -> bool {
        if !is_size(&half) || !convert::is_sound(pose) {
            return false;
        }
        let shape = SharedShape::cuboid(half.x, half.y, half.z);
        self.each_overlap(&shape, &convert::pose(pose), NodeId(u32::MAX), &mut |_| false)
    }

    /// A pose at which a node stands free on a surface: within its edges, below what
    /// is above, clear of everything, turned by `yaw` against the surface. `None` if
    /// no spot is free.
    ///
    /// Spots are tried on a raster of four centimetres or coarser; each costs some
    /// microseconds.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`], [`PhysicsError::NoSuchSurface`],
    /// [`PhysicsError::NotFinite`].
    pub fn free_spot(
        &self,
        id: NodeId,
        on: NodeId,
        surface: usize,
        yaw: f32,
        order: Order,
    ) -> Result<Option<Pose>, PhysicsError> {
        let thing = self.thing(id)?;
        let shelf = self.shelf(on, surface)?;
        let turn = turn(yaw, id)?;
        let free = |spot: &Pose| self.is_clear(thing, spot);
        Ok(spots(thing.form.extent, &shelf, &turn, (0.0, 0.0), PITCH, order).into_iter().find(free))
    }

    /// As [`Self::free_spot`], for a box of half lengths that no node has yet: the pose of its
    /// middle.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`], [`PhysicsError::NoSuchSurface`],
    /// [`PhysicsError::NotFinite`] of the yaw or of lengths that are not positive.
    pub fn free_spot_for(
        &self,
        half: Vector3<f32>,
        on: NodeId,
        surface: usize,
        yaw: f32,
        order: Order,
    ) -> Result<Option<Pose>, PhysicsError> {
        let shelf = self.shelf(on, surface)?;
        if !is_size(&half) {
            return Err(PhysicsError::NotFinite("the footprint", on));
        }
        let spots = spots((Point3::from(-half), Point3::from(half)), &shelf, &turn(yaw, on)?, (0.0, 0.0), PITCH, order);
        Ok(spots.into_iter().find(|spot| self.is_free(half, spot)))
    }

    fn shelf(&self, on: NodeId, surface: usize) -> Result<Shelf, PhysicsError> {
        let below = self.thing(on)?;
        let count = below.form.surfaces.len();
        self.shelf_of(below, surface).ok_or(PhysicsError::NoSuchSurface { id: on, surface, count })
    }

    /// As [`Self::free_spot`], on whichever surface of a node has one: those inside
    /// if `inside`, otherwise those on top. What does not stand in a container is laid on its
    /// side; what is wider than a surface is put in the middle of it and reaches over its edges. Where there is
    /// no room left for the box around it, it is put [close](Self::close_spot_at) to what is there.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`].
    pub fn free_spot_at(
        &self,
        id: NodeId,
        at: NodeId,
        inside: bool,
        order: Order,
    ) -> Result<Option<Pose>, PhysicsError> {
        self.free_spot_where(id, at, inside, order, |_| true)
    }

    /// As [`Self::free_spot_at`], at a spot that satisfies a condition, which is tested last.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`].
    pub fn free_spot_where(
        &self,
        id: NodeId,
        at: NodeId,
        inside: bool,
        order: Order,
        admits: impl Fn(&Pose) -> bool,
    ) -> Result<Option<Pose>, PhysicsError> {
        let apart = if inside {
            self.spot_by(&INTO, id, at, Hold::Inside, order, &admits)?
        } else {
            self.spot_by(&ONTO, id, at, Hold::On, order, &admits)?
        };
        if apart.is_some() { Ok(apart) } else { self.close_spot_where(id, at, inside, order, &admits) }
    }

    /// As [`Self::free_spot_at`], a little above what is in a container, upon which the thing is
    /// let down.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`].
    pub fn heaped_spot_in(&self, id: NodeId, at: NodeId, order: Order) -> Result<Option<Pose>, PhysicsError> {
        self.spot_by(&HEAP, id, at, Hold::Inside, order, &|_| true)
    }

    fn spot_by(
        &self,
        ways: &[Way],
        id: NodeId,
        at: NodeId,
        hold: Hold,
        order: Order,
        admits: &dyn Fn(&Pose) -> bool,
    ) -> Result<Option<Pose>, PhysicsError> {
        let (thing, below) = (self.thing(id)?, self.thing(at)?);
        let mut shelves = self.shelves_that(below, hold);
        // What is put on a stove goes to a burner that is free, not beside what is on another.
        shelves.sort_by_cached_key(|shelf| is_burner(shelf) && !self.is_bare(shelf));
        let mut spots = ways.iter().flat_map(|way| shelves.iter().map(move |shelf| (way, shelf)));
        Ok(spots.find_map(|(way, shelf)| self.spot_among(thing, shelf, way, order, admits)))
    }

    /// The surfaces of a thing that hold things in a way.
    fn shelves_that(&self, thing: &Thing, hold: Hold) -> Vec<Shelf> {
        let all = (0..thing.form.surfaces.len()).filter_map(|s| self.shelf_of(thing, s));
        all.filter(|s| s.hold == hold).collect()
    }

    /// Whether nothing stands or lies on a surface.
    fn is_bare(&self, shelf: &Shelf) -> bool {
        let half = Vector3::new(shelf.half.0, shelf.half.1, LOW / 2.0);
        self.is_free(half, &(shelf.pose * Pose::translation(0.0, 0.0, GAP + half.z)))
    }

    /// The first free spot on a surface for what is put there in a way: one where the box around
    /// it is free too, if there is one, as a plate does not stand under another's rim. On top of
    /// things that box has to be free at least of what is loose.
    fn spot_among(
        &self,
        thing: &Thing,
        shelf: &Shelf,
        way: &Way,
        order: Order,
        admits: &dyn Fn(&Pose) -> bool,
    ) -> Option<Pose> {
        let (low, high) = thing.form.extent;
        let half = (high - low) / 2.0;
        let around = SharedShape::cuboid(half.x + AROUND, half.y + AROUND, half.z);
        let middle = convert::pose(&Pose::from_parts(nalgebra::center(&low, &high).into(), UnitQuaternion::identity()));
        let clear_around = |spot: &Pose, of: &dyn Fn(NodeId) -> bool| {
            self.each_overlap(&around, &(convert::pose(spot) * middle), thing.id, &mut |id| !of(id))
        };
        let clear = |spot: &Pose| self.is_clear(thing, spot);
        let loose = |id| self.is_loose_on(shelf, id);
        let first = |free: &dyn Fn(&Pose) -> bool| self.first_spot(thing, shelf, way, order, free, admits);
        let apart = first(&|spot| clear_around(spot, &|_| true) && clear(spot));
        apart.or_else(|| first(&|spot| clear(spot) && clear_around(spot, &loose)))
    }

    /// Whether a thing is loose, other than the one of a surface on top of which things are put.
    fn is_loose_on(&self, shelf: &Shelf, id: NodeId) -> bool {
        shelf.hold == Hold::On && id != shelf.id && self.role(id) == Some(BodyRole::Loose)
    }

    /// The first spot that counts as free and is admitted.
    fn first_spot(
        &self,
        thing: &Thing,
        shelf: &Shelf,
        way: &Way,
        order: Order,
        free: &dyn Fn(&Pose) -> bool,
        admits: &dyn Fn(&Pose) -> bool,
    ) -> Option<Pose> {
        let Way { heights, over, across, .. } = way;
        if !way.is_for(thing.form.extent, shelf) {
            return None;
        }
        // What reaches over the edges is balanced, and what is put on a burner is put on its middle.
        let order = if *over > 0.0 || is_burner(shelf) { Order::Middle } else { order };
        let (low, high) = thing.form.extent;
        let turns = self.turns_of(thing, way);
        // What is heaped higher than the rim is not in it.
        let rim = self.aabb(shelf.id).map_or(f32::INFINITY, |b| b.max.z - shelf.pose.translation.z);
        let within = |height: &&f32| **height == 0.0 || **height < rim;
        heights.iter().filter(within).find_map(|&height| {
            let lifted = |turn| spots((low, high), shelf, turn, (height, *over), PITCH, order);
            let carried = |spot: &Pose| !across || self.is_just_over(thing, spot, shelf.id);
            let found = |mut spots: Vec<Pose>| spots.drain(..).find(|spot| free(spot) && carried(spot) && admits(spot));
            if *over == 0.0 {
                return turns.iter().find_map(|turn| found(lifted(turn)));
            }
            // A thing that has to reach over the edges does so as little as possible.
            let mut all: Vec<Pose> = turns.iter().flat_map(lifted).collect();
            all.sort_by_key(|spot| overhang((low, high), shelf, spot));
            found(all)
        })
    }

    /// The turns by which a thing may be put down in a way; what carries something is not tipped.
    fn turns_of(&self, thing: &Thing, way: &Way) -> Vec<UnitQuaternion<f32>> {
        let (low, high) = thing.form.extent;
        let laden = self.is_laden(thing);
        let stands = |tip: &&Tip| **tip == Tip::Upright || !laden && tip.stands(high - low, way.slender);
        way.tips.iter().filter(stands).flat_map(|tip| tip.turns()).collect()
    }

    /// Whether a thing at a spot is no more than one step of [`ACROSS`] above another, and above nothing else.
    fn is_just_over(&self, thing: &Thing, spot: &Pose, at: NodeId) -> bool {
        let lower = Pose::translation(0.0, 0.0, -ACROSS[0]) * spot;
        let mut met = false;
        let only = self.for_overlaps(thing, &lower, &mut |id| {
            met |= id == at;
            id == at
        });
        met && only
    }

    /// Whether a thing is on one of another's surfaces, not on what is there, or inside: the middle
    /// of its box is over it or plainly in it, and inside half of its corners too.
    pub fn is_at(&self, id: NodeId, at: NodeId, inside: bool) -> bool {
        let (Some(aabb), Some(pose), Ok(thing)) = (self.aabb(id), self.pose(id), self.thing(id)) else { return false };
        let (low, high) = thing.form.extent;
        let middle = pose * nalgebra::center(&low, &high);
        let margin = if inside { -BESIDE } else { BESIDE };
        let over = |shelf: &Shelf, point: Point3<f32>, margin: f32| {
            let own = shelf.pose.inverse_transform_point(&point);
            let across = own.x.abs() <= shelf.half.0 + margin && own.y.abs() <= shelf.half.1 + margin;
            across.then_some(own.z)
        };
        let within = |shelf: &Shelf, point: Point3<f32>, margin: f32| {
            let top = shelf.clearance.unwrap_or(f32::INFINITY);
            over(shelf, point, margin).is_some_and(|height| (-GAP..=top).contains(&height))
        };
        let corner = |i: usize| {
            let at = |axis: usize| if i >> axis & 1 == 0 { low[axis] } else { high[axis] };
            pose * Point3::new(at(0), at(1), at(2))
        };
        // A thing that is wider than a turntable reaches over its edges.
        let reaches = |shelf: &Shelf| {
            let over = |half: f32, room: f32| (half - room).clamp(0.0, TURNTABLE.over * half);
            let half = (aabb.max - aabb.min) / 2.0;
            over(half.x.min(half.y), shelf.half.0.min(shelf.half.1))
                .max(over(half.x.max(half.y), shelf.half.0.max(shelf.half.1)))
        };
        let holds = |shelf: &Shelf| match shelf.hold {
            Hold::Inside => {
                let corners = (0..8).filter(|i| within(shelf, corner(*i), reaches(shelf))).count();
                inside && within(shelf, middle, margin) && corners >= 4
            }
            Hold::On => {
                let above = aabb.min.z - shelf.pose.translation.z;
                !inside && over(shelf, middle, margin).is_some() && above.abs() <= LOW
            }
            Hold::Hook => false,
        };
        self.shelves(at).iter().any(holds)
    }

    /// Whether there is something on or in a thing that would fall off it or run out.
    fn is_laden(&self, thing: &Thing) -> bool {
        let full = self.fills.get(&thing.id).is_some_and(|level| *level > 0.0);
        full || self.is_held_with_load(thing.id) || !self.load_of(thing.state.base).is_empty()
    }

    /// Nodes of which some part is within a distance of a point, nearest first, with
    /// the distance; walls and floors with them.
    pub fn within(&self, centre: Point3<f32>, radius: f32) -> Vec<(NodeId, f32)> {
        if !centre.iter().all(|c| c.abs() <= convert::FARTHEST) || !radius.is_finite() || radius < 0.0 {
            return Vec::new();
        }
        let radius = radius.min(convert::FARTHEST);
        let ball = rapier3d::parry::shape::Ball::new(radius.max(1e-4));
        let queries = self.engine.queries(QueryFilter::default().exclude_sensors());
        let at = EnginePose::from_translation(convert::point(centre));
        let mut found: Vec<(NodeId, f32)> = Vec::new();
        for (_, collider) in queries.intersect_shape(at, &ball) {
            let distance = collider.shape().distance_to_point(collider.position(), convert::point(centre), true);
            found.push((group::marked(collider.user_data).0, distance));
        }
        found.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        found.dedup_by_key(|f| f.0);
        found.sort_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
        found
    }

    /// The first node that a ray from one point to another meets, and where; those in
    /// `past` do not stop it.
    pub fn ray(&self, from: Point3<f32>, to: Point3<f32>, past: &[NodeId]) -> Option<(NodeId, Point3<f32>)> {
        let way = to - from;
        if !convert::is_finite(&way) || way.norm() < 1e-6 {
            return None;
        }
        let solid = |_: ColliderHandle, c: &Collider| !past.contains(&group::marked(c.user_data).0);
        let queries = self.engine.queries(QueryFilter::default().exclude_sensors().predicate(&solid));
        let ray = Ray::new(convert::point(from), convert::vector(way));
        let (collider, at) = queries.cast_ray(&ray, 1.0, true)?;
        Some((self.node_of(collider)?, from + way * at))
    }
}

/// Whether half lengths are those of a box.
fn is_size(half: &Vector3<f32>) -> bool {
    half.iter().all(|h| *h > 0.0 && *h <= convert::LARGEST)
}

/// A turn around the vertical.
fn turn(yaw: f32, of: NodeId) -> Result<UnitQuaternion<f32>, PhysicsError> {
    let sound = yaw.is_finite().then(|| UnitQuaternion::from_axis_angle(&Vector3::z_axis(), yaw));
    sound.ok_or(PhysicsError::NotFinite("the yaw", of))
}

/// How far a thing between two corners reaches over an edge of a surface at a spot, at most, centimetres.
fn overhang((low, high): (Point3<f32>, Point3<f32>), shelf: &Shelf, spot: &Pose) -> u32 {
    let own = shelf.pose.inverse() * spot;
    let half = own.rotation.to_rotation_matrix().matrix().abs() * (high - low) / 2.0;
    let middle = own * nalgebra::center(&low, &high);
    let over = (middle.x.abs() + half.x - shelf.half.0).max(middle.y.abs() + half.y - shelf.half.1);
    (100.0 * over.max(0.0)).round() as u32
}
