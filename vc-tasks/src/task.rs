//! Tasks and how they end.

use serde::{Deserialize, Serialize};
use vc_graph::format::unmarked;
use vc_graph::goal::GoalError;
use vc_graph::{Goal, NodeId, SceneGraph};

use crate::obstacle::{self, Lost, Obstacle};
use crate::{GoalProgress, World};

/// A goal to be reached in a scene.
///
/// ```
/// use vc_tasks::Task;
/// let task = Task::new("breakfast", "On(apple, kitchen_table)".parse()?);
/// assert_eq!(task.step_limit, 500);
/// # Ok::<(), vc_graph::goal::GoalError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Task {
    /// The task's name, `set the table`.
    pub title: String,
    /// The goal, which is to hold at the end; words of time in it are about all that happens in the episode.
    pub goal: Goal,
    /// The number of actions after which an attempt is over.
    #[serde(default = "default_limit")]
    pub step_limit: usize,
}

/// Steps an attempt may take unless a task says otherwise. The thesis stops after
/// 100 and Watch-And-Help after 250; a search that samples places uniformly needs
/// more in its worst cases.
const STEP_LIMIT: usize = 500;

fn default_limit() -> usize {
    STEP_LIMIT
}

/// How an attempt ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Outcome {
    /// The goal holds in the true scene.
    Won,
    /// The agent stopped, and the goal does not hold.
    Lost,
    /// The step limit was reached first.
    TimedOut,
    /// The agent's action was refused, and the agent had no other.
    Aborted,
}

/// A mistake in a list of tasks.
///
/// ```
/// use vc_tasks::{Task, TaskError};
/// let error = Task::read_list("breakfast: On(apple").unwrap_err();
/// assert!(matches!(error, TaskError::Goal { line: 1, .. }));
/// ```
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum TaskError {
    /// A line is not `title: goal`.
    #[error("line {0}: a task is written `title: goal`")]
    NoTitle(usize),
    /// A goal cannot be parsed.
    #[error("line {line}: {error}")]
    Goal {
        /// Line, counted from one.
        line: usize,
        /// The mistake in the goal.
        #[source]
        error: GoalError,
    },
}

impl Task {
    /// A task with the usual step limit.
    pub fn new(title: impl Into<String>, goal: Goal) -> Self {
        Self { title: title.into(), goal, step_limit: STEP_LIMIT }
    }

    /// Begins an episode of an agent in a world as it is: the verdict on it, step by step. This is how
    /// episodes are judged; a goal with words of time can be judged in no other way.
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
    /// let mut progress = Task::new("fetch", "Holds(apple)".parse()?).begin(&world, me);
    /// for line in ["walk apple.3", "grab apple.3"] {
    ///     world.step(me, &line.parse()?).map_err(|why| why[0].clone())?;
    ///     progress.note(&world);
    /// }
    /// assert!(progress.holds(&world));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn begin(&self, world: &dyn World, agent: NodeId) -> GoalProgress {
        GoalProgress::new(&self.goal, world, agent)
    }

    /// Whether the goal holds for an agent in the world's current state: in the true scene, not in
    /// anybody's belief.
    ///
    /// A world does not keep its earlier states. So a goal with words of time ([`Goal::is_temporal`]) does not hold
    /// by this function once something has been done, whatever was so on the way: [`Task::begin`] judges it.
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
    /// assert!(Task::new("set", "On(apple, kitchen_table)".parse()?).holds(&world, me));
    /// assert_eq!(Task::new("fetch", "Holds(apple)".parse()?).score(&world, me), 0.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn holds(&self, world: &dyn World, agent: NodeId) -> bool {
        self.can_be_judged(world) && self.goal.holds(&world.situation(agent))
    }

    /// How much of the goal holds for an agent, 0 to 1: [`Goal::score`]. For a goal with words of time it is 0 once
    /// something has been done; see [`Task::holds`].
    pub fn score(&self, world: &dyn World, agent: NodeId) -> f64 {
        if self.can_be_judged(world) { self.goal.score(&world.situation(agent)) } else { 0.0 }
    }

    /// Whether the world's present state is all that the verdict depends on.
    fn can_be_judged(&self, world: &dyn World) -> bool {
        !self.goal.is_temporal() || world.history().events().is_empty()
    }

    /// The reasons why the goal makes no sense in a scene; empty if it does make sense. Considers the
    /// parts that must hold, but not negations; one alternative of a disjunction must be possible. Labels of another
    /// class than their nodes, missing nodes and unknown classes are reported wherever they stand.
    ///
    /// A state that no action brings about is no obstacle where a process of the built-in
    /// [`ProcessTable`](vc_graph::clock::ProcessTable) could: juice freezes in a freezer. Processes go on in a world with
    /// a clock, as `virtualcity::Environment`; in a [`Simulator`](vc_graph::Simulator) no time passes, and planners do
    /// not wait for them.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// use vc_tasks::Task;
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// for class in ["milk", "apple", "bread"] {
    ///     scene.add_in(kitchen, Draft::new(class))?;
    /// }
    /// let scene = scene.build();
    /// let why = |goal: &str| -> Result<String, vc_graph::goal::GoalError> {
    ///     Ok(Task::new("t", goal.parse()?).obstacles(&scene).iter().map(ToString::to_string).collect())
    /// };
    /// assert!(why("Holds(milk) & Holds(apple) & Holds(bread)")?.ends_with("an agent has 2 hands"));
    /// assert!(why("On(apple, floor.2)")?.contains("`floor.2` names a thing that is milk.2"));
    /// assert_eq!(why("Holds(milk.99)")?, "there is no `milk.99` in this scene");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn obstacles(&self, graph: &SceneGraph) -> Vec<Obstacle> {
        obstacle::obstacles(&self.goal, graph)
    }

    /// The reason why the goal is lost in a scene before anything is done: a label of another class than its node, or a
    /// missing node or an unknown class in a part that must not hold or must hold for all, a predicate that the scene does
    /// not define and without which nothing is meant, a part that ranges over more than 10^8 choices of objects, or two parts
    /// that never hold together. A part with a wrong name would hold at once, as nothing on the table is a `mugg`. A known
    /// class of which the scene has no object is no such name.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// use vc_tasks::Task;
    /// let mut scene = SceneBuilder::new("flat");
    /// scene.add(Draft::new("kitchen_table"))?;
    /// let scene = scene.build();
    /// let why = |goal: &str| -> Result<_, vc_graph::goal::GoalError> {
    ///     Ok(Task::new("t", goal.parse()?).lost(&scene).map(|lost| lost.to_string()))
    /// };
    /// let lost = why("always !On(mugg, kitchen_table)")?;
    /// assert_eq!(lost.as_deref(), Some("there is no class `mugg` (did you mean `mug`?)"));
    /// assert_eq!(why("!On(mug, kitchen_table)")?, None); // there is no mug, and so none on the table
    /// let lost = why("On(mug, kitchen_table) & !On(mug, kitchen_table)")?;
    /// assert!(lost.is_some_and(|why| why.ends_with("never hold at the same time")));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn lost(&self, graph: &SceneGraph) -> Option<Lost> {
        obstacle::lost(&self.goal, graph)
    }

    /// Reads a list of tasks: one a line, `title: goal`; `#` starts a comment line.
    ///
    /// ```
    /// let tasks = vc_tasks::Task::read_list("# mornings\nbreakfast: On(apple, table)\n")?;
    /// assert_eq!(tasks[0].title, "breakfast");
    /// # Ok::<(), vc_tasks::TaskError>(())
    /// ```
    ///
    /// # Errors
    /// [`TaskError`] with the line.
    pub fn read_list(text: &str) -> Result<Vec<Self>, TaskError> {
        Self::read_lines(text).collect()
    }

    /// As [`Task::read_list`], but continues after lines that are not tasks.
    ///
    /// ```
    /// use vc_tasks::Task;
    /// let text = "breakfast: On(apple, table)\nno task\nnight: Closed(fridge)\n";
    /// assert_eq!(Task::read_lines(text).filter(Result::is_ok).count(), 2);
    /// ```
    ///
    /// # Errors
    /// Each line that is not a task gives a [`TaskError`].
    pub fn read_lines(text: &str) -> impl Iterator<Item = Result<Self, TaskError>> + '_ {
        let lines = unmarked(text).lines().enumerate().map(|(i, line)| (i + 1, line.trim()));
        let tasks = lines.filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
        tasks.map(|(line, text)| Self::read_line(line, text))
    }

    fn read_line(line: usize, text: &str) -> Result<Self, TaskError> {
        let (title, goal) = text.split_once(':').ok_or(TaskError::NoTitle(line))?;
        let goal = goal.parse().map_err(|error| TaskError::Goal { line, error })?;
        Ok(Self::new(title.trim(), goal))
    }
}
