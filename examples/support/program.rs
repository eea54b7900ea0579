//! Plain programs in files.

use vc_graph::format::program::{self, Program};
use vc_graph::{ParsedAction, clip};

use crate::support::Complaint;

/// How programs are written.
const FORM: &str = "a program has an action in each line, as in `[WALK] <kitchen> (11)` or `walk kitchen.11`";

/// The program in a text. One without an action is refused: with all its lines for a title it would be executable.
pub(crate) fn read(text: &str) -> Result<Program, Complaint> {
    let program = program::read(text)?;
    match program.heading.first() {
        _ if !program.steps.is_empty() => Ok(program),
        None => Err(Complaint::new(format!("there is no action in it: {FORM}"))),
        Some(first) => {
            let number = text.lines().position(|line| line.contains(first.as_str())).unwrap_or_default() + 1;
            let why = first.parse::<ParsedAction>().err().map(|why| format!(" ({why})")).unwrap_or_default();
            let line = clip(first);
            Err(Complaint::new(format!("line {number}: `{line}` is no action{why}, and no other line is; {FORM}")))
        }
    }
}

/// The lines before the first action, to be told, so that a misspelt action among them is noticed.
pub(crate) fn titled(program: &Program) -> String {
    match program.heading.first() {
        None => String::new(),
        Some(first) if program.heading.len() == 1 => format!(", after the title `{}`", clip(first)),
        Some(first) => format!(", after {} lines of title from `{}` on", program.heading.len(), clip(first)),
    }
}
