//! Bread and other baked dough.

use std::f32::consts::TAU;

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Axis, Build, P, boulder, dims, level_oval, loft_columns, lump, sweep};

/// The section of a loaf: flat bottom, round top.
const SLICE: [(f32, f32); 12] = [
    (-0.85, 0.0),
    (0.85, 0.0),
    (0.92, 0.25),
    (0.9, 0.5),
    (1.0, 0.66),
    (0.95, 0.85),
    (0.65, 0.98),
    (-0.65, 0.98),
    (-0.95, 0.85),
    (-1.0, 0.66),
    (-0.9, 0.5),
    (-0.92, 0.25),
];

/// Loaves: from a tin, round-topped, or free and scored; some cut.
pub(super) fn loaf(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let cake = b.class == "pound_cake";
    let crust = if cake {
        b.choose(&[CRUST, YELLOW_SKIN, CHOCOLATE])
    } else {
        b.choose(&[CRUST, CRUST, BROWN_SKIN, COOKED_MEAT])
    };
    let crumb = if crust == CHOCOLATE { CHOCOLATE } else { CRUMB };
    if cake || b.rng.chance(0.5) {
        let sliced = b.rng.chance(0.5);
        let ring =
            |y: f32, k: f32| SLICE.iter().map(|p| [p.0 * hx * k, y, p.1 * z * 0.98 * k + z * 0.01]).collect::<Vec<P>>();
        let end = if sliced { hy * 0.35 } else { hy * 0.97 };
        let mut rings = vec![ring(-hy, 0.9), ring(-hy * 0.97, 0.98), ring(end, 1.0)];
        if !sliced {
            rings.push(ring(hy, 0.92));
        }
        loft_columns(b, "loaf", &rings, crust);
        if sliced {
            let cut: Vec<_> = SLICE.iter().map(|p| (p.0 * hx * 0.93, p.1 * z * 0.9 + z * 0.03)).collect();
            b.prism(
                "crumb",
                Axis::Y,
                [0.0, end - y * 0.01, 0.0],
                &cut.iter().map(|p| (p.0, p.1)).collect::<Vec<_>>(),
                y * 0.013,
                crumb,
            );
            for i in 0..3 {
                let at = hy * (0.36 + 0.2 * i as f32);
                let outline: Vec<_> = SLICE.iter().map(|p| (p.0 * hx, p.1 * z * (0.98 - 0.01 * i as f32))).collect();
                b.prism("slice", Axis::Y, [0.0, at, 0.0], &outline, hy * 0.19, crust);
                b.prism("crumb", Axis::Y, [0.0, at - hy * 0.004, 0.0], &cut, hy * 0.2, crumb);
            }
        }
        if cake {
            for i in 0..5 {
                let at = end * (i as f32 / 2.5 - 1.0) * 0.8 - hy * 0.1;
                b.hull(
                    "icing",
                    &[
                        [-hx * 0.7, at, z * 0.93],
                        [hx * 0.7, at + hy * 0.1, z * 0.93],
                        [-hx * 0.5, at, z],
                        [hx * 0.5, at + hy * 0.1, z],
                        [-hx * 0.6, at + hy * 0.08, z * 0.99],
                        [hx * 0.6, at + hy * 0.02, z * 0.99],
                    ],
                    CREAM_FOOD,
                );
            }
        }
        return;
    }
    let profile = [
        (0.0, 0.0),
        (0.45, 0.02),
        (0.75, 0.1),
        (0.95, 0.28),
        (1.0, 0.5),
        (0.95, 0.72),
        (0.75, 0.9),
        (0.45, 0.98),
        (0.0, 1.0),
    ];
    domed(b, "loaf", ([-hx, -hy], [hx, hy]), z * 0.98, &profile, crust);
    let cuts = b.rng.count(3, 5);
    scores(b, cuts, (hx, hy), z, CRUMB);
}

/// Half an elliptical body along Y with a flat bottom, as of bread baked on a sheet.
fn domed(
    b: &mut Build<'_>,
    name: &str,
    (low, high): ([f32; 2], [f32; 2]),
    h: f32,
    profile: &[(f32, f32)],
    mat: MaterialId,
) {
    let (mx, hx) = (f32::midpoint(low[0], high[0]), (high[0] - low[0]) / 2.0);
    let ring = |&(r, k): &(f32, f32)| {
        let point = |i: usize| {
            let (s, c) = (TAU * i as f32 / 16.0).sine_cosine();
            [mx + hx * r * c, low[1] + (high[1] - low[1]) * k, h * (0.3 + if s > 0.0 { 0.7 } else { 0.3 } * r * s)]
        };
        (0..16).map(point).collect()
    };
    let rings: Vec<Vec<P>> = profile.iter().map(ring).collect();
    loft_columns(b, name, &rings, mat);
}

/// Slanted scores in a crust.
fn scores(b: &mut Build<'_>, count: usize, (hx, hy): (f32, f32), z: f32, mat: MaterialId) {
    for i in 0..count {
        let at = hy * 1.3 * ((i as f32 + 0.5) / count as f32 - 0.5);
        let w = (hy * 0.28 / count as f32).min(hx * 0.2);
        b.hull(
            "score",
            &[
                [-hx * 0.45, at - w * 2.0, z * 0.86],
                [hx * 0.45, at + w * 2.0, z * 0.86],
                [-w, at + w * 0.6, z * 0.9],
                [w, at - w * 0.6, z * 0.9],
                [0.0, at, z],
                [-hx * 0.25, at - w, z * 0.965],
                [hx * 0.25, at + w, z * 0.965],
            ],
            mat,
        );
    }
}

/// Rolls, baguettes and other small bread.
pub(super) fn roll(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let crust = b.choose(&[CRUST, CRUST, BROWN_SKIN]);
    let profile: &[(f32, f32)] = if b.class == "baguette" {
        &[(0.0, 0.0), (0.5, 0.02), (0.85, 0.1), (1.0, 0.3), (1.0, 0.7), (0.85, 0.9), (0.5, 0.98), (0.0, 1.0)]
    } else {
        &[
            (0.0, 0.0),
            (0.4, 0.04),
            (0.72, 0.15),
            (0.93, 0.31),
            (1.0, 0.5),
            (0.93, 0.69),
            (0.72, 0.85),
            (0.4, 0.96),
            (0.0, 1.0),
        ]
    };
    if b.class == "bread_roll" && b.rng.chance(0.35) {
        return ring_bread(b, CRUST);
    }
    domed(b, "bread", ([-hx, -hy], [hx, hy]), z * 0.97, profile, crust);
    let cuts = if b.class == "baguette" { 5 } else { 1 };
    match b.class {
        "creamy_buns" => {
            let seam: Vec<Vec<P>> = [(0.45, 0.98), (0.62, 1.0), (0.72, 0.98)]
                .iter()
                .map(|&(k, r)| level_oval([0.0, 0.0, z * k], (hx * r * 0.98, hy * r * 0.98)))
                .collect();
            loft_columns(b, "cream", &seam, CREAM_FOOD);
            lump(b, "sugar", [0.0, 0.0, z * 0.9], [hx * 0.6, hy * 0.6, z * 0.1], 0.04, PETAL_WHITE);
        }
        _ => scores(b, cuts, (hx, hy), z, CRUMB),
    }
}

/// A thick ring: bagels and donuts, the latter glazed and sprinkled.
pub(super) fn ring_bread(b: &mut Build<'_>, dough: MaterialId) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let thick = (r * 0.36).min(z * 0.7);
    let circle = |k: f32, from: f32, to: f32, lift: f32| -> Vec<(f32, f32)> {
        (0..=12)
            .map(|i| {
                let (s, c) = (TAU * (from + (to - from) * i as f32 / 12.0)).sine_cosine();
                (r - thick + thick * k * c, z / 2.0 * (1.0 - lift) + (z / 2.0) * (1.0 - lift) * k * s + lift * z)
            })
            .collect()
    };
    let mut body = circle(1.0, 0.0, 1.0, 0.0);
    if let Some(last) = body.last_mut() {
        *last = (r, z / 2.0);
    }
    let body: Vec<_> = body.iter().map(|p| (p.0, p.1 * 0.97)).collect();
    b.lathe("ring", [0.0; 3], &body, dough);
    if b.class != "donut" {
        return;
    }
    let glaze = b.choose(&[CHOCOLATE, PETAL_PINK, PETAL_WHITE, CHOCOLATE]);
    let mut top: Vec<_> = (0..=8)
        .map(|i| {
            let (s, c) = (TAU * (0.06 + 0.38 * i as f32 / 8.0)).sine_cosine();
            (r - thick + thick * 0.96 * c, z * 0.49 + z * 0.5 * s)
        })
        .collect();
    let first = top[0];
    top.push(first);
    b.lathe("glaze", [0.0; 3], &top, glaze);
    let colours = [PETAL_RED, PETAL_YELLOW, PETAL_BLUE, PETAL_WHITE];
    for i in 0..14 {
        let (s, c) = (2.4 * i as f32).sine_cosine();
        let out = r - thick + thick * 0.4 * (1.9 * i as f32).sine();
        let (ax, ay) = ((3.1 * i as f32).cosine() * r * 0.05, (3.1 * i as f32).sine() * r * 0.05);
        let at = [out * c, out * s];
        b.block(
            "sprinkle",
            [at[0] - ax.abs() - r * 0.01, at[1] - ay.abs() - r * 0.01, z * 0.9],
            [at[0] + ax.abs() + r * 0.01, at[1] + ay.abs() + r * 0.01, z],
            colours[i % 4],
        );
    }
}

/// A donut.
pub(super) fn donut(b: &mut Build<'_>) {
    ring_bread(b, CRUST);
}

/// A slice of bread lying flat, with crust around it.
pub(super) fn bread_slice(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let toast = b.rng.chance(0.35);
    let outline: Vec<_> = SLICE.iter().map(|p| (p.1 * x / 0.98 - x / 2.0, p.0 * y / 2.0)).collect();
    b.prism("crust", Axis::Z, [0.0; 3], &outline, z * 0.95, if toast { COOKED_MEAT } else { CRUST });
    let inner: Vec<_> = outline.iter().map(|p| (p.0 * 0.92, p.1 * 0.92)).collect();
    b.prism("crumb", Axis::Z, [0.0, 0.0, z * 0.1], &inner, z * 0.9, if toast { CRUST } else { CRUMB });
}

/// A croissant: a bent, stepped roll, thick in the centre.
pub(super) fn croissant(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.choose(&[CRUST, CRUST, MUSTARD]);
    let r = (z / 2.0).min(x * 0.36);
    let steps = 7;
    for i in 0..steps {
        let t = (i as f32 + 0.5) / steps as f32 * 2.0 - 1.0;
        let place = |t: f32, k: f32| {
            let w = (r * (1.0 - 0.7 * t.abs().power(1.5)) * k).max(r * 0.08);
            ([x / 2.0 - r - (x - 2.0 * r) * t * t, (y / 2.0 - r * 0.2) * t, (w / k * 0.98).min(z / 2.0)], w, w)
        };
        let half = 1.25 / steps as f32;
        let (a, c) = ((t - half).max(-1.0), (t + half).min(1.0));
        let path = if t < 0.0 {
            [place(a, 0.75), place(f32::midpoint(a, t), 0.85), place(t, 0.95), place(c, 1.0)]
        } else {
            [place(a, 1.0), place(t, 0.95), place(f32::midpoint(c, t), 0.85), place(c, 0.75)]
        };
        sweep(b, "fold", &path, [0.0, 0.0, 1.0], mat);
    }
}

/// Flat round food in a stack: tortillas, pancakes.
pub(super) fn stack(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let pancake = b.class == "pancake";
    let mat = if pancake { CRUST } else { b.choose(&[CRUMB, PALE_FLESH]) };
    let count = ((z / if pancake { 0.012 } else { 0.005 }).round() as usize).clamp(1, 5);
    let room = z * if pancake && count > 2 { 0.85 } else { 0.94 };
    let t = room / count as f32;
    for i in 0..count {
        let k = 0.94 + 0.06 * ((i * 5) % 3) as f32 / 2.0;
        let (dx, dy) = (hx * (1.0 - k) * (2.1 * i as f32).sine(), hy * (1.0 - k) * (1.3 * i as f32).cosine());
        let ring = |z: f32, r: f32| level_oval([dx, dy, z], (hx * k * r, hy * k * r));
        let low = t * i as f32;
        loft_columns(b, "layer", &[ring(low + t * 0.02, 0.95), ring(low + t * 0.4, 1.0), ring(low + t, 0.93)], mat);
        if !pancake && i + 1 == count {
            for j in 0..6 {
                let (s, c) = (2.4 * j as f32).sine_cosine();
                let out = 0.7 * (j as f32 / 6.0).sqrt();
                b.cylinder("spot", [hx * out * c, hy * out * s, room - t * 0.3], hx * 0.09, z - room + t * 0.3, CRUST);
            }
        }
    }
    if pancake && room < z {
        b.rounded_block("butter", [-hx * 0.2, -hx * 0.2, room * 0.98], [hx * 0.2, hx * 0.2, z], z * 0.04, YELLOW_SKIN);
    }
}

/// A lump of dough, or dough rolled up.
pub(super) fn dough(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    boulder(b, "dough", ([0.0, 0.0, z / 2.0], [x / 2.0, y / 2.0, z / 2.0]), 0.04, (20, 12), CREAM_FOOD);
}

/// A knot of dough with salt.
pub(super) fn pretzel(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = (z * 0.45).min(x * 0.1);
    let (hx, hy) = (x / 2.0 - r, y / 2.0 - r);
    // The path runs from one end over the crossing and round both loops to the other end.
    let half = [
        (0.35, -0.7),
        (0.12, -0.25),
        (-0.12, 0.12),
        (-0.5, 0.7),
        (-0.8, 0.92),
        (-0.98, 0.6),
        (-0.95, 0.1),
        (-0.8, -0.45),
        (-0.45, -0.88),
    ];
    let other = half.iter().rev().map(|p| (-p.0, p.1));
    let points: Vec<(f32, f32)> = half.iter().copied().chain([(0.0, -1.0)]).chain(other).collect();
    let last = points.len() - 1;
    let place = |(i, &(v, u)): (usize, &(f32, f32))| {
        let k = i as f32 / last as f32;
        let w = r * (0.6 + 0.4 * (std::f32::consts::PI * k).sine());
        // The ends lie on the loop, the second over the first.
        let lift = match i {
            0 => z - r,
            i if i + 4 > last => z - r,
            _ => r,
        };
        ([hx * u, hy * v, lift], w, w)
    };
    let path: Vec<_> = points.iter().enumerate().map(place).collect();
    sweep(b, "pretzel", &path, [0.0, 0.0, 1.0], COOKED_MEAT);
    for i in 0..10 {
        let p = path[4 + i % (last - 7)].0;
        let s = r * 0.12;
        let shift = r * 0.35 * (1.7 * i as f32).sine();
        b.block(
            "salt",
            [p[0] - s + shift, p[1] - s, p[2] + r * 0.8],
            [p[0] + s + shift, p[1] + s, (p[2] + r * 1.05).min(z)],
            PETAL_WHITE,
        );
    }
}
