//! The reasons why a thing cannot be put to a spot.

use vc_graph::NodeId;

/// The reason why a thing cannot be put to a spot that is asked for; the last ones are nearest to success.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum SpotFault {
    /// No surface is there.
    OffSurface,
    /// Something is too low above it.
    TooLow,
    /// It would reach over an edge, so that it would not rest there.
    Unsupported,
    /// Nothing is in the way there, but the condition is not met.
    NotAdmitted,
    /// Other things are there; none if all spots of the surface are taken.
    Taken(Vec<NodeId>),
}
