//! Others that pursue the goal as well: what they promise, and what they are promised.

use vc_graph::{Action, NodeId, Relation, SceneGraph, Verb};

use super::Agent;
use crate::Plan;
use crate::look::Look;
use crate::trip::{Promise, Trip, ends, imagine};

impl Agent {
    /// What others have promised to bring where: that counts as done, and a plan that is
    /// about it is no longer followed.
    pub(crate) fn count_on(&mut self, promised: Vec<Promise>) {
        let ends = |a: &Action| matches!(a.verb, Verb::Close | Verb::SwitchOn | Verb::SwitchOff);
        let clashes = |a: &Action| {
            promised.iter().any(|(item, place)| a.object == Some(*item) || (ends(a) && a.object == Some(place.at)))
        };
        if self.next.iter().any(clashes) {
            self.next.clear();
        }
        self.planner.awaited = promised.iter().map(|(_, place)| place.at).collect();
        self.counted_on = promised;
        self.planner.in_company = true;
    }

    /// What it will bring where on its next trip.
    pub(crate) fn promises(&self) -> &[Promise] {
        &self.promises
    }

    /// The sampled state, with what others have promised done.
    pub(super) fn imagined(&self) -> SceneGraph {
        let mut graph = self.belief.graph().clone();
        imagine(&mut graph, &self.counted_on);
        graph
    }

    /// In company, promises the next trip of a plan and keeps to that: what comes after it
    /// others may do.
    pub(super) fn promise(&mut self, plan: &Plan) {
        if !self.planner.in_company {
            return;
        }
        let trip = Trip::of(self.belief.graph(), self.id, &plan.actions);
        let later = plan.actions.len() - trip.length;
        self.next.truncate(self.next.len().saturating_sub(later));
        self.unproved = None;
        trip.promises.into_iter().for_each(|promise| self.promise_one(promise));
    }

    fn promise_one(&mut self, (item, place): Promise) {
        match self.promises.iter_mut().find(|(known, _)| *known == item) {
            // A plan that is only about what comes next does not say where things go.
            Some(_) if place.relation == Relation::HoldsRight => {}
            Some((_, known)) => *known = place,
            None => self.promises.push((item, place)),
        }
    }

    /// What it holds or goes for is brought where it has said, if nothing else is decided.
    pub(super) fn keep_promises(&mut self) {
        let (graph, next) = (self.belief.graph(), &self.next);
        let in_mind = |id| graph.held(self.id).any(|held| held == id) || next.iter().any(|a| a.object == Some(id));
        self.promises.retain(|(item, _)| in_mind(*item));
    }

    /// Who looks for something goes on to bring what it holds and fetches where it belongs.
    pub(super) fn promise_found(&mut self, look: Option<Look>, plan: &[Action]) {
        if !self.planner.in_company {
            return;
        }
        let graph = self.belief.graph();
        let mut items: Vec<NodeId> = graph.held(self.id).collect();
        if let Some(Look::Do(Action { verb: Verb::Grab, object, .. })) = look {
            items.extend(object);
        }
        ends(graph, self.id, plan, &items).into_iter().for_each(|promise| self.promise_one(promise));
    }
}
