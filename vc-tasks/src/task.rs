//! Tasks and how they end.

use serde::{Deserialize, Serialize};
use vc_graph::format::unmarked;
use vc_graph::goal::GoalError;
use vc_graph::{Goal, NodeId};

use crate::{GoalProgress, World};

/// A goal to be reached in a scene.
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
    pub fn begin(&self, world: &dyn World, agent: NodeId) -> GoalProgress {
        GoalProgress::new(&self.goal, world, agent)
    }

    /// Whether the goal holds for an agent in the world's current state: in the true scene, not in
    /// anybody's belief.
    ///
    /// A world does not keep its earlier states. So a goal with words of time ([`Goal::is_temporal`]) does not hold
    /// by this function once something has been done, whatever was so on the way: [`Task::begin`] judges it.
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
