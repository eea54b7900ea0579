//! An action as the planner needs to know it.

use nalgebra::Point2;
use vc_graph::{Action, NodeId, SceneGraph};

/// An action that is planned.
#[derive(Clone)]
pub(in crate::environment) struct Step {
    /// The scene before the action, and the scene that the rule predicts after it.
    pub(in crate::environment) before: SceneGraph,
    pub(in crate::environment) after: SceneGraph,
    pub(in crate::environment) agent: NodeId,
    pub(in crate::environment) action: Action,
    /// Whether doors and drawers are pushed all the way: setting them to their end position left a thing behind
    /// that should have been carried along.
    pub(in crate::environment) pushes: bool,
    /// The spots where others are going to stand.
    pub(in crate::environment) claims: Vec<Point2<f32>>,
}
