//! Rules at the ends of roads: turns that are not allowed, crossings, signs.

use serde::{Deserialize, Serialize};

use crate::{JunctionId, RoadId, Users};

/// A turn that is not allowed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TurnBan {
    /// The road that one comes from.
    pub from: RoadId,
    /// The junction.
    pub at: JunctionId,
    /// The road that one may not go on with.
    pub to: RoadId,
    /// Those who may not turn.
    #[serde(default = "traffic", skip_serializing_if = "is_traffic")]
    pub users: Users,
}

impl TurnBan {
    /// A turn that nobody may take who drives on tyres.
    pub fn new(from: RoadId, at: JunctionId, to: RoadId) -> Self {
        Self { from, at, to, users: Users::TRAFFIC }
    }
}

fn traffic() -> Users {
    Users::TRAFFIC
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "serde asks for a reference")]
fn is_traffic(users: &Users) -> bool {
    *users == Users::TRAFFIC
}

/// How a crossing is marked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum CrossingKind {
    /// With lights.
    Signals,
    /// With a zebra or lines.
    Marked,
    /// People cross, and nothing is marked.
    Unmarked,
}

/// A crossing over an end of a road.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CrossingDraft {
    /// The junction at which it is.
    pub at: JunctionId,
    /// The road that it crosses.
    pub road: RoadId,
    /// How it is marked.
    pub kind: CrossingKind,
    /// Whether there is an island in its middle.
    #[serde(default)]
    pub island: bool,
    /// The number of the node or way that it was made from; 0 if there is none.
    #[serde(default)]
    pub source: i64,
}

/// The kind of a traffic sign.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum SignKind {
    /// One gives way.
    GiveWay,
    /// One stops, and gives way.
    Stop,
}

/// A traffic sign at the end of a road, for those who come along it to a junction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SignDraft {
    /// The junction.
    pub at: JunctionId,
    /// The road that ends there.
    pub road: RoadId,
    /// Its kind.
    pub kind: SignKind,
    /// The number of the node that it was made from; 0 if there is none.
    #[serde(default)]
    pub source: i64,
}
