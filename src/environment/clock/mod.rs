//! Actions that take time, on one clock.
//!
//! An action is a [schedule](schedule) of motions with an event at the end of each. Feet, and doors that hands move,
//! are [functions of the tick](track) between two events. The world is touched in *live* ticks only: those in which an
//! action begins, an event is due, or a body is awake. Whether one steps by single ticks or by thousands, the same
//! live ticks are visited. [`act`] does actions to their end, [`conflict`] is about agents in each other's way,
//! [`passing`] about ways past others, [`apart`] about distances and [`aside`] about making way, [`rest`] about the end of an action, [`answers`] about who answers for
//! what, [`anew`] about other spots, [`show`] about the tick as it is seen, [`processes`] about machines and matter, [`save`] about the clock as text.

mod act;
mod anew;
mod answers;
mod apart;
mod aside;
mod conflict;
mod ending;
mod events;
mod passing;
mod processes;
mod rest;
mod save;
mod schedule;
mod show;
mod track;

use std::collections::{BTreeMap, BTreeSet};

use vc_graph::clock::{Running, Span, Tick};
use vc_graph::{Action, ChangeSet, Event, Label, NodeId, Pose, SceneGraph};
use vc_physics::{PhysicsWorld, RestProgress};

use super::control::Controls;
use super::{ActionError, Attempt, Environment, EnvironmentState};

pub use ending::{Ending, Interruption};
pub(super) use passing::DISTANCES;
pub(super) use processes::TimeSettings;
use schedule::Schedule;

/// Bytes of a process that goes on.
const PROCESS: usize = 64;

/// The schedules of all agents, and the changes that are not read yet.
#[derive(Clone, Default)]
pub(super) struct Clock {
    /// The steps that bodies had made by tick zero.
    zero: u64,
    /// Actions that begin in the next tick.
    given: BTreeMap<NodeId, Action>,
    running: BTreeMap<NodeId, Schedule>,
    /// How long bodies have been coming to rest, and whether an event has disturbed them in this tick.
    rest: RestProgress,
    pub(super) stirred: bool,
    /// Nodes that the rule has put elsewhere since relations were read last, and whether bodies have moved since then.
    pub(super) changed: Vec<NodeId>,
    pub(super) unseen: bool,
    /// Things that are held still at poses once bodies have been stepped in this tick.
    held: Vec<(NodeId, Pose)>,
    /// Things that were pushed, or came, or were let go by a hand under control, and what these have set moving: no action answers
    /// for them until they rest.
    adrift: BTreeSet<NodeId>,
    /// The scene as relations have read it, while the graph differs.
    read: Option<SceneGraph>,
    endings: Vec<Ending>,
    /// The changes of the graph since the last action that was done.
    journal: ChangeSet,
    /// The processes that go on; whether they are known but for some nodes, and these nodes.
    processes: Running,
    noticed: bool,
    touched: Vec<NodeId>,
    /// The agents under low-level control.
    pub(super) controls: Controls,
}

impl Clock {
    /// The clock of a world at tick zero, in which nobody does anything.
    pub(super) fn at(world: &PhysicsWorld) -> Self {
        Self { zero: world.ticks(), ..Self::default() }
    }

    /// Takes note of changes of the graph: other processes may go on.
    pub(super) fn note(&mut self, changes: ChangeSet) {
        self.touched.extend(changes.nodes());
        self.journal = std::mem::take(&mut self.journal).then(changes);
    }

    /// The changes of the graph since the last action, which are told now.
    pub(super) fn take_journal(&mut self) -> ChangeSet {
        std::mem::take(&mut self.journal)
    }

    /// Something has changed the scene, and relations have read it: other processes may go on.
    pub(super) fn scene_changed(&mut self) {
        (self.noticed, self.read) = (false, None);
    }

    /// The scene as relations have read it, of an environment whose scene is given.
    pub(super) fn as_read<'a>(&'a self, graph: &'a SceneGraph) -> &'a SceneGraph {
        self.read.as_ref().unwrap_or(graph)
    }

    /// The clock with other changes of the graph since the last action.
    pub(super) fn with_journal(&self, journal: ChangeSet) -> Self {
        Self { journal, ..self.without_journal() }
    }

    /// The clock without the changes of the graph since the last action, while nobody acts.
    pub(super) fn without_journal(&self) -> Self {
        let mut clock = Self { journal: ChangeSet::default(), ..self.clone() };
        clock.changed.shrink_to_fit();
        clock.touched.shrink_to_fit();
        clock
    }

    /// About how many bytes it takes beside itself and its journal while nobody acts.
    pub(super) fn bytes(&self) -> usize {
        let nodes = self.changed.len() + self.touched.len();
        nodes * size_of::<NodeId>() + self.processes.processes().count() * PROCESS
    }

    /// The graph is about to change otherwise than by what relations read; a saved home goes on from what they have read.
    pub(super) fn about_to_change(&mut self, graph: &SceneGraph) {
        self.read.get_or_insert_with(|| graph.clone());
    }
}

impl Environment {
    /// Gives an agent an action, which begins in the next tick of [`step`](Self::step). An action that it was given before,
    /// or is doing by then, is interrupted; the latter goes on if the rule refuses the new one.
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
        if let Some(before) = self.clock.given.insert(agent, action) {
            let error = self.interrupted(&before, Interruption::Replaced(Attempt::new(&action, &self.graph)));
            self.end(agent, before, Err(error));
        }
    }

    /// Lets a span of time pass: agents do what they were [given](Self::give), side by side, go on as they are
    /// [controlled](Self::control), and bodies move. Returns the
    /// actions that have ended, in the order of their ticks, then of their agents.
    ///
    /// The outcome does not depend on how the time is divided into steps, nor on the order in which actions were given.
    /// An action that fails or is interrupted leaves the world as it is in that tick; one that the rule refuses changes
    /// nothing that anybody does. (It is asked for in a tick of its own, in which feet are put where they are on their way,
    /// so that last digits of poses may differ from a home in which it was not given.)
    ///
    /// Costs what the live ticks cost, in which an action begins, an event is due or a body is awake; the others pass at
    /// once.
    pub fn step(&mut self, span: Span) -> Vec<Ending> {
        self.advance(self.tick() + span);
        self.take_endings()
    }

    /// The endings since the last call, by their ticks, then by their agents.
    pub(super) fn take_endings(&mut self) -> Vec<Ending> {
        let mut endings = std::mem::take(&mut self.clock.endings);
        endings.sort_by_key(|ending| (ending.tick, ending.agent));
        endings
    }

    /// Lets time pass until nobody does anything any more, at most a span; returns the actions that have ended.
    pub fn step_until_idle(&mut self, most: Span) -> Vec<Ending> {
        self.advance_while(self.tick() + most, Self::is_busy);
        self.take_endings()
    }

    /// Lets time pass until a tick, or until the last one that can be counted.
    fn advance(&mut self, end: Tick) {
        let end = end.min(self.last_tick());
        while self.tick() < end {
            match self.next_live().filter(|tick| *tick < end) {
                Some(tick) => {
                    self.pass_until(tick);
                    self.live();
                }
                None => self.pass_until(end),
            }
        }
    }

    /// Lets time pass in which nothing moves.
    fn pass_until(&mut self, tick: Tick) {
        let left = tick - self.tick();
        self.world.pass(left.0);
    }

    /// Lets a tick pass in which something moves.
    pub(super) fn pass_tick(&mut self) {
        self.clock.stirred = true;
        self.advance(self.tick() + Span(1));
    }

    /// Lets time pass while something is the case, at most until a tick.
    pub(super) fn advance_while(&mut self, end: Tick, holds: impl Fn(&Self) -> bool) {
        let end = end.min(self.last_tick());
        while holds(self) && self.tick() < end {
            let next = self.next_live().unwrap_or(end).max(self.tick());
            self.advance((next + Span(1)).min(end));
        }
    }

    /// Bodies count their steps from before tick zero on.
    fn last_tick(&self) -> Tick {
        Tick(u64::MAX - self.clock.zero)
    }

    /// The tick: the time that has passed since the environment was made, in sixtieths of a second.
    pub fn tick(&self) -> Tick {
        let now = self.world.asleep().map_or_else(|| self.world.ticks(), EnvironmentState::ticks);
        Tick(now - self.clock.zero)
    }

    /// The action that an agent is doing or is about to begin.
    pub fn current_action(&self, agent: NodeId) -> Option<&Action> {
        self.clock.given.get(&agent).or_else(|| self.clock.running.get(&agent).map(|schedule| &schedule.action))
    }

    /// The changes of the graph since the last action that was done: also those by [control](Self::control),
    /// [`steer`](Self::steer), [`spawn`](Self::spawn), [`put`](Self::put), [`teleport`](Self::teleport) and
    /// [`switch_lamps`](Self::switch_lamps), and by processes. The changes of the next action begin with these. A thing that
    /// was spawned has an asset of the library that [`graph`](Self::graph) has since then.
    pub fn changes(&self) -> &ChangeSet {
        &self.clock.journal
    }

    /// Ends what an agent is doing, where it is; the ending is among those of the next [`step`](Self::step). Ends its
    /// [control](Self::control), too.
    pub fn interrupt(&mut self, agent: NodeId) {
        self.clock.controls.new |= self.clock.controls.all.remove(&agent).is_some();
        self.cancel(agent);
    }

    /// Ends what an agent is doing or was given, where it is.
    fn cancel(&mut self, agent: NodeId) {
        if let Some(given) = self.clock.given.remove(&agent) {
            let error = self.interrupted(&given, Interruption::Cancelled);
            self.end(agent, given, Err(error));
        }
        self.interrupt_for(agent, Interruption::Cancelled);
    }

    /// The agents that are doing something or are about to, and those under control.
    pub(super) fn busy(&self) -> Vec<Label> {
        let is_free = |agent: &NodeId| self.current_action(*agent).is_none() && self.controlled(*agent).is_none();
        let busy = self.agents().iter().filter(|agent| !is_free(agent));
        busy.map(|agent| self.graph.label(*agent)).collect()
    }

    /// As [`busy`](Self::busy), after hands whose control has ended have come back: they do not wait for the next tick.
    pub(super) fn busy_now(&mut self) -> Vec<Label> {
        if self.clock.controls.all.is_empty() {
            self.apply_controls();
        }
        self.busy()
    }

    /// The number of endings that no step has returned yet.
    pub(crate) fn unread_endings(&self) -> usize {
        self.clock.endings.len()
    }

    /// Whether any agent is doing something or is about to.
    pub fn is_busy(&self) -> bool {
        !self.clock.given.is_empty() || !self.clock.running.is_empty()
    }

    /// The next tick in which the world is touched, if there is one.
    pub(crate) fn next_live(&mut self) -> Option<Tick> {
        let now = self.tick();
        if self.clock.stirred || self.clock.controls.new || !self.clock.given.is_empty() || !self.world.pass(0) {
            return Some(now);
        }
        let process = self.next_process();
        let event = self.clock.running.values().map(|schedule| schedule.until).min();
        let event = event.filter(|tick| *tick != schedule::NEVER).map(|tick| tick.max(now));
        event.into_iter().chain(process).min()
    }

    /// A live tick: events that are due, beginnings, a step of bodies, ends.
    fn live(&mut self) {
        let (now, before) = (self.tick(), self.graph.clone());
        self.end_processes();
        self.apply_controls();
        let due: Vec<NodeId> = self.clock.running.iter().filter(|(_, s)| s.until <= now).map(|(a, _)| *a).collect();
        let given = std::mem::take(&mut self.clock.given);
        if !due.is_empty() || !given.is_empty() {
            self.put_feet(&due);
            self.put_passed_doors();
            self.put_aside();
        }
        due.into_iter().for_each(|agent| self.fire(agent));
        if !given.is_empty() {
            self.read_if_still();
        }
        given.into_iter().for_each(|(agent, action)| self.begin_action(agent, action));
        self.heed_effects(&before);
        self.heed_standers();
        self.step_bodies();
        self.follow_controls();
        self.spread_adrift();
        self.end_what_rests();
        if self.clock.running.values().all(|schedule| schedule.until != schedule::NEVER) {
            // Nobody is about to read it.
            self.read_if_still();
        }
    }

    fn step_bodies(&mut self) {
        let held = std::mem::take(&mut self.clock.held);
        if !held.is_empty() {
            self.world.step();
            self.clock.unseen = true;
            // Whatever else moves is still, too, but not in flight.
            let flying: Vec<NodeId> = self.clock.adrift.iter().copied().collect();
            // They are there.
            let _ = self.world.hold_still(&held, &flying);
            (self.clock.rest, self.clock.stirred) = (RestProgress::default(), true);
        } else if self.clock.stirred {
            // A thing that has lost its support wakes in this step.
            self.world.step();
            (self.clock.rest, self.clock.stirred, self.clock.unseen) = (RestProgress::default(), false, true);
        } else if !self.world.pass(1) {
            self.clock.unseen = true;
            if !self.clock.controls.all.is_empty() {
                // A hand does not come to rest: it is told to.
                self.clock.rest = RestProgress::default();
                self.world.step();
            } else if !self.world.step_awake(&mut self.clock.rest) {
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

    fn end(&mut self, agent: NodeId, action: Action, outcome: Result<(), ActionError>) {
        let outcome = outcome.map(|()| {
            self.past.push(Event { agent, action });
            self.clock.take_journal()
        });
        self.clock.endings.push(Ending { tick: self.tick(), agent, action, outcome });
        // Where it has come to is read later, and is nobody else's.
        self.excuse(&self.graph.carried_with(agent));
    }
}
