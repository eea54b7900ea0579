//! Flower and vegetable beds, lawns, sunflowers and stepping stones.

use std::f32::consts::TAU;

use crate::material::*;
use crate::solid::{Axis, Build, P, at_least, blob, plate, polar, polygon, spaced};

/// Builds the edging of a bed and returns its wall thickness and height.
fn edging(b: &mut Build<'_>, most: f32) -> (f32, f32) {
    let (x, y) = (b.size.x / 2.0, b.size.y / 2.0);
    let high = (most * b.vary(0.25, 0.5)).max(0.03);
    let (t, mat) = match b.rng.below(4) {
        0 => (0.028, b.style.wood),
        1 => (0.1_f32.min(x * 0.3), BRICK),
        2 => (0.006, RUST),
        _ => (0.05, b.choose(&[GRANITE, CONCRETE, SANDSTONE])),
    };
    let blocks = if t > 0.04 { b.rng.count(3, 9) } else { 1 };
    for side in [-1.0, 1.0] {
        let cx = side * (x - t / 2.0);
        let step = 2.0 * y / blocks as f32;
        for cy in spaced(blocks, -y + step / 2.0, y - step / 2.0) {
            let gap = if blocks > 1 { 0.004 } else { 0.0 };
            let half = step / 2.0 - gap;
            b.block("edging", [cx - t / 2.0, cy - half, 0.0], [cx + t / 2.0, cy + half, high], mat);
        }
        let cy = side * (y - t / 2.0);
        b.block("edging", [-x + t, cy - t / 2.0, 0.0], [x - t, cy + t / 2.0, high - 0.002], mat);
    }
    (t, high)
}

/// Soil between the edges, slightly raised in the centre.
fn soil(b: &mut Build<'_>, edge: f32, level: f32) {
    let (x, y) = (b.size.x / 2.0 - edge, b.size.y / 2.0 - edge);
    b.block("soil", [-x, -y, 0.0], [x, y, level * 0.7], SOIL);
    b.taper("soil", [0.0, 0.0, level * 0.7], (x, y), (x * 0.75, y * 0.85), level * 0.25, SOIL);
}

/// A flower bed: soil in an edging and clumps of flowers.
pub(super) fn flower_bed(b: &mut Build<'_>) {
    at_least(b, [0.2, 0.4, 0.08]);
    let h = b.size.z;
    let (edge, level) = edging(b, h);
    soil(b, edge, level);
    let (x, y) = (b.size.x / 2.0 - edge, b.size.y / 2.0 - edge);
    let rows = ((x / 0.2) as usize).clamp(1, 4);
    let columns = ((y / 0.14) as usize).max(2).min(18 / rows);
    let (first, second) = (b.rng.below(5), b.rng.below(5));
    let petals = [PETAL_RED, PETAL_WHITE, PETAL_YELLOW, PETAL_PINK, PETAL_BLUE];
    let leaves = b.choose(&[LEAF, DARK_LEAF, LIGHT_LEAF]);
    let (rx, ry) = (x / rows as f32, y / columns as f32);
    let tallest = b.rng.below(rows);
    for (i, cx) in spaced(rows, -x + rx, x - rx).enumerate() {
        for cy in spaced(columns, -y + ry, y - ry) {
            let top = h * if i == tallest { b.vary(0.85, 1.0) } else { b.vary(0.6, 0.85) };
            let petal = petals[if b.rng.chance(0.6) { first } else { second }];
            let at = [cx + b.vary(-0.2, 0.2) * rx, cy + b.vary(-0.2, 0.2) * ry, level * 0.8];
            clump(b, at, (rx.min(0.2) * 0.8, ry.min(0.2) * 0.8), top, (leaves, petal));
        }
    }
}

/// A clump of leaves with two flower heads above.
fn clump(b: &mut Build<'_>, at: P, half: (f32, f32), top: f32, mats: (MaterialId, MaterialId)) {
    let tall = (top - at[2]).max(0.02);
    let points = blob(b, [at[0], at[1], at[2] + tall * 0.3], [half.0, half.1, tall * 0.35], 16, 0.4);
    b.hull("leaves", &points, mats.0);
    let head = half.0.min(half.1).min(tall * 0.4) * 0.6;
    let stem = [at[0], at[1], at[2] + tall - head];
    b.rod("stem", at, stem, (head * 0.15).max(0.002), mats.0);
    let points = blob(b, stem, [head, head, head * 0.9], 14, 0.2);
    b.hull("flower", &points, mats.1);
    let (dx, dy) = polar(b.vary(0.0, TAU), head * 0.5);
    let low = [at[0] + dx, at[1] + dy, at[2] + tall * 0.62];
    let points = blob(b, low, [head * 0.8, head * 0.8, head * 0.6], 12, 0.2);
    b.hull("flower", &points, mats.1);
}

/// A vegetable patch: rows of cabbage, lettuce, carrots, onions and staked tomatoes.
pub(super) fn vegetable_patch(b: &mut Build<'_>) {
    at_least(b, [0.3, 0.6, 0.075]);
    let h = b.size.z;
    let (edge, level) = edging(b, h.min(0.35));
    let level = level.min(h * 0.5);
    soil(b, edge, level);
    let (x, y) = (b.size.x / 2.0 - edge, b.size.y / 2.0 - edge);
    let rows = ((2.0 * y / 0.55) as usize).clamp(2, 5);
    let per_row = ((2.0 * x / 0.3) as usize).clamp(2, 4);
    let half = (x / per_row as f32, y / rows as f32);
    let tall_row = b.rng.below(rows);
    for (i, cy) in spaced(rows, -y + half.1, y - half.1).enumerate() {
        let kind = b.rng.below(4);
        b.taper("ridge", [0.0, cy, level * 0.7], (x, half.1 * 0.8), (x * 0.95, half.1 * 0.4), level * 0.35, SOIL);
        for cx in spaced(per_row, -x + half.0, x - half.0) {
            let at = [cx, cy, level];
            let r = half.0.min(half.1).min(0.2) * b.vary(0.7, 0.95);
            match (i == tall_row, kind) {
                (true, _) => tomato(b, at, r, h),
                (_, 0) => head(b, at, r, (h - level).min(r * 1.3), LIGHT_LEAF),
                (_, 1) => head(b, at, r, (h - level).min(r * 1.6), LEAF),
                _ => tuft(b, at, r * 0.7, (h - level).min(0.25), if kind == 2 { LEAF } else { GRASS }),
            }
        }
    }
}

/// A leafy head: cabbage or lettuce.
fn head(b: &mut Build<'_>, at: P, r: f32, tall: f32, mat: MaterialId) {
    let points = blob(b, [at[0], at[1], at[2] + tall * 0.25], [r, r, tall * 0.4], 18, 0.35);
    b.hull("leaves", &points, mat);
    let points = blob(b, [at[0], at[1], at[2] + tall * 0.55], [r * 0.6, r * 0.6, tall * 0.45], 20, 0.1);
    b.hull("head", &points, LIGHT_LEAF);
}

/// A tuft of narrow leaves: carrots, onions.
fn tuft(b: &mut Build<'_>, at: P, r: f32, tall: f32, mat: MaterialId) {
    for i in 0..4 {
        let (dx, dy) = polar(1.6 * i as f32 + b.vary(0.0, 0.6), r);
        let tip = [at[0] + dx, at[1] + dy, at[2] + tall * b.vary(0.75, 1.0)];
        let w = r * 0.16;
        let foot = [[w, 0.0], [-w, w], [-w, -w]].map(|[x, y]| [at[0] + x, at[1] + y, at[2] - 0.03]);
        b.hull("leaf", &[foot[0], foot[1], foot[2], tip], mat);
    }
}

/// A tomato plant tied to its stake.
fn tomato(b: &mut Build<'_>, at: P, r: f32, top: f32) {
    b.cylinder("stake", [at[0], at[1], at[2] - 0.02], 0.009, top - at[2] + 0.02, BAMBOO);
    let tall = (top - at[2]) * 0.92;
    let points = blob(b, [at[0], at[1], at[2] + tall * 0.5], [r * 0.9, r * 0.9, tall * 0.5], 22, 0.45);
    b.hull("leaves", &points, LEAF);
    for i in 0..3 {
        let (dx, dy) = polar(2.2 * i as f32, r * 0.62);
        let points = blob(
            b,
            [at[0] + dx, at[1] + dy, at[2] + tall * (0.3 + 0.17 * i as f32)],
            [(r * 0.22).min(tall * 0.3); 3],
            14,
            0.05,
        );
        b.hull("tomato", &points, RED_SKIN);
    }
}

/// A lawn: mown stripes, edged or with taller grass along its rim.
pub(super) fn lawn(b: &mut Build<'_>) {
    at_least(b, [0.5, 0.5, 0.015]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let edged = b.rng.chance(0.5);
    let rim = if edged { 0.08_f32.min(x * 0.2).min(y * 0.2) } else { 0.0 };
    let high = if edged { h } else { h * 0.55 };
    let count = ((2.0 * y / b.vary(0.4, 0.9)) as usize).clamp(2, 24);
    let half = (y - rim) / count as f32;
    for (i, cy) in spaced(count, -y + rim + half, y - rim - half).enumerate() {
        let (level, mat) = if i % 2 == 0 { (high - 0.004, GRASS) } else { (high - 0.006, LEAF) };
        b.block("grass", [-x + rim, cy - half, 0.0], [x - rim, cy + half, level.max(0.005)], mat);
    }
    if edged {
        let mat = b.choose(&[GRANITE, BRICK, CONCRETE, SANDSTONE]);
        for side in [-1.0, 1.0] {
            let (cx, cy) = (side * (x - rim / 2.0), side * (y - rim / 2.0));
            b.block("edge", [cx - rim / 2.0, -y, 0.0], [cx + rim / 2.0, y, high - 0.002], mat);
            b.block("edge", [-x + rim, cy - rim / 2.0, 0.0], [x - rim, cy + rim / 2.0, high - 0.001], mat);
        }
    } else {
        for i in 0..b.rng.count(16, 40) {
            let (sx, sy) = (b.vary(-0.97, 0.97), b.vary(-0.97, 0.97));
            let edge = if i % 2 == 0 { 1.0_f32 } else { -1.0 };
            let at = if i % 4 < 2 { [edge * (x - 0.03), sy * y] } else { [sx * x, edge * (y - 0.03)] };
            let tall = h * b.vary(0.8, 1.0);
            b.cone("tuft", [at[0], at[1], 0.0], 0.025, tall, LEAF);
        }
    }
    b.top("lawn", [0.0, 0.0, high - 0.004], ((x - rim) * 0.85, (y - rim) * 0.85));
}

/// A sunflower that faces the front.
pub(super) fn sunflower(b: &mut Build<'_>) {
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let r = y.min(h * 0.18);
    let (centre, back) = (h - r, x * b.vary(-0.35, -0.1));
    b.rod("stem", [back, 0.0, 0.0], [back * 0.5, 0.0, centre * 0.6], 0.012, LEAF);
    b.rod("stem", [back * 0.5, 0.0, centre * 0.6], [x * 0.55, 0.0, centre], 0.01, LEAF);
    let mound = x.min(y) * 0.95;
    b.lathe("earth", [0.0; 3], &[(mound, 0.0), (mound * 0.6, 0.02), (0.0, 0.03)], SOIL);
    let petals = b.rng.count(13, 19);
    let core = r * b.vary(0.42, 0.55);
    for (layer, share) in [(0.0, 1.0), (0.5, 0.9)] {
        for i in 0..petals {
            let angle = TAU * (i as f32 + layer) / petals as f32;
            let at = |out: f32, aside: f32| {
                let ((dy, dz), (ay, az)) = (polar(angle, out), polar(angle + TAU / 4.0, aside));
                (dy + ay, dz + az)
            };
            let (w, tip) = (core * 0.22, r * share * 0.995);
            let outline = [
                at(core * 0.8, -w * 0.6),
                at(core * 1.3, -w),
                at(tip, 0.0),
                at(core * 1.3, w),
                at(core * 0.8, w * 0.6),
            ];
            b.prism("petal", Axis::X, [x * (0.6 + 0.16 * layer), 0.0, centre], &outline, 0.004, PETAL_YELLOW);
        }
    }
    b.lathe_along(
        "disc",
        [x * 0.5, 0.0, centre],
        [x, 0.0, centre],
        &[(core, 0.0), (core, x * 0.3), (core * 0.7, x * 0.49)],
        BROWN_SKIN,
    );
    let leaves = b.rng.count(2, 5);
    for i in 0..leaves {
        let side = if i % 2 == 0 { 1.0 } else { -1.0 };
        let z = centre * (0.2 + 0.5 * i as f32 / leaves as f32);
        let (reach, w) = (y * 0.85, (y * 0.3).min(x * 0.65));
        let (rise, cx) = (y * b.vary(0.1, 0.4), back * (1.0 - 0.5 * z / (centre * 0.6)));
        let quad = [
            [cx, 0.0, z],
            [cx - w, side * reach * 0.5, z + rise],
            [cx, side * reach, z + rise * 0.3],
            [cx + w, side * reach * 0.5, z + rise],
        ];
        plate(b, "leaf", quad, 0.004 * side, LEAF);
    }
}

/// A stepping stone: round, square, polygonal or a slice of a log.
pub(super) fn stepping_stone(b: &mut Build<'_>) {
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let stone = b.choose(&[GRANITE, SANDSTONE, CONCRETE, ROCK, GRAVEL, SLATE_TILE]);
    match b.rng.below(4) {
        0 => b.rounded_block("slab", [-x, -y, 0.0], [x, y, h], 0.008, stone),
        1 => {
            let r = x.min(y);
            b.lathe("slab", [0.0; 3], &[(r, 0.0), (r, h * 0.8), (r - h * 0.2, h)], stone);
        }
        2 => {
            let r = x.min(y);
            b.cylinder("bark", [0.0; 3], r, h - 0.003, BARK);
            b.cylinder("wood", [0.0; 3], r * 0.92, h, PINE);
        }
        _ => {
            let corners = b.rng.count(6, 10);
            let mut outline = polygon(corners, 1.0, 0.0);
            for p in &mut outline {
                let share = b.vary(0.82, 1.0);
                *p = (p.0 * x * share, p.1 * y * share);
            }
            b.prism("slab", Axis::Z, [0.0; 3], &outline, h, stone);
        }
    }
    b.top("top", [0.0, 0.0, h], (x.min(y) * 0.5, x.min(y) * 0.5));
}
