//! Names of predicates.

use super::write::capitalised;
use super::{DerivedPredicate, Predicate};
use crate::spelling::{key, same_word};
use crate::vocabulary::{Word, known};
use crate::{Relation, State, Verb};

/// Whether the agent may be omitted from a predicate's terms: `Near(table)`.
pub(super) fn agent_is_meant(predicate: Predicate) -> bool {
    use Relation::{Facing, HoldsLeft, HoldsRight, LyingOn, Near, SittingOn};
    match predicate {
        Predicate::Holds => true,
        Predicate::Relation(r) => [Near, Facing, HoldsLeft, HoldsRight, LyingOn, SittingOn].contains(&r),
        _ => false,
    }
}

/// Names of predicates apart from those of states and relations.
const NAMES: &[(&str, Predicate)] = &[
    ("in", Predicate::Relation(Relation::Inside)),
    ("room", Predicate::Relation(Relation::InRoom)),
    ("close_to", Predicate::Relation(Relation::Near)),
    ("next_to", Predicate::Relation(Relation::Near)),
    ("walk", Predicate::Relation(Relation::Near)),
    ("find", Predicate::Relation(Relation::Near)),
    ("face", Predicate::Relation(Relation::Facing)),
    ("sit", Predicate::Relation(Relation::SittingOn)),
    ("lie", Predicate::Relation(Relation::LyingOn)),
    ("wear", Predicate::Relation(Relation::WornBy)),
    ("holds", Predicate::Holds),
    ("held", Predicate::Holds),
    ("grab", Predicate::Holds),
    ("close", Predicate::State(State::Closed)),
    ("switched_on", Predicate::State(State::On)),
    ("switch_on", Predicate::State(State::On)),
    ("turn_on", Predicate::State(State::On)),
    ("switched_off", Predicate::State(State::Off)),
    ("switch_off", Predicate::State(State::Off)),
    ("turn_off", Predicate::State(State::Off)),
    ("plug_in", Predicate::State(State::PluggedIn)),
    ("plug_out", Predicate::State(State::PluggedOut)),
    ("cook", Predicate::State(State::Cooked)),
    ("cut", Predicate::State(State::Sliced)),
    ("fold", Predicate::State(State::Folded)),
    ("fill", Predicate::State(State::Filled)),
    ("real", Predicate::Real),
];

/// Words of goals that are no predicates.
const KEYWORDS: &[&str] = &[
    "not",
    "and",
    "or",
    "imply",
    "forall",
    "exists",
    "true",
    "false",
    "eventually",
    "always",
    "within",
    "steps",
    "at",
    "end",
    "least",
    "most",
    "exactly",
    "marginal",
    "pairs",
    "until",
    "before",
    "then",
    "did",
    "me",
    "character",
];

/// Whether a name is that of a built-in predicate or has another meaning in goals.
pub(crate) fn is_predicate(name: &str) -> bool {
    predicates().chain(KEYWORDS.iter().copied()).any(|known| same_word(known, name))
}

/// Every built-in name of a predicate.
pub(super) fn predicates() -> impl Iterator<Item = &'static str> {
    let named = NAMES.iter().map(|(name, _)| *name);
    named.chain(words::<State>()).chain(words::<Relation>()).chain(words::<Verb>())
}

/// The predicates whose names begin with that of another one and that take the things given to it, to be appended to
/// an error: ``(did you mean `SittingOn`?)``. Empty if there are none.
pub(super) fn taking(name: &str, given: usize) -> String {
    let takes = |p: Predicate| p.arity() == given || (agent_is_meant(p) && p.arity() == given + 1);
    let longer = |other: &&str| !same_word(other, name) && key(other).starts_with(&key(name));
    let fits = |other: &&str| native_predicate(other, given).is_some_and(takes);
    let near: Vec<String> = predicates().filter(longer).filter(fits).map(|p| format!("`{}`", capitalised(p))).collect();
    if near.is_empty() { String::new() } else { format!(" (did you mean {}?)", near.join(" or ")) }
}

/// Every name of a predicate, those that scenes of this process have declared among them.
pub(super) fn known_predicates() -> impl Iterator<Item = &'static str> {
    let named = NAMES.iter().map(|(name, _)| *name);
    let derived = DerivedPredicate::all().map(DerivedPredicate::as_str);
    named.chain(known::<State>()).chain(words::<Relation>()).chain(words::<Verb>()).chain(derived)
}

fn words<W: Word>() -> impl Iterator<Item = &'static str> {
    W::ALL.iter().map(|word| word.as_str())
}

pub(super) fn native_predicate(name: &str, given: usize) -> Option<Predicate> {
    let state = State::parse(name).ok().map(Predicate::State);
    let relation = Relation::parse(name).ok().map(Predicate::Relation);
    let by_number = if given == 1 { state.or(relation) } else { relation.or(state) };
    if given == 2 && same_word(name, "filled") {
        return Some(Predicate::Relation(Relation::FilledWith));
    }
    let named = || NAMES.iter().find(|(n, _)| same_word(n, name)).map(|(_, p)| *p);
    let derived = || DerivedPredicate::find(name).map(Predicate::Derived);
    by_number.or_else(named).or_else(|| Verb::builtin(name).map(Predicate::Did)).or_else(derived)
}

pub(super) fn eai_predicate(name: &str, given: usize) -> Option<Predicate> {
    let relation = match name {
        "ONTOP" => Some(Relation::On),
        "NEXT_TO" | "CLOSE" if given == 2 => Some(Relation::Near),
        "INSIDE" => Some(Relation::Inside),
        "FACING" => Some(Relation::Facing),
        "BETWEEN" => Some(Relation::Between),
        "HOLDS_RH" => Some(Relation::HoldsRight),
        "HOLDS_LH" => Some(Relation::HoldsLeft),
        _ => None,
    };
    let state = || State::parse(name).ok().filter(|_| given == 1).map(Predicate::State);
    let done = || Verb::from_virtualhome(name).map(Predicate::Did);
    // A verb such as OPEN means the state if it has one object, as in EAI's vocabulary.
    relation.map(Predicate::Relation).or_else(state).or_else(done)
}
