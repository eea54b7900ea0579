//! Plots as SVG.

use std::fmt::Write as _;

use super::{ReportRow, Table};

/// The widths of the labels and of the scale, the height of a bar and the gap between rows, pixels.
const LABELS: f64 = 170.0;
const SCALE: f64 = 460.0;
const BAR: f64 = 13.0;
const GAP: f64 = 9.0;
const TOP: f64 = 64.0;
const RIGHT: f64 = 60.0;

/// The colours of agents, in order of appearance (Okabe and Ito 2008: distinguishable for the
/// colour-blind).
const COLOURS: [&str; 7] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#666666"];

impl Table {
    /// Draws the success rate of each row as a bar with its 95 % interval, and the mean credit as a
    /// mark, as an SVG picture; each agent has one colour.
    ///
    /// ```
    /// use vc_tasks::report::{GroupBy, Report, Run};
    /// let report = Report::new(vec![Run { agent: "planner".into(), task: "tidy-01".into(), ..Run::default() }]);
    /// assert!(report.table(GroupBy::Agent).svg("Success").contains("<svg"));
    /// ```
    pub fn svg(&self, title: &str) -> String {
        let agents = self.agents();
        let keys = self.keys();
        let block = BAR * agents.len() as f64 + GAP;
        let (width, height) = (LABELS + SCALE + RIGHT, TOP + block * keys.len() as f64 + 40.0);
        let mut svg = String::new();
        let mut put = |text: String| svg.push_str(&(text + "\n"));
        put(format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" font-size=\"12\">"
        ));
        put(format!("<rect width=\"{width}\" height=\"{height}\" fill=\"white\"/>"));
        put(text(12.0, 22.0, "start", 15.0, title));
        put(legend(&agents));
        put(axis(height));
        for (index, key) in keys.iter().enumerate() {
            let y = TOP + block * index as f64;
            put(text(LABELS - 8.0, y + (block - GAP) / 2.0 + 4.0, "end", 12.0, key));
            for (place, agent) in agents.iter().enumerate() {
                if let Some(row) = self.rows.iter().find(|r| r.key == *key && r.agent == *agent) {
                    put(bar(row, y + BAR * place as f64, COLOURS[place % COLOURS.len()]));
                }
            }
        }
        svg + "</svg>\n"
    }

    fn agents(&self) -> Vec<&str> {
        once(self.rows.iter().map(|r| r.agent.as_str()))
    }

    fn keys(&self) -> Vec<&str> {
        once(self.rows.iter().map(|r| r.key.as_str()))
    }
}

/// The distinct names in order of appearance.
fn once<'a>(names: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    names.fold(Vec::new(), |mut all, name| {
        if !all.contains(&name) {
            all.push(name);
        }
        all
    })
}

fn at(share: f64) -> f64 {
    LABELS + SCALE * share
}

fn legend(agents: &[&str]) -> String {
    let mut x = LABELS;
    let mut svg = String::new();
    for (place, agent) in agents.iter().enumerate() {
        let colour = COLOURS[place % COLOURS.len()];
        let _ = write!(svg, "<rect x=\"{x:.0}\" y=\"34\" width=\"12\" height=\"12\" fill=\"{colour}\"/>");
        svg.push_str(&text(x + 17.0, 44.0, "start", 12.0, agent));
        x += 34.0 + 7.0 * agent.chars().count() as f64;
    }
    svg.push_str(&text(x, 44.0, "start", 12.0, "bar: success with 95 % interval; diamond: credit"));
    svg
}

fn axis(height: f64) -> String {
    let bottom = height - 34.0;
    let line = |tenth: i32| {
        let x = at(f64::from(tenth) / 5.0);
        let label = text(x, bottom + 18.0, "middle", 12.0, &format!("{}", f64::from(tenth) / 5.0));
        format!("<line x1=\"{x:.1}\" y1=\"{TOP}\" x2=\"{x:.1}\" y2=\"{bottom:.1}\" stroke=\"#dddddd\"/>{label}")
    };
    (0..=5).map(line).collect()
}

fn bar(row: &ReportRow, y: f64, colour: &str) -> String {
    let (low, high, middle) = (at(row.interval.0), at(row.interval.1), y + BAR / 2.0);
    let credit = at(row.credit);
    let length = SCALE * row.success;
    let thick = BAR - 2.0;
    format!(
        "<rect x=\"{LABELS}\" y=\"{y:.1}\" width=\"{length:.1}\" height=\"{thick}\" fill=\"{colour}\"/>\
         <line x1=\"{low:.1}\" y1=\"{middle:.1}\" x2=\"{high:.1}\" y2=\"{middle:.1}\" stroke=\"#222222\"/>\
         <path d=\"M {credit:.1} {y:.1} l 4 5.5 l -4 5.5 l -4 -5.5 z\" fill=\"white\" stroke=\"#222222\"/>{}",
        text(at(1.0) + 8.0, y + 10.0, "start", 11.0, &format!("{}/{}", row.won, row.runs))
    )
}

fn text(x: f64, y: f64, anchor: &str, size: f64, words: &str) -> String {
    let words = words.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    format!("<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" font-size=\"{size}\">{words}</text>")
}
