//! Radiators, heaters, boilers, fireplaces.

use crate::material::*;
use crate::object::cooker::fitting::*;
use crate::object::joinery::{Swing, gapped, swing};
use crate::solid::{Axis, Build, case, fit, floor_of, half_dims, plate_with_border};

/// A flat panel with ribs, columns of cast iron, or a smooth plate, on the wall.
pub(super) fn radiator(b: &mut Build<'_>) {
    let u = fit(b, [0.056, 0.4, 0.352]);
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[WHITE_METAL, WHITE_METAL, WHITE_METAL, SILVER_METAL, BLACK_METAL]);
    let foot = 0.06 * u;
    let side = y - 0.035 * u;
    let pipe = [0.0075 * u, -side];
    for dy in [0.0, -0.014 * u] {
        b.rod("pipe", [pipe[0], pipe[1] + dy, 0.0], [pipe[0], pipe[1] + dy, h * 0.3], 0.008 * u, WHITE_METAL);
    }
    let valve = (0.02 * u).min(x * 0.8);
    b.rod("valve", [pipe[0], -side + 0.01 * u, h * 0.3], [pipe[0], -y, h * 0.3], valve, WHITE_PLASTIC);
    match b.rng.below(3) {
        0 => columns(b, side, foot, u, mat),
        1 => {
            let (back, front) = (-x + 0.02 * u, x - 0.006 * u);
            b.block("panel", [back, -side, foot], [front, side, h - 0.012 * u], mat);
            let count = (side / 0.025).clamp(6.0, 36.0) as usize;
            let step = 2.0 * side / count as f32;
            for i in 0..count {
                let cy = -side + step * (i as f32 + 0.5);
                b.block(
                    "rib",
                    [front - 0.001 * u, cy - step * 0.28, foot + 0.02 * u],
                    [x, cy + step * 0.28, h - 0.03 * u],
                    mat,
                );
            }
            top_grille(b, (back, x), side, u, mat);
        }
        _ => {
            let back = -x + 0.02 * u;
            b.rounded_block("panel", [back, -side, foot], [x, side, h - 0.01 * u], 0.012 * u, mat);
            for z in [0.2, 0.4, 0.6, 0.8] {
                b.block(
                    "groove",
                    [x - 0.002 * u, -side * 0.98, h * z],
                    [x + 0.0005 * u, side * 0.98, h * z + 0.004 * u],
                    GREY_PLASTIC,
                );
            }
            top_grille(b, (back, x), side, u, mat);
        }
    }
    for cy in [-side * 0.8, side * 0.8] {
        b.block("bracket", [-x, cy - 0.015 * u, foot + 0.03 * u], [-x + 0.025 * u, cy + 0.015 * u, h * 0.85], mat);
    }
    b.top("top", [0.01 * u, 0.0, h], ((x - 0.014 * u).max(x * 0.3), side * 0.96));
}

/// The cover on a panel radiator.
fn top_grille(b: &mut Build<'_>, (back, front): (f32, f32), side: f32, u: f32, mat: MaterialId) {
    let h = b.size.z;
    b.block("cover", [back, -side, h - 0.0125 * u], [front - 0.001 * u, side, h], mat);
}

/// Rounded sections side by side.
fn columns(b: &mut Build<'_>, side: f32, foot: f32, u: f32, mat: MaterialId) {
    let (x, h) = (b.size.x / 2.0, b.size.z);
    let count = (side / 0.028).clamp(5.0, 20.0) as usize;
    let step = 2.0 * side / count as f32;
    let back = -x + 0.015 * u;
    let r = (step * 0.4).min((x - back) * 0.3);
    let deep = (x - back) / 2.0 - r;
    let middle = f32::midpoint(back, x);
    for i in 0..count {
        let cy = -side + step * (i as f32 + 0.5);
        for cx in [middle - deep, middle + deep] {
            b.rod("column", [cx, cy, foot + 0.02 * u], [cx, cy, h - 0.02 * u], r * 0.8, mat);
        }
        for (z0, z1) in [(foot, foot + 0.04 * u), (h - 0.04 * u, h)] {
            b.block("head", [back, cy - r, z0], [x, cy + r, z1], mat);
        }
    }
    b.block("rail", [back - 0.002 * u, -side, foot + 0.02 * u], [back + 0.006 * u, side, foot + 0.036 * u], mat);
    for z in [foot + 0.02 * u, h - 0.02 * u] {
        b.rod("tube", [middle, -side, z], [middle, side, z], (r * 0.8).min(0.012 * u), mat);
    }
}

/// A small heater: oil-filled ribs on wheels, a fan in a box, or glowing bars.
pub(super) fn heater(b: &mut Build<'_>) {
    let u = fit(b, [0.096, 0.176, 0.192]);
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[WHITE_METAL, BLACK_METAL, SILVER_METAL]);
    let foot = h * 0.1;
    match b.rng.below(3) {
        0 => {
            let count = (y / 0.035).clamp(3.0, 9.0) as usize;
            let end = y - y * 0.3;
            let step = (end + y) / count as f32;
            for i in 0..count {
                let cy = -y + step * i as f32;
                b.rounded_block(
                    "rib",
                    [-x * 0.9, cy + step * 0.14, foot],
                    [x * 0.9, cy + step * 0.86, h - 0.01 * u],
                    step * 0.3,
                    mat,
                );
            }
            b.rod("tube", [0.0, -y + step * 0.2, h * 0.8], [0.0, end, h * 0.8], x * 0.15, mat);
            b.rod("tube", [0.0, -y + step * 0.2, h * 0.25], [0.0, end, h * 0.25], x * 0.15, mat);
            b.rounded_block("controls", [-x * 0.95, end - 0.01 * u, foot], [x * 0.95, y, h], 0.015 * u, mat);
            for cy in [-y * 0.7, y * 0.6] {
                b.block("axle", [-x, cy - 0.012 * u, foot * 0.5], [x, cy + 0.012 * u, foot + 0.01 * u], BLACK_PLASTIC);
                for side in [-1.0, 1.0] {
                    let r = (foot * 0.5).min(x * 0.3);
                    let cx = side * (x - r);
                    b.rod("wheel", [cx, cy - 0.02 * u, r], [cx, cy + 0.02 * u, r], r, BLACK_PLASTIC);
                }
            }
            for z in [0.5, 0.72] {
                b.rod("knob", [0.0, y - 0.004 * u, h * z], [0.0, y - 0.0005 * u, h * z], x * 0.3, RED_PLASTIC);
            }
        }
        1 => {
            b.rounded_block("case", [-x, -y, foot * 0.5], [x * 0.9, y, h], 0.02 * u, mat);
            for side in [-0.7, 0.7] {
                b.block("foot", [-x, y * side - 0.02 * u, 0.0], [x, y * side + 0.02 * u, foot * 0.6], BLACK_PLASTIC);
            }
            let face = x * 0.9;
            b.block(
                "grille",
                [face - 0.002 * u, -y * 0.82, h * 0.2],
                [face + 0.001 * u, y * 0.82, h * 0.75],
                BLACK_PLASTIC,
            );
            for i in 0..8 {
                let z = h * (0.22 + 0.066 * i as f32);
                b.block("slat", [face, -y * 0.82, z], [x, y * 0.82, z + h * 0.02], mat);
            }
            knobs(b, [face, 0.0, h * 0.87], y, 2, (h * 0.05).min(x * 0.1), (BLACK_PLASTIC, WHITE));
        }
        _ => {
            // Quartz bars in front of a reflector.
            let wall = 0.02 * u;
            b.block("base", [-x, -y * 0.7, 0.0], [x, y * 0.7, foot], mat);
            case(b, [-x, -y, foot - 0.001 * u], [x * 0.5, y, h], wall, mat);
            b.block("reflector", [-x + wall, -y + wall, foot + wall], [-x + wall * 1.5, y - wall, h - wall], CHROME);
            for i in 0..2 {
                let z = foot + (h - foot) * (0.35 + 0.3 * i as f32);
                b.rod("bar", [0.0, -y + wall * 0.8, z], [0.0, y - wall * 0.8, z], 0.012 * u, FLAME);
            }
            for i in 0..7 {
                let z = foot + wall + (h - foot - 2.0 * wall) * (i as f32 + 0.5) / 7.0;
                b.rod("guard", [x * 0.48, -y + wall * 0.5, z], [x * 0.48, y - wall * 0.5, z], 0.003 * u, CHROME);
            }
        }
    }
}

/// A white case on the wall with pipes below and a gauge.
pub(super) fn boiler(b: &mut Build<'_>) {
    let u = fit(b, [0.224, 0.32, 0.512]);
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[WHITE_METAL, WHITE_METAL, SILVER_METAL]);
    let low = 0.12 * u;
    let board = low + (h - low) * 0.16;
    b.rounded_block("case", [-x, -y, board], [x, y, h - 0.08 * u], 0.02 * u, mat);
    b.rounded_block("controls", [-x, -y, low], [x - 0.026 * u, y, board + 0.004 * u], 0.015 * u, GREY_PLASTIC);
    b.cylinder("flue", [-x * 0.2, 0.0, h - 0.09 * u], 0.05 * u, 0.09 * u, WHITE_METAL);
    let z = f32::midpoint(low, board);
    display(b, x - 0.0265 * u, (-y * 0.15, z - 0.02 * u), (y * 0.15, z + 0.02 * u), LED);
    knobs(b, [x - 0.027 * u, -y * 0.55, z], y * 0.5, 2, ((board - low) * 0.24).min(0.025 * u), (BLACK_PLASTIC, WHITE));
    let r = (board - low) * 0.3;
    b.rod("gauge", [x - 0.03 * u, y * 0.6, z], [x - 0.024 * u, y * 0.6, z], r, WHITE_PAPER);
    for i in 0..5 {
        let cy = y * (-0.7 + 0.35 * i as f32);
        let (r, mat) = if i == 2 { (0.011 * u, YELLOW_PLASTIC) } else { (0.009 * u, COPPER) };
        b.cylinder("pipe", [-x * 0.3, cy, 0.0], r, low + 0.01 * u, mat);
    }
}

/// A round tank on the wall or the floor, or a flat one.
pub(super) fn water_heater(b: &mut Build<'_>) {
    let u = fit(b, [0.304, 0.304, 0.4]);
    let (x, y, h) = half_dims(b);
    let r = (x - 0.006 * u).min(y);
    let (low, top) = (0.08 * u, h - 0.05 * u);
    let tall = top - low;
    let bend = (0.06 * u).min(tall * 0.2);
    let tank = [
        (r * 0.7, 0.0),
        (r * 0.97, bend * 0.5),
        (r, bend),
        (r, tall - bend),
        (r * 0.94, tall - bend * 0.5),
        (r * 0.5, tall),
    ];
    b.lathe("tank", [0.0, 0.0, low], &tank, WHITE_METAL);
    if h > 1.0 {
        for (c, s) in [(0.6, 0.0), (-0.3, 0.52), (-0.3, -0.52)] {
            b.cylinder("foot", [c * r, s * r, 0.0], 0.025 * u, low + bend * 0.5, BLACK_PLASTIC);
        }
    } else {
        b.cylinder("cap", [0.0; 3], r * 0.6, low + 0.004 * u, GREY_PLASTIC);
    }
    for (cy, mat) in [(-0.3, BLUE_PLASTIC), (0.3, RED_PLASTIC)] {
        b.cylinder("pipe", [0.0, cy * r, top - bend * 0.4], 0.011 * u, h - top + bend * 0.4, COPPER);
        b.cylinder("mark", [0.0, cy * r, top + 0.012 * u], 0.016 * u, 0.015 * u, mat);
    }
    let z = low + tall * 0.28;
    b.lathe_along(
        "gauge",
        [r * 0.99, 0.0, z],
        [r + 1.0, 0.0, z],
        &[(r * 0.14, 0.0), (r * 0.14, (x - r * 0.99).min(0.02 * u))],
        WHITE_PLASTIC,
    );
    b.block(
        "badge",
        [r * 0.98, -r * 0.2, low + tall * 0.7],
        [r * 1.0 + 0.0005 * u, r * 0.2, low + tall * 0.74],
        GREY_PLASTIC,
    );
}

/// A hearth with logs and flames behind a glass door, under a mantel; or an iron stove.
pub(super) fn fireplace(b: &mut Build<'_>) {
    let u = fit(b, [0.32, 0.4, 0.56]);
    let (x, y, h) = half_dims(b);
    if y < 0.36 || b.rng.chance(0.25) {
        return iron_stove(b, u);
    }
    let stone = b.choose(&[MARBLE, BRICK, SANDSTONE, PLASTER, GRANITE, b.style.wood]);
    let (hearth, shelf) = (0.06 * u, 0.06 * u);
    let front = x - 0.06 * u;
    let (side, lintel) = (y * b.vary(0.6, 0.68), h * b.vary(0.62, 0.7));
    b.block("hearth", [-x, -y, 0.0], [x, y, hearth], stone);
    for s in [-1.0_f32, 1.0] {
        let (a, c) = (s * y * 0.96, s * side);
        b.block("pillar", [-x, a.min(c), hearth], [front, a.max(c), lintel], stone);
    }
    b.block("lintel", [-x, -y * 0.96, lintel], [front, y * 0.96, h - shelf], stone);
    b.rounded_block("mantel", [-x, -y, h - shelf], [x, y, h], 0.012 * u, stone);
    b.top("mantel", [0.0, 0.0, h], (x - 0.02 * u, y - 0.02 * u));
    let back = -x + 0.05 * u;
    b.block("back", [-x, -side, hearth], [back, side, lintel], BRICK);
    hearth_fire(b, ([back, -side, hearth], [front - 0.04 * u, side, lintel]), u);
    glass_front(b, (front - 0.03 * u, front - 0.012 * u), (-side, hearth), (side, lintel));
}

/// Logs on a grate with flames, and the bed they lie in.
fn hearth_fire(b: &mut Build<'_>, (low, high): ([f32; 3], [f32; 3]), u: f32) {
    let (cx, w) = (f32::midpoint(low[0], high[0]) - 0.03 * u, (high[1] - low[1]) * 0.3);
    let cy = f32::midpoint(low[1], high[1]);
    let r = (0.035 * u).min((high[0] - low[0]) * 0.12);
    let z = low[2] + r;
    for k in [-1.3, 1.3] {
        b.rod("log", [cx + k * r, cy - w, z], [cx + k * r, cy + w, z], r, BARK);
    }
    b.rod("log", [cx, cy - w * 0.8, z + r * 1.3], [cx, cy + w * 0.8, z + r * 1.3], r * 0.9, BARK);
    for i in 0..3 {
        let fy = cy + w * 0.5 * (i as f32 - 1.0);
        let tall = (high[2] - low[2]) * if i == 1 { 0.4 } else { 0.28 };
        let flame = [(r * 0.4, 0.0), (r * 0.8, tall * 0.25), (r * 0.4, tall * 0.6), (0.0, tall)];
        b.lathe("flame", [cx, fy, z + r * 1.8], &flame, FLAME);
    }
    let free = [high[0] - 0.1 * u, high[1] - 0.02 * u];
    let from = cx + r * 2.5;
    if free[0] + 0.09 * u > from {
        floor_of(b, "compartment_1", [from, low[1] + 0.02 * u, low[2]], [high[0], free[1], high[2]]);
    }
}

/// A framed pane in front of a fire, hinged at the left.
fn glass_front(b: &mut Build<'_>, (x0, x1): (f32, f32), low: (f32, f32), high: (f32, f32)) {
    let (dl, dh) = gapped([x0, low.0, low.1], [x1, high.0, high.1], 0.002);
    let w = (dh[1] - dl[1]).min(dh[2] - dl[2]) * 0.07;
    swing(b, Swing::Left, dl, dh, 1.5, |b| {
        plate_with_border(b, "door", dl, dh, w, IRON);
        let t = (x1 - x0) * 0.2;
        b.block("pane", [x0 + t, dl[1] + w, dl[2] + w], [x1 - t, dh[1] - w, dh[2] - w], GLASS);
        let z = f32::midpoint(dl[2], dh[2]);
        b.block(
            "latch",
            [x1 - 0.001, dl[1] + w * 0.2, z - w * 1.2],
            [x1 + w * 0.5, dl[1] + w * 0.8, z + w * 1.2],
            BRASS,
        );
    });
}

/// An iron stove on feet with a flue behind.
fn iron_stove(b: &mut Build<'_>, u: f32) {
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[IRON, BLACK_METAL, GREEN_METAL]);
    let (foot, wall, top) = (h * 0.12, 0.03 * u, h * b.vary(0.66, 0.76));
    let front = x - 0.06 * u;
    for (cx, cy) in [(-x * 0.7, -y * 0.75), (-x * 0.7, y * 0.75), (front * 0.7, -y * 0.75), (front * 0.7, y * 0.75)] {
        b.taper("foot", [cx, cy, 0.0], (0.02 * u, 0.02 * u), (0.03 * u, 0.03 * u), foot + 0.002 * u, mat);
    }
    let lintel = top - 0.04 * u;
    case(b, [-x * 0.9, -y * 0.92, foot], [front - 0.03 * u, y * 0.92, lintel], wall, mat);
    b.rounded_block("plate", [-x, -y, lintel], [x - 0.02 * u, y, top], 0.012 * u, mat);
    let flue = (x * 0.3).min(0.075 * u);
    b.cylinder("flue", [-x * 0.55, 0.0, top - 0.002 * u], flue, h - top + 0.002 * u, mat);
    b.ledge("plate", [x * 0.3, 0.0, top], (x * 0.45, y * 0.85), h * 0.4);
    let hollow = ([-x * 0.9 + wall, -y * 0.92 + wall, foot + wall], [front - 0.04 * u, y * 0.92 - wall, lintel - wall]);
    hearth_fire(b, hollow, u * 0.8);
    glass_front(b, (front - 0.029 * u, front), (-y * 0.9, foot + 0.01 * u), (y * 0.9, lintel - 0.004 * u));
    b.prism(
        "ash_lip",
        Axis::Y,
        [front - 0.03 * u, -y * 0.8, foot],
        &[(0.0, 0.0), (x - front + 0.03 * u, 0.0), (0.0, -0.03 * u)],
        y * 1.6,
        mat,
    );
}
