//! Irregular plans: rooms are grown on a coarse grid from the outer walls inwards; the remaining
//! area is the living room, which every room opens to.
//!
//! After Lopes, Tutenel, Smelik, de Kraker and Bidarra, "A constrained growth method
//! for procedural floor plan generation" (2010), with rejection instead of repair.

use vc_geometry::grid::BitGrid;
use vc_graph::Stream;

use super::programme::Programme;
use super::{Arrangement, Rect, Room, RoomKind};

/// The side of a grid square, cells.
const SQUARE: i32 = 6;
/// The width of a comfortable passage, in squares.
const PASSAGE: usize = 4;

/// Grows the rooms; `None` after several hundred failed attempts.
pub(super) fn lay_out(programme: &Programme, rng: &mut Stream) -> Option<Arrangement> {
    if programme.wishes.len() > 9 {
        return None;
    }
    (0..300).find_map(|_| attempt(programme, rng))
}

/// The owner of a square without a room.
const FREE: u8 = u8::MAX;

/// The grid with the room that owns each square.
struct Grid {
    width: usize,
    depth: usize,
    owner: Vec<u8>,
}

/// A rectangle of squares, without its far edges.
#[derive(Clone, Copy)]
struct Patch {
    x0: usize,
    y0: usize,
    x1: usize,
    y1: usize,
}

impl Patch {
    fn area(self) -> usize {
        (self.x1 - self.x0) * (self.y1 - self.y0)
    }

    fn squares(self) -> impl Iterator<Item = (usize, usize)> {
        (self.y0..self.y1).flat_map(move |y| (self.x0..self.x1).map(move |x| (x, y)))
    }
}

fn attempt(programme: &Programme, rng: &mut Stream) -> Option<Arrangement> {
    let squares = |index: usize| {
        let side = programme.wishes[index].area.sqrt() + 0.1;
        (side * side * 400.0 / (SQUARE * SQUARE) as f32).round() as usize
    };
    let total: usize = (0..programme.wishes.len()).map(squares).sum::<usize>() + 20 * programme.wishes.len();
    let depth = ((total as f32).sqrt() * rng.between(0.8, 1.1)) as usize;
    let width = total.div_ceil(depth.max(1));
    let mut grid = Grid { width, depth, owner: vec![FREE; width * depth] };
    let mut order: Vec<usize> = (1..programme.wishes.len()).collect();
    rng.shuffle(&mut order);
    // Rooms with windows first, en-suite bathrooms after their bedroom.
    order.sort_by_key(|&i| match programme.wishes[i].kind {
        RoomKind::Bedroom | RoomKind::Kids => 0,
        RoomKind::Kitchen | RoomKind::Study => 1,
        _ => 2,
    });
    let mut patches = vec![None; programme.wishes.len()];
    for index in order {
        let wish = programme.wishes[index];
        let least = ((wish.kind.least_side() + 2 + SQUARE - 1) / SQUARE).max(4) as usize;
        let by = wish.of.and_then(|b| patches[b]);
        let patch = (0..12).find_map(|_| grid.grow(squares(index), least, wish.kind, by, rng))?;
        patch.squares().for_each(|(x, y)| grid.owner[y * width + x] = index as u8);
        patches[index] = Some(patch);
    }
    grid.is_sound(&patches, programme)?;
    let mut rooms: Vec<Room> =
        programme.wishes.iter().map(|w| Room { kind: w.kind, rects: Vec::new(), of: w.of }).collect();
    for (room, patch) in rooms.iter_mut().zip(&patches) {
        room.rects.extend(patch.map(rect));
    }
    rooms[0].rects = grid.rest();
    let living = rooms[0].area();
    let sound = living <= programme.wishes[0].area * 1.7 && rooms.iter().all(|r| r.widest() >= r.kind.least_side());
    sound.then_some(Arrangement { rooms, facades: [false, true, true, true] })
}

impl Grid {
    fn is_free(&self, patch: Patch) -> bool {
        patch.x1 <= self.width
            && patch.y1 <= self.depth
            && (patch.y0..patch.y1).all(|y| self.row(y)[patch.x0..patch.x1].iter().all(|&o| o == FREE))
    }

    fn row(&self, y: usize) -> &[u8] {
        &self.owner[y * self.width..(y + 1) * self.width]
    }

    /// The squares without a room.
    fn free(&self) -> BitGrid {
        let mut free = BitGrid::new(self.width, self.depth);
        for y in 0..self.depth {
            self.row(y).iter().enumerate().filter(|(_, o)| **o == FREE).for_each(|(x, _)| free.set(x, y));
        }
        free
    }

    /// Grows a rectangle from a seed square side by side: from a windowed outer wall for rooms that
    /// need one, from the wall of `by` for its bathroom, else anywhere.
    fn grow(&self, area: usize, least: usize, kind: RoomKind, by: Option<Patch>, rng: &mut Stream) -> Option<Patch> {
        let (x0, y0) = match by {
            Some(b) => match rng.below(4) {
                0 => (b.x0.checked_sub(least)?, rng.count(b.y0, b.y1.saturating_sub(least))),
                1 => (b.x1, rng.count(b.y0, b.y1.saturating_sub(least))),
                2 => (rng.count(b.x0, b.x1.saturating_sub(least)), b.y0.checked_sub(least)?),
                _ => (rng.count(b.x0, b.x1.saturating_sub(least)), b.y1),
            },
            None => {
                let (right, top) = (self.width.checked_sub(least)?, self.depth.checked_sub(least)?);
                match rng.below(3) {
                    0 => (rng.below(right + 1), 0),
                    1 => (rng.below(right + 1), top),
                    _ => (if kind.is_bedroom() { right } else { right * rng.below(2) }, rng.below(top + 1)),
                }
            }
        };
        let mut patch = Patch { x0, y0, x1: x0 + least, y1: y0 + least };
        if !self.is_free(patch) {
            return None;
        }
        let mut sides = [0, 1, 2, 3];
        while patch.area() < area {
            rng.shuffle(&mut sides);
            let free = |&side: &usize| {
                let (grown, strip) = patch.extended(side)?;
                (grown.is_round() && self.is_free(strip)).then_some(grown)
            };
            patch = sides.iter().find_map(free)?;
        }
        Some(patch)
    }

    /// Whether the remaining area is connected and nowhere too narrow, and every room touches it
    /// (an en-suite bathroom touches its bedroom instead).
    fn is_sound(&self, patches: &[Option<Patch>], programme: &Programme) -> Option<()> {
        let reached = patches.iter().enumerate().all(|(index, patch)| {
            let Some(patch) = patch else { return true };
            let owner = programme.wishes[index].of.map_or(FREE, |room| room as u8);
            self.touch(*patch, owner) > PASSAGE
        });
        if !reached {
            return None;
        }
        let free = self.free();
        let passages = free.squares(PASSAGE);
        let (x, y) = passages.first((0, self.width as i32), (0, self.depth as i32))?;
        free.is_within(&passages.flood(x, y).covered(PASSAGE)).then_some(())
    }

    /// The longest stretch of a patch's sides that borders on a room, or on the remaining area.
    fn touch(&self, patch: Patch, other: u8) -> usize {
        let at = |x: usize, y: usize| x < self.width && y < self.depth && self.owner[y * self.width + x] == other;
        let longest = |cells: &mut dyn Iterator<Item = bool>| {
            let mut run = 0;
            cells
                .map(|hit| {
                    run = if hit { run + 1 } else { 0 };
                    run
                })
                .max()
                .unwrap_or(0)
        };
        let rows = [patch.y0.wrapping_sub(1), patch.y1];
        let columns = [patch.x0.wrapping_sub(1), patch.x1];
        let level = rows.map(|y| longest(&mut (patch.x0..patch.x1).map(|x| at(x, y))));
        let upright = columns.map(|x| longest(&mut (patch.y0..patch.y1).map(|y| at(x, y))));
        level.into_iter().chain(upright).max().unwrap_or(0)
    }

    /// Decomposes the remaining area into rectangles by a greedy sweep.
    fn rest(&self) -> Vec<Rect> {
        let mut taken: Vec<bool> = self.owner.iter().map(|o| *o != FREE).collect();
        let mut rects = Vec::new();
        for y in 0..self.depth {
            for x in 0..self.width {
                let free =
                    |x: usize, y: usize, taken: &[bool]| x < self.width && y < self.depth && !taken[y * self.width + x];
                if !free(x, y, &taken) {
                    continue;
                }
                let mut x1 = x;
                while free(x1, y, &taken) {
                    x1 += 1;
                }
                let mut y1 = y;
                while (x..x1).all(|x| free(x, y1, &taken)) {
                    y1 += 1;
                }
                let patch = Patch { x0: x, y0: y, x1, y1 };
                patch.squares().for_each(|(x, y)| taken[y * self.width + x] = true);
                rects.push(rect(patch));
            }
        }
        rects
    }
}

impl Patch {
    /// The patch extended by one square on a side, and the strip added.
    fn extended(self, side: usize) -> Option<(Self, Self)> {
        let Self { x0, y0, x1, y1 } = self;
        Some(match side {
            0 => (Self { x0: x0.checked_sub(1)?, ..self }, Self { x0: x0 - 1, x1: x0, ..self }),
            1 => (Self { x1: x1 + 1, ..self }, Self { x0: x1, x1: x1 + 1, ..self }),
            2 => (Self { y0: y0.checked_sub(1)?, ..self }, Self { y0: y0 - 1, y1: y0, ..self }),
            _ => (Self { y1: y1 + 1, ..self }, Self { y0: y1, y1: y1 + 1, ..self }),
        })
    }

    /// Whether neither side is more than nine fifths of the other.
    fn is_round(self) -> bool {
        let (w, d) = (self.x1 - self.x0, self.y1 - self.y0);
        5 * w.max(d) <= 9 * w.min(d)
    }
}

fn rect(patch: Patch) -> Rect {
    let cell = |v: usize| v as i32 * SQUARE;
    Rect { x0: cell(patch.x0), y0: cell(patch.y0), x1: cell(patch.x1), y1: cell(patch.y1) }
}
