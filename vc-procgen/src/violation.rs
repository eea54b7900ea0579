//! Violations of the rules of an apartment, with the items and rooms they concern.

use std::fmt;

use vc_graph::NodeId;

use crate::room_kind::RoomKind;

/// A violation in an apartment. Items are named as their nodes in [`Apartment::scene`](crate::Apartment::scene), rooms
/// and openings by their index in the plan.
///
/// ```
/// use vc_procgen::ApartmentViolation;
/// use vc_procgen::plan::RoomKind;
/// let violation = ApartmentViolation::Incomplete(2, RoomKind::Kitchen, "sink");
/// assert_eq!(violation.to_string(), "the Kitchen (room 2) has no sink");
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum ApartmentViolation {
    /// Two solids overlap.
    Overlap(ItemLabel, ItemLabel),
    /// An item is not within its room.
    Outside(ItemLabel, usize),
    /// An item floats above its support or penetrates it, by this distance in metres.
    Unsupported(ItemLabel, f32),
    /// A room is unreachable.
    UnreachableRoom(usize, RoomKind),
    /// An item is out of reach.
    Unreachable(ItemLabel),
    /// An item stands in the swing of a door's leaf or in front of an opening.
    BlockedDoor(usize, ItemLabel),
    /// A leaf, lid or drawer of the first item hits the second, which cannot be pushed aside, before it is half
    /// open.
    Jammed(ItemLabel, ItemLabel),
    /// A room lacks a required piece.
    Incomplete(usize, RoomKind, &'static str),
    /// A room is reached only through a bedroom or a bathroom.
    Passage(usize, RoomKind),
    /// An item, or a door's other side, is in a room that the plan does not have.
    UnknownRoom(ItemLabel, usize),
    /// An item rests on an item that does not precede it: on itself, on a later one, or on none. The index is that of
    /// the support.
    UnknownSupport(ItemLabel, usize),
    /// The first item rests on a surface that the second does not have.
    UnknownSurface(ItemLabel, ItemLabel, usize),
    /// An opening leads into a room that the plan does not have: the opening, and the room.
    OpensNowhere(usize, usize),
    /// A room, an opening or the outer wall reaches farther than 200 m from the plan's origin.
    TooFar,
}

/// An item: its class, and its number in the list of items and in the scene. Prints as its node does, `fridge.57`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ItemLabel {
    /// The index in [`Apartment::items`](crate::Apartment::items).
    pub item: usize,
    /// The node in [`Apartment::scene`](crate::Apartment::scene).
    pub node: NodeId,
    /// Its class.
    pub class: &'static str,
}

impl fmt::Display for ItemLabel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}", self.class, self.node.0)
    }
}

impl fmt::Display for ApartmentViolation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Overlap(a, b) => write!(f, "{a} and {b} share space"),
            Self::Outside(a, room) => write!(f, "{a} is not within room {room}"),
            Self::Unsupported(a, by) => write!(f, "{a} is {by:.3} m off what it rests on"),
            Self::UnreachableRoom(room, kind) => write!(f, "nobody gets into the {} (room {room})", kind.title()),
            Self::Unreachable(a) => write!(f, "nobody reaches {a}"),
            Self::BlockedDoor(door, a) => write!(f, "{a} is in the way of opening {door}"),
            Self::Jammed(a, b) => write!(f, "{a} does not open: {b} is in the way"),
            Self::Incomplete(room, kind, what) => write!(f, "the {} (room {room}) has no {what}", kind.title()),
            Self::Passage(room, kind) => {
                write!(f, "the {} (room {room}) is reached only through a private room", kind.title())
            }
            Self::UnknownRoom(a, room) => write!(f, "{a} is in room {room}, which the plan does not have"),
            Self::UnknownSupport(a, at) => {
                write!(f, "{a} rests on item {at}, which does not precede it: list a support before its load")
            }
            Self::UnknownSurface(a, b, surface) => {
                write!(f, "{a} rests on surface {surface} of {b}, which does not have it")
            }
            Self::OpensNowhere(opening, room) => {
                write!(f, "opening {opening} leads into room {room}, which the plan does not have")
            }
            Self::TooFar => write!(f, "a part of the plan is farther than 200 m from its origin: move it there"),
        }
    }
}

impl std::error::Error for ApartmentViolation {}
