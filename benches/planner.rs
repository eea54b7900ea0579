//! What deciding costs: plans from scratch, and the next action of an agent that sees
//! only its room.
//!
//! Plans are made in a home of five hundred objects made here, and in homes of other
//! sizes, for goals of one to thirty parts. The decisions are in VirtualHome's first
//! scene where the shared data is there (`VC_DATA` or `../shared/data`), else in the
//! bundled apartment; `benches/README.md` has the peers' figures.

#![allow(missing_docs, clippy::unwrap_used, clippy::print_stdout, reason = "benches stop where something is wrong")]

#[path = "../tests/common/mod.rs"]
mod common;

use std::time::{Duration, Instant};

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use vc_graph::format::read_scene;
use vc_graph::{ClassTable, Draft, Goal, NodeId, SceneBuilder, SceneGraph, Scope, Seed, Simulator};
use vc_planner::{Agent, Decision, Effort, Planner};

const GOAL: &str = "On(plate, kitchen_table), 2 & Inside(apple, fridge) & Closed(fridge)";
const ITEMS: [&str; 12] =
    ["plate", "fork", "mug", "apple", "book", "milk", "towel", "cellphone", "bowl", "knife", "banana", "pillow"];
const SURFACES: [&str; 6] = ["kitchen_table", "kitchen_counter", "coffee_table", "desk", "nightstand", "dresser"];
const BOXES: [&str; 4] = ["fridge", "kitchen_cabinet", "bathroom_cabinet", "closet"];

fn scene() -> SceneGraph {
    let bundled = include_str!("../examples/data/apartment.json").to_owned();
    let text = common::text("virtualhome/scene1.json.gz").unwrap_or(bundled);
    read_scene(&text, &ClassTable::builtin()).unwrap()
}

/// A home of five rooms and so many objects: a tenth of them surfaces and containers,
/// the rest things in and on these.
fn home(objects: usize, seed: u64) -> SceneGraph {
    let mut stream = Seed(seed).stream();
    let mut scene = SceneBuilder::new("home");
    let rooms = ["kitchen", "living_room", "bedroom", "bathroom", "hallway"];
    let rooms: Vec<NodeId> = rooms.iter().map(|r| scene.add(Draft::new(*r)).unwrap()).collect();
    let places: Vec<(NodeId, bool)> = (0..objects / 10)
        .map(|i| {
            let (class, inside) = match i % 5 {
                0 | 1 => (BOXES[i / 5 % BOXES.len()], true),
                _ => (SURFACES[i / 5 % SURFACES.len()], false),
            };
            (scene.add_in(*stream.pick(&rooms).unwrap(), Draft::new(class)).unwrap(), inside)
        })
        .collect();
    for i in places.len()..objects {
        let (at, inside) = *stream.pick(&places).unwrap();
        let draft = Draft::new(ITEMS[i % ITEMS.len()]);
        if inside { scene.add_in(at, draft) } else { scene.add_on(at, draft) }.unwrap();
    }
    scene.add_in(rooms[0], Draft::new("character")).unwrap();
    scene.build()
}

/// A goal about so many single things, as a household task names them.
fn goal(scene: &SceneGraph, parts: usize, seed: u64) -> Goal {
    let mut stream = Seed(seed).child("goal").stream();
    let targets = [("On", "kitchen_table"), ("On", "coffee_table"), ("Inside", "fridge"), ("Inside", "closet")];
    let mut used = Vec::new();
    let mut text = Vec::new();
    while text.len() < parts {
        let class = *stream.pick(&ITEMS).unwrap();
        let item = *stream.pick(&scene.of_class(class)).unwrap();
        let (relation, target) = *stream.pick(&targets).unwrap();
        let at = scene.of_class(target)[0];
        if !used.contains(&item) && !scene.rests_at(item, at) {
            used.push(item);
            text.push(format!("{relation}({}, {})", scene.label(item), scene.label(at)));
        }
    }
    text.join(" & ").parse().unwrap()
}

/// Plans from scratch over many goals; prints the median and the 99th percentile.
fn planning(c: &mut Criterion) {
    let mut group = c.benchmark_group("first plan from scratch");
    for objects in [100, 500, 1_000, 3_000, 10_000] {
        cases(&mut group, objects, 6, "objects");
    }
    for parts in [1, 3, 12, 20, 30] {
        cases(&mut group, 500, parts, "parts");
    }
    group.finish();
}

fn cases(
    group: &mut criterion::BenchmarkGroup<'_, criterion::measurement::WallTime>,
    objects: usize,
    parts: usize,
    by: &str,
) {
    let scene = home(objects, 1);
    let me = scene.agents()[0];
    let goals: Vec<Goal> = (0..200).map(|seed| goal(&scene, parts, seed)).collect();
    let mut planner = Planner::trying(Effort::QUICK);
    let mut times: Vec<Duration> = goals
        .iter()
        .map(|goal| {
            let least = |_| {
                let start = Instant::now();
                std::hint::black_box(planner.outline(&scene, me, goal, &[]).unwrap());
                start.elapsed()
            };
            (0..5).map(least).min().unwrap()
        })
        .collect();
    times.sort_unstable();
    println!("{objects} objects, {parts} parts: median {:?}, 99th percentile {:?}", times[100], times[197]);
    let mut next = goals.iter().cycle();
    let id = BenchmarkId::new(by, if by == "objects" { objects } else { parts });
    group.bench_function(id, |b| b.iter(|| planner.outline(&scene, me, next.next().unwrap(), &[]).unwrap()));
}

/// Runs an episode and adds the time of each decision: seeing and deciding.
fn episode(scene: &SceneGraph, goal: &Goal, seed: u64, times: &mut Vec<Duration>) {
    let me = scene.agents()[0];
    let mut world = Simulator::new(scene.clone());
    let mut agent = Agent::newcomer(scene, me, goal.clone(), seed);
    for _ in 0..500 {
        let start = Instant::now();
        let seen = world.graph().observe(me, Scope::Room);
        agent.see(&seen);
        let decision = agent.decide();
        times.push(start.elapsed());
        let Decision::Act(action, _) = decision else { return };
        drop(seen);
        world.step(me, &action).unwrap();
        agent.did(&action);
    }
}

fn deciding(c: &mut Criterion) {
    let (scene, goal): (SceneGraph, Goal) = (scene(), GOAL.parse().unwrap());
    let mut times = Vec::new();
    (0..50).for_each(|seed| episode(&scene, &goal, seed, &mut times));
    times.sort_unstable();
    println!("decisions: median {:?}, 99th percentile {:?}", times[times.len() / 2], times[times.len() * 99 / 100]);
    c.bench_function("next action: observe, believe, plan", |b| {
        b.iter_custom(|iterations| {
            let mut times = Vec::new();
            for seed in 0.. {
                episode(&scene, &goal, seed, &mut times);
                if times.len() as u64 >= iterations {
                    break;
                }
            }
            times.iter().sum::<Duration>().mul_f64(iterations as f64 / times.len() as f64)
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

criterion_group!(benches, planning, deciding, moving_in);
criterion_main!(benches);
