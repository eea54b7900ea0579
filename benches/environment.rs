//! The five endpoints in generated homes, as measured in the thesis's Table 5.1.
//!
//! `cargo bench --bench environment`. Homes of 300 to 560 nodes, one thread. `-- table` prints only the figures
//! beside the thesis's, `-- table 2` those of two homes: CPU time of the thread, except for the start of a
//! process and for batches, for which wall-clock time is measured.

#![allow(
    missing_docs,
    clippy::print_stdout,
    clippy::unwrap_used,
    reason = "benches print and stop where something is wrong"
)]

use std::hint::black_box;
use std::process::Command;
use std::time::{Duration, Instant};

use cpu_time::ThreadTime;
use criterion::{BatchSize, Criterion};
use vc_testkit::page::{Page, time};
use virtualcity::graph::{Action, Node, NodeId, Property, Scope, Seed, State, Verb};
use virtualcity::planner::{Agent, Decision};
use virtualcity::procgen::Apartment;
use virtualcity::relations::{Evidence, RelationRule, Relations};
use virtualcity::render::{Daylight, Modalities, Modality};
use virtualcity::{Batch, Environment, PictureOptions, Viewpoint, legal_action};

/// As in the bench of homes; the system's allocator takes a fifth longer.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// The argument with which this program starts itself to be timed until its first observation.
const FIRST: &str = "first-observation";
/// Environments in a batch.
const BATCH: u64 = 16;
/// Timed actions of each environment.
const ACTIONS: usize = 40;

/// Number of times that each home is made.
const ROUNDS: usize = 3;

/// The seed of the first measured home, and the number of homes unless another follows `table`.
const SEEDS: (u64, u64) = (40, 8);
/// The argument for printing only the figures beside the thesis's.
const TABLE: &str = "table";

fn seeds() -> std::ops::Range<u64> {
    let behind = std::env::args().skip_while(|a| a != TABLE).nth(1);
    let count = behind.and_then(|a| a.parse().ok()).unwrap_or(SEEDS.1);
    SEEDS.0..SEEDS.0 + count.max(1)
}

fn homes() -> Vec<Environment> {
    seeds().map(|seed| Environment::make(&format!("apartment/{seed}"), 1).unwrap()).collect()
}

fn make(criterion: &mut Criterion) {
    let mut seeds = seeds().cycle();
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

/// The home's scene with ten small objects raised a little.
fn moved(home: &Environment) -> virtualcity::graph::SceneGraph {
    let mut graph = home.graph().clone();
    let loose = |id: &NodeId| home.world().role(*id) == Some(virtualcity::physics::BodyRole::Loose);
    let small = |id: &NodeId| home.graph().node(*id).is_some_and(|n| n.affords(Property::Graspable));
    let both = |id: &NodeId| loose(id) && small(id);
    let ids: Vec<NodeId> = home.world().nodes().into_iter().filter(both).step_by(7).take(10).collect();
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
    let mut turn = (0..).map(|i: usize| i % all.len());
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

/// Times actions that the rule allows, chosen at random before the clock starts.
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

/// Times walks and the opening of a door.
fn by_verb(criterion: &mut Criterion, homes: &[Environment]) {
    let (home, there, fridge) = homes.iter().find_map(at_the_fridge).unwrap();
    let agent = home.agents()[0];
    criterion.bench_function("walk to the fridge", |b| {
        let action = Action::one(Verb::Walk, fridge);
        b.iter_batched(|| home.clone(), |mut home| home.set_action(agent, action).unwrap(), BatchSize::LargeInput);
    });
    let action = Action::one(Verb::Open, fridge);
    criterion.bench_function("open the fridge", |b| {
        b.iter_batched(|| there.clone(), |mut home| home.set_action(agent, action).unwrap(), BatchSize::LargeInput);
    });
    let mut open = there.clone();
    open.set_action(agent, action).unwrap();
    criterion.bench_function("close the fridge", |b| {
        let action = Action::one(Verb::Close, fridge);
        b.iter_batched(|| open.clone(), |mut home| home.set_action(agent, action).unwrap(), BatchSize::LargeInput);
    });
    criterion.bench_function("clone an environment", |b| b.iter(|| black_box(home.clone())));
}

/// A home in its initial state, the same home with its agent at the fridge, and the fridge; `None` if other
/// furniture is in the way.
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
    if std::env::args().any(|a| a == FIRST) {
        let home = Environment::make("apartment/42", 1).unwrap();
        println!("{}", home.room_observation(home.agents()[0]).len());
        return;
    }
    if !std::env::args().any(|a| a == TABLE) {
        let mut criterion = Criterion::default().sample_size(20).configure_from_args();
        make(&mut criterion);
        reset(&mut criterion);
        observe(&mut criterion);
        act(&mut criterion);
        look(&mut criterion);
        criterion.final_summary();
    }
    let mut page = Page::new("environment");
    table(&mut page);
    page.finish();
}

/// CPU time of this thread for some work.
fn cpu<T>(work: impl FnOnce() -> T) -> (Duration, T) {
    let start = ThreadTime::now();
    let made = black_box(work());
    (start.elapsed(), made)
}

/// Median and maximum of some times.
fn spread(mut times: Vec<Duration>) -> [String; 2] {
    times.sort_unstable();
    let at = |index: usize| times.get(index).map_or_else(|| "nothing".into(), |one| time(one.as_secs_f64()));
    [at(times.len() / 2), at(times.len().saturating_sub(1))]
}

/// The figures beside the thesis's.
fn table(page: &mut Page) {
    let mut rows = Vec::new();
    let mut row = |name: &str, times: Vec<Duration>, thesis: &str| {
        let [median, most] = spread(times);
        rows.push(vec![name.to_owned(), median, most, thesis.to_owned()]);
    };
    row("process start to first observation", (0..8).map(|_| first_observation()).collect(), "0.42-0.95 s to start");
    let name = |seed: u64| format!("apartment/{seed}");
    let mut homes = Vec::new();
    let mut made = Vec::new();
    // The first round allocates memory from the system; the following rounds reuse it. The cost of that
    // allocation is in the previous row.
    for round in 0..=ROUNDS {
        homes.clear();
        let all: Vec<_> = seeds().map(|seed| cpu(|| Environment::make(&name(seed), 1).unwrap())).collect();
        made.extend(all.iter().filter(|_| round > 0).map(|(time, _)| *time));
        homes = all.into_iter().map(|(_, home)| home).collect();
    }
    let stages = stages(&homes, &made);
    row("make", made, "0.22-0.27 s");
    stages.into_iter().for_each(|(stage, times)| row(stage, times, ""));
    let reset = |to: &dyn Fn(&Environment) -> virtualcity::graph::SceneGraph| -> Vec<Duration> {
        let one = |home: &Environment| {
            let (graph, mut home) = (to(home), home.clone());
            cpu(|| home.reset(&graph).unwrap()).0
        };
        homes.iter().map(one).collect()
    };
    row("reset to the start", reset(&|home| home.start().clone()), "0.17-0.27 s");
    row("reset with ten things moved", reset(&moved), "0.17-0.27 s");
    actions(&homes, &mut row);
    row("next planned action (see, believe, decide)", decisions(&homes), "0.05 s");
    fridges(&homes, &mut row);
    pictures(&homes, &mut row);
    page.table(&["", "median", "maximum", "the thesis (Table 5.1; Ryzen 9 5900X, RTX 3090)"], &rows);
    batches(&homes, page);
}

/// The cost of the stages of making homes; relations of whole homes are derived once everything is at rest.
fn stages(homes: &[Environment], made: &[Duration]) -> [(&'static str, Vec<Duration>); 3] {
    let (mut generate, mut build, mut relate) = (Vec::new(), Vec::new(), Vec::new());
    for (round, home) in (0..ROUNDS).flat_map(|round| homes.iter().map(move |home| (round, home))) {
        let number = generate.len() % homes.len();
        generate.push(cpu(|| Apartment::from_seed(Seed(SEEDS.0 + number as u64)).unwrap().scene()).0);
        let (mut graph, all) = (home.start().clone(), home.start().nodes().map(|n| n.id()).collect::<Vec<NodeId>>());
        let read = || {
            let relations = Relations::new(&graph, RelationRule::Contacts, Evidence::default()).unwrap();
            relations.write(&mut graph, &all).unwrap()
        };
        relate.push(cpu(read).0);
        build.push(made[round * homes.len() + number].saturating_sub(generate[generate.len() - 1] + relate[number]));
    }
    [
        ("of that: generate", generate),
        ("of that: build, settle", build),
        ("of that: relations of the whole home", relate),
    ]
}

/// Time from starting a process to its first observation of a home.
fn first_observation() -> Duration {
    let start = Instant::now();
    let done = Command::new(std::env::current_exe().unwrap()).arg(FIRST).output().unwrap();
    assert!(done.status.success());
    start.elapsed()
}

/// Random actions that the rule allows, and the observation of the room after each.
fn actions(homes: &[Environment], mut row: impl FnMut(&str, Vec<Duration>, &str)) {
    let mut stream = Seed(1).stream();
    let (mut acts, mut looks) = (Vec::new(), Vec::new());
    for mut home in homes.iter().cloned() {
        let agent = home.agents()[0];
        for _ in 0..ACTIONS {
            let action = legal_action(home.graph(), agent, &mut stream);
            acts.push(cpu(|| home.set_action(agent, action)).0);
            looks.push(cpu(|| home.room_observation(agent)).0);
        }
    }
    row("action at once, any that is legal", acts, "");
    row("observation of the room after an action", looks, "");
}

/// Decisions of an agent that sees only its room and brings three objects to tables.
fn decisions(homes: &[Environment]) -> Vec<Duration> {
    let mut times = Vec::new();
    for mut home in homes.iter().cloned() {
        let me = home.agents()[0];
        let mut agent = Agent::in_known_home(home.graph(), me, "On(novel, table), 2".parse().unwrap(), 7);
        for _ in 0..ACTIONS / 2 {
            let seen = home.graph().observe(me, Scope::Room);
            let (time, decision) = cpu(|| {
                agent.see(&seen);
                agent.decide()
            });
            times.push(time);
            let Decision::Act(action, _) = decision else { break };
            match home.set_action(me, action) {
                Ok(_) => agent.did(&action),
                Err(_) => break,
            }
        }
    }
    times
}

fn fridges(homes: &[Environment], mut row: impl FnMut(&str, Vec<Duration>, &str)) {
    let (mut opens, mut closes) = (Vec::new(), Vec::new());
    for (_, mut there, fridge) in homes.iter().filter_map(at_the_fridge) {
        let agent = there.agents()[0];
        let mut time = |verb| cpu(|| there.set_action(agent, Action::one(verb, fridge)).is_ok()).0;
        opens.push(time(Verb::Open));
        closes.push(time(Verb::Close));
    }
    row("opening a full fridge", opens, "");
    row("closing it", closes, "");
}

/// Times a picture from an agent's eyes that is drawn again, and one after the agent has walked somewhere, so
/// that shadows are updated. By day, and at night with all ceiling lamps on. On one thread.
fn pictures(homes: &[Environment], mut row: impl FnMut(&str, Vec<Duration>, &str)) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    for (hour, lamps) in [(12.0, false), (23.0, true)] {
        let (mut again, mut after) = (Vec::new(), Vec::new());
        for mut home in homes.iter().cloned() {
            home.set_pictures(PictureOptions { daylight: Daylight::at(hour), ..PictureOptions::default() });
            if lamps {
                home.reset(&lit(&home)).unwrap();
            }
            let me = home.agents()[0];
            let picture = |home: &Environment| {
                pool.install(|| cpu(|| home.render(Viewpoint::Agent(me), Modality::Rgb, 300, 300).unwrap()).0)
            };
            let goals = home.graph().nodes().filter(|n| n.affords(Property::Container)).map(Node::id);
            for goal in goals.step_by(3).take(6).collect::<Vec<_>>() {
                picture(&home);
                again.push(picture(&home));
                if home.set_action(me, Action::one(Verb::Walk, goal)).is_ok() {
                    after.push(picture(&home));
                }
            }
        }
        let when = if lamps { "at night, all lamps on" } else { "by day" };
        row(&format!("300 x 300 colours {when}"), again, "");
        row("the same after a walk", after, "");
    }
}

/// A home with all ceiling lamps on.
fn lit(home: &Environment) -> virtualcity::graph::SceneGraph {
    let mut graph = home.graph().clone();
    let lamps = graph.of_class("ceiling_lamp").to_vec();
    let mut edit = graph.edit();
    lamps.into_iter().for_each(|lamp| edit.enter_state(lamp, State::On).unwrap());
    edit.commit();
    graph
}

/// Times a step of a batch, and making one, on one thread and on all.
fn batches(homes: &[Environment], page: &mut Page) {
    let every: Vec<Environment> = (0..BATCH).map(|i| homes[i as usize % homes.len()].clone()).collect();
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let make =
            || pool.install(|| Batch::make((40..40 + BATCH).map(|seed| format!("apartment/{seed}")), 1).unwrap());
        drop(make());
        let start = Instant::now();
        let made = make();
        let making = start.elapsed();
        drop(made);
        let (mut batch, mut stream) = (Batch::new(every.clone()), Seed(3).stream());
        let mut stepping = Duration::ZERO;
        for _ in 0..ACTIONS {
            let action = |home: &Environment, stream: &mut _| {
                let agent = home.agents()[0];
                vec![(agent, legal_action(home.graph(), agent, stream))]
            };
            let actions: Vec<_> = batch.environments().iter().map(|home| action(home, &mut stream)).collect();
            let start = Instant::now();
            black_box(pool.install(|| batch.set_actions(&actions)));
            stepping += start.elapsed();
        }
        (making, stepping / ACTIONS as u32)
    };
    let ((make_one, step_one), (make_all, step_all)) = (on(1), on(cores));
    let row = |work: &str, one: Duration, all: Duration| {
        let [one, all] = [one, all].map(|t| t.as_secs_f64());
        vec![work.to_owned(), time(one), format!("{}, {:.2} times as fast", time(all), one / all)]
    };
    let rows = [row("making a batch of 16", make_one, make_all), row("an action in each of 16", step_one, step_all)];
    page.table(&["", "1 thread", &format!("{cores} threads")], &rows);
}
