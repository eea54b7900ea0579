//! Adding many edges at once, in time linear in their number but for the sorting of
//! each node's short list.

use crate::node::Link;
use crate::{Edge, NodeId, Relation, SceneGraph};

/// Adds edges to a graph; all or, if one ends nowhere, none: then its position and
/// the missing node are returned.
pub(crate) fn link(graph: &mut SceneGraph, edges: &[Edge]) -> Result<(), (usize, NodeId)> {
    let ids: Vec<NodeId> = graph.nodes().map(crate::Node::id).collect();
    let mut out = add(graph, &ids, edges)?;
    if !out.is_symmetric(&ids) {
        let symmetric = edges.iter().filter(|e| e.relation.is_symmetric());
        let back: Vec<Edge> = symmetric.map(|e| e.reversed()).collect();
        add(graph, &ids, &back)?;
    }
    Ok(())
}

/// Adds both ends of edges, of symmetric ones only the start, and returns the
/// links by the node they start from.
fn add(graph: &mut SceneGraph, ids: &[NodeId], edges: &[Edge]) -> Result<Lists, (usize, NodeId)> {
    let (mut out, mut inc) = (Lists::new(ids.len()), Lists::new(ids.len()));
    for (index, edge) in edges.iter().enumerate() {
        let find = |id| position(ids, id).ok_or((index, id));
        out.count(find(edge.from)?);
        let end = find(edge.to)?;
        inc.count_if(end, !edge.relation.is_symmetric());
    }
    out.reserve();
    inc.reserve();
    for edge in edges {
        let at = |id| position(ids, id).unwrap_or(0);
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

/// Where a node stands among sorted numbers, which mostly have no gaps.
fn position(ids: &[NodeId], id: NodeId) -> Option<usize> {
    let guess = id.0.wrapping_sub(ids.first()?.0) as usize;
    if ids.get(guess) == Some(&id) { Some(guess) } else { ids.binary_search(&id).ok() }
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
    /// Where its next link goes.
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

    fn count_if(&mut self, node: usize, counts: bool) {
        self.starts[node + 1] += u32::from(counts);
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

    /// Whether every symmetric link has its counterpart. Nodes are visited in
    /// order, so the counterparts of a node's links occur in order as well.
    fn is_symmetric(&mut self, ids: &[NodeId]) -> bool {
        for (node, &id) in ids.iter().enumerate() {
            for index in self.starts[node]..self.starts[node + 1] {
                let link = self.links[index as usize];
                if !link.relation().is_symmetric() {
                    continue;
                }
                let back = Link::new(link.relation(), id);
                let other = position(ids, link.node());
                if !other.is_some_and(|other| self.advance(other, back)) {
                    return false;
                }
            }
        }
        true
    }

    /// Moves a node's cursor on to a link; `false` if it is not there. Links of
    /// one relation come in order, so the cursor only goes back for another one.
    fn advance(&mut self, node: usize, link: Link) -> bool {
        let end = self.starts[node + 1];
        let cursor = &mut self.next[node];
        while *cursor < end && self.links[*cursor as usize] < link {
            *cursor += 1;
        }
        let found = *cursor < end && self.links[*cursor as usize] == link;
        found || self.of(node).binary_search(&link).is_ok()
    }
}
