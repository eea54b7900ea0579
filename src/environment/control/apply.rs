//! A tick under control: feet and hands are moved, and what came of it is read.

use nalgebra::Vector2;
use vc_graph::NodeId;
use vc_physics::{Hand, Posture};

use super::Control;
use crate::environment::Environment;

impl Environment {
    /// Lets bodies go on as they are controlled; those that are no longer, stop.
    pub(in crate::environment) fn apply_controls(&mut self) {
        if self.clock.controls.is_empty() {
            return;
        }
        if std::mem::take(&mut self.clock.controls.new) {
            self.clock.stirred = true;
            for agent in self.agents().to_vec() {
                let control = self.controlled(agent).copied();
                self.withdraw_hands(agent, &control.unwrap_or_default());
                self.move_feet(agent, control);
            }
        }
        for (agent, control) in self.clock.controls.all.clone() {
            let reached = self.reachable(agent, &control);
            for (hand, goal) in Hand::BOTH.into_iter().zip(reached).filter_map(|(hand, goal)| Some((hand, goal?))) {
                // It has been checked.
                let _ = self.world.guide_hand(agent, hand, goal);
            }
        }
    }

    fn withdraw_hands(&mut self, agent: NodeId, control: &Control) {
        for (hand, _) in Hand::BOTH.into_iter().zip(control.hands).filter(|(_, goal)| goal.is_none()) {
            if self.world.agent(agent).is_ok_and(|agent| agent.guided(hand).is_some()) {
                // The agent is there.
                let _ = self.world.withdraw_hand(agent, hand);
                self.clock.changed.push(agent);
            }
        }
    }

    /// Lets an agent walk as it is controlled. One that is not, and drifts still, stops.
    fn move_feet(&mut self, agent: NodeId, control: Option<Control>) {
        let stands = self.world.posture(agent) == Some(Posture::Standing);
        let walks = self.world.agent(agent).is_ok_and(|agent| agent.walk() == vc_physics::WalkState::Walking);
        let (velocity, turn) = control.map_or((Vector2::zeros(), 0.0), |control| (control.velocity, control.turn));
        if stands && (control.is_some() || walks) {
            // It stands, and the numbers have been checked.
            let _ = self.world.drift(agent, velocity, turn);
        }
    }

    /// Reads what bodies under control have brought about in a tick.
    pub(in crate::environment) fn follow_controls(&mut self) {
        if self.clock.controls.all.is_empty() || !self.clock.unseen {
            return;
        }
        for agent in self.clock.controls.all.keys().copied().collect::<Vec<_>>() {
            Hand::BOTH.into_iter().for_each(|hand| self.follow_hold(agent, hand));
        }
        // A relation that cannot be told in this moment is read in a later one.
        drop(self.read_moved());
    }
}
