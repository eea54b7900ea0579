//! The difference of two scenes.

use std::collections::BTreeSet;
use std::sync::Arc;

use crate::node::Node;
use crate::{Change, ChangeSet, Edge, SceneGraph};

impl ChangeSet {
    /// The changes that lead from one state of a scene to another, however it came about: the shortest record of it. Costs
    /// what differs, as clones share the rest.
    ///
    /// Both have the same asset library, class table and name: nodes name assets by number, and a change set has none of
    /// these. The number of the next node is not in it either ([`SceneGraph::next_number`]).
    ///
    /// ```
    /// use vc_graph::{ChangeSet, Draft, SceneBuilder, State};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let before = scene.build();
    /// let mut after = before.clone();
    /// for state in [State::Open, State::Closed, State::Open] {
    ///     let mut edit = after.edit();
    ///     edit.enter_state(fridge, state)?;
    ///     edit.commit();
    /// }
    /// let changes = ChangeSet::between(&before, &after);
    /// assert_eq!(changes.changes().len(), 1);
    /// let mut again = before.clone();
    /// changes.apply(&mut again)?;
    /// assert_eq!(again, after);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn between(before: &SceneGraph, after: &SceneGraph) -> Self {
        let pairs = before.nodes.unshared(&after.nodes);
        let unlinked = edges(pairs.iter().filter_map(|[old, new]| edges_without(*old, *new, after)));
        let linked = edges(pairs.iter().filter_map(|[old, new]| edges_without(*new, *old, before)));
        let replaced = || pairs.iter().filter(|[old, new]| !is_kept(*old, *new));
        let removed = replaced().filter_map(|[old, _]| old.map(|node| Change::Remove(Arc::new(node.bare()))));
        let added = replaced().filter_map(|[_, new]| new.map(|node| Change::Add(Arc::new(node.bare()))));
        let kept = pairs.iter().filter(|[old, new]| is_kept(*old, *new));
        let changed = kept.filter_map(|[old, new]| old.zip(*new)).flat_map(|(old, new)| differences(old, new));
        let nodes = removed.chain(added).chain(changed);
        unlinked.into_iter().map(Change::Unlink).chain(nodes).chain(linked.into_iter().map(Change::Link)).collect()
    }
}

/// Whether a node is the same in both scenes: one that is specified anew is another with the same number.
fn is_kept(old: Option<&Arc<Node>>, new: Option<&Arc<Node>>) -> bool {
    old.zip(new).is_some_and(|(old, new)| Arc::ptr_eq(&old.spec, &new.spec) || old.spec == new.spec)
}

/// The edges at a node that the other scene lacks; all if the node is not kept.
fn edges_without<'g>(
    node: Option<&'g Arc<Node>>,
    there: Option<&Arc<Node>>,
    other: &'g SceneGraph,
) -> Option<impl Iterator<Item = Edge> + 'g> {
    let kept = is_kept(node, there);
    Some(node?.edges().filter(move |edge| !kept || !other.has(*edge)))
}

/// Edges in order, each once: both ends have a symmetric one.
fn edges(lists: impl Iterator<Item = impl Iterator<Item = Edge>>) -> BTreeSet<Edge> {
    lists.flatten().map(Edge::in_one_direction).collect()
}

/// The changes of states, pose and contents between two states of a node.
fn differences(old: &Node, new: &Node) -> impl Iterator<Item = Change> {
    let id = old.id;
    let states = (old.states != new.states).then_some(Change::States { id, before: old.states, after: new.states });
    let pose = (old.pose != new.pose).then_some(Change::Pose { id, before: old.pose, after: new.pose });
    let contents = (old.contents != new.contents).then(|| {
        let (before, after) = (old.contents.clone(), new.contents.clone());
        Change::Contents { id, before, after }
    });
    [states, pose, contents].into_iter().flatten()
}
