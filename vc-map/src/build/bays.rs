//! Parking bays, doors and stops, each beside its lane or pavement.

use crate::parts::{Bay, Entrance, Lane, Stop, WalkKind};
use crate::{LaneId, Point, StopKind, StreetMap, StripKind, Users};

/// The length and width of a bay along the kerb, metres.
const ALONG: [f64; 2] = [5.75, 2.1];
/// A parking lane that is wider has bays across, metres.
const ACROSS: f64 = 3.5;
/// The width of a bay across, metres.
const ACROSS_WIDTH: f64 = 2.5;
/// No bay is nearer to a junction, metres.
const CLEAR: f64 = 5.0;
/// A door is at most this far from the walkable network, metres.
const DOOR: f64 = 200.0;
/// A stop is at most this far from its lane, metres.
const STOP: f64 = 25.0;

pub(super) fn bays(lanes: &[Lane]) -> Vec<Bay> {
    let parking = lanes.iter().enumerate().filter(|(_, lane)| lane.kind == StripKind::Parking);
    parking.flat_map(|(index, lane)| row(LaneId::of(index), lane)).collect()
}

fn row(id: LaneId, lane: &Lane) -> impl Iterator<Item = Bay> {
    let across = lane.width > ACROSS;
    let size = if across { [lane.width, ACROSS_WIDTH] } else { [ALONG[0], lane.width] };
    let (step, turn) = if across { (ACROSS_WIDTH, std::f64::consts::FRAC_PI_2) } else { (ALONG[0], 0.0) };
    let count = ((lane.line.length() - 2.0 * CLEAR) / step).clamp(0.0, 1e4) as u32;
    (0..count).map(move |i| {
        let station = CLEAR + (f64::from(i) + 0.5) * step;
        Bay { lane: id, at: lane.line.at(station), heading: lane.line.heading(station) + turn, size }
    })
}

pub(super) fn entrances(map: &StreetMap) -> Vec<Entrance> {
    let entrance = |draft: &crate::EntranceDraft| {
        let door = Point::from(draft.at);
        let near = map.pavement_near(&door, DOOR);
        Entrance {
            building: draft.building,
            door,
            edge: near.map(|(edge, _)| edge),
            station: near.map_or(0.0, |(_, station)| station),
            guessed: draft.source == 0,
        }
    };
    map.draft().entrances.iter().map(entrance).collect()
}

pub(super) fn stops(map: &StreetMap) -> Vec<Stop> {
    let stop = |draft: &crate::StopDraft| {
        let at = Point::from(draft.at);
        let users = match draft.kind {
            StopKind::Bus => Users::BUS,
            StopKind::Tram => Users::TRAM,
            StopKind::Train => Users::TRAIN,
        };
        let lane = map.lane_near(&at, users, STOP);
        Stop { kind: draft.kind, name: draft.name.clone(), at, lane, walk: map.pavement_near(&at, 2.0 * STOP) }
    };
    map.draft().stops.iter().map(stop).collect()
}

impl StreetMap {
    /// The pavement, path or shared street that is nearest to a point, within a distance in metres, with the station there.
    pub fn pavement_near(&self, point: &Point, within: f64) -> Option<(crate::WalkEdgeId, f64)> {
        self.walk_edge_near(point, within, |edge| matches!(edge.kind, WalkKind::Lane(_) | WalkKind::Shared(_)))
    }

    /// The doors of a building.
    pub fn entrances_of(&self, building: crate::BuildingId) -> Vec<crate::EntranceId> {
        let own = |(_, entrance): &(usize, &Entrance)| entrance.building == building;
        self.entrances().iter().enumerate().filter(own).map(|(index, _)| crate::EntranceId::of(index)).collect()
    }
}
