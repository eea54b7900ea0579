//! Minimal sets of what is missing.
//!
//! Found as Reiter finds diagnoses (Artificial Intelligence 32, 1987): while the goal
//! does not hold, some atoms alone keep it so, and one of them must change. Each is
//! tried in turn, the sets that may come to be smallest first (A*; Hart, Nilsson and
//! Raphael 1968), by a bound on what is still missing.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::fmt;

use crate::compile::{Atom, Bits, Gate, Kind, Program, Ref};

/// A condition that is not met: an atom that is to become true, or false.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Unmet {
    /// The atom.
    pub atom: Atom,
    /// What it is to be.
    pub wanted: bool,
}

impl fmt::Display for Unmet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", if self.wanted { "" } else { "!" }, self.atom)
    }
}

/// Sets of conditions that are not met and would make a goal hold.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct MinimalSets {
    /// The sets, smallest first: met together the conditions of a set make the goal
    /// hold, and those of no part of it do.
    pub sets: Vec<Vec<Unmet>>,
    /// Whether there are no others.
    pub complete: bool,
}

/// How many looks at gates a search may take: about a second.
const LOOKS: usize = 1 << 24;

impl Program {
    /// The minimal sets of conditions that are not met and would together make the
    /// goal hold: at most `most`, the smallest first. One empty set if it holds, none
    /// if nothing can make it hold.
    ///
    /// The search is given up after 16,777,216 looks at gates, with what was found by
    /// then; [`MinimalSets::complete`] tells.
    ///
    /// ```
    /// use vc_graph::goal::Situation;
    /// use vc_graph::{Draft, History, SceneBuilder};
    /// use vc_tasks::compile::Program;
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// scene.add_in(kitchen, Draft::new("cup"))?;
    /// scene.add_in(kitchen, Draft::new("plate"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let (graph, history) = (scene.build(), History::default());
    /// let now = Situation::new(&graph, me, &history);
    /// let goal = "(Dirty(cup) & Dirty(plate)) | On(cup, plate)".parse()?;
    /// let program = Program::new(&goal, &now)?;
    /// let found = program.unmet(&program.read(&now), 10);
    /// let sets: Vec<String> = found.sets.iter().map(|set| format!("{}", set[0])).collect();
    /// assert_eq!((sets, found.complete), (vec!["On(#2, #3)".to_owned(), "Dirty(#2)".to_owned()], true));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn unmet(&self, bits: &Bits, most: usize) -> MinimalSets {
        Search::new(self, self.root(), bits).run(most)
    }

    /// The same for one conjunct, counted from zero; none for one that is not there.
    pub fn unmet_of_head(&self, bits: &Bits, head: usize, most: usize) -> MinimalSets {
        self.head(head).map_or_else(MinimalSets::default, |of| Search::new(self, of, bits).run(most))
    }
}

/// Atoms that have been changed and such that must not be.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
struct Try {
    changed: Vec<u32>,
    kept: Vec<u32>,
}

struct Search<'a> {
    program: &'a Program,
    of: Ref,
    /// The atoms as they are in what is tried.
    bits: Bits,
    /// Atoms that may still change.
    open: Bits,
    /// For each gate what it takes at least to make it true, and to make it false.
    costs: Vec<[f64; 2]>,
    looks: usize,
}

impl<'a> Search<'a> {
    fn new(program: &'a Program, of: Ref, bits: &Bits) -> Self {
        let mut open = program.bits();
        (0..program.atoms().len()).for_each(|atom| open.set(atom, true));
        Self { program, of, bits: bits.clone(), open, costs: Vec::new(), looks: 0 }
    }

    fn run(&mut self, most: usize) -> MinimalSets {
        let mut found: Vec<Vec<u32>> = Vec::new();
        let mut queue = BinaryHeap::new();
        let mut complete = true;
        queue.extend(self.bound().map(|least| Reverse((least, 0, Try { changed: Vec::new(), kept: Vec::new() }))));
        while let Some(Reverse((_, _, next))) = queue.pop() {
            if found.len() == most || self.looks > LOOKS {
                complete = false;
                break;
            }
            if found.iter().any(|set| set.iter().all(|atom| next.changed.contains(atom))) {
                continue;
            }
            self.enter(&next, true);
            if self.program.value(&self.bits, self.of) {
                found.push(next.changed.clone());
            } else {
                queue.extend(self.branches(&next));
            }
            self.enter(&next, false);
        }
        let sets = found.iter().map(|set| self.named(set)).collect();
        MinimalSets { sets, complete }
    }

    fn named(&self, set: &[u32]) -> Vec<Unmet> {
        let unmet = |&atom: &u32| {
            let atom = atom as usize;
            Unmet { atom: self.program.atoms()[atom], wanted: !self.bits.has(atom) }
        };
        let mut sorted = set.to_vec();
        sorted.sort_unstable();
        sorted.iter().map(unmet).collect()
    }

    /// Makes the atoms as they are in a try, or as they were.
    fn enter(&mut self, next: &Try, here: bool) {
        for &atom in &next.changed {
            let value = self.bits.has(atom as usize);
            self.bits.set(atom as usize, !value);
        }
        next.changed.iter().chain(&next.kept).for_each(|&atom| self.open.set(atom as usize, !here));
    }

    /// One try for each atom that may be what keeps the goal from holding: it changes,
    /// and those before it do not.
    fn branches(&mut self, from: &Try) -> Vec<Reverse<(usize, usize, Try)>> {
        let mut why = Vec::new();
        self.why(self.of, &mut why);
        why.sort_unstable();
        why.dedup();
        let mut tries = Vec::new();
        let mut next = from.clone();
        for atom in why {
            next.changed.push(atom);
            self.enter(&Try { changed: vec![atom], kept: Vec::new() }, true);
            if let Some(least) = self.bound() {
                // Of equals those that are further come first.
                tries.push(Reverse((next.changed.len() + least, usize::MAX - next.changed.len(), next.clone())));
            }
            self.enter(&Try { changed: vec![atom], kept: Vec::new() }, false);
            next.changed.pop();
            next.kept.push(atom);
            self.open.set(atom as usize, false);
        }
        next.kept.iter().for_each(|&atom| self.open.set(atom as usize, true));
        from.kept.iter().for_each(|&atom| self.open.set(atom as usize, false));
        tries
    }
}

/// What must change.
impl Search<'_> {
    /// Atoms that may change and that alone keep something as it is.
    fn why(&mut self, r: Ref, found: &mut Vec<u32>) {
        self.looks += 1;
        if r.is_constant() {
            return;
        }
        if r.is_atom() {
            found.extend(self.open.has(r.index()).then_some(r.index() as u32));
            return;
        }
        let gate = self.program.gates()[r.index()];
        let mut inputs = self.program.inputs(gate).to_vec();
        inputs.dedup();
        let holds = self.program.value(&self.bits, Ref::gate(r.index()));
        if matches!(gate.kind, Kind::Exactly(_)) && holds {
            return inputs.into_iter().for_each(|input| self.why(input, found));
        }
        let (number, value) = self.decisive(gate, holds);
        let mut reasons: Vec<Vec<u32>> = Vec::new();
        inputs.retain(|&input| self.program.value(&self.bits, input) == value);
        for input in inputs {
            let mut atoms = Vec::new();
            self.why(input, &mut atoms);
            reasons.push(atoms);
        }
        // Those that leave the fewest atoms to try.
        reasons.sort_by_key(Vec::len);
        found.extend(reasons.into_iter().take(number).flatten());
    }

    /// How many inputs of which value make a gate what it is.
    fn decisive(&self, gate: Gate, holds: bool) -> (usize, bool) {
        let all = gate.inputs().len();
        match (gate.kind, holds) {
            (Kind::All, true) | (Kind::Any, false) | (Kind::Pairs(_), _) => (all, holds),
            (Kind::All, false) | (Kind::Any, true) => (1, holds),
            (Kind::AtLeast(k), true) => (k as usize, true),
            (Kind::AtLeast(k), false) => (all + 1 - k as usize, false),
            (Kind::Exactly(_), true) => (all, true),
            (Kind::Exactly(k), false) => {
                let found = self.program.inputs(gate).iter().filter(|&&r| self.program.value(&self.bits, r)).count();
                if found > k as usize { (k as usize + 1, true) } else { (all + 1 - k as usize, false) }
            }
        }
    }
}

/// What it takes at least.
impl Search<'_> {
    /// How many atoms must change at least; `None` if that does not help.
    ///
    /// An atom that stands in several places counts in each for its part, so that it
    /// counts for one at most.
    fn bound(&mut self) -> Option<usize> {
        let last = if self.of.is_atom() || self.of.is_constant() { 0 } else { self.of.index() + 1 };
        self.costs.clear();
        for index in 0..last {
            let gate = self.program.gates()[index];
            self.looks += 1 + gate.inputs().len();
            let costs = [true, false].map(|wanted| self.gate_cost(gate, wanted));
            self.costs.push(costs);
        }
        let cost = self.cost(self.of, true);
        cost.is_finite().then(|| (cost - 1e-6).ceil().max(0.0) as usize)
    }

    fn cost(&self, r: Ref, wanted: bool) -> f64 {
        let wanted = wanted != r.is_negated();
        match () {
            () if r.is_constant() => {
                if wanted {
                    0.0
                } else {
                    f64::INFINITY
                }
            }
            () if !r.is_atom() => self.costs[r.index()][usize::from(!wanted)],
            () if self.bits.has(r.index()) == wanted => 0.0,
            () if self.open.has(r.index()) => 1.0 / f64::from(self.program.shape().paths(r.index())),
            () => f64::INFINITY,
        }
    }

    fn gate_cost(&self, gate: Gate, wanted: bool) -> f64 {
        let inputs = self.program.inputs(gate);
        let all = inputs.len();
        match (gate.kind, wanted) {
            (Kind::All, true) | (Kind::Any, false) => self.least(inputs, all, wanted),
            (Kind::All, false) | (Kind::Any, true) => self.least(inputs, 1, wanted),
            (Kind::AtLeast(k), true) => self.least(inputs, k as usize, true),
            (Kind::AtLeast(k), false) => self.least(inputs, all + 1 - k as usize, false),
            (Kind::Exactly(k), true) => {
                self.least(inputs, k as usize, true).max(self.least(inputs, all - k as usize, false))
            }
            (Kind::Exactly(k), false) => {
                let (more, fewer) = (k as usize + 1, all + 1 - k as usize);
                self.least(inputs, more, true).min(self.least(inputs, fewer, false))
            }
            // So many pairs take so many cells, and one of those there must end.
            (Kind::Pairs(table), true) => self.least(inputs, table.need as usize, true),
            (Kind::Pairs(table), false) => match table.is_met(|cell| self.program.value(&self.bits, inputs[cell])) {
                true => self.least(inputs, 1, false),
                false => 0.0,
            },
        }
    }

    /// What the cheapest so many take.
    fn least(&self, inputs: &[Ref], number: usize, wanted: bool) -> f64 {
        if number > inputs.len() {
            return f64::INFINITY;
        }
        let costs = inputs.iter().map(|&r| self.cost(r, wanted));
        if number == 1 {
            return costs.fold(f64::INFINITY, f64::min);
        }
        let mut costs: Vec<f64> = costs.collect();
        costs.sort_unstable_by(f64::total_cmp);
        costs[..number].iter().sum()
    }
}
