//! Parts of a goal that cannot hold together, whatever is done.

use std::collections::HashSet;

use vc_graph::goal::{Goal, Literal, Predicate, Term};
use vc_graph::{NodeId, Relation, SceneGraph, State};

use super::Obstacle;

/// The first two parts of a conjunction of which one is the negation of the other, or which ask one thing or person to be in
/// states that exclude each other.
pub(super) fn contradiction(goal: &Goal, graph: &SceneGraph) -> Option<Obstacle> {
    let parts = goal.conjuncts();
    let (part, other) = denied(parts).or_else(|| apart(parts, graph))?;
    Some(Obstacle::Contradiction { part: part.to_string(), other: other.to_string() })
}

/// A part and its negation.
fn denied(parts: &[Goal]) -> Option<(&Goal, &Goal)> {
    let all: HashSet<&Goal> = parts.iter().collect();
    let negated = |other: &'_ Goal| if let Goal::Not(part) = other { all.get(&**part).copied() } else { None };
    parts.iter().find_map(|other| Some((negated(other)?, other)))
}

/// Two parts that ask for exclusive states of the same thing.
fn apart<'g>(parts: &'g [Goal], graph: &SceneGraph) -> Option<(&'g Goal, &'g Goal)> {
    let asked: Vec<(&Goal, One<'_>, State)> =
        parts.iter().filter_map(|part| state_of(part, graph).map(|(thing, state)| (part, thing, state))).collect();
    asked.iter().enumerate().find_map(|(at, (part, thing, state))| {
        let opposites = graph.vocabulary().opposites(*state);
        let other = asked[at + 1..].iter().find(|(_, other, state)| other == thing && opposites.contains(*state))?;
        Some((*part, other.0))
    })
}

/// The state that a part asks for, and of whom, if that is one thing or person: whoever is on a seat is sitting.
fn state_of<'g>(part: &'g Goal, graph: &SceneGraph) -> Option<(One<'g>, State)> {
    let Goal::Literal(Literal { predicate, terms }) = part else { return None };
    let state = match predicate {
        Predicate::State(state) => *state,
        Predicate::Relation(Relation::SittingOn) => State::Sitting,
        Predicate::Relation(Relation::LyingOn) => State::Lying,
        _ => return None,
    };
    Some((one(terms.first()?, graph)?, state))
}

/// A term that stands for one node.
#[derive(PartialEq)]
enum One<'g> {
    Node(NodeId),
    /// The agent, or a variable: the same in all parts.
    Named(&'g Term),
}

fn one<'g>(term: &'g Term, graph: &SceneGraph) -> Option<One<'g>> {
    match term {
        Term::Node(_, id) => Some(One::Node(*id)),
        Term::Class(class) => match graph.of_class(class).as_slice() {
            [only] => Some(One::Node(*only)),
            _ => None,
        },
        Term::Me | Term::Variable(_) => Some(One::Named(term)),
        Term::Anything => None,
    }
}
