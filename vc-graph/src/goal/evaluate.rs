//! One situation, and whether a predicate holds in it.

use super::{Predicate, Term};
use crate::{Edge, Event, History, NodeId, Relation, SceneGraph, State};

/// What a goal is judged by: the scene, who the agent is, what has been done. See
/// [`Trace`](super::Trace) for goals about what was so on the way.
#[derive(Debug, Clone, Copy)]
pub struct Situation<'a> {
    /// The scene as it is.
    pub graph: &'a SceneGraph,
    /// Who `me` is.
    pub agent: NodeId,
    /// What has been done, oldest first.
    pub events: &'a [Event],
}

/// Things chosen for the terms of a literal; unused places are `None`.
pub type Things = [Option<NodeId>; 2];

impl<'a> Situation<'a> {
    /// The situation of an agent in a scene.
    pub fn new(graph: &'a SceneGraph, agent: NodeId, history: &'a History) -> Self {
        Self { graph, agent, events: history.events() }
    }

    /// The nodes a term can mean.
    pub fn candidates(&self, term: &Term) -> Vec<NodeId> {
        match term {
            Term::Class(class) => self.graph.of_class(class),
            Term::Node(_, id) => vec![*id],
            Term::Me => vec![self.agent],
            Term::Anything => self.graph.nodes().map(crate::Node::id).collect(),
            Term::Variable(_) => Vec::new(),
        }
    }

    /// Whether a predicate holds of things. For what was done, `None` stands for
    /// anything.
    pub fn holds(&self, predicate: Predicate, things: Things) -> bool {
        match (predicate, things) {
            (Predicate::State(state), [Some(id), _]) => self.graph.node(id).is_some_and(|n| n.is(state)),
            (Predicate::Real, [Some(id), _]) => self.graph.node(id).is_some_and(|n| !n.is(State::Future)),
            (Predicate::Holds, [Some(agent), Some(id)]) => self.graph.held(agent).any(|h| h == id),
            (Predicate::Relation(relation), [Some(from), Some(to)]) => related(self.graph, from, relation, to),
            (Predicate::Did(verb), [object, target]) => self.events.iter().any(|e| {
                let same = |wanted: Option<NodeId>, was| wanted.is_none() || wanted == was;
                e.agent == self.agent
                    && e.action.verb == verb
                    && same(object, e.action.object)
                    && same(target, e.action.target)
            }),
            _ => false,
        }
    }
}

/// A relation as a goal means it.
fn related(graph: &SceneGraph, from: NodeId, relation: Relation, to: NodeId) -> bool {
    let edge = |relation| graph.has(Edge::new(from, relation, to));
    match relation {
        Relation::On => [Relation::On, Relation::SittingOn, Relation::LyingOn, Relation::WornBy].into_iter().any(edge),
        Relation::Inside | Relation::InRoom if graph.rooms().contains(&to) => {
            from != to && graph.room_of(from) == Some(to)
        }
        Relation::Inside => edge(relation) || edge(Relation::PouredInto) || within(graph, from, to),
        Relation::FilledWith | Relation::Contains => edge(relation) || holds_liquid(graph, from, to),
        Relation::Near if graph.agents().contains(&from) => graph.near(from, to),
        Relation::Facing if graph.agents().contains(&from) => graph.facing(from, to),
        _ => edge(relation),
    }
}

/// Whether what is in a thing to pour is of a node's class.
fn holds_liquid(graph: &SceneGraph, from: NodeId, to: NodeId) -> bool {
    let (Some(vessel), Some(liquid)) = (graph.node(from), graph.node(to)) else { return false };
    vessel.contents().is_some_and(|class| class == liquid.class())
}

/// Whether a thing is on or in something that is inside `to`.
fn within(graph: &SceneGraph, from: NodeId, to: NodeId) -> bool {
    let chain = graph.support_chain(from);
    chain.contains(&to) && chain.iter().any(|&id| graph.has(Edge::new(id, Relation::Inside, to)))
}
