//! Costs of relations, compared with shape casts of a physics engine: CPU time of the thread, on the scenes
//! used for timing physics. Run with `cargo bench -p vc-relations`.

#![allow(missing_docs, clippy::unwrap_used, reason = "benches stop where something is wrong")]

#[path = "../../benches/support/cpu.rs"]
mod cpu;
#[path = "../tests/shared/mod.rs"]
mod shared;

use std::hint::black_box;

use cpu::Cpu;
use cpu_time::ThreadTime;
use criterion::{BenchmarkId, Criterion};
use nalgebra::Vector3;
use parry3d::math::{Pose as EnginePose, Rotation as EngineRotation, Vector as EngineVector};
use parry3d::query::{ShapeCastOptions, cast_shapes};
use parry3d::shape::{Compound, Cuboid, SharedShape};
use vc_graph::{NodeId, Pose, SceneGraph};
use vc_relations::{Evidence, RelationRule, Relations};
use vc_testkit::page::Page;

const SIZES: [u32; 3] = [100, 500, 2000];

/// A scene of the peer comparison, or, if those are not available, one of the tests' own scenes of the same
/// size.
fn scene(objects: u32) -> (SceneGraph, Evidence, Vec<NodeId>) {
    if let Some(peers) = shared::peers::read(objects) {
        return (peers.graph, peers.evidence, peers.truth.iter().map(|t| t.0).collect());
    }
    let (home, truth) = shared::home::home(objects as usize);
    let ids = truth.iter().map(|t| home.id(&t.name)).collect();
    (home.graph, home.evidence, ids)
}

fn all(c: &mut Criterion<Cpu>) {
    let mut group = c.benchmark_group("all relations");
    for objects in SIZES {
        let (graph, evidence, _) = scene(objects);
        let mut relations = Relations::new(&graph, RelationRule::Contacts, evidence.clone()).unwrap();
        eprintln!("{objects} objects: {} relations", relations.edges().len());
        group.bench_function(BenchmarkId::new("assets known", objects), |b| {
            b.iter(|| {
                relations.rebuild(&graph).unwrap();
                black_box(relations.edges())
            });
        });
        for rule in [RelationRule::Contacts, RelationRule::BoxTrace] {
            group.bench_function(BenchmarkId::new(format!("from nothing, {rule:?}"), objects), |b| {
                b.iter(|| Relations::new(&graph, rule, evidence.clone()).unwrap().edges());
            });
        }
    }
    group.finish();
}

fn moved(c: &mut Criterion<Cpu>) {
    let mut group = c.benchmark_group("update");
    for objects in SIZES {
        let (mut graph, evidence, ids) = scene(objects);
        let mut relations = Relations::new(&graph, RelationRule::Contacts, evidence).unwrap();
        let mut turn = 0_usize;
        for count in [1, 10, 50] {
            group.bench_function(BenchmarkId::new(format!("{count} moved"), objects), |b| {
                b.iter_custom(|rounds| {
                    let mut spent = std::time::Duration::ZERO;
                    for _ in 0..rounds {
                        let batch: Vec<NodeId> = (0..count).map(|k| ids[(turn + k * 7) % ids.len()]).collect();
                        nudge(&mut graph, &batch, turn);
                        turn += 1;
                        let start = ThreadTime::now();
                        black_box(relations.update(&graph, &batch).unwrap());
                        for &id in &batch {
                            black_box(relations.edges_of(id));
                        }
                        spent += start.elapsed();
                    }
                    spent
                });
            });
        }
    }
    group.finish();
}

/// Moves objects back and forth by a centimetre.
fn nudge(graph: &mut SceneGraph, ids: &[NodeId], turn: usize) {
    let mut edit = graph.edit();
    for &id in ids {
        let mut pose: Pose = *edit.graph().node(id).unwrap().pose().unwrap();
        pose.translation.x += if (turn / 100).is_multiple_of(2) { 0.01 } else { -0.01 };
        edit.set_pose(id, Some(pose)).unwrap();
    }
    edit.commit();
}

/// The parts of every object as engine shapes, with their boxes.
struct Engine {
    shapes: Vec<(EnginePose, Compound, Vector3<f32>, Vector3<f32>)>,
    wholes: Vec<(EnginePose, Cuboid)>,
}

fn engine_pose(pose: &Pose) -> EnginePose {
    let (at, turn) = (pose.translation.vector, pose.rotation);
    (EngineVector::new(at.x, at.y, at.z), EngineRotation::from_xyzw(turn.i, turn.j, turn.k, turn.w)).into()
}

impl Engine {
    fn new(graph: &SceneGraph) -> Self {
        let (mut shapes, mut wholes) = (Vec::new(), Vec::new());
        for node in graph.nodes() {
            let Some(asset) = node.spec().asset.and_then(|a| graph.assets().get(a)) else { continue };
            let pose = *node.pose().unwrap();
            let cuboid = |half: Vector3<f32>| Cuboid::new(EngineVector::new(half.x, half.y, half.z));
            let part = |part: &vc_graph::asset::Part| {
                let (low, high) = part.extent();
                let centre = nalgebra::center(&low, &high);
                (
                    engine_pose(&Pose::translation(centre.x, centre.y, centre.z)),
                    SharedShape::new(cuboid((high - low) / 2.0)),
                )
            };
            let (low, high) = asset.extent().unwrap();
            let half = (high - low) / 2.0;
            let centre = pose
                * Pose::from_parts(nalgebra::center(&low, &high).coords.into(), nalgebra::UnitQuaternion::identity());
            let reach = pose.rotation.to_rotation_matrix().matrix().abs() * half;
            let at = centre.translation.vector;
            shapes.push((
                engine_pose(&pose),
                Compound::new(asset.parts.iter().map(part).collect()),
                at - reach,
                at + reach,
            ));
            wholes.push((engine_pose(&centre), cuboid(half)));
        }
        Self { shapes, wholes }
    }

    /// Casts the six traces of every object as shapes in the engine, after a check of boxes.
    fn trace_all(&self) -> usize {
        let mut hits = 0;
        for (index, (pose, whole)) in self.wholes.iter().enumerate() {
            let ways: [(Vector3<f32>, f32); 6] = [
                (Vector3::x(), 1.0),
                (-Vector3::x(), 1.0),
                (Vector3::y(), 1.0),
                (-Vector3::y(), 1.0),
                (Vector3::z(), 3.0),
                (-Vector3::z(), 3.0),
            ];
            for (way, limit) in ways {
                let (low, high) = (self.shapes[index].2, self.shapes[index].3);
                let (low, high) = (low.inf(&(low + way * limit)), high.sup(&(high + way * limit)));
                let mut best = limit;
                for (other, (at, shape, l, h)) in self.shapes.iter().enumerate() {
                    if other == index || (0..3).any(|k| l[k] > high[k] || h[k] < low[k]) {
                        continue;
                    }
                    let velocity = EngineVector::new(way.x, way.y, way.z);
                    let options = ShapeCastOptions { max_time_of_impact: best, ..ShapeCastOptions::default() };
                    let hit = cast_shapes(pose, velocity, whole, at, EngineVector::ZERO, shape, options).unwrap();
                    hit.into_iter().for_each(|hit| best = best.min(hit.time_of_impact));
                }
                hits += usize::from(best < limit);
            }
        }
        hits
    }
}

fn beside(c: &mut Criterion<Cpu>) {
    let engine = Engine::new(&scene(500).0);
    c.bench_function("engine shape casts, the thesis's rule, 500 objects", |b| {
        b.iter(|| black_box(engine.trace_all()))
    });
}

fn main() {
    let mut page = Page::new("relations");
    let quick = Criterion::default().sample_size(20).measurement_time(std::time::Duration::from_secs(2));
    let mut criterion = quick.with_measurement(Cpu).configure_from_args();
    [all, moved, beside].into_iter().for_each(|bench| bench(&mut criterion));
    criterion.final_summary();
    page.criterion();
    page.finish();
}
