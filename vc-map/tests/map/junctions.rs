//! Movements, conflicts, phases, crossings.

use vc_map::validate::{missing_conflicts, unsafe_phases};
use vc_map::{
    Control, CrossSection, DrivingSide, JunctionId, Light, MapDraft, MapError, MapViolation, RoadClass, RoadId,
    SignalId, Strip, StripKind, Turn, TurnBan, Users,
};

use crate::town::{crossroads, street};

const SIDES: [DrivingSide; 2] = [DrivingSide::Right, DrivingSide::Left];

#[test]
fn a_crossroads_lets_everybody_go_three_ways_and_walk_all_round() {
    for side in SIDES {
        let (map, middle) = crossroads(Control::Signals, side, 1);
        let junction = map.junction(middle).unwrap();
        let turns = |turn| junction.movements.iter().filter(|id| map.movement(**id).unwrap().turn == turn).count();
        assert_eq!([Turn::Through, Turn::Left, Turn::Right, Turn::Back].map(turns), [4, 4, 4, 0], "{side:?}");
        assert_eq!(junction.crossings.len(), 4);
        assert_eq!(map.walk_parts().len(), 1);
        assert_eq!(map.validate(), [], "{side:?}");
        // Those who keep to a side have the lanes on that side of the line.
        for lane in map.lanes().iter().filter(|lane| lane.kind == StripKind::Driving) {
            let road = map.road(lane.road).unwrap();
            let left = road.line.project(&lane.line.at(20.0)).left;
            assert_eq!(left < 0.0, lane.forward == (side == DrivingSide::Right));
        }
    }
}

#[test]
fn a_conflict_that_is_taken_out_is_missed() {
    let (map, middle) = crossroads(Control::Signals, DrivingSide::Right, 2);
    let table = &map.junction(middle).unwrap().conflicts;
    assert_eq!(missing_conflicts(&map, middle, table), []);
    let crossing = |(a, b): &(usize, usize)| {
        let movement = |row: usize| map.junction(middle).unwrap().movements.get(row).and_then(|id| map.movement(*id));
        movement(*a).zip(movement(*b)).is_some_and(|(a, b)| a.line.crosses(&b.line))
    };
    let pair = table.pairs().find(crossing).unwrap();
    let mut less = table.clone();
    less.clear(pair.0, pair.1);
    assert_eq!(missing_conflicts(&map, middle, &less), [pair]);
}

#[test]
fn a_phase_that_lets_two_go_who_meet_is_found() {
    let (map, middle) = crossroads(Control::Signals, DrivingSide::Right, 1);
    let (signal, table) = (&map.signals()[0], &map.junction(middle).unwrap().conflicts);
    assert_eq!(unsafe_phases(signal, table), []);
    let mut worse = signal.clone();
    worse.phases[0].lights.fill(Light::Green);
    assert_eq!(unsafe_phases(&worse, table).len(), table.pairs().count());
    // Two axes of about ninety seconds, each with an end without people, yellow and all red.
    assert_eq!(signal.phases.len(), 8);
    assert!((85.0..=95.0).contains(&signal.cycle()), "{}", signal.cycle());
}

#[test]
fn turns_give_way_to_those_who_go_straight_on_and_minor_roads_to_major_ones() {
    let mut draft = MapDraft::new("minor", 48.0, 11.0);
    let middle = draft.junction([0.0, 0.0], Control::Priority);
    for (end, class) in [
        ([100.0, 0.0], RoadClass::Primary),
        ([-100.0, 0.0], RoadClass::Primary),
        ([0.0, -100.0], RoadClass::Residential),
    ] {
        let end = draft.junction(end, Control::Edge);
        draft.road(end, middle, class, street(1));
    }
    let map = draft.build().unwrap();
    for movement in map.movements() {
        let class = map.road(map.lane(movement.from).unwrap().road).unwrap().draft.class;
        if movement.turn == Turn::Through {
            assert!(movement.yields.is_empty());
        }
        if class == RoadClass::Residential && movement.turn == Turn::Left {
            assert!(movement.yields.len() >= 2);
        }
    }
}

#[test]
fn marked_lanes_lead_where_their_marks_say_and_bans_are_kept() {
    let mut draft = MapDraft::new("marks", 48.0, 11.0);
    let middle = draft.junction([0.0, 0.0], Control::Priority);
    let mut roads = Vec::new();
    for end in [[-100.0, 0.0], [100.0, 0.0], [0.0, 100.0], [0.0, -100.0]] {
        let end = draft.junction(end, Control::Edge);
        roads.push(draft.road(end, middle, RoadClass::Secondary, street(2)));
    }
    draft.roads[0].section.forward[0].turns = vc_map::Turns::LEFT;
    draft.bans.push(TurnBan::new(roads[1], middle, roads[2]));
    let map = draft.build().unwrap();
    let from = |road: RoadId, index| {
        let lane = map
            .road(road)
            .unwrap()
            .lanes
            .iter()
            .map(|id| map.lane(*id).unwrap())
            .find(|l| l.forward && l.index == index);
        lane.unwrap().next.iter().map(|id| map.movement(*id).unwrap()).collect::<Vec<_>>()
    };
    assert!(from(roads[0], 0).iter().filter(|m| m.users.has(Users::CAR)).all(|movement| movement.turn == Turn::Left));
    assert!(from(roads[0], 1).iter().all(|movement| movement.turn != Turn::Left || !movement.users.has(Users::CAR)));
    let onto = |movement: &&vc_map::Movement| map.lane(movement.to).unwrap().road == roads[2];
    assert_eq!(map.movements().iter().filter(|m| map.lane(m.from).unwrap().road == roads[1]).filter(onto).count(), 0);
}

#[test]
fn a_dead_end_is_turned_at_and_the_edge_of_the_map_is_left_by() {
    for (control, count) in [(Control::Priority, 1), (Control::Edge, 0)] {
        let mut draft = MapDraft::new("end", 48.0, 11.0);
        let ends = [draft.junction([0.0, 0.0], control), draft.junction([80.0, 0.0], Control::Edge)];
        draft.road(ends[0], ends[1], RoadClass::Residential, street(1));
        let map = draft.build().unwrap();
        assert_eq!(map.junction(ends[0]).unwrap().movements.len(), count);
        assert_eq!(map.validate(), []);
    }
}

#[test]
fn a_street_apart_from_all_others_is_told_with_its_place() {
    let mut draft = MapDraft::new("apart", 48.0, 11.0);
    for y in [0.0, 500.0] {
        let ends =
            [draft.junction([0.0, y], Control::Priority), draft.junction([80.0 + y / 10.0, y], Control::Priority)];
        draft.road(ends[0], ends[1], RoadClass::Residential, street(1));
    }
    let map = draft.build().unwrap();
    let found = map.validate();
    assert!(matches!(found[..], [MapViolation::CutOff { .. }, MapViolation::WalkCutOff { .. }]), "{found:?}");
    assert!(found.iter().all(|violation| violation.place(&map).is_some()));
}

#[test]
fn descriptions_that_make_no_map_are_refused_with_the_part() {
    let mut draft = MapDraft::new("bad", 48.0, 11.0);
    let here = draft.junction([0.0, 0.0], Control::Priority);
    let road = draft.road(here, JunctionId(7), RoadClass::Residential, street(1));
    assert_eq!(draft.clone().build().unwrap_err(), MapError::NoSuchJunction { road, junction: JunctionId(7) });
    draft.roads[0].to = here;
    assert_eq!(draft.clone().build().unwrap_err(), MapError::Nowhere("a point of road 0".to_owned()));
    draft.roads[0].line = vec![[0.0, 0.0]; 2];
    assert_eq!(draft.clone().build().unwrap_err(), MapError::NoLine(road));
    draft.roads[0].line = vec![[0.0, 0.0], [9.0, 0.0]];
    draft.roads[0].section = CrossSection { forward: vec![Strip::driving(f64::NAN, 8.0)], ..CrossSection::default() };
    let error = draft.clone().build().unwrap_err().to_string();
    assert_eq!(error, "the width in metres of a strip of road 0 is NaN: give one from 0.1 to 100");
    draft.roads[0].section = CrossSection::default();
    assert_eq!(draft.clone().build().unwrap_err(), MapError::NoStrip(road));
    draft.origin.latitude = 200.0;
    assert_eq!(draft.build().unwrap_err(), MapError::NoOrigin);
    assert!(vc_map::StreetMap::signal(&crossroads(Control::Priority, DrivingSide::Right, 1).0, SignalId(0)).is_none());
}

#[test]
fn a_road_of_a_few_millimetres_between_wide_ones_is_built() {
    for metres in [0.0012, 0.004, 0.011, 0.3] {
        let mut draft = MapDraft::new("tiny", 48.0, 11.0);
        let at = [[-90.0, 0.0], [0.0, 0.0], [metres, 0.0], [90.0, 0.0], [0.0, 90.0], [metres, -90.0]];
        let ids = at.map(|at| draft.junction(at, Control::Priority));
        for [from, to] in [[0, 1], [1, 2], [2, 3], [4, 1], [5, 2]] {
            draft.road(ids[from], ids[to], RoadClass::Secondary, street(2));
        }
        let map = draft.build().unwrap();
        assert!(map.roads()[1].lanes.iter().all(|id| map.lane(*id).unwrap().line.length() > 0.0009));
    }
}

#[test]
fn what_is_near_is_found_however_far_it_is() {
    let (map, _) = crossroads(Control::Priority, DrivingSide::Right, 2);
    for away in [50.0, 3_000.0, 900_000.0] {
        let point = vc_map::Point::new(away, 40.0);
        let by = |lane: &&vc_map::Lane| lane.line.project(&point).left.abs();
        let cars = map.lanes().iter().filter(|lane| lane.users.has(Users::CAR));
        let nearest = cars.min_by(|a, b| by(a).total_cmp(&by(b))).unwrap();
        let (lane, station) = map.lane_near(&point, Users::CAR, 1e7).unwrap();
        assert_eq!(map.lane(lane).unwrap(), nearest, "{away}");
        assert_eq!(station, nearest.line.project(&point).station);
        let just = by(&nearest);
        assert!(
            map.lane_near(&point, Users::CAR, just * 0.999).is_none()
                && map.lane_near(&point, Users::CAR, just * 1.001).is_some()
        );
    }
}
