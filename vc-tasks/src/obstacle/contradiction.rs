//! Parts of a goal that cannot hold together, whatever is done.

use vc_graph::goal::{Goal, Literal, Predicate, Term};
use vc_graph::{NodeId, Relation, SceneGraph, State};

use super::Obstacle;

/// The first two parts of a conjunction of which one is the negation of the other, or which ask one thing or person to be in
/// states that exclude each other.
pub(super) fn contradiction(goal: &Goal, graph: &SceneGraph) -> Option<Obstacle> {
    let parts = goal.conjuncts();
    let pairs = parts.iter().enumerate().flat_map(|(at, part)| parts[at + 1..].iter().map(move |other| (part, other)));
    let excluded =
        |(part, other): &(&Goal, &Goal)| negates(part, other) || negates(other, part) || are_apart(part, other, graph);
    let (part, other) = pairs.into_iter().find(excluded)?;
    Some(Obstacle::Contradiction { part: part.to_string(), other: other.to_string() })
}

fn negates(part: &Goal, other: &Goal) -> bool {
    matches!(part, Goal::Not(inner) if **inner == *other)
}

/// Whether two parts ask for exclusive states of the same thing.
fn are_apart(part: &Goal, other: &Goal, graph: &SceneGraph) -> bool {
    let (Some((one, state)), Some((two, excluded))) = (state_of(part, graph), state_of(other, graph)) else {
        return false;
    };
    one == two && graph.vocabulary().opposites(state).contains(excluded)
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
