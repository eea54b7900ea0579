//! Pots and boxes for plants.

use std::f32::consts::TAU;

use crate::material::*;
use crate::solid::{Build, CORNERS, at_least, blob, polar, spaced, tapered_tub};

const POTS: &[MaterialId] =
    &[POTTERY, POTTERY, BLUE_GLAZE, GREEN_GLAZE, STONEWARE, CONCRETE, WHITE_PLASTIC, BLACK_GLAZE, BROWN_PLASTIC];

/// A plant pot, round or square, with or without a saucer; contains only soil.
pub(super) fn flower_pot(b: &mut Build<'_>) {
    at_least(b, [0.05, 0.05, 0.05]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let mat = b.one_of(POTS);
    let t = (r * 0.09).clamp(0.003, 0.012);
    let saucer = b.rng.chance(0.4);
    let low = if saucer { t } else { 0.0 };
    let top = if saucer { r * 0.94 } else { r };
    let foot = top * b.vary(0.58, 0.8);
    let soil = low + (h - low) * b.vary(0.2, 0.8);
    if saucer {
        let rim = h * 0.12;
        b.lathe("saucer", [0.0; 3], &[(r * 0.8, 0.0), (r, rim), (r - t, rim), (r * 0.78 - t, t), (0.0, t)], mat);
    }
    let tall = h - low;
    let inner = match b.rng.below(4) {
        0 => {
            // A collar below the rim.
            let collar = tall * b.vary(0.15, 0.25);
            let neck = top * 0.93;
            let profile = [
                (foot, 0.0),
                (neck, tall - collar),
                (top, tall - collar),
                (top, tall),
                (top - t, tall),
                (neck - t, tall - collar),
                (foot - t, t),
                (0.0, t),
            ];
            b.lathe("pot", [0.0, 0.0, low], &profile, mat);
            foot - t
        }
        1 => {
            let belly = top * 0.98;
            let profile = [
                (foot, 0.0),
                (belly, tall * 0.4),
                (top, tall * 0.7),
                (top * 0.85, tall * 0.93),
                (top * 0.92, tall),
                (top * 0.92 - t, tall),
                (top * 0.85 - t, tall * 0.93),
                (belly - t, tall * 0.4),
                (foot - t, t),
                (0.0, t),
            ];
            b.lathe("pot", [0.0, 0.0, low], &profile, mat);
            foot - t
        }
        2 if !saucer => {
            let half = b.size.x.min(b.size.y) / 2.0;
            tapered_tub(b, "pot", [0.0; 3], (half * foot / top, half * foot / top), (half, half), h, t, mat);
            foot - t
        }
        _ => {
            b.lathe("pot", [0.0, 0.0, low], &[(foot, 0.0), (top, tall), (top - t, tall), (foot - t, t), (0.0, t)], mat);
            foot - t
        }
    };
    let level = soil.max(low + t + 0.004);
    b.cylinder("soil", [0.0, 0.0, low + t * 0.5], inner * 0.995, level - low - t * 0.5, SOIL);
    b.inside("slot", [0.0, 0.0, level], (inner * 0.66, inner * 0.66), h - level);
}

/// A plant box: boards, concrete or plastic, with or without feet, with soil.
pub(super) fn planter(b: &mut Build<'_>) {
    at_least(b, [0.09, 0.2, 0.08]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let boards = h > 0.3 && b.rng.chance(0.6);
    let mat = b.one_of(if boards {
        &[PINE, OAK, TEAK, GREY_OAK, WALNUT]
    } else {
        &[CONCRETE, POTTERY, RUST, WHITE_PLASTIC, ANTHRACITE, GREEN_PLASTIC, GALVANISED]
    });
    let legs = h > 0.5 && b.rng.chance(0.4);
    let t = if boards { 0.022 } else { 0.012 };
    let low = if legs { h * b.vary(0.35, 0.55) } else { 0.0 };
    let (ix, iy);
    if boards {
        let post = 0.03_f32.min(x * 0.3);
        for (sx, sy) in CORNERS {
            let (cx, cy) = (sx * (x - post), sy * (y - post));
            b.block("post", [cx - post, cy - post, 0.0], [cx + post, cy + post, h], mat);
        }
        let rows = ((h - low) / 0.12).clamp(2.0, 6.0) as usize;
        let pitch = (h - low - 0.015) / rows as f32;
        for z in spaced(rows, low + pitch * 0.5, h - 0.015 - pitch * 0.5) {
            let half = pitch * 0.47;
            for side in [-1.0, 1.0] {
                b.block(
                    "board",
                    [side * (x - 0.012) - t / 2.0 + 0.0015, -y + post, z - half],
                    [side * (x - 0.012) + t / 2.0 - 0.0015, y - post, z + half],
                    mat,
                );
                b.block(
                    "board",
                    [-x + post, side * (y - 0.012) - t / 2.0 + 0.0015, z - half],
                    [x - post, side * (y - 0.012) + t / 2.0 - 0.0015, z + half],
                    mat,
                );
            }
        }
        b.block("bottom", [-x + 0.015, -y + 0.015, low + 0.003], [x - 0.015, y - 0.015, low + 0.02], mat);
        (ix, iy) = (x - 0.012 - t / 2.0, y - 0.012 - t / 2.0);
        let (sx, sy) = (x - 2.0 * post, y - 2.0 * post);
        let level = low + (h - low) * b.vary(0.6, 0.85);
        b.block("soil", [-ix - 0.003, -iy - 0.003, low + 0.019], [ix + 0.003, iy + 0.003, level], SOIL);
        b.inside("compartment", [0.0, 0.0, level], ((sx - 0.005).max(0.005), (sy - 0.005).max(0.005)), h - level);
    } else {
        let lean = b.vary(0.8, 1.0);
        if legs {
            for (sx, sy) in CORNERS {
                let (cx, cy) = (sx * (x * lean - 0.02), sy * (y * lean - 0.02));
                b.block("leg", [cx - 0.018, cy - 0.018, 0.0], [cx + 0.018, cy + 0.018, low + 0.004], IRON);
            }
        }
        tapered_tub(b, "box", [0.0, 0.0, low], (x * lean, y * lean), (x, y), h - low, t, mat);
        (ix, iy) = (x * lean - t, y * lean - t);
        let level = low + t + (h - low) * b.vary(0.4, 0.7);
        b.block("soil", [-ix - 0.001, -iy - 0.001, low + t * 0.5], [ix + 0.001, iy + 0.001, level], SOIL);
        b.inside("compartment", [0.0, 0.0, level], ((ix - 0.005).max(0.005), (iy - 0.005).max(0.005)), h - level);
    }
}

/// A basket on chains, planted at its rim.
pub(super) fn hanging_basket(b: &mut Build<'_>) {
    at_least(b, [0.1, 0.1, 0.1]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let mat = b.choose(&[WICKER, IRON, POTTERY, JUTE, GREEN_PLASTIC]);
    let deep = (h * 0.42).min(r * 1.1);
    let t = 0.006;
    let profile = [
        (r * 0.4, 0.0),
        (r * 0.8, deep * 0.5),
        (r * 0.9, deep),
        (r * 0.9 - t, deep),
        (r * 0.8 - t, deep * 0.5),
        (r * 0.4, t),
        (0.0, t),
    ];
    b.lathe("basket", [0.0; 3], &profile, mat);
    let level = deep * 0.7;
    b.lathe("soil", [0.0; 3], &[(r * 0.4, t * 0.5), (r * 0.78, deep * 0.5), (r * 0.82, level)], SOIL);
    let ring = h - 0.03;
    for i in 0..3 {
        let (px, py) = polar(TAU * i as f32 / 3.0, r * 0.88);
        b.rod("chain", [px, py, deep - 0.005], [0.0, 0.0, ring], 0.002, IRON);
    }
    b.bar("hook", [0.0, 0.0, ring - 0.01], [0.0, 0.0, h - 0.006], 0.005, IRON);
    let (petal, count) =
        (b.choose(&[PETAL_RED, PETAL_WHITE, PETAL_PINK, PETAL_BLUE, PETAL_YELLOW]), b.rng.count(6, 10));
    for i in 0..count {
        let angle = TAU * (i as f32 + 0.3) / count as f32;
        let ((px, py), size) = (polar(angle, r * 0.86), r * 0.13);
        let points = blob(b, [px, py, deep * 0.95], [size, size, size * 1.2], 12, 0.3);
        b.hull("leaves", &points, LEAF);
        let points = blob(b, [px, py, deep * 0.95 + size], [size * 0.6; 3], 10, 0.1);
        b.hull("flower", &points, petal);
    }
    b.inside("slot", [0.0, 0.0, level], (r * 0.35, r * 0.35), deep * 0.4);
}
