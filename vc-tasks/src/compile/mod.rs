//! Goals compiled for the things of a scene.
//!
//! A [`Program`] is a goal whose variables have been replaced by things: ground
//! [`Atom`]s, and gates over them. A gate is "all", "any", "at least k", "exactly
//! k", or "enough pairs in a table"; negation sits on its inputs and output. Equal
//! gates are one gate, and no alternatives are listed: a goal that is true in 10^13
//! ways is still as large as its atoms.
//!
//! The truth of a program is a function of [`Bits`], one for each atom. They are
//! read from a scene by [`Program::read`]; a [`Tracker`] keeps them, and the verdict,
//! up to date as the scene changes; [`Known`] says of some that they are not known.
//! A goal about time is followed by a [`Monitor`].
//!
//! ```
//! use vc_graph::goal::Situation;
//! use vc_graph::{Draft, History, SceneBuilder};
//! use vc_tasks::compile::Program;
//! let mut scene = SceneBuilder::new("flat");
//! let kitchen = scene.add(Draft::new("kitchen"))?;
//! let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
//! let plates = [(); 3].map(|()| scene.add_on(table, Draft::new("plate")));
//! let me = scene.add_in(kitchen, Draft::new("character"))?;
//! let (graph, history) = (scene.build(), History::default());
//! let now = Situation::new(&graph, me, &history);
//!
//! let goal = "forall ?p: plate. On(?p, table) & !Dirty(?p)".parse()?;
//! let program = Program::new(&goal, &now)?;
//! assert_eq!(program.atoms().len(), 6);
//! assert!(program.holds(&program.read(&now)));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod atom;
mod build;
mod course;
mod gate;
mod ground;
mod monitor;
mod scene;
mod shape;
mod table;
mod three;
mod track;

pub use atom::{Atom, Bits};
pub(crate) use gate::{Gate, Kind, Ref, Table};
pub use ground::{Compiler, Things};
pub use monitor::Monitor;
use shape::Shape;
pub(crate) use three::counts;
pub use three::{Known, Verdict};
pub use track::{Stale, Tracker};

use vc_graph::Goal;

/// Why a goal cannot be compiled.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum CompileError {
    /// Its truth depends on what was so before, not on one state.
    #[error("`{0}` is about several steps; follow it with a `Monitor`")]
    Temporal(String),
    /// Its variables range over too much.
    #[error("with these things the goal has more than {0} parts; let its variables range over smaller classes")]
    TooLarge(usize),
}

/// A goal compiled for the things of a scene.
#[derive(Debug, Clone)]
pub struct Program {
    atoms: Vec<Atom>,
    gates: Vec<Gate>,
    inputs: Vec<Ref>,
    /// The goal's conjuncts.
    heads: Vec<Ref>,
    root: Ref,
    shape: Shape,
}

impl Default for Program {
    fn default() -> Self {
        Self {
            atoms: Vec::new(),
            gates: Vec::new(),
            inputs: Vec::new(),
            heads: Vec::new(),
            root: Ref::TRUE,
            shape: Shape::default(),
        }
    }
}

impl Program {
    /// Compiles a goal; [`Compiler`] does several with the same memory.
    ///
    /// # Errors
    /// [`CompileError`]: the goal is about time, or there are too many choices.
    pub fn new(goal: &Goal, things: &impl Things) -> Result<Self, CompileError> {
        Compiler::new().compile(goal, things)
    }

    /// The atoms its truth depends on, each once.
    pub fn atoms(&self) -> &[Atom] {
        &self.atoms
    }

    /// Number of gates and of their inputs.
    pub fn size(&self) -> (usize, usize) {
        (self.gates.len(), self.inputs.len())
    }

    /// Number of the goal's conjuncts.
    pub fn heads(&self) -> usize {
        self.heads.len()
    }

    /// No atom is true yet.
    pub fn bits(&self) -> Bits {
        Bits::none(self.atoms.len())
    }

    /// Those of its atoms that are among these are true, and no others.
    pub fn having(&self, atoms: &[Atom]) -> Bits {
        let mut sorted = atoms.to_vec();
        sorted.sort_unstable();
        let mut bits = self.bits();
        for (index, atom) in self.atoms.iter().enumerate() {
            bits.set(index, sorted.binary_search(atom).is_ok());
        }
        bits
    }

    /// Whether the goal holds when these atoms are true.
    pub fn holds(&self, bits: &Bits) -> bool {
        self.value(bits, self.root)
    }

    /// Whether a conjunct, counted from zero, holds; `false` if there is no such.
    pub fn head_holds(&self, bits: &Bits, head: usize) -> bool {
        self.heads.get(head).is_some_and(|&r| self.value(bits, r))
    }

    /// Which conjuncts hold.
    fn heads_in(&self, bits: &Bits) -> Bits {
        let mut heads = Bits::none(self.heads.len());
        (0..self.heads.len()).for_each(|head| heads.set(head, self.head_holds(bits, head)));
        heads
    }

    pub(crate) fn root(&self) -> Ref {
        self.root
    }

    pub(crate) fn head(&self, head: usize) -> Option<Ref> {
        self.heads.get(head).copied()
    }

    pub(crate) fn gates(&self) -> &[Gate] {
        &self.gates
    }

    pub(crate) fn inputs(&self, gate: Gate) -> &[Ref] {
        &self.inputs[gate.inputs()]
    }

    pub(crate) fn shape(&self) -> &Shape {
        &self.shape
    }

    #[inline]
    pub(crate) fn value(&self, bits: &Bits, of: Ref) -> bool {
        let value = if of.is_atom() {
            bits.has(of.index())
        } else if of.is_constant() {
            true
        } else {
            self.gate_value(bits, &self.gates[of.index()])
        };
        value != of.is_negated()
    }

    /// Looks at no more inputs than it takes to know, and at atoms all at once.
    fn gate_value(&self, bits: &Bits, gate: &Gate) -> bool {
        if gate.mask.care != 0 {
            let found = gate.mask.read(bits);
            return match gate.kind {
                Kind::All => found == gate.mask.care,
                Kind::Any => found != 0,
                Kind::AtLeast(k) => found.count_ones() >= k,
                Kind::Exactly(k) => found.count_ones() == k,
                Kind::Pairs(_) => false,
            };
        }
        let inputs = self.inputs(*gate);
        let mut each = self.each(bits, inputs);
        match gate.kind {
            Kind::All => each.all(|value| value),
            Kind::Any => each.any(|value| value),
            Kind::AtLeast(k) => each.filter(|value| *value).nth(k as usize - 1).is_some(),
            Kind::Exactly(k) => {
                let mut found = each.filter(|value| *value);
                found.nth(k as usize - 1).is_some() && found.next().is_none()
            }
            Kind::Pairs(table) => table.is_met(|cell| self.value(bits, inputs[cell])),
        }
    }

    /// What is the same for all things stands there once for each: it is looked at
    /// once.
    fn each(&self, bits: &Bits, inputs: &[Ref]) -> impl Iterator<Item = bool> {
        let mut last = (Ref::TRUE, true);
        inputs.iter().map(move |&r| {
            if r != last.0 {
                last = (r, self.value(bits, r));
            }
            last.1
        })
    }
}
