//! What homes cost: plans, furniture, everything, the check, the scene graph, and
//! objects.
//!
//! Every iteration makes a few homes of neighbouring seeds, so that a figure is a mean
//! over small and large ones; `benches/README.md` has the peers' figures.

#![allow(missing_docs, clippy::unwrap_used, reason = "benches stop where something is wrong")]

use std::hint::black_box;

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use virtualcity::graph::Seed;
use virtualcity::procgen::plan::Plan;
use virtualcity::procgen::{Apartment, Layout, Specification, Style, object};

/// Homes of one iteration.
const HOMES: u64 = 16;

fn homes(c: &mut Criterion) {
    let (wishes, bare) = (Specification::default(), Specification { clutter: Some(0.0), ..Specification::default() });
    let mut group = c.benchmark_group("sixteen homes");
    group.throughput(Throughput::Elements(HOMES)).sample_size(20);
    let mut over = |name: &str, make: &dyn Fn(Seed)| {
        let mut first = 0;
        group.bench_function(name, |b| {
            b.iter(|| {
                (first..first + HOMES).for_each(|s| make(Seed(s)));
                first += HOMES;
            });
        });
    };
    over("plan", &|seed| drop(black_box(Plan::generate(&wishes, seed))));
    over("layout: plan, furniture, reachability", &|seed| drop(black_box(Layout::generate(&wishes, seed))));
    over("plan, building, furniture, check", &|seed| drop(black_box(Apartment::generate(&bare, seed))));
    over("everything", &|seed| drop(black_box(Apartment::generate(&wishes, seed))));
    group.finish();
}

fn afterwards(c: &mut Criterion) {
    let home = Apartment::from_seed(Seed(42)).unwrap();
    c.bench_function("check a home", |b| b.iter(|| home.check()));
    c.bench_function("scene graph of a home", |b| b.iter_with_large_drop(|| home.scene()));
    c.bench_function("fingerprint of a home", |b| b.iter(|| home.fingerprint()));
    c.bench_function("clone a home", |b| b.iter_batched(|| (), |()| home.clone(), BatchSize::SmallInput));
}

fn objects(c: &mut Criterion) {
    let style = Style::from_seed(Seed(1));
    for class in ["mug", "novel", "chair", "wardrobe", "sofa", "car"] {
        let generator = object::generator(class).unwrap();
        let mut seed = 0;
        c.bench_function(&format!("object: {class}"), |b| {
            b.iter_with_large_drop(|| {
                seed += 1;
                generator.object(&style, Seed(seed))
            });
        });
    }
}

criterion_group!(benches, homes, afterwards, objects);
criterion_main!(benches);
