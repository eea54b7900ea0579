//! Hands, and the things in them.

use serde::{Deserialize, Serialize};
use vc_graph::{NodeId, Pose, Relation};

/// A hand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub enum Hand {
    /// The right one, which is used first.
    Right,
    /// The left one.
    Left,
}

impl Hand {
    /// Both, the right one first.
    pub const BOTH: [Self; 2] = [Self::Right, Self::Left];

    /// The relation of a holder to what this hand holds.
    ///
    /// ```
    /// use vc_physics::Hand;
    /// assert_eq!(Hand::Left.relation(), vc_graph::Relation::HoldsLeft);
    /// ```
    pub fn relation(self) -> Relation {
        match self {
            Self::Right => Relation::HoldsRight,
            Self::Left => Relation::HoldsLeft,
        }
    }

    pub(crate) fn side(self) -> f32 {
        match self {
            Self::Right => -1.0,
            Self::Left => 1.0,
        }
    }
}

/// What a hand holds.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Held {
    pub(crate) id: NodeId,
    /// Where it is against the agent's feet while it stands.
    #[serde(with = "crate::serial::pose")]
    pub(crate) grip: Pose,
    /// What lies on it or in it, and where against it.
    pub(crate) load: Vec<Loaded>,
}

#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Loaded {
    pub(crate) id: NodeId,
    #[serde(with = "crate::serial::pose")]
    pub(crate) at: Pose,
    /// Whether it was pinned there, and is so again when the whole is put down.
    pub(crate) pinned: bool,
}
