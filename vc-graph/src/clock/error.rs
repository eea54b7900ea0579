//! Errors in tables of processes and of durations.

use super::tick::SpanError;
use crate::spelling::did_you_mean;
use crate::vocabulary::UnknownWord;
use crate::{State, StateSet};

/// An error in a table of processes or of durations, with its location.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{file}, line {line}, column `{column}`: {problem}")]
pub struct ClockError {
    /// Name of the text, as given.
    pub file: String,
    /// Line, counted from one.
    pub line: usize,
    /// The column.
    pub column: &'static str,
    /// The error.
    pub problem: ClockProblem,
}

/// An error in an entry of a table of processes or of durations.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ClockProblem {
    /// Wrong number of columns.
    #[error("a line has {needed} columns separated by `|`, this one has {found}")]
    Columns {
        /// The number of columns of this table.
        needed: usize,
        /// The number of columns of the line.
        found: usize,
    },
    /// No name, or one with other characters than letters, digits, `_` and `-`.
    #[error("the name is missing or has characters other than letters, digits, `_` and `-`")]
    Name,
    /// No kind of thing.
    #[error("no kind of thing is given; write classes, `category:food`, `affords:washable`, or `*` for all things")]
    NoKind,
    /// A class that does not exist.
    #[error("there is no class `{name}`{}", did_you_mean(.name, .near.iter().map(String::as_str)))]
    NoSuchClass {
        /// The name (clipped to a readable length).
        name: String,
        /// Names of classes that are spelt like it.
        near: Vec<String>,
    },
    /// A word that is not in its vocabulary.
    #[error(transparent)]
    Word(#[from] UnknownWord),
    /// States that exclude each other.
    #[error("`{0}` exclude each other, so a thing is never all of them")]
    Exclusive(StateSet),
    /// A state with and without the minus sign.
    #[error("`{0}` and `-{0}` exclude each other; keep one of them")]
    Both(State),
    /// A word that has no meaning among the states of a thing or of what becomes of it.
    #[error("`running` can be said of a place only; write states, `-` before those that are not to hold")]
    Running,
    /// Not a place.
    #[error("`{0}` is no place such as `in fridge`, `at affords:heater` or `away affords:heater`; it may be empty")]
    Place(String),
    /// States of a place where no place is given.
    #[error("states of a place are given, but no place; fill in the column before")]
    NoPlace,
    /// Only one of two columns that belong together.
    #[error("`inside` and `inside becomes` are given together or not at all")]
    Half,
    /// A process without a result.
    #[error("nothing becomes of it; give states in `becomes` or in `inside becomes`")]
    NoResult,
    /// Not a span.
    #[error(transparent)]
    Span(#[from] SpanError),
    /// A span of no ticks.
    #[error("it takes less than a tick; the shortest span is one tick, 1/60 s")]
    NoTime,
}
