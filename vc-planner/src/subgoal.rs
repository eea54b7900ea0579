//! From a goal to the things that are still to be brought about.

use vc_graph::goal::{Comparison, Goal, Literal, Predicate, Quantified, Situation, Term};
use vc_graph::{Action, Condition, Node, NodeId, Property, Relation, SceneGraph, State, Verb};

use crate::Known;
use crate::want::{Subgoal, Unreachable, Want};
use crate::weigh::Hints;

/// A goal seen by an agent that knows only a part.
pub(crate) struct View<'a> {
    pub(crate) now: Situation<'a>,
    pub(crate) known: &'a Known,
    pub(crate) hints: &'a Hints,
}

/// Variables and what they stand for.
type Bindings<'g> = Vec<(&'g str, NodeId)>;

type Found = Result<Vec<Subgoal>, Unreachable>;

impl View<'_> {
    pub(crate) fn graph(&self) -> &SceneGraph {
        self.now.graph
    }

    /// The open parts of a goal, in the order in which to go about them; none when
    /// the goal is known to hold.
    pub(crate) fn subgoals(&self, goal: &Goal) -> Found {
        let mut found = self.open(goal, &mut Vec::new())?;
        found.sort_by_key(|s| s.options.first().map_or(u8::MAX, |w| self.stage(w)));
        Ok(found)
    }

    fn open<'g>(&self, goal: &'g Goal, bound: &mut Bindings<'g>) -> Found {
        match goal {
            Goal::Literal(literal) => self.at_least(goal, literal, 1, bound),
            Goal::Count { literal, comparison, number } => {
                self.count(goal, literal, *comparison, *number as usize, bound)
            }
            Goal::And(parts) => {
                let all: Result<Vec<_>, _> = parts.iter().map(|p| self.open(p, bound)).collect();
                Ok(all?.concat())
            }
            Goal::Or(parts) => self.any(goal, parts.iter().map(|p| self.open(p, bound)).collect()),
            Goal::Not(part) => self.not(part, bound),
            Goal::ForAll(q) => {
                let each = self.range(q).into_iter().map(|id| bind(q, id, bound, |b| self.open(&q.body, b)));
                Ok(each.collect::<Result<Vec<_>, _>>()?.concat())
            }
            Goal::Exists(q) => {
                let each = self.range(q).into_iter().map(|id| bind(q, id, bound, |b| self.open(&q.body, b))).collect();
                self.any(goal, each)
            }
            Goal::Then(parts) => self.in_order(parts, bound),
            Goal::Imply(condition, part) => self.any(goal, vec![self.not(condition, bound), self.open(part, bound)]),
            Goal::Eventually(part) | Goal::AtEnd(part) | Goal::Always(part) | Goal::Within(_, part) => {
                self.open(part, bound)
            }
            Goal::Until(_, part) | Goal::Before(part, _) => self.open(part, bound),
            Goal::ForN { comparison: Comparison::AtLeast, number, of } => {
                self.so_many(goal, *number as usize, of, bound)
            }
            _ => Err(Unreachable::NoPlan(goal.to_string())),
        }
    }

    fn range(&self, q: &Quantified) -> Vec<NodeId> {
        match &q.class {
            Some(class) => self.graph().of_class(class),
            None => self.now.candidates(&Term::Anything),
        }
    }

    /// The part for so many things of a class: those with least to do.
    fn so_many<'g>(&self, goal: &Goal, number: usize, q: &'g Quantified, bound: &mut Bindings<'g>) -> Found {
        let each = self.range(q).into_iter().map(|id| bind(q, id, bound, |b| self.open(&q.body, b)));
        let mut possible: Vec<Vec<Subgoal>> = each.flatten().collect();
        if possible.len() < number {
            return Err(Unreachable::NoInstance(goal.to_string()));
        }
        possible.sort_by_key(Vec::len);
        Ok(possible.into_iter().take(number).flatten().collect())
    }

    /// One of several ways: the one with least to do; single steps are pooled.
    fn any(&self, goal: &Goal, ways: Vec<Found>) -> Found {
        let mut possible: Vec<Vec<Subgoal>> = ways.into_iter().flatten().collect();
        possible.sort_by_key(Vec::len);
        match possible.first() {
            None => Err(Unreachable::NoInstance(goal.to_string())),
            Some(way) if way.len() == 1 => {
                let single = possible.into_iter().take_while(|w| w.len() == 1);
                let mut options: Vec<Want> = single.flatten().flat_map(|s| s.options).collect();
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
                open = View { now: stretch(end), known: self.known, hints: self.hints }.open(part, bound);
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
            Goal::Count { literal, comparison: Comparison::AtLeast, number } => {
                self.at_most(part, literal, (*number as usize).saturating_sub(1), bound)
            }
            Goal::Count { literal, comparison: Comparison::AtMost, number } => {
                self.at_least(part, literal, *number as usize + 1, bound)
            }
            Goal::Count { literal, number, .. } => {
                let more = self.at_least(part, literal, *number as usize + 1, bound);
                let fewer = match *number {
                    0 => Err(Unreachable::NoInstance(part.to_string())),
                    n => self.at_most(part, literal, n as usize - 1, bound),
                };
                self.any(part, vec![fewer, more])
            }
            Goal::Not(inner) => self.open(inner, bound),
            Goal::And(parts) | Goal::Then(parts) => {
                let ways = parts.iter().map(|p| self.not(p, bound)).collect();
                self.any(part, ways)
            }
            Goal::Or(parts) => {
                let all: Result<Vec<_>, _> = parts.iter().map(|p| self.not(p, bound)).collect();
                Ok(all?.concat())
            }
            Goal::ForAll(q) => {
                let ways = self.range(q).into_iter().map(|id| bind(q, id, bound, |b| self.not(&q.body, b))).collect();
                self.any(part, ways)
            }
            Goal::Exists(q) => {
                let each = self.range(q).into_iter().map(|id| bind(q, id, bound, |b| self.not(&q.body, b)));
                Ok(each.collect::<Result<Vec<_>, _>>()?.concat())
            }
            _ => Err(Unreachable::NoPlan(part.to_string())),
        }
    }

    fn count(
        &self,
        goal: &Goal,
        literal: &Literal,
        comparison: Comparison,
        number: usize,
        bound: &Bindings<'_>,
    ) -> Found {
        let fewer = || self.at_most(goal, literal, number, bound);
        let more = || self.at_least(goal, literal, number, bound);
        match comparison {
            Comparison::AtLeast => more(),
            Comparison::AtMost => fewer(),
            Comparison::Exactly => Ok([fewer()?, more()?].concat()),
        }
    }

    /// So many different things must satisfy a literal.
    fn at_least(&self, goal: &Goal, literal: &Literal, number: usize, bound: &Bindings<'_>) -> Found {
        if literal.terms.is_empty() {
            let done = self.now.holds(literal.predicate, [None, None]);
            let options = self.wants(literal.predicate, [None, None]);
            return Ok((!done).then_some(Subgoal { options }).into_iter().collect());
        }
        let choices = self.choices(literal, bound);
        if choices.len() < number {
            return Err(Unreachable::NoInstance(goal.to_string()));
        }
        let mut met = 0;
        let mut options: Vec<Want> = Vec::new();
        for (_, things) in &choices {
            let holding = || things.iter().filter(|t| self.now.holds(literal.predicate, **t));
            if holding().any(|t| self.is_known(literal, t)) {
                met += 1;
            } else if let Some(guessed) = holding().next() {
                options.extend(self.to_see(literal, guessed));
            } else {
                options.extend(things.iter().flat_map(|t| self.wants(literal.predicate, *t)));
            }
        }
        if met >= number {
            return Ok(Vec::new());
        }
        if options.is_empty() {
            return Err(Unreachable::NoPlan(goal.to_string()));
        }
        options.sort_by_cached_key(|w| self.cost(w));
        // One subgoal for all that are missing: after each the rest is counted anew.
        Ok(vec![Subgoal { options }])
    }

    /// At most so many things may satisfy a literal.
    fn at_most(&self, goal: &Goal, literal: &Literal, number: usize, bound: &Bindings<'_>) -> Found {
        let mut holding = Vec::new();
        let mut unseen = Vec::new();
        for (_, things) in self.choices(literal, bound) {
            for t in things {
                if self.now.holds(literal.predicate, t) {
                    holding.push(t);
                } else if !self.is_known(literal, &t) {
                    unseen.extend(self.to_see(literal, &t));
                }
            }
        }
        let excess = holding.len().saturating_sub(number);
        if excess > 0 {
            let mut options: Vec<Want> = holding.iter().flat_map(|t| self.undo(literal.predicate, *t)).collect();
            options.sort_by_cached_key(|w| self.cost(w));
            let irrevocable = options.is_empty();
            return if irrevocable {
                Err(Unreachable::Irrevocable(goal.to_string()))
            } else {
                Ok(vec![Subgoal { options }])
            };
        }
        let subgoal = |want| Subgoal { options: vec![want] };
        Ok(unseen.into_iter().map(subgoal).collect())
    }

    /// For each thing that counts, the choices of all things with it.
    fn choices(&self, literal: &Literal, bound: &Bindings<'_>) -> Vec<(NodeId, Vec<[Option<NodeId>; 2]>)> {
        let lists: Vec<Vec<NodeId>> =
            literal.terms.iter().enumerate().map(|(i, t)| self.candidates(literal.predicate, i, t, bound)).collect();
        let counted = literal.counted().unwrap_or(0);
        let Some(first) = lists.get(counted) else { return Vec::new() };
        let others = lists.get(1 - counted).filter(|_| lists.len() > 1);
        let pair = |a: NodeId| match others {
            None => vec![[Some(a), None]],
            Some(others) if counted == 0 => others.iter().map(|&b| [Some(a), Some(b)]).collect(),
            Some(others) => others.iter().map(|&b| [Some(b), Some(a)]).collect(),
        };
        first.iter().map(|&a| (a, pair(a))).collect()
    }

    fn candidates(&self, predicate: Predicate, position: usize, term: &Term, bound: &Bindings<'_>) -> Vec<NodeId> {
        match (term, predicate) {
            (Term::Variable(name), _) => {
                bound.iter().rev().find(|(n, _)| n == name).map(|&(_, id)| id).into_iter().collect()
            }
            (Term::Anything, Predicate::Did(verb)) => self.fit_for(verb, position),
            _ => self.now.candidates(term),
        }
    }

    /// The things a verb can be done to, by what they are.
    fn fit_for(&self, verb: Verb, position: usize) -> Vec<NodeId> {
        let fits = |node: &&Node| {
            let id = node.id();
            let probe =
                if position == 0 { Action::one(verb, id) } else { Action { verb, object: None, target: Some(id) } };
            let needs = vc_graph::rule::preconditions(&probe);
            needs.iter().filter(|c| c.is_lasting()).all(|c| c.holds(self.graph(), self.now.agent))
        };
        self.graph().nodes().filter(|n| n.kind() == vc_graph::Kind::Object).filter(fits).map(Node::id).collect()
    }

    fn is_known(&self, literal: &Literal, things: &[Option<NodeId>; 2]) -> bool {
        matches!(literal.predicate, Predicate::Did(_)) || things.iter().flatten().all(|&id| self.known.contains(id))
    }

    /// What to look at to be sure of a literal.
    fn to_see(&self, literal: &Literal, things: &[Option<NodeId>; 2]) -> Vec<Want> {
        if matches!(literal.predicate, Predicate::Did(_)) {
            return Vec::new();
        }
        things.iter().flatten().filter(|&&id| !self.known.contains(id)).take(1).map(|&id| Want::See(id)).collect()
    }

    /// What would make a predicate true of things.
    fn wants(&self, predicate: Predicate, things: [Option<NodeId>; 2]) -> Vec<Want> {
        let me = self.now.agent;
        let hold = |c| vec![Want::Hold(c)];
        match (predicate, things) {
            (Predicate::State(state), [Some(id), _]) => hold(Condition::In(id, state)),
            (Predicate::Holds, [Some(agent), Some(id)]) if agent == me => hold(Condition::Holding(id)),
            (Predicate::Relation(relation), [Some(from), Some(to)]) => self.wants_relation(from, relation, to),
            (Predicate::Did(verb), [object, target]) => {
                let things: Vec<NodeId> = object.into_iter().chain(target).collect();
                Action::with(verb, &things).map(Want::Do).into_iter().collect()
            }
            _ => Vec::new(),
        }
    }

    fn wants_relation(&self, from: NodeId, relation: Relation, to: NodeId) -> Vec<Want> {
        let me = self.now.agent;
        let room = self.graph().rooms().contains(&to);
        let related = |relation| vec![Want::Hold(Condition::Related(from, relation, to))];
        let fixed = from != me && !Condition::Graspable(from).holds(self.graph(), me);
        if from == to || (fixed && matches!(relation, Relation::On | Relation::Inside | Relation::InRoom)) {
            return Vec::new();
        }
        match relation {
            Relation::On if from == me => {
                let node = self.graph().node(to);
                let affords = |p| node.is_some_and(|n| n.affords(p));
                let lie = affords(Property::Lieable).then_some(Relation::LyingOn);
                let sit = affords(Property::Sittable).then_some(Relation::SittingOn);
                let (first, second) = if self.hints.lying { (lie, sit) } else { (sit, lie) };
                first.into_iter().chain(second).flat_map(related).collect()
            }
            Relation::On if to == me => vec![Want::Hold(Condition::Worn(from))],
            Relation::Inside | Relation::InRoom if room => related(Relation::InRoom),
            Relation::Near if from == me && room => vec![Want::Hold(Condition::Related(me, Relation::InRoom, to))],
            Relation::Near if from == me => vec![Want::Hold(Condition::Near(to))],
            Relation::Facing if from == me => vec![Want::Hold(Condition::Facing(to))],
            _ => related(relation),
        }
    }

    /// What would make a predicate false of things.
    fn undo(&self, predicate: Predicate, things: [Option<NodeId>; 2]) -> Vec<Want> {
        let me = self.now.agent;
        match (predicate, things) {
            (Predicate::State(State::Sitting | State::Lying), [Some(id), _]) if id == me => {
                vec![Want::Hold(Condition::Upright)]
            }
            (Predicate::State(state), [Some(id), _]) => {
                state.opposites().iter().map(|s| Want::Hold(Condition::In(id, s))).collect()
            }
            (Predicate::Holds, [_, Some(id)]) => vec![Want::Do(Action::one(Verb::Drop, id))],
            (Predicate::Relation(relation), [Some(from), Some(to)]) => match relation {
                Relation::HoldsRight | Relation::HoldsLeft => vec![Want::Do(Action::one(Verb::Drop, to))],
                Relation::SittingOn | Relation::LyingOn => vec![Want::Hold(Condition::Upright)],
                Relation::On | Relation::Inside if from == me => vec![Want::Hold(Condition::Upright)],
                Relation::On | Relation::Inside | Relation::WornBy | Relation::InRoom => {
                    vec![Want::Hold(Condition::Holding(from))]
                }
                _ => Vec::new(),
            },
            _ => Vec::new(),
        }
    }
}

fn bind<'g, T>(
    q: &'g Quantified,
    id: NodeId,
    bound: &mut Bindings<'g>,
    with: impl FnOnce(&mut Bindings<'g>) -> T,
) -> T {
    bound.push((&q.variable, id));
    let result = with(bound);
    bound.pop();
    result
}
