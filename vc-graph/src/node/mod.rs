//! Nodes: their constant specification and their changing state.

mod draft;
mod uses;

use std::cmp::Ordering;
use std::sync::Arc;

use nalgebra::{Point3, Vector3};

use crate::class::{Slot, SlotKind};
use crate::geometry::{Aabb, Bounds, Pose};
use crate::vocabulary::Word;
use crate::{AssetId, Edge, Label, NodeId, ObjectRole, Place, Property, PropertySet, Relation, State, StateSet};

pub use draft::Draft;
pub(crate) use draft::role_of;

/// The sort of a node: where, who or which thing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum NodeKind {
    /// A region that contains other nodes; it has no body.
    Room,
    /// A character that can act.
    Agent,
    /// Any other node.
    Object,
}

/// The constant properties of a node; shared between clones of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Spec {
    /// The class under which the node is found: the class table's name, or the folded spelling if the table
    /// does not have the class.
    pub class: Arc<str>,
    /// The class as the scene's author spelled it.
    pub spelling: Arc<str>,
    /// The author's name for this instance or its model, if any.
    pub name: Option<Arc<str>>,
    /// The author's category, or the class's.
    pub category: Arc<str>,
    /// Room, agent or object.
    pub kind: NodeKind,
    /// Its role in the scene.
    pub role: ObjectRole,
    /// Properties given by the scene's author.
    pub properties: PropertySet,
    /// Properties used by the transition rule: the author's and the class's.
    pub affordances: PropertySet,
    /// Bounding box relative to the node's pose.
    pub bounds: Option<Bounds>,
    /// Scale of the asset along each axis; the bounds already include it.
    pub scale: Vector3<f32>,
    /// Places in or on it, by kind.
    pub slots: Arc<[Slot]>,
    /// Shape, in the scene's asset library.
    pub asset: Option<AssetId>,
}

/// One end of a relation, as stored in a node: relation and node packed into one integer, which sorts in the
/// same order as the pair and takes half the memory.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Link(u64);

impl Link {
    pub(crate) fn new(relation: Relation, node: NodeId) -> Self {
        Self((relation as u64) << 32 | u64::from(node.0))
    }

    pub(crate) fn relation(self) -> Relation {
        Relation::ALL[(self.0 >> 32) as usize]
    }

    pub(crate) fn node(self) -> NodeId {
        NodeId(self.0 as u32)
    }
}

impl std::fmt::Debug for Link {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} {}", self.relation(), self.node())
    }
}

/// A room, an agent or an object of a scene.
///
/// Read-only: a [`SceneGraph`](crate::SceneGraph) changes its nodes through [`Edit`](crate::Edit)s, which keep
/// both ends of every relation consistent.
///
/// ```
/// use vc_graph::{Draft, NodeKind, Property, SceneBuilder, State};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
/// let milk = scene.add_in(fridge, Draft::new("milk"))?;
/// let graph = scene.build();
/// let node = graph.node(fridge).ok_or("gone")?;
/// assert_eq!((node.label().to_string(), node.kind()), ("fridge.2".to_owned(), NodeKind::Object));
/// assert!(node.is(State::Closed) && node.affords(Property::Openable) && node.hides_contents());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    pub(crate) id: NodeId,
    pub(crate) spec: Arc<Spec>,
    pub(crate) states: StateSet,
    pub(crate) pose: Option<Pose>,
    pub(crate) contents: Option<Arc<str>>,
    /// Relations that start at the node, sorted.
    pub(crate) out: Vec<Link>,
    /// Relations that end at the node, sorted; symmetric relations are stored only in `out`.
    pub(crate) inc: Vec<Link>,
}

impl Node {
    /// The node's number.
    pub fn id(&self) -> NodeId {
        self.id
    }

    /// The constant properties of the node.
    pub fn spec(&self) -> &Spec {
        &self.spec
    }

    /// Class under which the node is found, `coffee_table`.
    pub fn class(&self) -> &Arc<str> {
        &self.spec.class
    }

    /// Class and number, `coffee_table.12`.
    pub fn label(&self) -> Label {
        Label { class: self.spec.class.clone(), id: self.id }
    }

    /// Room, agent or object.
    pub fn kind(&self) -> NodeKind {
        self.spec.kind
    }

    /// The role of the node in its scene.
    pub fn role(&self) -> ObjectRole {
        self.spec.role
    }

    /// The states of the node.
    pub fn states(&self) -> StateSet {
        self.states
    }

    /// Whether the node is in a state.
    pub fn is(&self, state: State) -> bool {
        self.states.contains(state)
    }

    /// Whether the node has an affordance.
    pub fn affords(&self, property: Property) -> bool {
        self.spec.affordances.contains(property)
    }

    /// The node's pose, if the scene has poses.
    pub fn pose(&self) -> Option<&Pose> {
        self.pose.as_ref()
    }

    /// The class of the contents that can be poured from it: `water` in a glass.
    pub fn contents(&self) -> Option<&Arc<str>> {
        self.contents.as_ref()
    }

    /// The world-aligned bounding box, if pose and box are known.
    pub fn aabb(&self) -> Option<Aabb> {
        Some(self.spec.bounds?.aabb(self.pose.as_ref()?))
    }

    /// The node's position, metres, if it has a pose.
    pub fn position(&self) -> Option<Point3<f32>> {
        self.pose.map(|p| Point3::from(p.translation.vector))
    }

    /// The number of its places of a kind.
    ///
    /// ```
    /// use vc_graph::class::SlotKind;
    /// use vc_graph::{Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let chair = scene.add(Draft::new("chair"))?;
    /// assert_eq!(scene.graph().node(chair).map(|node| node.slots(SlotKind::Seat)), Some(1));
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    pub fn slots(&self, kind: SlotKind) -> u32 {
        self.spec.slots.iter().filter(|s| s.kind == kind).fold(0, |sum, s| sum.saturating_add(s.number))
    }

    /// Whether it is part of the building: a wall, a floor, a ceiling.
    pub fn is_building(&self) -> bool {
        self.spec.role.is_building()
    }

    /// Whether the node is closed and therefore hides its contents. A sink has no lid: at best the counter around
    /// it can be opened.
    pub fn hides_contents(&self) -> bool {
        let holds = self.affords(Property::Container) || self.affords(Property::Recipient);
        self.is(State::Closed) && self.affords(Property::Openable) && holds
    }

    pub(crate) fn has(&self, relation: Relation, node: NodeId) -> bool {
        self.out.binary_search(&Link::new(relation, node)).is_ok()
    }

    /// The nodes to which a relation leads, in number order.
    pub(crate) fn out(&self, relation: Relation) -> impl Iterator<Item = NodeId> + '_ {
        of_relation(&self.out, relation)
    }

    /// The nodes from which a relation comes, in number order.
    pub(crate) fn inc(&self, relation: Relation) -> impl Iterator<Item = NodeId> + '_ {
        let links = if relation.is_symmetric() { &self.out } else { &self.inc };
        of_relation(links, relation)
    }
}

impl Node {
    /// Whether both nodes are near the same node.
    pub(crate) fn is_near_what(&self, other: &Self) -> bool {
        let (mut mine, mut others) = (self.out(Relation::Near), other.out(Relation::Near));
        let (mut one, mut two) = (mine.next(), others.next());
        while let (Some(a), Some(b)) = (one, two) {
            match a.cmp(&b) {
                Ordering::Less => one = mine.next(),
                Ordering::Greater => two = others.next(),
                Ordering::Equal => return true,
            }
        }
        false
    }
}

/// The links of relations that give a support or container. They sort first, so they are a prefix of every
/// sorted list of links.
fn resting(links: &[Link]) -> impl Iterator<Item = &Link> {
    links.iter().take_while(|l| l.relation() <= Relation::LyingOn)
}

fn is_hand(link: &&Link) -> bool {
    matches!(link.relation(), Relation::HoldsRight | Relation::HoldsLeft)
}

impl Node {
    /// The supports and containers of the node.
    pub(crate) fn resting(&self) -> impl Iterator<Item = Place> {
        resting(&self.out).map(|l| Place { relation: l.relation(), at: l.node() })
    }

    /// The agents that hold the node, with their hands.
    pub(crate) fn holders(&self) -> impl Iterator<Item = Place> {
        let start = self.inc.partition_point(|&l| l < Link::new(Relation::HoldsRight, NodeId(0)));
        self.inc[start..].iter().take_while(is_hand).map(|l| Place { relation: l.relation(), at: l.node() })
    }

    /// The edges that start or end at the node.
    pub(crate) fn edges(&self) -> impl Iterator<Item = Edge> {
        let out = self.out.iter().map(|link| Edge::new(self.id, link.relation(), link.node()));
        out.chain(self.inc.iter().map(|link| Edge::new(link.node(), link.relation(), self.id)))
    }

    /// The node without its relations.
    pub(crate) fn bare(&self) -> Self {
        Self { out: Vec::new(), inc: Vec::new(), ..self.clone() }
    }

    /// Everything that rests on, in or with the node, or is held by it.
    pub(crate) fn carried(&self) -> impl Iterator<Item = NodeId> {
        let held = self.out.iter().filter(|l| self.spec.kind == NodeKind::Agent && is_hand(l));
        resting(&self.inc).chain(held).map(|l| l.node())
    }
}

fn of_relation(links: &[Link], relation: Relation) -> impl Iterator<Item = NodeId> + '_ {
    let start = links.partition_point(|&l| l < Link::new(relation, NodeId(0)));
    links[start..].iter().take_while(move |l| l.relation() == relation).map(|l| l.node())
}
