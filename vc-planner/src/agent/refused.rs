//! An agent learns from each refusal: it does not try a refused action again while nothing has changed, and after
//! three refusals not at all.

use std::iter::once;

use vc_graph::{Action, Digest, NodeId, Observation, Property, Relation, Verb, rule};

use super::stages::ConstraintViolation;
use super::{Agent, Decision, Mind};
use crate::Plan;
use crate::compile::{anchor, is_ground};
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
    fn last(&self, action: &Action) -> Option<&Refusal> {
        self.all.iter().find(|refusal| refusal.action == *action)
    }

    fn times(&self, action: &Action) -> usize {
        self.last(action).map_or(0, |refusal| refusal.times)
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
            if let Some(ConstraintViolation { why, action }) = self.breach(&plan.actions) {
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
            // It was decided on, and not tried again.
            self.tried.pop();
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
        let refusal = self.refused.last(action);
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

    /// Plans to open elsewhere what bodies could not open in its place, as a box in a wardrobe has no room for its lid:
    /// to take it out, to put it down on a surface of the room or on the floor, and to open it there. Whether the rule
    /// allows it; the thesis's agent keeps no plan.
    pub(crate) fn open_elsewhere(&mut self, action: &Action) -> bool {
        if self.mind == Mind::Faithful {
            return false;
        }
        let graph = self.belief.graph();
        let shut_in = |id: &NodeId| graph.place(*id).is_some_and(|place| place.relation == Relation::Inside);
        let Some(id) = action.object.filter(|id| action.verb == Verb::Open && shut_in(id)) else { return false };
        let on = |at| vec![Action::one(Verb::Walk, at), Action::two(Verb::Place, id, at)];
        let downs = self.surfaces_here().into_iter().map(on).chain(once(vec![Action::one(Verb::Drop, id)]));
        let plans = downs.map(|down| [vec![Action::one(Verb::Grab, id)], down, vec![*action]].concat());
        let Some(plan) = plans.into_iter().find(|plan| self.is_allowed(plan)) else { return false };
        self.next = plan.into();
        self.tried.clear();
        true
    }

    /// The surfaces that stay in the agent's room and are no seats or beds, in the order of their numbers.
    fn surfaces_here(&self) -> Vec<NodeId> {
        let graph = self.belief.graph();
        let soft = [Property::Graspable, Property::Sittable, Property::Lieable];
        let stays = |n: &vc_graph::Node| n.affords(Property::Surface) && !soft.iter().any(|p| n.affords(*p));
        let fits = |id: &NodeId| !is_ground(graph, *id) && graph.node(*id).is_some_and(stays);
        graph.room_of(self.id).into_iter().flat_map(|room| graph.in_room(room)).filter(fits).collect()
    }

    /// Whether the rule allows a plan from the state that the agent believes in.
    fn is_allowed(&self, plan: &[Action]) -> bool {
        let mut graph = self.belief.graph().clone();
        plan.iter().all(|action| rule::step(&mut graph, self.id, action).is_ok())
    }
}
