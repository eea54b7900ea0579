//! Parsing of goals: errors and the token stream.

use std::str::FromStr;

use super::Goal;
use super::scan::{Token, scan};
use crate::spelling::{clip, takes_and_given, unmarked};
use crate::vocabulary::known;
use crate::{Verb, did_you_mean, goal::names};

/// Longest goal that is parsed, bytes.
const LONGEST: usize = 64 * 1024;
/// Deepest goal that is parsed, levels of nested parts.
const DEEPEST: usize = 60;
/// Deepest nesting in the text: a written goal may have a bracket for each part.
pub(super) const NESTED: usize = 2 * DEEPEST + 2;

/// An error in a goal's text, with its location.
///
/// ```
/// use vc_graph::Goal;
/// let error = "On(apple, table".parse::<Goal>().unwrap_err();
/// assert!(error.to_string().contains(')'));
/// ```
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("goal, character {at}: {problem}")]
pub struct GoalError {
    /// Character, counted from one.
    pub at: usize,
    /// The error.
    pub problem: GoalProblem,
}

/// An error in a goal's text.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum GoalProblem {
    /// An unexpected token.
    #[error("expected {expected}, found {found}")]
    Expected {
        /// The expected text.
        expected: &'static str,
        /// The actual text.
        found: String,
    },
    /// An unknown predicate.
    #[error(
        "unknown predicate `{0}`{near}; use a state (Open, Clean), a relation (On, Inside, Near) or a verb (Sit, Eat); your own are declared in a `Vocabulary` first",
        near = did_you_mean(.0, names::known_predicates())
    )]
    Predicate(String),
    /// A word after `did` that is no verb.
    #[error("unknown verb `{0}` after `did`{near}; use one such as `did grab(cup)`; your own are declared in a `Vocabulary` first", near = did_you_mean(.0, known::<Verb>()))]
    Verb(String),
    /// A predicate with the wrong number of terms.
    #[error("`{predicate}` takes {}{near}", takes_and_given(*.takes, *.given), near = names::taking(.predicate, *.given))]
    Arity {
        /// The predicate.
        predicate: String,
        /// The number of terms it takes.
        takes: usize,
        /// The number of terms given.
        given: usize,
    },
    /// A variable that no quantifier binds.
    #[error("no forall or exists binds the variable `?{0}`")]
    Unbound(String),
    /// Too long.
    #[error("goals are at most {LONGEST} bytes long, this one has {0}")]
    TooLong(usize),
    /// Too deep.
    #[error("goals nest at most {DEEPEST} levels deep")]
    TooDeep,
}

impl FromStr for Goal {
    type Err = GoalError;

    fn from_str(text: &str) -> Result<Self, GoalError> {
        read(text, Dialect::Native, Vec::new())
    }
}

impl Goal {
    /// Parses a goal formula of the Embodied Agent Interface, such as
    /// `(exists x0. (TYPE(x0)) then ON(computer.417))`. Its verbs are past actions, its `ONTOP` is
    /// VirtualCity's `On`, its `NEXT_TO` is `Near`, and `character` is the agent.
    ///
    /// ```
    /// use vc_graph::Goal;
    /// let goal = Goal::from_eai("(exists x0. (TOUCH(x0)) then NEXT_TO(character.65, cat.1000))")?;
    /// assert_eq!(goal.to_string(), "(exists ?x0. did touch(?x0)) then Near(me, cat.1000)");
    /// # Ok::<(), vc_graph::goal::GoalError>(())
    /// ```
    ///
    /// # Errors
    /// [`GoalError`], with the location and the expected form.
    pub fn from_eai(text: &str) -> Result<Self, GoalError> {
        read(text, Dialect::Eai, Vec::new())
    }

    /// Parses a goal with free variables.
    pub(super) fn with_free(text: &str, variables: &[String]) -> Result<Self, GoalError> {
        read(text, Dialect::Native, variables.to_vec())
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Dialect {
    Native,
    Eai,
}

fn read(text: &str, dialect: Dialect, bound: Vec<String>) -> Result<Goal, GoalError> {
    let text = unmarked(text);
    if text.len() > LONGEST {
        return Err(GoalError { at: 1, problem: GoalProblem::TooLong(text.len()) });
    }
    let tokens = scan(text)?;
    let mut reader = Reader { tokens, next: 0, end: text.chars().count() + 1, dialect, bound, depth: 0 };
    let goal = reader.goal()?;
    match reader.peek() {
        None if goal.depth() > DEEPEST => Err(GoalError { at: 1, problem: GoalProblem::TooDeep }),
        None => Ok(goal),
        Some(_) => Err(reader.expected("`&`, `|`, `then` or the end")),
    }
}

pub(super) struct Reader {
    pub(super) tokens: Vec<(usize, Token)>,
    pub(super) next: usize,
    end: usize,
    pub(super) dialect: Dialect,
    pub(super) bound: Vec<String>,
    pub(super) depth: usize,
}

/// Tokens and errors.
impl Reader {
    pub(super) fn peek(&self) -> Option<&Token> {
        self.ahead(0)
    }

    pub(super) fn ahead(&self, by: usize) -> Option<&Token> {
        self.tokens.get(self.next + by).map(|(_, token)| token)
    }

    pub(super) fn at(&self) -> usize {
        self.tokens.get(self.next).map_or(self.end, |(at, _)| *at)
    }

    pub(super) fn error(&self, problem: GoalProblem) -> GoalError {
        GoalError { at: self.at(), problem }
    }

    pub(super) fn expected(&self, expected: &'static str) -> GoalError {
        let found = match self.peek() {
            None => "the end".to_owned(),
            Some(Token::Name(name) | Token::Quoted(name, _) | Token::Variable(name)) => format!("`{}`", clip(name)),
            Some(Token::Sign(sign)) => format!("`{sign}`"),
        };
        self.error(GoalProblem::Expected { expected, found })
    }

    /// Consumes the next token if it is one of some signs or keywords.
    pub(super) fn take(&mut self, any: &[&str]) -> bool {
        let found = match self.peek() {
            Some(Token::Sign(sign)) => any.contains(sign),
            Some(Token::Name(name)) => any.iter().any(|word| name.eq_ignore_ascii_case(word)),
            _ => false,
        };
        self.next += usize::from(found);
        found
    }

    pub(super) fn demand(&mut self, sign: &'static str, expected: &'static str) -> Result<(), GoalError> {
        if self.take(&[sign]) { Ok(()) } else { Err(self.expected(expected)) }
    }

    pub(super) fn name(&mut self, expected: &'static str) -> Result<String, GoalError> {
        match self.peek() {
            Some(Token::Name(name)) => {
                let name = name.clone();
                self.next += 1;
                Ok(name)
            }
            _ => Err(self.expected(expected)),
        }
    }

    pub(super) fn number(&mut self) -> Result<u32, GoalError> {
        let not_a_number = self.expected("a number");
        self.name("a number")?.parse().map_err(|_| not_a_number)
    }
}
