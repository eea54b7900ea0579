//! Preconditions of actions.

use crate::rule::effect::Argument;
use crate::{Action, NodeId, Property, Relation, State};

/// A precondition of an action. `T` is the role of an object in the rule table, or the object itself once the
/// condition is [grounded](Condition::ground).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Condition<T = NodeId> {
    /// The object has a property.
    Affords(T, Property),
    /// The object is in a state.
    In(T, State),
    /// The object is not in a state.
    NotIn(T, State),
    /// The agent is near the object, see [`SceneGraph::near`](crate::SceneGraph::near).
    Near(T),
    /// The object is in a room, or is one, so that an agent can go there.
    Reachable(T),
    /// The object is a thing or a person, not a room.
    Tangible(T),
    /// The object is not inside a closed container.
    Accessible(T),
    /// The object can be picked up.
    Graspable(T),
    /// No other agent holds or wears the object, and no agent rests on it.
    NotElsewhereHeld(T),
    /// The agent has a free hand.
    FreeHand,
    /// The agent has a free hand, or the object is in one of its hands.
    FreeHandOrHolding(T),
    /// The agent holds the object.
    Holding(T),
    /// The agent holds something.
    HoldingSomething,
    /// The agent holds an object with a property.
    HoldingKind(Property),
    /// Objects can be put on it.
    Carries(T),
    /// Objects can be put in it.
    Encloses(T),
    /// If it can be opened, it is open.
    Accepts(T),
    /// The first object fits on or in the second, if the sizes are known.
    Fits(T, T),
    /// The place from which the held object was taken is near, and open if it can be opened.
    OriginNear(T),
    /// The agent stands.
    Upright,
    /// The agent stands, or is near the object.
    UprightOrNear(T),
    /// The agent sits or lies.
    AtRest,
    /// The agent does not sit.
    NotSitting,
    /// The agent does not lie.
    NotLying,
    /// There is a free place to sit.
    SeatFree(T),
    /// There is a free place to lie.
    BedFree(T),
    /// There is a free seat in the vehicle.
    SeatInside(T),
    /// No agent carries it.
    Steady(T),
    /// The agent is in a vehicle.
    Aboard,
    /// The agent is in this vehicle.
    AboardOf(T),
    /// The agent faces the object.
    Facing(T),
    /// The object is in the agent's room.
    SameRoom(T),
    /// The agent wears the object.
    Worn(T),
    /// It can be eaten, or it has food on it.
    Edible(T),
    /// It can be drunk, or it can contain a drink.
    Potable(T),
    /// It can be poured.
    Liquid(T),
    /// Liquids can be poured into or onto it.
    Receives(T),
    /// It is food that can be cut.
    Cuttable(T),
    /// It is on or in a heater that is on, directly or in a pot.
    OnHeat(T),
    /// It is inside a cooler that is on, directly or on or in another object.
    InCold(T),
    /// It can be pushed and pulled.
    Mobile(T),
    /// It can be squeezed.
    Soft(T),
    /// It can be typed on.
    Typable(T),
    /// It is off, or it may be opened while it is on: a fridge, an oven.
    SafeToOpen(T),
    /// It is a person.
    Personal(T),
    /// It is not the agent itself.
    Other(T),
    /// A relation holds between two objects. No verb needs it as such, but goals do.
    Related(T, Relation, T),
}

impl Condition<Argument> {
    /// The condition with the objects of an action; `None` if the action lacks one.
    pub fn ground(self, action: &Action) -> Option<Condition> {
        use Condition as C;
        let of = |role: Argument| role.of(action);
        Some(match self {
            C::Affords(t, p) => C::Affords(of(t)?, p),
            C::In(t, s) => C::In(of(t)?, s),
            C::NotIn(t, s) => C::NotIn(of(t)?, s),
            C::Near(t) => C::Near(of(t)?),
            C::Reachable(t) => C::Reachable(of(t)?),
            C::Tangible(t) => C::Tangible(of(t)?),
            C::Accessible(t) => C::Accessible(of(t)?),
            C::Graspable(t) => C::Graspable(of(t)?),
            C::NotElsewhereHeld(t) => C::NotElsewhereHeld(of(t)?),
            C::FreeHand => C::FreeHand,
            C::FreeHandOrHolding(t) => C::FreeHandOrHolding(of(t)?),
            C::Holding(t) => C::Holding(of(t)?),
            C::HoldingSomething => C::HoldingSomething,
            C::HoldingKind(p) => C::HoldingKind(p),
            C::Carries(t) => C::Carries(of(t)?),
            C::Encloses(t) => C::Encloses(of(t)?),
            C::Accepts(t) => C::Accepts(of(t)?),
            C::Fits(t, u) => C::Fits(of(t)?, of(u)?),
            C::OriginNear(t) => C::OriginNear(of(t)?),
            C::Upright => C::Upright,
            C::UprightOrNear(t) => C::UprightOrNear(of(t)?),
            C::AtRest => C::AtRest,
            C::NotSitting => C::NotSitting,
            C::NotLying => C::NotLying,
            C::SeatFree(t) => C::SeatFree(of(t)?),
            C::BedFree(t) => C::BedFree(of(t)?),
            C::SeatInside(t) => C::SeatInside(of(t)?),
            C::Steady(t) => C::Steady(of(t)?),
            C::Aboard => C::Aboard,
            C::AboardOf(t) => C::AboardOf(of(t)?),
            C::Facing(t) => C::Facing(of(t)?),
            C::SameRoom(t) => C::SameRoom(of(t)?),
            C::Worn(t) => C::Worn(of(t)?),
            C::Edible(t) => C::Edible(of(t)?),
            C::Potable(t) => C::Potable(of(t)?),
            C::Liquid(t) => C::Liquid(of(t)?),
            C::Receives(t) => C::Receives(of(t)?),
            C::Cuttable(t) => C::Cuttable(of(t)?),
            C::OnHeat(t) => C::OnHeat(of(t)?),
            C::InCold(t) => C::InCold(of(t)?),
            C::Mobile(t) => C::Mobile(of(t)?),
            C::Soft(t) => C::Soft(of(t)?),
            C::Typable(t) => C::Typable(of(t)?),
            C::SafeToOpen(t) => C::SafeToOpen(of(t)?),
            C::Personal(t) => C::Personal(of(t)?),
            C::Other(t) => C::Other(of(t)?),
            C::Related(t, r, u) => C::Related(of(t)?, r, of(u)?),
        })
    }
}

impl<T> Condition<T> {
    /// Whether no action can change it: it concerns constant properties of an object.
    pub fn is_lasting(&self) -> bool {
        use Condition as C;
        matches!(
            self,
            C::Affords(..)
                | C::Graspable(_)
                | C::Carries(_)
                | C::Encloses(_)
                | C::Edible(_)
                | C::Potable(_)
                | C::Liquid(_)
                | C::Receives(_)
                | C::Cuttable(_)
                | C::Mobile(_)
                | C::Soft(_)
                | C::Typable(_)
                | C::Personal(_)
                | C::Other(_)
                | C::Reachable(_)
                | C::Tangible(_)
        )
    }
}
