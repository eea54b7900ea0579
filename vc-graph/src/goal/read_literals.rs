//! Parsing of literals: predicates with terms, and the meaning of names.

use super::names::{agent_is_meant, eai_predicate, native_predicate};
use super::scan::{Token, is_plain};
use super::text::{Dialect, GoalError, GoalProblem, Reader};
use super::{Comparison, Goal, Literal, Predicate, Term};
use crate::spelling::{clip, same_word};
use crate::vocabulary::Word;
use crate::{ClassTable, NodeId, Relation, Verb};

impl Reader {
    pub(super) fn same(&mut self) -> Result<Goal, GoalError> {
        let first = self.one_thing()?;
        let differ = self.take(&["!="]) || !self.take(&["=", "=="]);
        let same = Goal::Same(first, self.one_thing()?);
        Ok(if differ { Goal::Not(Box::new(same)) } else { same })
    }

    fn one_thing(&mut self) -> Result<Term, GoalError> {
        let several = self.expected("a variable, a node such as `cup.12` or `me`");
        match self.word()? {
            Term::Class(_) | Term::Anything => Err(several),
            term => Ok(term),
        }
    }

    pub(super) fn counted(&mut self) -> Result<Goal, GoalError> {
        let literal = self.literal()?;
        let counts = match (self.peek(), self.ahead(1)) {
            (Some(Token::Sign(",")), Some(Token::Sign("=" | "==" | "<=" | ">="))) => true,
            (Some(Token::Sign(",")), Some(Token::Name(name))) => name.chars().all(|c| c.is_ascii_digit()),
            _ => false,
        };
        if !counts {
            return Ok(Goal::Literal(literal));
        }
        self.next += 1;
        let comparison = match self.peek() {
            Some(Token::Sign("=" | "==")) => Comparison::Exactly,
            Some(Token::Sign("<=")) => Comparison::AtMost,
            _ => Comparison::AtLeast,
        };
        self.take(&["=", "==", "<=", ">="]);
        match (comparison, self.number()?) {
            (Comparison::AtLeast, 1) => Ok(Goal::Literal(literal)),
            (_, number) => Ok(Goal::Count { literal, comparison, number }),
        }
    }

    fn literal(&mut self) -> Result<Literal, GoalError> {
        let start = self.at();
        let did = self.take(&["did"]);
        let name = self.name("a predicate such as `On(apple, table)`")?;
        let of_nothing = self.predicate(&name, did, 0).is_some_and(|p| p.arity() == 0);
        let brackets = if of_nothing {
            "`()` after a name that is about nothing, as in `did dance()`"
        } else {
            "`(` after the predicate"
        };
        self.demand("(", brackets)?;
        let mut terms = Vec::new();
        let things = self.next;
        while !self.take(&[")"]) {
            if !terms.is_empty() {
                self.demand(",", "`,` or `)`")?;
            }
            terms.push(self.term()?);
        }
        let fail = |problem| GoalError { at: start, problem };
        if let [Term::Class(class)] = &terms[..] {
            self.check_joined(&name, class, things)?;
        }
        let unknown = if did { GoalProblem::Verb } else { GoalProblem::Predicate };
        let predicate = self.predicate(&name, did, terms.len()).ok_or_else(|| fail(unknown(clip(&name))))?;
        let takes = predicate.arity();
        if terms.len() + 1 == takes {
            match predicate {
                Predicate::Relation(Relation::WornBy) => terms.push(Term::Me),
                _ if agent_is_meant(predicate) => terms.insert(0, Term::Me),
                _ => {}
            }
        }
        let given = terms.len();
        if given == takes {
            Ok(Literal { predicate, terms })
        } else {
            Err(fail(GoalProblem::Arity { predicate: clip(&name), takes, given }))
        }
    }

    /// Refuses two words without a comma after a predicate that takes one or two terms (`On`), unless they are
    /// the name of a class: they would be read as one term.
    fn check_joined(&self, name: &str, class: &str, at: usize) -> Result<(), GoalError> {
        let joined = matches!(self.tokens.get(at + 1), Some((_, Token::Name(_))));
        let of_two = matches!(native_predicate(name, 2), Some(Predicate::Relation(_)));
        let of_one = matches!(native_predicate(name, 1), Some(Predicate::State(_)));
        let called = |c: &crate::Class| std::iter::once(&c.name).chain(&c.aliases).any(|n| same_word(n, class));
        if !joined || !of_two || !of_one || ClassTable::builtin().get(class).is_some_and(called) {
            return Ok(());
        }
        let (at, token) = &self.tokens[at + 1];
        let found = if let Token::Name(word) = token { format!("`{}`", clip(word)) } else { String::new() };
        let expected = "`,` between two things; a class of two words is joined, `kitchen_table`";
        Err(GoalError { at: *at, problem: GoalProblem::Expected { expected, found } })
    }

    /// Parses a term; a class may be written in two words, `kitchen table`.
    fn term(&mut self) -> Result<Term, GoalError> {
        let first = match self.peek() {
            Some(Token::Name(name)) if is_plain(name) => name.clone(),
            _ => return self.word(),
        };
        let more = |r: &Self, by| matches!(r.ahead(by), Some(Token::Name(name)) if is_plain(name));
        if !more(self, 1) {
            return self.word();
        }
        self.next += 1;
        let mut name = first;
        while more(self, 0) {
            name = format!("{name}_{}", self.name("a class")?);
        }
        self.named(&name)
    }

    /// Parses a term of one word.
    fn word(&mut self) -> Result<Term, GoalError> {
        let unbound = |r: &Self, name: &str| r.error(GoalProblem::Unbound(name.to_owned()));
        let term = match self.peek() {
            Some(Token::Quoted(class, None)) => Term::Class(class.clone()),
            Some(Token::Quoted(class, Some(id))) => Term::Node(Some(class.clone()), *id),
            Some(Token::Variable(name)) if !self.bound.contains(name) => return Err(unbound(self, name)),
            Some(Token::Variable(name)) => Term::Variable(name.clone()),
            Some(Token::Name(name)) => match self.named(name)? {
                Term::Class(name) if name.starts_with('?') => {
                    return Err(unbound(self, name.trim_start_matches('?')));
                }
                term => term,
            },
            _ => return Err(self.expected("a thing: a class, `cup.12`, `me`, `?x` or `_`")),
        };
        self.next += 1;
        Ok(term)
    }

    /// The term that a name stands for.
    fn named(&self, name: &str) -> Result<Term, GoalError> {
        let variable = name.trim_start_matches('?');
        if self.bound.iter().any(|b| b == variable) {
            return Ok(Term::Variable(variable.to_owned()));
        }
        let number = |digits: &str| digits.parse().map(NodeId).map_err(|_| self.expected("the number of a node"));
        Ok(match (name, name.strip_prefix('#'), name.rsplit_once('.')) {
            ("_" | "*", ..) => Term::Anything,
            ("me" | "character", ..) => Term::Me,
            (_, Some(digits), _) => Term::Node(None, number(digits)?),
            (_, _, Some((class, _))) if self.dialect == Dialect::Eai && class == "character" => Term::Me,
            (_, _, Some((class, digits))) => Term::Node(Some(class.to_owned()), number(digits)?),
            _ => Term::Class(name.to_owned()),
        })
    }

    fn predicate(&self, name: &str, did: bool, given: usize) -> Option<Predicate> {
        if did {
            return Verb::parse(name).ok().or_else(|| Verb::from_virtualhome(name)).map(Predicate::Did);
        }
        match self.dialect {
            Dialect::Eai => eai_predicate(name, given),
            Dialect::Native => native_predicate(name, given),
        }
    }
}
