//! Buildings of many seeds: sound, the same whoever asks when, and open to who walks.

mod walk;

use vc_graph::space::{PortalKind, RegionFrame, RegionGraphs, RegionId, RegionKind};
use vc_graph::{Property, Seed, State};
use vc_procgen::{Apartment, Building, BuildingError, BuildingSpecification, Specification};
use walk::Ground;

fn of(seed: u64) -> Building {
    Building::from_seed(Seed(seed)).unwrap()
}

fn scenes(building: &Building) -> Vec<RegionId> {
    building.space().regions().filter(|(_, region)| region.has_scene()).map(|(id, _)| id).collect()
}

#[test]
fn buildings_of_many_seeds_are_sound() {
    for seed in 0..vc_testkit::amount(20, 100) {
        let found = of(seed).violations();
        assert!(
            found.is_empty(),
            "seed {seed}: {}",
            found.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
        );
    }
}

#[test]
fn a_high_building_is_sound() {
    let wishes = BuildingSpecification { storeys: 8, ..BuildingSpecification::default() };
    let building = Building::generate(&wishes, Seed(3)).unwrap();
    assert_eq!(building.violations(), []);
    let space = building.space();
    let cabin = space.region(building.cabin()).unwrap();
    assert_eq!(cabin.stops.len(), 8);
    let landings = space.portals().filter(|(_, portal)| portal.kind == PortalKind::Landing);
    assert_eq!(landings.count(), 8 + 7, "a stop for each storey, stairs between them");
}

#[test]
fn the_same_seed_makes_the_same_building_in_any_order() {
    let (one, other) = (of(7), of(7));
    assert_eq!(one, other);
    assert_eq!(one.space().digest(), other.space().digest());
    let forward: Vec<_> = scenes(&one).into_iter().map(|region| one.scene(region).unwrap()).collect();
    let mut back: Vec<_> = scenes(&other).into_iter().rev().map(|region| other.scene(region).unwrap()).collect();
    back.reverse();
    assert_eq!(forward, back);
    let shapes =
        |scenes: &[vc_graph::SceneGraph]| scenes.iter().map(vc_graph::format::native::write).collect::<Vec<_>>();
    assert_eq!(shapes(&forward), shapes(&back));
    assert_ne!(of(8).space().digest(), one.space().digest());
}

#[test]
fn homes_are_those_of_their_seeds_under_other_numbers() {
    let building = of(7);
    for home in building.storeys().iter().flat_map(|storey| storey.homes) {
        let plan = building.space().region(home).unwrap();
        let seed = plan.name.strip_prefix("apartment/").unwrap().parse().unwrap();
        let (here, alone) = (building.scene(home).unwrap(), Apartment::from_seed(Seed(seed)).unwrap().scene());
        assert_eq!(here.nodes().count(), alone.nodes().count());
        for (node, same) in here.nodes().zip(alone.nodes()) {
            assert_eq!(node.id().0, plan.numbers.first + same.id().0);
            assert_eq!((node.class(), node.pose(), node.states()), (same.class(), same.pose(), same.states()));
        }
    }
}

#[test]
fn all_its_scenes_are_a_world() {
    let building = of(7);
    let mut world = RegionGraphs::new(building.space().clone());
    for region in scenes(&building) {
        world.insert(region, building.scene(region).unwrap()).unwrap();
    }
    let storey = &building.storeys()[2];
    let is = |node, class: &str| assert_eq!(&*world.label(node).class, class);
    is(storey.lift_door, "lift_door");
    is(storey.call_button, "call_button");
    is(storey.floor_button, "floor_button");
    is(building.cabin_door(), "lift_door");
    assert_eq!(world.node(storey.floor_button).and_then(|node| node.spec().name.clone()).as_deref(), Some("storey 2"));
    for button in [storey.call_button, storey.floor_button] {
        let node = world.node(button).unwrap();
        assert!(node.affords(Property::Switchable) && node.is(State::Off));
    }
    let group = building.space().regions().find(|(_, region)| region.kind == RegionKind::Storey).unwrap().0;
    assert_eq!(building.scene(group), Err(BuildingError::NoScene(group)));
    assert_eq!(building.scene(RegionId(999)), Err(BuildingError::NoScene(RegionId(999))));
}

#[test]
fn a_frame_moves_a_building_and_nothing_in_it() {
    let there = RegionFrame::new([4000.0, -3000.0, 60.0], 0.6);
    let wishes = BuildingSpecification { frame: there, ..BuildingSpecification::default() };
    let (here, far) = (of(5), Building::generate(&wishes, Seed(5)).unwrap());
    assert_eq!(far.violations(), []);
    for region in scenes(&here) {
        assert_eq!(here.scene(region), far.scene(region));
        let [near, moved] = [&here, &far].map(|building| building.space().region(region).unwrap().frame);
        let expected = near.within(&there);
        assert!((moved.origin - expected.origin).norm() < 1e-9 && (moved.heading - expected.heading).abs() < 1e-9);
    }
}

#[test]
fn a_person_walks_from_every_front_door_to_all_that_the_gallery_leads_to() {
    for seed in 0..vc_testkit::amount(3, 20) {
        let building = of(seed);
        for (number, storey) in building.storeys().iter().enumerate() {
            let scene = building.scene(storey.gallery).unwrap();
            let places = walk::places(&building, storey.gallery);
            assert!(places.len() >= 4, "two front doors, the lift, stairs");
            let reached = Ground::new(&scene).from(places[0].1);
            for (name, place) in &places {
                assert!(reached.has(*place), "seed {seed}, storey {number}: no way to {name}");
            }
        }
    }
}

#[test]
fn railings_keep_everybody_on_the_gallery() {
    let building = of(2);
    for storey in building.storeys() {
        let scene = building.scene(storey.gallery).unwrap();
        let open: Vec<_> = walk::thresholds(&building, storey.gallery);
        let gaps = Ground::new(&scene).unguarded(&open);
        assert!(gaps.is_empty(), "one can fall at {gaps:?}");
    }
}

#[test]
fn wishes_that_cannot_be_met_are_told() {
    let with = |storeys| BuildingSpecification { storeys, ..BuildingSpecification::default() };
    for storeys in [0, 1, 9] {
        assert_eq!(Building::generate(&with(storeys), Seed(1)), Err(BuildingError::Storeys(storeys)));
    }
    let crowded = Specification { bedrooms: Some(4), area: Some(20.0), ..Specification::default() };
    let wishes = BuildingSpecification { homes: crowded, ..BuildingSpecification::default() };
    assert!(matches!(Building::generate(&wishes, Seed(1)), Err(BuildingError::Home(_))));
}
