//! The ends of actions: what they moved rests, is read, and is compared with the rule.

use nalgebra::Point2;
use vc_graph::{Action, ChangeSet, Effect, NodeId, Place, Pose, Relation, SceneGraph, State, rule};
use vc_physics::{BodyRole, Hand};

use super::passing::spot;
use super::schedule::{NEVER, Phase};
use super::track::{Track, is_between_rooms};
use crate::environment::compare::{Outcome, unsteady};
use crate::environment::execute::off_aim;
use crate::environment::motion::BodyMotion;
use crate::environment::observe::{self, faced_by, holder, keep_facing, lay_through, moved_by_rule};
use crate::environment::{ActionError, Attempt, Disagreement, Environment, PhysicalRefusal, astray};

/// A door pushes nobody nearer than that to somebody else, metres.
const PRESSED: f32 = 0.45;

impl Environment {
    /// Finds out which actions need not wait for bodies any longer.
    pub(super) fn end_what_rests(&mut self) {
        let now = self.tick();
        let waiting: Vec<NodeId> =
            self.clock.running.iter().filter(|(_, s)| s.until == NEVER).map(|(a, _)| *a).collect();
        for agent in waiting {
            let involved = self.involved(agent);
            let rests = !self.clock.stirred && self.world.rests(&involved);
            let pressed = self.presses_somebody(agent);
            pressed.into_iter().for_each(|thing| self.halt(thing));
            let Some(schedule) = self.clock.running.get_mut(&agent) else { continue };
            let over = match &mut schedule.phase {
                Phase::Pushes(left, _) => {
                    *left = left.saturating_sub(1);
                    let driven = schedule.action.things().any(|id| self.world.parts(id).is_driven());
                    *left == 0 || !driven || pressed.is_some()
                }
                _ => rests,
            };
            if over {
                schedule.until = now;
            }
        }
    }

    /// The thing that an agent's push moves, if that has pushed somebody up to somebody else.
    fn presses_somebody(&self, agent: NodeId) -> Option<NodeId> {
        let thing = self.clock.running.get(&agent)?.pushing()?.id;
        let walkers = self.walkers(agent);
        let stand = self.agents().iter().filter(|id| !walkers.contains(id));
        let feet: Vec<Point2<f32>> = stand.filter_map(|id| Some(spot(&self.world.pose(*id)?))).collect();
        let near = |(i, one): (usize, &Point2<f32>)| feet[i + 1..].iter().any(|other| (one - other).norm() < PRESSED);
        feet.iter().enumerate().any(near).then_some(thing)
    }

    /// Things in an agent's hands, and what its action is about.
    fn involved(&self, agent: NodeId) -> Vec<NodeId> {
        let held = Hand::BOTH.into_iter().filter_map(|hand| self.world.held(agent, hand));
        let about = self.clock.running.get(&agent).into_iter().flat_map(|schedule| schedule.action.things());
        let mut all: Vec<NodeId> = held.chain(about).chain([agent]).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// Reads what has moved into the graph; tells of a thing that has fallen out of the home.
    pub(in crate::environment) fn read_moved(&mut self) -> Result<Option<NodeId>, PhysicalRefusal> {
        let changed = std::mem::take(&mut self.clock.changed);
        if !self.start.time.bodies || (changed.is_empty() && !std::mem::take(&mut self.clock.unseen)) {
            return Ok(None);
        }
        let (graph, world, relations) = (&mut self.graph, &mut self.world, &mut self.relations);
        let read = observe::look_again(graph, &self.start, world, relations, &changed);
        if read.is_err() {
            (self.clock.changed, self.clock.unseen) = (changed, true);
        }
        let (met, seen) = read?;
        self.clock.read = None;
        let fallen = astray::fell_out(&self.world, &seen, &self.clock.adrift);
        self.clock.note(seen);
        let world = &self.world;
        self.clock.adrift.retain(|thing| !world.rests(&[*thing]));
        self.read_doors(&met);
        for truth in self.clock.running.values_mut().filter_map(|schedule| schedule.truth.as_mut()) {
            truth.met.extend(&met);
        }
        Ok(fallen)
    }

    /// Reads whether things are open that nobody is about to open or close: a lid may have been left half open, or
    /// knocked open.
    fn read_doors(&mut self, met: &[NodeId]) {
        let mut about: Vec<NodeId> = Vec::new();
        for schedule in self.clock.running.values() {
            about.extend(self.opened_or_closed(&schedule.action));
            // A door that a walker passes is as it was when the walker has passed.
            if let Track::Way(way) = &schedule.track {
                about.extend(way.doors.iter().map(|passage| passage.door));
            }
        }
        let doors: Vec<NodeId> = met.iter().copied().filter(|id| !about.contains(id)).collect();
        let written = self.write_open(&doors);
        // A hand under control may have let it go, so that it goes on by itself; a door between rooms is as somebody has
        // left it who has passed.
        let guided = !self.clock.controls.all.is_empty();
        let others = written.nodes().filter(|id| guided || is_between_rooms(&self.graph, *id));
        self.excuse(&others.collect::<Vec<NodeId>>());
    }

    /// Writes whether things are open as their parts are, where the graph says otherwise.
    pub(in crate::environment) fn write_open(&mut self, things: &[NodeId]) -> ChangeSet {
        let differs = |id: &NodeId| {
            let (now, node) = (self.world.parts(*id).state()?, self.graph.node(*id)?);
            let is_door = node.is(State::Open) || node.is(State::Closed);
            (is_door && !node.is(now)).then_some((*id, now))
        };
        let doors: Vec<(NodeId, State)> = things.iter().filter_map(differs).collect();
        let mut edit = self.graph.edit();
        // They are there and have the other state.
        doors.iter().for_each(|(id, state)| drop(edit.enter_state(*id, *state)));
        let changes = edit.commit();
        self.clock.note(changes.clone());
        changes
    }

    /// Reads what has moved, unless something moves still.
    pub(super) fn read_if_still(&mut self) {
        if self.clock.unseen && !self.clock.stirred && self.world.pass(0) {
            // If it cannot be told now, it is read at the end of an action.
            drop(self.read_moved());
        }
    }

    /// Ends an action, or puts back what it has disturbed.
    pub(super) fn finish_in_time(&mut self, agent: NodeId) {
        match self.outcome(agent) {
            Ok(false) => {}
            Ok(true) => {
                if let Some(schedule) = self.hand_over(agent) {
                    self.end(agent, schedule.action, Ok(()));
                }
            }
            Err(error) => self.stop(agent, error),
        }
    }

    /// Writes what bodies hold and how they sit where an action may have said otherwise: one by an own verb, of whose
    /// effects bodies may have done the first only, or one before which they got up.
    pub(super) fn heed_bodies(&mut self, agent: NodeId, action: &Action) {
        let sits = |effect: &Effect<NodeId>| matches!(effect, Effect::SitOn(_) | Effect::LieOn(_));
        let doubtful = |words| !action.verb.is_builtin() || rule::effects(words, action).iter().any(sits);
        if self.start.time.bodies && doubtful(self.graph.vocabulary()) {
            let before = self.graph.clone();
            let changes = observe::write_holding_and_posture(&mut self.graph, &self.world, agent);
            if changes.is_empty() {
                return;
            }
            self.clock.about_to_change(&before);
            self.clock.changed.extend(changes.changes().iter().filter_map(moved_by_rule));
            self.clock.note(changes);
        }
    }

    /// Whether an action is over; if not, something is being put back.
    fn outcome(&mut self, agent: NodeId) -> Result<bool, ActionError> {
        if let Some(action) = self.clock.running.get(&agent).map(|schedule| schedule.action) {
            self.heed_bodies(agent, &action);
        }
        if let Some(id) = self.read_moved().map_err(|why| self.cannot(agent, why))? {
            let error = self.cannot(agent, PhysicalRefusal::FallsOut(self.graph.label(id)));
            return if self.puts_back(agent, &[id]) { Ok(false) } else { Err(error) };
        }
        let Some(schedule) = self.clock.running.get(&agent) else { return Ok(false) };
        let (action, Some(truth)) = (schedule.action, schedule.truth.clone()) else { return Ok(false) };
        if !self.start.time.bodies {
            return Ok(true);
        }
        if let Some(why) = off_aim(&self.world, &self.graph, agent, &action) {
            return Err(self.cannot(agent, why));
        }
        let changed: Vec<NodeId> = truth.changes.changes().iter().filter_map(holder).chain([agent]).collect();
        let graph = &mut self.graph;
        let faced = keep_facing(graph, faced_by(&truth.ruled, agent)).then(lay_through(graph, &truth.ruled, &changed));
        self.clock.note(faced);
        let (before, ruled, observed) = (&truth.before, &truth.ruled, &self.graph);
        let outcome = Outcome { before, ruled, observed, world: &self.world };
        let mut differences = outcome.differences(agent, &action, &truth.changes, &truth.met);
        // Another action answers for the things that it has in hand.
        let others = self.owned_by_others(agent, &truth.before);
        differences.retain(|d| !others.contains(&d.thing.id) && !truth.excused.contains(&d.thing.id));
        let astray: Vec<NodeId> = differences.iter().map(|d| d.thing.id).collect();
        if astray.is_empty() {
            return Ok(true);
        }
        if self.turns_back(agent, &astray) || self.puts_back(agent, &astray) {
            return Ok(false);
        }
        if let Some(undone) = self.undone_by_another(agent, &action, &astray) {
            return Err(self.interrupted(&action, undone));
        }
        let balanced = self.clock.running.get(&agent).and_then(|schedule| schedule.balanced);
        if let Some(id) = balanced.filter(|id| self.world.role(*id) == Some(BodyRole::Loose)) {
            // It is not held any longer where nothing carries it.
            let _ = self.world.wake(id);
            self.clock.stirred = true;
        }
        let error = Disagreement { attempt: Attempt::new(&action, &self.graph), differences };
        Err(unsteady(error.into(), balanced))
    }

    /// The action of an agent and the scene before its effects, the first time that something is put back for it.
    fn before_putting_back(&mut self, agent: NodeId) -> Option<(Action, SceneGraph)> {
        let schedule = self.clock.running.get_mut(&agent)?;
        let truth = schedule.truth.as_mut()?;
        let first = !std::mem::replace(&mut truth.put_back, true);
        first.then(|| (schedule.action, truth.before.clone()))
    }

    /// Turns an agent back that has turned to a thing at the edge of its reach, which is out of reach now; returns
    /// whether it does.
    fn turns_back(&mut self, agent: NodeId, astray: &[NodeId]) -> bool {
        let is_here = |was: &Pose| self.world.pose(agent).is_some_and(|now| now.translation == was.translation);
        let was = self.clock.running.get(&agent).and_then(|s| s.truth.as_ref()?.before.node(agent)?.pose().copied());
        let Some(was) = was.filter(is_here).filter(|_| astray.iter().all(|id| *id == agent)) else { return false };
        if self.before_putting_back(agent).is_none() {
            return false;
        }
        let now = self.tick();
        if let Some(schedule) = self.clock.running.get_mut(&agent) {
            schedule.motions.push_back(BodyMotion::Turn(was));
            (schedule.phase, schedule.until) = (Phase::Back, now);
        }
        self.go_on(agent);
        true
    }

    /// Puts back bystanders that an action has disturbed, and holds them still: the scene before knows where they were.
    /// Once for each action; returns whether there were any.
    fn puts_back(&mut self, agent: NodeId, astray: &[NodeId]) -> bool {
        let Some((action, before)) = self.before_putting_back(agent) else { return false };
        if !astray.iter().all(|id| self.is_bystander(*id, agent, &action, &before)) {
            return false;
        }
        for &id in astray {
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

    /// Whether a thing is loose and no part of what an action is about: neither one of its things nor on or in one, nor
    /// with the agent. A thing on one that is only opened or closed has no part in that; one within goes with its parts.
    fn is_bystander(&self, id: NodeId, agent: NodeId, action: &Action, before: &SceneGraph) -> bool {
        let moved = self.opened_or_closed(action);
        let carried = |about: NodeId| (moved.is_empty() || about == agent) && self.graph.rests_at(id, about);
        let of_it = |about: NodeId| id == about || carried(about) || self.graph.rests_at(about, id);
        let is_within = moved.iter().any(|thing| is_within(before, id, *thing));
        self.world.role(id) == Some(BodyRole::Loose) && !is_within && !action.things().chain([agent]).any(of_it)
    }

    /// The things that an action opens or closes.
    pub(super) fn opened_or_closed(&self, action: &Action) -> Vec<NodeId> {
        let thing = |effect| match effect {
            Effect::Enter(id, State::Open | State::Closed) => Some(id),
            _ => None,
        };
        rule::effects(self.graph.vocabulary(), action).into_iter().filter_map(thing).collect()
    }
}

/// Whether a thing is inside another, or on or in what is.
fn is_within(graph: &SceneGraph, id: NodeId, around: NodeId) -> bool {
    let within = |place: Place| match place.at == around {
        true => place.relation == Relation::Inside,
        false => is_within(graph, place.at, around),
    };
    graph.places(id).any(within)
}
