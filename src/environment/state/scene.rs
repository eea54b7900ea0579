//! A scene as what differs from the one that it began as. Most of it are relations, of twelve bytes each.

use std::sync::Arc;

use vc_graph::{AssetLibrary, Change, ChangeMismatch, ChangeSet, Edge, SceneBuilder, SceneGraph};

/// The difference of a scene from its start.
pub(super) struct SceneDifference {
    unlinked: Box<[Edge]>,
    /// Changes of nodes, which come between those of relations.
    nodes: Box<[Change]>,
    linked: Box<[Edge]>,
    assets: Arc<AssetLibrary>,
    next: u32,
}

impl SceneDifference {
    pub(super) fn between(start: &SceneGraph, now: &SceneGraph) -> Self {
        let (mut unlinked, mut nodes, mut linked) = (Vec::new(), Vec::new(), Vec::new());
        for change in ChangeSet::between(start, now).changes() {
            match change {
                Change::Unlink(edge) => unlinked.push(*edge),
                Change::Link(edge) => linked.push(*edge),
                other => nodes.push(other.clone()),
            }
        }
        let (assets, next) = (now.assets().clone(), now.next_number());
        Self { unlinked: unlinked.into(), nodes: nodes.into(), linked: linked.into(), assets, next }
    }

    /// The scene that differs so from its start.
    pub(super) fn from_start(&self, start: &SceneGraph) -> Result<SceneGraph, ChangeMismatch> {
        let unlinked = self.unlinked.iter().map(|edge| Change::Unlink(*edge));
        let linked = self.linked.iter().map(|edge| Change::Link(*edge));
        let changes: ChangeSet = unlinked.chain(self.nodes.iter().cloned()).chain(linked).collect();
        let mut graph = start.clone();
        changes.apply(&mut graph)?;
        let mut builder = SceneBuilder::from_graph(graph);
        builder.assets(self.assets.clone()).number_from(self.next);
        Ok(builder.build())
    }

    pub(super) fn bytes(&self) -> usize {
        let nodes = self.nodes.iter().map(|change| match change {
            Change::Add(node) | Change::Remove(node) => size_of_val(&**node),
            _ => 0,
        });
        size_of_val(&*self.unlinked) + size_of_val(&*self.nodes) + size_of_val(&*self.linked) + nodes.sum::<usize>()
    }
}
