//! What decorates gardens: pots, baths and houses for birds, fountains, figures.

use std::f32::consts::{FRAC_PI_2, PI, TAU};

use crate::material::*;
use crate::object::build::{Axis, Build, P};
use crate::object::park::shape::{blob, grown, hoop, limb, polar, polygon, spaced, star, tub};
use vc_graph::portable::Portable;

const POTS: &[Mat] =
    &[POTTERY, POTTERY, BLUE_GLAZE, GREEN_GLAZE, STONEWARE, CONCRETE, WHITE_PLASTIC, BLACK_GLAZE, BROWN_PLASTIC];

/// A plant pot, round or square, on its saucer or not; empty but for soil.
pub(super) fn flower_pot(b: &mut Build<'_>) {
    grown(b, [0.05, 0.05, 0.05]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let mat = b.one(POTS);
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
            tub(b, "pot", [0.0; 3], (half * foot / top, half * foot / top), (half, half), h, t, mat);
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

/// A plant box: boards, concrete or plastic, on feet or not, with soil.
pub(super) fn planter(b: &mut Build<'_>) {
    grown(b, [0.09, 0.2, 0.08]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let boards = h > 0.3 && b.rng.chance(0.6);
    let mat = b.one(if boards {
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
        for (sx, sy) in [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)] {
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
            for (sx, sy) in [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)] {
                let (cx, cy) = (sx * (x * lean - 0.02), sy * (y * lean - 0.02));
                b.block("leg", [cx - 0.018, cy - 0.018, 0.0], [cx + 0.018, cy + 0.018, low + 0.004], IRON);
            }
        }
        tub(b, "box", [0.0, 0.0, low], (x * lean, y * lean), (x, y), h - low, t, mat);
        (ix, iy) = (x * lean - t, y * lean - t);
        let level = low + t + (h - low) * b.vary(0.4, 0.7);
        b.block("soil", [-ix - 0.001, -iy - 0.001, low + t * 0.5], [ix + 0.001, iy + 0.001, level], SOIL);
        b.inside("compartment", [0.0, 0.0, level], ((ix - 0.005).max(0.005), (iy - 0.005).max(0.005)), h - level);
    }
}

/// A basket on chains, planted at its rim.
pub(super) fn hanging_basket(b: &mut Build<'_>) {
    grown(b, [0.1, 0.1, 0.1]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let mat = b.one(&[WICKER, IRON, POTTERY, JUTE, GREEN_PLASTIC]);
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
    let (petal, count) = (b.one(&[PETAL_RED, PETAL_WHITE, PETAL_PINK, PETAL_BLUE, PETAL_YELLOW]), b.rng.count(6, 10));
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

/// A gnome: boots, coat, beard, pointed cap, and a spade or lantern.
pub(super) fn gnome(b: &mut Build<'_>) {
    grown(b, [0.04, 0.05, 0.1]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    // A head keeps to the width there is.
    let k = h.min(r * 6.5);
    let (coat, cap) = (b.one(&[BLUE, GREEN, RED, MUSTARD, FOREST]), b.one(&[RED, RED, GREEN, BLUE]));
    let (waist, neck) = (h * b.vary(0.16, 0.2), h * b.vary(0.46, 0.5));
    for side in [-1.0, 1.0] {
        b.soft(
            "boot",
            [-r * 0.35, side * r * 0.4 - r * 0.3, 0.0],
            [r * 0.95, side * r * 0.4 + r * 0.3, h * 0.09],
            r * 0.15,
            BLACK,
        );
        b.cylinder("leg", [0.0, side * r * 0.38, h * 0.05], r * 0.27, waist - h * 0.04, NAVY);
    }
    b.lathe(
        "coat",
        [0.0, 0.0, waist - 0.01],
        &[(r * 0.85, 0.0), (r * 0.8, (neck - waist) * 0.4), (r * 0.5, neck - waist)],
        coat,
    );
    b.lathe("belt", [0.0, 0.0, waist + (neck - waist) * 0.3], &[(r * 0.85, 0.0), (r * 0.83, h * 0.025)], BLACK);
    b.block(
        "buckle",
        [r * 0.7, -r * 0.15, waist + (neck - waist) * 0.3],
        [r * 0.9, r * 0.15, waist + (neck - waist) * 0.3 + h * 0.025],
        GOLD,
    );
    let face = neck + h * 0.09;
    b.ball("head", [0.0, 0.0, face], k * 0.105, SKIN);
    b.ball("nose", [k * 0.11, 0.0, face], k * 0.025, SKIN);
    let beard = [
        [k * 0.1, 0.5, face - h * 0.01],
        [k * 0.02, 0.75, face],
        [k * 0.12, 0.3, face - h * 0.1],
        [k * 0.1, 0.0, face - h * 0.22],
        [k * 0.04, 0.5, face - h * 0.1],
    ];
    b.hull(
        "beard",
        &beard.iter().flat_map(|p| [[p[0], p[1] * k * 0.13, p[2]], [p[0], -p[1] * k * 0.13, p[2]]]).collect::<Vec<P>>(),
        WHITE,
    );
    let droop = b.vary(-0.3, 0.3) * r;
    let brim = face + h * 0.03;
    b.hull(
        "cap",
        &limb([0.0, 0.0, brim], [-droop * 0.4, droop * 0.5, brim + (h - brim) * 0.55], k * 0.12, k * 0.06),
        cap,
    );
    let tip =
        limb([-droop * 0.4, droop * 0.5, brim + (h - brim) * 0.54], [-droop, droop, h - 0.004], k * 0.06, k * 0.006);
    b.hull("cap", &tip.into_iter().map(|p| [p[0], p[1], p[2].min(h)]).collect::<Vec<P>>(), cap);
    for side in [-1.0, 1.0] {
        let hand = [r * 0.55, side * r * 0.76, waist + (neck - waist) * 0.35];
        b.hull("arm", &limb([0.0, side * r * 0.5, neck - h * 0.04], hand, k * 0.045, k * 0.035), coat);
        b.ball("hand", hand, k * 0.035, SKIN);
    }
    let grip = [r * 0.55, r * 0.76];
    match b.rng.below(3) {
        0 => {
            b.cylinder("spade", [grip[0], grip[1], h * 0.1], k * 0.014, h * 0.45, BEECH);
            b.block(
                "spade",
                [grip[0] - k * 0.008, grip[1] - k * 0.035, 0.0],
                [grip[0] + k * 0.008, grip[1] + k * 0.035, h * 0.14],
                STEEL,
            );
        }
        1 => {
            let z = waist + (neck - waist) * 0.35 - h * 0.13;
            b.cylinder("lantern", [grip[0], grip[1], z], k * 0.032, h * 0.09, WARM_BULB);
            b.cone("lantern", [grip[0], grip[1], z + h * 0.085], k * 0.036, h * 0.035, IRON);
        }
        _ => {
            let z = waist + (neck - waist) * 0.35;
            b.rod("rod", [grip[0], grip[1], z - h * 0.08], [grip[0], grip[1], h * 0.85], k * 0.01, BAMBOO);
        }
    }
}

/// A bird bath: a basin with water on a foot.
pub(super) fn bird_bath(b: &mut Build<'_>) {
    grown(b, [0.15, 0.15, 0.22]);
    let r = b.size.x.min(b.size.y) / 2.0;
    let guest = if b.rng.chance(0.3) { 0.03_f32.min(r * 0.2) } else { 0.0 };
    let h = b.size.z - guest * 0.8;
    let mat = b.one(&[CONCRETE, SANDSTONE, GRANITE, POTTERY, BLUE_GLAZE, COPPER, MARBLE]);
    let deep = (h * 0.16).min(r * 0.45);
    let (base, waist) = (r * b.vary(0.55, 0.75), r * b.vary(0.18, 0.35));
    let low = h - deep;
    let mut column = vec![(base, 0.0), (base, h * 0.05), (base * 0.75, h * 0.09), (waist, h * 0.16)];
    if b.rng.chance(0.5) {
        column.extend([(waist * 1.1, h * 0.4), (waist * 1.5, h * 0.46), (waist * 1.1, h * 0.52)]);
    }
    column.extend([(waist * 0.85, low * 0.9), (waist * 1.3, low + 0.005)]);
    b.lathe("foot", [0.0; 3], &column, mat);
    let full = b.vary(0.45, 0.8);
    basin(b, [0.0, 0.0, low], (r, deep), full, mat);
    if guest > 0.0 {
        let (px, py) = polar(b.vary(0.0, TAU), r - 0.025);
        bird(b, [px, py, h], guest);
    }
}

/// A bowl with water standing on a point; its surface is a place inside.
fn basin(b: &mut Build<'_>, at: P, (r, deep): (f32, f32), full: f32, mat: Mat) {
    let t = (deep * 0.22).clamp(0.006, 0.04);
    let profile = [
        (r * 0.35, 0.0),
        (r * 0.85, deep * 0.5),
        (r, deep * 0.85),
        (r, deep),
        (r - t, deep),
        (r * 0.82 - t * 0.5, deep * 0.55),
        (r * 0.3, t),
        (0.0, t),
    ];
    b.lathe("basin", at, &profile, mat);
    let level = t + (deep - t) * full;
    let wide = (r - t) * if full > 0.6 { 0.9 } else { 0.75 };
    b.lathe("water", at, &[(r * 0.3, t * 0.6), (wide, level - 0.004), (wide, level)], WATER);
    b.inside("basin", [at[0], at[1], at[2] + level], (wide * 0.6, wide * 0.6), deep - level + 0.05);
}

/// A small bird standing on a point.
fn bird(b: &mut Build<'_>, at: P, size: f32) {
    let points = blob(b, [at[0], at[1], at[2] + size * 0.3], [size * 0.6, size, size * 0.5], 18, 0.05);
    let low = at[2] - 0.004;
    b.hull("bird", &points.into_iter().map(|p| [p[0], p[1], p[2].max(low)]).collect::<Vec<P>>(), BROWN_SKIN);
}

/// A bird table on a post, or a feeder that hangs or stands.
pub(super) fn bird_feeder(b: &mut Build<'_>) {
    grown(b, [0.07, 0.07, 0.11]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (wood, roof) = (b.one(&[PINE, OAK, TEAK, GREY_OAK, SAGE]), b.one(&[RED, ASPHALT, GREEN, POTTERY, PINE]));
    let low = if h > 0.6 { h - (2.2 * x.max(y)).min(h * 0.45) } else { 0.0 };
    if low > 0.0 {
        let post = 0.022_f32.min(x * 0.25);
        b.block("post", [-post, -post, 0.01], [post, post, low + 0.004], wood);
        for (dx, dy) in [(1.0, 0.0), (0.0, 1.0)] {
            let (lx, ly) = (x * 0.9 * dx + post * 0.8 * dy, y * 0.9 * dy + post * 0.8 * dx);
            b.block("foot", [-lx, -ly, 0.0], [lx, ly, 0.03 - 0.002 * dx], wood);
        }
    }
    let (t, eaves) = (0.01, low + (h - low) * 0.6);
    b.block("tray", [-x * 0.9, -y * 0.9, low], [x * 0.9, y * 0.9, low + t], wood);
    let lip = low + t + 0.018;
    for side in [-1.0, 1.0] {
        let (cx, cy) = (side * (x * 0.9 - t / 2.0), side * (y * 0.9 - t / 2.0));
        b.block("lip", [cx - t / 2.0, -y * 0.9, low + t], [cx + t / 2.0, y * 0.9, lip], wood);
        b.block("lip", [-x * 0.9 + t, cy - t / 2.0, low + t], [x * 0.9 - t, cy + t / 2.0, lip - 0.002], wood);
        for sx in [-1.0, 1.0] {
            let cx = sx * (x * 0.9 - t * 1.6);
            let cy = side * (y * 0.9 - t * 1.6);
            b.cylinder("post", [cx, cy, low + t * 0.5], t * 0.55, eaves - low, wood);
        }
    }
    let hang = if low > 0.0 { 0.0 } else { 0.03_f32.min(h * 0.1) };
    let ridge = h - hang;
    let slope = |s: f32| [(s * y, eaves), (s * y, eaves + t), (0.0, ridge), (0.0, ridge - t * 1.4)];
    for s in [-1.0, 1.0] {
        b.prism("roof", Axis::X, [-x, 0.0, 0.0], &slope(s), 2.0 * x, roof);
    }
    for cx in [-x * 0.9 + t * 1.6, x * 0.9 - t * 1.6] {
        b.block("tie", [cx - t * 0.4, -y * 0.88, eaves - 0.004], [cx + t * 0.4, y * 0.88, eaves + t * 0.8], wood);
        b.block("king", [cx - t * 0.35, -t * 0.5, eaves], [cx + t * 0.35, t * 0.5, ridge - t * 0.6], wood);
    }
    if hang > 0.0 {
        b.lathe_along(
            "ring",
            [0.0, -0.003, ridge + hang * 0.45],
            [0.0, 1.0, ridge + hang * 0.45],
            &hoop(hang * 0.42, 0.003),
            IRON,
        );
    }
    b.inside("compartment", [0.0, 0.0, low + t], (x * 0.9 - 3.0 * t, y * 0.9 - 3.0 * t), eaves - low - t - 0.01);
}

/// A nesting box: a hole in front, a perch, a roof.
pub(super) fn bird_house(b: &mut Build<'_>) {
    grown(b, [0.07, 0.06, 0.1]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, roof) = (
        b.one(&[PINE, OAK, BIRCH, SKY, SAGE, RED, YELLOW, GREY_OAK]),
        b.one(&[RED, ASPHALT, FOREST, PINE, WHITE, RUST]),
    );
    let t = 0.01;
    let gable = b.rng.chance(0.5);
    let eaves = h * if gable { b.vary(0.62, 0.72) } else { 0.82 };
    let (bx, by) = (x - 0.025, y * 0.82);
    let back = -x;
    b.block("back", [back, -by, 0.0], [back + t, by, eaves], mat);
    b.block("floor", [back + t, -by, 0.002], [bx, by, 0.002 + t], mat);
    for side in [-1.0, 1.0] {
        let cy = side * (by - t / 2.0);
        b.block("side", [back + t, cy - t / 2.0, 0.002 + t], [bx - t, cy + t / 2.0, eaves], mat);
    }
    // The front, in pieces around its hole.
    let (r, z) = ((by * 0.36).min(0.025), eaves * b.vary(0.58, 0.66));
    let ring: Vec<(f32, f32)> = polygon(12, r, 0.0).into_iter().map(|(py, pz)| (py, z + pz)).collect();
    let half = |s: f32| -> Vec<(f32, f32)> {
        let mut outline = vec![(0.0, 0.002 + t), (s * by, 0.002 + t), (s * by, eaves)];
        outline.push((0.0, eaves));
        outline.extend(ring.iter().copied().filter(|p| p.0 * s > -1e-4).collect::<Vec<_>>().into_iter().fold(
            Vec::new(),
            |mut sorted: Vec<(f32, f32)>, p| {
                let at = sorted.iter().position(|q| q.1 < p.1).unwrap_or(sorted.len());
                sorted.insert(at, p);
                sorted
            },
        ));
        outline
    };
    for s in [-1.0, 1.0] {
        b.prism("front", Axis::X, [bx - t, 0.0, 0.0], &half(s), t, mat);
    }
    b.rod("perch", [bx - 0.004, 0.0, z - r - 0.018], [x - 0.002, 0.0, z - r - 0.018], 0.004, b.style.wood);
    if gable {
        for s in [-1.0, 1.0] {
            b.prism(
                "roof",
                Axis::X,
                [-x + 0.002, 0.0, 0.0],
                &[(0.0, h - t * 1.3), (s * y, eaves - t), (s * y, eaves), (0.0, h)],
                2.0 * x - 0.004,
                roof,
            );
        }
        for cx in [back + 0.002, bx - t - 0.002] {
            b.prism(
                "gable",
                Axis::X,
                [cx + 0.001, 0.0, 0.0],
                &[(-by, eaves - 0.002), (by, eaves - 0.002), (0.0, h - t * 1.3)],
                t * 0.9,
                mat,
            );
        }
    } else {
        b.prism(
            "roof",
            Axis::Y,
            [0.0, -y, 0.0],
            &[(-x + 0.002, h - t), (-x + 0.002, h), (x, eaves + t), (x, eaves - 0.001), (-x + 0.002, eaves - 0.001)],
            2.0 * y,
            roof,
        );
    }
    b.inside(
        "compartment",
        [(back + bx) / 2.0, 0.0, 0.002 + t],
        ((bx - back) / 2.0 - t - 0.004, by - t - 0.004),
        eaves - t - 0.01,
    );
}

/// A fountain: bowls on a column in a basin, or a basin with a spout.
pub(super) fn fountain(b: &mut Build<'_>) {
    grown(b, [0.25, 0.25, 0.3]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let mat = b.one(&[SANDSTONE, MARBLE, GRANITE, CONCRETE, POTTERY]);
    let rim = (h * b.vary(0.16, 0.28)).min(r * 0.6);
    let t = r * b.vary(0.08, 0.13);
    let sides = b.rng.below(3);
    if sides == 0 {
        tub(b, "basin", [0.0; 3], (r, r), (r, r), rim, t, mat);
    } else {
        let inner = r - t;
        b.lathe(
            "basin",
            [0.0; 3],
            &[
                (r * 0.95, 0.0),
                (r * 0.93, rim * 0.8),
                (r, rim * 0.85),
                (r, rim),
                (inner, rim),
                (inner, t * 0.6),
                (0.0, t * 0.6),
            ],
            mat,
        );
    }
    let level = rim * 0.8;
    b.cylinder("water", [0.0, 0.0, t * 0.4], r - t - 0.002 + 0.004, level - t * 0.4, WATER);
    let bowls = b.rng.count(1, 3);
    let column = r * b.vary(0.12, 0.18);
    let top = h * 0.93;
    b.lathe(
        "column",
        [0.0; 3],
        &[
            (column * 1.6, t * 0.3),
            (column * 1.6, level + 0.02),
            (column, level + 0.05_f32.min(h * 0.05)),
            (column * 0.7, top),
        ],
        mat,
    );
    for i in 0..bowls {
        let z = level + (top - level) * (i as f32 + 1.0) / bowls as f32;
        let wide = r * 0.62 * (1.0 - 0.28 * i as f32);
        let deep = (wide * 0.35).min((top - level) / bowls as f32 * 0.5);
        b.lathe(
            "bowl",
            [0.0, 0.0, z - deep],
            &[
                (column * 0.8, 0.0),
                (wide * 0.75, deep * 0.5),
                (wide, deep),
                (wide * 0.92, deep),
                (wide * 0.7, deep * 0.6),
                (0.0, deep * 0.55),
            ],
            mat,
        );
        b.lathe("water", [0.0, 0.0, z - deep], &[(wide * 0.68, deep * 0.57), (wide * 0.86, deep * 0.88)], WATER);
        let drops = 4;
        for k in 0..drops {
            let (px, py) = polar(TAU * (k as f32 + 0.5 * i as f32) / drops as f32, wide * 0.97);
            b.cylinder(
                "jet",
                [px, py, if i == 0 { level - 0.01 } else { z - deep * 1.2 - (top - level) / bowls as f32 * 0.6 }],
                r * 0.012 + 0.002,
                if i == 0 { z - level } else { (top - level) / bowls as f32 * 0.6 + deep * 1.1 },
                WATER,
            );
        }
    }
    b.lathe(
        "finial",
        [0.0, 0.0, top - 0.01],
        &[(column * 0.5, 0.0), (column * 0.8, (h - top) * 0.4), (column * 0.3, (h - top) * 0.9), (0.0, h - top + 0.01)],
        mat,
    );
    let inner = r - t;
    let (from, to) = ((column * 1.6).max(r * 0.64), inner * 0.97);
    b.inside(
        "basin",
        [f32::midpoint(from, to), 0.0, level],
        ((to - from) / 2.0 - 0.005, (inner * 0.2).max(0.005)),
        rim - level + 0.02,
    );
}

/// A pond: stones around water of a free outline, with lilies.
pub(super) fn pond(b: &mut Build<'_>) {
    grown(b, [0.6, 0.75, 0.15]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let stones = b.rng.count(18, 30);
    let stone = b.one(&[ROCK, GRANITE, SANDSTONE, GRAVEL]);
    let rim = x.min(y) * b.vary(0.12, 0.18);
    let (bank, level) = (h * 0.35, h * 0.45);
    let waves = (b.vary(0.0, TAU), b.vary(0.03, 0.12));
    let reach = |a: f32| 1.0 - waves.1 * (1.0 + (2.0 * a + waves.0).cosine());
    let outline = |inset: f32, n: usize| -> Vec<(f32, f32)> {
        (0..n)
            .map(|i| TAU * i as f32 / n as f32)
            .map(|a| ((x - inset) * reach(a) * a.cosine(), (y - inset) * reach(a) * a.sine()))
            .collect()
    };
    b.prism("ground", Axis::Z, [0.0; 3], &outline(rim * 0.5, 28), bank, SOIL);
    b.prism("water", Axis::Z, [0.0, 0.0, bank * 0.5], &outline(rim * 1.2, 28), level - bank * 0.5, POOL_WATER);
    let tallest = b.rng.below(stones);
    for i in 0..stones {
        let a = TAU * i as f32 / stones as f32;
        let r = rim * b.vary(0.75, 1.0);
        let tall = if i == tallest { h } else { (level + h * b.vary(0.08, 0.3)).min(h) };
        let (cx, cy) = ((x - rim) * reach(a) * a.cosine(), (y - rim) * reach(a) * a.sine());
        let mut points = blob(b, [cx, cy, tall * 0.45], [r, r, tall * 0.55], 16, 0.2);
        points.push([cx, cy, tall]);
        points.iter_mut().for_each(|p| *p = [p[0].max(-x).min(x), p[1].max(-y).min(y), p[2].max(0.0).min(tall)]);
        b.hull("stone", &points, stone);
    }
    for _ in 0..b.rng.count(2, 5) {
        let (a, d) = (b.vary(0.5, 2.6), b.vary(0.45, 0.6));
        let (cx, cy, r) = (x * d * a.cosine(), y * d * a.sine(), rim * b.vary(0.4, 0.7));
        b.cylinder("lily", [cx, cy, level - 0.004], r, 0.009, LEAF);
        let points = blob(b, [cx, cy, level + r * 0.2], [r * 0.35, r * 0.35, r * 0.25], 14, 0.3);
        b.hull("flower", &points, PETAL_PINK);
    }
    let reeds = b.rng.count(4, 9);
    for i in 0..reeds {
        let a = 1.3 + 0.06 * i as f32;
        let at = [(x - rim * 1.6) * reach(a) * a.cosine(), (y - rim * 1.6) * reach(a) * a.sine(), bank];
        let tip = [at[0] + b.vary(-0.05, 0.05), at[1], h * b.vary(0.85, 1.0)];
        b.hull(
            "reed",
            &limb(at, tip, 0.012, 0.004).into_iter().map(|p| [p[0], p[1], p[2].min(h)]).collect::<Vec<P>>(),
            GRASS,
        );
    }
    let room = (x.min(y) - rim * 2.0) * 0.4;
    b.inside("basin", [0.0, -y * 0.25, level], (room.max(0.02), room.max(0.02)), 0.3_f32.min(h - level + 0.2));
}

/// A statue on a plinth: a bust, a figure, an urn, or an animal of stone.
pub(super) fn statue(b: &mut Build<'_>) {
    grown(b, [0.1, 0.1, 0.2]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (r, mat) = (x.min(y), b.one(&[MARBLE, SANDSTONE, CONCRETE, COPPER, GRANITE, PLASTER]));
    let foot = h * b.vary(0.12, 0.4);
    b.block("plinth", [-r, -r, 0.0], [r, r, foot * 0.2], mat);
    b.block("plinth", [-r * 0.85, -r * 0.85, foot * 0.2], [r * 0.85, r * 0.85, foot * 0.85], mat);
    b.block("plinth", [-r * 0.97, -r * 0.97, foot * 0.85], [r * 0.97, r * 0.97, foot], mat);
    let tall = h - foot;
    let at = |share: f32| foot + tall * share;
    match b.rng.below(4) {
        0 => {
            let head = (tall * 0.24).min(r * 0.7);
            b.lathe(
                "bust",
                [0.0, 0.0, foot],
                &[
                    (r * 0.45, 0.0),
                    (r * 0.3, tall * 0.12),
                    (r * 0.85, tall * 0.4),
                    (r * 0.8, tall * 0.5),
                    (r * 0.28, tall * 0.6),
                    (r * 0.26, (tall * 0.75).max(tall - head)),
                ],
                mat,
            );
            let points = blob(b, [r * 0.05, 0.0, h - head], [head * 0.85, head * 0.72, head], 40, 0.03);
            b.hull("head", &points, mat);
            b.hull(
                "nose",
                &[
                    [head * 0.8, head * 0.1, h - head * 1.2],
                    [head * 0.8, -head * 0.1, h - head * 1.2],
                    [head * 1.05, 0.0, h - head * 1.2],
                    [head * 0.75, 0.0, h - head * 0.8],
                ],
                mat,
            );
        }
        1 => {
            // A robed figure with one arm raised.
            let head = (tall * 0.085).min(r * 0.4);
            b.lathe(
                "robe",
                [0.0, 0.0, foot - 0.002],
                &[
                    (r * 0.75, 0.0),
                    (r * 0.55, tall * 0.3),
                    (r * 0.42, tall * 0.5),
                    (r * 0.5, tall * 0.7),
                    (r * 0.15, tall * 0.8),
                    (r * 0.14, (tall * 0.86).max(tall - head)),
                ],
                mat,
            );
            b.ball("head", [0.0, 0.0, h - head], head, mat);
            let up = b.rng.chance(0.5);
            for side in [-1.0, 1.0] {
                let elbow = [r * 0.2, side * r * 0.75, at(0.55)];
                let hand = if side > 0.0 && up {
                    [r * 0.4, side * r * 0.6, at(0.92)]
                } else {
                    [r * 0.55, side * r * 0.25, at(0.5)]
                };
                b.hull("arm", &limb([0.0, side * r * 0.42, at(0.7)], elbow, r * 0.16, r * 0.13), mat);
                b.hull("arm", &limb(elbow, hand, r * 0.13, r * 0.1), mat);
            }
        }
        2 => {
            let profile = [
                (r * 0.5, 0.0),
                (r * 0.5, tall * 0.06),
                (r * 0.2, tall * 0.14),
                (r * 0.8, tall * 0.5),
                (r * 0.85, tall * 0.65),
                (r * 0.6, tall * 0.8),
                (r * 0.8, tall * 0.97),
                (r * 0.8, tall),
                (r * 0.7, tall),
                (r * 0.5, tall * 0.8),
            ];
            b.lathe("urn", [0.0, 0.0, foot - 0.002], &profile, mat);
        }
        _ => {
            // A lion or dog, seated.
            let head = (tall * 0.16).min(r * 0.5);
            let neck = at(0.72).max(h - head * 1.7);
            let chest = limb([-r * 0.1, 0.0, at(0.1)], [r * 0.25, 0.0, neck], r * 0.45, r * 0.34);
            b.hull("body", &chest, mat);
            let points = blob(b, [-r * 0.3, 0.0, at(0.18)], [r * 0.55, r * 0.6, tall * 0.2], 26, 0.1);
            b.hull("body", &points.into_iter().map(|p| [p[0], p[1], p[2].max(foot - 0.002)]).collect::<Vec<P>>(), mat);
            let points = blob(b, [r * 0.35, 0.0, h - head], [head * 0.9, head, head], 30, 0.08);
            b.hull("head", &points, mat);
            b.hull(
                "muzzle",
                &limb(
                    [r * 0.35 + head * 0.5, 0.0, h - head * 1.15],
                    [(r * 0.35 + head * 1.3).min(r * 0.95), 0.0, h - head * 1.2],
                    head * 0.5,
                    head * 0.35,
                ),
                mat,
            );
            for side in [-1.0, 1.0] {
                b.hull(
                    "leg",
                    &limb([r * 0.5, side * r * 0.25, foot], [r * 0.35, side * r * 0.22, at(0.5)], r * 0.13, r * 0.15),
                    mat,
                );
                b.hull(
                    "ear",
                    &limb(
                        [r * 0.3, side * head * 0.6, h - head * 0.5],
                        [r * 0.28, side * head * 0.75, h - head * 0.1],
                        head * 0.22,
                        head * 0.08,
                    ),
                    mat,
                );
            }
        }
    }
}

/// A lantern: panes in a frame around a candle, or a paper-like drum.
pub(super) fn lantern(b: &mut Build<'_>) {
    grown(b, [0.05, 0.05, 0.08]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let metal = b.one(&[IRON, BLACK_METAL, BRASS, COPPER, WHITE_METAL, RUST, GREY_OAK]);
    let (low, eaves) = (h * 0.07, h * b.vary(0.58, 0.66));
    let sides = b.one(&[4, 4, 6]);
    let turn = PI / sides as f32;
    b.prism("base", Axis::Z, [0.0; 3], &fitted(sides, r, turn), low, metal);
    for (px, py) in fitted(sides, r * 0.88, turn) {
        b.rod("post", [px, py, low - 0.002], [px, py, eaves + 0.002], r * 0.07, metal);
    }
    b.prism("glass", Axis::Z, [0.0, 0.0, low], &fitted(sides, r * 0.84, turn), eaves - low, GLASS);
    let candle = (eaves - low) * b.vary(0.4, 0.7);
    b.cylinder("candle", [0.0, 0.0, low], r * 0.35, candle, WAX);
    b.lathe(
        "flame",
        [0.0, 0.0, low + candle - 0.003],
        &[(r * 0.06, 0.0), (r * 0.11, (eaves - low - candle) * 0.3), (0.0, (eaves - low - candle) * 0.8)],
        WARM_BULB,
    );
    let top = h * 0.83;
    let ring = |radius: f32, z: f32| fitted(sides, radius, turn).into_iter().map(move |(px, py)| [px, py, z]);
    b.hull("roof", &ring(r, eaves).chain(ring(r, eaves + 0.008)).chain(ring(r * 0.25, top)).collect::<Vec<P>>(), metal);
    b.cylinder("cap", [0.0, 0.0, top - 0.004], r * 0.2, h * 0.04, metal);
    let ring_r = (h - top - h * 0.03) / 2.0;
    let wire = (ring_r * 0.12).max(0.0015);
    b.lathe_along("ring", [0.0, -wire, h - ring_r], [0.0, 1.0, h - ring_r], &hoop(ring_r - wire, wire), metal);
}

/// A polygon that just fits a square of half side `half`.
fn fitted(sides: usize, half: f32, turn: f32) -> Vec<(f32, f32)> {
    let share = if sides == 4 { 2.0_f32.sqrt() } else { 1.0 };
    polygon(sides, half * share, turn)
}

/// A solar light on a spike.
pub(super) fn solar_light(b: &mut Build<'_>) {
    grown(b, [0.03, 0.03, 0.1]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let metal = b.one(&[STEEL, BLACK_PLASTIC, COPPER, WHITE_METAL]);
    let head = (r * b.vary(1.4, 2.2)).min(h * 0.4);
    let low = h - head;
    let spike = h * 0.2;
    b.lathe("spike", [0.0; 3], &[(0.0, 0.0), (r * 0.16, spike * 0.7), (r * 0.1, spike)], BLACK_PLASTIC);
    b.cylinder("pole", [0.0, 0.0, spike - 0.005], r * 0.12, low - spike + 0.01, metal);
    match b.rng.below(3) {
        0 => b.lathe("lamp", [0.0, 0.0, low], &[(r * 0.45, 0.0), (r * 0.8, head * 0.8)], WARM_BULB),
        1 => b.cylinder("lamp", [0.0, 0.0, low], r * 0.6, head * 0.8, COOL_BULB),
        _ => b.ball("lamp", [0.0, 0.0, low + head * 0.42], (head * 0.42).min(r * 0.95), WARM_BULB),
    }
    b.lathe("cap", [0.0, 0.0, low + head * 0.78], &[(r, 0.0), (r, head * 0.07), (r * 0.75, head * 0.2)], metal);
    b.block("panel", [-r * 0.45, -r * 0.45, low + head * 0.96], [r * 0.45, r * 0.45, h], BLACK_GLASS);
}

/// A wind chime: tubes of falling length under a disc, a clapper, a sail.
pub(super) fn wind_chime(b: &mut Build<'_>) {
    grown(b, [0.04, 0.04, 0.2]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let (metal, wood) = (b.one(&[ALUMINIUM, BRASS, COPPER, BAMBOO]), b.one(&[BEECH, WALNUT, BAMBOO, TEAK]));
    let disc = h * b.vary(0.78, 0.83);
    b.cylinder("disc", [0.0, 0.0, disc], r, 0.012_f32.min(h * 0.04), wood);
    let tubes = b.rng.count(4, 8);
    let radius = (r * 2.0 / tubes as f32).min(r * 0.25);
    let (longest, fall) = (h * b.vary(0.45, 0.55), b.vary(0.3, 0.6));
    for i in 0..tubes {
        let (px, py) = polar(TAU * i as f32 / tubes as f32, r - radius * 1.1);
        let long = longest * (1.0 - fall * i as f32 / tubes as f32);
        b.cylinder("tube", [px, py, disc - h * 0.07 - long], radius, long, metal);
        b.cylinder("cord", [px, py, disc - h * 0.075], 0.0015, h * 0.08, BLACK_FABRIC);
        b.rod("cord", [px, py, disc + 0.005], [0.0, 0.0, h - 0.02], 0.0015, BLACK_FABRIC);
    }
    let clapper = disc - longest * 0.5;
    b.cylinder("cord", [0.0, 0.0, h * 0.1], 0.0015, disc - h * 0.1 + 0.004, BLACK_FABRIC);
    b.cylinder("clapper", [0.0, 0.0, clapper], r * 0.35, 0.012_f32.min(h * 0.03), wood);
    b.prism(
        "sail",
        Axis::X,
        [-0.002, 0.0, 0.0],
        &[(0.0, h * 0.13), (r * 0.4, h * 0.07), (0.0, 0.0), (-r * 0.4, h * 0.07)],
        0.004,
        wood,
    );
    let ring = 0.01_f32.min(h * 0.03);
    b.lathe_along("ring", [0.0, -0.002, h - ring], [0.0, 1.0, h - ring], &hoop(ring - 0.002, 0.002), metal);
}

/// A scarecrow: a cross of poles, a coat, a straw head with a hat.
pub(super) fn scarecrow(b: &mut Build<'_>) {
    grown(b, [0.1, 0.4, 0.6]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let coat = b.one(&[RED_FABRIC, BLUE_FABRIC, BROWN_FABRIC, GREEN_FABRIC, DENIM]);
    let (hat, legs) = (b.one(&[HAY, BLACK_FABRIC, BROWN_FABRIC]), b.one(&[DENIM, BROWN_FABRIC, JUTE]));
    b.cylinder("pole", [0.0; 3], 0.02_f32.min(x * 0.4), h * 0.78, PINE);
    let arms = h * b.vary(0.66, 0.71);
    b.rod("cross", [0.0, -y + 0.03, arms], [0.0, y - 0.03, arms], 0.016_f32.min(x * 0.3), PINE);
    let wide = (y * 0.32).min(x * 1.4);
    let skirt: Vec<P> = [(h * 0.4, 1.1), (arms + h * 0.035, 0.85)]
        .into_iter()
        .flat_map(|(z, s)| polygon(8, 1.0, 0.39).into_iter().map(move |(px, py)| [px * x * 0.75, py * wide * s, z]))
        .collect();
    b.hull("coat", &skirt, coat);
    for side in [-1.0, 1.0] {
        let cuff = side * (y - 0.1_f32.min(y * 0.2));
        b.hull(
            "sleeve",
            &limb(
                [0.0, side * wide * 0.6, arms],
                [0.0, cuff, arms - h * 0.01],
                (h * 0.05).min(x * 0.6),
                (h * 0.042).min(x * 0.55),
            ),
            coat,
        );
        for i in 0..4 {
            let tip = [x * 0.4 * (i as f32 / 1.5 - 1.0), side * (y - 0.004), arms + h * 0.025 * (i as f32 - 1.8)];
            b.hull(
                "straw",
                &limb([0.0, cuff - side * 0.03, arms], tip, 0.008, 0.003)
                    .into_iter()
                    .map(|p| [p[0], p[1].max(-y).min(y), p[2]])
                    .collect::<Vec<P>>(),
                HAY,
            );
        }
        b.hull(
            "leg",
            &limb(
                [0.0, side * wide * 0.4, h * 0.42],
                [0.0, side * wide * 0.55, h * 0.14],
                (h * 0.05).min(x * 0.5),
                (h * 0.045).min(x * 0.5),
            ),
            legs,
        );
        let patch = b.one(&[MUSTARD_FABRIC, RED_FABRIC, GREEN_FABRIC]);
        b.block(
            "patch",
            [x * 0.4, side * wide * 0.35 - 0.03, h * 0.5 + 0.05 * side],
            [x * 0.76, side * wide * 0.35 + 0.03, h * 0.5 + 0.05 * side + 0.06],
            patch,
        );
    }
    let head = (h * 0.075).min(x * 0.75);
    let face = arms + h * 0.04 + head;
    let points = blob(b, [0.0, 0.0, face], [head * 0.95, head, head * 1.1], 36, 0.06);
    b.hull("head", &points, JUTE);
    for side in [-1.0, 1.0] {
        b.ball("eye", [head * 0.85, side * head * 0.35, face + head * 0.25], head * 0.12, BLACK);
    }
    b.block("mouth", [head * 0.7, -head * 0.4, face - head * 0.35], [head * 0.95, head * 0.4, face - head * 0.25], RED);
    let brim = face + head * 0.6;
    b.lathe(
        "hat",
        [0.0, 0.0, brim],
        &[
            (x.min(head * 1.9), 0.0),
            (x.min(head * 1.9), 0.008),
            (head * 0.95, 0.02),
            (head * 0.6, (h - brim) * 0.75),
            (head * 0.1, h - brim),
        ],
        hat,
    );
    b.lathe("band", [0.0, 0.0, brim + 0.015], &[(head, 0.0), (head * 0.93, 0.03_f32.min(h * 0.02))], coat);
}

/// N, W, S and E, as high as wide, around their middle.
const LETTERS: [&[(f32, f32)]; 4] = [
    &[
        (-1.0, -1.0),
        (-0.5, -1.0),
        (-0.5, 0.3),
        (0.5, -1.0),
        (1.0, -1.0),
        (1.0, 1.0),
        (0.5, 1.0),
        (0.5, -0.3),
        (-0.5, 1.0),
        (-1.0, 1.0),
    ],
    &[
        (-1.0, 1.0),
        (-0.65, -1.0),
        (-0.3, -1.0),
        (0.0, -0.1),
        (0.3, -1.0),
        (0.65, -1.0),
        (1.0, 1.0),
        (0.65, 1.0),
        (0.45, -0.3),
        (0.15, 0.5),
        (-0.15, 0.5),
        (-0.45, -0.3),
        (-0.65, 1.0),
    ],
    &[
        (-0.8, -1.0),
        (0.8, -1.0),
        (0.8, 0.2),
        (-0.35, 0.2),
        (-0.35, 0.6),
        (0.8, 0.6),
        (0.8, 1.0),
        (-0.8, 1.0),
        (-0.8, -0.2),
        (0.35, -0.2),
        (0.35, -0.6),
        (-0.8, -0.6),
    ],
    &[
        (-0.8, -1.0),
        (0.8, -1.0),
        (0.8, -0.6),
        (-0.35, -0.6),
        (-0.35, -0.2),
        (0.6, -0.2),
        (0.6, 0.2),
        (-0.35, 0.2),
        (-0.35, 0.6),
        (0.8, 0.6),
        (0.8, 1.0),
        (-0.8, 1.0),
    ],
];

/// A weather vane: a mast, letters of the compass, a turning arrow with a figure.
pub(super) fn weather_vane(b: &mut Build<'_>) {
    grown(b, [0.12, 0.12, 0.2]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let metal = b.one(&[IRON, COPPER, RUST, BLACK_METAL, BRASS]);
    let r = x.min(y);
    let figure = (r * 1.1).min(h * 0.45);
    let arms = h - figure - h * 0.12;
    let thin = (h * 0.008).clamp(0.004, 0.012);
    b.lathe("foot", [0.0; 3], &[(r * 0.5, 0.0), (r * 0.45, h * 0.02), (thin * 2.0, h * 0.05)], metal);
    // The arrow turns on its tip.
    b.cylinder("mast", [0.0, 0.0, h * 0.03], thin * 1.3, h * 0.97 - figure - thin * 0.8 + 0.001, metal);
    for (i, letter) in LETTERS.iter().enumerate() {
        let (px, py) = polar(FRAC_PI_2 * i as f32, r * 0.86);
        b.rod("arm", [0.0, 0.0, arms], [px, py, arms], thin * 0.7, metal);
        let s = (r * 0.11).min(h * 0.05);
        let outline: Vec<(f32, f32)> = letter.iter().map(|&(u, v)| (py + s * u, arms + s * v)).collect();
        b.prism("letter", Axis::X, [px - s * 0.25, 0.0, 0.0], &outline, s * 0.5, metal);
    }
    b.ball("ball", [0.0, 0.0, arms + h * 0.04], thin * 2.5, BRASS);
    let z = h - figure;
    let turn = b.vary(-1.0, 1.0);
    b.jointed(vc_graph::asset::JointKind::Hinge, [0.0; 3], [0.0, 0.0, 1.0], (-1e4, 1e4), |b| {
        b.at([0.0; 3], turn, |b| {
            let reach = r * 0.97;
            b.rod("arrow", [0.0, -reach * 0.85, z], [0.0, reach * 0.85, z], thin * 0.8, metal);
            let (tip, w) = (reach * 0.97, figure * 0.13);
            b.prism(
                "arrow",
                Axis::X,
                [-thin * 0.5, 0.0, z],
                &[(reach * 0.72, -w), (tip, 0.0), (reach * 0.72, w)],
                thin,
                metal,
            );
            b.prism(
                "arrow",
                Axis::X,
                [-thin * 0.5, 0.0, z],
                &[(-tip, -w), (-reach * 0.7, -w * 0.2), (-reach * 0.7, w * 0.2), (-tip, w)],
                thin,
                metal,
            );
            cock(b, z, (figure, thin), metal);
        });
    });
}

/// A cock in outline, or a ship, or a running star, standing at a height.
fn cock(b: &mut Build<'_>, z: f32, (tall, thin): (f32, f32), metal: Mat) {
    let cockerel = [
        (-0.08, 0.0),
        (0.08, 0.0),
        (0.1, 0.22),
        (0.28, 0.4),
        (0.36, 0.7),
        (0.5, 0.74),
        (0.37, 0.82),
        (0.33, 0.97),
        (0.2, 1.0),
        (0.17, 0.85),
        (0.1, 0.6),
        (-0.1, 0.5),
        (-0.3, 0.85),
        (-0.5, 0.88),
        (-0.58, 0.65),
        (-0.45, 0.4),
        (-0.2, 0.2),
    ];
    let ship = [
        (-0.05, 0.0),
        (0.3, 0.03),
        (0.45, 0.22),
        (0.06, 0.22),
        (0.06, 0.3),
        (0.4, 0.35),
        (0.06, 0.98),
        (-0.02, 0.98),
        (-0.35, 0.35),
        (-0.02, 0.3),
        (-0.02, 0.22),
        (-0.45, 0.22),
        (-0.3, 0.03),
    ];
    let scale = |points: &[(f32, f32)]| -> Vec<(f32, f32)> {
        points.iter().map(|&(py, pz)| (py * tall * 0.75, pz * tall)).collect()
    };
    let outline = match b.rng.below(3) {
        0 => scale(&cockerel),
        1 => scale(&ship),
        _ => star(b.rng.count(5, 9), tall * 0.5, tall * 0.22)
            .into_iter()
            .map(|(py, pz)| (py, pz * 0.99 + tall * 0.5))
            .collect(),
    };
    b.prism("figure", Axis::X, [-thin * 0.4, 0.0, z], &outline, thin * 0.8, metal);
}
