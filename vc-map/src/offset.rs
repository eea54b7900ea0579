//! Lines beside lines: lanes beside the middle of a road.

use crate::polyline::normal;
use crate::{Point, Polyline};

/// An offset corner lies at most this many times the offset from the line's own.
const LONGEST_MITRE: f64 = 2.0;

impl Polyline {
    /// The line at a distance to the left, metres; to the right if it is negative. Corners are mitred, by at most twice
    /// the distance; a bend that is tighter than the distance becomes a corner on its inside.
    #[must_use]
    pub fn offset(&self, left: f64) -> Self {
        let pieces = self.points().len() - 1;
        let beside = |point: usize, piece: usize| self.points()[point] + normal(self.along(piece)) * left;
        // The pieces that keep some length, each with the point at which it begins.
        let mut kept = vec![(0, beside(0, 0))];
        for piece in 1..pieces {
            loop {
                let (before, begin) = kept[kept.len() - 1];
                let corner = self.corner(before, piece, left);
                if (corner - begin).dot(&self.along(before)) > 0.0 {
                    kept.push((piece, corner));
                    break;
                }
                // The piece before has no length left: this one follows that before it, or begins the line.
                if kept.len() == 1 {
                    kept[0].0 = piece;
                    break;
                }
                kept.pop();
            }
        }
        let end = beside(pieces, pieces - 1);
        while let [_, .., (piece, begin)] = kept[..] {
            if (end - begin).dot(&self.along(piece)) > 0.0 {
                break;
            }
            kept.pop();
        }
        let points = kept.into_iter().map(|(_, begin)| begin).chain([end]);
        Self::new(points).unwrap_or_else(|| self.clone())
    }

    /// The point at which two pieces meet that lie beside the line.
    fn corner(&self, before: usize, after: usize, left: f64) -> Point {
        let (one, two) = (self.along(before), self.along(after));
        if after == before + 1 {
            let mean = normal(one) + normal(two);
            let mean = if mean.norm() < 1e-6 { normal(two) } else { mean.normalize() };
            return self.points()[after] + mean * (left / mean.dot(&normal(two)).max(1.0 / LONGEST_MITRE));
        }
        let (end, start) = (self.points()[before + 1] + normal(one) * left, self.points()[after] + normal(two) * left);
        let turn = one.perp(&two);
        // Pieces that are nearly parallel are joined half-way.
        if turn.abs() < 0.05 { nalgebra::center(&end, &start) } else { end + one * ((start - end).perp(&two) / turn) }
    }
}
