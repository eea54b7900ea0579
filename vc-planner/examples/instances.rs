//! Planning problems with our plans, for `benches/peers/planning.py` to compare.
//!
//! `cargo run --release -p vc-planner --example instances -- FOLDER` writes for each
//! instance `NAME.domain.pddl`, `NAME.problem.pddl` and `NAME.plan`, and a list of all
//! with the costs of our plans and their times in microseconds (the first plan, and the
//! best one carried out by the rule), `instances.csv`. Homes have 500 objects.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "an example stops where something is wrong")]

#[path = "../benches/support/homes.rs"]
mod homes;

use std::fmt::Write as _;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use homes::{errands, home};
use vc_graph::{Action, Draft, Goal, SceneBuilder, SceneGraph, Simulator, Verb};
use vc_planner::{Planner, SearchLimits};
use vc_tasks::format::pddl::{self, Keep};

/// How often a plan is made to time it: the best counts.
const REPEATS: usize = 5;
const OBJECTS: usize = 500;

/// Parts of goals besides errands: eating, sitting, switching, closing.
const EXTRAS: [(&str, &str); 6] = [
    ("Eat", "apple"),
    ("Sit", "sofa"),
    ("SwitchedOn", "television"),
    ("Closed", "fridge"),
    ("Holds", "cellphone"),
    ("Open", "closet"),
];

fn main() {
    let folder = PathBuf::from(std::env::args().nth(1).unwrap_or_else(|| "target/instances".into()));
    std::fs::create_dir_all(&folder).unwrap();
    let mut list = String::from("name,predicates,cost,first,microseconds,proved\n");
    let mut write = |name: String, predicates: usize, scene: &SceneGraph, goal: &str| {
        let goal: Goal = goal.parse().unwrap();
        let me = scene.agents()[0];
        let written = pddl::planning(scene, me, &goal, Keep::Relevant).unwrap();
        let mut graph = scene.clone();
        let (mut quick, mut planner) =
            (Planner::with_limits(SearchLimits::FIRST_ANSWER), Planner::with_limits(SearchLimits::THOROUGH));
        let plan = planner.plan(&mut graph, me, &goal, &[]).unwrap();
        let time = best(|| drop(std::hint::black_box(planner.plan(&mut graph, me, &goal, &[]))));
        let first = best(|| drop(std::hint::black_box(quick.outline(scene, me, &goal, &[]))));
        let file = |what: &str, text: String| std::fs::write(folder.join(format!("{name}.{what}")), text).unwrap();
        file("domain.pddl", written.domain.to_string());
        file("problem.pddl", written.problem.to_string());
        file("plan", plan.actions.iter().map(|a| format!("{}\n", a.describe(scene))).collect());
        let (first, time) = (first.as_secs_f64() * 1e6, time.as_secs_f64() * 1e6);
        writeln!(list, "{name},{predicates},{},{first:.1},{time:.0},{}", plan.actions.len(), plan.proved).unwrap();
    };
    for predicates in 1..=6 {
        for seed in 0..18 {
            let scene = home(OBJECTS, seed);
            write(
                format!("errands-{predicates}-{seed}"),
                predicates,
                &scene,
                &errands(&scene, predicates, seed).join(" & "),
            );
        }
    }
    for (number, (verb, class)) in EXTRAS.iter().enumerate() {
        for (seed, errand) in (0..).zip([2, 3, 4, 1, 2]) {
            let scene = home(OBJECTS, 100 + seed);
            let mut parts = errands(&scene, errand, seed);
            // LM-cut comes to no end where any of dozens will do: the last two are about one.
            parts.push(match seed {
                0..3 => format!("{verb}({class})"),
                _ => format!("{verb}({})", scene.label(scene.of_class(class)[0])),
            });
            write(format!("extra-{number}-{seed}"), parts.len(), &scene, &parts.join(" & "));
        }
    }
    for seed in 0..20 {
        let scene = home(OBJECTS, 200 + seed);
        write(format!("errands-12-{seed}"), 12, &scene, &errands(&scene, 12, seed).join(" & "));
    }
    for (name, full) in [("hands", false), ("hands-full", true)] {
        let (scene, goal) = hands(full);
        write(name.into(), 2, &scene, goal);
    }
    std::fs::write(folder.join("instances.csv"), &list).unwrap();
    println!("{} instances written to {}", list.lines().count() - 1, folder.display());
}

/// The least time of a few.
fn best(mut call: impl FnMut()) -> Duration {
    let time = |_| {
        let start = Instant::now();
        call();
        start.elapsed()
    };
    (0..REPEATS).map(time).min().unwrap_or_default()
}

/// Two things at one place, to be shut away at another: with both hands full nothing
/// can be opened. Where they are in the hands already one must be put down and taken up
/// again.
fn hands(full: bool) -> (SceneGraph, &'static str) {
    let mut scene = SceneBuilder::new("hands");
    let study = scene.add(Draft::new("office")).unwrap();
    let bedroom = scene.add(Draft::new("bedroom")).unwrap();
    let desk = scene.add_in(study, Draft::new("desk")).unwrap();
    scene.add_in(bedroom, Draft::new("bathroom_cabinet")).unwrap();
    let things = ["book", "mug"].map(|class| scene.add_on(desk, Draft::new(class)).unwrap());
    let me = scene.add_in(study, Draft::new("character")).unwrap();
    let mut world = Simulator::new(scene.build());
    if full {
        world.step(me, &Action::one(Verb::Walk, desk)).unwrap();
        things.iter().for_each(|&id| drop(world.step(me, &Action::one(Verb::Grab, id)).unwrap()));
    }
    (world.into_graph(), "Inside(book, bathroom_cabinet) & Inside(mug, bathroom_cabinet)")
}
