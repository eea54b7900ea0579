//! What of a goal anybody can bring about.

use vc_graph::Goal;
use vc_graph::Relation;
use vc_graph::goal::{Literal, Predicate, Term};

/// What of a goal anybody can bring about: where things are and in what state. What the
/// one of whom it speaks is to hold, eat or sit on is its own affair.
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

/// Whether all of a part is anybody's.
fn is_shared(part: &Goal) -> bool {
    match part {
        Goal::Literal(literal) | Goal::Count { literal, .. } => is_anybodys(literal),
        Goal::Same(a, b) => *a != Term::Me && *b != Term::Me,
        // All keep to what is to stay so.
        Goal::Always(part) if !part.is_temporal() => is_shared(part),
        // Of what was when only the one of whom it speaks keeps count.
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
