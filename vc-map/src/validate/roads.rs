//! Roads as they are described: lines that begin at their junctions, do not cross themselves, and lie beside each other.

use std::collections::BTreeMap;

use super::MapViolation;
use crate::{Lane, LaneId, Point, RoadId, StreetMap, StripKind, Users};

/// A road's line begins this near to a junction that is one point, metres.
const AT: f64 = 1.0;
/// Lanes are looked at each so many metres, at most so often.
const STEP: f64 = 5.0;
const MOST: f64 = 400.0;
/// Lanes lie on each other if this part of one does, and vehicles of this width on them touch, metres.
const PART: f64 = 0.5;
const VEHICLE: f64 = 1.8;

pub(super) fn violations(map: &StreetMap) -> Vec<MapViolation> {
    let mut found = Vec::new();
    for (index, road) in map.roads().iter().enumerate() {
        let id = RoadId::of(index);
        for (junction, point) in [(road.draft.from, road.line.start()), (road.draft.to, road.line.end())] {
            let Some(place) = map.junction(junction) else { continue };
            let metres = (place.at - point).norm();
            // Where several nodes are one junction each road begins at its own.
            if place.draft.source.len() <= 1 && metres > AT {
                found.push(MapViolation::Aside { road: id, junction, metres });
            }
        }
        if road.line.crosses_itself() {
            found.push(MapViolation::Tangled { road: id });
        }
    }
    found.extend(overlaps(map));
    found.extend(crossings(map));
    found
}

/// Streets that lie on each other for most of a lane.
fn overlaps(map: &StreetMap) -> impl Iterator<Item = MapViolation> {
    let mut pairs: BTreeMap<[RoadId; 2], f64> = BTreeMap::new();
    for (index, lane) in map.lanes().iter().enumerate().filter(|(_, lane)| drives(lane)) {
        for (other, metres) in beside(map, LaneId::of(index), lane) {
            let pair = [lane.road.min(other), lane.road.max(other)];
            let known = pairs.entry(pair).or_default();
            *known = known.max(metres);
        }
    }
    pairs.into_iter().map(|(roads, metres)| MapViolation::Overlap { roads, metres })
}

/// Streets on one level that cross where they have no junction, once for each two.
fn crossings(map: &StreetMap) -> impl Iterator<Item = MapViolation> {
    let street = |id: &RoadId| map.road(*id).filter(|road| road.draft.class.is_street());
    let mut found: BTreeMap<[RoadId; 2], Point> = BTreeMap::new();
    for (id, road) in (0..map.roads().len()).map(RoadId::of).filter_map(|id| Some((id, street(&id)?))) {
        let ends = [road.draft.from, road.draft.to];
        let apart = |other: &crate::Road| {
            let level = (other.draft.layer, other.draft.structure) == (road.draft.layer, road.draft.structure);
            level && !ends.contains(&other.draft.from) && !ends.contains(&other.draft.to)
        };
        for piece in road.line.points().windows(2) {
            for lane in map.lanes_crossed([piece[0], piece[1]]) {
                let Some(lane) = map.lane(lane).filter(|lane| drives(lane) && lane.road > id) else { continue };
                if street(&lane.road).is_some_and(apart) {
                    found.entry([id, lane.road]).or_insert(nalgebra::center(&piece[0], &piece[1]));
                }
            }
        }
    }
    found.into_iter().map(|(roads, at)| MapViolation::Crosses { roads, at })
}

fn drives(lane: &Lane) -> bool {
    lane.kind == StripKind::Driving && lane.users.any(Users::CAR | Users::BUS)
}

/// The other roads whose lanes lie on a lane for most of its length, with the metres.
fn beside(map: &StreetMap, id: LaneId, lane: &Lane) -> Vec<(RoadId, f64)> {
    let steps = (lane.line.length() / STEP).ceil().clamp(1.0, MOST);
    let Some(road) = map.road(lane.road) else { return Vec::new() };
    let level = |road: &crate::Road| (road.draft.layer, road.draft.structure);
    let mut hits: BTreeMap<RoadId, f64> = BTreeMap::new();
    for step in 0..steps as u32 {
        let at = lane.line.at((f64::from(step) + 0.5) * lane.line.length() / steps);
        let mut here: Vec<RoadId> = map
            .lanes_around(&at, VEHICLE)
            .filter(|(other, _)| *other != id)
            .filter_map(|(other, _)| map.lane(other).filter(|lane| drives(lane)))
            .filter(|other| other.road != lane.road && map.road(other.road).is_some_and(|r| level(r) == level(road)))
            .map(|other| other.road)
            .collect();
        here.sort_unstable();
        here.dedup();
        here.into_iter().for_each(|road| *hits.entry(road).or_default() += 1.0);
    }
    let most = hits.into_iter().filter(|(_, count)| count / steps > PART && lane.line.length() > STEP);
    most.map(|(road, count)| (road, count / steps * lane.line.length())).collect()
}
