//! An agent with a body pursues a household goal in a generated home under partial observability: it sees only
//! the room it is in.
//!
//! `cargo run --release --example household -- --seed 9 --out out/household` writes a folder: `index.html`
//! shows the film (from the agent's eyes and from a corner of the room), the six modalities, and the home from
//! above with the agent's path; `trajectory.jsonl` has every step. `--scene FILE` takes a scene file with
//! poses, `--task TITLE` a task of the library, `--goal TEXT` any goal; `--dataset` also writes frames with
//! COCO annotations and the scene as glTF; `--hour 19` is dusk and `--hour 23` night, at which lamps are on at
//! the start, unless `--lamps as-is` leaves them unchanged; `--finer 3` increases the antialiasing. With
//! `--agents 2` two agents share the goal and tell each other their observations. At the end all actions are
//! replayed from the start, and must lead to the same home. `--symbolic` runs without bodies: by default in the
//! bundled apartment, with the goal of three apples on the kitchen table and the fridge closed; the folder, then
//! `out/symbolic` by default, has `episode.jsonl` and a page with belief and log. A run removes the files of an
//! earlier run from its folder, with bodies or without, as `files.txt` lists them, and refuses a folder that has files
//! of those names from elsewhere, or a data set unless it writes one. `--list` shows the possible tasks in the home or
//! scene.

mod asked;
mod choose;
mod physical;
#[path = "../support/remark.rs"]
mod remark;
#[path = "../support/seed.rs"]
mod seed;
#[path = "../support/mod.rs"]
mod support;
mod symbolic;

use std::path::PathBuf;

use clap::{Parser, ValueEnum};
use support::Complaint;
use vc_planner::{PlannerPolicy, Policy, RandomPolicy};

/// An agent pursues a household goal and sees only the room it is in.
#[derive(Parser)]
pub(crate) struct Options {
    /// The seed of the home (default 9) and of the agent's guesses.
    #[arg(long, allow_negative_numbers = true, value_parser = seed::seed)]
    seed: Option<u64>,
    /// A scene: the thesis's JSON, VirtualHome's environment graph or VirtualCity's JSON.
    #[arg(long)]
    scene: Option<PathBuf>,
    /// A task of the library, by how its title begins, in capitals or not.
    #[arg(long, conflicts_with = "goal", value_parser = clap::builder::NonEmptyStringValueParser::new())]
    task: Option<String>,
    /// The goal, such as "Inside(plate, dishwasher), 2 & Closed(dishwasher)".
    #[arg(long)]
    goal: Option<String>,
    /// Number of agents in the home. Planners share the goal; with other policies only the first agent acts.
    #[arg(long, default_value_t = 1, value_parser = agents)]
    agents: usize,
    /// The output folder; out/household by default, or out/symbolic without bodies.
    #[arg(long)]
    out: Option<PathBuf>,
    /// Number of actions after which the run stops.
    #[arg(long, default_value_t = 500)]
    steps: usize,
    /// The policy.
    #[arg(long, value_enum, default_value = "planner")]
    policy: Who,
    /// Run without bodies: the transition rule alone.
    #[arg(long)]
    symbolic: bool,
    /// Show the possible tasks in the scene, and stop.
    #[arg(long)]
    list: bool,
    /// A table of additional classes for a symbolic run, in the format of `ClassTable::parse`.
    #[arg(long)]
    classes: Option<PathBuf>,
    /// Also write a data set: frames with boxes and masks as COCO, the scene as glTF.
    #[arg(long)]
    dataset: bool,
    /// Width of each picture, pixels, 480 by default; its height is three quarters of that.
    #[arg(long, value_parser = clap::value_parser!(u32).range(64..=1280))]
    width: Option<u32>,
    /// Supersampling factor along each side of a picture, for antialiasing; 2 by default.
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..=4))]
    finer: Option<u32>,
    /// The hour of the day, which determines the daylight: 12 is noon, 19 dusk, 23 night.
    #[arg(long, value_parser = hour)]
    hour: Option<f32>,
    /// Whether lamps are on at the start.
    #[arg(long, value_enum, default_value = "at-dark")]
    lamps: Lamps,
}

/// The initial state of the home's lamps.
#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Lamps {
    /// On if it is dark outside, as if people were at home.
    AtDark,
    /// As in the scene.
    AsIs,
}

impl Options {
    fn seed(&self) -> u64 {
        self.seed.unwrap_or(9)
    }

    /// The output folder.
    pub(crate) fn folder(&self) -> PathBuf {
        let usual = if self.symbolic { "out/symbolic" } else { "out/household" };
        self.out.clone().unwrap_or_else(|| usual.into())
    }
}

/// Parses a number of agents.
fn agents(text: &str) -> Result<usize, String> {
    let number = text.parse().ok().filter(|number| *number > 0);
    number.ok_or_else(|| "somebody has to act: a whole number from 1 up".to_owned())
}

/// Parses an hour of the day.
fn hour(text: &str) -> Result<f32, String> {
    let hour = text.parse().ok().filter(|hour| (0.0..=24.0).contains(hour));
    hour.ok_or_else(|| "an hour is a number from 0 to 24, such as 19.5".to_owned())
}

/// The policy.
#[derive(Clone, Copy, ValueEnum)]
enum Who {
    /// Searches where people usually keep objects, and plans for both hands.
    Planner,
    /// Plans as the thesis's agent does: guesses uniformly, pursues one subgoal after the other.
    Faithful,
    /// Knows and sees everything.
    Oracle,
    /// Any verb with any object.
    Random,
}

impl Who {
    pub(crate) fn policy(self) -> Box<dyn Policy> {
        match self {
            Self::Planner => Box::new(PlannerPolicy::best()),
            Self::Faithful => Box::new(PlannerPolicy::faithful()),
            Self::Oracle => Box::new(PlannerPolicy::oracle()),
            Self::Random => Box::new(RandomPolicy::default()),
        }
    }
}

fn main() -> Result<(), Complaint> {
    let options = Options::parse();
    asked::check(&options)?;
    if options.symbolic { symbolic::main(&options) } else { physical::main(&options) }
}
