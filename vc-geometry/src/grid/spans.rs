//! The part of each row of a raster that a grown outline covers.
//!
//! Every side, moved outwards by the radius, and every corner's arc between two sides is traced over the rows
//! it crosses. A convex outline needs only its smallest and largest x in each row.

use std::ops::Range;

use nalgebra::{Point2, Vector2};

use super::ceiling;

/// The covered interval of each row; the rows' middles are a pitch apart.
#[derive(Debug, Clone, Default)]
pub(super) struct Spans {
    /// Height of the first row's middle.
    first: f32,
    pitch: f32,
    rows: Vec<(f32, f32)>,
}

impl Spans {
    /// Traces a convex outline, corners counter-clockwise, grown by a radius, over `count` rows from `first`
    /// on. The cost is linear in the rows that its sides and arcs cross.
    pub(super) fn trace(&mut self, outline: &[Point2<f32>], radius: f32, first: f32, pitch: f32, count: usize) {
        (self.first, self.pitch) = (first, pitch);
        self.rows.clear();
        self.rows.resize(count, (f32::INFINITY, f32::NEG_INFINITY));
        let ends = outline.iter().zip(outline.iter().cycle().skip(1));
        let outwards = |(a, b): (&Point2<f32>, &Point2<f32>)| {
            (b - a).try_normalize(0.0).map(|unit| Vector2::new(unit.y, -unit.x) * radius)
        };
        let Some(mut before) = ends.clone().filter_map(outwards).last() else {
            return outline.iter().for_each(|p| self.disc(p, radius, p.y - radius, p.y + radius));
        };
        for (a, b) in ends {
            let Some(out) = outwards((a, b)) else { continue };
            self.arc(a, radius, &before, &out);
            self.side(&(a + out), &(b + out));
            before = out;
        }
    }

    /// The covered rows: index and interval.
    pub(super) fn covered(&self) -> impl Iterator<Item = (usize, (f32, f32))> + '_ {
        self.rows.iter().copied().enumerate().filter(|(_, (low, high))| low <= high)
    }

    fn between(&self, low: f32, high: f32) -> Range<usize> {
        let row = |y: f32| (y - self.first) / self.pitch;
        whole_up(row(low))..(row(high).max(0.0) as usize + usize::from(high >= self.first)).min(self.rows.len())
    }

    fn middle(&self, row: usize) -> f32 {
        self.first + row as f32 * self.pitch
    }

    fn add(&mut self, row: usize, low: f32, high: f32) {
        let span = &mut self.rows[row];
        *span = (span.0.min(low), span.1.max(high));
    }

    /// Adds the arc around a corner between the outward normals of the sides before and after it.
    fn arc(&mut self, corner: &Point2<f32>, radius: f32, before: &Vector2<f32>, after: &Vector2<f32>) {
        let (mut low, mut high) = (before.y.min(after.y), before.y.max(after.y));
        if before.x > 0.0 && after.x < 0.0 {
            high = radius;
        }
        if before.x < 0.0 && after.x > 0.0 {
            low = -radius;
        }
        self.disc(corner, radius, corner.y + low, corner.y + high);
    }

    /// Adds the part of a disc between two heights.
    fn disc(&mut self, centre: &Point2<f32>, radius: f32, low: f32, high: f32) {
        for row in self.between(low, high) {
            let rise = self.middle(row) - centre.y;
            let half = (radius * radius - rise * rise).max(0.0).sqrt();
            self.add(row, centre.x - half, centre.x + half);
        }
    }

    fn side(&mut self, a: &Point2<f32>, b: &Point2<f32>) {
        let rise = b.y - a.y;
        for row in self.between(a.y.min(b.y), a.y.max(b.y)) {
            let along = if rise == 0.0 { 0.0 } else { ((self.middle(row) - a.y) / rise).clamp(0.0, 1.0) };
            let x = a.x + (b.x - a.x) * along;
            self.add(row, x, x);
        }
    }
}

/// The ceiling of a number; zero for negative numbers and NaN.
pub(super) fn whole_up(x: f32) -> usize {
    ceiling(x).max(0) as usize
}
