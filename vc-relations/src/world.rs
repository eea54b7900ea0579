//! The world: all bodies of a scene, their rooms, and the facts of every pair, kept up to date.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use vc_geometry::cache::AssetCache;
use vc_geometry::tree::{BoxTree, OverlappingPairs};
use vc_graph::{Aabb, AssetId, AssetLibrary, Node, NodeId, NodeKind, ObjectRole, Property, Relation, SceneGraph};

use crate::body::Body;
use crate::evidence::Evidence;
use crate::facts::Facts;
use crate::form::Form;
use crate::pair::{self, Pair, Tolerance};
use crate::room::Rooms;
use crate::targets::Targets;
use crate::threshold::{NEAR_REACH, REACH_SLACK, UNDER_REACH};
use crate::walls::{Among, Walls};

/// The bodies of a scene, in the order of their node numbers.
#[derive(Debug, Clone, Default)]
pub(crate) struct World {
    pub(crate) ids: Vec<NodeId>,
    /// Nodes removed since the last rebuild; they keep their index.
    gone: BTreeSet<NodeId>,
    /// `None` for nodes without geometry, and for rooms; clones share bodies that have not moved.
    pub(crate) bodies: Vec<Option<Arc<Body>>>,
    pub(crate) pairs: Vec<Vec<Pair>>,
    pub(crate) rooms: Rooms,
    pub(crate) tree: BoxTree,
    pub(crate) targets: Targets,
    pub(crate) walls: Walls,
    pub(crate) tolerance: Tolerance,
    forms: Forms,
}

/// The bodies whose relations may have changed with another's.
#[derive(Debug, Default)]
pub(crate) struct Affected {
    /// Those whose supports may have changed, and with them those of others.
    pub(crate) bound: Vec<u32>,
    /// Those that are or were only near it, or only see it.
    pub(crate) beside: Vec<u32>,
}

/// A node of the world as it is now.
pub(crate) struct Reading {
    pub(crate) index: usize,
    body: Option<Arc<Body>>,
    gone: bool,
}

/// Forms by asset, computed on first use; clones share them.
#[derive(Debug, Clone, Default)]
struct Forms {
    library: Arc<AssetLibrary>,
    known: Arc<AssetCache<AssetId, Form>>,
}

impl Forms {
    fn form_of(&self, node: &Node) -> Option<Arc<Form>> {
        if let Some(id) = node.spec().asset {
            let asset = self.library.get(id)?;
            let form = self.known.get(&self.library, id, |_| Form::new(asset));
            if !form.pieces.is_empty() {
                return Some(form);
            }
        }
        let bounds = node.spec().bounds?;
        let (low, high) = (bounds.offset - bounds.half, bounds.offset + bounds.half);
        Some(Arc::new(Form::boxed(low, high, is_container(node))))
    }
}

/// Whether a node of which only the box is known holds things inside.
fn is_container(node: &Node) -> bool {
    node.affords(Property::Container) || (node.affords(Property::Recipient) && !node.affords(Property::Surface))
}

impl World {
    /// An empty world with a tolerance for supports.
    pub(crate) fn with(tolerance: Tolerance) -> Self {
        Self { tolerance, ..Self::default() }
    }

    /// Whether its forms are those of a library.
    pub(crate) fn knows(&self, library: &Arc<AssetLibrary>) -> bool {
        Arc::ptr_eq(&self.forms.library, library)
    }

    /// Rebuilds everything; the forms of assets are kept.
    pub(crate) fn rebuild(&mut self, graph: &SceneGraph, evidence: &Evidence) {
        if !self.knows(graph.assets()) {
            self.forms = Forms { library: graph.assets().clone(), known: Arc::default() };
        }
        self.rooms = self.find_rooms(graph);
        self.ids = graph.nodes().map(Node::id).collect();
        self.gone.clear();
        self.bodies.clear();
        for node in graph.nodes() {
            let body = self.body(node, evidence);
            self.bodies.push(body);
        }
        self.walls = Walls::new(self.bodies.iter().flatten().map(Arc::as_ref));
        self.tree = BoxTree::new(&self.bodies.iter().map(region).collect::<Vec<_>>());
        self.targets = Targets::new(&self.bodies);
        self.measure_all();
    }

    fn find_rooms(&self, graph: &SceneGraph) -> Rooms {
        let mut bodies = BTreeMap::new();
        let floors = graph.rooms().iter().flat_map(|&room| graph.relating(Relation::InRoom, room));
        for id in floors.chain(graph.rooms().iter().copied()) {
            let Some(node) = graph.node(id) else { continue };
            let wanted = matches!(node.role(), ObjectRole::Room | ObjectRole::Floor);
            if wanted && let Some(form) = self.forms.form_of(node) {
                bodies.extend(Body::new(node, form, Vec::new()).map(|b| (id, b)));
            }
        }
        Rooms::new(graph, |id| bodies.get(&id).cloned())
    }

    fn body(&self, node: &Node, evidence: &Evidence) -> Option<Arc<Body>> {
        if node.kind() == NodeKind::Room {
            return None;
        }
        let form = self.forms.form_of(node)?;
        let position = |link| evidence.positions.get(&(node.id(), link)).copied();
        let positions = (0..form.joints.len() as u32).map(|link| position(link).unwrap_or(0.0)).collect();
        let mut body = Body::new(node, form, positions)?;
        body.room = self.rooms.room_of(&body);
        Some(Arc::new(body))
    }

    /// Index of the body of an existing node.
    pub(crate) fn index(&self, id: NodeId) -> Option<usize> {
        self.ids.binary_search(&id).ok().filter(|_| !self.gone.contains(&id))
    }

    fn measure_all(&mut self) {
        let mut pairs = std::mem::take(&mut self.pairs);
        pairs.iter_mut().for_each(Vec::clear);
        pairs.resize_with(self.bodies.len(), || Vec::with_capacity(16));
        let zones: Vec<Aabb> = self.bodies.iter().map(|b| zone(b, 0.5)).collect();
        let overlaps = OverlappingPairs::new(&zones);
        let mut walls = Among::new(&self.walls);
        for (i, a) in self.bodies.iter().enumerate() {
            let Some(a) = a.as_deref() else { continue };
            let others =
                || overlaps.partners(i).iter().filter_map(|&j| Some((j as usize, self.bodies[j as usize].as_deref()?)));
            walls.gather(a, others().map(|(_, b)| b));
            // In this order every list comes out sorted.
            for (j, b) in others() {
                if let Some((ab, ba)) = pair::measure((i, a), (j, b), (&walls, self.tolerance)) {
                    pairs[i].push(ab);
                    pairs[j].push(ba);
                }
            }
        }
        self.pairs = pairs;
    }

    /// Reads one node again; `None` if the scene must be rebuilt, as for a room or part of the building, an unknown
    /// node, or one that was not lookable before.
    pub(crate) fn read(&self, graph: &SceneGraph, id: NodeId, evidence: &Evidence) -> Option<Reading> {
        let index = self.index(id)?;
        let node = graph.node(id);
        let body = node.and_then(|n| self.body(n, evidence));
        let is_building = |b: &Option<Arc<Body>>| b.as_ref().is_some_and(|b| b.traits.structure);
        let is_room = node.map_or_else(|| self.rooms.has(id), |n| n.kind() == NodeKind::Room);
        let stays = !is_room && !is_building(&body) && !is_building(&self.bodies[index]);
        (stays && self.targets.takes(index, &body)).then_some(Reading { index, body, gone: node.is_none() })
    }

    /// Puts a node as it was read, and measures its pairs. Adds the bodies it had pairs with before and has now.
    pub(crate) fn put(&mut self, Reading { index, body, gone }: Reading, affected: &mut Affected) {
        self.targets.set(index, &body);
        if gone {
            self.gone.insert(self.ids[index]);
        }
        self.meet(index, affected);
        for pair in std::mem::take(&mut self.pairs[index]) {
            let theirs = &mut self.pairs[pair.other as usize];
            if let Ok(at) = theirs.binary_search_by_key(&(index as u32), |p| p.other) {
                theirs.remove(at);
            }
        }
        self.tree.set(index, region(&body));
        self.bodies[index] = body;
        self.pairs[index] = self.measure_one(index);
        self.meet(index, affected);
    }

    /// Adds the bodies with which a body has pairs.
    fn meet(&self, index: usize, affected: &mut Affected) {
        for pair in &self.pairs[index] {
            let back = self.pair(pair.other as usize, index);
            let bound = pair.is_bound() || back.is_some_and(Pair::is_bound);
            let list = if bound { &mut affected.bound } else { &mut affected.beside };
            list.push(pair.other);
        }
    }

    /// Measures the pairs of one body; the opposite directions are put into the others' lists.
    fn measure_one(&mut self, index: usize) -> Vec<Pair> {
        let Some(a) = self.bodies[index].as_deref() else { return Vec::new() };
        let mut affected = Vec::new();
        self.tree.for_each(&zone(&self.bodies[index], 1.0), |j| affected.push(j));
        let others = || affected.iter().filter(|&&j| j != index).filter_map(|&j| Some((j, self.bodies[j].as_deref()?)));
        let mut walls = Among::new(&self.walls);
        walls.gather(a, others().map(|(_, b)| b));
        let (mut own, mut theirs) = (Vec::new(), Vec::new());
        for (j, b) in others() {
            // Measured in the order of a full build, so that the figures are the same to the last bit.
            let (first, second) = if index < j { ((index, a), (j, b)) } else { ((j, b), (index, a)) };
            if let Some((p, q)) = pair::measure(first, second, (&walls, self.tolerance)) {
                let (ab, ba) = if index < j { (p, q) } else { (q, p) };
                own.push(ab);
                theirs.push((j, ba));
            }
        }
        own.sort_unstable_by_key(|p| p.other);
        for (j, pair) in theirs {
            let list = &mut self.pairs[j];
            let at = list.partition_point(|p| p.other < pair.other);
            list.insert(at, pair);
        }
        own
    }

    /// The bodies below one, or beside but not above it, by number.
    pub(crate) fn below(&self, index: usize) -> Vec<usize> {
        let Some(body) = &self.bodies[index] else { return Vec::new() };
        let mut column = body.region;
        column.min.z -= UNDER_REACH;
        let mut found = Vec::new();
        self.tree.for_each(&column, |other| {
            if other != index {
                found.push(other);
            }
        });
        found.sort_unstable();
        found
    }

    /// Extends the bound bodies by those that touch them or may rest on them by joint or contact, directly or
    /// through others, but not through the building, and by those below any of these, as their supports and the
    /// things they are under depend on each other. Returns the nodes with those beside, by number.
    pub(crate) fn spread(&self, affected: Affected, facts: &Facts) -> Vec<NodeId> {
        let Affected { bound: mut affected, beside } = affected;
        let mut known = vec![false; self.bodies.len()];
        affected.retain(|&m| !std::mem::replace(&mut known[m as usize], true));
        let mut next = 0;
        while let Some(&index) = affected.get(next) {
            next += 1;
            if self.bodies[index as usize].as_deref().is_some_and(|b| b.traits.structure) {
                continue;
            }
            let touching = self.pairs[index as usize].iter().filter(|p| p.gap.is_finite() || p.hooked);
            let carried = facts.carried(self.ids[index as usize]).filter_map(|id| self.index(id));
            for other in touching.map(|p| p.other).chain(carried.map(|i| i as u32)) {
                if !std::mem::replace(&mut known[other as usize], true) {
                    affected.push(other);
                }
            }
        }
        for above in 0..affected.len() {
            let index = affected[above] as usize;
            for pair in self.pairs[index].iter().filter(|p| p.is_below) {
                if !std::mem::replace(&mut known[pair.other as usize], true) {
                    affected.push(pair.other);
                }
            }
        }
        affected.extend(beside.into_iter().filter(|&m| !std::mem::replace(&mut known[m as usize], true)));
        affected.sort_unstable();
        affected.into_iter().map(|m| self.ids[m as usize]).collect()
    }

    /// The pair of one body with another.
    pub(crate) fn pair(&self, of: usize, with: usize) -> Option<&Pair> {
        let list = &self.pairs[of];
        list.binary_search_by_key(&(with as u32), |p| p.other).ok().map(|at| &list[at])
    }
}

fn region(body: &Option<Arc<Body>>) -> Aabb {
    body.as_ref().map_or(Aabb::EMPTY, |b| b.region)
}

/// The region in which other bodies can affect a body, or a share of its margin.
fn zone(body: &Option<Arc<Body>>, share: f32) -> Aabb {
    region(body).grown(share * (NEAR_REACH + REACH_SLACK), share * (UNDER_REACH + REACH_SLACK))
}
