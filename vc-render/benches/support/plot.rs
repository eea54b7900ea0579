//! Line plots with two logarithmic axes, as SVG.

use std::fmt::Write;

/// Width and height of a panel's axes, and the margin around them.
const SIZE: [f64; 2] = [280.0, 240.0];
const MARGIN: f64 = 56.0;
const COLOURS: [&str; 2] = ["#1f6fb4", "#c8401f"];
/// Range of milliseconds on the vertical axis, the same in all panels.
const UPWARDS: [f64; 2] = [0.1, 100.0];

/// A plot of two lines.
pub(crate) struct Panel {
    title: &'static str,
    pub(crate) points: Vec<(f64, [f64; 2])>,
}

impl Panel {
    pub(crate) fn new(title: &'static str) -> Self {
        Self { title, points: Vec::new() }
    }

    fn draw(&self, left: f64, out: &mut String) {
        let all = self.points.iter().map(|(x, _)| *x);
        let across = all.fold([f64::INFINITY, 0.0], |r: [f64; 2], x| [r[0].min(0.8 * x), r[1].max(1.25 * x)]);
        let share = |v: f64, [low, high]: [f64; 2]| (v / low).ln() / (high / low).ln();
        let place = |x: f64, y: f64| [left + share(x, across) * SIZE[0], MARGIN + (1.0 - share(y, UPWARDS)) * SIZE[1]];
        let [right, bottom] = [left + SIZE[0], MARGIN + SIZE[1]];
        for v in ticks(across) {
            let [x, _] = place(v, 1.0);
            let _ = writeln!(out, "<path d='M{x:.1} {MARGIN}V{bottom}' stroke='#e4e4e4'/>");
            let _ = writeln!(out, "<text x='{x:.1}' y='{}' text-anchor='middle'>{}</text>", bottom + 18.0, short(v));
        }
        for v in ticks(UPWARDS) {
            let [_, y] = place(across[0], v);
            let _ = writeln!(out, "<path d='M{left} {y:.1}H{right}' stroke='#e4e4e4'/>");
            let _ = writeln!(out, "<text x='{}' y='{:.1}' text-anchor='end'>{}</text>", left - 6.0, y + 4.0, short(v));
        }
        let _ = writeln!(out, "<path d='M{left} {MARGIN}V{bottom}H{right}' fill='none' stroke='#666'/>");
        for (line, colour) in COLOURS.iter().enumerate() {
            let points: Vec<_> = self.points.iter().map(|(x, y)| place(*x, y[line])).collect();
            let list = points.iter().map(|[x, y]| format!("{x:.1},{y:.1}")).collect::<Vec<_>>().join(" ");
            let _ = writeln!(out, "<polyline points='{list}' fill='none' stroke='{colour}' stroke-width='2'/>");
            for [x, y] in points {
                let _ = writeln!(out, "<circle cx='{x:.1}' cy='{y:.1}' r='3' fill='{colour}'/>");
            }
        }
        let middle = left + 0.5 * SIZE[0];
        let _ = writeln!(out, "<text x='{middle}' y='{}' text-anchor='middle'>{}</text>", bottom + 38.0, self.title);
    }
}

/// Ticks of an axis: ones, twos and fives of each decade.
fn ticks([low, high]: [f64; 2]) -> Vec<f64> {
    let powers = low.log10().floor() as i32..=high.log10().ceil() as i32;
    let all = powers.flat_map(|power| [1.0, 2.0, 5.0].map(|one| one * 10_f64.powi(power)));
    all.filter(|v| (low * 0.999..=high * 1.001).contains(v)).collect()
}

/// Formats a number with few digits.
fn short(v: f64) -> String {
    match v {
        v if v > 0.999e6 => format!("{:.0}M", v / 1e6),
        v if v > 0.999e3 => format!("{:.0}k", v / 1e3),
        v if v > 0.999 => format!("{v:.0}"),
        v => format!("{v:.1}"),
    }
}

/// Panels side by side, with milliseconds on the vertical axes.
pub(crate) fn svg(panels: &[Panel], lines: &[&str; 2]) -> String {
    let (width, height) = (MARGIN + panels.len() as f64 * (SIZE[0] + MARGIN), SIZE[1] + 2.0 * MARGIN);
    let mut out = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' width='{width}' height='{height}' font-family='sans-serif' \
         font-size='12'>\n<rect width='100%' height='100%' fill='white'/>\n"
    );
    for (index, panel) in panels.iter().enumerate() {
        panel.draw(MARGIN + index as f64 * (SIZE[0] + MARGIN), &mut out);
    }
    let _ = writeln!(out, "<text x='{MARGIN}' y='28'>Milliseconds of one core:</text>");
    for (index, (name, colour)) in lines.iter().zip(COLOURS).enumerate() {
        let x = MARGIN + 160.0 + 160.0 * index as f64;
        let _ = writeln!(out, "<text x='{x}' y='28' fill='{colour}'>{name}</text>");
    }
    out + "</svg>\n"
}
