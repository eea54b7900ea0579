//! Room for doors, lids and drawers: a place that stands in the way of none, and one that lets them shut again.

use rapier3d::geometry::{Collider, ColliderHandle, SharedShape};
use rapier3d::math::Pose as EnginePose;
use rapier3d::parry::query::intersection_test;
use rapier3d::pipeline::QueryFilter;
use vc_graph::asset::Hold;
use vc_graph::{NodeId, Pose};

use super::travel::{POSITIONS, Travel};
use crate::place::SupportSurface;
use crate::state::Thing;
use crate::world::PhysicsWorld;
use crate::{BodyRole, PhysicsError, convert, group};

/// How far the own doors of a thing have to open where it is put, as a share of their range.
const HALF: f32 = 0.5;

impl PhysicsWorld {
    /// Whether a thing at a pose leaves room for what opens.
    pub(crate) fn leaves_openings_free(&self, thing: &Thing, pose: &Pose) -> bool {
        let meets_it = |shape: &SharedShape, at: &EnginePose| overlaps(thing, pose, shape, at);
        let near = self.things.iter().filter(|other| other.id != thing.id && self.may_open_into(other, thing, pose));
        let others = near.filter_map(|other| Some((other, self.engine.pose(other.state.base)?)));
        let mut bars = others.map(|(other, base)| self.meets_on_opening(other, &base, 1.0, &meets_it));
        !bars.any(|bars| bars)
            && !self.meets_on_opening(thing, pose, HALF, &|shape, at| self.meets_fixed(thing.id, shape, at))
    }

    /// Whether the parts of one thing may reach another at a pose.
    fn may_open_into(&self, other: &Thing, thing: &Thing, pose: &Pose) -> bool {
        let Some(bounds) = self.aabb(other.id).filter(|_| !other.state.moving.is_empty()) else { return false };
        let (low, high) = thing.form.extent;
        let between = bounds.centre() - pose * nalgebra::center(&low, &high);
        // A door is no wider than the thing it belongs to.
        between.norm() <= (high - low).norm() / 2.0 + 1.5 * (bounds.max - bounds.min).norm()
    }

    /// Whether some part of a thing with its base at a pose meets something until it is open by a share of its range.
    fn meets_on_opening(
        &self,
        thing: &Thing,
        base: &Pose,
        open: f32,
        meets: &dyn Fn(&SharedShape, &EnginePose) -> bool,
    ) -> bool {
        (0..thing.state.moving.len()).any(|part| {
            let link = &thing.form.links[part + 1];
            let Some((joint, (shape, local))) = link.joint.zip(link.solid.as_ref()) else { return false };
            let ends = self.target(thing.id, part, 0.0).and_then(|shut| Ok((shut, self.target(thing.id, part, open)?)));
            ends.is_ok_and(|way| {
                let travel = Travel { joint, base: *base, way };
                travel.poses().any(|at| meets(shape, &(convert::pose(&at) * *local)))
            })
        })
    }

    /// Whether a node at a pose in another would keep that from being shut.
    pub(crate) fn keeps_open(&self, id: NodeId, at: NodeId, pose: &Pose) -> Result<bool, PhysicsError> {
        let (thing, around) = (self.thing(id)?, self.thing(at)?);
        let carrier = self.part_below(around, thing, pose);
        let carried = carrier.and_then(|part| Some((part, self.shutting(around, part)?)));
        // Drawers shut before doors.
        let shut = carried.as_ref().map_or(*pose, |(_, travel)| travel.since_start(POSITIONS) * pose);
        let hits = |part: usize| {
            let (Some(travel), Some((shape, local))) =
                (self.shutting(around, part), around.form.links[part + 1].solid.as_ref())
            else {
                return false;
            };
            travel.poses().any(|at| overlaps(thing, &shut, shape, &(convert::pose(&at) * *local)))
        };
        let mut others = (0..around.state.moving.len()).filter(|part| Some(*part) != carrier);
        Ok(carried.is_some_and(|(part, travel)| self.sticks_out(thing, (at, part), pose, &travel)) || others.any(hits))
    }

    /// Whether a thing that a part carries would meet anything but the part's node and load, and agents, who give way,
    /// while the part shuts.
    fn sticks_out(&self, thing: &Thing, (at, part): (NodeId, usize), pose: &Pose, travel: &Travel) -> bool {
        let load = self.load_of_part(at, part);
        let mut passes = |id: NodeId| id == at || self.agents.contains_key(&id) || load.contains(&id);
        (1..=POSITIONS).any(|step| !self.for_overlaps(thing, &(travel.since_start(step) * pose), &mut passes))
    }

    /// The way of an open part until it is shut; `None` if it is shut or does not move.
    fn shutting(&self, around: &Thing, part: usize) -> Option<Travel> {
        let (joint, base) = (around.form.links[part + 1].joint?, self.engine.pose(around.state.base)?);
        let way = (self.part_position(around, part)?, self.target(around.id, part, 0.0).ok()?);
        (way.0 != way.1).then_some(Travel { joint, base, way })
    }

    /// The part of a thing that has the surface inside on which another one stands at a pose.
    fn part_below(&self, around: &Thing, thing: &Thing, pose: &Pose) -> Option<usize> {
        let (low, high) = thing.form.extent;
        let middle = pose * nalgebra::center(&low, &high);
        let height = |shelf: &SupportSurface| shelf.height_under(&middle);
        let shelves = self.surfaces_that(around, Hold::Inside).into_iter();
        let below = shelves.filter_map(|shelf| Some((height(&shelf)?, shelf.surface)));
        let (_, surface) = below.min_by(|a, b| a.0.total_cmp(&b.0))?;
        around.form.link_with(surface)?.checked_sub(1)
    }

    /// Whether a shape meets anything fixed but one thing.
    fn meets_fixed(&self, but: NodeId, shape: &SharedShape, at: &EnginePose) -> bool {
        let fixed = |_: ColliderHandle, c: &Collider| {
            let id = group::marked(c.user_data).0;
            id != but && group::is_solid(c) && self.role(id) == Some(BodyRole::Fixed)
        };
        let queries = self.engine.queries(QueryFilter::default().exclude_sensors().predicate(&fixed));
        queries.intersect_shape(*at, &**shape).next().is_some()
    }
}

/// Whether a thing at a pose, shut, overlaps a shape.
fn overlaps(thing: &Thing, pose: &Pose, shape: &SharedShape, at: &EnginePose) -> bool {
    let solid = thing.form.links.iter().filter_map(|link| link.solid.as_ref());
    let meets = |(own, local): &(SharedShape, EnginePose)| {
        intersection_test(&(convert::pose(pose) * *local), &**own, at, &**shape).is_ok_and(|met| met.intersecting)
    };
    solid.into_iter().any(meets)
}
