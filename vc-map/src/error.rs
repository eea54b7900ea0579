//! Errors of maps that cannot be built.

use crate::{BuildingId, EntranceId, JunctionId, RoadId};

/// A map cannot be built from its description. The text names the part and says what to do.
///
/// ```
/// use vc_map::{Control, CrossSection, JunctionId, MapDraft, RoadClass};
/// let mut draft = MapDraft::new("street", 48.1, 11.6);
/// let start = draft.junction([0.0, 0.0], Control::Priority);
/// draft.road(start, JunctionId(7), RoadClass::Residential, CrossSection::default());
/// let error = draft.build().unwrap_err();
/// assert_eq!(error.to_string(), "road 0 ends at junction 7, which the map does not have: add it, or name another");
/// ```
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MapError {
    /// The origin is not on Earth, or at a pole.
    #[error("the origin is not on Earth: give a latitude of -89 to 89 degrees and a longitude of -180 to 180")]
    NoOrigin,
    /// Something has no place.
    #[error("{0} has no place: give X and Y in metres from the origin, each within 1,000 km")]
    Nowhere(String),
    /// A road begins or ends at a junction that there is not.
    #[error("{road} ends at {junction}, which the map does not have: add it, or name another")]
    NoSuchJunction {
        /// The road.
        road: RoadId,
        /// The missing junction.
        junction: JunctionId,
    },
    /// A crossing, a sign or a ban names a road that does not end at its junction.
    #[error("a {what} at {junction} names {road}, which does not end there: name a road that does")]
    NotAtJunction {
        /// A crossing, a sign or a ban.
        what: &'static str,
        /// The junction.
        junction: JunctionId,
        /// The road.
        road: RoadId,
    },
    /// A road's line has no length.
    #[error("the line of {0} has no length: give two points at least that lie a millimetre apart")]
    NoLine(RoadId),
    /// A road has no strip at all.
    #[error("{0} has no strip: add one to a side of its section")]
    NoStrip(RoadId),
    /// A number is out of its range.
    #[error("the {what} of {part} is {value}: give one from {least} to {most}")]
    OutOfRange {
        /// The part of the map, as `road 3`.
        part: String,
        /// The quantity, with its unit.
        what: &'static str,
        /// Its value.
        value: f64,
        /// The least that is allowed.
        least: f64,
        /// The most.
        most: f64,
    },
    /// A part of the map has more of something than it can have.
    #[error("{part} has {count} {what}, at most {most} are possible: split it")]
    TooMany {
        /// The part of the map, as `junction 3`.
        part: String,
        /// Roads, strips, movements.
        what: &'static str,
        /// Their number.
        count: usize,
        /// The most that are possible.
        most: usize,
    },
    /// An entrance names a building that there is not.
    #[error("{entrance} names {building}, which the map does not have: add it, or name another")]
    NoSuchBuilding {
        /// The entrance.
        entrance: EntranceId,
        /// The missing building.
        building: BuildingId,
    },
    /// An outline has fewer than three points, or one without a place.
    #[error("the outline of {what} {index} needs three points at least, each within 1,000 km of the origin")]
    NoOutline {
        /// A building or an area.
        what: &'static str,
        /// Its position in the list.
        index: usize,
    },
    /// The map would take more memory than it may.
    #[error(
        "with {part} the map takes more than {most} bytes: leave parts out, or allow more by `MapDraft::build_within`"
    )]
    TooLarge {
        /// The part at which the memory was used up.
        part: String,
        /// The bytes that it may take.
        most: usize,
    },
}
