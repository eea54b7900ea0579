//! Right of way at junctions without lights.

use crate::parts::{Junction, Lane, Movement, Road, Turn};
use crate::{DrivingSide, MapDraft};

/// Fills in to whom each movement gives way: who conflicts and comes along a roundabout, from rails or a road of a higher
/// class, or straight on while one turns; among equals, whoever comes from the right.
pub(super) fn yields(
    draft: &MapDraft,
    junctions: &[Junction],
    roads: &[Road],
    lanes: &[Lane],
    movements: &mut [Movement],
) {
    for junction in junctions {
        for (position, id) in junction.movements.iter().enumerate() {
            let goes_first = |other: &usize| {
                let theirs = &movements[junction.movements[*other].index()];
                junction.conflicts.has(position, *other) && first(draft, roads, lanes, theirs, &movements[id.index()])
            };
            let to = (0..junction.movements.len()).filter(goes_first).filter_map(|other| u16::try_from(other).ok());
            let to: Vec<u16> = to.collect();
            movements[id.index()].yields = to;
        }
    }
}

/// Whether the first of two movements goes before the second. Exactly one of two does.
fn first(draft: &MapDraft, roads: &[Road], lanes: &[Lane], one: &Movement, other: &Movement) -> bool {
    let key = |movement: &Movement| {
        let road = &roads[lanes[movement.from.index()].road.index()].draft;
        let rank = if road.class.is_rail() { u8::MAX } else { road.class.rank() };
        (road.roundabout, rank, precedence(movement.turn, draft.side))
    };
    if key(one) != key(other) {
        return key(one) > key(other);
    }
    let (mine, theirs) = (arriving(one), arriving(other));
    let from_right = theirs.perp(&mine);
    if from_right.abs() < 0.3 { one.from < other.from } else { from_right > 0.0 }
}

/// Straight on before a turn on one's own side, before a turn over the other side.
pub(super) fn precedence(turn: Turn, side: DrivingSide) -> u8 {
    let near = if side == DrivingSide::Right { Turn::Right } else { Turn::Left };
    match turn {
        Turn::Through => 3,
        turn if turn == near => 2,
        Turn::Back => 0,
        _ => 1,
    }
}

fn arriving(movement: &Movement) -> nalgebra::Vector2<f64> {
    movement.line.direction(0.0)
}
