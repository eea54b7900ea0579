//! The account of an import: nothing is lost without an entry.

use std::collections::BTreeSet;

use vc_map::osm::{Element, Guessed, ImportOptions, ImportReport, OsmData, Reason};
use vc_map::{Control, CrossingKind, DrivingSide, StreetMap, StripKind, Turn, Users};

use crate::osm::{CROSS, file};
use crate::town::import;

/// A street of 100 m with these tags.
fn street(tags: &str) -> (StreetMap, ImportReport) {
    import(&file(&[(1, 0.0, 0.0, ""), (2, 1.0, 0.0, "")], &[(9, &[1, 2], tags)], ""))
}

/// The users of the strips of one side of the first road, from the divider outward.
fn users(map: &StreetMap, forward: bool) -> Vec<Users> {
    map.roads()[0].draft.section.side(forward).iter().map(|strip| strip.users).collect()
}

fn ignored(report: &ImportReport, element: Element, tag: &str) -> bool {
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
fn a_way_with_a_key_for_all_users_is_open_to_nobody_new() {
    for (tags, open) in [
        ("highway=footway access=permissive", Users::FOOT),
        ("highway=footway access=yes bicycle=yes", Users::FOOT | Users::BICYCLE),
        ("highway=steps access=customers", Users::FOOT),
        ("highway=footway bicycle=dismount", Users::FOOT),
        ("highway=motorway access=yes oneway=no", Users::CAR | Users::BUS),
        ("highway=cycleway access=no bicycle=yes", Users::BICYCLE),
        ("highway=residential access=no foot=yes", Users::FOOT),
        ("highway=residential vehicle=no bus=yes", Users::BUS | Users::FOOT),
        ("highway=trunk motorroad=yes", Users::CAR | Users::BUS),
    ] {
        let (map, _) = street(tags);
        let section = &map.roads()[0].draft.section;
        assert_eq!(section.users(true) | section.users(false), open, "{tags}");
    }
    let (map, _) = street("highway=footway access=private");
    assert_eq!(map.roads()[0].draft.section.side(true)[0].width, 2.0);
}

#[test]
fn bicycles_go_against_one_way_streets_and_beside_either_edge() {
    for (tags, forward, backward) in [
        ("highway=residential oneway=yes oneway:bicycle=no", 0, 1),
        ("highway=residential oneway=yes cycleway=opposite_lane", 0, 1),
        ("highway=residential oneway=yes cycleway:left=lane", 1, 0),
        ("highway=residential oneway=yes cycleway:left=lane oneway:bicycle=no", 0, 1),
        ("highway=residential oneway=yes cycleway:left=lane cycleway:left:oneway=-1", 0, 1),
        ("highway=residential oneway=yes cycleway:both=lane", 2, 0),
        ("highway=residential oneway=-1 cycleway:right=lane", 1, 0),
        ("highway=residential cycleway=lane", 1, 1),
        ("highway=residential oneway=yes bicycle=no oneway:bicycle=no", 0, 0),
    ] {
        let (map, report) = street(&format!("{tags} sidewalk=no"));
        let strips = |side| {
            map.roads()[0].draft.section.side(side).iter().filter(|strip| strip.kind == StripKind::Cycle).count()
        };
        assert_eq!((strips(true), strips(false)), (forward, backward), "{tags}");
        assert_eq!(
            report.guessed.iter().any(|(_, guessed)| *guessed == Guessed::ContraFlow),
            tags.ends_with("s oneway:bicycle=no")
        );
    }
}

#[test]
fn lists_of_lanes_say_who_may_use_each() {
    let (car, bus, bicycle) = (Users::CAR, Users::BUS, Users::BICYCLE);
    let all = Users::TRAFFIC;
    for (tags, expected) in [
        ("lanes=2 bus:lanes=|designated", vec![all, bus | bicycle]),
        // A lane for bicycles that is counted, and one that is not.
        ("lanes=2 bicycle:lanes=|designated", vec![all, bicycle]),
        ("lanes=2 bicycle:lanes=|designated|", vec![all, bicycle, all]),
        ("lanes=2 bicycle:lanes=|designated| turn:lanes=left||through", vec![all, bicycle, all]),
        ("lanes=2 bicycle:lanes=|designated| turn:lanes=left|through", vec![all, bicycle, all]),
        ("lanes=2 access:lanes=|no", vec![all, Users::NONE]),
        ("lanes=2 access:lanes=|no bus:lanes=|yes", vec![all, bus]),
        ("lanes=2 motor_vehicle:lanes=no|", vec![bicycle, all]),
        ("lanes=2 lanes:psv=1", vec![all, bus | bicycle]),
    ] {
        let (map, report) = street(&format!("highway=secondary oneway=yes sidewalk=no {tags}"));
        assert_eq!(users(&map, true), expected, "{tags}");
        assert_eq!(report.ignored, [], "{tags}");
    }
    // On the left, lists begin at the outer edge.
    let text = file(
        &[(1, 0.0, 0.0, ""), (2, 1.0, 0.0, "")],
        &[(9, &[1, 2], "highway=secondary oneway=yes sidewalk=no lanes=2 bus:lanes=designated|")],
        "",
    );
    let options = ImportOptions { side: Some(DrivingSide::Left), ..ImportOptions::default() };
    let (draft, _) = OsmData::from_xml(text.as_bytes()).unwrap().draft(&options).unwrap();
    assert_eq!(users(&draft.build().unwrap(), true), [all, bus | bicycle]);
    assert_ne!(car, bus);
}

#[test]
fn lists_of_another_number_of_lanes_are_told() {
    for tag in [
        "bus:lanes=|yes|designated",
        "bicycle:lanes=yes",
        "vehicle:lanes=||||no",
        "maxspeed=signals",
        "oneway=reversible",
        "width=wide",
        "layer=upper",
        "cycleway=maybe",
        "lanes=many",
        "access=unheard_of",
        "sidewalk=perhaps",
    ] {
        let (_, report) = street(&format!("highway=secondary {tag}"));
        let key = tag.split('=').next().unwrap();
        let forward = tag.replacen(key, &format!("{key}:forward"), 1);
        let (_, other) = street(&format!("highway=secondary lanes:forward=2 {forward}"));
        let listed = ignored(&report, Element::Way(9), tag) || ignored(&other, Element::Way(9), &forward);
        assert!(listed, "{tag}: {report}{other}");
    }
    let (_, report) = street("highway=secondary lanes=2 oneway=yes turn:lanes=left|through|right");
    assert!(report.guessed.contains(&(Element::Way(9), Guessed::TurnLanes)));
}

#[test]
fn lanes_of_both_directions_and_of_buses_against_the_traffic() {
    let driven = |map: &StreetMap, forward: bool| {
        let strips = map.roads()[0].draft.section.side(forward);
        strips.iter().filter(|strip| strip.kind == StripKind::Driving).count()
    };
    for (tags, lanes, median) in [
        ("lanes=1", [1, 1], 0.0),
        ("lanes=3 lanes:both_ways=1", [1, 1], 3.25),
        ("lanes=4 lanes:forward=3", [3, 1], 0.0),
        ("oneway=yes lanes=3 lanes:backward=1", [2, 1], 0.0),
        ("oneway=yes lanes=3 busway=opposite_lane", [2, 1], 0.0),
        ("oneway=yes lanes=2 oneway:bus=no", [1, 1], 0.0),
    ] {
        let (map, _) = street(&format!("highway=secondary {tags}"));
        assert_eq!([true, false].map(|forward| driven(&map, forward)), lanes, "{tags}");
        assert_eq!(map.roads()[0].draft.section.median, median, "{tags}");
        let one_way = tags.starts_with("oneway");
        assert_eq!(users(&map, false)[0] == Users::BUS, one_way, "{tags}");
    }
    let (map, report) = street("highway=secondary lanes=1");
    assert_eq!(map.roads()[0].draft.section.carriageway(true), 2.0);
    assert!(report.guessed.contains(&(Element::Way(9), Guessed::SharedLane)));
    let (map, _) = street("highway=secondary maxspeed:forward=30 maxspeed:backward=70");
    let limit = |forward: bool| map.roads()[0].draft.section.side(forward)[0].limit;
    assert!((limit(true) - 30.0 / 3.6).abs() < 1e-3 && (limit(false) - 70.0 / 3.6).abs() < 1e-3);
}

#[test]
fn people_do_not_walk_on_a_carriageway_beside_separate_pavements() {
    for (tags, walked) in [
        ("sidewalk:left=separate sidewalk:right=separate", false),
        ("sidewalk=separate", false),
        ("sidewalk:both=separate", false),
        ("sidewalk=no", true),
    ] {
        let (map, _) = street(&format!("highway=residential {tags}"));
        assert_eq!(map.roads()[0].draft.section.users(true).has(Users::FOOT), walked, "{tags}");
    }
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
        (1, 0.0, 0.0, "highway=mini_roundabout"),
        (2, 1.0, 0.0, "barrier=gate"),
        (3, 0.0, 1.0, "highway=give_way direction=forward"),
        (4, -1.0, 0.0, "natural=tree"),
        (5, 0.0, -1.0, "highway=crossing crossing=zebra tactile_paving=yes"),
        (6, 0.5, 0.0, "highway=stop"),
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
        (Element::Node(1), "highway=mini_roundabout"),
        (Element::Node(2), "barrier=gate"),
        (Element::Node(3), "highway=give_way"),
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
    let lost: Vec<_> = report.dropped.iter().copied().collect();
    assert_eq!(lost, [(Element::Node(2), Reason::Repeated), (Element::Way(7), Reason::Repeated)]);
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
fn signals_rule_a_junction_or_are_told() {
    let lit = |direction: &str, oneway: &str, refs: [i64; 4]| {
        let signal = format!("highway=traffic_signals traffic_signals:direction={direction}");
        let mut nodes = CROSS.to_vec();
        nodes.push((6, 0.4, 0.0, &signal));
        let way = format!("highway=secondary {oneway}");
        let ways: [(i64, &[i64], &str); 2] = [(8, &refs, &way), (9, &[3, 1, 5], "highway=secondary")];
        let (map, report) = import(&file(&nodes, &ways, ""));
        let told = report.dropped.contains(&(Element::Node(6), Reason::NoJunction));
        (map.signals().len(), told)
    };
    // Node 6 lies east of the junction at node 1, and only there is a junction.
    for (direction, oneway, refs, found) in [
        ("forward", "", [2, 6, 1, 4], 1),
        ("backward", "", [2, 6, 1, 4], 0),
        ("both", "", [4, 1, 6, 2], 1),
        ("backward", "", [4, 1, 6, 2], 1),
        ("forward", "oneway=-1", [4, 1, 6, 2], 0),
        ("backward", "oneway=-1", [4, 1, 6, 2], 1),
    ] {
        assert_eq!(lit(direction, oneway, refs), (found, found == 0), "{direction} {oneway} {refs:?}");
    }
}

/// A crossroads with lights for people on some arms, so far from the middle.
fn crossings(lights: &[(i64, f64)], middle: &'static str) -> (StreetMap, ImportReport) {
    let mut nodes = CROSS.to_vec();
    nodes[0].3 = middle;
    let way = |arm: i64| {
        let middle = lights.iter().find(|(lit, _)| *lit == arm).map(|_| arm + 10);
        [Some(1), middle, Some(arm)].into_iter().flatten().collect::<Vec<i64>>()
    };
    for (arm, away) in lights {
        let (_, x, y, _) = CROSS[*arm as usize - 1];
        nodes.push((arm + 10, x * away / 100.0, y * away / 100.0, "highway=crossing crossing=traffic_signals"));
    }
    let arms: Vec<Vec<i64>> = (2..=5).map(way).collect();
    let ways: Vec<(i64, &[i64], &str)> =
        arms.iter().zip(20..).map(|(refs, id)| (id, refs.as_slice(), "highway=secondary sidewalk=both")).collect();
    import(&file(&nodes, &ways, ""))
}

#[test]
fn lights_for_people_belong_to_a_junction_that_has_lights() {
    let lit = |map: &StreetMap| {
        let lit = map.junctions().iter().filter(|junction| junction.draft.control == Control::Signals);
        lit.map(|junction| junction.draft.source.contains(&1)).collect::<Vec<bool>>()
    };
    let signals = "highway=traffic_signals";
    for (lights, middle, expected) in [
        // Within the junction, on its arm, and between junctions.
        (vec![(2, 15.0)], signals, vec![true]),
        (vec![(2, 35.0)], signals, vec![true]),
        (vec![(2, 60.0)], signals, vec![true, false]),
        // A junction without lights gets none of one crossing, and those of four are its own.
        (vec![(2, 15.0)], "", vec![false]),
        (vec![(2, 5.0)], "", vec![]),
        (vec![(2, 15.0), (3, 15.0), (4, 15.0), (5, 15.0)], "", vec![true]),
        (vec![(2, 15.0), (3, 15.0), (4, 15.0)], "", vec![false; 3]),
    ] {
        let (map, report) = crossings(&lights, middle);
        assert_eq!(lit(&map), expected, "{lights:?} {middle} {report}");
        let told = report.guessed.iter().any(|(_, g)| matches!(g, Guessed::CrossingOf(1) | Guessed::NoLights));
        assert_eq!(told, lights == [(2, 35.0)] || lights == [(2, 5.0)], "{report}");
        let wrong: Vec<_> = map.validate();
        assert_eq!(wrong, [], "{lights:?} {middle}");
    }
    let (map, _) = crossings(&[(2, 35.0)], signals);
    let crossing = map.crossings().iter().find(|crossing| crossing.kind == CrossingKind::Marked);
    assert!(crossing.is_some_and(|crossing| (crossing.line.at(0.0).x - 35.0).abs() < 8.0));
}

#[test]
fn restrictions_hold_for_those_and_then_when_they_say() {
    let ways: [(i64, &[i64], &str); 4] = [
        (1, &[2, 1], "highway=secondary"),
        (2, &[1, 3], "highway=tertiary"),
        (3, &[1, 4], "highway=residential"),
        (4, &[1, 5], "highway=secondary name=x"),
    ];
    let import = |tags: &str, to: &[i64]| {
        let tags: String = tags
            .split_whitespace()
            .map(|tag| tag.split_once('=').unwrap())
            .fold(String::new(), |all, (k, v)| format!(r#"{all}<tag k="{k}" v="{v}"/>"#));
        let to: String = to.iter().map(|to| format!(r#"<member type="way" ref="{to}" role="to"/>"#)).collect();
        import(&file(
            &CROSS,
            &ways,
            &format!(
                r#"<relation id="1"><member type="way" ref="1" role="from"/><member type="node" ref="1" role="via"/>{to}<tag k="type" v="restriction"/>{tags}</relation>"#
            ),
        ))
    };
    let (car, bus, bicycle) = (Users::CAR, Users::BUS, Users::BICYCLE);
    for (tags, to, users, reason) in [
        ("restriction=no_right_turn", vec![2], vec![car | bus | bicycle], None),
        ("restriction=no_right_turn except=bicycle;bus", vec![2], vec![car], None),
        ("restriction=no_right_turn except=psv", vec![2], vec![car | bicycle], None),
        ("restriction=no_right_turn except=motorcar", vec![2], vec![bus | bicycle], None),
        ("restriction:bus=no_right_turn", vec![2], vec![bus], None),
        ("restriction=no_exit", vec![2, 3], vec![car | bus | bicycle; 2], None),
        ("restriction:hgv=no_right_turn", vec![2], vec![], Some(Reason::OtherUsers)),
        ("restriction=no_right_turn hour_on=7:00 hour_off=9:00", vec![2], vec![], Some(Reason::AtTimes)),
        ("restriction:conditional=no_right_turn", vec![2], vec![], Some(Reason::AtTimes)),
        ("restriction=no_left_turn", vec![2], vec![], Some(Reason::NoSuchTurn)),
        ("restriction=no_right_turn", vec![99], vec![], Some(Reason::NoSuchTurn)),
    ] {
        let (map, report) = import(tags, &to);
        assert_eq!(map.draft().bans.iter().map(|ban| ban.users).collect::<Vec<_>>(), users, "{tags}");
        assert_eq!(reason.map(|reason| (Element::Relation(1), reason)), report.dropped.first().copied(), "{tags}");
        // Those who are not banned turn.
        let turns = map.movements().iter().filter(|movement| {
            let road = |lane| map.road(map.lane(lane).unwrap().road).unwrap().draft.source.clone();
            road(movement.from) == [1] && road(movement.to) == [2] && movement.turn == Turn::Right
        });
        let turning = turns.fold(Users::NONE, |all, movement| all | movement.users);
        let banned = users.first().copied().unwrap_or_default();
        assert_eq!(turning, (car | bus | bicycle).without(banned), "{tags}");
    }
}

#[test]
fn who_may_not_turn_back_may_go_straight_on() {
    let ways: [(i64, &[i64], &str); 2] = [(1, &[2, 1, 4], "highway=secondary"), (2, &[3, 1, 5], "highway=tertiary")];
    let relation = r#"<relation id="1"><member type="way" ref="1" role="from"/><member type="node" ref="1" role="via"/>
        <member type="way" ref="1" role="to"/><tag k="type" v="restriction"/><tag k="restriction" v="no_u_turn"/></relation>"#;
    let (map, report) = import(&file(&CROSS, &ways, relation));
    assert_eq!(map.draft().bans, []);
    assert!(report.dropped.contains(&(Element::Relation(1), Reason::NoSuchTurn)));
}

#[test]
fn tiny_ways_and_far_ones_do_not_refuse_the_file() {
    // Four millimetres, alone and between two streets.
    let at = |id: i64, east: f64| format!(r#"<node id="{id}" lat="69" lon="{:.7}"/>"#, 18.0 + east / 39_900.0);
    let nodes = at(1, 0.0) + &at(2, 0.004) + &at(3, 100.0) + &at(4, -100.0) + r#"<node id="5" lat="20" lon="18"/>"#;
    let way = |id: i64, refs: &[i64]| {
        let refs: String = refs.iter().map(|id| format!(r#"<nd ref="{id}"/>"#)).collect();
        let class = if id == 7 { "service" } else { "residential" };
        format!(r#"<way id="{id}">{refs}<tag k="highway" v="{class}"/></way>"#)
    };
    let ways = way(7, &[1, 2]) + &way(8, &[2, 3]) + &way(9, &[4, 1]) + &way(10, &[3, 5]);
    let (map, report) = import(&format!("<osm>{nodes}{ways}</osm>"));
    assert_eq!(map.roads().len(), 2);
    assert!(report.dropped.contains(&(Element::Way(7), Reason::WithinJunction)), "{report}");
    assert!(report.dropped.contains(&(Element::Way(10), Reason::TooFar)), "{report}");
    assert_eq!(map.walk_parts().len(), 1);
}

#[test]
fn a_street_over_the_date_line_is_no_longer_than_elsewhere() {
    for bounds in ["", r#"<bounds minlat="-17" minlon="179.99" maxlat="-16" maxlon="-179.99"/>"#] {
        let text = format!(
            r#"<osm>{bounds}<node id="1" lat="-16.5" lon="179.9995"/><node id="2" lat="-16.5" lon="-179.9995"/>
            <way id="1"><nd ref="1"/><nd ref="2"/><tag k="highway" v="residential"/></way></osm>"#
        );
        let (map, _) = import(&text);
        let length = map.roads()[0].line.length();
        assert!((length - 106.8).abs() < 0.5, "{length}");
        let degrees = vc_map::format::geojson::write(&map);
        assert!(
            degrees.contains("[179.999") && degrees.contains("[-179.999") && !degrees.contains("[180.000"),
            "{degrees}"
        );
    }
}

#[test]
fn a_node_far_away_does_not_bend_the_map() {
    let text = |rest: &str| {
        format!(
            r#"<osm><node id="1" lat="48" lon="11"/><node id="2" lat="48" lon="11.001"/><node id="3" lat="52.5" lon="11"/>{rest}
            <way id="1"><nd ref="1"/><nd ref="2"/><tag k="highway" v="residential"/></way></osm>"#
        )
    };
    let boundary = r#"<way id="2"><nd ref="2"/><nd ref="3"/><tag k="boundary" v="administrative"/></way>"#;
    for rest in ["", boundary] {
        let (map, _) = import(&text(rest));
        assert!((map.roads()[0].line.length() - 74.63).abs() < 0.05, "{}", map.roads()[0].line.length());
    }
}

#[test]
fn places_are_those_of_the_projection_that_other_programs_use() {
    // From PROJ, `+proj=tmerc +k=1 +ellps=WGS84` around the middle of the bounds.
    for (middle, at, expected) in [
        ([48.0, 11.0], [48.09, 11.1342], [9997.2904, 10015.9208]),
        ([53.8, -1.5], [53.7, -1.7], [-13209.2623, -11111.4535]),
        ([-16.5, 179.9], [-16.4, -179.9], [21363.8065, 11055.8097]),
        ([69.0, 18.0], [69.5, 19.5], [58644.7942, 56495.2914]),
    ] {
        let [lat, lon] = middle;
        let text = format!(
            r#"<osm><bounds minlat="{}" minlon="{lon}" maxlat="{}" maxlon="{lon}"/>
            <node id="1" lat="{}" lon="{}"/><node id="2" lat="{}" lon="{}"/>
            <way id="1"><nd ref="1"/><nd ref="2"/><tag k="highway" v="residential"/></way></osm>"#,
            lat - 1.0,
            lat + 1.0,
            at[0],
            at[1],
            at[0] + 0.001,
            at[1]
        );
        let (map, _) = import(&text);
        let found = map.roads()[0].draft.line[0];
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-3), "{found:?} {expected:?}");
        let features: serde_json::Value = serde_json::from_str(&vc_map::format::geojson::write(&map)).unwrap();
        let features = features["features"].as_array().unwrap();
        let back = features.iter().filter(|f| f["properties"]["kind"] == "junction").any(|f| {
            let place = &f["geometry"]["coordinates"];
            [(0, at[1]), (1, at[0])]
                .iter()
                .all(|(axis, degrees)| (place[axis].as_f64().unwrap() - degrees).abs() < 2e-7)
        });
        assert!(back, "{middle:?}");
    }
}

#[test]
fn the_side_is_known_at_places_all_over_the_world() {
    let left = [
        ("Leeds", 53.8, -1.55),
        ("Dover", 51.13, 1.31),
        ("Dublin", 53.35, -6.26),
        ("Jersey", 49.19, -2.11),
        ("Valletta", 35.9, 14.51),
        ("Nicosia", 35.17, 33.36),
        ("Tokyo", 35.68, 139.77),
        ("Sapporo", 43.06, 141.35),
        ("Naha", 26.21, 127.68),
        ("Hong Kong", 22.28, 114.16),
        ("Macau", 22.19, 113.55),
        ("Bangkok", 13.75, 100.5),
        ("Chiang Mai", 18.79, 98.98),
        ("Singapore", 1.35, 103.82),
        ("Kota Kinabalu", 5.98, 116.07),
        ("Jakarta", -6.2, 106.82),
        ("Delhi", 28.61, 77.21),
        ("Kathmandu", 27.72, 85.32),
        ("Lahore", 31.55, 74.34),
        ("Islamabad", 33.69, 73.05),
        ("Guwahati", 26.14, 91.74),
        ("Colombo", 6.93, 79.85),
        ("Sydney", -33.87, 151.21),
        ("Auckland", -36.85, 174.76),
        ("Port Moresby", -9.44, 147.18),
        ("Suva", -18.14, 178.44),
        ("Cape Town", -33.92, 18.42),
        ("Windhoek", -22.56, 17.08),
        ("Lusaka", -15.42, 28.28),
        ("Ndola", -12.97, 28.64),
        ("Nairobi", -1.29, 36.82),
        ("Kampala", 0.35, 32.58),
        ("Port Louis", -20.16, 57.5),
        ("Kingston", 17.97, -76.79),
        ("Port of Spain", 10.65, -61.51),
        ("Paramaribo", 5.85, -55.2),
        ("Georgetown", 6.8, -58.16),
        ("Nassau", 25.05, -77.35),
        ("Bridgetown", 13.1, -59.62),
    ];
    let right = [
        ("Munich", 48.14, 11.57),
        ("New York", 40.75, -73.98),
        ("Boulogne", 50.73, 1.61),
        ("Calais", 50.95, 1.86),
        ("Dieppe", 49.92, 1.08),
        ("Lhasa", 29.65, 91.1),
        ("Lubumbashi", -11.66, 27.48),
        ("Huambo", -12.78, 15.74),
        ("Kigali", -1.95, 30.06),
        ("Gitega", -3.43, 29.92),
        ("Vladivostok", 43.12, 131.9),
        ("Phnom Penh", 11.56, 104.92),
        ("Vientiane", 17.97, 102.63),
        ("Noumea", -22.27, 166.45),
        ("Port Vila", -17.73, 168.32),
        ("Busan", 35.18, 129.08),
        ("Taipei", 25.03, 121.57),
        ("Shenzhen", 22.54, 114.06),
        ("Manila", 14.6, 120.98),
        ("Hanoi", 21.03, 105.85),
        ("Luanda", -8.84, 13.23),
        ("Kinshasa", -4.32, 15.31),
        ("Antananarivo", -18.88, 47.51),
        ("Saint-Denis", -20.88, 55.45),
        ("Havana", 23.11, -82.37),
        ("Caracas", 10.48, -66.9),
        ("Miami", 25.76, -80.19),
        ("Cayenne", 4.92, -52.33),
        ("Boa Vista", 2.82, -60.67),
        ("Tehran", 35.69, 51.39),
        ("Yangon", 16.84, 96.17),
        ("Luang Prabang", 19.89, 102.13),
    ];
    let told = |(name, lat, lon): (&'static str, f64, f64)| {
        let text = format!(
            r#"<osm><node id="1" lat="{lat}" lon="{lon}"/><node id="2" lat="{}" lon="{lon}"/>
            <way id="1"><nd ref="1"/><nd ref="2"/><tag k="highway" v="residential"/></way></osm>"#,
            lat + 0.001
        );
        (name, import(&text).0.side())
    };
    let wrong = |place: &(&str, DrivingSide), side| place.1 != side;
    let lost: BTreeSet<_> =
        left.into_iter().map(told).filter(|place| wrong(place, DrivingSide::Left)).map(|(name, _)| name).collect();
    let more: BTreeSet<_> =
        right.into_iter().map(told).filter(|place| wrong(place, DrivingSide::Right)).map(|(name, _)| name).collect();
    assert_eq!((lost, more), (BTreeSet::new(), BTreeSet::new()));
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
