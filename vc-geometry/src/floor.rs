//! Floors: slabs below their tops, joined with those beside them.

use nalgebra::Vector3;
use vc_graph::asset::Hold;
use vc_graph::{Aabb, Asset, Node, ObjectRole, SceneGraph};

use crate::block::{Block, Piece, part};
use crate::opening::size;
use crate::share::own_pieces;

/// Thickness of a floor at least, metres, below its top.
const THICK: f32 = 0.15;
/// Widest gap between two floors that are joined, metres: the walls between their rooms.
const GAP: f32 = 0.5;
/// Greatest difference of height of two floors that are joined, metres.
const STEP: f32 = 0.05;
/// How long two floors must run beside each other, metres.
const BESIDE: f32 = 0.3;

/// Builds the slab of a floor, less what is its neighbours'.
pub(crate) fn build(graph: &SceneGraph, node: &Node, block: &Block, asset: &mut Asset) {
    let Some(whole) = slab(graph, node, block) else { return };
    let pieces = own_pieces(graph, node, block, whole);
    let top = |b: &Block| b.surface("floor", Hold::On, block.high.z, 0.0, None);
    asset.surfaces = match pieces.len() {
        1 => vec![top(block)],
        _ => pieces.iter().map(|&(low, high)| top(&Block { low, high, ..*block })).collect(),
    };
    asset.parts = pieces.into_iter().map(|(low, high)| part("floor", low, high)).collect();
}

/// The slab of a floor, up to the floors beside it: those of the next room begin beyond a wall.
fn slab(graph: &SceneGraph, node: &Node, block: &Block) -> Option<Piece> {
    let own = node.aabb()?;
    let others: Vec<Aabb> = graph
        .of_role(ObjectRole::Floor)
        .filter(|other| other.id() != node.id())
        .filter_map(Node::aabb)
        .filter(|other| (other.max.z - own.max.z).abs() < STEP)
        .collect();
    let mut joined = own;
    for axis in 0..2 {
        joined.min[axis] -= gap(&own, &others, axis, false);
        joined.max[axis] += gap(&own, &others, axis, true);
    }
    let (low, high) = block.local(&joined);
    let bottom = (block.high.z - THICK).min(block.low.z);
    Some((Vector3::new(low.x, low.y, bottom), Vector3::new(high.x, high.y, block.high.z)))
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
