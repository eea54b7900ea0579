//! The scene graph: nodes, their relations, and queries about them.

use std::collections::BTreeMap;
use std::sync::Arc;

use nalgebra::Point3;

use crate::asset::AssetLibrary;
use crate::class::ClassTable;
use crate::grid::Grid;
use crate::node::{Link, Node, NodeKind};
use crate::spelling::key;
use crate::store::Store;
use crate::visit_order::VisitOrder;
use crate::{Edge, Label, NodeId, ObjectRole, Place, Property, Relation, State};

/// The distance up to which an object counts as near: within reach of an agent's step and arm, metres.
/// VirtualHome's CLOSE uses the same value.
pub const NEAR: f32 = 1.5;
/// The class of the switch of a room's lamps.
const LIGHT_SWITCH: &str = "lightswitch";

/// Rooms, agents and objects with their states, poses and relations.
///
/// Cloning shares everything until one of the two is edited, so a search may clone freely. Iteration is always
/// in the order of node numbers. Build one with [`SceneBuilder`](crate::SceneBuilder) or read one with
/// [`format`](crate::format); change it with [`SceneGraph::edit`] or, through an agent's actions, with
/// [`Simulator`](crate::Simulator).
///
/// ```
/// use vc_graph::{Draft, Relation, SceneBuilder};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let graph = scene.build();
/// assert_eq!(graph.room_of(apple), Some(kitchen));
/// assert_eq!(graph.of_class("table"), [table]); // a kitchen table is a table
/// assert_eq!(graph.label(apple).to_string(), "apple.3");
/// # Ok::<(), vc_graph::EditError>(())
/// ```
#[derive(Clone)]
pub struct SceneGraph {
    pub(crate) name: Arc<str>,
    pub(crate) classes: Arc<ClassTable>,
    pub(crate) assets: Arc<AssetLibrary>,
    pub(crate) nodes: Store<Node>,
    pub(crate) by_class: Arc<BTreeMap<Arc<str>, Vec<NodeId>>>,
    pub(crate) rooms: Arc<Vec<NodeId>>,
    pub(crate) agents: Arc<Vec<NodeId>>,
    pub(crate) grid: Arc<Grid>,
    pub(crate) next: u32,
}

impl SceneGraph {
    /// An empty scene with a class table.
    pub fn new(name: impl Into<Arc<str>>, classes: Arc<ClassTable>) -> Self {
        Self {
            name: name.into(),
            classes,
            assets: Arc::default(),
            nodes: Store::default(),
            by_class: Arc::default(),
            rooms: Arc::default(),
            agents: Arc::default(),
            grid: Arc::default(),
            next: 1,
        }
    }

    /// The scene's name, `Apartment_0`.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The scene's class table.
    pub fn classes(&self) -> &Arc<ClassTable> {
        &self.classes
    }

    /// The asset library that the nodes' asset identifiers refer to.
    pub fn assets(&self) -> &Arc<AssetLibrary> {
        &self.assets
    }

    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Whether there are no nodes.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The node with a number.
    pub fn node(&self, id: NodeId) -> Option<&Node> {
        self.nodes.get(id).map(Arc::as_ref)
    }

    /// All nodes.
    pub fn nodes(&self) -> impl Iterator<Item = &Node> {
        self.nodes.iter().map(Arc::as_ref)
    }

    /// Class and number of a node, for messages; the class of a missing node is `?`.
    pub fn label(&self, id: NodeId) -> Label {
        self.node(id).map_or_else(|| Label { class: "?".into(), id }, Node::label)
    }

    /// The node of a class, or of a kind of it, with the smallest number.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let desk = scene.add(Draft::new("desk_lamp"))?;
    /// let scene = scene.build();
    /// assert_eq!((scene.first_of_class("lamp"), scene.first_of_class("mug")), (Some(desk), None));
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    pub fn first_of_class(&self, class: &str) -> Option<NodeId> {
        self.of_class(class).first().copied()
    }

    /// The rooms.
    pub fn rooms(&self) -> &[NodeId] {
        &self.rooms
    }

    /// The agents.
    pub fn agents(&self) -> &[NodeId] {
        &self.agents
    }

    /// The nodes of a role, in number order. Costs a step for each node of the scene.
    ///
    /// ```
    /// use vc_graph::{Draft, ObjectRole, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let [_, window] = [scene.add(Draft::new("wall"))?, scene.add(Draft::new("roof_window"))?];
    /// let scene = scene.build();
    /// assert_eq!(scene.of_role(ObjectRole::Window).map(|node| node.id()).collect::<Vec<_>>(), [window]);
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    pub fn of_role(&self, role: ObjectRole) -> impl Iterator<Item = &Node> {
        self.nodes().filter(move |node| node.role() == role)
    }

    /// Nodes of a class (in any spelling) and of its descendants: `table` finds kitchen tables. Costs a look-up
    /// for each descendant class.
    pub fn of_class(&self, class: &str) -> Vec<NodeId> {
        let mut found: Vec<NodeId> = match self.classes.get(class) {
            Some(class) => self
                .classes
                .kinds_of(class)
                .filter_map(|kind| self.by_class.get(&kind.name))
                .flatten()
                .copied()
                .collect(),
            None => self.by_class.get(key(class).as_str()).cloned().unwrap_or_default(),
        };
        found.sort_unstable();
        found
    }

    /// All nodes in a room, at whatever place in it.
    pub fn in_room(&self, room: NodeId) -> impl Iterator<Item = NodeId> + '_ {
        self.relating(Relation::InRoom, room)
    }

    /// The room that a node is in; a room is in itself.
    pub fn room_of(&self, id: NodeId) -> Option<NodeId> {
        let node = self.node(id)?;
        match node.kind() {
            NodeKind::Room => Some(id),
            _ => node.out(Relation::InRoom).next(),
        }
    }

    /// Nodes whose position is within `radius` metres of a point, borders included. A grid makes the cost grow
    /// with the number of nodes found, not with the scene.
    pub fn within(&self, centre: Point3<f32>, radius: f32) -> Vec<NodeId> {
        self.grid.within(centre, radius)
    }

    /// Whether an object covers a window or a door when it is closed: a curtain, blinds, a shutter or a kind of
    /// these. Other covers, such as lids, bags and umbrellas, do not count. `false` if there is no such node.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let [blinds, umbrella] = [scene.add(Draft::new("blinds"))?, scene.add(Draft::new("umbrella"))?];
    /// let scene = scene.build();
    /// assert!(scene.covers_windows(blinds) && !scene.covers_windows(umbrella));
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    pub fn covers_windows(&self, id: NodeId) -> bool {
        self.node(id).is_some_and(|n| n.affords(Property::Openable) && n.role() == ObjectRole::Cover)
    }

    /// Whether a thing that can glow does: it is on, or it is a lamp without a switch of its own and a light switch of
    /// its room is on, as in VirtualHome's scenes. False if there is no such node.
    ///
    /// ```
    /// use vc_graph::{Draft, PropertySet, SceneBuilder, State};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let lamp = Draft { properties: Some(PropertySet::default()), ..Draft::new("ceiling_lamp") };
    /// let lamp = scene.add_in(kitchen, lamp)?;
    /// let switch = scene.add_in(kitchen, Draft::new("lightswitch").state(State::On))?;
    /// let mut scene = scene.build();
    /// assert!(scene.is_lit(lamp));
    /// let mut edit = scene.edit();
    /// edit.enter_state(switch, State::Off)?;
    /// edit.commit();
    /// assert!(!scene.is_lit(lamp));
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    pub fn is_lit(&self, id: NodeId) -> bool {
        let on = |id: NodeId| self.node(id).is_some_and(|n| n.is(State::On));
        on(id) || self.light_switches(id).any(on)
    }

    /// The light switches by which a lamp is switched that has no switch of its own: those of its room. None for all
    /// other things.
    pub fn light_switches(&self, lamp: NodeId) -> impl Iterator<Item = NodeId> + '_ {
        let is = |n: &Node, class: &str| self.classes().is_a(n.class(), class);
        let fixed = |n: &&Node| !n.affords(Property::Switchable) && !n.affords(Property::Graspable);
        let lamp = self.node(lamp).filter(fixed).filter(|n| n.role() == ObjectRole::Light);
        let room = lamp.and_then(|n| self.room_of(n.id));
        let things = room.into_iter().flat_map(|room| self.in_room(room));
        things.filter(move |id| self.node(*id).is_some_and(|n| is(n, LIGHT_SWITCH) && n.affords(Property::Switchable)))
    }

    /// The nodes that a relation leads to from a node.
    pub fn related(&self, from: NodeId, relation: Relation) -> impl Iterator<Item = NodeId> + '_ {
        self.node(from).into_iter().flat_map(move |n| n.out(relation))
    }

    /// The nodes from which a relation leads to a node.
    pub fn relating(&self, relation: Relation, to: NodeId) -> impl Iterator<Item = NodeId> + '_ {
        self.node(to).into_iter().flat_map(move |n| n.inc(relation))
    }

    /// Whether a relation holds as an edge of the graph.
    pub fn has(&self, edge: Edge) -> bool {
        self.node(edge.from).is_some_and(|n| n.has(edge.relation, edge.to))
    }

    /// All relations, ordered by start, kind and end; symmetric relations occur in both directions.
    pub fn edges(&self) -> impl Iterator<Item = Edge> + '_ {
        self.nodes().flat_map(|n| n.out.iter().map(|l| Edge::new(n.id, l.relation(), l.node())))
    }

    /// The objects that an agent holds, the right hand first.
    pub fn held(&self, agent: NodeId) -> impl Iterator<Item = NodeId> + '_ {
        Relation::hands().into_iter().flat_map(move |hand| self.related(agent, hand))
    }

    /// A free hand of an agent, the right one first.
    pub fn free_hand(&self, agent: NodeId) -> Option<Relation> {
        Relation::hands().into_iter().find(|&hand| self.related(agent, hand).next().is_none())
    }

    /// The agent that holds an object, and the hand.
    pub fn holder(&self, id: NodeId) -> Option<Place> {
        self.node(id)?.holders().next()
    }

    /// All direct placements of a node.
    pub fn places(&self, id: NodeId) -> impl Iterator<Item = Place> + '_ {
        let node = self.node(id);
        let holders = node.into_iter().flat_map(Node::holders);
        holders.chain(node.into_iter().flat_map(Node::resting))
    }

    /// The direct placement of a node; in nested containers the innermost. `None` for an object that stands in
    /// the room itself.
    ///
    /// If placements contradict each other, as in real scenes in which a pot is on a table and in a closed
    /// dishwasher beside it, containment wins: a support counts only if it is inside the same containers.
    pub fn place(&self, id: NodeId) -> Option<Place> {
        let depth = |p: &Place| self.related(p.at, Relation::Inside).count();
        let within = |p: &Place| {
            p.relation == Relation::Inside
                || self.related(id, Relation::Inside).all(|c| c == p.at || self.rests_at(p.at, c))
        };
        let mut best: Option<(usize, Place)> = None;
        for place in self.places(id).filter(within) {
            let rank = depth(&place) + if place.relation == Relation::Inside { 0 } else { 1000 };
            if best.is_none_or(|(r, _)| rank > r) {
                best = Some((rank, place));
            }
        }
        best.map(|(_, place)| place)
    }

    /// Everything that directly rests on, in or with a node, or is held by it.
    pub fn resting_at(&self, id: NodeId) -> impl Iterator<Item = NodeId> + '_ {
        self.node(id).into_iter().flat_map(Node::carried)
    }

    /// The node and everything that moves with it, itself first.
    pub fn carried_with(&self, id: NodeId) -> Vec<NodeId> {
        let mut met = VisitOrder::default();
        met.add(id);
        let mut next = 0;
        while let Some(node) = met.get(next) {
            next += 1;
            for child in self.resting_at(node) {
                met.add(child);
            }
        }
        met.into_vec()
    }

    /// The supports and containers of a node, direct and indirect, nearest first.
    pub fn support_chain(&self, id: NodeId) -> Vec<NodeId> {
        let mut chain = Vec::new();
        self.climb(id, &mut |place| {
            chain.push(place.at);
            false
        });
        chain
    }

    /// Visits the placements of a node upwards, nearest first, until `stop` returns `true`. The data may be
    /// cyclic and chains may have any length.
    pub(crate) fn climb(&self, id: NodeId, stop: &mut impl FnMut(Place) -> bool) -> Option<NodeId> {
        let mut met = VisitOrder::default();
        let (mut node, mut next) = (Some(id), 0);
        while let Some(from) = node {
            for place in self.places(from) {
                if met.add(place.at) && stop(place) {
                    return Some(place.at);
                }
            }
            node = met.get(next);
            next += 1;
        }
        None
    }

    /// The closed container that hides a node, the nearest if several do. A container that by the relations is
    /// inside itself, directly or indirectly, does not hide itself.
    pub fn hidden_in(&self, id: NodeId) -> Option<NodeId> {
        let shut = |p: Place| p.relation == Relation::Inside && self.node(p.at).is_some_and(Node::hides_contents);
        let closed = |p: Place| shut(p) && p.at != id && !self.rests_at(p.at, id);
        self.climb(id, &mut { closed })
    }

    /// Whether `id` rests on or in `at`, directly or through other objects.
    pub fn rests_at(&self, id: NodeId, at: NodeId) -> bool {
        self.climb(id, &mut |p| p.at == at).is_some()
    }

    /// Whether an agent is near an object. It is if the agent holds or wears it or rests on it; if the graph
    /// says so; if poses are known, the room is the same and its box is within [`NEAR`] metres; or if the
    /// object rests on or in something near, or is near the same object as the agent (VirtualHome's rule).
    ///
    /// The last case does not reach into the next room: if poses and rooms are known, a picture on the other
    /// side of the wall that the agent stands at is not near.
    pub fn near(&self, agent: NodeId, id: NodeId) -> bool {
        let (Some(body), Some(node)) = (self.node(agent), self.node(id)) else { return false };
        if node.affords(crate::Property::BodyPart) || body.has(Relation::Near, id) {
            return true;
        }
        if node.kind() == NodeKind::Room {
            return self.room_of(agent) == Some(id);
        }
        if self.within_reach(body, node) {
            return true;
        }
        let here = !self.is_next_door(body, node);
        let at_hand = |p: Place| p.at == agent || (here && body.has(Relation::Near, p.at));
        self.climb(id, &mut { at_hand }).is_some() || self.rests_at(agent, id) || (here && body.is_near_what(node))
    }

    /// Whether the object is known to be in another room, by poses and rooms: then the object that both are
    /// near is the door or the wall between them.
    fn is_next_door(&self, agent: &Node, node: &Node) -> bool {
        let rooms = (self.room_of(agent.id), self.room_of(node.id));
        agent.pose.is_some() && node.pose.is_some() && rooms.0.is_some() && rooms.1.is_some() && rooms.0 != rooms.1
    }

    fn within_reach(&self, agent: &Node, node: &Node) -> bool {
        self.room_of(agent.id) == self.room_of(node.id) && self.distance(agent.id, node.id).is_some_and(|d| d <= NEAR)
    }

    /// Horizontal distance from a node's position to another's box (to its position, if it has no box), metres;
    /// `None` without poses.
    pub fn distance(&self, from: NodeId, to: NodeId) -> Option<f32> {
        let start = self.node(from)?.position()?;
        let target = self.node(to)?;
        let nearest = match target.aabb() {
            Some(aabb) => aabb.nearest(&start),
            None => target.position()?,
        };
        Some((nearest - start).xy().norm())
    }

    /// Whether an agent faces an object, directly or through one intermediate object (a computer screen that
    /// the agent faces may itself face the object).
    pub fn facing(&self, agent: NodeId, id: NodeId) -> bool {
        self.has(Edge::new(agent, Relation::Facing, id))
            || self.related(agent, Relation::Facing).any(|n| self.has(Edge::new(n, Relation::Facing, id)))
    }
}

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

/// Prints a short summary; to see the whole scene, write it in one of the formats.
impl std::fmt::Debug for SceneGraph {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let digest = self.digest();
        write!(f, "SceneGraph({}, {} nodes, digest {digest})", self.name, self.len())
    }
}

/// Two scenes are equal if name, nodes and relations are equal. Their editing histories do not matter.
impl PartialEq for SceneGraph {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name && self.len() == other.len() && self.nodes.iter().eq(other.nodes.iter())
    }
}
