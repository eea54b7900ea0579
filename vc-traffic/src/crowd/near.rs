//! Neighbours: a uniform grid, as a list in the order of its cells.

use nalgebra::{Point2, Vector2};

use super::RADIUS;
use crate::network::NONE;

/// People see each other this far, metres: the side of a cell.
pub(super) const SIGHT: f32 = 4.0;
/// Somebody heeds at most so many others, the nearest.
pub(super) const MOST: usize = 16;

/// Somebody as others see them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Seen {
    cell: (i32, i32),
    pub(super) id: u32,
    pub(super) slot: u32,
    pub(super) at: Point2<f32>,
    pub(super) velocity: Vector2<f32>,
    pub(super) radius: f32,
}

impl Seen {
    pub(super) fn new(id: u32, slot: u32, at: Point2<f32>, velocity: Vector2<f32>) -> Self {
        // Rows come first, so that cells side by side follow each other.
        Self {
            cell: ((at.y / SIGHT).floor() as i32, (at.x / SIGHT).floor() as i32),
            id,
            slot,
            at,
            velocity,
            radius: RADIUS,
        }
    }

    /// A disc that stands: its number, place and radius.
    pub(super) fn disc(number: u32, at: Point2<f32>, radius: f32) -> Self {
        Self { radius, ..Self::new(u32::MAX - number, NONE, at, Vector2::zeros()) }
    }
}

/// The nearest others, with the squares of their distances; of larger discs as if they were people as near.
#[derive(Clone, Copy)]
pub(super) struct Nearest {
    list: [(f32, u32); MOST],
    count: usize,
}

impl Nearest {
    pub(super) fn new() -> Self {
        Self { list: [(f32::INFINITY, 0); MOST], count: 0 }
    }

    /// Takes another in, if it is among the nearest; of several at one distance the lowest number.
    pub(super) fn add(&mut self, square: f32, place: u32, people: &[Seen]) {
        let id = |place: u32| people[place as usize].id;
        let before = |one: &(f32, u32)| one.0 < square || (one.0 == square && id(one.1) < id(place));
        let mut at = self.count.min(MOST - 1);
        if self.count == MOST && before(&self.list[at]) {
            return;
        }
        while at > 0 && !before(&self.list[at - 1]) {
            self.list[at] = self.list[at - 1];
            at -= 1;
        }
        self.list[at] = (square, place);
        self.count = (self.count + 1).min(MOST);
    }

    pub(super) fn all(&self) -> &[(f32, u32)] {
        &self.list[..self.count]
    }

    pub(super) fn is_full(&self) -> bool {
        self.count == MOST
    }
}

/// Puts people in the order of their cells, and calls for each, by its place in that order, with the three rows of people around it.
pub(super) fn around(people: &mut [Seen], mut each: impl FnMut(&[Seen], usize, [std::ops::Range<usize>; 3])) {
    people.sort_unstable_by_key(|seen| (seen.cell, seen.id));
    let people = &*people;
    let mut rows = [0..0, 0..0, 0..0];
    let mut last = None;
    for place in 0..people.len() {
        let cell = people[place].cell;
        if last != Some(cell) {
            for (row, below) in rows.iter_mut().zip(-1..=1) {
                let y = cell.0.saturating_add(below);
                let (first, beyond) = ((y, cell.1.saturating_sub(1)), (y, cell.1.saturating_add(2)));
                // Cells come in order, so that rows only move on.
                let ahead = |from: usize, to: (i32, i32)| {
                    from + people[from..].iter().position(|seen| seen.cell >= to).unwrap_or(people.len() - from)
                };
                row.start = ahead(row.start, first);
                row.end = ahead(row.start.max(row.end), beyond);
            }
            last = Some(cell);
        }
        each(people, place, rows.clone());
    }
}
