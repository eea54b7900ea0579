//! Forms that are written, and read again where they can be.

use proptest::prelude::*;
use vc_graph::ClassTable;
use vc_graph::format::thesis;
use vc_map::format::{geojson, native, opendrive, skeleton, sumo};
use vc_map::{Control, DrivingSide, MapDraft, MapViolation, RoadClass, Strip};
use vc_testkit::cases;

use crate::town::{riverside, street};

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
    fn random_maps_are_read_as_they_were_written(
        places in prop::collection::vec((-2000.0..2000.0, -2000.0..2000.0), 2..12),
        links in prop::collection::vec((0usize..12, 0usize..12, 0usize..16, 1.0..4.0), 1..20),
        left: bool,
    ) {
        let mut draft = MapDraft::new("random", 48.123_456_789, 11.0);
        draft.side = if left { DrivingSide::Left } else { DrivingSide::Right };
        let controls = [Control::Priority, Control::Signals, Control::AllWayStop];
        let ids: Vec<_> = places.iter().enumerate().map(|(i, (x, y))| draft.junction([*x, *y], controls[i % 3])).collect();
        for (from, to, class, width) in links {
            let (from, to) = (ids[from % ids.len()], ids[to % ids.len()]);
            if from != to {
                let mut section = street(1 + class % 3);
                section.forward.push(Strip::driving(width, 10.0));
                draft.road(from, to, RoadClass::ALL[class], section);
            }
        }
        let Ok(map) = draft.build() else { return Ok(()) };
        prop_assert!(native::read(&native::write(&map)).unwrap() == map);
        let wrong = |v: &MapViolation| matches!(v, MapViolation::UnsafePhase { .. } | MapViolation::NeverGreen { .. });
        let found: Vec<_> = map.validate().into_iter().filter(wrong).collect();
        prop_assert_eq!(found, []);
        prop_assert!(geojson::write(&map).lines().count() > 2);
    }
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
