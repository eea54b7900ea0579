//! Restoring doors and switches to their original states.

use vc_graph::goal::Goal;
use vc_graph::{Condition, NodeId, State};

use super::Regression;
use crate::manners::Touched;
use crate::open_condition::{OpenCondition, Subgoal};

/// Subgoals from this stage on come after tidying up, since an agent that sits cannot walk.
const LAST: u8 = 6;

impl Regression<'_> {
    /// Doors and switches touched before or by this plan that are not in their original state; none for agents
    /// without manners.
    pub(crate) fn amiss(&self) -> Vec<(NodeId, State)> {
        let Some(before) = self.touched else { return Vec::new() };
        let mut touched: Touched = before.clone();
        self.events[self.done_before..].iter().for_each(|event| touched.note(&event.action));
        touched.amiss(self.graph).collect()
    }

    /// Restores one of them when only the last subgoals are open, if the goal is no further off afterwards.
    pub(super) fn put_back(&mut self, goal: &Goal, subgoals: &[Subgoal]) -> Option<(OpenCondition, usize)> {
        self.touched?;
        let last = |s: &Subgoal| s.options.first().is_none_or(|condition| self.view().stage(condition) >= LAST);
        if !subgoals.iter().all(last) {
            return None;
        }
        let mark = self.trail.len();
        for (id, was) in self.amiss() {
            let condition = OpenCondition::Hold(Condition::In(id, was));
            if self.settle(&condition) && self.is_no_further(goal, subgoals.len()) {
                return Some((condition, self.trail.len() - mark));
            }
            self.rewind(mark);
        }
        None
    }

    fn is_no_further(&self, goal: &Goal, open: usize) -> bool {
        match open {
            0 if self.knows_all => self.holds(goal),
            _ => self.view().subgoals(goal).is_ok_and(|now| now.len() <= open),
        }
    }
}
