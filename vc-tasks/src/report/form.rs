//! Tables as text and in files.

use std::fmt::Write as _;

use vc_graph::format::unmarked;

use super::{Report, ReportRow, Run, Table};

const HEADINGS: [&str; 14] = [
    "agent",
    "runs",
    "won",
    "lost",
    "timed out",
    "aborted",
    "success",
    "low",
    "high",
    "credit",
    "steps",
    "steps won",
    "SPL",
    "distance",
];

impl ReportRow {
    /// The cells in the order of the headings; a measure that is missing is empty.
    fn cells(&self) -> Vec<String> {
        let share = |value: f64| format!("{value:.3}");
        let maybe = |value: Option<f64>, digits: usize| value.map_or_else(String::new, |v| format!("{v:.digits$}"));
        let counts = [self.runs, self.won, self.lost, self.timed_out, self.aborted].map(|n| n.to_string());
        let shares = [self.success, self.interval.0, self.interval.1, self.credit].map(share);
        let mut cells = vec![self.key.clone(), self.agent.clone()];
        cells.extend(counts);
        cells.extend(shares);
        cells.push(format!("{:.1}", self.steps));
        cells.extend([maybe(self.steps_won, 1), maybe(self.spl, 3), maybe(self.distance, 1), maybe(self.seconds, 3)]);
        cells
    }
}

impl Table {
    fn headings(&self) -> Vec<&'static str> {
        std::iter::once(self.by.as_str()).chain(HEADINGS).chain(std::iter::once("seconds")).collect()
    }

    /// The table in aligned columns; empty columns are left out.
    pub fn text(&self) -> String {
        let headings: Vec<String> = self.headings().into_iter().map(str::to_owned).collect();
        let rows: Vec<Vec<String>> = self.rows.iter().map(ReportRow::cells).collect();
        let filled = |column: &usize| rows.iter().any(|row| !row[*column].is_empty());
        let columns: Vec<usize> = (0..headings.len()).filter(filled).collect();
        let all = || std::iter::once(&headings).chain(&rows);
        let width = |column: usize| all().map(|row| row[column].chars().count()).max().unwrap_or(0);
        let mut text = String::new();
        for row in all() {
            let cells = columns.iter().map(|&c| match c {
                0 | 1 => format!("{:<1$}", row[c], width(c)),
                _ => format!("{:>1$}", row[c], width(c)),
            });
            text.push_str(cells.collect::<Vec<_>>().join("  ").trim_end());
            text.push('\n');
        }
        text
    }

    /// The table as CSV (RFC 4180) with a line of headings.
    ///
    /// ```
    /// use vc_tasks::report::{GroupBy, Report, Run};
    /// let report = Report::new(vec![Run { agent: "planner".into(), task: "tidy-01".into(), ..Run::default() }]);
    /// let csv = report.table(GroupBy::Agent).csv();
    /// assert_eq!(csv.lines().count(), 2, "headings and a row");
    /// ```
    pub fn csv(&self) -> String {
        let headings: Vec<String> = self.headings().into_iter().map(|h| h.replace(' ', "_").to_lowercase()).collect();
        std::iter::once(headings).chain(self.rows.iter().map(ReportRow::cells)).map(|row| csv_line(&row)).collect()
    }

    /// The table as JSON: an array of rows.
    pub fn json(&self) -> String {
        // Plain data: serialising it cannot fail.
        serde_json::to_string_pretty(&self.rows).unwrap_or_default()
    }
}

impl Report {
    /// All attempts as JSON, to be read back by [`Report::from_json`].
    pub fn json(&self) -> String {
        serde_json::to_string_pretty(self).unwrap_or_default()
    }

    /// Reads attempts.
    ///
    /// ```
    /// use vc_tasks::report::{Report, Run};
    /// let report = Report::new(vec![Run { agent: "planner".into(), task: "tidy-01".into(), ..Run::default() }]);
    /// assert_eq!(Report::from_json(&report.json())?, report);
    /// # Ok::<(), serde_json::Error>(())
    /// ```
    ///
    /// # Errors
    /// The error of the JSON text, with line and column.
    pub fn from_json(text: &str) -> Result<Self, serde_json::Error> {
        serde_json::from_str(unmarked(text))
    }

    /// All attempts as CSV (RFC 4180), one a line.
    pub fn csv(&self) -> String {
        let mut text = String::from(
            "agent,task,seed,predicates,outcome,credit,steps,best_steps,distance,best_distance,seconds,spl\n",
        );
        self.runs.iter().for_each(|run| text.push_str(&run_line(run)));
        text
    }
}

fn run_line(run: &Run) -> String {
    let maybe = |value: Option<f64>| value.map_or_else(String::new, |v| v.to_string());
    let outcome = serde_json::to_value(run.outcome).ok().and_then(|v| v.as_str().map(str::to_owned));
    csv_line(&[
        run.agent.clone(),
        run.task.clone(),
        run.seed.to_string(),
        run.predicates.to_string(),
        outcome.unwrap_or_default(),
        run.credit.to_string(),
        run.steps.to_string(),
        run.best_steps.map_or_else(String::new, |v| v.to_string()),
        maybe(run.distance),
        maybe(run.best_distance),
        maybe(run.seconds),
        maybe(run.spl()),
    ])
}

fn csv_line(cells: &[String]) -> String {
    let mut line = String::new();
    for (index, cell) in cells.iter().enumerate() {
        let comma = if index == 0 { "" } else { "," };
        let quoted = cell.contains([',', '"', '\n', '\r']);
        let cell = if quoted { format!("\"{}\"", cell.replace('"', "\"\"")) } else { cell.clone() };
        // Writing to a string does not fail.
        let _ = write!(line, "{comma}{cell}");
    }
    line + "\n"
}
