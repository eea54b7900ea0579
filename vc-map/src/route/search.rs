//! The A* search.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::graph::{Cost, Graph};

/// The fastest way from one of some nodes to one of some others, each with a cost of its own: the whole cost and the nodes.
pub(super) fn search(graph: &Graph, starts: &[(u32, Cost)], ends: &[(u32, Cost)]) -> Option<(Cost, Vec<u32>)> {
    let bound = |node: u32| {
        let to = |(end, rest): &(u32, Cost)| graph.landmarks.at_least(node, *end).saturating_add(*rest);
        ends.iter().map(to).min().unwrap_or(Cost::MAX)
    };
    let mut best = vec![Cost::MAX; graph.len()];
    let mut before = vec![u32::MAX; graph.len()];
    let mut open = BinaryHeap::new();
    for (node, cost) in starts {
        if *cost < best[*node as usize] {
            best[*node as usize] = *cost;
            open.push(Reverse((cost.saturating_add(bound(*node)), *cost, *node)));
        }
    }
    let mut found: Option<(Cost, u32)> = None;
    while let Some(Reverse((least, cost, node))) = open.pop() {
        if found.is_some_and(|(known, _)| least >= known) {
            break;
        }
        if cost > best[node as usize] {
            continue;
        }
        for (_, rest) in ends.iter().filter(|(end, _)| *end == node) {
            let total = cost.saturating_add(*rest);
            if found.is_none_or(|known| (total, node) < known) {
                found = Some((total, node));
            }
        }
        for (next, step) in graph.from(node) {
            let total = cost.saturating_add(*step);
            if total < best[*next as usize] {
                (best[*next as usize], before[*next as usize]) = (total, node);
                open.push(Reverse((total.saturating_add(bound(*next)), total, *next)));
            }
        }
    }
    let (cost, mut node) = found?;
    let mut way = vec![node];
    while before[node as usize] != u32::MAX {
        node = before[node as usize];
        way.push(node);
    }
    way.reverse();
    Some((cost, way))
}
