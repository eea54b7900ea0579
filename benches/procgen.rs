//! Costs of generated homes: plans, furniture, everything, the check, the scene graph, and objects.
//!
//! Every iteration makes a few homes of neighbouring seeds, so that a figure is a mean over small and large
//! ones. Before that, each of 600 seeds is made separately three times, and the smallest of its CPU times
//! counts: median and 95th percentile are over the seeds. `benches/README.md` has the figures of the peers.

#![allow(missing_docs, clippy::unwrap_used, reason = "benches print and stop where something is wrong")]

use std::hint::black_box;
use std::time::Duration;

use cpu_time::ThreadTime;
use criterion::{BatchSize, Criterion, Throughput};
use vc_testkit::page::{Page, time};
use virtualcity::graph::Seed;
use virtualcity::procgen::plan::FloorPlan;
use virtualcity::procgen::{Apartment, Layout, Specification};
use virtualcity::shapes::{Style, object};

/// As in the example `apartment`; with the system's allocator homes take a fifth longer.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// Homes per iteration.
const HOMES: u64 = 16;

/// Number of seeds for the median and the 95th percentile.
const SEEDS: u64 = 600;

fn quantiles(page: &mut Page) {
    let wishes = Specification::default();
    let row = |name: &str, make: &dyn Fn(Seed)| {
        let once = |seed: u64| {
            let start = ThreadTime::now();
            make(Seed(seed));
            start.elapsed()
        };
        let least = |seed: u64| (0..3).map(|_| once(seed)).min().unwrap_or_default();
        let mut times: Vec<Duration> = (0..SEEDS).map(least).collect();
        times.sort_unstable();
        let mean = times.iter().sum::<Duration>() / SEEDS as u32;
        let at = |percent: usize| times[times.len() * percent / 100];
        let figures = [mean, at(50), at(95), times[times.len() - 1]].map(|figure| time(figure.as_secs_f64()));
        [vec![name.to_owned()], figures.to_vec()].concat()
    };
    let rows = [
        row("layout: plan, furniture, reachability", &|seed| drop(black_box(Layout::generate(&wishes, seed)))),
        row("everything", &|seed| drop(black_box(Apartment::generate(&wishes, seed)))),
    ];
    page.table(&["a home, seeds 0 to 599", "mean", "median", "95th percentile", "maximum"], &rows);
}

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
    over("plan", &|seed| drop(black_box(FloorPlan::generate(&wishes, seed))));
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

fn main() {
    let mut page = Page::new("procgen");
    quantiles(&mut page);
    let mut criterion = Criterion::default().configure_from_args();
    [homes, afterwards, objects].into_iter().for_each(|bench| bench(&mut criterion));
    criterion.final_summary();
    page.criterion();
    page.finish();
}
