//! The state of a world: the scenes of its active regions, and what has changed in the others.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::{NumberBlock, PortalId, PortalState, RegionFrame, RegionId, Space, SpaceError};
use crate::{Action, AssetLibrary, ChangeSet, Digest, Edit, Label, Node, NodeId, Refusal, SceneGraph, State, rule};

/// The numbers that a region whose block is full gets at a time.
const SLICE: u32 = 4096;
/// The numbers that a scene has left when an edit begins, at least.
const SPARE: u32 = 256;

/// The scenes of a world, region by region.
///
/// A region is *active* while its scene is here; it becomes *dormant* by [`RegionGraphs::rest`], which keeps what has
/// changed since it was made, and active again by [`RegionGraphs::insert`] with the scene as it was made. No relation leads
/// from one region to another; [`RegionGraphs::pass`] takes those who go through a portal, with all that they carry, from one
/// scene to the other.
///
/// Cloning costs a pointer for each active region. No call costs more for a larger world, but for binary searches.
#[derive(Clone)]
pub struct RegionGraphs {
    space: Arc<Space>,
    pub(super) active: BTreeMap<RegionId, Active>,
    pub(super) dormant: Arc<BTreeMap<RegionId, Dormant>>,
    /// The regions of nodes that are not where they were made.
    pub(super) moved: Arc<BTreeMap<NodeId, RegionId>>,
    /// The regions that go on with numbers of the overflow, by their slices.
    pub(super) slices: Arc<[RegionId]>,
    /// Where the regions that move are, if not at their first stop.
    pub(super) stops: Arc<BTreeMap<RegionId, Position>>,
}

/// Where a region that moves is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) enum Position {
    /// At a stop, counted from 0.
    At(u32),
    /// Between stops: no portal of it is there.
    Between(RegionFrame),
}

/// A scene, and the same as it was made.
#[derive(Clone)]
pub(super) struct Active {
    pub(super) graph: SceneGraph,
    made: SceneGraph,
}

/// The record of a region that was left.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Dormant {
    /// The scene as it was made.
    pub(super) made: Digest,
    pub(super) changes: ChangeSet,
    pub(super) numbers: NumberBlock,
    pub(super) next: u32,
    /// The shapes, if some came from other regions.
    pub(super) assets: Option<Arc<AssetLibrary>>,
    /// The leaves of its portals that are open.
    pub(super) open: Vec<NodeId>,
}

impl RegionGraphs {
    /// A world in which no region has been active.
    pub fn new(space: Arc<Space>) -> Self {
        let (dormant, moved, stops) = Default::default();
        Self { space, active: BTreeMap::new(), dormant, moved, slices: Arc::new([]), stops }
    }

    /// The plan of the world.
    pub fn space(&self) -> &Arc<Space> {
        &self.space
    }

    /// Makes a region active, with the scene that its generator made. Changes from before it was left are done again.
    ///
    /// # Errors
    /// [`SpaceError::NoScene`], [`SpaceError::Active`], [`SpaceError::ForeignNumber`]; [`SpaceError::MadeOtherwise`] if the
    /// scene is not as it was made when the region was active before. Nothing has changed then.
    pub fn insert(&mut self, region: RegionId, made: SceneGraph) -> Result<(), SpaceError> {
        let plan = self.space.region(region).filter(|plan| plan.has_scene()).ok_or(SpaceError::NoScene(region))?;
        if self.active.contains_key(&region) {
            return Err(SpaceError::Active(region));
        }
        if let Some(node) = made.nodes().find(|node| !plan.numbers.has(node.id())) {
            return Err(SpaceError::ForeignNumber { region, node: node.label() });
        }
        let mut graph = made.clone();
        graph.number_in(plan.numbers, plan.numbers.first);
        if let Some(dormant) = self.dormant.get(&region) {
            let (before, now) = (dormant.made, made.digest());
            let otherwise = SpaceError::MadeOtherwise { region, before, now };
            if before != now || dormant.changes.apply(&mut graph).is_err() {
                return Err(otherwise);
            }
            graph.number_in(dormant.numbers, dormant.next);
            graph.assets = dormant.assets.clone().unwrap_or(graph.assets);
            Arc::make_mut(&mut self.dormant).remove(&region);
        }
        self.active.insert(region, Active { graph, made });
        Ok(())
    }

    /// Makes a region dormant: its scene goes, what has changed since it was made stays. Costs what has changed, and a digest of the
    /// scene.
    ///
    /// # Errors
    /// [`SpaceError::NoScene`] if it is not active.
    pub fn rest(&mut self, region: RegionId) -> Result<(), SpaceError> {
        let record = self.record(region).ok_or(SpaceError::NoScene(region))?;
        self.active.remove(&region);
        Arc::make_mut(&mut self.dormant).insert(region, record);
        Ok(())
    }

    /// The record of an active region, as if it were left now.
    pub(super) fn record(&self, region: RegionId) -> Option<Dormant> {
        let Active { graph, made } = self.active.get(&region)?;
        let leaves = self.space.portals_of(region).filter_map(|portal| self.space.portal(portal)?.leaf);
        let open = leaves.filter(|leaf| graph.node(*leaf).is_some_and(|node| node.is(State::Open))).collect();
        Some(Dormant {
            made: made.digest(),
            changes: ChangeSet::between(made, graph),
            numbers: graph.numbers,
            next: graph.next,
            assets: (!Arc::ptr_eq(&graph.assets, &made.assets)).then(|| graph.assets.clone()),
            open,
        })
    }

    /// The active regions, in order.
    pub fn active(&self) -> impl Iterator<Item = RegionId> + '_ {
        self.active.keys().copied()
    }

    /// The changes that a dormant region keeps; `None` if it is active or has never been so.
    pub fn changes(&self, region: RegionId) -> Option<&ChangeSet> {
        self.dormant.get(&region).map(|dormant| &dormant.changes)
    }

    /// The scene of an active region.
    pub fn graph(&self, region: RegionId) -> Option<&SceneGraph> {
        self.active.get(&region).map(|active| &active.graph)
    }

    /// Begins an edit in an active region. At least 256 nodes can be added in it: a region with fewer numbers left goes on
    /// with some of the world's overflow.
    pub fn edit(&mut self, region: RegionId) -> Option<Edit<'_>> {
        self.prepare(region)?;
        self.active.get_mut(&region).map(|active| active.graph.edit())
    }

    /// Does an action by the transition rule, in the agent's region.
    ///
    /// # Errors
    /// Every [`Refusal`], as [`rule::step`]; [`Refusal::NoSuchThing`] if the agent is in no active region.
    pub fn step(&mut self, agent: NodeId, action: &Action) -> Result<ChangeSet, Vec<Refusal>> {
        let nobody = || vec![Refusal::NoSuchThing(agent)];
        let region = self.region_of(agent).ok_or_else(nobody)?;
        let active = self.active.get_mut(&region).ok_or_else(nobody)?;
        rule::step(&mut active.graph, agent, action)
    }

    /// The region of a node: where it was made, unless it has moved. A number that no node has may have a region, too.
    pub fn region_of(&self, node: NodeId) -> Option<RegionId> {
        self.moved.get(&node).copied().or_else(|| self.made_in(node))
    }

    /// A node of an active region.
    pub fn node(&self, id: NodeId) -> Option<&Node> {
        self.graph(self.region_of(id)?)?.node(id)
    }

    /// Class and number of a node, for messages; the class is `?` where its region is not active.
    pub fn label(&self, id: NodeId) -> Label {
        self.node(id).map_or_else(|| Label { class: "?".into(), id }, Node::label)
    }

    /// Whether a portal lets people, views and sounds through now. The leaf of a region that has never been active is shut;
    /// so is a portal whose region has moved away.
    pub fn portal(&self, portal: PortalId) -> Option<PortalState> {
        let plan = self.space.portal(portal)?;
        let is_there = plan.sides.iter().all(|side| self.is_at(side.region, plan.stop));
        if !is_there {
            return Some(PortalState::CLOSED);
        }
        Some(plan.state(plan.leaf.is_some_and(|leaf| self.is_open(leaf))))
    }

    /// Whether a region is where its portals of a stop are; one that does not move always is.
    fn is_at(&self, region: RegionId, stop: u32) -> bool {
        let moves = self.space.region(region).is_some_and(|region| !region.stops.is_empty());
        !moves || self.stop_of(region) == Some(stop)
    }

    /// The stop at which a region that moves is, counted from 0; `None` while it is between two, or if it does not move.
    pub fn stop_of(&self, region: RegionId) -> Option<u32> {
        self.space.region(region).filter(|region| !region.stops.is_empty())?;
        match self.stops.get(&region) {
            None => Some(0),
            Some(Position::At(stop)) => Some(*stop),
            Some(Position::Between(_)) => None,
        }
    }

    /// Where a region is now: in its frame, or wherever it has moved to.
    pub fn frame(&self, region: RegionId) -> Option<RegionFrame> {
        let plan = self.space.region(region)?;
        Some(match self.stops.get(&region) {
            None => plan.frame,
            Some(Position::At(stop)) => plan.frame_at(*stop as usize),
            Some(Position::Between(frame)) => *frame,
        })
    }

    /// Takes a region that moves to one of its stops, with all that is in it.
    ///
    /// # Errors
    /// [`SpaceError::StopUnknown`].
    pub fn stop_at(&mut self, region: RegionId, stop: u32) -> Result<(), SpaceError> {
        let stops = self.space.region(region).map_or(0, |plan| plan.stops.len());
        if stop as usize >= stops {
            return Err(SpaceError::StopUnknown { region, stop, stops });
        }
        let positions = Arc::make_mut(&mut self.stops);
        if stop == 0 {
            positions.remove(&region)
        } else {
            positions.insert(region, Position::At(stop))
        };
        Ok(())
    }

    /// Takes a region that moves somewhere between its stops, where none of its portals is.
    ///
    /// # Errors
    /// [`SpaceError::StopUnknown`] if it does not move, [`SpaceError::NotFinite`].
    pub fn move_between(&mut self, region: RegionId, frame: RegionFrame) -> Result<(), SpaceError> {
        let plan = self.space.region(region).filter(|plan| !plan.stops.is_empty());
        let plan = plan.ok_or(SpaceError::StopUnknown { region, stop: 0, stops: 0 })?;
        if !frame.is_finite() {
            return Err(SpaceError::NotFinite(plan.name.to_string()));
        }
        Arc::make_mut(&mut self.stops).insert(region, Position::Between(frame));
        Ok(())
    }

    fn is_open(&self, leaf: NodeId) -> bool {
        let Some(region) = self.region_of(leaf) else { return false };
        match self.graph(region) {
            Some(graph) => graph.node(leaf).is_some_and(|node| node.is(State::Open)),
            None => self.dormant.get(&region).is_some_and(|dormant| dormant.open.contains(&leaf)),
        }
    }

    pub(super) fn made_in(&self, node: NodeId) -> Option<RegionId> {
        let slice = || Some(node.0.checked_sub(NumberBlock::OVERFLOW.first)? / SLICE);
        self.space.made_in(node).or_else(|| self.slices.get(slice()? as usize).copied())
    }

    /// Lets an active region go on with numbers of the overflow if it has few left.
    fn prepare(&mut self, region: RegionId) -> Option<()> {
        let graph = &mut self.active.get_mut(&region)?.graph;
        if graph.numbers.end().saturating_sub(graph.next) < SPARE {
            let slice = self.slices.len() as u32;
            let first = NumberBlock::OVERFLOW.first.checked_add(slice.checked_mul(SLICE)?)?;
            let numbers = NumberBlock { first, count: SLICE };
            if NumberBlock::OVERFLOW.has(NodeId(numbers.end() - 1)) {
                graph.number_in(numbers, first);
                self.slices = self.slices.iter().copied().chain([region]).collect();
            }
        }
        Some(())
    }
}

/// Two worlds are equal if their plans are, the scenes of their active regions, what changed in the others, and where things
/// are.
impl PartialEq for RegionGraphs {
    fn eq(&self, other: &Self) -> bool {
        let scenes = || self.active.iter().map(|(id, active)| (id, &active.graph));
        self.space == other.space
            && scenes().eq(other.active.iter().map(|(id, active)| (id, &active.graph)))
            && (&self.dormant, &self.moved, &self.slices) == (&other.dormant, &other.moved, &other.slices)
            && self.stops == other.stops
    }
}

impl std::fmt::Debug for RegionGraphs {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let graphs = self.active.iter().map(|(id, active)| (id, &active.graph));
        write!(f, "RegionGraphs({} dormant) ", self.dormant.len())?;
        f.debug_map().entries(graphs).finish()
    }
}
