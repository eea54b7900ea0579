//! Plans, and how far they reach.

use vc_graph::Action;

use crate::open_condition::OpenCondition;

/// How far ahead to plan.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Horizon {
    /// Until the next subgoal is met: enough to know what to do now.
    NextSubgoal,
    /// Until the goal is met.
    Goal,
}

/// What to do, in order. Empty when the goal is known to hold.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Plan {
    /// The actions.
    pub actions: Vec<Action>,
    /// What each stretch of them is for, with how many actions it has; only regression
    /// says so.
    pub wants: Vec<(OpenCondition, usize)>,
    /// No plan of the packed problem is shorter. Where the goal has parts beyond it,
    /// nothing is proved.
    pub proved: bool,
}
