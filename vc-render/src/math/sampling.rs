//! Points and directions for sampling.

use std::f32::consts::PI;

use vc_graph::portable::Portable;

/// Low-discrepancy points of the unit square: a lattice from the plastic number (Roberts 2018).
pub(crate) fn low_discrepancy(index: u32) -> [f32; 2] {
    // Integers wrap around as fractional parts do.
    [3_242_174_889_u32, 2_447_445_414].map(|step| (index.wrapping_mul(step) >> 8) as f32 / (1 << 24) as f32)
}

/// A cosine-distributed direction around up (Malley's method).
pub(crate) fn cosine_weighted([a, b]: [f32; 2]) -> [f32; 3] {
    let (s, c) = (2.0 * PI * b).sine_cosine();
    let r = a.sqrt();
    [r * c, r * s, (1.0 - a).max(0.0).sqrt()]
}

/// An orthonormal frame with a given last axis (Duff and others 2017).
pub(crate) fn basis(n: [f32; 3]) -> [[f32; 3]; 3] {
    let sign = 1.0_f32.copysign(n[2]);
    let a = -1.0 / (sign + n[2]);
    let b = n[0] * n[1] * a;
    [[1.0 + sign * n[0] * n[0] * a, sign * b, -sign * n[0]], [b, sign + n[1] * n[1] * a, -n[1]], n]
}
