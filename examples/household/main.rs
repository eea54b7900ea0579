//! An agent with a body pursues a household goal in a generated home, seeing only the room
//! it stands in.
//!
//! `cargo run --release --example household -- --seed 9 --out out/household` writes a folder:
//! `index.html` shows the film (from its eyes and from a corner of the room), the six
//! modalities, the home from above with the way it went; `trajectory.jsonl` has every step.
//! `--scene FILE` takes a scene file with poses, `--task TITLE` a task of the library,
//! `--goal TEXT` any goal; `--dataset` writes frames with COCO annotations and the scene as glTF
//! as well; `--hour 19` is dusk and `--hour 23` night, at which lamps are on as it begins, unless
//! `--lamps as-is` leaves them as they are; `--finer 3` smooths edges more. With
//! `--agents 2` two agents share the goal and tell each other what they see. In the end all actions
//! are done again from the beginning, and have to lead to the same home.
//! `--symbolic` does it without bodies: by default the bundled
//! apartment, three apples to the kitchen table, and the fridge closed at the end; the folder then has
//! `trajectory.jsonl` and a page with belief and log. A run removes the files in the folder that an earlier run
//! wrote and that it does not write itself.
//! `--list` shows what can be asked of the home or scene.

mod asked;
mod choose;
mod physical;
#[path = "../support/mod.rs"]
mod support;
mod symbolic;

use std::path::PathBuf;

use clap::{Parser, ValueEnum};
use support::Complaint;
use vc_planner::{Newcomer, Policy, Random, Resident};

/// An agent pursues a household goal, seeing only the room it stands in.
#[derive(Parser)]
pub(crate) struct Options {
    /// The home's seed, 9 if not said; what the agent guesses by.
    #[arg(long)]
    seed: Option<u64>,
    /// A scene: the thesis's JSON, VirtualHome's environment graph or our own.
    #[arg(long)]
    scene: Option<PathBuf>,
    /// A task of the library, by the beginning of its title.
    #[arg(long, conflicts_with = "goal")]
    task: Option<String>,
    /// The goal, such as "Inside(plate, dishwasher), 2 & Closed(dishwasher)".
    #[arg(long)]
    goal: Option<String>,
    /// How many agents are in the home. Planners share the goal; of the others the first one acts.
    #[arg(long, default_value_t = 1, value_parser = agents)]
    agents: usize,
    /// The folder to write to.
    #[arg(long, default_value = "out/household")]
    out: PathBuf,
    /// After how many actions to stop.
    #[arg(long, default_value_t = 500)]
    steps: usize,
    /// Who acts.
    #[arg(long, value_enum, default_value = "planner")]
    policy: Who,
    /// Without bodies: the transition rule alone.
    #[arg(long)]
    symbolic: bool,
    /// Show what can be asked of the scene, and stop.
    #[arg(long)]
    list: bool,
    /// Classes of your own for a symbolic run, in the format of `ClassTable::parse`.
    #[arg(long)]
    classes: Option<PathBuf>,
    /// Write a dataset as well: frames with their boxes and masks as COCO, the scene as glTF.
    #[arg(long)]
    dataset: bool,
    /// Pixels across of each picture, 480 if not said; it is three quarters as high.
    #[arg(long, value_parser = clap::value_parser!(u32).range(64..=1280))]
    width: Option<u32>,
    /// How many times finer pictures are made along each side before they are shrunk, which smooths edges; twice if
    /// not said.
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..=4))]
    finer: Option<u32>,
    /// The hour of the day whose light comes in: 12 is noon, 19 dusk, 23 night.
    #[arg(long, value_parser = hour)]
    hour: Option<f32>,
    /// Whether lamps are on as it begins.
    #[arg(long, value_enum, default_value = "at-dark")]
    lamps: Lamps,
}

/// When the home's lamps are on as it begins.
#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Lamps {
    /// On if it is dark outside, as people who are at home have them.
    AtDark,
    /// As the scene has them.
    AsIs,
}

impl Options {
    fn seed(&self) -> u64 {
        self.seed.unwrap_or(9)
    }
}

/// How many agents act.
fn agents(text: &str) -> Result<usize, String> {
    let number = text.parse().ok().filter(|number| *number > 0);
    number.ok_or_else(|| "somebody has to act: a whole number from 1 up".to_owned())
}

/// An hour of the day.
fn hour(text: &str) -> Result<f32, String> {
    let hour = text.parse().ok().filter(|hour| (0.0..=24.0).contains(hour));
    hour.ok_or_else(|| "an hour is a number from 0 to 24, such as 19.5".to_owned())
}

/// Who acts.
#[derive(Clone, Copy, ValueEnum)]
enum Who {
    /// Searches where people keep things, and plans for both hands.
    Planner,
    /// Plans as the thesis's agent does: guesses uniformly, one subgoal after the other.
    Faithful,
    /// Knows and sees everything.
    Oracle,
    /// Any verb, any thing.
    Random,
}

impl Who {
    pub(crate) fn policy(self) -> Box<dyn Policy> {
        match self {
            Self::Planner => Box::new(Newcomer::best()),
            Self::Faithful => Box::new(Newcomer::faithful()),
            Self::Oracle => Box::new(Resident::default()),
            Self::Random => Box::new(Random::default()),
        }
    }
}

fn main() -> Result<(), Complaint> {
    let options = Options::parse();
    asked::check(&options)?;
    if options.symbolic { symbolic::main(&options) } else { physical::main(&options) }
}
