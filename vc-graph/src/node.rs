//! Nodes: what is constant about a thing, and what changes.

use std::cmp::Ordering;
use std::sync::Arc;

use nalgebra::{Point3, Vector3};

use crate::class::{Class, ClassTable, Slot, SlotKind};
use crate::geometry::{Aabb, Bounds, Pose};
use crate::vocabulary::{Word, key};
use crate::{AssetId, Label, NodeId, Place, Property, PropertySet, Relation, State, StateSet};

/// What part a node plays in a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Kind {
    /// A region that contains other nodes; it has no body.
    Room,
    /// Somebody who acts.
    Agent,
    /// Everything else.
    Object,
}

/// What is constant about a node; shared between clones of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Spec {
    /// The class under which the node is found: the class table's name, or the
    /// folded spelling for a class the table does not know.
    pub class: Arc<str>,
    /// The class as the scene's author spelled it.
    pub spelling: Arc<str>,
    /// The author's name for this instance or its model, if any.
    pub name: Option<Arc<str>>,
    /// The author's category, or the class's.
    pub category: Arc<str>,
    /// Room, agent or object.
    pub kind: Kind,
    /// Properties the scene's author wrote.
    pub properties: PropertySet,
    /// What the transition rule goes by: the written properties and the class's.
    pub affordances: PropertySet,
    /// Box around the node relative to its pose.
    pub bounds: Option<Bounds>,
    /// Scale of the asset along each axis; the bounds already include it.
    pub scale: Vector3<f32>,
    /// Places in or on it, by kind.
    pub slots: Arc<[Slot]>,
    /// Shape, in the scene's asset library.
    pub asset: Option<AssetId>,
}

/// One end of a relation, as seen from the node that keeps it: relation and node in
/// one number, which sorts as the two do and costs half as much.
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
/// Read-only: a [`SceneGraph`](crate::SceneGraph) changes its nodes by
/// [`Edit`](crate::Edit)s, so that both ends of every relation stay in step.
#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    pub(crate) id: NodeId,
    pub(crate) spec: Arc<Spec>,
    pub(crate) states: StateSet,
    pub(crate) pose: Option<Pose>,
    pub(crate) contents: Option<Arc<str>>,
    /// Relations that start here, sorted.
    pub(crate) out: Vec<Link>,
    /// Relations that end here, sorted; symmetric ones are only in `out`.
    pub(crate) inc: Vec<Link>,
}

impl Node {
    /// The node's number.
    pub fn id(&self) -> NodeId {
        self.id
    }

    /// What is constant about the node.
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
    pub fn kind(&self) -> Kind {
        self.spec.kind
    }

    /// The states that have been written or entered.
    pub fn states(&self) -> StateSet {
        self.states
    }

    /// Whether the node is in a state.
    pub fn is(&self, state: State) -> bool {
        self.states.contains(state)
    }

    /// Whether the node affords something.
    pub fn affords(&self, property: Property) -> bool {
        self.spec.affordances.contains(property)
    }

    /// Where the node is, if the scene has poses.
    pub fn pose(&self) -> Option<&Pose> {
        self.pose.as_ref()
    }

    /// The class of what is in it to pour: `water` in a glass.
    pub fn contents(&self) -> Option<&Arc<str>> {
        self.contents.as_ref()
    }

    /// The world-aligned box around the node, if pose and box are known.
    pub fn aabb(&self) -> Option<Aabb> {
        Some(self.spec.bounds?.aabb(self.pose.as_ref()?))
    }

    /// The node's position, metres, if it has a pose.
    pub fn position(&self) -> Option<Point3<f32>> {
        self.pose.map(|p| Point3::from(p.translation.vector))
    }

    /// How many places of a kind it has.
    pub fn slots(&self, kind: SlotKind) -> u32 {
        self.spec.slots.iter().filter(|s| s.kind == kind).fold(0, |sum, s| sum.saturating_add(s.number))
    }

    /// Whether it is part of the building: a wall, a floor, a ceiling.
    pub fn is_building(&self) -> bool {
        matches!(&*self.spec.category, "structure" | "Floor" | "Floors" | "Walls" | "Ceiling")
    }

    /// Whether it is closed and what is inside therefore hidden. A sink in a counter that opens at best has no lid.
    pub fn hides_contents(&self) -> bool {
        let holds = self.affords(Property::Container) || self.affords(Property::Recipient);
        self.is(State::Closed) && self.affords(Property::Openable) && holds
    }

    pub(crate) fn has(&self, relation: Relation, node: NodeId) -> bool {
        self.out.binary_search(&Link::new(relation, node)).is_ok()
    }

    /// Nodes a relation leads to, in number order.
    pub(crate) fn out(&self, relation: Relation) -> impl Iterator<Item = NodeId> + '_ {
        of_relation(&self.out, relation)
    }

    /// Nodes a relation comes from, in number order.
    pub(crate) fn inc(&self, relation: Relation) -> impl Iterator<Item = NodeId> + '_ {
        let links = if relation.is_symmetric() { &self.out } else { &self.inc };
        of_relation(links, relation)
    }
}

impl Node {
    /// Whether both are near the same thing.
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

/// The relations that say what a thing rests on come first, so that they are a
/// prefix of every sorted list of links.
fn resting(links: &[Link]) -> impl Iterator<Item = &Link> {
    links.iter().take_while(|l| l.relation() <= Relation::LyingOn)
}

fn is_hand(link: &&Link) -> bool {
    matches!(link.relation(), Relation::HoldsRight | Relation::HoldsLeft)
}

impl Node {
    /// What the node rests on, in or with.
    pub(crate) fn resting(&self) -> impl Iterator<Item = Place> {
        resting(&self.out).map(|l| Place { relation: l.relation(), at: l.node() })
    }

    /// Who holds the node.
    pub(crate) fn holders(&self) -> impl Iterator<Item = Place> {
        let start = self.inc.partition_point(|&l| l < Link::new(Relation::HoldsRight, NodeId(0)));
        self.inc[start..].iter().take_while(is_hand).map(|l| Place { relation: l.relation(), at: l.node() })
    }

    /// What rests on, in or with the node, or is held by it.
    pub(crate) fn carried(&self) -> impl Iterator<Item = NodeId> {
        let held = self.out.iter().filter(|l| self.spec.kind == Kind::Agent && is_hand(l));
        resting(&self.inc).chain(held).map(|l| l.node())
    }
}

fn of_relation(links: &[Link], relation: Relation) -> impl Iterator<Item = NodeId> + '_ {
    let start = links.partition_point(|&l| l < Link::new(relation, NodeId(0)));
    links[start..].iter().take_while(move |l| l.relation() == relation).map(|l| l.node())
}

/// A node to be: only the class is needed, the class table fills in the rest.
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
    /// States; by default those the class starts in.
    pub states: Option<StateSet>,
    /// States to enter on top of `states`.
    pub entering: Vec<State>,
    /// Pose, if the scene has poses.
    pub pose: Option<Pose>,
    /// Box relative to the pose.
    pub bounds: Option<Bounds>,
    /// Scale, by default one.
    pub scale: Option<Vector3<f32>>,
    /// Places in or on it; by default the class's.
    pub slots: Option<Vec<Slot>>,
    /// Class of what is in it to pour.
    pub contents: Option<Arc<str>>,
    /// Shape, in the scene's asset library.
    pub asset: Option<AssetId>,
}

impl Draft {
    /// A node of a class.
    pub fn new(class: impl Into<Arc<str>>) -> Self {
        Self { class: class.into(), ..Self::default() }
    }

    /// The draft that a node would be made from: everything but its number and relations.
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

    /// Enters a state; its opposites end.
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

    /// Sets the box.
    #[must_use]
    pub fn bounds(self, bounds: Bounds) -> Self {
        Self { bounds: Some(bounds), ..self }
    }

    /// The node this draft describes, by the knowledge of a class table.
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
        Spec {
            class: class.map_or_else(|| key(&self.class).into(), |c| c.name.clone()),
            kind: kind_of(class, &category),
            category,
            spelling: match class {
                Some(class) if class.name == self.class => class.name.clone(),
                _ => self.class,
            },
            name: self.name,
            properties: self.properties.unwrap_or(known),
            affordances: affordances(self.properties, class, states),
            bounds: self.bounds,
            scale: self.scale.unwrap_or_else(|| Vector3::repeat(1.0)),
            slots: self.slots.map_or_else(|| class.map_or_else(|| [].into(), |c| c.slots.clone()), Into::into),
            asset: self.asset,
        }
    }
}

fn kind_of(class: Option<&Class>, category: &str) -> Kind {
    use crate::class::Category;
    match (category, class.map(|c| c.category)) {
        ("Rooms" | "room", _) => Kind::Room,
        ("Characters" | "character", _) => Kind::Agent,
        (_, Some(Category::Character)) => Kind::Agent,
        _ => Kind::Object,
    }
}

/// What a node affords. Where the author lists properties, only the author says
/// what opens, switches and plugs in; the class table adds the rest, which authors
/// often leave out. VirtualHome's windows and desks open although it does not say so: what is
/// written to be open or closed opens, unless it is a mere part of the building such as a door frame.
fn affordances(written: Option<PropertySet>, class: Option<&Class>, states: StateSet) -> PropertySet {
    use Property::{Openable, Plug, Switchable};
    let known = class.map_or(PropertySet::EMPTY, |c| c.affordances);
    let Some(written) = written else { return known };
    let all = written.union(known.minus(PropertySet::of(&[Openable, Plug, Switchable])));
    let opens = states.contains(State::Open) || states.contains(State::Closed);
    let fixed = class.is_some_and(|c| c.category == crate::class::Category::Structure) && !known.contains(Openable);
    if opens && !fixed { all.with(Openable) } else { all }
}
