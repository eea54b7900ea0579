//! Costs of traffic: steps of a tenth of a second on a grid of 30 by 30 junctions with lights, 200 m apart, two lanes in each
//! direction, with some 1,000 and some 10,000 vehicles on the road; people on foot: 10,000 on ways, and some on a grid of 10 by 10
//! junctions with pavements, crossings and houses; and the timetable of 10,000 people there: a day, and asking for everybody.
//!
//! All set out within the first part of the run; times are those of the steps after it, with a core to itself if the machine has
//! one. `cargo bench -p vc-traffic --bench traffic`

#![allow(missing_docs, clippy::unwrap_used, reason = "benches stop where something is wrong")]

#[path = "../tests/traffic/grid.rs"]
mod grid;

use std::sync::Arc;
use std::time::Instant;

use vc_graph::Seed;
use vc_graph::clock::Tick;
use vc_map::{Control, DrivingSide, Polyline};
use vc_testkit::page::{Page, time};
use vc_traffic::{Crowd, Demand, LandUse, PersonId, Timetable, TimetableOptions, Traffic, TrafficOptions, Walker, Way};

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
    let mut rows: Vec<_> = [0.15, 0.5, 1.0, 2.0].map(crowd).into();
    rows.push(town());
    page.table(&["people", "a step", "for each", "of real time"], &rows);
    page.table(&["a day of", "to make", "places of all at 3:00", "7:45", "17:00"], &[timetable()]);
    page.finish();
}

/// Steps of people that are timed, and those before.
const WALKED: usize = 100;

fn row(name: String, people: usize, seconds: f64) -> Vec<String> {
    let step = seconds / WALKED as f64;
    vec![name, time(step), time(step / people as f64), format!("{:.0} times", 0.1 / step)]
}

/// Ten thousand people of a density, half of them each way, on twenty paths of 4 m.
fn crowd(density: f32) -> Vec<String> {
    const PEOPLE: u32 = 10_000;
    let length = PEOPLE as f32 / density / 80.0;
    let mut crowd = Crowd::new(0.1);
    let mut numbers = Seed(7).stream();
    let ways: Vec<Arc<Way>> = (0..20)
        .flat_map(|path| {
            let y = f64::from(path) * 10.0;
            let line = Polyline::new([[0.0, y], [f64::from(length) + 60.0, y]]).unwrap();
            [line.clone(), line.reversed()].map(|line| Arc::new(Way::new([(line, 4.0)]).unwrap()))
        })
        .collect();
    let mut id = 0;
    while id < PEOPLE {
        let way = ways[numbers.below(ways.len())].clone();
        let (station, left) = (30.0 + numbers.between(0.0, length), numbers.between(-1.8, 1.8));
        let speed = numbers.normal(1.34, 0.26).clamp(0.6, 2.0);
        id += u32::from(crowd.add(Walker::new(PersonId(id), way, station, left, speed)));
    }
    (0..50).for_each(|_| crowd.step());
    let begun = Instant::now();
    (0..WALKED).for_each(|_| crowd.step());
    row(format!("10,000, {density} a square metre"), PEOPLE as usize, begun.elapsed().as_secs_f64())
}

/// People on a map, without vehicles.
fn town() -> Vec<String> {
    let map = grid::town(10, 1, Control::Signals, DrivingSide::Right);
    let traffic = Traffic::new(&map, Vec::new(), &TrafficOptions::default(), Seed(1)).unwrap();
    let mut traffic = traffic.with_walks(grid::walks(&map, 10_000, 120.0, Seed(7))).unwrap();
    (0..1300).for_each(|_| traffic.step());
    let people = traffic.people().count();
    let begun = Instant::now();
    (0..WALKED).for_each(|_| traffic.step());
    row(format!("{people} on a map"), people, begun.elapsed().as_secs_f64())
}

/// A day of ten thousand people on a map, made and asked for.
fn timetable() -> Vec<String> {
    const PEOPLE: u32 = 10_000;
    const KINDS: [&str; 6] = ["apartments", "house", "office", "apartments", "retail", "school"];
    let mut draft = grid::town(10, 2, Control::Signals, DrivingSide::Right).draft().clone();
    let houses = draft.buildings.iter_mut().enumerate();
    houses.for_each(|(number, building)| building.kind = KINDS[number % KINDS.len()].to_owned());
    let map = draft.build().unwrap();
    let demand = Demand::of_land_use(&map, &LandUse::default(), PEOPLE as usize, Seed(7));
    let options = TimetableOptions { days: 1, ..TimetableOptions::default() };
    let begun = Instant::now();
    let timetable = Timetable::new(&map, &demand, &options, Seed(7)).unwrap();
    let made = begun.elapsed().as_secs_f64();
    let asked = [3.0, 7.75, 17.0].map(|hours| {
        let tick = Tick((hours * 3600.0 * 60.0) as u64);
        let begun = Instant::now();
        let found = (0..PEOPLE).filter(|person| timetable.place_at(PersonId(*person), tick).is_some()).count();
        assert_eq!(found, PEOPLE as usize);
        time(begun.elapsed().as_secs_f64())
    });
    [vec![format!("{PEOPLE} people"), time(made)], asked.to_vec()].concat()
}
