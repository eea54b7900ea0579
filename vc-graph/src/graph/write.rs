//! Primitive writes.

use std::sync::Arc;

use super::SceneGraph;
use crate::node::{Link, Node, NodeKind};
use crate::{Edge, NodeId};

/// The primitive writes from which edits and change sets are made. Each keeps both ends of a relation and all
/// indexes consistent, and checks nothing else.
impl SceneGraph {
    /// The number that the next added node gets. It grows past the numbers of nodes that have been removed.
    pub fn next_number(&self) -> u32 {
        self.next
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
        self.next = self.next.max(id.0.saturating_add(1));
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
