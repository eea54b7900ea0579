//! Lines by the squares of a grid that they pass, to find what is near a point.

use std::collections::BTreeMap;

use crate::{Point, Polyline};

/// The side of a square, metres.
const SQUARE: f64 = 32.0;
/// A line that passes more squares than this is noted by its box of squares no more finely.
const FINEST: f64 = SQUARE / 2.0;

#[derive(Debug, Default)]
pub(crate) struct PointIndex {
    squares: BTreeMap<(i32, i32), Vec<u32>>,
}

fn square(point: &Point) -> (i32, i32) {
    ((point.x / SQUARE).floor() as i32, (point.y / SQUARE).floor() as i32)
}

impl PointIndex {
    /// The index of some lines, with their numbers.
    pub(crate) fn new<'a>(lines: impl Iterator<Item = (u32, &'a Polyline)>) -> Self {
        let mut squares: BTreeMap<(i32, i32), Vec<u32>> = BTreeMap::new();
        for (id, line) in lines {
            let steps = (line.length() / FINEST).ceil().clamp(1.0, 1e5) as u32;
            for step in 0..=steps {
                let at = square(&line.at(line.length() * f64::from(step) / f64::from(steps)));
                let list = squares.entry(at).or_default();
                if list.last() != Some(&id) {
                    list.push(id);
                }
            }
        }
        Self { squares }
    }

    /// Visits everything near a point from the inside outward, until all that is nearer than the visitor's answer (the
    /// distance of the best so far) or within a distance has been seen.
    pub(crate) fn around(&self, point: &Point, within: f64, mut visit: impl FnMut(u32) -> f64) {
        let (x, y) = square(point);
        let mut best = f64::INFINITY;
        let rings = (within / SQUARE).ceil().clamp(0.0, 64.0) as i32 + 1;
        for ring in 0..=rings {
            // A line may have been noted a square beside the one in which it is nearest.
            if f64::from(ring - 2) * SQUARE > best {
                return;
            }
            for (dx, dy) in border(ring) {
                for id in self.squares.get(&(x.saturating_add(dx), y.saturating_add(dy))).into_iter().flatten() {
                    best = visit(*id);
                }
            }
        }
    }
}

/// The squares at a distance, in squares.
fn border(ring: i32) -> impl Iterator<Item = (i32, i32)> {
    (-ring..=ring).flat_map(move |dx| {
        let step = if dx.abs() == ring { 1 } else { (2 * ring).max(1) };
        (-ring..=ring).step_by(step as usize).map(move |dy| (dx, dy))
    })
}
