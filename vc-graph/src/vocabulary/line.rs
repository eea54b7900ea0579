//! Lines of a vocabulary, split into their fields.

use super::{VocabularyError, VocabularyProblem as Problem};
use crate::spelling::{clip, composed, unmarked};

/// A declaration as it is written.
pub(super) struct Line {
    pub(super) number: usize,
    pub(super) kind: &'static str,
    pub(super) name: String,
    /// The words after the name.
    pub(super) rest: String,
    fields: Vec<(&'static str, String)>,
}

/// The kinds of declarations with the names of their fields.
const KINDS: [(&str, &[&str]); 4] = [
    ("state", &["excludes", "needs"]),
    ("property", &[]),
    ("verb", &["needs", "effects", "aims", "motion", "says"]),
    ("predicate", &["is"]),
];

/// The lines of a text; empty ones and those that begin with `#` are left out.
pub(super) fn lines(file: &str, text: &str) -> Result<Vec<Line>, VocabularyError> {
    let numbered = unmarked(text).lines().enumerate().map(|(index, line)| (index + 1, composed(line)));
    let written = numbered.filter(|(_, line)| !line.trim().is_empty() && !line.trim().starts_with('#'));
    written.map(|(number, line)| Line::read(number, &line).map_err(|problem| error(file, number, problem))).collect()
}

pub(super) fn error(file: &str, line: usize, problem: impl Into<Problem>) -> VocabularyError {
    VocabularyError { file: file.to_owned(), line, problem: problem.into() }
}

impl Line {
    fn read(number: usize, text: &str) -> Result<Self, Problem> {
        let (head, fields) = text.split_once('|').map_or((text, None), |(head, fields)| (head, Some(fields)));
        let head = head.trim();
        let (kind, rest) = head.split_once(char::is_whitespace).unwrap_or((head, ""));
        let (kind, known) = KINDS.into_iter().find(|(k, _)| *k == kind).ok_or_else(|| Problem::Kind(clip(head)))?;
        let (name, rest) = rest.trim().split_once(char::is_whitespace).unwrap_or((rest.trim(), ""));
        if !matches!(kind, "verb" | "predicate") && !rest.is_empty() {
            return Err(Problem::Kind(clip(head)));
        }
        let mut line = Self { number, kind, name: name.into(), rest: rest.trim().into(), fields: Vec::new() };
        // A goal may have a `|`, so it is the only field.
        let limit = if kind == "predicate" { 1 } else { usize::MAX };
        let mut cells = fields.into_iter().flat_map(|fields| fields.splitn(limit, '|'));
        cells.try_for_each(|cell| line.add(cell.trim(), known))?;
        Ok(line)
    }

    fn add(&mut self, cell: &str, known: &'static [&'static str]) -> Result<(), Problem> {
        let (name, text) = cell.split_once(':').unwrap_or((cell, ""));
        let name = name.trim();
        let bad = || Problem::Field { kind: self.kind, field: clip(name), known: listed(known) };
        let field = *known.iter().find(|field| **field == name).ok_or_else(bad)?;
        if self.fields.iter().any(|(other, _)| *other == field) {
            return Err(Problem::Twice(field));
        }
        self.fields.push((field, text.trim().to_owned()));
        Ok(())
    }

    /// The text of a field; empty if it is left out.
    pub(super) fn field(&self, name: &str) -> &str {
        self.fields.iter().find(|(field, _)| *field == name).map_or("", |(_, text)| text)
    }

    /// The entries of a field that are separated by `;`, each read.
    pub(super) fn entries<T>(&self, field: &str, read: impl Fn(&str) -> Result<T, Problem>) -> Result<Vec<T>, Problem> {
        self.field(field).split(';').map(str::trim).filter(|entry| !entry.is_empty()).map(read).collect()
    }
}

fn listed(known: &[&str]) -> String {
    if known.is_empty() { "none".to_owned() } else { format!("`{}`", known.join("`, `")) }
}
