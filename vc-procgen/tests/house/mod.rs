//! Houses of flats in cities: sound, the same whoever asks when, with the flats of the plan.

use vc_graph::Seed;
use vc_graph::space::{PortalKind, RegionGraphs, RegionId, RegionKind};
use vc_procgen::city::{CityPlan, CitySpecification};
use vc_procgen::{House, HouseError};

fn city(seed: u64) -> CityPlan {
    CityPlan::generate(&CitySpecification { area: 0.2, ..CitySpecification::default() }, Seed(seed)).unwrap()
}

/// Some houses of a city, of different streets.
fn houses(city: &CityPlan, every: usize) -> impl Iterator<Item = (usize, House)> {
    let all = (0..city.buildings().len()).filter_map(|building| Some((building, House::of(city, building).ok()?)));
    all.step_by(every)
}

fn scenes(house: &House) -> Vec<RegionId> {
    house.space().regions().filter(|(_, region)| region.has_scene()).map(|(id, _)| id).collect()
}

#[test]
fn houses_of_cities_are_sound() {
    let mut count = 0;
    for seed in 0..vc_testkit::amount(3, 20) {
        for (building, house) in houses(&city(seed), 25) {
            let found = house.violations();
            let found: Vec<String> = found.iter().map(ToString::to_string).collect();
            assert!(found.is_empty(), "city {seed}, building {building}:\n{}", found.join("\n"));
            count += 1;
        }
    }
    assert!(count > 3, "{count} houses");
}

#[test]
fn a_house_has_the_flats_of_the_plan_and_ways_between_them() {
    let city = city(7);
    let mut count = 0;
    for (building, house) in houses(&city, 1) {
        let plan = &city.buildings()[building];
        assert_eq!(house.storeys().len(), plan.storeys);
        let flats =
            |storey: usize| plan.units(storey).iter().filter(|unit| city.flat(building, unit).is_some()).count();
        for (number, storey) in house.storeys().iter().enumerate() {
            assert_eq!((storey.homes.len(), storey.front_doors.len()), (flats(number), flats(number)));
            for (home, door) in storey.homes.iter().zip(&storey.front_doors) {
                let portal = house.space().portal(*door).unwrap();
                assert_eq!(portal.across(*home).unwrap().region, storey.landing);
            }
        }
        // From the street one comes everywhere.
        let (mut known, mut next) = (vec![house.street()], 0);
        while let Some(here) = known.get(next).copied() {
            next += 1;
            for portal in house.space().portals_of(here).filter_map(|id| house.space().portal(id)) {
                let beyond = portal.across(here).unwrap().region;
                if !known.contains(&beyond) {
                    known.push(beyond);
                }
            }
        }
        assert_eq!(known.len(), scenes(&house).len());
        let landings = house.space().portals().filter(|(_, portal)| portal.kind == PortalKind::Landing);
        assert_eq!(landings.count(), 2 * plan.storeys - 1, "a stop for each storey, stairs between them");
        count += 1;
    }
    assert!(count > 20, "{count} houses");
}

#[test]
fn a_house_is_the_same_in_any_order() {
    let [one, other] = [(); 2].map(|()| House::from_seed(Seed(7)).unwrap());
    assert_eq!(one, other);
    assert_eq!(one.space().digest(), other.space().digest());
    let forward: Vec<_> = scenes(&one).into_iter().map(|region| one.scene(region).unwrap()).collect();
    let mut back: Vec<_> = scenes(&other).into_iter().rev().map(|region| other.scene(region).unwrap()).collect();
    back.reverse();
    assert_eq!(forward, back);
    let mut world = RegionGraphs::new(one.space().clone());
    for (region, scene) in scenes(&one).into_iter().zip(forward) {
        world.insert(region, scene).unwrap();
    }
    for storey in one.storeys() {
        let is = |node, class: &str| assert_eq!(&*world.label(node).class, class);
        is(storey.lift_door, "lift_door");
        is(storey.call_button, "call_button");
        is(storey.floor_button, "floor_button");
        for door in &storey.front_doors {
            is(one.space().portal(*door).unwrap().leaf.unwrap(), "main_door");
        }
    }
    assert_eq!(&*world.label(one.street_door()).class, "main_door");
}

#[test]
fn what_is_no_house_is_told() {
    let city = city(7);
    let all: Vec<_> = (0..city.buildings().len()).map(|building| House::of(&city, building)).collect();
    for (building, house) in all.iter().enumerate() {
        let plan = &city.buildings()[building];
        let is_one = plan.wings.len() == 1 && !plan.kind.is_whole();
        match house {
            Ok(_) => assert!(is_one && plan.homes() > 0),
            Err(HouseError::NotOneWing(number)) => assert!(*number == building && !is_one),
            Err(HouseError::NoFlats(number)) => assert!(*number == building && plan.homes() == 0),
            Err(HouseError::NoCore(number)) => assert!(*number == building && is_one),
            Err(other) => panic!("{other}"),
        }
    }
    assert_eq!(House::of(&city, 1 << 20), Err(HouseError::NoBuilding(1 << 20)));
    let house = all.into_iter().find_map(Result::ok).unwrap();
    let group = house.space().regions().find(|(_, region)| region.kind == RegionKind::Storey).unwrap().0;
    for region in [group, RegionId(1 << 20)] {
        assert_eq!(house.scene(region), Err(HouseError::NoScene(region)));
    }
}
