//! Rays a second on one core, in the home of 300 objects used for timing pictures, and with as many objects in
//! one room, a third of them glass, which has a tree of its own.
//!
//! Run with `cargo bench -p vc-render --bench rays`. Primary rays go through the pixels of sixteen views in
//! order; bounce rays leave the hits of these in cosine-distributed directions; shadow rays go to points of the
//! ceiling. The throughput is in rays of one thread. Finally a tenth of the bodies moves.

#![allow(missing_docs, clippy::unwrap_used, reason = "a bench")]

#[path = "../tests/common/mod.rs"]
mod common;
#[path = "support/home.rs"]
#[allow(dead_code, reason = "only what stands in it is of use here")]
mod home;

use criterion::{Criterion, Throughput};
use nalgebra::{Point3, Vector3};
use vc_graph::{NodeId, Pose, Seed};
use vc_render::{Camera, RayCaster, Renderer, Snapshot};
use vc_testkit::page::Page;

type Ray = (Point3<f32>, Vector3<f32>);

/// Sixteen cameras in the room.
fn cameras() -> Vec<Camera> {
    let view = |i: usize| {
        let (x, y) = (i % 4, i / 4);
        let eye = Point3::new(-2.4 + 1.6 * x as f32, -2.0 + 1.3 * y as f32, 1.6);
        let target = eye + Vector3::new(1.5 - x as f32, 1.5 - y as f32, -0.3);
        Camera::with_fov(160, 120, 1.05).looking(eye, target)
    };
    (0..16).map(view).collect()
}

/// Primary rays through all pixels, in order.
fn primary(cameras: &[Camera]) -> Vec<Ray> {
    let through = |camera: &Camera| {
        let (camera, eye) = (*camera, camera.eye());
        (0..160 * 120).map(move |p| {
            let (across, down) = ((p % 160) as f32 + 0.5, (p / 160) as f32 + 0.5);
            (eye, (camera.unproject(across, down, 1.0) - eye).normalize())
        })
    };
    cameras.iter().flat_map(through).collect()
}

/// Bounce rays from the hits of other rays, in cosine-distributed directions.
fn bounced(caster: &RayCaster, rays: &[Ray]) -> Vec<Ray> {
    let mut chance = Seed(3).stream();
    let mut bounce = |(from, along): &Ray| {
        let hit = caster.first(from, along, 100.0)?;
        let normal = if hit.normal.dot(along) < 0.0 { hit.normal } else { -hit.normal };
        let mut number = || chance.between(-1.0, 1.0);
        let ball = loop {
            let v = Vector3::new(number(), number(), number());
            if (1e-3..1.0).contains(&v.norm()) {
                break v.normalize();
            }
        };
        Some((hit.point + normal * 1e-3, (normal + ball).try_normalize(1e-3).unwrap_or(normal)))
    };
    rays.iter().filter_map(&mut bounce).collect()
}

/// Times rays of all kinds in a scene.
fn rays(c: &mut Criterion, name: &str, snapshot: &Snapshot, cameras: &[Camera]) {
    let caster = RayCaster::new(snapshot);
    let first = primary(cameras);
    let bounces = bounced(&caster, &first);
    let mut group = c.benchmark_group(format!("{name}_{}_triangles", snapshot.triangles()));
    let count = |rays: &[Ray]| rays.iter().filter(|(from, along)| caster.first(from, along, 100.0).is_some()).count();
    group.throughput(Throughput::Elements(first.len() as u64));
    group.bench_function("primary", |b| b.iter(|| count(&first)));
    group.throughput(Throughput::Elements(bounces.len() as u64));
    group.bench_function("bounces", |b| b.iter(|| count(&bounces)));
    let up = |from: &Point3<f32>| Point3::new(0.3, 0.2, 2.4) + Vector3::new(from.x, from.y, 0.0) * 0.1;
    let seen = || bounces.iter().filter(|(from, _)| caster.sees(from, &up(from))).count();
    group.bench_function("shadows", |b| b.iter(seen));
    group.finish();
}

fn home(c: &mut Criterion) {
    let snapshot = Renderer::new().snapshot(&home::home(6, 300).graph).unwrap();
    rays(c, "home", &snapshot, &home::cameras(160, 120));
}

fn room(c: &mut Criterion) {
    let snapshot = Renderer::new().snapshot(&common::crowded(300)).unwrap();
    rays(c, "room", &snapshot, &cameras());
    moving(c, &snapshot);
}

/// Times rays and updates when a tenth of the bodies moves.
fn moving(c: &mut Criterion, snapshot: &Snapshot) {
    let (caster, first) = (RayCaster::new(snapshot), primary(&cameras()));
    let (mut other, mut moved) = (caster, snapshot.clone());
    let bodies: Vec<NodeId> = snapshot.nodes().step_by(10).collect();
    let mut group = c.benchmark_group("tree");
    group.sample_size(10);
    group.bench_function("build", |b| b.iter(|| RayCaster::new(snapshot)));
    let (mut turn, count) = (0.0, bodies.len());
    group.bench_function(format!("follow_{count}_bodies"), |b| {
        b.iter(|| {
            turn += 0.01;
            for (place, body) in (0..).zip(&bodies) {
                let at = Vector3::new(0.15 * place as f32 - 2.2, 0.1 * (place % 30) as f32 - 1.5, 1.2);
                moved.place(*body, &Pose::new(at, Vector3::new(0.0, 0.0, turn))).unwrap();
            }
            other.follow(&moved).unwrap();
        });
    });
    group.throughput(Throughput::Elements(first.len() as u64));
    let count = |rays: &[Ray]| rays.iter().filter(|(from, along)| other.first(from, along, 100.0).is_some()).count();
    group.bench_function("primary_among_moved", |b| b.iter(|| count(&first)));
    group.finish();
}

fn main() {
    let mut page = Page::new("rays");
    let mut criterion = Criterion::default().configure_from_args();
    [home, room].into_iter().for_each(|bench| bench(&mut criterion));
    criterion.final_summary();
    page.criterion();
    page.finish();
}
