//! Literals: a predicate of things.

use crate::{NodeId, Relation, State, Verb};

/// How a count compares.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Comparison {
    /// At least so many.
    AtLeast,
    /// Exactly so many.
    Exactly,
    /// At most so many.
    AtMost,
}

impl Comparison {
    /// Whether a found number satisfies it.
    pub fn admits(self, found: usize, number: u32) -> bool {
        match self {
            Self::AtLeast => found >= number as usize,
            Self::Exactly => found == number as usize,
            Self::AtMost => found <= number as usize,
        }
    }
}

/// A predicate of things.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Literal {
    /// What is said.
    pub predicate: Predicate,
    /// Of what: as many as [`Predicate::arity`].
    pub terms: Vec<Term>,
}

impl Literal {
    /// The position of the term a count is about: the first open one.
    pub fn counted(&self) -> Option<usize> {
        self.terms.iter().position(|t| matches!(t, Term::Class(_) | Term::Anything))
    }
}

/// What a literal says.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Predicate {
    /// The thing is in a state.
    State(State),
    /// The first thing stands so to the second. `On`, `Inside` and `Near` are
    /// read generously, see the [module](super).
    Relation(Relation),
    /// The first, an agent, holds the second in either hand.
    Holds,
    /// The agent has done it.
    Did(Verb),
    /// The thing is there: not in the state [`State::Future`].
    Real,
}

impl Predicate {
    /// How many things it is about.
    pub fn arity(self) -> usize {
        match self {
            Self::State(_) | Self::Real => 1,
            Self::Relation(_) | Self::Holds => 2,
            Self::Did(verb) => verb.arity(),
        }
    }
}

/// A thing a literal is about.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Term {
    /// Some node of a class.
    Class(String),
    /// One node; the class is for the reader.
    Node(Option<String>, NodeId),
    /// The variable of a quantifier.
    Variable(String),
    /// The agent.
    Me,
    /// Anything.
    Anything,
}
