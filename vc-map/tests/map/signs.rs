//! Give-way and stop signs, and mini-roundabouts: who goes first, and what other programs are told.

use nalgebra::Vector2;
use proptest::prelude::*;
use vc_map::format::{native, opendrive, sumo};
use vc_map::osm::{Element, ImportReport, Reason};
use vc_map::route::{Mode, Router};
use vc_map::{
    Control, DrivingSide, JunctionId, Movement, Point, RoadClass, RoadId, SignDraft, SignKind, StreetMap, Turn,
};
use vc_testkit::cases;

use crate::osm::file;
use crate::right_of_way::star;
use crate::town::import;

/// Arms at different angles, each with a class.
fn arms() -> impl Strategy<Value = Vec<(f64, RoadClass, bool)>> {
    prop::collection::btree_map(0u32..12, any::<bool>(), 3..6).prop_map(|arms| {
        let class = |main| if main { RoadClass::Secondary } else { RoadClass::Residential };
        arms.into_iter().map(|(angle, main)| (30.0 * f64::from(angle), class(main), false)).collect()
    })
}

/// The pairs of movements of a junction that conflict, by their positions.
fn pairs(map: &StreetMap, at: JunctionId) -> Vec<[(usize, &Movement); 2]> {
    let junction = map.junction(at).unwrap();
    let movement = |row: usize| (row, map.movement(junction.movements[row]).unwrap());
    let movements = junction.conflicts.pairs().filter(|(_, b)| *b < junction.movements.len());
    movements.map(|(a, b)| [movement(a), movement(b)]).collect()
}

/// Whether somebody on a line passes the ray from the middle to a point.
fn passes(line: &vc_map::Polyline, middle: Point, place: Point) -> bool {
    let ray = (place - middle).normalize();
    let seen: Vec<(f64, f64)> = (0..=400)
        .map(|step| line.at(line.length() * f64::from(step) / 400.0) - middle)
        .map(|at| (ray.perp(&at), ray.dot(&at)))
        .collect();
    seen.windows(2).any(|pair| (pair[0].0 > 0.0) != (pair[1].0 > 0.0) && pair[0].1 > 0.0)
}

proptest! {
    #![proptest_config(cases(60))]

    #[test]
    fn whoever_has_a_sign_gives_way_to_all_who_have_none(arms in arms(), signs in prop::collection::vec(0usize..3, 5), left: bool) {
        let side = if left { DrivingSide::Left } else { DrivingSide::Right };
        let (mut draft, middle) = star(Control::Priority, side, &arms, 1);
        let kind = |road: usize| [None, Some(SignKind::GiveWay), Some(SignKind::Stop)][signs[road]];
        for road in 0..arms.len() {
            let at = RoadId(road as u32);
            draft.signs.extend(kind(road).map(|kind| SignDraft { at: middle, road: at, kind, source: 0 }));
        }
        let map = draft.build().unwrap();
        for [(a, one), (b, other)] in pairs(&map, middle) {
            let signed = [one, other].map(|movement| map.lane(movement.from).unwrap().sign.is_some());
            let yields = [one.yields.contains(&(b as u32)), other.yields.contains(&(a as u32))];
            prop_assert!(yields[0] != yields[1]);
            if signed[0] != signed[1] {
                prop_assert_eq!(yields, signed);
            }
        }
        for lane in map.lanes().iter().filter(|lane| lane.sign.is_some()) {
            prop_assert!(lane.stop_line.is_some());
        }
        prop_assert_eq!(&native::read(&native::write(&map)).unwrap(), &map);
    }

    #[test]
    fn one_goes_around_a_mini_roundabout_and_lets_those_go_who_do(arms in arms(), left: bool) {
        let side = if left { DrivingSide::Left } else { DrivingSide::Right };
        let (draft, at) = star(Control::MiniRoundabout, side, &arms, 1);
        let map = draft.build().unwrap();
        prop_assert_eq!(map.validate(), vec![]);
        let junction = map.junction(at).unwrap();
        let middle = junction.at;
        let turns = if left { -1.0 } else { 1.0 };
        for id in &junction.movements {
            let points = map.movement(*id).unwrap().line.points();
            for pair in points.windows(2) {
                let [from, to]: [Vector2<f64>; 2] = [pair[0] - middle, pair[1] - middle];
                prop_assert!(turns * from.perp(&to) > 0.0 && to.norm() > 4.0, "{points:?}");
            }
        }
        // From each arm one can turn back.
        let back = junction.movements.iter().filter(|id| map.movement(**id).unwrap().turn == Turn::Back);
        prop_assert!(back.count() >= arms.len());
        for [(a, one), (b, other)] in pairs(&map, at) {
            let yields = [one.yields.contains(&(b as u32)), other.yields.contains(&(a as u32))];
            prop_assert!(yields[0] != yields[1]);
            // On their way they come by the arm of the other, who does not by theirs.
            let over = [passes(&one.line, middle, other.line.start()), passes(&other.line, middle, one.line.start())];
            if over[0] != over[1] {
                prop_assert_eq!(yields, [over[1], over[0]], "{:?} {:?}", one, other);
            }
        }
    }
}

/// Streets of one class, from the west to the east (way 8) and from the north (3) to the south (9), and signs on them.
fn crossing(signs: &[(i64, f64, f64, &'static str)], middle: &'static str) -> (StreetMap, ImportReport) {
    let mut nodes =
        vec![(1, 0.0, 0.0, middle), (2, 1.0, 0.0, ""), (3, 0.0, 1.0, ""), (4, -1.0, 0.0, ""), (5, 0.0, -1.0, "")];
    nodes.extend(signs);
    let on = |west: bool| -> Vec<i64> {
        let of = |sign: &&(i64, f64, f64, &str)| if west { sign.2 == 0.0 } else { sign.1 == 0.0 };
        let mut own: Vec<_> = signs.iter().filter(of).map(|sign| (sign.1 - sign.2, sign.0)).collect();
        own.extend(if west { [(-1.0, 4), (0.0, 1), (1.0, 2)] } else { [(-1.0, 3), (0.0, 1), (1.0, 5)] });
        own.sort_by(|a, b| a.0.total_cmp(&b.0));
        own.into_iter().map(|(_, id)| id).collect()
    };
    let (first, second) = (on(true), on(false));
    let ways: [(i64, &[i64], &str); 2] = [(8, &first, "highway=residential"), (9, &second, "highway=residential")];
    import(&file(&nodes, &ways, ""))
}

/// The ways with a sign, its kind, and the side of the junction on which it is: -1 is the west or the north.
fn signs(map: &StreetMap) -> Vec<(i64, SignKind, f64)> {
    let side = |lane: &vc_map::Lane| {
        let from = lane.line.start();
        if from.x.abs() > from.y.abs() { from.x.signum() } else { -from.y.signum() }
    };
    let way = |lane: &vc_map::Lane| map.road(lane.road).unwrap().draft.source[0];
    map.lanes().iter().filter_map(|lane| Some((way(lane), lane.sign?, side(lane)))).collect()
}

#[test]
fn signs_of_a_file_hold_at_the_junction_ahead() {
    let (give, stop) = (SignKind::GiveWay, SignKind::Stop);
    for (nodes, middle, expected) in [
        (vec![(6, -0.1, 0.0, "highway=give_way direction=forward")], "", vec![(8, give, -1.0)]),
        (vec![(6, 0.1, 0.0, "highway=stop direction=backward")], "", vec![(8, stop, 1.0)]),
        // Without a word of its direction it is that of the nearest junction.
        (vec![(6, 0.0, -0.2, "highway=stop")], "", vec![(9, stop, 1.0)]),
        // Those that lead away from the junction, or that are far from any, are none's.
        (vec![(6, -0.1, 0.0, "highway=give_way direction=backward")], "", vec![]),
        (vec![(6, -0.8, 0.0, "highway=give_way direction=forward")], "", vec![]),
        // Behind a crossing, and with one between.
        (
            vec![
                (6, -0.05, 0.0, "highway=give_way direction=forward"),
                (7, -0.1, 0.0, "highway=crossing crossing=zebra"),
            ],
            "",
            vec![(8, give, -1.0)],
        ),
        (
            vec![
                (6, -0.4, 0.0, "highway=give_way direction=forward"),
                (7, -0.3, 0.0, "highway=crossing crossing=zebra"),
            ],
            "",
            vec![(8, give, -1.0)],
        ),
        // On the junction itself, of equal streets.
        (vec![], "highway=stop", vec![]),
    ] {
        let (map, report) = crossing(&nodes, middle);
        assert_eq!(signs(&map), expected, "{nodes:?} {report}");
        let lost = report.dropped.iter().filter(|(_, why)| matches!(why, Reason::NoJunction | Reason::NoArm)).count();
        assert_eq!(lost, usize::from(expected.is_empty()), "{report}");
        assert_eq!(map.validate(), []);
    }
}

#[test]
fn signs_all_round_are_an_all_way_stop() {
    let all = [(6, -0.1, 0.0, "highway=stop direction=forward"), (7, 0.1, 0.0, "highway=stop direction=backward")];
    let more = [(10, 0.0, 0.1, "highway=stop direction=forward"), (11, 0.0, -0.1, "highway=stop direction=backward")];
    let control = |signs: &[(i64, f64, f64, &'static str)], middle| {
        let (map, _) = crossing(signs, middle);
        map.junctions().iter().find(|junction| junction.draft.source.contains(&1)).unwrap().draft.control
    };
    assert_eq!(control(&all, ""), Control::Priority);
    assert_eq!(control(&[all, more].concat(), ""), Control::AllWayStop);
    assert_eq!(control(&[(6, -0.1, 0.0, "highway=stop stop=all")], ""), Control::AllWayStop);
    assert_eq!(control(&[], "highway=mini_roundabout"), Control::MiniRoundabout);
    assert_eq!(control(&all, "highway=traffic_signals"), Control::Signals);
}

#[test]
fn a_sign_on_a_junction_is_for_the_lesser_streets() {
    let nodes = [(1, 0.0, 0.0, "highway=stop stop=minor"), (2, 1.0, 0.0, ""), (3, 0.0, 1.0, ""), (4, -1.0, 0.0, "")];
    let ways: [(i64, &[i64], &str); 2] = [(8, &[4, 1, 2], "highway=secondary"), (9, &[3, 1], "highway=residential")];
    let (map, report) = import(&file(&nodes, &ways, ""));
    assert_eq!(signs(&map), [(9, SignKind::Stop, -1.0)]);
    assert!(!report.dropped.iter().any(|(element, _)| *element == Element::Node(1)), "{report}");
}

#[test]
fn other_programs_are_told_of_signs_and_mini_roundabouts() {
    let (map, _) = crossing(&[(6, -0.1, 0.0, "highway=stop direction=forward")], "");
    let files = sumo::write(&map, "signs");
    assert!(files.nodes.contains(r#"type="priority_stop""#));
    // Straight on from the west waits for straight on from the north.
    let edge = |way: i64, start: f64, incoming: bool| {
        let fits = |(id, road): (usize, &vc_map::Road)| {
            let at = map.junction(road.draft.from).unwrap().at.coords.norm() < 1.0;
            let far = if at { road.line.end() } else { road.line.start() };
            let place = if way == 8 { far.x } else { -far.y };
            let name = if at == incoming { format!("-r{id}") } else { format!("r{id}") };
            (road.draft.source == [way] && place * start > 0.0).then_some(name)
        };
        map.roads().iter().enumerate().find_map(fits).unwrap()
    };
    let way = |way: i64| format!("{}-&gt;{}", edge(way, -1.0, true), edge(way, 1.0, false));
    let told = format!(r#"<prohibition prohibitor="{}" prohibited="{}"/>"#, way(9), way(8));
    assert!(files.connections.contains(&told), "{told} {}", files.connections);
    let drive = opendrive::write(&map);
    assert!(drive.contains(r#"country="DE" type="206""#));
    let yields: usize = map.movements().iter().map(|movement| movement.yields.len()).sum();
    assert_eq!(drive.matches("<priority ").count(), yields);
    let (round, _) = crossing(&[], "highway=mini_roundabout");
    let files = sumo::write(&round, "round");
    let at = round.junctions().iter().find(|junction| junction.draft.control == Control::MiniRoundabout).unwrap();
    assert_eq!(files.connections.matches("shape=").count(), at.movements.len());
    assert!(files.connections.contains("<prohibition"));
    assert!(files.nodes.contains(r#"type="right_before_left" shape="#));
    // Among equal streets a sign does not take away that vehicles which wait for each other go on.
    let (given, _) = crossing(&[(6, -0.1, 0.0, "highway=give_way direction=forward")], "");
    assert!(sumo::write(&given, "give").nodes.contains(r#"type="right_before_left""#));
    // A stop takes time.
    let seconds = |map: &StreetMap| {
        Router::new(map, Mode::Car).route(&Point::new(-90.0, -2.0), &Point::new(90.0, -2.0)).unwrap().seconds
    };
    let (free, _) = crossing(&[], "");
    assert!(seconds(&map) > seconds(&free) + 2.0);
}
