//! Preconditions of actions.

use crate::vocabulary::forms;
use crate::{NodeId, Property, Relation, State};

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
    /// It can be eaten, or it has food on or in it that nothing hides.
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

forms! { Condition, "condition" {
    Affords = "affords" { 0: thing, 1: property };
    In = "in" { 0: thing, 1: state };
    NotIn = "not_in" { 0: thing, 1: state };
    Near = "near" { 0: thing };
    Reachable = "reachable" { 0: thing };
    Tangible = "tangible" { 0: thing };
    Accessible = "accessible" { 0: thing };
    Graspable = "graspable" { 0: thing };
    NotElsewhereHeld = "not_elsewhere_held" { 0: thing };
    FreeHand = "free_hand" {};
    FreeHandOrHolding = "free_hand_or_holding" { 0: thing };
    Holding = "holding" { 0: thing };
    HoldingSomething = "holding_something" {};
    HoldingKind = "holding_kind" { 0: property };
    Carries = "carries" { 0: thing };
    Encloses = "encloses" { 0: thing };
    Accepts = "accepts" { 0: thing };
    Fits = "fits" { 0: thing, 1: other };
    OriginNear = "origin_near" { 0: thing };
    Upright = "upright" {};
    UprightOrNear = "upright_or_near" { 0: thing };
    AtRest = "at_rest" {};
    NotSitting = "not_sitting" {};
    NotLying = "not_lying" {};
    SeatFree = "seat_free" { 0: thing };
    BedFree = "bed_free" { 0: thing };
    SeatInside = "seat_inside" { 0: thing };
    Steady = "steady" { 0: thing };
    Aboard = "aboard" {};
    AboardOf = "aboard_of" { 0: thing };
    Facing = "facing" { 0: thing };
    SameRoom = "same_room" { 0: thing };
    Worn = "worn" { 0: thing };
    Edible = "edible" { 0: thing };
    Potable = "potable" { 0: thing };
    Liquid = "liquid" { 0: thing };
    Receives = "receives" { 0: thing };
    Cuttable = "cuttable" { 0: thing };
    OnHeat = "on_heat" { 0: thing };
    InCold = "in_cold" { 0: thing };
    Mobile = "mobile" { 0: thing };
    Soft = "soft" { 0: thing };
    Typable = "typable" { 0: thing };
    SafeToOpen = "safe_to_open" { 0: thing };
    Personal = "personal" { 0: thing };
    Other = "other" { 0: thing };
    Related = "related" { 0: thing, 1: relation, 2: other };
}}

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
