//! Costs of city plans: a square kilometre, and the area of Epic's City Sample, 15.8 km². Each time is the best of five on one
//! thread, since the machine may be busy with other things; the bar for the large one is 5 s and 400 MB. The memory is the most
//! that was asked for at once while the plan was made. `cargo bench -p vc-procgen --bench plans`

#![allow(missing_docs, clippy::unwrap_used, reason = "benches stop where something is wrong")]

use std::hint::black_box;
use std::time::Instant;

use vc_graph::Seed;
use vc_procgen::city::{CityPlan, CitySpecification};
use vc_testkit::page::{Page, time};

const AREAS: [f64; 2] = [1.0, 15.8];
const REPEATS: u64 = 5;

/// The result of some work, and the seconds that it took.
fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let begun = Instant::now();
    let made = black_box(work());
    (made, begun.elapsed().as_secs_f64())
}

/// The most memory that the process has held, megabytes, where the system tells.
fn peak() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    Some(line.split_whitespace().nth(1)?.parse::<f64>().ok()? / 1000.0)
}

fn row(area: f64) -> Vec<String> {
    let wishes = CitySpecification { area, ..CitySpecification::default() };
    let made = (0..REPEATS).map(|seed| timed(|| CityPlan::generate(&wishes, Seed(seed)).unwrap()));
    let (plan, best) = made.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
    let memory = peak().map_or("not told".to_owned(), |megabytes| format!("{megabytes:.0} MB"));
    let (_, checked) = timed(|| plan.violations());
    let count = |storey: usize| plan.buildings().iter().map(|building| building.units(storey).len()).sum::<usize>();
    let (units, asked) = timed(|| count(1));
    let outdoors = plan.items().len() + plan.cars().len() + plan.trees().len();
    let objects = plan.buildings().len() + outdoors;
    vec![
        format!("{area} km²"),
        plan.map().junctions().len().to_string(),
        plan.buildings().len().to_string(),
        outdoors.to_string(),
        plan.cars().len().to_string(),
        time(best),
        memory,
        format!("{:.0}", objects as f64 / best),
        time(checked),
        time(asked / units as f64),
    ]
}

fn main() {
    let mut page = Page::new("plans");
    let head = [
        "plan",
        "junctions",
        "buildings",
        "things outdoors",
        "of them cars",
        "made",
        "memory",
        "objects a second",
        "rules checked",
        "a unit",
    ];
    page.table(&head, &AREAS.map(row));
    page.finish();
}
