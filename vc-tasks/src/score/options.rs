//! The best way to a goal, without listing the ways.

use super::assign::best_pairs;
use crate::compile::{Bits, Gate, Kind, Program, Ref, Table};

/// How many conditions of the best way are met.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Credit {
    /// Conditions met.
    pub met: u32,
    /// Conditions there are; 0 if there is nothing to do, or no way.
    pub conditions: u32,
    /// Whether there is a way to the goal at all that does not contradict itself.
    pub possible: bool,
    /// Whether no better way can exist; `false` only if a goal contradicts itself in
    /// so many ways that the search was cut off.
    pub exact: bool,
}

impl Credit {
    /// The share, 0 to 1; 0 if there is no way.
    pub fn value(self) -> f64 {
        match (self.possible, self.conditions) {
            (false, _) => 0.0,
            (true, 0) => 1.0,
            (true, conditions) => f64::from(self.met) / f64::from(conditions),
        }
    }
}

/// Which ways there are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Options {
    /// Those that make the goal true.
    Sound,
    /// Those of BDDL's package: "exactly k" leaves the others alone.
    Bddl,
}

/// The best way to one gate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Way {
    pub(super) met: u32,
    pub(super) of: u32,
    pub(super) possible: bool,
}

impl Way {
    const NONE: Self = Self { met: 0, of: 0, possible: false };
    pub(super) const NOTHING: Self = Self { met: 0, of: 0, possible: true };

    pub(super) fn and(self, other: Self) -> Self {
        Self { met: self.met + other.met, of: self.of + other.of, possible: self.possible && other.possible }
    }
}

/// What a way is worth: a share p/q to beat.
#[derive(Debug, Clone, Copy)]
pub(super) struct Worth {
    pub(super) p: u32,
    pub(super) q: u32,
}

impl Worth {
    /// Larger is better; of equals the shorter.
    pub(super) fn of(self, way: Way) -> (i64, i64) {
        if !way.possible {
            return (i64::MIN, 0);
        }
        (i64::from(self.q) * i64::from(way.met) - i64::from(self.p) * i64::from(way.of), -i64::from(way.of))
    }
}

/// How often a search may branch.
const BRANCHES: u32 = 20_000;

/// Finds credits; it keeps its memory from one to the next.
#[derive(Debug, Default)]
pub struct Scorer {
    /// For each gate the best way to its truth and to its falsehood.
    ways: Vec<[Way; 2]>,
}

impl Scorer {
    /// A scorer that has scored nothing yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// See [`Program::credit`].
    pub fn credit(&mut self, program: &Program, bits: &Bits) -> Credit {
        self.best(program, Options::Sound, &|r| program.value(bits, r)).whole_if(program.holds(bits))
    }

    /// See [`Program::bddl_reward`].
    pub fn bddl_reward(&mut self, program: &Program, bits: &Bits) -> Credit {
        self.best(program, Options::Bddl, &|r| program.value(bits, r))
    }

    /// The best share of conditions met, by Dinkelbach's method.
    pub(crate) fn best(&mut self, program: &Program, options: Options, met: &dyn Fn(Ref) -> bool) -> Credit {
        let mut search = Search { program, options, met, memory: self, branches: 0 };
        let mut worth = Worth { p: 0, q: 1 };
        let mut found = search.solve(worth);
        loop {
            let better = match found {
                Some(way) if way.of > 0 => Worth { p: way.met, q: way.of },
                _ => break,
            };
            let next = search.solve(better);
            worth = better;
            match next {
                Some(way) if worth.of(way).0 > 0 => found = next,
                _ => break,
            }
        }
        let way = found.unwrap_or(Way::NONE);
        Credit { met: way.met, conditions: way.of, possible: way.possible, exact: search.branches < BRANCHES }
    }

    /// The fewest conditions that are not met but would make the goal hold: negated
    /// references are to become false. `None` if there is no way.
    pub(crate) fn unmet(&mut self, program: &Program, of: Ref, bits: &Bits) -> Option<Vec<Ref>> {
        let met = |r: Ref| program.value(bits, r);
        let mut search = Search { program, options: Options::Sound, met: &met, memory: self, branches: 0 };
        let mut list = search.solve_list(of, Worth { p: 1, q: 1 })?;
        list.retain(|&r| !met(r));
        list.sort_unstable();
        list.dedup();
        Some(list)
    }
}

impl Credit {
    /// 1 if and only if the goal holds: a pairing by margins may hold without one of
    /// its ways.
    fn whole_if(self, holds: bool) -> Self {
        match holds {
            true => Self { met: self.conditions, possible: true, ..self },
            false => self,
        }
    }
}

struct Search<'a, 'm> {
    program: &'a Program,
    options: Options,
    /// Whether a condition counts as met.
    met: &'a dyn Fn(Ref) -> bool,
    memory: &'m mut Scorer,
    branches: u32,
}

impl Search<'_, '_> {
    /// The way to the goal that is worth most.
    fn solve(&mut self, worth: Worth) -> Option<Way> {
        if !self.program.is_mixed() {
            let way = self.pass(self.program.root(), worth, &[]);
            return way.possible.then_some(way);
        }
        let list = self.solve_list(self.program.root(), worth)?;
        let met = list.iter().filter(|&&r| (self.met)(r)).count() as u32;
        Some(Way { met, of: list.len() as u32, possible: true })
    }

    /// The same, as a list of conditions. Branch and bound: the best way when
    /// contradictions are let pass is a bound for those without.
    fn solve_list(&mut self, root: Ref, worth: Worth) -> Option<Vec<Ref>> {
        let mut best: Option<((i64, i64), Vec<Ref>)> = None;
        let mut open = vec![Vec::new()];
        while let Some(forbidden) = open.pop() {
            let way = self.pass(root, worth, &forbidden);
            let bound = worth.of(way);
            if !way.possible || best.as_ref().is_some_and(|(value, _)| bound <= *value) {
                continue;
            }
            let mut list = Vec::new();
            self.collect(root, worth, &forbidden, &mut list);
            match contradiction(&list) {
                None => best = Some((bound, list)),
                Some(atom) if self.branches < BRANCHES => {
                    self.branches += 1;
                    // The one that is met is kept first.
                    let first = if (self.met)(atom) { [atom, !atom] } else { [!atom, atom] };
                    open.extend(first.map(|r| forbidden.iter().copied().chain([r]).collect::<Vec<Ref>>()));
                }
                Some(_) => {}
            }
        }
        best.map(|(_, list)| list)
    }

    /// One pass over the gates up to `root`.
    fn pass(&mut self, root: Ref, worth: Worth, forbidden: &[Ref]) -> Way {
        let last = if root.is_atom() || root.is_constant() { 0 } else { root.index() + 1 };
        self.memory.ways.clear();
        for index in 0..last {
            let gate = self.program.gates()[index];
            let ways = [false, true].map(|negated| self.gate(index, gate, negated, worth, forbidden, &mut None));
            self.memory.ways.push(ways);
        }
        self.way(root, forbidden)
    }

    fn way(&self, r: Ref, forbidden: &[Ref]) -> Way {
        if r.is_constant() {
            return if r == Ref::TRUE { Way::NOTHING } else { Way::NONE };
        }
        if !r.is_atom() {
            return self.memory.ways[r.index()][usize::from(r.is_negated())];
        }
        if forbidden.contains(&r) { Way::NONE } else { self.condition(r) }
    }

    fn condition(&self, r: Ref) -> Way {
        Way { met: u32::from((self.met)(r)), of: 1, possible: true }
    }

    /// The conditions of the best way to something, after a pass.
    fn collect(&mut self, r: Ref, worth: Worth, forbidden: &[Ref], list: &mut Vec<Ref>) {
        if r.is_constant() {
            return;
        }
        if r.is_atom() {
            return list.push(r);
        }
        let gate = self.program.gates()[r.index()];
        if matches!(gate.kind, Kind::Pairs(_)) && r.is_negated() {
            return list.push(r);
        }
        let mut chosen = Some(Vec::new());
        self.gate(r.index(), gate, r.is_negated(), worth, forbidden, &mut chosen);
        for input in chosen.unwrap_or_default() {
            self.collect(input, worth, forbidden, list);
        }
    }

    /// The best way to a gate's truth or falsehood, given those to its inputs, and
    /// which of these it takes.
    fn gate(
        &mut self,
        index: usize,
        gate: Gate,
        negated: bool,
        worth: Worth,
        forbidden: &[Ref],
        chosen: &mut Option<Vec<Ref>>,
    ) -> Way {
        let number = (gate.end - gate.start) as usize;
        let mut pick = Pick { search: self, gate, worth, forbidden, chosen };
        match (gate.kind, negated) {
            (Kind::All, false) | (Kind::Any, true) => pick.every(negated),
            (Kind::All, true) | (Kind::Any, false) => pick.one(negated),
            (Kind::AtLeast(k), false) => pick.some(k as usize, false),
            (Kind::AtLeast(k), true) => pick.some(number + 1 - k as usize, true),
            (Kind::Exactly(k), false) if pick.search.options == Options::Bddl => pick.some(k as usize, false),
            (Kind::Exactly(k), false) => pick.exactly(k as usize),
            (Kind::Exactly(k), true) => pick.other_than(k as usize, number),
            (Kind::Pairs(table), false) => pick.pairs(table),
            // That too many pairs must not exist is one condition.
            (Kind::Pairs(_), true) => pick.search.condition(!Ref::gate(index)),
        }
    }
}

/// An atom that a list wants both true and false.
fn contradiction(list: &[Ref]) -> Option<Ref> {
    let mut sorted: Vec<Ref> = list.to_vec();
    sorted.sort_unstable();
    sorted.dedup();
    sorted.windows(2).find(|w| w[0].plain() == w[1].plain()).map(|w| w[0].plain())
}

/// A choice among the inputs of a gate.
struct Pick<'s, 'a, 'm, 'c> {
    search: &'s mut Search<'a, 'm>,
    gate: Gate,
    worth: Worth,
    forbidden: &'c [Ref],
    chosen: &'c mut Option<Vec<Ref>>,
}

impl<'a> Pick<'_, 'a, '_, '_> {
    fn inputs(&self) -> &'a [Ref] {
        self.search.program.inputs(self.gate)
    }

    fn way(&self, r: Ref) -> Way {
        self.search.way(r, self.forbidden)
    }

    /// Takes an input; a chosen one that is not possible makes the whole so.
    fn take(&mut self, r: Ref) -> Way {
        if let Some(chosen) = self.chosen {
            chosen.push(r);
        }
        self.way(r)
    }

    fn every(&mut self, negated: bool) -> Way {
        self.inputs().iter().fold(Way::NOTHING, |sum, r| sum.and(self.take(r.negated_if(negated))))
    }

    fn one(&mut self, negated: bool) -> Way {
        let inputs = self.inputs().iter().map(|r| r.negated_if(negated));
        let best = inputs.max_by_key(|&r| self.worth.of(self.way(r)));
        best.map_or(Way::NONE, |r| self.take(r))
    }

    /// The best so many.
    fn some(&mut self, number: usize, negated: bool) -> Way {
        let inputs = self.inputs();
        if number > inputs.len() {
            return Way::NONE;
        }
        let mut order: Vec<usize> = (0..inputs.len()).collect();
        order.sort_by_cached_key(|&i| std::cmp::Reverse(self.worth.of(self.way(inputs[i].negated_if(negated)))));
        order[..number].iter().fold(Way::NOTHING, |sum, &i| sum.and(self.take(inputs[i].negated_if(negated))))
    }

    /// So many true and the others false: first those that cannot be false, last
    /// those that cannot be true.
    fn exactly(&mut self, number: usize) -> Way {
        let inputs = self.inputs();
        let gain = |i: &usize| {
            let [yes, no] = [inputs[*i], !inputs[*i]].map(|r| self.way(r));
            let ((a, short_a), (b, short_b)) = (self.worth.of(yes), self.worth.of(no));
            match (yes.possible, no.possible) {
                (true, true) => (a - b, short_a - short_b),
                (true, false) => (i64::MAX, 0),
                (false, _) => (i64::MIN, 0),
            }
        };
        let mut order: Vec<usize> = (0..inputs.len()).collect();
        order.sort_by_cached_key(|i| std::cmp::Reverse(gain(i)));
        let sides = order.iter().enumerate().map(|(at, &i)| inputs[i].negated_if(at >= number));
        sides.fold(Way::NOTHING, |sum, r| sum.and(self.take(r)))
    }

    /// More true than so many, or more false than would leave so many.
    fn other_than(&mut self, number: usize, inputs: usize) -> Way {
        let chosen = self.chosen.take();
        let (more, fewer) = (self.some(number + 1, false), self.some(inputs + 1 - number, true));
        *self.chosen = chosen;
        if self.worth.of(more) >= self.worth.of(fewer) {
            self.some(number + 1, false)
        } else {
            self.some(inputs + 1 - number, true)
        }
    }

    fn pairs(&mut self, table: Table) -> Way {
        let inputs = self.inputs();
        let ways: Vec<Way> = inputs.iter().map(|&r| self.way(r)).collect();
        match best_pairs(table, &ways, self.worth) {
            None => Way::NONE,
            Some(cells) => cells.into_iter().fold(Way::NOTHING, |sum, cell| sum.and(self.take(inputs[cell]))),
        }
    }
}
