//! Reading BEHAVIOR's activities: all 1,016 of bddl 3.6.0, from texts in memory.
//!
//! `VC_BDDL=FOLDER cargo bench -p vc-tasks --bench parse`, where the folder holds the
//! unpacked package. The package's own parser takes 64 ms for the same texts
//! (`parse_problem`, CPython 3.11), 45 to 114 ms to compile the goals.

#[path = "support/activities.rs"]
mod activities;

use std::hint::black_box;

use criterion::{Criterion, Throughput};
use vc_graph::goal::Pairing;
use vc_tasks::format::bddl::{ActivityDefinition, Facts};
use vc_tasks::lint;
use vc_testkit::page::Page;

fn main() {
    let Some(texts) = activities::texts() else { return };
    let mut page = Page::new("parse");
    let mut criterion = Criterion::default().configure_from_args();
    let mut group = criterion.benchmark_group(format!("{} activities", texts.len()));
    group.throughput(Throughput::Bytes(texts.iter().map(|t| t.len() as u64).sum()));
    group.bench_function("read", |b| {
        b.iter(|| texts.iter().filter_map(|t| ActivityDefinition::read(black_box(t)).ok()).count())
    });
    let activities: Vec<ActivityDefinition> = texts.iter().filter_map(|t| ActivityDefinition::read(t).ok()).collect();
    assert_eq!(activities.len(), texts.len(), "all texts are activities");
    group.bench_function("goals", |b| b.iter(|| activities.iter().filter_map(|a| a.to_goal().ok()).count()));
    group.bench_function("ground facts", |b| {
        b.iter(|| activities.iter().filter_map(|a| Facts::from_activity(a, Pairing::Matching).ok()).count())
    });
    group.bench_function("lint", |b| b.iter(|| activities.iter().map(|a| lint::activity(a).len()).sum::<usize>()));
    group.finish();
    criterion.final_summary();
    page.criterion();
    page.finish();
}
