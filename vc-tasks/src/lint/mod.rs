//! Finds mistakes and oddities in a task.
//!
//! [`activity`] checks an activity in BDDL, [`goal`] a goal in our notation, alone or in a scene.
//! Neither changes anything; findings are listed in the order of the text.
//!
//! ```
//! use vc_tasks::lint::{self, FindingKind};
//! let goal = "forall ?p: plate. On(cup, table) & !On(cup, table)".parse()?;
//! let found: Vec<FindingKind> = lint::goal(&goal, None).into_iter().map(|f| f.kind).collect();
//! assert_eq!(found, [FindingKind::UnusedVariable]);
//! let goal = "On(cup.1, table.2) & !On(cup.1, table.2)".parse()?;
//! assert_eq!(lint::goal(&goal, None)[0].kind, FindingKind::Unsatisfiable);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod activity;
mod cycle;
mod goal;
mod satisfy;

use std::fmt;

pub use activity::activity;
pub use goal::goal;

pub use crate::attainable::brought_about;

use crate::compile::{GoalProgram, Verdict};

/// The kind of a finding.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum FindingKind {
    /// No state of the objects fulfils the goal.
    Unsatisfiable,
    /// The goal holds before any action.
    TrueAtStart,
    /// A quantifier over a class contains a constant of that class.
    ConstantInQuantifier,
    /// A quantifier's variable does not occur in its condition.
    UnusedVariable,
    /// An object is declared more than once.
    DuplicateObject,
    /// A start fact is repeated.
    RepeatedFact,
    /// A start fact and its negation are both stated.
    ContradictoryFacts,
    /// An object, a class or a predicate is not declared.
    Undeclared,
    /// A predicate has too many or too few arguments.
    WrongArity,
    /// A relation has the same object twice.
    WithItself,
    /// Objects rest on or in each other in a cycle.
    Cycle,
    /// The domain is not known.
    UnknownDomain,
    /// The class of a label is not that of its node in the scene.
    NameMismatch,
    /// A class of the goal is in no class table, and the scene has no object of it.
    UnknownClass,
    /// The scene lacks something that the goal needs.
    Obstacle,
    /// A word or section without a meaning.
    Stray,
    /// The goal asks for a state or relation that neither an action nor a process brings about.
    NothingBringsAbout,
    /// A remark: one of the two variables of a pair does not occur in its condition.
    UnusedInPair,
    /// A remark: a variable shadows another one of the same name.
    HiddenVariable,
    /// A remark: the goal has further conditions, which the reference
    /// implementation does not read.
    SecondCondition,
    /// The search did not decide whether the goal can be fulfilled.
    Undecided,
}

impl FindingKind {
    /// Whether it is only a remark, not a mistake.
    pub fn is_remark(self) -> bool {
        matches!(self, Self::UnusedInPair | Self::HiddenVariable | Self::SecondCondition)
    }

    /// A short description.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Unsatisfiable => "unsatisfiable",
            Self::TrueAtStart => "true at the start",
            Self::ConstantInQuantifier => "a constant inside its own quantifier",
            Self::UnusedVariable => "a variable never used",
            Self::DuplicateObject => "an object declared twice",
            Self::RepeatedFact => "a fact repeated",
            Self::ContradictoryFacts => "facts contradict each other",
            Self::Undeclared => "not declared",
            Self::WrongArity => "a predicate of too many or too few things",
            Self::WithItself => "a thing in relation to itself",
            Self::Cycle => "things rest on each other in a cycle",
            Self::UnknownDomain => "an unknown domain",
            Self::NameMismatch => "a thing called what it is not",
            Self::UnknownClass => "an unknown class",
            Self::Obstacle => "the scene lacks what it needs",
            Self::Stray => "a stray word",
            Self::NothingBringsAbout => "nothing brings it about",
            Self::UnusedInPair => "remark: a variable of a pair never used",
            Self::HiddenVariable => "remark: a variable hides another",
            Self::SecondCondition => "remark: a second condition in the goal",
            Self::Undecided => "not found out whether it can be met",
        }
    }
}

impl fmt::Display for FindingKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.as_str())
    }
}

/// A mistake or oddity in a task.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// The kind of the finding.
    pub kind: FindingKind,
    /// Line and column, if there is a text.
    pub at: Option<(usize, usize)>,
    /// The part it concerns.
    pub part: String,
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some((line, column)) = self.at {
            write!(f, "line {line}, column {column}: ")?;
        }
        write!(f, "{}: {}", self.kind, self.part)
    }
}

/// The limit of parts of a goal that is checked as a whole, counted for every choice of objects:
/// BEHAVIOR's largest goal has some hundred.
const LARGEST: usize = 100_000;

/// A finding, if a compiled goal cannot be fulfilled or the search did not decide it.
fn satisfiability(program: &GoalProgram, part: &str) -> Option<Finding> {
    let kind = match satisfy::satisfiable(program) {
        Verdict::True => return None,
        Verdict::False => FindingKind::Unsatisfiable,
        Verdict::Unknown => FindingKind::Undecided,
    };
    Some(Finding { kind, at: None, part: part.to_owned() })
}
