//! Literals: predicates applied to terms.

use super::DerivedPredicate;
use crate::{NodeId, Relation, State, Verb};

/// The comparison of a count with a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Comparison {
    /// At least that number.
    AtLeast,
    /// Exactly that number.
    Exactly,
    /// At most that number.
    AtMost,
}

impl Comparison {
    /// Whether a count satisfies the comparison.
    ///
    /// ```
    /// use vc_graph::goal::Comparison;
    /// assert!(Comparison::AtLeast.admits(3, 2) && !Comparison::Exactly.admits(3, 2));
    /// ```
    pub fn admits(self, found: usize, number: u32) -> bool {
        match self {
            Self::AtLeast => found >= number as usize,
            Self::Exactly => found == number as usize,
            Self::AtMost => found <= number as usize,
        }
    }
}

/// A predicate with its terms.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Literal {
    /// The predicate.
    pub predicate: Predicate,
    /// The terms, as many as [`Predicate::arity`].
    pub terms: Vec<Term>,
}

impl Literal {
    /// The index of the term that a count refers to: the first that is a class or `_`.
    pub fn counted(&self) -> Option<usize> {
        self.terms.iter().position(|t| matches!(t, Term::Class(_) | Term::Anything))
    }
}

/// The predicate of a literal.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Predicate {
    /// The object is in a state.
    State(State),
    /// The first object stands in this relation to the second. `On`, `Inside` and `Near` are interpreted
    /// generously, see the [module](super).
    Relation(Relation),
    /// The first object, an agent, holds the second in either hand.
    Holds,
    /// The agent has performed an action with this verb.
    Did(Verb),
    /// The object exists: it is not in the state [`State::Future`].
    Real,
    /// The scene's vocabulary defines it by a goal.
    Derived(DerivedPredicate),
}

impl Predicate {
    /// The number of terms.
    pub fn arity(self) -> usize {
        match self {
            Self::State(_) | Self::Real => 1,
            Self::Relation(_) | Self::Holds => 2,
            Self::Did(verb) => verb.arity(),
            Self::Derived(predicate) => predicate.arity(),
        }
    }
}

/// A term of a literal.
///
/// ```
/// use vc_graph::goal::{Goal, Term};
/// let goal: Goal = "Holds(me, apple.4)".parse()?;
/// assert!(matches!(&goal.terms()[1], Term::Node(Some(class), id) if class == "apple" && id.0 == 4));
/// # Ok::<(), vc_graph::goal::GoalError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Term {
    /// Some node of a class.
    Class(String),
    /// One node; the class is only for the reader.
    Node(Option<String>, NodeId),
    /// The variable of a quantifier.
    Variable(String),
    /// The agent.
    Me,
    /// Any object.
    Anything,
}
