//! Edits that keep a scene's invariants.

use std::sync::Arc;

use nalgebra::Vector3;

use crate::geometry::is_finite;
use crate::node::{Draft, Node, NodeKind, Spec};
use crate::{
    Bounds, Change, ChangeSet, Edge, Label, NodeId, Place, Pose, Property, PropertySet, Relation, SceneGraph, State,
    StateSet,
};

/// The reason why an edit was refused; the graph is as it was before that call.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error, serde::Serialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum EditError {
    /// There is no such node.
    #[error("there is no node {0} in this scene")]
    NoSuchNode(NodeId),
    /// A node number is taken.
    #[error("node {0} exists already; give the new node another number")]
    Duplicate(NodeId),
    /// The last node number has been used.
    #[error("all node numbers are used up")]
    NumbersExhausted,
    /// An object would rest on itself.
    #[error("{thing} cannot rest at {at}: {at} itself rests on or in {thing}")]
    SupportCycle {
        /// The object to be placed.
        thing: Label,
        /// The place.
        at: Label,
    },
    /// A node is of the wrong kind for its role.
    #[error("{node} is no {needed}")]
    WrongKind {
        /// The node.
        node: Label,
        /// The kind it should have been.
        needed: &'static str,
    },
    /// The agent's hands are full.
    #[error("{agent} has no free hand")]
    HandsFull {
        /// The agent.
        agent: Label,
    },
    /// A relation that gives a location cannot be set directly.
    #[error("`{0}` gives an object's location; use `place`, `hold` or `move_to_room`")]
    NotFree(Relation),
    /// A relation that does not give a location.
    #[error("`{0}` gives no support, container or wearer; use `relate`, `hold` or `move_to_room`")]
    NotAPlace(Relation),
    /// A room can be removed only when it is empty.
    #[error("{room} still contains {count} nodes, {first} among them; move or remove them first")]
    RoomNotEmpty {
        /// The room.
        room: Label,
        /// How many nodes are in it.
        count: usize,
        /// One of them.
        first: Label,
    },
    /// A pose has values that are not finite.
    #[error("the pose of {0} is not finite")]
    NotFinite(Label),
}

/// An edit in progress. [`Edit::commit`] keeps it and returns its changes; dropping it undoes everything.
///
/// An edit keeps these invariants: for the objects it moves a single support chain without cycles, an object in
/// at most one hand, no opposite states, and a room for every moved object.
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

    /// Adds a node without a location, with the next free number.
    ///
    /// # Errors
    /// [`EditError::NumbersExhausted`], [`EditError::NotFinite`].
    pub fn add(&mut self, draft: Draft) -> Result<NodeId, EditError> {
        self.add_with_id(next_id(self.graph)?, draft)
    }

    /// Adds a node without a location, with a given number.
    ///
    /// # Errors
    /// [`EditError::Duplicate`], [`EditError::NotFinite`].
    pub fn add_with_id(&mut self, id: NodeId, draft: Draft) -> Result<NodeId, EditError> {
        let node = make_node(self.graph, id, draft)?;
        self.make(Change::Add(Arc::new(node)));
        Ok(id)
    }

    /// Adds a node of another scene, as it was observed there, without a location.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let apple = scene.add_in(kitchen, Draft::new("apple"))?;
    /// let real = scene.build();
    /// let mut told = real.clone();
    /// let mut edit = told.edit();
    /// edit.remove(apple)?;
    /// edit.add_as_seen(real.node(apple).ok_or("there")?)?;
    /// edit.commit();
    /// assert!(told.node(apple).is_some() && told.room_of(apple).is_none());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`EditError::Duplicate`].
    pub fn add_as_seen(&mut self, node: &Node) -> Result<(), EditError> {
        if self.graph.node(node.id()).is_some() {
            return Err(EditError::Duplicate(node.id()));
        }
        let mut copy = node.clone();
        copy.out.retain(|_| false);
        copy.inc.retain(|_| false);
        self.make(Change::Add(Arc::new(copy)));
        Ok(())
    }

    /// Removes a node; objects that rested on it stay in its room.
    ///
    /// # Errors
    /// [`EditError::NoSuchNode`], [`EditError::RoomNotEmpty`].
    pub fn remove(&mut self, id: NodeId) -> Result<(), EditError> {
        let node = self.graph.node(id).ok_or(EditError::NoSuchNode(id))?;
        if let Some(first) = self.graph.in_room(id).next() {
            let (room, first) = (node.label(), self.graph.label(first));
            return Err(EditError::RoomNotEmpty { room, count: self.graph.in_room(id).count(), first });
        }
        let out = node.out.iter().map(|l| Edge::new(id, l.relation(), l.node()));
        let inc = node.inc.iter().map(|l| Edge::new(l.node(), l.relation(), id));
        let edges: Vec<Edge> = out.chain(inc).collect();
        for edge in edges {
            self.unlink(edge);
        }
        if let Some(bare) = self.graph.nodes.get(id).cloned() {
            self.make(Change::Remove(bare));
        }
        Ok(())
    }

    /// Removes an affordance from a node, even if its class has it: for a caller who has found that nothing can
    /// be put on this node, or that it does not open. Its relations stay.
    ///
    /// ```
    /// use vc_graph::{Draft, Property, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let mut scene = scene.build();
    /// let mut edit = scene.edit();
    /// edit.bar(fridge, Property::Openable)?;
    /// edit.commit();
    /// let fridge = scene.node(fridge).ok_or("there")?;
    /// assert!(!fridge.affords(Property::Openable) && fridge.affords(Property::Container));
    /// assert_eq!(scene.room_of(fridge.id()), Some(kitchen));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`EditError::NoSuchNode`].
    pub fn bar(&mut self, id: NodeId, property: Property) -> Result<(), EditError> {
        self.respecify(id, |spec| spec.affordances = spec.affordances.minus(PropertySet::of(&[property])))
    }

    /// Gives a node an affordance, such as one that [`Edit::bar`] took from it. Its relations stay.
    ///
    /// # Errors
    /// [`EditError::NoSuchNode`].
    pub fn allow(&mut self, id: NodeId, property: Property) -> Result<(), EditError> {
        self.respecify(id, |spec| spec.affordances = spec.affordances.with(property))
    }

    /// Sets a node's scale along the axes of its frame: folded cloth takes less space along one axis and more
    /// along another. Its relations stay.
    ///
    /// # Errors
    /// [`EditError::NoSuchNode`]; [`EditError::NotFinite`] if the scale is not finite and positive.
    pub fn set_scale(&mut self, id: NodeId, scale: Vector3<f32>) -> Result<(), EditError> {
        if !scale.iter().all(|s| s.is_finite() && *s > 0.0) {
            return Err(EditError::NotFinite(self.graph.label(id)));
        }
        self.respecify(id, |spec| {
            let by = scale.component_div(&spec.scale);
            let resized =
                |b: Bounds| Bounds { offset: b.offset.component_mul(&by), half: b.half.component_mul(&by), ..b };
            spec.bounds = spec.bounds.map(resized);
            spec.scale = scale;
        })
    }

    /// Replaces a node by one with another specification and keeps its relations.
    fn respecify(&mut self, id: NodeId, change: impl FnOnce(&mut Spec)) -> Result<(), EditError> {
        let node = self.graph.node(id).ok_or(EditError::NoSuchNode(id))?;
        let out = node.out.iter().map(|l| Edge::new(id, l.relation(), l.node()));
        let inc = node.inc.iter().map(|l| Edge::new(l.node(), l.relation(), id));
        let mut edges: Vec<Edge> = out.chain(inc).collect();
        edges.dedup();
        let mut other = node.clone();
        other.out.retain(|_| false);
        other.inc.retain(|_| false);
        change(Arc::make_mut(&mut other.spec));
        edges.iter().for_each(|edge| self.make(Change::Unlink(*edge)));
        if let Some(bare) = self.graph.nodes.get(id).cloned() {
            self.make(Change::Remove(bare));
        }
        self.make(Change::Add(Arc::new(other)));
        edges.into_iter().for_each(|edge| self.make(Change::Link(edge)));
        Ok(())
    }

    /// Adds a state and removes its opposites.
    ///
    /// # Errors
    /// [`EditError::NoSuchNode`].
    pub fn enter_state(&mut self, id: NodeId, state: State) -> Result<(), EditError> {
        let before = self.graph.node(id).ok_or(EditError::NoSuchNode(id))?.states();
        self.set_states(id, before.entering(state))
    }

    /// Removes a state.
    ///
    /// # Errors
    /// [`EditError::NoSuchNode`].
    pub fn leave_state(&mut self, id: NodeId, state: State) -> Result<(), EditError> {
        let before = self.graph.node(id).ok_or(EditError::NoSuchNode(id))?.states();
        self.set_states(id, before.without(state))
    }

    /// Sets all states at once, as observed; the given states should not exclude each other.
    ///
    /// # Errors
    /// [`EditError::NoSuchNode`].
    pub fn set_states(&mut self, id: NodeId, after: StateSet) -> Result<(), EditError> {
        let before = self.graph.node(id).ok_or(EditError::NoSuchNode(id))?.states();
        if before != after {
            self.make(Change::States { id, before, after });
        }
        Ok(())
    }

    /// Sets the contents of a node; `None` empties it.
    ///
    /// # Errors
    /// [`EditError::NoSuchNode`].
    pub fn fill(&mut self, id: NodeId, contents: Option<Arc<str>>) -> Result<(), EditError> {
        let before = self.graph.node(id).ok_or(EditError::NoSuchNode(id))?.contents.clone();
        let state = if contents.is_some() { State::Filled } else { State::Empty };
        self.make(Change::Contents { id, before, after: contents });
        self.enter_state(id, state)
    }

    /// Sets the pose of a node and changes nothing else.
    ///
    /// # Errors
    /// [`EditError::NoSuchNode`], [`EditError::NotFinite`].
    pub fn set_pose(&mut self, id: NodeId, pose: Option<Pose>) -> Result<(), EditError> {
        let node = self.graph.node(id).ok_or(EditError::NoSuchNode(id))?;
        if pose.as_ref().is_some_and(|p| !is_finite(p)) {
            return Err(EditError::NotFinite(node.label()));
        }
        if node.pose != pose {
            let before = node.pose;
            self.make(Change::Pose { id, before, after: pose });
        }
        Ok(())
    }

    /// Moves a node with everything that rests on, in or with it.
    ///
    /// # Errors
    /// [`EditError::NoSuchNode`], [`EditError::NotFinite`].
    pub fn carry_to(&mut self, id: NodeId, pose: Pose) -> Result<(), EditError> {
        let Some(old) = self.graph.node(id).ok_or(EditError::NoSuchNode(id))?.pose else {
            return self.set_pose(id, Some(pose));
        };
        let motion = pose * old.inverse();
        for part in self.graph.carried_with(id) {
            let now = self.graph.node(part).and_then(|n| n.pose);
            let moved = now.map(|p| if part == id { pose } else { motion * p });
            self.set_pose(part, moved)?;
        }
        Ok(())
    }

    /// Adds a relation that does not give a location: near, facing, under, touching, between.
    ///
    /// # Errors
    /// [`EditError::NoSuchNode`], [`EditError::NotFree`].
    pub fn relate(&mut self, edge: Edge) -> Result<(), EditError> {
        use Relation::{HoldsLeft, HoldsRight, InRoom};
        let places = [InRoom, HoldsRight, HoldsLeft];
        if places.contains(&edge.relation) || Relation::places().contains(&edge.relation) {
            return Err(EditError::NotFree(edge.relation));
        }
        self.check(edge.from)?;
        self.check(edge.to)?;
        self.link(edge);
        Ok(())
    }

    /// Removes the relations of some kinds that start at a node.
    ///
    /// # Errors
    /// [`EditError::NoSuchNode`].
    pub fn unrelate(&mut self, id: NodeId, relations: &[Relation]) -> Result<(), EditError> {
        let node = self.graph.node(id).ok_or(EditError::NoSuchNode(id))?;
        let chosen = node.out.iter().filter(|l| relations.contains(&l.relation()));
        let edges: Vec<Edge> = chosen.map(|l| Edge::new(id, l.relation(), l.node())).collect();
        edges.into_iter().for_each(|edge| self.unlink(edge));
        Ok(())
    }

    /// Puts an object on, in or with another: it leaves its previous place and comes, with everything that
    /// rests on it, to the other's room.
    ///
    /// # Errors
    /// [`EditError::NoSuchNode`], [`EditError::NotAPlace`], [`EditError::WrongKind`],
    /// [`EditError::SupportCycle`].
    pub fn place(&mut self, id: NodeId, place: Place) -> Result<(), EditError> {
        self.check(place.at)?;
        self.check_movable(id)?;
        if !Relation::places().contains(&place.relation) {
            return Err(EditError::NotAPlace(place.relation));
        }
        if id == place.at || self.graph.rests_at(place.at, id) {
            let (thing, at) = (self.graph.label(id), self.graph.label(place.at));
            return Err(EditError::SupportCycle { thing, at });
        }
        self.detach(id)?;
        self.link(Edge::new(id, place.relation, place.at));
        match self.graph.room_of(place.at) {
            Some(room) => self.bring(id, room),
            None => Ok(()),
        }
    }

    /// Puts an object where it was observed, which may be several places at once (on a board and in the
    /// cupboard), none, or a hand.
    ///
    /// # Errors
    /// [`EditError::NoSuchNode`], [`EditError::SupportCycle`], [`EditError::WrongKind`].
    pub fn place_as_seen(&mut self, id: NodeId, places: &[Place], room: Option<NodeId>) -> Result<(), EditError> {
        let cyclic = |p: &&Place| id == p.at || self.graph.rests_at(p.at, id);
        if let Some(place) = places.iter().find(cyclic) {
            let (thing, at) = (self.graph.label(id), self.graph.label(place.at));
            return Err(EditError::SupportCycle { thing, at });
        }
        places.iter().try_for_each(|p| self.check(p.at))?;
        self.detach(id)?;
        for place in places {
            let held = Relation::hands().contains(&place.relation);
            let edge = Edge::new(id, place.relation, place.at);
            self.link(if held { edge.reversed() } else { edge });
        }
        room.map_or(Ok(()), |room| self.bring(id, room))
    }

    /// Puts an object into an agent's free hand, the right one first. Holding an object that the agent holds
    /// already changes nothing.
    ///
    /// # Errors
    /// [`EditError::NoSuchNode`], [`EditError::WrongKind`], [`EditError::HandsFull`],
    /// [`EditError::SupportCycle`].
    pub fn hold(&mut self, agent: NodeId, id: NodeId) -> Result<(), EditError> {
        self.check_kind(agent, NodeKind::Agent, "agent")?;
        self.check(id)?;
        if self.graph.holder(id).is_some_and(|p| p.at == agent) {
            return Ok(());
        }
        let full = EditError::HandsFull { agent: self.graph.label(agent) };
        let hand = self.graph.free_hand(agent).ok_or(full)?;
        if id == agent || self.graph.rests_at(agent, id) {
            let (thing, at) = (self.graph.label(id), self.graph.label(agent));
            return Err(EditError::SupportCycle { thing, at });
        }
        self.detach(id)?;
        self.link(Edge::new(agent, hand, id));
        match self.graph.room_of(agent) {
            Some(room) => self.bring(id, room),
            None => Ok(()),
        }
    }

    /// Removes an object from whatever it rests on, in or with; it stays in its room.
    ///
    /// # Errors
    /// [`EditError::NoSuchNode`].
    pub fn detach(&mut self, id: NodeId) -> Result<(), EditError> {
        self.check(id)?;
        if let Some(hold) = self.graph.holder(id) {
            self.unlink(Edge::new(hold.at, hold.relation, id));
        }
        self.unrelate(id, Relation::places())?;
        self.unrelate(id, &[Relation::Under, Relation::Touching])
    }

    /// Moves a node, with everything that rests on it, into a room. It no longer rests on supports in another
    /// room.
    ///
    /// # Errors
    /// [`EditError::NoSuchNode`], [`EditError::WrongKind`].
    pub fn move_to_room(&mut self, id: NodeId, room: NodeId) -> Result<(), EditError> {
        self.check_movable(id)?;
        self.check_kind(room, NodeKind::Room, "room")?;
        let elsewhere = |p: Place| self.graph.room_of(p.at) != Some(room);
        if self.graph.places(id).any(elsewhere) {
            self.detach(id)?;
        }
        self.bring(id, room)
    }

    /// As [`Edit::move_to_room`], without a change of the node's pose.
    fn bring(&mut self, id: NodeId, room: NodeId) -> Result<(), EditError> {
        self.check_movable(id)?;
        self.check_kind(room, NodeKind::Room, "room")?;
        if self.graph.room_of(id) == Some(room) && self.graph.resting_at(id).next().is_none() {
            return Ok(());
        }
        for part in self.graph.carried_with(id) {
            let edge = Edge::new(part, Relation::InRoom, room);
            if !self.graph.has(edge) {
                self.unrelate(part, &[Relation::InRoom])?;
                self.link(edge);
            }
        }
        Ok(())
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
    if graph.next == u32::MAX { Err(EditError::NumbersExhausted) } else { Ok(NodeId(graph.next)) }
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
