//! Chests: boxes with a lid that lifts.

use crate::material::*;
use crate::object::joinery::BOARD;
use crate::solid::{Build, CORNERS, at_least};

/// The design of a chest.
pub(in crate::object) struct Chest {
    /// The material of the box.
    pub(in crate::object) body: MaterialId,
    /// The material of the lid.
    pub(in crate::object) lid: MaterialId,
    /// Whether the lid is a seat cushion.
    pub(in crate::object) padded: bool,
    /// The material of the feet.
    pub(in crate::object) feet: MaterialId,
}

/// Four walls and a bottom between two corners.
pub(in crate::object) fn walls(b: &mut Build<'_>, low: [f32; 3], high: [f32; 3], t: f32, mat: MaterialId) {
    let floor = low[2] + t;
    b.block("bottom", low, [high[0], high[1], floor], mat);
    b.block("wall", [low[0], low[1], floor], [high[0], low[1] + t, high[2]], mat);
    b.block("wall", [low[0], high[1] - t, floor], high, mat);
    b.block("wall", [low[0], low[1] + t, floor], [low[0] + t, high[1] - t, high[2]], mat);
    b.block("wall", [high[0] - t, low[1] + t, floor], [high[0], high[1] - t, high[2]], mat);
}

/// Walls and bottom, and the surface inside.
pub(in crate::object) fn bin(b: &mut Build<'_>, low: [f32; 3], high: [f32; 3], t: f32, name: &str, mat: MaterialId) {
    let floor = low[2] + t;
    walls(b, low, high, t, mat);
    let half = |i: usize| ((high[i] - low[i]) / 2.0 - t - 0.003).max(0.001);
    let centre = [f32::midpoint(low[0], high[0]), f32::midpoint(low[1], high[1]), floor];
    b.inside(name, centre, (half(0), half(1)), (high[2] - floor - 0.005).max(0.005));
}

/// A chest that fills the requested size; its lid opens to the back.
pub(in crate::object) fn chest(b: &mut Build<'_>, chest: &Chest) {
    at_least(b, [0.17, 0.25, 0.17]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let lift = if chest.padded { 0.05 } else { 0.02 };
    let lid = if chest.padded { 0.06_f32.min(h * 0.2) } else { 0.03 };
    for (sx, sy) in CORNERS {
        let (cx, cy) = (sx * (x - 0.04), sy * (y - 0.04));
        b.cylinder("foot", [cx, cy, 0.0], 0.018, lift + 0.002, chest.feet);
    }
    let edge = 0.008;
    bin(b, [edge - x, edge - y, lift], [x - edge, y - edge, h - lid - 0.001], BOARD, "inside", chest.body);
    // The lid turns about its upper edge; about the lower one it would swing behind the chest.
    b.hinge([-x, 0.0, h], [0.0, -1.0, 0.0], 1.35, |b| {
        if chest.padded {
            b.rounded_block("lid", [-x, -y, h - lid], [x, y, h], 0.02, chest.lid);
        } else {
            b.rounded_block("lid", [-x, -y, h - lid], [x, y, h], 0.006, chest.lid);
        }
        b.top("lid", [0.0, 0.0, h], (x - 0.03, y - 0.03));
    });
}
