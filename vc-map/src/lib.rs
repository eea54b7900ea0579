#![doc = include_str!("../FRONT.md")]
#![warn(clippy::disallowed_methods)]

mod build;
mod draft;
mod error;
pub mod format;
mod geo;
mod id;
mod index;
mod map;
pub mod osm;
mod parts;
pub mod picture;
mod polyline;
pub mod route;
mod section;
pub mod validate;

pub use draft::{
    Area, AreaKind, Building, Control, CrossingDraft, CrossingKind, DrivingSide, EntranceDraft, JunctionDraft,
    MapDraft, Origin, RoadDraft, StopDraft, StopKind, Structure, TurnBan,
};
pub use error::MapError;
pub use id::{
    BuildingId, CrossingId, EntranceId, JunctionId, LaneId, MovementId, RoadId, SignalId, WalkEdgeId, WalkNodeId,
};
pub use map::StreetMap;
pub use parts::{
    Arm, Bay, ConflictTable, Entrance, Junction, Lane, Light, Movement, Phase, Road, RoadCrossing, Signal, Stop, Turn,
    WalkEdge, WalkKind, WalkNode,
};
pub use polyline::{Point, Polyline, Projection};
pub use section::{CrossSection, RoadClass, Strip, StripKind, Turns, Users};
pub use validate::MapViolation;
