//! Checking an action's preconditions, with or without reasons.

use std::marker::PhantomData;

use crate::node::NodeKind;
use crate::rule::condition::Condition;
use crate::rule::judge::Judge;
use crate::rule::refusal::Refusal;
use crate::{Action, NodeId, Place, Property, Relation, SceneGraph};

/// Whether the agent and the objects of an action exist and are as many as the verb takes.
pub(super) fn check_things(graph: &SceneGraph, agent: NodeId, action: &Action) -> Option<Refusal> {
    let Some(body) = graph.node(agent) else { return Some(Refusal::NoSuchThing(agent)) };
    if body.kind() != NodeKind::Agent {
        return Some(Refusal::NoAgent(body.label()));
    }
    let (verb, takes, given) = (action.verb, action.verb.arity(), action.things().count());
    let Some(rule) = graph.vocabulary().rule(verb) else { return Some(Refusal::NoSuchVerb(verb)) };
    let aims = &rule.aims;
    if takes != given && !(given == 0 && aims.stands_for_object(&action.aim)) {
        return Some(Refusal::Arity { verb, takes, given });
    }
    if !aims.fit(action) {
        return Some(aims.refusal(action));
    }
    if let Some(missing) = action.things().find(|&id| graph.node(id).is_none()) {
        return Some(Refusal::NoSuchThing(missing));
    }
    if let Some(found) = action.called.misnamed(graph, action) {
        return Some(Refusal::Misnamed(found));
    }
    let itself = action.object.filter(|_| action.object == action.target);
    itself.map(|id| Refusal::WithItself(graph.label(id)))
}

/// The reason why a precondition is not met, or a marker instead of it if the caller does not need the reason:
/// formulating a reason costs more than the check.
pub(super) trait Reason: Sized {
    fn because(refusal: impl FnOnce() -> Refusal) -> Self;
}

impl Reason for Refusal {
    fn because(refusal: impl FnOnce() -> Refusal) -> Self {
        refusal()
    }
}

/// An unmet precondition without a reason.
pub(super) struct NoReason;

impl Reason for NoReason {
    fn because(_: impl FnOnce() -> Refusal) -> Self {
        Self
    }
}

impl Condition {
    /// Whether the condition holds for an agent. Costs less than [`Condition::check`], since no reason is
    /// formulated.
    pub fn holds(&self, graph: &SceneGraph, agent: NodeId) -> bool {
        self.judged::<NoReason>(graph, agent).is_ok()
    }

    /// Checks whether the condition holds for an agent.
    ///
    /// ```
    /// use vc_graph::rule;
    /// use vc_graph::{Condition, Draft, Refusal, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let milk = scene.add_in(fridge, Draft::new("milk"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let graph = scene.build();
    /// let open = rule::preconditions(graph.vocabulary(), &"open fridge.2".parse()?).into_iter().find(|c| matches!(c, Condition::Near(_)));
    /// assert!(open.ok_or("no such condition")?.check(&graph, me).is_err(), "the agent has not walked there");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// The [`Refusal`] of an action with this precondition.
    pub fn check(&self, graph: &SceneGraph, agent: NodeId) -> Result<(), Refusal> {
        self.judged(graph, agent)
    }

    fn judged<W: Reason>(&self, graph: &SceneGraph, agent: NodeId) -> Result<(), W> {
        let body = graph.node(agent).ok_or_else(|| W::because(|| Refusal::NoSuchThing(agent)))?;
        Judge { graph, agent, body, reason: PhantomData }.judge(self)
    }
}

/// A checker of an agent's preconditions without reasons; `None` if the node is not an agent of the scene.
pub(super) fn judge_of(graph: &SceneGraph, agent: NodeId) -> Option<Judge<'_, NoReason>> {
    let body = graph.node(agent).filter(|body| body.kind() == NodeKind::Agent)?;
    Some(Judge { graph, agent, body, reason: PhantomData })
}

impl Judge<'_, NoReason> {
    pub(super) fn meets(&self, need: &Condition) -> bool {
        self.judge(need).is_ok()
    }
}

/// The vehicle that an agent is in.
pub(super) fn vehicle_of(graph: &SceneGraph, agent: NodeId) -> Option<NodeId> {
    let drivable = |id: &NodeId| graph.node(*id).is_some_and(|n| n.affords(Property::Drivable));
    graph.related(agent, Relation::Inside).find(drivable)
}

/// The place from which a held object was taken.
pub(super) fn origin(graph: &SceneGraph, id: NodeId) -> Option<Place> {
    let off = graph.related(id, Relation::TakenOff).next().map(|at| Place { relation: Relation::On, at });
    off.or_else(|| graph.related(id, Relation::TakenOut).next().map(|at| Place { relation: Relation::Inside, at }))
}
