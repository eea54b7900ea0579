//! Going through a portal, with everything that one carries.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::{PassError, PortalId, RegionGraphs, RegionId};
use crate::asset::AssetError;
use crate::node::{Node, NodeKind};
use crate::{AssetId, AssetLibrary, Change, ChangeMismatch, ChangeSet, Edge, NodeId, Pose, Relation, SceneGraph};

/// A passage through a portal: [`RegionGraphs::take_back`] undoes it.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Crossing {
    /// The portal.
    pub portal: PortalId,
    /// The region that was left.
    pub from: RegionId,
    /// The region that was entered.
    pub to: RegionId,
    /// The nodes that went, the one that was asked for first.
    pub nodes: Vec<NodeId>,
    /// The changes of the scene that was left.
    pub left: ChangeSet,
    /// The changes of the scene that was entered.
    pub entered: ChangeSet,
}

impl RegionGraphs {
    /// Takes a node that stands free, with everything that it carries, through an open portal into the region beyond.
    ///
    /// It stays where it is in the world, and the relations among those who go stay. Those to what is left behind end: where
    /// a held thing was taken from is forgotten. In the new scene all are in the room of the portal's side. Costs what is
    /// carried.
    ///
    /// # Errors
    /// [`PassError`]; nothing has changed then.
    pub fn pass(&mut self, node: NodeId, portal: PortalId) -> Result<Crossing, PassError> {
        let (from, to, into) = self.way(node, portal)?;
        let (left, entered) = match (self.graph(from), self.graph(to)) {
            (Some(left), Some(entered)) => (left, entered),
            (None, _) => return Err(PassError::NoSuchNode(node)),
            (_, None) => return Err(PassError::NotActive(to)),
        };
        let is_room = |id: &NodeId| entered.rooms().contains(id);
        let room = into.or_else(|| entered.rooms().first().copied()).filter(is_room).ok_or(PassError::NoRoom(to))?;
        let nodes = free_to_go(left, node, from)?;
        let frames = self.frame(from).zip(self.frame(to));
        let shift = frames.map_or_else(Pose::identity, |(from, to)| from.to(&to));
        let load = Load::new(left, &nodes);
        let lacking = load.nodes.iter().find_map(|node| Some((node, entered.vocabulary().word_lacking(node)?)));
        if let Some((node, word)) = lacking {
            return Err(PassError::Lacks { node: node.label(), word, region: to });
        }
        let mut library = entered.assets().clone();
        let mut arrived = |old: &Arc<Node>| {
            let mut new = Node { pose: old.pose.map(|pose| shift * pose), ..Node::clone(old) };
            if let Some(asset) = old.spec.asset {
                let shape = |error| PassError::Shape { node: old.label(), error };
                let asset = taken_over(&mut library, left.assets(), asset).map_err(shape)?;
                if Some(asset) != old.spec.asset {
                    Arc::make_mut(&mut new.spec).asset = Some(asset);
                }
            }
            Ok(Change::Add(Arc::new(new)))
        };
        let arrivals = load.nodes.iter().map(&mut arrived).collect::<Result<Vec<_>, _>>()?;
        let inside = nodes.iter().map(|id| Edge::new(*id, Relation::InRoom, room));
        let links = load.inner.iter().copied().chain(inside).map(Change::Link);
        let crossing = Crossing {
            portal,
            from,
            to,
            left: load.leaving(),
            entered: arrivals.into_iter().chain(links).collect(),
            nodes,
        };
        self.change(&crossing.left, &crossing.entered, from, to).map_err(|mismatch| PassError::Taken(mismatch.node))?;
        if let Some(active) = self.active.get_mut(&to) {
            active.graph.assets = library;
        }
        self.settle(&crossing.nodes, to);
        Ok(crossing)
    }

    /// Undoes a passage.
    ///
    /// # Errors
    /// [`PassError::NotActive`] if one of the two regions is dormant, [`PassError::Changed`] if its scene has changed
    /// since; nothing has changed then.
    pub fn take_back(&mut self, crossing: &Crossing) -> Result<(), PassError> {
        if let Some(region) = [crossing.from, crossing.to].into_iter().find(|region| self.graph(*region).is_none()) {
            return Err(PassError::NotActive(region));
        }
        let undone = self.change(&crossing.left.inverse(), &crossing.entered.inverse(), crossing.from, crossing.to);
        undone.map_err(|mismatch| PassError::Changed(Box::new(mismatch)))?;
        self.settle(&crossing.nodes, crossing.from);
        Ok(())
    }

    fn way(&self, node: NodeId, portal: PortalId) -> Result<(RegionId, RegionId, Option<NodeId>), PassError> {
        let plan = self.space().portal(portal).ok_or(PassError::NoSuchPortal(portal))?;
        let region = self.region_of(node).filter(|_| self.node(node).is_some()).ok_or(PassError::NoSuchNode(node))?;
        let elsewhere = || PassError::Elsewhere { node: self.label(node), region, portal };
        let across = plan.across(region).ok_or_else(elsewhere)?;
        let passable = self.portal(portal).is_some_and(|state| state.passable);
        if passable { Ok((region, across.region, across.room)) } else { Err(PassError::Shut(portal)) }
    }

    /// Writes the changes of two scenes, or none.
    fn change(
        &mut self,
        here: &ChangeSet,
        there: &ChangeSet,
        from: RegionId,
        to: RegionId,
    ) -> Result<(), ChangeMismatch> {
        let before = self.graph(from).cloned();
        if let Some(active) = self.active.get_mut(&from) {
            here.apply(&mut active.graph)?;
        }
        let Some(active) = self.active.get_mut(&to) else { return Ok(()) };
        let result = there.apply(&mut active.graph);
        if let (Err(_), Some(active), Some(before)) = (&result, self.active.get_mut(&from), before) {
            active.graph = before;
        }
        result
    }

    /// Notes where nodes are.
    fn settle(&mut self, nodes: &[NodeId], region: RegionId) {
        for id in nodes {
            let at_home = self.made_in(*id) == Some(region);
            let moved = Arc::make_mut(&mut self.moved);
            if at_home {
                moved.remove(id)
            } else {
                moved.insert(*id, region)
            };
        }
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
    let at = graph.place(id).or_else(|| graph.holder(id));
    match at {
        Some(place) => Err(PassError::Resting { node, at: graph.label(place.at), region }),
        None => Ok(graph.carried_with(id)),
    }
}

/// Nodes that leave a scene together.
struct Load {
    /// The nodes without relations.
    nodes: Vec<Arc<Node>>,
    /// Relations among them.
    inner: Vec<Edge>,
    /// Relations to what stays.
    outer: Vec<Edge>,
}

impl Load {
    fn new(graph: &SceneGraph, ids: &[NodeId]) -> Self {
        let going: BTreeSet<NodeId> = ids.iter().copied().collect();
        let nodes = || ids.iter().filter_map(|id| graph.node(*id));
        let edges: BTreeSet<Edge> = nodes().flat_map(Node::edges).map(Edge::in_one_direction).collect();
        let (inner, outer) =
            edges.into_iter().partition(|edge: &Edge| going.contains(&edge.from) && going.contains(&edge.to));
        Self { nodes: nodes().map(|node| Arc::new(node.bare())).collect(), inner, outer }
    }

    /// The changes of the scene that they leave.
    fn leaving(&self) -> ChangeSet {
        let unlinked = self.outer.iter().chain(&self.inner).copied().map(Change::Unlink);
        unlinked.chain(self.nodes.iter().cloned().map(Change::Remove)).collect()
    }
}
