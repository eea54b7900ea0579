//! Plans.

use vc_graph::format::unmarked;
use vc_graph::{Action, NodeId, Verb, Word, clip};

use super::FORMAT;
use crate::format::ReadError;

/// Reads a plan as Fast Downward, pyperplan and VAL write it, one step a line, `(grab cup_12 ...)`:
/// the verb, the objects it acts on, and further arguments of the domain. A time `0:` before a step
/// and text after `;` are ignored; the plan ends at the step which states that the goal is met.
///
/// ```
/// use vc_tasks::format::pddl::read_plan;
/// let plan = read_plan("0: (walk apple_3 here)\n; cost = 1 (unit cost)\n")?;
/// assert_eq!(plan[0].to_string(), "walk #3");
/// # Ok::<(), vc_tasks::format::ReadError>(())
/// ```
///
/// # Errors
/// [`ReadError`] for lines that are not a step in a domain of [`planning`](super::planning).
pub fn read_plan(text: &str) -> Result<Vec<Action>, ReadError> {
    let mut actions = Vec::new();
    for (index, line) in unmarked(text).lines().enumerate() {
        let line = line.split(';').next().unwrap_or_default();
        let start = line.find('(').unwrap_or_else(|| line.len() - line.trim_start().len());
        let step = line[start..].trim();
        if step.is_empty() {
            continue;
        }
        let step = step.strip_prefix('(').and_then(|s| s.split(')').next()).unwrap_or(step);
        if step.starts_with("met") {
            break;
        }
        let action = read_step(&step.to_ascii_lowercase());
        actions.push(action.map_err(|expected| ReadError {
            format: FORMAT,
            file: None,
            line: index + 1,
            column: 1 + line[..start].chars().count(),
            expected,
            found: format!("`{}`", clip(step)),
        })?);
    }
    Ok(actions)
}

fn read_step(step: &str) -> Result<Action, String> {
    let mut words = step.split_whitespace();
    let name = words.next().unwrap_or_default();
    // The variants of an action are numbered: `cook-2`.
    let name = name.split('-').next().unwrap_or_default();
    let verb = Verb::parse(name).map_err(|_| "a step such as `(grab cup_12 ...)`".to_owned())?;
    let things = words.take(verb.arity()).map(node).collect::<Option<Vec<NodeId>>>();
    let things = things.ok_or_else(|| "things such as `cup_12`".to_owned())?;
    Action::with(verb, &things).map_err(|error| error.to_string())
}

fn node(name: &str) -> Option<NodeId> {
    name.rsplit_once('_')?.1.parse().ok().map(NodeId)
}
