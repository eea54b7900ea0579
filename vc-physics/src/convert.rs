//! Conversions between nalgebra, which callers use, and the engine's own vectors and poses.

use nalgebra::{Point3, UnitQuaternion, Vector3};
use rapier3d::math::{Pose as EnginePose, Vector};
use vc_graph::Pose;

pub(crate) fn pose(pose: &Pose) -> EnginePose {
    (*pose).into()
}

pub(crate) fn isometry(pose: &EnginePose) -> Pose {
    (*pose).into()
}

pub(crate) fn vector(v: Vector3<f32>) -> Vector {
    Vector::new(v.x, v.y, v.z)
}

pub(crate) fn point(p: Point3<f32>) -> Vector {
    vector(p.coords)
}

pub(crate) fn vector3(v: Vector) -> Vector3<f32> {
    Vector3::new(v.x, v.y, v.z)
}

pub(crate) fn point3(v: Vector) -> Point3<f32> {
    vector3(v).into()
}

/// The largest allowed distance from the origin, metres: there the spacing of floats is six centimetres.
pub(crate) const FARTHEST: f32 = 1e6;
/// The largest allowed size of a thing, metres.
pub(crate) const LARGEST: f32 = 1e4;

/// Whether a pose is within bounds and its quaternion has unit length.
pub(crate) fn is_sound(pose: &Pose) -> bool {
    let near = pose.translation.vector.iter().all(|v| v.abs() <= FARTHEST);
    near && (pose.rotation.coords.norm() - 1.0).abs() < 1e-3
}

/// Whether every component of a vector is finite.
pub(crate) fn is_finite(v: &Vector3<f32>) -> bool {
    v.iter().all(|c| c.is_finite())
}

/// The turn around the vertical whose X points in a direction.
pub(crate) fn facing(x: f32, y: f32) -> UnitQuaternion<f32> {
    let length = (x * x + y * y).sqrt();
    if length.is_nan() || length <= 1e-9 {
        return UnitQuaternion::identity();
    }
    // Half-angle formulas; no angle is needed.
    let cos = x / length;
    let (w, z) = (((1.0 + cos) / 2.0).max(0.0).sqrt(), ((1.0 - cos) / 2.0).max(0.0).sqrt());
    UnitQuaternion::new_normalize(nalgebra::Quaternion::new(w, 0.0, 0.0, if y < 0.0 { -z } else { z }))
}
