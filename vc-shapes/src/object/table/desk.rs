//! Desks, and tables with drawers.

use super::frame::Four;
use super::{Base, Outline, Table};
use crate::material::*;
use crate::object::joinery::{BOARD, Front, Handle};
use crate::object::storage::case::{Case, Cell, Column, Piece, Stand, Tally};
use crate::solid::{Build, Cut, P, at_least};

/// Drawers side by side below a top, in a shallow case.
pub(super) fn drawers_below(b: &mut Build<'_>, half: (f32, f32), top: (f32, f32), body: MaterialId) {
    let handle = b.choose(&[Handle::Knob, Handle::Bar]);
    let count = (half.1 / 0.3).clamp(1.0, 3.0) as usize;
    let high = top.0 - top.1;
    let deep = 0.13_f32.min(high * 0.4);
    let case = Case {
        low: [-half.0, -half.1, high - deep],
        high: [half.0 - handle.depth(), half.1, high - 0.001],
        columns: vec![(1.0, vec![(1.0, Cell::Drawers(1))]); count],
        handle,
        body,
        front: body,
        lid: body,
        metal: b.style.metal,
    };
    case.build(b);
}

/// A desk: a top on legs, loops or trestles, with drawer pedestals or flat drawers.
pub(super) fn desk(b: &mut Build<'_>) {
    at_least(b, [0.27, 0.45, 0.33]);
    let mut table = Table::new(b, &[Outline::Rect, Outline::Rect, Outline::Rounded]);
    if table.outline == Outline::Oval {
        table.outline = Outline::Rect;
    }
    table.top = b.choose(&[table.wood, table.wood, WHITE, b.style.cabinet]);
    table.top(b);
    let half = (table.x - 0.02, table.y - 0.02);
    match b.rng.below(6) {
        0 => pedestals(b, &table, &[-1.0, 1.0]),
        1 | 2 => {
            let side = b.choose(&[-1.0, 1.0]);
            pedestals(b, &table, &[side]);
        }
        3 => {
            drawers_below(b, half, (table.h, table.thickness), table.wood);
            let r = (table.x * 0.1).min(0.03);
            let height = table.h - table.thickness - 0.12_f32.min(table.h * 0.38);
            Four::upright((half.0 - 0.03, half.1), height, (r * 0.6, r), Cut::Square).build(b, table.wood);
        }
        _ => {
            let base = b.choose(&[Base::Legs, Base::Loops, Base::Splayed, Base::Trestle, Base::Slabs]);
            table.base(b, base);
            if matches!(base, Base::Legs | Base::Loops) && b.rng.chance(0.5) {
                let (x, under) = (-half.0 * 0.8, table.h - table.thickness);
                b.block(
                    "modesty",
                    [x - 0.009, 0.03 - half.1, under * 0.55],
                    [x + 0.009, half.1 - 0.03, under - 0.0015],
                    table.wood,
                );
            }
        }
    }
}

/// Drawer pedestals below a desk at the given sides; a panel or legs at the other side.
fn pedestals(b: &mut Build<'_>, table: &Table, sides: &[f32]) {
    let handle = Handle::any(b);
    let (x, y, under) = (table.x - 0.015, table.y - 0.015, table.h - table.thickness);
    let wide = (y * 0.55).min(0.42);
    let columns: Vec<Column> = match b.rng.below(3) {
        0 => vec![(1.0, vec![(1.0, Cell::Drawers(3))])],
        1 => vec![(1.0, vec![(0.6, Cell::Doors(Front::Flat, 1)), (0.4, Cell::Drawers(1))])],
        _ => vec![(1.0, vec![(0.5, Cell::Drawers(1)), (0.5, Cell::Drawers(2))])],
    };
    let mut tally = Tally::default();
    for side in sides {
        let (a, c) = (side * y, side * (y - wide));
        let case = Case {
            low: [-x, a.min(c), 0.0],
            high: [x - handle.depth(), a.max(c), under - 0.001],
            columns: columns.clone(),
            handle,
            body: table.wood,
            front: table.top,
            lid: table.wood,
            metal: table.metal,
        };
        case.counted(b, &mut tally);
    }
    if let &[side] = sides {
        let (a, c) = (-side * y, -side * (y - BOARD * 1.4));
        b.block("panel", [-x, a.min(c), 0.0], [x, a.max(c), under], table.wood);
    }
    let reach = (-y + 0.02, y - 0.02);
    let back = (-x * 0.85, under * 0.5);
    let inner = if sides.len() > 1 {
        (wide - y, y - wide)
    } else if sides[0] > 0.0 {
        (reach.0, y - wide)
    } else {
        (wide - y, reach.1)
    };
    b.block("modesty", [back.0, inner.0, back.1], [back.0 + BOARD, inner.1, under - 0.0015], table.wood);
}

/// A desk on two columns, whose top is lifted by a motor.
pub(super) fn standing_desk(b: &mut Build<'_>) {
    at_least(b, [0.27, 0.45, 0.3]);
    let mut table = Table::new(b, &[Outline::Rect, Outline::Rounded]);
    table.outline = if table.outline == Outline::Oval { Outline::Rounded } else { table.outline };
    table.top = b.choose(&[b.style.wood, WHITE, BLACK]);
    let metal = b.choose(&[WHITE_METAL, BLACK_METAL, SILVER_METAL]);
    let (x, y, under) = (table.x, table.y * 0.68, table.h - table.thickness);
    let lower = under * 0.55;
    for side in [-1.0, 1.0] {
        let cy = side * y;
        b.rounded_block("foot", [-x * 0.9, cy - 0.035, 0.0], [x * 0.9, cy + 0.035, 0.03], 0.01, metal);
        b.block("column", [-0.045, cy - 0.03, 0.03], [0.045, cy + 0.03, lower], metal);
    }
    // The motor lifts everything above the lower columns.
    b.slide([0.0, 0.0, 1.0], (1.25 - table.h).clamp(0.05, 0.5), |b| {
        table.top(b);
        for side in [-1.0, 1.0] {
            let cy = side * y;
            b.block("lift", [-0.036, cy - 0.022, lower * 0.3], [0.036, cy + 0.022, under - 0.03], metal);
            b.block("arm", [-x * 0.75, cy - 0.025, under - 0.03], [x * 0.75, cy + 0.025, under], metal);
        }
        b.block("beam", [-0.03, 0.025 - y, under - 0.04], [0.03, y - 0.025, under - 0.001], metal);
        let (px, py) = (table.x * 0.9, table.y * 0.7);
        b.rounded_block("switch", [px - 0.07, py, under - 0.018], [px, py + 0.1, under - 0.001], 0.004, BLACK_PLASTIC);
        b.block("button", [px - 0.002, py + 0.02, under - 0.014], [px + 0.002, py + 0.04, under - 0.006], LED);
    });
}

/// A vanity: drawers below a narrow top, a mirror behind.
pub(super) fn dressing_table(b: &mut Build<'_>) {
    at_least(b, [0.19, 0.37, 0.33]);
    let mut table = Table::new(b, &[Outline::Rect, Outline::Rounded]);
    table.outline = Outline::Rect;
    table.wood = b.style.cabinet;
    table.top = b.choose(&[table.wood, b.style.wood, WHITE]);
    table.top(b);
    let half = (table.x - 0.015, table.y - 0.015);
    if b.rng.chance(0.5) {
        drawers_below(b, half, (table.h, table.thickness), table.wood);
        let height = table.h - table.thickness - 0.12_f32.min(table.h * 0.38);
        let (feet, heads) = (half, (half.0 - 0.05, half.1 - 0.05));
        Four { feet, heads, height, radii: (0.012, 0.022), cut: Cut::Round }.build(b, b.style.wood);
    } else {
        let sides: &[f32] = if b.rng.chance(0.5) { &[-1.0, 1.0] } else { &[1.0] };
        pedestals(b, &table, sides);
    }
}

/// A chest of drawers or an open rack with a padded top between rails.
pub(super) fn changing_table(b: &mut Build<'_>) {
    at_least(b, [0.22, 0.37, 0.4]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let rail = 0.09_f32.min(h * 0.12);
    let deck = h - rail;
    let body = b.choose(&[b.style.cabinet, b.style.wood, WHITE]);
    let columns: Vec<Column> = match b.rng.below(3) {
        0 => vec![(1.0, vec![(1.0, Cell::Drawers(3))])],
        1 => vec![(1.0, vec![(0.62, Cell::Open(2)), (0.38, Cell::Drawers(1))])],
        _ => vec![(1.0, vec![(1.0, Cell::Open(2))]), (1.0, vec![(1.0, Cell::Drawers(3))])],
    };
    let mut piece = Piece::new(columns, body);
    (piece.carries, piece.handle) = (false, Handle::Knob);
    piece.stand = b.choose(&[Stand::Plinth, Stand::Legs]);
    b.size.z = deck;
    piece.build(b);
    let front = x - Handle::Knob.depth();
    frame_around(b, [-x, -y, deck], [front, y, h], body);
    let pad = b.choose(&[WHITE_COTTON, SKY, b.style.accent]);
    let (px, py, t) = ((front + x) / 2.0 - 0.025, y - 0.025, rail * 0.45);
    let cx = f32::midpoint(-x, front);
    b.rounded_block("pad", [cx - px, -py, deck + 0.001], [cx + px, py, deck + t], 0.02, pad);
    b.top("pad", [cx, 0.0, deck + t], (px - 0.02, py - 0.02));
}

/// Low boards around a rectangle, standing on it.
fn frame_around(b: &mut Build<'_>, low: P, high: P, mat: MaterialId) {
    b.block("rail", low, [high[0], low[1] + BOARD, high[2]], mat);
    b.block("rail", [low[0], high[1] - BOARD, low[2]], high, mat);
    b.block("rail", [low[0], low[1] + BOARD, low[2]], [low[0] + BOARD, high[1] - BOARD, high[2]], mat);
}

/// A bedside table with drawers, an open space, or both.
pub(super) fn nightstand(b: &mut Build<'_>) {
    at_least(b, [0.16, 0.18, 0.2]);
    if b.rng.chance(0.15) {
        return light_nightstand(b);
    }
    let cells = match b.rng.below(5) {
        0 => vec![(1.0, Cell::Drawers(2))],
        1 => vec![(0.55, Cell::Open(1)), (0.45, Cell::Drawers(1))],
        2 => vec![(0.6, Cell::Drawers(1)), (0.4, Cell::Open(1))],
        3 => {
            let look = Front::any(b);
            vec![(0.62, Cell::Doors(look, 1)), (0.38, Cell::Drawers(1))]
        }
        _ => vec![(1.0, Cell::Drawers(if b.size.z > 0.55 { 3 } else { 2 }))],
    };
    let body = b.choose(&[b.style.wood, b.style.cabinet, b.style.wood]);
    let mut piece = Piece::new(vec![(1.0, cells)], body);
    piece.front = b.choose(&[body, body, b.style.cabinet]);
    piece.handle = Handle::any(b);
    piece.stand = b.choose(&[Stand::Plinth, Stand::Legs, Stand::Splayed, Stand::Splayed, Stand::Tube]);
    piece.overhang = b.choose(&[0.0, 0.012]);
    piece.build(b);
}

/// A small table with one drawer under its top, and a shelf.
fn light_nightstand(b: &mut Build<'_>) {
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let wood = b.style.wood;
    b.rounded_block("top", [-x, -y, h - 0.02], [x, y, h], 0.005, wood);
    b.top("top", [0.0, 0.0, h], (x - 0.01, y - 0.01));
    let half = (x - 0.01, y - 0.01);
    drawers_below(b, half, (h, 0.02), wood);
    let under = h - 0.02 - 0.13_f32.min((h - 0.02) * 0.4);
    let legs = (half.0 - 0.016, half.1);
    Four::upright(legs, under, (0.013, 0.016), Cut::Square).build(b, wood);
    let z = under * 0.35;
    b.block("shelf", [0.02 - legs.0, 0.006 - legs.1, z - 0.015], [legs.0 - 0.02, legs.1 - 0.006, z], wood);
    b.ledge("shelf", [0.0, 0.0, z], (legs.0 - 0.04, legs.1 - 0.04), under - z - 0.005);
}
