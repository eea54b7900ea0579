//! Costs of the scene graph: building, cloning, acting, observing, searching.
//!
//! The scene is VirtualHome's first one if the shared data exists (`VC_DATA` or `../shared/data`), else the
//! bundled apartment; `benches/README.md` has the figures of the peer.

#![allow(missing_docs, clippy::unwrap_used, reason = "benches stop where something is wrong")]

use std::hint::black_box;
use std::time::Instant;

use criterion::{BatchSize, Criterion};
use nalgebra::{Isometry3, Point3};
use vc_graph::format::virtualhome::EnvironmentGraph;
use vc_graph::format::{native, read_scene, virtualhome};
use vc_graph::{Action, ClassTable, Draft, NodeId, SceneBuilder, SceneGraph, Scope, Verb, Word, rule};
use vc_testkit::page::{Page, time};

fn scene() -> SceneGraph {
    let bundled = include_str!("../examples/data/apartment.json").to_owned();
    let text = vc_testkit::data::text("virtualhome/scene1.json.gz").unwrap_or(bundled);
    read_scene(&text, &ClassTable::builtin()).unwrap()
}

fn building(c: &mut Criterion) {
    let graph = scene();
    let (classes, text) = (ClassTable::builtin(), virtualhome::write(&graph));
    let file: EnvironmentGraph = EnvironmentGraph::from_scene(&graph);
    let own = native::write(&graph);
    c.bench_function("build from parsed nodes and edges", |b| {
        b.iter_with_large_drop(|| file.build("scene", &classes).unwrap())
    });
    c.bench_function("read VirtualHome JSON", |b| {
        b.iter_with_large_drop(|| virtualhome::read(black_box(&text), &classes).unwrap())
    });
    c.bench_function("read native JSON", |b| {
        b.iter_with_large_drop(|| native::read(black_box(&own), &classes).unwrap())
    });
    c.bench_function("clone", |b| b.iter(|| graph.clone()));
    c.bench_function("clone and step", |b| {
        let (me, walk) = (graph.agents()[0], far_walk(&graph));
        b.iter_batched(|| graph.clone(), |mut g| rule::step(&mut g, me, &walk).unwrap(), BatchSize::SmallInput);
    });
    c.bench_function("digest", |b| b.iter(|| graph.digest()));
}

/// A walk to an object in another room.
fn far_walk(graph: &SceneGraph) -> Action {
    let here = graph.room_of(graph.agents()[0]);
    let fridge = graph.of_class("fridge")[0];
    let there = if graph.room_of(fridge) == here { graph.of_class("bed")[0] } else { fridge };
    format!("walk #{}", there.0).parse().unwrap()
}

/// Ten actions that can be repeated: back and forth to the fridge.
fn script(graph: &SceneGraph) -> Vec<Action> {
    let id = |class: &str| graph.of_class(class)[0].0;
    let (fridge, plate, bed) = (id("fridge"), id("plate"), id("bed"));
    let lines = [
        format!("walk #{fridge}"),
        format!("open #{fridge}"),
        format!("walk #{plate}"),
        format!("grab #{plate}"),
        format!("walk #{fridge}"),
        format!("put_in #{plate} #{fridge}"),
        format!("grab #{plate}"),
        format!("close #{fridge}"),
        format!("walk #{bed}"),
        format!("place #{plate} #{bed}"),
    ];
    lines.iter().map(|l| l.parse().unwrap()).collect()
}

fn acting(c: &mut Criterion) {
    let mut graph = scene();
    let (me, script) = (graph.agents()[0], script(&graph));
    c.bench_function("ten actions in place", |b| {
        b.iter(|| script.iter().for_each(|a| drop(rule::step(&mut graph, me, a).unwrap())));
    });
    c.bench_function("one refusal", |b| {
        let far = Action::one(vc_graph::Verb::Grab, graph.of_class("fridge")[0]);
        b.iter(|| rule::step(&mut graph, me, &far).unwrap_err());
    });
}

fn observing(c: &mut Criterion) {
    let graph = scene();
    let me = graph.agents()[0];
    c.bench_function("observe a room", |b| b.iter(|| graph.observe(me, Scope::Room)));
    c.bench_function("observe a room, list all relations", |b| {
        b.iter(|| graph.observe(me, Scope::Room).relations().collect::<Vec<_>>());
    });
    c.bench_function("observe a room, as a graph", |b| b.iter(|| graph.observe(me, Scope::Room).to_graph(&graph)));
}

/// A million nodes on a floor of a square kilometre.
fn million() -> SceneGraph {
    let mut scene = SceneBuilder::new("city");
    for i in 0..1_000_000_u32 {
        let at = Isometry3::translation((i % 1000) as f32, (i / 1000) as f32, 0.0);
        scene.add(Draft::new("chair").at(at)).unwrap();
    }
    scene.build()
}

fn searching(c: &mut Criterion) {
    let graph = million();
    let (centre, radius) = (Point3::new(500.0, 500.0, 0.0), 15.0);
    let scan = || -> Vec<NodeId> {
        let near = |p: Point3<f32>| nalgebra::distance_squared(&p, &centre) <= radius * radius;
        graph.nodes().filter(|n| n.position().is_some_and(near)).map(vc_graph::Node::id).collect()
    };
    assert_eq!(graph.within(centre, radius), scan());
    let mut group = c.benchmark_group("radius in a million nodes");
    group.bench_function(format!("grid, {} found", scan().len()), |b| b.iter(|| graph.within(centre, radius)));
    group.sample_size(20).bench_function("linear scan", |b| b.iter(scan));
    group.finish();
    c.bench_function("look up one of a million", |b| b.iter(|| graph.node(black_box(NodeId(777_777)))));
    c.bench_function("clone a million", |b| b.iter(|| graph.clone()));
}

/// Every verb with each of some objects, or with any two of them, checked one by one by the rule, which
/// formulates every reason.
fn legal_one_by_one(graph: &SceneGraph, agent: NodeId, things: &[NodeId]) -> Vec<Action> {
    let pairs = |verb: Verb| things.iter().flat_map(move |&x| things.iter().map(move |&y| Action::two(verb, x, y)));
    let free = |action: &Action| rule::refusals(graph, agent, action).is_empty();
    let of = |&verb: &Verb| -> Vec<Action> {
        match verb.arity() {
            0 => Some(Action::zero(verb)).into_iter().filter(free).collect(),
            1 => things.iter().map(|&id| Action::one(verb, id)).filter(free).collect(),
            _ => pairs(verb).filter(free).collect(),
        }
    };
    Verb::ALL.iter().flat_map(of).collect()
}

/// The former implementation: one-object verbs with each object, and held objects put on or into each object,
/// checked in the same way. It omitted the other two-object verbs, such as pouring.
fn legal_as_it_was(graph: &SceneGraph, agent: NodeId, things: &[NodeId]) -> Vec<Action> {
    let free = |action: &Action| rule::refusals(graph, agent, action).is_empty();
    let one = Verb::ALL.iter().filter(|v| v.arity() == 1);
    let singles = one.flat_map(|&verb| things.iter().map(move |&id| Action::one(verb, id)));
    let held: Vec<NodeId> = graph.held(agent).collect();
    let put = |&x: &NodeId| things.iter().flat_map(move |&y| [Verb::Place, Verb::PutIn].map(|v| Action::two(v, x, y)));
    let none = Verb::ALL.iter().filter(|v| v.arity() == 0).map(|&verb| Action::zero(verb));
    singles.chain(held.iter().flat_map(put)).chain(none).filter(free).collect()
}

/// Mean time of some work, seconds, over as many rounds as fill half a second.
fn seconds(mut done: impl FnMut() -> usize) -> f64 {
    let (start, mut rounds) = (Instant::now(), 0_u32);
    while rounds == 0 || start.elapsed().as_secs_f64() < 0.5 {
        black_box(done());
        rounds += 1;
    }
    start.elapsed().as_secs_f64() / f64::from(rounds)
}

/// Times all implementations of listing the legal actions in one run: in the agent's room, and in the whole
/// home.
fn deciding(page: &mut Page) {
    let mut graph = scene();
    let (me, script) = (graph.agents()[0], script(&graph));
    // With a plate in hand, in front of an open fridge.
    script.iter().take(5).for_each(|action| drop(rule::step(&mut graph, me, action).unwrap()));
    let all: Vec<NodeId> = graph.nodes().map(vc_graph::Node::id).collect();
    let room: Vec<NodeId> = graph.in_room(graph.room_of(me).unwrap()).collect();
    let mut rows = Vec::new();
    for (name, things) in [("the room", room), ("the home", all)] {
        let found = rule::legal_actions_with(&graph, me, &things);
        assert_eq!(found, legal_one_by_one(&graph, me, &things));
        let fast = seconds(|| rule::legal_actions_with(&graph, me, &things).len());
        let before = seconds(|| legal_as_it_was(&graph, me, &things).len());
        let slow = seconds(|| legal_one_by_one(&graph, me, &things).len());
        let name = format!("{} objects of {name}, {} found", things.len(), found.len());
        rows.push([vec![name], [fast, before, slow].map(time).to_vec()].concat());
    }
    page.table(&["legal actions", "listed", "as it was", "every two objects, one by one"], &rows);
}

fn main() {
    let mut page = Page::new("graph");
    let mut criterion = Criterion::default().configure_from_args();
    [building, acting, observing, searching].into_iter().for_each(|bench| bench(&mut criterion));
    criterion.final_summary();
    page.criterion();
    deciding(&mut page);
    page.finish();
}
