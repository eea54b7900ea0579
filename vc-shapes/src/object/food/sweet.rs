//! Cakes and sweets.

use super::fruit::berry;
use crate::material::*;
use crate::solid::{
    Axis, Build, P, dims, flat_ring, loft_columns, lump, planar_tube, rounded_by_share, rounded_ring, spun, turn,
    vessel_profile,
};
use std::f32::consts::TAU;
use vc_graph::portable::Portable;

/// A layer cake with icing, cream and berries, or candles; sometimes with a slice cut out.
pub(super) fn cake(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let (icing, crumb) =
        b.choose(&[(CREAM_FOOD, CRUMB), (CHOCOLATE, CHOCOLATE), (PETAL_PINK, CRUMB), (CREAM_FOOD, CHOCOLATE)]);
    let trim = b.choose(&[CREAM_FOOD, CHOCOLATE, PETAL_PINK]);
    let candles = b.rng.chance(0.35);
    let h = z * if candles { 0.62 } else { 0.82 };
    let whole = b.rng.chance(0.6);
    if whole {
        turn(b, "cake", [0.0; 3], (r, h), &[(0.98, 0.0), (1.0, 0.04), (0.98, 0.94), (0.92, 1.0)], icing);
        for i in 0..2 {
            let at = h * (0.02 + 0.86 * i as f32);
            flat_ring(b, "trim", (at, at + h * 0.08), (r * 0.9, r * 0.999), trim);
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
            // Layers are visible in the cut.
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
    let paper = b.choose(&[WHITE_PAPER, CARDBOARD, PINK_CARD, BLUE_CARD, CREAM_PAPER]);
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
    loft_columns(b, "paper", &[ring(0.0, 0.68), ring(low, 0.9)], paper);
    if b.class == "muffin" {
        let dough = b.choose(&[CRUST, CHOCOLATE, MUSTARD]);
        spun(
            b,
            "dome",
            ([-r, -r, low * 0.9], [r, r, z]),
            &[(0.85, 0.0), (0.97, 0.15), (1.0, 0.35), (0.9, 0.65), (0.6, 0.9), (0.25, 0.99), (0.0, 1.0)],
            false,
            dough,
        );
        let bits = if dough == CHOCOLATE { CRUMB } else { b.choose(&[CHOCOLATE, PURPLE_SKIN]) };
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
        let cream = b.choose(&[CREAM_FOOD, PETAL_PINK, CHOCOLATE, PETAL_WHITE]);
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

/// A pie: a crimped crust, a filling and a lattice.
pub(super) fn pie(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let filling = b.choose(&[RED_SKIN, PURPLE_SKIN, ORANGE_SKIN, MUSTARD]);
    let outside: Vec<_> = [(0.8, 0.0), (0.93, 0.85), (0.97, 0.9)].iter().map(|p| (p.0 * r, p.1 * z)).collect();
    b.lathe("crust", [0.0; 3], &vessel_profile(&outside, r * 0.05), CRUST);
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
fn closed_crust(b: &mut Build<'_>, r: f32, z: f32, filling: MaterialId) {
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
    let dough = b.choose(&[CRUST, CHOCOLATE, MUSTARD]);
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
        let plan = rounded_by_share((hx * 0.98, hy * 0.98), if square { 0.15 } else { 1.0 });
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
    let round = b.choose(&[1.0, 0.25]);
    b.prism("plate", Axis::Z, [0.0; 3], &rounded_by_share((hx, hy), round), z * 0.55, CRUST);
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

/// A ball or a disc of sugar on an upright stick.
pub(super) fn lollipop(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let (mat, other) = b.choose(&[
        (RED_SKIN, PETAL_WHITE),
        (ORANGE_SKIN, PETAL_YELLOW),
        (PETAL_PINK, PETAL_WHITE),
        (GREEN_SKIN, PETAL_WHITE),
    ]);
    let centre = z - r;
    b.cylinder("stick", [0.0; 3], r * 0.12, centre, WHITE_PAPER);
    b.ball("sweet", [0.0, 0.0, centre], r, mat);
    flat_ring(b, "swirl", (centre - r * 0.15, centre + r * 0.15), (r * 0.9, r), other);
}

/// Scoops of ice cream with a wafer in a cup.
pub(super) fn ice_cream(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let cup = b.choose(&[GLASS, b.style.crockery, PINK_CARD, WHITE_PAPER]);
    let low = z * 0.5;
    let t = hx * 0.05;
    let at = |z: f32, k: f32| rounded_ring(z, (hx * k, hy * k), 1.0);
    loft_columns(
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
    loft_columns(b, "filling", &[at(low * 0.32, 0.5), at(low * 0.4, 0.8), at(low * 0.95, 0.95)], filling);
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

/// A pudding on a plate, with sauce.
pub(super) fn pudding(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let (body, sauce) =
        b.choose(&[(CREAM_FOOD, RED_SKIN), (MUSTARD, CHOCOLATE), (CHOCOLATE, CREAM_FOOD), (PETAL_PINK, RED_SKIN)]);
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
            planar_tube(
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
