//! The traces, distances and hollows behind the relations, compared with slow and simple versions of them,
//! through the public interface.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use crate::shared;

use nalgebra::{Point3, UnitQuaternion, Vector3};
use proptest::prelude::*;
use vc_graph::{Bounds, Draft, NodeId, Pose, Relation, SceneBuilder, SceneGraph};
use vc_relations::{Evidence, InputFlaw, RelationRule, Relations};

fn boxes(list: &[(Vector3<f32>, Pose)]) -> SceneGraph {
    let mut scene = SceneBuilder::new("boxes");
    for (half, pose) in list {
        let bounds = Bounds { offset: Vector3::zeros(), half: *half, frame: vc_graph::BoundsFrame::Object };
        scene.add(Draft::new("carton").bounds(bounds).at(*pose)).unwrap();
    }
    scene.build()
}

fn pose() -> impl Strategy<Value = Pose> {
    let number = |r: f32| -r..r;
    (number(1.0), number(1.0), number(1.0), number(3.0), number(3.0), number(3.0), any::<bool>()).prop_map(
        |(x, y, z, roll, pitch, yaw, upright)| {
            let (roll, pitch) = if upright { (0.0, 0.0) } else { (roll, pitch) };
            Pose::from_parts(Vector3::new(x, y, z).into(), UnitQuaternion::from_euler_angles(roll, pitch, yaw))
        },
    )
}

fn half() -> impl Strategy<Value = Vector3<f32>> {
    (0.05_f32..0.4, 0.05_f32..0.4, 0.05_f32..0.4).prop_map(|(x, y, z)| Vector3::new(x, y, z))
}

/// The point of a box nearest to a point.
fn nearest(half: &Vector3<f32>, pose: &Pose, point: &Point3<f32>) -> Point3<f32> {
    let own = pose.inverse_transform_point(point).coords;
    pose * Point3::from(own.sup(&-half).inf(half))
}

/// Distance between two boxes by alternating projections until convergence (Cheney and Goldstein 1959).
fn slow_distance(a: &(Vector3<f32>, Pose), b: &(Vector3<f32>, Pose)) -> f32 {
    slow_bounds(a, b).1
}

/// Lower and upper bounds of the distance between two boxes. The upper bound is the distance of two of their
/// points, the lower one the gap between the boxes along the line through these. Where boxes nearly touch at a
/// slant, projections converge slowly and the bounds differ.
fn slow_bounds(a: &(Vector3<f32>, Pose), b: &(Vector3<f32>, Pose)) -> (f32, f32) {
    let mut at = Point3::from(b.1.translation.vector);
    let mut other = at;
    for _ in 0..1000 {
        other = nearest(&a.0, &a.1, &at);
        at = nearest(&b.0, &b.1, &other);
    }
    let way = at - other;
    let along = way.try_normalize(1e-9).unwrap_or_else(Vector3::zeros);
    let reach = |(half, pose): &(Vector3<f32>, Pose), way: Vector3<f32>| {
        way.dot(&pose.translation.vector) + (pose.rotation.inverse() * way).abs().dot(half)
    };
    let gap = -reach(b, -along) - reach(a, along);
    (gap.max(0.0), way.norm())
}

/// Distance that one box falls until it hits another: it repeatedly falls by their distance, which cannot take
/// it past.
fn slow_drop(a: &(Vector3<f32>, Pose), b: &(Vector3<f32>, Pose), limit: f32) -> Option<f32> {
    let mut down = 0.0;
    while down < limit {
        let moved = Pose::from_parts((a.1.translation.vector - Vector3::z() * down).into(), a.1.rotation);
        let apart = slow_distance(&(a.0, moved), b);
        if apart < 1e-3 {
            return Some(down);
        }
        down += apart;
    }
    None
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn distances_are_those_of_the_slow_way(a in half(), p in pose(), b in half(), q in pose()) {
        let (one, two) = ((a, p), (b, q));
        let graph = boxes(&[one, two]);
        let relations = Relations::new(&graph, RelationRule::Contacts, Evidence::default()).unwrap();
        let (least, most) = slow_bounds(&one, &two);
        match relations.near(NodeId(1)).first() {
            Some(near) => {
                let within = near.distance > least - 2e-3 && near.distance < most + 2e-3;
                prop_assert!(within, "{} against {least} to {most}", near.distance);
            }
            None => prop_assert!(most > 0.999),
        }
        let back = relations.near(NodeId(2)).first().map(|n| n.distance);
        prop_assert_eq!(back, relations.near(NodeId(1)).first().map(|n| n.distance));
    }

    /// The swept box of the thesis's down trace hits exactly what the dropped box hits.
    #[test]
    fn sweeps_meet_what_a_dropped_box_meets(a in half(), p in pose(), b in half(), q in pose()) {
        let (one, two) = ((a, p), (b, q));
        let graph = boxes(&[one, two]);
        let relations = Relations::new(&graph, RelationRule::BoxTrace, Evidence::default()).unwrap();
        let hit = relations.between(NodeId(1), NodeId(2)).contains(&Relation::On);
        let slow = slow_drop(&one, &two, 2.9);
        // Grazing hits may go either way, so the slow result must be the same with a thicker and with a thinner
        // box.
        let sure = |by: f32| slow_drop(&(a.map(|h| h + by), p), &two, 2.9).is_some();
        if sure(0.004) == sure(-0.004) {
            prop_assert_eq!(hit, slow.is_some());
        }
    }

    /// In any scene, relations are sorted, symmetric where they should be, free of cycles, and no node is both
    /// on and in the same thing.
    #[test]
    fn relations_are_sound_in_any_heap(
        list in prop::collection::vec((half(), pose()), 2..14),
        agent in any::<bool>(),
    ) {
        let mut graph = boxes(&list);
        if agent {
            let mut edit = graph.edit();
            let bounds = Bounds::standing(Vector3::new(0.3, 0.4, 1.7));
            edit.add(Draft::new("character").bounds(bounds).at(list[0].1)).unwrap();
            edit.commit();
        }
        let relations = Relations::new(&graph, RelationRule::Contacts, Evidence::default()).unwrap();
        let edges = relations.edges();
        prop_assert!(edges.is_sorted());
        for edge in &edges {
            if edge.relation.is_symmetric() {
                let back = vc_graph::Edge::new(edge.to, edge.relation, edge.from);
                prop_assert!(edges.binary_search(&back).is_ok());
            }
            prop_assert!(relations.explain(edge.from, edge.to).unwrap().holds.contains(&edge.relation));
        }
        for node in graph.nodes() {
            let mut met = vec![node.id()];
            let mut next = 0;
            while next < met.len() {
                let supports = relations.supports(met[next]);
                for by in supports.into_iter().map(|s| s.by) {
                    prop_assert!(by != node.id(), "{} rests on itself", node.label());
                    if !met.contains(&by) {
                        met.push(by);
                    }
                }
                next += 1;
            }
        }
    }
}

fn hostile(worst: &'static [f32]) -> impl Strategy<Value = f32> {
    prop_oneof![4 => 0.0_f32..2.0, 1 => prop::sample::select(worst)]
}

/// A size that may be invalid, and a position; graphs accept no poses that are not finite.
fn hostile_box() -> impl Strategy<Value = [f32; 6]> {
    let size = prop::array::uniform3(hostile(&[f32::NAN, f32::INFINITY, -1.0, 1e30, f32::MIN_POSITIVE, 0.0]));
    let place = prop::array::uniform3(hostile(&[1e30, -1e30, -2.0, 9_999.0, 10_001.0]));
    (size, place).prop_map(|(s, p)| [s[0], s[1], s[2], p[0], p[1], p[2]])
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    /// Either all numbers are valid, or all invalid ones are named; never a panic.
    #[test]
    fn hostile_numbers_are_refused_by_name(numbers in prop::collection::vec(hostile_box(), 1..6)) {
        let number = |n: &[f32; 6]| (Vector3::new(n[0], n[1], n[2]), Pose::translation(n[3], n[4], n[5]));
        let graph = boxes(&numbers.iter().map(number).collect::<Vec<_>>());
        let is_bad = |n: &&[f32; 6]| {
            n[..3].iter().any(|&v| !(0.0..=1e4).contains(&v)) || n[3..].iter().any(|v| !(-1e4..=1e4).contains(v))
        };
        let bad = numbers.iter().filter(is_bad).count();
        for rule in [RelationRule::Contacts, RelationRule::BoxTrace, RelationRule::VirtualHome] {
            match Relations::new(&graph, rule, Evidence::default()) {
                Ok(mut relations) => {
                    prop_assert_eq!(bad, 0);
                    relations.update(&graph, &[NodeId(1), NodeId(99)]).unwrap();
                    prop_assert!(relations.edges_of(NodeId(99)).is_empty());
                    prop_assert!(relations.explain(NodeId(1), NodeId(99)).is_none());
                }
                Err(error) => prop_assert!(bad > 0 && error.flaws.len() >= bad, "{error}"),
            }
        }
    }
}

#[test]
fn flaws_are_named_and_change_nothing() {
    let mut graph = boxes(&[(Vector3::repeat(0.1), Pose::identity()), (Vector3::repeat(0.1), Pose::identity())]);
    let mut relations = Relations::new(&graph, RelationRule::Contacts, Evidence::default()).unwrap();
    let before = relations.edges();
    let mut edit = graph.edit();
    edit.set_pose(NodeId(1), Some(Pose::translation(0.0, 20_000.0, 0.0))).unwrap();
    edit.commit();
    let error = relations.update(&graph, &[NodeId(1)]).unwrap_err();
    assert_eq!(error.flaws, [InputFlaw::TooFar { node: graph.label(NodeId(1)), what: "position", value: 20_000.0 }]);
    let label = graph.label(NodeId(1));
    assert_eq!(error.to_string(), format!("position of {label} is 20000 m, more than 10000 m"));
    assert_eq!(relations.edges(), before);
    let nan = Vector3::new(0.0, 0.0, f32::NAN);
    let contact = vc_relations::ContactEvidence { between: (NodeId(1), NodeId(2)), impulse: nan };
    let near = vc_graph::Edge::new(NodeId(1), Relation::Near, NodeId(2));
    let evidence = Evidence::default().contact(contact).holding(near).positioned(NodeId(2), 0, f32::INFINITY);
    assert_eq!(relations.set_evidence(&graph, evidence).unwrap_err().flaws.len(), 3);
}

#[test]
fn contacts_decide_before_traces() {
    let scene =
        shared::scene(["a = box 0.3 0.3 0.3", "b = box 0.3 0.3 0.3 @ 0.3 0 0", "c = box 0.2 0.2 0.2 @ 0.15 0 0.3"]);
    let [a, b, c] = ["a", "b", "c"].map(|n| scene.id(n));
    let traced = Relations::new(&scene.graph, RelationRule::Contacts, Evidence::default()).unwrap();
    assert_eq!(traced.supports(c).iter().map(|s| s.by).collect::<Vec<_>>(), [a, b]);
    let contact = |on, up: f32| vc_relations::ContactEvidence { between: (on, c), impulse: Vector3::new(0.0, 0.0, up) };
    let evidence = Evidence::default().contact(contact(a, 0.95)).contact(contact(b, 0.05));
    let pushed = Relations::new(&scene.graph, RelationRule::Contacts, evidence).unwrap();
    let supports = pushed.supports(c);
    assert_eq!(supports.iter().map(|s| s.by).collect::<Vec<_>>(), [a]);
    assert!((supports[0].share - 0.95).abs() < 1e-6);
}

#[test]
fn joints_take_the_place_of_support() {
    let scene =
        shared::scene(["floor = floor 4 4", "frame = box 0.6 0.6 1.8", "leaf = box 0.05 0.6 1.7 @ 0.33 0 0.05"]);
    let attachment = vc_relations::Attachment { child: scene.id("leaf"), parent: scene.id("frame") };
    let relations =
        Relations::new(&scene.graph, RelationRule::Contacts, Evidence::default().attached(attachment)).unwrap();
    assert_eq!(relations.between(scene.id("leaf"), scene.id("frame"))[0], Relation::On);
    assert!(!relations.between(scene.id("leaf"), scene.id("floor")).contains(&Relation::On));
}

#[test]
fn what_is_written_back_is_sound() {
    let (mut home, truth) = shared::home::home(50);
    let relations = Relations::new(&home.graph, RelationRule::Contacts, Evidence::default()).unwrap();
    let all: Vec<NodeId> = home.graph.nodes().map(vc_graph::Node::id).collect();
    relations.write(&mut home.graph, &all).unwrap();
    for t in &truth {
        let place = home.graph.place(home.id(&t.name)).unwrap();
        assert!(place.at == home.id(&t.on) || t.inside.as_ref().is_some_and(|c| place.at == home.id(c)), "{}", t.name);
    }
    let cycles = home.graph.validate().into_iter().filter(|v| matches!(v, vc_graph::Violation::SupportCycle(_)));
    assert_eq!(cycles.count(), 0);
}
