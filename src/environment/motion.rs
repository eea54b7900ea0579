//! Motions: the parts of an action that bodies do.

use nalgebra::{Point2, Vector3};
use serde::{Deserialize, Serialize};
use vc_graph::{Action, NodeId, Pose, Side};
use vc_physics::Hand;

/// A motion of a body. An action is a sequence of them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) enum BodyMotion {
    /// Walks along points, doors on the way opened and closed in passing, to a pose.
    Walk { points: Vec<Point2<f32>>, doors: Vec<NodeId>, feet: Pose, run: bool },
    /// Walks out of somebody's way.
    StepAside { points: Vec<Point2<f32>>, doors: Vec<NodeId>, feet: Pose },
    /// Turns on the spot.
    Turn(Pose),
    /// Takes a thing into a hand, perhaps by a side.
    Take(Hand, NodeId, Option<Side>),
    /// Folds up cloth that a hand holds, to another scale.
    Fold(NodeId, Vector3<f32>),
    /// Moves doors and drawers out of the way: which part of what, and how far open it is then.
    Nudge(Vec<(NodeId, usize, f32)>),
    /// Pushes things together, to these poses.
    Push(Vec<(NodeId, Pose)>),
    /// Puts down what a hand holds.
    Put(Put),
    /// Puts what was put down elsewhere; held still there if it would not stay.
    PutAgain(NodeId, Pose, bool),
    /// Takes what was put down out of the way, and those around it to where they were.
    ClearAway(NodeId, Vec<(NodeId, Pose)>),
    /// Takes what was pushed together back to where it rested.
    PutBack(Vec<(NodeId, Pose)>),
    /// Waits until what was disturbed rests.
    ComeToRest,
    /// Fills a vessel to a share.
    Fill(NodeId, f32),
    /// Lets go of what a hand holds.
    LetGo(Hand),
    /// Moves doors, lids, drawers.
    Drive(Drive),
    /// Sits or lies down, perhaps on one of the seats, counted from 0.
    Rest(NodeId, bool, Option<u32>),
    /// Gets up to a pose.
    GetUp(Pose),
    /// Puts on a thing.
    Dress(NodeId),
    /// Takes a thing off, into a hand.
    Undress(Hand, NodeId),
    /// Does an action of which no body knows more than how it looks, for so many seconds.
    Gesture(Action, f32),
}

/// A thing that a hand puts down, and the pose it gets.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) struct Put {
    pub(super) hand: Hand,
    pub(super) id: NodeId,
    pub(super) pose: Pose,
    /// Whether it would not stay there by itself and is held still.
    pub(super) balanced: bool,
    /// Where it is held as it was at the start, as it would overlap something.
    pub(super) tight: Option<NodeId>,
    /// The thing in a hand with which it is carried from then on.
    pub(super) with: Option<NodeId>,
}

/// How the parts of a thing are moved.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Drive {
    pub(super) id: NodeId,
    /// To which fraction of their way, 1 open.
    pub(super) open: f32,
    /// Whether something is in the way, so that it takes force.
    pub(super) pushes: bool,
}
