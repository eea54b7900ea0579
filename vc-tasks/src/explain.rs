//! Why a goal does not hold, what makes it hold, and since when.

use std::fmt;

use vc_graph::goal::{Quantified, Situation, Trace};
use vc_graph::{Goal, NodeId};

use crate::compile::{Atom, Bits, CompileError, Compiler, Program, Ref, Things};
use crate::score::Scorer;

/// A condition that is not met: what is to become true or to end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Unmet {
    /// The atom is to be true, or false.
    Atom {
        /// The atom.
        atom: Atom,
        /// What it is to be.
        wanted: bool,
    },
    /// So many pairs must not be possible.
    Pairs {
        /// One more than allowed.
        number: u32,
    },
}

impl fmt::Display for Unmet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Atom { atom, wanted: true } => write!(f, "{atom}"),
            Self::Atom { atom, wanted: false } => write!(f, "!{atom}"),
            Self::Pairs { number } => write!(f, "fewer than {number} pairs"),
        }
    }
}

impl Program {
    /// A smallest set of conditions that are not met and would together make the goal
    /// hold; empty if it holds, `None` if nothing can make it hold. Of several equally
    /// small sets the first is given.
    pub fn unmet(&self, bits: &Bits) -> Option<Vec<Unmet>> {
        self.unmet_of(self.root(), bits)
    }

    /// The same for one conjunct, counted from zero.
    pub fn unmet_head(&self, bits: &Bits, head: usize) -> Option<Vec<Unmet>> {
        self.unmet_of(self.head(head)?, bits)
    }

    fn unmet_of(&self, of: Ref, bits: &Bits) -> Option<Vec<Unmet>> {
        if self.value(bits, of) {
            return Some(Vec::new());
        }
        let list = Scorer::new().unmet(self, of, bits)?;
        Some(list.into_iter().map(|r| self.condition(r)).collect())
    }

    fn condition(&self, r: Ref) -> Unmet {
        if r.is_atom() {
            return Unmet::Atom { atom: self.atoms()[r.index()], wanted: !r.is_negated() };
        }
        let need = match self.gates()[r.index()].kind {
            crate::compile::Kind::Pairs(table) => table.need,
            _ => 0,
        };
        Unmet::Pairs { number: need }
    }
}

/// What there is to say about one conjunct of a goal.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// The conjunct.
    pub goal: Goal,
    /// Whether it holds.
    pub holds: bool,
    /// A smallest set of what is missing; `None` if nothing can make it hold.
    pub unmet: Option<Vec<Unmet>>,
    /// For a quantified conjunct the things for which its body holds and those for
    /// which it does not.
    pub bindings: Option<Bindings>,
}

/// The things a quantified goal ranges over.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Bindings {
    /// Things for which the body holds.
    pub satisfied: Vec<NodeId>,
    /// Things for which it does not.
    pub unsatisfied: Vec<NodeId>,
}

/// Says of each conjunct of a goal whether it holds in a situation, what is missing,
/// and which things count.
///
/// ```
/// use vc_graph::goal::Situation;
/// use vc_graph::{Draft, History, SceneBuilder};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// scene.add_on(table, Draft::new("plate"))?;
/// scene.add_in(kitchen, Draft::new("plate"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let (graph, history) = (scene.build(), History::default());
/// let now = Situation::new(&graph, me, &history);
/// let parts = vc_tasks::explain(&"forall ?p: plate. On(?p, table)".parse()?, &now)?;
/// let unmet: Vec<String> = parts[0].unmet.iter().flatten().map(|u| u.to_string()).collect();
/// assert_eq!(unmet, ["On(#4, #2)"]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`CompileError`]: the goal is about time or too large.
pub fn explain(goal: &Goal, now: &Situation<'_>) -> Result<Vec<Part>, CompileError> {
    let mut compiler = Compiler::new();
    let program = compiler.compile(goal, now)?;
    let bits = program.read(now);
    let conjuncts = goal.conjuncts().iter().enumerate();
    let part = |(head, part): (usize, &Goal)| Part {
        goal: part.clone(),
        holds: program.head_holds(&bits, head),
        unmet: program.unmet_head(&bits, head),
        bindings: quantified(part).map(|q| bindings(q, now)),
    };
    Ok(conjuncts.map(part).collect())
}

fn quantified(goal: &Goal) -> Option<&Quantified> {
    match goal {
        Goal::ForAll(q) | Goal::Exists(q) | Goal::ForN { of: q, .. } => Some(q),
        _ => None,
    }
}

fn bindings(q: &Quantified, now: &Situation<'_>) -> Bindings {
    let mut things = Vec::new();
    now.each(q.class.as_deref(), &mut things);
    let mut found = Bindings::default();
    for thing in things {
        match q.holds_of(thing, now) {
            true => found.satisfied.push(thing),
            false => found.unsatisfied.push(thing),
        }
    }
    found
}

/// For each conjunct of a goal the first step after which it held, if there was one:
/// judged on what had happened by then.
pub fn first_held(goal: &Goal, trace: &Trace) -> Vec<Option<usize>> {
    let conjuncts = goal.conjuncts().iter();
    conjuncts.map(|part| (0..=trace.steps()).find(|&step| part.holds_by(trace, step))).collect()
}
