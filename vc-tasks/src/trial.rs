//! Executing a task action by action, for programs that ask for rewards.

use vc_graph::{Action, NodeId, Observation, SceneGraph, Scope};

use crate::{GoalProgress, Lost, Task, World, WorldError};

/// An agent with a task in a world, action by action, as in reinforcement learning: each action returns
/// an observation and a reward. The caller runs the loop; `Policy` and `run_episode` of `vc-planner` run it
/// themselves.
///
/// The reward of an action is the change of the score of [`GoalProgress`], so the rewards of an episode that was won sum
/// to the part of the goal that did not hold at first. A goal with words of time is judged on the trace since the trial
/// began. Once it can no longer hold, [`Feedback::lost`] says why, and no reward is positive: a score that counts the
/// steps at which `always Closed(fridge)` held would grow with each idle step after the fridge was open. Action costs
/// and the like are left to the caller.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder, Simulator};
/// use vc_tasks::{Task, Trial};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
/// let milk = scene.add_in(fridge, Draft::new("milk"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let task = Task::new("fetch the milk", "Holds(milk) & Closed(fridge)".parse()?);
///
/// let mut trial = Trial::new(Simulator::new(scene.build()), task, me);
/// let mut total = 0.0;
/// for line in ["grab milk.3", "walk fridge.2", "open fridge.2", "grab milk.3", "close fridge.2"] {
///     let step = trial.step(&line.parse()?);
///     assert_eq!(step.refused.is_some(), total == 0.0 && line == "grab milk.3", "{line}: {:?}", step.refused);
///     assert_eq!(step.terminated, line == "close fridge.2");
///     total += step.reward;
/// }
/// assert_eq!((total, trial.score()), (0.5, 1.0)); // the fridge was closed at first
/// assert!(!trial.reset()?.sees(milk));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Trial<W> {
    world: W,
    start: SceneGraph,
    task: Task,
    agent: NodeId,
    scope: Scope,
    progress: GoalProgress,
    score: f64,
    steps: usize,
    lost: Option<Lost>,
}

/// The result of an action.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder, Simulator};
/// use vc_tasks::{Task, Trial};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let mut world = Simulator::new(scene.build());
/// let mut trial = Trial::new(world, Task::new("fetch", "Holds(apple)".parse()?), me);
/// let feedback = trial.step(&"grab apple.3".parse()?);
/// assert!(feedback.refused.is_some() && !feedback.terminated, "it is not near");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Feedback {
    /// The agent's view after the action.
    pub observation: Observation,
    /// How much more of the goal holds than before the action, -1 to 1; at most 0 once the trial is lost.
    pub reward: f64,
    /// Whether the goal holds: the trial is over.
    pub terminated: bool,
    /// Whether the task's step limit is reached without the goal holding: the trial is over.
    pub truncated: bool,
    /// The reason why the goal cannot hold any more, whatever is done, if that is known: the trial is over. A part with
    /// words of time is broken, or a name in the goal stands for nothing ([`Task::lost`]).
    pub lost: Option<Lost>,
    /// The reason why the action was refused or failed, if it was; it counts as a step. A refused action
    /// changes nothing else.
    pub refused: Option<WorldError>,
}

impl<W: World> Trial<W> {
    /// Begins a task in a world in its current state; the agent observes the room it is in.
    pub fn new(world: W, task: Task, agent: NodeId) -> Self {
        let (start, progress) = (world.graph().clone(), task.begin(&world, agent));
        let (scope, score, steps) = (Scope::Room, 0.0, 0);
        let mut trial = Self { world, start, task, agent, scope, progress, score, steps, lost: None };
        trial.begin();
        trial
    }

    /// Sets which part of the scene the agent observes.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder, Scope, Simulator};
    /// use vc_tasks::{Task, Trial};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let mut world = Simulator::new(scene.build());
    /// let trial = Trial::new(world, Task::new("fetch", "Holds(apple)".parse()?), me).seeing(Scope::Whole);
    /// assert_eq!(trial.observation().len(), 4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn seeing(self, scope: Scope) -> Self {
        Self { scope, ..self }
    }

    /// Counts from the world's present state.
    fn begin(&mut self) {
        self.steps = 0;
        let misnamed = self.task.lost(self.world.graph());
        self.score = if misnamed.is_some() { 0.0 } else { self.progress.score(&self.world) };
        self.lost = misnamed.or_else(|| self.progress.lost(&self.world));
    }

    /// Executes an action of the agent. Actions are accepted after the end, too; the feedback then describes
    /// the world after them.
    pub fn step(&mut self, action: &Action) -> Feedback {
        let refused = self.world.step(self.agent, action).err();
        self.steps += 1;
        let (before, now) = (self.score, self.progress.score(&self.world));
        self.lost = self.lost.take().or_else(|| self.progress.lost(&self.world));
        self.score = if self.lost.is_some() { now.min(before) } else { now };
        let (observation, reward, lost) = (self.observation(), self.score - before, self.lost.clone());
        let terminated = lost.is_none() && self.progress.holds(&self.world);
        let truncated = !terminated && self.steps >= self.task.step_limit;
        Feedback { observation, reward, terminated, truncated, lost, refused }
    }

    /// Resets the world to the scene in which the trial began and returns the agent's first observation.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder, Simulator};
    /// use vc_tasks::{Task, Trial};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let mut world = Simulator::new(scene.build());
    /// let mut trial = Trial::new(world, Task::new("fetch", "Holds(apple)".parse()?), me);
    /// trial.step(&"walk apple.3".parse()?);
    /// assert_eq!(trial.steps(), 1);
    /// trial.reset()?;
    /// assert_eq!(trial.steps(), 0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`World::reset`]; then nothing has changed.
    pub fn reset(&mut self) -> Result<Observation, WorldError> {
        self.world.reset(&self.start)?;
        self.progress = self.task.begin(&self.world, self.agent);
        self.begin();
        Ok(self.observation())
    }

    /// The agent's observation of the world's current state.
    pub fn observation(&self) -> Observation {
        self.world.graph().observe(self.agent, self.scope)
    }

    /// How much of the goal holds now, 0 to 1; it does not grow any more once the trial is lost.
    pub fn score(&self) -> f64 {
        self.score
    }

    /// The number of actions executed or attempted.
    pub fn steps(&self) -> usize {
        self.steps
    }

    /// The world.
    pub fn world(&self) -> &W {
        &self.world
    }

    /// The task.
    pub fn task(&self) -> &Task {
        &self.task
    }
}
