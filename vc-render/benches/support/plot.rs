//! Lines over two axes, both by powers of ten, as SVG.

use std::fmt::Write;

/// Width and height of a panel's axes, and what is around them.
const SIZE: [f64; 2] = [260.0, 220.0];
const MARGIN: f64 = 60.0;
const COLOURS: [&str; 2] = ["#1f6fb4", "#c8401f"];

/// A plot of two lines.
pub(crate) struct Panel {
    title: &'static str,
    pub(crate) points: Vec<(f64, [f64; 2])>,
}

impl Panel {
    pub(crate) fn new(title: &'static str) -> Self {
        Self { title, points: Vec::new() }
    }

    /// Powers of ten around all values of an axis.
    fn range(&self, axis: usize) -> [f64; 2] {
        let values = self.points.iter().flat_map(|(x, y)| if axis == 0 { vec![*x] } else { y.to_vec() });
        let around = values.fold([f64::INFINITY, 0.0], |r: [f64; 2], v| [r[0].min(v), r[1].max(v)]);
        [around[0].log10().floor(), around[1].log10().ceil()]
    }

    fn draw(&self, left: f64, out: &mut String) {
        let ranges = [self.range(0), self.range(1)];
        let place = |axis: usize, v: f64| {
            let [low, high] = ranges[axis];
            let share = (v.log10() - low) / (high - low).max(1.0);
            if axis == 0 { left + share * SIZE[0] } else { MARGIN + (1.0 - share) * SIZE[1] }
        };
        let (right, bottom) = (left + SIZE[0], MARGIN + SIZE[1]);
        let tick = |power: i32| format!("10<tspan dy='-5' font-size='8'>{power}</tspan>");
        for power in ranges[0][0] as i32..=ranges[0][1] as i32 {
            let x = place(0, 10_f64.powi(power));
            let _ = writeln!(out, "<path d='M{x} {MARGIN}V{bottom}' stroke='#ddd'/>");
            let _ = writeln!(out, "<text x='{x}' y='{}' text-anchor='middle'>{}</text>", bottom + 18.0, tick(power));
        }
        for power in ranges[1][0] as i32..=ranges[1][1] as i32 {
            let y = place(1, 10_f64.powi(power));
            let _ = writeln!(out, "<path d='M{left} {y}H{right}' stroke='#ddd'/>");
            let _ = writeln!(out, "<text x='{}' y='{}' text-anchor='end'>{}</text>", left - 6.0, y + 4.0, tick(power));
        }
        for (line, colour) in COLOURS.iter().enumerate() {
            let points = self.points.iter().map(|(x, y)| format!("{:.1},{:.1}", place(0, *x), place(1, y[line])));
            let points = points.collect::<Vec<_>>().join(" ");
            let _ = writeln!(out, "<polyline points='{points}' fill='none' stroke='{colour}' stroke-width='2'/>");
        }
        let middle = left + 0.5 * SIZE[0];
        let _ = writeln!(out, "<text x='{middle}' y='{}' text-anchor='middle'>{}</text>", bottom + 38.0, self.title);
    }
}

/// Panels side by side, milliseconds upwards.
pub(crate) fn svg(panels: &[Panel], lines: &[&str; 2]) -> String {
    let (width, height) = (MARGIN + panels.len() as f64 * (SIZE[0] + MARGIN), SIZE[1] + 2.0 * MARGIN);
    let mut out = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' width='{width}' height='{height}' font-family='sans-serif' \
         font-size='12'>\n<rect width='100%' height='100%' fill='white'/>\n"
    );
    for (index, panel) in panels.iter().enumerate() {
        panel.draw(MARGIN + index as f64 * (SIZE[0] + MARGIN), &mut out);
    }
    for (index, (name, colour)) in lines.iter().zip(COLOURS).enumerate() {
        let x = MARGIN + 160.0 * index as f64;
        let _ = writeln!(out, "<text x='{x}' y='30' fill='{colour}'>{name}, ms of one core</text>");
    }
    out + "</svg>\n"
}
