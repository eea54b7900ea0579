//! The shortest plan by brute force through the transition rule.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use std::collections::HashSet;

use vc_graph::goal::Situation;
use vc_graph::{Action, Event, Goal, NodeId, SceneGraph, Simulator, rule};

/// The search problem.
pub(crate) struct World<'a> {
    pub(crate) scene: &'a SceneGraph,
    pub(crate) me: NodeId,
    /// All allowed actions.
    pub(crate) actions: &'a [Action],
    /// The part of the history that the goal mentions: the rest is forgotten.
    pub(crate) remembered: &'a dyn Fn(&[Event]) -> Vec<Action>,
}

/// The length of the shortest plan, if it is below a limit and few enough states are visited; `Err` if there
/// were too many states.
pub(crate) fn shortest(world: &World<'_>, goal: &Goal, below: usize, most: usize) -> Result<Option<usize>, ()> {
    let me = world.me;
    let mut level = vec![Simulator::new(world.scene.clone())];
    let mut met = HashSet::new();
    for length in 0..below {
        let mut next = Vec::new();
        for state in &level {
            if goal.holds(&Situation::new(state.graph(), me, state.history())) {
                return Ok(Some(length));
            }
            for action in world.actions.iter().filter(|a| rule::refusals(state.graph(), me, a).is_empty()) {
                let mut after = state.clone();
                after.step(me, action).unwrap();
                if met.insert((after.graph().digest(), (world.remembered)(after.history().events()))) {
                    next.push(after);
                }
            }
            if met.len() > most {
                return Err(());
            }
        }
        level = next;
    }
    Ok(None)
}
