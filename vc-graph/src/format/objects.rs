//! A scene as a plain list of objects, for programs that do not use graphs.

use serde::ser::SerializeStruct;
use serde::{Deserialize, Serialize};

use crate::{Aabb, Edge, Node, NodeId, Observation, Pose, SceneGraph};

/// A node as plain data: class, room, pose, bounding box, states and relations. Lengths are metres, axes
/// right-handed, Z up, X forward.
///
/// ```
/// use vc_graph::format::objects::{ListedObject, objects};
/// use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let size = Bounds::standing([0.6, 0.6, 1.8].into());
/// let fridge = scene.add_in(kitchen, Draft::new("fridge").bounds(size).at(Pose::translation(1.0, 2.0, 0.0)))?;
/// let all = objects(&scene.build());
/// let object = all.iter().find(|object| object.id == fridge).ok_or("there")?;
/// assert_eq!((&*object.class, object.room), ("fridge", Some(kitchen)));
/// assert_eq!((object.position, object.states[0].as_str()), (Some([1.0, 2.0, 0.0]), "closed"));
/// // To JSON and back.
/// let again: Vec<ListedObject> = serde_json::from_str(&serde_json::to_string(&all)?)?;
/// assert_eq!(again, all);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ListedObject {
    /// Its number.
    pub id: NodeId,
    /// Its class, `coffee_table`.
    pub class: String,
    /// The class's category, `furniture`.
    pub category: String,
    /// The room it is in.
    pub room: Option<NodeId>,
    /// Position of its origin, metres.
    pub position: Option<[f32; 3]>,
    /// Its rotation: a unit quaternion, x, y, z, w.
    pub rotation: Option<[f32; 4]>,
    /// Its world-aligned bounding box.
    #[serde(rename = "box")]
    pub bounds: Option<Corners>,
    /// Its states, `open`.
    pub states: Vec<String>,
    /// Its relations. A symmetric relation is listed at both objects.
    pub relations: Vec<Related>,
}

/// The two extreme corners of a box, metres.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Corners {
    /// The smallest coordinates.
    pub min: [f32; 3],
    /// The largest coordinates.
    pub max: [f32; 3],
}

/// A relation that starts at an object.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Related {
    /// Its kind, `on`.
    pub relation: String,
    /// The node it leads to.
    pub to: NodeId,
}

/// All nodes of a scene except rooms, by number.
///
/// ```
/// use vc_graph::format::objects::objects;
/// use vc_graph::{Draft, SceneBuilder};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let graph = scene.build();
/// let classes: Vec<String> = objects(&graph).into_iter().map(|object| object.class).collect();
/// assert_eq!(classes, ["kitchen_table", "apple"]);
/// # Ok::<(), vc_graph::EditError>(())
/// ```
pub fn objects(graph: &SceneGraph) -> Vec<ListedObject> {
    listed(graph.nodes(), |id| graph.room_of(id), graph.edges())
}

/// All nodes of an observation except rooms, by number, with the relations whose ends are both visible.
///
/// ```
/// use vc_graph::format::objects::seen;
/// use vc_graph::{Draft, SceneBuilder, Scope};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
/// scene.add_in(fridge, Draft::new("milk"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let seen = seen(&scene.build().observe(me, Scope::Room));
/// // The fridge is closed.
/// assert_eq!(seen.iter().map(|object| object.id).collect::<Vec<_>>(), [fridge, me]);
/// assert_eq!(seen[0].room, Some(kitchen));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn seen(observation: &Observation) -> Vec<ListedObject> {
    listed(observation.nodes(), |id| observation.room_of(id), observation.relations())
}

fn listed<'a>(
    nodes: impl Iterator<Item = &'a Node>,
    room_of: impl Fn(NodeId) -> Option<NodeId>,
    edges: impl Iterator<Item = Edge>,
) -> Vec<ListedObject> {
    let things = nodes.filter(|n| n.kind() != crate::NodeKind::Room);
    let mut all: Vec<ListedObject> = things.map(|n| bare(n, room_of(n.id()))).collect();
    for Edge { from, relation, to } in edges {
        if let Ok(at) = all.binary_search_by_key(&from, |object| object.id) {
            all[at].relations.push(Related { relation: relation.to_string(), to });
        }
    }
    all
}

/// An object without its relations.
fn bare(node: &Node, room: Option<NodeId>) -> ListedObject {
    let position = |pose: &Pose| pose.translation.vector.into();
    let rotation = |pose: &Pose| pose.rotation.coords.into();
    let corners = |b: Aabb| Corners { min: b.min.into(), max: b.max.into() };
    ListedObject {
        id: node.id(),
        class: node.class().to_string(),
        category: node.spec().category.to_string(),
        room,
        position: node.pose().map(position),
        rotation: node.pose().map(rotation),
        bounds: node.aabb().map(corners),
        states: node.states().iter().map(|state| state.to_string()).collect(),
        relations: Vec::new(),
    }
}

/// Agent, range, room, and the [objects](self) that the agent sees.
impl Serialize for Observation {
    fn serialize<S: serde::Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        let mut fields = s.serialize_struct("Observation", 4)?;
        fields.serialize_field("agent", &self.agent())?;
        fields.serialize_field("scope", &self.scope())?;
        fields.serialize_field("room", &self.room())?;
        fields.serialize_field("objects", &seen(self))?;
        fields.end()
    }
}
