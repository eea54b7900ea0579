//! Relations between nodes.

use crate::NodeId;
use crate::vocabulary::{Word, vocabulary};

vocabulary! {
    /// A typed, directed relation `from -> to`.
    ///
    /// [`Relation::places`] lists the relations that give an object's support or container; an object that is
    /// moved loses all of them and gets new ones.
    #[non_exhaustive]
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
        /// Some of the contents of `from` are now in `to`.
        PouredInto = "poured_into",
        /// Held object `from` was taken off `to`, where `put back` returns it.
        TakenOff = "taken_off",
        /// Held object `from` was taken out of `to`, where `put back` returns it.
        TakenOut = "taken_out",
        /// `from` and `to` stand side by side; the distance is judged by their sizes. Symmetric.
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
    /// Whether the relation is symmetric: it always holds in both directions.
    pub fn is_symmetric(self) -> bool {
        matches!(self, Self::Near | Self::Touching | Self::Beside)
    }

    /// The relations that give an object's support, container or wearer.
    pub fn places() -> &'static [Self] {
        &[Self::On, Self::Inside, Self::WornBy, Self::SittingOn, Self::LyingOn]
    }

    /// The relations of an agent's two hands, the preferred one first.
    pub const fn hands() -> [Self; 2] {
        [Self::HoldsRight, Self::HoldsLeft]
    }
}

/// One relation between two nodes.
///
/// ```
/// use vc_graph::{Edge, NodeId, Relation};
/// let edge = Edge::new(NodeId(2), Relation::On, NodeId(1));
/// assert_eq!(edge.to_string(), "#2 on #1");
/// assert!(Relation::Near.is_symmetric() && !Relation::On.is_symmetric());
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize)]
pub struct Edge {
    /// The node at which the relation starts.
    pub from: NodeId,
    /// The kind of relation.
    pub relation: Relation,
    /// The node to which it leads.
    pub to: NodeId,
}

impl Edge {
    /// The edge `from -relation-> to`.
    pub fn new(from: NodeId, relation: Relation, to: NodeId) -> Self {
        Self { from, relation, to }
    }

    /// The edge; of a symmetric one that from the smaller number.
    pub(crate) fn in_one_direction(self) -> Self {
        if self.relation.is_symmetric() && self.to < self.from { self.reversed() } else { self }
    }

    /// The same edge in the opposite direction.
    pub(crate) fn reversed(self) -> Self {
        Self { from: self.to, relation: self.relation, to: self.from }
    }
}

impl std::fmt::Display for Edge {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} {} {}", self.from, self.relation.as_str(), self.to)
    }
}

/// The placement of an object: a relation and the node that it rests on or in, or that holds or wears it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize)]
pub struct Place {
    /// On, inside, worn by, sitting on, lying on, or held in one of the hands.
    pub relation: Relation,
    /// The support, container, holder or wearer.
    pub at: NodeId,
}
