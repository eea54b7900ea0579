//! Reasons for the refusal of actions.

use crate::spelling::takes_and_given;
use crate::{AimPoint, EditError, Label, NodeId, Property, Relation, State, Verb};

/// The reason why an action is refused. Every refusal names the objects and the unmet precondition.
#[derive(Debug, Clone, PartialEq, thiserror::Error, serde::Serialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Refusal {
    /// The object does not exist.
    #[error("there is no node {0} in this scene")]
    NoSuchThing(NodeId),
    /// The verb is another scene's own.
    #[error("this scene has no verb `{0}`: declare it in the scene's vocabulary")]
    NoSuchVerb(Verb),
    /// The text of the action gives the object another name.
    #[error("{0} is not what the action calls it; write the class and the number of one thing")]
    Misnamed(Label),
    /// The acting node is not an agent.
    #[error("{0} is no agent and cannot act")]
    NoAgent(Label),
    /// An object is named twice.
    #[error("{0} is to be put on, in or with itself")]
    WithItself(Label),
    /// Too few objects are named.
    #[error("`{verb}` takes {}", takes_and_given(*.takes, *.given))]
    Arity {
        /// The verb.
        verb: Verb,
        /// The number of objects it takes.
        takes: usize,
        /// The number of objects given.
        given: usize,
    },
    /// The verb takes no such aim.
    #[error("`{verb}` takes {}", aims_taken(.takes, .given))]
    Aim {
        /// The verb.
        verb: Verb,
        /// The aims that it takes, as they are written.
        takes: Vec<String>,
        /// The aim given.
        given: String,
    },
    /// The point is neither on nor in the object, or not in the room.
    #[error("the point {point} is not on or in {at}")]
    PointElsewhere {
        /// The point.
        point: AimPoint,
        /// The surface, the container or the room.
        at: Label,
    },
    /// The point is not near the object that one is to go to.
    #[error("the point {point} is too far from {thing}: {distance:.1} m")]
    PointApart {
        /// The point.
        point: AimPoint,
        /// The object.
        thing: Label,
        /// Their distance, metres.
        distance: f32,
    },
    /// The point is not within reach.
    #[error("the point {point} is {distance:.1} m away: walk closer first")]
    PointOutOfReach {
        /// The point.
        point: AimPoint,
        /// Its distance, metres.
        distance: f32,
    },
    /// Another thing stands at the point.
    #[error("{by} stands at {point}: choose another point, or put {by} away first")]
    PointTaken {
        /// The point.
        point: AimPoint,
        /// The thing.
        by: Label,
    },
    /// The point is in no room.
    #[error("the point {0} is in no room of the scene")]
    OutsideRooms(AimPoint),
    /// The scene has no poses, so an agent cannot go to a point.
    #[error("the scene has no poses of rooms: name an object instead of the point {0}")]
    NoPoses(AimPoint),
    /// The object has fewer seats or slots.
    #[error(
        "{thing} has {has} {part}{}, numbered from 1: there is no {part} {number}",
        if *.has == 1 { "" } else { "s" }
    )]
    NoSuchPart {
        /// The object.
        thing: Label,
        /// The word for its parts: seat, slot.
        part: crate::AimWord,
        /// The number asked for.
        number: u16,
        /// How many it has.
        has: u32,
    },
    /// VirtualHome's simulator knows no aims.
    #[error("VirtualHome's simulator has no points, headings, seats, slots or sides: leave `{0}` out")]
    AimNotInVirtualHome(String),
    /// The object lacks the affordance.
    #[error("{0} is not {1}")]
    NotAfforded(Label, &'static str),
    /// The thing is a room.
    #[error("{0} is a room: name a thing in it, such as its floor")]
    IsRoom(Label),
    /// The agent is to do to itself what one does to others.
    #[error("{0} is oneself")]
    Oneself(Label),
    /// The object is not in the state.
    #[error("{0} is not {1}")]
    NotInState(Label, State),
    /// The object is in the state.
    #[error("{0} is {1}")]
    InState(Label, State),
    /// The object is not near.
    #[error("not near: {thing} is {}", far(*.distance))]
    NotNear {
        /// The object.
        thing: Label,
        /// Its distance, metres, if poses are known.
        distance: Option<f32>,
    },
    /// The object is in no room, so an agent cannot go there.
    #[error("{0} is in no room, so no agent can go there")]
    NoWay(Label),
    /// The object is inside a closed container.
    #[error("{thing} is inside {inside}, which is closed")]
    Hidden {
        /// The object.
        thing: Label,
        /// The container.
        inside: Label,
    },
    /// Both hands of the agent are full.
    #[error("{0} has no free hand: put something down first")]
    NoFreeHand(Label),
    /// The agent does not hold the object.
    #[error("{0} is not in hand")]
    NotHeld(Label),
    /// The agent's hands are empty.
    #[error("{0} holds nothing: take something first")]
    EmptyHands(Label),
    /// The agent holds nothing with the property.
    #[error("nothing in hand is a {0}")]
    NoTool(Property),
    /// Another agent holds the object, or something that it is on.
    #[error("{by} holds {thing}")]
    HeldByOther {
        /// The object.
        thing: Label,
        /// The holder.
        by: Label,
    },
    /// Another agent wears the object.
    #[error("{by} wears {thing}")]
    WornByOther {
        /// The object.
        thing: Label,
        /// The wearer.
        by: Label,
    },
    /// The agent would carry an object that another agent rests on.
    #[error("{by} is on {thing}")]
    UnderOther {
        /// The object.
        thing: Label,
        /// The agent on it.
        by: Label,
    },
    /// The agent would carry an object that it rests on itself.
    #[error("one rests on {0} oneself")]
    RestingOnIt(Label),
    /// The container is closed.
    #[error("{0} is closed")]
    Shut(Label),
    /// The object does not fit.
    #[error("{thing} does not fit: {at} {why}")]
    DoesNotFit {
        /// The object to be placed.
        thing: Label,
        /// The place.
        at: Label,
        /// The reason.
        why: &'static str,
    },
    /// The agent sits or lies.
    #[error("{0} must stand up first")]
    NotUpright(Label),
    /// The agent neither sits nor lies.
    #[error("{0} neither sits nor lies: sit or lie down first")]
    NotAtRest(Label),
    /// The agent has that posture already.
    #[error("one is {0} already")]
    PostureAlready(State),
    /// All places are taken.
    #[error("all {places} places on {seat} are taken")]
    Occupied {
        /// The seat or bed.
        seat: Label,
        /// The number of its places.
        places: u32,
    },
    /// The agent is in no vehicle, or in another one.
    #[error("one is not in {0}")]
    NotAboard(String),
    /// The agent does not face the object.
    #[error("one does not face {0}; turn to it first")]
    NotFacing(Label),
    /// The object is in another room.
    #[error("{thing} is in {room}, another room")]
    OtherRoom {
        /// The object.
        thing: Label,
        /// Its room.
        room: Label,
    },
    /// The agent does not wear the object.
    #[error("one does not wear {0}")]
    NotWorn(Label),
    /// Nothing heats the object.
    #[error("{0} is not on or in anything hot that is switched on")]
    NoHeat(Label),
    /// Nothing cools the object.
    #[error("{0} is not in anything that cools and runs")]
    NoCold(Label),
    /// The relation does not hold.
    #[error("not: {0} {1} {2}")]
    NotRelated(Label, Relation, Label),
    /// VirtualHome's simulator has no such action.
    #[error("VirtualHome's simulator has no action `{0}`")]
    NotInVirtualHome(Verb),
    /// The effects could not be carried out.
    #[error(transparent)]
    Edit(#[from] EditError),
}

fn aims_taken(takes: &[String], given: &str) -> String {
    match takes {
        [] => format!("no point, heading, seat, slot or side: leave `{given}` out"),
        takes => format!("`{}`, not `{given}`", takes.join("`, `")),
    }
}

fn far(distance: Option<f32>) -> String {
    distance.map_or_else(|| "too far away".into(), |d| format!("{d:.1} m away"))
}
