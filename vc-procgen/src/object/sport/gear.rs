use super::super::build::{Axis, Build};
use super::super::play::kit::*;
use crate::material::*;

/// A boot that stands on its sole at a height, toe to the front.
pub(in crate::object) fn boot(b: &mut Build<'_>, sole: f32, mat: Mat, trim: Mat) {
    let ring = |x: f32, y: f32, low: f32, high: f32| ([x, 0.0, (low + high) / 2.0], y, (high - low) / 2.0);
    let foot = [
        ([-0.98, 0.0, sole + 0.12], 0.0, 0.0),
        ring(-0.85, 0.7, sole, sole + 0.3),
        ring(-0.3, 0.8, sole, sole + 0.38),
        ring(0.3, 0.95, sole, sole + 0.3),
        ring(0.75, 0.9, sole, sole + 0.24),
        ([0.99, 0.0, sole + 0.08], 0.0, 0.0),
    ];
    b.skin("boot", Axis::X, &foot, mat);
    let shaft =
        [([-0.38, 0.0, sole + 0.16], 0.5, 0.7), ([-0.42, 0.0, sole + 0.4], 0.46, 0.66), ([-0.42, 0.0, 0.99], 0.5, 0.8)];
    b.skin("shaft", Axis::Z, &shaft, mat);
    b.slab("sole", [-0.9, -0.6, sole - 0.02], [0.9, 0.6, sole + 0.05], trim);
    for i in 0..3 {
        let (x, z) = (0.12 - 0.1 * i as f32, sole + 0.3 + 0.14 * i as f32);
        b.slab("buckle", [x - 0.2, -0.5, z], [x, 0.5, z + 0.05], trim);
    }
}
