//! File formats for scenes, programs and goals.
//!
//! | module | content |
//! |---|---|
//! | [`native`] | VirtualCity's own scene JSON, versioned and complete |
//! | [`thesis`] | the thesis's scene JSON, in Unreal's units |
//! | [`virtualhome`] | VirtualHome's environment graphs |
//! | [`program`] | VirtualHome's programs, `[WALK] <kitchen> (11)` |
//! | [`eai`] | programs with graphs and goals of the Embodied Agent Interface |
//! | [`objects`] | a plain list of objects, for JSON |
//!
//! No reader panics, recurses or allocates without bound: texts are limited to [`LARGEST`] bytes, nesting to
//! 128 levels (by serde_json), and the size of the result is proportional to the text. Errors give the line,
//! the field and the expected form.

pub mod eai;
pub mod native;
pub mod objects;
pub mod program;
mod scene;
pub mod thesis;
pub mod virtualhome;

use std::fmt;

use serde::de::DeserializeOwned;

use crate::EditError;

pub use scene::read_scene;

pub use crate::spelling::unmarked;

/// Largest text that a reader accepts, bytes.
pub const LARGEST: usize = 256 << 20;

/// An error in a file, with its location.
///
/// ```
/// use vc_graph::ClassTable;
/// use vc_graph::format::virtualhome;
/// let text = r#"{"nodes": [{"id": 1, "class_name": "cup", "states": ["FLYING"]}], "edges": []}"#;
/// let error = virtualhome::read(text, &ClassTable::builtin()).unwrap_err();
/// assert_eq!((error.line, error.field.as_str()), (Some(1), "nodes[0].states[0]"));
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FormatError {
    /// The format that was read.
    pub format: &'static str,
    /// Line, counted from one, if known.
    pub line: Option<usize>,
    /// The field, as a path: `nodes[3].states[0]`.
    pub field: String,
    /// The error and the expected form.
    pub problem: Box<FormatProblem>,
}

/// An error in a file.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum FormatProblem {
    /// Not JSON, or not of the structure of this format.
    #[error("{0}")]
    Shape(String),
    /// Too large.
    #[error("the text has {0} bytes, at most {LARGEST} are read")]
    TooLarge(usize),
    /// A node cannot be made.
    #[error(transparent)]
    Edit(#[from] EditError),
    /// An unknown word.
    #[error(transparent)]
    Word(#[from] crate::UnknownWord),
    /// An invalid number.
    #[error("{0} is not a finite number of a sensible size")]
    Number(String),
    /// A version that this program does not support.
    #[error("version {0} is newer than this program, which reads up to {1}")]
    Version(u32, u32),
    /// A name that no object has.
    #[error("no object is called `{0}`")]
    NoSuchName(String),
    /// A name that several objects share.
    #[error("{1} objects are called `{0}`; write its number as well, as in `{0}.7`")]
    Ambiguous(String, usize),
    /// An invalid asset.
    #[error(transparent)]
    Asset(#[from] crate::asset::AssetError),
    /// An invalid action.
    #[error(transparent)]
    Action(#[from] crate::ActionTextError),
    /// One character performs two actions in one step.
    #[error("`<char{0}>` does two things at once; write them in two lines, or name another character for one of them")]
    ActsTwice(u32),
    /// An invalid declaration of an own word.
    #[error(transparent)]
    Vocabulary(#[from] Box<crate::VocabularyError>),
    /// A node has an own word that the file and the classes do not declare.
    #[error("`{0}` is not declared: add its line to `words`")]
    Undeclared(&'static str),
    /// An invalid goal.
    #[error(transparent)]
    Goal(#[from] crate::goal::GoalError),
}

impl fmt::Display for FormatError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.format)?;
        if let Some(line) = self.line {
            write!(f, ", line {line}")?;
        }
        if !self.field.is_empty() && self.field != "." {
            write!(f, ", field `{}`", self.field)?;
        }
        write!(f, ": {}", self.problem)
    }
}

impl std::error::Error for FormatError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        Some(&*self.problem)
    }
}

/// A text that is being parsed, for error messages.
#[derive(Clone, Copy)]
pub(crate) struct Source<'t> {
    pub(crate) format: &'static str,
    pub(crate) text: &'t str,
}

impl<'t> Source<'t> {
    pub(crate) fn new(format: &'static str, text: &'t str) -> Self {
        Self { format, text: unmarked(text) }
    }

    /// Parses JSON into a type.
    pub(crate) fn json<T: DeserializeOwned>(&self) -> Result<T, FormatError> {
        if self.text.len() > LARGEST {
            return Err(self.error(String::new(), FormatProblem::TooLarge(self.text.len())));
        }
        // Tracking the path costs time, so it is only determined after an error.
        serde_json::from_str(self.text).map_err(|plain| self.shape_error::<T>(&plain))
    }

    fn shape_error<T: DeserializeOwned>(&self, plain: &serde_json::Error) -> FormatError {
        let mut json = serde_json::Deserializer::from_str(self.text);
        let field = match serde_path_to_error::deserialize::<_, T>(&mut json) {
            Err(error) => error.path().to_string(),
            Ok(_) => String::new(),
        };
        let message = plain.to_string();
        let message = message.split(" at line ").next().unwrap_or(&message).to_owned();
        FormatError {
            format: self.format,
            line: Some(plain.line()),
            field,
            problem: Box::new(FormatProblem::Shape(message)),
        }
    }

    /// An error at a field; for elements of lists, `nodes[3]`, the line is looked up in the text.
    pub(crate) fn error(&self, field: String, problem: impl Into<FormatProblem>) -> FormatError {
        let line = element_line(self.text, &field);
        FormatError { format: self.format, line, field, problem: Box::new(problem.into()) }
    }
}

/// The line on which an element of a top-level list begins: `edges[12].to_id`.
fn element_line(text: &str, field: &str) -> Option<usize> {
    let (key, rest) = field.split_once('[')?;
    let index: usize = rest.split_once(']')?.0.parse().ok()?;
    let list = text.find(&format!("\"{key}\""))?;
    let open = list + text[list..].find('[')?;
    let (mut depth, mut commas, mut quoted, mut escaped) = (0_usize, 0, false, false);
    let mut line = 1 + text[..open].matches('\n').count();
    for byte in text[open..].bytes() {
        line += usize::from(byte == b'\n');
        match byte {
            _ if escaped => escaped = false,
            b'\\' if quoted => escaped = true,
            b'"' => quoted = !quoted,
            _ if quoted => {}
            b'[' | b'{' => {
                depth += 1;
                if depth == 2 && commas == index {
                    return Some(line);
                }
            }
            b']' | b'}' => depth = depth.checked_sub(1)?,
            b',' if depth == 1 => commas += 1,
            _ => {}
        }
    }
    None
}
