//! Whether a goal can be fulfilled.
//!
//! The search of Davis, Logemann and Loveland (CACM 1962) on the gates themselves: consequences of
//! known values are propagated from inputs to gates and back; then an undecided gate nearest the
//! root is tried true and, if that fails, false.

use vc_graph::goal::Predicate;

use crate::compile::{Gate, GateKind, GoalProgram, Ref, Verdict, counts};

/// The limit of gate visits before giving up: about a second. The hardest goal of the 1,016 of
/// BEHAVIOR-1K takes some thousand.
const VISITS: usize = 1 << 24;

/// Whether some state fulfils a goal without two opposite states of one object; unknown if the
/// limit was reached.
pub(super) fn satisfiable(program: &GoalProgram) -> Verdict {
    let mut values = Values::new(program);
    if !values.set(program.root(), true) || !values.propagate() {
        return Verdict::False;
    }
    // The stack of the search: known values, and the place that is tried false next.
    let mut open: Vec<(Vec<Verdict>, usize)> = Vec::new();
    while values.visits < VISITS {
        let Some(place) = values.undecided() else { return Verdict::True };
        open.push((values.known.clone(), place));
        let mut fits = values.learn(place, true) && values.propagate();
        while !fits {
            let Some((known, place)) = open.pop() else { return Verdict::False };
            values.known = known;
            fits = values.learn(place, false) && values.propagate();
        }
    }
    Verdict::Unknown
}

/// The known values of atoms and gates.
struct Values<'p> {
    program: &'p GoalProgram,
    /// The atoms, then the gates.
    known: Vec<Verdict>,
    /// Pairs of atoms of which at most one is true.
    apart: Vec<[usize; 2]>,
    visits: usize,
}

impl<'p> Values<'p> {
    fn new(program: &'p GoalProgram) -> Self {
        let known = vec![Verdict::Unknown; program.atoms().len() + program.gates().len()];
        Self { program, known, apart: apart(program), visits: 0 }
    }

    fn place(&self, r: Ref) -> usize {
        if r.is_atom() { r.index() } else { self.program.atoms().len() + r.index() }
    }

    fn at(&self, r: Ref) -> Verdict {
        let plain = if r.is_constant() { Verdict::True } else { self.known[self.place(r)] };
        plain.negated_if(r.is_negated())
    }

    /// Sets a value; returns `false` if it contradicts the known one.
    fn set(&mut self, r: Ref, value: bool) -> bool {
        let value = value != r.is_negated();
        if r.is_constant() { value } else { self.learn(self.place(r), value) }
    }

    fn learn(&mut self, place: usize, value: bool) -> bool {
        if self.known[place] == Verdict::Unknown {
            self.known[place] = Verdict::from_bool(value);
        }
        self.known[place] == Verdict::from_bool(value)
    }

    /// The place nearest the root whose value is unknown.
    fn undecided(&self) -> Option<usize> {
        self.known.iter().rposition(|v| *v == Verdict::Unknown)
    }

    /// Propagates known values up and down until nothing changes; `false` if they contradict each
    /// other.
    fn propagate(&mut self) -> bool {
        let gates = self.program.gates();
        loop {
            let before = self.open();
            self.visits += self.known.len();
            let up = gates.iter().enumerate().all(|(index, gate)| self.up(index, *gate));
            if !up || !gates.iter().enumerate().rev().all(|(index, gate)| self.down(index, *gate)) || !self.keep_apart()
            {
                return false;
            }
            if self.open() == before {
                return true;
            }
        }
    }

    fn open(&self) -> usize {
        self.known.iter().filter(|v| **v == Verdict::Unknown).count()
    }

    fn keep_apart(&mut self) -> bool {
        let pairs = std::mem::take(&mut self.apart);
        let mut one_at_most = |a: usize, b: usize| self.known[a] != Verdict::True || self.learn(b, false);
        let kept = pairs.iter().all(|&[a, b]| one_at_most(a, b) && one_at_most(b, a));
        self.apart = pairs;
        kept
    }

    /// Propagates from a gate's inputs to the gate.
    fn up(&mut self, index: usize, gate: Gate) -> bool {
        match gate.verdict(self.program.inputs(gate), |r| self.at(r)) {
            Verdict::Unknown => true,
            verdict => self.set(Ref::gate(index), verdict == Verdict::True),
        }
    }

    /// Propagates from a gate to its inputs: when the greatest allowed number of inputs is true,
    /// the others are false, and the other way round.
    fn down(&mut self, index: usize, gate: Gate) -> bool {
        let inputs = self.program.inputs(gate);
        let (low, high) = match (self.at(Ref::gate(index)), gate.kind) {
            (Verdict::Unknown, _) | (_, GateKind::Pairs(_)) | (Verdict::False, GateKind::Exactly(_)) => return true,
            (Verdict::True, _) => gate.bounds(),
            (Verdict::False, _) => (0, gate.bounds().0 - 1),
        };
        let (least, most) = counts(inputs, |r| self.at(r));
        let rest = match () {
            () if least == most => return true,
            () if least == high => false,
            () if most == low => true,
            () => return true,
        };
        inputs.iter().all(|&r| self.at(r) != Verdict::Unknown || self.set(r, rest))
    }
}

/// Pairs of states of one object that exclude each other.
fn apart(program: &GoalProgram) -> Vec<[usize; 2]> {
    let state = |(index, atom): (usize, &crate::compile::GroundAtom)| match atom.predicate {
        Predicate::State(state) => Some((atom.things[0], index, state)),
        _ => None,
    };
    let mut states: Vec<_> = program.atoms().iter().enumerate().filter_map(state).collect();
    states.sort_unstable_by_key(|&(thing, index, _)| (thing, index));
    let of_one_thing = states.chunk_by(|a, b| a.0 == b.0);
    let pairs = of_one_thing.flat_map(|of| of.iter().flat_map(|a| of.iter().map(move |b| (a, b))));
    pairs.filter(|(a, b)| a.1 < b.1 && a.2.opposites().contains(b.2)).map(|(a, b)| [a.1, b.1]).collect()
}
