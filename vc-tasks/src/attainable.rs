//! Predicates that some action or process makes true.

use vc_graph::clock::ProcessTable;
use vc_graph::goal::Predicate;
use vc_graph::{Effect, Relation, State, Vocabulary};

/// Whether a predicate can be made true: the rules of a vocabulary have an action that does so, or the built-in
/// [`ProcessTable`] a process. Processes go on only in a world with a clock: that of `virtualcity::Environment` runs,
/// [`Simulator`](vc_graph::Simulator) has none.
///
/// ```
/// use vc_graph::{State, Vocabulary};
/// use vc_graph::goal::Predicate;
/// use vc_tasks::lint::brought_about;
/// let brought_about = |state| brought_about(&Vocabulary::builtin(), Predicate::State(state));
/// assert!(brought_about(State::Cooked));
/// assert!(brought_about(State::Frozen)); // by a freezer, in four hours
/// assert!(!brought_about(State::Broken));
/// ```
pub fn brought_about(words: &Vocabulary, predicate: Predicate) -> bool {
    let by_process = |state| ProcessTable::builtin().brings_about(state);
    brought_about_by_action(words, predicate) || matches!(predicate, Predicate::State(state) if by_process(state))
}

/// Whether the rules of a vocabulary have an action that makes a predicate true.
pub(crate) fn brought_about_by_action(words: &Vocabulary, predicate: Predicate) -> bool {
    let mut effects = words.rules().flat_map(|rule| rule.effects.iter());
    match predicate {
        Predicate::Did(_) | Predicate::Holds => true,
        Predicate::State(state) => effects.any(|e| enters(e, state)),
        Predicate::Relation(relation) => effects.any(|e| relates(e, relation)),
        // No action creates an object that does not exist.
        Predicate::Real | _ => false,
    }
}

fn enters<T>(effect: &Effect<T>, state: State) -> bool {
    match effect {
        Effect::Enter(_, entered) | Effect::EnterWith(_, entered) | Effect::EnterOwn(entered) => *entered == state,
        Effect::SitOn(_) | Effect::Board(_) => state == State::Sitting,
        Effect::LieOn(_) => state == State::Lying,
        Effect::PourInto(..) => [State::Filled, State::Empty].contains(&state),
        Effect::FillWithWater(_) => state == State::Filled,
        _ => false,
    }
}

fn relates<T>(effect: &Effect<T>, relation: Relation) -> bool {
    use Relation as R;
    let made: &[R] = match effect {
        Effect::GoTo(_) | Effect::Approach(_) => &[R::Near, R::InRoom, R::Inside],
        Effect::Face(_) => &[R::Facing],
        Effect::Hold(_) => &[R::HoldsRight, R::HoldsLeft, R::Near, R::TakenOff, R::TakenOut],
        Effect::PutOn(..) => &[R::On, R::Near],
        Effect::PutInto(..) => &[R::Inside, R::Near],
        Effect::PutWhereItWas(_) => &[R::On, R::Inside, R::Near],
        Effect::SitOn(_) => &[R::SittingOn, R::On, R::Facing],
        Effect::LieOn(_) => &[R::LyingOn, R::On],
        Effect::PourInto(..) => &[R::PouredInto, R::Inside, R::FilledWith, R::Contains],
        Effect::FillWithWater(_) => &[R::FilledWith, R::Contains],
        Effect::PutOnBody(_) => &[R::WornBy, R::On],
        Effect::Board(_) => &[R::Inside],
        Effect::DriveTo(..) => &[R::InRoom, R::Near, R::Inside],
        _ => &[],
    };
    made.contains(&relation)
}
