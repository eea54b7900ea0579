//! Derived predicates: names for goals, as in PDDL.

use std::cmp::Ordering;
use std::fmt;

use crate::NameProblem;
use crate::vocabulary::OwnWords;

static NAMES: OwnWords = OwnWords::new();

/// A predicate that a scene's [`Vocabulary`](crate::Vocabulary) defines by a goal: `Tidy(shirt)` for
/// `Clean(shirt) & Folded(shirt)`. It is a name with a number of terms; [`Goal::expanded`](super::Goal::expanded) puts the
/// definition in its place. Predicates are ordered by name.
///
/// ```
/// use vc_graph::goal::{DerivedPredicate, Goal};
/// use vc_graph::Vocabulary;
/// Vocabulary::parse("words.txt", "predicate neat ?x | is: Clean(?x) & Folded(?x)")?;
/// let neat = DerivedPredicate::find("Neat").ok_or("not declared")?;
/// assert_eq!((neat.as_str(), neat.arity()), ("neat", 1));
/// assert_eq!("Neat(shirt)".parse::<Goal>()?.to_string(), "Neat(shirt)");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct DerivedPredicate(u8);

impl DerivedPredicate {
    /// The predicate of a name in any usual spelling, if some vocabulary of this process has declared it.
    pub fn find(name: &str) -> Option<Self> {
        NAMES.find(name).map(|number| Self(number as u8))
    }

    /// The name, in lower case with `_` between words.
    pub fn as_str(self) -> &'static str {
        self.entry().0
    }

    /// The number of terms, 0 to 2.
    pub fn arity(self) -> usize {
        usize::from(self.entry().1)
    }

    /// A small number, which differs from run to run.
    pub fn index(self) -> usize {
        usize::from(self.0)
    }

    /// The predicate of a name, which gets a number if it has none.
    pub(crate) fn declare(name: &str, terms: u8) -> Result<Self, NameProblem> {
        NAMES.declare(name, terms).map(|number| Self(number as u8))
    }

    /// All predicates that vocabularies of this process have declared.
    pub(super) fn all() -> impl Iterator<Item = Self> {
        (0..OwnWords::MOST).take_while(|number| NAMES.name(*number).is_some()).map(|number| Self(number as u8))
    }

    fn entry(self) -> (&'static str, u8) {
        NAMES.name(self.index()).unwrap_or_default()
    }
}

impl Ord for DerivedPredicate {
    fn cmp(&self, other: &Self) -> Ordering {
        self.as_str().cmp(other.as_str())
    }
}

impl PartialOrd for DerivedPredicate {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl fmt::Debug for DerivedPredicate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}
