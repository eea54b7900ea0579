//! Primitive writes.

use std::sync::Arc;

use super::SceneGraph;
use crate::node::{Link, Node, NodeKind};
use crate::space::NumberBlock;
use crate::{Edge, NodeId};

/// The primitive writes from which edits and change sets are made. Each keeps both ends of a relation and all
/// indexes consistent, and checks nothing else.
impl SceneGraph {
    /// The number that the next added node gets. It grows past the numbers of nodes that have been removed.
    pub fn next_number(&self) -> u32 {
        self.next
    }

    /// The scene with the numbers of a block: the lowest number becomes the first of the block, and the others keep their
    /// distances. `None` if the block has too few numbers. Costs a copy of the scene.
    ///
    /// ```
    /// use vc_graph::space::NumberBlock;
    /// use vc_graph::{Draft, NodeId, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let flat = scene.build().renumbered(NumberBlock { first: 500, count: 100 }).ok_or("too many nodes")?;
    /// assert_eq!((flat.rooms(), flat.next_number()), (&[NodeId(500)][..], 502));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn renumbered(&self, block: NumberBlock) -> Option<Self> {
        let ids = || self.nodes.iter().map(|node| node.id.0);
        let lowest = ids().min().unwrap_or(block.first);
        let new = |id: NodeId| NodeId(id.0 - lowest + block.first);
        let last = ids().max().map(|highest| highest - lowest);
        if last.is_some_and(|last| last >= block.count || block.first.checked_add(last).is_none()) {
            return None;
        }
        let mut graph = Self::new(self.name.clone(), self.classes.clone());
        graph.assets = self.assets.clone();
        graph.number_in(block, block.first);
        for node in self.nodes.iter() {
            graph.insert(Arc::new(Node { id: new(node.id), ..node.bare() }));
        }
        for edge in self.edges() {
            graph.link(Edge::new(new(edge.from), edge.relation, new(edge.to)));
        }
        Some(graph)
    }

    /// Gives new nodes numbers of a block, from a number on.
    pub(crate) fn number_in(&mut self, block: NumberBlock, from: u32) {
        let used =
            self.nodes.iter().map(|node| node.id).filter(|id| block.has(*id)).map(|id| id.0.saturating_add(1)).max();
        (self.numbers, self.next) = (block, from.max(block.first).max(used.unwrap_or(0)));
    }

    pub(crate) fn insert(&mut self, node: Arc<Node>) {
        let (id, kind, class) = (node.id, node.kind(), node.class().clone());
        if let Some(at) = node.position() {
            Arc::make_mut(&mut self.grid).insert(id, at);
        }
        add_sorted(Arc::make_mut(&mut self.by_class).entry(class).or_default(), id);
        match kind {
            NodeKind::Room => add_sorted(Arc::make_mut(&mut self.rooms), id),
            NodeKind::Agent => add_sorted(Arc::make_mut(&mut self.agents), id),
            NodeKind::Object => {}
        }
        // Nodes of other regions have other numbers.
        if self.numbers.has(id) && !NumberBlock::TRAVELLERS.has(id) {
            self.next = self.next.max(id.0.saturating_add(1));
        }
        self.nodes.insert(id, node);
    }

    /// Removes a node that has no relations left.
    pub(crate) fn take(&mut self, id: NodeId) -> Option<Arc<Node>> {
        let node = self.nodes.remove(id)?;
        if let Some(at) = node.position() {
            Arc::make_mut(&mut self.grid).remove(id, at);
        }
        let by_class = Arc::make_mut(&mut self.by_class);
        if let Some(ids) = by_class.get_mut(node.class()) {
            remove_sorted(ids, id);
            if ids.is_empty() {
                by_class.remove(node.class());
            }
        }
        match node.kind() {
            NodeKind::Room => remove_sorted(Arc::make_mut(&mut self.rooms), id),
            NodeKind::Agent => remove_sorted(Arc::make_mut(&mut self.agents), id),
            NodeKind::Object => {}
        }
        Some(node)
    }

    /// Adds an edge; `false` if it exists already or an end is missing.
    pub(crate) fn link(&mut self, edge: Edge) -> bool {
        if self.node(edge.to).is_none() || self.has(edge) {
            return false;
        }
        self.each_end(edge, add_sorted)
    }

    /// Removes an edge; `false` if it does not exist.
    pub(crate) fn unlink(&mut self, edge: Edge) -> bool {
        self.has(edge) && self.each_end(edge, remove_sorted)
    }

    fn each_end(&mut self, edge: Edge, write: fn(&mut Vec<Link>, Link)) -> bool {
        let Some(node) = self.nodes.get_mut(edge.from) else { return false };
        write(&mut node.out, Link::new(edge.relation, edge.to));
        let back = Link::new(edge.relation, edge.from);
        match self.nodes.get_mut(edge.to) {
            Some(node) if edge.relation.is_symmetric() => write(&mut node.out, back),
            Some(node) => write(&mut node.inc, back),
            None => {}
        }
        true
    }

    pub(crate) fn set_pose(&mut self, id: NodeId, pose: Option<crate::Pose>) {
        let Some(node) = self.nodes.get_mut(id) else { return };
        let old = node.position();
        node.pose = pose;
        let new = node.position();
        let grid = Arc::make_mut(&mut self.grid);
        if let Some(at) = old {
            grid.remove(id, at);
        }
        if let Some(at) = new {
            grid.insert(id, at);
        }
    }
}

fn add_sorted<T: Ord>(items: &mut Vec<T>, item: T) {
    if let Err(position) = items.binary_search(&item) {
        items.insert(position, item);
    }
}

fn remove_sorted<T: Ord>(items: &mut Vec<T>, item: T) {
    if let Ok(position) = items.binary_search(&item) {
        items.remove(position);
    }
}
