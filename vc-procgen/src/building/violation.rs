//! Violations of the rules of a building.

use vc_graph::space::{PortalId, RegionId};
use vc_graph::{Label, Violation};

/// A violation in a building or house; one that was generated has none.
///
/// ```
/// use vc_graph::space::RegionId;
/// use vc_procgen::BuildingViolation;
/// let violation = BuildingViolation::FrontDoors { home: RegionId(5), gallery: RegionId(4), doors: 2 };
/// assert_eq!(violation.to_string(), "region 5 has 2 front doors to region 4");
/// ```
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BuildingViolation {
    /// Things of two regions share space: the first pair of them.
    #[error("{} of {} and {} of {} share space", .nodes[0], .regions[0], .nodes[1], .regions[1])]
    Overlap {
        /// The regions.
        regions: [RegionId; 2],
        /// A thing of each.
        nodes: [Label; 2],
    },
    /// A thing is outside the space that the plan has for its region.
    #[error("{0} is outside {1}")]
    Outside(Label, RegionId),
    /// A home has no front door to the gallery of its storey, or several.
    #[error("{home} has {doors} front doors to {gallery}")]
    FrontDoors {
        /// The home.
        home: RegionId,
        /// The gallery of its storey.
        gallery: RegionId,
        /// The number of portals between the two.
        doors: usize,
    },
    /// The leaf of a portal is no door of the scene where it should be.
    #[error("the leaf of {0} is {1}, no door")]
    NoLeaf(PortalId, Label),
    /// The door of the lift is not where it is on the ground.
    #[error("{0} is {1:.3} m off the lift's doors below")]
    LiftDoor(Label, f32),
    /// Stairs are not above those below.
    #[error("{0} are {1:.3} m off the stairs below")]
    Stairs(Label, f32),
    /// A rise of stairs differs from the others of the building by more than 5 mm.
    #[error("step {1} of {0} rises by {2:.3} m, others by {3:.3} m")]
    Rise(Label, usize, f32, f32),
    /// A node has a number outside the block of its region.
    #[error("{0} has a number outside the block of {1}")]
    Number(Label, RegionId),
    /// A scene breaks an invariant.
    #[error("{0}: {1}")]
    Scene(RegionId, Violation),
    /// A scene cannot be made.
    #[error("{0} cannot be made: {1}")]
    Broken(RegionId, String),
}
