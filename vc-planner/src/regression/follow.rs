//! Execution of plans that consist of macros.

use vc_graph::goal::Goal;
use vc_graph::{Action, Refusal, Verb, rule};

use super::{ROUNDS, Regression};
use crate::expansion::drops_elsewhere;

impl Regression<'_> {
    /// Executes actions, adds a walk or a rise between them where necessary, and leaves out unnecessary walks.
    /// Stops at the first action that cannot be done and then returns `false`.
    pub(crate) fn follow(&mut self, actions: &[Action]) -> bool {
        let mut next = 0;
        while next < actions.len() {
            let walks = |a: &Action| a.verb == Verb::Walk;
            let stretch = actions[next + 1..].iter().position(walks).map_or(actions.len(), |n| next + 1 + n);
            let mark = self.trail.len();
            let (walk, then) = (&actions[next], &actions[next + 1..stretch]);
            let spared = walks(walk)
                && !then.is_empty()
                && !drops_elsewhere(self.graph, self.agent, walk, then)
                && then.iter().all(|a| self.step(a));
            if !spared {
                self.rewind(mark);
                if !actions[next..stretch].iter().all(|a| self.step_there(a)) {
                    return false;
                }
            }
            next = stretch;
        }
        true
    }

    /// Removes final drops: a thing that has been carried into its target room need not be released at the end.
    pub(crate) fn keep_in_hand(&mut self, goal: &Goal) {
        while let Some(last) = self.events.last().copied().filter(|e| e.action.verb == Verb::Drop) {
            if self.trail.is_empty() {
                return;
            }
            self.rewind(self.trail.len() - 1);
            if !self.holds(goal) {
                self.step(&last.action);
                return;
            }
        }
    }

    /// Does an action; walks up to the thing or rises first if that makes it possible.
    fn step_there(&mut self, action: &Action) -> bool {
        for _ in 0..ROUNDS {
            let refusals = rule::refusals(self.graph, self.agent, action);
            let remedy = match refusals.first() {
                None => return self.step(action),
                Some(Refusal::NotUpright(_)) => Action::zero(Verb::Stand),
                Some(Refusal::NotNear { thing, .. }) => Action::one(Verb::Walk, thing.id),
                Some(_) => return false,
            };
            let stuck = |s: &mut Self| !s.step(&remedy) && !s.step(&Action::zero(Verb::Stand));
            if stuck(self) {
                return false;
            }
        }
        self.step(action)
    }
}
