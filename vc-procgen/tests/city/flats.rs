//! Flats in the buildings of cities: their windows are the facade's, their rooms fit behind, and furnished they pass the checker.

use proptest::prelude::*;
use vc_graph::Seed;
use vc_map::Point;
use vc_procgen::city::{CityPlan, CitySpecification, FlatPlan, Unit, UnitKind, Wing};
use vc_procgen::plan::{FloorPlan, OpeningKind, PlanFault, PlanOpening, Room, Side, Site, WindowPlace, metres};
use vc_procgen::{Apartment, Specification, SpecificationError};

use crate::checker::{Finding, examine, report};
use crate::{findings, number};

/// How far before a facade one looks at a window from, and how far behind it the room is tested, metres.
const BEFORE: f64 = 0.6;
const BEHIND: f64 = 0.5;

fn city(seed: u64) -> CityPlan {
    CityPlan::generate(&CitySpecification { area: 0.3, ..CitySpecification::default() }, Seed(seed)).unwrap()
}

/// The homes of one storey in a city, with their buildings.
fn homes(city: &CityPlan) -> Vec<(usize, Unit)> {
    let of = |(index, building): (usize, &vc_procgen::city::CityBuilding)| {
        let units = (0..building.storeys).flat_map(|storey| building.units(storey)).collect::<Vec<Unit>>();
        units.into_iter().map(move |unit| (index, unit))
    };
    let whole = |unit: &Unit, index: usize| city.buildings()[index].kind.is_whole() || unit.kind != UnitKind::HOME;
    city.buildings().iter().enumerate().flat_map(of).filter(|(index, unit)| !whole(unit, *index)).collect()
}

fn flats(city: &CityPlan) -> Vec<(usize, Unit, FlatPlan)> {
    let flat = |(index, unit): (usize, Unit)| {
        let flat = city.flat(index, &unit).unwrap_or_else(|| panic!("no flat for {unit:?} of building {index}"));
        (index, unit, flat)
    };
    homes(city).into_iter().map(flat).collect()
}

fn furnished(plan: FloorPlan, seed: u64) -> Result<Apartment, SpecificationError> {
    Apartment::generate(&Specification { plan: Some(plan), ..Specification::default() }, Seed(seed))
}

/// `VC_FIRST_CITY`, `VC_CITIES` and `VC_FLATS` choose cities and how many flats of each are furnished: `proofs/flats` goes through many.
#[test]
fn furnished_flats_pass_the_checkers() {
    let first = number("VC_FIRST_CITY", 0);
    let (cities, each) = (number("VC_CITIES", 1), number("VC_FLATS", vc_testkit::amount(6, 40)) as usize);
    let mut count = 0;
    for seed in first..first + cities {
        let flats = flats(&city(seed));
        let step = (flats.len() / each).max(1);
        let some: Vec<&FlatPlan> = flats.iter().skip(seed as usize % step).step_by(step).map(|flat| &flat.2).collect();
        count += some.len();
        let found = findings(0..some.len() as u64, |index| {
            let plan = some[index as usize].plan.clone();
            let rooms = plan.rooms.clone();
            let home =
                furnished(plan, index).unwrap_or_else(|error| panic!("city {seed}, flat {index}: {error}: {rooms:?}"));
            assert!(home.check().is_empty(), "city {seed}, flat {index}: {:?}", home.check());
            assert_eq!(home.plan.rooms, rooms);
            examine(index, &home)
        });
        let found: Vec<&Finding> = found.iter().collect();
        assert!(found.is_empty(), "city {seed}: {} violations\n{}", found.len(), report(&found));
    }
    println!("{count} flats of {cities} cities pass the checkers");
}

/// A straight line from outside through the middle of each window ends in the room whose window it is, on its storey, and one from
/// the front door in the corridor.
#[test]
fn windows_are_those_of_the_rooms_behind() {
    let first = number("VC_FIRST_CITY", 0);
    let (mut windows, mut count) = (0, 0);
    for seed in first..first + number("VC_CITIES", 1) {
        let city = city(seed);
        for (index, unit, flat) in flats(&city) {
            count += 1;
            let building = &city.buildings()[index];
            let floor: f64 = (0..unit.storey).map(|storey| building.storey_height(storey)).sum();
            assert!((flat.floor - floor).abs() < 1e-9 && flat.plan.fault().is_none());
            for window in flat.plan.openings.iter().filter(|opening| opening.kind == OpeningKind::Window) {
                let (room, [inside, outside]) = through(&flat, window);
                let own = &flat.plan.rooms[room];
                assert!(own.contains(20.0 * inside.0 as f32, 20.0 * inside.1 as f32), "building {index}: {window:?}");
                let [inside, outside] = [inside, outside].map(|(x, y)| flat.place(x, y));
                assert!(unit.outline.contains(&inside, 0.0), "building {index}: {window:?} is not of {unit:?}");
                let wing = |at: &Point| wing(&building.wings, unit.storey, at);
                assert_eq!((wing(&inside), wing(&outside)), (1, 0), "building {index}: {window:?} of {unit:?}");
                // It is one of the places that the facade has.
                let middle = nalgebra::center(&inside, &outside);
                let near = unit.windows.iter().any(|slot| (slot.at - middle).norm() < 0.35);
                assert!(near, "building {index}: {window:?} of {unit:?}");
                windows += 1;
            }
            // The front door leads to the corridor: into the building, and into nobody's rooms.
            let mut doors = flat.plan.openings.iter().filter(|opening| opening.kind == OpeningKind::Entrance);
            let (Some(door), None) = (doors.next(), doors.next()) else { panic!("not one front door") };
            let (_, [_, outside]) = through(&flat, door);
            let outside = flat.place(outside.0, outside.1);
            assert_eq!(wing(&building.wings, unit.storey, &outside), 1, "building {index}: {door:?} of {unit:?}");
            let others = building.units(unit.storey);
            let strange = others.iter().find(|other| other.outline.contains(&outside, 0.01));
            assert_eq!(strange, None, "building {index}: {door:?} of {unit:?}");
            let lit = |room: usize| {
                flat.plan.openings.iter().any(|opening| opening.kind == OpeningKind::Window && opening.touches(room))
            };
            let dark = (0..flat.plan.rooms.len()).find(|&room| flat.plan.rooms[room].kind.is_bedroom() && !lit(room));
            assert_eq!(dark, None);
        }
    }
    assert!(windows > 2 * count && count > 100, "{windows} windows, {count} flats");
    println!("{windows} windows of {count} flats are those of the rooms behind");
}

/// The number of wings on a storey in which a point is.
fn wing(wings: &[Wing], storey: usize, at: &Point) -> usize {
    let here = wings.iter().filter(|wing| wing.from <= storey && storey < wing.to);
    here.filter(|wing| wing.plan.contains(at, 0.0)).count()
}

/// The room of a window or of the front door, and points inside and outside before its middle, metres in the plan.
fn through(flat: &FlatPlan, window: &PlanOpening) -> (usize, [(f64, f64); 2]) {
    let half = |cells: i32| f64::from(metres(cells));
    let (middle, at) = (half(window.from + window.to) / 2.0, half(window.at));
    let (room, inwards) = match (window.low, window.high) {
        (Some(room), None) => (room, -1.0),
        (None, Some(room)) => (room, 1.0),
        sides => panic!("a window between {sides:?}"),
    };
    assert!(room < flat.plan.rooms.len());
    let point = |across: f64| if window.vertical { (at + across, middle) } else { (middle, at + across) };
    (room, [point(BEHIND * inwards), point(-BEFORE * inwards)])
}

/// Flats above each other are alike, so that wet rooms stand above one another, and a flat is the same whichever is asked for first.
#[test]
fn flats_above_each_other_are_alike() {
    let (one, other) = (city(4), city(4));
    let all = flats(&one);
    let mut alike = 0;
    for (index, unit, flat) in all.iter().rev() {
        assert_eq!(other.flat(*index, unit).as_ref(), Some(flat));
        let above = all.iter().filter(|(house, upper, _)| house == index && upper.storey == unit.storey + 1);
        for (_, _, upper) in above.filter(|(_, upper, _)| unit.storey > 0 && upper.outline == unit.outline) {
            assert_eq!(upper.plan, flat.plan);
            alike += 1;
        }
    }
    assert!(alike > 50, "{alike}");
}

fn site() -> Site {
    let window = |from| WindowPlace { side: Side::South, from, to: from + 26, sill: 0.9, head: 2.3 };
    let windows = vec![window(17), window(73), window(129)];
    Site { width: 172, depth: 218, windows, door: (0, 172), ceiling: 2.7, shell: 4 }
}

/// Sites without sense are refused with the measure that is wrong.
#[test]
fn sites_without_sense_are_refused() {
    let of = |change: fn(&mut Site)| {
        let mut site = site();
        change(&mut site);
        FloorPlan::on(&site, Seed(1)).map(|_| ()).unwrap_err().to_string()
    };
    assert!(of(|site| site.width = -3).contains("width of the site in cells is -3"));
    assert!(of(|site| site.depth = i32::MAX).contains("depth of the site"));
    assert!(of(|site| site.ceiling = f32::NAN).contains("ceiling of the site is NaN"));
    assert!(of(|site| site.windows.clear()).contains("number of windows in the main facade is 0"));
    assert!(of(|site| site.windows[0].side = Side::North).contains("the north is the corridor's"));
    assert!(of(|site| site.windows[0].to = 9000).contains("end of a window is 9000"));
    assert!(of(|site| site.door = (100, 110)).contains("end of the door's stretch"));
    assert!(FloorPlan::on(&site(), Seed(1)).is_ok());
}

#[test]
fn plans_of_ones_own_are_furnished_or_refused() {
    let plan = FloorPlan::on(&site(), Seed(3)).unwrap();
    let wishes = Specification { plan: Some(plan.clone()), bedrooms: Some(1), ..Specification::default() };
    assert_eq!(wishes.check(), Err(SpecificationError::Planned { what: "bedrooms" }));
    let broken = |change: fn(&mut FloorPlan)| {
        let mut plan = plan.clone();
        change(&mut plan);
        match furnished(plan, 1) {
            Err(SpecificationError::BadPlan(fault)) => fault,
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(broken(|plan| plan.rooms.clear()), PlanFault::Rooms(0));
    assert_eq!(broken(|plan| plan.rooms[1].rects.clear()), PlanFault::NoFloor(1));
    assert_eq!(broken(|plan| plan.rooms[1] = plan.rooms[0].clone()), PlanFault::Overlap(0, 1));
    assert_eq!(broken(|plan| plan.openings[0].low = Some(77)), PlanFault::UnknownRoom(0, 77));
    assert_eq!(broken(|plan| plan.openings[0].at += 3), PlanFault::OffWall(0));
    assert_eq!(broken(|plan| plan.openings.retain(|o| o.kind != OpeningKind::Entrance)), PlanFault::NoEntrance);
    assert!(matches!(broken(|plan| plan.openings[0].head = f32::NAN), PlanFault::Height(0, ..)));
    assert!(matches!(broken(|plan| plan.ceiling = f32::INFINITY), PlanFault::Measure("ceiling in metres", ..)));
    // Plans that are generated have no fault.
    for seed in 0..40 {
        assert_eq!(FloorPlan::generate(&Specification::default(), Seed(seed)).unwrap().fault(), None, "seed {seed}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: vc_testkit::amount(24, 600) as u32, failure_persistence: None, ..ProptestConfig::default() })]

    /// A plan that somebody has changed anyhow is furnished or refused.
    #[test]
    fn changed_plans_are_furnished_or_refused(
        seed in 0..40_u64,
        edits in prop::collection::vec((0..6_usize, 0..64_usize, -60..60_i32), 1..4),
    ) {
        let mut plan = FloorPlan::on(&site(), Seed(seed)).unwrap();
        for (what, which, by) in edits {
            let (rooms, openings) = (plan.rooms.len(), plan.openings.len());
            let room: &mut Room = &mut plan.rooms[which % rooms];
            match what {
                0 => room.rects.iter_mut().take(1).for_each(|rect| rect.x1 += by),
                1 => room.rects.iter_mut().take(1).for_each(|rect| rect.y0 += by),
                2 => plan.openings[which % openings].from += by,
                3 => drop(plan.openings.remove(which % openings)),
                4 => room.kind = vc_procgen::plan::RoomKind::Bathroom,
                _ => drop(plan.rooms.remove(which % rooms)),
            }
            if plan.rooms.is_empty() || plan.openings.is_empty() {
                break;
            }
        }
        if let Ok(home) = furnished(plan, seed) {
            prop_assert!(home.check().is_empty());
        }
    }

    /// A site of any sensible measures has a flat that fills it, with its windows at places of the site.
    #[test]
    fn sites_of_all_measures_have_flats(width in 64..300_i32, depth in 110..246_i32, seed in any::<u64>()) {
        let count = (width as f32 / 64.0).round().max(1.0) as i32;
        let bay = width / count;
        let window = |i: i32| {
            let from = bay * i + bay / 2 - 13;
            WindowPlace { side: Side::South, from, to: from + 26, sill: 0.9, head: 2.3 }
        };
        let site = Site { width, depth, windows: (0..count).map(window).collect(), door: (0, width), ..site() };
        prop_assume!(site.check().is_ok());
        let plan = FloorPlan::on(&site, Seed(seed)).unwrap_or_else(|error| panic!("{site:?}: {error}"));
        prop_assert_eq!(plan.hull(), site.rect());
        let area: f32 = plan.rooms.iter().flat_map(|room| &room.rects).map(|rect| rect.area()).sum();
        prop_assert!((area - site.rect().area()).abs() < 0.01, "the rooms fill {} of {} m²", area, site.rect().area());
        for opening in plan.openings.iter().filter(|opening| opening.kind == OpeningKind::Window) {
            let place = site.windows.iter().find(|place| place.from == opening.from && place.to == opening.to);
            prop_assert!(place.is_some() && opening.at == 0 && !opening.vertical);
        }
        prop_assert_eq!(plan.fault(), None);
    }
}
