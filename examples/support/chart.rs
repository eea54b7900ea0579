//! Charts as SVG: bar charts, and line charts over integers.

use std::fmt::Write as _;

/// Colours that colour-blind people can also distinguish (Okabe and Ito 2008).
const COLOURS: [&str; 7] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#666666"];
const MARGIN: f64 = 56.0;

/// A group of bars: its name, and a bar for each measure.
pub(crate) struct Bars {
    pub(crate) name: String,
    pub(crate) values: Vec<f64>,
}

/// A bar chart with the values; each measure has its own scale.
pub(crate) fn bars(title: &str, measures: &[(&str, f64)], groups: &[Bars]) -> String {
    const NAMES: f64 = 230.0;
    const LENGTH: f64 = 360.0;
    const BAR: f64 = 13.0;
    let block = BAR * (measures.len() as f64 + 0.7);
    let mut svg = page(title, NAMES + LENGTH + MARGIN, MARGIN + block * groups.len() as f64 + 12.0);
    legend(&mut svg, measures.iter().map(|m| m.0), NAMES, 40.0);
    for (i, group) in groups.iter().enumerate() {
        let top = MARGIN + block * i as f64;
        text(&mut svg, NAMES - 8.0, top + BAR, "end", &group.name);
        for (j, (value, (_, whole))) in group.values.iter().zip(measures).enumerate() {
            let (y, length) = (top + BAR * j as f64, (value / whole).clamp(0.0, 1.0) * LENGTH);
            let (colour, thick) = (COLOURS[j % COLOURS.len()], BAR - 2.0);
            let _ =
                writeln!(svg, "<rect x='{NAMES}' y='{y:.1}' width='{length:.1}' height='{thick}' fill='{colour}'/>");
            text(&mut svg, NAMES + length + 5.0, y + BAR - 3.0, "start", &format!("{value:.2}"));
        }
    }
    svg + "</svg>\n"
}

/// A line: its name, its points in the order of x, and whether they are connected.
pub(crate) struct Line {
    pub(crate) name: String,
    pub(crate) points: Vec<(f64, f64)>,
    pub(crate) joined: bool,
}

/// A line chart over the integers from one, with values from zero upwards.
pub(crate) fn lines(title: &str, across: &str, up: &str, lines: &[Line]) -> String {
    const WIDTH: f64 = 640.0;
    const HEIGHT: f64 = 340.0;
    let most = |of: fn(&(f64, f64)) -> f64| lines.iter().flat_map(|l| &l.points).map(of).fold(1.0, f64::max).ceil();
    let (right, top) = (most(|p| p.0), most(|p| p.1));
    let x = |v: f64| MARGIN + (v - 1.0) / (right - 1.0).max(1.0) * (WIDTH - 1.5 * MARGIN);
    let y = |v: f64| HEIGHT - MARGIN - v / top * (HEIGHT - 2.5 * MARGIN);
    let mut svg = page(title, WIDTH, HEIGHT);
    text(&mut svg, WIDTH / 2.0, HEIGHT - 12.0, "middle", across);
    text(&mut svg, 8.0, MARGIN + 20.0, "start", up);
    legend(&mut svg, lines.iter().map(|l| l.name.as_str()), MARGIN, 40.0);
    for tick in 1..=right as usize {
        text(&mut svg, x(tick as f64), HEIGHT - MARGIN + 16.0, "middle", &tick.to_string());
    }
    for tick in 0..=top as usize {
        let at = y(tick as f64);
        let _ = writeln!(svg, "<path d='M{MARGIN} {at:.1}H{:.1}' stroke='#ddd'/>", x(right));
        text(&mut svg, MARGIN - 6.0, at + 4.0, "end", &tick.to_string());
    }
    for (i, line) in lines.iter().enumerate() {
        let colour = COLOURS[i % COLOURS.len()];
        let points: Vec<String> = line.points.iter().map(|p| format!("{:.1},{:.1}", x(p.0), y(p.1))).collect();
        if line.joined {
            let points = points.join(" ");
            let _ = writeln!(svg, "<polyline points='{points}' fill='none' stroke='{colour}' stroke-width='2'/>");
        }
        for (px, py) in line.points.iter().map(|p| (x(p.0), y(p.1))) {
            let _ = writeln!(svg, "<circle cx='{px:.1}' cy='{py:.1}' r='3' fill='{colour}'/>");
        }
    }
    svg + "</svg>\n"
}

fn page(title: &str, width: f64, height: f64) -> String {
    let mut svg = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {width:.0} {height:.0}' width='{width:.0}' \
         font-family='sans-serif' font-size='11'>\n<rect width='100%' height='100%' fill='white'/>\n"
    );
    text(&mut svg, 12.0, 20.0, "start", title);
    svg
}

fn legend<'a>(svg: &mut String, names: impl Iterator<Item = &'a str>, left: f64, y: f64) {
    let mut x = left;
    for (name, colour) in names.zip(COLOURS.iter().cycle()) {
        let _ = writeln!(svg, "<rect x='{x:.0}' y='{:.0}' width='10' height='10' fill='{colour}'/>", y - 9.0);
        text(svg, x + 14.0, y, "start", name);
        x += 24.0 + 6.2 * name.chars().count() as f64;
    }
}

fn text(svg: &mut String, x: f64, y: f64, anchor: &str, words: &str) {
    let words = words.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    let _ = writeln!(svg, "<text x='{x:.1}' y='{y:.1}' text-anchor='{anchor}'>{words}</text>");
}
