//! VirtualHome's environment graphs, reading and writing.
//!
//! | VirtualHome | VirtualCity |
//! |---|---|
//! | `bounding_box`, metres, left-handed, Y up | pose at its centre and a world-aligned box, Y and Z swapped |
//! | `obj_transform` (from version 2 on) | pose; the box stays world-aligned |
//! | `INSIDE` a room | [`Relation::InRoom`]; `INSIDE` anything else, [`Relation::Inside`] |
//! | `ON`, from a character that sits or lies | [`Relation::SittingOn`], [`Relation::LyingOn`] |
//! | `ON` a character | [`Relation::WornBy`] |
//! | `CLOSE`, written both ways | [`Relation::Near`], symmetric |
//!
//! A quaternion that is not of unit length is normalised, and the sign of a size is ignored. Reading and
//! writing again preserves every node, state, property and edge of the format. Information that the format
//! cannot express is not written: VirtualCity's further states and properties, contents, the previous place of
//! a held object, touching, directions.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use nalgebra::{Isometry3, Quaternion, Translation3, UnitQuaternion, Vector3};
use serde::{Deserialize, Serialize};

use super::{FormatError, FormatProblem, Source};
use crate::node::NodeKind;
use crate::serial::{FARTHEST, LARGEST_SCALE, is_box, mended, within};
use crate::spelling::clip;
use crate::{
    Bounds, BoundsFrame, ClassTable, Draft, Edge, EditError, Node, NodeId, Pose, Property, PropertySet, Relation,
    SceneBuilder, SceneGraph, State, StateSet, UnknownWord, Word, did_you_mean,
};

/// An environment graph as in the file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct EnvironmentGraph {
    /// Its nodes.
    pub nodes: Vec<EnvironmentNode>,
    /// Its relations.
    pub edges: Vec<EnvironmentEdge>,
}

/// A node as in the file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct EnvironmentNode {
    /// Number.
    pub id: u32,
    /// `Rooms`, `Furniture`, `Props`, ...
    #[serde(default)]
    pub category: String,
    /// Class.
    pub class_name: String,
    /// Unity's name of the model.
    #[serde(default)]
    pub prefab_name: Option<String>,
    /// Version 2: position, rotation and scale.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub obj_transform: Option<Transform>,
    /// Axis-aligned box.
    #[serde(default)]
    pub bounding_box: Option<BoundingBox>,
    /// `GRABBABLE`, `CAN_OPEN`, ...
    #[serde(default)]
    pub properties: Vec<String>,
    /// `CLOSED`, `OFF`, ...
    #[serde(default)]
    pub states: Vec<String>,
}

/// An axis-aligned box, metres, left-handed, Y up.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct BoundingBox {
    /// Its centre.
    pub center: [f32; 3],
    /// Its full size.
    pub size: [f32; 3],
}

/// A Unity transform.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Transform {
    /// Metres.
    pub position: [f32; 3],
    /// Quaternion x, y, z, w.
    pub rotation: [f32; 4],
    /// Scale along each axis; one if the file has none.
    #[serde(default = "unscaled")]
    pub scale: [f32; 3],
}

fn unscaled() -> [f32; 3] {
    [1.0; 3]
}

/// A relation as in the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct EnvironmentEdge {
    /// The start node.
    pub from_id: u32,
    /// The kind of relation.
    pub relation_type: RelationType,
    /// The end node.
    pub to_id: u32,
}

/// VirtualHome's relations.
#[allow(missing_docs, reason = "the names are VirtualHome's; the module says what they mean here")]
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "SCREAMING_SNAKE_CASE")]
pub enum RelationType {
    On,
    Inside,
    Between,
    Close,
    Facing,
    HoldsRh,
    HoldsLh,
    Sitting,
}

/// Parses an environment graph.
///
/// ```
/// use vc_graph::{ClassTable, NodeId, State};
/// use vc_graph::format::virtualhome;
/// let text = r#"{"nodes": [{"id": 7, "class_name": "fridge", "states": ["CLOSED"]}], "edges": []}"#;
/// let scene = virtualhome::read(text, &ClassTable::builtin())?;
/// assert!(scene.node(NodeId(7)).is_some_and(|node| node.is(State::Closed)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`FormatError`]: another format, unknown states or properties, duplicate node numbers, edges to missing
/// nodes.
pub fn read(text: &str, classes: &Arc<ClassTable>) -> Result<SceneGraph, FormatError> {
    let source = Source::new("VirtualHome graph", text);
    let file: EnvironmentGraph = source.json()?;
    file.build("VirtualHome", classes).map_err(|(field, problem)| source.error(field, problem))
}

/// Writes an environment graph: nodes by number, edges by start, kind and end.
pub fn write(graph: &SceneGraph) -> String {
    serde_json::to_string(&EnvironmentGraph::from_scene(graph)).unwrap_or_default()
}

type Wrong = (String, FormatProblem);

impl EnvironmentGraph {
    /// Builds the scene.
    ///
    /// # Errors
    /// The invalid field and the error.
    pub fn build(&self, name: &str, classes: &Arc<ClassTable>) -> Result<SceneGraph, (String, FormatProblem)> {
        let mut scene = SceneBuilder::with_classes(name, classes.clone());
        let mut category = Arc::from("");
        for (index, node) in self.nodes.iter().enumerate() {
            let draft =
                node.draft(&mut category).map_err(|(field, problem)| (format!("nodes[{index}].{field}"), problem))?;
            let added = scene.add_with_id(NodeId(node.id), draft);
            added.map_err(|e| (format!("nodes[{index}].id"), FormatProblem::Edit(e)))?;
        }
        let edges: Vec<Edge> = self.edges.iter().map(|edge| edge.read(scene.graph())).collect();
        let linked = scene.link_each(&edges);
        linked.map_err(|(index, id)| (format!("edges[{index}]"), FormatProblem::Edit(EditError::NoSuchNode(id))))?;
        Ok(scene.build())
    }

    /// Converts a scene to this format.
    pub fn from_scene(graph: &SceneGraph) -> Self {
        let mut edges: Vec<EnvironmentEdge> =
            graph.edges().filter_map(|e| EnvironmentEdge::from_edge(graph, e)).collect();
        edges.sort_unstable();
        edges.dedup();
        Self { nodes: graph.nodes().map(EnvironmentNode::from_node).collect(), edges }
    }
}

/// VirtualHome's states; its tools refuse any other.
const STATES: [State; 10] = [
    State::Open,
    State::Closed,
    State::On,
    State::Off,
    State::Clean,
    State::Dirty,
    State::PluggedIn,
    State::PluggedOut,
    State::Sitting,
    State::Lying,
];

/// The differences of two environment graphs.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct GraphDifference {
    /// Nodes whose states differ: number, states in this graph, states in the other.
    pub states: Vec<(u32, Vec<String>, Vec<String>)>,
    /// Nodes that only one of the graphs has.
    pub nodes: Vec<u32>,
    /// Edges that only this graph has.
    pub added: Vec<EnvironmentEdge>,
    /// Edges that only the other graph has.
    pub missing: Vec<EnvironmentEdge>,
}

impl GraphDifference {
    /// Whether the graphs are equal.
    pub fn is_empty(&self) -> bool {
        self.states.is_empty() && self.nodes.is_empty() && self.added.is_empty() && self.missing.is_empty()
    }
}

impl EnvironmentGraph {
    /// The differences between this graph and another; the order of nodes, states and edges does not matter.
    ///
    /// ```
    /// use vc_graph::format::virtualhome::EnvironmentGraph;
    /// use vc_graph::{Draft, SceneBuilder, State};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let milk = scene.add_in(fridge, Draft::new("milk"))?;
    /// let mut graph = scene.build();
    /// let before = EnvironmentGraph::from_scene(&graph);
    /// let mut edit = graph.edit();
    /// edit.enter_state(fridge, State::Open)?;
    /// edit.commit();
    /// let difference = EnvironmentGraph::from_scene(&graph).difference(&before);
    /// assert_eq!(difference.states[0].0, fridge.0);
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    pub fn difference(&self, other: &Self) -> GraphDifference {
        let by_id = |g: &Self| -> BTreeMap<u32, BTreeSet<String>> {
            g.nodes.iter().map(|n| (n.id, n.states.iter().cloned().collect())).collect()
        };
        let (here, there) = (by_id(self), by_id(other));
        let states = here.iter().filter_map(|(id, states)| {
            let others = there.get(id).filter(|o| *o != states)?;
            Some((*id, states.iter().cloned().collect(), others.iter().cloned().collect()))
        });
        let one_sided = |a: &BTreeMap<u32, BTreeSet<String>>, b: &BTreeMap<u32, BTreeSet<String>>| {
            a.keys().filter(|id| !b.contains_key(id)).copied().collect::<Vec<u32>>()
        };
        let edges = |g: &Self| g.edges.iter().copied().collect::<BTreeSet<EnvironmentEdge>>();
        let (ours, theirs) = (edges(self), edges(other));
        GraphDifference {
            states: states.collect(),
            nodes: [one_sided(&here, &there), one_sided(&there, &here)].concat(),
            added: ours.difference(&theirs).copied().collect(),
            missing: theirs.difference(&ours).copied().collect(),
        }
    }
}

/// Swaps Y and Z: left-handed Y up to right-handed Z up, and back.
fn swap(v: [f32; 3]) -> Vector3<f32> {
    Vector3::new(v[0], v[2], v[1])
}

fn swap_back(v: Vector3<f32>) -> [f32; 3] {
    [v.x, v.z, v.y]
}

impl Transform {
    fn pose(&self) -> Pose {
        let [x, y, z, w] = self.rotation;
        let turn = mended(Quaternion::new(w, -x, -z, -y));
        Isometry3::from_parts(Translation3::from(swap(self.position)), turn)
    }

    fn from_pose(node: &Node, pose: &Pose) -> Self {
        let q = pose.rotation.coords;
        Self {
            position: swap_back(pose.translation.vector),
            rotation: [-q.x, -q.z, -q.y, q.w],
            scale: swap_back(node.spec().scale),
        }
    }
}

impl EnvironmentNode {
    /// Makes the node; `category` is that of the previous node, which is often the same.
    fn draft(&self, category: &mut Arc<str>) -> Result<Draft, Wrong> {
        let mut draft = Draft::new(&*self.class_name);
        if **category != *self.category {
            *category = self.category.as_str().into();
        }
        draft.category = Some(category.clone());
        draft.name = self.prefab_name.as_deref().map(Into::into);
        draft.properties = Some(self.properties()?);
        draft.states = Some(self.states()?);
        let number =
            |field: &str, v: &dyn std::fmt::Debug| (field.to_owned(), FormatProblem::Number(clip(&format!("{v:?}"))));
        if let Some(t) = &self.obj_transform {
            if !within(&t.position, FARTHEST) || !within(&t.scale, LARGEST_SCALE) || !within(&t.rotation, FARTHEST) {
                return Err(number("obj_transform", t));
            }
            draft.pose = Some(t.pose());
            draft.scale = Some(swap(t.scale));
        }
        if let Some(b) = &self.bounding_box {
            let placed = draft.pose.is_some() || within(&b.center, FARTHEST);
            if !placed || !is_box(&b.center) || !is_box(&b.size) {
                return Err(number("bounding_box", b));
            }
            let centre = swap(b.center);
            let pose =
                *draft.pose.get_or_insert_with(|| Isometry3::from_parts(centre.into(), UnitQuaternion::identity()));
            let offset = centre - pose.translation.vector;
            draft.bounds = Some(Bounds { offset, half: swap(b.size).abs() / 2.0, frame: BoundsFrame::World });
        }
        Ok(draft)
    }

    fn properties(&self) -> Result<PropertySet, Wrong> {
        let read = |(i, word): (usize, &String)| {
            let unknown = || {
                let near = did_you_mean(word, Property::ALL.iter().filter_map(|p| p.virtualhome()));
                FormatProblem::Shape(format!(
                    "unknown property `{}`{near}; VirtualHome's are SURFACES, GRABBABLE, ...",
                    clip(word)
                ))
            };
            Property::from_virtualhome(word).ok_or_else(|| (format!("properties[{i}]"), unknown()))
        };
        self.properties.iter().enumerate().map(read).collect()
    }

    fn states(&self) -> Result<StateSet, Wrong> {
        let at = |i: usize, e: UnknownWord| (format!("states[{i}]"), FormatProblem::Word(e));
        self.states.iter().enumerate().map(|(i, word)| State::parse(word).map_err(|e| at(i, e))).collect()
    }

    fn from_node(node: &Node) -> Self {
        let spec = node.spec();
        let turned = |pose: &&Pose| {
            // Version 1 has only boxes: no rotation, no scale, and the pose is the box's centre.
            spec.bounds.is_none_or(|b| b.offset != Vector3::zeros())
                || pose.rotation != UnitQuaternion::identity()
                || spec.scale != Vector3::repeat(1.0)
        };
        Self {
            id: node.id().0,
            category: spec.category.to_string(),
            class_name: spec.spelling.to_string(),
            prefab_name: spec.name.as_deref().map(str::to_owned),
            obj_transform: node.pose().filter(turned).map(|pose| Transform::from_pose(node, pose)),
            bounding_box: node.aabb().map(|b| bounding_box(node, &b)),
            properties: spec.properties.iter().filter_map(Property::virtualhome).map(str::to_owned).collect(),
            states: node.states().iter().filter(|s| STATES.contains(s)).map(|s| s.as_str().to_uppercase()).collect(),
        }
    }
}

fn bounding_box(node: &Node, aabb: &crate::Aabb) -> BoundingBox {
    match (node.spec().bounds, node.pose()) {
        // Write the numbers that were read, not results of arithmetic on them.
        (Some(b), Some(pose)) if b.frame == BoundsFrame::World => {
            BoundingBox { center: swap_back(pose.translation.vector + b.offset), size: swap_back(b.half * 2.0) }
        }
        _ => BoundingBox { center: swap_back(aabb.centre().coords), size: swap_back(aabb.max - aabb.min) },
    }
}

impl EnvironmentEdge {
    /// The relation as VirtualCity's kind. Missing ends are detected later.
    fn read(&self, graph: &SceneGraph) -> Edge {
        let (from, to) = (NodeId(self.from_id), NodeId(self.to_id));
        let is = |id, kind| graph.node(id).is_some_and(|n| n.kind() == kind);
        let in_state = |state| is(from, NodeKind::Agent) && graph.node(from).is_some_and(|n| n.is(state));
        let relation = match self.relation_type {
            RelationType::Inside if is(to, NodeKind::Room) => Relation::InRoom,
            RelationType::Inside => Relation::Inside,
            RelationType::Sitting => Relation::SittingOn,
            RelationType::On if in_state(State::Sitting) => Relation::SittingOn,
            RelationType::On if in_state(State::Lying) => Relation::LyingOn,
            RelationType::On if is(to, NodeKind::Agent) => Relation::WornBy,
            RelationType::On => Relation::On,
            RelationType::Between => Relation::Between,
            RelationType::Close => Relation::Near,
            RelationType::Facing => Relation::Facing,
            RelationType::HoldsRh => Relation::HoldsRight,
            RelationType::HoldsLh => Relation::HoldsLeft,
        };
        Edge::new(from, relation, to)
    }

    fn from_edge(graph: &SceneGraph, edge: Edge) -> Option<Self> {
        let sits = || graph.node(edge.from).is_some_and(|n| n.is(State::Sitting));
        let relation_type = match edge.relation {
            // Without the state, `ON` would be read as an object lying there.
            Relation::SittingOn if !sits() => RelationType::Sitting,
            Relation::On | Relation::SittingOn | Relation::LyingOn | Relation::WornBy => RelationType::On,
            Relation::Inside | Relation::InRoom | Relation::PouredInto => RelationType::Inside,
            Relation::Between => RelationType::Between,
            Relation::Near => RelationType::Close,
            Relation::Facing => RelationType::Facing,
            Relation::HoldsRight => RelationType::HoldsRh,
            Relation::HoldsLeft => RelationType::HoldsLh,
            _ => return None,
        };
        Some(Self { from_id: edge.from.0, relation_type, to_id: edge.to.0 })
    }
}
