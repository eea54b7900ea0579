//! The adjacency of room kinds: drawn for a plan, and found in one.

use vc_graph::Stream;

use super::{Room, RoomKind, boundaries};

/// Whether rooms of two kinds share a wall somewhere in the plan.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Topology {
    /// Two bedrooms.
    pub(crate) bedroom_bedroom: bool,
    /// Two bathrooms.
    pub(crate) bath_bath: bool,
    /// A bedroom and the kitchen.
    pub(crate) bedroom_kitchen: bool,
    /// A bathroom and the kitchen.
    pub(crate) bath_kitchen: bool,
}

/// The shortest stretch that counts as a shared wall, cells.
const CONTACT: i32 = 6;

impl Topology {
    /// Draws an adjacency like that of real plans. Not every scheme can follow every request: the
    /// probabilities drawn with are those for which the resulting shares are the real ones, with
    /// which [`crate::statistics`] compares them.
    pub(super) fn draw(rng: &mut Stream) -> Self {
        Self {
            bedroom_bedroom: rng.chance(0.53),
            bath_bath: rng.chance(0.76),
            bedroom_kitchen: rng.chance(0.03),
            bath_kitchen: rng.chance(0.5),
        }
    }

    /// The adjacency in a plan.
    pub(crate) fn from_rooms(rooms: &[Room]) -> Self {
        let mut found = Self::default();
        for edge in boundaries::boundaries(rooms).iter().filter(|e| e.length() >= CONTACT) {
            let (Some(a), Some(b)) = (edge.low, edge.high) else { continue };
            let (a, b) = (rooms[a].kind, rooms[b].kind);
            let pair = |f: fn(RoomKind) -> bool, g: fn(RoomKind) -> bool| (f(a) && g(b)) || (f(b) && g(a));
            let bath = |k| k == RoomKind::Bathroom;
            let kitchen = |k| k == RoomKind::Kitchen;
            found.bedroom_bedroom |= pair(RoomKind::is_bedroom, RoomKind::is_bedroom);
            found.bath_bath |= pair(bath, bath);
            found.bedroom_kitchen |= pair(RoomKind::is_bedroom, kitchen);
            found.bath_kitchen |= pair(bath, kitchen);
        }
        found
    }

    /// The number of differences that matter for these rooms; the one hardest for the schemes
    /// counts twice.
    pub(super) fn differences(self, other: Self, bedrooms: usize, baths: usize, kitchen: bool) -> usize {
        usize::from(bedrooms > 1 && self.bedroom_bedroom != other.bedroom_bedroom)
            + usize::from(baths > 1 && self.bath_bath != other.bath_bath)
            + 2 * usize::from(kitchen && self.bedroom_kitchen != other.bedroom_kitchen)
            + usize::from(kitchen && self.bath_kitchen != other.bath_kitchen)
    }
}
