//! Hall furniture for coats, hats and keys.

use std::f32::consts::{FRAC_PI_4, FRAC_PI_8};

use vc_graph::portable::Portable;

use super::case::{Case, Cell};
use crate::material::*;
use crate::object::joinery::{BOARD, Handle};
use crate::object::table::frame::baluster;
use crate::solid::{Axis, Build, Cut, P, at_least, leg};

/// A bent hook that protrudes from `x` with its tip turned up, and its surface.
fn peg(b: &mut Build<'_>, index: usize, at: P, reach: f32, drop: f32, mat: MaterialId) {
    let [x, y, z] = at;
    let r = (reach * 0.09).clamp(0.003, 0.006);
    b.pipe(
        "hook",
        &[[x, y, z], [x + reach * 0.75, y, z - reach * 0.15], [x + reach - 1.6 * r, y, z + reach * 0.3]],
        r,
        mat,
    );
    b.hook(&format!("hook_{}", index + 1), [x + reach * 0.75, y, z - reach * 0.15 + r], drop);
}

/// A pole with arms near its top, on three or four feet, or a tree of branches.
pub(super) fn coat_rack(b: &mut Build<'_>) {
    at_least(b, [0.17, 0.17, 0.6]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let wooden = b.rng.chance(0.55);
    let mat = if wooden { b.style.wood } else { b.choose(&[BLACK_METAL, BRASS, WHITE_METAL, b.style.metal]) };
    let (reach, r) = (x.min(y), if wooden { 0.02 } else { 0.013 });
    let feet: &[(f32, f32)] = if b.rng.chance(0.5) {
        &[(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)]
    } else {
        &[(0.96, 0.96), (-0.96, 0.96), (-0.96, -0.96), (0.96, -0.96)]
    };
    let low = h * 0.16;
    let design = b.rng.below(3);
    if design == 0 {
        let plate = reach * 0.94;
        b.lathe("foot", [0.0; 3], &[(plate, 0.0), (plate, 0.012), (plate * 0.4, 0.024), (r, 0.04)], mat);
    } else {
        if design == 1 && wooden {
            baluster(b, "pole", [0.0, 0.0, 0.1], r * 1.6, h * 0.5, mat);
        }
        for (i, &(dx, dy)) in feet.iter().enumerate() {
            let (foot, z) = ([dx * (x - r), dy * (y - r), 0.0], low - 0.002 * i as f32);
            leg(b, "foot", (foot, r * 0.7), ([dx * r * 0.4, dy * r * 0.4, z], r * 0.8), Cut::Round, mat);
        }
    }
    // A tray for gloves and drips.
    let (tray, floor) = (reach * 0.62, low + 0.008);
    b.lathe("tray", [0.0, 0.0, low - 0.008], &[(tray * 0.94, 0.0), (tray, 0.004), (tray, 0.016)], mat);
    let (near, far) = (r * 1.7 + 0.004, tray * 0.8);
    let half = ((far - near) / 2.0, tray * 0.45);
    b.ledge("tray", [f32::midpoint(near, far), 0.0, floor], half, h * 0.25);
    let start = if design == 0 { 0.02 } else { low * 0.5 };
    b.cylinder("pole", [0.0, 0.0, start], r, h - start - r * 1.2, mat);
    b.ball("knob", [0.0, 0.0, h - r * 1.2], r * 1.2, mat);
    let tiers = b.rng.count(1, 3);
    let mut index = 0;
    for tier in 0..tiers {
        let z = h - 0.1 - 0.16 * tier as f32;
        let out = reach * (0.92 - 0.12 * tier as f32);
        for &(dx, dy) in feet {
            // Each tier is rotated, so that coats hang clear of the arms below.
            let way = dy.angle_to(dx) + [0.0, FRAC_PI_4, FRAC_PI_8][tier];
            let turn = |k: f32, z: f32| [way.cosine() * k, way.sine() * k, z];
            b.pipe("arm", &[turn(0.0, z - 0.05), turn(out * 0.6, z), turn(out - 0.008, z + 0.045)], 0.008, mat);
            b.hook(&format!("hook_{}", index + 1), turn(out * 0.66, z + 0.012), (z - low - 0.1).min(z - floor - 0.02));
            index += 1;
        }
    }
}

/// A board, rail or panel on a wall with hooks or pegs, sometimes under a shelf.
pub(super) fn wall_hook_rack(b: &mut Build<'_>) {
    at_least(b, [0.03, 0.2, 0.04]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (wood, metal) =
        (b.choose(&[b.style.wood, b.style.cabinet, WHITE]), b.choose(&[b.style.metal, BRASS, BLACK_METAL, CHROME]));
    let t = 0.018_f32.min(x * 0.5);
    let (x0, shelf) = (t - x, h > 0.16 && b.rng.chance(0.6));
    // Without a hat shelf there is a narrow ledge.
    let (board, deep) = if shelf { (t, x) } else { (t.min(h * 0.15), x * 0.1) };
    let plate = h - board;
    b.rounded_block("board", [-x, -y, 0.0], [x0, y, plate], 0.004, wood);
    b.block("shelf", [-x, -y, plate], [deep, y, h], wood);
    b.top("shelf", [(deep - x) / 2.0, 0.0, h], ((deep + x) / 2.0 - 0.004, y - 0.01));
    if shelf {
        for side in [-1.0_f32, 1.0] {
            let (a, c) = (side * (y - 0.002), side * (y - t));
            b.block("bracket", [x0 - 0.001, a.min(c), h * 0.5], [x * 0.7, a.max(c), h - t + 0.001], wood);
        }
    }
    let count = (2.0 * y / b.vary(0.1, 0.15)).round().clamp(3.0, 8.0) as usize;
    let pegs = b.rng.chance(0.35);
    let reach = 2.0 * x - t;
    for i in 0..count {
        let cy = (y - 0.04) * (2.0 * (i as f32 + 0.5) / count as f32 - 1.0);
        if pegs {
            let z = plate * 0.55;
            let end = x - 0.012;
            b.rod("peg", [x0 - 0.002, cy, z], [end, cy, z], 0.007, wood);
            b.rod("knob", [end - 0.004, cy, z], [x, cy, z], 0.0125, wood);
            b.hook(&format!("hook_{}", i + 1), [f32::midpoint(x0, end), cy, z + 0.007], 1.2);
        } else {
            let z = if shelf { h * 0.42 } else { h * 0.35 };
            b.block("plate", [x0 - 0.001, cy - 0.009, z - h * 0.12], [x0 + 0.003, cy + 0.009, z + h * 0.3], metal);
            peg(b, i, [x0 + 0.002, cy, z], (reach - 0.002).min(z * 2.0), 1.2, metal);
        }
    }
}

/// A bench with compartments, a panelled back with hooks, and a shelf on top.
pub(super) fn hall_stand(b: &mut Build<'_>) {
    at_least(b, [0.16, 0.32, 0.7]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let body = b.choose(&[b.style.cabinet, b.style.wood, WHITE]);
    let (seat, t, back) = (0.45_f32.min(h * 0.3), BOARD, 0.02);
    let pad = 0.045;
    let cell = b.choose(&[Cell::Open(1), Cell::Open(2), Cell::Drawers(1)]);
    let handle = Handle::Knob;
    let grip = if matches!(cell, Cell::Open(_)) { 0.0 } else { handle.depth() };
    let case = Case {
        low: [-x, -y, 0.0],
        high: [x - grip, y, seat - pad],
        columns: vec![(1.0, vec![(1.0, cell)]); if y > 0.4 { 3 } else { 2 }],
        handle,
        body,
        front: body,
        lid: body,
        metal: b.style.metal,
    };
    case.build(b);
    let from = back - x;
    b.rounded_block(
        "cushion",
        [from + 0.004, 0.006 - y, seat - pad],
        [x - grip - 0.004, y - 0.006, seat],
        0.018,
        b.style.accent,
    );
    let centre = f32::midpoint(from, x - grip);
    b.ledge("seat", [centre, 0.0, seat], ((x - grip - from) / 2.0 - 0.025, y - 0.03), h * 0.76 - seat - 0.01);
    b.block("back", [-x, -y + 0.001, seat - pad], [from, y - 0.001, h - t], body);
    let boards = (y / 0.07).clamp(3.0, 10.0) as usize;
    for i in 1..boards {
        let cy = y * (2.0 * i as f32 / boards as f32 - 1.0);
        b.block(
            "groove",
            [from - 0.001, cy - 0.003, seat + 0.02],
            [from + 0.0015, cy + 0.003, h * 0.72],
            if body == WHITE { LIGHT_GREY } else { body },
        );
    }
    let rail = h * 0.76;
    b.block("rail", [from - 0.001, -y + 0.002, rail], [from + 0.014, y - 0.002, rail + 0.1], b.style.wood);
    let shelf = x * 0.75;
    b.block("shelf", [-x, -y, h - t], [shelf, y, h], body);
    for side in [-1.0_f32, 1.0] {
        let (a, c) = (side * y, side * (y - t));
        b.block(
            "bracket",
            [from - 0.001, a.min(c) + 0.002, h - 0.16_f32.min(h * 0.1)],
            [shelf * 0.8, a.max(c) - 0.002, h - t + 0.001],
            body,
        );
    }
    b.top("shelf", [f32::midpoint(-x, shelf), 0.0, h], ((shelf + x) / 2.0 - 0.008, y - 0.01));
    let count = (y / 0.09).clamp(3.0, 7.0) as usize;
    for i in 0..count {
        let cy = (y - 0.06) * (2.0 * (i as f32 + 0.5) / count as f32 - 1.0);
        peg(b, i, [from + 0.013, cy, rail + 0.045], 0.08_f32.min(x * 0.6), rail - seat - 0.1, b.style.metal);
    }
}

/// The length of what hangs from the hooks of a key holder, metres.
const KEYS: f32 = 0.16;

/// A small board with key hooks and a ledge, or a little house.
pub(super) fn key_holder(b: &mut Build<'_>) {
    at_least(b, [0.015, 0.09, 0.05]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (wood, metal) =
        (b.choose(&[b.style.wood, b.style.cabinet, b.style.wood]), b.choose(&[BRASS, BLACK_METAL, STEEL]));
    let t = 0.01_f32.min(x * 0.5);
    let x0 = t - x;
    if b.rng.chance(0.5) && h > 0.14 {
        let outline = [(-y, 0.0), (y, 0.0), (y, h * 0.72), (0.0, h), (-y, h * 0.72)];
        b.prism("board", Axis::X, [-x, 0.0, 0.0], &outline, t, wood);
    } else {
        b.rounded_block("board", [-x, -y, 0.0], [x0, y, h], 0.003, wood);
    }
    let (z, lip) = (h * 0.45, (h * 0.14).min(0.025));
    b.block("ledge", [x0 - 0.001, 0.006 - y, z], [x, y - 0.006, z + 0.006], wood);
    b.block("lip", [x - 0.006, 0.007 - y, z + 0.005], [x - 0.001, y - 0.007, z + lip], wood);
    let half = (x - 0.006 - x0) / 2.0;
    b.inside("rack", [x0 + half, 0.0, z + 0.006], ((half - 0.002).max(0.001), y - 0.012), h * 0.25);
    let count = (2.0 * y / 0.045).clamp(2.0, 7.0) as usize;
    for i in 0..count {
        let cy = (y - 0.015) * (2.0 * (i as f32 + 0.5) / count as f32 - 1.0);
        peg(b, i, [x0 - 0.001, cy, h * 0.22], (2.0 * x - t).min(h * 0.3).min(0.03), KEYS, metal);
    }
}
