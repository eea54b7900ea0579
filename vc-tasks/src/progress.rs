//! The verdict on a task while an episode goes on.

use vc_graph::goal::EpisodeTrace;
use vc_graph::{Event, Goal, NodeId};

use crate::World;
use crate::compile::Monitor;
use crate::obstacle::Lost;

/// A goal judged step by step in an episode.
///
/// A goal without words of time is judged on the world's present state, and nothing is kept. A goal with words of
/// time ([`Goal::is_temporal`]) is judged on the trace since the episode began, as [`Goal::holds_on`] judges it: each
/// action of any agent is a step of the trace, and the states share what did not change between them.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder, Simulator};
/// use vc_tasks::{Task, World};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
/// let milk = scene.add_in(fridge, Draft::new("milk"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let mut world = Simulator::new(scene.build());
///
/// let [fetch, never] = ["Open(fridge) then Closed(fridge) & Holds(milk)", "always Closed(fridge) & Holds(milk)"];
/// let mut fetch = Task::new("fetch", fetch.parse()?).begin(&world, me);
/// let mut never = Task::new("never open", never.parse()?).begin(&world, me);
/// for line in ["walk fridge.2", "open fridge.2", "grab milk.3", "close fridge.2"] {
///     World::step(&mut world, me, &line.parse()?)?;
///     fetch.note(&world);
///     never.note(&world);
/// }
/// assert!(fetch.holds(&world));
/// assert!(!never.holds(&world)); // the fridge was opened on the way
/// assert!(never.lost(&world).is_some_and(|lost| lost.to_string().starts_with("`always Closed(fridge)` does not hold")));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct GoalProgress {
    goal: Goal,
    agent: NodeId,
    past: Option<Box<Past>>,
}

/// The trace of an episode.
#[derive(Debug, Clone)]
struct Past {
    /// The world's history when the episode began.
    before: Vec<Event>,
    trace: EpisodeTrace,
    /// The same trace as truth values, while the scene has the nodes that it began with.
    monitor: Option<Monitor>,
}

impl GoalProgress {
    /// A goal of an agent in an episode that begins with the world as it is.
    pub fn new(goal: &Goal, world: &dyn World, agent: NodeId) -> Self {
        let past = goal.is_temporal().then(|| Box::new(Past::new(goal, world, agent)));
        Self { goal: goal.clone(), agent, past }
    }

    /// Takes note of what has been done since the last call, as one step. Call it after each action.
    ///
    /// The world's history says what has been done. Where its last actions are no more or have become others, they were
    /// undone, as a world is that is set back to a copy, and the trace goes on from the step before them. After a reset
    /// the trace begins anew; call it before the next action where the new scene may be another one.
    ///
    /// Costs nothing for a goal without words of time; else a comparison of the actions so far, one read of each fact
    /// that the goal is about, and a visit of each step so far for each word of time.
    pub fn note(&mut self, world: &dyn World) {
        let Some(past) = &mut self.past else { return };
        let events = world.history().events();
        let since = events.strip_prefix(past.before.as_slice());
        match since {
            Some(since) if since.starts_with(past.noted()) => past.push(world),
            Some(since) if past.can_step_back_to(since, world) => {
                past.step_back_to(since, &self.goal);
                past.push(world);
            }
            _ => **past = Past::new(&self.goal, world, self.agent),
        }
    }

    /// Whether the goal holds now; takes note of what has been done before.
    pub fn holds(&mut self, world: &dyn World) -> bool {
        self.note(world);
        match &self.past {
            None => self.goal.holds(&world.situation(self.agent)),
            Some(past) => past.holds(&self.goal),
        }
    }

    /// The reason why the goal cannot hold any more, whatever is done from now on, if that is known: a part with words
    /// of time has been broken. Takes note of what has been done before. Parts with `then` or pairs, and goals too
    /// large to be compiled, are not known to be broken.
    pub fn lost(&mut self, world: &dyn World) -> Option<Lost> {
        self.note(world);
        let part = self.past.as_ref()?.monitor.as_ref()?.broken()?;
        Some(Lost::Broken(self.goal.conjuncts().get(part)?.to_string()))
    }

    /// How much of the goal holds now, 0 to 1: [`Goal::score`], or [`Goal::score_on`] the trace. Takes note of what has
    /// been done before.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder, Simulator};
    /// use vc_tasks::Task;
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let mut world = Simulator::new(scene.build());
    /// let mut progress = Task::new("fetch", "On(apple, kitchen_table) & Holds(apple)".parse()?).begin(&world, me);
    /// assert_eq!(progress.score(&world), 0.5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn score(&mut self, world: &dyn World) -> f64 {
        self.note(world);
        match &self.past {
            None => self.goal.score(&world.situation(self.agent)),
            Some(past) if past.holds(&self.goal) => 1.0,
            Some(past) => self.goal.score_on(&past.trace),
        }
    }
}

impl Past {
    fn new(goal: &Goal, world: &dyn World, agent: NodeId) -> Self {
        let trace = EpisodeTrace::new(world.graph().clone(), agent);
        // A goal too large to be compiled is judged on the states.
        let monitor = Monitor::from_trace(goal, &trace);
        Self { before: world.history().events().to_vec(), trace, monitor }
    }

    /// The actions of the trace.
    fn noted(&self) -> &[Event] {
        self.trace.situation(self.trace.steps()).map_or(&[], |now| now.events)
    }

    /// Adds a step if there are actions that the trace does not have.
    fn push(&mut self, world: &dyn World) {
        let events = &world.history().events()[self.before.len() + self.noted().len()..];
        if events.is_empty() {
            return;
        }
        self.trace.push(world.graph().clone(), events.iter().copied());
        if !self.is_same_scene(world) {
            self.monitor = None;
        }
        if let (Some(monitor), Some(now)) = (&mut self.monitor, self.trace.situation(self.trace.steps())) {
            monitor.push(&now);
        }
    }

    /// Whether actions since the episode began can be those of the trace with the last ones undone: not if the world has
    /// been reset.
    fn can_step_back_to(&self, since: &[Event], world: &dyn World) -> bool {
        !since.is_empty() && (since.first() == self.noted().first() || self.is_same_scene(world))
    }

    /// Whether a world has the nodes with which the trace began.
    fn is_same_scene(&self, world: &dyn World) -> bool {
        self.trace.graph(0).is_some_and(|first| first.has_same_nodes(world.graph()))
    }

    /// Takes back the steps with actions that are not among those since the episode began.
    fn step_back_to(&mut self, since: &[Event], goal: &Goal) {
        let kept = self.noted().iter().zip(since).take_while(|(noted, done)| noted == done).count();
        let is_kept = |step: &usize| self.trace.situation(*step).is_none_or(|then| then.events.len() <= kept);
        let step = (0..=self.trace.steps()).rev().find(is_kept).unwrap_or(0);
        self.trace.truncate(step);
        self.monitor = Monitor::from_constant_nodes(goal, &self.trace);
    }

    fn holds(&self, goal: &Goal) -> bool {
        self.monitor.as_ref().map_or_else(|| goal.holds_on(&self.trace), Monitor::holds)
    }
}
