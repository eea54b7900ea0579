//! Definitions of derived predicates.

use std::fmt;

use super::read_parts::is_reserved;
use super::scan::is_plain;
use super::write::Open;
use super::{DerivedPredicate, Goal, Predicate, Term};
use crate::clip;
use crate::vocabulary::{Used, Vocabulary, VocabularyProblem as Problem};

/// The number of parts that a definition may have, those of the predicates in it included.
const LARGEST: usize = 256;

/// The definition of a [`DerivedPredicate`] in a [`Vocabulary`].
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct PredicateDefinition {
    /// The predicate.
    pub predicate: DerivedPredicate,
    /// The variables that stand for its terms, without `?`.
    pub variables: Vec<String>,
    /// The goal that the predicate stands for, without words of time.
    pub body: Goal,
}

impl PredicateDefinition {
    /// The variables of a declaration, `?x ?y`.
    pub(crate) fn variables(text: &str) -> Result<Vec<String>, Problem> {
        let wrong = || Problem::Variables(clip(text));
        let name =
            |word: &str| word.strip_prefix('?').filter(|name| is_plain(name) && !is_reserved(name)).map(str::to_owned);
        let names: Vec<String> = text.split_whitespace().map(name).collect::<Option<_>>().ok_or_else(wrong)?;
        let distinct = names.iter().enumerate().all(|(place, name)| !names[..place].contains(name));
        if names.len() <= 2 && distinct { Ok(names) } else { Err(wrong()) }
    }

    /// Reads the goal of a definition.
    pub(crate) fn read(predicate: DerivedPredicate, variables: Vec<String>, text: &str) -> Result<Self, Problem> {
        if text.is_empty() {
            return Err(Problem::Undefined(predicate.as_str()));
        }
        let body = Goal::with_free(text, &variables)?;
        if body.is_temporal() {
            return Err(Problem::Temporal(predicate.as_str()));
        }
        if let Some(node) = body.terms().into_iter().find(|term| matches!(term, Term::Node(..))) {
            return Err(Problem::NamesNode { predicate: predicate.as_str(), node: node.to_string() });
        }
        Ok(Self { predicate, variables, body })
    }

    /// The own words in the definition.
    pub(crate) fn used(&self) -> Vec<Used> {
        let mut used = Vec::new();
        self.body.each_literal(&mut |literal| match literal.predicate {
            Predicate::State(state) => used.push(Used::State(state)),
            Predicate::Did(verb) => used.push(Used::Verb(verb)),
            Predicate::Derived(predicate) => used.push(Used::Predicate(predicate)),
            _ => {}
        });
        used
    }

    /// Checks that a definition ends: it does not refer to itself, and is not too large with all that it refers to.
    pub(crate) fn check(&self, words: &Vocabulary) -> Result<(), Problem> {
        let mut left = LARGEST;
        self.body.spend(words, &mut vec![self.predicate], &mut left)
    }
}

impl Goal {
    /// Takes the number of its parts from what is left, with those of the definitions `within` which it is.
    fn spend(&self, words: &Vocabulary, within: &mut Vec<DerivedPredicate>, left: &mut usize) -> Result<(), Problem> {
        let outer = || within[0].as_str();
        *left = left.checked_sub(1).ok_or_else(|| Problem::Large { predicate: outer(), largest: LARGEST })?;
        if let Self::Literal(literal) | Self::Count { literal, .. } = self {
            let Some(definition) = words.definition(literal.predicate) else { return Ok(()) };
            if within.contains(&definition.predicate) {
                return Err(Problem::Circular(outer()));
            }
            within.push(definition.predicate);
            definition.body.spend(words, within, left)?;
            within.pop();
        }
        self.parts().into_iter().try_for_each(|part| part.spend(words, within, left))
    }
}

/// As a line of a vocabulary.
impl fmt::Display for PredicateDefinition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "predicate {}", self.predicate.as_str())?;
        self.variables.iter().try_for_each(|name| write!(f, " ?{name}"))?;
        write!(f, " | is: {}", Open(&self.body, &self.variables))
    }
}
