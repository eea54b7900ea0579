//! Signals, crossings with lights, restrictions of turns.

use vc_map::osm::{Element, Guessed, ImportReport, Reason};
use vc_map::{Control, CrossingKind, StreetMap, Turn, Users};

use crate::osm::{CROSS, file};
use crate::town::import;

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
fn a_crossing_before_a_roundabout_with_lights_has_none_against_them() {
    let ring = [(1, 0.2, 0.0, "highway=traffic_signals"), (2, 0.0, 0.2, ""), (3, -0.2, 0.0, ""), (4, 0.0, -0.2, "")];
    let arm = [(5, 0.35, 0.0, "highway=crossing crossing=traffic_signals"), (6, 1.0, 0.0, "")];
    let ways: [(i64, &[i64], &str); 2] = [
        (8, &[1, 2, 3, 4, 1], "highway=secondary junction=roundabout"),
        (9, &[6, 5, 1], "highway=secondary sidewalk=both"),
    ];
    let (map, report) = import(&file(&[&ring[..], &arm].concat(), &ways, ""));
    let lit: Vec<_> = map.signals().iter().map(|s| map.junction(s.junction).unwrap().draft.source.clone()).collect();
    assert_eq!(lit, [[1]], "{report}");
    assert!(report.guessed.contains(&(Element::Node(5), Guessed::CrossingOf(1))), "{report}");
    assert!(map.crossings().iter().any(|crossing| crossing.kind == CrossingKind::Marked));
}

#[test]
fn bollards_stop_cars_and_let_bicycles_through() {
    let through = |tags: &str| {
        let nodes = [(1, 0.0, 0.0, tags), (2, 1.0, 0.0, ""), (3, -1.0, 0.0, "")];
        let (map, report) = import(&file(&nodes, &[(9, &[2, 1, 3], "highway=residential sidewalk=both")], ""));
        assert_eq!(map.validate().iter().filter(|v| v.kind() == "lane without a way on").count(), 0, "{report}");
        let on = map.movements().iter().filter(|m| m.turn == Turn::Through);
        on.fold(Users::NONE, |all, movement| all | movement.users)
    };
    assert_eq!(through("barrier=bollard"), Users::BICYCLE);
    assert_eq!(through("barrier=block bicycle=yes"), Users::BICYCLE);
    // Nothing cuts the street: no junction, no movement.
    assert_eq!(through("barrier=bollard motor_vehicle=yes"), Users::NONE);
    assert_eq!(through("barrier=gate"), Users::BICYCLE);
    let mut nodes = CROSS.to_vec();
    nodes[0].3 = "barrier=bollard";
    let ways: [(i64, &[i64], &str); 2] =
        [(8, &[2, 1, 4], "highway=residential"), (9, &[3, 1, 5], "highway=residential")];
    let (map, report) = import(&file(&nodes, &ways, ""));
    assert!(map.draft().bans.is_empty() && report.dropped.contains(&(Element::Node(1), Reason::WithinJunction)));
}

#[test]
fn gates_stop_cars_unless_access_lets_them_in_and_all_if_nobody_opens_them() {
    for (tags, stopped) in [
        ("barrier=gate locked=yes", Users::TRAFFIC),
        ("barrier=lift_gate access=no", Users::TRAFFIC),
        ("barrier=gate access=no bicycle=yes", Users::CAR | Users::BUS),
        ("barrier=gate access=no motor_vehicle=yes", Users::BICYCLE),
        ("barrier=gate", Users::CAR | Users::BUS),
        ("barrier=gate locked=no", Users::CAR | Users::BUS),
        ("barrier=swing_gate motor_vehicle=no access=yes", Users::CAR | Users::BUS),
        ("barrier=gate access=private", Users::NONE),
        ("barrier=lift_gate motorcar=destination", Users::NONE),
    ] {
        assert_eq!(closed(tags, ""), stopped, "{tags}");
    }
    // The way behind it may say who comes in.
    assert_eq!(closed("barrier=gate", "access=private"), Users::NONE);
    assert_eq!(closed("barrier=gate motor_vehicle=no", "access=private"), Users::CAR | Users::BUS);
}

/// Those whom a node of some tags stops, on a street of others.
fn closed(tags: &str, street: &str) -> Users {
    let nodes = [(1, 0.0, 0.0, tags), (2, 1.0, 0.0, ""), (3, -1.0, 0.0, "")];
    let street = format!("highway=residential sidewalk=both foot=yes {street}");
    let (map, report) = import(&file(&nodes, &[(9, &[2, 1, 3], street.trim())], ""));
    let bans: Vec<Users> = map.draft().bans.iter().map(|ban| ban.users).collect();
    let stopped = bans.first().copied().unwrap_or_default();
    assert_eq!(bans, vec![stopped; bans.len()], "both ways");
    let on = map.movements().iter().filter(|movement| movement.turn == Turn::Through);
    assert!(on.into_iter().all(|movement| !movement.users.any(stopped)), "{tags}");
    assert_eq!(map.walk_parts().len(), 1, "people walk through: {tags}");
    let told = |tag: &str| tag.starts_with("barrier=");
    assert!(!report.ignored.iter().any(|(_, tag)| told(tag)) && report.unread.is_empty(), "{report}");
    stopped
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
