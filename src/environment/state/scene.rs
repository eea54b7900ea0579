//! A scene as what differs from the one that it began as. Most of it are relations, which take little.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use vc_graph::{AssetLibrary, Change, ChangeSet, Edge, NodeId, Pose, SceneBuilder, SceneGraph};
use vc_physics::RestRecord;

use super::StateError;

/// Changes in their order, sixteen bytes each for relations, of which most are.
pub(super) struct PackedChanges(Box<[Packed]>);

enum Packed {
    Link(Edge),
    Unlink(Edge),
    Other(Box<Change>),
}

impl PackedChanges {
    pub(super) fn new(changes: &ChangeSet) -> Self {
        let packed = |change: &Change| match change {
            Change::Link(edge) => Packed::Link(*edge),
            Change::Unlink(edge) => Packed::Unlink(*edge),
            other => Packed::Other(Box::new(other.clone())),
        };
        Self(changes.changes().iter().map(packed).collect())
    }

    pub(super) fn unpacked(&self) -> ChangeSet {
        let unpacked = |packed: &Packed| match packed {
            Packed::Link(edge) => Change::Link(*edge),
            Packed::Unlink(edge) => Change::Unlink(*edge),
            Packed::Other(change) => (**change).clone(),
        };
        self.0.iter().map(unpacked).collect()
    }

    pub(super) fn bytes(&self) -> usize {
        let other = |packed: &Packed| match packed {
            Packed::Other(change) => size_of::<Change>() + node_bytes(change),
            _ => 0,
        };
        size_of_val(&*self.0) + self.0.iter().map(other).sum::<usize>()
    }
}

/// The bytes of a node that came or went.
fn node_bytes(change: &Change) -> usize {
    match change {
        Change::Add(node) | Change::Remove(node) => size_of_val(&**node),
        _ => 0,
    }
}

/// The difference of a scene from its start, but for poses that a record of its bodies tells.
pub(super) struct SceneDifference {
    changes: PackedChanges,
    assets: Arc<AssetLibrary>,
    next: u32,
}

impl SceneDifference {
    pub(super) fn between(start: &SceneGraph, now: &SceneGraph, record: &RestRecord) -> Self {
        let told: BTreeMap<NodeId, Pose> = record.poses().collect();
        let is_told = |change: &&Change| match change {
            Change::Pose { id, after, .. } => after.is_some() && told.get(id) == after.as_ref(),
            _ => false,
        };
        let changes = ChangeSet::between(start, now);
        let untold: ChangeSet = changes.changes().iter().filter(|change| !is_told(change)).cloned().collect();
        let changes = PackedChanges::new(&untold);
        Self { changes, assets: now.assets().clone(), next: now.next_number() }
    }

    /// The scene that differs so from its start.
    pub(super) fn applied_to(&self, start: &SceneGraph, record: &RestRecord) -> Result<SceneGraph, StateError> {
        let mut graph = start.clone();
        let changes = self.changes.unpacked();
        changes.apply(&mut graph)?;
        let posed = |change: &Change| match change {
            Change::Pose { id, .. } => Some(*id),
            _ => None,
        };
        let untold: BTreeSet<NodeId> = changes.changes().iter().filter_map(posed).collect();
        let moved = |(id, pose): &(NodeId, Pose)| {
            !untold.contains(id) && graph.node(*id).is_some_and(|node| node.pose() != Some(pose))
        };
        let moved: Vec<(NodeId, Pose)> = record.poses().filter(moved).collect();
        let mut edit = graph.edit();
        moved.into_iter().try_for_each(|(id, pose)| edit.set_pose(id, Some(pose)))?;
        edit.commit();
        let mut builder = SceneBuilder::from_graph(graph);
        builder.assets(self.assets.clone()).number_from(self.next);
        Ok(builder.build())
    }

    pub(super) fn bytes(&self) -> usize {
        self.changes.bytes()
    }
}
