//! The rules that vehicles keep on maps of every kind of junction.

use std::collections::BTreeMap;

use vc_graph::Seed;
use vc_map::osm::{ImportOptions, OsmData};
use vc_map::{Control, DrivingSide, Light, MovementId, RoadId};
use vc_traffic::{Kerb, Pose, Traffic, TrafficError, TrafficEvent, TrafficOptions, Trip, VehicleClass, VehicleId};

use crate::grid::{grid, trips};

const RIVERSIDE: &str = include_str!("../../../vc-map/data/riverside.osm");

fn traffic(map: &vc_map::StreetMap, trips: Vec<Trip>) -> Traffic {
    Traffic::new(map, trips, &TrafficOptions::default(), Seed(1)).unwrap()
}

/// The light that shows for a movement at a time, by the map's signals.
fn light(traffic: &Traffic, movement: MovementId, seconds: f64) -> Option<Light> {
    let map = traffic.map();
    let junction = map.junction(map.movement(movement)?.junction)?;
    let signal = map.signal(junction.signal?)?;
    let row = junction.movements.iter().position(|id| *id == movement)?;
    let mut left = seconds.rem_euclid(signal.cycle());
    let shows = signal.phases.iter().find(|phase| {
        left -= phase.seconds;
        left < 0.0
    });
    shows?.lights.get(row).copied()
}

/// Steps until nobody is left, at most so often; looks at every step, and tells how many arrived and how many have no way.
fn run(traffic: &mut Traffic, steps: usize) -> [usize; 2] {
    let mut counts = [0; 2];
    // When each came over its line, seconds.
    let mut over: BTreeMap<VehicleId, f64> = BTreeMap::new();
    for step in 0..steps {
        let before: BTreeMap<VehicleId, Pose> = traffic.vehicles().collect();
        let seconds = traffic.seconds();
        traffic.step();
        let overlaps: Vec<_> =
            traffic.overlaps().into_iter().map(|(a, b)| [traffic.vehicle(a), traffic.vehicle(b)]).collect();
        assert!(overlaps.is_empty(), "step {step}: {overlaps:?}");
        for (id, pose) in traffic.vehicles() {
            let Some(was) = before.get(&id) else { continue };
            if let Some(lane) = was.lane.and_then(|lane| traffic.map().lane(lane)) {
                let line = lane.stop_line.unwrap_or(lane.line.length()) as f32;
                if was.station <= line && (pose.movement.is_some() || pose.station > line) {
                    over.insert(id, seconds);
                }
            }
            // Those who go over the junction at red came over its line before.
            let entered = pose.movement.filter(|_| was.lane.is_some()).zip(over.get(&id));
            let red = |(movement, line): (MovementId, &f64)| {
                [*line, seconds].iter().all(|seconds| light(traffic, movement, *seconds) == Some(Light::Red))
            };
            assert!(!entered.is_some_and(red), "step {step}: {id} {pose:?}");
        }
        for event in traffic.events() {
            match event {
                TrafficEvent::Arrived { .. } => counts[0] += 1,
                TrafficEvent::NoWay { .. } => counts[1] += 1,
                TrafficEvent::Stuck { vehicle, reason } => {
                    panic!("step {step}: {vehicle} {reason:?} {:?}", traffic.vehicle(*vehicle))
                }
                _ => {}
            }
        }
        if traffic.is_empty() && traffic.waiting() == 0 {
            break;
        }
    }
    counts
}

#[test]
fn all_arrive_none_overlap_and_none_goes_at_red() {
    for control in [Control::Signals, Control::Priority, Control::AllWayStop] {
        for (lanes, side) in
            [(1, DrivingSide::Right), (2, DrivingSide::Right), (2, DrivingSide::Left), (3, DrivingSide::Right)]
        {
            let map = grid(2, lanes, control, side);
            let trips = trips(&map, 100 * lanes, 200.0, &[0, 0, 1, 4], Seed(7));
            let count = trips.len();
            eprintln!("{control:?} {lanes} {side:?}");
            let [arrived, no_way] = run(&mut traffic(&map, trips), 20_000);
            assert!(
                arrived + no_way == count && arrived > count / 3,
                "{control:?} {lanes} {side:?}: {arrived} {no_way} of {count}"
            );
        }
    }
}

#[test]
fn a_full_grid_empties() {
    // For a while everybody at its middle has waited for more than a minute, and all give way to each other.
    let map = grid(3, 2, Control::Priority, DrivingSide::Right);
    let trips = trips(&map, 900, 300.0, &[0], Seed(4));
    let [arrived, no_way] = run(&mut traffic(&map, trips), 12_000);
    assert!(arrived + no_way == 900 && arrived > 400, "{arrived} {no_way}");
}

#[test]
fn a_town_is_driven_through() {
    // Bridges, a roundabout, dual carriageways, tracks, one-way streets, dead ends.
    let draft = OsmData::from_xml(RIVERSIDE.as_bytes()).unwrap().draft(&ImportOptions::default()).unwrap().0;
    let map = draft.build().unwrap();
    let trips = trips(&map, 300, 300.0, &[0], Seed(3));
    let [arrived, no_way] = run(&mut traffic(&map, trips), 12_000);
    assert!(arrived + no_way == 300 && no_way < 40, "{arrived} {no_way}");
}

#[test]
fn the_same_seed_gives_the_same_state_and_copies_go_on_alike() {
    let map = grid(2, 2, Control::Signals, DrivingSide::Right);
    let demand = trips(&map, 150, 100.0, &[0, 1], Seed(5));
    let mut first = traffic(&map, demand.clone());
    let mut second = traffic(&map, demand.clone());
    (0..800).for_each(|_| first.step());
    (0..800).for_each(|_| second.step());
    assert_eq!(first.digest(), second.digest());
    let mut copy = first.clone();
    (0..500).for_each(|_| copy.step());
    (0..500).for_each(|_| first.step());
    assert_eq!(first.digest(), copy.digest());
    let mut other = Traffic::new(&map, demand, &TrafficOptions::default(), Seed(2)).unwrap();
    (0..1300).for_each(|_| other.step());
    assert_ne!(first.digest(), other.digest());
}

/// The times at which vehicles that queue at a light come over its line, by the second of its cycle in which they do.
fn discharge(class: u8) -> Vec<f64> {
    let map = grid(1, 1, Control::Signals, DrivingSide::Right);
    let from = map.lanes().iter().find(|lane| lane.line.start().x < 1.0 && lane.line.direction(0.0).x > 0.9).unwrap();
    let to = map.lanes().iter().find(|lane| lane.line.end().x > 399.0 && lane.line.direction(0.0).x > 0.9).unwrap();
    let kerb = |lane: &vc_map::Lane, station| Kerb { road: lane.road, forward: lane.forward, station };
    let trip = Trip { class, departs: 0.0, from: kerb(from, 20.0), to: kerb(to, 150.0) };
    let mut traffic = traffic(&map, vec![trip; 200]);
    let mut times = Vec::new();
    for _ in 0..9000 {
        let before: BTreeMap<VehicleId, Pose> = traffic.vehicles().collect();
        traffic.step();
        let entered = |(id, pose): (VehicleId, Pose)| {
            pose.movement.is_some() && before.get(&id).is_some_and(|p| p.lane.is_some())
        };
        times.extend(traffic.vehicles().filter(|vehicle| entered(*vehicle)).map(|_| traffic.seconds()));
    }
    times
}

#[test]
fn queues_discharge_as_in_streets() {
    // Saturation flow of cars is 1,700 to 1,900 an hour (Highway Capacity Manual): 1.9 to 2.1 s between those behind the fourth.
    let times = discharge(0);
    let gaps: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let mut steady: Vec<f64> = gaps.split(|gap| *gap > 6.0).flat_map(|green| green.iter().copied().skip(4)).collect();
    steady.sort_by(f64::total_cmp);
    let median = steady[steady.len() / 2];
    assert!((1.8..2.2).contains(&median), "{median} {}", steady.len());
}

#[test]
fn what_cannot_be_is_refused_with_its_reason() {
    let map = grid(1, 1, Control::Priority, DrivingSide::Right);
    let kerb = Kerb { road: RoadId(0), forward: true, station: 50.0 };
    let trip = Trip { class: 0, departs: 0.0, from: kerb, to: kerb };
    let with = |trip, options: &TrafficOptions| {
        Traffic::new(&map, vec![trip], options, Seed(1)).err().map(|error| error.to_string())
    };
    let usual = TrafficOptions::default();
    let faults = [
        (Trip { class: 9, ..trip }, "vehicle 0: kind of vehicle 9 of 5"),
        (Trip { departs: f32::NAN, ..trip }, "vehicle 0: departs at NaN s: give a time from 0 on"),
        (
            Trip { to: Kerb { road: RoadId(99), ..kerb }, ..trip },
            "vehicle 0: no lane for vehicles on that side of road 99",
        ),
        (Trip { from: Kerb { station: f32::INFINITY, ..kerb }, ..trip }, "vehicle 0: station inf m on road 0"),
    ];
    for (trip, reason) in faults {
        assert_eq!(with(trip, &usual).as_deref(), Some(reason));
    }
    let step = |step| with(trip, &TrafficOptions { step, ..TrafficOptions::default() });
    assert!([0.0, f32::NAN, 5.0].into_iter().all(|seconds| step(seconds).is_some()) && step(0.5).is_none());
    let empty = TrafficOptions { classes: Vec::new(), ..TrafficOptions::default() };
    assert!(matches!(Traffic::new(&map, Vec::new(), &empty, Seed(1)), Err(TrafficError::Classes(0))));
    for (text, reason) in [
        ("car 1.0 car", "line 1 of the table of vehicles: 1 numbers, and nine are needed"),
        (
            "\n# x\ncar 1 0 x 1 2 1 2 4 1.8 car",
            "line 3 of the table of vehicles: the top speed `x` is no number from 0.5 to 100",
        ),
        ("car 1 0 40 1 2 1 2 4 1.8 boat", "line 1 of the table of vehicles: users `boat` are neither `car` nor `bus`"),
    ] {
        let error = VehicleClass::read(text).err().map(|error| error.to_string());
        assert_eq!(error.as_deref(), Some(reason));
    }
}
