//! Room for doors, lids and drawers: a place that stands in the way of none.

use rapier3d::geometry::{Collider, ColliderHandle, SharedShape};
use rapier3d::math::Pose as EnginePose;
use rapier3d::parry::query::intersection_test;
use rapier3d::pipeline::QueryFilter;
use vc_graph::{NodeId, Pose};

use crate::state::Thing;
use crate::world::PhysicsWorld;
use crate::{BodyRole, PhysicsError, convert, group};

/// Number of positions that are tested from shut to open.
const TESTED: usize = 8;
/// How far the own doors of a thing have to open where it is put, as a share of their range.
const HALF: f32 = 0.5;

impl PhysicsWorld {
    /// Whether a node at a pose leaves room for what opens: no part of another node meets it between shut and
    /// open, and its own parts meet nothing fixed until they are half open.
    ///
    /// Costs some microseconds, and some ten for each part nearby.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// let cup = world.pose(home.cup).ok_or("no cup")?;
    /// assert!(world.leaves_openings_free(home.cup, &cup)?); // No door opens over the table.
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn leaves_openings_free(&self, id: NodeId, pose: &Pose) -> Result<bool, PhysicsError> {
        let thing = self.thing(id)?;
        let meets_it = |shape: &SharedShape, at: &EnginePose| overlaps(thing, pose, shape, at);
        let near = self.things.iter().filter(|other| other.id != id && self.may_open_into(other, thing, pose));
        let others = near.filter_map(|other| Some((other, self.engine.pose(other.state.base)?)));
        let mut bars = others.map(|(other, base)| self.meets_on_opening(other, &base, 1.0, &meets_it));
        Ok(!bars.any(|bars| bars)
            && !self.meets_on_opening(thing, pose, HALF, &|shape, at| self.meets_fixed(id, shape, at)))
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
            (1..=TESTED).any(|tested| {
                let share = open * tested as f32 / TESTED as f32;
                let position = self.target(thing.id, part, share);
                position.is_ok_and(|position| meets(shape, &(convert::pose(&(base * joint.motion(position))) * *local)))
            })
        })
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
