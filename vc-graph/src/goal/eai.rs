//! The verdict of the Embodied Agent Interface's evaluator on its formulas, beside VirtualCity's.
//!
//! | | [`Goal::holds_on`] | [`Goal::eai_verdict`] |
//! |---|---|---|
//! | a formula without `then` | holds at the end | holds at some step, all of it at the same |
//! | an action | was performed at some step | is performed at the step after the state in which the rest of the formula holds |
//! | `a then b` | `a` holds at the end of some stretch, `b` at the end of the remaining steps | `b` holds at some step after the first at which `a` does |
//! | a `then` in brackets before another `then` | gets its stretch like any part | takes up all remaining steps: nothing after it ever holds |
//! | `not` | the part does not hold at the end | it fails at some step; for a `then`, it holds nowhere |
//! | `forn` | counts at the end | counts at some single step; for a `then`, over all steps |
//! | `and` of parts with and without `then` | like any other `and` | has no verdict |
//! | `ONTOP`, `INSIDE`, `NEXT_TO`, `FACING` | as in goals: also through other objects, by poses | the exact edge is in the graph |
//!
//! Hence for that evaluator it suffices that a state held at some time, even if it no longer does, whereas
//! [`Goal::holds_on`] requires it at the end. Only that evaluator relates an action to the state in which it
//! begins; for [`Goal::holds_on`] it may have been performed at any time.

use std::borrow::Cow;

use super::{Comparison, EpisodeTrace, Goal, Literal, Predicate, Quantified, Term};
use crate::{Edge, NodeId, Relation, SceneGraph};

/// The reason why the Embodied Agent Interface gives no verdict on a goal.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NoVerdict {
    /// The goal is of a kind that is not among its formulas.
    #[error("`{0}`: its formulas have and, or, not, imply, then, forall, exists and forn over literals")]
    NoFormula(String),
    /// A part with `then` and one without are joined by `and` or `imply`.
    #[error("`{0}`: its formulas do not join a part with `then` and one without by `and` or `imply`")]
    Mixed(String),
    /// Its evaluator leaves the trajectory: it evaluates a quantifier over a part with `then` when no step is left,
    /// or the part after a `not` of such a part.
    #[error("`{0}`: its evaluator leaves the trajectory")]
    Ended(String),
}

type Verdict<T> = Result<T, NoVerdict>;

impl Goal {
    /// The verdict of the Embodied Agent Interface's evaluator on a trace; the module [`eai`](self) lists the
    /// differences from [`Goal::holds_on`].
    ///
    /// ```
    /// use vc_graph::goal::{Goal, EpisodeTrace};
    /// use vc_graph::{Draft, Event, SceneBuilder, Simulator};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let mut world = Simulator::new(scene.build());
    /// let mut trace = EpisodeTrace::new(world.graph().clone(), me);
    /// for line in ["walk fridge.2", "open fridge.2", "close fridge.2"] {
    ///     let action = line.parse()?;
    ///     world.step(me, &action).map_err(|refusals| refusals[0].clone())?;
    ///     trace.push(world.graph().clone(), [Event { agent: me, action }]);
    /// }
    /// let opened = Goal::from_eai("OPEN(fridge.2)")?;
    /// // It was open on the way, but at the end it is not.
    /// assert_eq!((opened.eai_verdict(&trace)?, opened.holds_on(&trace)), (true, false));
    /// let twice = Goal::from_eai("OPEN(fridge.2) then CLOSED(fridge.2) then OPEN(fridge.2)")?;
    /// assert!(!twice.eai_verdict(&trace)?);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`NoVerdict`] where its evaluator stops with an error, and for goals that are not among its formulas.
    pub fn eai_verdict(&self, trace: &EpisodeTrace) -> Result<bool, NoVerdict> {
        let goal = trace.graph(0).map_or(Cow::Borrowed(self), |graph| self.expanded(graph.vocabulary()));
        Ok(Evaluator { trace, bound: Vec::new() }.after(&goal, 0)?.is_some())
    }

    /// Whether a goal concerns a single step.
    fn is_of_one_step(&self) -> Verdict<bool> {
        let parts = self.parts().into_iter().map(Self::is_of_one_step).collect::<Verdict<Vec<bool>>>()?;
        let (all, any) = (parts.iter().all(|p| *p), parts.iter().any(|p| *p));
        match self {
            Self::Literal(_) => Ok(true),
            Self::And(_) if all || !any => Ok(all),
            Self::Imply(..) if all => Ok(true),
            Self::And(_) | Self::Imply(..) => Err(NoVerdict::Mixed(self.to_string())),
            Self::Or(_) | Self::Not(_) | Self::ForAll(_) | Self::Exists(_) => Ok(all),
            Self::ForN { comparison: Comparison::Exactly, .. } => Ok(all),
            Self::Then(_) => Ok(false),
            _ => Err(NoVerdict::NoFormula(self.to_string())),
        }
    }
}

/// The number of steps after which a part was found to hold, counted from the start of the search; `None` if it
/// holds nowhere. For the negation of such a part, and for an empty conjunction, it is -1.
type Found = Option<i64>;

/// A goal with the value of a variable in it.
type Part<'g> = (Option<(&'g str, NodeId)>, &'g Goal);

/// The number of steps that `forn` of zero objects reports, since its part holds nowhere.
const NOWHERE: i64 = 1_000_000_000;

struct Evaluator<'g, 'a> {
    trace: &'a EpisodeTrace,
    bound: Vec<(&'g str, NodeId)>,
}

impl<'g> Evaluator<'g, '_> {
    /// The number of steps of the trace from `from` on, the end included.
    fn left(&self, from: usize) -> usize {
        (self.trace.steps() + 1).saturating_sub(from)
    }

    /// Whether a goal holds on the remaining steps from `from` on, and after how many steps.
    fn after(&mut self, goal: &'g Goal, from: usize) -> Verdict<Found> {
        if goal.is_of_one_step()? {
            let step = (from..=self.trace.steps()).find(|&step| self.at(goal, step));
            return Ok(step.map(|step| (step - from + 1) as i64));
        }
        match goal {
            Goal::And(parts) => self.all(parts.iter().map(|part| (None, part)), from),
            Goal::Or(parts) => self.any(parts.iter().map(|part| (None, part)), from),
            Goal::Not(part) => Ok(if self.after(part, from)?.is_some() { None } else { Some(-1) }),
            Goal::ForAll(q) => self.all(self.choices(goal, q, from)?, from),
            Goal::Exists(q) => self.any(self.choices(goal, q, from)?, from),
            Goal::ForN { number, of, .. } => {
                let found: Vec<i64> = self.each(self.choices(goal, of, from)?, from)?.into_iter().flatten().collect();
                let first = found.iter().copied().min().unwrap_or(NOWHERE);
                Ok((found.len() == *number as usize).then_some(first))
            }
            Goal::Then(parts) => self.in_order(goal, parts, from),
            _ => Err(NoVerdict::NoFormula(goal.to_string())),
        }
    }

    fn each<I>(&mut self, parts: I, from: usize) -> Verdict<Vec<Found>>
    where
        I: IntoIterator<Item = Part<'g>>,
    {
        let judge = |(variable, part): Part<'g>| {
            let outer = self.bound.len();
            self.bound.extend(variable);
            let found = self.after(part, from);
            self.bound.truncate(outer);
            found
        };
        parts.into_iter().map(judge).collect()
    }

    /// The earliest part to hold, unless it is at [`NOWHERE`].
    fn any<I>(&mut self, parts: I, from: usize) -> Verdict<Found>
    where
        I: IntoIterator<Item = Part<'g>>,
    {
        Ok(self.each(parts, from)?.into_iter().flatten().min().filter(|first| *first < NOWHERE))
    }

    fn all<I>(&mut self, parts: I, from: usize) -> Verdict<Found>
    where
        I: IntoIterator<Item = Part<'g>>,
    {
        let found: Option<Vec<i64>> = self.each(parts, from)?.into_iter().collect();
        Ok(found.map(|found| found.into_iter().max().unwrap_or(-1)))
    }

    /// The quantifier ranges over the objects at the first remaining step.
    fn choices(&self, goal: &Goal, q: &'g Quantified, from: usize) -> Verdict<Vec<Part<'g>>> {
        let graph = self.trace.graph(from).ok_or_else(|| NoVerdict::Ended(goal.to_string()))?;
        Ok(range(graph, q).into_iter().map(|id| (Some((&*q.variable, id)), &*q.body)).collect())
    }

    /// The parts in order; together they use up all remaining steps.
    fn in_order(&mut self, goal: &'g Goal, parts: &'g [Goal], from: usize) -> Verdict<Found> {
        let mut used = 0;
        for part in parts {
            match self.after(part, self.skip(goal, from, used)?)? {
                Some(more) => used += more,
                None => return Ok(None),
            }
        }
        Ok(Some(self.left(from) as i64))
    }

    /// The step `used` steps after `from`. A negative number is valid only if it covers all remaining steps.
    fn skip(&self, goal: &Goal, from: usize, used: i64) -> Verdict<usize> {
        let left = self.left(from) as i64;
        match used {
            0.. => Ok(from + used.min(left) as usize),
            _ if -used >= left => Ok(from),
            _ => Err(NoVerdict::Ended(goal.to_string())),
        }
    }

    /// Whether a goal about a single step holds at `step`.
    fn at(&mut self, goal: &'g Goal, step: usize) -> bool {
        match goal {
            Goal::Literal(literal) => self.literal(literal, step),
            Goal::And(parts) => parts.iter().all(|part| self.at(part, step)),
            Goal::Or(parts) => parts.iter().any(|part| self.at(part, step)),
            Goal::Not(part) => !self.at(part, step),
            Goal::Imply(condition, part) => !self.at(condition, step) || self.at(part, step),
            Goal::ForAll(q) => self.number(q, step) == self.range_at(q, step).len(),
            Goal::Exists(q) => self.number(q, step) > 0,
            Goal::ForN { number, of, .. } => self.number(of, step) == *number as usize,
            _ => false,
        }
    }

    fn range_at(&self, q: &Quantified, step: usize) -> Vec<NodeId> {
        self.trace.graph(step).map_or_else(Vec::new, |graph| range(graph, q))
    }

    fn number(&mut self, q: &'g Quantified, step: usize) -> usize {
        let mut number = 0;
        for id in self.range_at(q, step) {
            self.bound.push((&q.variable, id));
            number += usize::from(self.at(&q.body, step));
            self.bound.pop();
        }
        number
    }

    fn literal(&self, literal: &Literal, step: usize) -> bool {
        let Some(graph) = self.trace.graph(step) else { return false };
        let things: Option<Vec<NodeId>> = literal.terms.iter().map(|term| self.meant(graph, term)).collect();
        match (literal.predicate, things.as_deref()) {
            (Predicate::State(state), Some([id])) => graph.node(*id).is_some_and(|n| n.is(state)),
            (Predicate::Relation(relation), Some([from, to])) => is_edge(graph, *from, relation, *to),
            (Predicate::Did(verb), Some(things)) => self
                .trace
                .events(step + 1)
                .iter()
                .any(|event| event.action.verb == verb && event.action.things().eq(things.iter().copied())),
            _ => false,
        }
    }

    /// The object that a term names; a class alone names none.
    fn meant(&self, graph: &SceneGraph, term: &Term) -> Option<NodeId> {
        match term {
            Term::Me => Some(self.trace.agent()),
            Term::Variable(name) => self.bound.iter().rev().find(|(bound, _)| bound == name).map(|&(_, id)| id),
            Term::Node(None, id) => Some(*id),
            Term::Node(Some(class), id) => graph.node(*id).filter(|n| *n.spec().spelling == **class).map(|_| *id),
            Term::Class(_) | Term::Anything => None,
        }
    }
}

fn range(graph: &SceneGraph, q: &Quantified) -> Vec<NodeId> {
    match &q.class {
        Some(class) => graph.of_class(class),
        None => graph.nodes().map(crate::Node::id).collect(),
    }
}

/// Whether VirtualHome's graph has an edge.
fn is_edge(graph: &SceneGraph, from: NodeId, relation: Relation, to: NodeId) -> bool {
    use Relation::{InRoom, Inside, LyingOn, On, PouredInto, SittingOn, WornBy};
    let names: &[Relation] = match relation {
        On => &[On, SittingOn, LyingOn, WornBy],
        Inside | InRoom => &[Inside, InRoom, PouredInto],
        _ => &[relation],
    };
    names.iter().any(|&r| graph.has(Edge::new(from, r, to)))
}
