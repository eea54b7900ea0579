//! Bounding boxes and bounding spheres.

use super::{Affine, Narrow, point, three};

/// A box, by its centre and half its lengths.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Bounds {
    pub(crate) centre: [f32; 3],
    pub(crate) half: [f32; 3],
}

/// A bounding sphere in the world.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Ball {
    pub(crate) middle: [f32; 3],
    pub(crate) radius: f32,
}

impl Bounds {
    /// The bounding box of points; for no points, an empty box at the origin.
    pub(crate) fn around(points: impl Iterator<Item = [f32; 3]>) -> Self {
        let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
        for p in points {
            low = [0, 1, 2].map(|i: usize| low[i].min(p[i]));
            high = [0, 1, 2].map(|i: usize| high[i].max(p[i]));
        }
        if low[0] > high[0] {
            return Self::default();
        }
        let half = [0, 1, 2].map(|i: usize| 0.5 * (high[i] - low[i]));
        Self { centre: [0, 1, 2].map(|i: usize| low[i] + half[i]), half }
    }

    /// The bounding sphere of the mapped box.
    pub(crate) fn ball(&self, world: &Affine) -> Ball {
        let middle = world.point(self.centre.map(f64::from)).map(|v| v as f32);
        let side = |c: usize| three(|r| world.0[r][c] as f32 * self.half[c]);
        let (a, b, c) = (side(0), side(1), side(2));
        let corner = |s: f32, t: f32| three(|i| a[i] + s * b[i] + t * c[i]);
        let corners = [corner(1.0, 1.0), corner(1.0, -1.0), corner(-1.0, 1.0), corner(-1.0, -1.0)];
        let square = corners.map(|v| v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).into_iter().fold(0.0, f32::max);
        Ball { middle, radius: square.sqrt() }
    }

    /// The bounding box of two boxes.
    pub(crate) fn joined(&self, other: &Self) -> Self {
        let corners = |b: &Self| [-1.0, 1.0].map(|s| [0, 1, 2].map(|i: usize| b.centre[i] + s * b.half[i]));
        Self::around(corners(self).into_iter().chain(corners(other)))
    }

    /// The bounding box of the mapped box.
    pub(crate) fn mapped(&self, map: &Narrow) -> Self {
        let half = [0, 1, 2].map(|r: usize| (0..3).map(|c| map[r][c].abs() * self.half[c]).sum());
        Self { centre: point(map, self.centre), half }
    }
}
