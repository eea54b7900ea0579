//! Answering for what is elsewhere than an action's rule has it: others may have moved it.

use vc_graph::{Action, NodeId, Relation, SceneGraph};
use vc_physics::BodyRole;

use super::Interruption;
use super::schedule::Schedule;
use super::track::Track;
use crate::environment::Environment;

/// How near to each other two things are that move together, metres.
const BESIDE: f32 = 0.02;

impl Environment {
    /// The nodes for which others answer that are doing something.
    pub(super) fn owned_by_others(&self, but: NodeId, before: &SceneGraph) -> Vec<NodeId> {
        let own: Vec<NodeId> = self.clock.running.get(&but).into_iter().flat_map(|s| s.action.things()).collect();
        self.others(but).flat_map(|(agent, schedule)| self.answers_for(agent, schedule, before, &own)).collect()
    }

    /// The nodes for which an agent answers to those who are about some things: itself and what it carries, now and
    /// before; what its action is about; what is in a thing that it opens or shuts, and goes with its parts, but for
    /// these things; doors that it passes, and those who make way for it.
    fn answers_for(&self, agent: NodeId, schedule: &Schedule, before: &SceneGraph, about: &[NodeId]) -> Vec<NodeId> {
        let mut all = self.graph.carried_with(agent);
        all.extend(before.carried_with(agent));
        all.push(agent);
        all.extend(schedule.action.things());
        let moved = self.opened_or_closed(&schedule.action);
        let inside = moved.into_iter().flat_map(|thing| before.relating(Relation::Inside, thing));
        all.extend(inside.filter(|id| !about.contains(id)));
        if let Track::Way(way) = &schedule.track {
            all.extend(way.doors.iter().map(|passage| passage.door));
            all.extend(way.aside.iter().flat_map(|step| self.graph.carried_with(step.agent)));
        }
        all
    }

    /// Takes an action that ends from those that go on. Its agent goes on answering to them for what it has moved.
    pub(super) fn hand_over(&mut self, agent: NodeId) -> Option<Schedule> {
        let schedule = self.clock.running.remove(&agent)?;
        for id in self.clock.running.keys().copied().collect::<Vec<NodeId>>() {
            let Some((other, truth)) = self.clock.running.get(&id).and_then(|s| Some((s.action, s.truth.as_ref()?)))
            else {
                continue;
            };
            let about: Vec<NodeId> = other.things().collect();
            let excused = self.answers_for(agent, &schedule, &truth.before, &about);
            let moved = self.moved_of(&other, &schedule.action).map(|thing| (thing, agent));
            if let Some(truth) = self.clock.running.get_mut(&id).and_then(|other| other.truth.as_mut()) {
                truth.excuse(&excused);
                truth.moved = moved.or(truth.moved);
            }
        }
        Some(schedule)
    }

    /// Nobody answers for what a hand under control touches, for a door that others keep from shutting, or for those who
    /// make way.
    pub(in crate::environment) fn excuse(&mut self, touched: &[NodeId]) {
        let truths = self.clock.running.values_mut().filter_map(|other| other.truth.as_mut());
        truths.for_each(|truth| truth.excuse(touched));
    }

    /// Something moves that no action answers for.
    pub(in crate::environment) fn set_adrift(&mut self, things: &[NodeId]) {
        self.clock.adrift.extend(things);
        self.excuse(things);
    }

    /// Whatever moves beside what is adrift is adrift from now on: it has been hit, or has lost its support. What is hit may have sprung
    /// away in the same tick, so contacts do not tell.
    pub(super) fn spread_adrift(&mut self) {
        if self.clock.adrift.is_empty() {
            return;
        }
        let world = &self.world;
        // The boxes of all that moves, with how far it goes in a tick.
        let reach = |id: NodeId| {
            let far = BESIDE + world.body(id).ok()?.velocity().norm() * world.settings().dt;
            Some((id, world.aabb(id)?.grown(far, far)))
        };
        let is_loose = |id: &NodeId| world.role(*id) == Some(BodyRole::Loose);
        let (mut left, mut others): (Vec<_>, Vec<_>) = (world.awake_things().into_iter().filter(is_loose))
            .filter_map(reach)
            .partition(|(id, _)| self.clock.adrift.contains(id));
        let mut met = Vec::new();
        while let Some((_, around)) = left.pop() {
            let (hit, rest): (Vec<_>, Vec<_>) = others.into_iter().partition(|(_, other)| other.meets(&around));
            met.extend(hit.iter().map(|(id, _)| *id));
            left.extend(hit);
            others = rest;
        }
        if !met.is_empty() {
            self.set_adrift(&met);
        }
    }

    /// Whether somebody else has opened or shut what an action is about, if only its things are astray.
    pub(super) fn undone_by_another(&self, agent: NodeId, action: &Action, astray: &[NodeId]) -> Option<Interruption> {
        let is_own = |id: &NodeId| action.things().any(|thing| self.graph.rests_at(*id, thing) || thing == *id);
        let ended = self.clock.running.get(&agent)?.truth.as_ref()?.moved;
        let moves = |(by, other): (NodeId, &Schedule)| Some((self.moved_of(action, &other.action)?, by));
        let (thing, by) = ended.or_else(|| self.others(agent).find_map(moves))?;
        let lost = astray.iter().map(|id| self.graph.label(*id)).collect();
        let (thing, by) = (self.graph.label(thing), self.graph.label(by));
        astray.iter().all(is_own).then_some(Interruption::Undone { thing, by, lost })
    }

    /// The thing of one action that another one opens or shuts.
    fn moved_of(&self, action: &Action, other: &Action) -> Option<NodeId> {
        self.opened_or_closed(other).into_iter().find(|moved| action.things().any(|thing| thing == *moved))
    }
}
