//! Tasks that are planned anew, since the world has changed meanwhile: another spot for what is put down, on after somebody
//! who walks.

use std::collections::VecDeque;

use vc_graph::{Effect, NodeId, rule};

use super::Interruption;
use super::schedule::Phase;
use crate::environment::execute::Task;
use crate::environment::{ActionError, Environment};

/// How often tasks are planned anew.
const CHASES: u32 = 5;

impl Environment {
    /// The effect by which an agent puts something down.
    fn effect_of_put(&self, agent: NodeId) -> Option<Effect<NodeId>> {
        let schedule = self.clock.running.get(&agent)?;
        let is_put = |effect: &Effect<NodeId>| matches!(effect, Effect::PutOn(..) | Effect::PutInto(..));
        rule::effects(self.graph.vocabulary(), &schedule.action).into_iter().find(is_put)
    }

    /// The thing on or into which an agent puts something.
    pub(super) fn place_of_put(&self, agent: NodeId) -> Option<NodeId> {
        match self.effect_of_put(agent)? {
            Effect::PutOn(_, at) | Effect::PutInto(_, at) => Some(at),
            _ => None,
        }
    }

    /// Whether an agent looks for another spot whose hand is where it puts something down, where somebody else has put
    /// something meanwhile, or on or in what has been moved.
    pub(super) fn puts_elsewhere(&mut self, agent: NodeId) -> bool {
        let (now, put) = (self.tick(), self.effect_of_put(agent));
        let Some((schedule, put)) = self.clock.running.get_mut(&agent).zip(put) else { return false };
        if schedule.chases >= CHASES || !schedule.action.aim.is_nothing() {
            return false;
        }
        schedule.tasks = VecDeque::from([Task::Effect(put)]);
        (schedule.motions, schedule.chases) = (VecDeque::new(), schedule.chases + 1);
        (schedule.phase, schedule.until) = (Phase::Back, now);
        true
    }

    /// Whether an agent has to go on after somebody who has walked on meanwhile.
    pub(super) fn goes_after(&mut self, agent: NodeId) -> Result<bool, ActionError> {
        let Some(schedule) = self.clock.running.get(&agent) else { return Ok(false) };
        let (action, chases) = (schedule.action, schedule.chases);
        let goes_to = |effect: Effect<NodeId>| match effect {
            Effect::GoTo(id) | Effect::Approach(id) => Some(id),
            _ => None,
        };
        let goal = rule::effects(self.graph.vocabulary(), &action).into_iter().find_map(goes_to);
        let is_somebody = |id: &NodeId| self.start.time.bodies && self.graph.agents().contains(id);
        let Some(goal) = goal.filter(is_somebody) else { return Ok(false) };
        self.clock.changed.push(agent);
        // A relation that cannot be told now is read at the end.
        drop(self.read_moved());
        if self.graph.near(agent, goal) && self.graph.room_of(agent) == self.graph.room_of(goal) {
            return Ok(false);
        }
        if chases >= CHASES {
            return Err(self.interrupted(&action, Interruption::WalksAway(self.graph.label(goal))));
        }
        if let Some(schedule) = self.clock.running.get_mut(&agent) {
            (schedule.tasks, schedule.chases) = (Task::of(self.graph.vocabulary(), &action), chases + 1);
        }
        Ok(true)
    }
}
