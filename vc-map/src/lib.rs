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
mod markings;
mod offset;
pub mod osm;
mod parts;
pub mod picture;
mod places;
mod polyline;
pub mod route;
mod rules;
mod section;
mod signal;
mod size;
mod users;
pub mod validate;

pub use draft::{Control, DrivingSide, JunctionDraft, MapDraft, Origin, RoadDraft, Structure};
pub use error::MapError;
pub use id::{
    BuildingId, CrossingId, EntranceId, JunctionId, LaneId, MovementId, RoadId, SignalId, WalkEdgeId, WalkNodeId,
};
pub use map::StreetMap;
pub use markings::Marking;
pub use parts::{Arm, Junction, Lane, Movement, Road, RoadCrossing, Turn, WalkEdge, WalkKind, WalkNode};
pub use places::{Area, AreaKind, Bay, Building, Entrance, EntranceDraft, Stop, StopDraft, StopKind};
pub use polyline::{Point, Polyline, Projection};
pub use rules::{CrossingDraft, CrossingKind, SignDraft, SignKind, TurnBan};
pub use section::{CrossSection, RoadClass, Strip, StripKind};
pub use signal::{ConflictTable, Light, Phase, Signal};
pub use users::{Turns, Users};
pub use validate::MapViolation;
