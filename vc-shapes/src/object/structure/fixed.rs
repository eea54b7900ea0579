//! Switches, sockets, columns, railings, stairs and grilles.

use crate::material::*;
use crate::object::joinery::{Swing, gapped, swing};
use crate::solid::{Axis, Build, P, case, collar, fit, half_dims, plate_with_border};

/// A plate with one to three rockers, or a knob to turn.
pub(super) fn lightswitch(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let mat = plate_mat(b);
    plate(b, mat);
    let (inner_y, inner_z, z) = (y * b.vary(0.5, 0.8), h * b.vary(0.26, 0.4), h / 2.0);
    let face = x * 0.1;
    if b.rng.chance(0.2) {
        let r = inner_y.min(inner_z) * 0.75;
        b.lathe_along("dimmer", [face, 0.0, z], [x, 0.0, z], &[(r, 0.0), (r * 0.85, x - face)], mat);
        return;
    }
    let count = b.rng.count(1, 3);
    let step = 2.0 * inner_y / count as f32;
    for i in 0..count {
        let y0 = -inner_y + step * i as f32 + step * 0.03;
        // A rocker protrudes further at its lower end.
        let outline = [(face, -inner_z), (x, -inner_z), (x * 0.45, 0.0), (x * 0.4, inner_z), (face, inner_z)];
        b.prism("rocker", Axis::Y, [0.0, y0, z], &outline, step * 0.94, mat);
    }
}

/// A plate with one or two round wells and two holes in each.
pub(super) fn powersocket(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let mat = plate_mat(b);
    plate(b, mat);
    let count = if y > h * 0.7 { 2 } else { 1 };
    let step = 2.0 * y / count as f32;
    let z = h / 2.0;
    for i in 0..count {
        let cy = -y + step * (i as f32 + 0.5);
        let r = (step * 0.4).min(h * 0.4);
        let at = [x * 0.15, cy, z];
        collar(b, "well", (at, [x, cy, z]), (r * 0.84, r), mat);
        for side in [-1.0, 1.0] {
            let hole = cy + side * r * 0.32;
            b.rod("hole", [x * 0.2, hole, z], [x * 0.26, hole, z], r * 0.1, BLACK_PLASTIC);
            let pin = z + side * r * 0.75;
            b.block("earth", [x * 0.2, cy - r * 0.1, pin - r * 0.06], [x * 0.8, cy + r * 0.1, pin + r * 0.06], CHROME);
        }
    }
}

fn plate_mat(b: &mut Build<'_>) -> MaterialId {
    b.choose(&[WHITE_PLASTIC, WHITE_PLASTIC, BLACK_PLASTIC, STEEL, GREY_PLASTIC])
}

/// The square plate of switches and sockets.
fn plate(b: &mut Build<'_>, mat: MaterialId) {
    let (x, y, h) = half_dims(b);
    b.rounded_block("plate", [-x, -y, 0.0], [x * 0.2, y, h], x * 0.5, mat);
}

/// Breakers in rows behind a door.
pub(super) fn fuse_box(b: &mut Build<'_>) {
    let u = fit(b, [0.04, 0.12, 0.15]);
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[WHITE_METAL, GREY_PLASTIC, SILVER_METAL]);
    let (wall, face) = (0.012 * u, x - 0.012 * u);
    case(b, [-x, -y, 0.0], [face - 0.01 * u, y, h], wall, mat);
    let plate = 0.0;
    // Toggles must not touch the door.
    let proud = (0.018 * u).min((face - 0.01 * u) * 0.8);
    b.block("cover", [-x + wall, -y + wall, wall], [plate, y - wall, h - wall], WHITE_PLASTIC);
    let rows = (h / 0.15).round().clamp(1.0, 4.0) as usize;
    let pitch = (h - 2.0 * wall) / rows as f32;
    for row in 0..rows {
        let z = wall + pitch * (row as f32 + 0.5);
        let tall = pitch * 0.28;
        let used = b.rng.count(5, 8);
        let step = 2.0 * (y - wall) * 0.9 / 8.0;
        for i in 0..used {
            let y0 = -(y - wall) * 0.9 + step * i as f32;
            b.block("breaker", [plate, y0, z - tall], [plate + proud * 0.4, y0 + step * 0.94, z + tall], GREY_PLASTIC);
            b.block(
                "toggle",
                [plate, y0 + step * 0.3, z],
                [plate + proud, y0 + step * 0.64, z + tall * 0.5],
                BLACK_PLASTIC,
            );
        }
    }
    let (low, high) = gapped([face - 0.01 * u, -y, 0.0], [face, y, h], 0.002 * u);
    let clear = b.rng.chance(0.4);
    let at = b.choose(&[Swing::Left, Swing::Right]);
    let edge = if at == Swing::Left { low[1] + 0.03 * u } else { high[1] - 0.03 * u };
    swing(b, at, low, high, 1.9, |b| {
        if clear {
            plate_with_border(b, "door", low, high, 0.03 * u, mat);
            let w = 0.03 * u;
            b.block(
                "pane",
                [low[0] + 0.003 * u, low[1] + w, low[2] + w],
                [high[0] - 0.003 * u, high[1] - w, high[2] - w],
                BROWN_GLASS,
            );
        } else {
            b.block("door", low, high, mat);
            b.block(
                "sign",
                [high[0] - 0.001, -0.03 * u, h * 0.6],
                [high[0] + 0.0012, 0.03 * u, h * 0.6 + 0.05 * u],
                YELLOW_PLASTIC,
            );
        }
        b.rounded_block(
            "latch",
            [high[0] - 0.002, edge - 0.01 * u, h * 0.46],
            [x, edge + 0.01 * u, h * 0.54],
            0.003 * u,
            BLACK_PLASTIC,
        );
    });
}

/// A slab: a doorstep or a window ledge, its front edge rounded.
pub(super) fn slab(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let step = b.class == "doorstep";
    let mat = if step {
        b.choose(&[GRANITE, SANDSTONE, CONCRETE, b.style.wood])
    } else {
        b.choose(&[MARBLE, WHITE, b.style.wood])
    };
    if step && h > 0.06 {
        b.block("base", [-x, -y + 0.01, 0.0], [x * 0.9, y - 0.01, h * 0.75], CONCRETE);
        b.rounded_block("tread", [-x, -y, h * 0.75 - 0.001], [x, y, h], h * 0.08, mat);
    } else {
        b.rounded_block("board", [-x, -y, 0.0], [x, y, h], h * 0.3, mat);
    }
    b.top("top", [0.0, 0.0, h], (x * 0.9, y * 0.96));
}

/// A shaft between a base and a capital, round or square, fluted or plain.
pub(super) fn column(b: &mut Build<'_>) {
    let u = fit(b, [0.1, 0.1, 1.0]);
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[PLASTER, CONCRETE, MARBLE, SANDSTONE, BRICK, b.style.wood]);
    let r = x.min(y);
    let block = (0.12 * u).min(r);
    match b.rng.below(3) {
        0 => {
            b.block("plinth", [-r, -r, 0.0], [r, r, block * 0.6], mat);
            let (low, high, wide) = (block * 0.59, h - block * 0.5, r * 0.78);
            let shaft = [
                (r * 0.95, 0.0),
                (r * 0.95, block * 0.25),
                (wide, block * 0.6),
                (wide * 0.86, high - low - block * 0.4),
                (r * 0.92, high - low + 0.001),
            ];
            b.lathe("shaft", [0.0, 0.0, low], &shaft, mat);
            b.block("abacus", [-r, -r, high], [r, r, h], mat);
        }
        1 => {
            b.block("shaft", [-x * 0.86, -y * 0.86, block], [x * 0.86, y * 0.86, h - block * 0.5], mat);
            b.block("base", [-x, -y, 0.0], [x, y, block], mat);
            b.block("head", [-x, -y, h - block * 0.5], [x, y, h], mat);
        }
        _ => b.cylinder("shaft", [0.0; 3], r, h, mat),
    }
}

/// A rail on posts: bars, glass or wires between them.
pub(super) fn railing(b: &mut Build<'_>) {
    let u = fit(b, [0.025, 0.7, 0.45]);
    let (x, y, h) = half_dims(b);
    let metal = b.choose(&[b.style.metal, STEEL, IRON, WHITE_METAL]);
    let hand = b.choose(&[b.style.wood, metal]);
    let (rail, post) = (0.045 * u, (0.02 * u).min(x * 0.9));
    b.rounded_block("handrail", [-x, -y, h - rail], [x, y, h], rail * 0.4, hand);
    let bays = (y * 2.0 / 1.2).ceil().clamp(1.0, 6.0) as usize;
    let step = 2.0 * (y - post) / bays as f32;
    for i in 0..=bays {
        let cy = -y + post + step * i as f32;
        b.block("post", [-post, cy - post, 0.0], [post, cy + post, h - rail * 0.5], metal);
    }
    let low = 0.09 * u;
    let (from, to) = (-y + post * 2.0, y - post * 2.0);
    match b.rng.below(3) {
        0 => {
            b.block("lower_rail", [-post * 0.7, from, low], [post * 0.7, to, low + 0.025 * u], metal);
            let bars = ((to - from) / 0.12).clamp(4.0, 40.0) as usize;
            let gap = (to - from) / bars as f32;
            let r = post * 0.4;
            for i in 0..bars {
                let cy = from + gap * (i as f32 + 0.5);
                b.block("bar", [-r, cy - r, low + 0.02 * u], [r, cy + r, h - rail * 0.6], metal);
            }
        }
        1 => {
            let (t, pane) = (post * 0.3, b.choose(&[GLASS, FROSTED_GLASS]));
            for i in 0..bays {
                let cy = -y + post + step * i as f32;
                b.block("pane", [-t, cy + post * 0.8, low], [t, cy + step - post * 0.8, h - rail * 1.6], pane);
            }
        }
        _ => {
            for i in 0..6 {
                let z = low + (h - low - rail * 2.0) * i as f32 / 5.0;
                b.rod("wire", [0.0, -y + post, z], [0.0, y - post, z], post * 0.28, metal);
            }
        }
    }
}

/// Steps up from the front: closed, or treads between two stringers.
pub(super) fn stairs(b: &mut Build<'_>) {
    let u = fit(b, [1.0, 0.4, 1.0]);
    let (x, y, h) = half_dims(b);
    let wood = b.choose(&[b.style.wood, b.style.floor, CONCRETE]);
    let steps = (h / 0.18).round().clamp(2.0, 20.0) as usize;
    let (rise, run) = (h / steps as f32, 2.0 * x / steps as f32);
    let open = b.rng.chance(0.5);
    let (board, cheek) = (0.04 * u, 0.035 * u);
    let inner = if open { y - cheek } else { y };
    for i in 0..steps {
        let (z, x1) = (rise * (i as f32 + 1.0), x - run * i as f32);
        let back = if i + 1 == steps { x1 - run } else { x1 - run - 0.02 * u };
        if !open {
            b.block("riser", [-x, -inner + 0.006 * u, z - rise], [x1 - 0.02 * u, inner - 0.006 * u, z - board], WHITE);
        }
        b.block("tread", [back.max(-x), -inner, z - board], [x1, inner, z], wood);
        b.top(&format!("step_{}", i + 1), [x1 - run / 2.0, 0.0, z], (run * 0.46, inner * 0.94));
    }
    if open {
        let (w, slope) = (0.26 * u, rise / run);
        let outline: [(f32, f32); 5] = [
            (x, 0.0),
            (x, rise * 1.02),
            (-x, h.min(2.0 * x * slope + rise)),
            (-x, (h - w - rise * 0.5).max(rise)),
            (x - w * 0.9 / slope, 0.0),
        ];
        for cy in [-y, y - cheek] {
            b.prism("stringer", Axis::Y, [0.0, cy, 0.0], &outline, cheek, wood);
        }
    }
}

/// A frame with slanting slats.
pub(super) fn ventilation_grille(b: &mut Build<'_>) {
    let u = fit(b, [0.005, 0.05, 0.05]);
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[WHITE_PLASTIC, WHITE_METAL, STEEL, BROWN_PLASTIC]);
    let w = (y.min(h / 2.0) * 0.2).min(0.02 * u);
    plate_with_border(b, "frame", [-x, -y, 0.0], [x, y, h], w, mat);
    b.block("dark", [-x, -y + w, w], [-x * 0.8, y - w, h - w], BLACK_PLASTIC);
    let count = ((h - 2.0 * w) / (0.018 * u)).clamp(3.0, 14.0) as usize;
    let step = (h - 2.0 * w) / count as f32;
    let slat: [(f32, f32); 4] =
        [(-x * 0.8, step * 0.5), (x * 0.9, 0.0), (x * 0.9, step * 0.25), (-x * 0.8, step * 0.75)];
    for i in 0..count {
        b.prism("slat", Axis::Y, [0.0, -y + w, w + step * i as f32], &slat, 2.0 * (y - w), mat);
    }
    let corner: P = [x, y - w * 0.5, h - w * 0.5];
    for sy in [-1.0, 1.0] {
        b.rod(
            "screw",
            [x - 0.002_f32.min(x), sy * corner[1], corner[2]],
            [x, sy * corner[1], corner[2]],
            w * 0.15,
            STEEL,
        );
    }
}
