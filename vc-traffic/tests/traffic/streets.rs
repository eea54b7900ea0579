//! Streets without pavements and without crossings.

use vc_graph::Seed;
use vc_map::{
    Building, BuildingId, Control, CrossSection, EntranceDraft, EntranceId, MapDraft, RoadClass, StreetMap, Strip,
    Users,
};
use vc_traffic::{Kerb, Traffic, TrafficEvent, TrafficOptions, Trip, Walk};

use crate::people::{hit, overlap};

/// A street of 300 m with houses on both sides and no pavements.
fn street() -> StreetMap {
    let mut draft = MapDraft::new("street", 48.0, 11.0);
    let ends = [[0.0, 0.0], [150.0, 0.0], [300.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
    let mut lane = Strip::driving(2.75, 8.3);
    lane.users = lane.users | Users::FOOT;
    for pair in ends.windows(2) {
        let section = CrossSection { forward: vec![lane.clone()], backward: vec![lane.clone()], median: 0.0 };
        _ = draft.road(pair[0], pair[1], RoadClass::Residential, section);
    }
    for number in 0..20 {
        let side = if number % 2 == 0 { 1.0 } else { -1.0 };
        let [x, y] = [20.0 + 13.0 * f64::from(number), 6.0 * side];
        draft.buildings.push(Building::new(vec![[x, y], [x + 4.0, y + 8.0 * side], [x - 4.0, y + 8.0 * side]], 2));
        let building = BuildingId(draft.buildings.len() as u32 - 1);
        draft.entrances.push(EntranceDraft { building, at: [x, y], kind: "main".into(), source: 0 });
    }
    draft.build().unwrap()
}

#[test]
fn people_walk_beside_streets_without_pavements_and_cross_in_gaps() {
    let map = street();
    let mut numbers = Seed(2).stream();
    let mut walk = |_| {
        let [from, to] = [0, 1].map(|_| EntranceId(numbers.below(20) as u32));
        Walk { departs: numbers.between(0.0, 300.0), from, to }
    };
    let walks: Vec<Walk> = (0..120).map(&mut walk).filter(|walk| walk.from != walk.to).collect();
    let count = walks.len();
    let trip = |number: usize| {
        let forward = number.is_multiple_of(2);
        let roads = map.lanes().iter().filter(|lane| lane.forward == forward && lane.users.has(Users::CAR));
        let kerb = |lane: &vc_map::Lane, station| Kerb { road: lane.road, forward, station };
        let mut lanes: Vec<_> = roads.collect();
        lanes.sort_by(|a, b| a.line.start().x.total_cmp(&b.line.start().x));
        let [first, last] = if forward { [0, 1] } else { [1, 0] };
        let (from, to) = (kerb(lanes[first], 15.0), kerb(lanes[last], 140.0));
        Trip { class: 0, departs: number as f32 * 4.0, from, to }
    };
    // A vehicle every eight seconds in each direction.
    let traffic = Traffic::new(&map, (0..100).map(trip).collect(), &TrafficOptions::default(), Seed(1)).unwrap();
    let mut traffic = traffic.with_walks(walks).unwrap();
    let (mut arrived, mut reached, mut crossed, mut along) = (0, 0, 0, 0);
    for step in 0..9000 {
        traffic.step();
        assert_eq!(traffic.overlaps(), [], "step {step}");
        assert_eq!(overlap(traffic.people().map(|walker| walker.at)), None, "step {step}");
        assert_eq!(hit(&traffic), None, "step {step}");
        // Whoever is in the middle of the road goes across it.
        for walker in traffic.people().filter(|walker| walker.at[1].abs() < 1.5) {
            let [x, y] = walker.velocity.map(f32::abs);
            crossed += 1;
            along += usize::from(x > y.max(0.3));
        }
        for event in traffic.events() {
            match event {
                TrafficEvent::Arrived { .. } => arrived += 1,
                TrafficEvent::Reached { .. } => reached += 1,
                TrafficEvent::Stuck { .. } | TrafficEvent::StuckOnFoot { .. } => panic!("step {step}: {event:?}"),
                _ => {}
            }
        }
    }
    assert_eq!((arrived, reached), (100, count));
    assert!(crossed > 1000 && along < crossed / 20, "{crossed} {along}");
}
