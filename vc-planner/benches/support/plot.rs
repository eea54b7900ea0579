//! A plot of growth on two logarithmic axes.

use std::fmt::Write as _;

/// A line of a plot: its name and its points.
pub(crate) struct Line<'a> {
    pub(crate) name: &'a str,
    pub(crate) points: Vec<(f64, f64)>,
}

const WIDTH: f64 = 480.0;
const HEIGHT: f64 = 320.0;
const MARGIN: f64 = 56.0;
const COLOURS: [&str; 3] = ["#1f6feb", "#bc4c00", "#57606a"];

/// Draws lines as SVG, with a horizontal and a vertical axis and a mark at each power of ten.
pub(crate) fn svg(title: &str, across: &str, up: &str, lines: &[Line<'_>]) -> String {
    let all = || lines.iter().flat_map(|l| &l.points);
    let (x, y) = (Axis::over(all().map(|p| p.0)), Axis::over(all().map(|p| p.1)));
    let at = |p: &(f64, f64)| {
        (MARGIN + x.at(p.0) * (WIDTH - 1.5 * MARGIN), HEIGHT - MARGIN - y.at(p.1) * (HEIGHT - 2.0 * MARGIN))
    };
    let mut text = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {WIDTH} {HEIGHT}' font-family='sans-serif' font-size='11'>\n\
         <rect width='100%' height='100%' fill='white'/>\n<text x='{MARGIN}' y='20' font-size='13'>{title}</text>\n\
         <text x='{}' y='{}' text-anchor='middle'>{across}</text>\n<text x='8' y='{}'>{up}</text>\n",
        WIDTH / 2.0,
        HEIGHT - 12.0,
        MARGIN - 12.0,
    );
    for tick in x.ticks() {
        let (px, py) = at(&(tick, y.low));
        let _ = writeln!(
            text,
            "<path d='M{px} {py}V{MARGIN}' stroke='#ddd'/><text x='{px}' y='{}' text-anchor='middle'>{tick}</text>",
            py + 14.0
        );
    }
    for tick in y.ticks() {
        let (px, py) = at(&(x.low, tick));
        let _ = writeln!(
            text,
            "<path d='M{px} {py}H{}' stroke='#ddd'/><text x='{}' y='{}' text-anchor='end'>{tick}</text>",
            WIDTH - MARGIN / 2.0,
            px - 4.0,
            py + 4.0
        );
    }
    for (i, line) in lines.iter().enumerate() {
        let colour = COLOURS[i % COLOURS.len()];
        let points: Vec<String> = line.points.iter().map(at).map(|(px, py)| format!("{px:.1},{py:.1}")).collect();
        let _ =
            writeln!(text, "<polyline points='{}' fill='none' stroke='{colour}' stroke-width='2'/>", points.join(" "));
        let _ = writeln!(
            text,
            "<text x='{}' y='{}' fill='{colour}'>{}</text>",
            MARGIN + 8.0,
            MARGIN + 14.0 * (i + 1) as f64,
            line.name
        );
    }
    text + "</svg>\n"
}

struct Axis {
    low: f64,
    high: f64,
}

impl Axis {
    /// The range from the power of ten below the values to the one above.
    fn over(values: impl Iterator<Item = f64> + Clone) -> Self {
        let low = values.clone().fold(f64::INFINITY, f64::min).max(1e-9).log10().floor();
        let high = values.fold(1e-9, f64::max).log10().ceil();
        Self { low: 10f64.powf(low), high: 10f64.powf(high.max(low + 1.0)) }
    }

    fn at(&self, value: f64) -> f64 {
        (value.max(self.low) / self.low).log10() / (self.high / self.low).log10()
    }

    fn ticks(&self) -> impl Iterator<Item = f64> + use<> {
        let decades = (self.high / self.low).log10().round() as i32;
        let low = self.low;
        (0..=decades).map(move |n| low * 10f64.powi(n))
    }
}
