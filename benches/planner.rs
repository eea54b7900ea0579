//! What deciding costs: the next action of an agent that sees only its room.
//!
//! The scene is VirtualHome's first where the shared data is there (`VC_DATA` or
//! `../shared/data`), else the bundled apartment; `benches/README.md` has the
//! peer's figures.

#![allow(missing_docs, clippy::unwrap_used, reason = "benches stop where something is wrong")]

#[path = "../tests/common/mod.rs"]
mod common;

use std::time::{Duration, Instant};

use criterion::{Criterion, criterion_group, criterion_main};
use vc_graph::format::read_scene;
use vc_graph::{ClassTable, Goal, SceneGraph, Scope, Simulator};
use vc_planner::{Agent, Decision};

const GOAL: &str = "On(plate, kitchen_table), 2 & Inside(apple, fridge) & Closed(fridge)";

fn scene() -> SceneGraph {
    let bundled = include_str!("../examples/data/apartment.json").to_owned();
    let text = common::text("virtualhome/scene1.json.gz").unwrap_or(bundled);
    read_scene(&text, &ClassTable::builtin()).unwrap()
}

/// Runs an episode and returns the time spent in seeing and deciding, and how many
/// actions were decided.
fn episode(scene: &SceneGraph, goal: &Goal, seed: u64) -> (Duration, u32) {
    let me = scene.agents()[0];
    let mut world = Simulator::new(scene.clone());
    let mut agent = Agent::newcomer(scene, me, goal.clone(), seed);
    let (mut spent, mut steps) = (Duration::ZERO, 0);
    loop {
        let start = Instant::now();
        let seen = world.graph().observe(me, Scope::Room);
        agent.see(&seen);
        let decision = agent.decide();
        spent += start.elapsed();
        steps += 1;
        let Decision::Act(action, _) = decision else { return (spent, steps) };
        drop(seen);
        world.step(me, &action).unwrap();
        agent.did(&action);
    }
}

fn deciding(c: &mut Criterion) {
    let (scene, goal) = (scene(), GOAL.parse().unwrap());
    c.bench_function("next action: observe, believe, plan", |b| {
        b.iter_custom(|iterations| {
            let (mut total, mut decided) = (Duration::ZERO, 0);
            for seed in 0.. {
                let (spent, steps) = episode(&scene, &goal, seed);
                (total, decided) = (total + spent, decided + steps);
                if u64::from(decided) >= iterations {
                    break;
                }
            }
            total.mul_f64(iterations as f64 / f64::from(decided))
        });
    });
}

fn moving_in(c: &mut Criterion) {
    let (scene, goal) = (scene(), GOAL.parse::<Goal>().unwrap());
    let me = scene.agents()[0];
    c.bench_function("new agent", |b| b.iter(|| Agent::newcomer(&scene, me, goal.clone(), 1)));
    c.bench_function("plan to the goal with full knowledge", |b| {
        let mut graph = scene.clone();
        b.iter(|| vc_planner::plan(&mut graph, me, &goal, &vc_graph::History::default()).unwrap());
    });
}

criterion_group!(benches, deciding, moving_in);
criterion_main!(benches);
