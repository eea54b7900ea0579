//! Incremental updates equal a full rebuild, after any edits.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use crate::shared;

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::{UnitQuaternion, Vector3};
use proptest::prelude::*;
use vc_graph::{Bounds, Draft, Edge, NodeId, Pose, SceneBuilder, SceneGraph, Seed};
use vc_relations::threshold::WORLD_REACH;
use vc_relations::{Evidence, RelationRule, Relations};

fn by_node(edges: &[Edge]) -> BTreeMap<NodeId, Vec<Edge>> {
    let mut map: BTreeMap<NodeId, Vec<Edge>> = BTreeMap::new();
    edges.iter().for_each(|e| map.entry(e.from).or_default().push(*e));
    map
}

fn differences(a: &[Edge], b: &[Edge]) -> Vec<Edge> {
    let (a, b): (BTreeSet<Edge>, BTreeSet<Edge>) = (a.iter().copied().collect(), b.iter().copied().collect());
    a.symmetric_difference(&b).copied().collect()
}

/// Moves some objects: by a little, to another one's place, or somewhere tilted.
fn shuffle(graph: &mut SceneGraph, movable: &[NodeId], seed: Seed) -> Vec<NodeId> {
    let mut rng = seed.stream();
    let mut edit = graph.edit();
    let mut moved = Vec::new();
    for _ in 0..rng.count(1, 5) {
        let id = movable[rng.below(movable.len())];
        let goal = movable[rng.below(movable.len())];
        let pose = *edit.graph().node(id).unwrap().pose().unwrap();
        let at = edit.graph().node(goal).unwrap().pose().unwrap().translation.vector;
        let mut off = || Vector3::new(rng.between(-0.3, 0.3), rng.between(-0.3, 0.3), rng.between(-0.05, 0.3));
        let (near, far) = (off(), off());
        let pose = match rng.below(4) {
            0 => Pose::from_parts((pose.translation.vector + near).into(), pose.rotation),
            1 => Pose::from_parts((at + Vector3::z() * rng.between(0.0, 0.8)).into(), pose.rotation),
            2 => Pose::from_parts((at + far).into(), UnitQuaternion::from_euler_angles(near.x, near.y, far.x * 9.0)),
            _ => Pose::from_parts((at + far * 20.0).into(), pose.rotation),
        };
        edit.set_pose(id, Some(pose)).unwrap();
        moved.push(id);
    }
    edit.commit();
    moved
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn update_equals_rebuild(seed in any::<u64>()) {
        let (mut home, truth) = shared::home::home(100);
        let movable: Vec<NodeId> = truth.iter().map(|t| home.id(&t.name)).collect();
        let mut relations = Relations::new(&home.graph, RelationRule::Contacts, Evidence::default()).unwrap();
        let mut before = by_node(&relations.edges());
        for round in 0..12 {
            let moved = shuffle(&mut home.graph, &movable, Seed(seed).nth(round));
            let met = relations.update(&home.graph, &moved).unwrap();
            let fresh = Relations::new(&home.graph, RelationRule::Contacts, Evidence::default()).unwrap();
            let after = relations.edges();
            prop_assert!(differences(&after, &fresh.edges()).is_empty(), "{:?}", differences(&after, &fresh.edges()));
            for &id in &movable {
                prop_assert_eq!(relations.supports(id), fresh.supports(id));
                prop_assert_eq!(relations.near(id), fresh.near(id));
            }
            let after = by_node(&after);
            for node in home.graph.nodes() {
                let same = before.get(&node.id()) == after.get(&node.id());
                prop_assert!(same || met.contains(&node.id()), "{} changed unsaid", node.label());
            }
            before = after;
        }
    }
}

/// At the very limit of reach, rounding must not make the result depend on which of two nodes is updated.
#[test]
fn exactly_in_reach_is_the_same_after_an_update() {
    for step in 0..200 {
        let mut scene = SceneBuilder::new("edge");
        let size = Vector3::new(0.3, 0.3, 0.3);
        let mut put = |x: f32| {
            let draft = Draft::new("box").bounds(Bounds::standing(size)).at(Pose::translation(x, 0.7, 0.0));
            scene.add(draft).unwrap()
        };
        let x = 0.013 * step as f32;
        let (a, b) = (put(x), put(x + 1.3));
        let graph = scene.build();
        let fresh = Relations::new(&graph, RelationRule::Contacts, Evidence::default()).unwrap();
        for id in [a, b] {
            let mut updated = fresh.clone();
            updated.update(&graph, &[id]).unwrap();
            assert_eq!(updated.edges(), fresh.edges(), "at {x}");
        }
    }
}

#[test]
fn nodes_come_and_go() {
    let (mut home, _) = shared::home::home(50);
    let mut relations = Relations::new(&home.graph, RelationRule::Contacts, Evidence::default()).unwrap();
    let (apple, bowl) = (home.id("apple0"), home.id("bowl0"));
    let mut edit = home.graph.edit();
    edit.remove(apple).unwrap();
    edit.commit();
    relations.update(&home.graph, &[apple]).unwrap();
    assert!(relations.edges_of(apple).is_empty());
    assert_eq!(
        relations.edges(),
        Relations::new(&home.graph, RelationRule::Contacts, Evidence::default()).unwrap().edges()
    );
    let mut edit = home.graph.edit();
    let pose = *edit.graph().node(bowl).unwrap().pose().unwrap();
    let mut draft = vc_graph::Draft::new("apple").at(Pose::translation(0.0, 0.0, 0.02) * pose);
    draft.bounds = Some(vc_graph::Bounds::standing(Vector3::repeat(0.06)));
    let fresh = edit.add(draft).unwrap();
    edit.commit();
    relations.update(&home.graph, &[fresh]).unwrap();
    assert!(relations.has(Edge::new(fresh, vc_graph::Relation::Inside, bowl)));
    assert_eq!(
        relations.edges(),
        Relations::new(&home.graph, RelationRule::Contacts, Evidence::default()).unwrap().edges()
    );
}

/// An update that needs a rebuild, which is refused for another node, leaves everything as it was.
#[test]
fn a_refused_update_changes_nothing() {
    let (mut home, _) = shared::home::home(50);
    let mut relations = Relations::new(&home.graph, RelationRule::Contacts, Evidence::default()).unwrap();
    let (before, apple, bowl) = (relations.edges(), home.id("apple0"), home.id("bowl0"));
    let mut edit = home.graph.edit();
    edit.set_pose(apple, Some(Pose::translation(0.0, 0.0, 5.0))).unwrap();
    edit.set_pose(bowl, Some(Pose::translation(2.0 * WORLD_REACH, 0.0, 0.0))).unwrap();
    let fresh = edit.add(Draft::new("apple").at(Pose::identity())).unwrap();
    edit.commit();
    assert!(relations.update(&home.graph, &[apple, fresh]).is_err());
    assert!(differences(&relations.edges(), &before).is_empty());
    let held = Evidence { held: vec![Edge::new(apple, vc_graph::Relation::On, bowl)], ..Evidence::default() };
    assert!(relations.update_with(&home.graph, &[apple, fresh], held).is_err());
    assert_eq!((relations.evidence(), relations.edges()), (&Evidence::default(), before));
}
