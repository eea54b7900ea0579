//! Parts of a goal that cannot hold together, whatever is done.

use vc_graph::goal::{Goal, Literal, Predicate, Term};
use vc_graph::{NodeId, SceneGraph, State};

use super::Obstacle;

/// The first two parts of a conjunction of which one is the negation of the other, or which ask one thing to be in states
/// that exclude each other.
pub(super) fn contradiction(goal: &Goal, graph: &SceneGraph) -> Option<Obstacle> {
    let parts = goal.conjuncts();
    let pairs = parts.iter().enumerate().flat_map(|(at, part)| parts[at + 1..].iter().map(move |other| (part, other)));
    let excluded =
        |(part, other): &(&Goal, &Goal)| negates(part, other) || negates(other, part) || apart(part, other, graph);
    let (part, other) = pairs.into_iter().find(excluded)?;
    Some(Obstacle::Contradiction { part: part.to_string(), other: other.to_string() })
}

fn negates(part: &Goal, other: &Goal) -> bool {
    matches!(part, Goal::Not(inner) if **inner == *other)
}

/// Whether two parts ask for exclusive states of the same thing.
fn apart(part: &Goal, other: &Goal, graph: &SceneGraph) -> bool {
    let (Some((one, state)), Some((two, excluded))) = (state_of(part, graph), state_of(other, graph)) else {
        return false;
    };
    one == two && graph.vocabulary().opposites(state).contains(excluded)
}

/// The state that a part asks for, if it is that of one thing.
fn state_of(part: &Goal, graph: &SceneGraph) -> Option<(NodeId, State)> {
    let Goal::Literal(Literal { predicate: Predicate::State(state), terms }) = part else { return None };
    let thing = match terms.as_slice() {
        [Term::Node(_, id)] => *id,
        [Term::Class(class)] => match graph.of_class(class).as_slice() {
            [only] => *only,
            _ => return None,
        },
        _ => return None,
    };
    Some((thing, *state))
}
