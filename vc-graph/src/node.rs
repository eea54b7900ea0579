//! Nodes: their constant specification and their changing state.

use std::cmp::Ordering;
use std::sync::Arc;

use nalgebra::{Point3, Vector3};

use crate::class::{Class, ClassTable, Slot, SlotKind};
use crate::geometry::{Aabb, Bounds, Pose};
use crate::spelling::key;
use crate::vocabulary::Word;
use crate::{AssetId, Label, NodeId, ObjectRole, Place, Property, PropertySet, Relation, State, StateSet};

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

/// The description of a node to be added: only the class is needed, the class table fills in the rest.
///
/// ```
/// use vc_graph::{Draft, State};
/// let mug = Draft::new("mug").named("SM_Mug_02").state(State::Dirty);
/// assert_eq!(&*mug.class, "mug");
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Draft {
    /// Class, in any spelling.
    pub class: Arc<str>,
    /// The author's name for the instance.
    pub name: Option<Arc<str>>,
    /// The author's category; by default the class's.
    pub category: Option<Arc<str>>,
    /// Properties; by default the class's affordances.
    pub properties: Option<PropertySet>,
    /// States; by default the class's initial states.
    pub states: Option<StateSet>,
    /// States to enter on top of `states`.
    pub entering: Vec<State>,
    /// Pose, if the scene has poses.
    pub pose: Option<Pose>,
    /// Bounding box relative to the pose.
    pub bounds: Option<Bounds>,
    /// Scale, by default one.
    pub scale: Option<Vector3<f32>>,
    /// Places in or on it; by default the class's.
    pub slots: Option<Vec<Slot>>,
    /// Class of its contents.
    pub contents: Option<Arc<str>>,
    /// Shape, in the scene's asset library.
    pub asset: Option<AssetId>,
}

impl Draft {
    /// A draft of a class.
    pub fn new(class: impl Into<Arc<str>>) -> Self {
        Self { class: class.into(), ..Self::default() }
    }

    /// The draft from which a node could be made: everything but its number and relations.
    pub fn of(node: &Node) -> Self {
        let spec = node.spec();
        Self {
            class: spec.spelling.clone(),
            name: spec.name.clone(),
            category: Some(spec.category.clone()),
            properties: Some(spec.properties),
            states: Some(node.states()),
            entering: Vec::new(),
            pose: node.pose().copied(),
            bounds: spec.bounds,
            scale: Some(spec.scale),
            slots: Some(spec.slots.to_vec()),
            contents: node.contents().cloned(),
            asset: spec.asset,
        }
    }

    /// Sets the author's name for the instance.
    #[must_use]
    pub fn named(self, name: impl Into<Arc<str>>) -> Self {
        Self { name: Some(name.into()), ..self }
    }

    /// Adds a state and removes its opposites.
    #[must_use]
    pub fn state(mut self, state: State) -> Self {
        self.entering.push(state);
        self
    }

    /// Sets the pose.
    #[must_use]
    pub fn at(self, pose: Pose) -> Self {
        Self { pose: Some(pose), ..self }
    }

    /// Sets the bounding box.
    #[must_use]
    pub fn bounds(self, bounds: Bounds) -> Self {
        Self { bounds: Some(bounds), ..self }
    }

    /// Makes the node that this draft describes; a class table fills in the rest.
    pub(crate) fn into_node(self, id: NodeId, classes: &ClassTable) -> Node {
        let class = classes.get(&self.class);
        let states = self.states.unwrap_or_else(|| class.map_or(StateSet::EMPTY, |c| c.starts));
        let states = self.entering.iter().fold(states, |set, &state| set.entering(state));
        let contents = self.contents.clone();
        let pose = self.pose;
        let spec = Arc::new(self.into_spec(class, states));
        Node { id, spec, states, pose, contents, out: Vec::new(), inc: Vec::new() }
    }

    fn into_spec(self, class: Option<&Class>, states: StateSet) -> Spec {
        let known = class.map_or(PropertySet::EMPTY, |c| c.affordances);
        let category: Arc<str> = match (self.category, class) {
            (Some(written), _) => written,
            (None, Some(class)) => class.category.as_str().into(),
            (None, None) => "prop".into(),
        };
        let folded: Arc<str> = class.map_or_else(|| key(&self.class).into(), |c| c.name.clone());
        let kind = kind_of(class, &category);
        let affordances = affordances(self.properties, class, states);
        Spec {
            role: ObjectRole::of(kind, class, (&folded, &category), affordances),
            class: folded,
            kind,
            category,
            spelling: match class {
                Some(class) if class.name == self.class => class.name.clone(),
                _ => self.class,
            },
            name: self.name,
            properties: self.properties.unwrap_or(known),
            affordances,
            bounds: self.bounds,
            scale: self.scale.unwrap_or_else(|| Vector3::repeat(1.0)),
            slots: self.slots.map_or_else(|| class.map_or_else(|| [].into(), |c| c.slots.clone()), Into::into),
            asset: self.asset,
        }
    }
}

fn kind_of(class: Option<&Class>, category: &str) -> NodeKind {
    let written = ObjectRole::of_category(category);
    match (written, class.and_then(|c| c.listed)) {
        (Some(ObjectRole::Room), _) => NodeKind::Room,
        (Some(ObjectRole::Person), _) | (_, Some(ObjectRole::Person)) => NodeKind::Agent,
        _ => NodeKind::Object,
    }
}

/// The affordances of a node. If the author lists properties, these alone decide whether it can be opened,
/// switched or plugged in; the class table adds the others, which authors often leave out. VirtualHome's
/// windows and desks can be opened although their properties do not say so: a node with the state open or
/// closed can be opened, unless it is a mere part of the building such as a door frame.
fn affordances(written: Option<PropertySet>, class: Option<&Class>, states: StateSet) -> PropertySet {
    use Property::{Openable, Plug, Switchable};
    let known = class.map_or(PropertySet::EMPTY, |c| c.affordances);
    let Some(written) = written else { return known };
    let all = written.union(known.minus(PropertySet::of(&[Openable, Plug, Switchable])));
    let opens = states.contains(State::Open) || states.contains(State::Closed);
    let fixed = class.is_some_and(|c| c.category == crate::class::Category::Structure) && !known.contains(Openable);
    if opens && !fixed { all.with(Openable) } else { all }
}
