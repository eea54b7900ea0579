//! Change sets: the changes of an edit, to be applied to another graph or undone.

mod between;

use std::sync::Arc;

use crate::node::Node;
use crate::serial::pose;
use crate::{Edge, Label, NodeId, Pose, Relation, SceneGraph, StateSet};

/// One reversible change of a scene.
///
/// Changes that add or remove a node are read back by [`native::read_changes`](crate::format::native::read_changes), as
/// a node needs its class table.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Change {
    /// A node without relations was added.
    #[serde(skip_deserializing)]
    Add(Arc<Node>),
    /// A node without relations was removed.
    #[serde(skip_deserializing)]
    Remove(Arc<Node>),
    /// A node's states changed.
    States {
        /// The node.
        id: NodeId,
        /// States before.
        before: StateSet,
        /// States after.
        after: StateSet,
    },
    /// A node's pose changed.
    Pose {
        /// The node.
        id: NodeId,
        /// Pose before.
        #[serde(with = "pose::known")]
        before: Option<Pose>,
        /// Pose after.
        #[serde(with = "pose::known")]
        after: Option<Pose>,
    },
    /// The contents of a container that can be poured from or into changed.
    Contents {
        /// The node.
        id: NodeId,
        /// Class of the contents before.
        before: Option<Arc<str>>,
        /// Class of the contents after.
        after: Option<Arc<str>>,
    },
    /// A relation was added.
    Link(Edge),
    /// A relation was removed.
    Unlink(Edge),
}

impl Change {
    fn inverse(&self) -> Self {
        match self.clone() {
            Self::Add(node) => Self::Remove(node),
            Self::Remove(node) => Self::Add(node),
            Self::States { id, before, after } => Self::States { id, before: after, after: before },
            Self::Pose { id, before, after } => Self::Pose { id, before: after, after: before },
            Self::Contents { id, before, after } => Self::Contents { id, before: after, after: before },
            Self::Link(edge) => Self::Unlink(edge),
            Self::Unlink(edge) => Self::Link(edge),
        }
    }

    /// The label of the node that the change is about.
    fn label(&self, graph: &SceneGraph) -> Label {
        match self {
            Self::Add(node) | Self::Remove(node) => node.label(),
            Self::States { id, .. } | Self::Pose { id, .. } | Self::Contents { id, .. } => graph.label(*id),
            Self::Link(edge) | Self::Unlink(edge) => graph.label(edge.from),
        }
    }

    /// Whether the graph is in the state in which this change begins.
    fn fits(&self, graph: &SceneGraph) -> bool {
        match self {
            Self::Add(node) => graph.node(node.id).is_none(),
            Self::Remove(node) => graph.node(node.id) == Some(node),
            Self::States { id, before, .. } => graph.node(*id).is_some_and(|n| n.states == *before),
            Self::Pose { id, before, .. } => graph.node(*id).is_some_and(|n| n.pose == *before),
            Self::Contents { id, before, .. } => graph.node(*id).is_some_and(|n| n.contents == *before),
            Self::Link(e) => graph.node(e.from).is_some() && graph.node(e.to).is_some() && !graph.has(*e),
            Self::Unlink(e) => graph.has(*e),
        }
    }

    pub(crate) fn write(&self, graph: &mut SceneGraph) {
        match self {
            Self::Add(node) => graph.insert(node.clone()),
            Self::Remove(node) => {
                graph.take(node.id);
            }
            Self::States { id, after, .. } => {
                if let Some(node) = graph.nodes.get_mut(*id) {
                    node.states = *after;
                }
            }
            Self::Pose { id, after, .. } => graph.set_pose(*id, *after),
            Self::Contents { id, after, .. } => {
                if let Some(node) = graph.nodes.get_mut(*id) {
                    node.contents.clone_from(after);
                }
            }
            Self::Link(edge) => {
                graph.link(*edge);
            }
            Self::Unlink(edge) => {
                graph.unlink(*edge);
            }
        }
    }
}

/// The sequence of changes made by one edit or action.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder, State};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
/// let mut graph = scene.build();
/// let before = graph.clone();
///
/// let mut edit = graph.edit();
/// edit.enter_state(fridge, State::Open)?;
/// let changes = edit.commit();
/// assert_ne!(graph, before);
/// changes.undo(&mut graph)?;
/// assert_eq!(graph, before);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(transparent)]
pub struct ChangeSet {
    pub(crate) changes: Vec<Change>,
}

impl FromIterator<Change> for ChangeSet {
    fn from_iter<I: IntoIterator<Item = Change>>(changes: I) -> Self {
        Self { changes: changes.into_iter().collect() }
    }
}

/// An error: a change set was applied to a graph that differs from the one it was made on.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder, State};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
/// let milk = scene.add_in(fridge, Draft::new("milk"))?;
/// let mut graph = scene.build();
/// let mut edit = graph.edit();
/// edit.enter_state(fridge, State::Open)?;
/// let changes = edit.commit();
/// let error = changes.apply(&mut graph).unwrap_err(); // the fridge is open already
/// assert_eq!(error.node, graph.label(fridge));
/// # Ok::<(), vc_graph::EditError>(())
/// ```
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("change {index} of {total} does not fit this graph: {node} is not as before the change; nothing was changed")]
#[non_exhaustive]
pub struct ChangeMismatch {
    /// The index of the change, from zero.
    pub index: usize,
    /// How many changes there were.
    pub total: usize,
    /// The node that the change is about; for a relation, the node where it starts.
    pub node: Label,
    /// The change itself.
    pub change: Box<Change>,
}

impl ChangeSet {
    /// The nodes that came or went, or whose states, contents or places changed; not those that only moved. A node may be
    /// listed several times.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder, State};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let mut graph = scene.build();
    /// let mut edit = graph.edit();
    /// edit.enter_state(fridge, State::Open)?;
    /// assert_eq!(edit.commit().nodes().collect::<Vec<_>>(), [fridge]);
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    pub fn nodes(&self) -> impl Iterator<Item = NodeId> + '_ {
        self.changes()
            .iter()
            .flat_map(|change| match change {
                Change::Add(node) | Change::Remove(node) => [Some(node.id), None],
                Change::States { id, .. } | Change::Contents { id, .. } => [Some(*id), None],
                Change::Link(e) | Change::Unlink(e)
                    if Relation::hands().contains(&e.relation) || Relation::places().contains(&e.relation) =>
                {
                    [Some(e.from), Some(e.to)]
                }
                Change::Pose { .. } | Change::Link(_) | Change::Unlink(_) => [None, None],
            })
            .flatten()
    }

    /// The changes, in order.
    pub fn changes(&self) -> &[Change] {
        &self.changes
    }

    /// Whether nothing changed.
    pub fn is_empty(&self) -> bool {
        self.changes.is_empty()
    }

    /// Appends later changes.
    ///
    /// ```
    /// use vc_graph::{ChangeSet, Draft, SceneBuilder, State};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let milk = scene.add_in(fridge, Draft::new("milk"))?;
    /// let mut graph = scene.build();
    /// let before = graph.digest();
    /// let mut changes = ChangeSet::default();
    /// for state in [State::Open, State::Dirty] {
    ///     let mut edit = graph.edit();
    ///     edit.enter_state(fridge, state)?;
    ///     changes = changes.then(edit.commit());
    /// }
    /// changes.undo(&mut graph)?;
    /// assert_eq!(graph.digest(), before);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn then(mut self, later: Self) -> Self {
        self.changes.extend(later.changes);
        self
    }

    /// The changes that undo this set.
    #[must_use]
    pub fn inverse(&self) -> Self {
        Self { changes: self.changes.iter().rev().map(Change::inverse).collect() }
    }

    /// Applies the changes to a graph in the state before them.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder, State};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let milk = scene.add_in(fridge, Draft::new("milk"))?;
    /// let mut graph = scene.build();
    /// let mut copy = graph.clone();
    /// let mut edit = graph.edit();
    /// edit.enter_state(fridge, State::Open)?;
    /// edit.commit().apply(&mut copy)?;
    /// assert_eq!(copy, graph);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ChangeMismatch`] if the graph is in another state; then it is left unchanged.
    pub fn apply(&self, graph: &mut SceneGraph) -> Result<(), ChangeMismatch> {
        for (index, change) in self.changes.iter().enumerate() {
            if !change.fits(graph) {
                self.changes[..index].iter().rev().for_each(|c| c.inverse().write(graph));
                let node = change.label(graph);
                return Err(ChangeMismatch {
                    index,
                    total: self.changes.len(),
                    node,
                    change: Box::new(change.clone()),
                });
            }
            change.write(graph);
        }
        Ok(())
    }

    /// Undoes the changes on a graph in the state after them.
    ///
    /// # Errors
    /// [`ChangeMismatch`] if the graph is in another state; then it is left unchanged.
    pub fn undo(&self, graph: &mut SceneGraph) -> Result<(), ChangeMismatch> {
        self.inverse().apply(graph)
    }
}
