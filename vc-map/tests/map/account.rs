//! The account of an import: nothing is lost without an entry.

use vc_map::osm::{Element, Guessed, ImportReport, Reason};
use vc_map::{DrivingSide, Users};

use crate::osm::{CROSS, file, street};
use crate::town::import;

pub(crate) fn ignored(report: &ImportReport, element: Element, tag: &str) -> bool {
    report.ignored.contains(&(element, tag.to_owned()))
}

#[test]
fn ways_that_are_merged_keep_their_numbers() {
    let nodes = [CROSS.as_slice(), &[(6, 2.0, 0.0, "")]].concat();
    let all = "highway=residential lanes=2 maxspeed=30 sidewalk=both width=6";
    let ways: [(i64, &[i64], &str); 4] =
        [(10, &[6, 2], all), (11, &[2, 1], all), (12, &[3, 1, 5], all), (13, &[1, 4], "highway=tertiary")];
    let ban = r#"<relation id="1"><member type="way" ref="10" role="from"/><member type="node" ref="1" role="via"/>
        <member type="way" ref="12" role="to"/><tag k="type" v="restriction"/><tag k="restriction" v="no_right_turn"/></relation>"#;
    // The way beside the junction is 11, and both are one road.
    let (map, report) = import(&file(&nodes, &ways, ban));
    let sources: Vec<_> = map.roads().iter().map(|road| road.draft.source.clone()).collect();
    assert!(sources.contains(&vec![10, 11]), "{sources:?}");
    assert_eq!(report.dropped, [], "{report}");
    assert_eq!(map.draft().bans.len(), 1);
}

#[test]
fn every_value_that_a_rule_gave_is_listed() {
    let (_, report) = street("highway=secondary bridge=yes");
    let guessed: Vec<Guessed> = report.guessed.iter().map(|(_, guessed)| *guessed).collect();
    for value in
        [Guessed::Lanes(2), Guessed::Width(3.25), Guessed::Limit(50.0 / 3.6), Guessed::Pavements(2), Guessed::Layer(1)]
    {
        assert!(guessed.contains(&value), "{value}: {report}");
    }
    assert_eq!(report.general, [Guessed::Side(DrivingSide::Right)]);
    let (_, report) = street("highway=secondary bridge=yes layer=1 lanes=2 width=7 maxspeed=50 sidewalk=both");
    assert_eq!(report.guessed.iter().filter(|(element, _)| *element == Element::Way(9)).count(), 0, "{report}");
    let (_, report) = street("highway=footway");
    assert!(report.guessed.contains(&(Element::Way(9), Guessed::Width(2.0))));
    // The pavement of one side is a way of its own.
    let nodes = [(1, 0.0, 0.0, ""), (2, 1.0, 0.0, ""), (3, 0.0, 0.08, ""), (4, 1.0, 0.08, "")];
    let ways: [(i64, &[i64], &str); 2] =
        [(9, &[1, 2], "highway=residential"), (8, &[3, 4], "highway=footway footway=sidewalk")];
    let (_, report) = import(&file(&nodes, &ways, ""));
    assert!(report.guessed.contains(&(Element::Way(9), Guessed::Pavements(1))), "{report}");
}

#[test]
fn each_tag_and_each_element_is_in_the_map_or_in_the_account() {
    let nodes = [
        (1, 0.0, 0.0, "highway=turning_circle"),
        (2, 1.0, 0.0, "barrier=height_restrictor"),
        (3, 0.0, 1.0, "highway=milestone"),
        (4, -1.0, 0.0, "natural=tree"),
        (5, 0.0, -1.0, "highway=crossing crossing=zebra tactile_paving=yes"),
        (6, 0.5, 0.0, "emergency=phone"),
        (7, 9.0, 9.0, "shop=bakery"),
    ];
    let ways: [(i64, &[i64], &str); 4] = [
        (8, &[4, 1, 6, 2], "highway=secondary surface=asphalt lit=yes name=x"),
        (9, &[3, 1, 5], "highway=residential surface=asphalt"),
        (10, &[1, 2, 3, 1], "building=yes amenity=bank building:levels=two"),
        (11, &[2, 3], "power=line"),
    ];
    let relation = r#"<relation id="5"><member type="way" ref="8" role=""/><tag k="type" v="route"/></relation>"#;
    let (_, report) = import(&file(&nodes, &ways, relation));
    for (element, tag) in [
        (Element::Node(1), "highway=turning_circle"),
        (Element::Node(2), "barrier=height_restrictor"),
        (Element::Node(3), "highway=milestone"),
        (Element::Way(10), "building:levels=two"),
    ] {
        assert!(ignored(&report, element, tag), "{tag}: {report}");
    }
    for element in [Element::Node(6), Element::Node(7), Element::Way(11), Element::Relation(5)] {
        assert!(report.dropped.contains(&(element, Reason::NoUse)), "{element}: {report}");
    }
    let unread = ["surface", "lit", "tactile_paving", "amenity"].map(|key| report.unread[key]);
    assert_eq!(unread, [2, 1, 1, 1]);
    assert!(!report.unread.contains_key("shop") && !report.unread.contains_key("name"));
}

#[test]
fn relations_and_ways_of_one_number_are_told_apart() {
    let square = |id: i64, x: f64| {
        [(id, x, 0.1, ""), (id + 1, x + 0.2, 0.1, ""), (id + 2, x + 0.2, 0.3, ""), (id + 3, x, 0.3, "")]
    };
    let nodes = [CROSS.as_slice(), &square(11, 0.3), &square(21, 0.6)].concat();
    let ways: [(i64, &[i64], &str); 4] = [
        (1, &[4, 1, 2], "highway=residential"),
        (2, &[11, 12, 13, 14, 11], ""),
        (5, &[3, 1], "power=line"),
        (6, &[2, 3, 4, 2], "highway=service area=yes"),
    ];
    let relation = r#"<relation id="5"><member type="way" ref="2" role="outer"/><tag k="type" v="multipolygon"/><tag k="building" v="yes"/></relation>"#;
    let (map, report) = import(&file(&nodes, &ways, relation));
    assert!(report.guessed.contains(&(Element::Relation(5), Guessed::Entrance)), "{report}");
    assert!(!report.guessed.iter().any(|(element, _)| *element == Element::Way(5)));
    assert!(report.dropped.contains(&(Element::Way(5), Reason::NoUse)));
    // A square is no street, and not lost.
    assert_eq!(map.areas().len(), 1);
    assert!(!report.dropped.iter().any(|(element, _)| *element == Element::Way(6)), "{report}");
}

#[test]
fn elements_that_come_twice_or_were_deleted() {
    let text = r#"<osm><node id="1" lat="48" lon="11"/><node id="2" lat="48.001" lon="11"/><node id="2" lat="49" lon="11"/>
        <node id="3" action="delete"/><way id="7"><nd ref="1"/><nd ref="2"/><tag k="highway" v="residential"/></way>
        <way id="7"><nd ref="2"/><nd ref="1"/><tag k="highway" v="primary"/></way>
        <way id="8" action="delete"><nd ref="2"/><nd ref="1"/><tag k="highway" v="primary"/></way>
        <way id="9" visible="false"><nd ref="2"/><nd ref="1"/><tag k="highway" v="primary"/></way></osm>"#;
    let (map, report) = import(text);
    assert_eq!(map.roads().len(), 1);
    assert_eq!(report.dropped, [(Element::Node(2), Reason::Repeated), (Element::Way(7), Reason::Repeated)]);
}

#[test]
fn holes_outside_and_members_that_close_no_ring_are_told() {
    let square = |id: i64, x: f64| {
        [(id, x, 0.0, ""), (id + 1, x + 0.2, 0.0, ""), (id + 2, x + 0.2, 0.2, ""), (id + 3, x, 0.2, "")]
    };
    let nodes = [square(11, 0.3), square(21, 0.6)].concat();
    let ways: [(i64, &[i64], &str); 3] =
        [(1, &[11, 12, 13, 14, 11], ""), (2, &[21, 22, 23, 24, 21], ""), (3, &[21, 22], "")];
    let relation = |id: i64, role: &str, way: i64| {
        format!(
            r#"<relation id="{id}"><member type="way" ref="1" role="outer"/><member type="way" ref="{way}" role="{role}"/>
            <tag k="type" v="multipolygon"/><tag k="natural" v="water"/></relation>"#
        )
    };
    let (map, report) = import(&file(&nodes, &ways, &(relation(1, "inner", 2) + &relation(2, "outer", 3))));
    assert_eq!(map.areas().len(), 2);
    for found in [(Element::Relation(1), Reason::HoleOutside), (Element::Relation(2), Reason::OpenRing)] {
        assert!(report.dropped.contains(&found), "{report}");
    }
}

#[test]
fn words_that_are_no_users_are_refused_with_the_list() {
    let map = |users: &str| {
        format!(
            r#"{{"virtualcity_map":1,"map":{{"name":"","origin":{{"latitude":0,"longitude":0}},
            "junctions":[{{"at":[0,0]}},{{"at":[9,0]}}],"roads":[{{"from":0,"to":1,"line":[[0,0],[9,0]],"class":"residential",
            "section":{{"forward":[{{"kind":"driving","width":3,"users":[{users}],"limit":9}}]}}}}]}}}}"#
        )
    };
    assert!(vc_map::format::native::read(&map("\"car\",\"bus\"")).is_ok());
    for word in ["cars", "Car"] {
        let error = vc_map::format::native::read(&map(&format!("\"{word}\""))).unwrap_err().to_string();
        assert!(error.contains(&format!("`{word}` is none of: car, bus, bicycle, foot, tram, train")), "{error}");
    }
    assert_eq!(format!("{:?} {:?}", Users::NONE, Users::CAR | Users::BUS), "none car|bus");
}
