//! Undo of the motions of bodies.
//!
//! Copying all bodies before each action, in case it fails, would cost more than most actions do. Therefore one
//! copy is kept for several actions; when one fails, the actions before it are replayed from the copy, and
//! bodies move again exactly as before, bit for bit.

use std::sync::Arc;

use vc_graph::{Action, NodeId, SceneGraph};
use vc_physics::{Floor, World};

use super::deed::Deed;
use super::{Start, act};

/// The largest number of actions that are replayed.
const KEPT: usize = 8;

/// A copy of the bodies from some actions ago, and the actions done since.
#[derive(Clone, Default)]
pub(super) struct Undo {
    kept: Option<Arc<World>>,
    since: Vec<Step>,
}

/// An action whose effect on the bodies can be replayed.
#[derive(Clone)]
pub(super) struct Step {
    /// The scene before the action, and the scene that the rule predicts after it.
    pub(super) before: SceneGraph,
    pub(super) after: SceneGraph,
    pub(super) agent: NodeId,
    pub(super) action: Action,
    pub(super) care: Care,
}

/// Precautions for a second attempt at an action that has failed.
#[derive(Debug, Clone, Default)]
pub(super) struct Care {
    /// Things that are held still meanwhile: they would fall although nobody touches them.
    pub(super) steadied: Vec<NodeId>,
    /// Whether doors and drawers are pushed all the way: setting them to their end position left a thing behind
    /// that should have been carried along.
    pub(super) pushes: bool,
    /// Whether the agent does not turn to a thing it is near: at the edge of its reach, turning would take the
    /// thing out of reach.
    pub(super) stays: bool,
}

impl Undo {
    /// Makes sure that the bodies can be brought back to their present state.
    pub(super) fn keep(&mut self, world: &World) {
        if self.kept.is_none() || self.since.len() >= KEPT {
            (self.kept, self.since) = (Some(Arc::new(world.clone())), Vec::new());
        }
    }

    /// Records an action that was done.
    pub(super) fn push(&mut self, step: Step) {
        self.since.push(step);
    }

    /// Brings the bodies back to their state after the last recorded action.
    pub(super) fn take_back(&self, world: &mut World, floor: &mut Floor, start: &Start) {
        let Some(kept) = &self.kept else { return };
        *world = World::clone(kept);
        for step in &self.since {
            let mut deed = Deed::new(world, floor, start, step);
            // The action was done before, so it can be done again.
            let _ = deed.all(&step.action);
            act::calm(world);
        }
    }
}
