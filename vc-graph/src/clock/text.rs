//! Lines and columns of the clock's tables.

use super::error::{ClockError, ClockProblem};
use super::tick::Span;
use crate::class::ClassTable;
use crate::spelling::{composed, unmarked};

/// A line of a table, split into its columns.
pub(super) struct Line<'t, const N: usize> {
    pub(super) classes: &'t ClassTable,
    file: &'t str,
    number: usize,
    names: &'static [&'static str; N],
    cells: [String; N],
}

impl<const N: usize> Line<'_, N> {
    /// Reads the text of a column.
    pub(super) fn read<T>(
        &self,
        column: usize,
        read: impl FnOnce(&str) -> Result<T, ClockProblem>,
    ) -> Result<T, ClockError> {
        read(&self.cells[column]).map_err(|problem| self.error(column, problem))
    }

    pub(super) fn is_empty(&self, column: usize) -> bool {
        self.cells[column].is_empty()
    }

    pub(super) fn error(&self, column: usize, problem: ClockProblem) -> ClockError {
        ClockError { file: self.file.to_owned(), line: self.number, column: self.names[column], problem }
    }
}

/// Reads each line of a text; empty lines and those that begin with `#` are left out.
pub(super) fn lines<T, const N: usize>(
    (file, text): (&str, &str),
    names: &'static [&'static str; N],
    classes: &ClassTable,
    read: impl Fn(&Line<'_, N>) -> Result<T, ClockError>,
) -> Result<Vec<T>, ClockError> {
    let numbered = unmarked(text).lines().enumerate().map(|(index, line)| (index + 1, line.trim()));
    let written = numbered.filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
    let read = written.map(|(number, text)| {
        let cells: Vec<String> = composed(text).split('|').map(|cell| cell.trim().to_owned()).collect();
        let cells = cells.try_into().map_err(|cells: Vec<String>| {
            let problem = ClockProblem::Columns { needed: N, found: cells.len() };
            ClockError { file: file.to_owned(), line: number, column: names[0], problem }
        })?;
        read(&Line { classes, file, number, names, cells })
    });
    read.collect()
}

/// A name of letters, digits, `_` and `-`.
pub(super) fn name(text: &str) -> Result<std::sync::Arc<str>, ClockProblem> {
    let fine = text.chars().any(char::is_alphanumeric) && text.chars().all(crate::id::is_class_char);
    if fine { Ok(text.into()) } else { Err(ClockProblem::Name) }
}

/// A span of at least one tick.
pub(super) fn span(text: &str) -> Result<Span, ClockProblem> {
    let span: Span = text.parse()?;
    if span > Span(0) { Ok(span) } else { Err(ClockProblem::NoTime) }
}
