//! Landmarks: nodes at the rim of the map, from and to which all times are known.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use vc_graph::portable::Portable;

use super::graph::{Cost, Graph};
use crate::Point;

/// The number of landmarks.
const COUNT: u32 = 8;

/// For each landmark, the times from it and to it.
#[derive(Debug, Default)]
pub(super) struct Landmarks {
    times: Vec<[Vec<Cost>; 2]>,
}

impl Landmarks {
    /// The outermost node in each of eight directions.
    pub(super) fn new(places: &[Point], ahead: &Graph, back: &Graph) -> Self {
        let farthest = |direction: u32| {
            let (sine, cosine) = (f64::from(direction) * std::f64::consts::TAU / f64::from(COUNT)).sine_cosine();
            let along = |node: &usize| places[*node].x * cosine + places[*node].y * sine;
            // A node from which nothing leads on tells nothing.
            let joined = |node: &usize| !ahead.from(*node as u32).is_empty() && !back.from(*node as u32).is_empty();
            (0..places.len()).filter(joined).max_by(|a, b| along(a).total_cmp(&along(b)).then(b.cmp(a)))
        };
        let mut nodes: Vec<usize> = (0..COUNT).filter_map(farthest).collect();
        nodes.sort_unstable();
        nodes.dedup();
        Self { times: nodes.into_iter().map(|node| [times(ahead, node as u32), times(back, node as u32)]).collect() }
    }

    /// A time that no way from a node to another is faster than.
    pub(super) fn at_least(&self, from: u32, to: u32) -> Cost {
        let bound = |[ahead, back]: &[Vec<Cost>; 2]| {
            let gap = |list: &[Cost], far: u32, near: u32| match (list[far as usize], list[near as usize]) {
                (Cost::MAX, _) | (_, Cost::MAX) => 0,
                (far, near) => far.saturating_sub(near),
            };
            gap(ahead, to, from).max(gap(back, from, to))
        };
        self.times.iter().map(bound).max().unwrap_or(0)
    }
}

/// The times from a node to all others (Dijkstra).
fn times(graph: &Graph, from: u32) -> Vec<Cost> {
    let mut best = vec![Cost::MAX; graph.len()];
    let mut open = BinaryHeap::from([Reverse((0, from))]);
    best[from as usize] = 0;
    while let Some(Reverse((cost, node))) = open.pop() {
        if cost > best[node as usize] {
            continue;
        }
        for (next, step) in graph.from(node) {
            let total = cost.saturating_add(*step);
            if total < best[*next as usize] {
                best[*next as usize] = total;
                open.push(Reverse((total, *next)));
            }
        }
    }
    best
}
