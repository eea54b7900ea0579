//! Lanes: the strips of roads that somebody uses, as lines in the direction of travel.

use super::budget::Budget;
use crate::parts::{Lane, Road};
use crate::{LaneId, MapDraft, MapError, Polyline, RoadId, StripKind};

/// The shortest lane, metres.
const SHORTEST: f64 = 0.05;

pub(super) fn centre_lines(draft: &MapDraft) -> Result<Vec<Polyline>, MapError> {
    let line = |(index, road): (usize, &crate::RoadDraft)| {
        Polyline::new(road.line.iter().copied()).ok_or(MapError::NoLine(RoadId::of(index)))
    };
    draft.roads.iter().enumerate().map(line).collect()
}

/// Roads with their lanes; a lane begins and ends where the junctions do.
pub(super) fn lanes(
    draft: &MapDraft,
    lines: Vec<Polyline>,
    cuts: &[[f64; 2]],
    budget: &mut Budget,
) -> Result<(Vec<Road>, Vec<Lane>), MapError> {
    let mut lanes = Vec::new();
    let mut roads = Vec::with_capacity(lines.len());
    for (index, (line, cuts)) in lines.into_iter().zip(cuts).enumerate() {
        let (id, first) = (RoadId::of(index), lanes.len());
        let mut road = Road { draft: draft.roads[index].clone(), line, cuts: *cuts, lanes: Vec::new() };
        // Its middle, and a lane beside it.
        budget.has(id, 2 * road.line.bytes())?;
        let middle = road.middle();
        for forward in [true, false] {
            side(draft, id, forward, &middle, &mut lanes, budget)?;
        }
        road.lanes = (first..lanes.len()).map(LaneId::of).collect();
        budget.take(id, std::slice::from_ref(&road))?;
        roads.push(road);
    }
    Ok((roads, lanes))
}

/// The lanes of one side of a road.
fn side(
    draft: &MapDraft,
    road: RoadId,
    forward: bool,
    middle: &Polyline,
    lanes: &mut Vec<Lane>,
    budget: &mut Budget,
) -> Result<(), MapError> {
    let section = &draft.roads[road.index()].section;
    let turned = if forward { 1.0 } else { -1.0 };
    let mut inner = None;
    let mut edge = section.median / 2.0 - turned * section.shift();
    for (index, strip) in section.side(forward).iter().enumerate() {
        let out = edge + strip.width / 2.0;
        edge += strip.width;
        let parked = strip.kind == StripKind::Parking;
        if strip.users.is_empty() && !parked {
            continue;
        }
        let line = middle.offset(-draft.side.sign() * turned * out);
        let line = if line.length() < SHORTEST { middle.clone() } else { line };
        let id = LaneId::of(lanes.len());
        lanes.push(Lane {
            road,
            forward,
            index,
            kind: strip.kind,
            width: strip.width,
            users: strip.users,
            limit: strip.limit,
            turns: strip.turns,
            line: if forward { line } else { line.reversed() },
            inner,
            outer: None,
            next: Vec::new(),
            before: Vec::new(),
            stop_line: None,
            sign: None,
        });
        if let Some(inner) = inner.map(|inner: LaneId| inner.index()) {
            lanes[inner].outer = Some(id);
        }
        inner = Some(id);
        budget.take(road, &lanes[id.index()..])?;
    }
    Ok(())
}
