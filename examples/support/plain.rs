//! Plain programs run with bodies, each from the initial scene.

use std::path::{Path, PathBuf};

use vc_graph::format::program::Program;
use vc_graph::{Action, ClassTable, NodeId};
use virtualcity::{ActionError, Assets, Environment};

use crate::program;
use crate::support::{Complaint, say};

/// Whether a file is a plain program, not records with graphs; an unreadable file is reported by the next
/// reader.
pub(crate) fn is_program(file: &Path) -> bool {
    virtualcity::read_text(file).is_ok_and(|text| !text.trim_start().starts_with('{'))
}

/// Why a program stopped.
struct Stop {
    told: String,
    /// Whether the bodies did something else than the rule says.
    disagreement: bool,
}

/// Runs every program in a scene and reports the results. Unreadable programs, programs for more characters than the
/// scene has, and disagreements of bodies and rule are named; returns whether there were none.
pub(crate) fn replay(files: &[PathBuf], scene: &Path) -> bool {
    let (mut executable, mut unread, mut disagreements) = (0, 0, 0);
    for file in files {
        match run(file, scene) {
            Ok(Ok(told)) => {
                executable += 1;
                say!("{}: {told}", file.display());
            }
            Ok(Err(stop)) => {
                disagreements += usize::from(stop.disagreement);
                say!("{}: {}", file.display(), stop.told);
            }
            Err(complaint) => {
                unread += 1;
                say!("{}: {complaint:?}", file.display());
            }
        }
    }
    say!("\n{} programs, {executable} executable with bodies", files.len() - unread);
    if disagreements > 0 {
        say!("{disagreements} stopped because bodies and rule disagree");
    }
    unread + disagreements == 0
}

/// How many actions a program has, or how many were done before one was refused, and the reason, in words.
fn run(file: &Path, scene: &Path) -> Result<Result<String, Stop>, Complaint> {
    // The scene declares words of its own, which the program may use.
    let scene = virtualcity::read_scene(scene, &ClassTable::builtin()).map_err(Complaint::new)?;
    let program = program::read(&virtualcity::read_text(file)?)?;
    let home = Environment::builder_from_scene(scene).assets(Assets::Generated).agents(characters(&program));
    let mut home = home.make().map_err(Complaint::new)?;
    let mut done = 0;
    for together in program.cast(home.graph()).map_err(Complaint::new)? {
        let actions: Vec<(NodeId, Action)> = together.iter().map(|event| (event.agent, event.action)).collect();
        for ((_, action), outcome) in actions.iter().zip(home.set_actions(&actions)) {
            let Err(error) = outcome else {
                done += 1;
                continue;
            };
            let disagreement = matches!(error, ActionError::Disagreement(_));
            let ended = if disagreement { "stopped" } else { "refused" };
            let action = action.describe(home.graph());
            return Ok(Err(Stop { told: format!("{ended} after {done} actions: {action}: {error}"), disagreement }));
        }
    }
    Ok(Ok(format!("executable, {done} actions{}", program::titled(&program))))
}

/// The number of characters that a program needs.
pub(crate) fn characters(program: &Program) -> usize {
    const MOST: u32 = 64;
    let last = program.steps.iter().flatten().map(|parsed| parsed.character.min(MOST)).max().unwrap_or(0);
    last as usize + 1
}
