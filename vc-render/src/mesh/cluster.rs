//! Clusters: groups of nearby triangles, culled and transformed together.

use std::ops::Range;

use crate::math::Bounds;

/// Up to [`MOST`](super::MOST) triangles with their own vertices.
#[derive(Debug, Clone)]
pub(crate) struct Cluster {
    /// Its vertices in the mesh's lists.
    pub(crate) vertices: Range<u32>,
    /// Its triangles in the mesh's lists.
    pub(crate) triangles: Range<u32>,
    /// Its bounding box.
    pub(crate) bounds: Bounds,
    /// Axis of the cone that contains all its normals.
    pub(crate) axis: [f32; 3],
    /// Sine of half the angle of that cone; above one if no cone contains them.
    pub(crate) spread: f32,
}

/// Axis of a cone around unit vectors, and the sine of half its angle (2 if it is not narrower than a half
/// space).
pub(super) fn cone(normals: &[[f32; 3]]) -> ([f32; 3], f32) {
    let sum = normals.iter().fold([0.0_f32; 3], |s, n| [s[0] + n[0], s[1] + n[1], s[2] + n[2]]);
    let length = (sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]).sqrt();
    if length < 1e-3 {
        return ([0.0; 3], 2.0);
    }
    let axis = sum.map(|v| v / length);
    let along = |n: &[f32; 3]| n[0] * axis[0] + n[1] * axis[1] + n[2] * axis[2];
    let least = normals.iter().map(along).fold(1.0_f32, f32::min);
    // The cone is widened a little to allow for rounding.
    if least <= 0.01 { (axis, 2.0) } else { (axis, (1.0 - least * least).max(0.0).sqrt() + 1e-3) }
}
