//! Edits that keep a scene's invariants.

mod error;
mod locations;
mod nodes;

use crate::geometry::is_finite;
use crate::node::{Draft, Node, NodeKind};
use crate::{Change, ChangeSet, Edge, NodeId, SceneGraph};

pub use error::EditError;

/// An edit in progress. [`Edit::commit`] keeps it and returns its changes; dropping it undoes everything.
///
/// An edit keeps these invariants: for the objects it moves a single support chain without cycles, an object in
/// at most one hand, no opposite states, and a room for every moved object.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder, State};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
/// let milk = scene.add_in(fridge, Draft::new("milk"))?;
/// let mut graph = scene.build();
/// let before = graph.clone();
/// graph.edit().enter_state(fridge, State::Open)?; // never committed
/// assert_eq!(graph, before);
/// let mut edit = graph.edit();
/// edit.enter_state(fridge, State::Open)?;
/// assert_eq!(edit.commit().changes().len(), 1);
/// # Ok::<(), vc_graph::EditError>(())
/// ```
#[derive(Debug)]
pub struct Edit<'g> {
    graph: &'g mut SceneGraph,
    changes: Vec<Change>,
}

impl SceneGraph {
    /// Begins an edit that keeps the graph's invariants.
    pub fn edit(&mut self) -> Edit<'_> {
        Edit::new(self)
    }
}

impl<'g> Edit<'g> {
    pub(crate) fn new(graph: &'g mut SceneGraph) -> Self {
        Self { graph, changes: Vec::new() }
    }

    /// The graph with the edit's changes so far.
    pub fn graph(&self) -> &SceneGraph {
        self.graph
    }

    /// Keeps the edit.
    pub fn commit(mut self) -> ChangeSet {
        ChangeSet { changes: std::mem::take(&mut self.changes) }
    }

    fn make(&mut self, change: Change) {
        change.write(self.graph);
        self.changes.push(change);
    }

    fn check(&self, id: NodeId) -> Result<(), EditError> {
        self.graph.node(id).map(|_| ()).ok_or(EditError::NoSuchNode(id))
    }

    fn check_kind(&self, id: NodeId, kind: NodeKind, needed: &'static str) -> Result<(), EditError> {
        let node = self.graph.node(id).ok_or(EditError::NoSuchNode(id))?;
        if node.kind() == kind { Ok(()) } else { Err(EditError::WrongKind { node: node.label(), needed }) }
    }

    fn check_movable(&self, id: NodeId) -> Result<(), EditError> {
        let node = self.graph.node(id).ok_or(EditError::NoSuchNode(id))?;
        let needed = "thing that can be in a room";
        if node.kind() == NodeKind::Room { Err(EditError::WrongKind { node: node.label(), needed }) } else { Ok(()) }
    }

    /// Adds an edge of any kind; the callers keep the invariants.
    pub(crate) fn link(&mut self, edge: Edge) {
        if self.graph.link(edge) {
            self.changes.push(Change::Link(edge));
        }
    }

    pub(crate) fn unlink(&mut self, edge: Edge) {
        if self.graph.unlink(edge) {
            self.changes.push(Change::Unlink(edge));
        }
    }
}

impl Drop for Edit<'_> {
    fn drop(&mut self) {
        let undo = ChangeSet { changes: std::mem::take(&mut self.changes) }.inverse();
        undo.changes.iter().for_each(|change| change.write(self.graph));
    }
}

/// The number of the next node.
pub(crate) fn next_id(graph: &SceneGraph) -> Result<NodeId, EditError> {
    if graph.next >= graph.numbers.end() { Err(EditError::NumbersExhausted) } else { Ok(NodeId(graph.next)) }
}

/// Makes a node with a number that the graph does not have yet.
pub(crate) fn make_node(graph: &SceneGraph, id: NodeId, draft: Draft) -> Result<Node, EditError> {
    if graph.node(id).is_some() {
        return Err(EditError::Duplicate(id));
    }
    let node = draft.into_node(id, &graph.classes);
    let finite = node.pose.as_ref().is_none_or(is_finite);
    if finite { Ok(node) } else { Err(EditError::NotFinite(node.label())) }
}
