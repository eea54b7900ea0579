//! Lanes, and who may use them, from tags.

use vc_map::osm::{Element, Guessed, ImportOptions, OsmData};
use vc_map::{Control, CrossSection, DrivingSide, MapDraft, RoadClass, StreetMap, Strip, StripKind, Turns, Users};

use crate::account::ignored;
use crate::osm::{file, street};

/// The users of the strips of one side of the first road, from the divider outward.
fn users(map: &StreetMap, forward: bool) -> Vec<Users> {
    map.roads()[0].draft.section.side(forward).iter().map(|strip| strip.users).collect()
}

#[test]
fn a_way_with_a_key_for_all_users_is_open_to_nobody_new() {
    for (tags, open) in [
        ("highway=footway access=permissive", Users::FOOT),
        ("highway=footway access=yes bicycle=yes", Users::FOOT | Users::BICYCLE),
        ("highway=steps access=customers", Users::FOOT),
        // Private ground is closed to those on foot unless their own key lets them in.
        ("highway=residential access=private", Users::TRAFFIC),
        ("highway=residential access=private sidewalk=both", Users::TRAFFIC),
        ("highway=residential foot=private", Users::TRAFFIC),
        ("highway=residential foot=no sidewalk=right", Users::TRAFFIC),
        ("highway=residential access=private foot=permissive", Users::TRAFFIC | Users::FOOT),
        ("highway=service access=private foot=designated", Users::TRAFFIC | Users::FOOT),
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
    let (map, _) = street("highway=footway access=private foot=yes");
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
        let lanes = map.lanes().iter().filter(|lane| lane.kind == StripKind::Driving);
        assert_eq!(lanes.into_iter().all(|lane| lane.users.has(Users::FOOT)), walked, "{tags}");
    }
}

#[test]
fn where_lanes_lead_ahead_only_every_branch_ahead_can_be_taken() {
    // Three lanes from the south, marked for straight on, and three one-way streets: ahead, half to the left, to the left.
    let mut draft = MapDraft::new("fork", 48.0, 11.0);
    let middle = draft.junction([0.0, 0.0], Control::Priority);
    let start = draft.junction([0.0, -120.0], Control::Edge);
    let lane = Strip { turns: Turns::THROUGH, ..Strip::driving(3.0, 13.9) };
    let section = |strips: Vec<Strip>| CrossSection { forward: strips, ..CrossSection::default() };
    draft.road(start, middle, RoadClass::Trunk, section(vec![lane; 3]));
    let exit = |draft: &mut MapDraft, degrees: f64| {
        let (x, y) = degrees.to_radians().sin_cos();
        let end = draft.junction([-120.0 * x, 120.0 * y], Control::Edge);
        draft.road(middle, end, RoadClass::Trunk, section(vec![Strip::driving(3.0, 13.9)]))
    };
    let exits = [0.0, 50.0, 65.0, 90.0].map(|degrees| exit(&mut draft, degrees));
    let map = draft.build().unwrap();
    let taken = |road| {
        map.movements().iter().filter(|m| map.lane(m.to).unwrap().road == road && m.users.has(Users::CAR)).count()
    };
    // A street to the left is none of those ahead.
    assert_eq!(exits.map(taken), [3, 1, 1, 0]);
}

#[test]
fn nobody_crosses_more_carriageways_in_one_go_than_those_of_a_road_with_a_slip_road() {
    let crossed = |streets: usize| {
        let mut draft = MapDraft::new("star", 48.0, 11.0);
        let middle = draft.junction([0.0, 0.0], Control::Signals);
        let mut arm = |degrees: f64, class, strips: Vec<Strip>| {
            let (x, y) = degrees.to_radians().sin_cos();
            let end = draft.junction([100.0 * x, 100.0 * y], Control::Edge);
            draft.road(end, middle, class, CrossSection { forward: strips.clone(), backward: strips, median: 0.0 });
        };
        // Three paths to the south, and streets without pavements between the outer ones.
        let path = || vec![Strip::new(StripKind::Path, 2.0, Users::FOOT, 1.4)];
        [100.0, 180.0, 260.0].into_iter().for_each(|degrees| arm(degrees, RoadClass::Path, path()));
        let lane = Strip::new(StripKind::Driving, 3.0, Users::CAR, 13.9);
        (0..streets).for_each(|i| arm(-60.0 + 30.0 * i as f64, RoadClass::Secondary, vec![lane.clone()]));
        let map = draft.build().unwrap();
        map.crossings().iter().map(|crossing| crossing.roads.len()).max()
    };
    assert_eq!([3, 4, 5].map(crossed), [Some(3), None, None]);
}
