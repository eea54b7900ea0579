//! The predicates of BEHAVIOR's domains and their meanings.

use vc_graph::goal::Predicate;
use vc_graph::{Relation, State};

/// The supported domains: `omnigibson` of BEHAVIOR-1K and `igibson` of BEHAVIOR-100.
pub(crate) const DOMAINS: [&str; 2] = ["omnigibson", "igibson"];

/// Predicates with one argument.
const STATES: &[(&str, State)] = &[
    ("cooked", State::Cooked),
    ("frozen", State::Frozen),
    ("open", State::Open),
    ("folded", State::Folded),
    ("unfolded", State::Unfolded),
    ("toggled_on", State::On),
    ("hot", State::Hot),
    ("on_fire", State::OnFire),
    ("future", State::Future),
    ("broken", State::Broken),
    ("dusty", State::Dusty),
    ("stained", State::Stained),
    ("soaked", State::Wet),
    ("sliced", State::Sliced),
];

/// Predicates with two arguments. The first word for a relation is the one written.
const RELATIONS: &[(&str, Relation)] = &[
    ("ontop", Relation::On),
    ("onfloor", Relation::On),
    ("inside", Relation::Inside),
    ("nextto", Relation::Beside),
    ("under", Relation::Under),
    ("touching", Relation::Touching),
    ("inroom", Relation::InRoom),
    ("saturated", Relation::Saturated),
    ("covered", Relation::Covered),
    ("filled", Relation::FilledWith),
    ("contains", Relation::Contains),
    ("insource", Relation::SourceOf),
    ("overlaid", Relation::Overlaid),
    ("attached", Relation::Attached),
    ("draped", Relation::Draped),
];

/// The meaning of a predicate in our goals.
///
/// ```
/// use vc_graph::goal::Predicate;
/// use vc_tasks::format::bddl::meaning;
/// assert_eq!(meaning("toggled_on"), Some(Predicate::State(vc_graph::State::On)));
/// assert_eq!(meaning("perished"), None);
/// ```
pub fn meaning(word: &str) -> Option<Predicate> {
    let state = STATES.iter().find(|(w, _)| *w == word).map(|(_, s)| Predicate::State(*s));
    let relation = || RELATIONS.iter().find(|(w, _)| *w == word).map(|(_, r)| Predicate::Relation(*r));
    state.or_else(relation).or(match word {
        "real" => Some(Predicate::Real),
        "grasped" => Some(Predicate::Holds),
        _ => None,
    })
}

/// The word for one of our predicates.
pub(super) fn word(predicate: Predicate) -> Option<&'static str> {
    match predicate {
        Predicate::State(state) => STATES.iter().find(|(_, s)| *s == state).map(|(w, _)| *w),
        Predicate::Relation(relation) => RELATIONS.iter().find(|(_, r)| *r == relation).map(|(w, _)| *w),
        Predicate::Real => Some("real"),
        Predicate::Holds => Some("grasped"),
        _ => None,
    }
}
