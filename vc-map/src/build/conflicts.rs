//! The conflict tables of junctions.

use crate::parts::{Junction, Lane, Movement, RoadCrossing};
use crate::signal::ConflictTable;

/// Movements whose middles come nearer than this conflict, as a part of half their widths.
pub(crate) const NEAR: f64 = 0.75;
/// The width that a bicycle takes of a lane, metres.
const BICYCLE: f64 = 1.2;

/// The width that somebody on a movement takes, metres.
pub(crate) fn width(movement: &Movement, lanes: &[Lane]) -> f64 {
    let lane = &lanes[movement.from.index()];
    if movement.users.without(crate::Users::BICYCLE).is_empty() { BICYCLE } else { lane.width.clamp(BICYCLE, 3.5) }
}

pub(super) fn tables(junctions: &mut [Junction], movements: &[Movement], crossings: &[RoadCrossing], lanes: &[Lane]) {
    for junction in junctions {
        let own: Vec<&Movement> = junction.movements.iter().map(|id| &movements[id.index()]).collect();
        let mut table = ConflictTable::new(own.len() + junction.crossings.len());
        for (one, a) in own.iter().enumerate() {
            for (other, b) in own.iter().enumerate().skip(one + 1) {
                if conflict(a, b, lanes) {
                    table.set(one, other);
                }
            }
            for (position, id) in junction.crossings.iter().enumerate() {
                if over(a, &crossings[id.index()], lanes) {
                    table.set(one, own.len() + position);
                }
            }
        }
        junction.conflicts = table;
    }
}

/// Whether two movements are in each other's way. Those that part from one lane follow each other.
fn conflict(a: &Movement, b: &Movement, lanes: &[Lane]) -> bool {
    let clear = NEAR * (width(a, lanes) + width(b, lanes)) / 2.0;
    a.from != b.from && (a.to == b.to || a.line.distance(&b.line) < clear)
}

/// Whether a movement leads over a crossing.
pub(crate) fn over(movement: &Movement, crossing: &RoadCrossing, lanes: &[Lane]) -> bool {
    [movement.from, movement.to].iter().any(|lane| crossing.roads.contains(&lanes[lane.index()].road))
}
