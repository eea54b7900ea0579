//! The faults of a table of dressing.

/// A fault of a table, with its line.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{file}:{line}: {fault}")]
pub struct DressingError {
    /// The name of the text.
    pub file: String,
    /// The line, counted from one.
    pub line: usize,
    /// The fault.
    #[source]
    pub fault: DressingFault,
}

/// The reason why a line cannot be read.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DressingFault {
    /// A rule has fewer or more columns.
    #[error("a rule has three columns, `chance | things | place`, and here are {0}")]
    Columns(usize),
    /// A rule stands before the first line that names rooms.
    #[error("this rule is for no room: put a line such as `[kitchen]` above")]
    NoRoom,
    /// The word is no room that homes have.
    #[error("there is no kind of room `{word}`{near}")]
    UnknownRoom {
        /// The word.
        word: String,
        /// Similar words.
        near: String,
    },
    /// The word is no class, group or list.
    #[error("there is no class `{word}`{near}")]
    UnknownClass {
        /// The word.
        word: String,
        /// Similar words.
        near: String,
    },
    /// Nothing makes objects of the class.
    #[error("no objects of the class `{0}` can be made: name another one")]
    NoGenerator(String),
    /// There is no list of the name.
    #[error("there is no list `@{0}`: write `list {0} = ...` above")]
    UnknownList(String),
    /// The word is no trait of households.
    #[error("there is no trait `{word}`{near}: write `trait {word} | 0.5` above")]
    UnknownTrait {
        /// The word.
        word: String,
        /// Similar words.
        near: String,
    },
    /// There are more traits than a table can have.
    #[error("a table has at most {0} traits")]
    TooManyTraits(usize),
    /// The text is no chance.
    #[error("`{0}` is not a chance: write a number from 0 to 1")]
    Chance(String),
    /// The text is no number of things.
    #[error("`{0}` is not a number of things: write `2`, `1-3` or `4x`, at most 40")]
    Count(String),
    /// The text is no place.
    #[error("`{0}` is not a place: write one such as `on desk`, `in it` or `at 1.5`")]
    Place(String),
    /// An indented line stands below no rule, or is indented by more than one step.
    #[error("the line is indented and below no rule that it could belong to: indent by two spaces a step")]
    Orphan,
    /// A line about `it` is not indented.
    #[error("`it` is the thing of the line above: indent this line by two spaces")]
    NoIt,
    /// A rule about the thing above has a place that is not at that thing.
    #[error("an indented line is about the thing above: its place ends with `it`")]
    NotIt,
    /// A thing of the line above has no surface to put others left, right or behind of.
    #[error("the thing above stands on the floor or hangs: use `on it`, `in it`, `hang it` or `next` with its class")]
    NotBeside,
}
