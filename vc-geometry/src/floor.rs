//! Floors: slabs below their tops, joined with those beside them.

use nalgebra::Vector3;
use vc_graph::asset::Part;
use vc_graph::{Aabb, Node, SceneGraph};

use crate::block::{Block, part};
use crate::opening::size;

/// Thickness of a floor at least, metres, below its top.
const THICK: f32 = 0.15;
/// Widest gap between two floors that are joined, metres: the walls between their rooms.
const GAP: f32 = 0.5;
/// Greatest difference of height of two floors that are joined, metres.
const STEP: f32 = 0.05;
/// How long two floors must run beside each other, metres.
const BESIDE: f32 = 0.3;

/// The slab of a floor, up to the floors beside it: those of the next room begin beyond a wall.
pub(crate) fn parts(graph: &SceneGraph, node: &Node, block: &Block) -> Vec<Part> {
    let Some(own) = node.aabb() else { return Vec::new() };
    let others: Vec<Aabb> = graph
        .of_class("floor")
        .into_iter()
        .filter(|id| *id != node.id())
        .filter_map(|id| graph.node(id)?.aabb())
        .filter(|other| (other.max.z - own.max.z).abs() < STEP)
        .collect();
    let mut joined = own;
    for axis in 0..2 {
        joined.min[axis] -= gap(&own, &others, axis, false);
        joined.max[axis] += gap(&own, &others, axis, true);
    }
    let (low, high) = block.local(&joined);
    let bottom = (block.high.z - THICK).min(block.low.z);
    let (low, high) = (Vector3::new(low.x, low.y, bottom), Vector3::new(high.x, high.y, block.high.z));
    vec![part("floor", low, high)]
}

/// The least gap to a floor beside one, if it is narrow, else none.
fn gap(own: &Aabb, others: &[Aabb], axis: usize, upper: bool) -> f32 {
    let beside = |other: &&Aabb| {
        let along = 1 - axis;
        let shared = own.max[along].min(other.max[along]) - own.min[along].max(other.min[along]);
        shared >= BESIDE.min(size(own, along) / 2.0)
    };
    let far = |other: &Aabb| if upper { other.min[axis] - own.max[axis] } else { own.min[axis] - other.max[axis] };
    let gaps = others.iter().filter(beside).map(far).filter(|gap| *gap > 0.0 && *gap <= GAP);
    gaps.reduce(f32::min).unwrap_or(0.0)
}
