//! Evaluation of predicates in a single situation.

use super::{Predicate, Term};
use crate::{Edge, Event, History, NodeId, Relation, SceneGraph, State};

/// The data by which a goal is evaluated: the scene, the agent, and the past actions. See
/// [`EpisodeTrace`](super::EpisodeTrace) for goals about earlier states.
///
/// ```
/// use vc_graph::goal::Situation;
/// use vc_graph::{Draft, Goal, History, SceneBuilder};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let graph = scene.build();
/// let history = History::default();
/// let now = Situation::new(&graph, me, &history);
/// assert!("On(apple, kitchen_table)".parse::<Goal>()?.holds(&now));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Situation<'a> {
    /// The current scene.
    pub graph: &'a SceneGraph,
    /// The agent that `me` refers to.
    pub agent: NodeId,
    /// The past actions, oldest first.
    pub events: &'a [Event],
}

/// The objects chosen for the terms of a literal; `None` if there is no such term.
pub type BoundObjects = [Option<NodeId>; 2];

impl<'a> Situation<'a> {
    /// The situation of an agent in a scene.
    pub fn new(graph: &'a SceneGraph, agent: NodeId, history: &'a History) -> Self {
        Self { graph, agent, events: history.events() }
    }

    /// The nodes that a term can refer to.
    pub fn candidates(&self, term: &Term) -> Vec<NodeId> {
        match term {
            Term::Class(class) => self.graph.of_class(class),
            Term::Node(_, id) => vec![*id],
            Term::Me => vec![self.agent],
            Term::Anything => self.graph.nodes().map(crate::Node::id).collect(),
            Term::Variable(_) => Vec::new(),
        }
    }

    /// Whether a predicate holds for some objects. For past actions, `None` stands for any object.
    pub fn holds(&self, predicate: Predicate, things: BoundObjects) -> bool {
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

/// Whether a relation holds in the sense of goals.
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

/// Whether the contents of a container are of a node's class.
fn holds_liquid(graph: &SceneGraph, from: NodeId, to: NodeId) -> bool {
    let (Some(vessel), Some(liquid)) = (graph.node(from), graph.node(to)) else { return false };
    vessel.contents().is_some_and(|class| class == liquid.class())
}

/// Whether an object is on or in something that is inside `to`.
fn within(graph: &SceneGraph, from: NodeId, to: NodeId) -> bool {
    let chain = graph.support_chain(from);
    chain.contains(&to) && chain.iter().any(|&id| graph.has(Edge::new(id, Relation::Inside, to)))
}
