//! Right of way, people's time to clear, crossings, bends: each rule against a slow plain statement of it.

use nalgebra::Point2;
use proptest::prelude::*;
use vc_map::validate::short_clearances;
use vc_map::{
    Control, CrossSection, DrivingSide, JunctionId, Light, MapDraft, Movement, RoadClass, RoadId, StreetMap, Strip,
    Turn, Turns,
};
use vc_testkit::cases;

use crate::town::street;

/// A junction with arms at some angles in degrees, each a road of 120 m towards the middle.
pub(crate) fn star(
    control: Control,
    side: DrivingSide,
    arms: &[(f64, RoadClass, bool)],
    lanes: usize,
) -> (MapDraft, JunctionId) {
    let mut draft = MapDraft::new("star", 48.0, 11.0);
    draft.side = side;
    let middle = draft.junction([0.0, 0.0], control);
    for (angle, class, slip) in arms {
        let (y, x) = angle.to_radians().sin_cos();
        let end = draft.junction([120.0 * x, 120.0 * y], Control::Edge);
        let road = draft.road(end, middle, *class, street(lanes));
        draft.roads[road.index()].slip = *slip;
    }
    (draft, middle)
}

fn road_of(map: &StreetMap, movement: &Movement) -> RoadId {
    map.lane(movement.from).unwrap().road
}

/// The degrees by which one has to turn to the right to look at who comes: 0 is oncoming, 90 is from the right.
fn bearing(mine: &Movement, theirs: &Movement) -> f64 {
    let heading = |m: &Movement| m.line.heading(0.0).to_degrees();
    (heading(mine) - (heading(theirs) + 180.0)).rem_euclid(360.0)
}

/// Whether `mine` gives way to `theirs`, said as people say it. `None` where the rule leaves it open.
fn gives_way(map: &StreetMap, mine: &Movement, theirs: &Movement) -> Option<bool> {
    let road = |movement: &Movement| &map.road(road_of(map, movement)).unwrap().draft;
    let (own, other) = (road(mine), road(theirs));
    if own.class != other.class {
        return Some(other.class < own.class);
    }
    if own.slip != other.slip {
        return Some(own.slip);
    }
    let over = |turn: Turn| match turn {
        Turn::Left => map.side() == DrivingSide::Right,
        Turn::Right => map.side() == DrivingSide::Left,
        _ => false,
    };
    match bearing(mine, theirs) {
        b if !(40.0..=320.0).contains(&b) => (over(mine.turn) != over(theirs.turn)).then_some(over(mine.turn)),
        b if (50.0..160.0).contains(&b) => Some(true),
        b if (200.0..310.0).contains(&b) => Some(false),
        _ => None,
    }
}

proptest! {
    #![proptest_config(cases(150))]

    #[test]
    fn of_two_who_conflict_one_gives_way_and_the_right_one(
        arms in prop::collection::vec((0usize..24, 0usize..3, any::<bool>()), 2..6),
        left: bool,
    ) {
        let classes = [RoadClass::Residential, RoadClass::Residential, RoadClass::Secondary];
        let mut arms: Vec<_> =
            arms.into_iter().map(|(angle, class, slip)| (15.0 * angle as f64, classes[class], slip)).collect();
        arms.sort_by(|a, b| a.0.total_cmp(&b.0));
        arms.dedup_by_key(|arm| arm.0);
        let side = if left { DrivingSide::Left } else { DrivingSide::Right };
        let (draft, middle) = star(Control::Priority, side, &arms, 1);
        let map = draft.build().unwrap();
        let junction = map.junction(middle).unwrap();
        let movement = |row: usize| map.movement(junction.movements[row]).unwrap();
        for (a, b) in junction.conflicts.pairs().filter(|(_, b)| *b < junction.movements.len()) {
            let (one, other) = (movement(a), movement(b));
            for movement in [one, other] {
                let lane = map.lane(movement.from).unwrap();
                let begins = lane.line.direction(lane.line.length()).dot(&movement.line.direction(0.0));
                prop_assert!(begins > 0.7 || movement.turn == Turn::Back || movement.line.length() < 1.0, "a kink");
            }
            let yields = [one.yields.contains(&(b as u32)), other.yields.contains(&(a as u32))];
            prop_assert!(yields[0] != yields[1], "{:?} {:?}", one.turn, other.turn);
            let turns_back = one.turn == Turn::Back || other.turn == Turn::Back;
            if let Some(mine) = gives_way(&map, one, other).filter(|_| !turns_back) {
                prop_assert_eq!(mine, yields[0], "{:?} {:?} {}", one, other, bearing(one, other));
            }
        }
    }

    #[test]
    fn people_who_have_begun_to_cross_are_over_before_others_start(
        arms in prop::collection::vec((0usize..24, 0usize..3, 1usize..6), 3..6),
        left: bool,
    ) {
        let mut arms: Vec<_> =
            arms.into_iter().map(|(angle, class, lanes)| (15.0 * angle as f64, RoadClass::ALL[2 + 2 * class], lanes)).collect();
        arms.sort_by(|a, b| a.0.total_cmp(&b.0));
        arms.dedup_by_key(|arm| arm.0);
        let side = if left { DrivingSide::Left } else { DrivingSide::Right };
        let stars: Vec<_> = arms.iter().map(|(angle, class, _)| (*angle, *class, false)).collect();
        let (mut draft, middle) = star(Control::Signals, side, &stars, 1);
        arms.iter().zip(&mut draft.roads).for_each(|((.., lanes), road)| road.section = street(*lanes));
        let map = draft.build().unwrap();
        let junction = map.junction(middle).unwrap();
        let Some(signal) = junction.signal.and_then(|id| map.signal(id)) else { return Ok(()) };
        // Second by second over two cycles: people who start in the last second of their green.
        let half = |seconds: f64| (seconds * 2.0).round() as usize;
        let one: Vec<usize> =
            signal.phases.iter().enumerate().flat_map(|(i, phase)| vec![i; half(phase.seconds)]).collect();
        let light = |step: usize, row: usize| signal.phases[one[step % one.len()]].lights[row];
        let goes = |step: usize, row: usize| matches!(light(step, row), Light::Green | Light::GreenYield);
        for (position, id) in junction.crossings.iter().enumerate() {
            let row = junction.movements.len() + position;
            let time = map.crossing(*id).unwrap().line.length() / 1.07;
            let mut walk = 0;
            for step in 0..2 * one.len() {
                walk = if goes(step, row) { walk + 1 } else { 0 };
                if walk > 0 && !goes(step + 1, row) {
                    prop_assert!(walk >= 14 || step < one.len(), "{walk} half seconds of green");
                    for later in (step + 1..step + 1 + (2.0 * time).ceil() as usize).filter(|later| !goes(*later, row)) {
                        for m in (0..junction.movements.len()).filter(|m| junction.conflicts.has(*m, row)) {
                            let starts = goes(later, m) && !goes(later - 1, m);
                            prop_assert!(!starts, "{} s after green, of {time}", (later - step - 1) as f64 / 2.0);
                        }
                    }
                }
            }
        }
        prop_assert_eq!(short_clearances(&map, signal), []);
    }

    #[test]
    fn crossings_lie_in_the_arms_and_stop_lines_before_them(
        arms in prop::collection::vec((0usize..16, 1usize..4), 3..5),
        left: bool,
        lit: bool,
    ) {
        let mut arms = arms;
        arms.sort_unstable();
        arms.dedup_by_key(|arm| arm.0);
        let stars: Vec<_> = arms.iter().map(|(angle, _)| (22.5 * *angle as f64, RoadClass::Residential, false)).collect();
        let side = if left { DrivingSide::Left } else { DrivingSide::Right };
        let (mut draft, middle) = star(if lit { Control::Signals } else { Control::Priority }, side, &stars, 1);
        arms.iter().zip(&mut draft.roads).for_each(|((_, lanes), road)| road.section = street(*lanes));
        let map = draft.build().unwrap();
        for id in &map.junction(middle).unwrap().crossings {
            let crossing = map.crossing(*id).unwrap();
            let [road] = crossing.roads[..] else { continue };
            let road = map.road(road).unwrap();
            // Roads lead to the middle here: the junction begins at the cut.
            let edge = road.line.length() - road.cuts[1];
            let along = |point: &Point2<f64>| road.line.project(point).station;
            let near = along(&crossing.line.start()).max(along(&crossing.line.end())) + crossing.width / 2.0;
            prop_assert!(near <= edge + 1e-6, "{near} {edge}");
            let back = along(&crossing.line.start()).min(along(&crossing.line.end())) - crossing.width / 2.0;
            for lane in road.lanes.iter().filter_map(|id| map.lane(*id)).filter(|lane| lane.forward && lane.stop_line.is_some()) {
                let stop = along(&lane.line.at(lane.stop_line.unwrap()));
                prop_assert!(stop <= back - 1.0 && stop >= back - 2.0, "{stop} {back}");
            }
        }
    }
}

#[test]
fn among_equals_the_right_comes_first_even_before_those_who_go_straight_on() {
    let arms = [0.0, 90.0, 180.0, 270.0].map(|angle| (angle, RoadClass::Residential, false));
    let (draft, middle) = star(Control::Priority, DrivingSide::Right, &arms, 1);
    let map = draft.build().unwrap();
    let of = |road: u32, turn: Turn| {
        let own = map.junction(middle).unwrap().movements.iter().enumerate();
        let movement = |(row, id): (usize, &vc_map::MovementId)| (row as u32, map.movement(*id).unwrap().clone());
        own.map(movement).find(|(_, m)| road_of(&map, m) == RoadId(road) && m.turn == turn).unwrap()
    };
    // From the west straight on, from the south to the left.
    let ((west, straight), (south, left)) = (of(2, Turn::Through), of(3, Turn::Left));
    assert!(straight.yields.contains(&south) && !left.yields.contains(&west));
}

#[test]
fn slip_roads_give_way_to_their_motorway_whatever_the_order_of_roads() {
    for order in [[0, 1, 2], [2, 1, 0], [1, 2, 0]] {
        let all = [
            (180.0, RoadClass::Motorway, false),
            (0.0, RoadClass::Motorway, false),
            (190.0, RoadClass::Motorway, true),
        ];
        let (mut draft, _) = star(Control::Priority, DrivingSide::Right, &order.map(|i| all[i]), 1);
        for road in &mut draft.roads {
            let one_way = CrossSection { forward: vec![Strip::driving(3.5, 33.0)], ..CrossSection::default() };
            let against = CrossSection { backward: vec![Strip::driving(3.5, 33.0)], ..CrossSection::default() };
            road.section = if road.line[0][0] < 0.0 { one_way } else { against };
        }
        let map = draft.build().unwrap();
        let slip = |movement: &&Movement| map.road(road_of(&map, movement)).unwrap().draft.slip;
        let (own, others): (Vec<_>, Vec<_>) = map.movements().iter().partition(slip);
        assert!(own.iter().all(|m| m.yields.len() == 1) && others.iter().all(|m| m.yields.is_empty()), "{order:?}");
    }
}

#[test]
fn a_street_that_bends_where_a_path_meets_it_goes_on() {
    let arms = [(180.0, RoadClass::Residential, false), (40.0, RoadClass::Residential, false)];
    let (mut draft, middle) = star(Control::Priority, DrivingSide::Right, &arms, 1);
    let end = draft.junction([0.0, -90.0], Control::Edge);
    let path = vec![Strip::new(vc_map::StripKind::Path, 2.0, vc_map::Users::FOOT, 1.4)];
    draft.road(middle, end, RoadClass::Path, CrossSection { forward: path, ..CrossSection::default() });
    let map = draft.build().unwrap();
    assert!(map.movements().iter().all(|movement| movement.turn == Turn::Through), "{:?}", map.movements());
}

#[test]
fn lanes_marked_for_a_fork_lead_to_their_branches() {
    let arms = [180.0, 20.0, 340.0].map(|angle| (angle, RoadClass::Primary, false));
    for marks in [[Turns::LEFT, Turns::RIGHT], [Turns::THROUGH, Turns::RIGHT], [Turns::LEFT, Turns::THROUGH]] {
        let (mut draft, _) = star(Control::Priority, DrivingSide::Right, &arms, 2);
        draft.roads[0].section.forward.iter_mut().zip(marks).for_each(|(strip, turns)| strip.turns = turns);
        let map = draft.build().unwrap();
        for (index, road) in [(0, RoadId(1)), (1, RoadId(2))] {
            let lane = map.lanes().iter().find(|l| l.road == RoadId(0) && l.forward && l.index == index).unwrap();
            let next = lane.next.iter().map(|id| map.movement(*id).unwrap());
            let cars = next.filter(|movement| movement.users.has(vc_map::Users::CAR));
            let cars: Vec<_> = cars.map(|movement| map.lane(movement.to).unwrap().road).collect();
            assert_eq!(cars, [road], "{marks:?}");
        }
    }
}
