//! Goals: what an agent is to bring about.
//!
//! ```
//! use vc_graph::Goal;
//! let goal: Goal = "On(apple, kitchentable), 3 & Closed(fridge)".parse()?;
//! assert_eq!(goal.to_string(), "On(apple, kitchentable), 3 & Closed(fridge)");
//! let goal: Goal = "forall ?p: plate. (Inside(?p, dishwasher) | Clean(?p))".parse()?;
//! # Ok::<(), vc_graph::goal::GoalError>(())
//! ```
//!
//! A literal is a predicate of things. A thing is a class in any usual spelling
//! (`coffee_table`: some node of it), a node (`cup.12` or `#12`), `me` (the agent),
//! a variable (`?x`) or `_` (anything).
//!
//! | predicate | holds when |
//! |---|---|
//! | `Open` `Closed` `SwitchedOn` `On(x)` `Clean` `Dirty` `Cooked` ... | the thing is in that state |
//! | `On(x, y)` | x rests on y; also sits, lies or is worn on it |
//! | `Inside(x, y)`, `In` | x is inside y, directly or on or in something inside it, or in room y |
//! | `Near(x)`, `Walk(x)` | the agent is near x, or in room x |
//! | `Holds(x)`, `Grab(x)`, `HoldsRight`, `HoldsLeft` | the agent holds x |
//! | `Sit(x)` `Lie(x)` `Wear(x)` `Facing(x)` | the agent sits or lies on, wears, faces x |
//! | `Eat(x)` `Drink(x)` `Watch(x)` `did verb(x, y)` | the agent has done it |
//!
//! `, 3` after a literal asks for at least three different things in its first
//! open place (`, = 3` and `, <= 3` for exactly and at most). `!`, `&`, `|` (or
//! `not`, `and`, `or`) bind in that order; `then` binds loosest and orders what is
//! done. `forall` and `exists` reach as far as they can.

mod evaluate;
mod text;

use std::fmt;

use crate::vocabulary::Word;
use crate::{NodeId, Relation, State, Verb};

pub use evaluate::{Situation, Things};
pub use text::{GoalError, GoalProblem};

/// A goal.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Goal {
    /// At least one choice of things satisfies the literal.
    Literal(Literal),
    /// So many different things satisfy the literal.
    Count {
        /// The literal.
        literal: Literal,
        /// At least, exactly or at most.
        comparison: Comparison,
        /// How many.
        number: u32,
    },
    /// All parts hold.
    And(Vec<Goal>),
    /// Some part holds.
    Or(Vec<Goal>),
    /// The part does not hold.
    Not(Box<Goal>),
    /// The part holds for every thing of a class.
    ForAll(Quantified),
    /// The part holds for some thing of a class.
    Exists(Quantified),
    /// The parts hold, and what is to be done in them was done in this order.
    /// States are those of the end.
    Then(Vec<Goal>),
}

/// A variable and the goal it stands in.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Quantified {
    /// The variable's name, without `?`.
    pub variable: String,
    /// The class it ranges over; everything, if none.
    pub class: Option<String>,
    /// The goal about it.
    pub body: Box<Goal>,
}

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

/// What a literal says.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Predicate {
    /// The thing is in a state.
    State(State),
    /// The first thing stands so to the second. `On`, `Inside` and `Near` are
    /// read generously, see the [module](self).
    Relation(Relation),
    /// The first, an agent, holds the second in either hand.
    Holds,
    /// The agent has done it.
    Did(Verb),
}

impl Predicate {
    /// How many things it is about.
    pub fn arity(self) -> usize {
        match self {
            Self::State(_) => 1,
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

impl fmt::Display for Term {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Class(class) => f.write_str(class),
            Self::Node(Some(class), id) => write!(f, "{class}.{}", id.0),
            Self::Node(None, id) => write!(f, "{id}"),
            Self::Variable(name) => write!(f, "?{name}"),
            Self::Me => f.write_str("me"),
            Self::Anything => f.write_str("_"),
        }
    }
}

impl fmt::Display for Literal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.predicate {
            Predicate::State(State::On) => f.write_str("SwitchedOn(")?,
            Predicate::State(State::Off) => f.write_str("SwitchedOff(")?,
            Predicate::State(state) => write!(f, "{}(", capitalised(state.as_str()))?,
            Predicate::Relation(relation) => write!(f, "{}(", capitalised(relation.as_str()))?,
            Predicate::Holds => write!(f, "Holds(")?,
            Predicate::Did(verb) => write!(f, "did {verb}(")?,
        }
        for (i, term) in self.terms.iter().enumerate() {
            write!(f, "{}{term}", if i == 0 { "" } else { ", " })?;
        }
        f.write_str(")")
    }
}

/// `plugged_in` as `PluggedIn`.
fn capitalised(word: &str) -> String {
    word.split('_').map(|part| part[..1].to_uppercase() + &part[1..]).collect()
}

/// How tightly a goal binds, for brackets.
fn rank(goal: &Goal) -> u8 {
    match goal {
        Goal::ForAll(_) | Goal::Exists(_) => 0,
        Goal::Then(_) => 1,
        Goal::Or(_) => 2,
        Goal::And(_) => 3,
        Goal::Not(_) => 4,
        Goal::Literal(_) | Goal::Count { .. } => 5,
    }
}

impl fmt::Display for Goal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Literal(literal) => write!(f, "{literal}"),
            Self::Count { literal, comparison, number } => {
                let sign = match comparison {
                    Comparison::AtLeast => "",
                    Comparison::Exactly => "= ",
                    Comparison::AtMost => "<= ",
                };
                write!(f, "{literal}, {sign}{number}")
            }
            Self::And(parts) => join(f, parts, " & ", rank(self), "true"),
            Self::Or(parts) => join(f, parts, " | ", rank(self), "false"),
            Self::Then(parts) => join(f, parts, " then ", rank(self), "true"),
            Self::Not(part) => {
                f.write_str("!")?;
                bracketed(f, part, rank(part) < rank(self))
            }
            Self::ForAll(q) => quantified(f, "forall", q),
            Self::Exists(q) => quantified(f, "exists", q),
        }
    }
}

fn bracketed(f: &mut fmt::Formatter<'_>, goal: &Goal, brackets: bool) -> fmt::Result {
    if brackets { write!(f, "({goal})") } else { write!(f, "{goal}") }
}

fn join(f: &mut fmt::Formatter<'_>, parts: &[Goal], sign: &str, rank_here: u8, none: &str) -> fmt::Result {
    if parts.is_empty() {
        return f.write_str(none);
    }
    for (i, part) in parts.iter().enumerate() {
        if i > 0 {
            f.write_str(sign)?;
        }
        // A list of one would vanish without its brackets.
        bracketed(f, part, rank(part) <= rank_here)?;
    }
    Ok(())
}

fn quantified(f: &mut fmt::Formatter<'_>, word: &str, q: &Quantified) -> fmt::Result {
    write!(f, "{word} ?{}", q.variable)?;
    if let Some(class) = &q.class {
        write!(f, ": {class}")?;
    }
    write!(f, ". {}", q.body)
}

impl Goal {
    /// A literal about given things.
    pub fn literal(predicate: Predicate, terms: Vec<Term>) -> Self {
        Self::Literal(Literal { predicate, terms })
    }

    /// How many parts are within parts; 1 for a literal.
    pub fn depth(&self) -> usize {
        1 + match self {
            Self::Literal(_) | Self::Count { .. } => 0,
            Self::And(parts) | Self::Or(parts) | Self::Then(parts) => parts.iter().map(Self::depth).max().unwrap_or(0),
            Self::Not(part) => part.depth(),
            Self::ForAll(q) | Self::Exists(q) => q.body.depth(),
        }
    }

    /// The things the goal speaks of: the terms of its literals, and the classes its
    /// variables range over.
    pub fn terms(&self) -> Vec<Term> {
        match self {
            Self::Literal(literal) | Self::Count { literal, .. } => literal.terms.clone(),
            Self::And(parts) | Self::Or(parts) | Self::Then(parts) => parts.iter().flat_map(Self::terms).collect(),
            Self::Not(part) => part.terms(),
            Self::ForAll(q) | Self::Exists(q) => {
                let class = q.class.clone().map(Term::Class);
                q.body.terms().into_iter().chain(class).collect()
            }
        }
    }

    /// The parts of a conjunction, or the goal itself.
    pub fn conjuncts(&self) -> &[Goal] {
        match self {
            Self::And(parts) => parts,
            other => std::slice::from_ref(other),
        }
    }
}

impl serde::Serialize for Goal {
    fn serialize<S: serde::Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        s.collect_str(self)
    }
}

impl<'de> serde::Deserialize<'de> for Goal {
    fn deserialize<D: serde::Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        let text = <std::borrow::Cow<'de, str>>::deserialize(d)?;
        text.parse().map_err(serde::de::Error::custom)
    }
}
