//! Test scenes from text, one thing a line:
//! `name = shape measures... @ x y z r roll pitch yaw s x y z class c state open joint 0 0.3`. `shape!`
//! declares its hollows; `boxed x y z` has only a box, no parts.

#![allow(dead_code, clippy::unwrap_used, reason = "each test uses a part, and tests may unwrap")]

pub(crate) mod home;
pub(crate) mod peers;
pub(crate) mod shapes;

use std::collections::BTreeMap;
use std::sync::Arc;

use nalgebra::{UnitQuaternion, Vector3};
use vc_graph::asset::Material;
use vc_graph::{AssetLibrary, Bounds, Draft, Edge, NodeId, Pose, Relation, SceneBuilder, SceneGraph, State};
use vc_relations::Evidence;

/// A scene with names for its nodes.
#[derive(Debug)]
pub(crate) struct Named {
    pub(crate) graph: SceneGraph,
    pub(crate) ids: BTreeMap<String, NodeId>,
    pub(crate) evidence: Evidence,
}

impl Named {
    pub(crate) fn id(&self, name: &str) -> NodeId {
        *self.ids.get(name).unwrap_or_else(|| panic!("nothing is called `{name}`"))
    }
}

struct Words<'a>(std::iter::Peekable<std::str::SplitWhitespace<'a>>);

impl<'a> Words<'a> {
    fn next(&mut self) -> &'a str {
        self.0.next().unwrap_or_else(|| panic!("line ends early"))
    }

    fn numbers(&mut self) -> Vec<f32> {
        let mut found = Vec::new();
        while let Some(Ok(number)) = self.0.peek().map(|w| w.parse()) {
            found.push(number);
            self.0.next();
        }
        found
    }

    fn three(&mut self) -> Vector3<f32> {
        Vector3::from_iterator(self.numbers().into_iter().chain([0.0; 3]).take(3))
    }
}

pub(crate) fn library() -> AssetLibrary {
    let mut library = AssetLibrary::default();
    let material = Material { density: 600.0, ..Material::new("wood", [0.5; 3]) };
    library.add_material(material).unwrap();
    library
}

/// Parses one line of a scene into a name, a draft, and the positions of its joints.
pub(crate) fn thing(line: &str, library: &mut AssetLibrary) -> (String, Draft, Vec<(u32, f32)>) {
    let mut words = Words(line.split_whitespace().peekable());
    let name = words.next().to_owned();
    assert_eq!(words.next(), "=", "in `{line}`");
    let shape = words.next();
    let measures = words.numbers();
    let mut draft = match shape {
        "boxed" => Draft::new("carton").bounds(Bounds::standing(Vector3::from_column_slice(&measures))),
        "room" => {
            let size = Vector3::new(measures[0], measures[1], 2.5);
            Draft::new("bedroom").bounds(Bounds::standing(size))
        }
        _ => {
            let (class, asset) = shapes::make(shape.trim_end_matches('!'), &measures, shape.ends_with('!'));
            let mut draft = Draft::new(class);
            draft.asset = Some(library.add(asset).unwrap());
            draft
        }
    };
    let (mut at, mut turn, mut joints) = (Vector3::zeros(), UnitQuaternion::identity(), Vec::new());
    while words.0.peek().is_some() {
        match words.next() {
            "@" => at = words.three(),
            "r" => {
                let angles = words.three().map(f32::to_radians);
                turn = UnitQuaternion::from_euler_angles(angles.x, angles.y, angles.z);
            }
            "s" => draft.scale = Some(words.three()),
            "class" => draft.class = words.next().into(),
            "state" => draft.entering.push(words.next().parse::<State>().unwrap()),
            "joint" => {
                let pair = words.numbers();
                joints.push((pair[0] as u32, pair[1]));
            }
            other => panic!("unknown word `{other}` in `{line}`"),
        }
    }
    draft.pose = Some(Pose::from_parts(at.into(), turn));
    (name, draft, joints)
}

/// Builds a scene from lines. Lines may also be edges such as `me holds_right cup`, or `floor in kitchen` for
/// the room of a floor.
pub(crate) fn scene<'a>(lines: impl IntoIterator<Item = &'a str>) -> Named {
    let mut builder = SceneBuilder::new("truth");
    let (mut library, mut ids, mut evidence) = (library(), BTreeMap::new(), Evidence::default());
    let mut edges = Vec::new();
    for line in lines {
        if !line.contains('=') {
            let words: Vec<&str> = line.split_whitespace().collect();
            edges.push((words[0].to_owned(), words[1].to_owned(), words[2].to_owned()));
            continue;
        }
        let (name, draft, joints) = thing(line, &mut library);
        let id = builder.add(draft).unwrap();
        joints.into_iter().for_each(|(joint, position)| {
            evidence.positions.insert((id, joint), position);
        });
        assert!(ids.insert(name, id).is_none(), "two things of one name: `{line}`");
    }
    builder.assets(Arc::new(library));
    for (from, relation, to) in edges {
        let relation = if relation == "in" { Relation::InRoom } else { relation.parse().unwrap() };
        builder.link_all(&[Edge::new(ids[&from], relation, ids[&to])]).unwrap();
    }
    Named { graph: builder.build(), ids, evidence }
}
