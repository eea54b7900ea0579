//! Building a scene.

use std::sync::Arc;

use crate::asset::AssetLibrary;
use crate::bulk;
use crate::class::ClassTable;
use crate::node::{Draft, NodeKind};
use crate::space::NumberBlock;
use crate::{Edge, EditError, NodeId, Place, Relation, SceneGraph};

/// Builds a [`SceneGraph`], node by node or in bulk.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder, State};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
/// let milk = scene.add_in(fridge, Draft::new("milk"))?;
/// let graph = scene.build();
/// assert_eq!(graph.hidden_in(milk), Some(fridge)); // fridges start closed
/// assert!(graph.validate().is_empty());
/// # Ok::<(), vc_graph::EditError>(())
/// ```
#[derive(Debug)]
pub struct SceneBuilder {
    graph: SceneGraph,
}

impl SceneBuilder {
    /// Starts a scene with the built-in classes.
    pub fn new(name: impl Into<Arc<str>>) -> Self {
        Self::with_classes(name, ClassTable::builtin())
    }

    /// Starts a scene with a given class table.
    ///
    /// ```
    /// use vc_graph::{ClassTable, Draft, SceneBuilder};
    /// let text = "robot_dog | dog | | animal | | 0.7 0.3 0.5 | 12 | | | | ";
    /// let classes = ClassTable::builtin().extended("own.txt", text)?;
    /// let mut scene = SceneBuilder::with_classes("flat", classes.into());
    /// let spot = scene.add(Draft::new("RobotDog"))?;
    /// assert_eq!(scene.graph().of_class("dog"), [spot]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn with_classes(name: impl Into<Arc<str>>, classes: Arc<ClassTable>) -> Self {
        Self { graph: SceneGraph::new(name, classes) }
    }

    /// Continues from an existing scene.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let graph = scene.build();
    /// let mut more = SceneBuilder::from_graph(graph);
    /// more.add_on(table, Draft::new("plate"))?;
    /// assert_eq!(more.build().of_class("plate").len(), 1);
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    pub fn from_graph(graph: SceneGraph) -> Self {
        Self { graph }
    }

    /// Sets the library that the nodes' asset identifiers refer to.
    pub fn assets(&mut self, assets: Arc<AssetLibrary>) -> &mut Self {
        self.graph.assets = assets;
        self
    }

    /// Adds a node without a location: a room, or an object that is placed later.
    ///
    /// # Errors
    /// As [`Edit::add`](crate::Edit::add).
    pub fn add(&mut self, draft: Draft) -> Result<NodeId, EditError> {
        let id = crate::edit::next_id(&self.graph)?;
        self.add_with_id(id, draft)
    }

    /// Adds a node with a given number.
    ///
    /// # Errors
    /// As [`Edit::add_with_id`](crate::Edit::add_with_id).
    pub fn add_with_id(&mut self, id: NodeId, draft: Draft) -> Result<NodeId, EditError> {
        let node = crate::edit::make_node(&self.graph, id, draft)?;
        self.graph.insert(Arc::new(node));
        Ok(id)
    }

    /// Adds a node in a room or inside a container.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let milk = scene.add_in(fridge, Draft::new("milk"))?;
    /// let graph = scene.build();
    /// assert_eq!(graph.room_of(milk), Some(kitchen));
    /// assert_eq!(graph.place(milk).map(|place| place.at), Some(fridge));
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    ///
    /// # Errors
    /// As [`Edit::add`](crate::Edit::add) and [`Edit::place`](crate::Edit::place).
    pub fn add_in(&mut self, container: NodeId, draft: Draft) -> Result<NodeId, EditError> {
        let relation = match self.graph.node(container).ok_or(EditError::NoSuchNode(container))?.kind() {
            NodeKind::Room => Relation::InRoom,
            _ => Relation::Inside,
        };
        self.add_at(Place { relation, at: container }, draft)
    }

    /// Adds a node on a surface.
    ///
    /// ```
    /// use vc_graph::{Draft, Relation, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let graph = scene.build();
    /// assert_eq!(graph.place(apple).map(|place| place.relation), Some(Relation::On));
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    ///
    /// # Errors
    /// As [`Edit::add`](crate::Edit::add) and [`Edit::place`](crate::Edit::place).
    pub fn add_on(&mut self, surface: NodeId, draft: Draft) -> Result<NodeId, EditError> {
        self.add_at(Place { relation: Relation::On, at: surface }, draft)
    }

    fn add_at(&mut self, place: Place, draft: Draft) -> Result<NodeId, EditError> {
        let mut edit = self.graph.edit();
        let id = edit.add(draft)?;
        match place.relation {
            Relation::InRoom => edit.move_to_room(id, place.at)?,
            _ => edit.place(id, place)?,
        }
        edit.commit();
        Ok(id)
    }

    /// Begins an edit of the scene built so far.
    pub fn edit(&mut self) -> crate::Edit<'_> {
        self.graph.edit()
    }

    /// Numbers further nodes from a number on, if it is greater than those of all nodes: smaller ones may have been
    /// those of removed nodes. See [`SceneGraph::next_number`].
    pub fn number_from(&mut self, number: u32) {
        self.graph.next = self.graph.next.max(number);
    }

    /// Numbers nodes within a block: those of a region of a [`Space`](crate::space::Space).
    ///
    /// ```
    /// use vc_graph::space::NumberBlock;
    /// use vc_graph::{Draft, NodeId, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// scene.numbers(NumberBlock { first: 500, count: 100 });
    /// assert_eq!(scene.add(Draft::new("kitchen"))?, NodeId(500));
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    pub fn numbers(&mut self, block: NumberBlock) {
        self.graph.number_in(block, block.first);
    }

    /// The scene built so far.
    pub fn graph(&self) -> &SceneGraph {
        &self.graph
    }

    /// Adds many relations at once, as a file lists them. No invariant is enforced; [`SceneGraph::validate`]
    /// lists the violations.
    ///
    /// ```
    /// use vc_graph::{Draft, Edge, Relation, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let (kitchen, door) = (scene.add(Draft::new("kitchen"))?, scene.add(Draft::new("door"))?);
    /// scene.link_all(&[Edge::new(door, Relation::InRoom, kitchen)])?;
    /// assert_eq!(scene.build().room_of(door), Some(kitchen));
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    ///
    /// # Errors
    /// [`EditError::NoSuchNode`] if an edge refers to a missing node; then no edge is added.
    pub fn link_all(&mut self, edges: &[Edge]) -> Result<(), EditError> {
        self.link_each(edges).map_err(|(_, id)| EditError::NoSuchNode(id))
    }

    /// As [`Self::link_all`]; the error gives the position of the edge that refers to a missing node.
    pub(crate) fn link_each(&mut self, edges: &[Edge]) -> Result<(), (usize, NodeId)> {
        bulk::link(&mut self.graph, edges)
    }

    /// The finished scene.
    pub fn build(self) -> SceneGraph {
        self.graph
    }
}
