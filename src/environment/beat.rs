//! What a body does one after the other in the course of an action.

use nalgebra::{Point2, Vector3};
use vc_graph::{NodeId, Pose, Verb};
use vc_physics::Hand;

/// One thing a body does. An action at once does them all; an action in time shows them.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Beat {
    /// Walks along points, doors on the way opened and closed in passing, to a pose.
    Walk { points: Vec<Point2<f32>>, doors: Vec<NodeId>, feet: Pose, run: bool },
    /// Turns on the spot.
    Turn(Pose),
    /// Takes a thing into a hand.
    Take(Hand, NodeId),
    /// Folds up cloth that a hand holds, to another scale.
    Fold(NodeId, Vector3<f32>),
    /// Moves doors and drawers out of the way: which part of what, and how far open it is then.
    Nudge(Vec<(NodeId, usize, f32)>),
    /// Pushes things together, to these poses.
    Push(Vec<(NodeId, Pose)>),
    /// Puts down what a hand holds.
    Put(Hand, NodeId, Pose),
    /// Lets go of what a hand holds.
    LetGo(Hand),
    /// Moves doors, lids, drawers to a fraction of their way.
    Drive(NodeId, f32),
    /// Sits or lies down.
    Rest(NodeId, bool),
    /// Gets up.
    GetUp,
    /// Puts on a thing.
    Dress(NodeId),
    /// Takes a thing off, into a hand.
    Undress(Hand, NodeId),
    /// Does something that is only seen, for so many seconds.
    Gesture(Verb, f32),
}
