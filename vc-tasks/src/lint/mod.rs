//! What is wrong, or odd, with a task.
//!
//! [`activity`] looks at an activity in BDDL, [`goal`] at a goal in our language,
//! alone or in a scene. Neither changes anything; what they find is listed in the
//! order of the text.
//!
//! ```
//! use vc_tasks::lint::{self, Kind};
//! let goal = "forall ?p: plate. On(cup, table) & !On(cup, table)".parse()?;
//! let found: Vec<Kind> = lint::goal(&goal, None).into_iter().map(|f| f.kind).collect();
//! assert_eq!(found, [Kind::UnusedVariable]);
//! let goal = "On(cup.1, table.2) & !On(cup.1, table.2)".parse()?;
//! assert_eq!(lint::goal(&goal, None)[0].kind, Kind::Unsatisfiable);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod activity;
mod circle;
mod goal;
mod satisfy;

use std::fmt;

pub use activity::activity;
pub use goal::{brought_about, goal};

use crate::compile::{Program, Verdict};

/// What is wrong.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Kind {
    /// No state of the things there are meets the goal.
    Unsatisfiable,
    /// The goal holds before anything is done.
    TrueAtStart,
    /// Within a quantifier over a class stands a constant of that class.
    ConstantInQuantifier,
    /// A quantifier's variable does not stand in its condition.
    UnusedVariable,
    /// An object is declared more than once.
    DuplicateObject,
    /// The same is said of the start more than once.
    RepeatedFact,
    /// Of the start both a thing and its contrary are said.
    ContradictoryFacts,
    /// An object, a class or a predicate is not declared.
    Undeclared,
    /// A predicate of more or fewer things than it takes.
    WrongArity,
    /// A thing stands in a relation to itself.
    WithItself,
    /// Things rest on or in each other in a circle.
    Circle,
    /// A domain that is not known.
    UnknownDomain,
    /// A label is of another class than its node in the scene.
    Misnomer,
    /// No class table knows a class of the goal, and no thing of the scene is of it.
    UnknownClass,
    /// The scene lacks what the goal needs.
    Obstacle,
    /// A word or section that means nothing.
    Stray,
    /// The goal asks for what nothing that is done brings about.
    NothingBringsAbout,
    /// A remark: one of the two variables of a pair does not stand in its condition.
    UnusedInPair,
    /// A remark: a variable hides another one of the same name.
    HiddenVariable,
    /// A remark: the goal has further conditions, which the reference
    /// implementation does not read.
    SecondCondition,
    /// Whether the goal can be met was not found out.
    Undecided,
}

impl Kind {
    /// Whether it is no fault but worth a look.
    pub fn is_remark(self) -> bool {
        matches!(self, Self::UnusedInPair | Self::HiddenVariable | Self::SecondCondition)
    }

    /// In a few words.
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
            Self::Circle => "things rest on each other in a circle",
            Self::UnknownDomain => "an unknown domain",
            Self::Misnomer => "a thing called what it is not",
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

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.as_str())
    }
}

/// Something found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// What is wrong.
    pub kind: Kind,
    /// Line and column, where there is a text.
    pub at: Option<(usize, usize)>,
    /// The part it is about.
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

/// Most parts of a goal that is looked at as a whole, counted for every choice of
/// things: BEHAVIOR's largest has some hundred.
const LARGEST: usize = 100_000;

/// Whether a compiled goal can be met, as a finding if it cannot.
fn satisfiability(program: &Program, part: &str) -> Option<Finding> {
    let kind = match satisfy::satisfiable(program) {
        Verdict::True => return None,
        Verdict::False => Kind::Unsatisfiable,
        Verdict::Unknown => Kind::Undecided,
    };
    Some(Finding { kind, at: None, part: part.to_owned() })
}
