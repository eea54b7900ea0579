//! Pools, tubs and their covers.

use std::f32::consts::FRAC_PI_2;

use vc_graph::portable::Portable;

use super::BRIGHT;
use crate::material::*;
use crate::solid::{Axis, Build, P, at_least, polygon, ring_wall, spaced, tapered_tub, torus_profile};

/// A pool above the ground: rectangular, oval or round; tiled, boarded or of steel; with coping,
/// water and sometimes steps.
pub(super) fn pool(b: &mut Build<'_>) {
    at_least(b, [1.2, 2.0, 0.45]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (wall, lining) = (
        b.choose(&[CONCRETE, PINE, WHITE_METAL, SANDSTONE, TEAK, ANTHRACITE]),
        b.choose(&[BLUE_TILE, WHITE_TILE, SKY, BLUE_TILE]),
    );
    let coping = b.choose(&[SANDSTONE, TEAK, GRANITE, WHITE_TILE, CONCRETE]);
    let (t, broad) = (0.12, b.vary(0.2, 0.32).min(x * 0.25));
    let ladder = b.rng.chance(0.6);
    let top = h - if ladder { (h * 0.3).min(0.45) } else { 0.0 };
    let (slab, level) = (0.05, top - 0.14);
    let floor = 0.06;
    if b.rng.chance(0.6) {
        b.block("floor", [-x + t, -y + t, 0.0], [x - t, y - t, floor], lining);
        for s in [-1.0, 1.0] {
            let (cx, cy) = (s * (x - t / 2.0 - 0.03), s * (y - t / 2.0 - 0.03));
            b.block("wall", [cx - t / 2.0, -y + 0.03, 0.0], [cx + t / 2.0, y - 0.03, top - slab], wall);
            b.block("wall", [-x + t + 0.03, cy - t / 2.0, 0.001], [x - t - 0.03, cy + t / 2.0, top - slab], wall);
            let (ox, oy) = (s * (x - broad / 2.0), s * (y - broad / 2.0));
            b.block("coping", [ox - broad / 2.0, -y, top - slab], [ox + broad / 2.0, y, top], coping);
            b.block(
                "coping",
                [-x + broad, oy - broad / 2.0, top - slab],
                [x - broad, oy + broad / 2.0, top - 0.001],
                coping,
            );
        }
        let (ix, iy) = (x - t - 0.03, y - t - 0.03);
        b.block("water", [-ix - 0.004, -iy - 0.004, floor - 0.01], [ix + 0.004, iy + 0.004, level], POOL_WATER);
        let steps = if b.rng.chance(0.5) { 3 } else { 0 };
        for i in 0..steps {
            let deep = iy * 0.14 * (3 - i) as f32;
            b.block(
                "step",
                [-ix * 0.6, iy - deep, floor - 0.01],
                [ix * 0.6, iy + 0.005, floor + (level - floor) * 0.27 * (i + 1) as f32],
                lining,
            );
        }
        b.inside("basin", [0.0, 0.0, level], (x - broad - 0.02, y - broad - 0.02), top - level);
    } else {
        let sides = 36;
        let oval = |dx: f32, dy: f32| -> Vec<(f32, f32)> {
            // A superellipse, between a rectangle and an ellipse.
            let bow = |v: f32| v.signum() * v.abs().power(0.75);
            polygon(sides, 1.0, 0.0).into_iter().map(|(a, c)| (bow(a) * dx, bow(c) * dy)).collect()
        };
        b.prism("floor", Axis::Z, [0.0; 3], &oval(x - t * 0.8, y - t * 0.8), floor, lining);
        ring_wall(b, "wall", [&oval(x - 0.03, y - 0.03), &oval(x - t, y - t)], (0.001, top - slab), wall);
        ring_wall(b, "coping", [&oval(x, y), &oval(x - broad, y - broad)], (top - slab, top), coping);
        b.prism(
            "water",
            Axis::Z,
            [0.0, 0.0, floor - 0.01],
            &oval(x - t + 0.004, y - t + 0.004),
            level - floor + 0.01,
            POOL_WATER,
        );
        b.inside("basin", [0.0, 0.0, level], ((x - broad) * 0.72, (y - broad) * 0.72), top - level);
    }
    if ladder {
        let (cx, at) = (x * b.vary(-0.3, 0.3), y - broad);
        grab_ladder(b, [cx, at, top], (h - top, (level - floor) * 0.7 + 0.1), broad * 0.5);
    }
}

/// Two bent rails over an edge at `at` towards -Y, as high above the edge as below, with treads
/// between them.
fn grab_ladder(b: &mut Build<'_>, at: P, (over, below): (f32, f32), back: f32) {
    let [cx, cy, z] = at;
    let (r, half) = (0.02, 0.25);
    let over = over - 1.3 * r;
    for s in [-1.0, 1.0] {
        let px = cx + s * half;
        b.pipe(
            "rail",
            &[
                [px, cy + back, z - 0.01],
                [px, cy + back, z + over * 0.8],
                [px, cy + back * 0.5, z + over],
                [px, cy - 0.08, z + over * 0.8],
                [px, cy - 0.1, z - below],
            ],
            r,
            STEEL,
        );
    }
    let treads = b.rng.count(2, 4);
    for tz in spaced(treads, z - below + 0.06, z - 0.12) {
        b.block("tread", [cx - half, cy - 0.14, tz - 0.012], [cx + half, cy - 0.06, tz + 0.012], WHITE_PLASTIC);
    }
}

/// An inflatable round pool with bright rings, or a rigid plastic shell.
pub(super) fn kiddie_pool(b: &mut Build<'_>) {
    at_least(b, [0.4, 0.4, 0.1]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let base = b.one_of(BRIGHT);
    if (x - y).abs() < 0.25 || b.rng.chance(0.5) {
        let r = x.min(y);
        let rings = b.rng.count(2, 4);
        let s = (h / (1.86 * rings as f32 + 0.1)).min(r * 0.2);
        let level = (s * (1.86 * rings as f32 - 1.1)).max(0.03);
        b.cylinder("floor", [0.0, 0.0, 0.001], r - s, 0.02, base);
        for i in 0..rings {
            let mat = if i % 2 == 0 { base } else { b.one_of(BRIGHT) };
            b.lathe("ring", [0.0, 0.0, 1.86 * s * i as f32], &torus_profile(r - s, s), mat);
        }
        b.cylinder("water", [0.0, 0.0, 0.01], r - 1.5 * s, level - 0.01, POOL_WATER);
        b.inside("basin", [0.0, 0.0, level], ((r - 2.0 * s) * 0.69, (r - 2.0 * s) * 0.69), h - level);
    } else {
        let (t, lean) = (0.02, b.vary(0.8, 0.92));
        tapered_tub(b, "shell", [0.0; 3], (x * lean, y * lean), (x - 0.015, y - 0.015), h - 0.02, t, base);
        let rim = 0.035;
        for s in [-1.0, 1.0] {
            b.block(
                "rim",
                [s * (x - rim / 2.0) - rim / 2.0, -y, h - 0.022],
                [s * (x - rim / 2.0) + rim / 2.0, y, h],
                WHITE_PLASTIC,
            );
            b.block(
                "rim",
                [-x + rim, s * (y - rim / 2.0) - rim / 2.0, h - 0.022],
                [x - rim, s * (y - rim / 2.0) + rim / 2.0, h - 0.001],
                WHITE_PLASTIC,
            );
        }
        let level = h * 0.6;
        let wide = lean + (1.0 - lean) * 0.15;
        b.taper(
            "water",
            [0.0, 0.0, t * 0.6],
            (x * lean - t * 0.5, y * lean - t * 0.5),
            (x * wide - t * 0.5, y * wide - t * 0.5),
            level - t * 0.6,
            POOL_WATER,
        );
        b.inside("basin", [0.0, 0.0, level], (x * lean - 2.0 * t - 0.02, y * lean - 2.0 * t - 0.02), h - level);
    }
}

/// A hot tub: boarded or inflatable, with seats under water and a hinged cover.
pub(super) fn jacuzzi(b: &mut Build<'_>) {
    at_least(b, [0.8, 0.8, 0.35]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let cover = h * b.vary(0.08, 0.13);
    let rim = h - cover;
    let shell_mat = b.choose(&[WHITE_PLASTIC, SKY, GREY_PLASTIC, CREAM]);
    let side = b.choose(&[TEAK, WALNUT, ANTHRACITE, GREY_OAK, WHITE_PLASTIC]);
    let leather = b.choose(&[BROWN_LEATHER, BLACK_LEATHER, GREY_FABRIC, TAN_LEATHER]);
    let floor = rim * 0.2;
    let level = rim * 0.82;
    if b.rng.chance(0.65) {
        let t = b.vary(0.12, 0.2);
        b.block("floor", [-x + 0.02, -y + 0.02, 0.0], [x - 0.02, y - 0.02, floor], shell_mat);
        for s in [-1.0, 1.0] {
            let (cx, cy) = (s * (x - t / 2.0 - 0.02), s * (y - t / 2.0 - 0.02));
            b.block("wall", [cx - t / 2.0, -y + 0.02, floor], [cx + t / 2.0, y - 0.02, rim], shell_mat);
            b.block("wall", [-x + t + 0.02, cy - t / 2.0, floor], [x - t - 0.02, cy + t / 2.0, rim - 0.001], shell_mat);
            b.block(
                "panel",
                [s * (x - 0.011) - 0.01, -y + 0.002, 0.03],
                [s * (x - 0.011) + 0.01, y - 0.002, rim - 0.06],
                side,
            );
            b.block(
                "panel",
                [-x + 0.022, s * (y - 0.011) - 0.01, 0.03],
                [x - 0.022, s * (y - 0.011) + 0.01, rim - 0.06],
                side,
            );
            let inner = y - t - 0.02;
            let (a, c) = (s * inner * 0.55, s * (inner + 0.005));
            b.block("seat", [-x + t, a.min(c), floor - 0.005], [x - t, a.max(c), rim * 0.5], shell_mat);
        }
        let (ix, iy) = (x - t - 0.02, y - t - 0.02);
        b.block("water", [-ix - 0.003, -iy - 0.003, floor - 0.01], [ix + 0.003, iy + 0.003, level], POOL_WATER);
        for cy in spaced(3, -iy * 0.7, iy * 0.7) {
            b.rounded_block(
                "headrest",
                [-ix - 0.01, cy - iy * 0.18, rim - 0.1],
                [-ix + 0.05, cy + iy * 0.18, rim - 0.01],
                0.02,
                BLACK_LEATHER,
            );
        }
        b.block("controls", [x - t * 0.8, -0.1, rim - 0.002], [x - t * 0.35, 0.1, rim + 0.008], SCREEN);
        b.inside("basin", [0.06, 0.0, level], (ix - 0.08, iy - 0.02), rim - level);
        b.hinge([-x, 0.0, rim + 0.01], [0.0, -1.0, 0.0], FRAC_PI_2, |b| {
            b.taper("cover", [0.0, 0.0, rim + 0.01], (x, y), (x, y), cover * 0.55, leather);
            b.taper(
                "cover",
                [0.0, 0.0, rim + 0.009 + cover * 0.55],
                (x * 0.99, y * 0.99),
                (x * 0.5, y * 0.94),
                h - rim - 0.01 - cover * 0.55,
                leather,
            );
        });
    } else {
        let r = x.min(y);
        let (s, rings) = (rim / 5.75, 3);
        b.cylinder("floor", [0.0; 3], r - 0.04, floor, side);
        for i in 0..rings {
            b.lathe(
                "ring",
                [0.0, 0.0, 1.9 * s * i as f32],
                &torus_profile(r - s, s),
                if i == rings - 1 { shell_mat } else { side },
            );
        }
        b.cylinder("water", [0.0, 0.0, floor - 0.01], r - 1.3 * s, level - floor + 0.01, POOL_WATER);
        b.block("pump", [r - 0.06, -0.18, 0.0], [r, 0.18, rim * 0.6], WHITE_PLASTIC);
        b.inside("basin", [0.0, 0.0, level], ((r - 2.0 * s) * 0.68, (r - 2.0 * s) * 0.68), rim - level);
        b.hinge([-r, 0.0, rim + 0.002], [0.0, -1.0, 0.0], FRAC_PI_2, |b| {
            b.lathe(
                "cover",
                [0.0, 0.0, rim + 0.002],
                &[(r, 0.0), (r, cover * 0.3), (r * 0.3, cover - 0.004), (0.0, cover - 0.004)],
                leather,
            );
        });
    }
}

/// A spread-out pool cover: bubbles or bars, with a weighted edge.
pub(super) fn pool_cover(b: &mut Build<'_>) {
    at_least(b, [1.0, 1.5, 0.004]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, second) =
        (b.choose(&[BLUE_PLASTIC, GREEN_PLASTIC, GREY_PLASTIC, NAVY]), b.choose(&[BLACK_PLASTIC, WHITE_PLASTIC, NAVY]));
    let flat = h * 0.5;
    let inset = 0.06_f32.min(x * 0.1);
    b.block("sheet", [-x + inset * 0.5, -y + inset * 0.5, 0.0], [x - inset * 0.5, y - inset * 0.5, flat], mat);
    let bars = b.rng.count(3, 8);
    for cy in spaced(bars, -y * 0.8, y * 0.8) {
        b.block("bar", [-x + 0.01, cy - 0.03, flat * 0.3], [x - 0.01, cy + 0.03, h], second);
    }
    let hem = 0.8 * h;
    for s in [-1.0, 1.0] {
        b.block(
            "hem",
            [s * (x - inset / 2.0) - inset / 2.0, -y, 0.0002],
            [s * (x - inset / 2.0) + inset / 2.0, y, hem],
            mat,
        );
        b.block(
            "hem",
            [-x + inset, s * (y - inset / 2.0) - inset / 2.0, 0.0002],
            [x - inset, s * (y - inset / 2.0) + inset / 2.0, hem * 0.95],
            mat,
        );
    }
}
