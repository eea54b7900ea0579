//! Undo of the motions of bodies.
//!
//! Copying all bodies before each action, in case it fails, would cost more than most actions do. Therefore one
//! copy is kept for several actions; when one fails, the actions before it are replayed from the copy, and
//! bodies move again exactly as before, bit for bit.

use std::sync::Arc;

use vc_physics::{Floor, PhysicsWorld};

use super::Start;
use super::execute::Execution;
use super::settle::come_to_rest;
use super::step::Step;

/// The largest number of actions that are replayed.
const KEPT: usize = 8;

/// A copy of the bodies from some actions ago, and the actions done since.
#[derive(Clone, Default)]
pub(super) struct Undo {
    kept: Option<Arc<PhysicsWorld>>,
    since: Vec<Step>,
}

impl Undo {
    /// Makes sure that the bodies can be brought back to their present state.
    pub(super) fn keep(&mut self, world: &PhysicsWorld) {
        if self.kept.is_none() || self.since.len() >= KEPT {
            (self.kept, self.since) = (Some(Arc::new(world.clone())), Vec::new());
        }
    }

    /// Records an action that was done.
    pub(super) fn push(&mut self, step: Step) {
        self.since.push(step);
    }

    /// Brings the bodies back to their state after the last recorded action.
    pub(super) fn take_back(&self, world: &mut PhysicsWorld, floor: &mut Floor, start: &Start) {
        let Some(kept) = &self.kept else { return };
        *world = PhysicsWorld::clone(kept);
        for step in &self.since {
            // The action was done before, so it can be done again.
            drop(Execution::new(world, floor, start, step).all());
            come_to_rest(world);
        }
    }
}
