//! Writing goals as text.

use std::fmt;

use super::scan::is_plain;
use super::{Comparison, Goal, Literal, Pairing, Pairs, Predicate, Quantified, Term};
use crate::State;
use crate::vocabulary::Word;

impl fmt::Display for Term {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Writer { f, bound: Vec::new() }.term(self)
    }
}

impl fmt::Display for Literal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Writer { f, bound: Vec::new() }.literal(self)
    }
}

impl fmt::Display for Goal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Writer { f, bound: Vec::new() }.goal(self)
    }
}

/// A goal with free variables as text: classes of their names are written in quotes.
pub(super) struct Open<'g>(pub(super) &'g Goal, pub(super) &'g [String]);

impl fmt::Display for Open<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Writer { f, bound: self.1.iter().map(String::as_str).collect() }.goal(self.0)
    }
}

/// The binding strength of a goal, which decides where brackets are needed.
fn rank(goal: &Goal) -> u8 {
    match goal {
        Goal::ForAll(_) | Goal::Exists(_) | Goal::ForN { .. } | Goal::ForPairs(_) => 0,
        Goal::Then(_) => 1,
        Goal::Until(..) | Goal::Before(..) => 2,
        Goal::Imply(..) => 3,
        Goal::Or(_) => 4,
        Goal::And(_) => 5,
        Goal::Not(part) if matches!(**part, Goal::Same(..)) => 7,
        Goal::Not(_) | Goal::Eventually(_) | Goal::Always(_) | Goal::Within(..) | Goal::AtEnd(_) => 6,
        Goal::Literal(_) | Goal::Count { .. } | Goal::Same(..) => 7,
    }
}

/// The text of an empty list of parts: its truth value.
fn nothing(goal: &Goal) -> Option<&'static str> {
    match goal {
        Goal::And(parts) | Goal::Then(parts) if parts.is_empty() => Some("true"),
        Goal::Or(parts) if parts.is_empty() => Some("false"),
        _ => None,
    }
}

fn sign(comparison: Comparison) -> &'static str {
    match comparison {
        Comparison::AtLeast => "at least",
        Comparison::Exactly => "exactly",
        Comparison::AtMost => "at most",
    }
}

/// Capitalises: `plugged_in` becomes `PluggedIn`.
pub(super) fn capitalised(word: &str) -> String {
    word.split('_').map(|part| part[..1].to_uppercase() + &part[1..]).collect()
}

struct Writer<'g, 'f, 'b> {
    f: &'f mut fmt::Formatter<'b>,
    /// Variables bound so far: a class of the same name is written in quotes.
    bound: Vec<&'g str>,
}

impl<'g> Writer<'g, '_, '_> {
    fn goal(&mut self, goal: &'g Goal) -> fmt::Result {
        if let Some(word) = nothing(goal) {
            return self.f.write_str(word);
        }
        match goal {
            Goal::Literal(literal) => self.literal(literal),
            Goal::Count { literal, comparison, number } => self.count(literal, *comparison, *number),
            Goal::Same(a, b) => self.same(a, " = ", b),
            Goal::And(parts) => self.list(goal, parts, " & "),
            Goal::Or(parts) => self.list(goal, parts, " | "),
            Goal::Then(parts) => self.list(goal, parts, " then "),
            Goal::Not(part) => match &**part {
                Goal::Same(a, b) => self.same(a, " != ", b),
                _ => self.prefixed("!", part),
            },
            Goal::Imply(a, b) => self.infix(goal, a, " => ", b),
            Goal::Until(a, b) => self.infix(goal, a, " until ", b),
            Goal::Before(a, b) => self.infix(goal, a, " before ", b),
            Goal::Eventually(part) => self.prefixed("eventually ", part),
            Goal::Always(part) => self.prefixed("always ", part),
            Goal::Within(steps, part) => self.prefixed(&format!("within {steps} steps "), part),
            Goal::AtEnd(part) => self.prefixed("at end ", part),
            Goal::ForAll(q) => self.quantified("forall", q),
            Goal::Exists(q) => self.quantified("exists", q),
            Goal::ForN { comparison, number, of } => self.quantified(&format!("{} {number}", sign(*comparison)), of),
            Goal::ForPairs(pairs) => self.pairs(pairs),
        }
    }

    fn bracketed(&mut self, goal: &'g Goal, brackets: bool) -> fmt::Result {
        if !brackets {
            return self.goal(goal);
        }
        self.f.write_str("(")?;
        self.goal(goal)?;
        self.f.write_str(")")
    }

    fn list(&mut self, whole: &Goal, parts: &'g [Goal], sign: &str) -> fmt::Result {
        for (i, part) in parts.iter().enumerate() {
            if i > 0 {
                self.f.write_str(sign)?;
            }
            // A list with one part would be lost without its brackets.
            self.bracketed(part, rank(part) <= rank(whole) && nothing(part).is_none())?;
        }
        Ok(())
    }

    fn infix(&mut self, whole: &Goal, a: &'g Goal, sign: &str, b: &'g Goal) -> fmt::Result {
        self.bracketed(a, rank(a) <= rank(whole) && nothing(a).is_none())?;
        self.f.write_str(sign)?;
        self.bracketed(b, rank(b) <= rank(whole) && nothing(b).is_none())
    }

    fn prefixed(&mut self, word: &str, part: &'g Goal) -> fmt::Result {
        self.f.write_str(word)?;
        self.bracketed(part, rank(part) < 6 && nothing(part).is_none())
    }

    fn same(&mut self, a: &Term, sign: &str, b: &Term) -> fmt::Result {
        self.term(a)?;
        self.f.write_str(sign)?;
        self.term(b)
    }

    fn quantified(&mut self, word: &str, q: &'g Quantified) -> fmt::Result {
        write!(self.f, "{word} ")?;
        self.variable(&q.variable, q.class.as_deref())?;
        self.f.write_str(". ")?;
        self.bound.push(&q.variable);
        self.goal(&q.body)?;
        self.bound.pop();
        Ok(())
    }

    fn pairs(&mut self, pairs: &'g Pairs) -> fmt::Result {
        if let Some((comparison, number)) = pairs.number {
            write!(self.f, "{} {number} ", sign(comparison))?;
        }
        self.f.write_str(if pairs.pairing == Pairing::Marginal { "marginal pairs " } else { "pairs " })?;
        self.variable(&pairs.first.name, pairs.first.class.as_deref())?;
        self.f.write_str(", ")?;
        self.variable(&pairs.second.name, pairs.second.class.as_deref())?;
        self.f.write_str(". ")?;
        self.bound.extend([pairs.first.name.as_str(), pairs.second.name.as_str()]);
        self.goal(&pairs.body)?;
        self.bound.truncate(self.bound.len() - 2);
        Ok(())
    }

    fn variable(&mut self, name: &str, class: Option<&str>) -> fmt::Result {
        self.f.write_str("?")?;
        self.word(name, is_plain(name))?;
        let Some(class) = class else { return Ok(()) };
        self.f.write_str(": ")?;
        self.word(class, is_plain(class))
    }

    /// A name, quoted if it is not plain.
    fn word(&mut self, name: &str, plain: bool) -> fmt::Result {
        match plain {
            true => self.f.write_str(name),
            false => write!(self.f, "\"{}\"", name.replace('\\', "\\\\").replace('"', "\\\"")),
        }
    }

    fn count(&mut self, literal: &'g Literal, comparison: Comparison, number: u32) -> fmt::Result {
        self.literal(literal)?;
        let sign = match comparison {
            Comparison::AtLeast => "",
            Comparison::Exactly => "= ",
            Comparison::AtMost => "<= ",
        };
        write!(self.f, ", {sign}{number}")
    }

    fn literal(&mut self, literal: &Literal) -> fmt::Result {
        match literal.predicate {
            Predicate::State(State::On) => self.f.write_str("SwitchedOn(")?,
            Predicate::State(State::Off) => self.f.write_str("SwitchedOff(")?,
            Predicate::State(state) => write!(self.f, "{}(", capitalised(state.as_str()))?,
            Predicate::Relation(relation) => write!(self.f, "{}(", capitalised(relation.as_str()))?,
            Predicate::Holds => self.f.write_str("Holds(")?,
            Predicate::Did(verb) => write!(self.f, "did {verb}(")?,
            Predicate::Derived(predicate) => write!(self.f, "{}(", capitalised(predicate.as_str()))?,
            Predicate::Real => self.f.write_str("Real(")?,
        }
        for (i, term) in literal.terms.iter().enumerate() {
            self.f.write_str(if i == 0 { "" } else { ", " })?;
            self.term(term)?;
        }
        self.f.write_str(")")
    }

    fn term(&mut self, term: &Term) -> fmt::Result {
        match term {
            Term::Class(class) => {
                let taken = matches!(class.as_str(), "_" | "me" | "character") || self.bound.contains(&class.as_str());
                self.word(class, is_plain(class) && !taken)
            }
            Term::Node(Some(class), id) => {
                self.word(class, is_plain(class))?;
                write!(self.f, ".{}", id.0)
            }
            Term::Node(None, id) => write!(self.f, "{id}"),
            Term::Variable(name) => self.variable(name, None),
            Term::Me => self.f.write_str("me"),
            Term::Anything => self.f.write_str("_"),
        }
    }
}
