//! How two nodes stand to each other.

use crate::NodeId;
use crate::vocabulary::{Word, vocabulary};

vocabulary! {
    /// A typed, directed relation `from -> to`.
    ///
    /// [`Relation::places`] are those that say where a thing is; a thing that is
    /// moved loses them all and gets new ones.
    Relation, "relation" {
        /// `from` is supported by `to`.
        On = "on",
        /// `from` is inside `to`.
        Inside = "inside",
        /// Clothes `from` are worn by agent `to`.
        WornBy = "worn_by",
        /// Agent `from` sits on `to`.
        SittingOn = "sitting_on",
        /// Agent `from` lies on `to`.
        LyingOn = "lying_on",
        /// `from` is in room `to`.
        InRoom = "in_room",
        /// Agent `from` holds `to` in the right hand.
        HoldsRight = "holds_right",
        /// Agent `from` holds `to` in the left hand.
        HoldsLeft = "holds_left",
        /// `from` is under `to`.
        Under = "under",
        /// `from` and `to` touch. Symmetric.
        Touching = "touching",
        /// `from` and `to` are near each other. Symmetric.
        Near = "near",
        /// `to` is near, in front of `from`.
        NearFront = "near_front",
        /// `to` is near, behind `from`.
        NearBack = "near_back",
        /// `to` is near, left of `from`.
        NearLeft = "near_left",
        /// `to` is near, right of `from`.
        NearRight = "near_right",
        /// `from` faces `to`.
        Facing = "facing",
        /// Door `from` is between rooms: one edge to each.
        Between = "between",
        /// Some of what was in `from` is now in `to`.
        PouredInto = "poured_into",
        /// Held thing `from` was taken off `to`: where `put back` returns it.
        TakenOff = "taken_off",
        /// Held thing `from` was taken out of `to`: where `put back` returns it.
        TakenOut = "taken_out",
        /// `from` and `to` stand side by side, by their size. Symmetric.
        Beside = "beside",
        /// Substance `to` lies or sticks on `from`.
        Covered = "covered",
        /// `from` is full of substance `to`, as a cloth is of water.
        Saturated = "saturated",
        /// There is some of substance `to` in `from`.
        Contains = "contains",
        /// `from` is filled with substance `to`.
        FilledWith = "filled_with",
        /// Substance `to` comes out of `from`, as water does out of a tap.
        SourceOf = "source_of",
        /// `from` is fastened to `to`.
        Attached = "attached",
        /// Cloth `from` hangs over `to`.
        Draped = "draped",
        /// Cloth `from` lies spread over `to`.
        Overlaid = "overlaid",
    }
}

impl Relation {
    /// Whether the relation holds both ways whenever it holds one way.
    pub fn is_symmetric(self) -> bool {
        matches!(self, Self::Near | Self::Touching | Self::Beside)
    }

    /// The relations that say what a thing rests on, in or with.
    pub fn places() -> &'static [Self] {
        &[Self::On, Self::Inside, Self::WornBy, Self::SittingOn, Self::LyingOn]
    }

    /// The hands an agent holds things with, the preferred one first.
    pub fn hands() -> [Self; 2] {
        [Self::HoldsRight, Self::HoldsLeft]
    }
}

/// One relation between two nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Edge {
    /// The node the relation starts from.
    pub from: NodeId,
    /// What kind of relation it is.
    pub relation: Relation,
    /// The node it leads to.
    pub to: NodeId,
}

impl Edge {
    /// The edge `from -relation-> to`.
    pub fn new(from: NodeId, relation: Relation, to: NodeId) -> Self {
        Self { from, relation, to }
    }

    /// The same edge seen from its other end.
    pub(crate) fn reversed(self) -> Self {
        Self { from: self.to, relation: self.relation, to: self.from }
    }
}

impl std::fmt::Display for Edge {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} {} {}", self.from, self.relation.as_str(), self.to)
    }
}
