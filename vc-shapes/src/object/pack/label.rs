//! Labels: raised bands and panels with bars of colour.

use std::f32::consts::TAU;

use vc_graph::portable::Portable;

use crate::material::MaterialId;
use crate::solid::{Axis, Build, flat_ring};

/// The protrusion of a panel, metres.
const RAISED: f32 = 0.0007;

/// The protrusions of a band around a body and of a print on it: more than the protrusion of a
/// round body's corners over its sides.
const BAND: f32 = 0.001;
const PRINT: f32 = 0.0012;

/// The most that a label adds to a radius, metres.
pub(in crate::object) const GROWTH: f32 = BAND + PRINT;

/// A band around a round body of radius `r` with bars on its front; it protrudes by less than 2.3
/// mm.
pub(in crate::object) fn wrap(
    b: &mut Build<'_>,
    r: f32,
    (low, high): (f32, f32),
    (paper, ink): (MaterialId, MaterialId),
) {
    let tall = high - low;
    let band = r + BAND.min(r * 0.05);
    flat_ring(b, "label", (low, high), (r * 0.97, band), paper);
    if r < 0.008 {
        return;
    }
    let out = band + PRINT.min(r * 0.05);
    for (from, to, turn) in [(0.62, 0.84, 0.15), (0.42, 0.5, 0.11), (0.12, 0.3, 0.08)] {
        patch(b, (band * 0.97, out), turn * TAU, (low + tall * from, low + tall * to), ink);
    }
}

/// A piece of a ring on the front, `angle` to either side.
fn patch(b: &mut Build<'_>, (inner, outer): (f32, f32), angle: f32, (low, high): (f32, f32), mat: MaterialId) {
    let at = |r: f32, k: usize| {
        let (s, c) = (angle * (k as f32 / 5.0 - 1.0)).sine_cosine();
        (r * c, r * s)
    };
    let outline: Vec<_> = (0..=10).map(|k| at(outer, k)).chain((0..=10).rev().map(|k| at(inner, k))).collect();
    b.prism("print", Axis::Z, [0.0, 0.0, low], &outline, high - low, mat);
}

/// A panel with bars on a flat front at `x`, from `y.0 - y.1` to `y.0 + y.1`; it protrudes by 1.4
/// mm.
pub(in crate::object) fn panel(
    b: &mut Build<'_>,
    x: f32,
    y: (f32, f32),
    z: (f32, f32),
    (paper, ink): (MaterialId, MaterialId),
) {
    let ((mid, half), tall) = (y, z.1 - z.0);
    b.block("label", [x - RAISED, mid - half, z.0], [x + RAISED, mid + half, z.1], paper);
    for (from, to, wide) in [(0.66, 0.86, 0.8), (0.48, 0.56, 0.6), (0.12, 0.36, 0.45)] {
        let (w, low, high) = (half * wide, z.0 + tall * from, z.0 + tall * to);
        b.block("print", [x, mid - w, low], [x + 2.0 * RAISED, mid + w, high], ink);
    }
}
