//! Moving parts: at no position inside fixed parts.

use nalgebra::Isometry3;
use vc_graph::asset::Joint;

use crate::cases::{Case, Rule};
use crate::solid::{P, Solid};

/// The margin by which fixed parts are tested smaller on every side, metres; a quarter of their
/// thickness for thin ones.
const SHRUNK: f64 = 0.005;

pub(crate) fn check(case: &Case, say: &mut dyn FnMut(Rule, String)) {
    let fixed: Vec<&Solid> = case.solids.iter().filter(|s| s.joint.is_none()).collect();
    for solid in &case.solids {
        let Some(joint) = solid.joint else { continue };
        if let Some((other, share)) = collision(solid, &joint, &fixed) {
            say(Rule::Motion, format!("{} goes into {other} when {:.0}% open", solid.name, share * 100.0));
        }
    }
}

/// The first part in the way, and the share of the motion at which it is hit.
fn collision<'a>(solid: &Solid, joint: &Joint, fixed: &[&'a Solid]) -> Option<(&'a str, f32)> {
    let samples = solid.samples();
    let inside = |p: &P, s: &Solid| s.contains_deep(p, SHRUNK.min(s.size().min() / 4.0));
    for other in fixed {
        // Points inside it from the start, such as a hinge's pin, do not count.
        let free: Vec<&P> = samples.iter().filter(|p| !inside(p, other)).collect();
        for share in [0.2_f32, 0.4, 0.6, 0.8, 1.0] {
            for limit in [joint.limits.0, joint.limits.1].into_iter().filter(|l| *l != 0.0) {
                let motion: Isometry3<f64> = joint.motion(limit * share).cast();
                if free.iter().any(|p| inside(&(motion * *p), other)) {
                    return Some((&other.name, share));
                }
            }
        }
    }
    None
}
