//! The thesis's 145 tasks: every task that the oracle can do, the planners that observe only their own room can
//! do as well.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "tests may unwrap, and print counts")]

use vc_graph::format::read_scene;
use vc_graph::{ClassTable, SceneGraph, Seed, Simulator};
use vc_planner::{EpisodeOptions, PlannerPolicy, Policy};
use vc_tasks::initial::{InitialGenerator, PlainStock};
use vc_tasks::library::Benchmark;
use vc_tasks::{Outcome, World};

/// The bundled apartment, and VirtualHome's first scene if its file exists.
fn scenes() -> Vec<(&'static str, SceneGraph)> {
    let read = |text: &str| read_scene(text, &ClassTable::builtin()).unwrap();
    let mut all = vec![("bundled", read(include_str!("../../../examples/data/apartment.json")))];
    all.extend(vc_testkit::data::text("virtualhome/scene1.json.gz").map(|text| ("VirtualHome 1", read(&text))));
    all
}

#[test]
fn what_the_oracle_can_do_the_planners_can() {
    let names = ["oracle", "planner", "faithful"];
    let (mut made, mut won, mut steps) = (0, [0; 3], [0; 3]);
    let mut lost = Vec::new();
    for (name, scene) in scenes() {
        for activity in &Benchmark::v1().activities {
            let mut world = Simulator::new(scene.clone());
            let Ok(initial) = InitialGenerator::new(&PlainStock).make(activity, &scene, Seed(1), &mut world) else {
                continue;
            };
            let mut task = initial.task.clone();
            task.goal = activity.goal.clone();
            task.step_limit = 200;
            made += 1;
            let mut policies: [Box<dyn Policy>; 3] = [
                Box::new(PlannerPolicy::oracle()),
                Box::new(PlannerPolicy::best()),
                Box::new(PlannerPolicy::faithful()),
            ];
            let mut solvable = false;
            for (i, policy) in policies.iter_mut().enumerate() {
                world.reset(&initial.scene).unwrap();
                let run = EpisodeOptions { agent: Some(initial.agent), ..EpisodeOptions::seeded(1) };
                let episode = run.episode(policy.as_mut(), &task, &mut world, &mut |_| {});
                let done = episode.outcome == Outcome::Won;
                solvable |= i == 0 && done;
                (won[i], steps[i]) = (won[i] + usize::from(done), steps[i] + episode.steps);
                if !done {
                    let why = episode.reason.unwrap_or_default();
                    lost.push((
                        solvable,
                        names[i],
                        format!("{name} {} {}: {:?} {why}", activity.id, task.goal, episode.outcome),
                    ));
                }
            }
        }
    }
    println!("{made} environments");
    for (i, name) in names.iter().enumerate() {
        println!("{name:>9}: {} won, {:.2} steps", won[i], steps[i] as f64 / made as f64);
    }
    lost.iter().for_each(|(solvable, who, what)| println!("{who} (solvable: {solvable}): {what}"));
    assert!(made >= 50, "{made}");
    let missed: Vec<_> = lost.iter().filter(|(solvable, ..)| *solvable).collect();
    assert!(missed.is_empty(), "{missed:#?}");
}
