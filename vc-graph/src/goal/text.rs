//! Reading goals.

use std::str::FromStr;

use super::names::{agent_is_meant, eai_predicate, native_predicate};
use super::scan::{Token, is_plain, scan};
use super::{Comparison, Goal, Literal, Pairing, Pairs, Predicate, Quantified, Term, Variable};
use crate::vocabulary::Word;
use crate::vocabulary::clip;
use crate::{NodeId, Relation, Verb};

/// Longest goal that is read, bytes.
const LONGEST: usize = 64 * 1024;
/// Deepest goal that is read: parts within parts.
const DEEPEST: usize = 60;
/// Deepest nesting in the text: a goal that is written may have a bracket for each
/// part.
const NESTED: usize = 2 * DEEPEST + 2;

/// Where a goal is wrong.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("goal, character {at}: {problem}")]
pub struct GoalError {
    /// Character, counted from one.
    pub at: usize,
    /// What is wrong there.
    pub problem: GoalProblem,
}

/// What is wrong with a goal.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum GoalProblem {
    /// Something else should stand here.
    #[error("expected {expected}, found {found}")]
    Expected {
        /// What should stand here.
        expected: &'static str,
        /// What does.
        found: String,
    },
    /// No such predicate.
    #[error("unknown predicate `{0}`; use a state (Open, Clean), a relation (On, Inside, Near) or a verb (Sit, Eat)")]
    Predicate(String),
    /// A predicate with the wrong number of things.
    #[error("`{predicate}` takes {takes} things, {given} are given")]
    Arity {
        /// The predicate.
        predicate: String,
        /// How many it takes.
        takes: usize,
        /// How many there are.
        given: usize,
    },
    /// A variable no quantifier binds.
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
        read(text, Dialect::Native)
    }
}

impl Goal {
    /// Reads a goal formula of the Embodied Agent Interface, such as
    /// `(exists x0. (TYPE(x0)) then ON(computer.417))`. Its verbs are things done,
    /// its `ONTOP` is our `On`, its `NEXT_TO` our `Near`, and `character` the agent.
    ///
    /// ```
    /// use vc_graph::Goal;
    /// let goal = Goal::from_eai("(exists x0. (TOUCH(x0)) then NEXT_TO(character.65, cat.1000))")?;
    /// assert_eq!(goal.to_string(), "(exists ?x0. did touch(?x0)) then Near(me, cat.1000)");
    /// # Ok::<(), vc_graph::goal::GoalError>(())
    /// ```
    ///
    /// # Errors
    /// [`GoalError`] says where and what was expected.
    pub fn from_eai(text: &str) -> Result<Self, GoalError> {
        read(text, Dialect::Eai)
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Dialect {
    Native,
    Eai,
}

fn read(text: &str, dialect: Dialect) -> Result<Goal, GoalError> {
    if text.len() > LONGEST {
        return Err(GoalError { at: 1, problem: GoalProblem::TooLong(text.len()) });
    }
    let tokens = scan(text)?;
    let mut reader = Reader { tokens, next: 0, end: text.chars().count() + 1, dialect, bound: Vec::new(), depth: 0 };
    let goal = reader.goal()?;
    match reader.peek() {
        None if goal.depth() > DEEPEST => Err(GoalError { at: 1, problem: GoalProblem::TooDeep }),
        None => Ok(goal),
        Some(_) => Err(reader.expected("`&`, `|`, `then` or the end")),
    }
}

struct Reader {
    tokens: Vec<(usize, Token)>,
    next: usize,
    end: usize,
    dialect: Dialect,
    bound: Vec<String>,
    depth: usize,
}

/// Tokens, errors.
impl Reader {
    fn peek(&self) -> Option<&Token> {
        self.ahead(0)
    }

    fn ahead(&self, by: usize) -> Option<&Token> {
        self.tokens.get(self.next + by).map(|(_, token)| token)
    }

    fn at(&self) -> usize {
        self.tokens.get(self.next).map_or(self.end, |(at, _)| *at)
    }

    fn error(&self, problem: GoalProblem) -> GoalError {
        GoalError { at: self.at(), problem }
    }

    fn expected(&self, expected: &'static str) -> GoalError {
        let found = match self.peek() {
            None => "the end".to_owned(),
            Some(Token::Name(name) | Token::Quoted(name, _) | Token::Variable(name)) => format!("`{}`", clip(name)),
            Some(Token::Sign(sign)) => format!("`{sign}`"),
        };
        self.error(GoalProblem::Expected { expected, found })
    }

    /// Takes one of some signs or keywords.
    fn take(&mut self, any: &[&str]) -> bool {
        let found = match self.peek() {
            Some(Token::Sign(sign)) => any.contains(sign),
            Some(Token::Name(name)) => any.iter().any(|word| name.eq_ignore_ascii_case(word)),
            _ => false,
        };
        self.next += usize::from(found);
        found
    }

    fn demand(&mut self, sign: &'static str, expected: &'static str) -> Result<(), GoalError> {
        if self.take(&[sign]) { Ok(()) } else { Err(self.expected(expected)) }
    }

    fn name(&mut self, expected: &'static str) -> Result<String, GoalError> {
        match self.peek() {
            Some(Token::Name(name)) => {
                let name = name.clone();
                self.next += 1;
                Ok(name)
            }
            _ => Err(self.expected(expected)),
        }
    }

    fn number(&mut self) -> Result<u32, GoalError> {
        let not_a_number = self.expected("a number");
        self.name("a number")?.parse().map_err(|_| not_a_number)
    }
}

/// Connectives, loosest first.
impl Reader {
    fn goal(&mut self) -> Result<Goal, GoalError> {
        self.list(&["then"], Goal::Then, Self::in_time)
    }

    fn in_time(&mut self) -> Result<Goal, GoalError> {
        let words: [(_, fn(_, _) -> Goal); 2] = [(&["until"][..], Goal::Until), (&["before"], Goal::Before)];
        self.infix(&words, |r| r.infix(&[(&["=>", "imply", "implies"], Goal::Imply)], Self::either))
    }

    /// Two parts at most: what `a => b => c` means is better said with brackets.
    fn infix(
        &mut self,
        words: &[(&[&str], fn(Box<Goal>, Box<Goal>) -> Goal)],
        part: impl Fn(&mut Self) -> Result<Goal, GoalError>,
    ) -> Result<Goal, GoalError> {
        let first = part(self)?;
        match words.iter().find(|(any, _)| self.take(any)) {
            Some((_, build)) => Ok(build(Box::new(first), Box::new(part(self)?))),
            None => Ok(first),
        }
    }

    fn either(&mut self) -> Result<Goal, GoalError> {
        self.list(&["|", "||", "or"], Goal::Or, |r| r.list(&["&", "&&", ";", "and"], Goal::And, Self::unary))
    }

    fn list(
        &mut self,
        signs: &[&str],
        build: fn(Vec<Goal>) -> Goal,
        mut part: impl FnMut(&mut Self) -> Result<Goal, GoalError>,
    ) -> Result<Goal, GoalError> {
        let first = part(self)?;
        let mut parts = vec![first];
        while self.take(signs) || (signs.contains(&"&") && self.comma_before_predicate()) {
            parts.push(part(self)?);
        }
        let single = parts.len() == 1;
        Ok(if single { parts.remove(0) } else { build(parts) })
    }

    /// `On(a, b), 1, Sit(c), 1`: the comma after a literal joins the next.
    fn comma_before_predicate(&mut self) -> bool {
        let rest = &self.tokens[self.next.min(self.tokens.len())..];
        let joins = matches!(rest, [(_, Token::Sign(",")), (_, Token::Name(_)), (_, Token::Sign("(")), ..]);
        self.next += usize::from(joins);
        joins
    }

    fn unary(&mut self) -> Result<Goal, GoalError> {
        self.depth += 1;
        if self.depth > NESTED {
            return Err(self.error(GoalProblem::TooDeep));
        }
        let goal = self.simple();
        self.depth -= 1;
        goal
    }

    fn part(&mut self) -> Result<Box<Goal>, GoalError> {
        self.unary().map(Box::new)
    }

    fn simple(&mut self) -> Result<Goal, GoalError> {
        if matches!(self.ahead(1), Some(Token::Sign("=" | "==" | "!="))) {
            return self.same();
        }
        if self.take(&["("]) {
            let goal = self.goal()?;
            self.demand(")", "`)`")?;
            return Ok(goal);
        }
        match self.keyword() {
            Some("!" | "not") => self.part().map(Goal::Not),
            Some("eventually") => self.part().map(Goal::Eventually),
            Some("always") => self.part().map(Goal::Always),
            Some("within") => self.within(),
            Some("at") => self.at_end_or_count(),
            Some("exactly") => self.for_n(Comparison::Exactly),
            Some("forn") => self.eai_for_n(),
            Some("forall") => self.quantified().map(Goal::ForAll),
            Some("exists") => self.quantified().map(Goal::Exists),
            Some("marginal") => self.marginal_pairs(None),
            Some("pairs") => self.pairs(None, Pairing::Matching),
            Some("true") => Ok(Goal::And(Vec::new())),
            Some("false") => Ok(Goal::Or(Vec::new())),
            _ => self.counted(),
        }
    }

    /// A word that begins a part; none if it is followed by what makes it a
    /// predicate.
    fn keyword(&mut self) -> Option<&'static str> {
        const WORDS: [&str; 13] = [
            "!",
            "not",
            "forall",
            "exists",
            "true",
            "false",
            "eventually",
            "always",
            "within",
            "at",
            "exactly",
            "marginal",
            "pairs",
        ];
        let forn = (self.dialect == Dialect::Eai).then_some("forn");
        WORDS.into_iter().chain(forn).find(|word| self.take(&[word]))
    }

    fn within(&mut self) -> Result<Goal, GoalError> {
        let steps = self.number()?;
        self.take(&["steps", "step"]);
        Ok(Goal::Within(steps, self.part()?))
    }

    fn at_end_or_count(&mut self) -> Result<Goal, GoalError> {
        if self.take(&["least"]) {
            return self.for_n(Comparison::AtLeast);
        }
        if self.take(&["most"]) {
            return self.for_n(Comparison::AtMost);
        }
        self.take(&["the"]);
        self.demand("end", "`end`, `least` or `most`")?;
        self.part().map(Goal::AtEnd)
    }
}

/// Variables.
impl Reader {
    /// What follows `exactly`.
    fn for_n(&mut self, comparison: Comparison) -> Result<Goal, GoalError> {
        let number = self.number()?;
        if self.take(&["marginal"]) {
            return self.marginal_pairs(Some((comparison, number)));
        }
        if self.take(&["pairs"]) {
            return self.pairs(Some((comparison, number)), Pairing::Matching);
        }
        Ok(Goal::ForN { comparison, number, of: self.quantified()? })
    }

    /// `forn 2. x. (...)`.
    fn eai_for_n(&mut self) -> Result<Goal, GoalError> {
        let number = self.number()?;
        self.demand(".", "`.` after the number")?;
        Ok(Goal::ForN { comparison: Comparison::Exactly, number, of: self.quantified()? })
    }

    fn marginal_pairs(&mut self, number: Option<(Comparison, u32)>) -> Result<Goal, GoalError> {
        self.demand("pairs", "`pairs`")?;
        self.pairs(number, Pairing::Marginal)
    }

    fn pairs(&mut self, number: Option<(Comparison, u32)>, pairing: Pairing) -> Result<Goal, GoalError> {
        let first = self.variable()?;
        self.demand(",", "`,` and the other variable")?;
        let second = self.variable()?;
        let body = self.body(&[&first.name, &second.name])?;
        Ok(Goal::ForPairs(Pairs { first, second, number, pairing, body }))
    }

    fn quantified(&mut self) -> Result<Quantified, GoalError> {
        let Variable { name: variable, class } = self.variable()?;
        let body = self.body(&[&variable])?;
        Ok(Quantified { variable, class, body })
    }

    fn variable(&mut self) -> Result<Variable, GoalError> {
        const VARIABLE: &str = "a variable such as `?x`";
        let not_a_variable = self.expected(VARIABLE);
        let name = if let Some(Token::Variable(name)) = self.peek() {
            let name = name.clone();
            self.next += 1;
            name
        } else {
            let name = self.name(VARIABLE)?;
            let bare = name.strip_prefix('?').unwrap_or(&name);
            if !is_plain(bare) {
                return Err(not_a_variable);
            }
            bare.to_owned()
        };
        let class = if self.take(&[":"]) { Some(self.class()?) } else { None };
        Ok(Variable { name, class })
    }

    fn class(&mut self) -> Result<String, GoalError> {
        if let Some(Token::Quoted(class, None)) = self.peek() {
            let class = class.clone();
            self.next += 1;
            return Ok(class);
        }
        self.name("a class")
    }

    fn body(&mut self, variables: &[&str]) -> Result<Box<Goal>, GoalError> {
        self.demand(".", "`.` after the variable")?;
        let outer = self.bound.len();
        self.bound.extend(variables.iter().map(|&v| v.to_owned()));
        // EAI's quantifiers end with the bracket that follows them.
        let body = if self.dialect == Dialect::Eai { self.unary() } else { self.goal() };
        self.bound.truncate(outer);
        body.map(Box::new)
    }
}

/// Literals.
impl Reader {
    fn same(&mut self) -> Result<Goal, GoalError> {
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

    fn counted(&mut self) -> Result<Goal, GoalError> {
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
        self.demand("(", "`(` after the predicate")?;
        let mut terms = Vec::new();
        while !self.take(&[")"]) {
            if !terms.is_empty() {
                self.demand(",", "`,` or `)`")?;
            }
            terms.push(self.term()?);
        }
        let fail = |problem| GoalError { at: start, problem };
        let predicate =
            self.predicate(&name, did, terms.len()).ok_or_else(|| fail(GoalProblem::Predicate(clip(&name))))?;
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

    /// A term; `kitchen table` is written in two words as well.
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
        Ok(self.named(&name))
    }

    /// A term of one word.
    fn word(&mut self) -> Result<Term, GoalError> {
        let unbound = |r: &Self, name: &str| r.error(GoalProblem::Unbound(name.to_owned()));
        let term = match self.peek() {
            Some(Token::Quoted(class, None)) => Term::Class(class.clone()),
            Some(Token::Quoted(class, Some(id))) => Term::Node(Some(class.clone()), *id),
            Some(Token::Variable(name)) if !self.bound.contains(name) => return Err(unbound(self, name)),
            Some(Token::Variable(name)) => Term::Variable(name.clone()),
            Some(Token::Name(name)) => match self.named(name) {
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

    /// What a name stands for.
    fn named(&self, name: &str) -> Term {
        let variable = name.trim_start_matches('?');
        if self.bound.iter().any(|b| b == variable) {
            return Term::Variable(variable.to_owned());
        }
        let number = |digits: &str| digits.parse().ok().map(NodeId);
        match name {
            "_" | "*" => Term::Anything,
            "me" | "character" => Term::Me,
            other => match (other.strip_prefix('#').and_then(number), other.rsplit_once('.')) {
                (Some(id), _) => Term::Node(None, id),
                (_, Some((class, _))) if self.dialect == Dialect::Eai && class == "character" => Term::Me,
                (_, Some((class, digits))) => match number(digits) {
                    Some(id) => Term::Node(Some(class.to_owned()), id),
                    None => Term::Class(name.to_owned()),
                },
                _ => Term::Class(name.to_owned()),
            },
        }
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
