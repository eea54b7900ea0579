//! Equipment at the edge of a pool: boards, ladders, slides, showers.

use std::f32::consts::PI;

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Axis, Build, at_least, spaced};

/// A springboard on its stand; the board extends to the front.
pub(super) fn diving_board(b: &mut Build<'_>) {
    at_least(b, [0.8, 0.18, 0.2]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (board, stand) = (b.choose(&[SKY, WHITE, BLUE, CREAM]), b.choose(&[STEEL, WHITE_METAL, CONCRETE, ANTHRACITE]));
    let rails = h > 0.7 && b.rng.chance(0.6);
    let top = if rails { h * 0.55 } else { h - 0.002 };
    let t = 0.05;
    b.rounded_block("board", [-x, -y * 0.92, top - t], [x, y * 0.92, top], 0.012, board);
    b.block("grip", [-x * 0.98, -y * 0.8, top - 0.004], [x * 0.985, y * 0.8, top + 0.002], GREY_RUBBER);
    let (rear, roll) = ((-x * 0.88).max(-x + 0.15), -x * b.vary(0.0, 0.25));
    for (cx, wide) in [(rear, 0.1), (roll, 0.07)] {
        b.taper("stand", [cx, 0.0, 0.0], (wide * 1.5, y), (wide, y * 0.85), top - t + 0.003, stand);
    }
    b.block("base", [rear, -y * 0.5, 0.0], [roll, y * 0.5, 0.03], stand);
    if rails {
        for s in [-1.0, 1.0] {
            let (cy, r) = (s * (y - 0.02), 0.016);
            b.pipe(
                "rail",
                &[
                    [rear + 0.02, cy, top * 0.4],
                    [rear + 0.02, cy, h - r],
                    [roll * 0.9, cy, h - r],
                    [roll, cy, top * 0.4],
                ],
                r,
                STEEL,
            );
            b.rod("bracket", [rear + 0.02, cy, top * 0.45], [rear + 0.02, s * y * 0.6, top * 0.45], 0.012, STEEL);
            b.rod("bracket", [roll, cy, top * 0.45], [roll, s * y * 0.6, top * 0.45], 0.012, STEEL);
        }
    }
    b.top("board", [0.0, 0.0, top + 0.002], (x * 0.96, y * 0.75));
}

/// A ladder over a pool's edge: bent rails, or an A-frame of steps for above-ground pools.
pub(super) fn pool_ladder(b: &mut Build<'_>) {
    at_least(b, [0.25, 0.25, 0.6]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (steel, tread) = (b.choose(&[STEEL, WHITE_METAL, CHROME]), b.choose(&[WHITE_PLASTIC, GREY_PLASTIC, SKY]));
    let r = 0.02;
    let both = b.rng.chance(0.5);
    let (front, back, top) = (x - r * 1.5, -x + r * 1.5, h - r * 1.5);
    for s in [-1.0, 1.0] {
        let cy = s * (y - r);
        let foot = if both { r } else { h * 0.45 };
        b.pipe(
            "rail",
            &[
                [front, cy, r],
                [front * 0.95, cy, top - x * 0.3],
                [front * 0.5, cy, top],
                [back * 0.5, cy, top],
                [back * 0.95, cy, top - x * 0.3],
                [back, cy, foot],
            ],
            r,
            steel,
        );
    }
    let steps = b.rng.count(3, 5);
    for z in spaced(steps, h * 0.12, h * 0.68) {
        b.block("tread", [front - 0.05, -y + r, z - 0.014], [front + r, y - r, z + 0.014], tread);
        if both {
            b.block("tread", [back - r, -y + r, z - 0.014], [back + 0.05, y - r, z + 0.014], tread);
        }
    }
    if !both {
        b.block("flange", [back - r, -y, h * 0.44], [back + 0.04, y, h * 0.44 + 0.02], steel);
    }
    b.rod("brace", [front, -y + r, h * 0.06], [front, y - r, h * 0.06], r * 0.8, steel);
}

/// A slide into the pool: steps at the back, a trough that curves down to the front.
pub(super) fn pool_slide(b: &mut Build<'_>) {
    at_least(b, [0.9, 0.28, 0.6]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y.min(b.size.x * 0.4) / 2.0, b.size.z);
    let (mat, steel) =
        (b.choose(&[SKY, WHITE_PLASTIC, BLUE_PLASTIC, YELLOW_PLASTIC, RED_PLASTIC]), b.choose(&[STEEL, WHITE_METAL]));
    let platform = h * b.vary(0.66, 0.74);
    let (start, wide) = (-x * 0.55, y * 0.85);
    let at = |t: f32| [start + (x - start) * t, platform * (0.12 + 0.88 * (0.5 + 0.5 * (PI * t.power(0.85)).cosine()))];
    let steps = 9;
    let t = 0.015;
    let bed: Vec<[f32; 2]> = spaced(steps, 0.0, 1.0).map(at).collect();
    let strip = |lift: f32, thick: f32| -> Vec<(f32, f32)> {
        bed.iter().map(|p| (p[0], p[1] + lift)).chain(bed.iter().rev().map(|p| (p[0], p[1] + lift - thick))).collect()
    };
    b.prism("bed", Axis::Y, [0.0, -wide, 0.0], &strip(0.0, t), 2.0 * wide, mat);
    let lip = (h - platform).min(0.2) * 0.9;
    for s in [-1.0, 1.0] {
        b.prism(
            "side",
            Axis::Y,
            [0.0, s * wide - if s < 0.0 { t } else { 0.0 }, 0.0],
            &strip(lip, lip + t * 0.8),
            t,
            mat,
        );
    }
    b.block("platform", [-x * 0.85, -wide, platform - 0.04], [start + 0.04, wide, platform - t - 0.001], mat);
    let r = 0.022;
    for s in [-1.0, 1.0] {
        let cy = s * wide * 0.92;
        b.rod("stile", [-x + r, cy, r], [-x * 0.82, cy, platform - 0.02], r, steel);
        b.rod("leg", [start, cy, 0.0], [start, cy, platform - 0.03], r, steel);
        b.pipe(
            "rail",
            &[
                [-x * 0.9, cy, platform * 0.62],
                [-x * 0.84, cy, h - r * 1.2],
                [start, cy, h - r * 1.2],
                [start + 0.04, cy, platform - 0.01],
            ],
            r * 0.9,
            steel,
        );
        let low = at(0.75);
        b.rod("leg", [low[0], cy, 0.0], [low[0], cy, low[1]], r, steel);
    }
    let treads = ((platform / 0.26) as usize).clamp(2, 8);
    for z in spaced(treads, platform * 0.12, platform * 0.86) {
        let cx = -x + r + (x * 0.18 - r) * z / platform;
        b.block(
            "tread",
            [cx - 0.05_f32.min(x * 0.03), -wide * 0.92, z - 0.012],
            [cx + 0.05, wide * 0.92, z + 0.012],
            steel,
        );
    }
    b.block("base", [-x * 0.96, -wide * 0.9, 0.0], [start, -wide * 0.8, 0.02], steel);
    b.block("base", [-x * 0.96, wide * 0.8, 0.0], [start, wide * 0.9, 0.02], steel);
}

/// A solar shower: a dark column, a head, a tap.
pub(super) fn solar_shower(b: &mut Build<'_>) {
    at_least(b, [0.1, 0.1, 0.9]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, metal) = (b.choose(&[BLACK_PLASTIC, ANTHRACITE, NAVY, SILVER_METAL]), b.choose(&[CHROME, STEEL]));
    let foot = x.min(y);
    let r = (foot * b.vary(0.32, 0.45)).min(0.08);
    let back = -x + foot;
    b.lathe("foot", [back, 0.0, 0.0], &[(foot, 0.0), (foot * 0.95, 0.02), (r * 1.2, 0.035)], mat);
    let bend = h * b.vary(0.9, 0.94);
    if b.rng.chance(0.5) {
        b.lathe("column", [back, 0.0, 0.01], &[(r, 0.0), (r, bend - 0.02), (r * 0.5, bend + 0.02)], mat);
    } else {
        b.rounded_block("column", [back - r, -r * 0.9, 0.01], [back + r, r * 0.9, bend + 0.02], r * 0.5, mat);
    }
    let tube = (r * 0.3).min(0.014);
    let head = (x * 0.4).min(0.08).min(y);
    let reach = (x - head).max(back + 0.01);
    b.pipe(
        "arm",
        &[[back, 0.0, bend], [back + (reach - back) * 0.3, 0.0, h - tube * 1.2], [reach, 0.0, h - tube * 1.2]],
        tube,
        metal,
    );
    b.lathe("head", [reach, 0.0, h - tube - 0.045], &[(head * 0.95, 0.0), (head, 0.012), (tube, 0.035)], metal);
    let z = h * 0.52;
    b.hinge([back, 0.0, z], [1.0, 0.0, 0.0], PI * 0.5, |b| {
        b.rod("tap", [back + r - 0.004, 0.0, z], [(back + r + 0.04).min(x), 0.0, z], 0.02_f32.min(r * 0.6), metal);
        b.block(
            "tap",
            [(back + r + 0.028).min(x - 0.012), -0.008, z - 0.002],
            [(back + r + 0.04).min(x), 0.008, z + 0.05],
            metal,
        );
    });
    b.rod("foot_tap", [back + r * 0.8, 0.0, h * 0.12], [(back + r + 0.03).min(x), 0.0, h * 0.12], 0.012, metal);
}
