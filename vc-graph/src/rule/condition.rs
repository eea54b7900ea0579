//! What actions need.

use crate::rule::effect::Role;
use crate::{Action, NodeId, Property, Relation, State};

/// Something an action needs. `T` is the role of a thing in the rule table, or the
/// thing itself when the condition is [grounded](Condition::ground).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Condition<T = NodeId> {
    /// The thing has a property.
    Affords(T, Property),
    /// The thing is in a state.
    In(T, State),
    /// The thing is not in a state.
    NotIn(T, State),
    /// The agent is near the thing, see [`SceneGraph::near`](crate::SceneGraph::near).
    Near(T),
    /// The thing is in a room or is one: one can go there.
    Reachable(T),
    /// The thing is an object or a person, not a room.
    Tangible(T),
    /// The thing is not inside anything closed.
    Accessible(T),
    /// The thing can be picked up.
    Graspable(T),
    /// No other agent holds or wears the thing, and nobody rests on it.
    NotElsewhereHeld(T),
    /// The agent has a free hand.
    FreeHand,
    /// The agent has a free hand, or the thing is in one of its hands.
    FreeHandOrHolding(T),
    /// The agent holds the thing.
    Holding(T),
    /// The agent holds something.
    HoldingSomething,
    /// The agent holds something that has a property.
    HoldingKind(Property),
    /// Things can be put on it.
    Carries(T),
    /// Things can be put in it.
    Encloses(T),
    /// If it opens, it is open.
    Accepts(T),
    /// The first has room on or in the second, where sizes are known.
    Fits(T, T),
    /// What the held thing was taken from is near, and open if need be.
    OriginNear(T),
    /// The agent stands.
    Upright,
    /// The agent stands, or is near the thing.
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
    /// Nobody carries it about.
    Steady(T),
    /// The agent is in a vehicle.
    Aboard,
    /// The agent is in this vehicle.
    AboardOf(T),
    /// The agent faces the thing.
    Facing(T),
    /// The thing is in the agent's room.
    SameRoom(T),
    /// The agent wears the thing.
    Worn(T),
    /// It can be eaten, or something on it can.
    Edible(T),
    /// It can be drunk, or something can be in it to drink.
    Potable(T),
    /// It can be poured.
    Liquid(T),
    /// Liquids can be poured into it, or onto it.
    Receives(T),
    /// It is food that can be cut.
    Cuttable(T),
    /// It is on or in a heater that is on, directly or in a pot.
    OnHeat(T),
    /// It is inside a cooler that runs, directly or on or in something.
    InCold(T),
    /// It moves when pushed or pulled.
    Mobile(T),
    /// It gives when squeezed.
    Soft(T),
    /// One can type on it.
    Typable(T),
    /// It is off, or one opens it while it runs: a fridge, an oven.
    SafeToOpen(T),
    /// It is a person.
    Personal(T),
    /// A relation holds between two things. No verb needs it as such; goals do.
    Related(T, Relation, T),
}

impl Condition<Role> {
    /// The condition on the things of an action; `None` if the action lacks one.
    pub fn ground(self, action: &Action) -> Option<Condition> {
        use Condition as C;
        let of = |role: Role| role.of(action);
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
            C::Related(t, r, u) => C::Related(of(t)?, r, of(u)?),
        })
    }
}

impl<T> Condition<T> {
    /// Whether no action changes it: it is about what a thing is.
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
                | C::Reachable(_)
                | C::Tangible(_)
        )
    }
}
