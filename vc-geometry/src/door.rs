//! Doors and their frames.

use nalgebra::{Point3, Vector3};
use vc_graph::asset::{Joint, JointKind, Part};

use crate::block::{Block, part};
use crate::opening::WallOpening;

/// Thickness of a leaf, metres, and the gap around it.
const LEAF: f32 = 0.04;
const AROUND: f32 = 0.01;
/// Width of a frame's posts and height of its lintel, metres.
const POST: f32 = 0.04;

/// A frame: two posts and a lintel, one walks between them.
pub(crate) fn frame(block: &Block) -> Vec<Part> {
    let size = block.size();
    let along = usize::from(size.y > size.x);
    let (low, high) = (block.low, block.high);
    let mut parts = Vec::new();
    for upper in [false, true] {
        let (mut from, mut to) = (low, high);
        if upper {
            from[along] = high[along] - POST
        } else {
            to[along] = low[along] + POST
        }
        parts.push(part("post", from, to));
    }
    parts.push(part("lintel", Vector3::new(low.x, low.y, high.z - POST), high));
    parts
}

/// A leaf on a hinge in the middle of its opening, and a lintel above that stays.
pub(crate) fn leaf(block: &Block, opening: &WallOpening) -> Vec<Part> {
    let (low, high) = block.local(&opening.clear);
    let own = block.pose.rotation.inverse() * Vector3::ith(opening.across, 1.0);
    let across = usize::from(own.y.abs() > own.x.abs());
    let along = 1 - across;
    let middle = f32::midpoint(low[across], high[across]);
    let thick = LEAF.min(high[across] - low[across]) / 2.0;
    let (mut from, mut to) = (low, high);
    (from[across], to[across]) = (middle - thick, middle + thick);
    let lintel = part("lintel", Vector3::new(from.x, from.y, high.z - POST), to);
    let gap = POST + AROUND;
    (from[along], to[along]) = (low[along] + gap, high[along] - gap);
    (from.z, to.z) = (low.z + AROUND, high.z - gap);
    let mut leaf = part("leaf", from, to);
    let mut anchor = Point3::from((from + to) / 2.0);
    anchor[along] = from[along];
    let open = std::f32::consts::FRAC_PI_2;
    leaf.joint = Some(Joint { kind: JointKind::Hinge, anchor, axis: Vector3::z(), limits: (0.0, open) });
    vec![lintel, leaf]
}
