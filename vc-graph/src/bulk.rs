//! Adding many edges at once, in time linear in their number apart from sorting each node's short list.

use crate::node::Link;
use crate::{Edge, NodeId, Relation, SceneGraph};

/// Adds edges to a graph: all of them or, if one refers to a missing node, none; then the position of the edge
/// and the missing node are returned.
pub(crate) fn link(graph: &mut SceneGraph, edges: &[Edge]) -> Result<(), (usize, NodeId)> {
    let ids: Vec<NodeId> = graph.nodes().map(crate::Node::id).collect();
    let (first, count) = (ids.first().map_or(0, |id| id.0), ids.len());
    let dense = ids.last().is_none_or(|last| (last.0 - first) as usize + 1 == count);
    if dense {
        // Consecutive numbers, as most scenes have them, differ from positions only by an offset.
        let position = |id: NodeId| Some(id.0.wrapping_sub(first) as usize).filter(|&p| p < count);
        link_at(graph, &ids, edges, position)
    } else {
        link_at(graph, &ids, edges, |id| ids.binary_search(&id).ok())
    }
}

fn link_at(
    graph: &mut SceneGraph,
    ids: &[NodeId],
    edges: &[Edge],
    position: impl Fn(NodeId) -> Option<usize> + Copy,
) -> Result<(), (usize, NodeId)> {
    let mut out = add(graph, ids, edges, position)?;
    if !out.is_symmetric(ids, position) {
        let symmetric = edges.iter().filter(|e| e.relation.is_symmetric());
        let back: Vec<Edge> = symmetric.map(|e| e.reversed()).collect();
        add(graph, ids, &back, position)?;
    }
    Ok(())
}

/// Adds edges to the lists of both end nodes (a symmetric edge only to that of its start), and returns the
/// links by start node.
fn add(
    graph: &mut SceneGraph,
    ids: &[NodeId],
    edges: &[Edge],
    position: impl Fn(NodeId) -> Option<usize>,
) -> Result<Lists, (usize, NodeId)> {
    let (mut out, mut inc) = (Lists::new(ids.len()), Lists::new(ids.len()));
    for (index, edge) in edges.iter().enumerate() {
        let find = |id| position(id).ok_or((index, id));
        out.count(find(edge.from)?);
        let end = find(edge.to)?;
        if !edge.relation.is_symmetric() {
            inc.count(end);
        }
    }
    out.reserve();
    inc.reserve();
    for edge in edges {
        let at = |id| position(id).unwrap_or(0);
        out.put(at(edge.from), Link::new(edge.relation, edge.to));
        if !edge.relation.is_symmetric() {
            inc.put(at(edge.to), Link::new(edge.relation, edge.from));
        }
    }
    out.sort();
    inc.sort();
    for (index, id) in ids.iter().enumerate() {
        if let Some(node) = graph.nodes.get_mut(*id) {
            merge(&mut node.out, out.of(index));
            merge(&mut node.inc, inc.of(index));
        }
    }
    Ok(out)
}

/// Adds sorted links to a sorted list.
fn merge(links: &mut Vec<Link>, more: &[Link]) {
    let was_empty = links.is_empty();
    links.reserve_exact(more.len());
    links.extend_from_slice(more);
    if !was_empty {
        links.sort_unstable();
    }
    links.dedup();
}

/// A list of links for each node, all in one allocation: count, reserve, put, sort.
struct Lists {
    /// Where each node's list begins.
    starts: Vec<u32>,
    /// The index of the node's next link.
    next: Vec<u32>,
    links: Vec<Link>,
}

impl Lists {
    fn new(nodes: usize) -> Self {
        Self { starts: vec![0; nodes + 1], next: Vec::new(), links: Vec::new() }
    }

    fn count(&mut self, node: usize) {
        self.starts[node + 1] += 1;
    }

    fn reserve(&mut self) {
        let mut sum = 0;
        for start in &mut self.starts {
            sum += *start;
            *start = sum;
        }
        self.next = self.starts.clone();
        self.links = vec![Link::new(Relation::On, NodeId(0)); sum as usize];
    }

    fn put(&mut self, node: usize, link: Link) {
        let next = &mut self.next[node];
        self.links[*next as usize] = link;
        *next += 1;
    }

    fn sort(&mut self) {
        for ends in self.starts.windows(2) {
            self.links[ends[0] as usize..ends[1] as usize].sort_unstable();
        }
        self.next.copy_from_slice(&self.starts);
    }

    fn of(&self, node: usize) -> &[Link] {
        &self.links[self.starts[node] as usize..self.starts[node + 1] as usize]
    }

    /// Whether every symmetric link has its counterpart, in one pass: nodes come in order, so at each node the
    /// links to smaller nodes have been ticked off already, and its own links are ticked off at the larger
    /// ones. For nodes with two kinds of symmetric links it returns `false`, which costs the caller time and
    /// nothing else.
    fn is_symmetric(&mut self, ids: &[NodeId], position: impl Fn(NodeId) -> Option<usize>) -> bool {
        let first = Link::new(Relation::Touching, NodeId(0));
        for node in 0..ids.len() {
            self.next[node] += self.of(node).partition_point(|&link| link < first) as u32;
        }
        for (node, &id) in ids.iter().enumerate() {
            for index in self.next[node]..self.starts[node + 1] {
                let link = self.links[index as usize];
                if !link.relation().is_symmetric() {
                    break;
                }
                let to_larger = link.node() > id;
                let counterpart = Link::new(link.relation(), id);
                let other = position(link.node()).filter(|_| to_larger);
                if link.node() != id && !other.is_some_and(|other| self.tick_off(other, counterpart)) {
                    return false;
                }
            }
        }
        true
    }

    /// Advances past a node's next link if it equals `link`.
    fn tick_off(&mut self, node: usize, link: Link) -> bool {
        let next = &mut self.next[node];
        let found = *next < self.starts[node + 1] && self.links[*next as usize] == link;
        *next += u32::from(found);
        found
    }
}
