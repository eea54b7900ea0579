//! Positions of parts on their joints.

use vc_graph::Pose;
use vc_graph::asset::{Joint, JointKind};

/// The position of a closed part: zero, or the limit nearest to it.
pub(super) fn closed(limits: (f32, f32)) -> f32 {
    0.0_f32.clamp(limits.0, limits.1.max(limits.0))
}

/// The position of an open part: the limit farther from zero.
pub(super) fn opened(limits: (f32, f32)) -> f32 {
    if limits.1.abs() >= limits.0.abs() { limits.1 } else { limits.0 }
}

pub(super) fn fraction(limits: (f32, f32), position: f32) -> f32 {
    let (shut, open) = (closed(limits), opened(limits));
    if open == shut { 0.0 } else { ((position - shut) / (open - shut)).clamp(0.0, 1.0) }
}

/// The position of a body on its joint: radians or metres.
pub(super) fn position(joint: &Joint, base: &Pose, leaf: &Pose) -> f32 {
    let relative = base.inv_mul(leaf);
    match joint.kind {
        JointKind::Slide => relative.translation.vector.dot(&joint.axis),
        JointKind::Hinge => {
            let q = relative.rotation.quaternion();
            // nalgebra's `atan2`, which gives the same result on every machine.
            let angle = 2.0 * nalgebra::RealField::atan2(q.imag().dot(&joint.axis), q.scalar());
            // Among equivalent angles, the one nearest to the limits.
            let middle = f32::midpoint(joint.limits.0, joint.limits.1);
            angle + std::f32::consts::TAU * ((middle - angle) / std::f32::consts::TAU).round()
        }
    }
}
