//! Edits of relations: where nodes are, who holds them, and which relations lead from them.

use super::{Edit, EditError};
use crate::node::NodeKind;
use crate::{Edge, NodeId, Place, Relation};

impl Edit<'_> {
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
    /// ```
    /// use vc_graph::{Draft, Place, Relation, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let milk = scene.add_in(fridge, Draft::new("milk"))?;
    /// let mut graph = scene.build();
    /// let mut edit = graph.edit();
    /// edit.place(milk, Place { relation: Relation::On, at: fridge })?;
    /// edit.commit();
    /// assert_eq!(graph.hidden_in(milk), None);
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
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
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let mut graph = scene.build();
    /// let mut edit = graph.edit();
    /// edit.hold(me, apple)?;
    /// edit.commit();
    /// assert_eq!(graph.held(me).collect::<Vec<_>>(), [apple]);
    /// assert_eq!(graph.place(apple).map(|place| place.at), Some(me), "it is on the table no more");
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
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
        self.hold_in(agent, hand, id)
    }

    /// Puts a node into one of an agent's hands, [`Relation::HoldsRight`] or [`Relation::HoldsLeft`], out of the other
    /// one as well; it no longer rests anywhere else.
    ///
    /// ```
    /// use vc_graph::{Draft, Relation, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let (apple, me) = (scene.add_in(kitchen, Draft::new("apple"))?, scene.add_in(kitchen, Draft::new("character"))?);
    /// let mut graph = scene.build();
    /// let mut edit = graph.edit();
    /// edit.hold_in(me, Relation::HoldsLeft, apple)?;
    /// edit.commit();
    /// assert_eq!(graph.holder(apple).map(|place| place.relation), Some(Relation::HoldsLeft));
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    ///
    /// # Errors
    /// As [`Edit::hold`]; [`EditError::NotAHand`], [`EditError::HandsFull`] if that hand holds something else.
    pub fn hold_in(&mut self, agent: NodeId, hand: Relation, id: NodeId) -> Result<(), EditError> {
        self.check_kind(agent, NodeKind::Agent, "agent")?;
        self.check(id)?;
        if !Relation::hands().contains(&hand) {
            return Err(EditError::NotAHand(hand));
        }
        if self.graph.related(agent, hand).any(|held| held != id) {
            return Err(EditError::HandsFull { agent: self.graph.label(agent) });
        }
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
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let (kitchen, hall) = (scene.add(Draft::new("kitchen"))?, scene.add(Draft::new("hallway"))?);
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let mut graph = scene.build();
    /// let mut edit = graph.edit();
    /// edit.move_to_room(table, hall)?;
    /// edit.commit();
    /// assert_eq!(graph.room_of(apple), Some(hall), "it goes with the table");
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
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
}
