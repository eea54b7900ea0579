//! The cost of deciding: plans from scratch, and the next action of an agent that observes only its own room.
//!
//! Plans are made in a home with five hundred objects, and in homes of other sizes, for goals with one to
//! thirty parts; the growth is plotted in `target/planner/`. The time for each of 200 goals is the best of
//! five, since the machine may be busy with other things; median and 99th percentile are over the goals. The
//! decisions are made in VirtualHome's first scene if the shared data exist (`VC_DATA` or `../shared/data`),
//! otherwise in the bundled apartment; `benches/README.md` lists the times of comparable planners.

#![allow(missing_docs, clippy::unwrap_used, reason = "benches stop where something is wrong")]

#[path = "support/homes.rs"]
mod homes;
#[path = "support/plot.rs"]
mod plot;

use std::time::{Duration, Instant};

use homes::{errands, home};
use plot::{Line, svg};
use vc_graph::format::read_scene;
use vc_graph::{ClassTable, Goal, NodeId, SceneGraph, Scope, Simulator};
use vc_planner::{Agent, Decision, Planner, SearchLimits};
use vc_testkit::page::{Page, time};

const GOAL: &str = "On(plate, kitchen_table), 2 & Inside(apple, fridge) & Closed(fridge)";
const GOALS: u64 = 200;
const REPEATS: usize = 5;

/// A goal of a number of errands.
fn goal(scene: &SceneGraph, parts: usize, seed: u64) -> Goal {
    errands(scene, parts, seed).join(" & ").parse().unwrap()
}

fn main() {
    // `cargo bench -p vc-planner -- decision` runs only the named benchmarks.
    let only: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with('-')).collect();
    let wanted = |name: &str| only.is_empty() || only.iter().any(|o| name.contains(o.as_str()));
    let mut page = Page::new("planner");
    let mut rows = Vec::new();
    if wanted("plan") {
        plans(&mut rows);
    }
    if wanted("growth") {
        growth(&mut rows);
    }
    if wanted("decision") {
        deciding(&mut rows);
        moving_in(&mut rows);
    }
    page.table(&["", "mean", "median", "99th percentile", "minimum"], &rows);
    page.finish();
}

/// A row of the table: a name and the figures that were taken.
fn row(name: String, figures: [Option<Duration>; 4]) -> Vec<String> {
    let cell = |figure: Option<Duration>| figure.map_or_else(String::new, |figure| time(figure.as_secs_f64()));
    [vec![name], figures.map(cell).to_vec()].concat()
}

/// The rows of the table.
type Rows = Vec<Vec<String>>;

/// The first plans, for the sizes with a required time.
fn plans(rows: &mut Rows) {
    for parts in [6, 12] {
        planning(500, parts, rows);
    }
}

fn growth(rows: &mut Rows) {
    let by_objects = [100, 300, 500, 1_000, 3_000, 10_000].map(|objects| (objects as f64, planning(objects, 6, rows)));
    let by_parts = [1, 2, 3, 6, 12, 20, 30].map(|parts| (parts as f64, planning(500, parts, rows)));
    draw("objects", "Objects in the home, 6 predicates", &by_objects);
    draw("predicates", "Predicates, 500 objects", &by_parts);
}

/// Median and 99th percentile.
fn spread(times: &mut [Duration]) -> (Duration, Duration) {
    times.sort_unstable();
    (times[times.len() / 2], times[(times.len() * 99 / 100).min(times.len() - 1)])
}

fn draw(name: &str, title: &str, figures: &[(f64, (Duration, Duration))]) {
    let line = |name, pick: fn(&(Duration, Duration)) -> Duration| Line {
        name,
        points: figures.iter().map(|(x, times)| (*x, pick(times).as_secs_f64() * 1e6)).collect(),
    };
    let lines = [line("median", |t| t.0), line("99th percentile", |t| t.1)];
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../target/planner");
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join(format!("{name}.svg")), svg(title, name, "microseconds", &lines)).unwrap();
}

/// The first plans from scratch over many goals.
fn planning(objects: usize, parts: usize, rows: &mut Rows) -> (Duration, Duration) {
    let scene = home(objects, 1);
    let me = scene.agents()[0];
    let goals: Vec<Goal> = (0..GOALS).map(|seed| goal(&scene, parts, seed)).collect();
    let mut planner = Planner::with_limits(SearchLimits::FIRST_ANSWER);
    let mut least = vec![Duration::MAX; goals.len()];
    for _ in 0..REPEATS {
        for (goal, least) in goals.iter().zip(&mut least) {
            let start = Instant::now();
            std::hint::black_box(planner.outline(&scene, me, goal, &[]).unwrap());
            *least = start.elapsed().min(*least);
        }
    }
    let figures = spread(&mut least);
    let name = format!("first plan, {objects} objects, {parts} predicates");
    // Some sizes are measured more than once.
    rows.retain(|row| row[0] != name);
    rows.push(row(name, [None, Some(figures.0), Some(figures.1), None]));
    figures
}

fn scene() -> SceneGraph {
    let apartment = include_str!("../../examples/data/apartment.json").to_owned();
    let text = vc_testkit::data::text("virtualhome/scene1.json.gz").unwrap_or(apartment);
    read_scene(&text, &ClassTable::builtin()).unwrap()
}

/// Runs an episode; returns the time of each decision, observation and planning together.
fn episode(scene: &SceneGraph, mut agent: Agent) -> Vec<Duration> {
    let mut times = Vec::new();
    let me = scene.agents()[0];
    let mut world = Simulator::new(scene.clone());
    for _ in 0..500 {
        let start = Instant::now();
        let seen = world.graph().observe(me, Scope::Room);
        agent.see(&seen);
        let decision = agent.decide();
        times.push(start.elapsed());
        let Decision::Act(action, _) = decision else { break };
        drop(seen);
        world.step(me, &action).unwrap();
        agent.did(&action);
    }
    times
}

/// Whole decisions under partial observability.
fn deciding(rows: &mut Rows) {
    let home = home(500, 1);
    let cases: Vec<(&str, SceneGraph, Vec<Goal>)> = vec![
        ("VirtualHome scene 1", scene(), vec![GOAL.parse().unwrap(); 20]),
        ("500 objects", home.clone(), (0..20).map(|seed| goal(&home, 6, seed)).collect()),
    ];
    for (name, scene, goals) in cases {
        rows.push(decisions(format!("decision, {name}"), &scene, &goals, Agent::in_known_home));
        rows.push(decisions(format!("the same as in the thesis, {name}"), &scene, &goals, Agent::faithful));
    }
}

/// The decision times of some agents.
fn decisions(
    name: String,
    scene: &SceneGraph,
    goals: &[Goal],
    agent: fn(&SceneGraph, NodeId, Goal, u64) -> Agent,
) -> Vec<String> {
    let mut times = Vec::new();
    for (seed, goal) in (0..).zip(goals) {
        let new = |_| episode(scene, agent(scene, scene.agents()[0], goal.clone(), seed));
        let runs: Vec<Vec<Duration>> = (0..REPEATS).map(new).collect();
        times.extend((0..runs[0].len()).map(|i| runs.iter().map(|r| r[i]).min().unwrap()));
    }
    let mean = times.iter().sum::<Duration>() / times.len() as u32;
    let (median, late) = spread(&mut times);
    row(name, [Some(mean), Some(median), Some(late), None])
}

fn best(mut call: impl FnMut()) -> Duration {
    let time = |_| {
        let start = Instant::now();
        call();
        start.elapsed()
    };
    (0..20).map(time).min().unwrap()
}

fn moving_in(rows: &mut Rows) {
    let (scene, goal) = (scene(), GOAL.parse::<Goal>().unwrap());
    let me = scene.agents()[0];
    let new = best(|| drop(std::hint::black_box(Agent::in_known_home(&scene, me, goal.clone(), 1))));
    let mut graph = scene.clone();
    let history = vc_graph::History::default();
    let plan = best(|| drop(std::hint::black_box(vc_planner::plan(&mut graph, me, &goal, &history).unwrap())));
    rows.push(row("new agent".into(), [None, None, None, Some(new)]));
    rows.push(row("plan to the goal with full knowledge".into(), [None, None, None, Some(plan)]));
}
