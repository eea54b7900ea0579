//! Furniture around a corner: its box is around the corner, and around what stands there.

use nalgebra::{Vector2, Vector3};
use vc_graph::{Kind, Node, NodeId, Property, SceneGraph};

use crate::block::Block;

/// How much deeper than its class a box is that may be around a corner piece.
const DEEPER: f32 = 1.6;
/// Depth of an arm at most, as a part of the box's side.
const ARM: f32 = 0.4;
/// How high above a piece's bottom what stands beside it may begin, metres.
const LOW: f32 = 0.25;

/// The blocks that a piece of furniture fills: its box, or, where other furniture stands within the
/// box and it is much deeper than its class is, two arms without the corner in which that stands.
pub(crate) fn arms(graph: &SceneGraph, node: &Node, block: &Block) -> Vec<Block> {
    let depth = graph.classes().get(node.class()).and_then(|c| c.typical_size()).map(|s| s.x);
    let size = block.size();
    let Some(depth) = depth.filter(|d| size.x.min(size.y) > DEEPER * d) else { return vec![*block] };
    let Some(within) = furniture_within(graph, node, block) else { return vec![*block] };
    let depth = depth.min(ARM * size.x.min(size.y));
    let middle = ((block.low + block.high) / 2.0).xy();
    let upper = [within.x > middle.x, within.y > middle.y];
    let arm = |axis: usize| {
        // Along the side across from what stands there.
        let mut arm = *block;
        if upper[axis] {
            arm.high[axis] = arm.low[axis] + depth
        } else {
            arm.low[axis] = arm.high[axis] - depth
        }
        arm
    };
    let (one, mut other) = (arm(0), arm(1));
    if upper[0] {
        other.low.x = one.high.x
    } else {
        other.high.x = one.low.x
    }
    vec![one, other]
}

/// The middle of the other furniture that stands in a block, if any does.
fn furniture_within(graph: &SceneGraph, node: &Node, block: &Block) -> Option<Vector2<f32>> {
    let room = graph.room_of(node.id())?;
    let stands = |id: NodeId| {
        let other = graph.node(id).filter(|n| n.kind() == Kind::Object && n.id() != node.id())?;
        let flat = other.affords(Property::Graspable) || other.affords(Property::Cover);
        let (low, high) = block.local(&other.aabb().filter(|_| !flat)?);
        let (centre, size): (Vector3<f32>, _) = ((low + high) / 2.0, high - low);
        let over = |i: usize| (block.low[i]..=block.high[i]).contains(&centre[i]) && size[i] < block.size()[i] / 2.0;
        let on_floor = (block.low.z - LOW..block.low.z + LOW).contains(&low.z) && size.z > LOW;
        (on_floor && over(0) && over(1)).then(|| centre.xy())
    };
    let all: Vec<Vector2<f32>> = graph.in_room(room).filter_map(stands).collect();
    (!all.is_empty()).then(|| all.iter().sum::<Vector2<f32>>() / all.len() as f32)
}
