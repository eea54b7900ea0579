//! The checks that a description has to pass.

use crate::{JunctionId, MapDraft, MapError, RoadId};

/// Coordinates are at most this, metres.
const FARTHEST: f64 = 1e6;

fn sound(at: &[f64; 2]) -> bool {
    at.iter().all(|value| value.abs() <= FARTHEST)
}

pub(super) fn check(draft: &MapDraft) -> Result<(), MapError> {
    let origin = draft.origin;
    if !(origin.latitude.abs() <= 89.0 && origin.longitude.abs() <= 180.0) {
        return Err(MapError::NoOrigin);
    }
    let nowhere = draft.junctions.iter().position(|junction| !sound(&junction.at));
    nowhere.map_or(Ok(()), |index| Err(MapError::Nowhere(JunctionId::of(index))))?;
    (0..draft.roads.len()).try_for_each(|index| road(draft, RoadId::of(index)))?;
    let bans = draft.bans.iter().flat_map(|ban| [("ban", ban.at, ban.from), ("ban", ban.at, ban.to)]);
    let crossings = draft.crossings.iter().map(|crossing| ("crossing", crossing.at, crossing.road));
    for (what, junction, road) in bans.chain(crossings) {
        let ends = draft.roads.get(road.index()).is_some_and(|found| found.from == junction || found.to == junction);
        if !ends {
            return Err(MapError::NotAtJunction { what, junction, road });
        }
    }
    places(draft)
}

fn road(draft: &MapDraft, id: RoadId) -> Result<(), MapError> {
    let road = &draft.roads[id.index()];
    for junction in [road.from, road.to] {
        if junction.index() >= draft.junctions.len() {
            return Err(MapError::NoSuchJunction { road: id, junction });
        }
    }
    let strip = |(_, strip): (bool, &crate::Strip)| {
        (0.1..=100.0).contains(&strip.width) && (0.1..=150.0).contains(&strip.limit)
    };
    let section = &road.section;
    if section.strips().next().is_none() || !section.strips().all(strip) || !(0.0..=100.0).contains(&section.median) {
        return Err(MapError::NoStrip(id));
    }
    if road.line.iter().all(sound) { Ok(()) } else { Err(MapError::NoLine(id)) }
}

fn places(draft: &MapDraft) -> Result<(), MapError> {
    let ring = |ring: &Vec<[f64; 2]>| ring.len() >= 3 && ring.iter().all(sound);
    let building = |b: &crate::Building| ring(&b.outline) && b.courts.iter().all(ring) && b.height.abs() < FARTHEST;
    if let Some(index) = draft.buildings.iter().position(|b| !building(b)) {
        return Err(MapError::NoOutline { what: "building", index });
    }
    if let Some(index) = draft.areas.iter().position(|area| !(ring(&area.outline) && area.holes.iter().all(ring))) {
        return Err(MapError::NoOutline { what: "area", index });
    }
    let lost = |e: &&crate::EntranceDraft| e.building.index() >= draft.buildings.len() || !sound(&e.at);
    draft.entrances.iter().find(lost).map_or(Ok(()), |e| Err(MapError::NoSuchBuilding(e.building)))?;
    let nowhere = draft.stops.iter().position(|stop| !sound(&stop.at));
    nowhere.map_or(Ok(()), |index| Err(MapError::NoOutline { what: "stop", index }))
}
