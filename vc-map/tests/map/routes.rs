//! Routes against a slow obvious search.

use std::collections::BTreeMap;

use vc_map::route::{Leg, Mode, Router};
use vc_map::{
    BuildingId, Control, CrossSection, EntranceId, MapDraft, Point, RoadClass, Strip, StripKind, Users, WalkKind,
};

use crate::town::{grid, riverside, street};

/// The shortest times over the walkable network in seconds, by trying all edges until nothing changes.
fn walked(map: &vc_map::StreetMap, from: EntranceId) -> BTreeMap<u32, f64> {
    let cost = |edge: &vc_map::WalkEdge| {
        let wait = match edge.kind {
            WalkKind::Crossing(id) => {
                let crossing = map.crossing(id).unwrap();
                let junction = map.junction(crossing.junction).unwrap();
                let row = junction.movements.len() + junction.crossings.iter().position(|other| *other == id).unwrap();
                match junction.signal.filter(|_| crossing.kind == vc_map::CrossingKind::Signals) {
                    Some(signal) => {
                        let phases = &map.signal(signal).unwrap().phases;
                        phases
                            .iter()
                            .filter(|p| matches!(p.lights[row], vc_map::Light::Red | vc_map::Light::Yellow))
                            .map(|p| p.seconds)
                            .sum::<f64>()
                            / 2.0
                    }
                    None => {
                        if crossing.kind == vc_map::CrossingKind::Signals {
                            0.0
                        } else {
                            3.0
                        }
                    }
                }
            }
            _ => 0.0,
        };
        edge.line.length() * if edge.steps { 1.6 } else { 1.0 } / 1.34 + wait
    };
    let start = map.entrance(from).unwrap();
    let edge = map.walk_edge(start.edge.unwrap()).unwrap();
    let pace = cost(edge) / edge.line.length();
    let mut best = BTreeMap::from([
        (edge.ends[0].0, start.station * pace),
        (edge.ends[1].0, (edge.line.length() - start.station) * pace),
    ]);
    loop {
        let mut changed = false;
        for edge in map.walk_edges() {
            for [a, b] in [[0, 1], [1, 0]] {
                let Some(known) = best.get(&edge.ends[a].0).copied() else { continue };
                let time = known + cost(edge);
                let at = best.entry(edge.ends[b].0).or_insert(f64::INFINITY);
                if time < *at - 1e-9 {
                    *at = time;
                    changed = true;
                }
            }
        }
        if !changed {
            return best;
        }
    }
}

#[test]
fn ways_on_foot_end_at_doors_and_are_as_fast_as_any() {
    let (map, _) = riverside();
    let router = Router::new(&map, Mode::Foot);
    for from in [0, 50, 120].map(EntranceId) {
        let times = walked(&map, from);
        for to in (0..map.entrances().len() as u32).step_by(13).map(EntranceId).filter(|to| *to != from) {
            let route = router.between_entrances(from, to).unwrap();
            let (start, end) = (map.entrance(from).unwrap(), map.entrance(to).unwrap());
            assert_eq!((route.line.start(), route.line.end()), (start.door, end.door));
            if start.edge == end.edge {
                continue;
            }
            let edge = map.walk_edge(end.edge.unwrap()).unwrap();
            let rest = [end.station, edge.line.length() - end.station];
            let last = |i: usize| times[&edge.ends[i].0] + rest[i] / 1.34 * if edge.steps { 1.6 } else { 1.0 };
            let least = last(0).min(last(1));
            // Costs are kept in whole milliseconds.
            assert!((route.seconds - least).abs() < 0.1, "{} {least}", route.seconds);
            for pair in route.legs.windows(2) {
                let [Leg::Walk(one, along), Leg::Walk(next, on)] = *pair else { panic!("{pair:?}") };
                let ends = |id| map.walk_edge(id).unwrap().ends;
                assert_eq!(ends(one)[usize::from(along)], ends(next)[usize::from(!on)], "legs meet");
            }
            let lines: Vec<f64> = route.line.points().windows(2).map(|w| (w[1] - w[0]).norm()).collect();
            assert!(lines.iter().all(|step| *step < 500.0));
        }
    }
    assert!(map.entrances_of(BuildingId(0)).len() == 1);
}

#[test]
fn cars_follow_movements_and_turn_as_little_as_they_can() {
    let map = grid(6);
    let router = Router::new(&map, Mode::Car);
    let route = router.route(&Point::new(50.0, -1.5), &Point::new(501.5, 450.0)).unwrap();
    let roads: Vec<_> = route
        .legs
        .iter()
        .map(|leg| match leg {
            Leg::Road(road, forward) => (*road, *forward),
            other => panic!("{other:?}"),
        })
        .collect();
    for pair in roads.windows(2) {
        let joined = map.movements().iter().any(|movement| {
            let side = |id| map.lane(id).map(|lane| (lane.road, lane.forward));
            side(movement.from) == Some(pair[0]) && side(movement.to) == Some(pair[1])
        });
        assert!(joined, "{pair:?}");
    }
    let turns = roads.windows(2).filter(|pair| {
        let along = |(road, _): (vc_map::RoadId, bool)| map.road(road).unwrap().line.direction(0.0);
        along(pair[0]).dot(&along(pair[1])).abs() < 0.5
    });
    assert_eq!(turns.count(), 1);
    assert!((route.metres - 900.0).abs() < 60.0, "{}", route.metres);
    // Behind oneself on a street of two directions: round a block or back at an end, never against the lane.
    let back = router.route(&Point::new(60.0, -1.5), &Point::new(40.0, -1.5)).unwrap();
    assert!(back.metres > 300.0 && back.legs.len() > 2);
}

#[test]
fn there_is_no_way_where_there_is_none() {
    let map = grid(2);
    let router = Router::new(&map, Mode::Car);
    assert!(router.route(&Point::new(50.0, 0.0), &Point::new(5000.0, 0.0)).is_none());
    assert!(router.to_entrance(&Point::new(50.0, 0.0), EntranceId(0)).is_none());
    let near = Router::new(&map, Mode::Foot).route(&Point::new(50.0, -4.0), &Point::new(50.0, -4.0));
    assert!(near.is_some_and(|route| route.metres < 0.1));
}

/// A square of streets, 300 m on a side, with a short cut through its middle of a class, private or not.
fn short_cut(class: RoadClass, private: bool) -> vc_map::StreetMap {
    let mut draft = MapDraft::new("short cut", 48.0, 11.0);
    let at = [[0.0, 0.0], [150.0, 0.0], [300.0, 0.0], [300.0, 300.0], [150.0, 300.0], [0.0, 300.0], [150.0, 150.0]];
    let ids = at.map(|at| draft.junction(at, Control::Priority));
    for [from, to] in [[0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [5, 0]] {
        draft.road(ids[from], ids[to], RoadClass::Residential, street(1));
    }
    for [from, to] in [[1, 6], [6, 4]] {
        let road = draft.road(ids[from], ids[to], class, street(1));
        draft.roads[road.index()].private = private;
    }
    draft.build().unwrap()
}

#[test]
fn nobody_drives_through_private_ground_but_to_a_place_there() {
    let (south, north, inside) = (Point::new(100.0, 0.0), Point::new(100.0, 300.0), Point::new(150.0, 220.0));
    let cases = [
        (RoadClass::Residential, false, Mode::Car, true),
        (RoadClass::Residential, true, Mode::Car, false),
        (RoadClass::Service, false, Mode::Car, false),
        (RoadClass::Service, false, Mode::Bicycle, true),
        (RoadClass::Service, true, Mode::Bicycle, false),
        (RoadClass::Service, true, Mode::Foot, true),
    ];
    for (class, private, mode, through) in cases {
        let map = short_cut(class, private);
        let router = Router::new(&map, mode);
        let enters = |route: &vc_map::route::Route| {
            route.legs.iter().any(|leg| match leg {
                Leg::Road(road, _) => map.road(*road).unwrap().draft.class == class && road.0 >= 6,
                Leg::Walk(edge, _) => map.walk_edge(*edge).unwrap().line.start().x > 140.0,
                _ => false,
            })
        };
        let round = router.route(&south, &north).unwrap();
        assert_eq!(enters(&round), through, "{class:?} {private} {mode}");
        let there = router.route(&south, &inside).unwrap();
        let back = router.route(&inside, &north).unwrap();
        assert!(enters(&there) && enters(&back));
        // Entering costs no time.
        assert!(there.seconds < 250.0 && back.seconds < 250.0 && there.metres < 330.0, "{} {mode}", there.seconds);
    }
}

#[test]
fn of_two_edges_between_the_same_places_the_fastest_is_taken() {
    // Steps straight up, and a path around that is longer and faster.
    let mut draft = MapDraft::new("steps", 48.0, 11.0);
    let at = [[-50.0, 0.0], [0.0, 0.0], [30.0, 0.0], [80.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
    let path =
        |kind| CrossSection { forward: vec![Strip::new(kind, 2.0, Users::FOOT, 1.4)], ..CrossSection::default() };
    for [from, to] in [[0, 1], [2, 3]] {
        draft.road(at[from], at[to], RoadClass::Path, path(StripKind::Path));
    }
    let steps = draft.road(at[1], at[2], RoadClass::Steps, path(StripKind::Path));
    let round = draft.road(at[1], at[2], RoadClass::Path, path(StripKind::Path));
    draft.roads[round.index()].line.insert(1, [15.0, 12.0]);
    let map = draft.build().unwrap();
    let way = Router::new(&map, Mode::Foot).route(&Point::new(-20.0, 0.0), &Point::new(50.0, 0.0)).unwrap();
    let roads: Vec<_> = way
        .legs
        .iter()
        .filter_map(|leg| match leg {
            Leg::Walk(edge, _) => match map.walk_edge(*edge)?.kind {
                WalkKind::Lane(lane) => Some(map.lane(lane)?.road),
                _ => None,
            },
            _ => None,
        })
        .collect();
    assert!(roads.contains(&round) && !roads.contains(&steps), "{roads:?}");
    assert!((way.seconds - way.metres / 1.34).abs() < 0.1);
}
