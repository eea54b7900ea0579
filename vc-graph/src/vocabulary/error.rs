//! Errors in the text of a vocabulary.

use super::{NameProblem, UnknownWord};
use crate::State;
use crate::goal::GoalError;
use crate::spelling::things as number_of;

/// An error in the text of a [`Vocabulary`](super::Vocabulary), with its line.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{file}, line {line}: {problem}")]
pub struct VocabularyError {
    /// Name of the text, as given.
    pub file: String,
    /// Line, counted from one.
    pub line: usize,
    /// The error.
    pub problem: VocabularyProblem,
}

/// An error in a line of a vocabulary.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum VocabularyProblem {
    /// The line declares nothing.
    #[error("`{0}` is no declaration: write `state NAME`, `property NAME`, `verb NAME THINGS` or `predicate NAME ?x`")]
    Kind(String),
    /// A verb without its number of things.
    #[error("`{0}` is no number of things: a verb takes 0, 1 or 2, as in `verb polish 2`")]
    Things(String),
    /// A predicate with other words after its name than variables.
    #[error(
        "`{0}` is no list of variables: a predicate has none, one or two different ones, as in `predicate tidy ?x`"
    )]
    Variables(String),
    /// A predicate without a definition.
    #[error("`{0}` has no meaning: add `| is:` with a goal, as in `predicate tidy ?x | is: Clean(?x) & Folded(?x)`")]
    Undefined(&'static str),
    /// An error in the goal of a definition.
    #[error(transparent)]
    Goal(#[from] GoalError),
    /// A definition with words of time.
    #[error("`{0}` is about a single step, so its definition has no words of time; use them around it")]
    Temporal(&'static str),
    /// A definition names a node of a scene.
    #[error("the definition of `{predicate}` names `{node}`, a node of one scene: use a class or a variable")]
    NamesNode {
        /// The predicate.
        predicate: &'static str,
        /// The node.
        node: String,
    },
    /// A definition refers to itself, by others or directly.
    #[error("the definition of `{0}` refers to itself, or to one that does")]
    Circular(&'static str),
    /// A definition is too large.
    #[error("the definition of `{predicate}` has more than {largest} parts, with those of the predicates in it")]
    Large {
        /// The predicate.
        predicate: &'static str,
        /// The largest number of parts.
        largest: usize,
    },
    /// A bad name.
    #[error(transparent)]
    Name(#[from] NameProblem),
    /// A field that a declaration does not have.
    #[error("`{field}` is no field of a {kind}: it has {known}")]
    Field {
        /// The kind of the declaration.
        kind: &'static str,
        /// The field.
        field: String,
        /// The fields that there are.
        known: String,
    },
    /// A field is given twice.
    #[error("`{0}` is given twice: separate several entries by `;`")]
    Twice(&'static str),
    /// A condition, effect or set of aims that does not exist.
    #[error("unknown {what} `{word}`{near}; use one of: {known}")]
    Unknown {
        /// A condition, an effect or a set of aims.
        what: &'static str,
        /// The word.
        word: String,
        /// The nearest of these that there are.
        near: String,
        /// Those that there are.
        known: String,
    },
    /// A condition or effect with other parts than it has.
    #[error("`{0}` has too few words or too many")]
    Parts(String),
    /// A word of another vocabulary.
    #[error(transparent)]
    Word(#[from] UnknownWord),
    /// The word for a thing is neither `x` nor `y`.
    #[error("`{0}` is no thing of an action: `x` is the first, `y` the second")]
    Thing(String),
    /// A rule is about a thing that its verb does not take.
    #[error("`{verb}` takes {}, so there is no `{thing}`", number_of(*.things))]
    NoSuchThing {
        /// The verb.
        verb: String,
        /// How many things it takes.
        things: usize,
        /// The thing.
        thing: &'static str,
    },
    /// An effect by an action's aim.
    #[error("effects of an aim are not written: `aims: {{name}}` says which aims a verb takes")]
    OfAim,
    /// The verb takes another number of things than the aims are for.
    #[error("the aims `{aims}` are for verbs with {needed} things")]
    Aims {
        /// The aims.
        aims: &'static str,
        /// The number of things that they are for.
        needed: usize,
    },
    /// A state of bodies is entered or left without them.
    #[error(
        "bodies tell what is {0}: write `sit_on`, `lie_on`, `stand_up`, `enter x open` or `enter x closed` instead"
    )]
    OfBodies(State),
    /// An own word of another vocabulary.
    #[error("`{0}` is not declared in this vocabulary")]
    Undeclared(&'static str),
    /// A word is declared again with another meaning.
    #[error("`{0}` is declared already, with another meaning")]
    Redeclared(&'static str),
}
