//! The specification of a building.

use vc_graph::space::RegionFrame;

use super::error::BuildingError;
use crate::specification::Specification;

/// The wishes for a building.
///
/// ```
/// use vc_procgen::{BuildingSpecification, Specification};
/// let small = BuildingSpecification { storeys: 2, homes: Specification::with_bedrooms(1), ..Default::default() };
/// assert!(small.check().is_ok());
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct BuildingSpecification {
    /// Storeys, 2 to 8, the ground counted; 3 by default.
    pub storeys: usize,
    /// Where it is in the world: the middle of the southern edge of the gallery on the ground.
    pub frame: RegionFrame,
    /// The wishes for all its homes.
    pub homes: Specification,
}

impl Default for BuildingSpecification {
    fn default() -> Self {
        Self { storeys: 3, frame: RegionFrame::WORLD, homes: Specification::default() }
    }
}

impl BuildingSpecification {
    /// Checks that every number is within its range.
    ///
    /// ```
    /// use vc_procgen::BuildingSpecification;
    /// let error = BuildingSpecification { storeys: 9, ..Default::default() }.check().unwrap_err();
    /// assert_eq!(error.to_string(), "storeys is 9, it must be from 2 to 8");
    /// ```
    ///
    /// # Errors
    /// [`BuildingError::Storeys`], or [`BuildingError::Home`] for the wishes for homes.
    pub fn check(&self) -> Result<(), BuildingError> {
        if !(2..=8).contains(&self.storeys) {
            return Err(BuildingError::Storeys(self.storeys));
        }
        Ok(self.homes.check()?)
    }
}
