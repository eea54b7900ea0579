//! Maps that are broken by hand: each fault is told, with its place.

use vc_map::{
    Building, BuildingId, Control, CrossSection, EntranceDraft, MapDraft, MapViolation, RoadClass, RoadId, Strip,
};

use crate::town::{riverside, street};

/// The kinds of what is wrong with the town after a change, each once, and that the first is near a point.
fn wrong(change: impl Fn(&mut MapDraft)) -> Vec<&'static str> {
    let (map, _) = riverside();
    let mut draft = map.draft().clone();
    change(&mut draft);
    let map = draft.build().unwrap();
    let found = map.validate();
    assert!(found.iter().all(|violation| violation.place(&map).is_some() && !violation.to_string().is_empty()));
    let mut kinds: Vec<_> = found.iter().map(MapViolation::kind).collect();
    kinds.sort_unstable();
    kinds.dedup();
    kinds
}

/// A street of the town with cars on it, on the ground.
fn a_street(draft: &MapDraft) -> usize {
    let on = |road: &vc_map::RoadDraft| road.class == RoadClass::Residential && road.layer == 0 && road.line.len() == 2;
    draft.roads.iter().position(on).unwrap()
}

#[test]
fn the_town_as_it_is_has_no_fault() {
    assert_eq!(wrong(|_| {}), [""; 0]);
}

#[test]
fn lines_beside_their_junctions_knots_and_doubles_are_told() {
    for metres in [20.0, 70.0] {
        let found = wrong(|draft| {
            let road = a_street(draft);
            draft.roads[road].line[0][0] += metres;
        });
        assert!(found.contains(&"road beside its junction"), "{found:?}");
    }
    let found = wrong(|draft| draft.junctions[0].at[1] += 60.0);
    assert!(found.contains(&"road beside its junction"), "{found:?}");
    let found = wrong(|draft| {
        let road = a_street(draft);
        let [[x, y], end] = draft.roads[road].line[..] else { panic!("two points") };
        let zigzag = (0..40).map(|i| [x + f64::from(i % 3) * 9.0, y + f64::from(i % 2) * 9.0]);
        draft.roads[road].line = [[x, y]].into_iter().chain(zigzag).chain([end]).collect();
    });
    assert!(found.contains(&"road crosses itself"), "{found:?}");
    let found = wrong(|draft| draft.roads.push(draft.roads[a_street(draft)].clone()));
    assert!(found.contains(&"streets on each other"), "{found:?}");
    // Streets of many lanes, side by side within the width of one.
    let found = wrong(|draft| {
        for offset in 0..12 {
            let ends = [[-300.0, 0.0], [300.0, 0.0]].map(|[x, y]| [x + 2000.0, y + f64::from(offset) * 9.0]);
            let ends = ends.map(|at| draft.junction(at, Control::Edge));
            let section = CrossSection { forward: vec![Strip::driving(3.0, 10.0); 32], ..CrossSection::default() };
            draft.road(ends[0], ends[1], RoadClass::Minor, section);
        }
    });
    assert!(found.contains(&"streets on each other"), "{found:?}");
}

#[test]
fn buildings_and_doors_where_none_can_be_are_told() {
    let bow = vec![[2000.0, 0.0], [2010.0, 10.0], [2010.0, 0.0], [2000.0, 10.0]];
    assert_eq!(wrong(|draft| draft.buildings.push(Building::new(bow.clone(), 2))), ["outline crosses itself"]);
    let on_street = |draft: &mut MapDraft| {
        let line = &draft.roads[a_street(draft)].line;
        let [x, y] = [0, 1].map(|axis| (line[0][axis] + line[1][axis]) / 2.0);
        let ring = [[-6.0, -6.0], [6.0, -6.0], [6.0, 6.0], [-6.0, 6.0]].map(|[dx, dy]| [x + dx, y + dy]);
        draft.buildings.push(Building::new(ring.to_vec(), 2));
    };
    assert_eq!(wrong(on_street), ["building on a street"]);
    // A roof over it is none.
    let roof = |draft: &mut MapDraft| {
        on_street(draft);
        draft.buildings.last_mut().unwrap().base = 4.5;
    };
    assert_eq!(wrong(roof), [""; 0]);
    let away = |draft: &mut MapDraft| draft.entrances[0].at[0] += 3000.0;
    assert_eq!(wrong(away), ["door away from its building"]);
    let far = |draft: &mut MapDraft| {
        let building = BuildingId(draft.buildings.len() as u32);
        draft.buildings.push(Building::new(vec![[5000.0, 0.0], [5010.0, 0.0], [5000.0, 9.0]], 1));
        draft.entrances.push(EntranceDraft { building, at: [5005.0, 0.0], kind: "main".into(), source: 1 });
    };
    assert_eq!(wrong(far), ["door without a way"]);
    let in_lane = |draft: &mut MapDraft| {
        on_street(draft);
        let building = BuildingId(draft.buildings.len() as u32 - 1);
        let line = &draft.roads[a_street(draft)].line;
        let [a, b] = [line[0], line[1]].map(nalgebra::Point2::from);
        let along = (b - a).normalize();
        let at = a + (b - a) / 2.0 + along * 6.0;
        draft.entrances.push(EntranceDraft { building, at: at.into(), kind: "main".into(), source: 1 });
    };
    assert_eq!(wrong(in_lane), ["building on a street", "door in a lane"]);
}

#[test]
fn streets_that_cross_without_a_junction_heights_and_stops_are_told() {
    let over = |draft: &mut MapDraft, layer: i8| {
        let ends = [[-300.0, 3000.0], [300.0, 3000.0], [0.0, 2700.0], [0.0, 3300.0]];
        let ends = ends.map(|at| draft.junction(at, Control::Edge));
        let section = CrossSection { forward: vec![Strip::driving(3.0, 10.0)], ..CrossSection::default() };
        draft.road(ends[0], ends[1], RoadClass::Minor, section.clone());
        let above = draft.road(ends[2], ends[3], RoadClass::Minor, section);
        draft.roads[above.index()].layer = layer;
    };
    assert_eq!(wrong(|draft| over(draft, 0)), ["streets cross without a junction"]);
    assert_eq!(wrong(|draft| over(draft, 1)), [""; 0]);
    assert_eq!(wrong(|draft| draft.buildings[3].base = draft.buildings[3].height + 1.0), ["building without height"]);
    assert_eq!(wrong(|draft| draft.stops[0].at[0] += 5000.0), ["stop away from everything"]);
}

#[test]
fn a_door_that_is_walled_in_is_told() {
    let walled = |draft: &mut MapDraft| {
        let at = nalgebra::Point2::from(draft.entrances[0].at);
        for [dx, dy] in [[30.0, 0.0], [-30.0, 0.0], [0.0, 30.0], [0.0, -30.0]] {
            let around = [[-40.0, -40.0], [40.0, -40.0], [40.0, 40.0], [-40.0, 40.0]];
            let ring = around.map(|[x, y]| [at.x + dx * 1.4 + x * 0.9, at.y + dy * 1.4 + y * 0.9]);
            draft.buildings.push(Building::new(ring.to_vec(), 2));
        }
    };
    assert!(wrong(walled).contains(&"way to a door through a building"));
}

#[test]
fn lights_that_stop_nobody_are_told() {
    let mut draft = MapDraft::new("lights", 48.0, 11.0);
    let ends = [[-100.0, 0.0], [0.0, 0.0], [100.0, 0.0]].map(|at| draft.junction(at, Control::Edge));
    draft.junctions[1].control = Control::Signals;
    let section = CrossSection { forward: vec![Strip::driving(3.0, 10.0)], ..CrossSection::default() };
    draft.road(ends[0], ends[1], RoadClass::Minor, section.clone());
    draft.road(ends[1], ends[2], RoadClass::Minor, section);
    let found = draft.build().unwrap().validate();
    assert!(matches!(found[..], [MapViolation::NeverRed { .. }]), "{found:?}");
    // Two that come towards each other and would always go together go one after the other.
    let mut draft = MapDraft::new("lights", 48.0, 11.0);
    let ends = [[-100.0, 0.0], [0.0, 0.0], [100.0, 0.0]].map(|at| draft.junction(at, Control::Edge));
    draft.junctions[1].control = Control::Signals;
    let mut both = street(1);
    [&mut both.forward, &mut both.backward].into_iter().for_each(|side| side.truncate(1));
    draft.road(ends[0], ends[1], RoadClass::Minor, both.clone());
    draft.road(ends[1], ends[2], RoadClass::Minor, both);
    assert_eq!(draft.build().unwrap().validate(), []);
}

#[test]
fn a_pavement_that_ends_in_a_lane_is_told() {
    // Two streets of six lanes that part at 15 degrees: no cut is long enough to bring their pavements apart.
    let mut draft = MapDraft::new("fork", 48.0, 11.0);
    let middle = draft.junction([0.0, 0.0], Control::Priority);
    for angle in [0.0_f64, 15.0, 180.0] {
        let (y, x) = angle.to_radians().sin_cos();
        let end = draft.junction([200.0 * x, 200.0 * y], Control::Edge);
        draft.road(middle, end, RoadClass::Secondary, street(3));
    }
    let map = draft.build().unwrap();
    let kinds: Vec<_> = map.validate().iter().map(MapViolation::kind).collect();
    assert!(kinds.contains(&"pavement in a lane"), "{kinds:?}");
    assert!(map.road(RoadId(0)).is_some());
}

#[test]
fn a_crossing_within_its_road_is_told() {
    // Paths from both sides end at nodes in a wide street.
    let mut draft = MapDraft::new("narrow", 48.0, 11.0);
    let places = [[-100.0, 0.0], [0.0, 0.0], [100.0, 0.0], [0.0, 2.0], [0.0, -2.0], [0.0, 40.0], [0.0, -40.0]];
    let at = places.map(|place| draft.junction(place, Control::Priority));
    let wide = || CrossSection { forward: vec![Strip::driving(3.0, 10.0); 4], ..CrossSection::default() };
    draft.road(at[0], at[1], RoadClass::Secondary, wide());
    draft.road(at[1], at[2], RoadClass::Secondary, wide());
    let path = || CrossSection {
        forward: vec![Strip::new(vc_map::StripKind::Path, 2.0, vc_map::Users::FOOT, 1.4)],
        ..CrossSection::default()
    };
    for (from, to) in [(1, 3), (1, 4), (3, 5), (4, 6)] {
        draft.road(at[from], at[to], RoadClass::Path, path());
    }
    draft.crossings.push(vc_map::CrossingDraft {
        at: at[1],
        road: RoadId(0),
        kind: vc_map::CrossingKind::Marked,
        island: false,
        source: 1,
    });
    let map = draft.build().unwrap();
    let kinds: Vec<_> = map.validate().iter().map(MapViolation::kind).collect();
    assert!(kinds.contains(&"crossing ends in its road"), "{kinds:?} {:?}", map.crossings());
}
