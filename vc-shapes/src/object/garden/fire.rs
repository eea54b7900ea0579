//! Garden fires, firewood and patio heaters.

use std::f32::consts::{PI, TAU};

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Axis, Build, CORNERS, P, at_least, blob, limb, polar, polygon, star};

/// A fire of logs in a ring of stones.
pub(super) fn campfire(b: &mut Build<'_>) {
    at_least(b, [0.3, 0.3, 0.15]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let stones = b.rng.count(7, 12);
    let mat = b.choose(&[ROCK, GRANITE, GRAVEL, SANDSTONE]);
    let size = (x.min(y) * 2.4 / stones as f32).min(x.min(y) * 0.28);
    let (ax, ay) = (x - size * 0.8, y - size * 0.8);
    let oval = |share: f32, z: f32| polygon(20, share, 0.0).into_iter().map(move |(px, py)| [px * ax, py * ay, z]);
    b.hull("ash", &oval(1.0, 0.0).chain(oval(0.8, 0.02)).chain(oval(0.2, 0.03)).collect::<Vec<P>>(), BLACK_GRANITE);
    for i in 1..stones {
        let angle = TAU * i as f32 / stones as f32;
        let (cx, cy) = ((x - size) * angle.cosine(), (y - size) * angle.sine());
        let tall = h.min(size * b.vary(1.0, 1.5)) * 0.5;
        let mut points = blob(b, [cx, cy, tall * 0.7], [size, size, tall * 1.2], 18, 0.25);
        points.iter_mut().for_each(|p| p[2] = p[2].max(0.0));
        b.hull("stone", &points, mat);
    }
    // The first stone is flat, so that a pan can be put down.
    let flat = (h * 0.3).min(size);
    b.rounded_block("hearth_stone", [x - 2.0 * size, -size, 0.0], [x, size, flat], size * 0.2, mat);
    b.top("hearth_stone", [x - size, 0.0, flat], (size * 0.75, size * 0.75));
    let logs = b.rng.count(4, 8);
    let wood = b.choose(&[BARK, WALNUT, OAK]);
    let reach = x.min(y) - 2.1 * size;
    let r = reach * b.vary(0.1, 0.16);
    let stacked = b.rng.chance(0.4);
    for i in 0..logs {
        if stacked {
            let (layer, side) = ((i / 2) as f32, if i % 2 == 0 { 0.55 } else { -0.55 });
            let z = 0.02 + r + layer * 1.9 * r;
            if z + r > h {
                break;
            }
            let across = reach * side;
            let (from, to) = if (layer as usize).is_multiple_of(2) {
                ([across, -reach, z], [across, reach, z])
            } else {
                ([-reach, across, z], [reach, across, z])
            };
            b.rod("log", from, to, r, wood);
        } else {
            let angle = TAU * i as f32 / logs as f32 + b.vary(-0.1, 0.1);
            let (fx, fy) = polar(angle, reach);
            let (tx, ty) = polar(angle, reach * 0.12);
            let top = h * b.vary(0.7, 0.8);
            let points = limb([fx, fy, r * 0.8], [tx, ty, top], r, r * 0.7);
            b.hull("log", &points.into_iter().map(|p| [p[0], p[1], p[2].clamp(0.0, h)]).collect::<Vec<P>>(), wood);
        }
    }
    flames(b, reach * 0.5, h);
}

/// Three tongues of flame.
fn flames(b: &mut Build<'_>, reach: f32, top: f32) {
    for (i, share) in [1.0, 0.75, 0.6].into_iter().enumerate() {
        let (dx, dy) = polar(2.1 * i as f32, reach * if i == 0 { 0.1 } else { 0.5 });
        let wide = reach * 0.5 * share;
        b.lathe(
            "flame",
            [dx, dy, 0.02],
            &[
                (wide * 0.5, 0.0),
                (wide, top * 0.2 * share),
                (wide * 0.6, top * 0.5 * share),
                (0.0, (top - 0.02) * share),
            ],
            if i == 1 { SIGNAL_AMBER } else { FLAME },
        );
    }
}

/// A fire pit: a bowl on a foot or a walled square, with a rim that is a surface.
pub(super) fn fire_pit(b: &mut Build<'_>) {
    at_least(b, [0.25, 0.25, 0.12]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let mat = b.choose(&[RUST, IRON, CONCRETE, BLACK_METAL, BRICK]);
    let rim = r * b.vary(0.18, 0.26);
    let inner = r - rim;
    let (deep, low) = (h * b.vary(0.45, 0.6), 0.012);
    let bed = h - deep;
    if b.rng.chance(0.6) {
        let foot = r * b.vary(0.35, 0.6);
        let profile = [
            (foot, 0.0),
            (foot * 0.9, bed * 0.4),
            (inner * 0.74, bed * 0.8),
            (r * 0.9, h - 0.03),
            (r, h - 0.02),
            (r, h),
            (inner, h),
            (inner * 0.7, bed),
            (0.0, bed),
        ];
        b.lathe("bowl", [0.0; 3], &profile, mat);
    } else {
        let (x, y) = (b.size.x / 2.0, b.size.y / 2.0);
        b.block("base", [-x * 0.95, -y * 0.95, 0.0], [x * 0.95, y * 0.95, bed], mat);
        for side in [-1.0, 1.0] {
            let (cx, cy) = (side * (x - rim / 2.0), side * (y - rim / 2.0));
            b.block("wall", [cx - rim / 2.0, -y, low], [cx + rim / 2.0, y, h], mat);
            b.block("wall", [-x + rim, cy - rim / 2.0, low], [x - rim, cy + rim / 2.0, h - 0.001], mat);
        }
    }
    let log = inner * 0.13;
    for i in 0..3 {
        let z = bed + log * if i < 2 { 0.9 } else { 2.4 };
        let cy = inner * [0.5, 0.24, 0.36][i];
        b.rod("log", [-inner * 0.45, cy, z], [inner * 0.45, cy, z], log, BARK);
    }
    let square = b.size.x.min(b.size.y) / 2.0;
    b.top("rim", [b.size.x / 2.0 - rim * 0.5 - (b.size.x / 2.0 - square), 0.0, h], (rim * 0.35, inner * 0.25));
    b.inside("basin", [0.0, -inner * 0.26, bed], (inner * 0.34, inner * 0.26), deep);
}

/// Firewood: a log, a split log, or a few tied together; they lie along Y.
pub(super) fn firewood(b: &mut Build<'_>) {
    at_least(b, [0.04, 0.1, 0.04]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (bark, wood) = (b.choose(&[BARK, PALE_BARK, WALNUT]), b.choose(&[PINE, BEECH, OAK]));
    match b.rng.below(3) {
        0 => {
            let r = x.min(h / 2.0);
            b.rod("bark", [0.0, -y + 0.004, r], [0.0, y - 0.004, r], r, bark);
            b.rod("wood", [0.0, -y, r], [0.0, y, r], r * 0.88, wood);
        }
        1 => {
            // A split quarter: bark on its back, two cut faces.
            let back: Vec<(f32, f32)> =
                (0..=6).map(|i| PI * i as f32 / 6.0).map(|a| (x * a.cosine(), h * a.sine())).collect();
            let skew = b.vary(-0.5, 0.5) * x;
            let face: Vec<(f32, f32)> = [(x * 0.97, 0.0), (skew * 0.5, h * 0.94), (-x * 0.97, 0.0)].to_vec();
            b.prism("bark", Axis::Y, [0.0, -y + 0.004, 0.0], &back, 2.0 * y - 0.008, bark);
            b.prism("wood", Axis::Y, [0.0, -y, 0.0], &face, 2.0 * y, wood);
        }
        _ => {
            let r = (x / 2.0).min(h / 3.8);
            for (dx, dz) in [(-r, r), (r, r), (0.0, 2.72 * r)] {
                let share = b.vary(0.9, 1.0);
                b.rod("bark", [dx, -y * share + 0.004, dz], [dx, y * share - 0.004, dz], r, bark);
                b.rod("wood", [dx, -y * share, dz], [dx, y * share, dz], r * 0.85, wood);
            }
            let band = [
                (2.0 * r, 0.3 * r),
                (1.6 * r, r * 0.02),
                (-1.6 * r, r * 0.02),
                (-2.0 * r, 0.3 * r),
                (-2.0 * r, 1.4 * r),
                (-0.6 * r, 3.6 * r),
                (0.6 * r, 3.6 * r),
                (2.0 * r, 1.4 * r),
            ];
            b.prism("band", Axis::Y, [0.0, -0.01, 0.0], &band, 0.02, JUTE);
        }
    }
}

/// A rack half filled with logs, open or roofed.
pub(super) fn firewood_rack(b: &mut Build<'_>) {
    at_least(b, [0.15, 0.3, 0.3]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let frame = b.choose(&[IRON, RUST, PINE, OAK, ANTHRACITE]);
    let roofed = h > 1.0 && b.rng.chance(0.6);
    let top = if roofed { h - 0.1 } else { h };
    let (post, low) = (0.025_f32.min(x * 0.2), 0.08_f32.min(h * 0.1));
    for (sx, sy) in CORNERS {
        let (cx, cy) = (sx * (x - post - 0.02), sy * (y - post));
        b.block("post", [cx - post, cy - post, 0.0], [cx + post, cy + post, top - 0.001 * (1.0 + sx)], frame);
    }
    b.block("floor", [-x + 0.02, -y + 0.002, low - 0.03], [x - 0.02, y - 0.002, low], frame);
    for side in [-1.0, 1.0] {
        let cy = side * (y - post);
        b.block(
            "rail",
            [-x + 0.022, cy - post * 0.8, top * 0.6],
            [x - 0.022, cy + post * 0.8, top * 0.6 + 0.03],
            frame,
        );
    }
    b.block("rail", [-x + 0.022, -y + 0.002, top - 0.05], [-x + 0.02 + 2.0 * post, y - 0.002, top - 0.01], frame);
    if roofed {
        b.prism(
            "roof",
            Axis::Y,
            [0.0, -y, 0.0],
            &[(x, top - 0.06), (x, top - 0.03), (-x, h), (-x, h - 0.03)],
            2.0 * y,
            frame,
        );
    }
    let (inner, room) = (y - 2.0 * post - 0.01, (if roofed { top - 0.07 } else { top }) - low);
    let split = inner * b.vary(-0.2, 0.3);
    let r = ((split + inner) / 8.0).clamp(0.03, 0.09).min((split + inner) / 4.0).max(room / 16.0);
    let columns = (((split + inner) / (2.0 * r)) as usize).clamp(1, 6);
    let rows = ((room / (1.75 * r)) as usize).clamp(1, 9).min(44 / columns);
    for row in 0..rows {
        let shift = if row % 2 == 0 { 0.0 } else { r * 0.5 };
        for column in 0..columns {
            let (cy, z) = (-inner + r + 2.0 * r * column as f32 + shift * 0.4, low + r + 1.75 * r * row as f32);
            if z + r > low + room {
                break;
            }
            let reach = (x - 0.015) * b.vary(0.85, 1.0);
            let wood = b.choose(&[PINE, BEECH, BARK, OAK]);
            b.rod("log", [-reach, cy, z], [reach, cy, z], r * 0.98, wood);
        }
    }
    let from = -inner + 2.0 * r * columns as f32 + r * 0.3;
    b.inside(
        "rack",
        [0.0, f32::midpoint(from, inner), low],
        (x - 0.04, ((inner - from) / 2.0 - 0.005).max(0.02)),
        room - 0.06,
    );
}

/// A propane bottle with its collar and a valve that turns.
pub(super) fn gas_tank(b: &mut Build<'_>) {
    at_least(b, [0.1, 0.1, 0.18]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let mat = b.choose(&[GREY, RED_METAL, BLUE_METAL, WHITE_METAL, GREEN_METAL, ORANGE, SILVER_METAL]);
    let neck = h * b.vary(0.72, 0.78);
    let belly = neck * b.vary(0.72, 0.82);
    b.lathe(
        "tank",
        [0.0; 3],
        &[
            (r * 0.75, 0.0),
            (r * 0.75, h * 0.05),
            (r * 0.9, h * 0.08),
            (r, h * 0.16),
            (r, belly),
            (r * 0.8, (belly + neck) / 2.0 + 0.01),
            (r * 0.25, neck),
        ],
        mat,
    );
    b.cylinder("seam", [0.0, 0.0, (belly + h * 0.16) / 2.0], r * 0.99 + 0.001, 0.006, mat);
    let collar = r * b.vary(0.55, 0.68);
    let arc: Vec<f32> = (0..=10).map(|i| 0.6 + (TAU - 1.2) * i as f32 / 10.0).collect();
    let outline: Vec<(f32, f32)> =
        arc.iter().map(|&a| polar(a, collar)).chain(arc.iter().rev().map(|&a| polar(a, collar - 0.006))).collect();
    let low = neck - h * 0.08;
    b.prism("collar", Axis::Z, [0.0, 0.0, low], &outline, h - low, mat);
    b.cylinder("valve", [0.0, 0.0, neck - 0.01], 0.015, (h - neck) * 0.45 + 0.011, BRASS);
    b.rod(
        "valve",
        [0.0, 0.0, neck + (h - neck) * 0.25],
        [0.035_f32.min(collar * 0.8), 0.0, neck + (h - neck) * 0.25],
        0.01,
        BRASS,
    );
    let top = neck + (h - neck) * 0.45;
    b.hinge([0.0, 0.0, top], [0.0, 0.0, 1.0], TAU, |b| {
        b.prism(
            "knob",
            Axis::Z,
            [0.0, 0.0, top],
            &star(7, 0.03_f32.min(collar * 0.6), 0.024_f32.min(collar * 0.5)),
            (h - top) * 0.5,
            BLACK_PLASTIC,
        );
    });
}

/// A patio heater: a base that contains the gas bottle, a pole, a burner, a reflector hood.
pub(super) fn patio_heater(b: &mut Build<'_>) {
    at_least(b, [0.25, 0.25, 0.9]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let mat = b.choose(&[STEEL, ANTHRACITE, BLACK_METAL, COPPER, SILVER_METAL]);
    let foot = r * b.vary(0.5, 0.62);
    let tank = h * b.vary(0.3, 0.38);
    b.lathe(
        "foot",
        [0.0; 3],
        &[(foot * 1.05, 0.0), (foot * 1.05, 0.03), (foot * 0.85, 0.035), (foot * 0.8, tank), (foot * 0.3, tank + 0.04)],
        mat,
    );
    let burner = h * b.vary(0.78, 0.83);
    b.cylinder("pole", [0.0, 0.0, tank], 0.03, burner - tank, mat);
    let neck = h * 0.94;
    b.lathe("burner", [0.0, 0.0, burner - 0.01], &[(0.05, 0.0), (r * 0.3, 0.03), (r * 0.3, 0.06)], mat);
    b.cylinder("mesh", [0.0, 0.0, burner + 0.045], r * 0.24, neck - burner - 0.05, FLAME);
    for i in 0..4 {
        let (px, py) = polar(TAU * i as f32 / 4.0, r * 0.27);
        b.cylinder("bar", [px, py, burner + 0.04], 0.006, neck - burner - 0.03, mat);
    }
    b.lathe(
        "hat",
        [0.0, 0.0, neck - 0.02],
        &[
            (r, 0.0),
            (r, 0.01),
            (r * 0.5, (h - neck) * 0.7 + 0.02),
            (0.04, h - neck + 0.02),
            (0.0, h - neck + 0.02),
            (0.0, 0.02),
            (r * 0.98, 0.002),
        ],
        mat,
    );
    b.rod("knob", [0.03, 0.0, burner - 0.1], [0.06, 0.0, burner - 0.1], 0.018, BLACK_PLASTIC);
}
