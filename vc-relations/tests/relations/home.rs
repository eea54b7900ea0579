//! A home in which every support and container is known, read from geometry alone.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use crate::shared;

use vc_graph::{Edge, Relation};
use vc_relations::{Evidence, RelationRule, Relations};

/// Correct supports of all, containments of all and those found, and false containments.
fn score(objects: usize, rule: RelationRule) -> (usize, usize, usize, usize, usize) {
    let (home, truth) = shared::home::home(objects);
    let relations = Relations::new(&home.graph, rule, Evidence::default()).unwrap();
    let mut score = (0, truth.len(), 0, 0, 0);
    for t in &truth {
        let id = home.id(&t.name);
        let on = home.id(&t.on);
        let right = if rule == RelationRule::Contacts {
            relations.supports(id).iter().map(|s| s.by).eq([on])
        } else {
            relations.edges_of(id).iter().filter(|e| e.relation == Relation::On).map(|e| e.to).eq([on])
        };
        score.0 += usize::from(right);
        let inside: Vec<Edge> = relations.edges_of(id).into_iter().filter(|e| e.relation == Relation::Inside).collect();
        let expected = t.inside.as_ref().map(|c| home.id(c));
        score.2 += usize::from(expected.is_some());
        score.3 += inside.iter().filter(|e| Some(e.to) == expected).count();
        score.4 += inside.iter().filter(|e| Some(e.to) != expected).count();
    }
    score
}

#[test]
fn every_support_and_container_is_found() {
    let (right, of, containments, found, wrong) = score(500, RelationRule::Contacts);
    assert_eq!((right, found, wrong), (of, containments, 0));
}

#[test]
fn the_box_traces_do_what_has_been_measured() {
    let (right, of, containments, found, wrong) = score(500, RelationRule::BoxTrace);
    eprintln!("box traces: {right} of {of} supports, {found} of {containments} containments, {wrong} false ones");
    assert_eq!((right, of, found, containments, wrong), (460, 500, 120, 220, 260));
}
