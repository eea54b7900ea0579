//! The thesis's scene JSON (its Listing 1), both ways.
//!
//! One key, the environment's name, over a list of objects:
//!
//! ```json
//! {"Apartment_0": [
//!   {"conatiner": 0, "id": 7, "name": "SM_Glass", "relation": ["SM_Glass supported by SM_L_Table"],
//!    "state": ["Clean"], "transform": ["X=120 Y=-40 Z=75", "P=0 Y=90 R=0", "X=1 Y=1 Z=1"]}]}
//! ```
//!
//! - `conatiner` is the original's spelling; `container` is read as well.
//! - Transforms are Unreal's: centimetres, left-handed, Z up, pitch, yaw and roll
//!   in degrees. They are converted here and nowhere else.
//! - Locations are those of the centre of an object's base, and its size is its
//!   class's typical size times the scale.
//! - The class is found in the name, `SM_Coffee_Table_03`. Rooms are objects of a
//!   room class; agents are of class `character`.
//! - States add to those the class starts in: what opens is closed and what switches
//!   is off, unless the file says otherwise.
//! - In a relation, `NAME.ID` says which object is meant where several share a
//!   name; a bare name means the nearest of them.
//! - An object that is said to be in no room is in that of its support, else in
//!   the room whose box contains it.
//! - Facts that these keys cannot say are under a further one, `virtualcity`, which other readers pass over: the
//!   class where the name does not tell it, a box that does not stand on the thing's origin, states of its class that
//!   it is not in.

mod beyond;

use std::collections::HashMap;
use std::sync::Arc;

use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};
use serde::{Deserialize, Serialize};

use super::{FormatError, FormatProblem, Source};
use crate::serial::{FARTHEST, within};
use beyond::{Beyond, down};

use crate::class::{Slot, SlotKind};
use crate::node::NodeKind;
use crate::spelling::clip;
use crate::{
    Bounds, BoundsFrame, ClassTable, Draft, Edge, Node, NodeId, Pose, Relation, SceneBuilder, SceneGraph, State, Word,
};

#[derive(Serialize, Deserialize)]
struct ObjectFile {
    #[serde(rename = "conatiner", alias = "container", default)]
    containers: u32,
    id: u32,
    name: String,
    #[serde(default)]
    relation: Vec<String>,
    #[serde(default)]
    state: Vec<String>,
    transform: [String; 3],
    #[serde(default, skip_serializing_if = "Option::is_none")]
    virtualcity: Option<Beyond>,
}

/// Relative difference up to which a size is the one that a scale gives, and distance in metres up to which
/// the base of a box is at its node's origin.
const SAME: f32 = 1e-4;

/// The part of the farthest distance that rounding does not lead beyond.
const NEAR: f32 = 0.99;

/// The file's keys and what is under them; a map would drop a key that occurs twice.
struct Environments(Vec<(String, Vec<ObjectFile>)>);

impl<'de> Deserialize<'de> for Environments {
    fn deserialize<D: serde::Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        struct Entries;
        impl<'de> serde::de::Visitor<'de> for Entries {
            type Value = Environments;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("an object with one key, the environment's name, over a list of objects")
            }
            fn visit_map<A: serde::de::MapAccess<'de>>(self, mut map: A) -> Result<Environments, A::Error> {
                let mut entries = Vec::new();
                while let Some(entry) = map.next_entry()? {
                    entries.push(entry);
                }
                Ok(Environments(entries))
            }
        }
        d.deserialize_map(Entries)
    }
}

/// How relations are written.
const PHRASES: &[(&str, Relation)] = &[
    ("supported by", Relation::On),
    ("inside", Relation::Inside),
    ("under", Relation::Under),
    ("between", Relation::Between),
    ("facing", Relation::Facing),
    ("touching", Relation::Touching),
    ("near front of", Relation::NearFront),
    ("near back of", Relation::NearBack),
    ("near left of", Relation::NearLeft),
    ("near right of", Relation::NearRight),
    ("near", Relation::Near),
    ("worn by", Relation::WornBy),
    ("sitting on", Relation::SittingOn),
    ("lying on", Relation::LyingOn),
    ("holds in right hand", Relation::HoldsRight),
    ("holds in left hand", Relation::HoldsLeft),
    ("poured into", Relation::PouredInto),
    ("taken off", Relation::TakenOff),
    ("taken out of", Relation::TakenOut),
];

/// Reads a scene.
///
/// # Errors
/// [`FormatError`]: not this format, numbers or states that are none, relations to
/// objects that do not exist.
pub fn read(text: &str, classes: &Arc<ClassTable>) -> Result<SceneGraph, FormatError> {
    let source = Source::new("thesis scene", text);
    let Environments(file) = source.json()?;
    let number = file.len();
    let mut environments = file.into_iter();
    let (Some((name, objects)), None) = (environments.next(), environments.next()) else {
        let message = format!("expected one key, the environment's name, over a list of objects; found {number} keys");
        return Err(source.error(String::new(), FormatProblem::Shape(message)));
    };
    let mut scene = SceneBuilder::with_classes(name.as_str(), classes.clone());
    let at = |index: usize, field: &str| format!("{name}[{index}].{field}");
    for (index, object) in objects.iter().enumerate() {
        let draft = object.draft(classes).map_err(|(field, problem)| source.error(at(index, field), problem))?;
        let added = scene.add_with_id(NodeId(object.id), draft);
        added.map_err(|e| source.error(at(index, "id"), e))?;
    }
    let names = Names::new(&objects);
    let mut edges = Vec::new();
    for (index, object) in objects.iter().enumerate() {
        for text in &object.relation {
            let edge = names.edge(scene.graph(), object, text);
            edges.push(edge.map_err(|problem| source.error(at(index, "relation"), problem))?);
        }
    }
    scene.link_all(&edges).map_err(|e| source.error(name.clone(), e))?;
    find_rooms(&mut scene).map_err(|e| source.error(name.clone(), e))?;
    Ok(scene.build())
}

/// Writes a scene. Sizes of boxes are written as scales of their classes' typical sizes. Assets, and places in or on
/// things that are not their classes', are not written.
pub fn write(graph: &SceneGraph) -> String {
    let mut by_name: HashMap<String, usize> = HashMap::new();
    for node in graph.nodes() {
        *by_name.entry(name_of(node)).or_default() += 1;
    }
    let reference = |node: &Node| {
        let name = name_of(node);
        // A dot in a name would be taken for the one before a number.
        if name.contains('.') || by_name.get(&name).is_some_and(|&n| n > 1) { numbered(node) } else { name }
    };
    let objects = graph.nodes().map(|node| {
        let object = ObjectFile::from_node(graph, node, &reference);
        serde_json::to_string(&object).unwrap_or_default()
    });
    let name = serde_json::to_string(graph.name()).unwrap_or_default();
    format!("{{{name}: [\n{}\n]}}\n", objects.collect::<Vec<_>>().join(",\n"))
}

fn numbered(node: &Node) -> String {
    format!("{}.{}", name_of(node), node.id().0)
}

fn name_of(node: &Node) -> String {
    node.spec().name.as_ref().unwrap_or(&node.spec().spelling).to_string()
}

impl ObjectFile {
    fn draft(&self, classes: &ClassTable) -> Result<Draft, (&'static str, FormatProblem)> {
        let numbers = |index: usize, keys: [&str; 3]| {
            fields(&self.transform[index], keys).ok_or_else(|| {
                let wanted = keys.map(|k| format!("{k}=0")).join(" ");
                let message = format!("expected `{wanted}`, found `{}`", clip(&self.transform[index]));
                ("transform", FormatProblem::Shape(message))
            })
        };
        let location = numbers(0, ["X", "Y", "Z"])?;
        let rotation = numbers(1, ["P", "Y", "R"])?;
        let scale = numbers(2, ["X", "Y", "Z"])?.map(|v| v as f32);
        let states = self.state.iter().map(|word| State::parse(word)).collect::<Result<Vec<State>, _>>();
        let named = self.virtualcity.as_ref().and_then(|beyond| beyond.class.as_deref());
        let class = classes.get(named.unwrap_or(&self.name));
        let size = class.and_then(crate::Class::typical_size);
        let scale = Vector3::from(scale);
        let mut draft = Draft {
            class: named.map(Into::into).or(class.map(|c| c.name.clone())).unwrap_or_else(|| self.name.as_str().into()),
            name: Some(self.name.as_str().into()),
            // On top of those its class starts in: closed and off, unless said here.
            entering: states.map_err(|e| ("state", FormatProblem::Word(e)))?,
            pose: Some(from_unreal(location, rotation)),
            bounds: size.map(|s| Bounds::standing(s.component_mul(&scale.abs()))),
            scale: Some(scale),
            slots: self.slots(class),
            ..Draft::default()
        };
        let added = self.virtualcity.as_ref().map_or(Ok(()), |beyond| beyond.add_to(&mut draft, class));
        added.map(|()| draft).map_err(|problem| ("virtualcity", problem))
    }

    /// The class's places, unless the file counts other ones.
    fn slots(&self, class: Option<&crate::Class>) -> Option<Vec<Slot>> {
        let known = class.map_or(0, |c| storage(&c.slots));
        (self.containers > 0 && self.containers != known).then(|| {
            let seats = class.into_iter().flat_map(|c| c.slots.iter().copied()).filter(|s| !stores(s.kind));
            let counted = Slot { kind: SlotKind::Compartment, number: self.containers };
            seats.chain([counted]).collect()
        })
    }

    fn from_node(graph: &SceneGraph, node: &Node, reference: &impl Fn(&Node) -> String) -> Self {
        let own = reference(node);
        let relation = node.out.iter().filter_map(|link| {
            let to = graph.node(link.node())?;
            let relation = if link.relation() == Relation::InRoom { Relation::Inside } else { link.relation() };
            let phrase = PHRASES.iter().find(|(_, r)| *r == relation)?.0;
            // A name without a number would mean another thing.
            let to = if to.id() == node.id() { numbered(to) } else { reference(to) };
            Some(format!("{own} {phrase} {to}"))
        });
        let (name, bounds) = (name_of(node), untold(graph, node));
        Self {
            containers: storage(&node.spec().slots),
            id: node.id().0,
            relation: relation.collect(),
            state: node.states().iter().map(|s| titled(s.as_str())).collect(),
            transform: to_unreal(&base(node), scale(graph, node)),
            virtualcity: Beyond::new(node, &name, graph.classes(), bounds),
            name,
        }
    }
}

/// The pose at the middle of the base of a node's box; that of the node, if the base is farther away than this format
/// can say.
fn base(node: &Node) -> Pose {
    let pose = node.pose().copied().unwrap_or_else(Pose::identity);
    let bounds = node.spec().bounds.filter(|b| !stands(b));
    bounds.map(|b| base_of(node, &pose, &b)).filter(is_near).unwrap_or(pose)
}

fn base_of(node: &Node, pose: &Pose, bounds: &Bounds) -> Pose {
    let down = Translation3::from(down(bounds));
    match frame(node, bounds) {
        BoundsFrame::Object => pose * down,
        BoundsFrame::World => down * pose,
    }
}

fn is_near(pose: &Pose) -> bool {
    within(pose.translation.vector.as_slice(), NEAR * FARTHEST)
}

/// Whether a box stands on its node's origin: then the pose is written as it is, to the last bit.
fn stands(bounds: &Bounds) -> bool {
    down(bounds).norm() < SAME
}

/// The axes that a node's box is along; a room is not turned, and its box is along both.
fn frame(node: &Node, bounds: &Bounds) -> BoundsFrame {
    let turned = node.pose().is_some_and(|p| p.rotation != UnitQuaternion::identity());
    if node.kind() == NodeKind::Room && !turned { BoundsFrame::Object } else { bounds.frame }
}

/// The box of a node where pose and scale do not tell it.
fn untold(graph: &SceneGraph, node: &Node) -> Option<Bounds> {
    let sized = typical_size(graph, node).is_some();
    let told = |b: &Bounds| sized && stands(b) && frame(node, b) == BoundsFrame::Object;
    let pose = node.pose().copied().unwrap_or_else(Pose::identity);
    node.spec().bounds.filter(|b| !told(b) && is_near(&base_of(node, &pose, b)))
}

fn typical_size(graph: &SceneGraph, node: &Node) -> Option<Vector3<f32>> {
    graph.classes().get(node.class()).and_then(crate::Class::typical_size)
}

/// The scale that makes a node's size of its class's typical size.
fn scale(graph: &SceneGraph, node: &Node) -> Vector3<f32> {
    let written = node.spec().scale;
    let Some((own, typical)) = node.spec().bounds.zip(typical_size(graph, node)) else { return written };
    let size = own.size();
    let is_so = (0..3).all(|i| (typical[i] * written[i].abs() - size[i]).abs() <= SAME * size[i]);
    let side = |i: usize, _| size[i] / typical[i] * if written[i] < 0.0 { -1.0 } else { 1.0 };
    if is_so { written } else { Vector3::from_fn(side) }
}

/// `plugged_in` as `Plugged_In`.
fn titled(word: &str) -> String {
    let parts = word.split('_').map(|p| p[..1].to_uppercase() + &p[1..]);
    parts.collect::<Vec<_>>().join("_")
}

/// Whether a kind of place counts as a container.
fn stores(kind: SlotKind) -> bool {
    matches!(kind, SlotKind::Shelf | SlotKind::Drawer | SlotKind::Compartment | SlotKind::Basin)
}

fn storage(slots: &[Slot]) -> u32 {
    slots.iter().filter(|s| stores(s.kind)).fold(0, |sum, s| sum.saturating_add(s.number))
}

/// `X=1 Y=2 Z=3`: the three numbers, if they are of a sensible size.
fn fields(text: &str, keys: [&str; 3]) -> Option<[f64; 3]> {
    let mut parts = text.split_whitespace();
    let mut next = |key: &str| {
        let (found, number) = parts.next()?.split_once('=')?;
        let number: f64 = number.parse().ok().filter(|v: &f64| v.abs() <= 1e9)?;
        found.eq_ignore_ascii_case(key).then_some(number)
    };
    let [a, b, c] = keys;
    let all = [next(a)?, next(b)?, next(c)?];
    parts.next().is_none().then_some(all)
}

/// Unreal's axes to ours: Y changes sign, and with it the turns around X's
/// neighbours. Rotations apply roll, then pitch, then yaw.
fn from_unreal([x, y, z]: [f64; 3], [pitch, yaw, roll]: [f64; 3]) -> Pose {
    let turn = UnitQuaternion::from_euler_angles(roll.to_radians(), -pitch.to_radians(), -yaw.to_radians());
    let place = Vector3::new(x / 100.0, -y / 100.0, z / 100.0).cast::<f32>();
    Isometry3::from_parts(Translation3::from(place), turn.cast())
}

fn to_unreal(pose: &Pose, scale: Vector3<f32>) -> [String; 3] {
    let place = pose.translation.vector.map(|v| decimal(v) * 100.0);
    let (roll, pitch, yaw) = pose.rotation.cast::<f64>().euler_angles();
    let degrees = |v: f64| tidy(v.to_degrees(), 4);
    [
        format!("X={} Y={} Z={}", tidy(place.x, 8), tidy(-place.y, 8), tidy(place.z, 8)),
        format!("P={} Y={} R={}", degrees(-pitch), degrees(-yaw), degrees(roll)),
        format!("X={} Y={} Z={}", scale.x, scale.y, scale.z),
    ]
}

/// The shortest decimal that means this single-precision number.
fn decimal(value: f32) -> f64 {
    value.to_string().parse().unwrap_or_else(|_| f64::from(value))
}

/// A number without trailing zeros and without minus zero.
fn tidy(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" || text.is_empty() { "0".to_owned() } else { text.to_owned() }
}

/// When more objects share a name, relations must say which one they mean.
const AMBIGUOUS: usize = 1000;

/// Which objects a name can mean.
struct Names<'f> {
    by_name: HashMap<&'f str, Vec<u32>>,
}

impl<'f> Names<'f> {
    fn new(objects: &'f [ObjectFile]) -> Self {
        let mut by_name: HashMap<&str, Vec<u32>> = HashMap::new();
        for object in objects {
            by_name.entry(&object.name).or_default().push(object.id);
        }
        Self { by_name }
    }

    fn edge(&self, graph: &SceneGraph, object: &ObjectFile, text: &str) -> Result<Edge, FormatProblem> {
        let numbered = format!("{}.{}", object.name, object.id);
        let rest = [&numbered, &object.name].into_iter().find_map(|own| {
            let rest = text.strip_prefix(own.as_str())?.strip_prefix(' ')?;
            PHRASES
                .iter()
                .find_map(|(phrase, relation)| Some((*relation, rest.strip_prefix(phrase)?.strip_prefix(' ')?)))
        });
        let Some((relation, to)) = rest else { return Err(no_relation(object, text)) };
        let (from, to) = (NodeId(object.id), self.find(graph, NodeId(object.id), to)?);
        let into_room = relation == Relation::Inside && graph.node(to).is_some_and(|n| n.kind() == NodeKind::Room);
        Ok(Edge { from, relation: if into_room { Relation::InRoom } else { relation }, to })
    }

    fn find(&self, graph: &SceneGraph, from: NodeId, name: &str) -> Result<NodeId, FormatProblem> {
        let exact = name.rsplit_once('.').and_then(|(name, id)| {
            let id = id.parse().ok()?;
            self.by_name.get(name).filter(|ids| ids.contains(&id)).map(|_| NodeId(id))
        });
        if let Some(id) = exact {
            return Ok(id);
        }
        let sharing = self.by_name.get(name).map_or(0, Vec::len);
        if sharing > AMBIGUOUS {
            return Err(FormatProblem::Ambiguous(clip(name), sharing));
        }
        let ids = self.by_name.get(name).into_iter().flatten().map(|&id| NodeId(id)).filter(|&id| id != from);
        let far = |id: &NodeId| graph.distance(from, *id).map_or(u32::MAX, |d| (d * 1e3) as u32);
        ids.min_by_key(far).ok_or_else(|| FormatProblem::NoSuchName(clip(name)))
    }
}

fn no_relation(object: &ObjectFile, text: &str) -> FormatProblem {
    let other = PHRASES.iter().find_map(|(phrase, _)| text.split_once(&format!(" {phrase} ")));
    FormatProblem::Shape(match other {
        Some((from, _)) => format!("expected a relation of {}, found one of `{}`", clip(&object.name), clip(from)),
        None => format!("expected a relation such as `A supported by B`, found `{}`", clip(text)),
    })
}

/// Gives a room to every object that is said to be in none.
fn find_rooms(scene: &mut SceneBuilder) -> Result<(), crate::EditError> {
    let graph = scene.graph();
    let lost: Vec<NodeId> =
        graph.nodes().filter(|n| n.kind() != NodeKind::Room && graph.room_of(n.id()).is_none()).map(Node::id).collect();
    let found: Vec<(NodeId, NodeId)> = lost.iter().filter_map(|&id| Some((id, room_around(graph, id)?))).collect();
    let mut edit = scene.edit();
    for (id, room) in found {
        edit.link(Edge::new(id, Relation::InRoom, room));
    }
    edit.commit();
    Ok(())
}

fn room_around(graph: &SceneGraph, id: NodeId) -> Option<NodeId> {
    let by_box = |id: NodeId| {
        let at = graph.node(id)?.position()?;
        let contains = |room: &&NodeId| graph.node(**room).and_then(Node::aabb).is_some_and(|b| b.contains(&at));
        graph.rooms().iter().find(contains).copied()
    };
    let supports = graph.support_chain(id);
    let supported = supports.into_iter().find_map(|at| graph.room_of(at).or_else(|| by_box(at)));
    supported.or_else(|| by_box(id))
}
