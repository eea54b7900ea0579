//! Signs at the ends of lanes, and stop lines: before crossings, at lights and at signs.

use crate::parts::{Junction, Lane, Road, RoadCrossing};
use crate::{Control, MapDraft, Polyline, Users};

/// Vehicles stop this far before a crossing, and before the junction itself where there is none, metres.
const BEFORE_CROSSING: f64 = 1.5;
const BEFORE_JUNCTION: f64 = 1.0;

/// Fills in the signs at the ends of lanes. The stricter of two holds.
pub(super) fn signs(draft: &MapDraft, roads: &[Road], lanes: &mut [Lane]) {
    for sign in &draft.signs {
        let road = &roads[sign.road.index()];
        for id in &road.lanes {
            let lane = &mut lanes[id.index()];
            let end = if lane.forward { road.draft.to } else { road.draft.from };
            if end == sign.at && lane.users.any(Users::TRAFFIC) {
                lane.sign = lane.sign.max(Some(sign.kind));
            }
        }
    }
}

/// Fills in the stop lines of the lanes that end at junctions.
pub(super) fn stop_lines(junctions: &[Junction], crossings: &[RoadCrossing], roads: &[Road], lanes: &mut [Lane]) {
    for junction in junctions {
        let lit = junction.draft.control == Control::Signals;
        for arm in &junction.arms {
            let own = junction.crossings.iter().map(|id| &crossings[id.index()]);
            let own: Vec<&RoadCrossing> = own.filter(|crossing| crossing.roads.contains(&arm.road)).collect();
            for id in &roads[arm.road.index()].lanes {
                let lane = &mut lanes[id.index()];
                if lane.forward != arm.start && lane.users.any(Users::TRAFFIC) {
                    lane.stop_line = stop_line(lane, &own, lit);
                }
            }
        }
    }
}

fn stop_line(lane: &Lane, crossings: &[&RoadCrossing], lit: bool) -> Option<f64> {
    let before = |c: &&RoadCrossing| meeting(&lane.line, &c.line) - c.width / 2.0 - BEFORE_CROSSING;
    let at = crossings.iter().map(before).reduce(f64::min);
    let waits = lit || lane.sign.is_some();
    let at = at.or(waits.then(|| lane.line.length() - BEFORE_JUNCTION));
    at.map(|station| station.max(0.0))
}

/// The station of a line at which another comes nearest to its end: where they meet, if they do.
fn meeting(line: &Polyline, other: &Polyline) -> f64 {
    // Each step halves the way to the meeting point at least, unless the lines are nearly parallel.
    (0..8).fold(line.length(), |station, _| line.project(&other.project(&line.at(station)).point).station)
}
