//! Cleaning equipment: brooms, mops, buckets, sponges.

use std::f32::consts::{PI, TAU};

use nalgebra::{Isometry3, Vector3};
use vc_graph::portable::Portable;

use super::super::kitchenware::holders::bail;
use super::label::{GROWTH, panel};
use super::look::look;
use crate::material::*;
use crate::solid::{
    Axis, Build, P, dims, flat_ring, level_oval, loft_columns, lump, planar_tube, rounded_by_share, rounded_ring,
    sweep, tub, turn, vessel,
};

const BRIGHT: [MaterialId; 6] =
    [RED_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC, GREY_PLASTIC, YELLOW_PLASTIC, ORANGE_PLASTIC];

/// A stick with a round end, up to the top of a tool.
fn stick(b: &mut Build<'_>, (x, low): (f32, f32), r: f32) {
    let z = b.size.z;
    let mat = b.choose(&[BEECH, PINE, STEEL, GREEN_METAL, RED_METAL, BLUE_METAL]);
    turn(b, "stick", [x, 0.0, low], (r, z - low), &[(1.0, 0.0), (1.0, 0.985), (0.5, 1.0)], mat);
}

/// A broom standing on its bristles.
pub(super) fn broom(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let head = (z * 0.13).min(0.16);
    let block = head * 0.72;
    let (mat, bristle) = (
        b.choose(&[BEECH, RED_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC]),
        b.choose(&[HAY, BLACK_PLASTIC, RED_PLASTIC, GREY_PLASTIC]),
    );
    b.rounded_block("head", [-hx * 0.75, -hy * 0.92, block * 0.9], [hx * 0.75, hy * 0.92, head], hx * 0.3, mat);
    let tufts = 9;
    for i in 0..tufts {
        let k = 2.0 * (i as f32 + 0.5) / tufts as f32 - 1.0;
        let (top, foot, w) = (hy * 0.86 * k, hy * 0.96 * k, hy * 0.88 / tufts as f32);
        let foot = foot.max(-hy + w).min(hy - w);
        let ring =
            |y: f32, wx: f32, wy: f32, z: f32| [[-wx, y - wy, z], [wx, y - wy, z], [-wx, y + wy, z], [wx, y + wy, z]];
        let points: Vec<P> = [ring(foot, hx, w * 1.05_f32.min(hy), 0.0), ring(top, hx * 0.6, w * 0.85, block)]
            .concat()
            .into_iter()
            .map(|p| [p[0], p[1].max(-hy).min(hy), p[2]])
            .collect();
        b.hull("bristles", &points, bristle);
    }
    turn(b, "socket", [0.0, 0.0, head * 0.95], (hx.min(hy) * 0.5, head * 0.45), &[(1.0, 0.0), (0.7, 1.0)], mat);
    stick(b, (0.0, head), (hx * 0.4).min(0.012));
}

/// A mop: a flat one with a cloth, or one with strings.
pub(super) fn mop(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let (plastic, cloth) = (b.choose(&BRIGHT), b.choose(&[WHITE_COTTON, BLUE_FABRIC, GREY_FABRIC]));
    if y > x * 1.8 {
        let t = z * 0.015;
        b.rounded_block("cloth", [-hx, -hy, 0.0], [hx, hy, t], t * 0.4, cloth);
        b.rounded_block("plate", [-hx * 0.85, -hy * 0.95, t * 0.9], [hx * 0.85, hy * 0.95, t * 2.0], t * 0.3, plastic);
        b.taper("joint", [0.0, 0.0, t * 1.9], (hx * 0.4, hx * 0.4), (hx * 0.2, hx * 0.2), z * 0.05, plastic);
        return stick(b, (0.0, z * 0.05), (hx * 0.2).min(0.012));
    }
    let h = z * 0.2;
    let strings = 16;
    for i in 0..strings {
        let (s, c) = (TAU * i as f32 / strings as f32).sine_cosine();
        let out = if i % 2 == 0 { 1.0 } else { 0.7 };
        let w = hx.min(hy) * 0.13;
        let at = |k: f32, z: f32| [(hx - w) * k * c, (hy - w) * k * s, z];
        let side = [-s, c, 0.0];
        planar_tube(
            b,
            "string",
            &[at(0.2, h), at(0.45, h * 0.95), at(0.8 * out, h * 0.45), at(out, 0.0)],
            w,
            side,
            cloth,
        );
    }
    turn(
        b,
        "socket",
        [0.0, 0.0, h * 0.85],
        (hx.min(hy) * 0.4, h * 0.4),
        &[(1.0, 0.0), (1.0, 0.4), (0.5, 1.0)],
        plastic,
    );
    stick(b, (0.0, h), (hx * 0.2).min(0.012));
}

/// A bucket with a lip and a bail; the mop bucket has a wringer.
pub(super) fn bucket(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.choose(&[RED_PLASTIC, BLUE_PLASTIC, GREY_PLASTIC, GREEN_PLASTIC, GALVANISED, YELLOW_PLASTIC]);
    let h = z * 0.84;
    if b.class == "mop_bucket" {
        return mop_bucket(b, h, mat);
    }
    let r = x.min(y) / 2.0;
    let t = (r * 0.02).min(0.003);
    let rim = r * 0.95;
    vessel(
        b,
        "bucket",
        (rim, h),
        &[(0.72, 0.0), (0.74, 0.02), (0.97, 0.93), (0.97, 0.94), (1.0, 0.94), (1.0, 1.0)],
        t,
        mat,
    );
    let w = (r * 0.025).min(0.004);
    bail(b, r - w, (h * 0.94, z), w, STEEL);
    b.rod(
        "grip",
        [0.0, -r * 0.25, z - w * 2.2],
        [0.0, r * 0.25, z - w * 2.2],
        w * 2.2,
        if mat == GALVANISED { BEECH } else { mat },
    );
    if mat == GALVANISED {
        for k in [0.3, 0.62] {
            let wall = rim * (0.74 + 0.23 * k);
            flat_ring(b, "hoop", (h * k, h * (k + 0.03)), (wall * 0.96, wall + r * 0.02), mat);
        }
    }
}

fn mop_bucket(b: &mut Build<'_>, h: f32, mat: MaterialId) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let t = (hx * 0.02).min(0.003);
    tub(
        b,
        "bucket",
        &[(0.0, hx * 0.8, hy * 0.82), (h * 0.9, hx * 0.94, hy * 0.94), (h * 0.91, hx, hy), (h, hx, hy)],
        0.6,
        t,
        mat,
    );
    b.inside("inside", [0.0, -hy * 0.2, t], (hx * 0.55, hy * 0.45), h * 0.6);
    let basket = b.choose(&BRIGHT);
    let (low, cy) = (h * 0.65, hy * 0.45);
    let ring = |z: f32, k: f32| level_oval([0.0, cy, z], (hx * 0.78 * k, hy * 0.42 * k));
    loft_columns(
        b,
        "wringer",
        &[
            ring(low, 0.5),
            ring(h, 0.95),
            ring(h + (z - h) * 0.3, 1.0),
            ring(h + (z - h) * 0.3, 0.92),
            ring(h, 0.85),
            ring(low + t, 0.42),
        ],
        basket,
    );
    for i in 0..8 {
        let (s, c) = (TAU * i as f32 / 8.0).sine_cosine();
        let at = |k: f32, z: f32| [hx * 0.78 * k * c, cy + hy * 0.42 * k * s, z];
        b.rod("rib", at(0.42, low + t), at(0.86, h), hx * 0.02, BLACK_PLASTIC);
    }
    let w = (hx * 0.03).min(0.005);
    bail(b, hy - w, (h * 0.93, z), w, STEEL);
}

/// Sponges with a rough side, and wool scouring pads.
pub(super) fn sponge(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    if b.class == "steel_wool" {
        for i in 0..3 {
            let shift = hx * 0.15 * (i as f32 - 1.0);
            lump(
                b,
                "wool",
                [shift, -shift, z * 0.5],
                [hx * 0.85, hy * 0.85, z * (0.5 - 0.03 * i as f32)],
                0.2,
                ALUMINIUM,
            );
        }
        return;
    }
    let (foam, pad) = (
        b.choose(&[YELLOW_SKIN, PETAL_PINK, PETAL_BLUE, ORANGE_SKIN, HAY]),
        b.choose(&[GREEN_FABRIC, GREEN_FABRIC, NAVY_FABRIC]),
    );
    let waist = b.choose(&[1.0, 0.9]);
    let plan: Vec<_> = rounded_by_share((hx, hy), 0.25)
        .into_iter()
        .map(|p| (p.0 * (waist + (1.0 - waist) * (p.1 / hy).abs().raised(2)), p.1))
        .collect();
    b.prism("foam", Axis::Z, [0.0; 3], &plan, z * 0.76, foam);
    let upper: Vec<_> = plan.iter().map(|p| (p.0 * 0.98, p.1 * 0.98)).collect();
    b.prism("pad", Axis::Z, [0.0, 0.0, z * 0.75], &upper, z * 0.25, pad);
    for i in 0..7 {
        let (s, c) = (2.4 * i as f32).sine_cosine();
        b.rod(
            "pore",
            [hx * 0.9, hy * 0.75 * s, z * (0.38 + 0.22 * c)],
            [hx * if waist < 1.0 { 0.93 } else { 1.0 } + 0.0003, hy * 0.75 * s, z * (0.38 + 0.22 * c)],
            z * 0.04,
            MUSTARD,
        );
    }
}

/// A feather duster, standing on its handle.
pub(super) fn duster(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let handle = b.choose(&[BEECH, BLACK_PLASTIC, RED_PLASTIC]);
    let feather = b.choose(&[BLUE_FABRIC, GREY_FABRIC, ROSE_FABRIC, FUR, MUSTARD_FABRIC]);
    let low = z * 0.45;
    turn(
        b,
        "handle",
        [0.0; 3],
        (hx.min(hy) * 0.2, low * 1.1),
        &[(0.8, 0.0), (1.0, 0.1), (0.7, 0.5), (0.8, 1.0)],
        handle,
    );
    for tier in 0..3 {
        let (from, to) = (low + (z - low) * 0.2 * tier as f32, low + (z - low) * (0.6 + 0.2 * tier as f32));
        let wide = [1.0, 0.85, 0.6][tier];
        for i in 0..7 {
            let angle = TAU * (i as f32 + 0.5 * tier as f32) / 7.0;
            let at = |turn: f32, k: f32, z: f32| {
                let (s, c) = (angle + turn).sine_cosine();
                [hx * wide * k * c, hy * wide * k * s, z]
            };
            let mid = f32::midpoint(from, to);
            b.hull(
                "feather",
                &[
                    at(0.0, 0.05, from),
                    at(-0.4, 0.7, mid),
                    at(0.4, 0.7, mid),
                    at(0.0, 1.0, mid),
                    at(-0.2, 0.95, to * 0.97),
                    at(0.2, 0.95, to * 0.97),
                    at(0.0, 0.6, to),
                ],
                feather,
            );
        }
    }
}

/// A squeegee: a rubber blade across a handle, standing on the blade.
pub(super) fn squeegee(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let mat = b.choose(&BRIGHT);
    b.block("rubber", [-hx * 0.12, -hy, 0.0], [hx * 0.12, hy, z * 0.1], RUBBER);
    b.rounded_block("bar", [-hx * 0.35, -hy * 0.98, z * 0.07], [hx * 0.35, hy * 0.98, z * 0.17], hx * 0.1, mat);
    let r = (hx * 0.45).min(hy * 0.12);
    let path = [
        ([0.0, 0.0, z * 0.14], r * 2.0, r * 0.7),
        ([0.0, 0.0, z * 0.3], r * 0.8, r * 0.7),
        ([0.0, 0.0, z * 0.5], r, r),
        ([0.0, 0.0, z * 0.92], r, r),
        ([0.0, 0.0, z], r * 0.6, r * 0.6),
    ];
    sweep(b, "grip", &path, [0.0, 1.0, 0.0], contrast(mat));
    let w = hx - r * 0.2;
    b.block("brace", [-w, -hy * 0.1, z * 0.1], [w, hy * 0.1, z * 0.155], mat);
}

/// Returns a contrasting colour; black contrasts with all colours in use.
fn contrast(mat: MaterialId) -> MaterialId {
    if mat == GREY_PLASTIC { BLUE_PLASTIC } else { BLACK_PLASTIC }
}

/// A dustpan with a wide mouth to the front and a handle at the back.
pub(super) fn dustpan(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let mat = b.choose(&BRIGHT);
    let t = (z * 0.04).min(0.003);
    let back = -hx + x * 0.42;
    b.hull(
        "floor",
        &[
            [hx * 0.99, -hy * 0.985, 0.0],
            [hx * 0.99, hy * 0.985, 0.0],
            [back, -hy * 0.835, 0.0],
            [back, hy * 0.835, 0.0],
            [back, -hy * 0.835, t * 1.5],
            [back, hy * 0.835, t * 1.5],
            [hx * 0.99, -hy * 0.985, t * 0.4],
            [hx * 0.99, hy * 0.985, t * 0.4],
        ],
        mat,
    );
    b.block("back", [back - t * 0.4, -hy * 0.84, t * 0.4], [back + t, hy * 0.84, z * 0.7], mat);
    for side in [-1.0, 1.0] {
        let wall = |x: f32, k: f32, z: f32| [[x, side * hy * k, z], [x, side * (hy * k - t), z]];
        let points: Vec<P> = [
            wall(hx, 1.0, 0.0),
            wall(hx, 1.0, t),
            wall(back + t * 0.4, 0.855, t * 0.2),
            wall(back + t * 0.4, 0.855, z * 0.69),
        ]
        .concat();
        b.hull("side", &points, mat);
    }
    let hood = [
        [back, -hy * 0.85, z * 0.7 - t],
        [back, hy * 0.85, z * 0.7 - t],
        [back + x * 0.14, -hy * 0.88, z * 0.55],
        [back + x * 0.14, hy * 0.88, z * 0.55],
        [back, -hy * 0.85, z * 0.7],
        [back, hy * 0.85, z * 0.7],
    ];
    b.hull("hood", &hood, mat);
    let w = (hy * 0.14).min(x * 0.06);
    let h = (z * 0.14).min(w);
    let path = [
        ([back + t * 0.3, 0.0, z * 0.6], w, h),
        ([back - x * 0.1, 0.0, z * 0.75], w * 0.8, h),
        ([-hx + x * 0.1, 0.0, z - h], w, h),
        ([-hx, 0.0, z - h], w * 0.6, h * 0.7),
    ];
    sweep(b, "handle", &path, [0.0, 1.0, 0.0], mat);
    b.inside("inside", [f32::midpoint(back, hx) + x * 0.08, 0.0, t * 1.5], ((hx - back) * 0.3, hy * 0.7), z * 0.5);
}

/// An upright roller of sticky paper with a handle.
pub(super) fn lint_roller(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.choose(&BRIGHT);
    let r = (x / 2.0).min(z * 0.12);
    let (hy, axis) = (y / 2.0, z - r);
    b.rod("roll", [0.0, -hy, axis], [0.0, hy * 0.86, axis], r, WHITE_PAPER);
    b.rod("core", [0.0, -hy * 0.98, axis], [0.0, hy * 0.98, axis], r * 0.4, mat);
    let w = r * 0.28;
    let points = [
        [0.0, hy - w * 3.5, axis],
        [0.0, hy - w * 1.6, axis - r * 0.5],
        [0.0, hy - w * 1.6, axis - r * 1.3],
        [0.0, 0.0, axis - r * 1.9],
        [0.0, 0.0, z * 0.42],
    ];
    planar_tube(b, "arm", &points, w, [1.0, 0.0, 0.0], mat);
    turn(
        b,
        "grip",
        [0.0; 3],
        (r * 0.62, z * 0.5),
        &[(0.7, 0.0), (0.95, 0.08), (0.8, 0.5), (1.0, 0.85), (0.5, 1.0)],
        mat,
    );
}

/// Bin liners on a roll along Y.
pub(super) fn garbage_bag(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.choose(&[BLACK_PLASTIC, BLUE_PLASTIC, WHITE_PLASTIC, GREEN_PLASTIC]);
    let r = x.min(z) / 2.0 - GROWTH.min(x * 0.02);
    let from = [0.0, -y / 2.0, r];
    let core: Vec<_> = [(r, 0.0), (r, y), (r * 0.25, y), (r * 0.25, 0.0), (r, 0.0)].to_vec();
    b.lathe_along("roll", from, [0.0, y / 2.0, r], &core, mat);
    let (paper, ink) = (b.choose(&[WHITE_PAPER, YELLOW_CARD, GREEN_CARD]), b.choose(&[RED_CARD, BLACK_CARD]));
    let band = |low: f32, high: f32, out: f32| -> Vec<(f32, f32)> {
        [(r + out, low), (r + out, high), (r * 0.97, high), (r * 0.97, low), (r + out, low)].to_vec()
    };
    b.lathe_along("band", from, [0.0, y / 2.0, r], &band(y * 0.3, y * 0.7, GROWTH.min(x * 0.02) * 0.5), paper);
    b.lathe_along("print", from, [0.0, y / 2.0, r], &band(y * 0.42, y * 0.5, GROWTH.min(x * 0.02)), ink);
    // A bag pulled off the roll opens above it.
    b.inside("inside", [0.0, 0.0, 2.0 * r], ((r * 0.3).max(0.0045), y * 0.1), x);
}

/// A pair of hanging rubber gloves with the fingers down.
pub(super) fn rubber_gloves(b: &mut Build<'_>) {
    let over = Isometry3::new(Vector3::z() * b.size.z.max(1e-3), Vector3::x() * PI);
    b.posed(over, gloves);
}

/// Two gloves with the fingers down.
fn gloves(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.choose(&[YELLOW_PLASTIC, PINK_PLASTIC, BLUE_PLASTIC, ORANGE_PLASTIC]);
    let hy = y / 2.0;
    let t = x * 0.24;
    for (i, flip) in [-1.0_f32, 1.0].into_iter().enumerate() {
        let at = flip * t;
        let ring = |z: f32, k: f32| {
            rounded_by_share((t, hy * k), 0.9).into_iter().map(|p| [at + p.0 * 0.98, p.1, z]).collect::<Vec<P>>()
        };
        loft_columns(
            b,
            "glove",
            &[ring(z * 0.3, 0.66), ring(z * 0.45, 0.72), ring(z * 0.6, 0.62), ring(z * 0.98, 0.9), ring(z, 0.92)],
            mat,
        );
        for k in 0..4 {
            let cy = hy * 0.5 * (k as f32 / 1.5 - 1.0);
            let low = z * [0.1, 0.02, 0.0, 0.07][k];
            let w = (hy * 0.16).min(z * 0.05);
            let finger = |h: f32, s: f32| ([at, cy, low + (z * 0.34 - low) * h], t * 0.95 * s, w * s);
            sweep(b, "finger", &[finger(0.0, 0.5), finger(0.1, 0.9), finger(1.0, 1.0)], [1.0, 0.0, 0.0], mat);
        }
        let (ty, w) = (if i == 0 { hy } else { -hy }, hy * 0.16);
        let s = ty.signum();
        let thumb = [
            ([at, ty * 0.5, z * 0.46], t * 0.9, w),
            ([at, ty * 0.8, z * 0.38], t * 0.9, w),
            ([at, ty - s * w * 0.8, z * 0.26], t * 0.6, w * 0.7),
        ];
        sweep(b, "thumb", &thumb, [1.0, 0.0, 0.0], mat);
    }
}

/// Dishwasher tablets in a standing pouch or a tub.
pub(super) fn dishwasher_tablets(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let look = look(b);
    let g = GROWTH.min(x * 0.04);
    let (hx, hy) = (x / 2.0 - g, y / 2.0);
    let at = |z: f32, kx: f32, ky: f32| rounded_ring(z, (hx * kx, hy * ky), 0.4);
    loft_columns(b, "tub", &[at(0.0, 0.9, 0.92), at(z * 0.04, 0.97, 0.97), at(z * 0.78, 1.0, 1.0)], look.body);
    loft_columns(b, "lid", &[at(z * 0.785, 1.0, 0.995), at(z * 0.95, 1.0, 0.99), at(z, 0.9, 0.95)], look.cap);
    panel(b, hx, (0.0, hy * 0.7), (z * 0.1, z * 0.7), look.label());
}
