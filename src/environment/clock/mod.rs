//! Actions that take time, on one clock.
//!
//! An action is a [schedule](schedule) of motions with an event at the end of each. Feet, and doors that hands move,
//! are [functions of the tick](track) between two events. The world is touched in *live* ticks only: those in which an
//! action begins, an event is due, or a body is awake. Whether one steps by single ticks or by thousands, the same
//! live ticks are visited. [`conflict`] is about agents in each other's way, [`rest`] about the end of an action,
//! [`moment`] about the tick as it is seen, [`processes`] about machines and matter.

mod conflict;
mod ending;
mod events;
mod moment;
mod processes;
mod rest;
mod schedule;
mod track;

use std::collections::{BTreeMap, BTreeSet};

use vc_graph::clock::{Running, Span, Tick};
use vc_graph::{Action, ChangeSet, Event, Label, NodeId};
use vc_physics::{Hand, PhysicsWorld, RestProgress};

use super::{ActionError, Environment};

pub use ending::{Ending, Interruption};
pub(super) use processes::TimeSettings;
use schedule::Schedule;
pub(super) use track::along;

/// The schedules of all agents, and the changes that are not read yet.
#[derive(Clone, Default)]
pub(super) struct Clock {
    /// Actions that begin in the next tick.
    given: BTreeMap<NodeId, Action>,
    running: BTreeMap<NodeId, Schedule>,
    /// How long bodies have been coming to rest, and whether an event has disturbed them in this tick.
    calm: RestProgress,
    stirred: bool,
    /// Nodes that the rule has put elsewhere since relations were read last, and whether bodies have moved since then.
    changed: Vec<NodeId>,
    unseen: bool,
    endings: Vec<Ending>,
    /// The processes that go on; whether they are known but for some nodes, and these nodes.
    processes: Running,
    noticed: bool,
    touched: Vec<NodeId>,
}

impl Clock {
    /// Nobody does anything in a world.
    pub(super) fn at(world: &PhysicsWorld) -> Self {
        Self { processes: Running::new(Tick(world.ticks())), ..Self::default() }
    }

    /// Something has changed the scene: other processes may go on.
    pub(super) fn scene_changed(&mut self) {
        self.noticed = false;
    }

    /// As [`scene_changed`](Self::scene_changed), by these changes.
    pub(super) fn changed_by(&mut self, changes: &ChangeSet) {
        self.touched.extend(changes.nodes());
    }
}

impl Environment {
    /// Gives an agent an action, which begins in the next tick of [`step`](Self::step). An action that it is doing by
    /// then is interrupted.
    ///
    /// Whether the rule allows the action is asked in that tick; the answer is an [`Ending`].
    ///
    /// ```
    /// use virtualcity::Environment;
    /// use virtualcity::graph::clock::Span;
    /// let mut home = Environment::make("apartment/42", 2)?;
    /// let (me, you) = (home.agents()[0], home.agents()[1]);
    /// let fridge = home.graph().of_class("fridge")[0];
    /// home.give(me, format!("walk fridge.{}", fridge.0).parse()?);
    /// home.give(you, "wave".parse()?);
    /// let endings = home.step(Span::from_seconds(60.0));
    /// // Waving is over before the walk.
    /// assert_eq!(endings.iter().map(|e| e.agent).collect::<Vec<_>>(), [you, me]);
    /// assert!(endings.iter().all(|e| e.outcome.is_ok()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn give(&mut self, agent: NodeId, action: Action) {
        self.clock.given.insert(agent, action);
    }

    /// Lets a span of time pass: agents do what they were [given](Self::give), side by side, and bodies move. Returns the
    /// actions that have ended, in the order of their ticks, then of their agents.
    ///
    /// The outcome does not depend on how the time is divided into steps, nor on the order in which actions were given.
    /// An action that fails or is interrupted leaves the world as it is in that tick; one that the rule refuses changes
    /// nothing.
    ///
    /// Costs what the live ticks cost, in which an action begins, an event is due or a body is awake; the others pass at
    /// once.
    pub fn step(&mut self, span: Span) -> Vec<Ending> {
        let end = self.tick() + span;
        while self.tick() < end {
            match self.next_live().filter(|tick| *tick < end) {
                Some(tick) => {
                    self.world.pass((tick - self.tick()).0);
                    self.live();
                }
                None => {
                    self.world.pass((end - self.tick()).0);
                }
            }
        }
        std::mem::take(&mut self.clock.endings)
    }

    /// Lets time pass until nobody does anything any more, at most a span; returns the actions that have ended.
    pub fn step_until_idle(&mut self, most: Span) -> Vec<Ending> {
        let (end, mut endings) = (self.tick() + most, Vec::new());
        while self.is_busy() && self.tick() < end {
            let next = self.next_live().unwrap_or(end).max(self.tick());
            endings.extend(self.step((next + Span(1)).min(end) - self.tick()));
        }
        endings
    }

    /// The tick: the time that has passed since the environment was made, in sixtieths of a second.
    pub fn tick(&self) -> Tick {
        Tick(self.world.ticks())
    }

    /// The action that an agent is doing or is about to begin.
    pub fn current_action(&self, agent: NodeId) -> Option<&Action> {
        self.clock.given.get(&agent).or_else(|| self.clock.running.get(&agent).map(|schedule| &schedule.action))
    }

    /// Ends what an agent is doing, where it is; the ending is among those of the next [`step`](Self::step).
    pub fn interrupt(&mut self, agent: NodeId) {
        self.clock.given.remove(&agent);
        if self.clock.running.contains_key(&agent) {
            self.interrupt_for(agent, Interruption::Cancelled);
        }
    }

    /// The agents that are doing something.
    pub(super) fn busy(&self) -> Vec<Label> {
        let all: BTreeSet<NodeId> = self.clock.given.keys().chain(self.clock.running.keys()).copied().collect();
        all.into_iter().map(|agent| self.graph.label(agent)).collect()
    }

    /// Whether any agent is doing something or is about to.
    pub fn is_busy(&self) -> bool {
        !self.clock.given.is_empty() || !self.clock.running.is_empty()
    }

    /// The next tick in which the world is touched, if there is one.
    fn next_live(&mut self) -> Option<Tick> {
        let now = self.tick();
        if self.clock.stirred || !self.clock.given.is_empty() || !self.world.pass(0) {
            return Some(now);
        }
        let process = self.next_process();
        let event = self.clock.running.values().map(|schedule| schedule.until).min();
        let event = event.filter(|tick| *tick != schedule::NEVER).map(|tick| tick.max(now));
        event.into_iter().chain(process).min()
    }

    /// A live tick: events that are due, beginnings, a step of bodies, ends.
    fn live(&mut self) {
        let now = self.tick();
        self.end_processes();
        let due: Vec<NodeId> = self.clock.running.iter().filter(|(_, s)| s.until <= now).map(|(a, _)| *a).collect();
        let given = std::mem::take(&mut self.clock.given);
        if !due.is_empty() || !given.is_empty() {
            self.put_feet(&due);
        }
        due.into_iter().for_each(|agent| self.fire(agent));
        if !given.is_empty() && self.clock.unseen && !self.clock.stirred && self.world.pass(0) {
            drop(self.read_moved());
        }
        given.into_iter().for_each(|(agent, action)| self.begin_action(agent, action));
        self.step_bodies();
        self.end_what_rests();
    }

    fn step_bodies(&mut self) {
        if self.clock.stirred {
            // A thing that has lost its support wakes in this step.
            self.world.step();
            (self.clock.calm, self.clock.stirred, self.clock.unseen) = (RestProgress::default(), false, true);
        } else if !self.world.pass(1) {
            self.clock.unseen = true;
            if !self.world.step_awake(&mut self.clock.calm) {
                self.world.step();
            }
        }
    }

    /// Brings the bodies of those who are on their way to where they are in this tick.
    fn put_feet(&mut self, but: &[NodeId]) {
        let now = self.tick();
        for (agent, schedule) in self.clock.running.iter().filter(|(agent, _)| !but.contains(agent)) {
            if let Some(feet) = schedule.track.feet(now) {
                // It stood there before.
                let _ = self.world.teleport(*agent, feet);
            }
        }
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

    fn end(&mut self, agent: NodeId, action: Action, outcome: Result<ChangeSet, ActionError>) {
        if outcome.is_ok() {
            self.history.push(Event { agent, action });
        }
        // What came before cannot be replayed by single actions.
        self.undo = super::undo::Undo::default();
        self.clock.endings.push(Ending { tick: self.tick(), agent, action, outcome });
    }
}
