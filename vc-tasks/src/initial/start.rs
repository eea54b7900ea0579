//! The start conditions: states, and the object that the agent sits on or holds.

use vc_graph::goal::{Goal, Literal, Predicate, Term};
use vc_graph::{
    Edit, EditError, NodeId, Place, Property, PropertySet, Relation, SceneGraph, State, StateSet, Vocabulary,
};

/// Makes those parts of a start true that can be set: a state of all objects of a class, or its
/// negation, and the agent's seat or the object it holds. The other parts are left as they are and
/// checked later.
pub(super) fn bring_about(edit: &mut Edit<'_>, agent: NodeId, start: &Goal) -> Result<(), EditError> {
    start.conjuncts().iter().try_for_each(|part| match part {
        Goal::Literal(literal) => establish(edit, agent, literal),
        Goal::Not(part) => match &**part {
            Goal::Literal(Literal { predicate: Predicate::State(state), terms }) => {
                let opposite = only(edit.graph().vocabulary().opposites(*state));
                things(edit.graph(), terms, *state).into_iter().try_for_each(|id| match opposite {
                    Some(opposite) => enter(edit, id, opposite),
                    None => edit.leave_state(id, *state),
                })
            }
            _ => Ok(()),
        },
        _ => Ok(()),
    })
}

fn only(states: StateSet) -> Option<State> {
    states.iter().next().filter(|_| states.len() == 1)
}

fn establish(edit: &mut Edit<'_>, agent: NodeId, literal: &Literal) -> Result<(), EditError> {
    match (literal.predicate, literal.terms.as_slice()) {
        (Predicate::State(state), terms) => {
            things(edit.graph(), terms, state).into_iter().try_for_each(|id| enter(edit, id, state))
        }
        (Predicate::Relation(relation @ (Relation::SittingOn | Relation::LyingOn)), [Term::Me, Term::Class(class)]) => {
            let posture = if relation == Relation::SittingOn { State::Sitting } else { State::Lying };
            let Some(at) = free_seat(edit.graph(), class, relation) else { return Ok(()) };
            edit.place(agent, Place { relation, at })?;
            edit.enter_state(agent, posture)
        }
        (Predicate::Holds, [Term::Me, Term::Class(class)]) => {
            let found = edit.graph().of_class(class).into_iter().find(|&id| edit.graph().holder(id).is_none());
            found.map_or(Ok(()), |id| edit.hold(agent, id))
        }
        _ => Ok(()),
    }
}

/// The first seat of a class that is free.
pub(super) fn free_seat(graph: &SceneGraph, class: &str, relation: Relation) -> Option<NodeId> {
    let needed = if relation == Relation::SittingOn { Property::Sittable } else { Property::Lieable };
    let fits = |id: &NodeId| {
        graph.node(*id).is_some_and(|n| n.affords(needed)) && graph.relating(relation, *id).next().is_none()
    };
    graph.of_class(class).into_iter().find(fits)
}

/// Puts an object in a state; an object to be filled is filled with water, unless it has contents
/// already.
pub(super) fn enter(edit: &mut Edit<'_>, id: NodeId, state: State) -> Result<(), EditError> {
    let full = edit.graph().node(id).is_some_and(|n| n.contents().is_some());
    match state {
        State::Filled if !full => edit.fill(id, Some("water".into())),
        State::Empty => edit.fill(id, None),
        state => edit.enter_state(id, state),
    }
}

/// The nodes that terms denote and that can be in a state.
fn things(graph: &SceneGraph, terms: &[Term], state: State) -> Vec<NodeId> {
    let all = match terms {
        [Term::Class(class)] => graph.of_class(class),
        [Term::Node(_, id)] => vec![*id],
        _ => Vec::new(),
    };
    all.into_iter()
        .filter(|&id| graph.node(id).is_some_and(|n| allows(graph.vocabulary(), n.spec().affordances, state)))
        .collect()
}

/// Whether these affordances allow a state at all.
pub(super) fn allows(words: &Vocabulary, affordances: PropertySet, state: State) -> bool {
    words.needs(state).is_none_or(|needed| affordances.contains(needed))
}

/// The first part of a start that does not hold; a state of a class without objects counts as
/// holding.
pub(super) fn unmet(now: &vc_graph::goal::Situation<'_>, start: &Goal) -> Option<String> {
    let vacuous = |part: &Goal| match part {
        Goal::Literal(Literal { predicate: Predicate::State(state), terms }) => {
            things(now.graph, terms, *state).is_empty()
        }
        _ => false,
    };
    start.conjuncts().iter().find(|part| !vacuous(part) && !part.holds(now)).map(Goal::to_string)
}
