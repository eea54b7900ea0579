//! Ambient light from all directions at a point.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

use crate::math::{scaled, three};

/// Irradiance on surfaces that face along the six axis directions, after Valve's ambient cube (McTaggart 2004):
/// a surface that faces a wall with a window gets none of the window's light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Ambient(pub(super) [f32; SIDES]);

/// Four numbers (three colours and their brightness) for each of +X, +Y, +Z, -X, -Y and -Z.
pub(super) const SIDES: usize = 24;

impl Default for Ambient {
    fn default() -> Self {
        Self([0.0; SIDES])
    }
}

impl Ambient {
    /// The marker for points inside of things, whose light is unknown.
    pub(super) const UNKNOWN: Self = Self([f32::NAN; SIDES]);

    /// Radiance from above, with less of it from each side, so that the shapes of things of one colour remain
    /// visible.
    pub(super) fn from_above(radiance: f32) -> Self {
        const SHARES: [f32; 6] = [0.8, 0.55, 1.0, 0.4, 0.65, 0.5];
        Self(std::array::from_fn(|i| std::f32::consts::PI * radiance * SHARES[i / 4]))
    }

    pub(super) fn is_known(&self) -> bool {
        !self.0[0].is_nan()
    }

    /// Adds light from a direction, given as the irradiance on a surface that faces it.
    pub(super) fn add(&mut self, towards: [f32; 3], light: [f32; 3]) {
        for axis in 0..3 {
            let side = axis + if towards[axis] < 0.0 { 3 } else { 0 };
            let [red, green, blue] = light;
            for (sum, light) in self.0[4 * side..].iter_mut().zip([red, green, blue, crate::colour::luminance(light)]) {
                *sum += towards[axis].abs() * light;
            }
        }
    }

    /// Adds a share of another ambient light.
    #[inline(always)]
    pub(super) fn mix(&mut self, other: &Self, share: f32) {
        for (sum, value) in self.0.iter_mut().zip(&other.0) {
            *sum += share * value;
        }
    }

    /// A share of it.
    pub(super) fn times(&self, share: f32) -> Self {
        let mut less = Self::default();
        less.mix(self, share);
        less
    }

    /// Irradiance on a surface with this normal.
    #[inline(always)]
    pub(crate) fn falls(&self, normal: [f32; 3]) -> [f32; 3] {
        let mut sum = [0.0_f32; 4];
        for axis in 0..3 {
            let n = normal[axis];
            let side = 4 * (axis + if n < 0.0 { 3 } else { 0 });
            for (sum, value) in sum.iter_mut().zip(&self.0[side..side + 4]) {
                *sum += n * n * value;
            }
        }
        [sum[0], sum[1], sum[2]]
    }

    /// Blurred radiance from around a direction.
    #[inline(always)]
    pub(crate) fn sheen(&self, towards: [f32; 3]) -> [f32; 3] {
        scaled(self.falls(towards), 1.0 / std::f32::consts::PI)
    }

    /// Difference of brightness between opposite axis directions: how much more light falls on a surface that
    /// faces along each axis than on one that faces the other way.
    #[inline(always)]
    pub(crate) fn lean(&self) -> [f32; 3] {
        three(|axis| 0.5 * (self.0[4 * axis + 3] - self.0[4 * axis + 15]))
    }

    /// Mean radiance in each colour.
    pub(super) fn colour(&self) -> [f32; 3] {
        three(|c| self.0.chunks(4).map(|side| side[c]).sum::<f32>() / (6.0 * std::f32::consts::PI))
    }

    /// Mean radiance.
    pub(super) fn mean(&self) -> f32 {
        self.0.chunks(4).map(|side| side[3]).sum::<f32>() / (6.0 * std::f32::consts::PI)
    }
}
