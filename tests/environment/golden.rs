//! Worlds, plans and episodes with bodies of ten seeds, compared with the digests in `tests/data/seeds.txt`.
//!
//! `VC_GOLDEN=write cargo test --workspace --test environment golden` rewrites the file. `decisions/18-seeds.md`
//! says what a seed promises.

use std::path::Path;

use rayon::prelude::*;
use vc_testkit::golden;
use virtualcity::Environment;
use virtualcity::graph::hash::Digester;
use virtualcity::graph::{SceneGraph, Seed, Simulator};
use virtualcity::initial::{AtHome, at_home, generator};
use virtualcity::planner::{EpisodeOptions, PlannerPolicy, Trajectory};
use virtualcity::tasks::library::{Activity, Benchmark};
use virtualcity::tasks::{Task, World, WorldError};

const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/seeds.txt");
const HEAD: &str = "# seed, world; task, steps and digest of an episode by the rule, of its first steps with bodies\n";
const SEEDS: u64 = 10;
/// An episode with bodies ends after this many steps.
const FIRST: usize = 12;

fn with_bodies(home: SceneGraph) -> Result<Environment, WorldError> {
    Environment::from_scene(home, 1).map_err(WorldError::failed)
}

/// An episode: its actions, and the scene after each.
fn episode<W: World>(made: &mut AtHome<W>, seed: u64, steps: usize) -> (usize, Digester) {
    let run = EpisodeOptions { agent: Some(made.initial.agent), ..EpisodeOptions::seeded(seed) };
    let task = Task { step_limit: steps, ..made.initial.task.clone() };
    let trajectory = Trajectory::record(&run, &mut PlannerPolicy::best(), &task, &mut made.world);
    let mut digester = Digester::new();
    for step in &trajectory.steps {
        digester.text(&step.action.to_string()).text(&step.digest);
    }
    (trajectory.steps.len(), digester)
}

fn line(seed: u64, activity: &Activity) -> String {
    let world = Environment::make(&format!("apartment/{seed}"), 1).unwrap().digest();
    let mut symbolic = at_home(activity, Seed(seed), &generator(), |home| Ok(Simulator::new(home))).unwrap();
    let (planned, plan) = episode(&mut symbolic, seed, usize::from(u8::MAX));
    let mut bodies = at_home(activity, Seed(seed), &generator(), with_bodies).unwrap();
    let (done, mut moved) = episode(&mut bodies, seed, FIRST);
    let moved = moved.word(bodies.world.digest().0).digest();
    format!("{seed} {world}; {} {planned} {} {done} {moved}\n", activity.id, plan.digest())
}

#[test]
fn seeds_give_what_they_gave() {
    let tasks = Benchmark::v1().activities;
    // Tasks from all of the benchmark.
    let of = |seed: u64| &tasks[seed as usize * tasks.len() / SEEDS as usize];
    let lines: Vec<String> = (0..SEEDS).into_par_iter().map(|seed| line(seed, of(seed))).collect();
    golden::same_lines(Path::new(FILE), &(HEAD.to_owned() + &lines.concat()));
}
