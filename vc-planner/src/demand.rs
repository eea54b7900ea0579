//! A goal taken apart into demands on things.

use vc_graph::goal::{Comparison, Goal, Literal, Pairs, Predicate, Quantified, Situation, Term, Variable};
use vc_graph::{NodeId, State};

/// So many things of a list are to satisfy a predicate.
#[derive(Debug, Clone)]
pub(crate) struct Demand<'g> {
    pub(crate) predicate: Predicate,
    /// What can stand in each place of the predicate.
    pub(crate) things: [Vec<NodeId>; 2],
    /// Which place is counted.
    pub(crate) counted: usize,
    pub(crate) number: usize,
    /// The part of the goal it comes from.
    pub(crate) part: &'g Goal,
}

impl Demand<'_> {
    /// The things counted.
    pub(crate) fn subjects(&self) -> &[NodeId] {
        &self.things[self.counted]
    }

    /// The things that stand in the other place.
    pub(crate) fn others(&self) -> &[NodeId] {
        &self.things[1 - self.counted]
    }

    pub(crate) fn pair(&self, subject: NodeId, other: Option<NodeId>) -> [Option<NodeId>; 2] {
        if self.counted == 0 { [Some(subject), other] } else { [other, Some(subject)] }
    }

    /// Whether the predicate holds of a thing, with some other.
    pub(crate) fn holds(&self, now: &Situation<'_>, subject: NodeId) -> bool {
        let other = self.others();
        if other.is_empty() {
            return now.holds(self.predicate, self.pair(subject, None));
        }
        other.iter().any(|&o| now.holds(self.predicate, self.pair(subject, Some(o))))
    }
}

/// Which of several ways is taken at each `or`, as the digits of a counter.
#[derive(Debug, Default)]
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

    /// Goes on to the next choice; `false` after the last.
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

/// The demands of a goal under a choice, and whether anything is left out of them.
#[derive(Debug, Default)]
pub(crate) struct Demands<'g> {
    pub(crate) all: Vec<Demand<'g>>,
    /// Parts that are no demands: orders, upper bounds, negations.
    pub(crate) rest: bool,
    /// Sitting and lying is left to regression, which sees when a seat is at hand anyway.
    pub(crate) regress_postures: bool,
}

/// Takes a goal apart.
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
            // What is to hold at some step may as well hold at the last.
            Goal::Eventually(part) | Goal::AtEnd(part) => self.part(part),
            Goal::Until(_, part) | Goal::Before(part, _) | Goal::Within(_, part) => {
                self.found.rest = true;
                self.part(part);
            }
            Goal::ForN { comparison, number, of } => self.so_many(*comparison, *number as usize, of),
            Goal::ForPairs(pairs) => self.pairs(pairs),
            Goal::ForAll(q) => {
                for id in self.range(q) {
                    self.with(q, id);
                }
            }
            Goal::Exists(q) => {
                let mut range = self.range(q);
                // Those of which most holds already are tried first.
                range.sort_by_key(|&id| std::cmp::Reverse(self.met(q, id)));
                if !range.is_empty() {
                    let chosen = self.choice.pick(range.len());
                    self.with(q, range[chosen]);
                }
                self.found.rest |= range.is_empty();
            }
            _ => self.found.rest = true,
        }
    }

    /// How many parts of a body hold of a thing now.
    fn met(&self, q: &Quantified, id: NodeId) -> usize {
        let parts = match &*q.body {
            Goal::And(parts) => parts.as_slice(),
            whole => std::slice::from_ref(whole),
        };
        let stands_for = |term: &Term| match term {
            Term::Variable(name) if *name == q.variable => vec![id],
            other => self.candidates(other),
        };
        let holds = |part: &&Goal| {
            let Goal::Literal(literal) = part else { return false };
            let things = |i: usize| literal.terms.get(i).map_or_else(Vec::new, stands_for);
            let (first, second) = (things(0), things(1));
            let with = |a| match second.as_slice() {
                [] => self.now.holds(literal.predicate, [Some(a), None]),
                others => others.iter().any(|&b| self.now.holds(literal.predicate, [Some(a), Some(b)])),
            };
            first.into_iter().any(with)
        };
        parts.iter().filter(holds).count()
    }

    /// So many of a class, those first of which the part holds already.
    fn so_many(&mut self, comparison: Comparison, number: usize, q: &'g Quantified) {
        self.found.rest |= comparison != Comparison::AtLeast;
        if comparison == Comparison::AtMost {
            return;
        }
        let range = self.range(q);
        self.found.rest |= range.len() < number;
        let chosen = if range.len() > number { self.choice.pick(range.len()) } else { 0 };
        for &id in range.iter().cycle().skip(chosen).take(number.min(range.len())) {
            self.with(q, id);
        }
    }

    /// Things of two classes, one with one in order.
    fn pairs(&mut self, pairs: &'g Pairs) {
        self.found.rest = true;
        let all = |v: &Variable| match &v.class {
            Some(class) => self.now.graph.of_class(class),
            None => Vec::new(),
        };
        let (first, second) = (all(&pairs.first), all(&pairs.second));
        let number = pairs.number.map_or(usize::MAX, |(_, n)| n as usize);
        for (a, b) in first.into_iter().zip(second).take(number) {
            self.bound.push((&pairs.first.name, a));
            self.bound.push((&pairs.second.name, b));
            self.part(&pairs.body);
            self.bound.truncate(self.bound.len() - 2);
        }
    }

    fn with(&mut self, q: &'g Quantified, id: NodeId) {
        self.bound.push((&q.variable, id));
        self.part(&q.body);
        self.bound.pop();
    }

    fn range(&self, q: &Quantified) -> Vec<NodeId> {
        match &q.class {
            Some(class) => self.now.graph.of_class(class),
            None => self.now.candidates(&Term::Anything),
        }
    }

    /// A state has an opposite that can be demanded of all; else it is left.
    fn not(&mut self, part: &'g Goal) {
        let opposite = |state| match state {
            State::Open => Some(State::Closed),
            State::Closed => Some(State::Open),
            State::On => Some(State::Off),
            State::Off => Some(State::On),
            State::Dirty => Some(State::Clean),
            _ => None,
        };
        let Goal::Literal(literal) = part else {
            self.found.rest = true;
            return;
        };
        let Predicate::State(state) = literal.predicate else {
            self.found.rest = true;
            return;
        };
        let Some(opposite) = opposite(state) else {
            self.found.rest = true;
            return;
        };
        for id in self.candidates(&literal.terms[0]) {
            if self.now.holds(literal.predicate, [Some(id), None]) {
                self.found.all.push(Demand {
                    predicate: Predicate::State(opposite),
                    things: [vec![id], Vec::new()],
                    counted: 0,
                    number: 1,
                    part,
                });
            }
        }
    }

    fn demand(&mut self, part: &'g Goal, literal: &'g Literal, number: usize) {
        let terms = &literal.terms;
        let things = [0, 1].map(|i| terms.get(i).map_or_else(Vec::new, |t| self.candidates(t)));
        // Of what is held, not of who holds it, there may be several.
        let held = literal.predicate == Predicate::Holds;
        let counted = if held { 1 } else { literal.counted().unwrap_or(0).min(1) };
        if terms.iter().any(|t| matches!(t, Term::Anything)) && !matches!(literal.predicate, Predicate::Did(_)) {
            self.found.rest = true;
            return;
        }
        self.found.all.push(Demand { predicate: literal.predicate, things, counted, number, part });
    }

    fn candidates(&self, term: &Term) -> Vec<NodeId> {
        match term {
            Term::Variable(name) => {
                self.bound.iter().rev().find(|(n, _)| n == name).map(|&(_, id)| id).into_iter().collect()
            }
            Term::Anything => Vec::new(),
            _ => self.now.candidates(term),
        }
    }
}
