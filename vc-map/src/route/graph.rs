//! A graph of times, packed: the edges of each node lie side by side.

use super::landmarks::Landmarks;
use crate::Point;

/// Milliseconds; the largest value stands for no way.
pub(super) type Cost = u32;

#[derive(Debug, Default)]
pub(super) struct Graph {
    first: Vec<u32>,
    edges: Vec<(u32, Cost)>,
    pub(super) landmarks: Landmarks,
}

impl Graph {
    /// A graph of some nodes with their places, and edges (from, to, cost).
    pub(super) fn new(places: &[Point], edges: Vec<(u32, u32, Cost)>) -> Self {
        let reversed: Vec<_> = edges.iter().map(|(from, to, cost)| (*to, *from, *cost)).collect();
        let (mut graph, back) = (Self::packed(places.len(), edges), Self::packed(places.len(), reversed));
        graph.landmarks = Landmarks::new(places, &graph, &back);
        graph
    }

    fn packed(nodes: usize, mut edges: Vec<(u32, u32, Cost)>) -> Self {
        edges.sort_unstable();
        edges.dedup_by_key(|(from, to, _)| (*from, *to));
        let mut first = vec![0; nodes + 1];
        edges.iter().for_each(|(from, ..)| first[*from as usize + 1] += 1);
        (0..nodes).for_each(|node| first[node + 1] += first[node]);
        Self {
            first,
            edges: edges.into_iter().map(|(_, to, cost)| (to, cost)).collect(),
            landmarks: Landmarks::default(),
        }
    }

    pub(super) fn len(&self) -> usize {
        self.first.len() - 1
    }

    pub(super) fn from(&self, node: u32) -> &[(u32, Cost)] {
        &self.edges[self.first[node as usize] as usize..self.first[node as usize + 1] as usize]
    }
}
