//! Kinds of rooms as plans of real homes distinguish them.

use serde::{Deserialize, Serialize};

use crate::plan::RoomKind;

/// Rooms of the same purpose. Halls belong to the living room, as in the plans of real homes that
/// the reference values come from.
///
/// ```
/// use vc_procgen::plan::RoomKind;
/// use vc_procgen::statistics::Zone;
/// assert_eq!(Zone::from_room_kind(RoomKind::Hall), Some(Zone::Living));
/// assert_eq!(Zone::from_room_kind(RoomKind::Study), None);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Zone {
    /// Balconies.
    Balcony,
    /// Bathrooms.
    Bathroom,
    /// Bedrooms, including children's.
    Bedroom,
    /// The kitchen.
    Kitchen,
    /// Living room and halls.
    Living,
    /// Store rooms.
    Storage,
}

impl Zone {
    /// All zones.
    pub const ALL: [Self; 6] =
        [Self::Living, Self::Bedroom, Self::Kitchen, Self::Bathroom, Self::Balcony, Self::Storage];

    /// The zone of a room, if the reference has one for it.
    pub fn from_room_kind(kind: RoomKind) -> Option<Self> {
        match kind {
            RoomKind::Living | RoomKind::Hall => Some(Self::Living),
            RoomKind::Bedroom | RoomKind::Kids => Some(Self::Bedroom),
            RoomKind::Bathroom => Some(Self::Bathroom),
            RoomKind::Kitchen => Some(Self::Kitchen),
            RoomKind::Balcony => Some(Self::Balcony),
            RoomKind::Storage => Some(Self::Storage),
            RoomKind::Wc | RoomKind::Study | RoomKind::Laundry => None,
        }
    }

    /// Its name.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Living => "living",
            Self::Bedroom => "bedroom",
            Self::Kitchen => "kitchen",
            Self::Bathroom => "bathroom",
            Self::Balcony => "balcony",
            Self::Storage => "storage",
        }
    }
}

/// The name of a pair of zones in either order: `bathroom-bedroom`.
pub(super) fn pair(a: Zone, b: Zone) -> String {
    format!("{}-{}", a.min(b).name(), a.max(b).name())
}
