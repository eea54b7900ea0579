//! Traces: the states and events on which a goal is evaluated.

use super::Situation;
use crate::{Event, NodeId, SceneGraph, Vocabulary};

/// The record of an episode: the initial state, and for each step its actions and the state after it. The
/// scenes share everything that did not change between them, so a long trace is small.
///
/// ```
/// use vc_graph::goal::{Goal, EpisodeTrace};
/// use vc_graph::{Draft, Event, SceneBuilder, Simulator};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// scene.add_in(kitchen, Draft::new("fridge"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let mut world = Simulator::new(scene.build());
/// let mut trace = EpisodeTrace::new(world.graph().clone(), me);
/// for line in ["walk fridge.2", "open fridge.2", "close fridge.2"] {
///     let action = line.parse()?;
///     world.step(me, &action).map_err(|refusals| refusals[0].clone())?;
///     trace.push(world.graph().clone(), [Event { agent: me, action }]);
/// }
/// let holds = |text: &str| text.parse::<Goal>().map(|goal| goal.holds_on(&trace));
/// assert!(!holds("Open(fridge)")?); // at the end it is closed
/// assert!(holds("eventually Open(fridge)")?);
/// assert!(holds("Closed(fridge) until did open(fridge)")?);
/// assert!(holds("always (did open(fridge) => within 1 steps Closed(fridge))")?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct EpisodeTrace {
    agent: NodeId,
    graphs: Vec<SceneGraph>,
    events: Vec<Event>,
    /// For each step the number of events up to its end.
    ends: Vec<usize>,
}

impl EpisodeTrace {
    /// A trace without steps.
    pub fn new(graph: SceneGraph, agent: NodeId) -> Self {
        Self { agent, graphs: vec![graph], events: Vec::new(), ends: vec![0] }
    }

    /// Appends a step: its actions and the state after it.
    pub fn push(&mut self, graph: SceneGraph, events: impl IntoIterator<Item = Event>) {
        self.graphs.push(graph);
        self.events.extend(events);
        self.ends.push(self.events.len());
    }

    /// Takes back all steps after the first `steps`.
    ///
    /// ```
    /// use vc_graph::goal::EpisodeTrace;
    /// use vc_graph::{Action, Draft, Event, NodeId, SceneBuilder, Verb};
    /// let mut scene = SceneBuilder::new("flat");
    /// let me = scene.add(Draft::new("character"))?;
    /// let mut trace = EpisodeTrace::new(scene.graph().clone(), me);
    /// trace.push(scene.graph().clone(), [Event { agent: me, action: Action::zero(Verb::Wave) }]);
    /// trace.truncate(0);
    /// assert_eq!((trace.steps(), trace.events(1)), (0, &[][..]));
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    pub fn truncate(&mut self, steps: usize) {
        self.graphs.truncate(steps + 1);
        self.ends.truncate(steps + 1);
        self.events.truncate(self.ends.last().copied().unwrap_or(0));
    }

    /// The agent that `me` refers to.
    pub fn agent(&self) -> NodeId {
        self.agent
    }

    /// Number of steps.
    pub fn steps(&self) -> usize {
        self.graphs.len() - 1
    }

    /// The state after a step; step 0 is the initial state.
    pub fn graph(&self, step: usize) -> Option<&SceneGraph> {
        self.graphs.get(step)
    }

    /// The actions of a step; empty for step 0.
    pub fn events(&self, step: usize) -> &[Event] {
        let after = |step: usize| self.ends.get(step).copied();
        let before = step.checked_sub(1).and_then(after).unwrap_or(0);
        after(step).map_or(&[], |end| &self.events[before..end])
    }

    /// The situation after a step: its state and all actions up to it.
    pub fn situation(&self, step: usize) -> Option<Situation<'_>> {
        let graph = self.graph(step)?;
        Some(Situation { graph, agent: self.agent, events: &self.events[..*self.ends.get(step)?] })
    }

    pub(super) fn course(&self) -> Course<'_> {
        Course { agent: self.agent, graphs: &self.graphs, events: &self.events, ends: Some(&self.ends) }
    }
}

/// A trace, or a situation viewed as one.
#[derive(Clone, Copy)]
pub(super) struct Course<'a> {
    agent: NodeId,
    /// One state for each step, or one for all steps.
    graphs: &'a [SceneGraph],
    events: &'a [Event],
    /// For each step the number of events up to its end; `None` if each step has one event.
    ends: Option<&'a [usize]>,
}

impl<'a> Course<'a> {
    /// A situation as a course in which every state equals the present one.
    pub(super) fn new(now: &Situation<'a>) -> Self {
        Self { agent: now.agent, graphs: std::slice::from_ref(now.graph), events: now.events, ends: None }
    }

    pub(super) fn agent(&self) -> NodeId {
        self.agent
    }

    /// The vocabulary of the scene, which no action changes.
    pub(super) fn vocabulary(&self) -> &'a Vocabulary {
        self.graphs[0].vocabulary()
    }

    pub(super) fn last(&self) -> usize {
        self.ends.map_or(self.events.len(), |ends| ends.len() - 1)
    }

    fn ended(&self, step: usize) -> usize {
        self.ends.map_or(step, |ends| ends[step])
    }

    /// The state after a step, and the actions after step `since` up to it.
    pub(super) fn situation(&self, since: usize, step: usize) -> Situation<'a> {
        let graph = &self.graphs[step.min(self.graphs.len() - 1)];
        let events = &self.events[self.ended(since)..self.ended(step)];
        Situation { graph, agent: self.agent, events }
    }
}

/// The part of a course on which a goal is evaluated.
#[derive(Clone, Copy)]
pub(super) struct Stretch {
    /// Actions after this step count.
    since: usize,
    /// Temporal operators range from this step on.
    from: usize,
    /// The state is the one after this step.
    now: usize,
    /// The last step.
    end: usize,
    /// `since` and `from` of the whole stretch.
    whole: (usize, usize),
}

impl Stretch {
    /// The whole course.
    pub(super) fn all(course: &Course<'_>) -> Self {
        Self::up_to(course.last())
    }

    /// The course up to a step.
    pub(super) fn up_to(step: usize) -> Self {
        Self::between(0, 0, step)
    }

    fn between(since: usize, from: usize, end: usize) -> Self {
        Self { since, from, now: end, end, whole: (since, from) }
    }

    pub(super) fn situation<'a>(&self, course: &Course<'a>) -> Situation<'a> {
        course.situation(self.since, self.now)
    }

    /// A single step of the stretch.
    fn at(self, step: usize) -> Self {
        Self { since: step.saturating_sub(1).max(self.whole.0), from: step, now: step, ..self }
    }

    /// The steps over which temporal operators range.
    pub(super) fn moments(self) -> impl DoubleEndedIterator<Item = Self> {
        (self.from..=self.end).map(move |step| self.at(step))
    }

    /// The first step and the `steps` steps after it.
    pub(super) fn moments_within(self, steps: u32) -> impl Iterator<Item = Self> {
        self.moments().take((steps as usize).saturating_add(1))
    }

    /// The end of the stretch, evaluated as if the goal stood alone.
    pub(super) fn alone(self) -> Self {
        Self { since: self.whole.0, from: self.whole.1, now: self.end, ..self }
    }

    /// The stretches that a part of a sequence can have: all begin at `from`; the shortest come first.
    pub(super) fn starts(self) -> impl Iterator<Item = Self> {
        (self.from..=self.end).map(move |end| Self::between(self.since, self.from, end))
    }

    /// The stretch from here to the end, as a stretch of its own.
    pub(super) fn rest(self) -> Self {
        Self::between(self.since, self.from, self.end)
    }

    /// The remainder after a stretch.
    pub(super) fn after(self, first: Self) -> Self {
        Self::between(first.end, first.end, self.end)
    }
}
