//! Best-first search over packed states.
//!
//! Weighted A* (Pohl 1970) gives a first answer; the search is then run again with
//! less weight as long as its budget lasts, as in anytime A* (Likhachev, Gordon and
//! Thrun 2003). The result depends on the budget in expansions, never on a clock.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::packed::{Op, Problem, State};

/// How much a search may do.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Effort {
    /// States looked at for the first answer.
    pub first: usize,
    /// States looked at to prove or improve it.
    pub improve: usize,
}

impl Effort {
    /// A first answer and nothing more.
    pub const QUICK: Self = Self { first: 4_000, improve: 0 };
    /// Proves the best for about six predicates.
    pub const THOROUGH: Self = Self { first: 4_000, improve: 20_000 };
}

impl Default for Effort {
    fn default() -> Self {
        Self::THOROUGH
    }
}

/// What a search came to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Found {
    /// Macros to the goal, what they cost, and whether nothing is cheaper.
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
    open: BinaryHeap<Reverse<(u32, u32, u32)>>,
    ops: Vec<Op>,
}

const SMALL_TABLE: usize = 256;

impl Search {
    /// The cheapest way from a state to the goal that the effort allows.
    pub(crate) fn solve(&mut self, problem: &Problem, start: State, effort: Effort) -> Found {
        let first = self.run(problem, start, 3, effort.first, u32::MAX);
        let Found::Way { cost, .. } = first else { return first };
        if effort.improve == 0 {
            return first;
        }
        match self.run(problem, start, 2, effort.improve, cost) {
            Found::Unfinished(_) => first,
            Found::Exhausted(_) => match first {
                Found::Way { ops, cost, .. } => Found::Way { ops, cost, best: true },
                other => other,
            },
            better => better,
        }
    }

    /// A* with the bound weighted by `weight` halves; only ways cheaper than `under`.
    fn run(&mut self, problem: &Problem, start: State, weight: u32, budget: usize, under: u32) -> Found {
        self.clear();
        self.reach(problem, start, 0, 0, Op::Start, weight, under);
        let mut expanded = 0;
        let mut ops = std::mem::take(&mut self.ops);
        let found = loop {
            let Some(Reverse((_, _, number))) = self.open.pop() else { break Found::Exhausted(expanded) };
            let visit = self.visits[number as usize];
            if visit.closed {
                continue;
            }
            self.visits[number as usize].closed = true;
            if problem.is_goal(&visit.state) {
                break Found::Way { ops: self.path(number), cost: visit.cost, best: weight == 2 };
            }
            if expanded == budget {
                break Found::Unfinished(expanded);
            }
            expanded += 1;
            problem.ops(&visit.state, &mut ops);
            for &op in &ops {
                let mut next = visit.state;
                if let Some(cost) = problem.apply(&mut next, op) {
                    self.reach(problem, next, visit.cost + cost, number, op, weight, under);
                }
            }
        };
        self.ops = ops;
        found
    }

    fn clear(&mut self) {
        self.visits.clear();
        self.open.clear();
        if self.table.len() > 4 * SMALL_TABLE {
            self.table.truncate(SMALL_TABLE);
        }
        self.table.fill(0);
        self.table.resize(self.table.len().max(SMALL_TABLE), 0);
    }

    #[allow(clippy::too_many_arguments, reason = "one step of a search")]
    fn reach(&mut self, problem: &Problem, state: State, cost: u32, from: u32, op: Op, weight: u32, under: u32) {
        let slot = self.slot(&state);
        let known = self.table[slot];
        let number = if known == 0 {
            let bound = problem.bound(&state);
            if cost + bound >= under {
                return;
            }
            self.visits.push(Visit { state, cost, bound, from, op, closed: false });
            self.table[slot] = self.visits.len() as u32;
            if self.visits.len() * 2 > self.table.len() {
                self.grow();
            }
            self.visits.len() as u32 - 1
        } else {
            let visit = &mut self.visits[known as usize - 1];
            if visit.cost <= cost {
                return;
            }
            (visit.cost, visit.from, visit.op, visit.closed) = (cost, from, op, false);
            known - 1
        };
        let bound = self.visits[number as usize].bound;
        self.open.push(Reverse((2 * cost + weight * bound, bound, number)));
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

    fn path(&self, mut number: u32) -> Vec<Op> {
        let mut ops = Vec::new();
        while self.visits[number as usize].op != Op::Start {
            ops.push(self.visits[number as usize].op);
            number = self.visits[number as usize].from;
        }
        ops.reverse();
        ops
    }
}

/// Multiply and rotate over the words of a state (as in Firefox's hash).
fn hash(state: &State) -> u64 {
    let mut hash = 0u64;
    let mut add = |word: u64| hash = (hash.rotate_left(5) ^ word).wrapping_mul(0x517c_c1b7_2722_0a95);
    [state.at, state.open, state.on, state.used].into_iter().for_each(&mut add);
    for bytes in [&state.piles, &state.needs] {
        for chunk in bytes.chunks_exact(8) {
            add(chunk.iter().fold(0, |word, &b| word << 8 | u64::from(b)));
        }
    }
    let [a, b] = state.hands;
    let [c, d] = state.down;
    add([a, b, c, d, u8::from(state.fresh), state.room].iter().fold(0, |word, &b| word << 8 | u64::from(b)));
    hash ^ hash >> 29
}
