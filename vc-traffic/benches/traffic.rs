//! Costs of traffic: steps of a tenth of a second on a grid of 30 by 30 junctions with lights, 200 m apart, two lanes in each
//! direction, with some 1,000 and some 10,000 vehicles on the road.
//!
//! All set out within the first part of the run; times are those of the steps after it, with a core to itself if the machine has
//! one. `cargo bench -p vc-traffic --bench traffic`

#![allow(missing_docs, clippy::unwrap_used, reason = "benches stop where something is wrong")]

#[path = "../tests/traffic/grid.rs"]
mod grid;

use std::time::Instant;

use vc_graph::Seed;
use vc_map::{Control, DrivingSide};
use vc_testkit::page::{Page, time};
use vc_traffic::{Traffic, TrafficOptions};

/// Steps in which vehicles set out, and those that are timed.
const BEFORE: usize = 2100;
const TIMED: usize = 600;

fn main() {
    let map = grid::grid(30, 2, Control::Signals, DrivingSide::Right);
    let mut rows = Vec::new();
    for trips in [1_200, 11_500] {
        let demand = grid::trips(&map, trips, 200.0, &[0], Seed(7));
        let mut traffic = Traffic::new(&map, demand, &TrafficOptions::default(), Seed(1)).unwrap();
        (0..BEFORE).for_each(|_| traffic.step());
        let vehicles = traffic.len();
        let begun = Instant::now();
        let mut steps = 0;
        for _ in 0..TIMED {
            steps += traffic.len();
            traffic.step();
        }
        let seconds = begun.elapsed().as_secs_f64();
        let standing = traffic.vehicles().filter(|(_, pose)| pose.speed < 0.1).count() as f64 / traffic.len() as f64;
        rows.push(vec![
            vehicles.to_string(),
            time(seconds / TIMED as f64),
            format!("{:.1} million", steps as f64 / seconds / 1e6),
            format!("{:.0} times", TIMED as f64 * 0.1 / seconds),
            format!("{:.0} %", standing * 100.0),
        ]);
    }
    let mut page = Page::new("traffic");
    page.table(&["vehicles", "a step", "vehicle steps a second", "of real time", "stand still"], &rows);
    page.finish();
}
