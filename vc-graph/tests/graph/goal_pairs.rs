//! Counts of objects, pairs, equal and different objects.
#![allow(clippy::unwrap_used)]

use proptest::prelude::*;
use vc_graph::goal::{Pairing, Situation, largest_matching};
use vc_graph::{Draft, Edge, Goal, History, NodeId, Relation, SceneBuilder, SceneGraph, State};
use vc_testkit::cases;

/// Cups and plates in a kitchen; some cups touch some plates.
fn table(cups: usize, plates: usize, touching: &[(usize, usize)]) -> (SceneGraph, NodeId) {
    let mut scene = SceneBuilder::new("table");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let mut all = |class: &str, number| -> Vec<NodeId> {
        (0..number).map(|_| scene.add_in(kitchen, Draft::new(class)).unwrap()).collect()
    };
    let (cups, plates) = (all("cup", cups), all("plate", plates));
    let me = scene.add_in(kitchen, Draft::new("character")).unwrap();
    let mut graph = scene.build();
    let mut edit = graph.edit();
    for &(cup, plate) in touching {
        edit.relate(Edge::new(cups[cup], Relation::Covered, plates[plate])).unwrap();
    }
    if let Some(&cup) = cups.first() {
        edit.enter_state(cup, State::Future).unwrap();
    }
    edit.commit();
    (graph, me)
}

fn holds(scene: &(SceneGraph, NodeId), text: &str) -> bool {
    let history = History::default();
    let now = Situation::new(&scene.0, scene.1, &history);
    let goal: Goal = text.parse().unwrap_or_else(|e| panic!("{text}: {e}"));
    assert_eq!(goal.holds(&now), goal.score(&now) == 1.0, "{text}");
    goal.holds(&now)
}

#[test]
fn pairs_are_one_with_one() {
    // Both cups match only the first plate; the second plate has no match.
    let shared = table(3, 3, &[(0, 0), (1, 0), (2, 1), (2, 2)]);
    assert!(!holds(&shared, "pairs ?c: cup, ?p: plate. Covered(?c, ?p)"));
    assert!(holds(&shared, "marginal pairs ?c: cup, ?p: plate. Covered(?c, ?p)"));
    for (text, expected) in [
        ("at least 2 pairs ?c: cup, ?p: plate. Covered(?c, ?p)", true),
        ("exactly 2 pairs ?c: cup, ?p: plate. Covered(?c, ?p)", true),
        ("at most 1 pairs ?c: cup, ?p: plate. Covered(?c, ?p)", false),
        ("exactly 3 marginal pairs ?c: cup, ?p: plate. Covered(?c, ?p)", true),
        ("pairs ?c: cup, ?p: spoon. Covered(?c, ?p)", true),
        ("pairs ?c: cup, ?p: plate. !Covered(?c, ?p)", true),
        ("pairs ?c: cup, ?d: cup. ?c = ?d", false),
        ("pairs ?c: cup, ?d: cup. true", true),
    ] {
        assert_eq!(holds(&shared, text), expected, "{text}");
    }
}

#[test]
fn so_many_things() {
    let scene = table(3, 2, &[(0, 0), (1, 0), (1, 1)]);
    for (text, expected) in [
        ("exactly 2 ?c: cup. Covered(?c, plate)", true),
        ("exactly 1 ?c: cup. Covered(?c, plate)", false),
        ("at least 1 ?c: cup. Covered(?c, plate)", true),
        ("at most 1 ?c: cup. Covered(?c, plate)", false),
        ("exactly 1 ?c: cup. exactly 2 ?p: plate. Covered(?c, ?p)", true),
        ("exists ?c: cup. exists ?p: plate. exists ?q: plate. ?p != ?q & Covered(?c, ?p) & Covered(?c, ?q)", true),
        ("forall ?p: plate. exists ?c: cup. Covered(?c, ?p)", true),
        ("forall ?c: cup. Covered(?c, plate) => Clean(?c)", true),
        ("exactly 2 ?c: cup. Real(?c)", true),
        ("exactly 1 ?c: cup. Future(?c)", true),
        ("exists ?c: character. ?c = me", true),
        ("exists ?c: cup. ?c = me", false),
    ] {
        assert_eq!(holds(&scene, text), expected, "{text}");
    }
}

/// The largest number of pairs by exhaustive search.
fn by_force(rows: &[Vec<usize>], taken: u32) -> usize {
    let Some((row, rest)) = rows.split_first() else { return 0 };
    let with = row.iter().filter(|&&c| taken & (1 << c) == 0).map(|&c| 1 + by_force(rest, taken | (1 << c)));
    with.chain([by_force(rest, taken)]).max().unwrap_or(0)
}

proptest! {
    #![proptest_config(cases(500))]

    #[test]
    fn the_largest_matching_is_the_largest(rows in prop::collection::vec(prop::collection::vec(0_usize..7, 0..4), 0..7)) {
        prop_assert_eq!(largest_matching(&rows, 7), by_force(&rows, 0));
        prop_assert!(Pairing::Marginal.number(&rows, 7) >= Pairing::Matching.number(&rows, 7));
    }
}
