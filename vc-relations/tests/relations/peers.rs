//! The prototype's scenes: the supports and containers of up to 2,000 objects.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use crate::shared;

use vc_graph::{NodeId, Relation};
use vc_relations::{RelationRule, Relations};

/// Supports found of all, containments found of all, and the number of false containments.
#[derive(Debug, PartialEq, Eq)]
struct Score {
    supports: (usize, usize),
    containments: (usize, usize),
    false_ones: usize,
}

fn score(objects: u32, rule: RelationRule) -> Option<Score> {
    let peers = shared::peers::read(objects)?;
    let relations = Relations::new(&peers.graph, rule, peers.evidence.clone()).unwrap();
    let to = |id, relation| -> Vec<NodeId> {
        relations.edges_of(id).iter().filter(|e| e.relation == relation).map(|e| e.to).collect()
    };
    let supports = |id| match rule {
        RelationRule::Contacts => relations.supports(id).iter().map(|s| s.by).collect(),
        _ => to(id, Relation::On),
    };
    let right = peers.truth.iter().filter(|t| supports(t.0) == [t.1]).count();
    let (mut found, mut false_ones) = (0, 0);
    for (id, _, container) in &peers.truth {
        let inside = to(*id, Relation::Inside);
        found += inside.iter().filter(|c| Some(**c) == *container).count();
        false_ones += inside.iter().filter(|c| Some(**c) != *container).count();
    }
    let containments = (found, peers.truth.iter().filter(|t| t.2.is_some()).count());
    let score = Score { supports: (right, peers.truth.len()), containments, false_ones };
    eprintln!("{objects} objects, {rule:?}: {score:?}");
    Some(score)
}

#[test]
fn every_support_and_containment_is_found_and_none_is_false() {
    for objects in [100, 500, 2000] {
        let Some(score) = score(objects, RelationRule::Contacts) else { return };
        assert_eq!(score.supports.0, score.supports.1);
        assert_eq!(score.containments.0, score.containments.1);
        assert_eq!(score.false_ones, 0);
    }
}

#[test]
fn the_box_traces_are_reported_beside_it() {
    let Some(score) = score(500, RelationRule::BoxTrace) else { return };
    let reported = Score { supports: (400, 500), containments: (100, 220), false_ones: 80 };
    assert_eq!(score, reported);
}

#[test]
fn there_are_as_many_relations_as_reported() {
    let Some(peers) = shared::peers::read(500) else { return };
    let relations = Relations::new(&peers.graph, RelationRule::Contacts, peers.evidence).unwrap();
    assert_eq!(relations.edges().len(), 12_656);
}
