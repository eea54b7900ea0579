//! Turns a planned action into one that can be done now.

use vc_graph::{Action, Property, Refusal, Relation, State, Verb, rule};

use super::{Agent, Decision};
use crate::Plan;
use crate::compile::anchor;
use crate::expansion::drops_elsewhere;

impl Agent {
    /// Does an action after its prerequisites: a walk, an opening, a free hand.
    pub(super) fn act(&mut self, action: Action, plan: Vec<Action>) -> Decision {
        // A walk that the next action does not need is left out.
        let spared = match plan.as_slice() {
            [walk, then, ..] if walk.verb == Verb::Walk && *walk == action && then.verb != Verb::Walk => {
                let needed = drops_elsewhere(self.belief.graph(), self.id, walk, &[*then]);
                (!needed && self.refusals(then).is_empty()).then_some(*then)
            }
            _ => None,
        };
        let first = spared.or_else(|| self.doable(action));
        match first {
            Some(first) => {
                let rest = if plan.is_empty() { vec![action] } else { plan };
                let actions = if rest.first() == Some(&first) { rest } else { [&[first], rest.as_slice()].concat() };
                Decision::Act(first, Plan { actions, ..Plan::default() })
            }
            None => self.decide_by_regression(),
        }
    }

    pub(super) fn refusals(&self, action: &Action) -> Vec<Refusal> {
        rule::refusals(self.belief.graph(), self.id, action)
    }

    /// Whether an action can be done at once without walking away.
    pub(super) fn is_at_hand(&self, action: &Action) -> bool {
        action.verb != Verb::Walk && self.refusals(action).is_empty()
    }

    /// The action itself if it can be done, otherwise the action that has to be done before it.
    fn doable(&self, mut action: Action) -> Option<Action> {
        for _ in 0..6 {
            let Some(refusal) = self.refusals(&action).into_iter().next() else { return Some(action) };
            action = match refusal {
                Refusal::NotUpright(_) => Action::zero(Verb::Stand),
                Refusal::NotNear { thing, .. } => {
                    // A thing that the belief has in one room, inside something in another room, is not near
                    // the latter.
                    let (graph, at) = (self.belief.graph(), anchor(self.belief.graph(), thing.id));
                    Action::one(Verb::Walk, if graph.near(self.id, at) { thing.id } else { at })
                }
                Refusal::Hidden { inside, .. } => Action::one(Verb::Open, inside.id),
                Refusal::Shut(container) => Action::one(Verb::Open, container.id),
                Refusal::NoFreeHand(_) => self.put_down()?,
                Refusal::InState(thing, State::On) => Action::one(Verb::SwitchOff, thing.id),
                _ => return None,
            };
        }
        None
    }

    /// Frees a hand: puts the held thing on a surface at hand, otherwise on the floor.
    fn put_down(&self) -> Option<Action> {
        let held = self.belief.graph().held(self.id).last()?;
        let graph = self.belief.graph();
        let near = graph.related(self.id, Relation::Near).filter(|id| {
            graph.node(*id).is_some_and(|n| n.affords(Property::Surface) && !n.affords(Property::Graspable))
        });
        let on = near.map(|at| Action::two(Verb::Place, held, at)).find(|a| self.refusals(a).is_empty());
        Some(on.unwrap_or(Action::one(Verb::Drop, held)))
    }
}
