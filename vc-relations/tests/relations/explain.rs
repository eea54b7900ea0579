//! Explanations of relations that hold or do not, for any pair and by any rule: every verdict once.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use crate::shared;

use nalgebra::{Point3, Vector3};
use vc_graph::{Edge, Relation};
use vc_relations::{
    BoxTrace, ContactEvidence, Evidence, Explanation, Hit, NearSide, RelationRule, Relations, TraceOutcome,
};

fn explain(rule: RelationRule, lines: &[&str], from: &str, to: &str) -> (shared::Named, Explanation) {
    let scene = shared::scene(lines.iter().copied());
    let relations = Relations::new(&scene.graph, rule, scene.evidence.clone()).unwrap();
    let why = relations.explain(scene.id(from), scene.id(to)).unwrap();
    (scene, why)
}

fn why(lines: &[&str], from: &str, to: &str) -> Explanation {
    explain(RelationRule::Contacts, lines, from, to).1
}

fn hit_of(why: &Explanation, hits: &[Hit]) -> Hit {
    *hits.iter().find(|h| h.node == why.to).unwrap_or_else(|| panic!("not met: {why}"))
}

#[test]
fn hits_tell_what_was_met_where() {
    let scene =
        shared::scene(["floor = floor 4 4", "table = table 0.8 1.2 0.75", "cup = mug 0.08 0.1 @ 0.1 0.2 0.752"]);
    let relations = Relations::new(&scene.graph, RelationRule::Contacts, Evidence::default()).unwrap();
    let why = relations.explain(scene.id("cup"), scene.id("table")).unwrap();
    assert_eq!(why.down[0].node, scene.id("table"));
    assert!((why.down[0].distance - 0.002).abs() < 1e-4);
    assert!((why.down[0].at - Point3::new(0.1, 0.2, 0.75)).norm() < 0.02);
    assert_eq!(why.down[0].outcome, TraceOutcome::Counts);
    assert_eq!(why.down[1].node, scene.id("floor"));
    assert_eq!(why.down[1].outcome, TraceOutcome::TooFar);
    assert!(why.to_string().contains("by the trace down"));
}

/// A ball lies on the floor below the edge of a table, whose top is the fifth of its pieces: the trace from the
/// middle of the ball, 5 cm wide, hits only the part of the table above it.
#[test]
fn hits_upwards_tell_which_piece_was_met_and_where() {
    let why = why(&["floor = floor 4 4", "table = table 0.8 1.2 0.75", "ball = ball 0.1 @ 0.39 0 0"], "ball", "table");
    let hit = hit_of(&why, &why.up);
    assert_eq!(hit.pieces, (None, 4));
    assert!((hit.distance - 0.67).abs() < 1e-4, "{hit:?}");
    assert!((hit.at - Point3::new(0.3825, 0.0, 0.72)).norm() < 1e-4, "{hit:?}");
    assert_eq!(hit.outcome, TraceOutcome::Counts);
    assert!(why.holds.contains(&Relation::Under));
}

/// A book that is wedged in a shelf bears part of its weight, and still does not carry it.
#[test]
fn nothing_rests_on_its_contents() {
    let scene = shared::scene(["f = floor 4 4", "s = shelf 0.3 0.8 1.2 3", "b = book 0.2 0.03 0.25 @ 0 0 0.413"]);
    let (floor, shelf, book) = (scene.id("f"), scene.id("s"), scene.id("b"));
    let push = |by, on| ContactEvidence { between: (by, on), impulse: Vector3::new(0.0, 0.0, 1.0) };
    let evidence = Evidence::default().contact(push(floor, shelf)).contact(push(book, shelf));
    let relations = Relations::new(&scene.graph, RelationRule::Contacts, evidence).unwrap();
    let has = |from, relation, to| relations.has(Edge::new(from, relation, to));
    assert!(has(book, Relation::Inside, shelf) && has(shelf, Relation::On, floor));
    assert!(!has(shelf, Relation::On, book));
}

#[test]
fn every_verdict_on_what_is_below() {
    let outcome = |lines: &[&str], from: &str, to: &str| {
        let why = why(lines, from, to);
        hit_of(&why, &why.down).outcome
    };
    let saucer = ["t = table 0.8 1.2 0.75", "s = box 0.2 0.2 0.01 @ 0 0 0.75", "c = box 0.1 0.1 0.1 @ 0 0 0.76"];
    assert_eq!(outcome(&saucer, "c", "s"), TraceOutcome::Counts);
    assert_eq!(outcome(&saucer, "c", "t"), TraceOutcome::Outranked);
    let high = ["f = floor 4 4", "a = box 0.2 0.2 0.2 @ 0 0 0.5"];
    assert_eq!(outcome(&high, "a", "f"), TraceOutcome::TooFar);
    let sunk = ["a = box 0.4 0.4 0.4", "b = box 0.3 0.3 0.3 @ 0 0 0.3"];
    assert_eq!(outcome(&sunk, "b", "a"), TraceOutcome::TooDeep);
    let steep = ["a = box 1 1 0.1 @ 0 0 0.5 r 0 70 0", "b = box 0.1 0.1 0.1 @ 0 0 1"];
    assert_eq!(outcome(&steep, "b", "a"), TraceOutcome::TooSteep);
    let shelf = ["s = shelf 0.3 0.8 1.2 3", "b = book 0.2 0.03 0.25 @ 0 0 0.413"];
    assert_eq!(outcome(&shelf, "s", "b"), TraceOutcome::Content);
}

#[test]
fn every_verdict_on_what_is_above() {
    let outcome = |lines: &[&str], from: &str, to: &str| {
        let why = why(lines, from, to);
        hit_of(&why, &why.up).outcome
    };
    let room = ["c = ceiling 4 4 @ 0 0 2.5", "t = table 0.8 1.2 0.75", "b = ball 0.1"];
    assert_eq!(outcome(&room, "b", "t"), TraceOutcome::Counts);
    assert_eq!(outcome(&room, "b", "c"), TraceOutcome::Shaded);
    assert_eq!(outcome(&room, "t", "c"), TraceOutcome::Shade);
    let stack = ["a = box 0.4 0.4 0.3", "b = box 0.3 0.3 0.3 @ 0 0 0.3"];
    assert_eq!(outcome(&stack, "a", "b"), TraceOutcome::Carried);
}

#[test]
fn every_verdict_on_looking() {
    let sight = |tv: &str, more: &[&str]| {
        let mut lines = vec!["me = person 1.7", tv];
        lines.extend(more);
        let why = why(&lines, "me", "tv");
        assert_eq!(why.holds.contains(&Relation::Facing), why.sight.unwrap().outcome == TraceOutcome::Counts, "{why}");
        why.sight.unwrap()
    };
    let ahead = sight("tv = tv 0.1 1.2 0.7 @ 3 1.73205 0.5", &[]);
    assert_eq!(ahead.outcome, TraceOutcome::Counts);
    assert!((ahead.angle.to_degrees() - 30.0).abs() < 1e-3 && (ahead.distance - 12.0_f32.sqrt()).abs() < 1e-4);
    let aside = sight("tv = tv 0.1 1.2 0.7 @ 0 -3 0.5", &[]);
    assert_eq!(aside.outcome, TraceOutcome::Aside);
    assert!((aside.angle.to_degrees() - 90.0).abs() < 1e-3);
    let behind = sight("tv = tv 0.1 1.2 0.7 @ -3 0 0.5", &[]);
    assert!(behind.outcome == TraceOutcome::Aside && (behind.angle.to_degrees() - 180.0).abs() < 1e-3);
    assert_eq!(sight("tv = tv 0.1 1.2 0.7 @ 5.1 0 0.5", &[]).outcome, TraceOutcome::TooFar);
    assert_eq!(sight("tv = tv 0.1 1.2 0.7 @ 1 0 6.8", &[]).outcome, TraceOutcome::TooFar);
    let wall = ["wall = wall 0.1 4 2.5 @ 1.5 0 0"];
    assert_eq!(sight("tv = tv 0.1 1.2 0.7 @ 3 0 0.5", &wall).outcome, TraceOutcome::Walled);
    assert_eq!(sight("tv = box 0.1 1.2 0.7 @ 3 0 0.5", &[]).outcome, TraceOutcome::Unfit);
    let back = why(&["me = person 1.7", "tv = tv 0.1 1.2 0.7 @ 3 0 0.5 r 0 0 180"], "tv", "me");
    assert_eq!(back.sight.unwrap().outcome, TraceOutcome::Unfit);
}

#[test]
fn every_verdict_on_sitting_and_lying() {
    let seat = |lines: &[&str], to: &str| why(lines, "me", to).seat.unwrap();
    let sitting = "me = boxed 0.3 0.45 1.3 @ 0.05 0 0 class character state sitting";
    let on_chair = seat(&["c = chair", sitting], "c");
    assert_eq!(on_chair.outcome, TraceOutcome::Counts);
    assert!((on_chair.share.unwrap() - 0.46 / 1.3).abs() < 1e-4, "{on_chair:?}");
    assert_eq!(seat(&["c = chair @ 0.02 0 0", "d = chair", sitting], "d").outcome, TraceOutcome::Outranked);
    assert_eq!(seat(&["c = chair @ 0.7 0 0", sitting], "c").outcome, TraceOutcome::Aside);
    assert_eq!(seat(&["c = chair", "me = person 1.7 @ 0.05 0 0.46"], "c").outcome, TraceOutcome::WrongHeight);
    assert_eq!(seat(&["b = box 0.4 0.4 0.4", sitting], "b").outcome, TraceOutcome::Unfit);
    let lying = "me = boxed 1.7 0.45 0.3 @ 0 0 0.5 class character state lying";
    assert_eq!(seat(&["b = bed 1.4", lying], "b").outcome, TraceOutcome::Counts);
    assert_eq!(seat(&["b = bed 1.4 @ 4 0 0", lying], "b").outcome, TraceOutcome::TooFar);
    assert_eq!(seat(&["c = chair", lying], "c").outcome, TraceOutcome::Unfit);
    assert_eq!(why(&["c = chair", sitting], "c", "me").seat, None);
}

#[test]
fn every_verdict_on_hanging() {
    let hooks = "h = hooks 0.8 @ 2.99 0 1.7 r 0 0 180";
    let hook = |thing: &str, more: &[&str]| {
        let mut lines = vec![hooks, thing];
        lines.extend(more);
        why(&lines, "c", "h").hook.unwrap()
    };
    // A narrow coat, which only one of the hooks touches.
    let hangs = hook("c = coat @ 2.9 0.1 1.7 r 0 0 180 s 1 0.3 1", &[]);
    assert_eq!((hangs.outcome, hangs.distance), (TraceOutcome::Counts, 0.0));
    assert!((hangs.at - Point3::new(2.945, 0.1, 1.69)).norm() < 1e-4, "{hangs:?}");
    let far = hook("c = coat @ 1.9 0.1 1.7 r 0 0 180", &[]);
    assert!(far.outcome == TraceOutcome::TooFar && (far.distance - 0.985).abs() < 1e-4, "{far:?}");
    assert_eq!(hook("c = coat @ 2.9 0.1 2.5 r 0 0 180", &[]).outcome, TraceOutcome::WrongHeight);
    let stands = hook("c = coat @ 2.9 0.1 1.7 r 0 0 180", &["b = box 0.3 0.6 0.7 @ 2.85 0.1 0"]);
    assert_eq!(stands.outcome, TraceOutcome::Outranked);
    assert_eq!(hook("c = door 0.9 2 @ 2.945 0 0", &[]).outcome, TraceOutcome::Unfit);
    assert_eq!(why(&[hooks, "c = coat"], "h", "c").hook, None);
}

#[test]
fn who_holds_a_thing_is_said() {
    let lines = ["t = table 0.8 1.2 0.75", "me = person 1.7 @ 1 0 0", "c = mug 0.08 0.1 @ 0 0 0.75", "me holds_left c"];
    let (scene, why) = explain(RelationRule::Contacts, &lines, "c", "t");
    assert_eq!(why.held, [Edge::new(scene.id("me"), Relation::HoldsLeft, scene.id("c"))]);
    assert!(why.supports.is_empty() && !why.holds.contains(&Relation::On));
    assert!(why.to_string().contains("holds or wears it"), "{why}");
}

const TWO_ROOMS: [&str; 7] = [
    "west = room 3 4 @ -1.6 0 0",
    "east = room 3 4 @ 1.6 0 0",
    "floor_w = floor 3 4 @ -1.6 0 0",
    "floor_e = floor 3 4 @ 1.6 0 0",
    "floor_w in west",
    "floor_e in east",
    "door = door 0.9 2 @ -0.09 0 0",
];

#[test]
fn depths_tell_why_a_thing_is_in_a_room() {
    let mut lines = TWO_ROOMS.to_vec();
    lines.push("cup = box 0.1 0.1 0.1 @ -1.5 0 0");
    let (scene, here) = explain(RelationRule::Contacts, &lines, "cup", "west");
    let close = |depth: f32, to: f32| (depth - to).abs() < 1e-4;
    assert_eq!(here.holds, [Relation::InRoom]);
    assert!(here.rooms.len() == 1 && here.rooms[0].0 == scene.id("west") && close(here.rooms[0].1, 1.4), "{here}");
    let (scene, there) = explain(RelationRule::Contacts, &lines, "cup", "east");
    assert_eq!((there.holds.len(), there.rooms.len()), (0, 2));
    assert!(there.rooms[1].0 == scene.id("east") && close(there.rooms[1].1, -1.6), "{there}");
    assert!(there.to_string().contains(&format!("1.60 m outside of {}", scene.id("east"))), "{there}");
    let relations = Relations::new(&scene.graph, RelationRule::Contacts, Evidence::default()).unwrap();
    assert!(relations.explain(scene.id("west"), scene.id("cup")).is_none());
}

#[test]
fn points_beside_a_door_tell_what_it_is_between() {
    let (scene, why) = explain(RelationRule::Contacts, &TWO_ROOMS, "door", "east");
    assert_eq!(why.holds, [Relation::Between]);
    let mut sides = why.sides.clone();
    sides.sort_by(|a, b| a.0.x.total_cmp(&b.0.x));
    assert_eq!([sides[0].1, sides[1].1], [Some(scene.id("west")), Some(scene.id("east"))]);
    assert!((sides[0].0 - Point3::new(-0.31, 0.0, 1.0)).norm() < 1e-4, "{why}");
    assert!((sides[1].0 - Point3::new(0.13, 0.0, 1.0)).norm() < 1e-4, "{why}");
}

/// Under another rule, the explanation has only facts that this rule uses.
#[test]
fn other_rules_are_explained_by_what_they_ask() {
    let lines = ["f = floor 4 4", "a = box 0.4 0.4 0.3 @ 0 0 0.01", "b = box 0.2 0.2 0.2 @ 0.5 0 0.02"];
    let (scene, why) = explain(RelationRule::BoxTrace, &lines, "a", "b");
    assert_eq!(why.holds, [Relation::Near, Relation::NearFront]);
    assert_eq!(why.traces.iter().map(|t| t.trace).collect::<Vec<_>>(), BoxTrace::ALL);
    let hit = |trace| why.traces.iter().find(|t| t.trace == trace).unwrap().hit;
    let (what, far) = hit(BoxTrace::Side(NearSide::Front)).unwrap();
    assert!(what == scene.id("b") && (far - 0.2).abs() < 1e-5);
    let (what, far) = hit(BoxTrace::Down).unwrap();
    assert!(what == scene.id("f") && (far - 0.01).abs() < 1e-5);
    assert!(
        [BoxTrace::Up, BoxTrace::Side(NearSide::Back), BoxTrace::Side(NearSide::Left)]
            .iter()
            .all(|t| hit(*t).is_none())
    );
    for rule in [RelationRule::BoxTrace, RelationRule::VirtualHome] {
        let (_, why) = explain(rule, &lines, "a", "b");
        assert!(why.down.is_empty() && why.up.is_empty() && why.supports.is_empty() && why.sight.is_none());
        assert_eq!(why.traces.is_empty(), rule == RelationRule::VirtualHome);
    }
}
