//! Goals compiled for the objects of a scene.
//!
//! A [`GoalProgram`] is a goal whose variables have been replaced by objects: ground [`GroundAtom`]s, and
//! gates over them. A gate is "all", "any", "at least k", "exactly k", or "enough pairs in a
//! table"; its inputs and its output can be negated. Equal gates are stored once, and alternatives
//! are not enumerated: a goal that can be fulfilled in 10^13 ways is still only as large as its
//! atoms.
//!
//! The truth of a program is a function of [`Bits`], one for each atom. [`GoalProgram::read`] reads
//! them from a scene; a [`Tracker`] keeps the bits and the verdict up to date as the scene changes;
//! [`Known`] represents partial knowledge of the atoms. A [`Monitor`] evaluates temporal goals.
//!
//! ```
//! use vc_graph::goal::Situation;
//! use vc_graph::{Draft, History, SceneBuilder};
//! use vc_tasks::compile::GoalProgram;
//! let mut scene = SceneBuilder::new("flat");
//! let kitchen = scene.add(Draft::new("kitchen"))?;
//! let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
//! let plates = [(); 3].map(|()| scene.add_on(table, Draft::new("plate")));
//! let me = scene.add_in(kitchen, Draft::new("character"))?;
//! let (graph, history) = (scene.build(), History::default());
//! let now = Situation::new(&graph, me, &history);
//!
//! let goal = "forall ?p: plate. On(?p, table) & !Dirty(?p)".parse()?;
//! let program = GoalProgram::new(&goal, &now)?;
//! assert_eq!(program.atoms().len(), 6);
//! assert!(program.holds(&program.read(&now)));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod atom;
mod build;
mod course;
mod fate;
mod gate;
mod ground;
mod monitor;
mod scene;
mod shape;
mod table;
mod three;
mod track;

pub use atom::{Bits, GroundAtom};
pub(crate) use gate::{Gate, GateKind, Ref, Table};
pub use ground::{Compiler, Things};
pub use monitor::Monitor;
use shape::Shape;
pub(crate) use three::counts;
pub use three::{Known, Verdict};
pub use track::{Stale, Tracker};

use vc_graph::Goal;

/// The reason why a goal cannot be compiled.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum CompileError {
    /// The goal's truth depends on earlier states, not on a single one.
    #[error("`{0}` is about several steps; follow it with a `Monitor`")]
    Temporal(String),
    /// The variables range over too many objects.
    #[error("for these objects the goal has more than {0} parts; let its variables range over smaller classes")]
    TooLarge(usize),
}

/// A goal compiled for the objects of a scene.
#[derive(Debug, Clone)]
pub struct GoalProgram {
    atoms: Vec<GroundAtom>,
    gates: Vec<Gate>,
    inputs: Vec<Ref>,
    /// The goal's conjuncts.
    heads: Vec<Ref>,
    root: Ref,
    shape: Shape,
}

impl Default for GoalProgram {
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

impl GoalProgram {
    /// Compiles a goal; [`Compiler`] compiles several and reuses its memory.
    ///
    /// # Errors
    /// [`CompileError`]: the goal is temporal, or there are too many choices.
    pub fn new(goal: &Goal, things: &impl Things) -> Result<Self, CompileError> {
        Compiler::new().compile(goal, things)
    }

    /// The atoms that the goal's truth depends on, each once.
    pub fn atoms(&self) -> &[GroundAtom] {
        &self.atoms
    }

    /// The numbers of gates and of their inputs.
    pub fn size(&self) -> (usize, usize) {
        (self.gates.len(), self.inputs.len())
    }

    /// The number of the goal's conjuncts.
    pub fn heads(&self) -> usize {
        self.heads.len()
    }

    /// Bits with all atoms false.
    pub fn bits(&self) -> Bits {
        Bits::none(self.atoms.len())
    }

    /// Bits in which exactly those of the program's atoms are true that are given.
    ///
    /// ```
    /// use vc_graph::goal::Situation;
    /// use vc_graph::{Draft, History, SceneBuilder};
    /// use vc_tasks::compile::GoalProgram;
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let (graph, history) = (scene.build(), History::default());
    /// let now = Situation::new(&graph, me, &history);
    /// let program = GoalProgram::new(&"Holds(apple)".parse()?, &now)?;
    /// assert!(program.holds(&program.having(program.atoms())));
    /// assert!(!program.holds(&program.having(&[])));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn having(&self, atoms: &[GroundAtom]) -> Bits {
        let mut sorted = atoms.to_vec();
        sorted.sort_unstable();
        let mut bits = self.bits();
        for (index, atom) in self.atoms.iter().enumerate() {
            bits.set(index, sorted.binary_search(atom).is_ok());
        }
        bits
    }

    /// Whether the goal holds for these truth values of the atoms.
    pub fn holds(&self, bits: &Bits) -> bool {
        self.value(bits, self.root)
    }

    /// Whether a conjunct, counted from zero, holds; `false` if the index is out of range.
    ///
    /// ```
    /// use vc_graph::goal::Situation;
    /// use vc_graph::{Draft, History, SceneBuilder};
    /// use vc_tasks::compile::GoalProgram;
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let (graph, history) = (scene.build(), History::default());
    /// let now = Situation::new(&graph, me, &history);
    /// let program = GoalProgram::new(&"On(apple, kitchen_table) & Holds(apple)".parse()?, &now)?;
    /// let bits = program.read(&now);
    /// assert_eq!([0, 1].map(|head| program.head_holds(&bits, head)), [true, false]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn head_holds(&self, bits: &Bits, head: usize) -> bool {
        self.heads.get(head).is_some_and(|&r| self.value(bits, r))
    }

    /// The conjuncts that hold.
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

    /// Stops at the first input that decides the gate, and evaluates masked atoms all at once.
    fn gate_value(&self, bits: &Bits, gate: &Gate) -> bool {
        if gate.mask.care != 0 {
            let found = gate.mask.read(bits);
            return match gate.kind {
                GateKind::All => found == gate.mask.care,
                GateKind::Any => found != 0,
                GateKind::AtLeast(k) => found.count_ones() >= k,
                GateKind::Exactly(k) => found.count_ones() == k,
                GateKind::Pairs(_) => false,
            };
        }
        let inputs = self.inputs(*gate);
        let mut each = self.each(bits, inputs);
        match gate.kind {
            GateKind::All => each.all(|value| value),
            GateKind::Any => each.any(|value| value),
            GateKind::AtLeast(k) => each.filter(|value| *value).nth(k as usize - 1).is_some(),
            GateKind::Exactly(k) => {
                let mut found = each.filter(|value| *value);
                found.nth(k as usize - 1).is_some() && found.next().is_none()
            }
            GateKind::Pairs(table) => table.is_met(|cell| self.value(bits, inputs[cell])),
        }
    }

    /// A subgoal that does not depend on the quantified variable appears once per object; adjacent
    /// equal inputs are evaluated once.
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
