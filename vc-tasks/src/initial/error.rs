//! The errors of preparing an initial environment.

use std::fmt;

use vc_graph::EditError;

use crate::world::WorldError;

/// The reason why a scene cannot be prepared for an activity.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder, Seed, Simulator};
/// use vc_tasks::initial::{InitialError, InitialGenerator, PlainStock};
/// use vc_tasks::library::Benchmark;
/// let mut scene = SceneBuilder::new("shed");
/// scene.add(Draft::new("garden"))?;
/// let (graph, benchmark) = (scene.build(), Benchmark::v1());
/// let mut world = Simulator::new(graph.clone());
/// let made = InitialGenerator::new(&PlainStock).make(&benchmark.activities[0], &graph, Seed(1), &mut world);
/// assert!(matches!(made, Err(InitialError::NoRoom(room)) if room == "kitchen"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InitialError {
    /// The activity takes place in a room that the scene does not have.
    #[error("the scene has no {0}")]
    NoRoom(String),
    /// An object is neither in the scene nor in the stock.
    #[error("the scene has no {0}, and the stock has none either")]
    NotInStock(String),
    /// The missing object is part of a building or fixed to it.
    #[error("the scene has no {0} that can be reached, and one does not add what is built in")]
    BuiltIn(String),
    /// No placement was found for an object.
    #[error("no place for {thing}: {place}: {why}")]
    NoSpot {
        /// The object's class.
        thing: String,
        /// The place tried last.
        place: String,
        /// The reason why the object does not fit there.
        why: PlacementReason,
    },
    /// The goal already holds before any action.
    #[error("the goal holds already: `{0}`")]
    AlreadyMet(String),
    /// The start conditions cannot be fulfilled.
    #[error("`{0}` is to hold at the start and does not")]
    StartUnmet(String),
    /// The world's scene differs from the one requested after every attempt.
    #[error("after {tries} tries: {difference}")]
    Unconfirmed {
        /// The first difference at the last attempt, with the labels of the nodes.
        difference: String,
        /// The number of attempts.
        tries: usize,
    },
    /// The start conditions would break an invariant of the scene.
    #[error(transparent)]
    Edit(#[from] EditError),
    /// The world does not take the scene, at every attempt.
    #[error("after {tries} tries: {error}")]
    World {
        /// The world's error at the last attempt.
        #[source]
        error: WorldError,
        /// The number of attempts.
        tries: usize,
    },
}

impl InitialError {
    /// Whether another attempt may succeed because the error depends on chance.
    pub(super) fn is_chance(&self) -> bool {
        !matches!(self, Self::NoRoom(_) | Self::NotInStock(_) | Self::BuiltIn(_))
    }
}

/// The reason why an object cannot be placed somewhere.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum PlacementReason {
    /// There is no such place in the scene.
    Absent,
    /// The object is wider or deeper than the place.
    TooSmall,
    /// The object is higher than the free space above the place.
    TooLow,
    /// Other objects are in the way at every sampled position.
    Taken,
    /// An agent could not reach the object there, or the object would block a way.
    Unreachable,
    /// The placement would fulfil the goal or a part of it.
    MeetsGoal,
    /// The transition rules say that it does not fit.
    Refused,
}

impl fmt::Display for PlacementReason {
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
