//! Bread, cakes and sweets.

use std::f32::consts::TAU;

use vc_graph::portable::Portable;

use super::super::build::{Axis, Build, P};
use super::super::kitchenware::form::{
    boulder, dims, hoop, level, loft, lump, oval, rounded, shell, spun, sweep, tube, turn,
};
use super::fruit::berry;
use crate::material::*;

/// The section of a loaf: flat below, round above.
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
    let crust =
        if cake { b.one(&[CRUST, YELLOW_SKIN, CHOCOLATE]) } else { b.one(&[CRUST, CRUST, BROWN_SKIN, COOKED_MEAT]) };
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
        loft(b, "loaf", &rings, crust);
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

/// Half a body of ellipses along Y, flat below: bread that was baked on a sheet.
fn domed(b: &mut Build<'_>, name: &str, (low, high): ([f32; 2], [f32; 2]), h: f32, profile: &[(f32, f32)], mat: Mat) {
    let (mx, hx) = (f32::midpoint(low[0], high[0]), (high[0] - low[0]) / 2.0);
    let ring = |&(r, k): &(f32, f32)| {
        let point = |i: usize| {
            let (s, c) = (TAU * i as f32 / 16.0).sine_cosine();
            [mx + hx * r * c, low[1] + (high[1] - low[1]) * k, h * (0.3 + if s > 0.0 { 0.7 } else { 0.3 } * r * s)]
        };
        (0..16).map(point).collect()
    };
    let rings: Vec<Vec<P>> = profile.iter().map(ring).collect();
    loft(b, name, &rings, mat);
}

/// Slanted cuts in a crust.
fn scores(b: &mut Build<'_>, count: usize, (hx, hy): (f32, f32), z: f32, mat: Mat) {
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
    let crust = b.one(&[CRUST, CRUST, BROWN_SKIN]);
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
                .map(|&(k, r)| oval([0.0, 0.0, z * k], (hx * r * 0.98, hy * r * 0.98)))
                .collect();
            loft(b, "cream", &seam, CREAM_FOOD);
            lump(b, "sugar", [0.0, 0.0, z * 0.9], [hx * 0.6, hy * 0.6, z * 0.1], 0.04, PETAL_WHITE);
        }
        _ => scores(b, cuts, (hx, hy), z, CRUMB),
    }
}

/// A thick ring: bagels and donuts, the latter glazed and sprinkled.
pub(super) fn ring_bread(b: &mut Build<'_>, dough: Mat) {
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
    let glaze = b.one(&[CHOCOLATE, PETAL_PINK, PETAL_WHITE, CHOCOLATE]);
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

/// A slice of bread lying flat, its crust around it.
pub(super) fn bread_slice(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let toast = b.rng.chance(0.35);
    let outline: Vec<_> = SLICE.iter().map(|p| (p.1 * x / 0.98 - x / 2.0, p.0 * y / 2.0)).collect();
    b.prism("crust", Axis::Z, [0.0; 3], &outline, z * 0.95, if toast { COOKED_MEAT } else { CRUST });
    let inner: Vec<_> = outline.iter().map(|p| (p.0 * 0.92, p.1 * 0.92)).collect();
    b.prism("crumb", Axis::Z, [0.0, 0.0, z * 0.1], &inner, z * 0.9, if toast { CRUST } else { CRUMB });
}

/// A croissant: a bent roll of steps, thick in the middle.
pub(super) fn croissant(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.one(&[CRUST, CRUST, MUSTARD]);
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

/// Flat round things in a stack: tortillas, pancakes.
pub(super) fn stack(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let pancake = b.class == "pancake";
    let mat = if pancake { CRUST } else { b.one(&[CRUMB, PALE_FLESH]) };
    let count = ((z / if pancake { 0.012 } else { 0.005 }).round() as usize).clamp(1, 5);
    let room = z * if pancake && count > 2 { 0.85 } else { 0.94 };
    let t = room / count as f32;
    for i in 0..count {
        let k = 0.94 + 0.06 * ((i * 5) % 3) as f32 / 2.0;
        let (dx, dy) = (hx * (1.0 - k) * (2.1 * i as f32).sine(), hy * (1.0 - k) * (1.3 * i as f32).cosine());
        let ring = |z: f32, r: f32| oval([dx, dy, z], (hx * k * r, hy * k * r));
        let low = t * i as f32;
        loft(b, "layer", &[ring(low + t * 0.02, 0.95), ring(low + t * 0.4, 1.0), ring(low + t, 0.93)], mat);
        if !pancake && i + 1 == count {
            for j in 0..6 {
                let (s, c) = (2.4 * j as f32).sine_cosine();
                let out = 0.7 * (j as f32 / 6.0).sqrt();
                b.cylinder("spot", [hx * out * c, hy * out * s, room - t * 0.3], hx * 0.09, z - room + t * 0.3, CRUST);
            }
        }
    }
    if pancake && room < z {
        b.soft("butter", [-hx * 0.2, -hx * 0.2, room * 0.98], [hx * 0.2, hx * 0.2, z], z * 0.04, YELLOW_SKIN);
    }
}

/// A layer cake with icing, cream and berries, or candles; some with a slice out.
pub(super) fn cake(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let (icing, crumb) =
        b.one(&[(CREAM_FOOD, CRUMB), (CHOCOLATE, CHOCOLATE), (PETAL_PINK, CRUMB), (CREAM_FOOD, CHOCOLATE)]);
    let trim = b.one(&[CREAM_FOOD, CHOCOLATE, PETAL_PINK]);
    let candles = b.rng.chance(0.35);
    let h = z * if candles { 0.62 } else { 0.82 };
    let whole = b.rng.chance(0.6);
    if whole {
        turn(b, "cake", [0.0; 3], (r, h), &[(0.98, 0.0), (1.0, 0.04), (0.98, 0.94), (0.92, 1.0)], icing);
        for i in 0..2 {
            let at = h * (0.02 + 0.86 * i as f32);
            hoop(b, "trim", (at, at + h * 0.08), (r * 0.9, r * 0.999), trim);
        }
    } else {
        let sector = |k: f32| -> Vec<(f32, f32)> {
            (0..=20)
                .map(|i| {
                    let (s, c) = (0.35 + 5.58 * i as f32 / 20.0).sine_cosine();
                    (r * k * c, r * k * s)
                })
                .chain([(0.0, 0.0)])
                .collect()
        };
        b.prism("icing", Axis::Z, [0.0, 0.0, h * 0.01], &sector(1.0), h * 0.99, icing);
        for i in 0..3 {
            // Layers show in the cut.
            b.prism("layer", Axis::Z, [r * 0.012, 0.0, h * (0.04 + 0.3 * i as f32)], &sector(0.95), h * 0.24, crumb);
        }
    }
    let count = 8;
    for i in 0..count {
        let angle = TAU * (i as f32 + 0.9) / (count as f32 + 0.8);
        let (s, c) = angle.sine_cosine();
        let at = [r * 0.74 * c, r * 0.74 * s];
        if candles {
            b.cylinder(
                "candle",
                [at[0], at[1], h * 0.97],
                r * 0.03,
                z * 0.3,
                [PETAL_PINK, PETAL_BLUE, PETAL_YELLOW][i % 3],
            );
            b.cone("flame", [at[0], at[1], h * 0.97 + z * 0.3], r * 0.025, (z * 0.7 - h * 0.97).max(z * 0.02), FLAME);
        } else {
            turn(
                b,
                "dollop",
                [at[0], at[1], h * 0.98],
                (r * 0.12, z - h * 1.04),
                &[(1.0, 0.0), (0.9, 0.4), (0.4, 0.8), (0.1, 1.0)],
                trim,
            );
            let top = (z - r * 0.075).max(h);
            berry(b, [at[0], at[1], top.min(z - r * 0.07)], r * 0.07, RED_SKIN);
        }
    }
}

/// Muffins and cupcakes: a pleated paper cup, a dome or a swirl.
pub(super) fn muffin(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let paper = b.one(&[WHITE_PAPER, CARDBOARD, PINK_CARD, BLUE_CARD, CREAM_PAPER]);
    let low = z * b.vary(0.42, 0.56);
    let pleats = 20;
    let ring = |z: f32, k: f32| -> Vec<P> {
        (0..2 * pleats)
            .map(|i| {
                let (s, c) = (TAU * i as f32 / (2 * pleats) as f32).sine_cosine();
                let k = r * k * if i % 2 == 0 { 1.0 } else { 0.93 };
                [k * c, k * s, z]
            })
            .collect()
    };
    loft(b, "paper", &[ring(0.0, 0.68), ring(low, 0.9)], paper);
    if b.class == "muffin" {
        let dough = b.one(&[CRUST, CHOCOLATE, MUSTARD]);
        spun(
            b,
            "dome",
            ([-r, -r, low * 0.9], [r, r, z]),
            &[(0.85, 0.0), (0.97, 0.15), (1.0, 0.35), (0.9, 0.65), (0.6, 0.9), (0.25, 0.99), (0.0, 1.0)],
            false,
            dough,
        );
        let bits = if dough == CHOCOLATE { CRUMB } else { b.one(&[CHOCOLATE, PURPLE_SKIN]) };
        let count = b.rng.count(4, 10);
        for i in 0..count {
            let (s, c) = (2.4 * i as f32).sine_cosine();
            let k = 0.3 + 0.5 * i as f32 / count as f32;
            berry(
                b,
                [
                    r * k * c,
                    r * k * s,
                    (low * 0.9 + (z - low * 0.9) * (1.0 - k * k * k * k * 0.6) - r * 0.05).min(z - r * 0.09),
                ],
                r * 0.08,
                bits,
            );
        }
    } else {
        let cream = b.one(&[CREAM_FOOD, PETAL_PINK, CHOCOLATE, PETAL_WHITE]);
        let swirl: Vec<_> = [
            (0.9, 0.0),
            (0.98, 0.1),
            (0.85, 0.24),
            (0.68, 0.27),
            (0.76, 0.36),
            (0.64, 0.5),
            (0.45, 0.53),
            (0.52, 0.62),
            (0.4, 0.76),
            (0.2, 0.85),
            (0.05, 0.95),
        ]
        .to_vec();
        turn(b, "swirl", [0.0, 0.0, low * 0.97], (r, (z - r * 0.2 - low * 0.97).max(z * 0.2)), &swirl, cream);
        berry(b, [0.0, 0.0, z - r * 0.17], r * 0.17, RED_SKIN);
    }
}

/// A pie: a crimped crust, a filling, a lattice.
pub(super) fn pie(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let filling = b.one(&[RED_SKIN, PURPLE_SKIN, ORANGE_SKIN, MUSTARD]);
    let outside: Vec<_> = [(0.8, 0.0), (0.93, 0.85), (0.97, 0.9)].iter().map(|p| (p.0 * r, p.1 * z)).collect();
    b.lathe("crust", [0.0; 3], &shell(&outside, r * 0.05), CRUST);
    turn(b, "filling", [0.0, 0.0, z * 0.1], (r, z * 0.68), &[(0.77, 0.0), (0.87, 1.0)], filling);
    for i in 0..16 {
        let (s, c) = (TAU * i as f32 / 16.0).sine_cosine();
        berry(b, [r * 0.93 * c, r * 0.93 * s, z * 0.9], (r * 0.07).min(z * 0.1), CRUST);
    }
    if b.rng.chance(0.6) { lattice(b, r, z) } else { closed_crust(b, r, z, filling) }
}

/// Strips of dough across a pie.
fn lattice(b: &mut Build<'_>, r: f32, z: f32) {
    let strips = b.rng.count(3, 6);
    let half = r * 0.26 / strips as f32;
    for i in 0..strips {
        let at = r * 0.6 * (2.0 * i as f32 / (strips - 1) as f32 - 1.0);
        let reach = ((r * 0.88).raised(2) - at * at).max(0.0).sqrt();
        b.block("lattice", [at - half, -reach, z * 0.7], [at + half, reach, z * 0.84], CRUST);
        b.block("lattice", [-reach, at - half, z * 0.7], [reach, at + half, z * 0.88], CRUST);
    }
}

/// A domed crust with slits that show the filling.
fn closed_crust(b: &mut Build<'_>, r: f32, z: f32, filling: Mat) {
    turn(
        b,
        "cover",
        [0.0, 0.0, z * 0.74],
        (r * 0.9, z * 0.2),
        &[(1.0, 0.0), (0.8, 0.6), (0.4, 0.92), (0.0, 1.0)],
        CRUST,
    );
    let slits = b.rng.count(4, 8);
    for i in 0..slits {
        b.at([0.0; 3], TAU * i as f32 / slits as f32, |b| {
            b.block("slit", [r * 0.2, -r * 0.03, z * 0.76], [r * 0.5, r * 0.03, z * 0.935], filling);
        });
    }
}

/// A cookie with chips, or a biscuit with pricks.
pub(super) fn cookie(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let dough = b.one(&[CRUST, CHOCOLATE, MUSTARD]);
    let bits = if dough == CHOCOLATE { PALE_FLESH } else { CHOCOLATE };
    if b.rng.chance(0.7) {
        lump(b, "cookie", [0.0, 0.0, z * 0.45], [hx, hy, z * 0.45], 0.02, dough);
        for i in 0..8 {
            let (s, c) = (2.4 * i as f32).sine_cosine();
            let k = 0.75 * ((i as f32 + 0.3) / 8.0).sqrt();
            berry(b, [hx * k * c, hy * k * s, z * (0.87 - 0.25 * k)], z * 0.13, bits);
        }
    } else {
        let square = b.rng.chance(0.5);
        let plan = rounded((hx * 0.98, hy * 0.98), if square { 0.15 } else { 1.0 });
        b.prism("biscuit", Axis::Z, [0.0; 3], &plan, z * 0.45, dough);
        b.prism(
            "filling",
            Axis::Z,
            [0.0, 0.0, z * 0.4],
            &plan.iter().map(|p| (p.0 * 0.93, p.1 * 0.93)).collect::<Vec<_>>(),
            z * 0.2,
            CREAM_FOOD,
        );
        b.prism("biscuit", Axis::Z, [0.0, 0.0, z * 0.56], &plan, z * 0.4, dough);
        for i in 0..5 {
            let (s, c) = (TAU * i as f32 / 5.0).sine_cosine();
            b.cylinder("prick", [hx * 0.5 * c, hy * 0.5 * s, z * 0.9], hx * 0.05, z * 0.1, CHOCOLATE);
        }
    }
}

/// A waffle: a plate under a grid of ridges.
pub(super) fn waffle(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let round = b.one(&[1.0, 0.25]);
    b.prism("plate", Axis::Z, [0.0; 3], &rounded((hx, hy), round), z * 0.55, CRUST);
    for i in 0..6 {
        let k = i as f32 / 2.5 - 1.0;
        let at = 0.88 * k;
        let reach = if round > 0.5 { (0.96 - at * at).max(0.0).sqrt().min(0.97) } else { 0.96 };
        b.block(
            "ridge",
            [hx * at - hx * 0.06, -hy * reach, z * 0.5],
            [hx * at + hx * 0.06, hy * reach, z * 0.98],
            CRUST,
        );
        b.block("ridge", [-hx * reach, hy * at - hy * 0.06, z * 0.5], [hx * reach, hy * at + hy * 0.06, z], CRUST);
    }
}

/// Dough in a lump, or rolled on itself.
pub(super) fn dough(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    boulder(b, "dough", ([0.0, 0.0, z / 2.0], [x / 2.0, y / 2.0, z / 2.0]), 0.04, (20, 12), CREAM_FOOD);
}

/// A knot of dough with salt.
pub(super) fn pretzel(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = (z * 0.45).min(x * 0.1);
    let (hx, hy) = (x / 2.0 - r, y / 2.0 - r);
    // From one end over the cross and round both loops to the other end.
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

/// A ball or a disc of sugar on a stick, standing on its end.
pub(super) fn lollipop(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let (mat, other) = b.one(&[
        (RED_SKIN, PETAL_WHITE),
        (ORANGE_SKIN, PETAL_YELLOW),
        (PETAL_PINK, PETAL_WHITE),
        (GREEN_SKIN, PETAL_WHITE),
    ]);
    let centre = z - r;
    b.cylinder("stick", [0.0; 3], r * 0.12, centre, WHITE_PAPER);
    b.ball("sweet", [0.0, 0.0, centre], r, mat);
    hoop(b, "swirl", (centre - r * 0.15, centre + r * 0.15), (r * 0.9, r), other);
}

/// Scoops with a wafer in a cup.
pub(super) fn ice_cream(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let cup = b.one(&[GLASS, b.style.crockery, PINK_CARD, WHITE_PAPER]);
    let low = z * 0.5;
    let t = hx * 0.05;
    let at = |z: f32, k: f32| level(z, (hx * k, hy * k), 1.0);
    loft(
        b,
        "cup",
        &[
            at(0.0, 0.6),
            at(low * 0.4, 0.85),
            at(low, 1.0),
            at(low, 1.0 - t / hx),
            at(low * 0.4, 0.85 - t / hx),
            at(low * 0.3, 0.6),
        ],
        cup,
    );
    let flavours = [CREAM_FOOD, CHOCOLATE, PETAL_PINK, GREEN_SKIN, PALE_FLESH];
    let count = if y > x * 1.25 { 3 } else { 2 };
    let r = (hx * 0.62).min(hy * 0.9 / count as f32 + hx * 0.2);
    let start = b.rng.below(5);
    for i in 0..count {
        let k = i as f32 - (count as f32 - 1.0) / 2.0;
        let reach = if count == 2 { 0.75 } else { 1.0 };
        lump(
            b,
            "scoop",
            [0.0, k * (hy - r) * reach, z * 0.66],
            [r.min(hx * 0.9), r, z * 0.34],
            0.04,
            flavours[(start + i) % 5],
        );
    }
    let filling = flavours[(start + 3) % 5];
    loft(b, "filling", &[at(low * 0.32, 0.5), at(low * 0.4, 0.8), at(low * 0.95, 0.95)], filling);
    let wafer = z * 0.98;
    b.prism(
        "wafer",
        Axis::X,
        [-hx * 0.4, 0.0, z * 0.5],
        &[(-hy * 0.1, 0.0), (hy * 0.1, 0.0), (hy * 0.18, wafer - z * 0.5), (-hy * 0.18, wafer - z * 0.5)],
        hx * 0.05,
        CRUST,
    );
}

/// A pudding turned out on a plate, with sauce.
pub(super) fn pudding(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let (body, sauce) =
        b.one(&[(CREAM_FOOD, RED_SKIN), (MUSTARD, CHOCOLATE), (CHOCOLATE, CREAM_FOOD), (PETAL_PINK, RED_SKIN)]);
    let plate = b.style.crockery;
    turn(b, "plate", [0.0; 3], (r, z * 0.12), &[(0.7, 0.0), (1.0, 0.8), (1.0, 1.0), (0.75, 0.6)], plate);
    turn(
        b,
        "pudding",
        [0.0, 0.0, z * 0.06],
        (r * 0.72, z * 0.84),
        &[(1.0, 0.0), (0.97, 0.1), (0.75, 0.9), (0.68, 1.0)],
        body,
    );
    turn(
        b,
        "sauce",
        [0.0, 0.0, z * 0.87],
        (r * 0.56, z * 0.13),
        &[(1.0, 0.0), (0.95, 0.5), (0.5, 0.9), (0.1, 1.0)],
        sauce,
    );
    for i in 0..4 {
        b.at([0.0; 3], TAU * i as f32 / 4.0 + 0.4, |b| {
            let (a, c) = (r * 0.5, r * 0.62);
            tube(
                b,
                "drip",
                &[[a * 0.9, 0.0, z * 0.9], [a * 1.03, 0.0, z * 0.85], [c, 0.0, z * 0.5]],
                r * 0.06,
                [0.0, 1.0, 0.0],
                sauce,
            );
        });
    }
}
