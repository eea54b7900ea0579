//! Aggregated attempts.

use serde::Serialize;

use super::{GroupBy, Run};
use crate::Outcome;

/// The measures of several attempts.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ReportRow {
    /// The key that they have in common.
    pub key: String,
    /// The agent's name.
    pub agent: String,
    /// The number of attempts.
    pub runs: usize,
    /// The number of attempts that were won.
    pub won: usize,
    /// The number of attempts that the agent gave up or wrongly took for done.
    pub lost: usize,
    /// The number of attempts that ran out of steps.
    pub timed_out: usize,
    /// The number of attempts stopped by a refused action or a fault.
    pub aborted: usize,
    /// The success rate.
    pub success: f64,
    /// The 95 % confidence interval of the success rate: Wilson's (1927), which is sound for few
    /// attempts.
    pub interval: (f64, f64),
    /// The mean share of the goal that held at the end.
    pub credit: f64,
    /// The mean number of actions.
    pub steps: f64,
    /// The mean number of actions of the attempts that were won.
    pub steps_won: Option<f64>,
    /// The mean success weighted by path length, see [`Run::spl`].
    pub spl: Option<f64>,
    /// The mean distance, metres.
    pub distance: Option<f64>,
    /// The mean duration, seconds.
    pub seconds: Option<f64>,
}

/// Rows aggregated by the same key.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// The aggregation key.
    pub by: GroupBy,
    /// The rows: by key, then by agent.
    pub rows: Vec<ReportRow>,
}

impl ReportRow {
    pub(super) fn new(key: &str, agent: &str, runs: &[&Run]) -> Self {
        let count = |outcome| runs.iter().filter(|r| r.outcome == outcome).count();
        let won = count(Outcome::Won);
        let mean_of = |measure: fn(&Run) -> Option<f64>| mean(runs.iter().filter_map(|r| measure(r)));
        let steps_won = runs.iter().filter(|r| r.outcome == Outcome::Won).map(|r| r.steps as f64);
        Self {
            key: key.to_owned(),
            agent: agent.to_owned(),
            runs: runs.len(),
            won,
            lost: count(Outcome::Lost),
            timed_out: count(Outcome::TimedOut),
            aborted: count(Outcome::Aborted),
            success: won as f64 / runs.len().max(1) as f64,
            interval: wilson(won, runs.len()),
            credit: mean_of(|r| Some(r.credit)).unwrap_or(0.0),
            steps: mean_of(|r| Some(r.steps as f64)).unwrap_or(0.0),
            steps_won: mean(steps_won),
            spl: mean_of(Run::spl),
            distance: mean_of(|r| r.distance),
            seconds: mean_of(|r| r.seconds),
        }
    }
}

fn mean(values: impl Iterator<Item = f64>) -> Option<f64> {
    let (sum, number) = values.fold((0.0, 0_usize), |(sum, number), value| (sum + value, number + 1));
    (number > 0).then(|| sum / number as f64)
}

/// Wilson's score interval of a rate, at 95 %.
fn wilson(won: usize, runs: usize) -> (f64, f64) {
    if runs == 0 {
        return (0.0, 1.0);
    }
    const Z: f64 = 1.959_964;
    let (n, share) = (runs as f64, won as f64 / runs as f64);
    let middle = share + Z * Z / (2.0 * n);
    let spread = Z * (share * (1.0 - share) / n + Z * Z / (4.0 * n * n)).sqrt();
    let scale = 1.0 + Z * Z / n;
    // Rounding must not put the rate itself outside.
    (((middle - spread) / scale).clamp(0.0, share), ((middle + spread) / scale).clamp(share, 1.0))
}
