//! Projection of vertices into the image.

use crate::math::Narrow;

/// Greatest number of vertices of a cluster: a byte indexes them.
pub(super) const POINTS: usize = 256;

/// Subpixel units in a pixel, to which vertices are snapped.
pub(super) const STEPS: f32 = 256.0;

/// Guard band: greatest distance of an unclipped vertex from the image's corner, pixels.
pub(super) const GUARD: f32 = 16000.0;

/// Added to a number of magnitude below 2^22, leaves the nearest integer in the low bits.
const ROUNDER: f32 = 12_582_912.0;

/// Projected vertices of a cluster.
pub(super) struct Points {
    /// Snapped, in subpixel units.
    pub(super) x: [i32; POINTS],
    pub(super) y: [i32; POINTS],
    /// Unsnapped, pixels.
    pub(super) across: [f32; POINTS],
    pub(super) down: [f32; POINTS],
    /// Inverse depth.
    pub(super) inverse: [f32; POINTS],
    /// Whether a vertex needs clipping: it is before the near plane or beyond the guard band.
    pub(super) stray: [u32; POINTS],
}

/// A projected vertex.
#[derive(Debug, Clone, Copy)]
pub(super) struct Corner {
    pub(super) x: i32,
    pub(super) y: i32,
    pub(super) across: f32,
    pub(super) down: f32,
    pub(super) inverse: f32,
}

/// The nearest integer number of subpixel units. Arbitrary for vertices that need clipping, where it is not
/// used.
#[inline(always)]
pub(super) fn snapped(pixels: f32) -> i32 {
    ((pixels * STEPS + ROUNDER).to_bits() as i32).wrapping_sub(ROUNDER.to_bits() as i32)
}

impl Points {
    pub(super) fn new() -> Self {
        let zero = [0.0; POINTS];
        Self { x: [0; POINTS], y: [0; POINTS], across: zero, down: zero, inverse: zero, stray: [0; POINTS] }
    }

    /// Projects vertices; `map` leads to pixels times depth, and depth. True if some need clipping.
    #[inline(always)]
    pub(super) fn project(&mut self, [xs, ys, zs]: [&[f32]; 3], map: &Narrow, near: f32) -> bool {
        let count = xs.len().min(ys.len()).min(zs.len()).min(POINTS);
        let mut any = 0;
        for i in 0..count {
            let p = [xs[i], ys[i], zs[i]];
            let row = |r: usize| map[r][0] * p[0] + map[r][1] * p[1] + map[r][2] * p[2] + map[r][3];
            let inverse = 1.0 / row(2);
            let (across, down) = (row(0) * inverse, row(1) * inverse);
            let inside = (row(2) >= near) & (across.abs() < GUARD) & (down.abs() < GUARD);
            self.across[i] = across;
            self.down[i] = down;
            self.inverse[i] = inverse;
            self.x[i] = snapped(across);
            self.y[i] = snapped(down);
            self.stray[i] = u32::from(!inside);
            any |= u32::from(!inside);
        }
        any != 0
    }

    /// A triangle wound from the x axis towards the y axis.
    #[inline(always)]
    pub(super) fn triangle(&self, [a, b, c]: [u8; 3], mirrored: bool) -> [Corner; 3] {
        // Counter-clockwise seen from outside becomes clockwise with y down.
        if mirrored {
            [self.corner(a), self.corner(b), self.corner(c)]
        } else {
            [self.corner(a), self.corner(c), self.corner(b)]
        }
    }

    #[inline(always)]
    fn corner(&self, at: u8) -> Corner {
        let i = usize::from(at);
        Corner { x: self.x[i], y: self.y[i], across: self.across[i], down: self.down[i], inverse: self.inverse[i] }
    }
}
