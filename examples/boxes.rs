//! Tests how much agents can do in homes of which only bounding boxes are known.
//!
//! `cargo run --release --example boxes -- FILE...` takes scenes (VirtualHome's or the thesis's; `.gz` is
//! unpacked). For each it prints the rooms between which an agent can walk, and how many of the graspable
//! objects it can take and put back where the scene has them. Unreadable files are named, and the exit status
//! is then 1. `--out DIR` draws each scene from above.

mod support;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;
use support::{Complaint, say};
use vc_graph::goal::Situation;
use vc_graph::{Action, NodeId, Place, Property, Relation, Verb};
use vc_planner::{Newcomer, Run, Step};
use vc_tasks::{Outcome, Task};
use virtualcity::{ActionError, Assets, Environment, SceneOptions};

/// Tests how much agents can do in homes of which only bounding boxes are known.
#[derive(Parser)]
struct Options {
    /// Scene files; .gz is unpacked.
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Let the planner pursue forty everyday goals.
    #[arg(long)]
    goals: bool,
    /// Give objects plain boxes instead of the shapes of their classes.
    #[arg(long)]
    plain: bool,
    /// Do not take and put back objects.
    #[arg(long)]
    rooms_only: bool,
    /// Draw each scene from above into this folder.
    #[cfg(feature = "render")]
    #[arg(long)]
    out: Option<PathBuf>,
}

fn main() -> Result<ExitCode, Complaint> {
    let options = Options::parse();
    let (mut won, mut failed) = ((0, 0), 0);
    for file in &options.files {
        if let Err(complaint) = look_at(file, &options, &mut won) {
            let (file, why) = (file.display().to_string(), format!("{complaint:?}"));
            say!("{}", if why.starts_with(&file) { why } else { format!("{file}: {why}") });
            failed += 1;
        }
    }
    if options.goals {
        say!("{} of {} goals won", won.0, won.1);
    }
    if failed > 0 {
        say!("{failed} of {} scenes could not be looked at", options.files.len());
    }
    Ok(if failed == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Runs all requested tests in one scene.
fn look_at(file: &Path, options: &Options, won: &mut (usize, usize)) -> Result<(), Complaint> {
    let assets = if options.plain { Assets::None } else { Assets::Generated };
    let home = Environment::make_with(&format!("scene:{}", file.display()), 1, &SceneOptions { assets });
    let home = home.map_err(Complaint::new)?;
    say!("{}: {} nodes, left out {:?}", file.display(), home.graph().len(), home.left_out());
    say!("  {} things are elsewhere by geometry", home.elsewhere().len());
    rooms(&home);
    if !options.rooms_only {
        places(&home);
    }
    if options.goals {
        goals(&home, won)?;
    }
    #[cfg(feature = "render")]
    if let Some(out) = &options.out {
        picture(&home, out, file)?;
    }
    Ok(())
}

/// Everyday goals for such homes.
const GOALS: &str = include_str!("data/box_goals.txt");

/// Lets the planner, which does not know the home, pursue every goal that is meaningful in it and does not hold
/// yet.
fn goals(home: &Environment, won: &mut (usize, usize)) -> Result<(), Complaint> {
    let me = home.agents()[0];
    for task in Task::read_list(GOALS).map_err(Complaint::new)? {
        let done = task.goal.holds(&Situation::new(home.graph(), me, home.history()));
        if done || !task.obstacles(home.graph()).is_empty() {
            continue;
        }
        let mut steps = Vec::new();
        let mut note = |step: &Step| steps.push(step.refused.clone().unwrap_or_else(|| step.described.clone()));
        let run = Run { agent: Some(me), ..Run::seeded(1) };
        let episode = run.episode(&mut Newcomer::best(), &task, &mut home.clone(), &mut note);
        won.1 += 1;
        if episode.outcome == Outcome::Won {
            won.0 += 1;
        } else {
            say!("  {}: {:?} after {} actions, {:?}", task.title, episode.outcome, episode.steps, episode.reason);
            steps.iter().rev().take(4).rev().for_each(|step| say!("      {step}"));
        }
    }
    say!("  {} of {} goals won so far", won.0, won.1);
    Ok(())
}

/// Walks to every room.
fn rooms(home: &Environment) {
    let (me, mut reached) = (home.agents()[0], 0);
    for &room in home.graph().rooms() {
        match home.clone().set_action(me, Action::one(Verb::Walk, room)) {
            Ok(_) => reached += 1,
            Err(error) => say!("  {error}"),
        }
    }
    say!("  {reached} of {} rooms reached", home.graph().rooms().len());
}

/// Takes every graspable object and puts it back where it was.
fn places(home: &Environment) {
    let graph = home.graph();
    let carried = graph.nodes().filter(|n| n.affords(Property::Graspable));
    let rests = |p: &Place| matches!(p.relation, Relation::On | Relation::Inside);
    let wanted: Vec<(NodeId, Place)> =
        carried.filter_map(|n| Some((n.id(), graph.place(n.id()).filter(rests)?))).collect();
    let (mut done, mut failed) = (0, BTreeMap::<String, Vec<String>>::new());
    for &(id, place) in &wanted {
        match put_back(&mut home.clone(), id, place) {
            Ok(()) => done += 1,
            Err((step, error)) => {
                let (kind, detail) = sorted(&error);
                let thing = format!("{} {}: {detail}", graph.label(id), graph.label(place.at));
                failed.entry(format!("{step}: {kind}")).or_default().push(thing);
            }
        }
    }
    say!("  {done} of {} things are put back where they were", wanted.len());
    for (kind, things) in failed {
        say!("    {} {kind}", things.len());
        things.iter().take(12).for_each(|t| say!("      {t}"));
    }
}

fn put_back(home: &mut Environment, id: NodeId, place: Place) -> Result<(), (&'static str, Box<ActionError>)> {
    let me = home.agents()[0];
    let mut act = |name: &'static str, action: Action| {
        home.set_action(me, action).map(|_| home.graph().hidden_in(id)).map_err(|e| (name, Box::new(e)))
    };
    let mut hidden = act("walk", Action::one(Verb::Walk, id))?;
    while let Some(container) = hidden {
        act("walk", Action::one(Verb::Walk, container))?;
        hidden = act("open", Action::one(Verb::Open, container))?;
    }
    act("walk", Action::one(Verb::Walk, id))?;
    act("grab", Action::one(Verb::Grab, id))?;
    act("walk back", Action::one(Verb::Walk, place.at))?;
    if home.graph().node(place.at).is_some_and(vc_graph::Node::hides_contents) {
        home.set_action(me, Action::one(Verb::Open, place.at)).map_err(|e| ("open", Box::new(e)))?;
    }
    let mut act =
        |name: &'static str, action: Action| home.set_action(me, action).map(drop).map_err(|e| (name, Box::new(e)));
    let verb = if place.relation == Relation::Inside { Verb::PutIn } else { Verb::Place };
    act("put", Action::two(verb, id, place.at))
}

fn sorted(error: &ActionError) -> (&'static str, String) {
    let kind = match error {
        ActionError::Refused(_) => "refused",
        ActionError::Impossible { .. } => "impossible",
        ActionError::Disagreement(_) => "disagreement",
        _ => "other",
    };
    (kind, error.to_string())
}

#[cfg(feature = "render")]
fn picture(home: &Environment, out: &std::path::Path, file: &std::path::Path) -> Result<(), Complaint> {
    use virtualcity::Viewpoint;
    use virtualcity::render::{Modality, picture};
    let name = file.file_name().and_then(|n| n.to_str()).and_then(|n| n.split('.').next()).unwrap_or("scene");
    std::fs::create_dir_all(out).map_err(Complaint::new)?;
    let frame = home.render(Viewpoint::Overhead, Modality::Rgb, 1200, 900).map_err(Complaint::new)?;
    let png = picture::png(&picture::rgb(&frame)).map_err(Complaint::new)?;
    std::fs::write(out.join(format!("{name}.png")), png).map_err(Complaint::new)
}
