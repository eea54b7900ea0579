//! Smooth paths for cameras.

use nalgebra::Point3;

/// A path with its corners cut off.
pub(super) struct Path {
    points: Vec<Point3<f32>>,
    /// Length of the path up to each point, metres.
    gone: Vec<f32>,
}

impl Path {
    pub(super) fn new(points: &[Point3<f32>]) -> Self {
        let points = (0..3).fold(points.to_vec(), |points, _| cut(&points));
        let steps = points.windows(2).map(|p| (p[1] - p[0]).norm());
        let gone = std::iter::once(0.0).chain(steps.scan(0.0, |sum, step| {
            *sum += step;
            Some(*sum)
        }));
        Self { gone: gone.take(points.len()).collect(), points }
    }

    /// Length of the path, metres; `None` if it has no points.
    pub(super) fn length(&self) -> Option<f32> {
        self.gone.last().copied()
    }

    /// The point of the path at a distance from its start, metres.
    pub(super) fn at(&self, gone: f32) -> Point3<f32> {
        let next = self.gone.partition_point(|g| *g <= gone).clamp(1, self.points.len().max(2) - 1);
        let (Some(a), Some(b)) = (self.points.get(next - 1), self.points.get(next)) else { return self.points[0] };
        let (from, to) = (self.gone[next - 1], self.gone[next]);
        let share = if to > from { ((gone - from) / (to - from)).min(1.0) } else { 0.0 };
        a + (b - a) * share
    }
}

/// Cuts corners off, a quarter of each side from either end (one step of Chaikin's algorithm).
fn cut(points: &[Point3<f32>]) -> Vec<Point3<f32>> {
    let (Some(first), [.., last]) = (points.first(), points) else { return Vec::new() };
    let quarters = points.windows(2).flat_map(|p| [0.25, 0.75].map(|share| p[0] + (p[1] - p[0]) * share));
    let ends = points.len() > 1;
    std::iter::once(*first).chain(quarters).chain(ends.then_some(*last)).collect()
}
