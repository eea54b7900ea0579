//! People and vehicles on one map: crossings, lights, doors.

use std::collections::BTreeMap;

use vc_graph::Seed;
use vc_map::{Control, CrossingId, DrivingSide, EntranceId, JunctionId, LaneId, Light, Point, StreetMap, Users};
use vc_traffic::{PersonId, Traffic, TrafficError, TrafficEvent, TrafficOptions, Walk, Walker};

use crate::grid::{grid, town, trips, walks};
use crate::people::{hit, overlap};

/// The radius of a body, metres, and what rounding may add.
const RADIUS: f64 = 0.2;
const ROUNDING: f64 = 0.01;

/// Everything that happened.
#[derive(Debug, Default)]
struct Seen {
    set_off: usize,
    reached: usize,
    no_walk: usize,
    arrived: usize,
    no_way: usize,
    crossed: usize,
    longest_wait: f32,
}

fn point(walker: &Walker) -> Point {
    Point::new(f64::from(walker.at[0]), f64::from(walker.at[1]))
}

/// The crossing on which somebody is, by its line and width.
fn crossing(map: &StreetMap, at: &Point) -> Option<CrossingId> {
    let over = |(_, crossing): &(usize, &vc_map::RoadCrossing)| {
        let near = crossing.line.project(at);
        (near.point - at).norm() < crossing.width / 2.0 + ROUNDING
    };
    map.crossings().iter().enumerate().find(over).map(|(number, _)| CrossingId(number as u32))
}

/// The lane for vehicles on which somebody stands with a part of their body.
fn lane_under(map: &StreetMap, at: &Point) -> Option<LaneId> {
    let (id, _) = map.lane_near(at, Users::CAR, 5.0)?;
    let lane = map.lane(id)?;
    let near = lane.line.project(at);
    let beside = near.station > 0.0 && near.station < lane.line.length();
    (beside && near.left.abs() < lane.width / 2.0 + RADIUS - 3.0 * ROUNDING).then_some(id)
}

/// The light for people at a crossing at a time.
fn light(map: &StreetMap, id: CrossingId, seconds: f64) -> Option<Light> {
    let junction = map.junction(map.crossing(id)?.junction)?;
    let signal = map.signal(junction.signal?)?;
    let row = junction.movements.len() + junction.crossings.iter().position(|other| *other == id)?;
    let mut left = seconds.rem_euclid(signal.cycle());
    let shows = signal.phases.iter().find(|phase| {
        left -= phase.seconds;
        left < 0.0
    });
    shows?.lights.get(row).copied()
}

/// Steps until nobody is left, at most so often, and looks at every step.
fn run(traffic: &mut Traffic, steps: usize) -> Seen {
    let map = traffic.map().clone();
    let mut seen = Seen::default();
    // Those who were on a carriageway, and for how long somebody has stood.
    let mut over: BTreeMap<PersonId, CrossingId> = BTreeMap::new();
    let mut stood: BTreeMap<PersonId, f32> = BTreeMap::new();
    for step in 0..steps {
        let seconds = traffic.seconds();
        traffic.step();
        assert_eq!(traffic.overlaps(), [], "step {step}");
        assert_eq!(overlap(traffic.people().map(|walker| walker.at)), None, "step {step}");
        assert_eq!(hit(traffic), None, "step {step}");
        let mut now = BTreeMap::new();
        for walker in traffic.people() {
            let at = point(&walker);
            if lane_under(&map, &at).is_some() {
                let Some(on) = crossing(&map, &at) else { panic!("step {step}: {} on the road at {at}", walker.id) };
                if !over.contains_key(&walker.id) {
                    seen.crossed += 1;
                    assert!(light(&map, on, seconds) != Some(Light::Red), "step {step}: {} at red at {at}", walker.id);
                }
                now.insert(walker.id, on);
            } else if let Some(on) = over.get(&walker.id).filter(|on| crossing(&map, &at) == Some(**on)) {
                // Between the kerb and the end of the crossing one may be pushed back.
                now.insert(walker.id, *on);
            }
            let speed = walker.velocity[0].abs() + walker.velocity[1].abs();
            let stands = stood.entry(walker.id).or_default();
            *stands = if speed < 0.05 { *stands + 0.1 } else { 0.0 };
            seen.longest_wait = seen.longest_wait.max(*stands);
        }
        over = now;
        for event in traffic.events() {
            match event {
                TrafficEvent::SetOff { .. } => seen.set_off += 1,
                TrafficEvent::Reached { .. } => seen.reached += 1,
                TrafficEvent::StuckOnFoot { person } => panic!("step {step}: {person}"),
                TrafficEvent::NoWalk { .. } => seen.no_walk += 1,
                TrafficEvent::Arrived { .. } => seen.arrived += 1,
                TrafficEvent::NoWay { .. } => seen.no_way += 1,
                TrafficEvent::Stuck { vehicle, reason } => {
                    panic!("step {step}: {vehicle} {reason:?} {:?}", traffic.vehicle(*vehicle))
                }
                _ => {}
            }
        }
        let empty = traffic.is_empty() && traffic.people().next().is_none();
        if empty && traffic.waiting() + traffic.waiting_on_foot() == 0 {
            break;
        }
    }
    seen
}

fn with_people(map: &StreetMap, vehicles: usize, people: usize, seconds: f32) -> Traffic {
    let cars = trips(map, vehicles, seconds, &[0, 0, 1, 4], Seed(7));
    let traffic = Traffic::new(map, cars, &TrafficOptions::default(), Seed(1)).unwrap();
    traffic.with_walks(walks(map, people, seconds, Seed(9))).unwrap()
}

#[test]
fn people_and_vehicles_leave_crossings_to_each_other() {
    for control in [Control::Signals, Control::Priority, Control::AllWayStop] {
        for (lanes, side) in [(1, DrivingSide::Right), (2, DrivingSide::Left)] {
            let map = town(2, lanes, control, side);
            assert!(!map.crossings().is_empty());
            let seen = run(&mut with_people(&map, 200, 200, 150.0), 12_000);
            eprintln!("{control:?} {lanes} {side:?}: {seen:?}");
            assert_eq!(
                (seen.reached + seen.no_walk, seen.arrived + seen.no_way),
                (200, 200),
                "{control:?} {lanes}: {seen:?}"
            );
            assert!(seen.reached > 180 && seen.crossed > 200, "{control:?} {lanes}: {seen:?}");
            assert!(seen.longest_wait < 150.0, "{control:?} {lanes}: {seen:?}");
        }
    }
}

#[test]
fn the_same_seed_gives_the_same_people_and_copies_go_on_alike() {
    let map = town(2, 1, Control::Signals, DrivingSide::Right);
    let [mut first, mut second] = [(); 2].map(|()| with_people(&map, 80, 120, 60.0));
    (0..900).for_each(|_| first.step());
    // On another thread, too.
    let mut second = std::thread::spawn(move || {
        (0..900).for_each(|_| second.step());
        second
    })
    .join()
    .unwrap();
    assert_eq!(first.digest(), second.digest());
    let mut copy = second.clone();
    for traffic in [&mut first, &mut second, &mut copy] {
        (0..300).for_each(|_| traffic.step());
    }
    assert_eq!([first.digest(), second.digest()], [copy.digest(); 2]);
}

#[test]
fn walks_from_doors_that_there_are_not_are_refused() {
    let map = grid(1, 1, Control::Priority, DrivingSide::Right);
    let of = |walk| {
        let traffic = Traffic::new(&map, Vec::new(), &TrafficOptions::default(), Seed(1)).unwrap();
        traffic.with_walks(vec![walk]).err()
    };
    let walk = Walk { departs: 0.0, from: EntranceId(0), to: EntranceId(7) };
    let error: Option<TrafficError> = of(walk);
    assert_eq!(error.map(|error| error.to_string()).as_deref(), Some("person 0: entrance 0 of 0"));
    let map = town(1, 1, Control::Priority, DrivingSide::Right);
    let traffic = Traffic::new(&map, Vec::new(), &TrafficOptions::default(), Seed(1)).unwrap();
    let error = traffic.with_walks(vec![Walk { departs: f32::NAN, ..walk }]).err();
    assert_eq!(
        error.map(|error| error.to_string()).as_deref(),
        Some("person 0: departs at NaN s: give a time from 0 on")
    );
    assert!(map.junction(JunctionId(0)).is_some());
}
