//! Buildings and their doors: outlines that do not cross themselves, beside streets, and doors that can be walked to.

use std::collections::BTreeMap;

use super::MapViolation;
use crate::index::PointIndex;
use crate::polyline::inside;
use crate::{
    Building, BuildingId, Entrance, EntranceId, Lane, LaneId, Point, Polyline, RoadId, StreetMap, StripKind, Structure,
    Users,
};

/// A door lies this near to the outline of its building, metres.
const DOOR: f64 = 2.0;
/// A building stands on a lane if its middle is inside for this long, metres, looked at each so many.
const LONGEST: f64 = 3.0;
const STEP: f64 = 1.0;
const MOST: f64 = 2000.0;

pub(super) fn violations(map: &StreetMap) -> Vec<MapViolation> {
    let ground = Ground::new(map);
    let mut found = Vec::new();
    for (index, building) in map.buildings().iter().enumerate() {
        let building_id = BuildingId::of(index);
        if is_tangled(building) {
            found.push(MapViolation::Outline { building: building_id });
        }
        if building.height <= building.base.max(0.0) {
            found.push(MapViolation::NoHeight { building: building_id });
        }
    }
    found.extend(ground.on_streets(map));
    for (index, entrance) in map.entrances().iter().enumerate() {
        found.extend(door(map, EntranceId::of(index), entrance, &ground));
    }
    let away = map.stops().iter().enumerate().filter(|(_, stop)| stop.lane.is_none() && stop.walk.is_none());
    found.extend(away.map(|(stop, _)| MapViolation::StopAway { stop }));
    found
}

fn is_tangled(building: &Building) -> bool {
    let mut walls = building.walls();
    walls.next().is_none_or(|outline| outline.crosses_itself()) || walls.any(|court| court.crosses_itself())
}

/// Whether a building stands on the ground, other than as a roof.
fn stands(building: &Building) -> bool {
    building.base <= 0.0 && !matches!(building.kind.as_str(), "roof" | "carport" | "bridge")
}

fn plain(ring: &[[f64; 2]]) -> Vec<Point> {
    ring.iter().map(|at| (*at).into()).collect()
}

/// The ground that buildings take.
struct Ground<'a> {
    buildings: &'a [Building],
    rings: Vec<Vec<Point>>,
    index: PointIndex,
}

impl<'a> Ground<'a> {
    fn new(map: &'a StreetMap) -> Self {
        let rings: Vec<Vec<Point>> = map.buildings().iter().map(|building| plain(&building.outline)).collect();
        let corners = |ring: &Vec<Point>| {
            let ends = [Point::new(f64::INFINITY, f64::INFINITY), Point::new(f64::NEG_INFINITY, f64::NEG_INFINITY)];
            ring.iter().fold(ends, |[low, high], point| [low.inf(point), high.sup(point)])
        };
        let index = PointIndex::of_boxes(rings.iter().map(corners));
        Self { buildings: map.buildings(), rings, index }
    }

    /// How many of some points lie within each building.
    fn within(&self, points: impl Iterator<Item = Point>) -> BTreeMap<BuildingId, u32> {
        let mut counts = BTreeMap::new();
        for at in points {
            self.index.around(&at, 0.0, |building| {
                let place = building as usize;
                let court = |b: &Building| b.courts.iter().any(|ring| inside(&plain(ring), &at));
                let fits = |b: &&Building| stands(b) && inside(&self.rings[place], &at) && !court(b);
                if self.buildings.get(place).filter(fits).is_some() {
                    *counts.entry(BuildingId(building)).or_default() += 1;
                }
                0.0
            });
        }
        counts
    }

    /// The buildings that stand on lanes for cars or pavements on the ground.
    fn on_streets(&self, map: &StreetMap) -> impl Iterator<Item = MapViolation> + use<> {
        let mut covered: BTreeMap<(BuildingId, RoadId), f64> = BTreeMap::new();
        let used = |lane: &&Lane| lane.users.has(Users::CAR) || lane.kind == StripKind::Pavement;
        for lane in map.lanes().iter().filter(used).filter(|lane| is_ground(map, lane)) {
            let steps = (lane.line.length() / STEP).ceil().clamp(1.0, MOST);
            let step = lane.line.length() / steps;
            for (building, count) in self.within((0..=steps as u32).map(|i| lane.line.at(f64::from(i) * step))) {
                let known = covered.entry((building, lane.road)).or_default();
                *known = known.max(f64::from(count) * step);
            }
        }
        let on = covered.into_iter().filter(|(_, metres)| *metres > LONGEST);
        on.map(|((building, road), metres)| MapViolation::OnStreet { building, road, metres })
    }

    /// A building through which the way between two points leads for more than a metre.
    fn between(&self, from: Point, to: Point) -> Option<BuildingId> {
        let steps = ((to - from).norm() / STEP).ceil().clamp(1.0, MOST) as u32;
        let points = (0..=steps).map(|step| from + (to - from) * (f64::from(step) / f64::from(steps)));
        self.within(points).into_iter().find(|(_, count)| *count > 2).map(|(building, _)| building)
    }
}

fn is_ground(map: &StreetMap, lane: &Lane) -> bool {
    map.road(lane.road).is_some_and(|road| road.draft.structure == Structure::Ground && road.draft.layer == 0)
}

fn door(map: &StreetMap, entrance: EntranceId, door: &Entrance, ground: &Ground<'_>) -> Option<MapViolation> {
    // Doors lead into courts, too.
    let near = |wall: Polyline| (wall.project(&door.door).point - door.door).norm();
    let walls = map.building(door.building)?.walls();
    let metres = walls.map(near).fold(f64::INFINITY, f64::min);
    if metres.is_finite() && metres > DOOR {
        return Some(MapViolation::DoorAway { entrance, metres });
    }
    let Some(at) = door.edge.and_then(|edge| map.walk_edge(edge)).map(|edge| edge.line.at(door.station)) else {
        return Some(MapViolation::DoorWithoutWay { entrance });
    };
    let on = |(lane, away): (LaneId, f64)| {
        let on = map.lane(lane)?;
        let drives = on.users.has(Users::CAR) && !on.users.has(Users::FOOT);
        (is_ground(map, on) && drives && away < on.width / 2.0).then_some(lane)
    };
    if let Some(lane) = map.lanes_around(&door.door, 2.0).find_map(on) {
        return Some(MapViolation::DoorInLane { entrance, lane });
    }
    ground.between(door.door, at).map(|building| MapViolation::DoorWalledIn { entrance, building })
}
