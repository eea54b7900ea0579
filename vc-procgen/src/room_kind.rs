//! The purposes of rooms.

use serde::Serialize;
use vc_graph::ClassTable;
use vc_graph::class::Trait;

/// The purpose of a room.
///
/// ```
/// use vc_procgen::plan::RoomKind;
/// assert_eq!((RoomKind::Study.class(), RoomKind::Study.title()), ("home_office", "Study"));
/// assert!(RoomKind::Kids.is_bedroom());
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum RoomKind {
    /// Living room, often with the dining area.
    Living,
    /// Kitchen, closed or open to the living room.
    Kitchen,
    /// Bedroom for one or two adults.
    Bedroom,
    /// A child's bedroom.
    Kids,
    /// Bathroom with toilet, basin and shower or bath.
    Bathroom,
    /// Toilet and hand basin.
    Wc,
    /// Hall or corridor.
    Hall,
    /// Study.
    Study,
    /// Laundry.
    Laundry,
    /// Store room or walk-in closet.
    Storage,
    /// Balcony: outside the walls.
    Balcony,
}

impl RoomKind {
    /// The room's class in the class table.
    pub fn class(self) -> &'static str {
        match self {
            Self::Living => "living_room",
            Self::Kitchen => "kitchen",
            Self::Bedroom => "bedroom",
            Self::Kids => "kids_room",
            Self::Bathroom | Self::Wc => "bathroom",
            Self::Hall => "hallway",
            Self::Study => "home_office",
            Self::Laundry => "laundry_room",
            Self::Storage => "storage_room",
            Self::Balcony => "balcony",
        }
    }

    /// The name for display.
    pub fn title(self) -> &'static str {
        match self {
            Self::Living => "Living room",
            Self::Kitchen => "Kitchen",
            Self::Bedroom => "Bedroom",
            Self::Kids => "Child's room",
            Self::Bathroom => "Bathroom",
            Self::Wc => "WC",
            Self::Hall => "Hall",
            Self::Study => "Study",
            Self::Laundry => "Laundry",
            Self::Storage => "Storage",
            Self::Balcony => "Balcony",
        }
    }

    /// Whether it is a bedroom.
    pub fn is_bedroom(self) -> bool {
        matches!(self, Self::Bedroom | Self::Kids)
    }

    /// Whether it has windows where it is at a facade.
    pub(crate) fn has_window(self) -> bool {
        matches!(self, Self::Living | Self::Kitchen | Self::Bedroom | Self::Kids | Self::Study | Self::Hall)
    }

    /// Whether it has running water and a tiled floor.
    pub(crate) fn is_wet(self) -> bool {
        is_wet(&ClassTable::builtin(), self.class())
    }
}

/// Whether rooms of a class have running water and a tiled floor.
pub(crate) fn is_wet(classes: &ClassTable, room: &str) -> bool {
    classes.get(room).is_some_and(|class| class.traits.contains(Trait::Wet))
}
