//! The timetable: people of a town over some days.

use std::collections::BTreeMap;

use proptest::prelude::*;
use vc_graph::Seed;
use vc_graph::clock::{DAY, TICKS_PER_SECOND, Tick};
use vc_map::{Control, DrivingSide, Light, Point, StreetMap};
use vc_traffic::{
    Demand, Errand, LandUse, PersonId, Timetable, TimetableError, TimetableOptions, VehicleId, Whereabouts,
};

use crate::grid;

/// A town of some hundred houses, a third of which are for other things.
fn town(size: usize, lanes: usize, control: Control) -> StreetMap {
    let mut draft = grid::town(size, lanes, control, DrivingSide::Right).draft().clone();
    let kinds =
        ["apartments", "house", "office", "apartments", "retail", "house", "apartments", "school", "apartments"];
    draft.buildings.iter_mut().enumerate().for_each(|(number, building)| {
        building.kind = kinds[number % kinds.len()].to_owned();
        building.storeys = 3;
    });
    draft.build().unwrap()
}

fn timetable(map: &StreetMap, people: usize, days: u32, seed: u64) -> Timetable {
    of(map, &Demand::of_land_use(map, &LandUse::default(), people, Seed(seed)), days, seed)
}

/// Demand in which all who have a car take it.
fn drivers(map: &StreetMap, people: usize, seed: u64) -> Demand {
    let mut demand = Demand::of_land_use(map, &LandUse::default(), people, Seed(seed));
    for person in &mut demand.people {
        person.week.iter_mut().for_each(|outing| outing.by_car = person.car);
    }
    demand
}

fn of(map: &StreetMap, demand: &Demand, days: u32, seed: u64) -> Timetable {
    let options = TimetableOptions { days, ..TimetableOptions::default() };
    Timetable::new(map, demand, &options, Seed(seed)).unwrap()
}

fn tick(day: u32, seconds: f64) -> Tick {
    Tick(((f64::from(day * DAY) + seconds) * TICKS_PER_SECOND as f64) as u64)
}

fn at(map: &StreetMap, whereabouts: &Whereabouts) -> Point {
    match whereabouts {
        Whereabouts::Indoors { door, .. } => map.entrance(*door).unwrap().door,
        Whereabouts::OnFoot { at, .. } => *at,
        Whereabouts::Driving { pose, .. } => pose.at,
        _ => panic!("{whereabouts:?}"),
    }
}

fn all(timetable: &Timetable) -> impl Iterator<Item = PersonId> + use<> {
    (0..timetable.people() as u32).map(PersonId)
}

#[test]
fn nobody_jumps_and_everybody_is_in_one_place() {
    for (lanes, control) in
        [(1, Control::Signals), (2, Control::Signals), (1, Control::Priority), (1, Control::AllWayStop)]
    {
        let map = town(3, lanes, control);
        let timetable = of(&map, &drivers(&map, 600, 5), 2, 5);
        let figures = timetable.figures();
        assert!(figures.by_car > 500 && figures.on_foot > 300 && figures.squeezed == 0, "{figures:?}");
        let (mut drove, mut walked) = (0, 0);
        for person in all(&timetable).step_by(5) {
            let mut before: Option<Point> = None;
            // Six times a second for two hours, and each second of a day.
            let ticks =
                (0..43_200).map(|n| tick(0, 27_000.0).0 + n * 10).chain((0..86_400).map(|n| tick(1, 0.0).0 + n * 60));
            for now in ticks {
                let now = Tick(now);
                let whereabouts = timetable.place_at(person, now).unwrap();
                let (here, most) = (at(&map, &whereabouts), if now < tick(1, 0.0) { 1.0 / 6.0 } else { 1.0 });
                if let Some(before) = before.filter(|_| now != tick(1, 0.0)) {
                    let metres = (here - before).norm();
                    assert!(metres <= 16.0 * most, "{control:?} {person} {now:?}: {metres} m, {whereabouts:?}");
                }
                before = Some(here);
                let vehicle = timetable.vehicle_at(VehicleId(person.0), now);
                match whereabouts {
                    Whereabouts::Driving { vehicle: id, pose } => {
                        drove += 1;
                        assert_eq!((id, Some(pose)), (VehicleId(person.0), vehicle));
                    }
                    Whereabouts::OnFoot { speed, .. } => {
                        walked += 1;
                        assert!(vehicle.is_none() && (0.0..=2.0).contains(&speed));
                    }
                    _ => assert!(vehicle.is_none()),
                }
            }
        }
        assert!(drove > 300 && walked > 1000, "{drove} {walked}");
    }
}

#[test]
fn people_are_at_home_at_night_and_many_at_work_at_noon() {
    let map = town(4, 1, Control::Signals);
    let timetable = timetable(&map, 1000, 7, 3);
    let doing = |tick: Tick| {
        let mut counts: BTreeMap<Option<Errand>, usize> = BTreeMap::new();
        for person in all(&timetable) {
            let errand = match timetable.place_at(person, tick).unwrap() {
                Whereabouts::Indoors { errand, .. } => Some(errand),
                _ => None,
            };
            *counts.entry(errand).or_default() += 1;
        }
        counts
    };
    for day in 0..8 {
        assert_eq!(doing(tick(day, 3.5 * 3600.0)), BTreeMap::from([(Some(Errand::Home), 1000)]), "day {day}");
        let noon = doing(tick(day, 11.0 * 3600.0));
        let count = |errand| noon.get(&Some(errand)).copied().unwrap_or(0);
        match day {
            0..5 => assert!(count(Errand::Work) > 350 && count(Errand::School) > 100, "day {day}: {noon:?}"),
            5..7 => assert!(count(Errand::Work) == 0 && count(Errand::Shop) > 100, "day {day}: {noon:?}"),
            // The week is over.
            _ => assert_eq!(count(Errand::Home), 1000),
        }
    }
    assert_eq!(timetable.place_at(PersonId(1000), Tick(0)), None);
    let figures = timetable.figures();
    let each = (figures.on_foot + figures.by_car) as f64 / 7000.0;
    assert!((2.5..3.7).contains(&each), "{each} journeys a day");
}

/// Whether a row of a junction is green at a tick.
fn is_green(map: &StreetMap, junction: usize, row: usize, tick: u64) -> bool {
    let signal = map.signal(map.junctions()[junction].signal.unwrap()).unwrap();
    let mut left = (tick as f64 / TICKS_PER_SECOND as f64).rem_euclid(signal.cycle());
    let phase = signal.phases.iter().find(|phase| {
        left -= phase.seconds;
        left < 0.0
    });
    matches!(phase.unwrap().lights[row], Light::Green | Light::GreenYield)
}

#[test]
fn vehicles_queue_behind_each_other_and_go_at_green() {
    let map = town(4, 1, Control::Signals);
    // All drive off within a quarter of an hour.
    let (doors, mut numbers) = (map.entrances().len(), Seed(8).stream());
    let week = |_| {
        let [home, to, minute, second] = [doors, doors, 15, 60].map(|count| numbers.below(count));
        format!("home {home} car\nmon 08:{minute:02}:{second:02} work {to} car\nmon 12:00 home {home} car\n")
    };
    let table: String = (0..1000).map(week).collect();
    let timetable = of(&map, &Demand::read(&table).unwrap(), 1, 8);
    assert_eq!(timetable.figures().squeezed, 0);
    let (mut queued, mut most) = (0, 0);
    for second in 0..3600 {
        let now = tick(0, 28_800.0 + f64::from(second));
        let mut lanes: BTreeMap<_, Vec<(f32, f32)>> = BTreeMap::new();
        for person in all(&timetable) {
            if let Some(pose) = timetable.vehicle_at(VehicleId(person.0), now) {
                lanes.entry((pose.lane, pose.movement)).or_default().push((pose.station, pose.speed));
            }
        }
        for ((lane, _), mut on) in lanes.into_iter().filter(|((lane, _), _)| lane.is_some()) {
            on.sort_by(|a, b| a.0.total_cmp(&b.0));
            for pair in on.windows(2) {
                assert!(pair[1].0 - pair[0].0 > 6.0, "second {second}, {lane:?}: {on:?}");
            }
            queued += on.iter().filter(|(_, speed)| *speed == 0.0).count();
            most = most.max(on.len());
        }
    }
    assert!(queued > 10_000 && most > 6, "{queued} {most}");
    let mut went = 0;
    for person in all(&timetable) {
        let mut before = None;
        for now in tick(0, 29_400.0).0..tick(0, 30_000.0).0 {
            let on = timetable.vehicle_at(VehicleId(person.0), Tick(now)).and_then(|pose| pose.movement);
            if let Some(id) = on.filter(|_| before != on) {
                let movement = map.movement(id).unwrap();
                let junction = map.junction(movement.junction).unwrap();
                let row = junction.movements.iter().position(|other| *other == id).unwrap();
                if junction.signal.is_some() {
                    went += 1;
                    assert!(is_green(&map, movement.junction.index(), row, now - 1), "{person} {now} {id:?}");
                }
            }
            before = on;
        }
    }
    assert!(went > 300, "{went}");
}

#[test]
fn the_same_seed_gives_the_same_bytes_whoever_asks_in_which_order() {
    let map = town(2, 1, Control::Signals);
    let [one, other] = [7, 7].map(|seed| of(&map, &drivers(&map, 200, seed), 2, seed));
    assert_eq!(one.digest(), other.digest());
    assert_ne!(one.digest(), timetable(&map, 200, 2, 8).digest());
    let mut numbers = Seed(1).stream();
    let asked: Vec<(PersonId, Tick)> = (0..20_000)
        .map(|_| (PersonId(numbers.below(200) as u32), tick(0, f64::from(numbers.between(0.0, 172_800.0)))))
        .collect();
    let in_order: Vec<_> = asked.iter().map(|(person, tick)| one.place_at(*person, *tick)).collect();
    let copy = one.clone();
    let backward = std::thread::scope(|scope| {
        let ask = || asked.iter().rev().map(|(person, tick)| copy.place_at(*person, *tick)).collect::<Vec<_>>();
        let asking = scope.spawn(ask);
        ask();
        asking.join().unwrap()
    });
    assert!(in_order.iter().eq(backward.iter().rev()));
    assert_eq!(one.digest(), other.digest());
}

#[test]
fn a_table_of_demand_is_kept_to() {
    let map = town(3, 1, Control::Priority);
    // On streets that lead on at both ends; the shop is in the same street as work, and home some streets away.
    let inside = |at: &Point| (201.0..599.0).contains(&at.x) && (201.0..599.0).contains(&at.y);
    let doors: Vec<usize> = (0..map.entrances().len()).filter(|door| inside(&map.entrances()[*door].door)).collect();
    let [home, shop, work] = [doors[0], doors[doors.len() - 2], doors[doors.len() - 1]];
    let table = format!(
        "home {home} car\nmon 08:00 work {work} car\nmon 12:00 shop {shop} foot\nmon 12:40 work {work} foot\nmon 17:00 home {home} car"
    );
    let timetable = of(&map, &Demand::read(&table).unwrap(), 7, 1);
    let figures = timetable.figures();
    assert_eq!((figures.by_car, figures.on_foot, figures.without_road, figures.without_way), (2, 2, 0, 0));
    let errand = |day, hours: f64| match timetable.place_at(PersonId(0), tick(day, hours * 3600.0)) {
        Some(Whereabouts::Indoors { errand, door }) => Some((errand, door.index())),
        _ => None,
    };
    assert_eq!(errand(0, 7.99), Some((Errand::Home, home)));
    assert_eq!(errand(0, 8.01), None);
    assert_eq!(
        [8.2, 12.5, 13.2, 17.2].map(|hours| errand(0, hours)),
        [
            Some((Errand::Work, work)),
            Some((Errand::Shop, shop)),
            Some((Errand::Work, work)),
            Some((Errand::Home, home)),
        ]
    );
    assert_eq!(errand(1, 12.5), Some((Errand::Home, home)));
}

#[test]
fn weeks_that_cannot_be_are_refused() {
    let map = town(2, 1, Control::Priority);
    let refuse = |table: &str, days| {
        let options = TimetableOptions { days, ..TimetableOptions::default() };
        let error = Timetable::new(&map, &Demand::read(table).unwrap(), &options, Seed(1)).err().unwrap();
        error.to_string()
    };
    for (table, says) in [
        ("home 4000", "person 0: entrance 4000 of"),
        ("home 4\nmon 08:00 work 9 car\nmon 17:00 home 4 car", "without a car"),
        ("home 4 car\nmon 08:00 work 9 foot\nmon 17:00 home 4 car", "let them fetch it on foot"),
        ("home 4 car\nmon 08:00 work 9 car\nmon 17:00 home 4 foot", "let them drive home"),
        ("home 3\nhome 4\nmon 08:00 work 9 foot", "person 1: is at entrance 9 when the week ends"),
    ] {
        let error = refuse(table, 7);
        assert!(error.contains(says), "{table}: {error}");
    }
    assert_eq!(refuse("home 4", 0), TimetableError::Days(0).to_string());
    let classes = TimetableOptions { days: 1, classes: Vec::new() };
    assert_eq!(Timetable::new(&map, &Demand::default(), &classes, Seed(1)).err(), Some(TimetableError::Classes));
    let mut demand = Demand::read("home 4\nmon 08:00 shop 5 foot\nmon 17:00 home 4 foot").unwrap();
    demand.people[0].week.swap(0, 1);
    let error = Timetable::new(&map, &demand, &TimetableOptions::default(), Seed(1)).err().unwrap();
    assert!(error.to_string().contains("sort them"), "{error}");
    for (table, line) in [
        ("mon 08:00 work 9 foot", 1),
        ("home x", 1),
        ("home 4\n\nfri-mon 08:00 work 9 foot", 3),
        ("home 4\nmon 25:00 work 9 foot", 2),
        ("home 4\nmon 08:00 holiday 9 foot", 2),
        ("home 4\nmon 08:00 work 9 train", 2),
        ("home 4 bike", 1),
    ] {
        assert_eq!(Demand::read(table).unwrap_err().line, line, "{table}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, ..ProptestConfig::default() })]

    #[test]
    fn everybody_comes_home_whatever_the_demand(seed in 0_u64..1000, size in 2_usize..5, lanes in 1_usize..3, control in 0..3) {
        let control = [Control::Signals, Control::Priority, Control::AllWayStop][control as usize];
        let map = town(size, lanes, control);
        let doors = map.entrances().len();
        let mut numbers = Seed(seed).stream();
        let mut table = String::new();
        for _ in 0..400 {
            let home = numbers.below(doors);
            table += &format!("home {home} car\n");
            let by = if numbers.chance(0.7) { "car" } else { "foot" };
            for hour in [8, 9, 12, 16] {
                let to = if hour == 16 { home } else { numbers.below(doors) };
                table += &format!("mon {hour:02}:{:02} leisure {to} {by}\n", numbers.below(20));
            }
        }
        let timetable = of(&map, &Demand::read(&table).unwrap(), 1, seed);
        for person in all(&timetable) {
            let mut before: Option<Point> = None;
            let begin = tick(0, f64::from(numbers.between(28_800.0, 64_800.0))).0;
            for now in begin..begin + 3600 {
                let here = at(&map, &timetable.place_at(person, Tick(now)).unwrap());
                let metres = before.map_or(0.0, |before| (here - before).norm());
                prop_assert!(metres < 0.3, "{person} {now}: {metres} m");
                before = Some(here);
            }
            let night = timetable.place_at(person, tick(0, 86_000.0)).unwrap();
            prop_assert!(matches!(night, Whereabouts::Indoors { errand: Errand::Home | Errand::Leisure, .. }), "{person} {night:?}");
        }
    }
}
