//! The thesis's rule to the letter: all relations of small scenes, worked out by hand from its definition,
//! including those that are wrong in reality.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use crate::shared;

use std::collections::BTreeSet;

use serde_json::Value;
use vc_graph::Edge;
use vc_relations::{RelationRule, Relations};

fn words(value: &Value) -> Vec<&str> {
    value.as_array().unwrap().iter().map(|v| v.as_str().unwrap()).collect()
}

fn edge(scene: &shared::Named, text: &str) -> Edge {
    let words: Vec<&str> = text.split(' ').collect();
    Edge::new(scene.id(words[0]), words[1].parse().unwrap(), scene.id(words[2]))
}

#[test]
fn all_relations_are_those_worked_out_by_hand() {
    for line in include_str!("../data/box_traces.jsonl").lines() {
        let case: Value = serde_json::from_str(line).unwrap();
        let scene = shared::scene(words(&case["scene"]));
        let relations = Relations::new(&scene.graph, RelationRule::BoxTrace, scene.evidence.clone()).unwrap();
        let expected: BTreeSet<Edge> = words(&case["edges"]).iter().map(|e| edge(&scene, e)).collect();
        let found: BTreeSet<Edge> = relations.edges().into_iter().collect();
        let named = |edges: &mut dyn Iterator<Item = &Edge>| -> Vec<String> {
            let name = |id| scene.ids.iter().find(|n| *n.1 == id).map_or("?", |n| n.0);
            edges.map(|e| format!("{} {:?} {}", name(e.from), e.relation, name(e.to))).collect()
        };
        let (missed, wrong) = (named(&mut expected.difference(&found)), named(&mut found.difference(&expected)));
        assert!(missed.is_empty() && wrong.is_empty(), "{}: missed {missed:?}, wrong {wrong:?}", case["name"]);
    }
}
