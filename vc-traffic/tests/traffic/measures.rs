//! Measures of the field, floating car data, and the timetable held against vehicles that are moved step by step.

use std::collections::BTreeMap;

use vc_graph::Seed;
use vc_graph::clock::Tick;
use vc_map::{Control, DrivingSide, MovementId, RoadId, StreetMap};
use vc_traffic::{
    Demand, Fcd, Measures, Nearness, Timetable, TimetableOptions, Traffic, TrafficEvent, TrafficOptions, VehicleId,
};

use crate::grid::{grid, town, trips, walks};

fn tick(hours: f64) -> Tick {
    Tick((hours * 3600.0 * 60.0) as u64)
}

/// All people drive to a door between eight and nine.
fn rush(map: &StreetMap, people: usize) -> Timetable {
    let (doors, mut numbers) = (map.entrances().len(), Seed(8).stream());
    let week = |_| {
        let [home, to, minute, second, back] = [doors, doors, 60, 60, 60].map(|count| numbers.below(count));
        format!("home {home} car\nmon 08:{minute:02}:{second:02} work {to} car\nmon 22:{back:02} home {home} car\n")
    };
    let table: String = (0..people).map(week).collect();
    let options = TimetableOptions { days: 1, ..TimetableOptions::default() };
    Timetable::new(map, &Demand::read(&table).unwrap(), &options, Seed(1)).unwrap()
}

#[test]
fn the_timetable_agrees_with_vehicles_that_are_moved_step_by_step() {
    for (control, lanes, people) in [
        (Control::Signals, 1, 3000),
        (Control::Signals, 2, 3000),
        (Control::Priority, 1, 1500),
        (Control::AllWayStop, 1, 1500),
    ] {
        let map = town(6, lanes, control, DrivingSide::Right);
        let timetable = rush(&map, people);
        let (trips, on_foot) = timetable.journeys(tick(8.0)..tick(10.0));
        let count = trips.len();
        assert!(count > people / 3 && on_foot.len() + count + people / 20 > people, "{count} {}", on_foot.len());
        let mut traffic = Traffic::new(&map, trips, &TrafficOptions::default(), Seed(1)).unwrap();
        let mut measures = Measures::new(&traffic);
        let mut flows = Vec::new();
        for step in 0..72_000 {
            traffic.step();
            measures.add(&traffic);
            if step == 36_000 {
                flows = (0..map.movements().len()).map(|number| measures.went(MovementId(number as u32))).collect();
            }
        }
        assert!(traffic.is_empty() && traffic.waiting() == 0);
        // By the sides of roads from which they come and to which they go.
        let by_side = |went: Vec<u32>| {
            let mut sums: BTreeMap<_, f64> = BTreeMap::new();
            for (movement, went) in map.movements().iter().zip(went) {
                let [from, to] = [movement.from, movement.to].map(|lane| map.lane(lane).unwrap());
                *sums.entry((from.road, from.forward, to.road)).or_default() += f64::from(went);
            }
            sums
        };
        let (planned, moved) = (by_side(timetable.went(tick(8.0)..tick(9.0))), by_side(flows));
        let busy = moved.iter().filter(|(_, went)| **went >= 20.0);
        let mut off: Vec<f64> = busy.map(|(side, went)| (planned[side] - went).abs() / went).collect();
        off.sort_by(f64::total_cmp);
        assert!(off.len() > 40 && off[off.len() / 2] < 0.05 && off[off.len() * 9 / 10] < 0.15, "{control:?} {off:?}");
        let seconds = |person: u32| -> usize {
            let on = |second: &u64| timetable.vehicle_at(VehicleId(person), Tick(tick(8.0).0 + second * 60)).is_some();
            (0..7200).filter(on).count()
        };
        let planned = (0..people as u32).map(seconds).sum::<usize>() as f64 / count as f64;
        let moved = measures.travel_times().iter().sum::<f32>() as f64 / count as f64;
        assert!((planned / moved - 1.0).abs() < 0.12, "{control:?} {lanes}: {planned} s, {moved} s");
    }
}

#[test]
fn measures_are_those_of_what_vehicles_did() {
    let map = grid(3, 2, Control::Signals, DrivingSide::Right);
    let mut traffic =
        Traffic::new(&map, trips(&map, 500, 600.0, &[0, 0, 1, 4], Seed(5)), &TrafficOptions::default(), Seed(1))
            .unwrap();
    let mut measures = Measures::new(&traffic);
    let (mut went, mut before) = (BTreeMap::new(), BTreeMap::new());
    let mut metres: BTreeMap<RoadId, f64> = BTreeMap::new();
    let mut arrived = Vec::new();
    for _ in 0..9000 {
        traffic.step();
        measures.add(&traffic);
        for (id, pose) in traffic.vehicles() {
            let last = before.insert(id, pose.movement);
            if let Some(movement) = pose.movement.filter(|_| last != Some(pose.movement)) {
                *went.entry(movement).or_insert(0) += 1;
            }
            if let Some(lane) = pose.lane {
                *metres.entry(map.lane(lane).unwrap().road).or_default() += f64::from(pose.speed) * 0.1;
            }
        }
        arrived.extend(traffic.events().iter().filter_map(|event| match event {
            TrafficEvent::Arrived { seconds, .. } => Some(*seconds),
            _ => None,
        }));
    }
    arrived.sort_by(f32::total_cmp);
    assert_eq!(measures.travel_times(), arrived);
    for (id, count) in &went {
        assert_eq!(measures.went(*id), *count, "{id:?}");
    }
    assert!(went.len() > 100);
    let (mut queued, mut late) = (0, 0);
    for (road, metres) in metres {
        let sides = [true, false].map(|forward| measures.street(road, forward).unwrap());
        let length =
            map.road(road).unwrap().lanes.iter().map(|id| map.lane(*id).unwrap().line.length()).fold(0.0, f64::max);
        let flow: f64 = sides.iter().map(|side| side.flow).sum();
        assert!((flow * length * 900.0 / 3600.0 / metres - 1.0).abs() < 0.01, "{road:?}: {flow} {metres}");
        for side in sides {
            assert!((side.flow - 3.6 * side.density * side.speed).abs() < 1e-6 * side.flow.max(1.0));
            assert!(side.speed < 17.0 && side.mean_queue <= f64::from(side.longest_queue));
            queued += usize::from(side.longest_queue > 10.0);
            late += usize::from(side.delay > 3.0);
        }
    }
    assert!(queued > 10 && late > 10, "{queued} {late}");
    assert_eq!(measures.street(RoadId(10_000), true), None);
}

#[test]
fn near_misses_are_told_and_none_is_close() {
    for control in [Control::Signals, Control::Priority, Control::AllWayStop] {
        let map = grid(3, 1, control, DrivingSide::Right);
        let demand = trips(&map, 500, 900.0, &[0, 0, 1, 4], Seed(6));
        let mut traffic = Traffic::new(&map, demand, &TrafficOptions::default(), Seed(1)).unwrap();
        let mut measures = Measures::new(&traffic);
        for _ in 0..12_000 {
            traffic.step();
            measures.add(&traffic);
        }
        let misses = measures.near_misses();
        let [collisions, crossings] = [Nearness::Collision, Nearness::Encroachment]
            .map(|kind| misses.iter().filter(|miss| miss.kind == kind).collect::<Vec<_>>());
        assert!(crossings.len() > 20, "{control:?} {}", crossings.len());
        assert!(
            crossings.iter().all(|miss| miss.junction.is_some() && (0.5..5.0).contains(&miss.seconds)),
            "{control:?}"
        );
        assert!(collisions.iter().all(|miss| (0.8..3.0).contains(&miss.seconds)), "{control:?} {collisions:?}");
        assert!(misses.iter().all(|miss| miss.vehicles[0] != miss.vehicles[1] && miss.at > 0.0));
    }
}

#[test]
fn floating_car_data_has_everybody_in_each_step() {
    let map = town(2, 1, Control::Priority, DrivingSide::Right);
    let traffic =
        Traffic::new(&map, trips(&map, 60, 60.0, &[0, 1], Seed(5)), &TrafficOptions::default(), Seed(1)).unwrap();
    let mut traffic = traffic.with_walks(walks(&map, 30, 60.0, Seed(2))).unwrap();
    let mut fcd = Fcd::new();
    let (mut xml, mut count, mut people) = (String::new(), 0, 0);
    for _ in 0..600 {
        traffic.step();
        fcd.add(&traffic);
        xml += &fcd.take();
        (count, people) = (count + traffic.len(), people + traffic.people().count());
    }
    xml += &fcd.finish();
    assert!(xml.starts_with("<?xml") && xml.ends_with("</fcd-export>\n"));
    let tags = |tag: &str| xml.matches(tag).count();
    assert_eq!((tags("<timestep "), tags("</timestep>")), (600, 600));
    assert_eq!((tags("<vehicle "), tags("<person ")), (count, people));
    let number = |line: &str, key: &str| -> f64 {
        let rest = line.split_once(&format!(" {key}=\"")).unwrap().1;
        rest.split_once('"').unwrap().0.parse().unwrap()
    };
    // The last step, vehicle by vehicle: SUMO's angles are clockwise from north.
    let last = xml.rsplit_once("<timestep").unwrap().1;
    assert!(traffic.len() > 10);
    for (line, (id, pose)) in last.lines().filter(|line| line.contains("<vehicle ")).zip(traffic.vehicles()) {
        assert_eq!(number(line, "id"), f64::from(id.0));
        let (sine, cosine) = number(line, "angle").to_radians().sin_cos();
        let front = pose.front();
        let back = [number(line, "x") - 2.0 * sine, number(line, "y") - 2.0 * cosine];
        let there = front + (pose.at - front).normalize() * 2.0;
        assert!((there.x - back[0]).hypot(there.y - back[1]) < 0.02, "{line}");
        assert_eq!(line.contains("lane=\"r") || line.contains("lane=\"-r"), pose.lane.is_some(), "{line}");
        assert_eq!(line.contains("lane=\":j"), pose.movement.is_some(), "{line}");
    }
}
