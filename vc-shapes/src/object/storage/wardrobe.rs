//! Wardrobes and closets.

use super::case::{Case, Cell, Column, Piece, Stand};
use crate::material::*;
use crate::object::joinery::{BOARD, Front, GAP, Handle, drawer, front_panel};
use crate::solid::{Build, at_least};

/// A wardrobe with hinged doors or sliding ones: a rod under a shelf, shelves, drawers.
pub(super) fn wardrobe(b: &mut Build<'_>) {
    at_least(b, [0.27, 0.45, 0.9]);
    let closet = b.class == "closet";
    let sliding = b.size.y > 1.2 && b.rng.chance(if closet { 0.5 } else { 0.25 });
    if sliding {
        return slider(b, closet);
    }
    // One column for each pair of doors, each about half a metre wide.
    let doors = (b.size.y / 0.5).round().clamp(1.0, 6.0) as usize;
    let look = b.choose(&[Front::Flat, Front::Flat, Front::Framed, Front::Framed, Front::Louvred, Front::Reeded]);
    let mirror = b.rng.chance(0.25);
    let below = b.rng.chance(0.4);
    let columns: Vec<Column> = (0..doors.div_ceil(2))
        .map(|i| {
            let leaves = (doors - 2 * i).min(2);
            let look = if mirror && i == 0 { Front::Mirror } else { look };
            let cell = if i % 2 == 1 || (leaves == 1 && doors > 1) { Cell::Doors(look, 5) } else { Cell::Hang(look) };
            let stack = if below { vec![(0.2, Cell::Drawers(1)), (0.8, cell)] } else { vec![(1.0, cell)] };
            (leaves as f32, stack)
        })
        .collect();
    let body = b.choose(&[b.style.cabinet, b.style.wood, WHITE, b.style.cabinet]);
    let mut piece = Piece::new(columns, body);
    piece.front = b.choose(&[body, body, b.style.cabinet]);
    piece.handle = b.choose(&[Handle::Bar, Handle::Bar, Handle::Knob]);
    piece.carries = false;
    if closet {
        (piece.stand, piece.body) = (Stand::None, WHITE);
    } else {
        piece.stand = b.choose(&[Stand::Plinth, Stand::Plinth, Stand::Legs]);
        piece.overhang = b.choose(&[0.0, 0.0, 0.02]);
    }
    piece.build(b);
}

/// A wardrobe behind two or three panels that slide in front of each other.
fn slider(b: &mut Build<'_>, closet: bool) {
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let body = if closet { WHITE } else { b.choose(&[b.style.cabinet, b.style.wood, WHITE]) };
    let (front, metal) = (b.choose(&[body, WHITE, b.style.cabinet]), b.choose(&[ALUMINIUM, b.style.metal]));
    let lift = if closet { 0.0 } else { 0.05 };
    let track = 0.06;
    let inner = x - track;
    let count = if b.size.y > 2.0 { 3 } else { 2 };
    let insides = [Cell::Rod, Cell::Open(5), Cell::Rod];
    let columns: Vec<Column> = (0..count).map(|i| (1.0, vec![(1.0, insides[i])])).collect();
    Stand::Plinth.build(b, [-x, -y, lift], [inner, y, h], body, metal);
    let (low, high) = ([-x, -y, lift], [inner, y, h]);
    Case { low, high, columns, handle: Handle::None, body, front, lid: body, metal }.build(b);
    let (z0, z1) = (lift + 0.025, h - 0.045);
    b.block("track", [inner - 0.002, 0.001 - y, lift + 0.001], [x, y - 0.001, z0 - 0.004], metal);
    b.block("track", [inner - 0.002, 0.001 - y, z1 + 0.004], [x, y - 0.001, h - 0.001], metal);
    let wide = 2.0 * y / count as f32;
    let mirrored = b.rng.below(count + 2);
    let look = b.choose(&[Front::Flat, Front::Framed, Front::Flat]);
    for i in 0..count {
        // Panels alternate between the two rails; each slides over its neighbour.
        let rail = if i % 2 == 0 { x - 0.026 } else { inner + 0.006 };
        let (a, c) = (wide * i as f32 - y, wide * (i + 1) as f32 - y);
        let lap = |edge: f32| if edge.abs() > y - 0.001 { GAP } else { -0.015 };
        let (low, high) = ([rail, a + lap(a), z0], [rail + 0.022, c - lap(c), z1]);
        let way = if i + 1 == count { -1.0 } else { 1.0 };
        let look = if i == mirrored { Front::Mirror } else { look };
        b.slide([0.0, way, 0.0], wide - 0.03, |b| {
            front_panel(b, &format!("door_{}", i + 1), low, high, look, front);
            for edge in [low[1], high[1] - 0.02] {
                let (from, to) =
                    ([low[0] - 0.001, edge + 0.001, z0 + 0.001], [high[0] + 0.003, edge + 0.019, z1 - 0.001]);
                b.block("grip", from, to, metal);
            }
        });
    }
}

/// One drawer in its own case, for the inside of a closet.
pub(super) fn closet_drawer(b: &mut Build<'_>) {
    at_least(b, [0.2, 0.2, 0.075]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let handle = b.choose(&[Handle::Bar, Handle::Knob, Handle::None]);
    let body = b.choose(&[WHITE, b.style.cabinet, b.style.wood]);
    let (front, t) = (x - handle.depth(), BOARD * 0.8);
    for side in [-1.0_f32, 1.0] {
        let (a, c) = (side * y, side * (y - t));
        b.block("side", [-x, a.min(c), 0.0], [front - BOARD, a.max(c), h - 0.001], body);
    }
    b.block("back", [-x, t - y, 0.0], [-x + 0.01, y - t, h - 0.002], body);
    b.block("bottom", [-x + 0.01, t - y, 0.0], [front - BOARD, y - t, 0.006], body);
    let (low, high) = ([-x, -y, 0.0], [front, y, h]);
    drawer(b, "drawer_1", low, high, handle, (body, BIRCH, b.style.metal));
}
