//! Decomposition of a goal into demands on things.

use vc_graph::goal::{Comparison, Goal, Literal, Pairs, Predicate, Quantified, Situation, Term};
use vc_graph::{NodeId, State};

use crate::small_list::SmallList;

/// A demand that a number of things from a list satisfy a predicate.
#[derive(Debug, Clone)]
pub(crate) struct Demand<'g> {
    pub(crate) predicate: Predicate,
    /// The candidates for each argument of the predicate.
    pub(crate) things: [SmallList; 2],
    /// The argument that is counted.
    pub(crate) counted: usize,
    pub(crate) number: usize,
    /// The part of the goal from which the demand comes.
    pub(crate) part: &'g Goal,
}

impl Demand<'_> {
    /// The candidates of the counted argument.
    pub(crate) fn subjects(&self) -> &[NodeId] {
        &self.things[self.counted]
    }

    /// The candidates of the other argument.
    pub(crate) fn others(&self) -> &[NodeId] {
        &self.things[1 - self.counted]
    }

    pub(crate) fn pair(&self, subject: NodeId, other: Option<NodeId>) -> [Option<NodeId>; 2] {
        if self.counted == 0 { [Some(subject), other] } else { [other, Some(subject)] }
    }

    /// Whether the predicate holds of a thing with some candidate of the other argument.
    pub(crate) fn holds(&self, now: &Situation<'_>, subject: NodeId) -> bool {
        let other = self.others();
        if other.is_empty() {
            return now.holds(self.predicate, self.pair(subject, None));
        }
        other.iter().any(|&o| now.holds(self.predicate, self.pair(subject, Some(o))))
    }
}

/// The alternative that is chosen at each `or`, as the digits of a counter.
#[derive(Debug, Clone, Default)]
pub(crate) struct Choice {
    digits: Vec<(usize, usize)>,
    next: usize,
}

impl Choice {
    fn pick(&mut self, of: usize) -> usize {
        if self.next == self.digits.len() {
            self.digits.push((0, of));
        }
        self.next += 1;
        self.digits[self.next - 1].0
    }

    /// Advances to the next choice; `false` after the last.
    pub(crate) fn advance(&mut self) -> bool {
        self.next = 0;
        while let Some((digit, of)) = self.digits.pop() {
            if digit + 1 < of {
                self.digits.push((digit + 1, of));
                return true;
            }
        }
        false
    }
}

/// The demands of a goal under a choice, and whether they leave anything out.
#[derive(Debug, Default)]
pub(crate) struct Demands<'g> {
    pub(crate) all: Vec<Demand<'g>>,
    /// Whether the goal has parts that are not demands: orders, upper bounds, negations.
    pub(crate) rest: bool,
    /// A part that no action can make true: a claim that one thing is another.
    pub(crate) refuted: Option<&'g Goal>,
    /// Whether postures are left to regression, which notices a seat that is at hand anyway.
    pub(crate) regress_postures: bool,
}

/// Decomposes a goal.
pub(crate) struct Reader<'a, 'g> {
    pub(crate) now: &'a Situation<'a>,
    pub(crate) choice: &'a mut Choice,
    pub(crate) found: Demands<'g>,
    bound: Vec<(&'g str, NodeId)>,
}

impl<'a, 'g> Reader<'a, 'g> {
    pub(crate) fn read(goal: &'g Goal, now: &'a Situation<'a>, choice: &'a mut Choice) -> Demands<'g> {
        choice.next = 0;
        let mut reader = Self { now, choice, found: Demands::default(), bound: Vec::new() };
        reader.part(goal);
        reader.found
    }

    fn part(&mut self, goal: &'g Goal) {
        match goal {
            Goal::Literal(literal) => self.demand(goal, literal, 1),
            Goal::Same(a, b) => self.same(goal, a, b, true),
            Goal::Count { literal, comparison, number } => {
                if *comparison != Comparison::AtMost {
                    self.demand(goal, literal, *number as usize);
                }
                self.found.rest |= *comparison != Comparison::AtLeast;
            }
            Goal::And(parts) => {
                self.found.all.reserve(parts.len());
                parts.iter().for_each(|p| self.part(p));
            }
            Goal::Or(parts) if !parts.is_empty() => {
                let chosen = self.choice.pick(parts.len());
                self.part(&parts[chosen]);
            }
            Goal::Not(part) => self.not(part),
            Goal::Imply(condition, part) => match self.choice.pick(2) {
                0 => self.part(part),
                _ => self.not(condition),
            },
            // A part that has to hold at some step may as well hold at the last.
            Goal::Eventually(part) | Goal::AtEnd(part) => self.part(part),
            Goal::Until(_, part) | Goal::Before(part, _) | Goal::Within(_, part) => {
                self.found.rest = true;
                self.part(part);
            }
            Goal::ForN { comparison, number, of } => self.so_many(*comparison, *number as usize, of),
            Goal::ForPairs(pairs) => self.pairs(pairs),
            Goal::ForAll(q) => {
                for id in self.range(q.class.as_deref()) {
                    self.with(q, id);
                }
            }
            Goal::Exists(q) => {
                let mut range = self.range(q.class.as_deref());
                // Candidates for which most parts hold already are tried first.
                range.sort_by_cached_key(|&id| {
                    std::cmp::Reverse(self.bound_to(&[(&q.variable, id)], |r| r.met(&q.body)))
                });
                if !range.is_empty() {
                    let chosen = self.choice.pick(range.len());
                    self.with(q, range[chosen]);
                }
                self.found.rest |= range.is_empty();
            }
            _ => self.found.rest = true,
        }
    }

    /// The number of parts of a body that hold now under the variables' bindings.
    fn met(&self, body: &Goal) -> usize {
        body.conjuncts().iter().filter(|part| self.holds(part)).count()
    }

    /// Whether a literal or a (dis)equality holds now; other parts of the language count as not holding.
    fn holds(&self, part: &Goal) -> bool {
        match part {
            Goal::Same(a, b) => self.meant(a).is_some_and(|a| self.meant(b) == Some(a)),
            Goal::Not(part) => matches!(**part, Goal::Same(..)) && !self.holds(part),
            Goal::Literal(literal) => {
                let things = |i: usize| literal.terms.get(i).map_or(SmallList::NONE, |t| self.candidates(t));
                let (first, second) = (things(0), things(1));
                let with = |a| match &*second {
                    [] => self.now.holds(literal.predicate, [Some(a), None]),
                    others => others.iter().any(|&b| self.now.holds(literal.predicate, [Some(a), Some(b)])),
                };
                first.iter().copied().any(with)
            }
            _ => false,
        }
    }

    /// The thing that a term denotes, if it is a single thing.
    fn meant(&self, term: &Term) -> Option<NodeId> {
        match term {
            Term::Class(_) | Term::Anything => None,
            one => self.candidates(one).first().copied(),
        }
    }

    /// Handles equality or inequality of two things: it holds, or it never will.
    fn same(&mut self, part: &'g Goal, a: &Term, b: &Term, wanted: bool) {
        let same = self.meant(a).is_some_and(|a| self.meant(b) == Some(a));
        if same != wanted {
            self.found.refuted = Some(part);
        }
    }

    /// Demands a number of things of a class, first those for which the part holds already.
    fn so_many(&mut self, comparison: Comparison, number: usize, q: &'g Quantified) {
        self.found.rest |= comparison != Comparison::AtLeast;
        if comparison == Comparison::AtMost {
            return;
        }
        let range = self.range(q.class.as_deref());
        self.found.rest |= range.len() < number;
        let chosen = if range.len() > number { self.choice.pick(range.len()) } else { 0 };
        for &id in range.iter().cycle().skip(chosen).take(number.min(range.len())) {
            self.with(q, id);
        }
    }

    /// Demands pairs of things of two classes, one to one: pairs that hold already, then the others in order.
    fn pairs(&mut self, pairs: &'g Pairs) {
        self.found.rest = true;
        let (comparison, number) = match pairs.number {
            Some((comparison, number)) => (comparison, number as usize),
            None => (Comparison::AtLeast, usize::MAX),
        };
        if comparison == Comparison::AtMost {
            return;
        }
        let [mut first, mut second] = [&pairs.first, &pairs.second].map(|v| self.range(v.class.as_deref()));
        let names = [&*pairs.first.name, &*pairs.second.name];
        let mut chosen = Vec::new();
        first.retain(|&a| {
            let fits =
                |&b: &NodeId| a != b && self.bound_to(&[(names[0], a), (names[1], b)], |r| r.holds_now(&pairs.body));
            let found = second.iter().position(fits);
            chosen.extend(found.map(|at| (a, second.remove(at))));
            found.is_none()
        });
        chosen.extend(first.into_iter().zip(second).filter(|(a, b)| a != b));
        for (a, b) in chosen.into_iter().take(number) {
            self.bound_to(&[(names[0], a), (names[1], b)], |r| r.part(&pairs.body));
        }
    }

    /// Whether all parts of a body hold now.
    fn holds_now(&self, body: &Goal) -> bool {
        self.met(body) == body.conjuncts().len()
    }

    fn with(&mut self, q: &'g Quantified, id: NodeId) {
        self.bound_to(&[(&q.variable, id)], |r| r.part(&q.body));
    }

    /// Runs `read` with variables bound to things.
    fn bound_to<T>(&mut self, things: &[(&'g str, NodeId)], read: impl FnOnce(&mut Self) -> T) -> T {
        let outer = self.bound.len();
        self.bound.extend_from_slice(things);
        let result = read(self);
        self.bound.truncate(outer);
        result
    }

    fn range(&self, class: Option<&str>) -> Vec<NodeId> {
        match class {
            Some(class) => self.now.graph.of_class(class),
            None => self.now.candidates(&Term::Anything),
        }
    }

    /// Demands the opposite of a state for all candidates, if the state has an opposite; otherwise the part is
    /// left.
    fn not(&mut self, part: &'g Goal) {
        let opposite = |state| match state {
            State::Open => Some(State::Closed),
            State::Closed => Some(State::Open),
            State::On => Some(State::Off),
            State::Off => Some(State::On),
            State::Dirty => Some(State::Clean),
            _ => None,
        };
        let literal = match part {
            Goal::Literal(literal) => literal,
            Goal::Same(a, b) => return self.same(part, a, b, false),
            Goal::Not(part) => return self.part(part),
            Goal::Imply(condition, then) => {
                self.part(condition);
                return self.not(then);
            }
            Goal::Or(parts) => return parts.iter().for_each(|p| self.not(p)),
            Goal::And(parts) if !parts.is_empty() => {
                let chosen = self.choice.pick(parts.len());
                return self.not(&parts[chosen]);
            }
            _ => {
                self.found.rest = true;
                return;
            }
        };
        let Predicate::State(state) = literal.predicate else {
            self.found.rest = true;
            return;
        };
        let Some(opposite) = opposite(state) else {
            self.found.rest = true;
            return;
        };
        for &id in self.candidates(&literal.terms[0]).iter() {
            if self.now.holds(literal.predicate, [Some(id), None]) {
                self.found.all.push(Demand {
                    predicate: Predicate::State(opposite),
                    things: [SmallList::One(id), SmallList::NONE],
                    counted: 0,
                    number: 1,
                    part,
                });
            }
        }
    }

    fn demand(&mut self, part: &'g Goal, literal: &'g Literal, number: usize) {
        let terms = &literal.terms;
        let things = [0, 1].map(|i| terms.get(i).map_or(SmallList::NONE, |t| self.candidates(t)));
        // For `Holds` the held things are counted, not the holder. One thing that is to be at one of several
        // places is a need of one, whatever the places.
        let held = literal.predicate == Predicate::Holds;
        let one = number == 1 && matches!(terms.first(), Some(Term::Variable(_) | Term::Node(..)));
        let counted = if held { 1 } else { literal.counted().filter(|_| !one).unwrap_or(0).min(1) };
        if terms.iter().any(|t| matches!(t, Term::Anything)) && !matches!(literal.predicate, Predicate::Did(_)) {
            self.found.rest = true;
            return;
        }
        self.found.all.push(Demand { predicate: literal.predicate, things, counted, number, part });
    }

    fn candidates(&self, term: &Term) -> SmallList {
        match term {
            Term::Variable(name) => {
                self.bound.iter().rev().find(|(n, _)| n == name).map_or(SmallList::NONE, |&(_, id)| SmallList::One(id))
            }
            // An agent in an unknown home knows no thing by its number before seeing it.
            Term::Node(_, id) => {
                if self.now.graph.node(*id).is_some() {
                    SmallList::One(*id)
                } else {
                    SmallList::NONE
                }
            }
            Term::Me => SmallList::One(self.now.agent),
            Term::Anything => SmallList::NONE,
            Term::Class(_) => SmallList::Many(self.now.candidates(term)),
        }
    }
}
