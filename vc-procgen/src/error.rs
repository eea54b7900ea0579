//! The reasons why an apartment cannot be generated.

use crate::plan::PlanFault;
use crate::room_kind::RoomKind;
use crate::violation::ApartmentViolation;

/// A specification that cannot be fulfilled.
///
/// ```
/// use vc_graph::Seed;
/// use vc_procgen::{Apartment, Specification, SpecificationError};
/// let wishes = Specification { bedrooms: Some(4), area: Some(20.0), ..Specification::default() };
/// let error = Apartment::generate(&wishes, Seed(1)).unwrap_err();
/// assert!(matches!(error, SpecificationError::TooSmall { wished: 20.0, .. }), "{error}");
/// ```
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SpecificationError {
    /// The rooms need more than the specified area.
    #[error(
        "{rooms} rooms need at least {needed:.1} m², the specified area is {wished:.1} m²: the largest need is \
         {largest} at {share:.1} m²; specify fewer rooms or more area"
    )]
    TooSmall {
        /// The number of rooms specified.
        rooms: usize,
        /// The least net area that they need together, m².
        needed: f32,
        /// The net area specified, m².
        wished: f32,
        /// The room that needs the largest area.
        largest: &'static str,
        /// The area that room needs, m².
        share: f32,
    },
    /// The area is more than the rooms can sensibly fill.
    #[error("{rooms} rooms fill at most {most:.1} m², {wished:.1} m² were specified: add rooms or reduce the area")]
    TooLarge {
        /// The number of rooms specified.
        rooms: usize,
        /// The largest net area that they can fill, m².
        most: f32,
        /// The net area specified, m².
        wished: f32,
    },
    /// A number of the specification is out of range.
    #[error("{what} is {value}, it must be from {low} to {high}")]
    OutOfRange {
        /// The name of the number.
        what: &'static str,
        /// Its value.
        value: f32,
        /// The least value allowed.
        low: f32,
        /// The greatest value allowed.
        high: f32,
    },
    /// No floor-plan scheme accommodates the rooms.
    #[error("no floor plan was found for {rooms} rooms on {area:.1} m²: change the area or the number of rooms")]
    NoPlan {
        /// The number of rooms.
        rooms: usize,
        /// The net area, m².
        area: f32,
    },
    /// The floor plan that was given cannot be furnished.
    #[error("the floor plan cannot be furnished: {0}")]
    BadPlan(#[from] PlanFault),
    /// Rooms or areas are specified beside a floor plan, which has its own.
    #[error("{what} is specified beside a floor plan, which says it already: leave out one of them")]
    Planned {
        /// The name of the field.
        what: &'static str,
    },
    /// No arrangement of the furniture was found that leaves a room usable.
    #[error("the {} (room {room}) holds no {piece}: give the apartment more area", kind.title())]
    NoPlace {
        /// The room's kind.
        kind: RoomKind,
        /// The room's index in the plan.
        room: usize,
        /// The piece that does not fit.
        piece: &'static str,
    },
    /// Every allowed attempt failed the check.
    #[error("{attempts} attempts all failed the check, the last by: {last}")]
    Unsound {
        /// The number of attempts.
        attempts: usize,
        /// A violation of the last attempt.
        #[source]
        last: ApartmentViolation,
    },
}
