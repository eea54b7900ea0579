//! An action as it is executed and replayed.

use nalgebra::Point2;
use vc_graph::{Action, NodeId, SceneGraph};

/// An action whose effect on the bodies can be replayed.
#[derive(Clone)]
pub(super) struct Step {
    /// The scene before the action, and the scene that the rule predicts after it.
    pub(super) before: SceneGraph,
    pub(super) after: SceneGraph,
    pub(super) agent: NodeId,
    pub(super) action: Action,
    pub(super) care: RetryOptions,
    /// The spots where others are going to stand.
    pub(super) claims: Vec<Point2<f32>>,
}

/// Precautions for a second attempt at an action that has failed.
#[derive(Debug, Clone, Default)]
pub(super) struct RetryOptions {
    /// Things that are held still meanwhile: they would fall although nobody touches them.
    pub(super) steadied: Vec<NodeId>,
    /// Whether doors and drawers are pushed all the way: setting them to their end position left a thing behind
    /// that should have been carried along.
    pub(super) pushes: bool,
    /// Whether the agent does not turn to a thing it is near: at the edge of its reach, turning would take the
    /// thing out of reach.
    pub(super) stays: bool,
}
