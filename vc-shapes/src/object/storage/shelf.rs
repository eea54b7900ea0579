//! Bookcases and shelves.

use super::case::{Case, Cell, Column, Piece, Stand};
use crate::material::*;
use crate::object::joinery::{BOARD, Front, Handle};
use crate::object::table::frame::Four;
use crate::solid::{Axis, Build, CORNERS, Cut, P, at_least, leg};

/// The number of compartments of a usual height.
fn spaces(b: &mut Build<'_>, tall: f32) -> usize {
    (tall / b.vary(0.28, 0.36)).round().clamp(1.0, 8.0) as usize
}

/// The material of a bookcase.
fn body(b: &mut Build<'_>) -> MaterialId {
    b.choose(&[b.style.wood, b.style.wood, b.style.cabinet, WHITE])
}

/// A bookcase: a plain case, one with a cornice, one with unequal columns, a ladder or an open
/// metal frame.
pub(super) fn bookshelf(b: &mut Build<'_>) {
    at_least(b, [0.12, 0.3, 0.4]);
    match b.rng.below(8) {
        0 => etagere(b),
        1 => ladder(b),
        2 => {
            // Columns of unequal compartments.
            let count = spaces(b, b.size.z);
            let few = count.saturating_sub(1).max(1);
            let (foot, wide) = (foot(b), b.vary(0.8, 1.2));
            let columns = vec![(wide, stack(foot, count)), (1.0, stack(foot, few))];
            let mat = body(b);
            let mut piece = Piece::new(columns, mat);
            piece.handle = grip(b);
            piece.build(b);
        }
        design => {
            let columns = if b.size.y > 0.95 { 2 } else { 1 };
            let count = spaces(b, b.size.z);
            let mat = body(b);
            let foot = foot(b);
            let mut piece = Piece::new(vec![(1.0, stack(foot, count)); columns], mat);
            piece.handle = grip(b);
            piece.stand = b.choose(&[Stand::Plinth, Stand::Plinth, Stand::None, Stand::Legs, Stand::Splayed]);
            if design < 5 {
                piece.overhang = b.vary(0.012, 0.02);
            }
            piece.build(b);
        }
    }
}

/// The closed part at the foot of a bookcase, and its height relative to a compartment.
fn foot(b: &mut Build<'_>) -> (f32, Cell) {
    let look = b.choose(&[Front::Flat, Front::Framed, Front::Framed]);
    b.choose(&[(0.6, Cell::Drawers(1)), (1.0, Cell::Drawers(2)), (1.1, Cell::Doors(look, 1))])
}

/// Open compartments over a foot, `count` in total.
fn stack(foot: (f32, Cell), count: usize) -> Vec<(f32, Cell)> {
    let open = count.saturating_sub(1).max(1);
    vec![foot, (open as f32, Cell::Open(open))]
}

fn grip(b: &mut Build<'_>) -> Handle {
    b.choose(&[Handle::Knob, Handle::Bar, Handle::None])
}

/// Two drawers that fill a space between shelves.
fn drawers(b: &mut Build<'_>, low: P, high: P, mat: MaterialId) {
    let columns = vec![(1.0, vec![(1.0, Cell::Drawers(2))])];
    let metal = b.style.metal;
    Case { low, high, columns, handle: Handle::None, body: mat, front: mat, lid: mat, metal }.build(b);
}

/// A bookcase as high as a table or a little more.
pub(super) fn low_bookcase(b: &mut Build<'_>) {
    at_least(b, [0.125, 0.3, 0.3]);
    let columns = (b.size.y / b.vary(0.45, 0.75)).round().clamp(1.0, 3.0) as usize;
    let (count, mat) = (spaces(b, b.size.z - 0.08), body(b));
    let mut piece = Piece::new(vec![(1.0, vec![(1.0, Cell::Open(count))]); columns], mat);
    piece.stand = b.choose(&[Stand::Plinth, Stand::Legs, Stand::Splayed, Stand::None, Stand::Tube]);
    piece.overhang = b.choose(&[0.0, 0.015]);
    if b.rng.chance(0.3) {
        piece.lid = b.style.wood;
    }
    piece.build(b);
}

/// Cubes in rows and columns; some hold a drawer.
pub(super) fn cube_shelf(b: &mut Build<'_>) {
    at_least(b, [0.15, 0.3, 0.3]);
    let across = (b.size.y / 0.38).round().clamp(1.0, 6.0) as usize;
    let up = (b.size.z / 0.38).round().clamp(1.0, 6.0) as usize;
    let filled = b.choose(&[0.0, 0.0, 0.2]);
    let columns: Vec<Column> = (0..across)
        .map(|_| {
            let cell = |b: &mut Build<'_>| if b.rng.chance(filled) { Cell::Drawers(1) } else { Cell::Open(1) };
            (1.0, (0..up).map(|_| (1.0, cell(b))).collect())
        })
        .collect();
    let mat = b.choose(&[WHITE, b.style.wood, b.style.cabinet, BLACK]);
    let mut piece = Piece::new(columns, mat);
    (piece.stand, piece.front) = (Stand::None, b.choose(&[mat, b.style.accent, b.style.wood]));
    piece.build(b);
}

/// Quarter-round shelves in a corner, between two walls of board or on poles. The corner is at the
/// back right.
pub(super) fn corner_bookcase(b: &mut Build<'_>) {
    at_least(b, [0.14, 0.14, 0.4]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = body(b);
    let t = BOARD;
    b.block("side", [-x, -y, 0.0], [-x + t, y, h], mat);
    b.block("side", [-x + t, -y, 0.0], [x, -y + t, h], mat);
    let count = spaces(b, h);
    let pitch = (h - t - 0.05) / count as f32;
    let (wx, wy) = (2.0 * x - t - 0.003, 2.0 * y - t - 0.003);
    let round = b.rng.chance(0.6);
    let quarter: &[(f32, f32)] = if round {
        &[
            (0.0, 0.0),
            (1.0, 0.0),
            (0.974, 0.225),
            (0.866, 0.5),
            (0.707, 0.707),
            (0.5, 0.866),
            (0.225, 0.974),
            (0.0, 1.0),
        ]
    } else {
        &[(0.0, 0.0), (1.0, 0.0), (1.0, 0.35), (0.35, 1.0), (0.0, 1.0)]
    };
    let outline: Vec<(f32, f32)> = quarter.iter().map(|p| (p.0 * wx, p.1 * wy)).collect();
    for i in 0..=count {
        let z = 0.05 + pitch * i as f32;
        b.prism("shelf", Axis::Z, [t - x, t - y, z], &outline, t - 0.001, mat);
        // The square that fits inside the rounded shelf.
        let free = (wx * 0.34, wy * 0.34);
        let centre = [t - x + free.0 + 0.005, t - y + free.1 + 0.005, z + t - 0.001];
        if i == count {
            b.top("top", centre, (free.0 - 0.004, free.1 - 0.004));
        } else {
            b.inside(&format!("shelf_{}", i + 1), centre, (free.0 - 0.004, free.1 - 0.004), pitch - t - 0.005);
        }
    }
}

/// Boards between two ladders of metal tube, open on all sides.
fn etagere(b: &mut Build<'_>) {
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (metal, wood) = (b.choose(&[b.style.metal, BLACK_METAL, BRASS]), b.style.wood);
    let t = 0.02_f32.min(x * 0.15);
    Four::upright((x, y), h, (t / 2.0, t / 2.0), Cut::Square).build(b, metal);
    for side in [-1.0_f32, 1.0] {
        let (a, c) = (side * y, side * (y - t));
        for z in [0.06, h - t] {
            b.block("tube", [t - x, a.min(c), z], [x - t, a.max(c), z + t - 0.001], metal);
        }
    }
    boards(b, (x - 0.002, y - t - 0.001), (0.08, h - 0.045), wood, (t * 1.5, 0.01));
    b.rod("brace", [t / 2.0 - x, t - y, 0.1], [t / 2.0 - x, y - t, h - 0.1], 0.004, metal);
    b.rod("brace", [t / 2.0 - x + 0.006, y - t, 0.1], [t / 2.0 - x + 0.006, t - y, h - 0.1], 0.004, metal);
}

/// Shelves from one height to another, the uppermost open above; `keep` is the part of them that
/// posts occupy.
fn boards(b: &mut Build<'_>, half: (f32, f32), z: (f32, f32), mat: MaterialId, keep: (f32, f32)) {
    let count = spaces(b, z.1 - z.0).max(2);
    let pitch = (z.1 - z.0) / count as f32;
    let thick = 0.022;
    let holds = b.class != "shelf";
    for i in 0..=count {
        let top = z.0 + pitch * i as f32 + thick;
        b.block("shelf", [-half.0, -half.1, top - thick], [half.0, half.1, top], mat);
        let (centre, free) = ([0.0, 0.0, top], ((half.0 - keep.0).max(0.01), half.1 - keep.1));
        if i == count {
            b.top("top", centre, free);
        } else if i == 0 && b.class == "bookshelf" {
            let side = half.1 - keep.1;
            drawers(b, [-half.0 + 0.02, -side, top - 0.002], [half.0, side, top + pitch - thick + 0.002], mat);
        } else if holds {
            b.inside(&format!("shelf_{}", i + 1), centre, free, pitch - thick - 0.005);
        } else {
            b.ledge(&format!("shelf_{}", i + 1), centre, free, pitch - thick - 0.005);
        }
    }
}

/// A leaning ladder with shelves that deepen downwards.
fn ladder(b: &mut Build<'_>) {
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let wood = b.choose(&[b.style.wood, b.style.cabinet]);
    let (t, r) = (0.024, 0.016_f32.min(x * 0.1));
    let front = |z: f32| x - r - (2.0 * x - 0.14).max(x * 0.3) * (z / h);
    for side in [-1.0, 1.0] {
        let cy = side * (y - r);
        leg(b, "rail", ([front(0.0), cy, 0.0], r), ([front(h), cy, h], r), Cut::Square, wood);
        leg(b, "post", ([r - x, cy, 0.0], r), ([r - x, cy, h * 0.98], r), Cut::Square, wood);
    }
    let count = spaces(b, h).clamp(3, 6);
    let pitch = (h - 0.16) / (count as f32 - 0.45);
    let holds = b.class != "shelf";
    for i in 0..count {
        let z = 0.14 + pitch * i as f32;
        let end = front(z) + r;
        b.block("shelf", [-x + 0.001, 2.0 * r - y - 0.002, z - t], [end - 0.003, y - 2.0 * r + 0.002, z], wood);
        b.block("lip", [-x + 0.002, 2.0 * r - y, z - 0.002], [-x + 0.014, y - 2.0 * r, z + 0.04], wood);
        // Between the uprights, which lean over the shelf.
        let (from, to) = (-x + 0.02, end - 0.008);
        let (centre, free) = ([f32::midpoint(from, to), 0.0, z], ((to - from) / 2.0, y - 2.0 * r - 0.006));
        let clear = pitch - t - 0.01;
        if i == 0 && b.class == "bookshelf" {
            let (side, end) = (y - 2.0 * r - 0.003, front(z + clear) + r - 0.004);
            drawers(b, [from, -side, z - 0.002], [end, side, z + clear + 0.012], wood);
            continue;
        }
        match (i + 1 == count, holds) {
            (true, _) => b.top("top", centre, free),
            (false, true) => b.inside(&format!("shelf_{}", i + 1), centre, free, clear),
            (false, false) => b.ledge(&format!("shelf_{}", i + 1), centre, free, clear),
        }
    }
}

/// Shelves without closed sides or back: posts and boards, a frame, a ladder.
pub(super) fn open_shelf(b: &mut Build<'_>) {
    at_least(b, [0.1, 0.3, 0.35]);
    match b.rng.below(3) {
        0 => etagere(b),
        1 => ladder(b),
        _ => {
            let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
            let wood = body(b);
            let r = 0.016_f32.min(x * 0.12);
            let cut = b.choose(&[Cut::Round, Cut::Square]);
            for (sx, sy) in CORNERS {
                let at = |z: f32| [sx * (x - r - 0.004), sy * (y - r - 0.004), z];
                leg(b, "post", (at(0.0), r), (at(h - 0.01), r), cut, wood);
            }
            // Objects stand between the posts.
            boards(b, (x, y), (0.08, h - 0.022), wood, (0.005, 2.0 * r + 0.01));
        }
    }
}

/// A board on a wall: floating, on brackets, boxed, or in two tiers.
pub(super) fn wall_shelf(b: &mut Build<'_>) {
    at_least(b, [0.07, 0.2, 0.015]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, metal) = (body(b), b.style.metal);
    let t = h.min(0.035);
    if h < 0.08 {
        b.rounded_block("shelf", [-x, -y, h - t], [x, y, h], 0.004, mat);
        b.top("top", [0.0, 0.0, h], (x - 0.006, y - 0.01));
        if h > t + 0.01 {
            b.block("cleat", [-x, -y * 0.9, 0.0], [-x + 0.02, y * 0.9, h - t + 0.001], mat);
        }
        return;
    }
    let t = 0.022;
    match b.rng.below(3) {
        0 => {
            // On triangular brackets.
            b.rounded_block("shelf", [-x, -y, h - t], [x, y, h], 0.004, mat);
            b.top("top", [0.0, 0.0, h], (x - 0.006, y - 0.01));
            for side in [-1.0, 1.0] {
                let cy = side * y * 0.7;
                b.block("bracket", [-x, cy - 0.011, 0.0], [-x + 0.006, cy + 0.011, h - t], metal);
                b.block(
                    "bracket",
                    [-x + 0.005, cy - 0.012, h - t - 0.006],
                    [x * 0.8, cy + 0.012, h - t - 0.001],
                    metal,
                );
                b.rod("stay", [-x + 0.008, cy, 0.015], [x * 0.7, cy, h - t - 0.008], 0.005, metal);
            }
        }
        1 => {
            // A box open in front.
            b.block("side", [-x, -y, 0.0], [x, -y + t, h], mat);
            b.block("side", [-x, y - t, 0.0], [x, y, h], mat);
            b.block("shelf", [-x, t - y, 0.0], [x - 0.001, y - t, t], mat);
            b.block("top", [-x, t - y, h - t], [x - 0.001, y - t, h - 0.001], mat);
            b.ledge("shelf_1", [0.0, 0.0, t], (x - 0.008, y - t - 0.008), h - 2.0 * t - 0.005);
            b.top("top", [0.0, 0.0, h], (x - 0.008, y - t - 0.008));
        }
        _ => {
            // Two tiers between loops of metal.
            for side in [-1.0, 1.0] {
                let cy = side * (y * 0.86);
                b.block("strip", [-x, cy - 0.01, 0.0], [-x + 0.005, cy + 0.01, h - 0.01], metal);
                b.block("strip", [x - 0.005, cy - 0.01, 0.0], [x, cy + 0.01, h - 0.01], metal);
                b.block("strip", [-x + 0.004, cy - 0.009, 0.001], [x - 0.004, cy + 0.009, 0.006], metal);
            }
            for (z, name) in [(0.004, "shelf_1"), (h - t, "top")] {
                let inset = if name == "top" { 0.0 } else { 0.006 };
                b.block("shelf", [-x + inset, -y, z], [x - inset, y, z + t], mat);
                let (centre, free) = ([0.0, 0.0, z + t], (x - 0.012, y * 0.84 - 0.01));
                if inset > 0.0 {
                    b.ledge(name, centre, free, h - 2.0 * t - 0.01);
                } else {
                    b.top(name, centre, (x - 0.008, y - 0.01));
                }
            }
        }
    }
}
