//! Scenes unlike any home: chains of a hundred thousand nested boxes, and numbers far apart. Nothing recurses
//! without bound, and nothing takes quadratic time.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use std::fmt::Write;

use vc_graph::format::native;
use vc_graph::{ClassTable, NodeId, Scope};

const DEPTH: u32 = 100_000;

/// A room with deeply nested boxes, and an agent.
fn russian_dolls() -> String {
    let mut nodes = String::from(
        "{\"id\": 1, \"class\": \"kitchen\", \"category\": \"room\"},\n{\"id\": 2, \"class\": \"character\", \"category\": \"character\"}",
    );
    let mut edges = String::from("[2, \"in_room\", 1]");
    for id in 3..3 + DEPTH {
        write!(nodes, ",\n{{\"id\": {id}, \"class\": \"box\", \"category\": \"prop\"}}").unwrap();
        write!(edges, ",\n[{id}, \"in_room\", 1]").unwrap();
        if id > 3 {
            write!(edges, ",\n[{id}, \"inside\", {}]", id - 1).unwrap();
        }
    }
    format!("{{\"virtualcity\": 1, \"name\": \"dolls\", \"nodes\": [{nodes}], \"edges\": [{edges}]}}")
}

#[test]
fn long_chains_are_climbed_without_recursion() {
    let graph = native::read(&russian_dolls(), &ClassTable::builtin()).unwrap();
    let innermost = NodeId(2 + DEPTH);
    assert_eq!(graph.support_chain(innermost).len(), DEPTH as usize - 1);
    assert_eq!(graph.carried_with(NodeId(3)).len(), DEPTH as usize);
    assert!(graph.rests_at(innermost, NodeId(3)));
    assert_eq!(graph.hidden_in(innermost), None);
    graph.validate();
    let mut edit = graph.clone();
    let mut edit = edit.edit();
    let place = vc_graph::Place { relation: vc_graph::Relation::Inside, at: innermost };
    assert!(edit.place(NodeId(3), place).is_err());
}

#[test]
fn numbers_may_be_far_apart() {
    let text = r#"{"virtualcity": 1, "name": "far", "nodes": [
        {"id": 4294967295, "class": "apple", "category": "food"},
        {"id": 0, "class": "kitchen", "category": "room"},
        {"id": 2147483648, "class": "character", "category": "character"}],
        "edges": [[4294967295, "in_room", 0], [2147483648, "in_room", 0]]}"#;
    let graph = native::read(text, &ClassTable::builtin()).unwrap();
    let seen = graph.observe(NodeId(2_147_483_648), Scope::Room);
    assert_eq!(seen.ids().collect::<Vec<_>>(), [0, 2_147_483_648, u32::MAX].map(NodeId));
    let mut graph = graph;
    assert_eq!(graph.edit().add(vc_graph::Draft::new("cup")).unwrap_err().to_string(), "all node numbers are used up");
}

#[test]
fn a_hundred_thousand_namesakes_are_refused_with_advice() {
    let object = |id: u32| {
        format!(
            r#"{{"id": {id}, "name": "SM_Box", "relation": ["SM_Box supported by SM_Box"], "state": [], "transform": ["X=0 Y=0 Z=0", "P=0 Y=0 R=0", "X=1 Y=1 Z=1"]}}"#
        )
    };
    let objects: Vec<String> = (0..100_000).map(object).collect();
    let text = format!("{{\"Boxes\": [{}]}}", objects.join(","));
    let error = vc_graph::format::thesis::read(&text, &ClassTable::builtin()).unwrap_err();
    assert!(error.to_string().contains("write its number as well"), "{error}");
}
