//! Executes VirtualHome programs and compares the results with the expected ones.
//!
//! `cargo run --release --example replay -- FILE...` takes JSON Lines of programs with the graphs before and
//! after (the Embodied Agent Interface's), or, with `--scene`, plain programs to be run in that scene, by one
//! character or by several. Unreadable files and lines are named and skipped, and the exit status is then 1; so it is
//! when with `--bodies` the bodies contradict the rule.
//! With `--semantics virtualhome` programs are run by VirtualHome's own transition rule, including its faults,
//! and every edge is compared.

#[cfg(feature = "environment")]
#[path = "support/bodies.rs"]
mod bodies;
#[cfg(feature = "environment")]
#[path = "support/plain.rs"]
mod plain;
#[path = "support/program.rs"]
mod program;
mod support;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;
use indicatif::{ProgressBar, ProgressStyle};
use support::{Complaint, say};
use vc_graph::format::program::Program;
use vc_graph::format::virtualhome::{EnvironmentGraph, GraphDifference, RelationType};
use vc_graph::format::{eai, read_scene};
use vc_graph::{ClassTable, Event, NodeId, Refusal, SceneGraph, Semantics, Simulator};

/// Executes VirtualHome programs and compares the results with the expected ones.
#[derive(Parser)]
struct Options {
    /// Programs: .jsonl with graphs before and after, or .txt with --scene; may be compressed.
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// The scene in which .txt programs run: any scene file, or one with graphs before and after.
    #[arg(long)]
    scene: Option<PathBuf>,
    /// Run the programs with bodies in --scene. Those in .jsonl must fit it: every node number in a program
    /// must have the same class there.
    #[cfg(feature = "environment")]
    #[arg(long)]
    bodies: bool,
    /// Also show differences in CLOSE and FACING.
    #[arg(long)]
    all: bool,
    /// The transition rule by which programs run: virtualcity or virtualhome.
    #[arg(long, default_value = "virtualcity")]
    semantics: Semantics,
}

impl Options {
    /// With VirtualHome's own rule all edges should be equal.
    fn compares_all(&self) -> bool {
        self.all || self.semantics == Semantics::VirtualHome
    }
}

#[derive(Default)]
struct Tally {
    programs: usize,
    executable: usize,
    /// Programs with a known expected result, and those that had this result.
    compared: usize,
    same: usize,
    /// Unreadable files and lines.
    unread: usize,
}

fn main() -> Result<ExitCode, Complaint> {
    let options = Options::parse();
    #[cfg(feature = "environment")]
    if options.bodies {
        if options.semantics != Semantics::VirtualCity {
            return Err(Complaint::new("bodies go by our own rule: leave out --semantics, or --bodies"));
        }
        let scene = options.scene.as_deref().ok_or_else(|| Complaint::new("--bodies needs --scene FILE"))?;
        let (plain, records): (Vec<PathBuf>, Vec<PathBuf>) =
            options.files.iter().cloned().partition(|file| plain::is_program(file));
        let mut all_well = plain.is_empty() || plain::replay(&plain, scene);
        if !records.is_empty() {
            all_well &= bodies::replay(&records, scene)?;
        }
        return Ok(if all_well { ExitCode::SUCCESS } else { ExitCode::FAILURE });
    }
    let classes = ClassTable::builtin();
    let scene = options.scene.as_ref().map(|path| virtualcity::read_scene(path, &classes)).transpose()?;
    let mut tally = Tally::default();
    for file in &options.files {
        if let Err(complaint) = replay(file, scene.as_ref(), &options, &mut tally) {
            say!("{complaint:?}");
            tally.unread += 1;
        }
    }
    say!("\n{} programs, {} executable", tally.programs, tally.executable);
    if tally.compared > 0 {
        say!("{} of {} compared have the expected result", tally.same, tally.compared);
    }
    Ok(if tally.unread == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Runs a file of records, or one plain program in a scene.
fn replay(file: &Path, scene: Option<&SceneGraph>, options: &Options, tally: &mut Tally) -> Result<(), Complaint> {
    let text = virtualcity::read_text(file)?;
    let located = |e: &dyn std::fmt::Display| Complaint::new(format!("{}: {e}", file.display()));
    if text.trim_start().starts_with('{') {
        if is_scene(&text) {
            return Err(located(&"this is a scene and no file of programs: name it with --scene"));
        }
        return replay_records(file, &text, options, tally);
    }
    let program = program::read(&text).map_err(|why| located(&format!("{why:?}")))?;
    let titled = program::titled(&program);
    let scene = scene.ok_or_else(|| located(&"a plain program needs --scene FILE"))?;
    let run = execute(scene.clone(), &program, options.semantics);
    tally.programs += 1;
    tally.executable += usize::from(run.refused.is_none());
    say!("{}{titled}: {}", file.display(), run.verdict());
    Ok(())
}

/// Whether a text is a scene instead of records of programs.
fn is_scene(text: &str) -> bool {
    let first = text.lines().find(|line| !line.trim().is_empty());
    first.is_some_and(|line| eai::read_record(line).is_err()) && read_scene(text, &ClassTable::builtin()).is_ok()
}

fn replay_records(file: &Path, text: &str, options: &Options, tally: &mut Tally) -> Result<(), Complaint> {
    let lines: Vec<(usize, &str)> = text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty()).collect();
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} programs").map_err(Complaint::new)?;
    let bar = ProgressBar::new(lines.len() as u64).with_style(style);
    for (number, line) in &lines {
        let replayed = replay_record(line, options, tally);
        let shown = replayed.unwrap_or_else(|problem| {
            tally.unread += 1;
            vec![format!("{}, line {}: {problem}", file.display(), number + 1)]
        });
        bar.suspend(|| shown.iter().for_each(|line| say!("{line}")));
        bar.inc(1);
    }
    bar.finish_and_clear();
    Ok(())
}

/// The lines to be printed about a record, or the reason why it cannot be read.
fn replay_record(line: &str, options: &Options, tally: &mut Tally) -> Result<Vec<String>, String> {
    let record = eai::read_record(line).map_err(|e| e.to_string())?;
    let build = |graph: &EnvironmentGraph| {
        let built = graph.build(&record.id, &ClassTable::builtin());
        built.map_err(|(field, problem)| format!("{field}: {problem}"))
    };
    let run = execute(build(&record.initial)?, &record.program, options.semantics);
    let difference =
        EnvironmentGraph::from_scene(&run.scene).difference(&EnvironmentGraph::from_scene(&build(&record.last)?));
    let differing = describe(&difference, &run.scene, options.compares_all());
    let executable = run.refused.is_none();
    tally.programs += 1;
    tally.executable += usize::from(executable);
    tally.compared += 1;
    tally.same += usize::from(executable && differing.is_empty());
    let verdict = format!("{} {}: {}", record.id, record.title, run.verdict());
    let differing = differing.into_iter().filter(|_| executable).map(|line| format!("    {line}"));
    Ok(std::iter::once(verdict).chain(differing).collect())
}

/// The result of a program.
struct Run {
    scene: SceneGraph,
    done: usize,
    refused: Option<String>,
}

impl Run {
    fn verdict(&self) -> String {
        match &self.refused {
            None => format!("executable, {} actions", self.done),
            Some(why) => format!("refused after {} actions: {why}", self.done),
        }
    }
}

fn execute(scene: SceneGraph, program: &Program, semantics: Semantics) -> Run {
    let mut world = Simulator::with(scene, semantics);
    let (mut done, mut refused) = (0, None);
    match program.cast(world.graph()) {
        _ if world.graph().agents().is_empty() => refused = Some("the scene has no character".into()),
        Err(error) => refused = Some(error.to_string()),
        Ok(steps) => {
            for step in steps {
                if let Err((event, refusals)) = world.step_together(&step) {
                    refused = Some(told(world.graph(), &event, &refusals));
                    break;
                }
                done += step.len();
            }
        }
    }
    Run { scene: world.into_graph(), done, refused }
}

/// A refused action and the reasons, with its agent if there are several.
fn told(graph: &SceneGraph, event: &Event, refusals: &[Refusal]) -> String {
    let reasons: Vec<String> = refusals.iter().map(ToString::to_string).collect();
    let who = if graph.agents().len() > 1 { format!("{} ", graph.label(event.agent)) } else { String::new() };
    format!("{who}{}: {}", event.action.describe(graph), reasons.join("; "))
}

fn describe(difference: &GraphDifference, scene: &SceneGraph, all: bool) -> Vec<String> {
    let label = |id: u32| scene.label(NodeId(id)).to_string();
    let loose = |r: RelationType| matches!(r, RelationType::Close | RelationType::Facing);
    let states = difference
        .states
        .iter()
        .map(|(id, ours, theirs)| format!("{} is {}, expected {}", label(*id), ours.join(" "), theirs.join(" ")));
    let edges = [(&difference.added, "not expected"), (&difference.missing, "missing")];
    let edges = edges.into_iter().flat_map(|(edges, what)| edges.iter().map(move |e| (e, what)));
    let edges = edges.filter(|(e, _)| all || !loose(e.relation_type));
    let edges = edges.map(|(e, what)| format!("{what}: {} {:?} {}", label(e.from_id), e.relation_type, label(e.to_id)));
    states.chain(edges).collect()
}
