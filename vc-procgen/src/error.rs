//! Why an apartment cannot be made.

use crate::plan::RoomKind;

/// A wish that cannot be met.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Impossible {
    /// The rooms need more than the area wished for.
    #[error(
        "{rooms} rooms need at least {needed:.1} m², the wish is {wished:.1} m²: the largest need is {largest} at \
         {share:.1} m²; wish for fewer rooms or more area"
    )]
    TooSmall {
        /// How many rooms were wished for.
        rooms: usize,
        /// The least net area they need together, m².
        needed: f32,
        /// The net area wished for, m².
        wished: f32,
        /// The room that needs most.
        largest: &'static str,
        /// What that room needs, m².
        share: f32,
    },
    /// The area is more than the rooms can sensibly fill.
    #[error("{rooms} rooms fill at most {most:.1} m², the wish is {wished:.1} m²: wish for more rooms or less area")]
    TooLarge {
        /// How many rooms were wished for.
        rooms: usize,
        /// The largest net area they fill, m².
        most: f32,
        /// The net area wished for, m².
        wished: f32,
    },
    /// A figure of the specification is out of range.
    #[error("{what} is {value}, it must be from {low} to {high}")]
    OutOfRange {
        /// Which figure.
        what: &'static str,
        /// What it is.
        value: f32,
        /// The least it may be.
        low: f32,
        /// The most it may be.
        high: f32,
    },
    /// No scheme holds the rooms.
    #[error("no floor plan was found for {rooms} rooms on {area:.1} m²: change the area or the number of rooms")]
    NoPlan {
        /// How many rooms.
        rooms: usize,
        /// The net area, m².
        area: f32,
    },
    /// No furniture was found that leaves a room usable.
    #[error("the {} (room {room}) holds no {piece}: give the apartment more area", kind.title())]
    NoPlace {
        /// The room's kind.
        kind: RoomKind,
        /// The room's position in the plan.
        room: usize,
        /// What does not fit.
        piece: &'static str,
    },
    /// Every attempt within the bound failed the check.
    #[error("{attempts} attempts all failed the check, the last by: {last}")]
    Unsound {
        /// How many attempts were made.
        attempts: usize,
        /// A violation of the last one.
        last: String,
    },
}
