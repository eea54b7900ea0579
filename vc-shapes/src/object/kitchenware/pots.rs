//! Pots, pans and tins.

use std::f32::consts::TAU;

use vc_graph::portable::Portable;

use super::dishes::KNOB;
use crate::material::*;
use crate::solid::{Build, arch, dims, flat_ring, planar_tube, sweep, tub, turn, vessel, vessel_profile};

/// A grip loop at the Y side of a round wall, horizontal at height `z`.
fn loop_grip(
    b: &mut Build<'_>,
    side: f32,
    (wall, reach): (f32, f32),
    z: f32,
    width: f32,
    radius: f32,
    mat: MaterialId,
) {
    let r = radius.min((reach - wall) * 0.3).max(2e-4);
    let path = arch([0.0, side * wall, z], [width, 0.0, 0.0], [0.0, side * (reach - wall - r).max(1e-4), 0.0]);
    planar_tube(b, "handle", &path, r, [0.0, 0.0, 1.0], mat);
}

/// A long handle along Y, flatter than wide and thicker at the grip.
fn long_grip(b: &mut Build<'_>, from: (f32, f32), to: (f32, f32), half: (f32, f32), mat: MaterialId) {
    let at = |k: f32, lift: f32| [0.0, from.0 + (to.0 - from.0) * k, from.1 + (to.1 - from.1) * lift];
    let path = [
        (at(0.0, 0.0), half.0 * 0.6, half.1 * 0.6),
        (at(0.3, 0.45), half.0 * 0.65, half.1 * 0.7),
        (at(0.45, 0.7), half.0, half.1),
        (at(0.9, 1.0), half.0, half.1),
        (at(1.0, 1.0), half.0 * 0.5, half.1 * 0.6),
    ];
    sweep(b, "handle", &path, [1.0, 0.0, 0.0], mat);
}

/// A removable lid on a rim.
fn lid(b: &mut Build<'_>, r: f32, (rim, top): (f32, f32), mats: (MaterialId, MaterialId)) {
    let rise = (top - rim) * 0.45;
    b.slide([0.0, 0.0, 1.0], top * 0.6, |b| {
        turn(
            b,
            "lid",
            [0.0, 0.0, rim + 0.0004],
            (r, rise),
            &[(0.99, 0.0), (1.0, 0.15), (0.75, 0.7), (0.1, 1.0)],
            mats.0,
        );
        let width = (r * 0.22).min(0.025);
        turn(b, "knob", [0.0, 0.0, rim + rise * 0.95], (width, top - rim - rise * 0.95), KNOB, mats.1);
    });
}

/// Pots with a lid: high or low, of steel or cast iron, with loops or a long handle.
pub(super) fn pot(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let long = matches!(b.class, "pressure_cooker" | "saute_pan");
    let cast = b.class == "dutch_oven";
    let mat = match b.class {
        "dutch_oven" => b.choose(&[RED_METAL, BLUE_METAL, GREEN_METAL, YELLOW_METAL, BLACK_METAL]),
        "pressure_cooker" | "stockpot" => b.choose(&[STEEL, STEEL, ALUMINIUM]),
        _ => b.choose(&[STEEL, STEEL, STEEL, BLACK_METAL, RED_METAL, COPPER, WHITE_METAL]),
    };
    let grip = if cast { mat } else { b.choose(&[STEEL, BLACK_PLASTIC, mat]) };
    let cover = if cast { mat } else { b.choose(&[mat, STEEL, GLASS]) };
    let r = (x / 2.0).min(y * if long { 0.34 } else { 0.43 });
    let knob = (z * 0.28).min(0.055);
    let h = z - knob;
    let (foot, belly) = (b.vary(0.88, 0.97), if cast { 0.98 } else { 1.0 });
    let t = (r * 0.04).min(if cast { 0.006 } else { 0.003 });
    vessel(b, "pot", (r, h), &[(foot, 0.0), (belly, 0.1), (1.0, 0.5), (1.0, 1.0)], t, mat);
    if cover == GLASS {
        flat_ring(b, "rim", (h * 0.98, h + (knob * 0.1).min(0.003)), (r * 0.92, r * 0.985), STEEL);
    }
    lid(b, r * if cover == GLASS { 0.93 } else { 0.99 }, (h, z), (cover, grip));
    if b.class == "pressure_cooker" {
        b.slide([0.0, 0.0, 1.0], z * 0.6, |b| {
            b.block("bar", [-r * 0.12, -r, h + 0.001], [r * 0.12, r, h + knob * 0.35], grip);
            b.cylinder("valve", [r * 0.5, 0.0, h], r * 0.08, knob * 0.7, BLACK_PLASTIC);
        });
    }
    let thick = (r * 0.07).min(0.008);
    if long {
        long_grip(b, (r * 0.97, h * 0.75), (y - r - (y - 2.0 * r) * 0.12, h * 0.9), (thick * 1.5, thick), grip);
        loop_grip(b, -1.0, (r * 0.97, r + (y - 2.0 * r) * 0.12), h * 0.8, r * 0.3, thick, grip);
    } else {
        for side in [-1.0, 1.0] {
            loop_grip(b, side, (r * 0.94, y / 2.0), h * 0.82, r * 0.32, thick, grip);
        }
    }
}

/// Pans with a long handle: low frying pans, high saucepans, woks.
pub(super) fn pan(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = match b.class {
        "saucepan" => b.choose(&[STEEL, STEEL, COPPER, BLACK_METAL, RED_METAL, WHITE_METAL]),
        "wok" => b.choose(&[IRON, BLACK_METAL, STEEL]),
        _ => b.choose(&[BLACK_METAL, IRON, STEEL, COPPER, RED_METAL, GREEN_METAL]),
    };
    let grip = b.choose(&[BLACK_PLASTIC, STEEL, IRON, b.style.wood]);
    let r = (x / 2.0).min(y * if b.class == "saucepan" { 0.34 } else { 0.36 });
    let saucepan = b.class == "saucepan";
    let h = if saucepan { z * 0.95 } else { z * b.vary(0.62, 0.72) };
    let shape: &[(f32, f32)] = match (b.class, b.rng.below(2)) {
        ("saucepan", 0) => &[(0.92, 0.0), (0.98, 0.08), (0.98, 0.95), (1.0, 1.0)],
        ("saucepan", _) => &[(0.7, 0.0), (0.9, 0.25), (0.98, 0.7), (1.0, 1.0)],
        ("wok", _) => &[(0.5, 0.0), (0.6, 0.15), (0.85, 0.5), (1.0, 1.0)],
        (_, 0) => &[(0.78, 0.0), (0.82, 0.08), (0.98, 0.9), (1.0, 1.0)],
        _ => &[(0.72, 0.0), (0.86, 0.25), (0.95, 0.65), (1.0, 1.0)],
    };
    let t = (r * 0.03).min(h * 0.1).min(0.0035);
    vessel(b, "pan", (r, h), shape, t, mat);
    if b.class == "frying_pan" {
        b.top("top", [0.0, 0.0, t], (r * 0.46, r * 0.46));
    }
    let thick = (z * 0.12).min(r * 0.07).min(0.009);
    long_grip(
        b,
        (r * 0.95, h * 0.75),
        ((y - r * if saucepan { 1.1 } else { 1.0 }).min(r * 3.4), z - thick),
        (thick * 1.6, thick),
        grip,
    );
    let plate = r * 0.09;
    b.block("rivets", [-plate, r * 0.93, h * 0.6], [plate, r + thick * 0.5, h * 0.9], STEEL);
    if saucepan && b.rng.chance(0.4) {
        let points = [
            [r * 0.3, -r * 0.9, h * 0.992],
            [-r * 0.3, -r * 0.9, h * 0.992],
            [0.0, -r * 1.1, h * 0.992],
            [0.0, -r * 0.92, h * 0.8],
        ];
        b.hull("lip", &points, mat);
    }
}

/// A square pan with ribs.
pub(super) fn grill_pan(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let hx = (x / 2.0).min(y * 0.34);
    let mat = b.choose(&[IRON, BLACK_METAL]);
    let (t, h) = ((z * 0.1).min(0.004), z * 0.75);
    tub(b, "pan", &[(0.0, hx * 0.9, hx * 0.9), (h, hx, hx)], 0.2, t, mat);
    let rib = (h * 0.15).min(0.004);
    for i in 0..9 {
        let at = hx * 0.8 * (i as f32 / 4.0 - 1.0);
        b.block("rib", [-hx * 0.8, at - rib * 0.5, t * 0.5], [hx * 0.8, at + rib * 0.5, t + rib], mat);
    }
    b.top("top", [0.0, 0.0, t + rib], (hx * 0.72, hx * 0.72));
    let thick = (z * 0.12).min(hx * 0.07).min(0.008);
    let grip = b.choose(&[mat, BLACK_PLASTIC, b.style.wood]);
    long_grip(b, (hx * 0.96, h * 0.75), ((y - hx).min(hx * 3.4), z - thick), (thick * 1.6, thick), grip);
}

/// Rectangular tins, dishes and pans with straight walls, some with grips or a lid.
pub(super) fn tin(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let (mat, round, foot): (MaterialId, f32, f32) = match b.class {
        "casserole_dish" => (
            b.choose(&[PORCELAIN, GLASS, RED_GLAZE, BLUE_GLAZE, STONEWARE, b.style.crockery]),
            b.choose(&[0.3, 1.0, 0.6]),
            0.9,
        ),
        "loaf_tin" => (b.choose(&[BLACK_METAL, ALUMINIUM, STEEL]), 0.15, 0.86),
        "gastronorm_pan" => (STEEL, 0.25, 0.92),
        "oven_tray" => (b.choose(&[BLACK_METAL, ALUMINIUM, STEEL]), 0.08, 0.96),
        _ => (b.choose(&[STEEL, BLACK_METAL, ALUMINIUM, BLUE_METAL]), 0.2, 0.92),
    };
    let t = (z * 0.12).min(if b.class == "casserole_dish" { 0.006 } else { 0.0025 });
    let grips = matches!(b.class, "casserole_dish" | "roasting_pan");
    let lidded = b.class == "casserole_dish";
    let h = if lidded { z * 0.72 } else { z };
    let (wx, wy) = (hx, if grips { hy * 0.88 } else { hy });
    let lip = (wx * 0.05).min(0.012);
    let sides = [
        (0.0, (wx - lip) * foot, (wy - lip) * foot),
        (h - t.min(h * 0.2), wx - lip, wy - lip),
        (h - t.min(h * 0.2) * 0.9, wx, wy),
        (h, wx, wy),
    ];
    tub(b, "tin", &sides, round, t.min(lip * 0.9), mat);
    let (ix, iy) = (wx * foot - lip - t, wy * foot - lip - t);
    let k = if round > 0.5 { 0.68 } else { 0.92 };
    let half = ((ix * k).max(1e-4), (iy * k).max(1e-4));
    let t = t.min(lip * 0.9);
    b.inside("inside", [0.0, 0.0, t], half, (h - t - 0.001).max(0.0));
    if !lidded {
        b.top("top", [0.0, 0.0, t], half);
    }
    if grips {
        // The ends of round dishes recede from their centre.
        let grip_wall = if round > 0.5 { wy - lip - wx * 0.075 } else { (wy - lip) * 0.97 };
        for side in [-1.0, 1.0] {
            loop_grip(b, side, (grip_wall, hy), h * 0.85, wx * 0.35, (h * 0.08).min(0.006), mat);
        }
    }
    if lidded {
        let cover = b.choose(&[mat, GLASS]);
        b.slide([0.0, 0.0, 1.0], z, |b| {
            let at = |z: f32, k: f32| crate::solid::rounded_ring(z, (wx * k, wy * k), round);
            let rings = [at(h + 0.0004, 0.99), at(h + z * 0.05, 0.99), at(h + z * 0.13, 0.75)];
            crate::solid::loft_columns(b, "lid", &rings, cover);
            turn(b, "knob", [0.0, 0.0, h + z * 0.12], ((wx * 0.25).min(0.03), z * 0.16), KNOB, cover);
        });
    }
}

/// Round tins and dishes for cakes, tarts and pies.
pub(super) fn round_tin(b: &mut Build<'_>) {
    let (x, y, h) = dims(b);
    let r = x.min(y) / 2.0;
    if b.class == "pie_dish" {
        let mat = b.choose(&[PORCELAIN, RED_GLAZE, BLUE_GLAZE, b.style.crockery, ALUMINIUM, GLASS]);
        let t = (h * 0.12).min(0.004);
        vessel(b, "dish", (r * 0.97, h), &[(0.78, 0.0), (0.82, 0.05), (0.97, 0.92), (1.0, 1.0)], t, mat);
        // The wavy rim of a tart dish.
        for i in 0..24 {
            b.at([0.0; 3], TAU * i as f32 / 24.0, |b| {
                let (low, high, h) = (r * 0.86, r * 0.99, h * 0.98);
                b.hull(
                    "wave",
                    &[
                        [low, -r * 0.05, h * 0.35],
                        [low, r * 0.05, h * 0.35],
                        [high, 0.0, h],
                        [high * 0.95, r * 0.1, h],
                        [high * 0.95, -r * 0.1, h],
                        [r * 0.95, 0.0, h],
                    ],
                    mat,
                );
            });
        }
        return;
    }
    let mat = b.choose(&[BLACK_METAL, ALUMINIUM, STEEL, RED_METAL]);
    let t = (r * 0.015).min(0.002);
    vessel(b, "tin", (r * 0.94, h), &[(0.99, 0.0), (0.99, 0.5), (0.99, 0.96), (1.0, 1.0)], t, mat);
    flat_ring(b, "base", (0.0, (h * 0.06).min(0.003)), (r * 0.5, r), mat);
    b.block("clip", [r * 0.92, -r * 0.12, h * 0.3], [r, r * 0.12, h * 0.75], STEEL);
    b.rod("lever", [r * 0.97, -r * 0.1, h * 0.5], [r * 0.97, r * 0.25, h * 0.5], (r * 0.02).min(h * 0.1), STEEL);
}

/// A muffin tray: a sheet with cups.
pub(super) fn muffin_tin(b: &mut Build<'_>) {
    let (x, y, h) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let mat = b.choose(&[BLACK_METAL, ALUMINIUM, STEEL]);
    let rows = if x / y > 0.85 { 3 } else { 2 };
    let columns = ((y / x * rows as f32).round() as usize).clamp(2, 5);
    let (px, py) = (x * 0.94 / rows as f32, y * 0.94 / columns as f32);
    let r = px.min(py) * 0.43;
    let t = (h * 0.05).min(0.0015);
    let bar = |b: &mut Build<'_>, low: [f32; 2], high: [f32; 2]| {
        b.block("sheet", [low[0], low[1], h - 2.0 * t], [high[0], high[1], h - t], mat);
    };
    // Strips between the cups cover them up to their rims.
    for i in 0..=rows {
        let at = -x * 0.47 + px * i as f32;
        bar(b, [(at - px * 0.24).max(-hx), -hy], [(at + px * 0.24).min(hx), hy]);
    }
    for i in 0..=columns {
        let at = -y * 0.47 + py * i as f32;
        for row in 0..rows {
            let from = -x * 0.47 + px * row as f32 + px * 0.24;
            bar(b, [from, (at - py * 0.24).max(-hy)], [from + px * 0.52, (at + py * 0.24).min(hy)]);
        }
    }
    for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
        let centre = [-x * 0.47 + px * (i as f32 + 0.5), -y * 0.47 + py * (j as f32 + 0.5), 0.0];
        let outside = [(r * 0.72, 0.0), (r * 0.97, h - t), (r, h)];
        b.lathe("cup", centre, &crate::solid::vessel_profile(&outside, t), mat);
        if (i, j) == (0, 0) {
            b.inside("cup_1", [centre[0], centre[1], t], (r * 0.45, r * 0.45), (h - t).max(0.0));
        }
    }
}

/// Stacked bamboo steamer baskets with a lid.
pub(super) fn steamer_basket(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let tiers = if z > 0.12 { 2 } else { 1 };
    let h = z * 0.78 / tiers as f32;
    let wall = r * 0.05;
    for i in 0..tiers {
        let low = h * i as f32;
        flat_ring(b, "wall", (low + 0.0003, low + h - 0.0003), (r * 0.93 - wall, r * 0.95), BAMBOO);
        flat_ring(b, "band", (low + h * 0.08, low + h * 0.35), (r * 0.94, r), BAMBOO);
        flat_ring(b, "band", (low + h * 0.65, low + h * 0.92), (r * 0.94, r), BAMBOO);
        for k in 0..7 {
            let at = r * 0.78 * (k as f32 / 3.0 - 1.0);
            let reach = ((r * 0.9).raised(2) - at * at).max(0.0).sqrt();
            b.block("slat", [-reach, at - r * 0.09, low + h * 0.1], [reach, at + r * 0.09, low + h * 0.16], PINE);
        }
        let name = format!("tier_{}", i + 1);
        b.inside(&name, [0.0, 0.0, low + h * 0.16], (r * 0.58, r * 0.58), h * 0.8);
    }
    let top = h * tiers as f32;
    b.slide([0.0, 0.0, 1.0], z * 0.8, |b| {
        flat_ring(b, "lid_band", (top + 0.0003, top + (z - top) * 0.5), (r * 0.85, r), BAMBOO);
        turn(
            b,
            "lid",
            [0.0, 0.0, top + (z - top) * 0.3],
            (r * 0.93, (z - top) * 0.6),
            &[(1.0, 0.0), (0.8, 0.6), (0.1, 1.0)],
            PINE,
        );
        let grip = arch([0.0, 0.0, top + (z - top) * 0.8], [0.0, r * 0.2, 0.0], [0.0, 0.0, (z - top) * 0.15]);
        planar_tube(b, "grip", &grip, (z - top) * 0.05, [1.0, 0.0, 0.0], BAMBOO);
    });
}

/// A cooling rack: a wire grid on four feet.
pub(super) fn cooling_rack(b: &mut Build<'_>) {
    let (x, y, h) = dims(b);
    let w = (h * 0.12).min(0.0022);
    let (hx, hy) = (x / 2.0 - w, y / 2.0 - w);
    let mat = b.choose(&[STEEL, CHROME, BLACK_METAL, COPPER]);
    let top = h - w;
    for side in [-1.0, 1.0] {
        b.rod("frame", [side * hx, -hy - w, top], [side * hx, hy + w, top], w, mat);
        b.rod("frame", [-hx, side * hy, top], [hx, side * hy, top], w, mat);
        for end in [-0.85, 0.85] {
            let (fx, fy) = (hx * end, hy * side * 0.98);
            b.rod("foot", [fx, fy, 0.0], [fx, fy, top], w, mat);
        }
    }
    let count = ((y / 0.022) as usize).clamp(8, 20);
    let thin = w * 0.7;
    for i in 1..count {
        let at = hy * (2.0 * i as f32 / count as f32 - 1.0);
        b.block("wire", [-hx, at - thin, top], [hx, at + thin, top + thin], mat);
    }
    b.rod("spine", [0.0, -hy, top - w], [0.0, hy, top - w], w, mat);
    b.top("top", [0.0, 0.0, h], (hx * 0.95, hy * 0.95));
}

/// A mortar with a pestle leaning in it.
pub(super) fn mortar_and_pestle(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let h = z * b.vary(0.5, 0.6);
    let mat = b.choose(&[GRANITE, MARBLE, PORCELAIN, b.style.wood, BLACK_GRANITE]);
    let shape = b.choose(&[
        [(0.6, 0.0), (0.62, 0.12), (0.9, 0.4), (1.0, 1.0)],
        [(0.8, 0.0), (0.9, 0.2), (0.98, 0.6), (1.0, 1.0)],
    ]);
    let outside: Vec<_> = shape.iter().map(|p| (p.0 * r, p.1 * h)).collect();
    b.lathe("mortar", [0.0; 3], &vessel_profile(&outside, r * 0.16), mat);
    let (thick, lean) = (r * 0.13, r * 0.5);
    let foot = [-r * 0.15, 0.0, r * 0.155];
    let way = [lean + r * 0.15, 0.0, z - thick - foot[2]];
    let at = |k: f32| [foot[0] + way[0] * k, 0.0, foot[2] + way[2] * k];
    let path = [
        (at(0.0), thick * 0.8, thick * 0.8),
        (at(0.05), thick * 1.3, thick * 1.3),
        (at(0.25), thick * 1.2, thick * 1.2),
        (at(0.4), thick * 0.75, thick * 0.75),
        (at(0.9), thick * 0.9, thick * 0.9),
        (at(1.0), thick * 0.5, thick * 0.5),
    ];
    sweep(b, "pestle", &path, [0.0, 1.0, 0.0], mat);
}
