//! Executes VirtualHome programs and compares what comes out with what should.
//!
//! `cargo run --release --example replay -- FILE...` takes JSON Lines of programs
//! with the graphs before and after (the Embodied Agent Interface's), or, with
//! `--scene`, plain programs to be run in that scene.

#[cfg(feature = "environment")]
#[path = "support/bodies.rs"]
mod bodies;
mod support;

use std::path::PathBuf;
use std::sync::Arc;

use clap::Parser;
use indicatif::{ProgressBar, ProgressStyle};
use support::{Complaint, say};
use vc_graph::format::virtualhome::{Difference, EnvironmentGraph, RelationType};
use vc_graph::format::{eai, program, read_scene};
use vc_graph::{Action, ClassTable, NodeId, SceneGraph, Simulator};

/// Executes VirtualHome programs and compares what comes out with what should.
#[derive(Parser)]
struct Options {
    /// Programs: .jsonl with graphs before and after, or .txt with --scene; .gz is unpacked.
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// The scene in which .txt programs run.
    #[arg(long)]
    scene: Option<PathBuf>,
    /// Run the programs of .jsonl with bodies in --scene, each that fits it: every number it names has
    /// the same class there.
    #[cfg(feature = "environment")]
    #[arg(long)]
    bodies: bool,
    /// Also show differences in CLOSE and FACING.
    #[arg(long)]
    all: bool,
}

#[derive(Default)]
struct Tally {
    programs: usize,
    executable: usize,
    /// Programs whose expected result is known, and those that came out so.
    compared: usize,
    same: usize,
}

fn main() -> Result<(), Complaint> {
    let options = Options::parse();
    let classes = ClassTable::builtin();
    let mut tally = Tally::default();
    #[cfg(feature = "environment")]
    if options.bodies {
        let scene = options.scene.as_deref().ok_or_else(|| Complaint::new("--bodies needs --scene FILE"))?;
        return bodies::replay(&options.files, scene);
    }
    for file in &options.files {
        let text = support::read(file)?;
        let located = |e: &dyn std::fmt::Display| Complaint::new(format!("{}: {e}", file.display()));
        if text.trim_start().starts_with('{') {
            replay_records(&text, &options, &classes, &mut tally).map_err(|e| located(&format!("{e:?}")))?;
        } else {
            let program = program::read(&text).map_err(|e| located(&e))?;
            let scene = options.scene.as_deref().ok_or_else(|| located(&"a plain program needs --scene FILE"))?;
            let scene = read_scene(&support::read(scene)?, &classes).map_err(Complaint::new)?;
            tally.programs += 1;
            let run = execute(scene, &program.actions)?;
            tally.executable += usize::from(run.refused.is_none());
            say!("{}: {}", file.display(), run.verdict());
        }
    }
    say!("\n{} programs, {} executable", tally.programs, tally.executable);
    if tally.compared > 0 {
        say!("{} of {} compared have the expected result", tally.same, tally.compared);
    }
    Ok(())
}

fn replay_records(
    text: &str,
    options: &Options,
    classes: &Arc<ClassTable>,
    tally: &mut Tally,
) -> Result<(), Complaint> {
    let lines: Vec<&str> = text.lines().filter(|l| !l.trim().is_empty()).collect();
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} programs").map_err(Complaint::new)?;
    let bar = ProgressBar::new(lines.len() as u64).with_style(style);
    for (number, line) in lines.iter().enumerate() {
        let located = |e: &dyn std::fmt::Display| Complaint::new(format!("line {}: {e}", number + 1));
        let record = eai::read_record(line).map_err(|e| located(&e))?;
        let build = |graph: &EnvironmentGraph| {
            graph.build(&record.id, classes).map_err(|(field, problem)| located(&format!("{field}: {problem}")))
        };
        let run = execute(build(&record.initial)?, &record.actions)?;
        let difference = EnvironmentGraph::of(&run.scene).difference(&EnvironmentGraph::of(&build(&record.last)?));
        let shown = describe(&difference, &run.scene, options.all);
        tally.programs += 1;
        tally.executable += usize::from(run.refused.is_none());
        tally.compared += 1;
        tally.same += usize::from(run.refused.is_none() && shown.is_empty());
        bar.suspend(|| {
            say!("{} {}: {}", record.id, record.title, run.verdict());
            if run.refused.is_none() {
                shown.iter().for_each(|line| say!("    {line}"));
            }
        });
        bar.inc(1);
    }
    bar.finish_and_clear();
    Ok(())
}

/// How a program went.
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

fn execute(scene: SceneGraph, actions: &[Action]) -> Result<Run, Complaint> {
    let no_agent = || Complaint::new("the scene has no character");
    let me = *scene.agents().first().ok_or_else(no_agent)?;
    let mut world = Simulator::new(scene);
    let mut refused = None;
    let mut done = 0;
    for action in actions {
        if let Err(refusals) = world.step(me, action) {
            let reasons: Vec<String> = refusals.iter().map(ToString::to_string).collect();
            refused = Some(format!("{}: {}", action.describe(world.graph()), reasons.join("; ")));
            break;
        }
        done += 1;
    }
    Ok(Run { scene: world.into_graph(), done, refused })
}

fn describe(difference: &Difference, scene: &SceneGraph, all: bool) -> Vec<String> {
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
