//! Elements of appliances and fitted units: racks, knobs, grips, displays and worktops.
//!
//! Dimensions scale with [`fit`](crate::solid::fit), so that an object smaller than usual for its class keeps its
//! proportions.

use crate::material::*;
use crate::solid::{Build, P, half_dims};

/// A level rack of bars along X between two cross bars.
pub(in crate::object) fn rack(b: &mut Build<'_>, low: P, high: P, count: usize, mat: MaterialId) {
    let w = (high[0] - low[0]).min(high[1] - low[1]) * 0.02;
    b.block("rack", low, [low[0] + w, high[1], high[2]], mat);
    b.block("rack", [high[0] - w, low[1], low[2]], high, mat);
    let step = (high[1] - low[1] - w) / count.max(2).saturating_sub(1) as f32;
    for i in 0..count.max(2) {
        let y = low[1] + step * i as f32;
        b.block("rack", [low[0] + w, y, low[2]], [high[0] - w, y + w, high[2]], mat);
    }
}

/// A knob on a plane at X, with a pointer.
pub(in crate::object) fn knob(b: &mut Build<'_>, at: P, radius: f32, depth: f32, mats: (MaterialId, MaterialId)) {
    let [x, y, z] = at;
    b.lathe_along("knob", at, [x + 1.0, y, z], &[(radius, 0.0), (radius * 0.85, depth)], mats.0);
    let w = radius * 0.12;
    b.block("pointer", [x + depth * 0.9, y - w, z], [x + depth + 0.001, y + w, z + radius * 0.8], mats.1);
}

/// A row of knobs across a plane at X.
pub(in crate::object) fn knobs(
    b: &mut Build<'_>,
    at: P,
    span: f32,
    count: usize,
    radius: f32,
    mats: (MaterialId, MaterialId),
) {
    for i in 0..count {
        let y = at[1] + span * ((i as f32 + 0.5) / count as f32 - 0.5);
        knob(b, [at[0], y, at[2]], radius, (radius * 0.9).min(0.025), mats);
    }
}

/// A handle bar on two posts, level or upright, protruding by `depth` from a plane at X.
pub(in crate::object) fn grab(b: &mut Build<'_>, at: P, length: f32, upright: bool, depth: f32, mat: MaterialId) {
    let half = length / 2.0;
    let end = |k: f32, out: f32| {
        let along = half * k;
        [at[0] + out, at[1] + if upright { 0.0 } else { along }, at[2] + if upright { along } else { 0.0 }]
    };
    let r = depth * 0.22;
    for k in [-0.85, 0.85] {
        b.rod("handle", end(k, -r * 0.2), end(k, depth - r), r * 0.7, mat);
    }
    b.rod("handle", end(-1.0, depth - r), end(1.0, depth - r), r, mat);
}

/// A dark display with lit digits on a plane at X.
pub(in crate::object) fn display(b: &mut Build<'_>, x: f32, low: (f32, f32), high: (f32, f32), light: MaterialId) {
    b.block("display", [x - 0.001, low.0, low.1], [x + 0.0015, high.0, high.1], SCREEN);
    let (w, h) = (high.0 - low.0, high.1 - low.1);
    for i in 0..3 {
        let y = low.0 + w * (0.28 + 0.16 * i as f32);
        let (z0, z1) = (low.1 + h * 0.3, low.1 + h * 0.7);
        b.block("figure", [x, y, z0], [x + 0.0025, y + w * 0.09, z1], light);
    }
}

/// The distance of the front plane of doors and panels in a kitchen run behind the edge: handles
/// must not protrude beyond the worktop.
pub(in crate::object) const RUN: f32 = 0.03;

/// A worktop of the style, with its top at the full height and over the whole depth and width;
/// returns the height below it.
pub(in crate::object) fn worktop(b: &mut Build<'_>, u: f32) -> f32 {
    let (x, y, h) = half_dims(b);
    let t = 0.035 * u;
    b.block("worktop", [-x, -y, h - t], [x, y, h], b.style.worktop);
    b.top("worktop", [0.0, 0.0, h], (x - 0.01 * u, y - 0.005 * u));
    h - t
}

/// Whether it has the height of a kitchen run.
pub(in crate::object) fn in_run(b: &Build<'_>) -> bool {
    (0.88..=0.97).contains(&b.size.z)
}

/// Adds a worktop to an appliance with the height of a kitchen run; returns the height below it.
pub(in crate::object) fn under_worktop(b: &mut Build<'_>, u: f32) -> f32 {
    if in_run(b) { worktop(b, u) } else { b.size.z }
}
