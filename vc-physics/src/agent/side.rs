//! Taking hold of a thing by one of its sides.

use nalgebra::{Point3, UnitQuaternion, Vector3};
use rapier3d::geometry::{Collider, SharedShape};
use vc_graph::{NodeId, Pose, Side};

use super::reach::point_distance;
use crate::displaced::NONE;
use crate::state::{Hand, Thing};
use crate::world::PhysicsWorld;
use crate::{AgentError, convert, group};

/// Half the thickness and half the width of a hand that takes hold, and its distance from the thing, metres.
const HAND: Vector3<f32> = Vector3::new(0.015, 0.03, 0.03);
const OFF: f32 = 0.004;

/// # Sides
impl PhysicsWorld {
    /// The middle of a side of the box around a thing, in the world's frame, and the direction out of it.
    pub(crate) fn side_of(&self, thing: &Thing, side: Side) -> (Point3<f32>, Vector3<f32>) {
        let (pose, out) = (self.engine.pose(thing.state.base).unwrap_or_else(Pose::identity), side.direction());
        (pose * side_middle(thing.form.extent, side), pose.rotation * out)
    }

    /// The things that leave no room for a hand at a side of a thing.
    pub(crate) fn things_at_side(&self, thing: &Thing, side: Side) -> Vec<NodeId> {
        let (middle, out) = self.side_of(thing, side);
        let turn = UnitQuaternion::rotation_between(&Vector3::x(), &out).unwrap_or_default();
        let at = convert::pose(&Pose::from_parts((middle.coords + out * (OFF + HAND.x)).into(), turn));
        let counts = |c: &Collider| {
            let other = group::marked(c.user_data).0;
            group::is_solid(c) && other != thing.id && !self.agents.contains_key(&other)
        };
        let (shape, mut found) = (SharedShape::cuboid(HAND.x, HAND.y, HAND.z), Vec::new());
        self.each_met((&shape, &at), &counts, &NONE, &mut |collider, _| {
            found.push(group::marked(collider.user_data).0);
            true
        });
        found.sort_unstable();
        found.dedup();
        found
    }

    /// As [`grab_with_load`](Self::grab_with_load), by a side: the hand is at the middle of that side then.
    ///
    /// # Errors
    /// As [`grab`](Self::grab); [`AgentError::SideTaken`] if things leave no room for the hand.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_graph::Side;
    /// use vc_physics::Hand;
    /// world.teleport(home.person, vc_graph::Pose::translation(0.3, 0.0, 0.0))?;
    /// world.grab_by_side(home.person, (Hand::Right, Side::Top), home.cup, &[])?;
    /// let held = world.pose(home.cup).ok_or("no body")?.translation.z;
    /// world.grab_by_side(home.person, (Hand::Left, Side::Top), home.cup, &[]).unwrap_err();
    /// assert!(held < 1.2, "it hangs from the hand");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn grab_by_side(
        &mut self,
        agent: NodeId,
        (hand, side): (Hand, Side),
        id: NodeId,
        load: &[NodeId],
    ) -> Result<(), AgentError> {
        let (body, thing) = (self.agent_state(agent)?, self.thing(id)?);
        let (middle, _) = self.side_of(thing, side);
        let (distance, reach) = (point_distance(body, &body.feet, middle), body.plan.reach);
        if distance > reach {
            return Err(AgentError::OutOfReach { agent, id, distance, reach });
        }
        if let Some(&by) = self.things_at_side(thing, side).first() {
            return Err(AgentError::SideTaken { id, side, by });
        }
        let load = self.load_among(id, load);
        self.take(agent, hand, id, &load, Some(side))
    }
}

/// The middle of a side of a box.
pub(super) fn side_middle((low, high): (Point3<f32>, Point3<f32>), side: Side) -> Point3<f32> {
    let half = (high - low) / 2.0;
    nalgebra::center(&low, &high) + side.direction().component_mul(&half)
}
