//! Why actions are refused.

use crate::{EditError, Label, NodeId, Property, Relation, State, Verb};

/// Why an action is refused. Every refusal names the things and says what is
/// missing.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Refusal {
    /// There is no such thing.
    #[error("there is no node {0} in this scene")]
    NoSuchThing(NodeId),
    /// The text that the action was read from calls the thing otherwise.
    #[error("{0} is not what the action calls it; write the class and the number of one thing")]
    Misnamed(Label),
    /// The one who is to act is no agent.
    #[error("{0} is no agent and cannot act")]
    NoAgent(Label),
    /// One thing is named twice.
    #[error("{0} is to be put on, in or with itself")]
    WithItself(Label),
    /// Too few things are named.
    #[error("`{verb}` takes {takes} things, {given} are given")]
    Arity {
        /// The verb.
        verb: Verb,
        /// How many it takes.
        takes: usize,
        /// How many there are.
        given: usize,
    },
    /// The thing does not afford it.
    #[error("{0} is not {1}")]
    NotAfforded(Label, &'static str),
    /// The thing is a room.
    #[error("{0} is a room: name a thing in it, such as its floor")]
    IsRoom(Label),
    /// The thing is not in the state.
    #[error("{0} is not {1}")]
    NotInState(Label, State),
    /// The thing is in the state.
    #[error("{0} is {1}")]
    InState(Label, State),
    /// The thing is not near.
    #[error("not near: {thing} is {}", far(*.distance))]
    NotNear {
        /// The thing.
        thing: Label,
        /// How far away, metres, where poses are known.
        distance: Option<f32>,
    },
    /// The thing is nowhere one could go.
    #[error("{0} is in no room: there is no way to it")]
    NoWay(Label),
    /// The thing is in something closed.
    #[error("{thing} is inside {inside}, which is closed")]
    Hidden {
        /// The thing.
        thing: Label,
        /// What it is inside.
        inside: Label,
    },
    /// Both hands are full.
    #[error("no free hand: both hold something")]
    NoFreeHand,
    /// The agent does not hold the thing.
    #[error("{0} is not in hand")]
    NotHeld(Label),
    /// The agent's hands are empty.
    #[error("nothing is in hand")]
    EmptyHands,
    /// The agent holds nothing of the kind.
    #[error("nothing in hand is a {0}")]
    NoTool(Property),
    /// Somebody holds the thing, or something that it is on.
    #[error("{by} holds {thing}")]
    HeldByOther {
        /// The thing.
        thing: Label,
        /// Who holds it.
        by: Label,
    },
    /// Another agent wears the thing.
    #[error("{by} wears {thing}")]
    WornByOther {
        /// The thing.
        thing: Label,
        /// Who wears it.
        by: Label,
    },
    /// The agent would carry what another rests on.
    #[error("{by} is on {thing}")]
    UnderOther {
        /// The thing.
        thing: Label,
        /// The agent on it.
        by: Label,
    },
    /// The agent would carry what it rests on.
    #[error("one rests on {0} oneself")]
    RestingOnIt(Label),
    /// The container is closed.
    #[error("{0} is closed")]
    Shut(Label),
    /// There is no room for it.
    #[error("{thing} does not fit: {at} {why}")]
    DoesNotFit {
        /// What was to be put there.
        thing: Label,
        /// Where.
        at: Label,
        /// What is in the way.
        why: &'static str,
    },
    /// The agent sits or lies.
    #[error("one must stand up first")]
    NotUpright,
    /// The agent does neither sit nor lie.
    #[error("one neither sits nor lies")]
    NotAtRest,
    /// The agent is in that posture already.
    #[error("one is {0} already")]
    PostureAlready(State),
    /// All places are taken.
    #[error("all {places} places on {seat} are taken")]
    Occupied {
        /// What one would sit or lie on.
        seat: Label,
        /// How many places it has.
        places: u32,
    },
    /// The agent is in no vehicle, or in another.
    #[error("one is not in {0}")]
    NotAboard(String),
    /// The agent does not face the thing.
    #[error("one does not face {0}; turn to it first")]
    NotFacing(Label),
    /// The thing is in another room.
    #[error("{thing} is in {room}, another room")]
    OtherRoom {
        /// The thing.
        thing: Label,
        /// The room it is in.
        room: Label,
    },
    /// The agent does not wear the thing.
    #[error("one does not wear {0}")]
    NotWorn(Label),
    /// Nothing heats the thing.
    #[error("{0} is not on or in anything hot that is switched on")]
    NoHeat(Label),
    /// Nothing cools the thing.
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

fn far(distance: Option<f32>) -> String {
    distance.map_or_else(|| "too far away".into(), |d| format!("{d:.1} m away"))
}
