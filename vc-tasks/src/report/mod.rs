//! The results of attempts at tasks: measures, tables, files and plots.
//!
//! A [`Run`] is one attempt with its measures. A [`Report`] holds many of them: [`Report::table`]
//! aggregates them by agent, by task group or by number of predicates into [`ReportRow`]s, as text, CSV, JSON
//! or an SVG plot.
//!
//! ```
//! use vc_tasks::Outcome;
//! use vc_tasks::report::{GroupBy, Report, Run};
//!
//! let run = |task: &str, outcome, steps| Run {
//!     agent: "planner".into(),
//!     task: task.into(),
//!     outcome,
//!     credit: if outcome == Outcome::Won { 1.0 } else { 0.5 },
//!     steps,
//!     best_steps: Some(10),
//!     ..Run::default()
//! };
//! let report = Report::new(vec![
//!     run("watch_tv-01", Outcome::Won, 10),
//!     run("watch_tv-02", Outcome::Won, 20),
//!     run("put_fridge-01", Outcome::TimedOut, 100),
//! ]);
//! let table = report.table(GroupBy::Group);
//! let tv = table.rows.iter().find(|r| r.key == "watch_tv").ok_or("no such row")?;
//! assert_eq!((tv.success, tv.spl, tv.steps_won), (1.0, Some(0.75), Some(15.0)));
//! assert_eq!(report.overall().success, 2.0 / 3.0);
//! # Ok::<(), &str>(())
//! ```

mod form;
mod plot;
mod row;

use serde::{Deserialize, Serialize};
use vc_graph::Goal;

use crate::Outcome;

pub use row::{ReportRow, Table};

/// One attempt at a task, with its measures.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Run {
    /// The agent's name.
    pub agent: String,
    /// The task's identifier, `put_fridge-01`; the part before the last `-` is its group.
    pub task: String,
    /// The seed of the initial environment.
    pub seed: u64,
    /// The number of conditions in the goal, see [`predicates`].
    pub predicates: usize,
    /// The result of the attempt.
    pub outcome: Outcome,
    /// The fraction of the goal that held at the end, 0 to 1.
    pub credit: f64,
    /// The number of actions executed.
    pub steps: usize,
    /// The smallest number of actions known to fulfil the task, for the path-weighted success.
    pub best_steps: Option<usize>,
    /// The distance the agent covered, metres, where bodies move.
    pub distance: Option<f64>,
    /// The shortest distance known to fulfil the task, metres.
    pub best_distance: Option<f64>,
    /// The duration, seconds, by the runner's clock.
    pub seconds: Option<f64>,
}

impl Default for Run {
    /// An attempt that was stopped before its first action.
    fn default() -> Self {
        Self {
            agent: String::new(),
            task: String::new(),
            seed: 0,
            predicates: 0,
            outcome: Outcome::Aborted,
            credit: 0.0,
            steps: 0,
            best_steps: None,
            distance: None,
            best_distance: None,
            seconds: None,
        }
    }
}

impl Run {
    /// The task's group: its base in the benchmark.
    pub fn group(&self) -> &str {
        self.task.rsplit_once('-').map_or(&self.task, |(group, _)| group)
    }

    /// Success weighted by path length (Anderson et al., "On evaluation of embodied navigation agents",
    /// 2018): for a success the best effort divided by the actual one, at most 1; else 0. Measured in
    /// metres where both distances are known, else in actions; `None` where neither best is known.
    ///
    /// ```
    /// use vc_tasks::Outcome;
    /// use vc_tasks::report::Run;
    /// let run = Run { outcome: Outcome::Won, steps: 20, best_steps: Some(10), ..Run::default() };
    /// assert_eq!(run.spl(), Some(0.5));
    /// ```
    pub fn spl(&self) -> Option<f64> {
        let (best, taken) = match (self.best_distance, self.distance, self.best_steps) {
            (Some(best), Some(taken), _) => (best, taken),
            (_, _, Some(best)) => (best as f64, self.steps as f64),
            _ => return None,
        };
        let longest = taken.max(best);
        let share = if longest > 0.0 { best / longest } else { 1.0 };
        Some(if self.outcome == Outcome::Won { share } else { 0.0 })
    }
}

/// The number of conditions in a goal: its literals, each weighted by its count.
///
/// ```
/// use vc_tasks::report::predicates;
/// assert_eq!(predicates(&"On(plate, table), 3 & (Sit(chair) | Lie(bed)) & Closed(fridge)".parse()?), 6);
/// # Ok::<(), vc_graph::goal::GoalError>(())
/// ```
pub fn predicates(goal: &Goal) -> usize {
    match goal {
        Goal::Literal(_) => 1,
        Goal::Count { number, .. } => (*number).max(1) as usize,
        Goal::Same(..) => 0,
        Goal::ForN { number, of, .. } => (*number).max(1) as usize * predicates(&of.body),
        _ => goal.parts().into_iter().map(predicates).sum(),
    }
}

/// The key by which a table aggregates attempts; agents are always kept separate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum GroupBy {
    /// By agent alone.
    Agent,
    /// By the task's group.
    Group,
    /// By the number of conditions in the goal.
    Predicates,
}

impl GroupBy {
    /// The name in tables.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Agent => "agent",
            Self::Group => "group",
            Self::Predicates => "predicates",
        }
    }

    fn key(self, run: &Run) -> (usize, String) {
        match self {
            Self::Agent => (0, run.agent.clone()),
            Self::Group => (0, run.group().to_owned()),
            Self::Predicates => (run.predicates, run.predicates.to_string()),
        }
    }
}

/// Attempts at tasks.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Report {
    /// The attempts, in the order in which they were made.
    pub runs: Vec<Run>,
}

impl Report {
    /// A report of attempts.
    pub fn new(runs: Vec<Run>) -> Self {
        Self { runs }
    }

    /// Aggregates the attempts, one row for each key and agent.
    pub fn table(&self, by: GroupBy) -> Table {
        let mut groups: std::collections::BTreeMap<(usize, String, &str), Vec<&Run>> = Default::default();
        for run in &self.runs {
            let (rank, key) = by.key(run);
            groups.entry((rank, key, &run.agent)).or_default().push(run);
        }
        let rows = groups.iter().map(|((_, key, agent), runs)| ReportRow::new(key, agent, runs));
        Table { by, rows: rows.collect() }
    }

    /// Aggregates all attempts into one row.
    pub fn overall(&self) -> ReportRow {
        ReportRow::new("all", "", &self.runs.iter().collect::<Vec<_>>())
    }
}
