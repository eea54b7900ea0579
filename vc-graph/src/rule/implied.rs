//! The needs that effects have by themselves: nobody takes anything without a hand, or sits down on what is no seat.

use std::borrow::Cow;
use std::mem::discriminant;

use crate::State;
use crate::rule::table::{ActionRule, RULES};
use crate::rule::{Argument, Condition, Effect};
use crate::vocabulary::{Used, entry};

/// The states that bodies have: doors stand somewhere, agents sit on something.
const OF_BODIES: [State; 4] = [State::Open, State::Closed, State::Sitting, State::Lying];

/// Adds to a rule what its effects need: the preconditions of the built-in verb with such an effect, unless they are
/// written or an earlier effect brings them about.
pub(crate) fn with_implied(mut rule: ActionRule) -> ActionRule {
    let mut all = rule.preconditions.to_vec();
    for (i, effect) in rule.effects.iter().enumerate() {
        let met = |need: &Condition<Argument>| rule.effects[..i].iter().any(|earlier| brings_about(earlier, need));
        let new: Vec<_> = needs_of(*effect).filter(|need| !all.contains(need) && !met(need)).collect();
        all.extend(new);
    }
    rule.preconditions = Cow::Owned(all);
    rule
}

/// The state of a body that an effect sets without that body: sitting comes with a seat, `open` ends with `closed`.
pub(crate) fn bodiless(effect: &Effect<Argument>) -> Option<State> {
    let state = match effect {
        Effect::Enter(_, state @ (State::Sitting | State::Lying))
        | Effect::EnterWith(_, state)
        | Effect::Leave(_, state)
        | Effect::EnterOwn(state)
        | Effect::LeaveOwn(state) => *state,
        _ => return None,
    };
    is_of_bodies(state).then_some(state)
}

/// Whether bodies tell a state.
pub(crate) fn is_of_bodies(state: State) -> bool {
    OF_BODIES.contains(&state)
}

/// The preconditions of the first built-in verb that has such an effect and no other.
fn needs_of(effect: Effect<Argument>) -> impl Iterator<Item = Condition<Argument>> {
    let model = RULES.iter().find(|rule| matches!(*rule.effects, [own] if is_alike(own, effect)));
    let parts = move |of: Effect<Argument>| of.words().1;
    let roles = model.map(|rule| parts(rule.effects[0]).into_iter().zip(parts(effect)).collect::<Vec<_>>());
    let needs = model.into_iter().flat_map(|rule| rule.preconditions.iter());
    needs.filter_map(move |need| with_roles(*need, roles.as_deref().unwrap_or_default()))
}

/// Whether two effects ask the same of bodies. A state that bodies do not have needs nothing of them.
fn is_alike(model: Effect<Argument>, effect: Effect<Argument>) -> bool {
    match (model, effect) {
        (Effect::Enter(_, model), Effect::Enter(_, state)) => {
            model == state && matches!(state, State::Open | State::Closed | State::Folded | State::Unfolded)
        }
        (Effect::EnterWith(..) | Effect::EnterOwn(_) | Effect::LeaveOwn(_), _) => false,
        _ => discriminant(&model) == discriminant(&effect),
    }
}

/// A need of the model for the things of another effect; `None` if it is about a thing that this one has not.
fn with_roles(need: Condition<Argument>, roles: &[(Used, Used)]) -> Option<Condition<Argument>> {
    let (name, parts) = need.words();
    let other = |part: Used| match part {
        Used::Thing(_) => roles.iter().find(|(model, _)| model.as_str() == part.as_str()).map(|(_, own)| *own),
        part => Some(part),
    };
    let parts: Option<Vec<Used>> = parts.into_iter().map(other).collect();
    Condition::read(&entry(name, &parts?)).ok()
}

/// Whether an effect brings a need about, so that a later one finds it met.
fn brings_about(effect: &Effect<Argument>, need: &Condition<Argument>) -> bool {
    use Condition as C;
    use Effect as E;
    match (effect, need) {
        (E::GoTo(at) | E::Approach(at), C::Near(id) | C::SameRoom(id) | C::UprightOrNear(id)) => at == id,
        (E::Face(at), C::Facing(id)) => at == id,
        (E::Hold(of), C::Holding(id) | C::FreeHandOrHolding(id)) => of == id,
        (E::PutOn(..) | E::PutInto(..) | E::PutWhereItWas(_) | E::LetGo(_) | E::PutOnBody(_), need) => {
            matches!(need, C::FreeHand | C::FreeHandOrHolding(_))
        }
        (E::StandUp, need) => matches!(need, C::Upright | C::NotSitting | C::NotLying | C::UprightOrNear(_)),
        (E::SitOn(_), need) => matches!(need, C::AtRest | C::NotLying),
        (E::LieOn(_), need) => matches!(need, C::AtRest | C::NotSitting),
        (E::Enter(of, state), C::In(id, wanted)) => of == id && state == wanted,
        (E::Enter(of, State::Open), C::Accepts(id)) => of == id,
        _ => false,
    }
}
