//! The stretches of a room's walls along which a fitted kitchen can run, and chains of them around corners.

use super::Furnisher;
use super::kitchen_plan::{CORNER, DEPTH, STEP, TOP};
use super::place::Need;
use super::space::{OFF_WALL, Side};

/// A free stretch of a wall; whether each of its ends is that of the wall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stretch {
    side: usize,
    from: f32,
    to: f32,
    walled: [bool; 2],
}

/// A stretch in the direction of a run.
#[derive(Debug, Clone, Copy)]
pub(super) struct Leg {
    pub(super) side: usize,
    /// Its first and last point along the wall.
    pub(super) start: f32,
    pub(super) end: f32,
    /// Whether it begins and ends in a corner of the run.
    pub(super) corner: [bool; 2],
    /// Whether it begins and ends at a wall.
    pub(super) walled: [bool; 2],
}

impl Leg {
    pub(super) fn length(&self) -> f32 {
        (self.end - self.start).abs()
    }

    /// The stretch of wall between two distances from its beginning.
    pub(super) fn between(&self, from: f32, to: f32) -> (f32, f32) {
        if self.end > self.start { (self.start + from, self.start + to) } else { (self.start - to, self.start - from) }
    }
}

/// The stretches of walls before which units can stand.
pub(super) fn stretches(s: &Furnisher<'_>) -> Vec<Stretch> {
    let mut all = Vec::new();
    for (side, wall) in s.space.sides.iter().enumerate() {
        let (low, high) = (wall.from + OFF_WALL, wall.to - OFF_WALL);
        let count = ((high - low) / STEP).floor().max(0.0) as usize;
        let mut begun: Option<f32> = None;
        for step in 0..=count {
            let at = low + STEP * step as f32;
            let free = step < count && is_free(s, wall, at, at + STEP);
            match (begun, free) {
                (None, true) => begun = Some(at),
                (Some(from), false) => {
                    begun = None;
                    let last = step == count;
                    let to = if last { high } else { at };
                    all.push(Stretch { side, from, to, walled: [from < low + STEP / 2.0, last] });
                }
                _ => {}
            }
        }
    }
    all
}

fn is_free(s: &Furnisher<'_>, wall: &Side, from: f32, to: f32) -> bool {
    let area = wall.facing.area(wall.point(f32::midpoint(from, to), OFF_WALL), DEPTH, to - from);
    let low = wall.sill(from, to).is_some_and(|sill| TOP > sill - 0.02);
    !low && !wall.has_way(from, to) && s.fits(area, 0.0, TOP, wall.facing, Need::default())
}

/// Single stretches, pairs that meet in a corner, and three in a row, in both directions.
pub(super) fn chains(s: &Furnisher<'_>, free: &[Stretch]) -> Vec<Vec<Leg>> {
    let mut all: Vec<Vec<Leg>> = Vec::new();
    for a in free {
        for turned in [false, true] {
            let first = leg(a, turned);
            all.push(vec![first]);
            let Some((b, second)) = next(s, free, a, first) else { continue };
            all.push(joined(&[first, second]));
            if let Some((_, third)) = next(s, free, b, second).filter(|(c, _)| *c != a) {
                all.push(joined(&[first, second, third]));
            }
        }
    }
    all
}

fn leg(stretch: &Stretch, turned: bool) -> Leg {
    let Stretch { side, from, to, walled } = *stretch;
    match turned {
        false => Leg { side, start: from, end: to, corner: [false; 2], walled },
        true => Leg { side, start: to, end: from, corner: [false; 2], walled: [walled[1], walled[0]] },
    }
}

/// The stretch around the corner in which a leg ends.
fn next<'s>(s: &Furnisher<'_>, free: &'s [Stretch], own: &Stretch, leg: Leg) -> Option<(&'s Stretch, Leg)> {
    let corner_of = |stretch: &Stretch, at: f32| {
        let wall = &s.space.sides[stretch.side];
        (wall.facing, wall.facing.area(wall.point(at, OFF_WALL), DEPTH, 2.0 * DEPTH))
    };
    let (facing, here) = corner_of(own, leg.end);
    if !leg.walled[1] {
        return None;
    }
    free.iter().filter(|other| other.side != own.side).find_map(|other| {
        [false, true].into_iter().find_map(|turned| {
            let begun = self::leg(other, turned);
            let (across, there) = corner_of(other, begun.start);
            let close = near(s, own.side, leg.end, other.side, begun.start);
            let meets = close && across.is_along_x() != facing.is_along_x() && here.overlaps(&there);
            (begun.walled[0] && meets).then_some((other, begun))
        })
    })
}

/// Whether two ends of walls are the same corner of the room.
fn near(s: &Furnisher<'_>, a: usize, at_a: f32, b: usize, at_b: f32) -> bool {
    let (p, q) = (s.space.sides[a].point(at_a, OFF_WALL), s.space.sides[b].point(at_b, OFF_WALL));
    (p.0 - q.0).abs() < 0.03 && (p.1 - q.1).abs() < 0.03
}

/// Legs with the corners between them: each but the first begins at the front of the one before.
fn joined(legs: &[Leg]) -> Vec<Leg> {
    let last = legs.len() - 1;
    let join = |(i, leg): (usize, &Leg)| {
        let corner = [i > 0, i < last];
        let (start, _) = if corner[0] { leg.between(DEPTH, DEPTH) } else { (leg.start, 0.0) };
        Leg { start, corner, ..*leg }
    };
    legs.iter().enumerate().map(join).collect()
}

/// A chain no longer than wished, shortened at either end; as it is if it is short enough.
pub(super) fn shortened(chain: &[Leg], longest: f32) -> Vec<Vec<Leg>> {
    let spare = chain.iter().map(Leg::length).sum::<f32>() - longest;
    if spare < STEP {
        return vec![chain.to_vec()];
    }
    let cut = |at: usize, end: bool| {
        let mut legs = chain.to_vec();
        let leg = &mut legs[at];
        let spare = spare.min(leg.length() - CORNER).max(0.0);
        if end {
            (leg.end, _) = if leg.end > leg.start { (leg.end - spare, 0.0) } else { (leg.end + spare, 0.0) };
        } else {
            (leg.start, _) = if leg.end > leg.start { (leg.start + spare, 0.0) } else { (leg.start - spare, 0.0) };
        }
        leg.walled[usize::from(end)] = false;
        legs
    };
    vec![cut(0, false), cut(chain.len() - 1, true)]
}
