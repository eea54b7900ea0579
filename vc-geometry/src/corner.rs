//! Furniture around a corner: its box is also around the other things that stand in the corner.

use nalgebra::{Vector2, Vector3};
use vc_graph::{Node, NodeId, NodeKind, Property, SceneGraph};

use crate::block::Block;

/// How many times deeper than its class's typical size the box around a corner piece is at least.
const DEEPER: f32 = 1.6;
/// Depth of an arm at most, as a part of the box's side.
const ARM: f32 = 0.4;
/// How far from the height of a piece's bottom other furniture on the floor may begin, metres.
const LOW: f32 = 0.25;

/// How far from the walls a seat in a corner of its room is at most, metres.
const BESIDE_WALL: f32 = 0.4;

/// The blocks that a piece of furniture fills: its box, or two arms, if the box is much deeper than the
/// class's typical size and other furniture stands in it; the arms leave out the corner of that
/// furniture. A seat as deep as that, in a corner of its room, also gets two arms, along the walls.
pub(crate) fn arms(graph: &SceneGraph, node: &Node, block: &Block) -> Vec<Block> {
    let depth = graph.classes().get(node.class()).and_then(|c| c.typical_size()).map(|s| s.x);
    let size = block.size();
    let Some(depth) = depth.filter(|d| size.x.min(size.y) > DEEPER * d) else { return vec![*block] };
    let missing = furniture_within(graph, node, block).or_else(|| across_corner(graph, node, block));
    let Some(within) = missing.filter(|_| size.z > LOW) else { return vec![*block] };
    let depth = depth.min(ARM * size.x.min(size.y));
    let middle = ((block.low + block.high) / 2.0).xy();
    let upper = [within.x > middle.x, within.y > middle.y];
    let arm = |axis: usize| {
        // Along the side across from the missing corner.
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

/// The corner of a seat's box that is across from the corner of the room which it stands in.
fn across_corner(graph: &SceneGraph, node: &Node, block: &Block) -> Option<Vector2<f32>> {
    let room = graph.node(graph.room_of(node.id())?)?.aabb().filter(|_| node.affords(Property::Sittable))?;
    let (low, high) = block.local(&room);
    let side = |i: usize| match (block.low[i] - low[i] < BESIDE_WALL, high[i] - block.high[i] < BESIDE_WALL) {
        (true, false) => Some(block.high[i]),
        (false, true) => Some(block.low[i]),
        _ => None,
    };
    Some(Vector2::new(side(0)?, side(1)?))
}

/// The middle of the other furniture that stands in a block, if any does.
fn furniture_within(graph: &SceneGraph, node: &Node, block: &Block) -> Option<Vector2<f32>> {
    let room = graph.room_of(node.id())?;
    let stands = |id: NodeId| {
        let other = graph.node(id).filter(|n| n.kind() == NodeKind::Object && n.id() != node.id())?;
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
