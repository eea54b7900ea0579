//! Evaluation of goals, part by part.

use super::trace::{Course, Stretch};
use super::{EpisodeTrace, Goal, Literal, Pairs, Predicate, Quantified, Situation, Term, Variable};
use crate::NodeId;

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
        self.judge(Course::new(now))
    }

    /// Whether the goal holds on a trace, see the [module](super) on time. Costs an evaluation of every part
    /// for every choice of objects and, for each temporal operator around it, for every step.
    pub fn holds_on(&self, trace: &EpisodeTrace) -> bool {
        self.judge(trace.course())
    }

    /// Whether the goal holds on the trace up to the end of a step.
    pub fn holds_by(&self, trace: &EpisodeTrace, step: usize) -> bool {
        let course = trace.course();
        let stretch = Stretch::up_to(step.min(course.last()));
        Judge { course, bound: Vec::new() }.holds(&self.expanded(course.vocabulary()), stretch)
    }

    /// The conjuncts that do not hold.
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
    /// let goal: Goal = "On(apple, kitchen_table) & Holds(apple)".parse()?;
    /// let history = History::default();
    /// let unmet = goal.unmet(&Situation::new(&graph, me, &history));
    /// assert_eq!(unmet[0].to_string(), "Holds(me, apple)");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn unmet(&self, now: &Situation<'_>) -> Vec<&Goal> {
        self.conjuncts().iter().filter(|part| !part.holds(now)).collect()
    }

    fn judge(&self, course: Course<'_>) -> bool {
        Judge { course, bound: Vec::new() }.holds(&self.expanded(course.vocabulary()), Stretch::all(&course))
    }
}

impl Quantified {
    /// Whether the body holds for an object.
    pub fn holds_of(&self, thing: NodeId, now: &Situation<'_>) -> bool {
        let course = Course::new(now);
        let body = self.body.expanded(course.vocabulary());
        Judge { course, bound: vec![(&self.variable, thing)] }.holds(&body, Stretch::all(&course))
    }
}

/// The evaluator of goals on a course.
pub(super) struct Judge<'g, 'a> {
    pub(super) course: Course<'a>,
    /// Variables bound so far, innermost last.
    pub(super) bound: Vec<(&'g str, NodeId)>,
}

impl<'g, 'a> Judge<'g, 'a> {
    pub(super) fn holds(&mut self, goal: &'g Goal, on: Stretch) -> bool {
        match goal {
            Goal::Literal(literal) => self.count(literal, on) > 0,
            Goal::Count { literal, comparison, number } => comparison.admits(self.count(literal, on), *number),
            Goal::Same(a, b) => self.meant(a).is_some_and(|a| self.meant(b) == Some(a)),
            Goal::And(parts) => parts.iter().all(|p| self.holds(p, on)),
            Goal::Or(parts) => parts.iter().any(|p| self.holds(p, on)),
            Goal::Not(part) => !self.holds(part, on),
            Goal::Imply(a, b) => !self.holds(a, on) || self.holds(b, on),
            Goal::ForAll(q) => self.each(q, on).into_iter().all(|id| self.holds_of(q, id, on)),
            Goal::Exists(q) => self.each(q, on).into_iter().any(|id| self.holds_of(q, id, on)),
            Goal::ForN { comparison, number, of } => comparison.admits(self.found(of, on), *number),
            Goal::ForPairs(pairs) => {
                let (first, second, found) = self.pairs(pairs, on);
                pairs.admits(found, first, second)
            }
            _ => self.holds_in_time(goal, on),
        }
    }

    fn holds_in_time(&mut self, goal: &'g Goal, on: Stretch) -> bool {
        match goal {
            Goal::Then(parts) => self.in_order(parts, on),
            Goal::Eventually(part) => on.moments().any(|m| self.holds(part, m)),
            Goal::Always(part) => on.moments().all(|m| self.holds(part, m)),
            Goal::Within(steps, part) => on.moments_within(*steps).any(|m| self.holds(part, m)),
            Goal::AtEnd(part) => self.holds(part, on.alone()),
            Goal::Until(a, b) => {
                let end = on.moments().find(|&m| self.holds(b, m) || !self.holds(a, m));
                end.is_some_and(|m| self.holds(b, m))
            }
            Goal::Before(a, b) => {
                let end = on.moments().find(|&m| self.holds(b, m) || self.holds(a, m));
                end.is_some_and(|m| !self.holds(b, m))
            }
            _ => false,
        }
    }

    /// Cuts the stretch into one stretch per part, each as short as possible.
    fn in_order(&mut self, parts: &'g [Goal], on: Stretch) -> bool {
        let Some((last, others)) = parts.split_last() else { return true };
        let mut rest = on.rest();
        for part in others {
            match rest.starts().find(|&stretch| self.holds(part, stretch)) {
                Some(stretch) => rest = rest.after(stretch),
                None => return false,
            }
        }
        self.holds(last, rest)
    }

    /// Evaluates with a variable bound to an object.
    pub(super) fn with<T>(&mut self, variable: &'g str, id: NodeId, judge: impl FnOnce(&mut Self) -> T) -> T {
        self.bound.push((variable, id));
        let result = judge(self);
        self.bound.pop();
        result
    }

    fn holds_of(&mut self, q: &'g Quantified, id: NodeId, on: Stretch) -> bool {
        self.with(&q.variable, id, |judge| judge.holds(&q.body, on))
    }

    /// The number of objects for which a quantified goal holds.
    pub(super) fn found(&mut self, q: &'g Quantified, on: Stretch) -> usize {
        self.each(q, on).into_iter().filter(|&id| self.holds_of(q, id, on)).count()
    }

    /// The nodes that a quantifier ranges over.
    pub(super) fn each(&self, q: &Quantified, on: Stretch) -> Vec<NodeId> {
        self.range(q.class.as_deref(), on)
    }

    fn range(&self, class: Option<&str>, on: Stretch) -> Vec<NodeId> {
        let now = on.situation(&self.course);
        match class {
            Some(class) => now.graph.of_class(class),
            None => now.candidates(&Term::Anything),
        }
    }

    /// The numbers of objects in the two ranges, and the number of pairs.
    pub(super) fn pairs(&mut self, pairs: &'g Pairs, on: Stretch) -> (usize, usize, usize) {
        let range = |v: &Variable| self.range(v.class.as_deref(), on);
        let (firsts, seconds) = (range(&pairs.first), range(&pairs.second));
        let mut rows = Vec::new();
        for &a in &firsts {
            let mut goes_with = |b: NodeId| {
                a != b
                    && self.with(&pairs.first.name, a, |j| j.with(&pairs.second.name, b, |j| j.holds(&pairs.body, on)))
            };
            rows.push((0..seconds.len()).filter(|&i| goes_with(seconds[i])).collect());
        }
        (firsts.len(), seconds.len(), pairs.pairing.number(&rows, seconds.len()))
    }

    /// The object that a term refers to, if it is a single one.
    fn meant(&self, term: &Term) -> Option<NodeId> {
        match term {
            Term::Variable(name) => self.bound.iter().rev().find(|(n, _)| n == name).map(|&(_, id)| id),
            Term::Node(_, id) => Some(*id),
            Term::Me => Some(self.course.agent()),
            Term::Class(_) | Term::Anything => None,
        }
    }

    /// The number of objects for a literal's counted term that satisfy it.
    pub(super) fn count(&self, literal: &Literal, on: Stretch) -> usize {
        let now = on.situation(&self.course);
        let counted = literal.counted().unwrap_or(0);
        let lists: Vec<Vec<Option<NodeId>>> = literal.terms.iter().map(|t| self.choices(literal, t, &now)).collect();
        let Some(first) = lists.get(counted) else {
            return usize::from(now.holds(literal.predicate, [None, None]));
        };
        let anything = [None];
        let other = lists.get(1 - counted.min(1)).filter(|_| lists.len() > 1);
        let others = other.map_or(&anything[..], Vec::as_slice);
        let holds = |a: Option<NodeId>| {
            others.iter().any(|&b| {
                let things = if counted == 0 { [a, b] } else { [b, a] };
                now.holds(literal.predicate, things)
            })
        };
        first.iter().filter(|&&a| holds(a)).count()
    }

    /// The nodes that a term can refer to; an event's `_` needs no enumeration.
    fn choices(&self, literal: &Literal, term: &Term, now: &Situation<'_>) -> Vec<Option<NodeId>> {
        match (term, literal.predicate) {
            (Term::Anything, Predicate::Did(_)) => vec![None],
            (Term::Variable(_), _) => self.meant(term).map(Some).into_iter().collect(),
            _ => now.candidates(term).into_iter().map(Some).collect(),
        }
    }
}
