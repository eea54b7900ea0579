//! An agent learns from each refusal: it does not try a refused action again while nothing has changed, and after
//! three refusals not at all.

use vc_graph::{Action, Digest, NodeId, Observation, Verb};

use super::stages::ContractViolation;
use super::{Agent, Decision};
use crate::Plan;
use crate::compile::anchor;
use crate::open_condition::Unreachable;

/// After so many refusals an action is not tried any more: what looks different each time may fail all the same.
const MOST: usize = 3;
/// How many other decisions are sought in place of one that would be in vain.
const OTHERS: usize = 12;

/// The actions that have been refused, and whether anything has changed since.
#[derive(Debug, Clone, Default)]
pub(super) struct Refused {
    all: Vec<Refusal>,
    /// How often something has changed: an action was done, or an observation differed from the one before.
    changes: usize,
    /// The last observation since something was refused.
    seen: Option<Digest>,
}

#[derive(Debug, Clone)]
struct Refusal {
    action: Action,
    times: usize,
    /// How often something had changed when it was refused last.
    changes: usize,
}

impl Refused {
    fn of(&self, action: &Action) -> Option<&Refusal> {
        self.all.iter().find(|refusal| refusal.action == *action)
    }

    fn times(&self, action: &Action) -> usize {
        self.of(action).map_or(0, |refusal| refusal.times)
    }

    pub(super) fn note(&mut self, action: &Action) {
        let (times, changes) = (self.times(action) + 1, self.changes);
        self.all.retain(|refusal| refusal.action != *action);
        self.all.push(Refusal { action: *action, times, changes });
    }

    pub(super) fn did(&mut self, action: &Action) {
        self.changes += 1;
        self.all.retain(|refusal| refusal.action != *action);
    }

    /// Takes note of what is seen, while there is a refusal that it may explain.
    pub(super) fn see(&mut self, seen: &Observation) {
        let now = (!self.all.is_empty()).then(|| seen.digest());
        self.changes += usize::from(self.seen.is_some() && now != self.seen);
        self.seen = now;
    }
}

impl Agent {
    /// Decides; what would be tried in vain, or breaks what must stay so, is gone about otherwise, and if it cannot be,
    /// given up.
    pub(super) fn think_twice(&mut self) -> Decision {
        let (mut vain, mut breach) = (None, None);
        for _ in 0..OTHERS {
            let (action, plan) = match (self.think_on(), breach.take()) {
                (Decision::Act(action, plan), _) => (action, plan),
                (Decision::GiveUp(_), Some(why)) => return Decision::GiveUp(why),
                (decision, _) => return decision,
            };
            if let Some(ContractViolation { why, action }) = self.breach(&plan.actions) {
                self.forget_plans();
                self.breach = Some(why.clone());
                if !action.is_some_and(|action| self.bar(&action)) {
                    return Decision::GiveUp(why);
                }
                breach = Some(why);
                continue;
            }
            if !self.is_vain(&action) {
                return Decision::Act(action, plan);
            }
            vain = Some(action);
            self.forget_plans();
            if let Some(detour) = self.detour(&action) {
                return detour;
            }
            if !self.bar(&action) {
                break;
            }
        }
        if let Some(why) = breach {
            return Decision::GiveUp(why);
        }
        let action = vain.map_or_else(String::new, |action| action.describe(self.belief.graph()).to_string());
        Decision::GiveUp(Unreachable::Refused(action))
    }

    /// Whether an action was refused and nothing has changed since, or was refused too often.
    fn is_vain(&self, action: &Action) -> bool {
        let refusal = self.refused.of(action);
        refusal.is_some_and(|refusal| refusal.times >= MOST || refusal.changes == self.refused.changes)
    }

    /// Another action first, after which the agent tries the refused one again, as its body may only have failed where
    /// it stood. After two refusals the agent does this only for actions that it can hardly do without.
    fn detour(&mut self, action: &Action) -> Option<Decision> {
        if self.refused.times(action) >= MOST {
            return None;
        }
        let again = self.refused.times(action) > 1;
        let walk = self.way_round(action).filter(|_| !again).map(|at| Action::one(Verb::Walk, at));
        let turn =
            || action.object.or_else(|| self.belief.graph().room_of(self.id)).map(|at| Action::one(Verb::TurnTo, at));
        let needed = matches!(action.verb, Verb::Stand | Verb::Drop | Verb::Walk | Verb::Leave);
        let turn = || turn().filter(|_| !again || needed);
        let fits = |first: &Action| !self.is_vain(first) && self.refusals(first).is_empty();
        let first = walk.filter(fits).or_else(|| turn().filter(fits))?;
        self.next = [*action].into();
        Some(Decision::Act(first, Plan { actions: vec![first, *action], ..Plan::default() }))
    }

    /// Where one goes to try again: up to the thing, or, if that is where one could not go, to its room, or to
    /// something else in the room.
    fn way_round(&self, action: &Action) -> Option<NodeId> {
        let graph = self.belief.graph();
        let at = action.target.or(action.object)?;
        if action.verb != Verb::Walk {
            return Some(anchor(graph, at));
        }
        let room = graph.room_of(at)?;
        if room != at {
            return Some(room);
        }
        graph.in_room(room).find(|&id| id != self.id && self.belief.known().contains(id) && anchor(graph, id) == id)
    }
}
