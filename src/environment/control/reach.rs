//! How far arms reach, and how a figure's hands are posed.

use nalgebra::Vector3;
use vc_graph::{NodeId, Pose};
use vc_people::{Activity, BodySide, Skeleton};
use vc_physics::{Hand, HandGoal};

use super::Control;
use crate::environment::Environment;

/// From the point between fingers and thumb to the middle of the palm: back along the fingers, and out of the back of the
/// hand beside half the opening, metres.
const BACK: f32 = 0.03;
const OUT: f32 = 0.011;

impl Environment {
    /// The goals of the hands of an agent, as near as the body brings them.
    pub(super) fn reachable(&self, agent: NodeId, control: &Control) -> [Option<HandGoal>; 2] {
        let openings = Hand::BOTH.map(|hand| self.guided(agent, hand).map_or(0.0, |(_, opening)| opening));
        let wanted = [0, 1].map(|i| control.hands[i].map(|goal| palm_at(&goal.pose, openings[i])));
        let doing = Activity { palms: wanted, ..Activity::default() };
        let Some(attitude) = self.attitude(agent) else { return control.hands };
        let body = Skeleton::new(attitude, &doing, [None, None]);
        let nearest = |(side, goal, wanted): (BodySide, HandGoal, Pose)| {
            let missed = body.palm(side).translation.vector - wanted.translation.vector;
            let at = goal.pose.translation.vector + if missed.norm() > NEGLIGIBLE { missed } else { Vector3::zeros() };
            HandGoal { pose: Pose::from_parts(at.into(), goal.pose.rotation), ..goal }
        };
        [0, 1].map(|i| Some(nearest((BodySide::BOTH[i], control.hands[i]?, wanted[i]?))))
    }

    /// The activity of an agent's figure under control: its hands and its head.
    pub(in crate::environment) fn under_control(&self, agent: NodeId, doing: Activity) -> Activity {
        let Some(control) = self.controlled(agent) else { return doing };
        let feet = self.world.pose(agent).unwrap_or_else(Pose::identity);
        let palm = |(pose, opening): (Pose, f32)| palm_at(&(feet.inverse() * pose), opening);
        let palms = Hand::BOTH.map(|hand| self.guided(agent, hand).map(palm));
        // Whoever guides a hand looks at it.
        let watched = palms.iter().flatten().next().map(|palm| feet * nalgebra::Point3::from(palm.translation.vector));
        let head = control.head.map(|head| (head.x, head.y));
        Activity { palms, head, gaze: watched.or(doing.gaze), ..doing }
    }

    /// The pose of a guided hand, and how far it is open, metres.
    fn guided(&self, agent: NodeId, hand: Hand) -> Option<(Pose, f32)> {
        self.world.agent(agent).ok()?.guided(hand).map(|hand| (hand.pose, hand.opening))
    }
}

/// An error of the figure's arms that is none of reach, metres.
const NEGLIGIBLE: f32 = 2e-3;

/// The palm of a hand with the point between fingers and thumb at a pose.
fn palm_at(pose: &Pose, opening: f32) -> Pose {
    pose * Pose::translation(-BACK, 0.0, opening / 2.0 + OUT)
}
