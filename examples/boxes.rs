//! Tests how much agents can do in homes of which only bounding boxes are known.
//!
//! `cargo run --release --example boxes -- FILE...` takes scenes (VirtualHome's or the thesis's; `.gz` is
//! unpacked). For each it prints the rooms between which an agent can walk, and how many of the graspable
//! objects it can take and put back where the scene has them, and why not the others. Unreadable files are named, and the exit status
//! is then 1. `--out DIR` draws each scene from above.

#[path = "support/placements.rs"]
mod placements;
mod support;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;
use support::{Complaint, say};
use vc_graph::goal::Situation;
use vc_graph::{Action, Verb};
use vc_planner::{EpisodeOptions, PlannerPolicy, Step};
use vc_tasks::{Outcome, Task};
use virtualcity::{Assets, Environment};

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
    let (mut won, mut put, mut failed) = ((0, 0), placements::Tally::default(), 0);
    for file in &options.files {
        if let Err(complaint) = look_at(file, &options, &mut won, &mut put) {
            let (file, why) = (file.display().to_string(), format!("{complaint:?}"));
            say!("{}", if why.starts_with(&file) { why } else { format!("{file}: {why}") });
            failed += 1;
        }
    }
    if options.goals {
        say!("{} of {} goals won", won.0, won.1);
    }
    if !options.rooms_only && options.files.len() > 1 {
        say!("in all scenes");
        put.say();
    }
    if failed > 0 {
        say!("{failed} of {} scenes could not be looked at", options.files.len());
    }
    Ok(if failed == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Runs all requested tests in one scene.
fn look_at(
    file: &Path,
    options: &Options,
    won: &mut (usize, usize),
    put: &mut placements::Tally,
) -> Result<(), Complaint> {
    let assets = if options.plain { Assets::None } else { Assets::Generated };
    let home = Environment::builder(format!("scene:{}", file.display())).assets(assets).make();
    let home = home.map_err(Complaint::new)?;
    say!("{}: {} nodes, {} left out", file.display(), home.graph().len(), home.left_out().len());
    home.left_out().iter().for_each(|left| say!("  {left}"));
    say!("  {} things are elsewhere by geometry", home.elsewhere().len());
    for passage in home.opened_passages() {
        let rooms: Vec<String> = passage.rooms.iter().map(|room| home.graph().label(*room).to_string()).collect();
        say!("  a passage was opened between {}, which no door connects", rooms.join(" and "));
    }
    rooms(&home);
    if !options.rooms_only {
        put.add(placements::all(&home));
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
        let run = EpisodeOptions { agent: Some(me), ..EpisodeOptions::seeded(1) };
        let episode = run.episode(&mut PlannerPolicy::best(), &task, &mut home.clone(), &mut note);
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

#[cfg(feature = "render")]
fn picture(home: &Environment, out: &std::path::Path, file: &std::path::Path) -> Result<(), Complaint> {
    use virtualcity::Viewpoint;
    use virtualcity::render::{Modality, picture};
    let name = file.file_name().and_then(|n| n.to_str()).and_then(|n| n.split('.').next()).unwrap_or("scene");
    virtualcity::files::create_folder(out)?;
    let frame = home.render(Viewpoint::Overhead, Modality::Rgb, 1200, 900).map_err(Complaint::new)?;
    let png = picture::png(&picture::rgb(&frame)).map_err(Complaint::new)?;
    std::fs::write(out.join(format!("{name}.png")), png).map_err(Complaint::new)
}
