//! VirtualCity's scene JSON: complete, versioned, the same bytes for the same scene.
//!
//! ```json
//! {"virtualcity": 1, "name": "flat",
//!  "nodes": [
//!   {"id": 1, "class": "kitchen", "category": "room"},
//!   {"id": 2, "class": "apple", "category": "food", "affordances": ["graspable", "eatable"],
//!    "states": ["clean"], "pose": {"position": [1, 2, 0.75], "rotation": [0, 0, 0, 1]}}],
//!  "edges": [[2, "in_room", 1]]}
//! ```
//!
//! A scene with words of its own has their declarations as lines of a [`Vocabulary`](crate::Vocabulary), here `"words":
//! ["state waxed | excludes: dusty"]`; they are added to those that the class table has.
//!
//! One node and one edge per line. Metres, kilograms, right-handed, Z up, X forward; quaternions are x, y, z,
//! w.

mod changes;

use std::fmt::Write;
use std::sync::Arc;

use serde::de::IgnoredAny;
use serde::{Deserialize, Serialize};

use super::{FormatError, FormatProblem, Source};
use crate::class::Slot;
use crate::node::{Node, NodeKind, Spec, role_of};
use crate::serial::{BoundsFile, LARGEST_SCALE, PoseFile, within};
use crate::spelling::key;
use crate::{
    Asset, AssetId, AssetLibrary, ClassTable, Edge, EditError, NodeId, ObjectRole, PropertySet, Relation, SceneBuilder,
    SceneGraph, Set, StateSet, Word,
    asset::{Material, Texture},
};

pub use changes::read_changes;

/// The version that this program writes, and the latest that it reads.
pub const VERSION: u32 = 1;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    virtualcity: u32,
    name: String,
    #[serde(default, rename = "words")]
    _words: IgnoredAny,
    nodes: Vec<NodeFile>,
    edges: Vec<(NodeId, Relation, NodeId)>,
    #[serde(default)]
    textures: Vec<Arc<Texture>>,
    #[serde(default)]
    materials: Vec<Material>,
    #[serde(default)]
    assets: Vec<Asset>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct NodeFile {
    id: NodeId,
    class: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    spelling: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    name: Option<String>,
    category: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    kind: Option<KindFile>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    properties: Option<Vec<crate::Property>>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    affordances: Vec<crate::Property>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    states: Vec<crate::State>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pose: Option<PoseFile>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    bounds: Option<BoundsFile>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    scale: Option<[f32; 3]>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    slots: Vec<Slot>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    contents: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    asset: Option<AssetId>,
}

#[derive(Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum KindFile {
    Room,
    Agent,
    Object,
}

/// The kind of a node that gives only its category.
fn implied(category: &str) -> KindFile {
    match ObjectRole::of_category(category) {
        Some(ObjectRole::Room) => KindFile::Room,
        Some(ObjectRole::Person) => KindFile::Agent,
        _ => KindFile::Object,
    }
}

/// Reads a scene.
///
/// ```
/// use vc_graph::{format::native, ClassTable, Draft, SceneBuilder};
/// let mut scene = SceneBuilder::new("flat");
/// scene.add(Draft::new("kitchen"))?;
/// let graph = scene.build();
/// let text = native::write(&graph);
/// assert_eq!(native::read(&text, &ClassTable::builtin())?, graph);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`FormatError`]: another format, a newer version, duplicate node numbers, edges to missing nodes, invalid
/// poses.
pub fn read(text: &str, classes: &Arc<ClassTable>) -> Result<SceneGraph, FormatError> {
    let source = Source::new("virtualcity scene", text);
    let classes = &with_own_words(&source, text, classes)?;
    let file: File = source.json()?;
    if file.virtualcity > VERSION {
        return Err(source.error("virtualcity".into(), FormatProblem::Version(file.virtualcity, VERSION)));
    }
    let mut graph = SceneGraph::new(file.name.as_str(), classes.clone());
    graph.assets = Arc::new(library(&source, file.textures, file.materials, file.assets)?);
    for (index, node) in file.nodes.into_iter().enumerate() {
        let at = |field: &str| format!("nodes[{index}]{field}");
        if graph.node(node.id).is_some() {
            return Err(source.error(at(".id"), EditError::Duplicate(node.id)));
        }
        let node = node
            .into_node(classes)
            .map_err(|field| source.error(at(field), FormatProblem::Number(field[1..].to_owned())))?;
        if let Some(word) = classes.vocabulary().word_lacking(&node) {
            return Err(source.error(at(""), FormatProblem::Undeclared(word)));
        }
        graph.insert(Arc::new(node));
    }
    let edges: Vec<Edge> = file.edges.into_iter().map(|(from, relation, to)| Edge { from, relation, to }).collect();
    let mut builder = SceneBuilder::from_graph(graph);
    let nowhere = |(index, id)| source.error(format!("edges[{index}]"), EditError::NoSuchNode(id));
    builder.link_each(&edges).map_err(nowhere)?;
    Ok(builder.build())
}

/// The classes with the own words of a file, which have to be known before its nodes are read.
fn with_own_words(source: &Source<'_>, text: &str, classes: &Arc<ClassTable>) -> Result<Arc<ClassTable>, FormatError> {
    #[derive(Deserialize)]
    struct Words {
        #[serde(default)]
        words: Vec<String>,
    }
    // Most scenes have none, and are read once.
    if !text.contains(r#""words""#) {
        return Ok(classes.clone());
    }
    let lines = source.json::<Words>()?.words.join("\n");
    let words = classes.vocabulary().extended("words", &lines);
    let words = words.map_err(|error| source.error("words".into(), Box::new(error)))?;
    let known = words == **classes.vocabulary();
    Ok(if known { classes.clone() } else { Arc::new(classes.with_vocabulary(words)) })
}

fn library(
    source: &Source<'_>,
    textures: Vec<Arc<Texture>>,
    materials: Vec<Material>,
    assets: Vec<Asset>,
) -> Result<AssetLibrary, FormatError> {
    let mut library = AssetLibrary::default();
    for (index, texture) in textures.into_iter().enumerate() {
        library.add_texture(texture).map_err(|e| source.error(format!("textures[{index}]"), e))?;
    }
    for (index, material) in materials.into_iter().enumerate() {
        library.add_material(material).map_err(|e| source.error(format!("materials[{index}]"), e))?;
    }
    for (index, asset) in assets.into_iter().enumerate() {
        library.add(asset).map_err(|e| source.error(format!("assets[{index}]"), e))?;
    }
    Ok(library)
}

/// Writes a scene; equal scenes give equal bytes.
///
/// ```
/// use vc_graph::format::native;
/// use vc_graph::{ClassTable, Draft, SceneBuilder};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let graph = scene.build();
/// assert_eq!(native::read(&native::write(&graph), &ClassTable::builtin())?, graph);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write(graph: &SceneGraph) -> String {
    let mut text = format!("{{\"virtualcity\": {VERSION}, \"name\": {},\n", json(&graph.name()));
    let library = graph.assets();
    let textures: Vec<&Arc<Texture>> = (0..).map_while(|i| library.texture(i)).collect();
    let materials: Vec<&Material> = (0..).map_while(|i| library.material(i)).collect();
    let assets: Vec<&Arc<Asset>> = (0..library.len() as u32).filter_map(|i| library.get(AssetId(i))).collect();
    if !graph.vocabulary().is_builtin() {
        list(&mut text, "words", graph.vocabulary().lines().map(|line| json(&line)));
        text.push_str(",\n");
    }
    list(&mut text, "nodes", graph.nodes().map(|n| json(&NodeFile::from(n))));
    text.push_str(",\n");
    // A symmetric relation is written once.
    let once = graph.edges().filter(|e| !e.relation.is_symmetric() || e.from <= e.to);
    list(&mut text, "edges", once.map(|e| json(&(e.from, e.relation, e.to))));
    if !textures.is_empty() {
        text.push_str(",\n");
        list(&mut text, "textures", textures.into_iter().map(|t| json(&**t)));
    }
    if !materials.is_empty() || !assets.is_empty() {
        text.push_str(",\n");
        list(&mut text, "materials", materials.into_iter().map(json));
        text.push_str(",\n");
        list(&mut text, "assets", assets.into_iter().map(|a| json(&**a)));
    }
    text.push_str("}\n");
    text
}

/// JSON of one of this crate's plain types, for which serialisation cannot fail.
fn json<T: Serialize + ?Sized>(value: &T) -> String {
    serde_json::to_string(value).unwrap_or_default()
}

fn list(text: &mut String, key: &str, items: impl Iterator<Item = String>) {
    let _ = write!(text, " \"{key}\": [");
    for (index, item) in items.enumerate() {
        let _ = write!(text, "{}\n  {item}", if index == 0 { "" } else { "," });
    }
    text.push(']');
}

fn words<W: Word>(set: Set<W>) -> Vec<W> {
    set.iter().collect()
}

impl From<&Node> for NodeFile {
    fn from(node: &Node) -> Self {
        let spec = node.spec();
        let kind = match spec.kind {
            NodeKind::Room => KindFile::Room,
            NodeKind::Agent => KindFile::Agent,
            NodeKind::Object => KindFile::Object,
        };
        Self {
            id: node.id(),
            class: spec.class.to_string(),
            spelling: (spec.spelling != spec.class).then(|| spec.spelling.to_string()),
            name: spec.name.as_deref().map(str::to_owned),
            category: spec.category.to_string(),
            kind: (kind != implied(&spec.category)).then_some(kind),
            properties: (spec.properties != spec.affordances).then(|| words(spec.properties)),
            affordances: words(spec.affordances),
            states: words(node.states()),
            pose: node.pose().map(PoseFile::from),
            bounds: spec.bounds.as_ref().map(BoundsFile::from),
            scale: Some(spec.scale.into()).filter(|&s: &[f32; 3]| s != [1.0; 3]),
            slots: spec.slots.to_vec(),
            contents: node.contents().map(|c| c.to_string()),
            asset: spec.asset,
        }
    }
}

/// A node as in this format: without its relations.
impl Serialize for Node {
    fn serialize<S: serde::Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        NodeFile::from(self).serialize(s)
    }
}

impl NodeFile {
    /// The node, or the name of the invalid field.
    fn into_node(self, classes: &ClassTable) -> Result<Node, &'static str> {
        let affordances: PropertySet = self.affordances.into_iter().collect();
        let kind = match self.kind.unwrap_or_else(|| implied(&self.category)) {
            KindFile::Room => NodeKind::Room,
            KindFile::Agent => NodeKind::Agent,
            KindFile::Object => NodeKind::Object,
        };
        let scale = self.scale.unwrap_or([1.0; 3]);
        if !within(&scale, LARGEST_SCALE) {
            return Err(".scale");
        }
        let spelled: Arc<str> = self.class.into();
        let class = classes.exact(&spelled);
        let name = class.map_or_else(|| Arc::from(key(&spelled)), |c| c.name.clone());
        let spec = Spec {
            role: role_of(kind, class, (&name, &self.category), affordances),
            class: name,
            spelling: self.spelling.map_or(spelled, Into::into),
            name: self.name.map(Into::into),
            category: self.category.into(),
            kind,
            properties: self.properties.map_or(affordances, |p| p.into_iter().collect()),
            affordances,
            bounds: self.bounds.map(|b| b.bounds().ok_or(".bounds")).transpose()?,
            scale: scale.into(),
            slots: self.slots.into(),
            asset: self.asset,
        };
        let states: StateSet = self.states.into_iter().collect();
        let pose = self.pose.map(|p| p.pose().ok_or(".pose")).transpose()?;
        let contents = self.contents.map(Into::into);
        Ok(Node { id: self.id, spec: Arc::new(spec), states, pose, contents, out: Vec::new(), inc: Vec::new() })
    }
}
