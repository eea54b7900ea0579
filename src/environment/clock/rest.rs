//! The ends of actions: what they moved rests, is read, and is compared with the rule.

use vc_graph::{ChangeSet, NodeId};

use super::schedule::{NEVER, Phase};
use super::track::Track;
use crate::environment::act::{holder, keep_facing, lay_through, unsteady};
use crate::environment::compare::{Difference, Outcome};
use crate::environment::execute::off_aim;
use crate::environment::{ActionError, Disagreement, Environment, PhysicalRefusal, astray, observe};

impl Environment {
    /// Finds out which actions need not wait for bodies any longer.
    pub(super) fn end_what_rests(&mut self) {
        let now = self.tick();
        let waiting: Vec<NodeId> =
            self.clock.running.iter().filter(|(_, s)| s.until == NEVER).map(|(a, _)| *a).collect();
        for agent in waiting {
            let involved = self.involved(agent);
            let rests = !self.clock.stirred && self.world.rests(&involved);
            let Some(schedule) = self.clock.running.get_mut(&agent) else { continue };
            let over = match &mut schedule.phase {
                Phase::Pushes(left) => {
                    *left = left.saturating_sub(1);
                    let driven = schedule.action.things().any(|id| self.world.parts(id).is_driven());
                    *left == 0 || !driven
                }
                _ => rests,
            };
            if over {
                schedule.until = now;
            }
        }
    }

    /// Reads what has moved into the graph; returns what may have changed.
    pub(super) fn read_moved(&mut self) -> Result<ChangeSet, PhysicalRefusal> {
        let changed = std::mem::take(&mut self.clock.changed);
        if changed.is_empty() && !std::mem::take(&mut self.clock.unseen) {
            return Ok(ChangeSet::default());
        }
        let (graph, relations) = (&mut self.graph, &mut self.relations);
        let (met, seen) = observe::look_again(graph, &self.start, &self.world, relations, &changed)?;
        self.clock.changed_by(&seen);
        for truth in self.clock.running.values_mut().filter_map(|schedule| schedule.truth.as_mut()) {
            truth.met.extend(&met);
        }
        Ok(seen)
    }

    /// Ends an action, or puts back bystanders that it has disturbed.
    pub(super) fn finish_in_time(&mut self, agent: NodeId) {
        match self.outcome(agent) {
            Ok(None) => {}
            Ok(Some(changes)) => {
                if let Some(schedule) = self.clock.running.remove(&agent) {
                    self.end(agent, schedule.action, Ok(changes));
                }
            }
            Err(error) => self.stop(agent, error),
        }
    }

    fn outcome(&mut self, agent: NodeId) -> Result<Option<ChangeSet>, ActionError> {
        let seen = self.read_moved().map_err(|why| self.cannot(agent, why))?;
        if let Some(id) = astray::fell_out(&self.world, &seen) {
            return Err(self.cannot(agent, PhysicalRefusal::FallsOut(self.graph.label(id))));
        }
        let Some(schedule) = self.clock.running.get(&agent) else { return Ok(None) };
        let Some(truth) = schedule.truth.clone() else { return Ok(None) };
        if let Some(why) = off_aim(&self.world, &self.graph, agent, &schedule.action) {
            return Err(self.cannot(agent, why));
        }
        let changed: Vec<NodeId> = truth.changes.changes().iter().filter_map(holder).chain([agent]).collect();
        let graph = &mut self.graph;
        let faced = keep_facing(graph, &truth.ruled, agent).then(lay_through(graph, &truth.ruled, &changed));
        let (before, ruled, observed) = (&truth.before, &truth.ruled, &self.graph);
        let outcome = Outcome { before, ruled, observed, world: &self.world };
        let mut differences = outcome.differences(agent, &schedule.action, &truth.changes, &truth.met);
        // What another action has in hand is for that one to answer for.
        let others = self.owned_by_others(agent);
        differences.retain(|d| !others.contains(&d.thing.id));
        if differences.is_empty() {
            return Ok(Some(truth.changes.then(seen).then(faced)));
        }
        if self.puts_back(agent, &differences) {
            return Ok(None);
        }
        let Some(schedule) = self.clock.running.get(&agent) else { return Ok(None) };
        let error = Disagreement { action: schedule.action.describe(&self.graph).to_string(), differences };
        Err(unsteady(error.into(), schedule.balanced))
    }

    /// Puts back bystanders that an action has disturbed, and holds them still: the scene before knows where they were.
    /// Once for each action; returns whether there were any.
    fn puts_back(&mut self, agent: NodeId, differences: &[Difference]) -> bool {
        let Some(schedule) = self.clock.running.get_mut(&agent) else { return false };
        let (action, Some(truth)) = (schedule.action, schedule.truth.as_mut()) else { return false };
        if std::mem::replace(&mut truth.steadied, true) {
            return false;
        }
        let before = truth.before.clone();
        if !differences.iter().all(|d| self.is_bystander(d.thing.id, agent, &action)) {
            return false;
        }
        for id in differences.iter().map(|d| d.thing.id) {
            let was = before.node(id).and_then(|node| node.pose().copied());
            // It is loose and was there.
            let _ = was.map(|was| self.world.place(id, was).and_then(|()| self.world.pin(id, None)));
            self.clock.changed.push(id);
        }
        self.clock.stirred = true;
        if let Some(schedule) = self.clock.running.get_mut(&agent) {
            (schedule.phase, schedule.until) = (Phase::Ends, NEVER);
        }
        true
    }

    /// The agents that are doing something else, what they carry, and what their actions are about.
    fn owned_by_others(&self, but: NodeId) -> Vec<NodeId> {
        let mut all = Vec::new();
        for (&agent, schedule) in self.clock.running.iter().filter(|(agent, _)| **agent != but) {
            all.extend(self.graph.carried_with(agent));
            all.push(agent);
            all.extend(schedule.action.things());
            if let Track::Way(way) = &schedule.track {
                all.extend(way.doors.iter().map(|passage| passage.door));
            }
        }
        all
    }
}
