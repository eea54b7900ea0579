//! Forms that are written, and read again where they can be.

use proptest::prelude::*;
use vc_graph::ClassTable;
use vc_graph::format::thesis;
use vc_map::format::{geojson, native, opendrive, skeleton, sumo};
use vc_map::{
    Building, BuildingId, Control, CrossSection, EntranceDraft, MapDraft, MapViolation, RoadClass, StopDraft, StopKind,
    Strip,
};
use vc_testkit::cases;

use crate::bounds::any_draft;
use crate::town::riverside;

#[test]
fn the_town_is_written_and_read_as_the_same_map() {
    let (map, _) = riverside();
    let text = native::write(&map);
    let again = native::read(&text).unwrap();
    assert!(again == map);
    assert_eq!(native::write(&again), text);
    assert_eq!(opendrive::write(&again), opendrive::write(&map));
    assert_eq!(sumo::write(&again, "town"), sumo::write(&map, "town"));
}

#[test]
fn a_map_of_another_kind_is_refused_with_line_and_field() {
    let error = |text: &str| native::read(text).unwrap_err().to_string();
    assert_eq!(
        error(r#"{"virtualcity_map": 9, "map": {}}"#),
        "the map has version 9, at most 1 is read: use a newer program"
    );
    assert!(
        error("{\n\"virtualcity_map\": 1,\n\"map\": {\"name\": 3}}").starts_with("line 3: map.name: "),
        "{}",
        error("{\n\"virtualcity_map\": 1,\n\"map\": {\"name\": 3}}")
    );
    assert!(error("nonsense").starts_with("line 1: "));
}

proptest! {
    #![proptest_config(cases(100))]

    #[test]
    fn random_maps_are_read_as_they_were_written(draft in any_draft()) {
        let Ok(map) = draft.build() else { return Ok(()) };
        prop_assert!(native::read(&native::write(&map)).unwrap() == map);
        let wrong = |v: &MapViolation| {
            use MapViolation::{Gap, MissingConflict, NeverGreen, ShortClearance, UnsafePhase};
            matches!(v, UnsafePhase { .. } | NeverGreen { .. } | ShortClearance { .. } | Gap { .. } | MissingConflict { .. })
        };
        let found: Vec<_> = map.validate().into_iter().filter(wrong).collect();
        prop_assert_eq!(found, []);
        prop_assert!(geojson::write(&map).lines().count() > 2);
    }

    #[test]
    fn numbers_that_are_accepted_are_read_as_they_were_written(
        [x, y, height, base] in prop::array::uniform4(any_number()),
        [width, limit, median] in prop::array::uniform3(any_number()),
        [latitude, longitude] in prop::array::uniform2(any_number()),
        storeys: u32,
        source: i64,
    ) {
        let mut draft = MapDraft::new("numbers", latitude, longitude);
        let ends = [draft.junction([x, y], Control::Signals), draft.junction([0.0, 0.0], Control::Priority)];
        let side = vec![Strip::driving(width, limit)];
        draft.road(ends[0], ends[1], RoadClass::Minor, CrossSection { forward: side.clone(), backward: side, median });
        draft.roads[0].source = vec![source];
        draft.buildings.push(Building { height, base, source, ..Building::new(vec![[x, y], [y, x], [0.0, -y]], 1) });
        draft.buildings[0].storeys = storeys;
        draft.entrances.push(EntranceDraft { building: BuildingId(0), at: [y, x], kind: "yes".to_owned(), source });
        draft.stops.push(StopDraft { kind: StopKind::Tram, at: [x, -y], name: None, source });
        // Each is tried alone as well, so that one that is refused does not hide the others.
        let mut alone = MapDraft::new("building", 48.0, 11.0);
        alone.buildings.push(Building { height, base, ..Building::new(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], 1) });
        for draft in [draft, alone] {
            if let Ok(map) = draft.build() {
                prop_assert!(native::read(&native::write(&map)).unwrap() == map);
                prop_assert!(map.buildings().iter().all(|b| b.height.is_finite() && b.base.is_finite()));
                let _ = (skeleton::write(&map), opendrive::write(&map), sumo::write(&map, "x"), map.validate());
            }
        }
    }
}

/// Numbers of all sizes, and the bounds of what is accepted.
fn any_number() -> impl Strategy<Value = f64> {
    let bounds =
        [0.0, 0.1, 0.099_96, 89.0, -89.0, 90.0, 100.0, 100.000_04, 150.0, 180.0, -180.0, 1e6, -1e6, 1e305, f64::NAN];
    prop_oneof![4 => prop::sample::select(bounds.to_vec()), 4 => 0.1..80.0, 1 => any::<f64>(), 1 => -1e6..1e6]
}

#[test]
fn buildings_that_begin_beyond_all_numbers_are_refused() {
    let text = r#"{"virtualcity_map":1,"map":{"name":"","origin":{"latitude":0,"longitude":0},
        "buildings":[{"outline":[[0,0],[1,0],[0,1]],"height":3,"base":1e305,"storeys":1,"kind":"yes"}]}}"#;
    let error = native::read(text).unwrap_err().to_string();
    assert!(
        error.starts_with("the base in metres of building 0 is 1000")
            && error.ends_with("give one from -1000000 to 1000000"),
        "{error}"
    );
}

#[test]
fn geojson_has_degrees_of_the_place_and_the_thesis_reads_the_skeleton() {
    let (map, _) = riverside();
    let features: serde_json::Value = serde_json::from_str(&geojson::write(&map)).unwrap();
    let features = features["features"].as_array().unwrap();
    assert_eq!(features.iter().filter(|f| f["properties"]["kind"] == "building").count(), map.buildings().len());
    for feature in features.iter().filter(|feature| feature["geometry"]["type"] == "Point") {
        let place = feature["geometry"]["coordinates"].as_array().unwrap();
        assert!((place[0].as_f64().unwrap() - 11.0).abs() < 0.02 && (place[1].as_f64().unwrap() - 48.0).abs() < 0.02);
    }
    let scene = thesis::read(&skeleton::write(&map).unwrap(), &ClassTable::builtin()).unwrap();
    assert_eq!(scene.nodes().filter(|node| &**node.class() == "building").count(), map.buildings().len());
}

#[test]
fn stops_of_buses_and_trams_stand_in_the_skeleton() {
    let (map, _) = riverside();
    let scene = skeleton::scene(&map).unwrap();
    let count = |kind: StopKind| map.stops().iter().filter(|stop| stop.kind == kind).count();
    let stops = scene.nodes().filter(|node| &**node.class() == "bus_stop").count();
    assert!(count(StopKind::Tram) > 0 && stops == count(StopKind::Bus) + count(StopKind::Tram));
}

#[test]
fn streets_of_equals_give_way_to_the_right_in_sumo_and_private_ones_are_closed_to_passenger_cars() {
    let kinds = |change: fn(&mut MapDraft)| {
        let mut draft = crate::town::crossroads(Control::Priority, vc_map::DrivingSide::Right, 1).0.draft().clone();
        change(&mut draft);
        let files = sumo::write(&draft.build().unwrap(), "x");
        (files.nodes.matches("right_before_left").count(), files.edges.matches(" passenger ").count())
    };
    assert_eq!(kinds(|_| ()), (1, 8));
    assert_eq!(kinds(|draft| draft.roads[0].class = RoadClass::Residential), (0, 8));
    assert_eq!(kinds(|draft| draft.roads[0].slip = true), (0, 8));
    assert_eq!(kinds(|draft| draft.junctions[0].control = Control::Signals), (0, 8));
    assert_eq!(kinds(|draft| draft.roads[0].private = true), (1, 6));
}

#[test]
fn nobody_waits_in_sumo_before_a_road_on_which_no_vehicle_has_room() {
    let waits = |length: f64| {
        let mut draft = MapDraft::new("x", 48.1, 11.6);
        let ends = [0.0, 100.0, 100.0 + length].map(|x| draft.junction([x, 0.0], Control::Priority));
        let section = CrossSection { forward: vec![Strip::driving(3.0, 8.3)], ..CrossSection::default() };
        for pair in ends.windows(2) {
            draft.road(pair[0], pair[1], RoadClass::Residential, section.clone());
        }
        let files = sumo::write(&draft.build().unwrap(), "x");
        assert!(files.connections.contains(r#"from="r0" to="r1""#));
        !files.connections.contains(r#"keepClear="false""#)
    };
    assert!(!waits(10.0) && waits(100.0));
}
