//! Holders of paper on the wall, and curtains before the bath.

use crate::material::*;
use crate::object::structure::pleated;
use crate::solid::{Axis, Build, fit, half_dims};

/// The height of a roll's top above the arm through its core, metres.
const ROLL: f32 = 0.056;

/// An arm through the roll, on a plate that bends forwards to a lid.
pub(super) fn toilet_roll_holder(b: &mut Build<'_>) {
    let u = fit(b, [0.06, 0.12, 0.09]);
    let (x, y, h) = half_dims(b);
    let metal = b.choose(&[b.style.tap, b.style.tap, BLACK_METAL, STEEL]);
    let (r, t) = (0.005 * u, 0.005 * u);
    let wide = y * b.vary(0.5, 0.9);
    b.rounded_block("plate", [-x, -wide, 0.0], [-x + t, wide, h - t * 0.4], t * 0.3, metal);
    b.rounded_block("lid", [-x + t * 0.4, -y, h - t], [x, y, h], t * 0.3, metal);
    b.top("lid", [0.0, 0.0, h], (x * 0.7, y * 0.8));
    let (out, z, side) = (x - 3.0 * r, h * 0.36, -y + 2.0 * r);
    // From the plate to the front, and along the roll.
    b.bar("arm", [-x + 1.1 * r, r - wide, z], [out, side, z], r, metal);
    b.bar("arm", [out, side, z], [out, y - 2.0 * r, z], r, metal);
    b.ball("end", [out, y - 2.0 * r, z], 1.6 * r, metal);
    // Beside the arm: the core of a roll is wider.
    b.hook("arm", [out - 0.011 * u, 2.0 * r, (z + ROLL).min(h - 1.5 * t)], ROLL * 2.4);
}

/// A rail under the ceiling with a curtain that is drawn to one end.
pub(super) fn shower_curtain(b: &mut Build<'_>) {
    let u = fit(b, [0.04, 0.5, 0.6]);
    let (x, y, h) = half_dims(b);
    let cloth = b.choose(&[WHITE_COTTON, b.style.towel, b.style.curtain, b.style.accent, WHITE_COTTON]);
    let rail = 0.022 * u;
    b.block("rail", [-0.012 * u, -y, h - rail], [0.012 * u, y, h], b.style.tap);
    let (half, side) = (y * b.vary(0.2, 0.36), b.choose(&[-1.0, 1.0]));
    let count = (half / 0.035).round().clamp(3.0, 11.0) as usize;
    let outline = pleated(half, x, (0.003 * u).min(x * 0.3), count);
    b.prism("cloth", Axis::Z, [0.0, side * (y - half - 0.001), 0.0], &outline, h - rail + 0.002, cloth);
}
