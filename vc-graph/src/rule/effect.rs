//! Effects of actions.

use crate::{Action, Aim, NodeId, State};

/// The role of an object in an action.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Argument {
    /// The first object: the one that is grabbed, opened, put.
    X,
    /// The second object: the place where the first is put.
    Y,
}

impl Argument {
    pub(super) fn of(self, action: &Action) -> Option<NodeId> {
        match self {
            Self::X => action.object,
            Self::Y => action.target,
        }
    }
}

/// An effect of an action. `T` as in [`Condition`](super::Condition).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
pub enum Effect<T> {
    /// The object enters a state.
    Enter(T, State),
    /// The object enters a state, with everything on or in it.
    EnterWith(T, State),
    /// The agent enters a state.
    EnterOwn(State),
    /// The agent leaves a state.
    LeaveOwn(State),
    /// The agent goes there and takes the objects it holds along.
    GoTo(T),
    /// The agent goes there unless it is near already.
    Approach(T),
    /// The agent faces the object and nothing else.
    Face(T),
    /// The object is in the agent's hand.
    Hold(T),
    /// The first is on the second.
    PutOn(T, T),
    /// The first is inside the second.
    PutInto(T, T),
    /// The object is back where it was taken from.
    PutWhereItWas(T),
    /// The object is in the room, without a support.
    LetGo(T),
    /// The agent sits on the object.
    SitOn(T),
    /// The agent lies on the object.
    LieOn(T),
    /// The agent stands.
    StandUp,
    /// Some of the first object's contents are in the second.
    PourInto(T, T),
    /// The object is filled with water.
    FillWithWater(T),
    /// The agent wears the object.
    PutOnBody(T),
    /// The agent is inside the vehicle.
    Board(T),
    /// The agent is outside its vehicle.
    Alight,
    /// The first object, with everything in it, moves to the second.
    DriveTo(T, T),
    /// The agent goes to the point of an aim and takes the objects it holds along.
    GoToPoint(Aim),
    /// The agent stands at the point of an aim, if it has one, and is turned by its heading.
    StandAs(Aim),
    /// The agent is turned by the heading of an aim, or to its point.
    TurnAs(Aim),
    /// The object is at the point of an aim and turned by its heading, as far as it has them.
    PoseAs(T, Aim),
}

impl Effect<Argument> {
    /// The effect with the objects of an action; `None` if the action lacks one.
    pub fn ground(self, action: &Action) -> Option<Effect<NodeId>> {
        use Effect as E;
        let of = |role: Argument| role.of(action);
        Some(match self {
            E::Enter(t, s) => E::Enter(of(t)?, s),
            E::EnterWith(t, s) => E::EnterWith(of(t)?, s),
            E::EnterOwn(s) => E::EnterOwn(s),
            E::LeaveOwn(s) => E::LeaveOwn(s),
            E::GoTo(t) => E::GoTo(of(t)?),
            E::Approach(t) => E::Approach(of(t)?),
            E::Face(t) => E::Face(of(t)?),
            E::Hold(t) => E::Hold(of(t)?),
            E::PutOn(t, u) => E::PutOn(of(t)?, of(u)?),
            E::PutInto(t, u) => E::PutInto(of(t)?, of(u)?),
            E::PutWhereItWas(t) => E::PutWhereItWas(of(t)?),
            E::LetGo(t) => E::LetGo(of(t)?),
            E::SitOn(t) => E::SitOn(of(t)?),
            E::LieOn(t) => E::LieOn(of(t)?),
            E::StandUp => E::StandUp,
            E::PourInto(t, u) => E::PourInto(of(t)?, of(u)?),
            E::FillWithWater(t) => E::FillWithWater(of(t)?),
            E::PutOnBody(t) => E::PutOnBody(of(t)?),
            E::Board(t) => E::Board(of(t)?),
            E::Alight => E::Alight,
            E::DriveTo(t, u) => E::DriveTo(of(t)?, of(u)?),
            E::GoToPoint(aim) => E::GoToPoint(aim),
            E::StandAs(aim) => E::StandAs(aim),
            E::TurnAs(aim) => E::TurnAs(aim),
            E::PoseAs(t, aim) => E::PoseAs(of(t)?, aim),
        })
    }
}
