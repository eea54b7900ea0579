//! Affine maps of space.

use nalgebra::{Isometry3, Vector3};

use super::three;

/// A linear map and a translation, as rows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Affine(pub(crate) [[f64; 4]; 3]);

/// An affine map in single precision, for inner loops.
pub(crate) type Narrow = [[f32; 4]; 3];

impl Affine {
    pub(crate) const IDENTITY: Self = Self([[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]]);

    /// The map that first scales along the node's own axes, then rotates and translates.
    pub(crate) fn placed(pose: &Isometry3<f32>, scale: &Vector3<f32>) -> Self {
        let pose = pose.cast::<f64>();
        let turn = pose.rotation.to_rotation_matrix();
        let row = |r: usize| {
            let cell = |c: usize| turn[(r, c)] * f64::from(scale[c]);
            [cell(0), cell(1), cell(2), pose.translation.vector[r]]
        };
        Self([row(0), row(1), row(2)])
    }

    /// The map of a pose alone.
    pub(crate) fn from_pose(pose: &Isometry3<f32>) -> Self {
        Self::placed(pose, &Vector3::repeat(1.0))
    }

    /// Scales everything towards a point, which stays fixed.
    pub(crate) fn shrunk(to: [f64; 3], by: f64) -> Self {
        let row = |r: usize| {
            let mut row = [0.0; 4];
            row[r] = by;
            row[3] = to[r] * (1.0 - by);
            row
        };
        Self([row(0), row(1), row(2)])
    }

    /// The composition: first `first`, then this.
    pub(crate) fn after(&self, first: &Self) -> Self {
        let row = |r: usize| {
            let own = &self.0[r];
            let cell = |c: usize| (0..3).map(|k| own[k] * first.0[k][c]).sum::<f64>();
            [cell(0), cell(1), cell(2), cell(3) + own[3]]
        };
        Self([row(0), row(1), row(2)])
    }

    /// Maps a point.
    pub(crate) fn point(&self, p: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|r: usize| {
            let row = &self.0[r];
            row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3]
        })
    }

    pub(crate) fn determinant(&self) -> f64 {
        let [a, b, c] = self.0;
        a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
    }

    /// The inverse map; none where the map is singular.
    pub(crate) fn inverse(&self) -> Option<Self> {
        let determinant = self.determinant();
        if !determinant.is_normal() {
            return None;
        }
        let m = &self.0;
        let minor = |r: usize, c: usize| {
            let (r1, r2, c1, c2) = ((r + 1) % 3, (r + 2) % 3, (c + 1) % 3, (c + 2) % 3);
            (m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1]) / determinant
        };
        let row = |r: usize| {
            let linear = [minor(0, r), minor(1, r), minor(2, r)];
            let shift = -(0..3).map(|k| linear[k] * m[k][3]).sum::<f64>();
            [linear[0], linear[1], linear[2], shift]
        };
        Some(Self([row(0), row(1), row(2)]))
    }

    pub(crate) fn narrow(&self) -> Narrow {
        three(|r| {
            let row = &self.0[r];
            [row[0] as f32, row[1] as f32, row[2] as f32, row[3] as f32]
        })
    }

    pub(crate) fn is_finite(&self) -> bool {
        // Small enough for single precision, squares included.
        self.0.iter().flatten().all(|v| v.abs() < 1e15)
    }
}

/// The composition of two maps: first `first`, then `then`.
pub(crate) fn composed(then: &Narrow, first: &Narrow) -> Narrow {
    let row = |r: usize| {
        let cell = |c: usize| (0..3).map(|k| then[r][k] * first[k][c]).sum::<f32>();
        [cell(0), cell(1), cell(2), cell(3) + then[r][3]]
    };
    [row(0), row(1), row(2)]
}

/// Maps a point.
#[inline(always)]
pub(crate) fn point(m: &Narrow, p: [f32; 3]) -> [f32; 3] {
    three(
        #[inline(always)]
        |r| m[r][0] * p[0] + m[r][1] * p[1] + m[r][2] * p[2] + m[r][3],
    )
}

/// Maps a direction.
#[inline(always)]
pub(crate) fn vector(m: &Narrow, v: [f32; 3]) -> [f32; 3] {
    three(
        #[inline(always)]
        |r| m[r][0] * v[0] + m[r][1] * v[1] + m[r][2] * v[2],
    )
}

/// Maps a normal, given the inverse of the map; the result is not of unit length.
#[inline(always)]
pub(crate) fn normal(inverse: &Narrow, n: [f32; 3]) -> [f32; 3] {
    three(
        #[inline(always)]
        |c| inverse[0][c] * n[0] + inverse[1][c] * n[1] + inverse[2][c] * n[2],
    )
}
