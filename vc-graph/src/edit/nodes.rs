//! Edits of single nodes: adding and removing, affordances, scale, states, contents, poses.

use std::sync::Arc;

use nalgebra::Vector3;

use super::{Edit, EditError, make_node, next_id};
use crate::geometry::is_finite;
use crate::node::{Draft, Node, Spec};
use crate::{Bounds, Change, Edge, NodeId, Pose, Property, PropertySet, State, StateSet};

impl Edit<'_> {
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
        self.make(Change::Add(Arc::new(node.bare())));
        Ok(())
    }

    /// Removes a node; objects that rested on it stay in its room.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let mut graph = scene.build();
    /// let mut edit = graph.edit();
    /// edit.remove(apple)?;
    /// edit.commit();
    /// assert!(graph.node(apple).is_none());
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    ///
    /// # Errors
    /// [`EditError::NoSuchNode`], [`EditError::RoomNotEmpty`].
    pub fn remove(&mut self, id: NodeId) -> Result<(), EditError> {
        let node = self.graph.node(id).ok_or(EditError::NoSuchNode(id))?;
        if let Some(first) = self.graph.in_room(id).next() {
            let (room, first) = (node.label(), self.graph.label(first));
            return Err(EditError::RoomNotEmpty { room, count: self.graph.in_room(id).count(), first });
        }
        let edges: Vec<Edge> = node.edges().collect();
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
        self.respecify(id, |spec| spec.affordances = spec.affordances.minus(PropertySet::from_words(&[property])))
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
        let mut edges: Vec<Edge> = node.edges().collect();
        edges.dedup();
        let mut other = node.bare();
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
    /// ```
    /// use vc_graph::{Draft, SceneBuilder, State};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let milk = scene.add_in(fridge, Draft::new("milk"))?;
    /// let mut graph = scene.build();
    /// let mut edit = graph.edit();
    /// edit.enter_state(fridge, State::Open)?;
    /// edit.commit();
    /// assert!(graph.node(fridge).is_some_and(|node| node.is(State::Open) && !node.is(State::Closed)));
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    ///
    /// # Errors
    /// [`EditError::NoSuchNode`].
    pub fn enter_state(&mut self, id: NodeId, state: State) -> Result<(), EditError> {
        let before = self.graph.node(id).ok_or(EditError::NoSuchNode(id))?.states();
        let after = self.graph.vocabulary().entering(before, state);
        self.set_states(id, after)
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
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let glass = scene.add(Draft::new("glass"))?;
    /// let mut graph = scene.build();
    /// let mut edit = graph.edit();
    /// edit.fill(glass, Some("water".into()))?;
    /// edit.commit();
    /// assert_eq!(graph.node(glass).and_then(|node| node.contents()).map(|class| &**class), Some("water"));
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
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
    /// ```
    /// use vc_graph::{Draft, Pose, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let mut graph = scene.build();
    /// let mut edit = graph.edit();
    /// edit.set_pose(apple, Some(Pose::translation(1.0, 2.0, 0.8)))?;
    /// edit.commit();
    /// assert_eq!(graph.node(apple).and_then(|node| node.position()).map(|at| at.z), Some(0.8));
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
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
}
