//! Nodes that leave a scene together: somebody, and everything that is carried.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::{PassError, RegionId};
use crate::asset::AssetError;
use crate::node::{Node, NodeKind};
use crate::{AssetId, AssetLibrary, Change, ChangeSet, Edge, NodeId, ObjectRole, Place, Pose, Relation, SceneGraph};

/// Nodes that leave a scene together, and the relations among them: an agent with all that it carries, a cart with what
/// is on it. [`RegionGraphs::pass`](super::RegionGraphs::pass) takes them from one scene to another.
///
/// ```
/// use vc_graph::space::{Load, RegionId};
/// use vc_graph::{Draft, Pose, SceneBuilder};
/// let mut kitchen = SceneBuilder::new("kitchen");
/// let room = kitchen.add(Draft::new("kitchen"))?;
/// let me = kitchen.add_in(room, Draft::new("character"))?;
/// let cup = kitchen.add(Draft::new("cup"))?;
/// let mut edit = kitchen.edit();
/// edit.hold(me, cup)?;
/// edit.commit();
/// let mut garden = SceneBuilder::new("garden");
/// garden.number_from(100);
/// let lawn = garden.add(Draft::new("garden"))?;
/// let (mut kitchen, mut garden) = (kitchen.build(), garden.build());
///
/// let load = Load::new(&kitchen, me, RegionId(0))?;
/// load.leave(&mut kitchen)?;
/// load.enter((&mut garden, RegionId(1)), &Pose::identity(), lawn)?;
/// assert_eq!((kitchen.len(), garden.room_of(cup)), (1, Some(lawn)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Load {
    /// The nodes without relations, the one that was asked for first.
    nodes: Vec<Arc<Node>>,
    /// Relations among them.
    inner: Vec<Edge>,
    /// Relations to what stays.
    outer: Vec<Edge>,
    library: Arc<AssetLibrary>,
}

impl Load {
    /// A node that stands free in the scene of a region, with everything that it carries.
    ///
    /// # Errors
    /// [`PassError::IsRoom`], [`PassError::Resting`].
    pub fn new(graph: &SceneGraph, id: NodeId, region: RegionId) -> Result<Self, PassError> {
        let ids = free_to_go(graph, id, region)?;
        let going: BTreeSet<NodeId> = ids.iter().copied().collect();
        let nodes = || ids.iter().filter_map(|id| graph.node(*id));
        let edges: BTreeSet<Edge> = nodes().flat_map(Node::edges).map(Edge::in_one_direction).collect();
        let (inner, outer) =
            edges.into_iter().partition(|edge: &Edge| going.contains(&edge.from) && going.contains(&edge.to));
        let nodes = nodes().map(|node| Arc::new(node.bare())).collect();
        Ok(Self { nodes, inner, outer, library: graph.assets().clone() })
    }

    /// The numbers of the nodes, that of the one that was asked for first.
    pub fn ids(&self) -> impl Iterator<Item = NodeId> + '_ {
        self.nodes.iter().map(|node| node.id())
    }

    /// Takes them out of the scene that they were read from; returns its changes.
    ///
    /// # Errors
    /// [`PassError::Changed`] if the scene has changed since; nothing has changed then.
    pub fn leave(&self, scene: &mut SceneGraph) -> Result<ChangeSet, PassError> {
        let changes = self.leaving();
        changes.apply(scene).map_err(|mismatch| PassError::Changed(Box::new(mismatch)))?;
        Ok(changes)
    }

    /// Brings them into a room of the scene of a region, with poses that are taken over by a transformation; returns the
    /// changes of the scene. Its shapes become more, too.
    ///
    /// # Errors
    /// [`PassError::Lacks`], [`PassError::Shape`], [`PassError::NoRoom`], [`PassError::Taken`]; nothing has changed then.
    pub fn enter(
        &self,
        (scene, region): (&mut SceneGraph, RegionId),
        shift: &Pose,
        room: NodeId,
    ) -> Result<ChangeSet, PassError> {
        if !scene.rooms().contains(&room) {
            return Err(PassError::NoRoom(region));
        }
        let (library, changes) = self.entering((scene, region), shift, room)?;
        changes.apply(scene).map_err(|mismatch| PassError::Taken(mismatch.node))?;
        scene.assets = library;
        Ok(changes)
    }

    /// The changes of the scene that they leave.
    pub(super) fn leaving(&self) -> ChangeSet {
        let unlinked = self.outer.iter().chain(&self.inner).copied().map(Change::Unlink);
        unlinked.chain(self.nodes.iter().cloned().map(Change::Remove)).collect()
    }

    /// The changes of the scene of a region that they enter, in a room of it, with poses that are taken over by a
    /// transformation; and the shapes of that scene then.
    ///
    /// # Errors
    /// [`PassError::Lacks`], [`PassError::Shape`].
    pub(super) fn entering(
        &self,
        (scene, region): (&SceneGraph, RegionId),
        shift: &Pose,
        room: NodeId,
    ) -> Result<(Arc<AssetLibrary>, ChangeSet), PassError> {
        let lacking = self.nodes.iter().find_map(|node| Some((node, scene.vocabulary().word_lacking(node)?)));
        if let Some((node, word)) = lacking {
            return Err(PassError::Lacks { node: node.label(), word, region });
        }
        let mut library = scene.assets().clone();
        let mut arrived = |old: &Arc<Node>| {
            let mut new = Node { pose: old.pose.map(|pose| shift * pose), ..Node::clone(old) };
            if let Some(asset) = old.spec.asset {
                let shape = |error| PassError::Shape { node: old.label(), error };
                let asset = taken_over(&mut library, &self.library, asset).map_err(shape)?;
                if Some(asset) != old.spec.asset {
                    Arc::make_mut(&mut new.spec).asset = Some(asset);
                }
            }
            Ok(Change::Add(Arc::new(new)))
        };
        let arrivals = self.nodes.iter().map(&mut arrived).collect::<Result<Vec<_>, _>>()?;
        let inside = self.ids().map(|id| Edge::new(id, Relation::InRoom, room));
        let links = self.inner.iter().copied().chain(inside).map(Change::Link);
        let entered = arrivals.into_iter().chain(links).collect();
        Ok((library, entered))
    }
}

/// The asset in a library that is the same as one of another; it is added if there is none.
fn taken_over(library: &mut Arc<AssetLibrary>, from: &AssetLibrary, asset: AssetId) -> Result<AssetId, AssetError> {
    match library.find(from, asset) {
        Some(here) => Ok(here),
        None => Arc::make_mut(library).import(from, asset),
    }
}

/// A node with everything that it carries, if it can go.
fn free_to_go(graph: &SceneGraph, id: NodeId, region: RegionId) -> Result<Vec<NodeId>, PassError> {
    let node = graph.label(id);
    if graph.node(id).is_some_and(|node| node.kind() == NodeKind::Room) {
        return Err(PassError::IsRoom(node));
    }
    // A floor is left behind; so is whatever an agent stands on.
    let is_agent = graph.node(id).is_some_and(|node| node.kind() == NodeKind::Agent);
    let is_ground = |place: &Place| {
        let floor = graph.node(place.at).is_some_and(|node| node.role() == ObjectRole::Floor);
        place.relation == Relation::On && (is_agent || floor)
    };
    let at = graph.places(id).find(|place| !is_ground(place)).or_else(|| graph.holder(id));
    match at {
        Some(place) => Err(PassError::Resting { node, at: graph.label(place.at), region }),
        None => Ok(graph.carried_with(id)),
    }
}
