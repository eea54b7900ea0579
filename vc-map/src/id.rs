//! Numbers of the parts of a map.

use std::fmt;

use serde::{Deserialize, Serialize};

macro_rules! ids {
    ($($(#[$doc:meta])* $name:ident, $word:literal;)*) => {$(
        $(#[$doc])*
        #[doc = concat!("Prints as `", $word, " 3`.")]
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
        #[serde(transparent)]
        pub struct $name(pub u32);

        impl $name {
            /// As an index into the list of its kind.
            pub fn index(self) -> usize {
                self.0 as usize
            }

            /// The id of a position in the list of its kind.
            pub(crate) fn of(index: usize) -> Self {
                Self(u32::try_from(index).unwrap_or(u32::MAX))
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, concat!($word, " {}"), self.0)
            }
        }
    )*};
}

ids! {
    /// The number of a junction.
    JunctionId, "junction";
    /// The number of a road.
    RoadId, "road";
    /// The number of a lane.
    LaneId, "lane";
    /// The number of a movement.
    MovementId, "movement";
    /// The number of a signal.
    SignalId, "signal";
    /// The number of a crossing.
    CrossingId, "crossing";
    /// The number of a building.
    BuildingId, "building";
    /// The number of an entrance.
    EntranceId, "entrance";
    /// The number of a node of the walkable network.
    WalkNodeId, "walk node";
    /// The number of an edge of the walkable network.
    WalkEdgeId, "walk edge";
}
