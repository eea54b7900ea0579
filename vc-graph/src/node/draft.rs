//! Descriptions of nodes to be added: the class table fills in all that they leave out.

use std::sync::Arc;

use nalgebra::Vector3;

use super::{Node, NodeKind, Spec};
use crate::class::{Category, Class, ClassTable, Slot};
use crate::geometry::{Bounds, Pose};
use crate::spelling::key;
use crate::vocabulary::Word;
use crate::{AssetId, NodeId, ObjectRole, Property, PropertySet, State, StateSet};

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
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let graph = scene.build();
    /// let mut copy = SceneBuilder::new("copy");
    /// let node = graph.node(apple).ok_or("gone")?;
    /// let twin = copy.add(Draft::from_node(node))?;
    /// assert_eq!(copy.graph().node(twin).map(|n| n.spec().clone()), Some(node.spec().clone()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_node(node: &Node) -> Self {
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
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder, State};
    /// let mut scene = SceneBuilder::new("flat");
    /// let door = scene.add(Draft::new("door").state(State::Open))?;
    /// assert!(scene.graph().node(door).is_some_and(|node| node.is(State::Open) && !node.is(State::Closed)));
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
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
    ///
    /// ```
    /// use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let bounds = Bounds::standing([0.6, 0.6, 1.8].into());
    /// let fridge = scene.add(Draft::new("fridge").bounds(bounds).at(Pose::translation(1.0, 0.0, 0.0)))?;
    /// assert_eq!(scene.graph().node(fridge).and_then(|node| node.aabb()).map(|aabb| aabb.max.z), Some(1.8));
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    #[must_use]
    pub fn bounds(self, bounds: Bounds) -> Self {
        Self { bounds: Some(bounds), ..self }
    }

    /// Makes the node that this draft describes; a class table fills in the rest.
    pub(crate) fn into_node(self, id: NodeId, classes: &ClassTable) -> Node {
        let class = classes.get(&self.class);
        let states = self.states.unwrap_or_else(|| class.map_or(StateSet::EMPTY, |c| c.starts));
        let states = self.entering.iter().fold(states, |set, &state| classes.vocabulary().entering(set, state));
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
            role: role_of(kind, class, (&folded, &category), affordances),
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

/// The role of a node; `name` is the folded name of its class.
pub(crate) fn role_of(
    kind: NodeKind,
    class: Option<&Class>,
    (name, category): (&str, &str),
    affordances: PropertySet,
) -> ObjectRole {
    let known = match (kind, class) {
        (NodeKind::Room, _) => return ObjectRole::Room,
        (NodeKind::Agent, _) => return ObjectRole::Person,
        (NodeKind::Object, Some(class)) => class.listed,
        (NodeKind::Object, None) => ObjectRole::of_name(name).or_else(|| ObjectRole::of_category(category)),
    };
    let is_thing = |role: &ObjectRole| !matches!(role, ObjectRole::Room | ObjectRole::Person);
    known.filter(is_thing).unwrap_or_else(|| ObjectRole::by_use(affordances))
}

/// The affordances of a node. If the author lists properties, these alone decide whether it can be opened,
/// switched or plugged in; the class table adds the others, which authors often leave out. VirtualHome's
/// windows and desks can be opened although their properties do not say so: a node with the state open or
/// closed can be opened, unless it is a mere part of the building such as a door frame.
fn affordances(written: Option<PropertySet>, class: Option<&Class>, states: StateSet) -> PropertySet {
    let known = class.map_or(PropertySet::EMPTY, |c| c.affordances);
    let Some(written) = written else { return known };
    let all = written.union(known.minus(PropertySet::from_words(&[
        Property::Openable,
        Property::Plug,
        Property::Switchable,
    ])));
    let opens = states.contains(State::Open) || states.contains(State::Closed);
    let fixed = class.is_some_and(|c| c.category == Category::Structure) && !known.contains(Property::Openable);
    if opens && !fixed { all.with(Property::Openable) } else { all }
}
