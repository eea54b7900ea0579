//! Why no initial environment was found.

use std::fmt;

/// Why a scene cannot be made ready for an activity.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum InitialError {
    /// The activity happens in a place that the scene does not have.
    #[error("the scene has no {0}")]
    NoRoom(String),
    /// A thing is neither in the scene nor in the stock.
    #[error("the scene has no {0}, and the stock has none either")]
    NotInStock(String),
    /// A thing is missing that is part of a building or fixed to it.
    #[error("the scene has no {0} that can be reached, and one does not add what is built in")]
    BuiltIn(String),
    /// No place was found for a thing.
    #[error("no place for {thing}: {place}: {why}")]
    NoSpot {
        /// The thing's class.
        thing: String,
        /// The place tried last.
        place: String,
        /// Why it would not do.
        why: Why,
    },
    /// The goal holds before anything is done.
    #[error("the goal holds already: `{0}`")]
    AlreadyMet(String),
    /// The start cannot be as it should be.
    #[error("`{0}` is to hold at the start and does not")]
    StartUnmet(String),
    /// What the world made of it is not what was asked, however often it was tried.
    #[error("after {tries} tries: {what}")]
    Unconfirmed {
        /// The first difference at the last try.
        what: String,
        /// How many tries there were.
        tries: usize,
    },
}

impl InitialError {
    /// Whether another try may go better: chance had a part in it.
    pub(super) fn is_chance(&self) -> bool {
        matches!(self, Self::NoSpot { .. } | Self::AlreadyMet(_) | Self::Unconfirmed { .. } | Self::StartUnmet(_))
    }
}

/// Why a thing cannot be in a place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Why {
    /// There is no such place in the scene.
    Absent,
    /// The thing is wider or deeper than the place.
    TooSmall,
    /// The thing is higher than what is free above the place.
    TooLow,
    /// Other things are in the way, wherever it was tried.
    Taken,
    /// Nobody could reach it there, or it would be in everybody's way.
    Unreachable,
    /// The goal, or a part of it, would be met at once.
    MeetsGoal,
    /// The transition rule says that it does not fit.
    Refused,
}

impl fmt::Display for Why {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Absent => "there is no such place",
            Self::TooSmall => "it is too small",
            Self::TooLow => "there is too little height",
            Self::Taken => "other things are in the way",
            Self::Unreachable => "nobody would reach it there, or it would bar the way",
            Self::MeetsGoal => "the goal would be met",
            Self::Refused => "it does not fit",
        })
    }
}
