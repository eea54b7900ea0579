//! Errors of maps that cannot be built.

use crate::{BuildingId, JunctionId, RoadId};

/// A map cannot be built from its description.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MapError {
    /// A road begins or ends at a junction that there is not.
    #[error("{road} ends at {junction}, which the map does not have")]
    NoSuchJunction {
        /// The road.
        road: RoadId,
        /// The missing junction.
        junction: JunctionId,
    },
    /// A crossing or a ban names a road that does not end at its junction.
    #[error("a {what} at {junction} names {road}, which does not end there")]
    NotAtJunction {
        /// A crossing or a ban.
        what: &'static str,
        /// The junction.
        junction: JunctionId,
        /// The road.
        road: RoadId,
    },
    /// A road's line has no length, or a number in it is not finite.
    #[error("the line of {0} needs two points that differ, with finite coordinates within 1,000 km")]
    NoLine(RoadId),
    /// A road has a strip without a width, or no strip at all.
    #[error("{0} needs at least one strip, each with a width from 0.1 to 100 m and a limit of 0.1 to 150 m/s")]
    NoStrip(RoadId),
    /// A junction lies nowhere.
    #[error("{0} is not at a finite place within 1,000 km")]
    Nowhere(JunctionId),
    /// Too many roads meet.
    #[error("{arms} roads meet at {junction}, at most {most} can: split it")]
    TooManyArms {
        /// The junction.
        junction: JunctionId,
        /// The roads.
        arms: usize,
        /// The most that can meet.
        most: usize,
    },
    /// An entrance names a building that there is not.
    #[error("an entrance names {0}, which the map does not have")]
    NoSuchBuilding(BuildingId),
    /// An outline has fewer than three points, or one that is not finite.
    #[error("the outline of {what} {index} needs three finite points at least")]
    NoOutline {
        /// A building or an area.
        what: &'static str,
        /// Its position in the list.
        index: usize,
    },
    /// The origin is not on Earth.
    #[error("the origin has a latitude of -89 to 89 and a longitude of -180 to 180 degrees")]
    NoOrigin,
}
