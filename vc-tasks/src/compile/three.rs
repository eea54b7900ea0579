//! Three-valued truth under partial observability.

use super::{Bits, Gate, GateKind, GoalProgram, Ref};

/// Whether a goal holds, as far as is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// It holds, whatever the unknown atoms are.
    True,
    /// It does not hold, whatever the unknown atoms are.
    False,
    /// The known atoms do not decide it.
    Unknown,
}

impl Verdict {
    /// The verdict for a known truth value.
    ///
    /// ```
    /// use vc_tasks::compile::Verdict;
    /// assert_eq!(Verdict::from_bool(false), Verdict::False);
    /// ```
    pub fn from_bool(value: bool) -> Self {
        if value { Self::True } else { Self::False }
    }

    pub(crate) fn negated_if(self, negate: bool) -> Self {
        match self {
            Self::True if negate => Self::False,
            Self::False if negate => Self::True,
            other => other,
        }
    }
}

/// The atoms known to be true and those known to be false.
///
/// ```
/// use vc_graph::goal::Situation;
/// use vc_graph::{Draft, History, SceneBuilder};
/// use vc_tasks::compile::{Known, GoalProgram, Verdict};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// scene.add_in(kitchen, Draft::new("cup"))?;
/// scene.add_in(kitchen, Draft::new("cup"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let (graph, history) = (scene.build(), History::default());
/// let now = Situation::new(&graph, me, &history);
///
/// let program = GoalProgram::new(&"exactly 1 ?c: cup. Dirty(?c)".parse()?, &now)?;
/// let mut known = Known::nothing(&program);
/// known.learn(0, true);
/// assert_eq!(program.verdict(&known), Verdict::Unknown);
/// known.learn(1, true);
/// assert_eq!(program.verdict(&known), Verdict::False);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Known {
    known: Bits,
    value: Bits,
}

impl Known {
    /// No atom of a program is known.
    pub fn nothing(program: &GoalProgram) -> Self {
        Self { known: program.bits(), value: program.bits() }
    }

    /// Records the truth of an atom, given by its index.
    pub fn learn(&mut self, atom: usize, value: bool) {
        self.known.set(atom, true);
        self.value.set(atom, value);
    }

    /// The known truth of an atom.
    pub fn get(&self, atom: usize) -> Verdict {
        if self.known.has(atom) { Verdict::from_bool(self.value.has(atom)) } else { Verdict::Unknown }
    }
}

impl GoalProgram {
    /// Whether the goal holds, as far as is known: Kleene's strong logic, with lower and upper
    /// bounds for counts and pairs. A verdict of true or false is right for every value of the
    /// unknown atoms; the verdict may be unknown where they do not matter, as for `Open(x) |
    /// !Open(x)`.
    pub fn verdict(&self, known: &Known) -> Verdict {
        self.seen(known, self.root())
    }

    fn seen(&self, known: &Known, of: Ref) -> Verdict {
        let verdict = if of.is_atom() {
            known.get(of.index())
        } else if of.is_constant() {
            Verdict::True
        } else {
            self.gate_seen(known, self.gates()[of.index()])
        };
        verdict.negated_if(of.is_negated())
    }

    fn gate_seen(&self, known: &Known, gate: Gate) -> Verdict {
        gate.verdict(self.inputs(gate), |r| self.seen(known, r))
    }
}

impl Gate {
    /// The verdict of a gate, given the verdicts of its inputs.
    pub(crate) fn verdict(self, inputs: &[Ref], seen: impl Fn(Ref) -> Verdict) -> Verdict {
        if let GateKind::Pairs(table) = self.kind {
            let most = table.is_met(|cell| seen(inputs[cell]) != Verdict::False);
            let least = most && table.is_met(|cell| seen(inputs[cell]) == Verdict::True);
            return if most == least { Verdict::from_bool(least) } else { Verdict::Unknown };
        }
        let (least, most) = counts(inputs, seen);
        let (low, high) = self.bounds();
        if low <= least && most <= high {
            Verdict::True
        } else if most < low || least > high {
            Verdict::False
        } else {
            Verdict::Unknown
        }
    }

    /// The least and the greatest number of true inputs with which the gate is true; a table has no
    /// such bounds.
    pub(crate) fn bounds(self) -> (usize, usize) {
        let all = self.inputs().len();
        match self.kind {
            GateKind::All => (all, all),
            GateKind::Any => (1, all),
            GateKind::AtLeast(k) => (k as usize, all),
            GateKind::Exactly(k) => (k as usize, k as usize),
            GateKind::Pairs(_) => (0, all),
        }
    }
}

/// The number of inputs that are true, and the number that can be. Adjacent equal inputs are
/// evaluated once.
pub(crate) fn counts(inputs: &[Ref], seen: impl Fn(Ref) -> Verdict) -> (usize, usize) {
    let same = inputs.chunk_by(|a, b| a == b);
    same.fold((0, 0), |(least, most), same| match seen(same[0]) {
        Verdict::True => (least + same.len(), most + same.len()),
        Verdict::Unknown => (least, most + same.len()),
        Verdict::False => (least, most),
    })
}
