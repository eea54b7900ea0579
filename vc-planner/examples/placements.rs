//! How many steps the planner takes where things are placed by rules it was not made for.
//!
//! `cargo run --release -p vc-planner --example placements -- 24` tries 24 errands in each of
//! VirtualHome's scenes in the shared data (`VC_DATA` or `../shared/data`) by each rule: things
//! anywhere, in foreign homes, and in a made-up world where they live in bookshelves. It prints
//! mean steps of the planner, of the same with all places alike, and of the oracle;
//! `proofs/placements` sets that beside the homes the planner was made for.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "an example stops where something is wrong")]

#[path = "../tests/support/placements.rs"]
mod placements;

use placements::{Rule, errand};
use vc_graph::{SceneGraph, Simulator};
use vc_planner::{EpisodeOptions, PlannerPolicy, Policy, Prior};
use vc_tasks::{Outcome, Task};

const RULES: [(&str, Rule); 3] =
    [("anywhere", Rule::Anywhere), ("foreign", Rule::Foreign), ("in bookshelves", Rule::In("bookshelf"))];
/// How many things are asked for at most.
const MOST: u64 = 8;

fn main() {
    let number: u64 = std::env::args().nth(1).map_or(24, |n| n.parse().unwrap());
    let scenes: Vec<SceneGraph> = vc_testkit::data::SCENES.into_iter().filter_map(vc_testkit::data::scene).collect();
    if scenes.is_empty() {
        return;
    }
    println!(
        "{:<16}{:>8}{:>8}{:>10}{:>10}{:>8}{:>8}",
        "things are", "errands", "won", "planner", "uniform", "ratio", "oracle"
    );
    for (name, rule) in RULES {
        let (mut won, mut steps, mut all) = (0, [0; 3], 0);
        for (scene, seed) in scenes.iter().flat_map(|scene| (0..number).map(move |seed| (scene, seed))) {
            let (home, goal) = errand(scene, rule, (1 + seed % MOST) as usize, seed);
            let uniform = || PlannerPolicy::best().with_prior(Prior::Uniform);
            let policies: [&mut dyn Policy; 3] =
                [&mut PlannerPolicy::best(), &mut uniform(), &mut PlannerPolicy::oracle()];
            let runs = policies.map(|policy| attempt(policy, &home, &goal, seed));
            all += 1;
            won += usize::from(runs[0].0);
            steps.iter_mut().zip(runs).for_each(|(sum, (_, steps))| *sum += steps);
        }
        let [planner, uniform, oracle] = steps.map(|sum| sum as f64 / f64::from(all));
        println!("{name:<16}{all:>8}{won:>8}{planner:>10.2}{uniform:>10.2}{:>8.3}{oracle:>8.2}", planner / uniform);
    }
}

fn attempt(policy: &mut dyn Policy, home: &SceneGraph, goal: &str, seed: u64) -> (bool, usize) {
    let mut task = Task::new("errand", goal.parse().unwrap());
    task.step_limit = 250;
    let episode = EpisodeOptions::seeded(seed).episode(policy, &task, &mut Simulator::new(home.clone()), &mut |_| {});
    (episode.outcome == Outcome::Won, episode.steps)
}
