//! Best-first search over packed states.
//!
//! Weighted A* (Pohl 1970) gives a first answer, beam search (Lowerre 1976) a better one,
//! and A* without a weight proves it or finds what the beam has missed. Each works only
//! on what can still be cheaper than the best answer so far, so that one may stop at any
//! of them (Hansen and Zhou, *Anytime Heuristic Search*, 2007). The result depends on
//! the budget in expansions, never on a clock.

mod beam;

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::packed::{ACTION, FINE, Op, Problem, State};

/// How much a search may do.
///
/// ```
/// use vc_planner::{Planner, SearchLimits};
/// let planner = Planner::with_limits(SearchLimits { first: 1_000, ..SearchLimits::FIRST_ANSWER });
/// # let _ = planner;
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SearchLimits {
    /// States looked at for the first answer.
    pub first: usize,
    /// States looked at to improve or prove it.
    pub improve: usize,
}

impl SearchLimits {
    /// A first answer and nothing more.
    pub const FIRST_ANSWER: Self = Self { first: 4_000, improve: 0 };
    /// Proves that no plan has fewer actions for six predicates, mostly for eight, and finds the
    /// best of twelve nearly always (58 of 60 errands among 500 objects, in some 4 ms).
    pub const THOROUGH: Self = Self { first: 4_000, improve: 7_000 };
}

impl Default for SearchLimits {
    fn default() -> Self {
        Self::THOROUGH
    }
}

/// The result of a search.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Found {
    /// Macros to the goal, what they cost, and whether no others take fewer actions.
    Way { ops: Vec<Op>, cost: u32, best: bool },
    /// There is none: this many states are all there are.
    Exhausted(usize),
    /// The budget ended first.
    Unfinished(usize),
}

#[derive(Debug, Clone, Copy)]
struct Visit {
    state: State,
    cost: u32,
    bound: u32,
    from: u32,
    op: Op,
    closed: bool,
}

/// Memory of searches, kept from one to the next.
#[derive(Debug, Clone, Default)]
pub(crate) struct Search {
    visits: Vec<Visit>,
    /// Positions in `visits` plus one, by hash; a power of two of them.
    table: Vec<u32>,
    open: BinaryHeap<Reverse<u64>>,
    ops: Vec<Op>,
    layer: Vec<u32>,
    /// Only ways cheaper than this are looked for, without the last `blur` bits: a way
    /// with as many actions is no better to A*, one through fewer rooms is to a beam.
    under: u32,
    blur: u32,
    /// The weight of the bound, in halves.
    weight: u32,
}

const SMALL_TABLE: usize = 256;
/// A beam as wide as this finds the best of six predicates nearly always.
const WIDEST: usize = 256;

impl Search {
    /// The cheapest way from a state to the goal that the limits allow.
    pub(crate) fn solve(&mut self, problem: &Problem, start: State, limits: SearchLimits) -> Found {
        let first = self.best_first(problem, start, 3, limits.first, u32::MAX);
        let Found::Way { mut ops, mut cost, .. } = first else { return first };
        let least = problem.bound(&start) / ACTION;
        let mut budget = limits.improve;
        if cost / ACTION > least && budget > 0 {
            let width = (budget / (2 * ops.len().max(1))).clamp(1, WIDEST);
            budget = budget.saturating_sub(width * ops.len());
            if let Some(better) = self.beam(problem, start, width, cost) {
                (ops, cost) = better;
            }
        }
        let mut best = cost / ACTION <= least;
        if !best && budget > 0 {
            match self.best_first(problem, start, 2, budget, cost) {
                Found::Unfinished(_) => {}
                Found::Exhausted(_) => best = true,
                better => return better,
            }
        }
        Found::Way { ops, cost, best }
    }

    /// A way of fewer actions than `than`, if there is one and the budget allows it;
    /// [`Found::Exhausted`] if there is none.
    pub(crate) fn shorter(&mut self, problem: &Problem, start: State, than: usize, budget: usize) -> Found {
        let under = (than as u32) << FINE;
        let found = self.best_first(problem, start, 2, budget / 2, under);
        if !matches!(found, Found::Unfinished(_)) {
            return found;
        }
        let width = (budget / (2 * than.max(1))).clamp(1, WIDEST);
        let beam = self.beam(problem, start, width, under);
        beam.map_or(found, |(ops, cost)| Found::Way { ops, cost, best: false })
    }

    /// A* with the bound weighted by `weight` halves; only ways of fewer actions than
    /// `under`.
    fn best_first(&mut self, problem: &Problem, start: State, weight: u32, budget: usize, under: u32) -> Found {
        self.begin(problem, start, under, FINE, weight);
        let mut expanded = 0;
        loop {
            let Some(number) = self.next() else { return Found::Exhausted(expanded) };
            let Visit { state, cost, .. } = self.visits[number];
            if problem.is_goal(&state) {
                return Found::Way { ops: self.path(number), cost, best: weight == 2 };
            }
            if expanded == budget {
                return Found::Unfinished(expanded);
            }
            expanded += 1;
            self.expand(problem, number);
        }
    }

    /// Forgets all, and starts from a state.
    fn begin(&mut self, problem: &Problem, start: State, under: u32, blur: u32, weight: u32) {
        self.visits.clear();
        self.open.clear();
        self.table.truncate(4 * SMALL_TABLE);
        self.table.fill(0);
        self.table.resize(self.table.len().max(SMALL_TABLE), 0);
        (self.under, self.blur, self.weight) = (under >> blur, blur, weight);
        self.reach(problem, start, 0, 0, Op::Start);
    }

    /// The most promising state not yet gone on from; it is now.
    fn next(&mut self) -> Option<usize> {
        loop {
            let Reverse(key) = self.open.pop()?;
            let number = key as u32 as usize;
            let visit = &mut self.visits[number];
            if !visit.closed && (visit.cost + visit.bound) >> self.blur < self.under {
                visit.closed = true;
                return Some(number);
            }
        }
    }

    /// Does all that may help in a state.
    fn expand(&mut self, problem: &Problem, number: usize) {
        let mut ops = std::mem::take(&mut self.ops);
        let Visit { state, cost, .. } = self.visits[number];
        problem.ops(&state, &mut ops);
        for &op in &ops {
            let mut next = state;
            if let Some(more) = problem.apply(&mut next, op) {
                self.reach(problem, next, cost + more, number as u32, op);
            }
        }
        self.ops = ops;
    }

    fn reach(&mut self, problem: &Problem, state: State, cost: u32, from: u32, op: Op) {
        let slot = self.slot(&state);
        let known = self.table[slot];
        let number = if known == 0 {
            let bound = problem.bound(&state);
            if (cost + bound) >> self.blur >= self.under {
                return;
            }
            self.visits.push(Visit { state, cost, bound, from, op, closed: false });
            self.table[slot] = self.visits.len() as u32;
            if self.visits.len() * 2 > self.table.len() {
                self.grow();
            }
            self.visits.len() - 1
        } else {
            let visit = &mut self.visits[known as usize - 1];
            if visit.cost <= cost {
                return;
            }
            (visit.cost, visit.from, visit.op, visit.closed) = (cost, from, op, false);
            known as usize - 1
        };
        self.open.push(Reverse(self.key(number)));
    }

    /// Weighted cost, then bound, then number, in one word that sorts as the three do.
    fn key(&self, number: usize) -> u64 {
        let Visit { cost, bound, .. } = self.visits[number];
        let whole = u64::from(2 * cost + self.weight * bound).min((1 << 18) - 1);
        whole << 46 | u64::from(bound.min((1 << 14) - 1)) << 32 | number as u64
    }

    /// Where a state is in the table, or would be.
    fn slot(&self, state: &State) -> usize {
        let mask = self.table.len() - 1;
        let mut slot = hash(state) as usize & mask;
        while self.table[slot] != 0 && self.visits[self.table[slot] as usize - 1].state != *state {
            slot = (slot + 1) & mask;
        }
        slot
    }

    fn grow(&mut self) {
        let size = self.table.len() * 4;
        self.table.clear();
        self.table.resize(size, 0);
        for number in 0..self.visits.len() {
            let slot = self.slot(&self.visits[number].state);
            self.table[slot] = number as u32 + 1;
        }
    }

    fn path(&self, number: usize) -> Vec<Op> {
        let mut ops = Vec::with_capacity(32);
        let mut visit = &self.visits[number];
        while visit.op != Op::Start {
            ops.push(visit.op);
            visit = &self.visits[visit.from as usize];
        }
        ops.reverse();
        ops
    }
}

/// Multiply and rotate over the words of a state (as in Firefox's hash).
fn hash(state: &State) -> u64 {
    let [a, b] = state.hands;
    let [c, d] = state.down;
    let small = u64::from_le_bytes([a, b, c, d, u8::from(state.fresh), state.room, 0, 0]);
    let words = [state.at, state.open, state.on, state.used, state.piles, state.needs, small];
    let mix = |hash: u64, word: u64| (hash.rotate_left(5) ^ word).wrapping_mul(0x517c_c1b7_2722_0a95);
    let hash = words.into_iter().fold(0, mix);
    hash ^ hash >> 32
}
