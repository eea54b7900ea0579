//! Cooperation with other agents that pursue the same goal: promises given and received.

use vc_graph::{Action, NodeId, Relation, SceneGraph, Verb};

use super::Agent;
use crate::Plan;
use crate::search_step::SearchStep;
use crate::trip::{Promise, Trip, ends, imagine};

impl Agent {
    /// Takes note of the deliveries that other agents have promised: they count as done, and a plan that
    /// concerns them is dropped.
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

    /// The deliveries that the agent will make on its next trip.
    pub(crate) fn promises(&self) -> &[Promise] {
        &self.promises
    }

    /// The sampled state in which the promises of others are fulfilled.
    pub(super) fn imagined(&self) -> SceneGraph {
        let mut graph = self.belief.graph().clone();
        imagine(&mut graph, &self.counted_on);
        graph
    }

    /// In company, promises the next trip of a plan and commits to it; others may do the rest of the plan.
    pub(super) fn promise(&mut self, plan: &Plan) {
        if !self.planner.in_company {
            return;
        }
        let trip = Trip::new(self.belief.graph(), self.id, &plan.actions);
        let later = plan.actions.len() - trip.length;
        self.next.truncate(self.next.len().saturating_sub(later));
        self.unproved = None;
        trip.promises.into_iter().for_each(|promise| self.promise_one(promise));
    }

    fn promise_one(&mut self, (item, place): Promise) {
        match self.promises.iter_mut().find(|(known, _)| *known == item) {
            // A plan that covers only the next step does not say where things go.
            Some(_) if place.relation == Relation::HoldsRight => {}
            Some((_, known)) => *known = place,
            None => self.promises.push((item, place)),
        }
    }

    /// Keeps only the promises for things that the agent holds or is about to handle.
    pub(super) fn keep_promises(&mut self) {
        let (graph, next) = (self.belief.graph(), &self.next);
        let in_mind = |id| graph.held(self.id).any(|held| held == id) || next.iter().any(|a| a.object == Some(id));
        self.promises.retain(|(item, _)| in_mind(*item));
    }

    /// Promises, during a search, the deliveries of the held things and of the thing that the agent is about to
    /// fetch.
    pub(super) fn promise_found(&mut self, look: Option<SearchStep>, plan: &[Action]) {
        if !self.planner.in_company {
            return;
        }
        let graph = self.belief.graph();
        let mut items: Vec<NodeId> = graph.held(self.id).collect();
        if let Some(SearchStep::Do(Action { verb: Verb::Grab, object, .. })) = look {
            items.extend(object);
        }
        ends(graph, self.id, plan, &items).into_iter().for_each(|promise| self.promise_one(promise));
    }
}
