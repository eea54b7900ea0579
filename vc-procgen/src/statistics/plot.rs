//! Plots: room areas, adjacency, the mix of homes.

use super::{Histogram, ReferenceComparison, Statistics, reference};
use crate::picture::{Anchor, Canvas, Colour, Ink, Point};

const OURS: Colour = Colour::hex(0x4a7fb5);
const DARK: Colour = Colour::hex(0x1d3f63);
const REAL: Colour = Colour::hex(0xc0392b);
const GREY: Colour = Colour::hex(0x777c82);

/// The size of one histogram.
const PANEL: Point = [450.0, 250.0];
/// The number of bars of a histogram.
const BARS: usize = 40;

impl Statistics {
    /// Histograms of room areas in the homes that resemble real ones, with the 5th percentile,
    /// median and 95th percentile of both: ours below the axis, those of real homes as red lines.
    ///
    /// ```
    /// use vc_procgen::statistics::Statistics;
    /// assert!(Statistics::default().area_plot().to_svg(600).contains("real homes"));
    /// ```
    pub fn area_plot(&self) -> Canvas {
        let mut canvas = sheet([2.0 * PANEL[0], 3.0 * PANEL[1] + 60.0]);
        let title = "Net room areas, m²: ours (blue), real homes' p5, median, p95 (red)";
        canvas.text([20.0, 3.0 * PANEL[1] + 30.0], 17.0, Anchor::Start, Colour::BLACK, title);
        let empty = Histogram::new(1.0);
        for (i, (zone, real)) in reference::AREAS.into_iter().enumerate() {
            let corner = [(i % 2) as f32 * PANEL[0], (2 - i / 2) as f32 * PANEL[1]];
            let ours = self.comparable.areas.get(&zone).unwrap_or(&empty);
            let high = (1.35 * real[2]).max(1.1 * ours.quantile(0.95).unwrap_or(0.0)).ceil();
            let panel = Panel { corner, high };
            panel.bars(&mut canvas, ours, BARS);
            panel.axis(&mut canvas, zone.name());
            panel.marks(&mut canvas, ours, Some(real));
        }
        canvas
    }

    /// For each pair of room kinds the share of plans in which they share a wall, a door or an open
    /// passage: ours as bars, that of real homes as a red mark within a band of ±0.05.
    pub fn pair_plot(&self) -> Canvas {
        let pairs = self.pairs();
        let high = 30.0 * pairs.len() as f32 + 70.0;
        let mut canvas = sheet([900.0, high]);
        let title = "Share of plans: ours (blue), real homes with ±0.05 (red)";
        canvas.text([20.0, high - 32.0], 17.0, Anchor::Start, Colour::BLACK, title);
        for (i, (_, comparison)) in pairs.iter().enumerate() {
            bar(&mut canvas, high - 70.0 - 30.0 * i as f32, comparison);
        }
        canvas
    }

    /// The mix of homes: schemes, bedrooms, bathrooms, areas and objects.
    pub fn mix_plot(&self) -> Canvas {
        let mut canvas = sheet([2.0 * PANEL[0], 3.0 * PANEL[1] + 60.0]);
        let title = format!("{} homes", self.homes);
        canvas.text([20.0, 3.0 * PANEL[1] + 30.0], 17.0, Anchor::Start, Colour::BLACK, &title);
        let named = |counts: &std::collections::BTreeMap<u32, u64>| -> Vec<(String, u64)> {
            counts.iter().map(|(k, n)| (k.to_string(), *n)).collect()
        };
        let schemes: Vec<_> = self.schemes.iter().map(|(k, n)| (k.clone(), *n)).collect();
        self.columns(&mut canvas, [0.0, 2.0 * PANEL[1]], "scheme", &schemes);
        self.columns(&mut canvas, [PANEL[0], 2.0 * PANEL[1]], "bedrooms", &named(&self.bedrooms));
        self.columns(&mut canvas, [0.0, PANEL[1]], "bathrooms", &named(&self.bathrooms));
        let spreads = [
            ([PANEL[0], PANEL[1]], "net area, m²", &self.area),
            ([0.0, 0.0], "rooms", &self.rooms_per_home),
            ([PANEL[0], 0.0], "objects", &self.objects_per_home),
        ];
        for (corner, what, spread) in spreads {
            let high = (1.05 * spread.quantile(0.999).unwrap_or(1.0)).ceil().max(1.0);
            let panel = Panel { corner, high };
            // Whole numbers get one bar each.
            panel.bars(&mut canvas, spread, if high < BARS as f32 { high as usize } else { BARS });
            panel.axis(&mut canvas, what);
            panel.marks(&mut canvas, spread, None);
        }
        canvas
    }

    /// Draws the shares of homes as bars, with their names and percentages.
    fn columns(&self, canvas: &mut Canvas, corner: Point, what: &str, counts: &[(String, u64)]) {
        let panel = Panel { corner, high: 1.0 };
        canvas.text(panel.at(0.0, 1.06), 14.0, Anchor::Start, Colour::BLACK, what);
        let most = counts.iter().map(|c| c.1).max().unwrap_or(1).max(1) as f32;
        let wide = 1.0 / counts.len().max(1) as f32;
        for (i, (name, count)) in counts.iter().enumerate() {
            let (left, top) = (wide * i as f32, 0.85 * *count as f32 / most);
            let right = left + 0.8 * wide;
            canvas.rectangle(panel.at(left, 0.0), panel.at(right, top), Ink::filled(OURS));
            let middle = (left + right) / 2.0;
            let share = format!("{:.1}%", 100.0 * *count as f32 / self.homes.max(1) as f32);
            canvas.text(panel.at(middle, top + 0.03), 9.0, Anchor::Middle, DARK, &share);
            let fit = (0.95 * wide * (PANEL[0] - 60.0) / Canvas::text_width(1.0, name)).min(11.0);
            let [x, y] = panel.at(middle, 0.0);
            canvas.text([x, y - 16.0], fit, Anchor::Middle, GREY, name);
        }
    }
}

fn sheet(size: Point) -> Canvas {
    Canvas::new([0.0, 0.0], size)
}

/// The position of a histogram on the sheet, and the end of its axis.
struct Panel {
    corner: Point,
    high: f32,
}

impl Panel {
    /// A position in the panel, both coordinates from 0 to 1.
    fn at(&self, x: f32, y: f32) -> Point {
        [self.corner[0] + 30.0 + x * (PANEL[0] - 60.0), self.corner[1] + 55.0 + y * (PANEL[1] - 90.0)]
    }

    fn bars(&self, canvas: &mut Canvas, spread: &Histogram, count: usize) {
        let counts = spread.histogram(self.high, count);
        let most = counts.iter().copied().max().unwrap_or(0).max(1) as f32;
        for (i, n) in counts.iter().enumerate().filter(|(_, n)| **n > 0) {
            let (left, right) = (i as f32 / count as f32, (i + 1) as f32 / count as f32);
            let top = *n as f32 / most;
            canvas.rectangle(self.at(left, 0.0), self.at(right, top), Ink::filled(OURS).outlined(Colour::WHITE, 0.7));
        }
    }

    fn axis(&self, canvas: &mut Canvas, title: &str) {
        canvas.line(&[self.at(0.0, 0.0), self.at(1.0, 0.0)], Ink::line(GREY, 1.0));
        canvas.text(self.at(0.0, 1.06), 14.0, Anchor::Start, Colour::BLACK, title);
        let step = [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0].into_iter().find(|s| self.high / s <= 8.0);
        let step = step.unwrap_or(500.0);
        for i in 0..=(self.high / step) as usize {
            let value = step * i as f32;
            let [x, y] = self.at(value / self.high, 0.0);
            canvas.line(&[[x, y], [x, y - 4.0]], Ink::line(GREY, 1.0));
            canvas.text([x, y - 17.0], 10.0, Anchor::Middle, GREY, &format!("{value:.0}"));
        }
    }

    /// Draws percentiles: ours as dark ticks below the axis, those of real homes as lines.
    fn marks(&self, canvas: &mut Canvas, ours: &Histogram, real: Option<[f32; 3]>) {
        let ours = [0.05, 0.5, 0.95].map(|share| ours.quantile(share));
        for (i, value) in ours.into_iter().enumerate() {
            let Some(value) = value else { continue };
            let [x, y] = self.at((value / self.high).min(1.0), 0.0);
            let half = if i == 1 { 5.0 } else { 3.0 };
            canvas.polygon(&[[x, y], [x - half, y - 8.0], [x + half, y - 8.0]], Ink::filled(DARK));
        }
        let text = |v: [Option<f32>; 3]| v.map(|v| v.map_or_else(|| "?".into(), |v| format!("{v:.1}"))).join(" - ");
        canvas.text(self.at(1.0, 1.06), 11.0, Anchor::End, DARK, &text(ours));
        for (i, value) in real.into_iter().flatten().enumerate() {
            let ink = Ink::line(REAL, if i == 1 { 2.0 } else { 1.2 });
            let x = value / self.high;
            canvas.line(&[self.at(x, 0.0), self.at(x, 0.97)], if i == 1 { ink } else { ink.dashed(4.0) });
        }
        if let Some(real) = real {
            canvas.text(self.at(1.0, 0.96), 11.0, Anchor::End, REAL, &text(real.map(Some)));
        }
    }
}

/// Draws one row: name, bar from 0 to 1, mark of the reference, values.
fn bar(canvas: &mut Canvas, y: f32, comparison: &ReferenceComparison) {
    let at = |share: f64| 290.0 + 420.0 * share as f32;
    let (name, real) = (&comparison.quantity, comparison.reference);
    canvas.text([270.0, y + 6.0], 12.0, Anchor::End, Colour::BLACK, name);
    canvas.rectangle([at(0.0), y], [at(1.0), y + 20.0], Ink::filled(Colour::hex(0xf1f2f4)));
    let ours = comparison.measured.unwrap_or(0.0);
    canvas.rectangle([at(0.0), y + 3.0], [at(ours), y + 17.0], Ink::filled(OURS));
    let (low, high) = ((real - 0.05).max(0.0), (real + 0.05).min(1.0));
    canvas.rectangle([at(low), y], [at(high), y + 20.0], Ink::filled(REAL.faded(0.2)));
    canvas.line(&[[at(real), y - 1.0], [at(real), y + 21.0]], Ink::line(REAL, 2.0));
    let colour = if comparison.holds() == Some(false) { REAL } else { DARK };
    let measured = comparison.measured.map_or_else(|| "  - ".to_owned(), |v| format!("{v:.2}"));
    canvas.text([730.0, y + 6.0], 12.0, Anchor::Start, colour, &format!("{measured} / {real:.2}"));
}
