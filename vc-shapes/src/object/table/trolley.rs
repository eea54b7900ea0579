//! Work tables: of steel, folding, on castors, with a vice.

use super::frame::Four;
use super::{Outline, Table};
use crate::material::*;
use crate::object::joinery::Handle;
use crate::object::storage::case::{Case, Cell};
use crate::solid::{Axis, Build, CORNERS, Cut, P, at_least, leg, rounded_by_radius};

/// A light table whose legs fold under its top.
pub(super) fn folding_table(b: &mut Build<'_>) {
    let mut table = Table::new(b, &[Outline::Rect, Outline::Rounded]);
    table.outline = Outline::Rounded;
    table.top = b.choose(&[WHITE_PLASTIC, b.style.wood, GREY_PLASTIC, BLACK]);
    table.top(b);
    let (x, y, under) = (table.x - 0.06, table.y * 0.82, table.h - table.thickness);
    let (metal, r) = (b.choose(&[GALVANISED, BLACK_METAL, WHITE_METAL]), 0.012);
    for side in [-1.0, 1.0] {
        let (cy, z) = (side * y, under - 0.02);
        let foot = side * (y + 0.03);
        b.hinge([0.0, cy, z], [-side, 0.0, 0.0], 1.5, |b| {
            for sx in [-x, x] {
                b.bar("leg", [sx, cy, z], [sx, foot, r], r, metal);
            }
            b.rod("rung", [-x, cy, z], [x, cy, z], r * 0.9, metal);
            b.rod("rung", [-x, foot * 0.98, under * 0.25], [x, foot * 0.98, under * 0.25], r * 0.8, metal);
        });
    }
    for side in [-1.0, 1.0] {
        let cx = side * (x - 0.03);
        b.block("rail", [cx - 0.01, 0.04 - y, under - 0.02], [cx + 0.01, y - 0.04, under], metal);
        for cy in [-y, y] {
            b.block("bracket", [cx - 0.015, cy - 0.012, under - 0.0105], [cx + 0.015, cy + 0.012, under], metal);
        }
    }
}

/// A castor below a point.
pub(in crate::object) fn castor(b: &mut Build<'_>, at: P, radius: f32) {
    let [x, y, top] = at;
    let t = radius * 0.5;
    b.rod("castor", [x, y - t, radius], [x, y + t, radius], radius, BLACK_PLASTIC);
    b.cylinder("fork", [x, y, radius], t * 0.6, (top - radius).max(0.002), STEEL);
}

/// A trolley on castors with two or three trays between posts.
pub(super) fn serving_trolley(b: &mut Build<'_>) {
    at_least(b, [0.2, 0.25, 0.35]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let metal = b.choose(&[b.style.metal, BRASS, STEEL, BLACK_METAL]);
    let tray = b.choose(&[b.style.wood, GLASS, STEEL, b.style.wood]);
    let (levels, wheel, r) = (b.rng.count(2, 3), 0.035, 0.012);
    let (px, py) = (x - 0.03, y - 0.07_f32.min(y * 0.2));
    let round = b.rng.chance(0.5);
    for (sx, sy) in CORNERS {
        let (cx, cy) = (sx * (px - r), sy * (py - r));
        castor(b, [cx, cy, wheel * 2.0], wheel);
        if round {
            b.cylinder("post", [cx, cy, wheel * 1.9], r, h - wheel * 1.9 - 0.02, metal);
        } else {
            b.block("post", [cx - r, cy - r, wheel * 1.9], [cx + r, cy + r, h - 0.02], metal);
        }
    }
    let (first, last) = (0.14, h - 0.1);
    let pitch = (last - first) / (levels - 1) as f32;
    for i in 0..levels {
        let z = first + pitch * i as f32;
        b.block("tray", [0.001 - px, 0.001 - py, z - 0.015], [px - 0.001, py - 0.001, z], tray);
        let free = (px - 2.0 * r - 0.008, py - 2.0 * r - 0.008);
        let name = format!("tray_{}", i + 1);
        if i + 1 == levels {
            b.top(&name, [0.0, 0.0, z], free);
        } else {
            b.inside(&name, [0.0, 0.0, z], free, pitch - 0.02);
        }
        for side in [-1.0, 1.0] {
            let (cx, rail) = (side * (px - r), z + 0.04);
            b.rod("rail", [cx, -py + r, rail], [cx, py - r, rail], 0.005, metal);
            let cy = side * (py - r);
            b.rod("rail", [-px + r, cy, rail + 0.001], [px - r, cy, rail + 0.001], 0.005, metal);
        }
    }
    let top = h - 0.012;
    for side in [-1.0, 1.0] {
        let (a, c) = (side * (py - r), side * (y - 0.012));
        b.pipe("handle", &[[-px + r, a, top], [-px + r, c, top], [px - r, c, top], [px - r, a, top]], 0.011, metal);
    }
}

/// A steel table with a shelf below, sometimes with a splashback.
pub(super) fn prep_table(b: &mut Build<'_>) {
    at_least(b, [0.25, 0.35, 0.35]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let splash = if b.rng.chance(0.5) { 0.1_f32.min(h * 0.15) } else { 0.0 };
    let deck = h - splash;
    let top = b.choose(&[STEEL, STEEL, STEEL, BEECH]);
    let lip = if top == STEEL { 0.04 } else { 0.045 };
    let feet = 0.02_f32.min(x * 0.1);
    b.rounded_block("top", [-x, -y, deck - lip], [x, y, deck], 0.006, top);
    if splash > 0.0 {
        b.block("splashback", [-x, -y, deck - 0.002], [-x + 0.015, y, h], STEEL);
    }
    let from = if splash > 0.0 { 0.02 - x } else { 0.01 - x };
    b.top("top", [f32::midpoint(from, x), 0.0, deck], ((x - from) / 2.0 - 0.01, y - 0.01));
    let half = (x - 0.03, y - 0.03);
    Four::upright(half, deck - lip, (feet, feet), Cut::Round).build(b, STEEL);
    let levels = b.rng.count(1, 2);
    let pitch = (deck - lip - 0.15) / levels as f32;
    for i in 0..levels {
        let z = 0.17 + pitch * i as f32;
        b.block("shelf", [-half.0 + 0.005, -half.1 + 0.005, z - 0.02], [half.0 - 0.005, half.1 - 0.005, z], STEEL);
        let free = (half.0 - 2.0 * feet - 0.01, half.1 - 2.0 * feet - 0.01);
        b.ledge(&format!("shelf_{}", i + 1), [0.0, 0.0, z], free, (pitch - 0.05).max(0.05));
    }
    if b.rng.chance(0.3) {
        let bars = (y / 0.12).clamp(3.0, 10.0);
        let step = 2.0 * (half.1 - 0.05) / bars;
        for i in 0..bars as usize {
            let cy = 0.05 - half.1 + step * (i as f32 + 0.5);
            b.rod("hook", [half.0 + 0.006, cy, deck - lip], [half.0 + 0.006, cy, deck - lip - 0.05], 0.003, STEEL);
        }
    }
}

/// A thick top on heavy legs with a shelf, drawers and a vice.
pub(super) fn workbench(b: &mut Build<'_>) {
    at_least(b, [0.27, 0.5, 0.4]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let wood = b.choose(&[BEECH, PINE, OAK]);
    let frame = b.choose(&[wood, wood, BLUE_METAL, RED_METAL, BLACK_METAL]);
    let vice = b.rng.chance(0.6);
    let front = if vice { x - 0.09_f32.min(x * 0.2) } else { x };
    let (t, r) = (b.vary(0.045, 0.07), b.vary(0.035, 0.05).min(x * 0.15));
    let centre = f32::midpoint(-x, front);
    b.block("top", [-x, -y, h - t], [front, y, h], wood);
    b.top("top", [centre, 0.0, h], ((front + x) / 2.0 - 0.01, y - 0.01));
    let half = ((front + x) / 2.0 - 0.03, y - 0.06);
    b.at([centre, 0.0, 0.0], 0.0, |b| {
        Four::upright(half, h - t, (r, r), Cut::Square).build(b, frame);
        let (z, inner) = (h * 0.22, (half.0 - r * 0.5, half.1 - r * 0.5));
        b.block("shelf", [-inner.0, -inner.1, z - 0.025], [inner.0, inner.1, z], wood);
        let free = (half.0 - 2.0 * r - 0.01, half.1 - 2.0 * r - 0.01);
        let drawers = b.rng.chance(0.5);
        let drop = if drawers { 0.17_f32.min(h * 0.2) } else { 0.1_f32.min(h * 0.12) };
        b.ledge("shelf", [0.0, 0.0, z], free, h - t - drop - z - 0.01);
        if drawers {
            let handle = Handle::Bar;
            // The drawers are placed beside the vice.
            let (low, high) = (2.0 * r - half.1, half.1 - 2.0 * r);
            let high = if vice { high.min(y * 0.62 - 0.14).max(low + 0.1) } else { high };
            let case = Case {
                low: [-half.0 * 0.9, low, h - t - drop],
                high: [half.0 + 0.02 - handle.depth(), high, h - t - 0.001],
                columns: vec![(1.0, vec![(1.0, Cell::Drawers(1))]); 2],
                handle,
                body: frame,
                front: frame,
                lid: frame,
                metal: STEEL,
            };
            case.build(b);
        } else {
            for side in [-1.0_f32, 1.0] {
                let cx = side * (half.0 - r);
                b.block("rail", [cx - 0.015, r - half.1, h - t - drop], [cx + 0.015, half.1 - r, h - t], frame);
            }
        }
    });
    if vice {
        front_vice(b, front, x, (y * 0.62, h));
    }
}

/// A wooden-jawed vice on the front edge.
fn front_vice(b: &mut Build<'_>, front: f32, end: f32, at: (f32, f32)) {
    let ((y, h), jaw) = (at, (end - front) * 0.45);
    b.block("jaw", [front + 0.004, y - 0.12, h - 0.13], [front + jaw, y + 0.12, h - 0.005], BEECH);
    b.rod("screw", [front - 0.02, y, h - 0.08], [end - 0.014, y, h - 0.08], 0.012, STEEL);
    b.rod("bar", [end - 0.012, y - 0.09, h - 0.08], [end - 0.012, y + 0.09, h - 0.08], 0.008, STEEL);
}

/// An ironing board: a long padded top with one pointed end on crossed legs.
pub(in crate::object) fn ironing_board(b: &mut Build<'_>) {
    at_least(b, [0.15, 0.5, 0.35]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let cover = b.choose(&[BLUE_FABRIC, GREY_FABRIC, b.style.accent, b.style.linen]);
    let t = 0.03;
    let mut outline = rounded_by_radius((x, y), 0.05);
    // The end at the higher Y tapers to a blunt point.
    for p in &mut outline {
        let k = ((p.1 - y * 0.35) / (y * 0.65)).clamp(0.0, 1.0);
        p.0 *= 1.0 - 0.62 * k * k;
    }
    b.prism("top", Axis::Z, [0.0, 0.0, h - t], &outline, t, cover);
    b.top("top", [0.0, -y * 0.3, h], (x - 0.03, y * 0.6));
    let (metal, r, under) = (b.choose(&[WHITE_METAL, SILVER_METAL, BLACK_METAL]), 0.011, h - t);
    let wide = x * 0.8;
    for (sx, from, to) in [(wide, -y * 0.62, y * 0.55), (-wide, -y * 0.62, y * 0.55)] {
        leg(b, "leg", ([sx, from, 0.0], r), ([sx * 0.35, to, under], r), Cut::Round, metal);
        leg(b, "leg", ([sx, -from, 0.0], r), ([sx * 0.3, -to, under], r), Cut::Round, metal);
    }
    for side in [-1.0, 1.0] {
        let cy = side * y * 0.62;
        b.rod("foot", [-x * 0.95, cy, r], [x * 0.95, cy, r], r, metal);
        b.block("rail", [side * 0.03 - 0.01, -y * 0.7, under - 0.012], [side * 0.03 + 0.01, y * 0.6, under], metal);
    }
}
