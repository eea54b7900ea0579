//! How attempts at tasks went: measures, tables, files and plots.
//!
//! A [`Run`] is one attempt with what was measured. A [`Report`] is many of them:
//! [`Report::table`] aggregates them by agent, by task group or by number of
//! predicates into [`Row`]s, as text, CSV, JSON or an SVG plot.
//!
//! ```
//! use vc_tasks::Outcome;
//! use vc_tasks::report::{By, Report, Run};
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
//! let table = report.table(By::Group);
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

pub use row::{Row, Table};

/// One attempt at a task, and what was measured.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Run {
    /// Who tried.
    pub agent: String,
    /// The task's id, `put_fridge-01`; what is before the last `-` is its group.
    pub task: String,
    /// The seed of the initial environment.
    pub seed: u64,
    /// How many things the goal asks for, see [`predicates`].
    pub predicates: usize,
    /// How it ended.
    pub outcome: Outcome,
    /// How much of the goal held at the end, 0 to 1.
    pub credit: f64,
    /// How many actions were done.
    pub steps: usize,
    /// The fewest actions known to do it, for the path-weighted success.
    pub best_steps: Option<usize>,
    /// How far the agent went, metres, where bodies move.
    pub distance: Option<f64>,
    /// The shortest way known to do it, metres.
    pub best_distance: Option<f64>,
    /// How long it took, seconds, by whatever clock the runner keeps.
    pub seconds: Option<f64>,
}

impl Default for Run {
    /// An attempt that was stopped before anything was done.
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

    /// Success weighted by path length (Anderson et al., "On evaluation of embodied
    /// navigation agents", 2018): for a success what would have done over what was
    /// done, at most 1; else 0. Metres where both are known, else actions; `None`
    /// where neither best is known.
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

/// How many things a goal asks for: its literals, each as often as it counts.
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

/// What the attempts of a table are put together by; agents are always kept apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum By {
    /// By agent alone.
    Agent,
    /// By the task's group.
    Group,
    /// By the number of things the goal asks for.
    Predicates,
}

impl By {
    /// What it is called in tables.
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

    /// The attempts put together, one row for each key and agent.
    pub fn table(&self, by: By) -> Table {
        let mut groups: std::collections::BTreeMap<(usize, String, &str), Vec<&Run>> = Default::default();
        for run in &self.runs {
            let (rank, key) = by.key(run);
            groups.entry((rank, key, &run.agent)).or_default().push(run);
        }
        let rows = groups.iter().map(|((_, key, agent), runs)| Row::of(key, agent, runs));
        Table { by, rows: rows.collect() }
    }

    /// All attempts in one row.
    pub fn overall(&self) -> Row {
        Row::of("all", "", &self.runs.iter().collect::<Vec<_>>())
    }
}
