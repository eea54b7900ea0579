//! Effects of actions.

use crate::vocabulary::forms;
use crate::{Aim, State};

/// The role of an object in an action.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Argument {
    /// The first object: the one that is grabbed, opened, put.
    X,
    /// The second object: the place where the first is put.
    Y,
}

/// An effect of an action. `T` as in [`Condition`](super::Condition).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
pub enum Effect<T> {
    /// The object enters a state.
    Enter(T, State),
    /// The object enters a state, with everything on or in it.
    EnterWith(T, State),
    /// The object leaves a state.
    Leave(T, State),
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

forms! { Effect, "effect" {
    Enter = "enter" { 0: thing, 1: state };
    EnterWith = "enter_with" { 0: thing, 1: state };
    Leave = "leave" { 0: thing, 1: state };
    EnterOwn = "enter_own" { 0: state };
    LeaveOwn = "leave_own" { 0: state };
    GoTo = "go_to" { 0: thing };
    Approach = "approach" { 0: thing };
    Face = "face" { 0: thing };
    Hold = "hold" { 0: thing };
    PutOn = "put_on" { 0: thing, 1: other };
    PutInto = "put_into" { 0: thing, 1: other };
    PutWhereItWas = "put_where_it_was" { 0: thing };
    LetGo = "let_go" { 0: thing };
    SitOn = "sit_on" { 0: thing };
    LieOn = "lie_on" { 0: thing };
    StandUp = "stand_up" {};
    PourInto = "pour_into" { 0: thing, 1: other };
    FillWithWater = "fill_with_water" { 0: thing };
    PutOnBody = "put_on_body" { 0: thing };
    Board = "board" { 0: thing };
    Alight = "alight" {};
    DriveTo = "drive_to" { 0: thing, 1: other };
    GoToPoint = "go_to_point" { 0: aim };
    StandAs = "stand_as" { 0: aim };
    TurnAs = "turn_as" { 0: aim };
    PoseAs = "pose_as" { 0: thing, 1: aim };
}}
