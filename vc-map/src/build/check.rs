//! The checks that a description has to pass.

use std::fmt::Display;
use std::ops::RangeInclusive;

use crate::{Area, Building, BuildingId, CrossSection, EntranceId, JunctionId, MapDraft, MapError, RoadId};

/// Coordinates and heights are at most this, metres.
const FARTHEST: f64 = 1e6;
/// Widths of strips and of a median, metres, and limits, metres per second.
const WIDTH: RangeInclusive<f64> = 0.1..=100.0;
const MEDIAN: RangeInclusive<f64> = 0.0..=100.0;
const LIMIT: RangeInclusive<f64> = 0.1..=150.0;
/// The most strips on a side of a road.
const STRIPS: usize = 32;

fn sound(at: &[f64; 2]) -> bool {
    at.iter().all(|value| value.abs() <= FARTHEST)
}

fn at(part: impl Display, place: &[f64; 2]) -> Result<(), MapError> {
    if sound(place) { Ok(()) } else { Err(MapError::Nowhere(part.to_string())) }
}

/// That a quantity of a part is within a range; no number is not.
fn within(part: impl Display, what: &'static str, value: f64, range: &RangeInclusive<f64>) -> Result<(), MapError> {
    let (least, most) = (*range.start(), *range.end());
    let wrong = || MapError::OutOfRange { part: part.to_string(), what, value, least, most };
    range.contains(&value).then_some(()).ok_or_else(wrong)
}

pub(super) fn check(draft: &MapDraft) -> Result<(), MapError> {
    let origin = draft.origin;
    if !(origin.latitude.abs() <= 89.0 && origin.longitude.abs() <= 180.0) {
        return Err(MapError::NoOrigin);
    }
    draft.junctions.iter().enumerate().try_for_each(|(index, j)| at(JunctionId::of(index), &j.at))?;
    (0..draft.roads.len()).try_for_each(|index| road(draft, RoadId::of(index)))?;
    let bans = draft.bans.iter().flat_map(|ban| [("ban", ban.at, ban.from), ("ban", ban.at, ban.to)]);
    let crossings = draft.crossings.iter().map(|crossing| ("crossing", crossing.at, crossing.road));
    let signs = draft.signs.iter().map(|sign| ("sign", sign.at, sign.road));
    for (what, junction, road) in bans.chain(crossings).chain(signs) {
        let ends = draft.roads.get(road.index()).is_some_and(|found| found.from == junction || found.to == junction);
        if !ends {
            return Err(MapError::NotAtJunction { what, junction, road });
        }
    }
    draft.buildings.iter().enumerate().try_for_each(|(index, b)| building(index, b))?;
    draft.areas.iter().enumerate().try_for_each(|(index, a)| area(index, a))?;
    (0..draft.entrances.len()).try_for_each(|index| entrance(draft, index))?;
    draft.stops.iter().enumerate().try_for_each(|(index, stop)| at(format_args!("stop {index}"), &stop.at))
}

fn road(draft: &MapDraft, id: RoadId) -> Result<(), MapError> {
    let road = &draft.roads[id.index()];
    for junction in [road.from, road.to] {
        if junction.index() >= draft.junctions.len() {
            return Err(MapError::NoSuchJunction { road: id, junction });
        }
    }
    section(id, &road.section)?;
    road.line.iter().try_for_each(|point| at(format_args!("a point of {id}"), point))
}

fn section(id: RoadId, section: &CrossSection) -> Result<(), MapError> {
    let most = section.forward.len().max(section.backward.len());
    if most == 0 {
        return Err(MapError::NoStrip(id));
    }
    if most > STRIPS {
        return Err(MapError::TooMany { part: id.to_string(), what: "strips on a side", count: most, most: STRIPS });
    }
    for (_, strip) in section.strips() {
        within(format_args!("a strip of {id}"), "width in metres", strip.width, &WIDTH)?;
        within(format_args!("a strip of {id}"), "limit in metres per second", strip.limit, &LIMIT)?;
    }
    within(id, "median in metres", section.median, &MEDIAN)
}

fn ring(what: &'static str, index: usize, points: &[[f64; 2]]) -> Result<(), MapError> {
    let fine = points.len() >= 3 && points.iter().all(sound);
    if fine { Ok(()) } else { Err(MapError::NoOutline { what, index }) }
}

fn building(index: usize, building: &Building) -> Result<(), MapError> {
    std::iter::once(&building.outline)
        .chain(&building.courts)
        .try_for_each(|points| ring("building", index, points))?;
    let id = BuildingId::of(index);
    let heights = [("height in metres", building.height), ("base in metres", building.base)];
    heights.into_iter().try_for_each(|(what, value)| within(id, what, value, &(-FARTHEST..=FARTHEST)))
}

fn area(index: usize, area: &Area) -> Result<(), MapError> {
    std::iter::once(&area.outline).chain(&area.holes).try_for_each(|points| ring("area", index, points))
}

fn entrance(draft: &MapDraft, index: usize) -> Result<(), MapError> {
    let (id, entrance) = (EntranceId::of(index), &draft.entrances[index]);
    if entrance.building.index() >= draft.buildings.len() {
        return Err(MapError::NoSuchBuilding { entrance: id, building: entrance.building });
    }
    at(id, &entrance.at)
}
