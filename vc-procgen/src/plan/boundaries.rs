//! The boundaries of rooms: every straight piece of wall with the rooms on its two sides.

use super::{Rect, Room};

/// A straight piece of a boundary between two rooms, or a room and the outside.
///
/// ```
/// use vc_graph::Seed;
/// use vc_procgen::Specification;
/// use vc_procgen::plan::FloorPlan;
/// let plan = FloorPlan::generate(&Specification::studio(), Seed(2))?;
/// assert!(plan.boundaries().iter().any(|boundary| boundary.low.is_none() || boundary.high.is_none()), "outer walls");
/// # Ok::<(), vc_procgen::SpecificationError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Boundary {
    /// Whether it runs along Y.
    pub vertical: bool,
    /// The X coordinate if vertical, else Y, cells.
    pub at: i32,
    /// The start along its direction, cells.
    pub from: i32,
    /// The end along its direction, cells.
    pub to: i32,
    /// The room on the side of smaller coordinates, if any.
    pub low: Option<usize>,
    /// The room on the other side.
    pub high: Option<usize>,
}

impl Boundary {
    /// The length, cells.
    pub(crate) fn length(&self) -> i32 {
        self.to - self.from
    }

    /// Whether it separates the two rooms.
    pub(crate) fn joins(&self, a: usize, b: usize) -> bool {
        (self.low, self.high) == (Some(a), Some(b)) || (self.low, self.high) == (Some(b), Some(a))
    }

    /// The room on the other side; `None` for the outside, or if it does not bound the room.
    pub(crate) fn beyond(&self, room: usize) -> Option<usize> {
        match (self.low, self.high) {
            (Some(a), other) | (other, Some(a)) if a == room => other,
            _ => None,
        }
    }

    /// The room, if the outside is on the other side.
    pub(crate) fn inner(&self) -> Option<usize> {
        self.low.xor(self.high)
    }
}

/// All boundaries of rooms that do not overlap, those along X before those along Y, ordered by position.
///
/// Costs the square of the number of distinct coordinates, some microseconds.
pub(crate) fn boundaries(rooms: &[Room]) -> Vec<Boundary> {
    let rects = || rooms.iter().enumerate().flat_map(|(i, r)| r.rects.iter().map(move |rect| (i, *rect)));
    let xs = coordinates(rects().flat_map(|(_, r)| [r.x0, r.x1]));
    let ys = coordinates(rects().flat_map(|(_, r)| [r.y0, r.y1]));
    let (columns, rows) = (xs.len() - 1, ys.len() - 1);
    let mut owner = vec![None; columns * rows];
    for (room, Rect { x0, y0, x1, y1 }) in rects() {
        for row in index(&ys, y0)..index(&ys, y1) {
            owner[row * columns + index(&xs, x0)..row * columns + index(&xs, x1)].fill(Some(room));
        }
    }
    let at = |column: usize, row: usize| {
        // Indices below zero wrap around, and are outside as well.
        if column < columns && row < rows { owner[row * columns + column] } else { None }
    };
    let mut found = Vec::new();
    for (row, &y) in ys.iter().enumerate() {
        let sides = |column: usize| (at(column, row.wrapping_sub(1)), at(column, row));
        runs(&xs, sides, |from, to, (low, high)| found.push(Boundary { vertical: false, at: y, from, to, low, high }));
    }
    for (column, &x) in xs.iter().enumerate() {
        let sides = |row: usize| (at(column.wrapping_sub(1), row), at(column, row));
        runs(&ys, sides, |from, to, (low, high)| found.push(Boundary { vertical: true, at: x, from, to, low, high }));
    }
    found
}

type Sides = (Option<usize>, Option<usize>);

/// Calls `found` with each maximal run of equal pieces whose two sides differ.
fn runs(lines: &[i32], sides: impl Fn(usize) -> Sides, mut found: impl FnMut(i32, i32, Sides)) {
    let mut start = 0;
    for i in 1..lines.len() {
        if i + 1 == lines.len() || sides(i) != sides(start) {
            let (low, high) = sides(start);
            if low != high {
                found(lines[start], lines[i], (low, high));
            }
            start = i;
        }
    }
}

fn coordinates(all: impl Iterator<Item = i32>) -> Vec<i32> {
    let mut all: Vec<i32> = all.collect();
    all.sort_unstable();
    all.dedup();
    if all.is_empty() {
        all.push(0);
    }
    all
}

fn index(of: &[i32], value: i32) -> usize {
    of.partition_point(|&v| v < value)
}
