//! Footways around ends of streets, and faults of maps that are told.

use nalgebra::Vector2;
use vc_map::validate::short_clearances;
use vc_map::{
    Control, CrossingDraft, CrossingKind, DrivingSide, Light, MapDraft, MapViolation, RoadClass, RoadId, WalkKind,
};

use crate::right_of_way::star;
use crate::town::{crossroads, street};

#[test]
fn a_dead_end_is_walked_around_and_not_crossed_as_well() {
    let mut draft = MapDraft::new("end", 48.0, 11.0);
    let ends = [draft.junction([0.0, 0.0], Control::Priority), draft.junction([80.0, 0.0], Control::Priority)];
    draft.road(ends[0], ends[1], RoadClass::Residential, street(1));
    let map = draft.build().unwrap();
    assert_eq!(map.crossings().len(), 0);
    assert_eq!(map.walk_edges().iter().filter(|edge| matches!(edge.kind, WalkKind::Corner(_))).count(), 2);
    assert_eq!(map.walk_parts().len(), 1);
}

#[test]
fn nobody_walks_around_the_outside_of_the_maps_edge() {
    // The outside is to the south, whichever arm comes last by its angle.
    for turned in [0.0, 90.0, 180.0, 270.0] {
        let arms = [20.0, 90.0, 160.0].map(|angle: f64| (angle + turned, RoadClass::Residential, false));
        let (draft, middle) = star(Control::Edge, DrivingSide::Right, &arms, 1);
        let map = draft.build().unwrap();
        let corners: Vec<_> = map.walk_edges().iter().filter(|edge| edge.kind == WalkKind::Corner(middle)).collect();
        assert_eq!(corners.len(), 2, "{turned}");
        let (y, x) = (90.0 + turned).to_radians().sin_cos();
        for corner in corners {
            let at = corner.line.at(corner.line.length() / 2.0).coords;
            assert!(at.dot(&Vector2::new(x, y)) > 0.0, "{turned}: {at:?}");
        }
    }
}

#[test]
fn a_road_that_begins_far_from_its_junction_is_told() {
    let mut draft = MapDraft::new("gap", 48.0, 11.0);
    let ends = [[0.0, 0.0], [400.0, 0.0], [-100.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
    let road = draft.road(ends[0], ends[1], RoadClass::Residential, street(1));
    draft.road(ends[2], ends[0], RoadClass::Residential, street(1));
    assert_eq!(draft.clone().build().unwrap().validate(), []);
    draft.roads[road.index()].line = vec![[300.0, 0.0], [400.0, 0.0]];
    let map = draft.build().unwrap();
    let found = map.validate();
    assert_eq!(found.len(), 5);
    assert_eq!(found[0], MapViolation::Aside { road, junction: ends[0], metres: 300.0 });
    for violation in &found[1..] {
        let MapViolation::Gap { junction, lane, metres } = violation else { panic!("{violation}") };
        assert!(*junction == ends[0] && map.lane(*lane).unwrap().road == road && *metres > 299.0);
    }
}

#[test]
fn crossings_that_differ_from_their_junction_in_lights_are_told() {
    for (control, kind, wrong) in [
        (Control::Signals, CrossingKind::Unmarked, true),
        (Control::Priority, CrossingKind::Signals, true),
        (Control::Signals, CrossingKind::Marked, false),
        (Control::Priority, CrossingKind::Marked, false),
    ] {
        let (map, middle) = crossroads(control, DrivingSide::Right, 1);
        let mut draft = map.draft().clone();
        draft.crossings.push(CrossingDraft { at: middle, road: RoadId(0), kind, island: false, source: 0 });
        let found = draft.build().unwrap().validate();
        assert_eq!(matches!(found[..], [MapViolation::Unlit { .. }]), wrong, "{control:?} {kind:?} {found:?}");
        assert_eq!(found.is_empty(), !wrong);
    }
}

#[test]
fn a_crossing_that_a_table_lacks_is_missed() {
    let (map, middle) = crossroads(Control::Signals, DrivingSide::Right, 2);
    let junction = map.junction(middle).unwrap();
    for row in junction.movements.len()..junction.conflicts.size() {
        let over: Vec<_> = junction.conflicts.pairs().filter(|(_, b)| *b == row).collect();
        // From two lanes of its own arm in three directions, and into it.
        assert!(over.len() >= 8, "{over:?}");
        for (one, other) in over {
            let mut less = junction.conflicts.clone();
            less.clear(one, other);
            assert_eq!(vc_map::validate::missing_conflicts(&map, middle, &less), [(one, other)]);
        }
    }
}

#[test]
fn a_signal_without_time_for_people_is_told() {
    let (map, middle) = crossroads(Control::Signals, DrivingSide::Right, 3);
    let signal = map.junction(middle).unwrap().signal.and_then(|id| map.signal(id)).unwrap();
    assert_eq!(short_clearances(&map, signal), []);
    let mut hasty = signal.clone();
    let movements = map.junction(middle).unwrap().movements.len();
    // People keep their green until that of vehicles ends.
    let walk: Vec<Light> = hasty.phases[0].lights[movements..].to_vec();
    hasty.phases[1].lights[movements..].copy_from_slice(&walk);
    let found = short_clearances(&map, &hasty);
    assert!(!found.is_empty() && found.iter().all(|(phase, _, seconds)| *phase == 1 && *seconds < 10.0), "{found:?}");
}
