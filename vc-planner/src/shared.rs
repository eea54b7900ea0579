//! The part of a goal that any agent can bring about.

use vc_graph::Goal;
use vc_graph::Relation;
use vc_graph::goal::{Literal, Predicate, Term};

/// The part of a goal that any agent can bring about: places and states of things. The things that a particular
/// agent is to hold, eat or sit on concern only that agent.
pub(crate) fn shared(goal: &Goal) -> Goal {
    match goal {
        Goal::And(parts) => Goal::And(parts.iter().map(shared).filter(|part| *part != nothing()).collect()),
        whole if is_shared(whole) => whole.clone(),
        _ => nothing(),
    }
}

fn nothing() -> Goal {
    Goal::And(Vec::new())
}

/// Whether any agent can bring about all of a part.
fn is_shared(part: &Goal) -> bool {
    match part {
        Goal::Literal(literal) | Goal::Count { literal, .. } => is_anybodys(literal),
        Goal::Same(a, b) => *a != Term::Me && *b != Term::Me,
        // All agents keep a condition that is to stay true.
        Goal::Always(part) if !part.is_temporal() => is_shared(part),
        // Only the agent itself keeps a record of the past.
        part if part.is_temporal() => false,
        part => part.parts().into_iter().all(is_shared),
    }
}

fn is_anybodys(literal: &Literal) -> bool {
    let about_things = match literal.predicate {
        Predicate::Relation(relation) => matches!(relation, Relation::On | Relation::Inside | Relation::InRoom),
        Predicate::State(_) => true,
        _ => false,
    };
    about_things && !literal.terms.contains(&Term::Me)
}
