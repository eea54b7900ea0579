//! Files: scenes, programs and goals as others and we write them.
//!
//! | module | what |
//! |---|---|
//! | [`native`] | our own scene JSON, versioned, complete |
//! | [`thesis`] | the thesis's scene JSON, in Unreal's units |
//! | [`virtualhome`] | VirtualHome's environment graphs |
//! | [`program`] | VirtualHome's programs, `[WALK] <kitchen> (11)` |
//! | [`eai`] | programs with graphs and goals of the Embodied Agent Interface |
//! | [`objects`] | a plain list of objects, for JSON |
//!
//! No reader panics, recurses or allocates without bound: texts are limited to
//! [`LARGEST`] bytes, nesting to 128 levels (by serde_json), and what is built is
//! proportional to the text. Errors say line, field and what was expected.

pub mod eai;
pub mod native;
pub mod objects;
pub mod program;
mod scene;
pub(crate) mod serial;
pub mod thesis;
pub mod virtualhome;

use std::fmt;

use serde::de::DeserializeOwned;

use crate::EditError;

pub use scene::read_scene;

/// Largest text a reader takes, bytes.
pub const LARGEST: usize = 256 << 20;

/// A text without the byte order mark that some editors write in front. Every reader here leaves it out.
///
/// ```
/// assert_eq!(vc_graph::format::unmarked("\u{feff}[WALK] <kitchen> (11)"), "[WALK] <kitchen> (11)");
/// ```
pub fn unmarked(text: &str) -> &str {
    text.trim_start_matches('\u{feff}')
}

/// Where a file is wrong.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FormatError {
    /// Which format was read.
    pub format: &'static str,
    /// Line, counted from one, where known.
    pub line: Option<usize>,
    /// The field, as a path: `nodes[3].states[0]`.
    pub field: String,
    /// What is wrong there, and what was expected.
    pub problem: Box<Problem>,
}

/// What is wrong with a file.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Problem {
    /// Not JSON, or not of this format's shape.
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
    /// A number that cannot be.
    #[error("{0} is not a finite number of a sensible size")]
    Number(String),
    /// A version this program does not know.
    #[error("version {0} is newer than this program, which reads up to {1}")]
    Version(u32, u32),
    /// A name that means nothing here.
    #[error("no object is called `{0}`")]
    NoSuchName(String),
    /// A name that too many objects share.
    #[error("{1} objects are called `{0}`; write its number as well, as in `{0}.7`")]
    Ambiguous(String, usize),
    /// An asset that is not sound.
    #[error(transparent)]
    Asset(#[from] crate::asset::AssetError),
    /// An action that is not one.
    #[error(transparent)]
    Action(#[from] crate::ActionError),
    /// One character does two things in one step.
    #[error("`<char{0}>` does two things at once; write them in two lines, or who else does one of them")]
    ActsTwice(u32),
    /// A goal that is not one.
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

impl std::error::Error for FormatError {}

/// A text being read: makes errors of it.
#[derive(Clone, Copy)]
pub(crate) struct Source<'t> {
    pub(crate) format: &'static str,
    pub(crate) text: &'t str,
}

impl<'t> Source<'t> {
    pub(crate) fn new(format: &'static str, text: &'t str) -> Self {
        Self { format, text: unmarked(text) }
    }

    /// Reads JSON into a type.
    pub(crate) fn json<T: DeserializeOwned>(&self) -> Result<T, FormatError> {
        if self.text.len() > LARGEST {
            return Err(self.error(String::new(), Problem::TooLarge(self.text.len())));
        }
        // The path costs time, so it is only looked for when there is an error.
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
        FormatError { format: self.format, line: Some(plain.line()), field, problem: Box::new(Problem::Shape(message)) }
    }

    /// An error at a field; elements of lists, `nodes[3]`, are found in the text.
    pub(crate) fn error(&self, field: String, problem: impl Into<Problem>) -> FormatError {
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
