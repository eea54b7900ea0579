//! Reading BEHAVIOR's activities: all 1,016 of bddl 3.6.0, from texts in memory.
//!
//! `VC_BDDL=FOLDER cargo bench -p vc-tasks --bench parse`, where the folder holds the
//! unpacked package. The package's own parser takes 64 ms for the same texts
//! (`parse_problem`, CPython 3.11), 45 to 114 ms to compile the goals.

use std::hint::black_box;
use std::path::Path;

use criterion::{Criterion, Throughput};
use vc_graph::goal::Pairing;
use vc_tasks::format::bddl::{Activity, Facts};
use vc_tasks::lint;

fn main() {
    let Some(folder) = std::env::var_os("VC_BDDL") else {
        eprintln!("SKIPPED: set VC_BDDL to where the PyPI package bddl 3.6.0 is unpacked");
        return;
    };
    let mut texts = Vec::new();
    collect(Path::new(&folder), &mut texts);
    texts.retain(|text| text.contains("(:domain omnigibson)"));
    let mut criterion = Criterion::default().configure_from_args();
    let mut group = criterion.benchmark_group(format!("{} activities", texts.len()));
    group.throughput(Throughput::Bytes(texts.iter().map(|t| t.len() as u64).sum()));
    group.bench_function("read", |b| b.iter(|| texts.iter().filter_map(|t| Activity::read(black_box(t)).ok()).count()));
    let activities: Vec<Activity> = texts.iter().filter_map(|t| Activity::read(t).ok()).collect();
    assert_eq!(activities.len(), texts.len(), "all texts are activities");
    group.bench_function("goals", |b| b.iter(|| activities.iter().filter_map(|a| a.to_goal().ok()).count()));
    group.bench_function("ground facts", |b| {
        b.iter(|| activities.iter().filter_map(|a| Facts::of(a, Pairing::Matching).ok()).count())
    });
    group.bench_function("lint", |b| b.iter(|| activities.iter().map(|a| lint::activity(a).len()).sum::<usize>()));
    group.finish();
    criterion.final_summary();
}

fn collect(folder: &Path, texts: &mut Vec<String>) {
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten().map(|e| e.path()) {
        let name = entry.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if entry.is_dir() {
            collect(&entry, texts);
        } else if name.starts_with("problem") && name.ends_with(".bddl") {
            texts.extend(std::fs::read_to_string(&entry));
        }
    }
}
