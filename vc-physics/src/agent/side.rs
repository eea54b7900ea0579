//! Taking hold of a thing by one of its sides.

use nalgebra::{Point3, UnitQuaternion, Vector3};
use rapier3d::geometry::{Collider, SharedShape};
use vc_graph::{NodeId, Pose, Side};

use crate::displaced::NONE;
use crate::state::{Hand, Posture};
use crate::world::PhysicsWorld;
use crate::{AgentError, PhysicsError, convert, group};

/// Half the thickness and half the width of a hand that takes hold, and its distance from the thing, metres.
const HAND: Vector3<f32> = Vector3::new(0.015, 0.03, 0.03);
const OFF: f32 = 0.004;

/// # Sides
impl PhysicsWorld {
    /// The middle of a side of the box around a thing, in the world's frame, and the direction out of it. `None`
    /// without a body.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_graph::Side;
    /// let (top, up) = world.side_of(home.cup, Side::Top).ok_or("no body")?;
    /// assert!(up.z > 0.999 && (top.z - 0.84).abs() < 2e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn side_of(&self, id: NodeId, side: Side) -> Option<(Point3<f32>, Vector3<f32>)> {
        let (pose, out) = (self.pose(id)?, side.direction());
        Some((pose * side_middle(self.local_bounds(id)?, side), pose.rotation * out))
    }

    /// The things that leave no room for a hand at a side of a thing.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_graph::Side;
    /// assert!(world.things_at_side(home.cup, Side::Left)?.is_empty());
    /// assert_eq!(world.things_at_side(home.table, Side::Top)?, [home.cup]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn things_at_side(&self, id: NodeId, side: Side) -> Result<Vec<NodeId>, PhysicsError> {
        let (middle, out) = self.side_of(id, side).ok_or(PhysicsError::NoBody(id))?;
        let turn = UnitQuaternion::rotation_between(&Vector3::x(), &out).unwrap_or_default();
        let at = convert::pose(&Pose::from_parts((middle.coords + out * (OFF + HAND.x)).into(), turn));
        let counts = |c: &Collider| {
            let other = group::marked(c.user_data).0;
            group::is_solid(c) && other != id && !self.agents.contains_key(&other)
        };
        let (shape, mut found) = (SharedShape::cuboid(HAND.x, HAND.y, HAND.z), Vec::new());
        self.each_met((&shape, &at), &counts, &NONE, &mut |collider, _| {
            found.push(group::marked(collider.user_data).0);
            true
        });
        found.sort_unstable();
        found.dedup();
        Ok(found)
    }

    /// The distance from an agent's shoulder to a point, with its feet at a pose, metres; see
    /// [`reach_distance`](Self::reach_distance).
    ///
    /// # Errors
    /// [`AgentError::NoSuchAgent`].
    pub fn point_distance(&self, agent: NodeId, feet: &Pose, point: Point3<f32>) -> Result<f32, AgentError> {
        let body = self.agent(agent)?;
        let arm = match body.posture {
            Posture::Standing => super::reach::leaning(&body.plan, feet.translation.vector.into(), point),
            _ => body.shoulder(),
        };
        Ok((point - arm).norm())
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
        let (middle, _) = self.side_of(id, side).ok_or(PhysicsError::NoBody(id))?;
        let (feet, reach) = (self.agent(agent)?.feet, self.agent(agent)?.plan.reach);
        let distance = self.point_distance(agent, &feet, middle)?;
        if distance > reach {
            return Err(AgentError::OutOfReach { agent, id, distance, reach });
        }
        if let Some(&by) = self.things_at_side(id, side)?.first() {
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
