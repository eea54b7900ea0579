//! The thesis's tables beside the results of this run.

use vc_tasks::Outcome;
use vc_tasks::report::{Report, Run};

use crate::chart::{Bars, Line, bars, lines};

/// Completion in percent, steps, and steps of successes, if there are any.
pub(crate) type Figures = (f64, f64, Option<f64>);

/// The thesis's results.
const THESIS: [(&str, Figures); 3] = [
    ("thesis: random", (16.55, 95.69, Some(73.96))),
    ("thesis: GPT-4 (sees everything)", (77.93, 21.90, Some(10.83))),
    ("thesis: planner", (82.07, 27.61, Some(11.80))),
];

/// The mean steps of Watch-And-Help's planner on tasks of five predicates, and of the optimum with full
/// observability.
pub(crate) const WATCH_AND_HELP: (usize, [f64; 2]) = (5, [60.5, 26.9]);

/// The results of the runs by policy; the last policy is the oracle.
pub(crate) struct Tables {
    pub(crate) report: Report,
    pub(crate) names: Vec<String>,
}

/// Steps relative to the oracle's for goals with a number of objects.
pub(crate) struct Ratios {
    pub(crate) things: usize,
    pub(crate) environments: usize,
    /// In the order of [`Tables::compared`].
    pub(crate) of: Vec<f64>,
}

impl Tables {
    /// The rows of Table 5.2: the thesis's, then those of this run.
    pub(crate) fn rows(&self) -> Vec<(String, Figures)> {
        let thesis = THESIS.iter().map(|(name, figures)| ((*name).to_owned(), *figures));
        let ours = self.names.iter().map(|name| (name.clone(), self.figures(name, |_| true)));
        thesis.chain(ours).collect()
    }

    /// The figures of a policy in some runs. A task that is not completed counts as 100 steps, as in the thesis.
    pub(crate) fn figures(&self, name: &str, which: impl Fn(&Run) -> bool) -> Figures {
        const NOT_COMPLETED: f64 = 100.0;
        let runs: Vec<&Run> = self.report.runs.iter().filter(|r| r.agent == name && which(r)).collect();
        let won: Vec<f64> = runs.iter().filter(|r| r.outcome == Outcome::Won).map(|r| r.steps as f64).collect();
        let failed = (runs.len() - won.len()) as f64;
        let all = runs.len().max(1) as f64;
        // An empty sum is -0.
        let sum = won.iter().sum::<f64>() + 0.0;
        let steps_of_won = (!won.is_empty()).then(|| sum / won.len() as f64);
        (100.0 * won.len() as f64 / all, (sum + NOT_COMPLETED * failed) / all, steps_of_won)
    }

    /// All policies but random, which hardly ever succeeds.
    pub(crate) fn compared(&self) -> &[String] {
        self.names.get(1..).unwrap_or(&[])
    }

    pub(crate) fn ratios(&self) -> Vec<Ratios> {
        let mut numbers: Vec<usize> = self.report.runs.iter().map(|r| r.predicates).collect();
        numbers.sort_unstable();
        numbers.dedup();
        let row = |things: usize| {
            let group = self.report.runs.chunks(self.names.len()).filter(|g| g[0].predicates == things);
            let all_won: Vec<&[Run]> =
                group.filter(|g| g[1..].iter().all(|r| r.outcome == Outcome::Won && r.steps > 0)).collect();
            let steps = |i: usize| all_won.iter().map(|g| g[i].steps).sum::<usize>() as f64;
            let oracle = steps(self.names.len() - 1).max(1.0);
            let of = (1..self.names.len()).map(|i| steps(i) / oracle).collect();
            Ratios { things, environments: all_won.len(), of }
        };
        numbers.into_iter().map(row).filter(|row| row.environments > 0).collect()
    }

    pub(crate) fn table_csv(&self) -> String {
        let line = |(name, (done, steps, won)): &(String, Figures)| {
            let won = won.map_or_else(String::new, |won| format!("{won:.2}"));
            format!("\"{name}\",{done:.2},{steps:.2},{won}\n")
        };
        "policy,completed_percent,steps,steps_when_completed\n".to_owned()
            + &self.rows().iter().map(line).collect::<String>()
    }

    pub(crate) fn table_svg(&self) -> String {
        let group = |(name, (done, steps, won)): &(String, Figures)| Bars {
            name: name.clone(),
            values: vec![*done, *steps, won.unwrap_or(0.0)],
        };
        let groups: Vec<Bars> = self.rows().iter().map(group).collect();
        let measures = [("completed, %", 100.0), ("steps", 100.0), ("steps when completed", 100.0)];
        bars("Table 5.2: the thesis's rows and ours", &measures, &groups)
    }

    pub(crate) fn ratios_csv(&self) -> String {
        let (things, [theirs, best]) = WATCH_AND_HELP;
        let names: String = self.compared().iter().map(|name| format!(",\"{name}\"")).collect();
        let mut csv = format!("things,environments{names},Watch-And-Help\n");
        for row in self.ratios() {
            let cells: String = row.of.iter().map(|ratio| format!(",{ratio:.3}")).collect();
            let reference = if row.things == things { format!("{:.3}", theirs / best) } else { String::new() };
            csv += &format!("{},{}{cells},{reference}\n", row.things, row.environments);
        }
        csv
    }

    pub(crate) fn ratios_svg(&self) -> String {
        let rows = self.ratios();
        let (things, [theirs, best]) = WATCH_AND_HELP;
        let points = |i: usize| rows.iter().map(|row| (row.things as f64, row.of[i])).collect();
        let ours = self.compared().iter().enumerate().map(|(i, name)| Line {
            name: name.clone(),
            points: points(i),
            joined: true,
        });
        let theirs = Line {
            name: "Watch-And-Help's planner".into(),
            points: vec![(things as f64, theirs / best)],
            joined: false,
        };
        let all: Vec<Line> = ours.chain([theirs]).collect();
        lines("Steps as a multiple of the oracle's", "things a goal asks for", "multiple", &all)
    }
}
