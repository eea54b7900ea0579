//! Plans of cities, held against slow obvious versions, and against the rules on some seeds; `proofs/cities` has many.

mod flats;

use std::collections::BTreeSet;

use vc_graph::Seed;
use vc_graph::hash::fnv1a;
use vc_map::format::{native, opendrive, sumo};
use vc_map::{Control, Point};
use vc_procgen::city::{
    CityBuilding, CityPlan, CityPlanError, CitySpecification, CityZone, Convex, StreetPattern, UnitKind, Waterside,
};

/// The digests of the texts of plans of seeds 0, 1 and 2: the same on every machine.
const DIGESTS: [&str; 3] = ["f5ee614988e24833", "96f208606ec39ce8", "1a48083cdeb42fc6"];

fn plan(seed: u64) -> CityPlan {
    CityPlan::from_seed(Seed(seed)).unwrap()
}

fn small(seed: u64) -> CityPlan {
    CityPlan::generate(&CitySpecification { area: 0.25, ..CitySpecification::default() }, Seed(seed)).unwrap()
}

#[test]
fn every_machine_and_thread_makes_the_same_bytes() {
    let digest = |seed| format!("{:016x}", fnv1a(plan(seed).text().bytes()));
    let alone: Vec<String> = (0..3).map(digest).collect();
    assert_eq!(alone, DIGESTS);
    let threads: Vec<_> =
        (0..3).map(|seed| std::thread::spawn(move || format!("{:016x}", fnv1a(plan(seed).text().bytes())))).collect();
    let together: Vec<String> = threads.into_iter().map(|thread| thread.join().unwrap()).collect();
    assert_eq!(alone, together);
}

#[test]
fn plans_keep_the_rules() {
    // `VC_FIRST_CITY` and `VC_CITIES` choose other seeds, `VC_CITY_AREA` another area: the proof goes through many.
    let number = |name: &str| std::env::var(name).ok().and_then(|text| text.parse::<f64>().ok());
    let first = number("VC_FIRST_CITY").unwrap_or(0.0) as u64;
    let count = number("VC_CITIES").unwrap_or(6.0) as u64;
    let area = number("VC_CITY_AREA").unwrap_or(1.0);
    let mut broken = 0;
    for seed in first..first + count {
        let wishes = CitySpecification { area, ..CitySpecification::default() };
        for wrong in CityPlan::generate(&wishes, Seed(seed)).unwrap().violations() {
            println!("seed {seed}: {wrong}");
            broken += 1;
        }
    }
    assert_eq!(broken, 0, "violations in {count} cities from seed {first} on");
}

#[test]
fn wishes_are_met_or_refused() {
    for pattern in StreetPattern::ALL {
        for (kind, density) in [(Waterside::Beach, 9_000.0), (Waterside::Quay, 14_000.0)] {
            let wishes =
                CitySpecification { area: 0.6, density, pattern: Some(pattern), waterside: Some(kind), parks: 0.08 };
            let plan = CityPlan::generate(&wishes, Seed(3)).unwrap();
            assert_eq!((plan.pattern(), plan.shore().map(|shore| shore.kind)), (pattern, Some(kind)));
            assert!((plan.area() / 0.6e6 - 1.0).abs() < 1e-6, "{} m²", plan.area());
            assert!(
                (plan.residents() / (0.6 * density) - 1.0).abs() < 0.2,
                "{} residents for {density}",
                plan.residents()
            );
            assert_eq!(plan.violations(), []);
        }
    }
    let absurd = [f64::NAN, -1.0, 0.0, 1e9];
    for area in absurd {
        let wishes = CitySpecification { area, ..CitySpecification::default() };
        assert!(matches!(CityPlan::generate(&wishes, Seed(1)), Err(CityPlanError::OutOfRange { what: "area", .. })));
    }
}

/// Euler: a connected plane graph has as many inner faces as edges without vertices, and one.
#[test]
fn blocks_are_the_faces_of_the_streets() {
    for seed in 0..4 {
        let plan = plan(seed);
        let roads = plan.map().roads().iter().filter(|road| road.draft.class.is_street()).count();
        let junctions =
            plan.map().junctions().iter().filter(|junction| junction.draft.control != Control::Edge).count();
        assert_eq!(plan.blocks().len(), roads + 1 - junctions);
    }
}

/// Points all over the city: in a block's land each is on one parcel, and beyond it on none.
#[test]
fn parcels_tile_the_land() {
    let plan = small(5);
    let mut stream = Seed(1).stream();
    let mut on_land = 0;
    for _ in 0..4000 {
        let at = Point::new(f64::from(stream.between(-320.0, 320.0)), f64::from(stream.between(-320.0, 320.0)));
        let near = |polygon: &Convex, inward: f64| polygon.contains(&at, inward);
        let land = plan.blocks().iter().filter(|block| near(&block.land, 0.01)).count();
        let [sure, perhaps] =
            [0.01, -0.01].map(|inward| plan.parcels().iter().filter(|parcel| near(&parcel.land, inward)).count());
        assert!(sure <= land && land <= perhaps, "{land} blocks and {sure} to {perhaps} parcels at {at}");
        on_land += land;
    }
    assert!(on_land > 1000);
}

/// The units of a building, storey by storey in an order.
fn units(building: &CityBuilding, storeys: impl Iterator<Item = usize>) -> Vec<String> {
    let mut all: Vec<String> =
        storeys.flat_map(|storey| building.units(storey)).map(|unit| format!("{unit:?}")).collect();
    all.sort();
    all
}

#[test]
fn units_do_not_depend_on_the_order_in_which_they_are_asked_for() {
    let (one, other) = (small(2), small(2));
    let forward: Vec<Vec<String>> =
        one.buildings().iter().map(|building| units(building, 0..building.storeys)).collect();
    let backward = other.buildings().iter().rev().map(|building| units(building, (0..building.storeys).rev()));
    let mut backward: Vec<Vec<String>> = backward.collect();
    backward.reverse();
    assert_eq!(forward, backward);
}

#[test]
fn units_fit_into_their_wings_and_have_daylight() {
    let plan = plan(4);
    let mut dark = 0;
    for building in plan.buildings() {
        let mut homes = 0;
        for unit in (0..building.storeys).flat_map(|storey| building.units(storey)) {
            let wings = || building.wings.iter().filter(|wing| wing.from <= unit.storey && unit.storey < wing.to);
            let held =
                wings().any(|wing| unit.outline.corners().iter().all(|corner| wing.plan.contains(corner, -1e-3)));
            assert!(held, "a unit of {:?} hangs out", building.kind);
            assert!(unit.outline.contains(&unit.door, -1e-3));
            for window in &unit.windows {
                let ahead = window.at + window.out * 0.3;
                assert!(!wings().any(|wing| wing.plan.contains(&ahead, 0.0)), "a window into a wall");
            }
            homes += usize::from(unit.kind == UnitKind::HOME);
            dark += usize::from(unit.windows.is_empty() && unit.kind == UnitKind::HOME);
        }
        assert_eq!(homes, building.homes(), "{building:?}");
    }
    assert_eq!(dark, 0, "homes without windows");
}

#[test]
fn a_city_has_all_that_its_rules_are_about() {
    let plan = plan(1);
    let zones: BTreeSet<CityZone> = plan.blocks().iter().map(|block| block.zone).collect();
    assert_eq!(zones.len(), CityZone::ALL.len());
    let classes: BTreeSet<&str> = plan.items().iter().map(|item| item.class).collect();
    for class in ["street_lamp", "tree", "bench", "hydrant", "traffic_light", "traffic_sign", "bus_stop"] {
        assert!(classes.contains(class), "no {class}");
    }
    let table = vc_graph::ClassTable::builtin();
    let all = classes.iter().copied().chain(plan.cars().iter().map(|car| car.class));
    all.for_each(|class| assert!(table.get(class).is_some(), "{class} is no class"));
    let outdoors = plan.items().len() + plan.cars().len() + plan.trees().len();
    assert!(outdoors > 4500 && plan.railway().is_some() && !plan.parks().is_empty());
}

#[test]
fn a_plan_is_a_map_for_others() {
    let plan = small(9);
    assert_eq!(&native::read(&native::write(plan.map())).unwrap(), plan.map());
    assert!(opendrive::write(plan.map()).contains("<junction"));
    assert!(sumo::write(plan.map(), "plan").all().iter().all(|(_, text)| !text.is_empty()));
}
