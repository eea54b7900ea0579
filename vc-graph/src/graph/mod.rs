//! The scene graph: nodes, their relations, and queries about them.

mod nearness;
mod relations;
mod write;

use std::collections::BTreeMap;
use std::sync::Arc;

use nalgebra::Point3;

use crate::asset::AssetLibrary;
use crate::class::ClassTable;
use crate::grid::Grid;
use crate::node::{Node, NodeKind};
use crate::space::NumberBlock;
use crate::spelling::key;
use crate::store::Store;
use crate::{Label, NodeId, ObjectRole, Property, Relation, State, Vocabulary};

pub use nearness::NEAR;

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
    /// The numbers that new nodes get.
    pub(crate) numbers: NumberBlock,
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
            numbers: NumberBlock::ALL,
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

    /// The scene's vocabulary: its verbs with their rules, its own states and properties.
    pub fn vocabulary(&self) -> &Arc<Vocabulary> {
        self.classes.vocabulary()
    }

    /// Gives the scene another vocabulary, for instance a generated one. Nodes stay as they are. Costs a copy of the class
    /// table, about a millisecond.
    ///
    /// ```
    /// use vc_graph::{Action, Draft, SceneBuilder, Vocabulary, rule};
    /// let mut scene = SceneBuilder::new("flat");
    /// let me = scene.add(Draft::new("character"))?;
    /// let mut scene = scene.build();
    /// scene.set_vocabulary(Vocabulary::parse("words.txt", "verb bow 0")?);
    /// assert!(rule::allows(&scene, me, &"bow".parse()?));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn set_vocabulary(&mut self, words: impl Into<Arc<Vocabulary>>) {
        self.classes = Arc::new(self.classes.with_vocabulary(words));
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

    /// Whether another state of a scene has nodes of the same numbers.
    pub fn has_same_nodes(&self, other: &Self) -> bool {
        self.len() == other.len() && self.nodes().map(Node::id).eq(other.nodes().map(Node::id))
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
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let graph = scene.build();
    /// assert_eq!(graph.label(apple).to_string(), "apple.3");
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
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
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let graph = scene.build();
    /// assert_eq!(graph.of_class("apple"), [apple]);
    /// assert_eq!(graph.of_class("table"), [table], "a kitchen table is a table");
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
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
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let graph = scene.build();
    /// assert_eq!(graph.in_room(kitchen).collect::<Vec<_>>(), [table, apple]);
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
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
    ///
    /// ```
    /// use vc_graph::nalgebra::Point3;
    /// use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let bounds = Bounds::standing([0.1, 0.1, 0.1].into());
    /// let cup = |x| Draft::new("cup").bounds(bounds).at(Pose::translation(x, 0.0, 0.0));
    /// let (near, far) = (scene.add(cup(1.0))?, scene.add(cup(5.0))?);
    /// let graph = scene.build();
    /// assert_eq!(graph.within(Point3::origin(), 2.0), [near]);
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
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
}

/// Prints a short summary; to see the whole scene, write it in one of the formats.
impl std::fmt::Debug for SceneGraph {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let digest = self.digest();
        write!(f, "SceneGraph({}, {} nodes, digest {digest})", self.name, self.len())
    }
}

/// Two scenes are equal if name, vocabulary, nodes and relations are equal. Their editing histories do not matter.
impl PartialEq for SceneGraph {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
            && self.len() == other.len()
            && self.nodes.iter().eq(other.nodes.iter())
            && self.vocabulary() == other.vocabulary()
    }
}
