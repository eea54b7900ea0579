//! Lamps on ceilings and walls.

use super::{bulb, shade, shade_at, shade_mat, stand_mat};
use crate::material::*;
use crate::solid::{Axis, Build, circle, collar, fit, half_dims, plate_with_hole};

/// A lamp flat against the ceiling: a glass bowl, a drum, a light panel, or spots.
pub(super) fn ceiling_lamp(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    let metal = stand_mat(b);
    let plate = h * 0.12;
    let design = b.rng.below(5);
    match if h > r && design == 2 { 1 } else { design } {
        0 => {
            b.cylinder("plate", [0.0, 0.0, h - plate], r * 0.6, plate, metal);
            let bowl = [(r * 0.1, 0.0), (r * 0.6, h * 0.12), (r * 0.9, h * 0.4), (r, h * 0.8), (r, h - plate * 0.9)];
            b.lathe("bowl", [0.0; 3], &bowl, WARM_BULB);
            b.cylinder("rim", [0.0, 0.0, h - plate * 1.2], r * 0.97, plate * 0.6, metal);
        }
        1 => {
            let cloth = shade_mat(b);
            shade(b, 0, [0.0; 3], (r, h * 0.86), cloth);
            b.cylinder("diffuser", [0.0, 0.0, h * 0.04], r * 0.95, h * 0.06, WARM_BULB);
            b.cylinder("plate", [0.0, 0.0, h - plate], r * 0.5, plate, metal);
            b.rod("stem", [0.0, 0.0, h * 0.08], [0.0, 0.0, h - plate * 0.5], r * 0.05, metal);
            ring_of_spokes(b, r * 0.98, h * 0.8, r * 0.02, metal);
        }
        2 => {
            let frame = b.choose(&[WHITE_METAL, BLACK_METAL, metal, b.style.wood]);
            b.rounded_block("case", [-x, -y, h * 0.35], [x, y, h], h * 0.15, frame);
            b.rounded_block("light", [-x * 0.92, -y * 0.92, 0.0], [x * 0.92, y * 0.92, h * 0.5], h * 0.12, COOL_BULB);
        }
        3 => {
            b.cylinder("plate", [0.0, 0.0, h - plate], r * 0.5, plate, metal);
            let count = b.rng.count(3, 4);
            for i in 0..count {
                let (s, c) = circle::part(i, count);
                let at = [c * r * 0.62, s * r * 0.62, h * 0.52];
                b.bar("arm", [c * r * 0.3, s * r * 0.3, h - plate], [at[0], at[1], at[2] + h * 0.2], h * 0.03, metal);
                let spot = r * 0.3;
                b.lathe("spot", [at[0], at[1], h * 0.1], &cup_down(spot, h * 0.62), metal);
                let middle = h * 0.1 + spot * 0.62;
                b.ball("bulb", [at[0], at[1], middle], (spot * 0.6).min(h * 0.3), WARM_BULB);
                b.rod("socket", [at[0], at[1], middle], [at[0], at[1], h * 0.72], spot * 0.33, metal);
            }
            b.cylinder("finial", [0.0, 0.0, 0.0], r * 0.06, h - plate + 0.001, metal);
        }
        _ => {
            let glass = r.min(h * 0.48);
            b.cylinder("plate", [0.0, 0.0, h - plate], r, plate, metal);
            b.lathe(
                "bowl",
                [0.0; 3],
                &[(glass * 0.2, 0.0), (glass * 0.75, h * 0.12), (glass, h * 0.4), (r * 0.9, h - plate * 0.9)],
                WARM_BULB,
            );
        }
    }
}

/// The lathe profile of a tube that is open at the bottom.
fn cup_down(r: f32, h: f32) -> [(f32, f32); 5] {
    let t = r * 0.08;
    [(r, 0.0), (r * 0.8, h), (r * 0.3, h), (r - t, t), (r, 0.0)]
}

/// Three rods from the axis to a shade.
fn ring_of_spokes(b: &mut Build<'_>, r: f32, z: f32, thick: f32, mat: MaterialId) {
    for i in 0..3 {
        let (s, c) = circle::part(i, 3);
        b.rod("spoke", [0.0, 0.0, z], [c * r, s * r, z], thick, mat);
    }
}

/// A pendant lamp: a shade on a cord from a ceiling rose; cloth, metal, glass or a globe.
pub(super) fn pendant_lamp(b: &mut Build<'_>) {
    let u = fit(b, [0.16, 0.16, 0.24]);
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    let metal = stand_mat(b);
    let rose = (0.03 * u).min(h * 0.15);
    b.lathe("rose", [0.0, 0.0, h - rose], &[(0.015 * u, 0.0), (0.05 * u, rose * 0.6), (0.055 * u, rose)], metal);
    let tall = (r * b.vary(0.8, 1.7)).min(h * 0.72);
    let cord =
        |b: &mut Build<'_>, z: f32| b.rod("cord", [0.0, 0.0, z], [0.0, 0.0, h - rose * 0.5], 0.004 * u, BLACK_FABRIC);
    let lamp = r * 0.26;
    match b.rng.below(5) {
        0 | 1 => {
            let design = b.rng.below(6);
            let mat = if b.rng.chance(0.5) {
                shade_mat(b)
            } else {
                b.choose(&[BLACK_METAL, WHITE_METAL, COPPER, BRASS, GREEN_METAL, WICKER])
            };
            shade(b, design, [0.0; 3], (r, tall), mat);
            b.lathe("cap", [0.0, 0.0, tall * 0.86], &[(r * 0.2, 0.0), (r * 0.12, tall * 0.2)], metal);
            ring_of_spokes(b, shade_at(design, 0.97, r), tall * 0.97, 0.004 * u, metal);
            bulb(b, [0.0, 0.0, tall * 0.45], lamp.min(tall * 0.25), true);
            b.rod("stem", [0.0, 0.0, tall * 0.45], [0.0, 0.0, tall], lamp * 0.4, metal);
            cord(b, tall);
        }
        2 => {
            let ball = r.min(h * 0.36);
            let light = b.choose(&[WARM_BULB, COOL_BULB]);
            b.ball("globe", [0.0, 0.0, ball], ball, light);
            b.cylinder("cap", [0.0, 0.0, ball * 1.9], ball * 0.3, ball * 0.25, metal);
            cord(b, ball * 2.0);
        }
        3 => {
            // A cage or glass around the bulb.
            let glass = b.choose(&[GLASS, BROWN_GLASS, FROSTED_GLASS]);
            shade(b, 5, [0.0; 3], (r, tall), glass);
            bulb(b, [0.0, 0.0, tall * 0.5], lamp, true);
            b.cylinder("cap", [0.0, 0.0, tall * 0.95], r * 0.32, tall * 0.12, metal);
            b.rod("stem", [0.0, 0.0, tall * 0.5], [0.0, 0.0, tall], lamp * 0.4, metal);
            cord(b, tall);
        }
        _ => {
            // A ring of light on three wires.
            let t = r * 0.1;
            let z = (h * 0.06).min(0.05 * u);
            collar(b, "ring", ([0.0; 3], [0.0, 0.0, z]), (r - t, r), metal);
            collar(b, "light", ([0.0, 0.0, z * 0.2], [0.0, 0.0, z * 0.8]), (r - t * 1.3, r - t * 0.9), WARM_BULB);
            for i in 0..3 {
                let (s, c) = circle::part(i, 3);
                let edge = r - t * 0.5;
                b.rod("wire", [c * edge, s * edge, z * 0.9], [0.0, 0.0, h - rose * 0.6], 0.0025 * u, metal);
            }
        }
    }
}

/// A chandelier on a chain: arms with candles or small shades around a stem.
pub(super) fn chandelier(b: &mut Build<'_>) {
    let u = fit(b, [0.48, 0.48, 0.4]);
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    let metal = b.choose(&[BRASS, GOLD, IRON, CHROME, b.style.metal]);
    let arms = b.rng.count(5, 8);
    let level = h * b.vary(0.22, 0.3);
    let top = h * 0.93;
    b.lathe("rose", [0.0, 0.0, top], &[(0.02 * u, 0.0), (0.06 * u, h - top)], metal);
    b.rod("chain", [0.0, 0.0, h * 0.5], [0.0, 0.0, top + 0.005 * u], 0.007 * u, metal);
    let body = [
        (0.012 * u, 0.0),
        (0.035 * u, h * 0.05),
        (0.02 * u, h * 0.12),
        (0.05 * u, h * 0.24),
        (0.02 * u, h * 0.34),
        (0.03 * u, h * 0.42),
        (0.012 * u, h * 0.52),
    ];
    b.lathe("stem", [0.0; 3], &body, metal);
    let candle = b.rng.chance(0.6);
    let cup_r = (r * 0.17).min(0.07 * u);
    let reach = r - cup_r;
    let mat = shade_mat(b);
    for i in 0..arms {
        let (s, c) = circle::part(i, arms);
        let at = |k: f32, z: f32| [c * reach * k, s * reach * k, z];
        b.pipe("arm", &[at(0.05, level), at(0.6, level * 0.6), at(1.0, level * 1.05)], 0.008 * u, metal);
        let z = level * 1.05;
        b.lathe("cup", at(1.0, z), &[(cup_r * 0.2, 0.0), (cup_r * 0.6, h * 0.02), (cup_r * 0.5, h * 0.025)], metal);
        let tall = h * 0.14;
        if candle {
            b.cylinder("candle", at(1.0, z + h * 0.015), cup_r * 0.28, tall * 0.6, WAX);
            b.lathe(
                "flame",
                at(1.0, z + h * 0.012 + tall * 0.6),
                &[(cup_r * 0.12, 0.0), (cup_r * 0.3, tall * 0.18), (0.0, tall * 0.6)],
                WARM_BULB,
            );
        } else {
            b.ball("bulb", at(1.0, z + tall * 0.45), cup_r * 0.4, WARM_BULB);
            b.at(at(1.0, 0.0), 0.0, |b| shade(b, 2, [0.0, 0.0, z + tall * 0.1], (cup_r, tall), mat));
            b.rod("pin", at(1.0, z), at(1.0, z + tall * 0.4), cup_r * 0.1, metal);
            let z = z + tall * 0.9;
            let (ox, oy) = (c * reach, s * reach);
            b.rod("pin", [ox - cup_r * 0.7, oy, z], [ox + cup_r * 0.7, oy, z], cup_r * 0.04, metal);
            b.rod("pin", [ox, oy, z - tall * 0.5], [ox, oy, z], cup_r * 0.08, metal);
        }
        if candle && arms < 7 {
            b.lathe(
                "drop",
                at(1.0, level * 0.5),
                &[(0.0, 0.0), (cup_r * 0.2, level * 0.2), (0.0, level * 0.56)],
                GLASS,
            );
        }
    }
}

/// A wall lamp: a shade on an arm, a box that shines up and down, or a half bowl.
pub(super) fn wall_lamp(b: &mut Build<'_>) {
    let u = fit(b, [0.064, 0.08, 0.08]);
    let (x, y, h) = half_dims(b);
    let metal = stand_mat(b);
    let plate = (0.015 * u).min(x * 0.3);
    let design = b.rng.below(4);
    match if h < y * 2.4 && design == 1 { 2 } else { design } {
        0 => {
            let r = y.min(x * 0.8);
            let z = h * 0.36;
            let base = z.min(0.05 * u).min(h * 0.2);
            b.rod("plate", [-x, 0.0, base], [-x + plate, 0.0, base], base, metal);
            let cx = x - r;
            b.pipe("arm", &[[-x + plate, 0.0, base], [cx, 0.0, base], [cx, 0.0, z]], 0.006 * u, metal);
            let mat = shade_mat(b);
            let design = b.choose(&[0, 2, 2, 3]);
            shade(b, design, [cx, 0.0, h * 0.3], (r, h * 0.7), mat);
            bulb(b, [cx, 0.0, h * 0.58], r * 0.34, false);
            b.rod("arm", [cx, 0.0, z - 0.001 * u], [cx, 0.0, h * 0.58], 0.005 * u, metal);
            b.rod("cross", [cx - r * 0.6, 0.0, h * 0.55], [cx + r * 0.6, 0.0, h * 0.55], 0.003 * u, metal);
            let edge = shade_at(design, 0.26 / 0.7, r);
            b.rod("cross", [cx, -edge, h * 0.56], [cx, edge, h * 0.56], 0.003 * u, metal);
        }
        1 => {
            let t = (0.008 * u).min(y * 0.2);
            b.block("plate", [-x, -y * 0.5, h * 0.3], [-x + plate, y * 0.5, h * 0.7], metal);
            let (low, high) = ([-x + plate * 0.9, -y, 0.0], [x, y, h]);
            plate_with_hole(b, "case", Axis::Z, (low, high), ((low[0] + t, -y + t), (x - t, y - t)), metal);
            for z in [h * 0.12, h * 0.8] {
                b.block("light", [low[0] + t, -y + t, z], [x - t, y - t, z + h * 0.08], WARM_BULB);
            }
        }
        2 => {
            let half: Vec<(f32, f32)> = [(0.0, 1.0), (0.38, 0.92), (0.71, 0.71), (0.92, 0.38), (1.0, 0.0)]
                .iter()
                .map(|p| (-x + 2.0 * x * p.0, y * p.1))
                .collect();
            let mirrored = half.iter().rev().skip(1).map(|p| (p.0, -p.1));
            let outline: Vec<(f32, f32)> = half.iter().copied().chain(mirrored).collect();
            b.prism("bowl", Axis::Z, [0.0; 3], &outline, h * 0.92, FROSTED_GLASS);
            let smaller: Vec<(f32, f32)> = outline.iter().map(|p| ((p.0 + x) * 0.9 - x, p.1 * 0.9)).collect();
            b.prism("light", Axis::Z, [0.0, 0.0, h * 0.91], &smaller, h * 0.09, WARM_BULB);
        }
        _ => {
            let r = y.min(h * 0.45).min(x * 0.8);
            let middle = h - r;
            b.rod("plate", [-x, 0.0, h * 0.25], [-x + plate, 0.0, h * 0.25], (h * 0.25).min(y), metal);
            b.bar("arm", [-x + plate, 0.0, h * 0.25], [x - r, 0.0, h * 0.25], 0.006 * u, metal);
            b.ball("globe", [x - r, 0.0, middle], r, WARM_BULB);
            b.cylinder("cup", [x - r, 0.0, h * 0.22], r * 0.35, (middle - r * 0.85 - h * 0.22).max(0.004 * u), metal);
        }
    }
}

/// Rotating cylindrical spots on a rail, or one on a round plate.
pub(super) fn spotlight(b: &mut Build<'_>) {
    let u = fit(b, [0.064, 0.064, 0.064]);
    let (x, y, h) = half_dims(b);
    let metal = b.choose(&[WHITE_METAL, BLACK_METAL, STEEL, BRASS]);
    let rail = h * 0.18;
    let count = ((2.0 * y) / 0.22).floor().clamp(1.0, 5.0) as usize;
    if count == 1 {
        let r = x.min(y) * 0.8;
        b.cylinder("plate", [0.0, 0.0, h - rail], r, rail, metal);
    } else {
        b.rounded_block("rail", [-x * 0.3, -y, h - rail], [x * 0.3, y, h], rail * 0.3, metal);
    }
    let step = 2.0 * y / count as f32;
    let r = (h * 0.26).min(x * 0.42).min(step * 0.42);
    let long = b.rng.chance(0.6);
    for i in 0..count {
        let cy = -y + step * (i as f32 + 0.5);
        let z = r * 1.15;
        b.rod("neck", [0.0, cy, z], [0.0, cy, h - rail * 0.9], 0.008 * u.min(r / 0.02), metal);
        let way = if i % 2 == 0 { 1.0 } else { 0.6 };
        let length = if long { x * 0.95 } else { x * 0.7 };
        let (from, to) = ([-length * 0.8, cy, z + r * 0.3 * way], [length, cy, z - r * 0.1]);
        b.lathe_along(
            "head",
            from,
            to,
            &[
                (r * 0.6, 0.0),
                (r, length * 0.4),
                (r, length * 1.62),
                (r * 0.85, length * 1.62),
                (r * 0.85, length * 1.5),
            ],
            metal,
        );
        b.rod("bulb", [length * 0.4, cy, z], [length * 0.72, cy, z - r * 0.05], r * 0.8, WARM_BULB);
    }
}

/// A mirror lamp: a light bar, or round lamps in a row.
pub(super) fn mirror_light(b: &mut Build<'_>) {
    let u = fit(b, [0.048, 0.24, 0.032]);
    let (x, y, h) = half_dims(b);
    let metal = b.style.tap;
    let z = h / 2.0;
    let r = (h * 0.46).min(x * 0.55);
    b.rounded_block(
        "plate",
        [-x, -y * 0.3, h * 0.1],
        [-x + (0.012 * u).min(x * 0.4), y * 0.3, h * 0.9],
        0.003 * u,
        metal,
    );
    let cx = x - r;
    if b.rng.chance(0.55) {
        for side in [-1.0, 1.0] {
            let cy = side * y * 0.2;
            b.rod("arm", [-x + 0.004 * u, cy, z], [cx, cy, z], (r * 0.3).min(0.006 * u), metal);
            b.rod("cap", [cx, side * y * 0.94, z], [cx, side * y, z], r, metal);
        }
        b.rod("light", [cx, -y * 0.95, z], [cx, y * 0.95, z], r * 0.9, COOL_BULB);
    } else {
        b.rounded_block("bar", [-x, -y, z - h * 0.2], [-x * 0.2, y, z + h * 0.2], h * 0.08, metal);
        let count = b.rng.count(3, 5);
        for i in 0..count {
            let cy = y * (2.0 * (i as f32 + 0.5) / count as f32 - 1.0);
            let size = r.min(y / count as f32 * 0.8);
            b.ball("bulb", [x - size, cy, z], size, WARM_BULB);
            b.rod("socket", [-x * 0.3, cy, z], [(x - size * 1.8).max(-x * 0.25), cy, z], size * 0.5, metal);
        }
    }
}

/// A flat light bar with a switch.
pub(super) fn under_cabinet_light(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let case_mat = b.choose(&[WHITE_PLASTIC, ALUMINIUM, BLACK_PLASTIC]);
    let round = b.rng.chance(0.3) && x > h;
    if round {
        let count = (y / 0.15).clamp(2.0, 6.0) as usize;
        let r = x.min(y / count as f32 * 0.9);
        for i in 0..count {
            let cy = (y - r) * (2.0 * i as f32 / (count - 1) as f32 - 1.0);
            b.cylinder("puck", [0.0, cy, h * 0.25], r, h * 0.75, case_mat);
            b.cylinder("light", [0.0, cy, 0.0], r * 0.8, h * 0.4, WARM_BULB);
        }
        b.block("cable", [-x * 0.12, -y + r, h * 0.7], [x * 0.12, y - r, h * 0.85], WHITE_PLASTIC);
    } else {
        b.block("case", [-x, -y, h * 0.35], [x, y, h], case_mat);
        b.rounded_block("light", [-x * 0.85, -y * 0.94, 0.0], [x * 0.85, y * 0.94, h * 0.5], h * 0.1, COOL_BULB);
        b.block("switch", [x * 0.2, y * 0.955, h * 0.25], [x * 0.6, y * 0.985, h * 0.36], SIGNAL_RED);
    }
}
