//! OpenStreetMap's oddities, each as a small file.

use std::fmt::Write;

use vc_map::osm::{Element, Guessed, ImportOptions, ImportReport, OsmData, OsmError, Reason};
use vc_map::{Control, CrossingKind, DrivingSide, RoadClass, StreetMap, StripKind, Users};

use crate::town::import;

/// A file of nodes, in hundreds of metres from 48 N, 11 E, and ways as lists of nodes with tags.
pub(crate) fn file(nodes: &[(i64, f64, f64, &str)], ways: &[(i64, &[i64], &str)], rest: &str) -> String {
    let tags = |text: &str| -> String {
        text.split_whitespace().map(|tag| tag.split_once('=').unwrap()).fold(String::new(), |mut all, (key, value)| {
            write!(all, r#"<tag k="{key}" v="{value}"/>"#).unwrap();
            all
        })
    };
    let mut text = "<osm version=\"0.6\">\n".to_owned();
    for (id, x, y, marks) in nodes {
        let (lat, lon) = (48.0 + y * 100.0 / 111_195.0, 11.0 + x * 100.0 / 74_400.0);
        writeln!(text, r#"<node id="{id}" lat="{lat}" lon="{lon}">{}</node>"#, tags(marks)).unwrap();
    }
    for (id, refs, marks) in ways {
        let refs: String = refs.iter().map(|id| format!(r#"<nd ref="{id}"/>"#)).collect();
        writeln!(text, r#"<way id="{id}">{refs}{}</way>"#, tags(marks)).unwrap();
    }
    format!("{text}{rest}</osm>")
}

/// A crossroads at node 1 with arms to nodes 2 to 5.
pub(crate) const CROSS: [(i64, f64, f64, &str); 5] =
    [(1, 0.0, 0.0, ""), (2, 1.0, 0.0, ""), (3, 0.0, 1.0, ""), (4, -1.0, 0.0, ""), (5, 0.0, -1.0, "")];

/// A street of 100 m with these tags.
pub(crate) fn street(tags: &str) -> (StreetMap, ImportReport) {
    import(&file(&[(1, 0.0, 0.0, ""), (2, 1.0, 0.0, "")], &[(9, &[1, 2], tags)], ""))
}

#[test]
fn lanes_limits_and_one_way_streets_in_both_directions() {
    let tags = [("oneway=yes", 0.0), ("oneway=-1", 1.0)];
    for (oneway, from) in tags {
        let way = format!("highway=residential {oneway} maxspeed=30 lanes=2 sidewalk=right");
        let (map, _) = import(&file(&[(1, 0.0, 0.0, ""), (2, 1.0, 0.0, "")], &[(9, &[1, 2], &way)], ""));
        let drives: Vec<_> = map.lanes().iter().filter(|lane| lane.users.has(Users::CAR)).collect();
        assert_eq!(drives.len(), 2);
        let line = &drives[0].line;
        assert_eq!(line.start().x > line.end().x, from > 0.0, "{oneway}");
        assert!((drives[0].limit - 30.0 / 3.6).abs() < 1e-3);
        // The pavement stays on the side that is right of the way as it is drawn: south.
        let pavement = map.lanes().iter().find(|lane| lane.kind == StripKind::Pavement).unwrap();
        assert!(pavement.line.start().y < line.start().y, "{oneway}");
    }
    let (map, _) =
        import(&file(&[(1, 0.0, 0.0, ""), (2, 1.0, 0.0, "")], &[(9, &[1, 2], "highway=primary maxspeed=30mph")], ""));
    assert!((map.lanes()[0].limit - 13.4112).abs() < 1e-3);
}

#[test]
fn bridges_do_not_meet_the_street_below() {
    let nodes = [(1, -1.0, 0.0, ""), (2, 1.0, 0.0, ""), (3, 0.0, -1.0, ""), (4, 0.0, 1.0, "")];
    let ways: [(i64, &[i64], &str); 2] =
        [(8, &[1, 2], "highway=secondary"), (9, &[3, 4], "highway=secondary bridge=yes layer=1")];
    let (map, _) = import(&file(&nodes, &ways, ""));
    assert_eq!((map.roads().len(), map.junctions().len()), (2, 4));
    assert_eq!(map.roads().iter().map(|road| road.draft.layer).max(), Some(1));
}

#[test]
fn a_signal_before_a_junction_rules_the_junction() {
    let mut nodes = CROSS.to_vec();
    nodes.push((6, 0.3, 0.0, "highway=traffic_signals traffic_signals:direction=backward"));
    let ways: [(i64, &[i64], &str); 2] =
        [(8, &[4, 1, 6, 2], "highway=secondary"), (9, &[3, 1, 5], "highway=secondary")];
    let (map, report) = import(&file(&nodes, &ways, ""));
    let lit: Vec<_> = map.junctions().iter().filter(|junction| junction.draft.control == Control::Signals).collect();
    assert!(matches!(lit[..], [junction] if junction.draft.source.contains(&1)), "{lit:?}");
    assert!(report.guessed.contains(&(Element::Node(6), Guessed::SignalAt(1))));
}

#[test]
fn the_four_nodes_of_a_dual_carriageway_are_one_junction() {
    let near = 0.06;
    let corners = [(-near, -near), (near, -near), (near, near), (-near, near)];
    let mut nodes: Vec<(i64, f64, f64, &str)> =
        corners.iter().enumerate().map(|(i, (x, y))| (i as i64 + 1, *x, *y, "highway=traffic_signals")).collect();
    for (id, x, y) in [
        (11, -1.0, -near),
        (12, 1.0, -near),
        (13, 1.0, near),
        (14, -1.0, near),
        (21, -near, -1.0),
        (22, -near, 1.0),
        (23, near, 1.0),
        (24, near, -1.0),
    ] {
        nodes.push((id, x, y, ""));
    }
    let one_way = "highway=primary oneway=yes lanes=2";
    let ways: [(i64, &[i64], &str); 4] = [
        (1, &[11, 1, 2, 12], one_way),
        (2, &[13, 3, 4, 14], one_way),
        (3, &[22, 4, 1, 21], one_way),
        (4, &[24, 2, 3, 23], one_way),
    ];
    let (map, _) = import(&file(&nodes, &ways, ""));
    let lit: Vec<_> = map.junctions().iter().filter(|junction| junction.draft.control == Control::Signals).collect();
    assert!(matches!(lit[..], [junction] if junction.arms.len() == 8 && junction.draft.source.len() == 4), "{lit:?}");
    assert_eq!(map.signals().len(), 1);
}

#[test]
fn roundabouts_tell_the_side_and_stay_rings() {
    for (ring, side) in [([1, 2, 3, 4, 1], DrivingSide::Right), ([1, 4, 3, 2, 1], DrivingSide::Left)] {
        let nodes = [
            (1, 0.2, 0.0, ""),
            (2, 0.0, 0.2, ""),
            (3, -0.2, 0.0, ""),
            (4, 0.0, -0.2, ""),
            (5, 1.0, 0.0, ""),
            (6, -1.0, 0.0, ""),
        ];
        let ways: [(i64, &[i64], &str); 3] = [
            (7, &ring, "highway=primary junction=roundabout"),
            (8, &[5, 1], "highway=primary"),
            (9, &[3, 6], "highway=primary"),
        ];
        let (map, _) = import(&file(&nodes, &ways, ""));
        assert_eq!(map.side(), side);
        assert_eq!(map.roads().iter().filter(|road| road.draft.roundabout).count(), 2);
    }
}

#[test]
fn a_crossing_joins_the_paths_on_both_sides_of_a_fast_street_whichever_way_it_is_drawn() {
    let nodes = [
        (1, 0.0, 0.0, "highway=crossing crossing=marked"),
        (2, 1.0, 0.0, ""),
        (3, 0.0, 0.3, ""),
        (4, -1.0, 0.0, ""),
        (5, 0.0, -0.3, ""),
    ];
    for (street, path) in [([2, 1, 4], [3, 1, 5]), ([4, 1, 2], [3, 1, 5]), ([2, 1, 4], [5, 1, 3])] {
        let ways: [(i64, &[i64], &str); 2] =
            [(8, &street, "highway=trunk maxspeed=70 oneway=yes lanes=4"), (9, &path, "highway=footway")];
        let (map, _) = import(&file(&nodes, &ways, ""));
        assert_eq!(map.walk_parts().len(), 1, "{street:?} {path:?}");
        assert_eq!(map.crossings().iter().map(|c| c.kind).collect::<Vec<_>>(), [CrossingKind::Marked]);
    }
}

#[test]
fn crossings_with_and_without_footways_lights_and_marks() {
    let nodes = [
        (1, -1.0, 0.0, ""),
        (2, 0.0, 0.0, "highway=crossing crossing=traffic_signals"),
        (3, 1.0, 0.0, ""),
        (4, 0.0, 0.3, ""),
        (5, 0.0, -0.3, ""),
        (6, 0.5, 0.0, "highway=crossing crossing=zebra crossing:island=yes"),
    ];
    let ways: [(i64, &[i64], &str); 3] = [
        (7, &[1, 2, 6, 3], "highway=secondary sidewalk=both"),
        (8, &[4, 2], "highway=footway"),
        (9, &[2, 5], "highway=footway"),
    ];
    let (map, _) = import(&file(&nodes, &ways, ""));
    let kinds: Vec<_> =
        map.crossings().iter().filter(|crossing| !crossing.guessed).map(|c| (c.kind, c.island)).collect();
    assert!(
        kinds.contains(&(CrossingKind::Signals, false)) && kinds.contains(&(CrossingKind::Marked, true)),
        "{kinds:?}"
    );
    assert_eq!((map.signals().len(), map.walk_parts().len()), (1, 1));
    // People have a phase of their own, vehicles another.
    assert!(map.signals()[0].phases.len() >= 4);
    assert_eq!(map.validate(), []);
}

#[test]
fn buildings_from_ways_and_relations_with_heights_and_doors() {
    let nodes = [
        (1, 0.0, 0.0, ""),
        (2, 0.2, 0.0, "entrance=main"),
        (3, 0.2, 0.2, ""),
        (4, 0.0, 0.2, ""),
        (5, 0.05, 0.05, ""),
        (6, 0.15, 0.05, ""),
        (7, 0.15, 0.15, ""),
        (8, -1.0, -0.1, ""),
        (9, 1.0, -0.1, ""),
        (11, 0.4, 0.0, ""),
        (12, 0.5, 0.0, ""),
        (13, 0.5, 0.1, ""),
    ];
    let ways: [(i64, &[i64], &str); 5] = [
        (1, &[1, 2, 3], ""),
        (2, &[1, 4, 3], ""),
        (3, &[5, 6, 7, 5], ""),
        (4, &[8, 9], "highway=residential"),
        (5, &[11, 12, 13, 11], "building=yes height=33ft"),
    ];
    let relation = r#"<relation id="1"><member type="way" ref="1" role="outer"/><member type="way" ref="2" role="outer"/>
        <member type="way" ref="3" role="inner"/><tag k="type" v="multipolygon"/><tag k="building" v="retail"/>
        <tag k="building:levels" v="4"/></relation>"#;
    let (map, report) = import(&file(&nodes, &ways, relation));
    let [court, small] = map.buildings() else { panic!("{:?}", map.buildings()) };
    assert_eq!((court.courts.len(), court.storeys, court.kind.as_str()), (1, 4, "retail"));
    assert!((small.height - 33.0 * 0.3048).abs() < 1e-3);
    let doors: Vec<_> = map.entrances().iter().map(|entrance| (entrance.building.0, entrance.guessed)).collect();
    assert_eq!(doors, [(0, false), (1, true)]);
    assert!(report.guessed.contains(&(Element::Way(5), Guessed::Entrance)));
}

#[test]
fn doors_lead_out_of_their_building_and_what_lies_below_the_ground_is_told() {
    // A house with its guessed door to the street in the south, a station below the street, and a court with a door into it.
    let nodes = [
        (1, -1.0, 0.0, ""),
        (2, 1.0, 0.0, ""),
        (3, -0.5, 0.02, ""),
        (4, 0.5, 0.02, ""),
        (5, 0.5, -0.3, ""),
        (6, -0.5, -0.3, ""),
        (11, -0.2, 0.1, ""),
        (12, 0.2, 0.1, ""),
        (13, 0.2, 0.4, ""),
        (14, 0.0, 0.4, "entrance=yes"),
        (15, -0.2, 0.4, ""),
        (16, -1.0, 1.0, ""),
        (17, 1.0, 1.0, ""),
    ];
    let ways: [(i64, &[i64], &str); 4] = [
        (1, &[1, 2], "highway=residential"),
        (2, &[3, 4, 5, 6, 3], "building=train_station layer=-1"),
        (3, &[11, 12, 13, 14, 15, 11], "building=yes"),
        (4, &[16, 17], "highway=footway"),
    ];
    let (map, report) = import(&file(&nodes, &ways, ""));
    assert_eq!(report.dropped, [(Element::Way(2), Reason::Underground)]);
    // The door in the north leads to the path there, though the street is nearer by air.
    let [door] = map.entrances() else { panic!("{:?}", map.entrances()) };
    let at = map.walk_edge(door.edge.unwrap()).unwrap().line.at(door.station);
    assert!((at.y - door.door.y - 60.0).abs() < 0.1, "{at:?}");
}

#[test]
fn extracts_cut_at_the_edge_lose_what_is_not_there_and_say_so() {
    let ways: [(i64, &[i64], &str); 7] = [
        (1, &[4, 1, 2, 99], "highway=residential"),
        (2, &[98, 97], "highway=residential"),
        (3, &[3, 5], "highway=construction"),
        (4, &[3, 3], "highway=residential"),
        (5, &[1, 2, 3, 99, 1], "building=yes"),
        (6, &[1, 2], "building=yes"),
        (7, &[1, 2, 3, 1], ""),
    ];
    let relations = r#"<relation id="1"><member type="way" ref="7" role="outer"/><member type="way" ref="77" role="outer"/>
        <tag k="type" v="multipolygon"/><tag k="natural" v="water"/></relation>
        <relation id="2"><member type="way" ref="77" role="outer"/><tag k="type" v="multipolygon"/><tag k="building" v="yes"/></relation>"#;
    let (map, report) = import(&file(&CROSS, &ways, relations));
    assert_eq!((map.roads().len(), map.areas().len(), map.buildings().len()), (1, 1, 0));
    assert!(map.junctions().iter().any(|junction| junction.draft.control == Control::Edge && junction.at.x > 50.0));
    for (way, reason) in [
        (1, Reason::Shortened),
        (2, Reason::CutOff),
        (3, Reason::NotThere),
        (4, Reason::NoShape),
        (5, Reason::CutOff),
        (6, Reason::NoShape),
    ] {
        assert!(report.dropped.contains(&(Element::Way(way), reason)), "{way} {report}");
    }
    for (relation, reason) in [(1, Reason::Shortened), (2, Reason::CutOff)] {
        assert!(report.dropped.contains(&(Element::Relation(relation), reason)), "{relation} {report}");
    }
}

#[test]
fn a_way_that_is_cut_at_its_start_still_ends_where_it_ends() {
    for (refs, cut) in [([99, 1, 2], 1), ([1, 2, 99], 2), ([2, 1, 99], 1)] {
        let nodes = [(1, -1.0, 0.0, ""), (2, 1.0, 0.0, "")];
        let (map, _) = import(&file(&nodes, &[(9, &refs, "highway=residential")], ""));
        for junction in map.junctions() {
            let expected = if junction.draft.source == [cut] { Control::Edge } else { Control::Priority };
            assert_eq!(junction.draft.control, expected, "{refs:?} {:?}", junction.draft.source);
        }
    }
}

#[test]
fn restrictions_keep_from_turning() {
    let ways: [(i64, &[i64], &str); 4] = [
        (1, &[2, 1], "highway=secondary"),
        (2, &[1, 3], "highway=tertiary"),
        (3, &[1, 4], "highway=residential"),
        (4, &[1, 5], "highway=secondary name=x"),
    ];
    let relation = |kind: &str, to: i64| {
        format!(
            r#"<relation id="1"><member type="way" ref="1" role="from"/><member type="node" ref="1" role="via"/>
            <member type="way" ref="{to}" role="to"/><tag k="type" v="restriction"/><tag k="restriction" v="{kind}"/></relation>"#
        )
    };
    for (kind, to, count) in [("no_right_turn", 2, 1), ("only_straight_on", 3, 2), ("no_left_turn", 2, 0)] {
        let (map, report) = import(&file(&CROSS, &ways, &relation(kind, to)));
        assert_eq!(map.draft().bans.len(), count, "{kind}");
        assert_eq!(report.dropped.contains(&(Element::Relation(1), Reason::NoSuchTurn)), count == 0);
        assert!(map.roads().iter().all(|road| road.draft.class <= RoadClass::Residential));
    }
}

#[test]
fn files_that_are_none_are_refused_with_the_line() {
    let read = |text: &str| OsmData::from_xml(text.as_bytes()).unwrap_err().to_string();
    for (text, start) in [
        ("", "line 1: `<osm>` was expected, found the end of the file"),
        ("\n\nhello", "line 3: `<osm>` was expected, found `hello`"),
        ("<osm>\n<node id='1' lat='x' lon='2'/></osm>", "line 2: `<node>` needs `lat`, a number"),
        ("<osm>\n<node id='1' lat='95' lon='2'/></osm>", "node 1 has no latitude"),
        ("<osm>\n<way id='1'>\n", "line 3: the file ends before `</osm>`"),
        ("<osm>\n\n<way id='1'></node></osm>", "line 3:"),
    ] {
        assert!(read(text).starts_with(start), "{:?}", read(text));
    }
    let nothing = OsmData::from_xml(b"<osm><node id='1' lat='1' lon='2'/></osm>").unwrap();
    assert_eq!(nothing.draft(&ImportOptions::default()).unwrap_err(), OsmError::Empty);
}
