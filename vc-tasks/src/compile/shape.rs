//! The structure of a program's gates: found once, used by each score.

use super::{GateKind, GoalProgram, Ref};

/// The polarities in which the atoms and gates of a program are used, and the parts that compete
/// for the same atoms.
#[derive(Debug, Clone, Default)]
pub(crate) struct Shape {
    /// For each gate whether its truth matters (1), its falsehood (2), or both.
    sides: Vec<u8>,
    /// For each atom the number of paths to it from the root.
    paths: Vec<u32>,
    /// The conjuncts; empty if no atom is contested.
    parts: Vec<Part>,
    /// For each gate whether it contains no pairs, if some atom is contested.
    pure: Vec<bool>,
}

/// A conjunct.
#[derive(Debug, Clone)]
pub(crate) struct Part {
    pub(crate) of: Ref,
    /// Its gates, inputs before the gates that use them.
    pub(crate) gates: Vec<u32>,
    /// The contested atoms in it.
    pub(crate) contested: Vec<u32>,
}

const TRUTH: u8 = 1;
const BOTH: u8 = 3;

impl Shape {
    pub(super) fn new(program: &GoalProgram) -> Self {
        let mut uses = Uses::new(program);
        let contested = uses.contested(program);
        let parts = if contested { uses.parts(program) } else { Vec::new() };
        let pure = if contested { pure(program) } else { Vec::new() };
        let paths = uses.atoms.iter().map(|u| u.paths).collect();
        Self { sides: uses.gates.into_iter().map(|u| u.sides).collect(), paths, parts, pure }
    }

    /// Whether the truth of a gate matters or, if `negated`, its falsehood.
    #[inline]
    pub(crate) fn matters(&self, gate: usize, negated: bool) -> bool {
        self.sides.get(gate).is_some_and(|sides| (sides >> u8::from(negated)) & 1 != 0)
    }

    /// The number of paths to an atom from the root, at least one.
    pub(crate) fn paths(&self, atom: usize) -> u32 {
        self.paths.get(atom).map_or(1, |&paths| paths.max(1))
    }

    /// Whether a gate contains no pairs.
    pub(crate) fn is_pure(&self, gate: usize) -> bool {
        self.pure.get(gate).is_some_and(|pure| *pure)
    }

    pub(crate) fn parts(&self) -> &[Part] {
        &self.parts
    }
}

fn pure(program: &GoalProgram) -> Vec<bool> {
    let mut pure: Vec<bool> = Vec::with_capacity(program.gates.len());
    for gate in &program.gates {
        let inputs = program.inputs(*gate).iter();
        let own = !matches!(gate.kind, GateKind::Pairs(_));
        pure.push(own && inputs.filter(|r| !r.is_atom() && !r.is_constant()).all(|r| pure[r.index()]));
    }
    pure
}

/// How an atom or gate is used.
#[derive(Debug, Clone, Copy, Default)]
struct Use {
    sides: u8,
    /// The number of paths to it from the root.
    paths: u32,
}

struct Uses {
    atoms: Vec<Use>,
    gates: Vec<Use>,
}

impl Uses {
    fn new(program: &GoalProgram) -> Self {
        let none = Use::default();
        let mut uses = Self { atoms: vec![none; program.atoms.len()], gates: vec![none; program.gates.len()] };
        uses.add(program.root, Use { sides: TRUTH, paths: 1 });
        for (index, gate) in program.gates.iter().enumerate().rev() {
            let mut here = uses.gates[index];
            if matches!(gate.kind, GateKind::Exactly(_)) && here.sides != 0 {
                here.sides = BOTH;
            }
            program.inputs(*gate).iter().for_each(|&r| uses.add(r, here));
        }
        uses
    }

    fn add(&mut self, r: Ref, from: Use) {
        let used = match () {
            () if r.is_constant() => return,
            () if r.is_atom() => &mut self.atoms[r.index()],
            () => &mut self.gates[r.index()],
        };
        let turned = ((from.sides << 1) & 2) | (from.sides >> 1);
        used.sides |= if r.is_negated() { turned } else { from.sides };
        used.paths = used.paths.saturating_add(from.paths);
    }

    /// Whether an atom can be wanted true in one place and false in another.
    fn is_contested(&self, atom: usize) -> bool {
        self.atoms[atom].sides == BOTH && self.atoms[atom].paths > 1
    }

    fn contested(&self, program: &GoalProgram) -> bool {
        (0..program.atoms.len()).any(|atom| self.is_contested(atom))
    }

    fn parts(&mut self, program: &GoalProgram) -> Vec<Part> {
        let mut parts = Vec::new();
        let mut open = vec![program.root];
        while let Some(r) = open.pop() {
            let gate = (!r.is_atom() && !r.is_constant()).then(|| program.gates[r.index()]);
            match gate {
                Some(gate) if gate.kind == GateKind::All && !r.is_negated() => {
                    open.extend(program.inputs(gate).iter().rev());
                }
                _ => parts.push(self.part(program, r)),
            }
        }
        parts
    }

    fn part(&self, program: &GoalProgram, of: Ref) -> Part {
        let mut part = Part { of, gates: Vec::new(), contested: Vec::new() };
        let mut open = vec![of];
        let mut seen = vec![false; self.gates.len()];
        while let Some(r) = open.pop() {
            match () {
                () if r.is_constant() => {}
                () if r.is_atom() => part.contested.extend(self.is_contested(r.index()).then_some(r.index() as u32)),
                () if std::mem::replace(&mut seen[r.index()], true) => {}
                () => {
                    part.gates.push(r.index() as u32);
                    open.extend(program.inputs(program.gates[r.index()]));
                }
            }
        }
        for list in [&mut part.gates, &mut part.contested] {
            list.sort_unstable();
            list.dedup();
        }
        part
    }
}
