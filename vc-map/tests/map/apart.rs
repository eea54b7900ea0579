//! Pavements that are mapped as ways of their own, and crossings between them.

use vc_map::osm::{Element, Guessed, Reason};
use vc_map::route::{Mode, Router};
use vc_map::{CrossingKind, Light, StripKind, Users};

use crate::osm::file;
use crate::town::import;

const STREET: &str = "highway=secondary sidewalk=separate";

/// A street along X with a crossing in its middle, and pavements so many metres to its north and south.
fn street(crossing: &str, pavements: &[f64]) -> (vc_map::StreetMap, vc_map::osm::ImportReport) {
    let mut nodes = vec![(1, -1.0, 0.0, ""), (2, 0.0, 0.0, crossing), (3, 1.0, 0.0, "")];
    let mut ways: Vec<(i64, [i64; 2])> = Vec::new();
    for (number, metres) in (0..).zip(pavements) {
        let id = 10 + 2 * number;
        nodes.extend([(id, -1.0, metres / 100.0, ""), (id + 1, 1.0, metres / 100.0, "")]);
        ways.push((20 + number, [id, id + 1]));
    }
    let mut all: Vec<(i64, &[i64], &str)> = vec![(9, &[1, 2, 3], STREET)];
    all.extend(ways.iter().map(|(id, refs)| (*id, refs.as_slice(), "highway=footway footway=sidewalk")));
    import(&file(&nodes, &all, ""))
}

#[test]
fn lights_for_people_stop_traffic_where_pavements_are_mapped_apart() {
    for apart in [[8.0, -8.0], [17.0, -14.0]] {
        let (map, report) = street("highway=crossing crossing=traffic_signals", &apart);
        let [crossing] = map.crossings() else { panic!("{:?}", map.crossings()) };
        assert_eq!(crossing.kind, CrossingKind::Signals);
        assert!(report.guessed.contains(&(Element::Node(2), Guessed::Links(2))));
        let [signal] = map.signals() else { panic!("{:?}", map.signals()) };
        let red = |phase: &vc_map::Phase| phase.lights[0] == Light::Red && phase.lights.last() == Some(&Light::Green);
        assert!(signal.phases.iter().any(red));
        assert_eq!(map.validate().iter().filter(|v| v.kind() != "streets cut off").count(), 0, "{:?}", map.validate());
        // From one pavement to the other over the crossing.
        let far = [40.0, -40.0].map(|y| vc_map::Point::new(-50.0, y));
        let walk = Router::new(&map, Mode::Foot).route(&far[0], &far[1]).unwrap();
        assert!((walk.metres - (100.0 + apart[0] - apart[1])).abs() < 3.0, "{}", walk.metres);
    }
}

#[test]
fn a_crossing_that_nobody_comes_to_is_told_and_stops_nobody() {
    for pavements in [&[8.0][..], &[8.0, -60.0]] {
        // A pavement is mapped on one side, and on the other nothing but that there is none.
        let (map, report) = street("highway=crossing crossing=traffic_signals", pavements);
        let paved =
            map.roads().iter().flat_map(|road| road.draft.section.strips()).any(|(_, s)| s.kind == StripKind::Pavement);
        assert!(paved, "where a pavement is said to be mapped apart and is not, it is guessed");
        assert_eq!((map.signals().len(), map.crossings().len()), (1, 1), "{report}");
    }
    let nodes = [(1, -1.0, 0.0, ""), (2, 0.0, 0.0, "highway=crossing crossing=traffic_signals"), (3, 1.0, 0.0, "")];
    let (map, report) = import(&file(&nodes, &[(9, &[1, 2, 3], "highway=secondary sidewalk=left")], ""));
    assert_eq!((map.signals().len(), map.crossings().len()), (0, 0));
    assert!(report.dropped.contains(&(Element::Node(2), Reason::NobodyCrosses)));
}

#[test]
fn a_pavement_that_is_said_to_be_mapped_apart_and_is_not_is_guessed() {
    let pavements = |map: &vc_map::StreetMap| {
        let strips = map.roads()[0].draft.section.strips();
        strips.filter(|(_, strip)| strip.kind == StripKind::Pavement && strip.users == Users::FOOT).count()
    };
    for (apart, left) in [(&[][..], 2), (&[8.0], 1), (&[8.0, -8.0], 0)] {
        let (map, report) = street("", apart);
        assert_eq!(pavements(&map), left);
        let told = report.guessed.iter().find(|(_, guessed)| matches!(guessed, Guessed::Pavements(_)));
        assert_eq!(told, (left > 0).then_some(&(Element::Way(9), Guessed::Pavements(left as u32))));
    }
}

#[test]
fn a_crossing_that_is_a_way_leads_from_kerb_to_kerb() {
    for (lanes, metres) in [(2, 5.5), (4, 12.0)] {
        let street = format!("highway=secondary lanes={lanes} width={metres} sidewalk=separate");
        let nodes = [
            (1, -1.0, 0.0, ""),
            (2, 0.0, 0.0, "highway=crossing crossing=traffic_signals"),
            (3, 1.0, 0.0, ""),
            (4, -1.0, 0.09, ""),
            (5, 0.0, 0.09, ""),
            (6, 1.0, 0.09, ""),
            (7, -1.0, -0.09, ""),
            (8, 0.0, -0.09, ""),
            (9, 1.0, -0.09, ""),
        ];
        let ways: [(i64, &[i64], &str); 4] = [
            (20, &[1, 2, 3], &street),
            (21, &[4, 5, 6], "highway=footway footway=sidewalk"),
            (22, &[7, 8, 9], "highway=footway footway=sidewalk"),
            (23, &[5, 2, 8], "highway=footway footway=crossing crossing=traffic_signals"),
        ];
        let (map, _) = import(&file(&nodes, &ways, ""));
        let [crossing] = map.crossings() else { panic!("{:?}", map.crossings()) };
        let width = map.road(crossing.roads[0]).unwrap().draft.section.surface();
        assert!((crossing.line.length() - width).abs() < 0.3, "{} {width}", crossing.line.length());
        assert!(map.validate().iter().all(|v| v.kind() == "streets cut off"), "{:?}", map.validate());
    }
}

#[test]
fn a_crossing_that_is_mapped_in_pieces_is_as_long_as_one_in_one() {
    // Nodes at the kerbs, at an island, and two pieces of which one is drawn the other way.
    let street = "highway=secondary lanes=4 width=13 sidewalk=separate";
    let crossing = "highway=footway footway=crossing crossing=traffic_signals";
    let sidewalk = "highway=footway footway=sidewalk";
    let nodes = [
        (1, -1.0, 0.0, ""),
        (2, 0.0, 0.0, "highway=crossing crossing=traffic_signals"),
        (3, 1.0, 0.0, ""),
        (4, -1.0, 0.09, ""),
        (5, 0.0, 0.09, ""),
        (6, 1.0, 0.09, ""),
        (7, -1.0, -0.09, ""),
        (8, 0.0, -0.09, ""),
        (9, 1.0, -0.09, ""),
        (10, 0.0, 0.027, "kerb=lowered"),
        (11, 0.0, -0.06, ""),
        (12, 0.0, -0.03, ""),
    ];
    let pieces: [&[(i64, &[i64], &str)]; 3] = [
        &[(23, &[5, 2, 8], crossing)],
        &[(23, &[10, 2, 12], crossing), (24, &[10, 5], "highway=footway"), (25, &[8, 12], "highway=footway width=3")],
        &[
            (23, &[2, 10], crossing),
            (24, &[12, 2], crossing),
            (25, &[12, 11, 8], "highway=footway"),
            (26, &[5, 10], sidewalk),
        ],
    ];
    for pieces in pieces {
        let mut ways: Vec<(i64, &[i64], &str)> =
            vec![(20, &[1, 2, 3], street), (21, &[4, 5, 6], sidewalk), (22, &[7, 8, 9], sidewalk)];
        ways.extend(pieces);
        let (map, _) = import(&file(&nodes, &ways, ""));
        let [crossing] = map.crossings() else { panic!("{:?}", map.crossings()) };
        assert!((crossing.line.length() - 13.0).abs() < 0.3, "{} {pieces:?}", crossing.line.length());
        assert!(map.validate().iter().all(|v| v.kind() == "streets cut off"), "{:?}", map.validate());
    }
}

#[test]
fn pavements_go_on_over_rails_at_any_angle() {
    for degrees in [90.0_f64, 60.0, 45.0, 30.0, 20.0] {
        let (y, x) = degrees.to_radians().sin_cos();
        for (rails, tracks) in [("railway=rail", 1), ("railway=tram", 1), ("railway=rail", 2), ("railway=tram", 3)] {
            // Tracks lie 4 m apart.
            let mut nodes = vec![(1, -1.0, 0.0, ""), (2, 1.0, 0.0, "")];
            let mut ways: Vec<(i64, Vec<i64>, &str)> = Vec::new();
            for track in 0..tracks {
                let (id, at) = (10 * (track + 1), 0.04 * track as f64 / y);
                nodes.extend([(id, at, 0.0, ""), (id + 1, at + x, y, ""), (id + 2, at - x, -y, "")]);
                ways.push((30 + track, vec![id + 1, id, id + 2], rails));
            }
            let street = [1].into_iter().chain((0..tracks).map(|track| 10 * (track + 1))).chain([2]).collect();
            ways.push((20, street, "highway=residential sidewalk=both"));
            let ways: Vec<(i64, &[i64], &str)> = ways.iter().map(|(id, refs, tags)| (*id, &refs[..], *tags)).collect();
            let (map, _) = import(&file(&nodes, &ways, ""));
            for side in [10.0, -10.0] {
                let ends = [-90.0, 90.0].map(|x| vc_map::Point::new(x, side));
                let walk = Router::new(&map, Mode::Foot).route(&ends[0], &ends[1]);
                assert!(walk.is_some_and(|walk| walk.metres < 183.0), "{degrees} {tracks} {:?}", map.crossings());
            }
            assert!(map.validate().iter().all(|v| v.kind() == "streets cut off"), "{degrees} {:?}", map.validate());
        }
    }
}

/// A street along X that meets one along Y with lights, a crossing over its western arm, and pavements on both sides that meet in
/// the corners; the crossing's ways end at a corner, so far from the middle of the junction in hundreds of metres.
fn bent(corner: f64, crossing: f64) -> (vc_map::StreetMap, vc_map::osm::ImportReport) {
    let lit = "highway=crossing crossing=traffic_signals";
    let nodes = [
        (1, 0.0, 0.0, "highway=traffic_signals"),
        (2, -1.0, 0.0, ""),
        (3, 1.0, 0.0, ""),
        (4, 0.0, -1.0, ""),
        (5, 0.0, 1.0, ""),
        (8, -crossing, 0.0, lit),
        (10, -corner, corner, ""),
        (11, -corner, -corner, ""),
        (12, -1.0, corner, ""),
        (13, -1.0, -corner, ""),
        (14, -corner, 1.0, ""),
        (15, -corner, -1.0, ""),
    ];
    let street = "highway=secondary lanes=2 width=6.5 sidewalk=separate";
    let ways: [(i64, &[i64], &str); 5] = [
        (20, &[2, 8, 1, 3], street),
        (21, &[4, 1, 5], street),
        (30, &[12, 10, 14], "highway=footway footway=sidewalk"),
        (31, &[13, 11, 15], "highway=footway footway=sidewalk"),
        (40, &[10, 8, 11], "highway=footway footway=crossing crossing=traffic_signals"),
    ];
    import(&file(&nodes, &ways, ""))
}

#[test]
fn crossings_bend_to_the_corners_where_their_ways_meet_pavements() {
    for crossing in [0.043, 0.05, 0.06, 0.08] {
        let (map, _) = bent(0.043, crossing);
        let [mapped] = map.crossings().iter().filter(|c| !c.guessed).collect::<Vec<_>>()[..] else {
            panic!("{crossing}: {:?}", map.crossings())
        };
        // The two ways from the corners, cut at the kerbs.
        assert!((6.0..9.0).contains(&mapped.line.length()), "{crossing}: {:?}", mapped.line);
        assert_eq!(map.walk_parts().len(), 1, "{crossing}");
        let kinds: Vec<_> = map.validate().iter().map(vc_map::MapViolation::kind).collect();
        assert!(kinds.iter().all(|kind| *kind == "streets cut off"), "{crossing} {kinds:?}");
    }
}

/// A crossroads with lights and a lit crossing on each arm, so far from its middle in hundreds of metres: with stop lines behind these,
/// pavements apart or as tags, and streets with these tags.
fn crossroads(
    crossing: f64,
    stop: Option<f64>,
    apart: bool,
    street: &str,
) -> (vc_map::StreetMap, vc_map::osm::ImportReport) {
    let lit = "highway=crossing crossing=traffic_signals";
    let mut nodes = vec![(1, 0.0, 0.0, if stop.is_some() { "" } else { "highway=traffic_signals" })];
    let mut ways: Vec<(i64, Vec<i64>, &str)> = Vec::new();
    for arm in 0..4_i64 {
        let [x, y] = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]][arm as usize];
        let at = |along: f64, left: f64| (x * along - y * left, y * along + x * left);
        let mut node = |id: i64, (x, y): (f64, f64), tags| nodes.push((id, x, y, tags));
        let id = 10 * (arm + 1);
        node(id, at(1.0, 0.0), "");
        node(id + 1, at(crossing, 0.0), lit);
        let mut way = vec![id];
        if let Some(stop) = stop {
            node(id + 2, at(crossing + stop, 0.0), "highway=traffic_signals traffic_signals:direction=forward");
            way.push(id + 2);
        }
        way.extend([id + 1, 1]);
        ways.push((100 + arm, way, street));
        if apart {
            // The corner to its left, and the pavements and crossing that lead there.
            let next = 10 * ((arm + 1) % 4 + 1);
            node(id + 3, at(crossing, 0.06), "");
            node(id + 4, at(crossing, -0.06), "");
            node(id + 5, at(1.0, 0.06), "");
            node(id + 6, at(1.0, -0.06), "");
            ways.push((
                200 + arm,
                vec![id + 3, id + 1, id + 4],
                "highway=footway footway=crossing crossing=traffic_signals",
            ));
            ways.push((300 + arm, vec![id + 5, id + 3, next + 4, next + 6], "highway=footway footway=sidewalk"));
        }
    }
    let ways: Vec<(i64, &[i64], &str)> = ways.iter().map(|(id, refs, tags)| (*id, &refs[..], *tags)).collect();
    import(&file(&nodes, &ways, ""))
}

#[test]
fn crossings_lie_where_they_are_mapped() {
    let separate = "highway=secondary lanes=2 width=6.5 sidewalk=separate";
    let tagged = "highway=secondary lanes=2 width=6.5 sidewalk=both";
    let bare = "highway=residential lanes=2 width=6.5 sidewalk=no";
    for (apart, street) in [(true, separate), (false, tagged), (true, bare)] {
        for crossing in [0.09, 0.12] {
            for stop in [None, Some(0.015), Some(0.03), Some(0.05)] {
                let (map, report) = crossroads(crossing, stop, apart, street);
                let told = format!("{street} {crossing} {stop:?} {:?}", map.crossings());
                let lit: Vec<_> = map.crossings().iter().filter(|c| c.kind == CrossingKind::Signals).collect();
                assert_eq!(lit.len(), 4, "{told} {report}");
                for crossed in lit {
                    let middle = crossed.line.at(crossed.line.length() / 2.0).coords.norm();
                    assert!((middle - crossing * 100.0).abs() < 1.1, "{middle} {told}");
                }
                assert_eq!((map.signals().len(), map.walk_parts().len()), (1, 1), "{told}");
                assert!(map.validate().iter().all(|v| v.kind() == "streets cut off"), "{:?} {told}", map.validate());
            }
        }
    }
}

#[test]
fn crossings_from_an_island_end_at_its_kerbs() {
    // A slip road around an island, from which crossings lead over both streets and over the slip road.
    let lit = "highway=crossing crossing=traffic_signals";
    let nodes = [
        (1, -1.5, 0.0, ""),
        (2, 0.0, 0.0, "highway=traffic_signals"),
        (3, 1.5, 0.0, ""),
        (4, 0.0, -1.5, ""),
        (31, 0.0, 1.5, ""),
        (5, -0.45, 0.0, ""),
        (6, 0.0, -0.45, ""),
        (7, -0.18, -0.18, "highway=crossing crossing=unmarked"),
        (8, -0.18, 0.0, lit),
        (9, 0.0, -0.18, lit),
        (27, -0.12, -0.12, ""),
        (28, -0.24, -0.24, ""),
        (20, -0.18, 0.08, ""),
        (21, -1.5, 0.08, ""),
        (23, 0.08, -0.18, ""),
        (24, 0.08, -1.5, ""),
        (29, -1.5, -0.24, ""),
        (30, -0.24, -1.5, ""),
        (40, -0.18, -0.036, ""),
        (41, -0.036, -0.18, ""),
        (32, -0.08, 1.5, ""),
        (33, -0.08, 0.12, ""),
        (34, 1.5, -0.08, ""),
        (35, 0.08, -0.08, ""),
    ];
    let street = "highway=secondary lanes=2 width=6.5 sidewalk=separate";
    let (walk, over) =
        ("highway=footway footway=sidewalk", "highway=footway footway=crossing crossing=traffic_signals");
    let ways: [(i64, &[i64], &str); 11] = [
        (50, &[1, 5, 8, 2, 3], street),
        (51, &[31, 2, 9, 6, 4], street),
        (52, &[5, 7, 6], "highway=secondary_link oneway=yes lanes=1 sidewalk=separate"),
        (60, &[21, 20, 33, 32], walk),
        (61, &[24, 23, 35, 34], walk),
        (62, &[29, 28, 30], walk),
        (63, &[28, 7, 27], "highway=footway footway=crossing crossing=unmarked"),
        (64, &[40, 8, 20], over),
        (65, &[41, 9, 23], over),
        (66, &[27, 40], "highway=footway"),
        (67, &[27, 41], "highway=footway"),
    ];
    let (map, report) = import(&file(&nodes, &ways, ""));
    let lit: Vec<f64> =
        map.crossings().iter().filter(|c| c.kind == CrossingKind::Signals).map(|c| c.line.length()).collect();
    assert!(lit.len() == 2 && lit.iter().all(|metres| (6.0..7.5).contains(metres)), "{lit:?} {report}");
}

#[test]
fn a_way_over_lanes_that_no_crossing_joins_is_told() {
    let nodes = [(1, -1.0, 0.0, ""), (3, 1.0, 0.0, ""), (4, 0.0, 0.5, ""), (5, 0.0, -0.5, "")];
    let over = "highway=footway footway=crossing crossing=traffic_signals";
    let ways: [(i64, &[i64], &str); 2] = [(20, &[1, 3], "highway=secondary sidewalk=no"), (21, &[4, 5], over)];
    let (map, _) = import(&file(&nodes, &ways, ""));
    assert!(map.validate().iter().any(|violation| violation.kind() == "pavement in a lane"), "{:?}", map.validate());
    // A crossing that one can come to by no way.
    let mut draft = map.draft().clone();
    let road = vc_map::RoadId(0);
    let at = draft.roads[0].from;
    draft.crossings.push(vc_map::CrossingDraft { at, road, kind: CrossingKind::Marked, island: false, source: 7 });
    let map = draft.build().unwrap();
    assert!(
        map.validate().iter().any(|violation| violation.kind() == "crossing without a way"),
        "{:?}",
        map.validate()
    );
}

#[test]
fn nobody_walks_around_the_island_of_a_ring() {
    for (tags, told) in [("sidewalk=both", true), ("sidewalk:both=yes", true), ("sidewalk=right", false), ("", false)] {
        let mut nodes = Vec::new();
        let mut ways: Vec<(i64, [i64; 2])> = Vec::new();
        for arm in 0..8_i64 {
            let (y, x) = (arm as f64 * std::f64::consts::FRAC_PI_4).sin_cos();
            nodes.push((10 + arm, 0.18 * x, 0.18 * y, ""));
            if arm % 2 == 0 {
                nodes.push((20 + arm, x, y, ""));
                ways.push((30 + arm, [20 + arm, 10 + arm]));
            }
        }
        let ring: Vec<i64> = (10..18).chain([10]).collect();
        let round = format!("highway=secondary junction=roundabout {tags}");
        let mut all: Vec<(i64, &[i64], &str)> = vec![(9, &ring, &round)];
        all.extend(ways.iter().map(|(id, refs)| (*id, refs.as_slice(), "highway=secondary sidewalk=both")));
        let (map, report) = import(&file(&nodes, &all, ""));
        assert_eq!(report.dropped.contains(&(Element::Way(9), Reason::IslandPavement)), told, "{report}");
        let inside = |edge: &vc_map::WalkEdge| edge.line.points().iter().any(|at| at.coords.norm() < 16.0);
        assert_eq!(map.walk_edges().iter().filter(|edge| inside(edge)).count(), 0, "{tags}");
        assert_eq!(map.walk_parts().len(), 1, "{tags}");
        assert!(map.validate().is_empty(), "{tags} {:?}", map.validate());
    }
}

#[test]
fn rails_in_the_median_part_no_junction() {
    // A dual carriageway 14 m wide with two tracks between, and a street across it; lights on both nodes.
    let lights = "highway=traffic_signals";
    let lines = [0.07, 0.015, -0.015, -0.07];
    let nodes: Vec<(i64, f64, f64, &str)> = (1..)
        .zip(lines)
        .flat_map(|(row, y): (i64, f64)| {
            let mark = if y.abs() > 0.05 { lights } else { "" };
            [(10 * row, -1.0, y, ""), (10 * row + 1, 0.0, y, mark), (10 * row + 2, 1.0, y, "")]
        })
        .chain([(1, 0.0, 1.0, ""), (2, 0.0, -1.0, "")])
        .collect();
    let ways: [(i64, &[i64], &str); 5] = [
        (20, &[12, 11, 10], "highway=primary oneway=yes sidewalk=right"),
        (21, &[20, 21, 22], "railway=tram"),
        (22, &[30, 31, 32], "railway=tram"),
        (23, &[40, 41, 42], "highway=primary oneway=yes sidewalk=right"),
        (24, &[1, 11, 21, 31, 41, 2], "highway=tertiary"),
    ];
    let (map, _) = import(&file(&nodes, &ways, ""));
    assert_eq!(map.signals().len(), 1);
    let wide = map.crossings().iter().filter(|crossing| crossing.roads.len() == 4).count();
    let lit = map.crossings().iter().filter(|crossing| crossing.kind == CrossingKind::Signals).count();
    assert_eq!((lit, wide), (4, 2), "{:?}", map.crossings());
}

#[test]
fn lights_at_rails_keep_cars_and_trams_apart() {
    let nodes = [
        (1, -1.0, 0.0, ""),
        (2, 0.0, 0.0, "highway=traffic_signals"),
        (3, 1.0, 0.0, ""),
        (4, 0.0, 1.0, ""),
        (5, 0.0, -1.0, ""),
    ];
    let ways: [(i64, &[i64], &str); 2] = [(20, &[1, 2, 3], "highway=secondary"), (21, &[4, 2, 5], "railway=tram")];
    let (map, report) = import(&file(&nodes, &ways, ""));
    let [signal] = map.signals() else { panic!("{report}") };
    let goes = |row: usize| {
        let green = |phase: &vc_map::Phase| matches!(phase.lights[row], Light::Green | Light::GreenYield);
        signal.phases.iter().map(green).collect::<Vec<bool>>()
    };
    let junction = map.junction(signal.junction).unwrap();
    let users = |row: usize| map.movement(junction.movements[row]).unwrap().users;
    for tram in (0..junction.movements.len()).filter(|row| users(*row).has(Users::TRAM)) {
        for car in (0..junction.movements.len()).filter(|row| users(*row).has(Users::CAR)) {
            assert!(goes(tram).iter().zip(goes(car)).all(|(a, b)| !(*a && b)), "{:?}", signal.phases);
        }
    }
}

#[test]
fn rails_in_a_street_are_crossed_with_it() {
    let nodes = [(1, -1.0, 0.0, ""), (2, 0.0, 0.0, ""), (3, 1.0, 0.0, ""), (4, 0.0, 1.0, ""), (5, 0.0, -1.0, "")];
    let rails = [(6, -1.0, 0.01, ""), (8, 1.0, 0.01, "")];
    let nodes: Vec<_> = nodes.into_iter().chain(rails).collect();
    let ways: [(i64, &[i64], &str); 3] = [
        (20, &[1, 2, 3], "highway=residential"),
        (21, &[4, 2, 5], "highway=residential"),
        (22, &[6, 2, 8], "railway=tram"),
    ];
    let (map, _) = import(&file(&nodes, &ways, ""));
    let tram = |id: &vc_map::RoadId| map.road(*id).unwrap().draft.class.is_rail();
    let over: Vec<_> = map.crossings().iter().filter(|crossing| crossing.roads.iter().any(tram)).collect();
    assert_eq!(over.len(), 2);
    assert!(over.iter().all(|crossing| crossing.roads.len() == 2 && crossing.line.length() > 5.0), "{over:?}");
}
