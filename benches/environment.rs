//! The five endpoints in generated homes: what the thesis's Table 5.1 measures.
//!
//! `cargo bench --bench environment`. Homes of 300 to 560 nodes, one thread.

#![allow(clippy::unwrap_used, reason = "a bench stops where something is wrong")]

use std::hint::black_box;

use criterion::{BatchSize, Criterion};
use virtualcity::graph::{Action, NodeId, Seed, Verb};
use virtualcity::render::{Modalities, Modality};
use virtualcity::{Environment, Viewpoint, legal_action};

/// Homes that are measured in turn.
const SEEDS: std::ops::Range<u64> = 40..48;

fn homes() -> Vec<Environment> {
    SEEDS.map(|seed| Environment::make(&format!("apartment/{seed}"), 1).unwrap()).collect()
}

fn make(criterion: &mut Criterion) {
    let mut seeds = SEEDS.cycle();
    let mut next = || format!("apartment/{}", seeds.next().unwrap_or(40));
    criterion.bench_function("make", |b| {
        b.iter_batched(&mut next, |name| Environment::make(&name, 1).unwrap(), BatchSize::PerIteration);
    });
}

fn reset(criterion: &mut Criterion) {
    let all = homes();
    let mut turn = 0..;
    criterion.bench_function("reset to the start", |b| {
        let mut homes = all.clone();
        b.iter(|| {
            let index = turn.next().unwrap_or(0) % homes.len();
            let start = homes[index].start().clone();
            black_box(homes[index].reset(&start).unwrap())
        });
    });
    criterion.bench_function("reset with ten things moved", |b| {
        let mut homes: Vec<(Environment, _)> = all.iter().map(|h| (h.clone(), moved(h))).collect();
        b.iter(|| {
            let index = turn.next().unwrap_or(0) % homes.len();
            let (home, graph) = &mut homes[index];
            black_box(home.reset(graph).unwrap())
        });
    });
}

/// Ten small things raised a little.
fn moved(home: &Environment) -> virtualcity::graph::SceneGraph {
    let mut graph = home.graph().clone();
    let loose = |id: &NodeId| home.world().role(*id) == Some(virtualcity::physics::Role::Loose);
    let ids: Vec<NodeId> = home.world().nodes().into_iter().filter(loose).step_by(7).take(10).collect();
    let mut edit = graph.edit();
    for id in ids {
        let pose = home.world().pose(id).unwrap();
        let raised = nalgebra::Translation3::new(0.0, 0.0, 0.01) * pose;
        edit.set_pose(id, Some(raised)).unwrap();
    }
    edit.commit();
    graph
}

fn observe(criterion: &mut Criterion) {
    let all = homes();
    let mut turn = (0..).map(|i: usize| i % SEEDS.count());
    let mut home = || &all[turn.next().unwrap_or(0)];
    criterion.bench_function("observation of a room", |b| {
        b.iter(|| {
            let home = home();
            black_box(home.room_observation(home.agents()[0]).len())
        });
    });
    criterion.bench_function("observation within 3 m", |b| {
        b.iter(|| {
            let home = home();
            black_box(home.observation(home.agents()[0], 3.0).len())
        });
    });
}

/// Actions that the rule allows, chosen at random before the clock starts.
fn act(criterion: &mut Criterion) {
    let mut homes = homes();
    let mut stream = Seed(1).stream();
    let mut turn = 0..;
    let legal = |homes: &[Environment], index: usize, stream: &mut virtualcity::graph::Stream| {
        let home = &homes[index];
        let agent = home.agents()[0];
        (agent, legal_action(home.graph(), agent, stream))
    };
    criterion.bench_function("a legal action at random", |b| {
        b.iter_custom(|count| {
            let mut time = std::time::Duration::ZERO;
            for _ in 0..count {
                let index = turn.next().unwrap_or(0) % homes.len();
                let (agent, action) = legal(&homes, index, &mut stream);
                let start = std::time::Instant::now();
                let _ = black_box(homes[index].set_action(agent, action));
                time += start.elapsed();
            }
            time
        });
    });
    by_verb(criterion, &homes);
}

/// Walks, and a door that opens.
fn by_verb(criterion: &mut Criterion, homes: &[Environment]) {
    let (home, there, fridge) = homes.iter().find_map(at_the_fridge).unwrap();
    let agent = home.agents()[0];
    criterion.bench_function("walk to the fridge", |b| {
        let action = Action::one(Verb::Walk, fridge);
        b.iter_batched(|| home.clone(), |mut home| home.set_action(agent, action).unwrap(), BatchSize::LargeInput);
    });
    criterion.bench_function("open the fridge", |b| {
        let action = Action::one(Verb::Open, fridge);
        b.iter_batched(|| there.clone(), |mut home| home.set_action(agent, action).unwrap(), BatchSize::LargeInput);
    });
    criterion.bench_function("clone an environment", |b| b.iter(|| black_box(home.clone())));
}

/// A home as it begins, the same with its agent at the fridge, and the fridge; none where
/// other furniture is in the way.
fn at_the_fridge(home: &Environment) -> Option<(Environment, Environment, NodeId)> {
    let mut home = home.clone();
    let start = home.start().clone();
    home.reset(&start).ok()?;
    let (agent, fridge) = (home.agents()[0], *home.graph().of_class("fridge").first()?);
    let mut there = home.clone();
    there.set_action(agent, Action::one(Verb::Walk, fridge)).ok()?;
    there.clone().set_action(agent, Action::one(Verb::Open, fridge)).ok()?;
    Some((home, there, fridge))
}

fn look(criterion: &mut Criterion) {
    let home = Environment::make("apartment/42", 1).unwrap();
    let view = Viewpoint::Agent(home.agents()[0]);
    for (name, wanted) in [("depth and nodes", Modality::Depth | Modality::Instance), ("colours", Modality::Rgb.into())]
    {
        let wanted: Modalities = wanted;
        criterion.bench_function(&format!("render {name}, 300 x 300"), |b| {
            b.iter(|| black_box(home.render(view, wanted, 300, 300).unwrap()));
        });
    }
}

fn main() {
    let mut criterion = Criterion::default().sample_size(20).configure_from_args();
    make(&mut criterion);
    reset(&mut criterion);
    observe(&mut criterion);
    act(&mut criterion);
    look(&mut criterion);
    thesis();
    criterion.final_summary();
}

/// The thesis's own figures (Table 5.1), beside which these stand.
#[allow(clippy::print_stdout, reason = "a bench prints")]
fn thesis() {
    println!("the thesis's Table 5.1, seconds (Ryzen 9 5900X, RTX 3090): VirtualHome, VirtualCity");
    println!("  starting the executable   4.56-5.07   0.42-0.95");
    println!("  make('Apartment_0')       1.88-3.09   0.22-0.27");
    println!("  reset()                   1.30-2.15   0.17-0.27");
}
