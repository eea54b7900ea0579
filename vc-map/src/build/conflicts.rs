//! The conflict tables of junctions.

use super::budget::Budget;
use crate::parts::{Junction, Lane, Movement, RoadCrossing};
use crate::signal::ConflictTable;
use crate::{JunctionId, MapError, Point, Polyline};

/// Movements whose middles come nearer than this conflict, as a part of half their widths.
const NEAR: f64 = 0.75;
/// Crossings lie along the lanes within this of the junction, metres.
const BESIDE: f64 = 15.0;
/// The width that a bicycle takes of a lane, and what others take at least and at most, metres.
const BICYCLE: f64 = 1.2;
const VEHICLE: [f64; 2] = [2.2, 3.5];

/// The width that somebody on a movement takes, metres.
fn width(movement: &Movement, lanes: &[Lane]) -> f64 {
    let [least, most] = VEHICLE;
    let bicycles = movement.users.without(crate::Users::BICYCLE).is_empty();
    if bicycles { BICYCLE } else { lanes[movement.from.index()].width.clamp(least, most) }
}

pub(super) fn tables(
    junctions: &mut [Junction],
    movements: &[Movement],
    crossings: &[RoadCrossing],
    lanes: &[Lane],
    budget: &mut Budget,
) -> Result<(), MapError> {
    for (index, junction) in junctions.iter_mut().enumerate() {
        let own: Vec<Way> = junction.movements.iter().map(|id| Way::of(&movements[id.index()], lanes)).collect();
        let mut table = ConflictTable::new(own.len() + junction.crossings.len());
        budget.take_bytes(JunctionId::of(index), table.bytes())?;
        for (one, a) in own.iter().enumerate() {
            for (other, _) in own.iter().enumerate().skip(one + 1).filter(|(_, b)| conflict(a, b)) {
                table.set(one, other);
            }
            for (position, id) in junction.crossings.iter().enumerate() {
                if over(a.movement, &crossings[id.index()], lanes) {
                    table.set(one, own.len() + position);
                }
            }
        }
        junction.conflicts = table;
    }
    Ok(())
}

/// A movement with its width and the box around its line.
struct Way<'a> {
    movement: &'a Movement,
    width: f64,
    bounds: [Point; 2],
}

impl<'a> Way<'a> {
    fn of(movement: &'a Movement, lanes: &[Lane]) -> Self {
        Self { movement, width: width(movement, lanes), bounds: movement.line.bounds() }
    }
}

/// Whether two movements are in each other's way. Those that part from one lane follow each other.
fn conflict(a: &Way<'_>, b: &Way<'_>) -> bool {
    let (one, other) = (a.movement, b.movement);
    let clear = NEAR * (a.width + b.width) / 2.0;
    // Most are far from each other, which their boxes show.
    let gap = (a.bounds[0] - b.bounds[1]).sup(&(b.bounds[0] - a.bounds[1]));
    let near = || gap.x < clear && gap.y < clear && one.line.distance(&other.line) < clear;
    one.from != other.from && (one.to == other.to || near())
}

/// Whether a movement leads over a crossing: from or to a road that it crosses, or across its line, be it with its lanes
/// just before or behind the junction.
pub(super) fn over(movement: &Movement, crossing: &RoadCrossing, lanes: &[Lane]) -> bool {
    let [from, to] = [movement.from, movement.to].map(|lane| &lanes[lane.index()]);
    let near = |line: &Polyline, [start, end]: [f64; 2]| {
        line.part(start, end).is_some_and(|part| part.crosses(&crossing.line))
    };
    let length = from.line.length();
    [from, to].iter().any(|lane| crossing.roads.contains(&lane.road))
        || movement.line.crosses(&crossing.line)
        || near(&from.line, [length - BESIDE, length])
        || near(&to.line, [0.0, BESIDE])
}
