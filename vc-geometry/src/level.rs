//! The heights at which things stand on and in a thing.

use vc_graph::{Node, NodeId, Relation, SceneGraph};

use crate::block::Block;

/// Things whose bottoms differ less stand on one level, metres.
const SAME: f32 = 0.03;

/// A thing at another, by the heights of its bottom and top in the other's frame, metres.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Load {
    pub(crate) bottom: f32,
    pub(crate) top: f32,
    pub(crate) inside: bool,
    /// How far it is from the sides of the other at least, metres.
    pub(crate) margin: f32,
}

/// The things that the graph has on and in a node, from below.
pub(crate) fn loads(graph: &SceneGraph, node: &Node, block: &Block) -> Vec<Load> {
    let of = |inside: bool| {
        let relation = if inside { Relation::Inside } else { Relation::On };
        let load = move |id: NodeId| {
            let aabb = graph.node(id)?.aabb()?;
            let (low, high) = block.local(&aabb);
            let margin = |i: usize| (low[i] - block.low[i]).min(block.high[i] - high[i]);
            Some(Load { bottom: low.z, top: high.z, inside, margin: margin(0).min(margin(1)) })
        };
        graph.relating(relation, node.id()).filter_map(load)
    };
    let mut all: Vec<Load> = of(true).chain(of(false)).collect();
    all.sort_by(|a, b| a.bottom.total_cmp(&b.bottom));
    all
}

/// A height at which things stand, metres, and whether they are inside.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Level {
    pub(crate) at: f32,
    pub(crate) inside: bool,
}

/// The heights between two others at which things stand, from below. A level of things inside is at the
/// least height of these, a level of things on it in the middle between the least and the greatest.
pub(crate) fn levels(loads: &[Load], low: f32, high: f32) -> Vec<Level> {
    let within: Vec<&Load> = loads.iter().filter(|l| l.bottom > low && l.bottom < high).collect();
    let mut found = Vec::new();
    let mut from = 0;
    while let Some(first) = within.get(from) {
        let same = within[from..].iter().take_while(|l| l.bottom - first.bottom < SAME).count();
        let group = &within[from..from + same];
        let inside = 2 * group.iter().filter(|l| l.inside).count() >= same;
        let middle = f32::midpoint(first.bottom, group[same - 1].bottom);
        found.push(Level { at: if inside { first.bottom } else { middle }, inside });
        from += same;
    }
    found
}

/// The median height of the things that stand on a thing above some height, metres.
pub(crate) fn top(loads: &[Load], above: f32) -> Option<f32> {
    let bottoms: Vec<f32> = loads.iter().filter(|l| !l.inside && l.bottom > above).map(|l| l.bottom).collect();
    bottoms.get(bottoms.len() / 2).copied()
}
