//! Minimal sets of missing conditions.
//!
//! The search follows Reiter's computation of diagnoses (Artificial Intelligence 32, 1987): while the
//! goal does not hold, some set of atoms is alone enough to keep it so, and one of these atoms must
//! change. Each is tried in turn, best first (A*; Hart, Nilsson and Raphael 1968) by the size of the set
//! so far plus a lower bound on what is still missing.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::fmt;

use crate::compile::{Bits, Gate, GateKind, GoalProgram, GroundAtom, Ref};

/// A missing condition: an atom that has to become true, or false.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Unmet {
    /// The atom.
    pub atom: GroundAtom,
    /// The truth value it has to take.
    pub wanted: bool,
}

impl fmt::Display for Unmet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", if self.wanted { "" } else { "!" }, self.atom)
    }
}

/// The minimal sets of missing conditions that would make a goal hold.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct MinimalSets {
    /// The sets, smallest first: fulfilling all conditions of a set makes the goal hold, fulfilling only
    /// a proper subset does not.
    pub sets: Vec<Vec<Unmet>>,
    /// Whether these are all.
    pub complete: bool,
}

/// The limit of gate visits in a search: about a second.
const VISITS: usize = 1 << 24;

impl GoalProgram {
    /// The minimal sets of missing conditions that would together make the goal hold: at most `most`, the
    /// smallest first. One empty set if the goal holds, no set if nothing can make it hold.
    ///
    /// The search ends after 16,777,216 gate visits and returns the sets found until then, with
    /// [`MinimalSets::complete`] false.
    ///
    /// ```
    /// use vc_graph::goal::Situation;
    /// use vc_graph::{Draft, History, SceneBuilder};
    /// use vc_tasks::compile::GoalProgram;
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// scene.add_in(kitchen, Draft::new("cup"))?;
    /// scene.add_in(kitchen, Draft::new("plate"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let (graph, history) = (scene.build(), History::default());
    /// let now = Situation::new(&graph, me, &history);
    /// let goal = "(Dirty(cup) & Dirty(plate)) | On(cup, plate)".parse()?;
    /// let program = GoalProgram::new(&goal, &now)?;
    /// let found = program.unmet(&program.read(&now), 10);
    /// let sets: Vec<String> = found.sets.iter().map(|set| format!("{}", set[0])).collect();
    /// assert_eq!((sets, found.complete), (vec!["On(#2, #3)".to_owned(), "Dirty(#2)".to_owned()], true));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn unmet(&self, bits: &Bits, most: usize) -> MinimalSets {
        Search::new(self, self.root(), bits).run(most)
    }

    /// The same for one conjunct, counted from zero; no sets if the index is out of range.
    pub(crate) fn unmet_of_head(&self, bits: &Bits, head: usize, most: usize) -> MinimalSets {
        self.head(head).map_or_else(MinimalSets::default, |of| Search::new(self, of, bits).run(most))
    }
}

/// A node of the search: the atoms that were changed, and those that must not be.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
struct Try {
    changed: Vec<u32>,
    kept: Vec<u32>,
}

struct Search<'a> {
    program: &'a GoalProgram,
    of: Ref,
    /// The truth values in the node under consideration.
    bits: Bits,
    /// The atoms that may still change.
    open: Bits,
    /// For each gate a lower bound of the changes that make it true, and of those that make it false.
    costs: Vec<[f64; 2]>,
    visits: usize,
}

impl<'a> Search<'a> {
    fn new(program: &'a GoalProgram, of: Ref, bits: &Bits) -> Self {
        let mut open = program.bits();
        (0..program.atoms().len()).for_each(|atom| open.set(atom, true));
        Self { program, of, bits: bits.clone(), open, costs: Vec::new(), visits: 0 }
    }

    fn run(&mut self, most: usize) -> MinimalSets {
        let mut found: Vec<Vec<u32>> = Vec::new();
        let mut queue = BinaryHeap::new();
        let mut complete = true;
        queue.extend(self.bound().map(|least| Reverse((least, 0, Try { changed: Vec::new(), kept: Vec::new() }))));
        while let Some(Reverse((_, _, next))) = queue.pop() {
            if found.len() == most || self.visits > VISITS {
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

    /// Applies the changes of a node, or takes them back.
    fn enter(&mut self, next: &Try, here: bool) {
        for &atom in &next.changed {
            let value = self.bits.has(atom as usize);
            self.bits.set(atom as usize, !value);
        }
        next.changed.iter().chain(&next.kept).for_each(|&atom| self.open.set(atom as usize, !here));
    }

    /// One child for each atom that may keep the goal from holding: that atom changes, and the ones
    /// before it do not.
    fn branches(&mut self, from: &Try) -> Vec<Reverse<(usize, usize, Try)>> {
        let mut atoms = Vec::new();
        self.sufficient_atoms(self.of, &mut atoms);
        atoms.sort_unstable();
        atoms.dedup();
        let mut tries = Vec::new();
        let mut next = from.clone();
        for atom in atoms {
            next.changed.push(atom);
            self.enter(&Try { changed: vec![atom], kept: Vec::new() }, true);
            if let Some(least) = self.bound() {
                // Among equals the larger set comes first.
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

/// The atoms of which one must change.
impl Search<'_> {
    /// Open atoms that are together enough to keep a gate or atom at its current value.
    fn sufficient_atoms(&mut self, r: Ref, found: &mut Vec<u32>) {
        self.visits += 1;
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
        if matches!(gate.kind, GateKind::Exactly(_)) && holds {
            return inputs.into_iter().for_each(|input| self.sufficient_atoms(input, found));
        }
        let (number, value) = self.decisive(gate, holds);
        let mut reasons: Vec<Vec<u32>> = Vec::new();
        inputs.retain(|&input| self.program.value(&self.bits, input) == value);
        for input in inputs {
            let mut atoms = Vec::new();
            self.sufficient_atoms(input, &mut atoms);
            reasons.push(atoms);
        }
        // The inputs with the fewest atoms to try come first.
        reasons.sort_by_key(Vec::len);
        found.extend(reasons.into_iter().take(number).flatten());
    }

    /// The number of inputs, and their value, that are enough to determine a gate's current value.
    fn decisive(&self, gate: Gate, holds: bool) -> (usize, bool) {
        let all = gate.inputs().len();
        match (gate.kind, holds) {
            (GateKind::All, true) | (GateKind::Any, false) | (GateKind::Pairs(_), _) => (all, holds),
            (GateKind::All, false) | (GateKind::Any, true) => (1, holds),
            (GateKind::AtLeast(k), true) => (k as usize, true),
            (GateKind::AtLeast(k), false) => (all + 1 - k as usize, false),
            (GateKind::Exactly(_), true) => (all, true),
            (GateKind::Exactly(k), false) => {
                let found = self.program.inputs(gate).iter().filter(|&&r| self.program.value(&self.bits, r)).count();
                if found > k as usize { (k as usize + 1, true) } else { (all + 1 - k as usize, false) }
            }
        }
    }
}

/// Lower bounds.
impl Search<'_> {
    /// The least number of atoms that must change; `None` if no change helps.
    ///
    /// An atom used in several places counts a fraction in each, so that it counts at most once in total.
    fn bound(&mut self) -> Option<usize> {
        let last = if self.of.is_atom() || self.of.is_constant() { 0 } else { self.of.index() + 1 };
        self.costs.clear();
        for index in 0..last {
            let gate = self.program.gates()[index];
            self.visits += 1 + gate.inputs().len();
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
            (GateKind::All, true) | (GateKind::Any, false) => self.least(inputs, all, wanted),
            (GateKind::All, false) | (GateKind::Any, true) => self.least(inputs, 1, wanted),
            (GateKind::AtLeast(k), true) => self.least(inputs, k as usize, true),
            (GateKind::AtLeast(k), false) => self.least(inputs, all + 1 - k as usize, false),
            (GateKind::Exactly(k), true) => {
                self.least(inputs, k as usize, true).max(self.least(inputs, all - k as usize, false))
            }
            (GateKind::Exactly(k), false) => {
                let (more, fewer) = (k as usize + 1, all + 1 - k as usize);
                self.least(inputs, more, true).min(self.least(inputs, fewer, false))
            }
            // A number of pairs takes as many true cells; to undo a matching, at least one of its cells
            // must become false.
            (GateKind::Pairs(table), true) => self.least(inputs, table.need as usize, true),
            (GateKind::Pairs(table), false) => {
                match table.is_met(|cell| self.program.value(&self.bits, inputs[cell])) {
                    true => self.least(inputs, 1, false),
                    false => 0.0,
                }
            }
        }
    }

    /// The sum of the lowest costs.
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
