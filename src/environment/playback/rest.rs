//! Sitting down, lying down and getting up: the transition between two postures.

use vc_graph::Pose;
use vc_people::{Activity, Skeleton};
use vc_physics::Hand;

use super::{Player, between};
use crate::environment::Environment;

/// Duration of the transition, seconds.
const SETTLING: f32 = 1.0;

/// A transition between two postures.
#[derive(Debug, Clone)]
pub(super) struct Settling {
    /// The former skeleton, relative to the present pose.
    from: Skeleton,
    /// The grips of the held things at the beginning and at the end.
    held: Vec<(Hand, Pose, Pose)>,
}

impl Player {
    /// Takes a posture, in the world at once and in the picture gradually; returns whether the posture is
    /// reached.
    pub(super) fn settle(&mut self, show: &mut Environment, before: f32, act: impl FnOnce(&mut Environment)) -> bool {
        if before == 0.0 {
            let (was, skeleton) = (self.feet(show), show.skeleton(self.agent));
            let grips = Hand::BOTH.map(|hand| show.world.agent(self.agent).ok().and_then(|agent| agent.grip(hand)));
            act(show);
            self.come_true(show);
            let moved = self.feet(show).inverse() * was;
            let held = Hand::BOTH.into_iter().zip(grips).filter_map(|(hand, grip)| {
                let now = show.world.agent(self.agent).ok()?.grip(hand)?;
                Some((hand, moved * grip?, now))
            });
            let held = held.collect();
            self.settling = skeleton.map(|from| Settling { from: from.transformed(&moved), held });
        }
        let Some(Settling { from, held }) = &self.settling else { return true };
        let share = (self.time / SETTLING).min(1.0);
        // Eased at both ends.
        let share = share * share * (3.0 - 2.0 * share);
        for (hand, from, to) in held {
            // The thing is in that hand.
            let _ = show.world.regrip(self.agent, *hand, between(from, to, share));
        }
        show.poses.insert(self.agent, Activity { transition: Some((from.clone(), share)), ..Activity::default() });
        self.time >= SETTLING
    }
}
