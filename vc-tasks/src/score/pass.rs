//! The best ways to gates, computed from the ways to their inputs.

use super::Options;
use super::assign::best_pairs;
use super::way::{Way, Worth};
use crate::compile::{Bits, Gate, GateKind, GoalProgram, Ref, Table};

/// The criterion for a fulfilled condition.
#[derive(Debug, Clone, Copy)]
pub(super) struct Met<'a> {
    /// The atoms that are true now.
    pub(super) now: &'a Bits,
    /// The atoms true at the start, if conditions that already held then do not count.
    pub(super) start: Option<&'a Bits>,
}

impl Met<'_> {
    fn has(self, program: &GoalProgram, r: Ref) -> bool {
        program.value(self.now, r) && !self.start.is_some_and(|start| program.value(start, r))
    }

    /// The number of masked inputs that are fulfilled, and the number whose negations are.
    #[inline]
    fn masked(self, gate: &Gate) -> (u32, u32) {
        let now = gate.mask.read(self.now);
        let (mut yes, mut no) = (now, gate.mask.care & !now);
        if let Some(start) = self.start {
            let start = gate.mask.read(start);
            (yes, no) = (yes & !start, no & start);
        }
        (yes.count_ones(), no.count_ones())
    }
}

/// One pass over the gates of a program. Contradictions between the ways to different gates are
/// ignored, so the value found is an upper bound for ways without contradictions.
#[derive(Debug)]
pub(super) struct Pass<'a> {
    pub(super) program: &'a GoalProgram,
    pub(super) options: Options,
    pub(super) met: Met<'a>,
    pub(super) worth: Worth,
    /// For each gate the best way to its truth and to its falsehood.
    ways: Vec<[Way; 2]>,
    /// The atoms, then gates, that must not be true, and those that must not be false.
    barred: [Bits; 2],
    /// The number of these bars.
    bars: usize,
    order: Vec<((i64, i64), u32)>,
}

impl<'a> Pass<'a> {
    /// Reuses the memory returned by [`Pass::into_memory`].
    pub(super) fn new(program: &'a GoalProgram, options: Options, met: Met<'a>, memory: Memory) -> Self {
        let Memory { mut ways, order } = memory;
        ways.clear();
        ways.resize(program.gates().len(), [Way::NONE; 2]);
        let places = program.atoms().len() + program.gates().len();
        let bars = || Bits::none(if program.shape().parts().is_empty() { 0 } else { places });
        let worth = Worth { p: 1, q: 1 };
        Self { program, options, met, worth, ways, barred: [bars(), bars()], bars: 0, order }
    }

    pub(super) fn into_memory(self) -> Memory {
        Memory { ways: self.ways, order: self.order }
    }

    /// The index of an atom or gate in the numbering of both.
    pub(super) fn place(&self, r: Ref) -> usize {
        if r.is_atom() { r.index() } else { self.program.atoms().len() + r.index() }
    }

    /// Forbids an atom or gate the truth value of this reference, or allows it again.
    pub(super) fn bar(&mut self, r: Ref, barred: bool) {
        let place = self.place(r);
        self.barred[usize::from(r.is_negated())].set(place, barred);
        self.bars = if barred { self.bars + 1 } else { self.bars - 1 };
    }

    /// Whether an atom is barred from either truth value.
    pub(super) fn is_settled(&self, atom: usize) -> bool {
        self.bars > 0 && self.barred.iter().any(|side| side.has(atom))
    }

    #[inline]
    fn is_barred(&self, r: Ref) -> bool {
        self.bars > 0 && self.barred[usize::from(r.is_negated())].has(self.place(r))
    }

    /// Whether some masked input is barred.
    #[inline]
    fn is_masked_barred(&self, gate: &Gate) -> bool {
        self.bars > 0 && self.barred.iter().any(|side| side.word(gate.mask.word as usize) & gate.mask.care != 0)
    }

    /// Computes the best way to every gate.
    pub(super) fn run(&mut self) {
        (0..self.program.gates().len()).for_each(|gate| self.run_gate(gate));
    }

    /// Computes the best way to a gate from those to its inputs.
    pub(super) fn run_gate(&mut self, index: usize) {
        let gate = self.program.gates()[index];
        for negated in [false, true] {
            if self.program.shape().matters(index, negated) {
                self.ways[index][usize::from(negated)] = self.best(index, &gate, negated);
            }
        }
    }

    /// The best way to an atom, a constant or a gate already computed.
    #[inline]
    pub(super) fn way(&self, r: Ref) -> Way {
        match () {
            () if r.is_constant() => {
                if r == Ref::TRUE {
                    Way::NOTHING
                } else {
                    Way::NONE
                }
            }
            () if self.is_barred(r) => Way::NONE,
            () if !r.is_atom() => self.ways[r.index()][usize::from(r.is_negated())],
            () => self.condition(r),
        }
    }

    fn condition(&self, r: Ref) -> Way {
        Way::new(u32::from(self.met.has(self.program, r)), 1)
    }

    fn best(&mut self, index: usize, gate: &Gate, negated: bool) -> Way {
        match gate.kind {
            GateKind::Pairs(table) if !negated && self.bars == 0 => {
                if let Some(way) = self.plain_pairs(gate, table) {
                    return way;
                }
            }
            _ if gate.mask.care != 0 && !self.is_masked_barred(gate) => return self.masked(gate, negated),
            _ => {}
        }
        let mut order = std::mem::take(&mut self.order);
        let mut sum = Way::NOTHING;
        let found = self.choose(index, negated, &mut order, &mut |r| sum = sum.and(self.chosen(r)));
        self.order = order;
        if found { sum } else { Way::NONE }
    }

    /// The way to a chosen input; the absence of pairs counts as one condition.
    fn chosen(&self, r: Ref) -> Way {
        if self.is_lack_of_pairs(r) { self.condition(r) } else { self.way(r) }
    }

    /// Whether this is the negation of a gate over pairs.
    pub(super) fn is_lack_of_pairs(&self, r: Ref) -> bool {
        let is_gate = !r.is_atom() && !r.is_constant();
        is_gate && r.is_negated() && matches!(self.program.gates()[r.index()].kind, GateKind::Pairs(_))
    }

    /// The best way to a gate over single atoms, computed from counts alone.
    fn masked(&self, gate: &Gate, negated: bool) -> Way {
        let all = gate.mask.care.count_ones();
        let (yes, no) = self.met.masked(gate);
        let some = |met: u32, number: u32| if number > all { Way::NONE } else { Way::new(met.min(number), number) };
        match (gate.kind, negated) {
            (GateKind::All, false) => some(yes, all),
            (GateKind::All, true) => some(no, 1),
            (GateKind::Any, false) => some(yes, 1),
            (GateKind::Any, true) => some(no, all),
            (GateKind::AtLeast(k), false) => some(yes, k),
            (GateKind::AtLeast(k), true) => some(no, all + 1 - k),
            (GateKind::Exactly(k), false) if self.options == Options::Bddl => some(yes, k),
            // The k true ones are taken first from the fulfilled inputs, then from those fulfilled
            // neither way.
            (GateKind::Exactly(k), false) => Way::new(yes.min(k) + no - k.saturating_sub(all - no).min(no), all),
            (GateKind::Exactly(k), true) => self.worth.better(some(yes, k + 1), some(no, all + 1 - k)),
            (GateKind::Pairs(_), _) => Way::NONE,
        }
    }

    /// The best way to pairs where each cell is one condition: the pairs already present can be
    /// completed by any others.
    fn plain_pairs(&self, gate: &Gate, table: Table) -> Option<Way> {
        let inputs = self.program.inputs(*gate);
        let plain = inputs.iter().all(|r| r.is_atom()) && table.need <= table.rows.min(table.columns);
        let met = || table.matching(|cell| self.met.has(self.program, inputs[cell])) as u32;
        plain.then(|| Way::new(met().min(table.need), table.need))
    }

    /// Passes to `take` the inputs that the best way to a gate's truth or falsehood uses; returns
    /// `false` if there is no way.
    pub(super) fn choose(
        &self,
        index: usize,
        negated: bool,
        order: &mut Vec<((i64, i64), u32)>,
        take: &mut dyn FnMut(Ref),
    ) -> bool {
        let gate = self.program.gates()[index];
        let inputs = self.program.inputs(gate);
        let all = inputs.len();
        match (gate.kind, negated) {
            (GateKind::All, false) | (GateKind::Any, true) => {
                inputs.iter().for_each(|r| take(r.negated_if(negated)));
                true
            }
            (GateKind::All, true) | (GateKind::Any, false) => self.some(inputs, 1, negated, order, take),
            (GateKind::AtLeast(k), false) => self.some(inputs, k as usize, false, order, take),
            (GateKind::AtLeast(k), true) => self.some(inputs, all + 1 - k as usize, true, order, take),
            (GateKind::Exactly(k), false) if self.options == Options::Bddl => {
                self.some(inputs, k as usize, false, order, take)
            }
            (GateKind::Exactly(k), false) => self.exactly(inputs, k as usize, order, take),
            (GateKind::Exactly(k), true) => self.other_than(inputs, k as usize, order, take),
            (GateKind::Pairs(table), false) => self.pairs(inputs, table, take),
            (GateKind::Pairs(_), true) => {
                take(!Ref::gate(index));
                true
            }
        }
    }

    /// The best inputs, as many as are asked for.
    fn some(
        &self,
        inputs: &[Ref],
        number: usize,
        negated: bool,
        order: &mut Vec<((i64, i64), u32)>,
        take: &mut dyn FnMut(Ref),
    ) -> bool {
        if number > inputs.len() {
            return false;
        }
        let rank = |r: &Ref| self.worth.rank(self.way(r.negated_if(negated)));
        if number == 1 {
            let best = inputs.iter().max_by_key(|r| rank(r));
            best.into_iter().for_each(|r| take(r.negated_if(negated)));
            return true;
        }
        sort(order, inputs.iter().map(rank));
        order[..number].iter().for_each(|&(_, i)| take(inputs[i as usize].negated_if(negated)));
        true
    }

    /// Exactly the given number true and the others false: first those that cannot be false, last
    /// those that cannot be true.
    fn exactly(
        &self,
        inputs: &[Ref],
        number: usize,
        order: &mut Vec<((i64, i64), u32)>,
        take: &mut dyn FnMut(Ref),
    ) -> bool {
        let gain = |&r: &Ref| {
            let [yes, no] = [self.way(r), self.way(!r)];
            let ((a, short_a), (b, short_b)) = (self.worth.rank(yes), self.worth.rank(no));
            match (yes.possible, no.possible) {
                (true, true) => (a - b, short_a - short_b),
                (true, false) => (i64::MAX, 0),
                (false, _) => (i64::MIN, 0),
            }
        };
        sort(order, inputs.iter().map(gain));
        order.iter().enumerate().for_each(|(at, &(_, i))| take(inputs[i as usize].negated_if(at >= number)));
        true
    }

    /// More inputs true than the given number, or so many false that fewer remain.
    fn other_than(
        &self,
        inputs: &[Ref],
        number: usize,
        order: &mut Vec<((i64, i64), u32)>,
        take: &mut dyn FnMut(Ref),
    ) -> bool {
        let [more, fewer] = [(number + 1, false), (inputs.len() + 1 - number, true)].map(|(number, negated)| {
            let mut sum = Way::NOTHING;
            let found = self.some(inputs, number, negated, order, &mut |r| sum = sum.and(self.way(r)));
            if found { sum } else { Way::NONE }
        });
        match self.worth.rank(more) >= self.worth.rank(fewer) {
            true => self.some(inputs, number + 1, false, order, take),
            false => self.some(inputs, inputs.len() + 1 - number, true, order, take),
        }
    }

    fn pairs(&self, inputs: &[Ref], table: Table, take: &mut dyn FnMut(Ref)) -> bool {
        let ways: Vec<Way> = inputs.iter().map(|&r| self.way(r)).collect();
        let cells = best_pairs(table, &ways, self.worth);
        cells.iter().flatten().for_each(|&cell| take(inputs[cell]));
        cells.is_some()
    }
}

/// The memory of a pass, reused by the next.
#[derive(Debug, Default)]
pub(super) struct Memory {
    ways: Vec<[Way; 2]>,
    order: Vec<((i64, i64), u32)>,
}

/// Sorts the indices of some ranks, best first.
fn sort(order: &mut Vec<((i64, i64), u32)>, ranks: impl Iterator<Item = (i64, i64)>) {
    order.clear();
    order.extend(ranks.zip(0..));
    order.sort_unstable_by_key(|&(rank, place)| (std::cmp::Reverse(rank), place));
}
