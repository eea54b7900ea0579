//! What a body does one after the other in the course of an action.

use nalgebra::{Point2, Vector3};
use vc_graph::{Action, Effect, NodeId, Pose};
use vc_physics::Hand;

/// One thing a body does. An action at once does them all; an action in time shows them.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum BodyMotion {
    /// Walks along points, doors on the way opened and closed in passing, to a pose.
    Walk { points: Vec<Point2<f32>>, doors: Vec<NodeId>, feet: Pose, run: bool },
    /// Turns on the spot.
    Turn(Pose),
    /// Takes a thing into a hand.
    Take(Hand, NodeId),
    /// Things that nobody touches are held where they are: they would fall.
    Steady(Vec<NodeId>),
    /// Folds up cloth that a hand holds, to another scale.
    Fold(NodeId, Vector3<f32>),
    /// Moves doors and drawers out of the way: which part of what, and how far open it is then.
    Nudge(Vec<(NodeId, usize, f32)>),
    /// Pushes things together, to these poses.
    Push(Vec<(NodeId, Pose)>),
    /// Puts down what a hand holds.
    Put(Put),
    /// Lets go of what a hand holds.
    LetGo(Hand),
    /// Moves doors, lids, drawers.
    Drive(Drive),
    /// Sits or lies down.
    Rest(NodeId, bool),
    /// Gets up to a pose.
    GetUp(Pose),
    /// Puts on a thing.
    Dress(NodeId),
    /// Takes a thing off, into a hand.
    Undress(Hand, NodeId),
    /// Does an action of which no body knows more than how it looks, for so many seconds.
    Gesture(Action, f32),
}

/// What a hand puts down, and where.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Put {
    pub(super) hand: Hand,
    pub(super) id: NodeId,
    pub(super) pose: Pose,
    /// Whether it would not stay there by itself and is held still.
    pub(super) balanced: bool,
    /// Where it is held as it was at the start, as it would overlap something.
    pub(super) tight: Option<NodeId>,
}

/// How the parts of a thing are moved.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Drive {
    pub(super) id: NodeId,
    /// To which fraction of their way, 1 open.
    pub(super) open: f32,
    /// Whether something is in the way, so that it takes force.
    pub(super) pushes: bool,
    /// How far open each part is in the end.
    pub(super) end: Vec<f32>,
}

/// What a body does in an action, and what becomes of it by the rule.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Course {
    pub(super) beats: Vec<BodyMotion>,
    /// Each effect, and the number of the beat with which it comes true; with the last one where
    /// there is none of its own.
    pub(super) effects: Vec<(Option<usize>, Effect<NodeId>)>,
}

impl Course {
    pub(super) fn push(&mut self, beat: BodyMotion) {
        self.beats.push(beat);
    }

    /// The thing that was put down last, if it would not stay where it was put.
    pub(super) fn balanced(&self) -> Option<NodeId> {
        self.beats.iter().rev().find_map(|beat| match beat {
            BodyMotion::Put(put) if put.balanced => Some(put.id),
            _ => None,
        })
    }
}
