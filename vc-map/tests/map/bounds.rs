//! Files and descriptions that ask for far too much.

use proptest::prelude::*;
use vc_map::format::native;
use vc_map::{Building, Control, CrossSection, MapDraft, MapError, RoadClass, Strip, StripKind, Users};
use vc_testkit::cases;

use crate::town::{import, street};

/// A road of a length with some strips on each side.
fn road(metres: f64, strips: usize, strip: &Strip) -> MapDraft {
    let mut draft = MapDraft::new("road", 48.0, 11.0);
    let ends = [[0.0, 0.0], [metres, 0.0]].map(|at| draft.junction(at, Control::Priority));
    let side = vec![strip.clone(); strips];
    draft.road(ends[0], ends[1], RoadClass::Minor, CrossSection { forward: side.clone(), backward: side, median: 0.0 });
    draft
}

#[test]
fn long_roads_take_no_more_than_short_ones() {
    let parking = Strip::new(StripKind::Parking, 2.1, Users::NONE, 8.3);
    let [short, long] = [100.0, 1e6].map(|metres| road(metres, 20, &parking).build().unwrap());
    assert_eq!(short.bytes(), long.bytes());
    assert_eq!(long.bays().count(), 40 * 173_911);
    // A street of OpenStreetMap's that is as long as a map is wide.
    let file = r#"<osm><bounds minlat="44" minlon="0" maxlat="46" maxlon="22"/><node id="1" lat="45" lon="0"/><node id="2" lat="45" lon="22"/>
        <way id="3"><nd ref="1"/><nd ref="2"/><tag k="highway" v="road"/><tag k="parking:both" v="parallel"/></way></osm>"#;
    let (map, _) = import(file);
    assert!(map.roads()[0].line.length() > 1.7e6 && map.bytes() < 8_000, "{}", map.bytes());
}

#[test]
fn roads_of_too_many_strips_and_junctions_of_too_many_movements_are_refused() {
    let parking = Strip::new(StripKind::Parking, 2.1, Users::NONE, 8.3);
    let error = road(60_000.0, 20_000, &parking).build().unwrap_err();
    assert_eq!(error.to_string(), "road 0 has 20000 strips on a side, at most 32 are possible: split it");
    // Thirty streets of forty lanes each, in two bundles.
    let mut draft = MapDraft::new("bundles", 48.0, 11.0);
    let middle = draft.junction([0.0, 0.0], Control::Priority);
    for arm in 0..30 {
        let (x, y) = (if arm % 2 == 0 { 300.0 } else { -300.0 }, f64::from(arm));
        let end = draft.junction([x, y], Control::Edge);
        let side = vec![Strip::driving(3.0, 13.9); 20];
        draft.road(
            end,
            middle,
            RoadClass::Primary,
            CrossSection { forward: side.clone(), backward: side, median: 0.0 },
        );
    }
    assert!(matches!(draft.build(), Err(MapError::TooMany { what: "movements", .. })));
}

#[test]
fn a_line_of_many_points_under_many_lanes_is_refused_for_its_memory() {
    let mut draft = road(1000.0, 32, &Strip::driving(3.0, 8.3));
    draft.roads[0].line = (0..100_000).map(|i| [f64::from(i) / 100.0, f64::from(i % 2) / 1000.0]).collect();
    let error = draft.build().unwrap_err().to_string();
    assert!(error.starts_with("with road 0 the map takes more than "), "{error}");
}

#[test]
fn every_part_of_a_map_counts() {
    let empty = MapDraft::new("", 48.0, 11.0);
    let bytes = |change: fn(&mut MapDraft)| {
        let mut draft = empty.clone();
        change(&mut draft);
        draft.build().unwrap().bytes()
    };
    let none = bytes(|_| ());
    for change in [
        (|draft| draft.name = "x".repeat(1000)) as fn(&mut MapDraft),
        |draft| draft.buildings.push(Building::new((0..100).map(|i| [f64::from(i), f64::from(i * i)]).collect(), 3)),
        |draft| {
            draft.junctions = (0..100)
                .map(|i| vc_map::JunctionDraft { at: [f64::from(i), 0.0], control: Control::Edge, source: vec![1] })
                .collect()
        },
    ] {
        assert!(bytes(change) >= none + 1000);
    }
}

/// A description of random places, links and widths.
pub(crate) fn any_draft() -> impl Strategy<Value = MapDraft> {
    let places = prop::collection::vec((-300.0..300.0, -300.0..300.0), 2..12);
    let links = prop::collection::vec((0usize..12, 0usize..12, 0usize..16, 1.0..4.0, 0.0..6.0, 1usize..4), 1..20);
    (places, links, any::<bool>()).prop_map(|(places, links, left)| {
        let mut draft = MapDraft::new("random", 48.123_456_789, 11.0);
        draft.side = if left { vc_map::DrivingSide::Left } else { vc_map::DrivingSide::Right };
        let controls = [Control::Priority, Control::Signals, Control::AllWayStop];
        let ids: Vec<_> =
            places.iter().enumerate().map(|(i, (x, y))| draft.junction([*x, *y], controls[i % 3])).collect();
        for (from, to, class, width, median, lanes) in links {
            let (from, to) = (ids[from % ids.len()], ids[to % ids.len()]);
            if from != to {
                let mut section = street(lanes);
                section.median = median;
                section.forward.push(Strip::driving(width, 10.0));
                draft.road(from, to, RoadClass::ALL[class], section);
            }
        }
        draft
    })
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn the_nearest_lane_is_that_of_a_look_at_all(draft in any_draft(), x in -900.0..900.0, y in -900.0..900.0, within in 1.0..900.0) {
        let Ok(map) = draft.build() else { return Ok(()) };
        let point = vc_map::Point::new(x, y);
        let away = |lane: &vc_map::Lane| lane.line.project(&point).left.abs();
        let all = map.lanes().iter().filter(|lane| lane.users.has(Users::FOOT)).map(away);
        let least = all.fold(f64::INFINITY, f64::min);
        let found = map.lane_near(&point, Users::FOOT, within).map(|(lane, _)| away(map.lane(lane).unwrap()));
        prop_assert_eq!(found, Some(least).filter(|least| *least <= within));
    }

    #[test]
    fn a_map_takes_at_most_the_memory_that_it_may(draft in any_draft(), most in 2_000usize..300_000) {
        match draft.build_within(most) {
            Ok(map) => prop_assert!(map.bytes() <= most, "{} {most}", map.bytes()),
            Err(MapError::TooLarge { most: told, .. }) => prop_assert_eq!(told, most),
            Err(_) => {}
        }
    }
}

#[test]
fn files_of_long_lines_under_many_lanes_are_refused_at_twenty_times_their_size() {
    let line: Vec<String> = (0..400_000).map(|i| format!("[{i},.{}]", i % 9).replace(",.", ",0.")).collect();
    let lane = r#"{"kind":"path","width":1,"users":["bicycle"],"limit":1}"#;
    let file = format!(
        r#"{{"virtualcity_map":1,"map":{{"name":"","origin":{{"latitude":0,"longitude":0}},"junctions":[{{"at":[0,0]}},{{"at":[9,9]}}],
        "roads":[{{"from":0,"to":1,"class":"path","line":[{}],"section":{{"forward":[{}]}}}}]}}}}"#,
        line.join(","),
        vec![lane; 32].join(",")
    );
    let error = native::read(&file).unwrap_err().to_string();
    let most = (16 << 20) + 18 * file.len();
    assert!(error.starts_with(&format!("with road 0 the map takes more than {most} bytes")), "{error}");
}

#[test]
fn the_town_takes_less_than_twenty_times_its_file() {
    let (map, _) = crate::town::riverside();
    assert!(map.bytes() < 20 * native::write(&map).len());
}
