//! Buildings and their doors: outlines that do not cross themselves, beside streets, and doors that can be walked to.

use std::collections::BTreeMap;

use super::MapViolation;
use crate::index::PointIndex;
use crate::polyline::inside;
use crate::{Building, BuildingId, Entrance, EntranceId, LaneId, Point, Polyline, RoadId, StreetMap, Structure, Users};

/// A door lies this near to the outline of its building, metres.
const DOOR: f64 = 2.0;
/// A building stands on a lane if its middle is inside for this long, metres, looked at each so many.
const LONGEST: f64 = 3.0;
const STEP: f64 = 1.0;
const MOST: f64 = 2000.0;

pub(super) fn violations(map: &StreetMap) -> Vec<MapViolation> {
    let rings: Vec<Vec<Point>> =
        map.buildings().iter().map(|b| b.outline.iter().map(|at| (*at).into()).collect()).collect();
    let tangled = |building: &Building| {
        let mut walls = building.walls();
        walls.next().is_none_or(|outline| outline.crosses_itself()) || walls.any(|court| court.crosses_itself())
    };
    let outlines = map.buildings().iter().enumerate().filter(|(_, building)| tangled(building));
    let mut found: Vec<MapViolation> =
        outlines.map(|(index, _)| MapViolation::Outline { building: BuildingId::of(index) }).collect();
    found.extend(on_streets(map, &rings));
    for (index, entrance) in map.entrances().iter().enumerate() {
        found.extend(door(map, EntranceId::of(index), entrance));
    }
    found
}

/// The buildings that stand on lanes for cars on the ground.
fn on_streets(map: &StreetMap, rings: &[Vec<Point>]) -> impl Iterator<Item = MapViolation> {
    let around = |ring: &Vec<Point>| {
        let ends = [Point::new(f64::INFINITY, f64::INFINITY), Point::new(f64::NEG_INFINITY, f64::NEG_INFINITY)];
        ring.iter().fold(ends, |[low, high], point| [low.inf(point), high.sup(point)])
    };
    let index = PointIndex::of_boxes(rings.iter().map(around));
    let mut covered: BTreeMap<(BuildingId, RoadId), f64> = BTreeMap::new();
    for lane in map.lanes().iter().filter(|lane| lane.users.has(Users::CAR)) {
        let mut here: BTreeMap<BuildingId, f64> = BTreeMap::new();
        if !map.road(lane.road).is_some_and(|road| road.draft.structure == Structure::Ground && road.draft.layer == 0) {
            continue;
        }
        let steps = (lane.line.length() / STEP).ceil().clamp(1.0, MOST);
        for step in 0..=steps as u32 {
            let at = lane.line.at(lane.line.length() * f64::from(step) / steps);
            index.around(&at, 0.0, |building| {
                let place = building as usize;
                if map.buildings().get(place).is_some_and(stands) && inside(&rings[place], &at) {
                    *here.entry(BuildingId(building)).or_default() += lane.line.length() / steps;
                }
                0.0
            });
        }
        for (building, metres) in here {
            let known = covered.entry((building, lane.road)).or_default();
            *known = known.max(metres);
        }
    }
    let on = covered.into_iter().filter(|(_, metres)| *metres > LONGEST);
    on.map(|((building, road), metres)| MapViolation::OnStreet { building, road, metres })
}

/// Whether a building stands on the ground, other than as a roof.
fn stands(building: &Building) -> bool {
    building.base <= 0.0 && !matches!(building.kind.as_str(), "roof" | "carport" | "bridge")
}

fn door(map: &StreetMap, entrance: EntranceId, door: &Entrance) -> Option<MapViolation> {
    // Doors lead into courts, too.
    let near = |wall: Polyline| (wall.project(&door.door).point - door.door).norm();
    let walls = map.building(door.building)?.walls();
    let metres = walls.map(near).fold(f64::INFINITY, f64::min);
    if metres.is_finite() && metres > DOOR {
        return Some(MapViolation::DoorAway { entrance, metres });
    }
    if door.edge.is_none() {
        return Some(MapViolation::DoorWithoutWay { entrance });
    }
    let on = |(lane, away): (LaneId, f64)| {
        let on = map.lane(lane)?;
        let road = map.road(on.road)?;
        let ground = road.draft.structure == Structure::Ground && road.draft.layer == 0;
        (ground && on.users.has(Users::CAR) && !on.users.has(Users::FOOT) && away < on.width / 2.0).then_some(lane)
    };
    let lane = map.lanes_around(&door.door, 2.0).find_map(on)?;
    Some(MapViolation::DoorInLane { entrance, lane })
}
