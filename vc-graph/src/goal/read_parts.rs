//! Parsing of connectives and quantifiers.

use super::scan::{Token, is_plain};
use super::text::{Dialect, GoalError, GoalProblem, NESTED, Reader};
use super::{Comparison, Goal, Pairing, Pairs, Quantified, Variable};

/// Joins the two parts around an operator.
type Join = fn(Box<Goal>, Box<Goal>) -> Goal;

/// Connectives, loosest binding first.
impl Reader {
    pub(super) fn goal(&mut self) -> Result<Goal, GoalError> {
        self.list(&["then"], Goal::Then, Self::in_time)
    }

    fn in_time(&mut self) -> Result<Goal, GoalError> {
        let words: [(&[&str], Join); 2] = [(&["until"], Goal::Until), (&["before"], Goal::Before)];
        self.infix(&words, |r| r.infix(&[(&["=>", "imply", "implies"], Goal::Imply)], Self::either))
    }

    /// Parses at most two parts: for `a => b => c` brackets are required, since its meaning is unclear.
    fn infix(
        &mut self,
        words: &[(&[&str], Join)],
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

    /// Whether the comma after a literal joins the next literal: `On(a, b), 1, Sit(c), 1`.
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

    /// A word that begins a part; `None` if the following token makes it a predicate.
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

/// Quantifiers and their variables.
impl Reader {
    /// Parses the rest after `exactly` and the like.
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

    /// Parses `forn 2. x. (...)`.
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
        const VARIABLE: &str = "a variable such as `?x`, not `me`, `character`, `_` or `*`";
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
        if is_reserved(&name) {
            return Err(not_a_variable);
        }
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
        // EAI's quantifiers end with the bracket after them.
        let body = if self.dialect == Dialect::Eai { self.unary() } else { self.goal() };
        self.bound.truncate(outer);
        body.map(Box::new)
    }
}

/// Whether a name has a meaning of its own as a term, so that no variable can have it.
pub(super) fn is_reserved(name: &str) -> bool {
    matches!(name, "me" | "character" | "_" | "*")
}
