//! Errors of reading and writing.

use std::fmt;
use std::path::Path;

use vc_graph::clip;
use vc_graph::format::unmarked;

/// An error in a text: its place, what was expected there and what was found.
///
/// ```
/// use vc_tasks::format::bddl::ActivityDefinition;
/// let error = ActivityDefinition::read("(define\n  (problem p)\n  (:goal (not))").unwrap_err();
/// assert_eq!(
///     error.in_file("p.bddl").to_string(),
///     "p.bddl, line 1, column 1: BDDL: expected a `)` for this `(`, found the end",
/// );
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ReadError {
    /// The format of the text.
    pub format: &'static str,
    /// The file, if the caller has named it.
    pub file: Option<String>,
    /// Line, counted from one.
    pub line: usize,
    /// Column in characters, counted from one.
    pub column: usize,
    /// The text expected there.
    pub expected: String,
    /// The text found there.
    pub found: String,
}

impl ReadError {
    /// An error at a byte of a text.
    pub(crate) fn at(
        format: &'static str,
        text: &str,
        byte: usize,
        expected: impl Into<String>,
        found: impl Into<String>,
    ) -> Self {
        let (line, column) = line_and_column(text, byte);
        Self { format, file: None, line, column, expected: expected.into(), found: found.into() }
    }

    /// Adds the file's name to the error.
    #[must_use]
    pub fn in_file(mut self, file: impl AsRef<Path>) -> Self {
        self.file = Some(file.as_ref().display().to_string());
        self
    }
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(file) = &self.file {
            write!(f, "{file}, ")?;
        }
        let Self { format, line, column, expected, found, .. } = self;
        write!(f, "line {line}, column {column}: {format}: expected {expected}, found {found}")
    }
}

impl std::error::Error for ReadError {}

/// The line and the column, in characters, of a byte, both counted from one.
pub(crate) fn line_and_column(text: &str, byte: usize) -> (usize, usize) {
    let before = text.get(..byte).unwrap_or(text);
    let line = 1 + before.matches('\n').count();
    let start = before.rfind('\n').map_or(0, |i| i + 1);
    (line, 1 + before[start..].chars().count())
}

/// An error for a goal that a format cannot express.
///
/// ```
/// use vc_tasks::format::watch_and_help;
/// let error = watch_and_help::write(&"Dirty(plate)".parse()?).unwrap_err();
/// assert!(error.to_string().contains("cannot express `Dirty(plate)`"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{format} cannot express `{part}`: {why}")]
pub struct Unwritable {
    /// The format.
    pub format: &'static str,
    /// The part of the goal, in our own notation.
    pub part: String,
    /// The reason.
    pub why: String,
}

impl Unwritable {
    pub(crate) fn new(format: &'static str, part: impl fmt::Display, why: impl Into<String>) -> Self {
        Self { format, part: clip(&part.to_string()), why: why.into() }
    }
}

/// A JSON object with its entries in the order of the text.
pub(crate) struct Entries(pub(crate) Vec<(String, serde_json::Value)>);

impl<'de> serde::Deserialize<'de> for Entries {
    fn deserialize<D: serde::Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        struct Reader;
        impl<'de> serde::de::Visitor<'de> for Reader {
            type Value = Entries;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a JSON object")
            }

            fn visit_map<A: serde::de::MapAccess<'de>>(self, mut map: A) -> Result<Entries, A::Error> {
                let mut entries = Vec::new();
                while let Some(entry) = map.next_entry()? {
                    entries.push(entry);
                }
                Ok(Entries(entries))
            }
        }
        d.deserialize_map(Reader)
    }
}

/// Reads JSON into a type.
pub(crate) fn from_json<T: serde::de::DeserializeOwned>(format: &'static str, text: &str) -> Result<T, ReadError> {
    serde_json::from_str(unmarked(text)).map_err(|error| {
        let message = error.to_string();
        let message = message.split(" at line ").next().unwrap_or(&message);
        let (found, expected) = message.split_once(", expected ").unwrap_or((message, "JSON of this format"));
        let (line, column) = (error.line().max(1), error.column().max(1));
        ReadError { format, file: None, line, column, expected: expected.to_owned(), found: found.to_owned() }
    })
}
