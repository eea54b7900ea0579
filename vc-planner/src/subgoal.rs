//! Derivation of the open subgoals from a goal.

mod conditions;
pub(crate) mod hints;
mod literal;
mod number;

use vc_graph::goal::{Goal, Predicate, Quantified, Situation, Term};
use vc_graph::{NodeId, Place, SceneGraph};

use crate::KnownNodes;
use crate::open_condition::{OpenCondition, Subgoal, Unreachable};
use hints::Hints;

/// A goal as seen by an agent with partial knowledge.
pub(crate) struct View<'a> {
    pub(crate) now: Situation<'a>,
    pub(crate) known: &'a KnownNodes,
    /// The places where things that have not been found can be.
    pub(crate) unseen: &'a [Place],
    pub(crate) hints: &'a Hints,
}

/// Variables and the things they are bound to.
type Bindings<'g> = Vec<(&'g str, NodeId)>;

type Found = Result<Vec<Subgoal>, Unreachable>;

impl View<'_> {
    pub(crate) fn graph(&self) -> &SceneGraph {
        self.now.graph
    }

    /// The open parts of a goal, in the order in which they should be done; none if the goal is known to hold.
    pub(crate) fn subgoals(&self, goal: &Goal) -> Found {
        let mut found = self.open(goal, &mut Vec::new())?;
        for part in goal.conjuncts().iter().filter(|part| presses(part)) {
            let pressing = self.open(part, &mut Vec::new())?;
            if !pressing.is_empty() {
                found = pressing;
                break;
            }
        }
        found.sort_by_key(|s| s.options.first().map_or(u8::MAX, |w| self.stage(w)));
        Ok(found)
    }

    fn open<'g>(&self, goal: &'g Goal, bound: &mut Bindings<'g>) -> Found {
        match goal {
            Goal::Literal(literal) => self.at_least(goal, literal, 1, bound),
            Goal::Count { literal, comparison, number } => {
                self.number(*comparison, *number, &mut |limit| self.literals(goal, literal, limit, bound))
            }
            Goal::Same(a, b) if self.same(a, b, bound) => Ok(Vec::new()),
            Goal::Same(..) => Err(Unreachable::NoInstance(goal.to_string())),
            Goal::And(parts) => all(parts.iter().map(|p| self.open(p, bound))),
            Goal::Or(parts) => self.any(goal, parts.iter().map(|p| self.open(p, bound)).collect()),
            Goal::Not(part) => self.not(part, bound),
            Goal::ForAll(q) => all(self.each(q, bound, |b| self.open(&q.body, b)).into_iter()),
            Goal::Exists(q) => self.any(goal, self.each(q, bound, |b| self.open(&q.body, b))),
            Goal::Then(parts) => self.in_order(parts, bound),
            Goal::Imply(condition, part) => self.any(goal, vec![self.not(condition, bound), self.open(part, bound)]),
            Goal::Eventually(part) | Goal::AtEnd(part) | Goal::Always(part) | Goal::Within(_, part) => {
                self.open(part, bound)
            }
            Goal::Until(meanwhile, part) => self.until(meanwhile, part, bound),
            Goal::Before(part, later) => self.before(part, later, bound),
            Goal::ForN { comparison, number, of } => {
                self.number(*comparison, *number, &mut |limit| self.so_many(goal, of, limit, bound))
            }
            Goal::ForPairs(pairs) => {
                let (comparison, number) = self.pairs_wanted(pairs);
                self.number(comparison, number, &mut |limit| self.pairs(goal, pairs, limit, bound))
            }
            _ => Err(Unreachable::NoPlan(goal.to_string())),
        }
    }

    /// The second part; the first must hold until then. Only the present value of a state is known: it matters
    /// if the second part is an action, before which there was a step.
    fn until<'g>(&self, meanwhile: &'g Goal, part: &'g Goal, bound: &mut Bindings<'g>) -> Found {
        let open = self.open(part, bound)?;
        if !open.is_empty() || !speaks_of_actions(part) || speaks_of_actions(meanwhile) {
            return Ok(open);
        }
        self.open(meanwhile, bound)
    }

    /// The first part; the second must not hold before. A state that holds now is taken to have held before.
    fn before<'g>(&self, part: &'g Goal, later: &'g Goal, bound: &mut Bindings<'g>) -> Found {
        let open = self.open(part, bound)?;
        if !open.is_empty() || speaks_of_actions(later) {
            return Ok(open);
        }
        self.not(later, bound)
    }

    /// Whether two terms denote the same thing.
    fn same(&self, a: &Term, b: &Term, bound: &Bindings<'_>) -> bool {
        let meant = |term: &Term| match term {
            Term::Variable(name) => bound.iter().rev().find(|(n, _)| n == name).map(|&(_, id)| id),
            Term::Node(_, id) => Some(*id),
            Term::Me => Some(self.now.agent),
            Term::Class(_) | Term::Anything => None,
        };
        meant(a).is_some_and(|a| meant(b) == Some(a))
    }

    fn range(&self, class: Option<&str>) -> Vec<NodeId> {
        match class {
            Some(class) => self.graph().of_class(class),
            None => self.now.candidates(&Term::Anything),
        }
    }

    /// The results with the variable bound to each thing of its class.
    fn each<'g>(
        &self,
        q: &'g Quantified,
        bound: &mut Bindings<'g>,
        mut find: impl FnMut(&mut Bindings<'g>) -> Found,
    ) -> Vec<Found> {
        let range = self.range(q.class.as_deref());
        range.into_iter().map(|id| bind(&q.variable, id, bound, &mut find)).collect()
    }

    /// One of several alternatives: the one with the fewest subgoals; alternatives of a single step are pooled.
    fn any(&self, goal: &Goal, ways: Vec<Found>) -> Found {
        let (mut possible, reason) = sift(ways);
        possible.sort_by_key(Vec::len);
        match possible.first() {
            None => Err(reason.unwrap_or_else(|| Unreachable::NoInstance(goal.to_string()))),
            Some(way) if way.len() == 1 => {
                let single = possible.into_iter().take_while(|w| w.len() == 1);
                let mut options: Vec<OpenCondition> = single.flatten().flat_map(|s| s.options).collect();
                options.sort_by_cached_key(|w| self.cost(w));
                Ok(vec![Subgoal { options }])
            }
            Some(way) => Ok(way.clone()),
        }
    }

    /// The first part of a sequence that does not hold after those before it.
    fn in_order<'g>(&self, parts: &'g [Goal], bound: &mut Bindings<'g>) -> Found {
        let mut start = 0;
        for (index, part) in parts.iter().enumerate() {
            let events = self.now.events;
            let stretch = |end: usize| Situation { events: &events[start..end], ..self.now };
            let ends = if index + 1 == parts.len() { events.len()..=events.len() } else { start..=events.len() };
            let mut open = Ok(Vec::new());
            let mut met = None;
            for end in ends {
                open = View { now: stretch(end), ..*self }.open(part, bound);
                if open.as_ref().is_ok_and(Vec::is_empty) {
                    met = Some(end);
                    break;
                }
            }
            match met {
                Some(end) => start = end,
                None => return open,
            }
        }
        Ok(Vec::new())
    }

    /// A goal that must not hold.
    fn not<'g>(&self, part: &'g Goal, bound: &mut Bindings<'g>) -> Found {
        match part {
            Goal::Literal(literal) => self.at_most(part, literal, 0, bound),
            Goal::Count { literal, comparison, number } => {
                self.other_number(part, *comparison, *number, &mut |limit| self.literals(part, literal, limit, bound))
            }
            Goal::Same(a, b) if !self.same(a, b, bound) => Ok(Vec::new()),
            Goal::Same(..) => Err(Unreachable::NoInstance(part.to_string())),
            Goal::Not(inner) => self.open(inner, bound),
            Goal::And(parts) | Goal::Then(parts) => {
                let ways = parts.iter().map(|p| self.not(p, bound)).collect();
                self.any(part, ways)
            }
            Goal::Or(parts) => all(parts.iter().map(|p| self.not(p, bound))),
            Goal::Imply(condition, then) => Ok([self.open(condition, bound)?, self.not(then, bound)?].concat()),
            Goal::ForAll(q) => self.any(part, self.each(q, bound, |b| self.not(&q.body, b))),
            Goal::Exists(q) => all(self.each(q, bound, |b| self.not(&q.body, b)).into_iter()),
            Goal::ForN { comparison, number, of } => {
                self.other_number(part, *comparison, *number, &mut |limit| self.so_many(part, of, limit, bound))
            }
            Goal::ForPairs(pairs) => {
                let (comparison, number) = self.pairs_wanted(pairs);
                self.other_number(part, comparison, number, &mut |limit| self.pairs(part, pairs, limit, bound))
            }
            Goal::Eventually(inner) | Goal::AtEnd(inner) | Goal::Always(inner) | Goal::Within(_, inner) => {
                self.not(inner, bound)
            }
            Goal::Until(meanwhile, then) => self.any(part, vec![self.not(then, bound), self.not(meanwhile, bound)]),
            Goal::Before(first, later) => self.any(part, vec![self.not(first, bound), self.open(later, bound)]),
            _ => Err(Unreachable::NoPlan(part.to_string())),
        }
    }
}

/// Whether a part has to be done before others because it may be too late afterwards.
fn presses(part: &Goal) -> bool {
    matches!(part, Goal::Within(..) | Goal::Before(..))
}

/// Whether some part is about past actions.
fn speaks_of_actions(goal: &Goal) -> bool {
    match goal {
        Goal::Literal(literal) | Goal::Count { literal, .. } => matches!(literal.predicate, Predicate::Did(_)),
        _ => goal.parts().into_iter().any(speaks_of_actions),
    }
}

/// The subgoals of all parts; the first impossible part gives the error.
fn all(parts: impl Iterator<Item = Found>) -> Found {
    Ok(parts.collect::<Result<Vec<_>, _>>()?.concat())
}

/// The possible alternatives, and the error of the first impossible one.
fn sift(ways: Vec<Found>) -> (Vec<Vec<Subgoal>>, Option<Unreachable>) {
    let (mut possible, mut reason) = (Vec::new(), None);
    for way in ways {
        match way {
            Ok(way) => possible.push(way),
            Err(why) => reason = reason.or(Some(why)),
        }
    }
    (possible, reason)
}

fn bind<'g, T>(
    variable: &'g str,
    id: NodeId,
    bound: &mut Bindings<'g>,
    with: impl FnOnce(&mut Bindings<'g>) -> T,
) -> T {
    bound.push((variable, id));
    let result = with(bound);
    bound.pop();
    result
}
