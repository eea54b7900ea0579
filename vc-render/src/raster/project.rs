//! Vertices to the image.

use crate::affine::Narrow;

/// Vertices of a cluster at most; a byte counts them.
pub(super) const POINTS: usize = 256;

/// Parts of a pixel that vertices are snapped to.
pub(super) const STEPS: f32 = 256.0;

/// Farthest a vertex may be from the image's corner without being clipped, pixels.
pub(super) const GUARD: f32 = 16000.0;

/// Added to a number of less than 2^22, leaves the nearest whole number in the low bits.
const ROUNDER: f32 = 12_582_912.0;

/// Vertices of a cluster in the image.
pub(super) struct Points {
    /// Snapped, in parts of a pixel.
    pub(super) x: [i32; POINTS],
    pub(super) y: [i32; POINTS],
    /// Not snapped, pixels.
    pub(super) across: [f32; POINTS],
    pub(super) down: [f32; POINTS],
    /// One over depth.
    pub(super) inverse: [f32; POINTS],
    /// Whether it is before the near plane or far outside.
    pub(super) stray: [u32; POINTS],
}

/// A vertex in the image.
#[derive(Debug, Clone, Copy)]
pub(super) struct Corner {
    pub(super) x: i32,
    pub(super) y: i32,
    pub(super) across: f32,
    pub(super) down: f32,
    pub(super) inverse: f32,
}

/// The nearest whole number of parts of a pixel; anything for what is astray, and not
/// looked at then.
#[inline(always)]
pub(super) fn snapped(pixels: f32) -> i32 {
    ((pixels * STEPS + ROUNDER).to_bits() as i32).wrapping_sub(ROUNDER.to_bits() as i32)
}

impl Points {
    pub(super) fn new() -> Self {
        let zero = [0.0; POINTS];
        Self { x: [0; POINTS], y: [0; POINTS], across: zero, down: zero, inverse: zero, stray: [0; POINTS] }
    }

    /// Takes vertices to the image; `map` leads to pixels times depth, and depth.
    /// True if some are astray.
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

    /// A triangle whose corners go around it as the y axis goes to the x axis.
    #[inline(always)]
    pub(super) fn triangle(&self, [a, b, c]: [u8; 3], mirrored: bool) -> [Corner; 3] {
        // Counter-clockwise seen from outside is clockwise with y down.
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
