//! How actions end.

use vc_graph::clock::Tick;
use vc_graph::{Action, ChangeSet, Label, NodeId, Refusal};

use crate::environment::error::in_a_row;
use crate::environment::{ActionError, Attempt};

/// An action that has ended, as [`Environment::step`](crate::Environment::step) reports it.
#[derive(Debug, Clone, PartialEq)]
pub struct Ending {
    /// The tick in which it ended: when [`Environment::tick`](crate::Environment::tick) is past it, the graph has what
    /// happened in it. An effect comes true with its motion, and its action ends when all rests and the hand is back;
    /// whoever is too late by then is told in the tick of the effect, so before the winner's ending.
    pub tick: Tick,
    /// The agent that did it.
    pub agent: NodeId,
    /// The action.
    pub action: Action,
    /// The changes of the graph since the ending of the last action that was done, or the reason for which this one was
    /// not. An action that is broken off after its effects have come true has been done, however its motions end, unless
    /// somebody else has [undone](Interruption::Undone) it.
    pub outcome: Result<ChangeSet, ActionError>,
}

/// The reason for which an action ended before its end. The world stays as it was in that tick.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Interruption {
    /// Somebody else has taken the thing.
    #[error("{by} has taken {thing}")]
    Taken {
        /// The thing.
        thing: Label,
        /// The agent that holds it now.
        by: Label,
    },
    /// The one whom it was about walks on, faster than one can follow.
    #[error("{0} walks away")]
    WalksAway(Label),
    /// The door was shut before the walker.
    #[error("{by} moves {door}, which is on the way")]
    Shut {
        /// The door.
        door: Label,
        /// The agent that moves it.
        by: Label,
    },
    /// Somebody is in the doorway.
    #[error("{by} is in the doorway of {door}")]
    InDoorway {
        /// The door that was to be moved.
        door: Label,
        /// The agent that passes it.
        by: Label,
    },
    /// Others are in the way and have not left within ten seconds, or a thing is that has come there; there is no way
    /// round.
    #[error("{} in the way: let them walk elsewhere first, or move what can be moved", something(.by))]
    Blocked {
        /// The agents or the thing; empty if nothing is found where there was no way.
        by: Vec<Label>,
    },
    /// Somebody else has opened or shut what it was about, and what was put there is elsewhere.
    #[error("{by} moves {thing}: {} elsewhere", is(.lost))]
    Undone {
        /// The furniture.
        thing: Label,
        /// The agent that has moved it.
        by: Label,
        /// The things that have not stayed where they were put.
        lost: Vec<Label>,
    },
    /// The transition rule allows the action no longer.
    #[error("it is no longer allowed: {}", .0.iter().map(Refusal::to_string).collect::<Vec<_>>().join("; "))]
    NoLonger(Vec<Refusal>),
    /// It was [interrupted](crate::Environment::interrupt) from outside.
    #[error("it was interrupted")]
    Cancelled,
    /// The agent was given another action.
    #[error("another action was given: {0}")]
    Replaced(Attempt),
}

fn something(labels: &[Label]) -> String {
    if labels.is_empty() { "something is".to_owned() } else { is(labels) }
}

fn is(labels: &[Label]) -> String {
    format!("{} {}", in_a_row(labels), if labels.len() == 1 { "is" } else { "are" })
}
