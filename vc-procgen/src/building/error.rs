//! The reasons why a building cannot be generated.

use vc_graph::space::{RegionId, SpaceError};

use crate::error::SpecificationError;

/// A building that cannot be generated, or a scene of it that there is not.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BuildingError {
    /// The number of storeys is out of range.
    #[error("storeys is {0}, it must be from 2 to 8")]
    Storeys(usize),
    /// A home cannot be generated.
    #[error(transparent)]
    Home(#[from] SpecificationError),
    /// Something stands before the front door of every home that was drawn for a place.
    #[error(
        "something stands before the front doors of all {drawn} homes that were drawn for a place: specify fewer balconies or another seed"
    )]
    NoHome {
        /// The homes that were drawn.
        drawn: u64,
    },
    /// The regions cannot be planned.
    #[error(transparent)]
    Space(#[from] SpaceError),
    /// There is no such storey.
    #[error("there is no storey {storey}: the last of {storeys} is {}", .storeys - 1)]
    NoStorey {
        /// The storey, counted from 0.
        storey: usize,
        /// The number of storeys.
        storeys: usize,
    },
    /// A region is none of the building's, or a group without a scene.
    #[error("{0} has no scene in this building")]
    NoScene(RegionId),
}
