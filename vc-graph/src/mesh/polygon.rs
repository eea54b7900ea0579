//! Triangulation of a polygon by ear clipping.
//!
//! An outline of `n` corners always gives `n - 2` triangles that use all of them, even a corner in the middle
//! of a straight edge and even if the outline touches or crosses itself, so that caps fit walls without a gap.
//! O'Rourke, Computational Geometry in C, chapter 1.

use robust::{Coord, orient2d};

use std::cmp::Ordering;

fn side(a: (f32, f32), b: (f32, f32), c: (f32, f32)) -> Ordering {
    let [a, b, c] = [a, b, c].map(|(x, y)| Coord { x: f64::from(x), y: f64::from(y) });
    orient2d(a, b, c).total_cmp(&0.0)
}

/// The remaining corners of a polygon, as a circular list.
struct Left<'a> {
    outline: &'a [(f32, f32)],
    next: Vec<usize>,
    previous: Vec<usize>,
    /// Corners that are not convex: only these can be inside an ear.
    blunt: Vec<usize>,
}

/// Cuts a counter-clockwise polygon of `n` different corners into `n - 2` triangles.
pub(super) fn triangles(outline: &[(f32, f32)]) -> Vec<[usize; 3]> {
    let n = outline.len();
    if n < 3 {
        return Vec::new();
    }
    let next = (1..n).chain([0]).collect();
    let previous = [n - 1].into_iter().chain(0..n - 1).collect();
    let mut left = Left { outline, next, previous, blunt: Vec::new() };
    left.blunt = (0..n).filter(|&v| !left.is_convex(v)).collect();
    left.cut()
}

impl Left<'_> {
    fn cut(mut self) -> Vec<[usize; 3]> {
        let mut triangles = Vec::with_capacity(self.outline.len() - 2);
        let (mut at, mut refused, mut crossed) = (0, 0, false);
        while triangles.len() + 2 < self.outline.len() {
            let (before, after) = (self.previous[at], self.next[at]);
            // An outline that crosses itself may have no ear; then any corner is cut off.
            crossed |= refused > self.outline.len() - triangles.len();
            if !crossed && !self.is_ear(at) {
                (at, refused) = (after, refused + 1);
                continue;
            }
            triangles.push([before, at, after]);
            (self.next[before], self.previous[after]) = (after, before);
            // A corner that has become convex stays convex.
            let blunt = std::mem::take(&mut self.blunt);
            self.blunt =
                blunt.into_iter().filter(|&v| v != at && (v != before && v != after || !self.is_convex(v))).collect();
            (at, refused) = (self.next[after], 0);
        }
        triangles
    }

    fn corner(&self, v: usize) -> [(f32, f32); 3] {
        [self.previous[v], v, self.next[v]].map(|v| self.outline[v])
    }

    fn is_convex(&self, v: usize) -> bool {
        let [a, b, c] = self.corner(v);
        side(a, b, c) == Ordering::Greater
    }

    /// Whether a corner is convex and no other corner is inside its triangle or on its border.
    fn is_ear(&self, v: usize) -> bool {
        let [a, b, c] = self.corner(v);
        let inside =
            |p: (f32, f32)| [(a, b), (b, c), (c, a)].iter().all(|&(from, to)| side(from, to, p) != Ordering::Less);
        let blocks = |&w: &usize| {
            let p = self.outline[w];
            p != a && p != b && p != c && inside(p)
        };
        self.is_convex(v) && !self.blunt.iter().any(blocks)
    }
}
