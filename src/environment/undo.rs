//! Taking back what bodies did.
//!
//! To copy all bodies before each action, in case it fails, would cost more than most actions
//! do. So one copy is kept for several actions, and when one fails, those before it are done
//! again from there: bodies do the same again, bit for bit.

use std::sync::Arc;

use vc_graph::{Action, NodeId, SceneGraph};
use vc_physics::{Floor, World};

use super::deed::Deed;
use super::{Start, act};

/// Most actions that are done again.
const KEPT: usize = 8;

/// Bodies as they were some actions ago, and what was done since.
#[derive(Clone, Default)]
pub(super) struct Undo {
    kept: Option<Arc<World>>,
    since: Vec<Step>,
}

/// An action of which the bodies' part can be done again.
#[derive(Clone)]
pub(super) struct Step {
    /// The scene before, and as the rule says it is after.
    pub(super) before: SceneGraph,
    pub(super) after: SceneGraph,
    pub(super) agent: NodeId,
    pub(super) action: Action,
    pub(super) care: Care,
}

/// What is heeded when an action is done again that has failed.
#[derive(Debug, Clone, Default)]
pub(super) struct Care {
    /// What is held still meanwhile: it would fall, though nobody touches it.
    pub(super) steadied: Vec<NodeId>,
    /// Whether doors and drawers are pushed all the way: put where they go, one left behind what it
    /// should have taken along.
    pub(super) pushes: bool,
    /// Whether the agent does not turn to a thing it is near: at the edge of its reach, turning would take
    /// the thing out of reach.
    pub(super) stays: bool,
}

impl Undo {
    /// Makes sure that bodies can come back to where they are.
    pub(super) fn keep(&mut self, world: &World) {
        if self.kept.is_none() || self.since.len() >= KEPT {
            (self.kept, self.since) = (Some(Arc::new(world.clone())), Vec::new());
        }
    }

    /// Remembers an action that was done.
    pub(super) fn push(&mut self, step: Step) {
        self.since.push(step);
    }

    /// Brings bodies back to where they were after the last action that was remembered.
    pub(super) fn take_back(&self, world: &mut World, floor: &mut Floor, start: &Start) {
        let Some(kept) = &self.kept else { return };
        *world = World::clone(kept);
        for step in &self.since {
            let mut deed = Deed::new(world, floor, start, step);
            // It was done before, so it can be done.
            let _ = deed.all(&step.action);
            act::calm(world);
        }
    }
}
