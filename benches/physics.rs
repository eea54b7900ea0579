//! Costs of physics: building, settling, stepping, resetting, path finding.
//!
//! The scene is the one on which `peers/physics.py` times MuJoCo and PyBullet; times are CPU time of the
//! thread, as there. `benches/README.md` has the figures side by side.

#![allow(missing_docs, clippy::unwrap_used, reason = "benches stop where something is wrong")]

#[path = "support/cpu.rs"]
mod cpu;
#[path = "support/scene.rs"]
mod scene;

use std::hint::black_box;

use cpu::Cpu;
use criterion::{BatchSize, BenchmarkId, Criterion};
use nalgebra::{Point2, Vector3};
use vc_testkit::page::{Page, time};
use virtualcity::graph::{NodeId, Pose, SceneGraph, Seed};
use virtualcity::physics::{DoorHandling, Floor, FloorOptions, PhysicsWorld, ShapeCache};

const SIZES: [u32; 3] = [100, 500, 2000];

fn at(name: &str, objects: u32) -> BenchmarkId {
    BenchmarkId::new(name, objects)
}

fn worlds(c: &mut Criterion<Cpu>) {
    for objects in SIZES {
        let graph = scene::read(objects);
        let shapes = ShapeCache::new();
        let build = || PhysicsWorld::build(&graph, &shapes, scene::settings()).unwrap();
        let fresh = build();
        let mut group = c.benchmark_group("physics");
        group.sample_size(if objects > 500 { 10 } else { 30 });
        group.bench_function(at("build", objects), |b| b.iter_with_large_drop(build));
        group.bench_function(at("build and first step", objects), |b| {
            b.iter_with_large_drop(|| {
                let mut world = build();
                world.step();
                world
            });
        });
        group.bench_function(at("build, no shapes known", objects), |b| {
            b.iter_with_large_drop(|| PhysicsWorld::build(&graph, &ShapeCache::new(), scene::settings()).unwrap());
        });
        group.bench_function(at("settle", objects), |b| {
            b.iter_batched(|| fresh.clone(), |mut w| (w.settle(300), w), BatchSize::LargeInput);
        });
        let mut settled = fresh.clone();
        let report = settled.settle(300);
        eprintln!("{objects} objects: settled in {} steps, at rest {}", report.steps, report.at_rest);
        group.bench_function(at("step, all asleep", objects), |b| b.iter(|| settled.step()));
        group.bench_function(at("clone", objects), |b| {
            b.iter_batched(|| (), |()| settled.clone(), BatchSize::PerIteration);
        });
        group.bench_function(at("save", objects), |b| b.iter_with_large_drop(|| settled.save().unwrap()));
        let bytes = settled.save().unwrap();
        group.bench_function(at("restore", objects), |b| {
            b.iter_with_large_drop(|| PhysicsWorld::restore(black_box(&bytes), &graph, &shapes).unwrap());
        });
        active(&mut group, &settled, &scene::small_things(&graph), objects);
        let other = moved(&graph, &settled, 10);
        // Each reset reuses the memory of the previous world, as in a sequence of episodes.
        group.bench_function(at("reset, 10 moved", objects), |b| {
            b.iter_batched(|| (), |()| settled.reset(&other, &shapes).unwrap(), BatchSize::PerIteration);
        });
        group.bench_function(at("reset, 10 moved, and a step", objects), |b| {
            b.iter_with_large_drop(|| {
                let (mut world, _) = settled.reset(&other, &shapes).unwrap();
                world.step();
                world
            });
        });
        let plan = FloorOptions { doors: DoorHandling::AsTheyAre, ..FloorOptions::default() };
        group.bench_function(at("floor", objects), |b| b.iter_with_large_drop(|| Floor::new(&settled, plan)));
        group.finish();
    }
}

type Group<'a> = criterion::BenchmarkGroup<'a, Cpu>;

/// Two seconds in which fifty small objects are thrown up six times a second.
fn active(group: &mut Group<'_>, settled: &PhysicsWorld, things: &[NodeId], objects: u32) {
    group.bench_function(at("120 steps, 50 active", objects), |b| {
        b.iter_batched(
            || settled.clone(),
            |mut world| {
                for step in 0..120 {
                    if step % 10 == 0 {
                        for &id in things {
                            let up = world.body(id).unwrap().velocity() + Vector3::z() * 0.4;
                            let spin = world.body(id).unwrap().angular_velocity();
                            world.set_velocity(id, up, spin).unwrap();
                        }
                    }
                    world.step();
                }
                world
            },
            BatchSize::LargeInput,
        );
    });
}

/// The scene with some small objects a little above their rest positions.
fn moved(graph: &SceneGraph, settled: &PhysicsWorld, count: usize) -> SceneGraph {
    let mut other = graph.clone();
    let mut edit = other.edit();
    for id in scene::small_things(graph).into_iter().take(count) {
        let pose = Pose::translation(0.0, 0.0, 0.05) * settled.pose(id).unwrap();
        edit.set_pose(id, Some(pose)).unwrap();
    }
    edit.commit();
    other
}

/// Prints the memory of a world at rest. It runs before all benches and keeps its clones to the end, since
/// allocations that reuse freed memory would not be measured.
fn memory(page: &mut Page) {
    let (mut kept, mut rows) = (Vec::new(), Vec::new());
    for objects in SIZES {
        let graph = scene::read(objects);
        let mut world = PhysicsWorld::build(&graph, &ShapeCache::new(), scene::settings()).unwrap();
        world.settle(300);
        let (bodies, pieces) = world.size();
        let memory = format!("{:.2} MiB", growth(&world, &mut kept));
        rows.push(vec![objects.to_string(), bodies.to_string(), pieces.to_string(), memory]);
    }
    page.table(&["objects", "bodies", "pieces", "memory of a world"], &rows);
}

/// The growth of the process for each of many clones, MiB.
fn growth(world: &PhysicsWorld, kept: &mut Vec<PhysicsWorld>) -> f64 {
    const CLONES: usize = 40;
    let resident = || {
        let text = std::fs::read_to_string("/proc/self/statm").unwrap_or_default();
        text.split(' ').nth(1).and_then(|n| n.parse::<f64>().ok()).unwrap_or(f64::NAN) * 4096.0 / 1048576.0
    };
    // The first clones use memory left over from building and settling.
    kept.extend((0..CLONES).map(|_| world.clone()));
    let before = resident();
    kept.extend((0..CLONES).map(|_| world.clone()));
    (resident() - before) / CLONES as f64
}

/// Path finding in generated apartments.
#[cfg(feature = "procgen")]
fn apartments(c: &mut Criterion<Cpu>, page: &mut Page) {
    use virtualcity::physics::Settings;
    use virtualcity::procgen::Apartment;
    let shapes = ShapeCache::new();
    let scenes: Vec<SceneGraph> = (1..6).map(|seed| Apartment::from_seed(Seed(seed)).unwrap().scene()).collect();
    let build = |graph: &SceneGraph| PhysicsWorld::build(graph, &shapes, Settings::default()).unwrap();
    let worlds: Vec<PhysicsWorld> = scenes.iter().map(build).collect();
    let mut group = c.benchmark_group("apartment");
    group.bench_function("build", |b| b.iter_with_large_drop(|| build(&scenes[0])));
    let mut settled = worlds[0].clone();
    let report = settled.settle(300);
    eprintln!("apartment 1: {:?} bodies and pieces, {} steps to rest", worlds[0].size(), report.steps);
    group.bench_function("settle", |b| {
        b.iter_batched(|| worlds[0].clone(), |mut w| (w.settle(300), w), BatchSize::LargeInput);
    });
    group.bench_function("step, all asleep", |b| b.iter(|| settled.step()));
    group.bench_function("floor", |b| b.iter_with_large_drop(|| Floor::new(&worlds[0], FloorOptions::default())));
    // The outlines of the shapes on the floor are computed once for all worlds with the same shapes; here, each
    // time.
    group.bench_function("floor, no shapes known", |b| {
        let fresh = || PhysicsWorld::build(&scenes[0], &ShapeCache::new(), Settings::default()).unwrap();
        b.iter_batched(fresh, |world| (Floor::new(&world, FloorOptions::default()), world), BatchSize::LargeInput);
    });
    let floors: Vec<Floor> = worlds.iter().map(|w| Floor::new(w, FloorOptions::default())).collect();
    let queries: Vec<(&Floor, Point2<f32>, Point2<f32>)> = floors.iter().flat_map(|f| pairs(f, 200)).collect();
    report_ways(&queries, page);
    let mut next = queries.iter().cycle();
    group.bench_function("way", |b| {
        b.iter(|| {
            let (floor, from, to) = next.next().unwrap();
            floor.route(*from, *to)
        });
    });
    group.finish();
}

#[cfg(feature = "procgen")]
fn pairs(floor: &Floor, count: usize) -> Vec<(&Floor, Point2<f32>, Point2<f32>)> {
    let mut rng = Seed(1).stream();
    let mut point = || loop {
        let p = Point2::new(rng.between(-1.0, 16.0), rng.between(-1.0, 16.0));
        if floor.is_free(p) {
            break p;
        }
    };
    (0..count).map(|_| (floor, point(), point())).collect()
}

/// The median over routes: each is timed separately ten times, and the best time counts.
#[cfg(feature = "procgen")]
fn report_ways(queries: &[(&Floor, Point2<f32>, Point2<f32>)], page: &mut Page) {
    let best = |(floor, from, to): &(&Floor, Point2<f32>, Point2<f32>)| {
        let once = || {
            let start = std::time::Instant::now();
            black_box(floor.route(*from, *to));
            start.elapsed().as_secs_f64()
        };
        (0..10).map(|_| once()).fold(f64::MAX, f64::min)
    };
    let mut times: Vec<f64> = queries.iter().map(best).collect();
    times.sort_by(f64::total_cmp);
    let mut lengths: Vec<f32> = queries.iter().filter_map(|(f, a, b)| Some(f.route(*a, *b)?.length)).collect();
    lengths.sort_by(f32::total_cmp);
    let row = vec![
        format!("{}, of which {} exist", queries.len(), lengths.len()),
        time(times[times.len() / 2]),
        time(times[times.len() * 95 / 100]),
        format!("{:.1} m", lengths.get(lengths.len() / 2).copied().unwrap_or(f32::NAN)),
    ];
    page.table(&["routes in apartments", "median", "95th percentile", "median length"], &[row]);
}

#[cfg(not(feature = "procgen"))]
fn apartments(_: &mut Criterion<Cpu>, _: &mut Page) {
    let _ = (Point2::new(0.0, 0.0), Seed(0), time(0.0));
}

fn main() {
    let mut page = Page::new("physics");
    memory(&mut page);
    let mut criterion = Criterion::default().with_measurement(Cpu).configure_from_args();
    worlds(&mut criterion);
    apartments(&mut criterion, &mut page);
    criterion.final_summary();
    page.criterion();
    page.finish();
}
