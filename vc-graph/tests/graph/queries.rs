//! Queries compared with slow, obvious versions: scans over all nodes and edges.
#![allow(clippy::unwrap_used)]

use std::collections::BTreeSet;

use nalgebra::Point3;
use proptest::prelude::*;
use vc_graph::{
    Draft, NEAR, Node, NodeId, NodeKind, Place, Pose, Property, Relation, SceneBuilder, SceneGraph, Scope, State, Word,
};
use vc_testkit::cases;
use vc_testkit::edits::{apply, plans};
use vc_testkit::scenes::{CLASSES, scene, steps};

/// A scene whose debug output is its file.
struct Shown(SceneGraph);

impl std::fmt::Debug for Shown {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&vc_graph::format::native::write(&self.0))
    }
}

/// A random scene after random edits.
fn graphs() -> impl Strategy<Value = Shown> {
    (steps(20), plans(20), any::<bool>()).prop_map(|(steps, plans, posed)| {
        let mut graph = scene(&steps, posed);
        plans.into_iter().for_each(|plan| drop(apply(&mut graph, plan)));
        Shown(graph)
    })
}

fn ids(graph: &SceneGraph) -> Vec<NodeId> {
    graph.nodes().map(Node::id).collect()
}

fn ends(graph: &SceneGraph, from: NodeId, relation: Relation) -> Vec<NodeId> {
    graph.edges().filter(|e| e.from == from && e.relation == relation).map(|e| e.to).collect()
}

fn starts(graph: &SceneGraph, relation: Relation, to: NodeId) -> Vec<NodeId> {
    graph.edges().filter(|e| e.to == to && e.relation == relation).map(|e| e.from).collect()
}

fn room_of(graph: &SceneGraph, id: NodeId) -> Option<NodeId> {
    if graph.node(id)?.kind() == NodeKind::Room { Some(id) } else { ends(graph, id, Relation::InRoom).first().copied() }
}

fn places(graph: &SceneGraph, id: NodeId) -> BTreeSet<Place> {
    let resting = |r: &Relation| Relation::places().contains(r);
    let on = graph.edges().filter(|e| e.from == id && resting(&e.relation));
    let on = on.map(|e| Place { relation: e.relation, at: e.to });
    let held = graph.edges().filter(|e| e.to == id && Relation::hands().contains(&e.relation));
    on.chain(held.map(|e| Place { relation: e.relation, at: e.from })).collect()
}

/// All supports and containers of a node, direct and indirect.
fn chain(graph: &SceneGraph, id: NodeId) -> BTreeSet<NodeId> {
    let mut found = BTreeSet::new();
    let mut open = vec![id];
    while let Some(next) = open.pop() {
        open.extend(places(graph, next).into_iter().map(|p| p.at).filter(|&at| found.insert(at)));
    }
    found
}

/// The closed containers that a node is inside, directly or indirectly.
fn hiding(graph: &SceneGraph, id: NodeId) -> BTreeSet<NodeId> {
    let below = chain(graph, id).into_iter().chain([id]);
    let inside = below.flat_map(|n| ends(graph, n, Relation::Inside));
    let closed = |n: &Node| n.is(State::Closed) && n.affords(Property::Openable);
    inside.filter(|&at| graph.node(at).is_some_and(closed)).collect()
}

fn distance(graph: &SceneGraph, from: NodeId, to: NodeId) -> Option<f32> {
    let (start, node) = (graph.node(from)?.position()?, graph.node(to)?);
    let target = match node.aabb() {
        Some(aabb) => {
            Point3::new(start.x.clamp(aabb.min.x, aabb.max.x), start.y.clamp(aabb.min.y, aabb.max.y), start.z)
        }
        None => node.position()?,
    };
    Some((target.x - start.x).hypot(target.y - start.y))
}

fn near(graph: &SceneGraph, agent: NodeId, id: NodeId) -> bool {
    let about = |id| ends(graph, id, Relation::Near).into_iter().collect::<BTreeSet<_>>();
    let (mine, its) = (about(agent), chain(graph, id));
    let node = graph.node(id).unwrap();
    let same_room = room_of(graph, agent) == room_of(graph, id);
    if node.kind() == NodeKind::Room && !node.affords(Property::BodyPart) {
        return mine.contains(&id) || room_of(graph, agent) == Some(id);
    }
    // If poses and rooms are known, an object in another room is not near through a near object.
    let known = [agent, id].iter().all(|n| graph.node(*n).unwrap().pose().is_some() && room_of(graph, *n).is_some());
    node.affords(Property::BodyPart)
        || mine.contains(&id)
        || !(mine.is_disjoint(&about(id)) && mine.is_disjoint(&its)) && (same_room || !known)
        || its.contains(&agent)
        || chain(graph, agent).contains(&id)
        || same_room && distance(graph, agent, id).is_some_and(|d| d <= NEAR)
}

proptest! {
    #![proptest_config(cases(150))]

    #[test]
    fn relations_both_ways(Shown(graph) in graphs()) {
        for id in ids(&graph) {
            for &relation in Relation::ALL {
                prop_assert_eq!(graph.related(id, relation).collect::<Vec<_>>(), ends(&graph, id, relation));
                prop_assert_eq!(graph.relating(relation, id).collect::<Vec<_>>(), starts(&graph, relation, id));
            }
        }
    }

    #[test]
    fn rooms_and_people(Shown(graph) in graphs()) {
        let of_kind = |kind| graph.nodes().filter(|n| n.kind() == kind).map(Node::id).collect::<Vec<_>>();
        prop_assert_eq!(graph.rooms(), of_kind(NodeKind::Room));
        prop_assert_eq!(graph.agents(), of_kind(NodeKind::Agent));
        for id in ids(&graph) {
            prop_assert_eq!(graph.room_of(id), room_of(&graph, id));
            let inside: Vec<NodeId> = graph.in_room(id).collect();
            prop_assert_eq!(inside, starts(&graph, Relation::InRoom, id));
        }
    }

    #[test]
    fn classes_and_their_kinds(Shown(graph) in graphs()) {
        for class in CLASSES.iter().chain(&["table", "seat", "food", "furniture", "KitchenTable", "nothing"]) {
            let slow: Vec<NodeId> =
                graph.nodes().filter(|n| graph.classes().is_a(n.class(), class)).map(Node::id).collect();
            prop_assert_eq!(graph.of_class(class), slow, "{}", class);
        }
    }

    #[test]
    fn radius(Shown(graph) in graphs(), x in -25.0_f32..25.0, y in -25.0_f32..25.0, z in -25.0_f32..25.0, r in 0.0_f32..60.0) {
        let centre = Point3::new(x, y, z);
        let close = |n: &&Node| n.position().is_some_and(|p| nalgebra::distance_squared(&p, &centre) <= r * r);
        let slow: Vec<NodeId> = graph.nodes().filter(close).map(Node::id).collect();
        prop_assert_eq!(graph.within(centre, r), slow);
        let all: Vec<NodeId> = graph.nodes().filter(|n| n.pose().is_some()).map(Node::id).collect();
        prop_assert_eq!(graph.within(centre, f32::INFINITY), all);
        prop_assert_eq!(graph.within(centre, f32::NAN), []);
    }

    #[test]
    fn places_and_chains(Shown(graph) in graphs()) {
        for id in ids(&graph) {
            let direct = places(&graph, id);
            prop_assert_eq!(graph.places(id).collect::<BTreeSet<_>>(), direct.clone());
            prop_assert_eq!(graph.place(id).is_some(), !direct.is_empty());
            prop_assert!(graph.place(id).is_none_or(|p| direct.contains(&p)));
            let supports = chain(&graph, id);
            prop_assert_eq!(graph.support_chain(id).into_iter().collect::<BTreeSet<_>>(), supports.clone());
            for other in ids(&graph) {
                prop_assert_eq!(graph.rests_at(id, other), supports.contains(&other));
                let carried = id == other || chain(&graph, other).contains(&id);
                prop_assert_eq!(graph.carried_with(id).contains(&other), carried);
            }
        }
    }

    #[test]
    fn hands(Shown(graph) in graphs()) {
        for id in ids(&graph) {
            let held: Vec<NodeId> = Relation::hands().iter().flat_map(|&hand| ends(&graph, id, hand)).collect();
            prop_assert_eq!(graph.held(id).collect::<Vec<_>>(), held);
            let free = Relation::hands().into_iter().find(|&hand| ends(&graph, id, hand).is_empty());
            prop_assert_eq!(graph.free_hand(id), free);
            let holder = Relation::hands().iter().flat_map(|&hand| starts(&graph, hand, id)).next();
            prop_assert_eq!(graph.holder(id).map(|p| p.at), holder);
        }
    }

    #[test]
    fn hidden(Shown(graph) in graphs()) {
        for id in ids(&graph) {
            let closed = hiding(&graph, id);
            match graph.hidden_in(id) {
                Some(by) => prop_assert!(closed.contains(&by) && graph.rests_at(id, by)),
                None => prop_assert_eq!(closed, BTreeSet::new()),
            }
        }
    }

    #[test]
    fn nearness(Shown(graph) in graphs()) {
        for &agent in graph.agents() {
            for id in ids(&graph) {
                let (fast, slow) = (graph.distance(agent, id), distance(&graph, agent, id));
                prop_assert_eq!(fast.is_some(), slow.is_some());
                prop_assert!(fast.zip(slow).is_none_or(|(a, b)| (a - b).abs() < 1e-4));
                let close_call = slow.is_some_and(|d| (d - NEAR).abs() < 1e-4);
                prop_assert!(close_call || graph.near(agent, id) == near(&graph, agent, id), "{agent} {id}");
            }
        }
    }
}

#[test]
fn an_absent_node_has_nothing() {
    let graph = scene(&[], true);
    let none = NodeId(404);
    assert_eq!(graph.label(none).to_string(), "?.404");
    assert!(graph.node(none).is_none() && graph.room_of(none).is_none() && graph.place(none).is_none());
    assert!(graph.in_room(none).next().is_none() && graph.support_chain(none).is_empty());
    assert!(!graph.near(none, none) && !graph.facing(none, none) && graph.hidden_in(none).is_none());
}

#[test]
fn nothing_is_within_less_than_nothing() {
    let mut scene = vc_graph::SceneBuilder::new("one");
    let cup = scene.add(vc_graph::Draft::new("cup").at(vc_graph::Pose::identity())).unwrap();
    let graph = scene.build();
    assert_eq!(graph.within(Point3::origin(), 0.0), [cup]);
    for radius in [-0.5, -5.0, -50.0, f32::NEG_INFINITY] {
        assert_eq!(graph.within(Point3::origin(), radius), [], "{radius}");
    }
}

#[test]
fn positions_far_away_are_found() {
    let mut scene = vc_graph::SceneBuilder::new("far");
    let pose = vc_graph::Pose::translation(9.0e6, -9.0e6, 0.0);
    let cup = scene.add(vc_graph::Draft::new("cup").at(pose)).unwrap();
    let graph = scene.build();
    assert_eq!(graph.within(Point3::new(9.0e6, -9.0e6, 0.0), 1.0), [cup]);
    assert_eq!(graph.within(Point3::new(8.0e6, -9.0e6, 0.0), 1.0), []);
}

/// If two pictures hang on either side of a wall, only the one in the agent's own room is near; without poses,
/// the graph's relation decides.
#[test]
fn what_hangs_behind_the_wall_is_not_near() {
    use vc_graph::{Draft, Edge, Pose, SceneBuilder};
    for posed in [true, false] {
        let mut scene = SceneBuilder::new("flat");
        let rooms = ["bedroom", "kitchen"].map(|class| scene.add(Draft::new(class)).unwrap());
        let mut put = |room: usize, class: &str, y: f32| {
            let pose = posed.then(|| Pose::translation(0.0, y, 0.0));
            scene.add_in(rooms[room], Draft { pose, ..Draft::new(class) }).unwrap()
        };
        let (me, wall) = (put(0, "character", -3.0), put(0, "wall", 0.0));
        let pictures = [put(0, "picture", -0.1), put(1, "picture", 0.1)];
        let on = |id| Edge::new(id, Relation::On, wall);
        scene.link_all(&[Edge::new(me, Relation::Near, wall), on(pictures[0]), on(pictures[1])]).unwrap();
        let graph = scene.build();
        assert_eq!(pictures.map(|id| graph.near(me, id)), [true, !posed]);
    }
}

/// A missing node sees nothing; an agent with a negative radius or NaN sees only the rooms and itself.
#[test]
fn nobody_sees_nothing() {
    let mut scene = SceneBuilder::new("flat");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let me = scene.add_in(kitchen, Draft::new("character").at(Pose::identity())).unwrap();
    scene.add_in(kitchen, Draft::new("cup").at(Pose::identity())).unwrap();
    let graph = scene.build();
    for scope in [Scope::Room, Scope::Radius(5.0), Scope::Whole] {
        assert!(graph.observe(NodeId(99), scope).is_empty(), "{scope:?}");
    }
    for radius in [f32::NAN, -1.0, f32::NEG_INFINITY] {
        assert_eq!(graph.observe(me, Scope::Radius(radius)).ids().collect::<Vec<_>>(), [kitchen, me]);
    }
    assert_eq!(graph.observe(me, Scope::Radius(f32::INFINITY)).len(), 3);
}
