//! VirtualHome's programs: one action a line.
//!
//! ```text
//! Make coffee
//! A line that is no action before the first one is the title.
//!
//! [WALK] <kitchen> (11)
//! [GRAB] <cup> (12)
//! ```

use super::{FormatError, LARGEST, Problem};
use crate::{Action, ActionError, SceneGraph};

/// A program: what an agent is to do, in order.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Program {
    /// Title and description, as far as there are any.
    pub heading: Vec<String>,
    /// What to do.
    pub actions: Vec<Action>,
}

/// Reads a program in VirtualHome's notation or ours.
///
/// ```
/// use vc_graph::format::program;
/// let program = program::read("Drink\n\n[WALK] <kitchen> (11)\n[GRAB] <cup> (12)\n")?;
/// assert_eq!(program.heading, ["Drink"]);
/// assert_eq!(program.actions.len(), 2);
/// # Ok::<(), vc_graph::format::FormatError>(())
/// ```
///
/// # Errors
/// [`FormatError`] with the line that is no action.
pub fn read(text: &str) -> Result<Program, FormatError> {
    let fail = |line: usize, problem: Problem| FormatError {
        format: "program",
        line: Some(line + 1),
        field: String::new(),
        problem: Box::new(problem),
    };
    if text.len() > LARGEST {
        return Err(fail(0, Problem::TooLarge(text.len())));
    }
    let mut program = Program::default();
    for (index, line) in text.lines().enumerate().filter(|(_, l)| !l.trim().is_empty()) {
        match line.parse() {
            Ok(action) => program.actions.push(action),
            Err(_) if program.actions.is_empty() && !line.trim().starts_with('[') => {
                program.heading.push(line.trim().to_owned());
            }
            Err(error) => return Err(fail(index, Problem::Action(error))),
        }
    }
    Ok(program)
}

/// Writes a program in VirtualHome's notation, with a scene's class names.
///
/// # Errors
/// [`ActionError::NotInVirtualHome`] for a verb it does not have.
pub fn write(program: &Program, graph: &SceneGraph) -> Result<String, ActionError> {
    let mut text: String = program.heading.iter().map(|line| format!("{line}\n")).collect();
    if !text.is_empty() {
        text.push('\n');
    }
    for action in &program.actions {
        text.push_str(&action.to_virtualhome(graph)?);
        text.push('\n');
    }
    Ok(text)
}
