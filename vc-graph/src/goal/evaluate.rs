//! Whether a goal holds, how much of it, and what is missing.

use super::{Goal, Literal, Predicate, Quantified, Term};
use crate::{Edge, Event, History, NodeId, Relation, SceneGraph};

/// What a goal is judged by: the scene, who the agent is, what has been done.
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

/// Variables bound so far, innermost last.
type Bindings<'g> = Vec<(&'g str, NodeId)>;

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
        Relation::Near if graph.agents().contains(&from) => graph.near(from, to),
        Relation::Facing if graph.agents().contains(&from) => graph.facing(from, to),
        _ => edge(relation),
    }
}

/// Whether a thing is on or in something that is inside `to`.
fn within(graph: &SceneGraph, from: NodeId, to: NodeId) -> bool {
    let chain = graph.support_chain(from);
    chain.contains(&to) && chain.iter().any(|&id| graph.has(Edge::new(id, Relation::Inside, to)))
}

impl Goal {
    /// Whether the goal holds.
    ///
    /// ```
    /// use vc_graph::goal::{Goal, Situation};
    /// use vc_graph::{Draft, History, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// scene.add_on(table, Draft::new("apple"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let graph = scene.build();
    /// let history = History::default();
    /// let now = Situation::new(&graph, me, &history);
    /// assert!("On(apple, table)".parse::<Goal>()?.holds(&now));
    /// assert_eq!("On(apple, table), 4".parse::<Goal>()?.score(&now), 0.25);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn holds(&self, now: &Situation<'_>) -> bool {
        self.holds_with(now, &mut Vec::new())
    }

    /// How much of the goal holds, 0 to 1; 1 if and only if it holds. The parts of
    /// a conjunction count alike, a count by how many were found, a disjunction by
    /// its best part.
    pub fn score(&self, now: &Situation<'_>) -> f64 {
        self.score_with(now, &mut Vec::new())
    }

    /// The conjuncts that do not hold.
    pub fn unmet(&self, now: &Situation<'_>) -> Vec<&Goal> {
        self.conjuncts().iter().filter(|part| !part.holds(now)).collect()
    }

    fn holds_with<'g>(&'g self, now: &Situation<'_>, bound: &mut Bindings<'g>) -> bool {
        match self {
            Self::Literal(literal) => literal.count_with(now, bound) > 0,
            Self::Count { literal, comparison, number } => comparison.admits(literal.count_with(now, bound), *number),
            Self::And(parts) => parts.iter().all(|p| p.holds_with(now, bound)),
            Self::Or(parts) => parts.iter().any(|p| p.holds_with(now, bound)),
            Self::Not(part) => !part.holds_with(now, bound),
            Self::ForAll(q) => each(q, now).into_iter().all(|id| q.with(id, bound, |body, b| body.holds_with(now, b))),
            Self::Exists(q) => each(q, now).into_iter().any(|id| q.with(id, bound, |body, b| body.holds_with(now, b))),
            Self::Then(parts) => split_in_order(parts, now, bound).is_some(),
        }
    }

    fn score_with<'g>(&'g self, now: &Situation<'_>, bound: &mut Bindings<'g>) -> f64 {
        if self.holds_with(now, bound) {
            return 1.0;
        }
        let partial = match self {
            Self::Count { literal, comparison: super::Comparison::AtLeast, number } => {
                literal.count_with(now, bound) as f64 / f64::from(*number)
            }
            Self::And(parts) | Self::Then(parts) => mean(parts.iter().map(|p| p.score_with(now, bound))),
            Self::Or(parts) => best(parts.iter().map(|p| p.score_with(now, bound))),
            Self::ForAll(q) => {
                mean(each(q, now).into_iter().map(|id| q.with(id, bound, |body, b| body.score_with(now, b))))
            }
            Self::Exists(q) => {
                best(each(q, now).into_iter().map(|id| q.with(id, bound, |body, b| body.score_with(now, b))))
            }
            Self::Literal(_) | Self::Count { .. } | Self::Not(_) => 0.0,
        };
        // All parts of a `then` may hold and their order not.
        partial.min(1.0 - f64::EPSILON)
    }
}

fn mean(scores: impl Iterator<Item = f64>) -> f64 {
    let (sum, number) = scores.fold((0.0, 0.0), |(sum, number), s| (sum + s, number + 1.0));
    if number > 0.0 { sum / number } else { 1.0 }
}

fn best(scores: impl Iterator<Item = f64>) -> f64 {
    scores.fold(0.0, f64::max)
}

/// The nodes a quantifier ranges over.
fn each(q: &Quantified, now: &Situation<'_>) -> Vec<NodeId> {
    match &q.class {
        Some(class) => now.graph.of_class(class),
        None => now.candidates(&Term::Anything),
    }
}

impl Quantified {
    fn with<'g, T>(
        &'g self,
        id: NodeId,
        bound: &mut Bindings<'g>,
        judge: impl FnOnce(&'g Goal, &mut Bindings<'g>) -> T,
    ) -> T {
        bound.push((&self.variable, id));
        let result = judge(&self.body, bound);
        bound.pop();
        result
    }
}

/// Cuts what was done into one stretch for each part, each as short as can be.
fn split_in_order<'g>(parts: &'g [Goal], now: &Situation<'_>, bound: &mut Bindings<'g>) -> Option<()> {
    let mut start = 0;
    for (index, part) in parts.iter().enumerate() {
        let last = index + 1 == parts.len();
        let ends = if last { now.events.len()..=now.events.len() } else { start..=now.events.len() };
        let fits = |&end: &usize| {
            let stretch = Situation { events: &now.events[start..end], ..*now };
            part.holds_with(&stretch, bound)
        };
        start = ends.into_iter().find(fits)?;
    }
    Some(())
}

impl Literal {
    /// The position of the term a count is about: the first open one.
    pub fn counted(&self) -> Option<usize> {
        self.terms.iter().position(|t| matches!(t, Term::Class(_) | Term::Anything))
    }

    fn count_with(&self, now: &Situation<'_>, bound: &Bindings<'_>) -> usize {
        let counted = self.counted().unwrap_or(0);
        let lists: Vec<Vec<Option<NodeId>>> = self.terms.iter().map(|t| self.choices(t, now, bound)).collect();
        let Some(first) = lists.get(counted) else {
            return usize::from(now.holds(self.predicate, [None, None]));
        };
        let anything = [None];
        let other = lists.get(1 - counted.min(1)).filter(|_| lists.len() > 1);
        let others = other.map_or(&anything[..], Vec::as_slice);
        let holds = |a: Option<NodeId>| {
            others.iter().any(|&b| {
                let things = if counted == 0 { [a, b] } else { [b, a] };
                now.holds(self.predicate, things)
            })
        };
        first.iter().filter(|&&a| holds(a)).count()
    }

    /// The nodes a term can mean; an event's `_` needs no enumeration.
    fn choices(&self, term: &Term, now: &Situation<'_>, bound: &Bindings<'_>) -> Vec<Option<NodeId>> {
        match (term, self.predicate) {
            (Term::Anything, Predicate::Did(_)) => vec![None],
            (Term::Variable(name), _) => {
                bound.iter().rev().find(|(n, _)| n == name).map(|&(_, id)| Some(id)).into_iter().collect()
            }
            _ => now.candidates(term).into_iter().map(Some).collect(),
        }
    }
}
