//! Pool and bathing: pools, tubs, what floats in them and what keeps them clean.

use std::f32::consts::{FRAC_PI_2, PI, TAU};

use super::build::{Axis, Build, P};
use super::park::shape::{grown, hoop, limb, polar, polygon, spaced, tub};
use super::{Generator, outdoor};
use crate::material::*;
use vc_graph::portable::Portable;

pub(super) const GENERATORS: &[Generator] = &[
    outdoor("pool", 50, pool),
    outdoor("kiddie_pool", 20, kiddie_pool),
    outdoor("jacuzzi", 16, jacuzzi),
    outdoor("diving_board", 8, diving_board),
    outdoor("pool_ladder", 8, pool_ladder),
    outdoor("pool_slide", 8, pool_slide),
    outdoor("pool_goal", 8, pool_goal),
    outdoor("pool_volleyball", 8, pool_volleyball),
    outdoor("pool_basketball", 8, pool_basketball),
    outdoor("pool_float", 12, pool_float),
    outdoor("swim_ring", 12, swim_ring),
    outdoor("buoy", 10, buoy),
    outdoor("pool_noodle", 6, pool_noodle),
    outdoor("beach_ball", 8, beach_ball),
    outdoor("pool_skimmer", 6, pool_skimmer),
    outdoor("pool_robot", 6, pool_robot),
    outdoor("pool_pump", 8, pool_pump),
    outdoor("pool_cover", 8, pool_cover),
    outdoor("solar_shower", 8, solar_shower),
    outdoor("diving_mask", 6, diving_mask),
    outdoor("swim_fins", 6, swim_fins),
    outdoor("life_jacket", 6, life_jacket),
];

const BRIGHT: &[Mat] =
    &[RED_PLASTIC, YELLOW_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC, ORANGE_PLASTIC, PINK_PLASTIC, PURPLE_PLASTIC];

/// A pool above the ground: rectangular, oval or round, tiled, boarded or of steel,
/// with coping, water and perhaps steps.
fn pool(b: &mut Build<'_>) {
    grown(b, [1.2, 2.0, 0.45]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (wall, lining) = (
        b.one(&[CONCRETE, PINE, WHITE_METAL, SANDSTONE, TEAK, ANTHRACITE]),
        b.one(&[BLUE_TILE, WHITE_TILE, SKY, BLUE_TILE]),
    );
    let coping = b.one(&[SANDSTONE, TEAK, GRANITE, WHITE_TILE, CONCRETE]);
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
            // Rounder than a rectangle, fuller than an ellipse.
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

/// A closed strip between two outlines of as many corners.
fn ring_wall(b: &mut Build<'_>, name: &str, [outer, inner]: [&[(f32, f32)]; 2], (low, high): (f32, f32), mat: Mat) {
    let n = outer.len() as u32;
    let level = |outline: &[(f32, f32)], z: f32| -> Vec<P> { outline.iter().map(|p| [p.0, p.1, z]).collect() };
    let vertices = [level(outer, low), level(outer, high), level(inner, low), level(inner, high)].concat();
    let mut triangles = Vec::new();
    let mut quad = |a: u32, c: u32, d: u32, e: u32| triangles.extend([[a, c, d], [a, d, e]]);
    for i in 0..n {
        let j = (i + 1) % n;
        quad(i, j, n + j, n + i);
        quad(2 * n + j, 2 * n + i, 3 * n + i, 3 * n + j);
        quad(n + i, n + j, 3 * n + j, 3 * n + i);
        quad(2 * n + i, 2 * n + j, j, i);
    }
    b.mesh(name, &vertices, triangles, mat);
}

/// Two bent rails over an edge at `at` towards -Y, as high above it as below, and
/// treads between them.
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

/// A pool to blow up, round with bright rings, or a shell of plastic.
fn kiddie_pool(b: &mut Build<'_>) {
    grown(b, [0.4, 0.4, 0.1]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let base = b.one(BRIGHT);
    if (x - y).abs() < 0.25 || b.rng.chance(0.5) {
        let r = x.min(y);
        let rings = b.rng.count(2, 4);
        let s = (h / (1.86 * rings as f32 + 0.1)).min(r * 0.2);
        let level = (s * (1.86 * rings as f32 - 1.1)).max(0.03);
        b.cylinder("floor", [0.0, 0.0, 0.001], r - s, 0.02, base);
        for i in 0..rings {
            let mat = if i % 2 == 0 { base } else { b.one(BRIGHT) };
            b.lathe("ring", [0.0, 0.0, 1.86 * s * i as f32], &hoop(r - s, s), mat);
        }
        b.cylinder("water", [0.0, 0.0, 0.01], r - 1.5 * s, level - 0.01, POOL_WATER);
        b.inside("basin", [0.0, 0.0, level], ((r - 2.0 * s) * 0.69, (r - 2.0 * s) * 0.69), h - level);
    } else {
        let (t, lean) = (0.02, b.vary(0.8, 0.92));
        tub(b, "shell", [0.0; 3], (x * lean, y * lean), (x - 0.015, y - 0.015), h - 0.02, t, base);
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

/// A hot tub: boarded or blown up, seats under water, a cover that turns up.
fn jacuzzi(b: &mut Build<'_>) {
    grown(b, [0.8, 0.8, 0.35]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let cover = h * b.vary(0.08, 0.13);
    let rim = h - cover;
    let shell_mat = b.one(&[WHITE_PLASTIC, SKY, GREY_PLASTIC, CREAM]);
    let side = b.one(&[TEAK, WALNUT, ANTHRACITE, GREY_OAK, WHITE_PLASTIC]);
    let leather = b.one(&[BROWN_LEATHER, BLACK_LEATHER, GREY_FABRIC, TAN_LEATHER]);
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
            b.soft(
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
                &hoop(r - s, s),
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

/// A springboard on its stand; it reaches out to the front.
fn diving_board(b: &mut Build<'_>) {
    grown(b, [0.8, 0.18, 0.2]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (board, stand) = (b.one(&[SKY, WHITE, BLUE, CREAM]), b.one(&[STEEL, WHITE_METAL, CONCRETE, ANTHRACITE]));
    let rails = h > 0.7 && b.rng.chance(0.6);
    let top = if rails { h * 0.55 } else { h - 0.002 };
    let t = 0.05;
    b.soft("board", [-x, -y * 0.92, top - t], [x, y * 0.92, top], 0.012, board);
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

/// A ladder over a pool's edge: bent rails, or an A of steps for raised pools.
fn pool_ladder(b: &mut Build<'_>) {
    grown(b, [0.25, 0.25, 0.6]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (steel, tread) = (b.one(&[STEEL, WHITE_METAL, CHROME]), b.one(&[WHITE_PLASTIC, GREY_PLASTIC, SKY]));
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

/// A slide into the pool: steps behind, a trough that curves down to the front.
fn pool_slide(b: &mut Build<'_>) {
    grown(b, [0.9, 0.28, 0.6]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y.min(b.size.x * 0.4) / 2.0, b.size.z);
    let (mat, steel) =
        (b.one(&[SKY, WHITE_PLASTIC, BLUE_PLASTIC, YELLOW_PLASTIC, RED_PLASTIC]), b.one(&[STEEL, WHITE_METAL]));
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

/// Tubes that float, with a net over them: rails along X and Y at the water, posts.
fn floats(b: &mut Build<'_>, (x, y): (f32, f32), r: f32, mat: Mat) {
    let keep = 1.2 * r;
    for s in [-1.0, 1.0] {
        b.bar("float", [-x + keep, s * (y - keep), keep], [x - keep, s * (y - keep), keep], r, mat);
    }
    b.bar("float", [-x + keep, -y + keep, keep], [-x + keep, y - keep, keep], r, mat);
}

/// Threads of a net over a parallelogram: a corner and its two sides.
fn net(b: &mut Build<'_>, at: P, u: P, v: P, (nu, nv): (usize, usize), r: f32, mat: Mat) {
    let point = |a: f32, c: f32| -> P { std::array::from_fn(|i| at[i] + u[i] * a + v[i] * c) };
    for a in spaced(nu, 0.0, 1.0) {
        b.rod("net", point(a, 0.0), point(a, 1.0), r, mat);
    }
    for c in spaced(nv, 0.0, 1.0) {
        b.rod("net", point(0.0, c), point(1.0, c), r, mat);
    }
}

/// A goal that floats.
fn pool_goal(b: &mut Build<'_>) {
    grown(b, [0.2, 0.45, 0.3]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, second) = (b.one(BRIGHT), b.one(&[WHITE_PLASTIC, YELLOW_PLASTIC, BLUE_PLASTIC]));
    let r = b.vary(0.035, 0.055).min(x * 0.2);
    floats(b, (x, y), r, mat);
    let (front, back) = (x - 2.2 * r, -x + 1.2 * r);
    let (side, top, post) = (y - 1.2 * r, h - r, r * 0.7);
    for s in [-1.0, 1.0] {
        b.bar("post", [front, s * side, 1.2 * r], [front, s * side, top], post, second);
        b.rod("stay", [back, s * side, 1.2 * r], [front, s * side, top], post * 0.4, second);
    }
    b.bar("crossbar", [front, -side, top], [front, side, top], post, second);
    net(
        b,
        [back, -side, 1.2 * r],
        [0.0, 2.0 * side, 0.0],
        [front - back, 0.0, top - 1.2 * r],
        (9, 6),
        0.003,
        WHITE_COTTON,
    );
}

/// A volleyball net on two floats.
fn pool_volleyball(b: &mut Build<'_>) {
    grown(b, [0.15, 1.2, 0.3]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, second) = (b.one(BRIGHT), b.one(&[WHITE_PLASTIC, YELLOW_PLASTIC, BLUE_PLASTIC]));
    let r = b.vary(0.04, 0.06).min(x * 0.3);
    for s in [-1.0, 1.0] {
        let cy = s * (y - x.min(0.25));
        let half = x.min(0.25);
        b.lathe("float", [0.0, cy, 0.0], &hoop(half - r, r), mat);
        b.bar("spar", [-half + r, cy, r], [half - r, cy, r], r * 0.5, second);
        b.bar("post", [0.0, cy, r], [0.0, cy, h - r], r * 0.65, second);
    }
    let side = y - x.min(0.25);
    let low = h * b.vary(0.4, 0.5);
    net(b, [0.0, -side, low], [0.0, 2.0 * side, 0.0], [0.0, 0.0, h - 1.5 * r - low], (17, 4), 0.003, WHITE_COTTON);
    b.block("tape", [-0.004, -side, h - 1.8 * r], [0.004, side, h - r], second);
}

/// A basketball hoop that floats.
fn pool_basketball(b: &mut Build<'_>) {
    grown(b, [0.25, 0.25, 0.3]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, ring_mat) = (b.one(BRIGHT), b.one(&[ORANGE_PLASTIC, RED_PLASTIC, WHITE_PLASTIC]));
    let (half, r) = (x.min(y), b.vary(0.05, 0.07).min(x * 0.2));
    b.lathe("float", [0.0; 3], &hoop(half - r, r), mat);
    b.cylinder("floor", [0.0, 0.0, r * 0.8], half - r, 0.006, mat);
    let (back, board) = (-half + 2.0 * r, h * 0.42);
    for s in [-1.0, 1.0] {
        b.bar("post", [back, s * half * 0.3, r], [back, s * half * 0.3, h - board * 0.5], r * 0.35, ring_mat);
    }
    b.soft(
        "board",
        [back + r * 0.2, -half * 0.75, h - board],
        [back + r * 0.2 + 0.03, half * 0.75, h],
        0.01,
        WHITE_PLASTIC,
    );
    let x0 = back + r * 0.2 + 0.028;
    b.block("target", [x0, -half * 0.25, h - board * 0.75], [x0 + 0.005, half * 0.25, h - board * 0.3], ring_mat);
    let rim = (half * 0.42).min((half - x0) / 2.0);
    let z = h - board * 0.85;
    b.lathe("rim", [x0 + rim, 0.0, z], &hoop(rim - 0.012, 0.012), ring_mat);
    for i in 0..8 {
        let (dx, dy) = polar(TAU * i as f32 / 8.0, 1.0);
        let (top, low) = (rim - 0.02, rim * 0.6);
        b.rod(
            "net",
            [x0 + rim + dx * top, dy * top, z + 0.008],
            [x0 + rim + dx * low, dy * low, z - h * 0.14],
            0.003,
            WHITE_COTTON,
        );
    }
    b.lathe("net", [x0 + rim, 0.0, z - h * 0.14 - 0.003], &hoop(rim * 0.6, 0.003), WHITE_COTTON);
}

/// A mattress to float on: tubes side by side, a pillow at the head.
fn pool_float(b: &mut Build<'_>) {
    grown(b, [0.3, 0.8, 0.06]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, second) = (b.one(BRIGHT), b.one(&[WHITE_PLASTIC, YELLOW_PLASTIC, BLUE_PLASTIC, PINK_PLASTIC]));
    let pillow = h * b.vary(0.2, 0.35);
    let flat = h - pillow;
    let across = b.rng.chance(0.5);
    let count = b.rng.count(4, 7);
    let t = flat / 2.0;
    if across {
        let half = y / count as f32;
        for (i, cy) in spaced(count, -y + half * 1.02, y - half * 1.02).enumerate() {
            b.soft(
                "tube",
                [-x, cy - half * 1.02, 0.0],
                [x, cy + half * 1.02, flat - 0.0015 * (i % 2) as f32],
                t * 0.9,
                if i % 2 == 0 { mat } else { second },
            );
        }
    } else {
        let half = x / count as f32;
        for (i, cx) in spaced(count, -x + half * 1.02, x - half * 1.02).enumerate() {
            b.soft(
                "tube",
                [cx - half * 1.02, -y, 0.0],
                [cx + half * 1.02, y, flat - 0.0015 * (i % 2) as f32],
                t * 0.9,
                if i % 2 == 0 { mat } else { second },
            );
        }
    }
    b.soft("pillow", [-x * 0.95, y * 0.66, flat * 0.5], [x * 0.95, y * 0.99, h], (h - flat * 0.5) * 0.45, second);
    b.cylinder("valve", [x * 0.8, y * 0.9, h - 0.006], 0.01, 0.006, WHITE_PLASTIC);
}

/// A ring to swim in, with bands, or with a head like a duck's.
fn swim_ring(b: &mut Build<'_>) {
    grown(b, [0.25, 0.25, 0.07]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let (mat, second) = (b.one(BRIGHT), b.one(&[WHITE_PLASTIC, YELLOW_PLASTIC, BLUE_PLASTIC]));
    let animal = h > 0.17 && b.rng.chance(0.5);
    let s = (if animal { h * 0.32 } else { h / 2.0 }).min(r * b.vary(0.27, 0.33));
    b.lathe("ring", [0.0; 3], &hoop(r - s, s), mat);
    if animal {
        let neck = [r - s, 0.0, s];
        let head = [r - 1.1 * s, 0.0, h - s * 0.62];
        b.hull("neck", &limb(neck, head, s * 0.6, s * 0.45), mat);
        b.ball("head", head, s * 0.6, mat);
        b.hull(
            "beak",
            &limb(
                [head[0] + s * 0.4, 0.0, head[2] - s * 0.1],
                [(head[0] + s * 1.05).min(r), 0.0, head[2] - s * 0.15],
                s * 0.28,
                s * 0.16,
            ),
            ORANGE_PLASTIC,
        );
        for side in [-1.0, 1.0] {
            b.ball("eye", [head[0] + s * 0.3, side * s * 0.4, head[2] + s * 0.22], s * 0.12, BLACK_PLASTIC);
        }
    } else {
        bands(b, r - s, s, second);
    }
    b.cylinder("valve", [-r + s, 0.0, 2.0 * s - 0.006], 0.012, 0.0055, WHITE_PLASTIC);
}

/// Sleeves of another colour around a ring that lies flat.
fn bands(b: &mut Build<'_>, radius: f32, section: f32, mat: Mat) {
    let count = b.rng.count(4, 8);
    let share = PI / count as f32 * 0.5;
    for i in 0..count {
        let a = TAU * i as f32 / count as f32;
        let slice = |angle: f32| -> Vec<P> {
            let (ux, uy) = polar(angle, 1.0);
            polygon(10, section * 1.012 - 0.0005, 0.0)
                .into_iter()
                .map(|(r, z)| {
                    [
                        ux * (radius + r.min(section * 0.999)),
                        uy * (radius + r.min(section * 0.999)),
                        (section + z).max(0.0).min(2.0 * section),
                    ]
                })
                .collect()
        };
        b.hull("band", &[slice(a - share * 0.5), slice(a), slice(a + share * 0.5)].concat(), mat);
    }
}

/// A lifebuoy, upright, with a rope along its rim.
fn buoy(b: &mut Build<'_>) {
    grown(b, [0.03, 0.25, 0.25]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let r = y.min(h / 2.0);
    let (mat, second) =
        (b.one(&[ORANGE_PLASTIC, WHITE_PLASTIC, RED_PLASTIC]), b.one(&[WHITE_PLASTIC, RED_PLASTIC, NAVY]));
    let second = if second == mat { SILVER_METAL } else { second };
    let rope = 0.006;
    let (s, out) = (x * 0.94, r - 2.2 * rope);
    let section: Vec<(f32, f32)> = {
        let wide = out * b.vary(0.14, 0.19);
        let mut ring: Vec<_> = polygon(12, 1.0, 0.0).into_iter().map(|(a, c)| (out - wide + a * wide, c * s)).collect();
        ring.extend(ring.first().copied());
        ring
    };
    let from: P = [0.0, 0.0, r];
    b.lathe_along("ring", from, [1.0, 0.0, r], &section, mat);
    let wide = (section[0].0 - section[6].0) / 2.0;
    for i in 0..4 {
        let a = FRAC_PI_2 * i as f32 + FRAC_PI_2 / 2.0;
        let slice = |angle: f32| -> Vec<P> {
            let (uy, uz) = polar(angle, 1.0);
            polygon(12, 1.0, 0.0)
                .into_iter()
                .map(|(p, q)| (out - wide + p * wide * 1.04, q * x * 0.985))
                .map(|(d, px)| [px, uy * d, r + uz * d])
                .collect()
        };
        b.hull("band", &[slice(a - 0.16), slice(a), slice(a + 0.16)].concat(), second);
        let at = |angle: f32, d: f32| {
            let (py, pz) = polar(angle, d);
            [0.0, py, r + pz]
        };
        let rim = r - rope * 1.3;
        for k in 0..4 {
            let (a0, a1) = (a + FRAC_PI_2 * k as f32 / 4.0, a + FRAC_PI_2 * (k + 1) as f32 / 4.0);
            b.rod("rope", at(a0, rim), at(a1, rim), rope, WHITE_COTTON);
        }
    }
}

/// A foam noodle, lying; a tube with a hole.
fn pool_noodle(b: &mut Build<'_>) {
    grown(b, [0.03, 0.4, 0.03]);
    let (r, y) = (b.size.x.min(b.size.z) / 2.0, b.size.y / 2.0);
    let mat = b.one(BRIGHT);
    let hole = r * b.vary(0.25, 0.4);
    b.lathe_along(
        "noodle",
        [0.0, -y, r],
        [0.0, y, r],
        &[(r, 0.0), (r, 2.0 * y), (hole, 2.0 * y), (hole, 0.0), (r, 0.0)],
        mat,
    );
}

/// A beach ball of coloured segments.
fn beach_ball(b: &mut Build<'_>) {
    grown(b, [0.1, 0.1, 0.1]);
    let r = b.size.min() / 2.0;
    let segments = b.one(&[6, 8]);
    let (first, second) = (b.one(BRIGHT), b.one(&[WHITE_PLASTIC, YELLOW_PLASTIC, BLUE_PLASTIC]));
    let third = b.one(BRIGHT);
    let cap = 0.18;
    for i in 0..segments {
        let mut points: Vec<P> = Vec::new();
        for a in spaced(4, 0.0, 1.0).map(|s| TAU * (i as f32 + s) / segments as f32) {
            for polar_angle in spaced(9, cap * 0.8, PI - cap * 0.8) {
                let (out, z) = (r * polar_angle.sine(), r * polar_angle.cosine());
                let (px, py) = polar(a, out);
                points.push([px, py, r + z]);
            }
        }
        points.extend([[0.0, 0.0, r * 0.2], [0.0, 0.0, r * 1.8]]);
        b.hull("segment", &points, [first, second, third, second][i % 4]);
    }
    let at = r * cap.cosine();
    b.lathe(
        "cap",
        [0.0, 0.0, r + at - 0.002],
        &[(r * cap.sine(), 0.0), (r * cap.sine() * 0.9, (r - at) * 0.5), (0.0, r - at + 0.002)],
        WHITE_PLASTIC,
    );
    b.lathe(
        "cap",
        [0.0; 3],
        &[(0.0, 0.0), (r * cap.sine() * 0.9, (r - at) * 0.5), (r * cap.sine(), r - at + 0.002)],
        WHITE_PLASTIC,
    );
}

/// A net on a pole, upright, the net below.
fn pool_skimmer(b: &mut Build<'_>) {
    grown(b, [0.025, 0.17, 0.5]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, cloth) = (b.one(&[BLUE_PLASTIC, SKY, WHITE_PLASTIC, GREEN_PLASTIC]), b.one(&[BLUE_FABRIC, WHITE_COTTON]));
    let (tall, r) = ((h * 0.22).min(y * 1.6), 0.008_f32.min(x * 0.4));
    let (low, wide) = (r * 1.2, y - r * 1.2);
    b.pipe(
        "frame",
        &[
            [0.0, -wide * 0.8, low],
            [0.0, wide * 0.8, low],
            [0.0, wide, tall * 0.6],
            [0.0, 0.0, tall],
            [0.0, -wide, tall * 0.6],
            [0.0, -wide * 0.8, low],
        ],
        r,
        mat,
    );
    let bag = [
        [0.0, -wide * 0.8, low],
        [0.0, wide * 0.8, low],
        [0.0, wide, tall * 0.6],
        [0.0, 0.0, tall],
        [0.0, -wide, tall * 0.6],
        [-x, -wide * 0.4, tall * 0.3],
        [-x, wide * 0.4, tall * 0.3],
        [-x, 0.0, tall * 0.6],
    ];
    b.hull("net", &bag, cloth);
    let joint = h * b.vary(0.5, 0.65);
    b.cylinder("pole", [0.0, 0.0, tall - 0.01], r * 1.4, joint - tall + 0.01, ALUMINIUM);
    b.cylinder("pole", [0.0, 0.0, joint - 0.01], r * 1.15, h - joint + 0.01, ALUMINIUM);
    b.cylinder("collar", [0.0, 0.0, joint - 0.03], (r * 1.9).min(x), 0.05, mat);
    b.cylinder("grip", [0.0, 0.0, h - 0.13_f32.min(h * 0.1)], r * 1.6, 0.12_f32.min(h * 0.09), RUBBER);
}

/// A robot that cleans pools: a body on tracks or brushes, a handle over it.
fn pool_robot(b: &mut Build<'_>) {
    grown(b, [0.17, 0.17, 0.1]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, second) = (
        b.one(&[BLUE_PLASTIC, WHITE_PLASTIC, GREY_PLASTIC, ORANGE_PLASTIC]),
        b.one(&[BLACK_PLASTIC, GREY_PLASTIC, NAVY]),
    );
    let r = (h * 0.24).min(x * 0.35);
    for s in [-1.0, 1.0] {
        let cx = s * (x - r);
        b.rod("brush", [cx, -y * 0.8, r], [cx, y * 0.8, r], r, YELLOW_PLASTIC);
        let cy = s * y * 0.9;
        let track: Vec<(f32, f32)> = (0..=8)
            .map(|i| FRAC_PI_2 + PI * i as f32 / 8.0)
            .map(|a| (-x + r + r * a.cosine(), r + r * a.sine()))
            .chain(
                (0..=8).map(|i| -FRAC_PI_2 + PI * i as f32 / 8.0).map(|a| (x - r + r * a.cosine(), r + r * a.sine())),
            )
            .collect();
        b.prism("track", Axis::Y, [0.0, cy - y * 0.1, 0.0], &track, y * 0.2, RUBBER);
    }
    let top = h * b.vary(0.68, 0.76);
    b.taper("body", [0.0, 0.0, r * 0.8], (x * 0.82, y * 0.8), (x * 0.5, y * 0.62), top - r * 0.8, mat);
    b.lathe("port", [0.0, 0.0, top - 0.004], &[(y * 0.3, 0.0), (y * 0.22, 0.014), (0.0, 0.018)], second);
    let bar = (h * 0.05).min(0.014);
    b.pipe(
        "handle",
        &[
            [-x * 0.6, 0.0, top * 0.7],
            [-x * 0.45, 0.0, h - bar * 1.2],
            [x * 0.45, 0.0, h - bar * 1.2],
            [x * 0.6, 0.0, top * 0.7],
        ],
        bar,
        second,
    );
    for s in [-1.0, 1.0] {
        b.block(
            "window",
            [-x * 0.3, s * y * 0.72 - 0.012, top * 0.6],
            [x * 0.3, s * y * 0.72 + 0.004, top * 0.8],
            BLUE_GLASS,
        );
    }
}

/// A pump on a foot, with its filter: a cartridge or a ball of sand.
fn pool_pump(b: &mut Build<'_>) {
    grown(b, [0.15, 0.15, 0.2]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, second) = (
        b.one(&[GREY_PLASTIC, BLACK_PLASTIC, BLUE_PLASTIC, WHITE_PLASTIC]),
        b.one(&[SKY, GREY_PLASTIC, WHITE_PLASTIC]),
    );
    let foot = 0.03;
    b.soft("foot", [-x, -y, 0.0], [x, y, foot], 0.01, BLACK_PLASTIC);
    let r = (y * 0.62).min(x * 0.8).min(h * 0.38);
    let at = y - r - 0.02;
    let valve = h * 0.86;
    if b.rng.chance(0.5) {
        let middle = (foot + (valve - foot) * 0.5).max(foot + r * 0.6);
        let arc: Vec<(f32, f32)> = (0..=12)
            .map(|i| -1.2 + 2.4 * i as f32 / 12.0)
            .map(|a| (r * a.cosine(), middle + (valve - foot) * 0.5 * a.sine() / 0.932))
            .collect();
        b.lathe("filter", [0.0, at, 0.0], &arc, second);
    } else {
        b.lathe(
            "filter",
            [0.0, at, foot - 0.004],
            &[
                (r * 0.85, 0.0),
                (r * 0.85, (valve - foot) * 0.8),
                (r, (valve - foot) * 0.82),
                (r, (valve - foot) * 0.92),
                (r * 0.5, valve - foot + 0.004),
            ],
            second,
        );
    }
    b.cylinder("valve", [0.0, at, valve - 0.02], r * 0.45, h * 0.08 + 0.02, mat);
    b.block("lever", [-r * 0.7, at - r * 0.12, h * 0.93], [r * 0.7, at + r * 0.12, h], mat);
    b.rod("gauge", [r * 0.3, at, h * 0.9], [r * 0.75, at, h * 0.9], r * 0.14, WHITE_METAL);
    let (motor, z) = ((r * 0.55).min(h * 0.16), foot + (r * 0.6).min(h * 0.18));
    let cy = -y + motor + 0.02;
    b.rod("motor", [-x * 0.8, cy, z], [x * 0.25, cy, z], motor, mat);
    b.rod("basket", [x * 0.2, cy, z], [x * 0.75, cy, z], motor * 0.8, CLEAR_PLASTIC);
    b.block("cradle", [-x * 0.6, cy - motor * 0.7, foot * 0.5], [x * 0.1, cy + motor * 0.7, z], BLACK_PLASTIC);
    let pipe = (motor * 0.3).min(0.03);
    b.pipe("pipe", &[[x * 0.5, cy, z + motor * 0.6], [x * 0.5, cy, valve], [0.0, at, valve]], pipe, second);
}

/// A cover for a pool, spread out: bubbles or bars, its edge weighted.
fn pool_cover(b: &mut Build<'_>) {
    grown(b, [1.0, 1.5, 0.004]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, second) =
        (b.one(&[BLUE_PLASTIC, GREEN_PLASTIC, GREY_PLASTIC, NAVY]), b.one(&[BLACK_PLASTIC, WHITE_PLASTIC, NAVY]));
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

/// A shower of the sun's warmth: a dark column, a head, a tap.
fn solar_shower(b: &mut Build<'_>) {
    grown(b, [0.1, 0.1, 0.9]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, metal) = (b.one(&[BLACK_PLASTIC, ANTHRACITE, NAVY, SILVER_METAL]), b.one(&[CHROME, STEEL]));
    let foot = x.min(y);
    let r = (foot * b.vary(0.32, 0.45)).min(0.08);
    let back = -x + foot;
    b.lathe("foot", [back, 0.0, 0.0], &[(foot, 0.0), (foot * 0.95, 0.02), (r * 1.2, 0.035)], mat);
    let bend = h * b.vary(0.9, 0.94);
    if b.rng.chance(0.5) {
        b.lathe("column", [back, 0.0, 0.01], &[(r, 0.0), (r, bend - 0.02), (r * 0.5, bend + 0.02)], mat);
    } else {
        b.soft("column", [back - r, -r * 0.9, 0.01], [back + r, r * 0.9, bend + 0.02], r * 0.5, mat);
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

/// A diving mask with a snorkel beside it, or swimming goggles where it is low.
fn diving_mask(b: &mut Build<'_>) {
    grown(b, [0.025, 0.075, 0.02]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, strap) = (b.one(BRIGHT), b.one(&[BLACK_PLASTIC, GREY_RUBBER]));
    let glass = BLUE_GLASS;
    let snorkel = h > 0.16;
    let tall = if h > 0.07 { h.min(0.11) } else { h };
    let wide = if snorkel { y * 0.86 } else { y };
    let cy = wide - y;
    let pair = !snorkel && h < 0.07;
    let frame = |half: f32, z: f32, high: f32| {
        vec![
            (-half, z + high * 0.3),
            (-half * 0.8, z),
            (-half * 0.25, z + high * 0.06),
            (half * 0.25, z + high * 0.06),
            (half * 0.8, z),
            (half, z + high * 0.3),
            (half, z + high * 0.8),
            (half * 0.8, z + high),
            (-half * 0.8, z + high),
            (-half, z + high * 0.8),
        ]
    };
    if pair {
        for s in [-1.0, 1.0] {
            let half = wide * 0.46;
            b.prism("frame", Axis::X, [-x * 0.2, cy + s * wide * 0.54, 0.0], &frame(half, 0.0, tall), x * 1.1, mat);
            b.prism(
                "lens",
                Axis::X,
                [x * 0.7, cy + s * wide * 0.54, 0.0],
                &frame(half * 0.82, tall * 0.1, tall * 0.8),
                x * 0.3,
                glass,
            );
        }
        b.block("bridge", [0.0, cy - wide * 0.12, tall * 0.45], [x * 0.6, cy + wide * 0.12, tall * 0.62], strap);
    } else {
        b.prism("skirt", Axis::X, [-x * 0.6, cy, 0.0], &frame(wide * 0.92, 0.002, tall * 0.95), x * 1.2, strap);
        b.prism("frame", Axis::X, [x * 0.4, cy, 0.0], &frame(wide, 0.0, tall), x * 0.45, mat);
        b.prism("lens", Axis::X, [x * 0.6, cy, 0.0], &frame(wide * 0.84, tall * 0.1, tall * 0.82), x * 0.4, glass);
        b.hull(
            "nose",
            &[
                [x * 0.8, cy - wide * 0.2, tall * 0.02],
                [x * 0.8, cy + wide * 0.2, tall * 0.02],
                [x * 0.8, cy, tall * 0.45],
                [x, cy, tall * 0.1],
            ],
            strap,
        );
    }
    let z = tall * 0.5;
    for s in [-1.0, 1.0] {
        b.rod("strap", [-x * 0.2, cy + s * wide * 0.95, z], [-x + 0.003, cy + s * wide * 0.5, z], 0.003, strap);
    }
    b.rod("strap", [-x + 0.003, cy - wide * 0.5, z], [-x + 0.003, cy + wide * 0.5, z], 0.003, strap);
    if snorkel {
        let r = (y - wide * 0.98).clamp(0.005, 0.011);
        let side = y - r * 1.2;
        b.pipe(
            "snorkel",
            &[
                [x * 0.3, side - 0.03, r * 1.2],
                [0.0, side, r * 1.2],
                [-x * 0.2, side, h * 0.3],
                [-x * 0.4, side, h - r * 1.2],
            ],
            r,
            mat,
        );
        b.rod("clip", [-x * 0.2, cy + wide * 0.9, z], [-x * 0.1, side, z], 0.004, strap);
        b.rod("band", [-x * 0.38, side, h - h * 0.16], [-x * 0.395, side, h - h * 0.06], r * 1.25, BLACK_PLASTIC);
    }
}

/// A pair of fins lying side by side, blades to the front.
fn swim_fins(b: &mut Build<'_>) {
    grown(b, [0.15, 0.08, 0.03]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, rubber) = (b.one(BRIGHT), b.one(&[BLACK_PLASTIC, GREY_RUBBER, RUBBER]));
    let half = y * 0.49;
    let shoe = -x + 2.0 * x * b.vary(0.38, 0.46);
    for s in [-1.0, 1.0] {
        let cy = s * (y - half);
        let foot = half * 0.75;
        let body = [
            [-x, 0.5, 0.0, 0.2],
            [-x, 0.5, 0.55, 0.4],
            [shoe, 1.0, 0.0, 0.0],
            [shoe, 0.8, 0.5, 0.0],
            [shoe - (shoe + x) * 0.5, 0.95, 0.0, 0.0],
            [shoe - (shoe + x) * 0.55, 0.75, 1.0, 0.0],
        ];
        b.hull(
            "shoe",
            &body
                .iter()
                .flat_map(|p| [[p[0], cy + foot * p[1], h * p[2]], [p[0], cy - foot * p[1], h * p[2]]])
                .collect::<Vec<P>>(),
            rubber,
        );
        let blade = [
            (shoe - 0.02, -foot * 0.9),
            (shoe + (x - shoe) * 0.7, -half),
            (x, -half * 0.9),
            (x - (x - shoe) * 0.06, 0.0),
            (x, half * 0.9),
            (shoe + (x - shoe) * 0.7, half),
            (shoe - 0.02, foot * 0.9),
        ];
        b.prism("blade", Axis::Z, [0.0, cy, h * 0.1], &blade, h * 0.1, mat);
        for k in [-1.0, 0.0, 1.0] {
            let reach = shoe + (x - shoe) * if k == 0.0 { 0.75 } else { 0.9 };
            b.hull(
                "rib",
                &limb(
                    [shoe - 0.03, cy + k * foot * 0.7, h * 0.2],
                    [reach, cy + k * (half * 0.88).min(half - h * 0.07), h * 0.15],
                    h * 0.12,
                    h * 0.06,
                ),
                rubber,
            );
        }
    }
    b.rod("clip", [shoe - 0.01, -y * 0.25, h * 0.2], [shoe - 0.01, y * 0.25, h * 0.2], h * 0.04, BLACK_PLASTIC);
}

/// A life jacket, upright: two front panels, a back, a collar, straps with buckles.
fn life_jacket(b: &mut Build<'_>) {
    grown(b, [0.05, 0.17, 0.2]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, strap) = (
        b.one(&[ORANGE_PLASTIC, RED_FABRIC, YELLOW_PLASTIC, BLUE_FABRIC]),
        b.one(&[BLACK_FABRIC, GREY_FABRIC, NAVY_FABRIC]),
    );
    let (chest, shoulder) = (h * b.vary(0.62, 0.7), y * 0.7);
    let t = x * 0.62;
    let gap = 0.006;
    for s in [-1.0, 1.0] {
        let outline = [
            (s * gap, 0.0),
            (s * y, h * 0.02),
            (s * y, chest * 0.75),
            (s * shoulder, chest),
            (s * shoulder * 0.9, h * 0.93),
            (s * shoulder * 0.45, h * 0.93),
            (s * y * 0.3, chest * 0.95),
            (s * gap, chest * 0.8),
        ];
        b.prism("front", Axis::X, [x - t - 0.006, 0.0, 0.0], &outline, t, mat);
        b.soft(
            "shoulder",
            [-x * 0.8, (s * shoulder * 0.45).min(s * shoulder * 0.9), h * 0.88],
            [x - 0.012, (s * shoulder * 0.45).max(s * shoulder * 0.9), h * 0.99],
            h * 0.04,
            mat,
        );
    }
    let back = [
        (-y * 0.98, h * 0.02),
        (y * 0.98, h * 0.02),
        (y * 0.98, chest * 0.75),
        (shoulder, chest),
        (shoulder * 0.9, h * 0.92),
        (-shoulder * 0.9, h * 0.92),
        (-shoulder, chest),
        (-y * 0.98, chest * 0.75),
    ];
    b.prism("back", Axis::X, [-x, 0.0, 0.0], &back, t * 0.8, mat);
    b.soft("collar", [-x, -shoulder * 0.6, h * 0.86], [-x * 0.3, shoulder * 0.6, h], h * 0.05, mat);
    let straps = b.rng.count(2, 3);
    for z in spaced(straps, h * 0.14, chest * 0.66) {
        b.block("strap", [-x * 0.9, -y + 0.0005, z - 0.012], [x - 0.004, y - 0.0005, z + 0.012], strap);
        b.block(
            "buckle",
            [x - 0.008, -0.022_f32.min(y * 0.2), z - 0.016],
            [x, 0.022_f32.min(y * 0.2), z + 0.016],
            BLACK_PLASTIC,
        );
    }
    b.block("reflector", [x - 0.008, y * 0.4, chest * 0.82], [x - 0.004, y * 0.65, chest * 0.88], SILVER_METAL);
}
