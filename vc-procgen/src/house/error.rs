//! The reasons why there is no house.

use vc_graph::space::{RegionId, SpaceError};

use crate::city::CityPlanError;
use crate::error::SpecificationError;

/// A building that is no house of flats, or a scene of it that there is not.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum HouseError {
    /// The city has no such building.
    #[error("the city has no building {0}")]
    NoBuilding(usize),
    /// The building has several wings, or is a single unit.
    #[error(
        "building {0} is not of flats along one corridor: choose another; houses of several wings cannot be entered yet"
    )]
    NotOneWing(usize),
    /// Stairs and lift do not fit.
    #[error("building {0} has no room for stairs and a lift")]
    NoCore(usize),
    /// No flat fits.
    #[error("building {0} has no flats")]
    NoFlats(usize),
    /// A city has no house of flats.
    #[error("the city of this seed has no house of flats: use another seed")]
    None,
    /// The city cannot be planned.
    #[error(transparent)]
    City(#[from] CityPlanError),
    /// A flat cannot be furnished.
    #[error(transparent)]
    Flat(#[from] SpecificationError),
    /// The regions cannot be planned.
    #[error(transparent)]
    Space(#[from] SpaceError),
    /// A region is none of the house's, or a group without a scene.
    #[error("{0} has no scene in this house")]
    NoScene(RegionId),
}
