//! Tests how much agents can do in homes of which only bounding boxes are known.
//!
//! `cargo run --release --example boxes -- FILE...` takes scenes (VirtualHome's or the thesis's; `.gz` is
//! unpacked). For each it prints the rooms between which an agent can walk, and how many of the graspable
//! objects it can take and put back where the scene has them, and why not the others. `--out DIR` draws each scene from
//! above: `a/home.json` as `home_above.png`, another `home.json` as `home_above_2.png`. The exit status is 1 if a file
//! cannot be read or a picture not be written, a room cannot be reached, or bodies and rule disagree about an action.

#[path = "support/placements.rs"]
mod placements;
mod support;

#[cfg(feature = "render")]
use std::collections::BTreeSet;
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
///
/// The exit status is 1 if a file cannot be read or a picture not be written, a room cannot be reached, or bodies and
/// rule disagree about an action.
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
    /// Draw each scene from above into this folder, as `NAME_above.png`, or `NAME_above_2.png` where a name is taken.
    #[cfg(feature = "render")]
    #[arg(long)]
    out: Option<PathBuf>,
}

/// The findings in all scenes.
#[derive(Default)]
struct Findings {
    /// Goals won, and pursued.
    won: (usize, usize),
    put: placements::Tally,
    unreached: usize,
    /// The names of the pictures.
    #[cfg(feature = "render")]
    pictures: BTreeSet<String>,
}

fn main() -> Result<ExitCode, Complaint> {
    let options = Options::parse();
    let (mut found, mut failed) = (Findings::default(), 0);
    for file in &options.files {
        if let Err(complaint) = look_at(file, &options, &mut found) {
            let (file, why) = (file.display().to_string(), format!("{complaint:?}"));
            say!("{}", if why.starts_with(&file) { why } else { format!("{file}: {why}") });
            failed += 1;
        }
    }
    if options.goals {
        say!("{} of {} goals won", found.won.0, found.won.1);
    }
    if !options.rooms_only && options.files.len() > 1 {
        say!("in all scenes");
        found.put.say();
    }
    let faults = [
        (failed, format!("{failed} of {} scenes could not be looked at", options.files.len())),
        (found.unreached, format!("rooms that could not be reached: {}", found.unreached)),
        (found.put.disagreed(), format!("actions about which bodies and rule disagree: {}", found.put.disagreed())),
    ];
    faults.iter().filter(|(count, _)| *count > 0).for_each(|(_, words)| say!("{words}"));
    Ok(if faults.iter().all(|(count, _)| *count == 0) { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Runs all requested tests in one scene.
fn look_at(file: &Path, options: &Options, found: &mut Findings) -> Result<(), Complaint> {
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
    found.unreached += rooms(&home);
    if !options.rooms_only {
        found.put.add(placements::all(&home));
    }
    if options.goals {
        goals(&home, &mut found.won)?;
    }
    #[cfg(feature = "render")]
    if let Some(out) = &options.out {
        picture(&home, &out.join(picture_name(file, &mut found.pictures)))?;
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

/// Walks to every room, and counts those that cannot be reached.
fn rooms(home: &Environment) -> usize {
    let (me, mut reached) = (home.agents()[0], 0);
    for &room in home.graph().rooms() {
        match home.clone().set_action(me, Action::one(Verb::Walk, room)) {
            Ok(_) => reached += 1,
            Err(error) => say!("  {error}"),
        }
    }
    let all = home.graph().rooms().len();
    say!("  {reached} of {all} rooms reached");
    all - reached
}

#[cfg(feature = "render")]
fn picture(home: &Environment, path: &Path) -> Result<(), Complaint> {
    use virtualcity::Viewpoint;
    use virtualcity::render::{Modality, picture};
    let failed = |error: String| Complaint::new(format!("{}: {error}", path.display()));
    let frame = home.render(Viewpoint::Overhead, Modality::Rgb, 1200, 900).map_err(|e| failed(e.to_string()))?;
    let png = picture::png(&picture::rgb(&frame)).map_err(|e| failed(e.to_string()))?;
    Ok(virtualcity::files::write(path, png)?)
}

/// The name of a scene's picture, which no other scene of this run has.
#[cfg(feature = "render")]
fn picture_name(file: &Path, taken: &mut BTreeSet<String>) -> String {
    let file = if file.extension().is_some_and(|e| e == "gz") { file.with_extension("") } else { file.to_owned() };
    let stem = file.file_stem().map_or_else(|| "scene".into(), |stem| stem.to_string_lossy());
    let (mut name, mut number) = (format!("{stem}_above.png"), 1);
    while !taken.insert(name.clone()) {
        number += 1;
        name = format!("{stem}_above_{number}.png");
    }
    name
}

#[cfg(all(test, feature = "render"))]
mod tests {
    use super::*;

    #[test]
    fn pictures_of_several_scenes_have_several_names() {
        let mut taken = BTreeSet::new();
        let files = ["a/home.json", "b/home.json", "home.json.gz", "flat_3.json", "flat_3.thesis.json"];
        let names = files.map(|file| picture_name(Path::new(file), &mut taken));
        assert_eq!(names[..3], ["home_above.png", "home_above_2.png", "home_above_3.png"]);
        assert_eq!(names[3..], ["flat_3_above.png", "flat_3.thesis_above.png"]);
    }
}
