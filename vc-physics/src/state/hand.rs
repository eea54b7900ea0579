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

    /// The relation of an agent to the thing in this hand.
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

/// A thing in a hand.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Held {
    pub(crate) id: NodeId,
    /// Its pose relative to the feet of the agent while that stands.
    #[serde(with = "crate::serial::pose")]
    pub(crate) grip: Pose,
    /// The things on it and in it, with their poses relative to it.
    pub(crate) load: Vec<Loaded>,
}

#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Loaded {
    pub(crate) id: NodeId,
    #[serde(with = "crate::serial::pose")]
    pub(crate) at: Pose,
    /// Whether it was pinned there; if so, it is pinned again when the whole is put down.
    pub(crate) pinned: bool,
}
