//! Profiles: plane outlines of any form, as shapes are turned or extruded from; their cutting into trapezia between
//! horizontal lines, and outlines with fewer corners.
//!
//! ```
//! use vc_geometry::profile::{simplified, slabs};
//! // A cup's wall and bottom: radius and height.
//! let cup = [(0.0, 0.0), (4.0, 0.0), (4.0, 10.0), (3.0, 10.0), (3.0, 1.0), (0.0, 1.0)];
//! let cut = slabs(&cup);
//! assert_eq!(cut.len(), 2);
//! assert_eq!((cut[1].bottom, cut[1].top, cut[1].low), (1.0, 10.0, (3.0, 4.0)));
//! assert_eq!(simplified(&[(0.0, 0.0), (1.0, 0.01), (2.0, 0.0), (2.0, 5.0)], 0.1).len(), 3);
//! ```

/// A trapezium between two levels: its left and right ends at the bottom and at the top.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slab {
    /// The lower level.
    pub bottom: f32,
    /// The upper level.
    pub top: f32,
    /// Left and right end at the lower level.
    pub low: (f32, f32),
    /// Left and right end at the upper level.
    pub high: (f32, f32),
}

impl Slab {
    /// Its four corners, counter-clockwise from the lower left.
    pub fn corners(&self) -> [(f32, f32); 4] {
        [(self.low.0, self.bottom), (self.low.1, self.bottom), (self.high.1, self.top), (self.high.0, self.top)]
    }

    /// Whether another slab continues this one upwards without a corner.
    fn goes_on(&self, next: &Self) -> bool {
        let slope = |s: &Self| {
            let height = s.top - s.bottom;
            ((s.high.0 - s.low.0) / height, (s.high.1 - s.low.1) / height)
        };
        let near = |a: f32, b: f32| (a - b).abs() < 1e-4;
        let (a, b) = (slope(self), slope(next));
        near(self.high.0, next.low.0) && near(self.high.1, next.low.1) && near(a.0, b.0) && near(a.1, b.1)
    }
}

/// Cuts the inside of an outline (a closed polygon, even-odd rule) at the level of every corner. Costs the
/// square of the number of corners.
///
/// ```
/// let gable = [(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 4.0), (0.0, 2.0)];
/// let slabs = vc_geometry::profile::slabs(&gable);
/// assert_eq!(slabs.iter().map(|slab| (slab.bottom, slab.top)).collect::<Vec<_>>(), [(0.0, 2.0), (2.0, 4.0)]);
/// assert_eq!(slabs[1].high, (2.0, 2.0)); // The ridge.
/// ```
pub fn slabs(outline: &[(f32, f32)]) -> Vec<Slab> {
    let mut levels: Vec<f32> = outline.iter().map(|p| p.1).collect();
    levels.sort_by(f32::total_cmp);
    levels.dedup_by(|a, b| (*a - *b).abs() < 1e-5);
    let mut done: Vec<Slab> = Vec::new();
    for pair in levels.windows(2) {
        let (bottom, top) = (pair[0], pair[1]);
        let mut sides = crossings(outline, f32::midpoint(bottom, top), bottom, top);
        sides.sort_by(|a, b| (a.0 + a.1).total_cmp(&(b.0 + b.1)));
        for side in sides.chunks_exact(2) {
            let slab = Slab { bottom, top, low: (side[0].0, side[1].0), high: (side[0].1, side[1].1) };
            match done.iter_mut().find(|s| s.top == bottom && s.goes_on(&slab)) {
                Some(below) => (below.top, below.high) = (top, slab.high),
                None => done.push(slab),
            }
        }
    }
    done
}

/// The edges that cross a level, given by their ends at the bottom and at the top of a slab.
fn crossings(outline: &[(f32, f32)], level: f32, bottom: f32, top: f32) -> Vec<(f32, f32)> {
    let next = outline.iter().cycle().skip(1);
    let edges = outline.iter().zip(next).filter(|(a, b)| (a.1 < level) != (b.1 < level));
    let at = |a: &(f32, f32), b: &(f32, f32), y: f32| a.0 + (b.0 - a.0) * ((y - a.1) / (b.1 - a.1)).clamp(0.0, 1.0);
    edges.map(|(a, b)| (at(a, b, bottom), at(a, b, top))).collect()
}

/// An outline without the corners that change it by less than a tolerance (Ramer 1972, Douglas and Peucker
/// 1973), and without repeated points.
///
/// ```
/// let wavy = [(0.0, 0.0), (1.0, 0.01), (2.0, -0.01), (3.0, 0.0), (3.0, 2.0)];
/// assert_eq!(vc_geometry::profile::simplified(&wavy, 0.1), [(0.0, 0.0), (3.0, 0.0), (3.0, 2.0)]);
/// ```
pub fn simplified(outline: &[(f32, f32)], tolerance: f32) -> Vec<(f32, f32)> {
    let mut keep = vec![false; outline.len()];
    if let Some(last) = outline.len().checked_sub(1) {
        (keep[0], keep[last]) = (true, true);
        let mut open = vec![(0, last)];
        while let Some((from, to)) = open.pop() {
            let far = (from + 1..to).map(|i| (i, distance(outline[i], outline[from], outline[to])));
            if let Some((middle, _)) = far.filter(|(_, d)| *d > tolerance).max_by(|a, b| a.1.total_cmp(&b.1)) {
                keep[middle] = true;
                open.extend([(from, middle), (middle, to)]);
            }
        }
    }
    outline.iter().zip(keep).filter(|(_, k)| *k).map(|(p, _)| *p).collect()
}

/// Distance of a point from a segment.
fn distance(p: (f32, f32), a: (f32, f32), b: (f32, f32)) -> f32 {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let length = dx * dx + dy * dy;
    let t = if length > 0.0 { (((p.0 - a.0) * dx + (p.1 - a.1) * dy) / length).clamp(0.0, 1.0) } else { 0.0 };
    let (x, y) = (p.0 - a.0 - t * dx, p.1 - a.1 - t * dy);
    (x * x + y * y).sqrt()
}
