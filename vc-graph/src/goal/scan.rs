//! Tokenising the text of a goal.

use super::{GoalError, GoalProblem};
use crate::NodeId;
use crate::spelling::composed;

/// A token.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Token {
    /// A name, number, `?variable`, `#12` or `cup.12`.
    Name(String),
    /// A class in quotes, with or without a node's number.
    Quoted(String, Option<NodeId>),
    /// A variable in quotes.
    Variable(String),
    /// One of [`SIGNS`].
    Sign(&'static str),
}

/// The signs, longer ones first.
const SIGNS: [&str; 17] = ["<=", ">=", "=>", "==", "!=", "&&", "||", "(", ")", ",", ":", ".", "!", "&", "|", "=", ";"];

/// The tokens of a text, each with its position in characters, counted from one.
pub(super) fn scan(text: &str) -> Result<Vec<(usize, Token)>, GoalError> {
    let mut scanner = Scanner { chars: composed(text).chars().collect(), at: 0 };
    let mut tokens = Vec::new();
    while let Some(next) = scanner.peek(0) {
        let start = scanner.at;
        if next.is_whitespace() {
            scanner.at += 1;
        } else {
            tokens.push((start + 1, scanner.token()?));
        }
    }
    Ok(tokens)
}

/// Whether a class or variable of that name can be written without quotes.
pub(super) fn is_plain(name: &str) -> bool {
    !name.is_empty() && name.chars().all(is_name)
}

pub(super) fn is_name(c: char) -> bool {
    c.is_alphanumeric() || c == '_' || c == '-'
}

struct Scanner {
    chars: Vec<char>,
    at: usize,
}

impl Scanner {
    fn peek(&self, ahead: usize) -> Option<char> {
        self.chars.get(self.at + ahead).copied()
    }

    fn token(&mut self) -> Result<Token, GoalError> {
        let sign = SIGNS.iter().find(|s| s.chars().enumerate().all(|(i, c)| self.peek(i) == Some(c)));
        if let Some(sign) = sign {
            self.at += sign.len();
            return Ok(Token::Sign(sign));
        }
        match (self.peek(0), self.peek(1)) {
            (Some('"'), _) => self.quoted_class(),
            (Some('?'), Some('"')) => {
                self.at += 1;
                self.quoted().map(Token::Variable)
            }
            (Some(c), _) if is_name(c) || matches!(c, '?' | '#' | '*') => Ok(Token::Name(self.name())),
            (other, _) => {
                let found = other.map_or_else(|| "the end".to_owned(), |c| format!("`{c}`"));
                Err(self.expected("a name, a number or one of `( ) , : . ! & |`", found))
            }
        }
    }

    fn expected(&self, expected: &'static str, found: String) -> GoalError {
        GoalError { at: self.at + 1, problem: GoalProblem::Expected { expected, found } }
    }

    fn name(&mut self) -> String {
        let start = self.at;
        self.at += 1;
        while self.peek(0).is_some_and(is_name) || self.number_follows() {
            self.at += 1;
        }
        self.chars[start..self.at].iter().collect()
    }

    /// Whether the dot here joins a class and a number, `cup.12`.
    fn number_follows(&self) -> bool {
        self.peek(0) == Some('.') && self.peek(1).is_some_and(|c| c.is_ascii_digit())
    }

    fn quoted_class(&mut self) -> Result<Token, GoalError> {
        let class = self.quoted()?;
        if !self.number_follows() {
            return Ok(Token::Quoted(class, None));
        }
        self.at += 1;
        let start = self.at;
        while self.peek(0).is_some_and(|c| c.is_ascii_digit()) {
            self.at += 1;
        }
        let digits: String = self.chars[start..self.at].iter().collect();
        match digits.parse() {
            Ok(id) => Ok(Token::Quoted(class, Some(NodeId(id)))),
            Err(_) => Err(self.expected("a node's number", format!("`{}`", crate::spelling::clip(&digits)))),
        }
    }

    /// The text between quotes; `\"` and `\\` stand for `"` and `\`.
    fn quoted(&mut self) -> Result<String, GoalError> {
        self.at += 1;
        let mut text = String::new();
        loop {
            match (self.peek(0), self.peek(1)) {
                (Some('"'), _) => break,
                (Some('\\'), Some(next)) => {
                    text.push(next);
                    self.at += 1;
                }
                (Some(c), _) => text.push(c),
                (None, _) => return Err(self.expected("a closing `\"`", "the end".to_owned())),
            }
            self.at += 1;
        }
        self.at += 1;
        Ok(text)
    }
}
