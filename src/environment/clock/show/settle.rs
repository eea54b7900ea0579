//! Sitting down, lying down and getting up: the transition between two postures.

use vc_graph::{NodeId, Pose};
use vc_people::{Activity, Skeleton};
use vc_physics::Hand;

use super::between;
use crate::environment::Environment;
use crate::environment::clock::schedule::SETTLING;

/// A transition between two postures, from the one before.
#[derive(Debug, Clone)]
pub(in crate::environment::clock) struct Settling {
    was: Pose,
    skeleton: Skeleton,
    grips: [Option<Pose>; 2],
}

impl Settling {
    /// The posture of an agent that is about to take another one.
    pub(in crate::environment::clock) fn begin(home: &Environment, agent: NodeId) -> Option<Self> {
        let grips = Hand::BOTH.map(|hand| home.world.agent(agent).ok().and_then(|agent| agent.grip(hand)));
        Some(Self { was: home.world.pose(agent)?, skeleton: home.skeleton(agent)?, grips })
    }

    /// Shows an agent some seconds after it has taken the other posture.
    pub(super) fn show(&self, home: &mut Environment, agent: NodeId, since: f32) {
        let share = (since / SETTLING.seconds() as f32).min(1.0);
        // Eased at both ends.
        let share = share * share * (3.0 - 2.0 * share);
        let Some(now) = home.world.pose(agent) else { return };
        let moved = now.inverse() * self.was;
        for (hand, grip) in Hand::BOTH.into_iter().zip(self.grips) {
            if let (Some(from), Some(to)) = (grip, home.world.agent(agent).ok().and_then(|agent| agent.grip(hand))) {
                // The thing is in that hand.
                let _ = home.world.regrip(agent, hand, between(&(moved * from), &to, share));
            }
        }
        let transition = Some((self.skeleton.transformed(&moved), share));
        home.poses.insert(agent, Activity { transition, ..Activity::default() });
    }
}
