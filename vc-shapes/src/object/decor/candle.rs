//! Candles and candle holders.

use std::f32::consts::TAU;

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, half_dims, oval, spline};

const WAXES: [MaterialId; 7] = [WAX, WHITE_PLASTIC, RED_GLAZE, WAX, PINK_PLASTIC, SAGE, NAVY];

/// A wick on top of wax.
fn wick(b: &mut Build<'_>, at: P, high: f32) {
    b.rod("wick", [at[0], at[1], at[2] - high * 0.2], [at[0], at[1], at[2] + high], high * 0.12, BLACK_FABRIC);
}

/// A candle: a pillar, one in a glass, a tin or a bowl, or one with three wicks.
pub(super) fn candle(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    let wax = b.choose(&WAXES);
    let string = (h * 0.12).min(0.012);
    let top = h - string;
    match b.rng.below(4) {
        0 => {
            let dip = r * b.vary(0.7, 0.85);
            b.lathe(
                "wax",
                [0.0; 3],
                &[(r * 0.98, 0.0), (r, h * 0.02), (r, top), (dip, top), (dip * 0.6, top - h * 0.04)],
                wax,
            );
            wick(b, [0.0, 0.0, top - h * 0.04], string + h * 0.03);
            drips(b, r, top, wax);
        }
        1 => {
            let glass = b.choose(&[GLASS, FROSTED_GLASS, BROWN_GLASS, BLUE_GLASS]);
            let t = r * 0.06;
            b.lathe(
                "glass",
                [0.0; 3],
                &[(r * 0.92, 0.0), (r * 0.97, h * 0.05), (r * 0.97, h), (r * 0.97 - t, h), (r * 0.97 - t, h * 0.06)],
                glass,
            );
            let fill = h * b.vary(0.5, 0.7);
            b.cylinder("wax", [0.0, 0.0, h * 0.061], r * 0.97 - t * 1.3, fill, wax);
            wick(b, [0.0, 0.0, h * 0.061 + fill], string);
            b.lathe(
                "label",
                [0.0, 0.0, h * 0.2],
                &[(r * 1.0, 0.0), (r * 1.0, h * 0.3), (r * 0.96, h * 0.3), (r * 0.96, 0.0), (r * 1.0, 0.0)],
                CREAM_PAPER,
            );
        }
        2 => {
            let tin = b.choose(&[BRASS, BLACK_METAL, STONEWARE, PORCELAIN, b.style.metal]);
            let foot = b.vary(0.7, 1.0);
            b.lathe(
                "bowl",
                [0.0; 3],
                &[(r * foot, 0.0), (r, h * 0.75), (r * 0.92, h * 0.75), (r * foot * 0.9, h * 0.05)],
                tin,
            );
            b.lathe("wax", [0.0, 0.0, h * 0.05], &[(r * foot * 0.88, 0.0), (r * 0.9, h * 0.55)], wax);
            for i in 0..3 {
                let (s, c) = (i as f32 * 2.094).sine_cosine();
                wick(b, [r * 0.4 * c, r * 0.4 * s, h * 0.6], string);
            }
        }
        _ => {
            let rings = b.rng.count(3, 6);
            let mut profile = vec![(r * 0.9, 0.0)];
            for i in 0..rings {
                let z = top * (i as f32 + 0.5) / rings as f32;
                profile.extend([(r, z), (r * 0.82, top * (i as f32 + 1.0) / rings as f32)]);
            }
            b.lathe("wax", [0.0; 3], &profile, wax);
            wick(b, [0.0, 0.0, top], string);
        }
    }
}

/// Wax drips.
fn drips(b: &mut Build<'_>, r: f32, top: f32, wax: MaterialId) {
    let count = b.rng.count(0, 4);
    let mut shell = MeshBuilder::default();
    for _ in 0..count {
        let (s, c) = b.vary(0.0, TAU).sine_cosine();
        let long = top * b.vary(0.1, 0.3);
        shell.egg([r * 0.95 * c, r * 0.95 * s, top - long * 0.9], [r * 0.05, r * 0.05, long * 0.9]);
    }
    shell.put(b, "drip", wax);
}

/// A tealight in its tin.
pub(super) fn tealight(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    let wax = b.choose(&WAXES);
    let tin = h * 0.85;
    b.lathe(
        "tin",
        [0.0; 3],
        &[(r * 0.94, 0.0), (r * 0.96, tin), (r, tin * 1.02), (r * 0.92, tin * 1.02), (r * 0.9, h * 0.04)],
        ALUMINIUM,
    );
    b.cylinder("wax", [0.0, 0.0, h * 0.03], r * 0.91, tin * 0.85, wax);
    wick(b, [0.0, 0.0, tin * 0.86], h - tin * 0.86);
}

/// A candle holder with candles: a turned stick, a plate with a grip, or a branched one.
pub(super) fn candlestick(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let metal = b.choose(&[b.style.metal, BRASS, IRON, SILVER_METAL, b.style.wood, PORCELAIN]);
    if y > 1.5 * x || y > 0.09 && h > 0.15 && b.rng.chance(0.6) {
        return branched(b, metal);
    }
    let r = x.min(y);
    let holder = h * if h > 0.14 { b.vary(0.5, 0.65) } else { 0.4 };
    let cup = (r * 0.35).clamp(0.004, 0.014);
    let stem = [
        (r, 0.0),
        (r, holder * 0.05),
        (r * 0.3, holder * 0.06),
        (cup * 0.8, holder * 0.1),
        (cup * 0.6, holder * 0.3),
        (cup * 1.1, holder * 0.45),
        (cup * 0.6, holder * 0.6),
        (cup * 0.7, holder * 0.8),
        (cup * 1.05, holder * 0.9),
        (cup * 1.05, holder),
        (cup, holder),
        (cup, holder * 0.9),
    ];
    b.lathe("holder", [0.0; 3], &stem, metal);
    taper(b, [0.0, 0.0, holder * 0.9], cup * 0.9, h - holder * 0.9);
    b.top("plate", [-r * 0.64, 0.0, holder * 0.055], (r * 0.25, r * 0.3));
}

/// A slim candle with its wick, from a point upwards.
fn taper(b: &mut Build<'_>, at: P, r: f32, high: f32) {
    let wax = b.choose(&WAXES);
    b.lathe("candle", at, &[(r, 0.0), (r * 0.8, high * 0.9), (r * 0.3, high * 0.93)], wax);
    b.rod("wick", [at[0], at[1], at[2] + high * 0.92], [at[0], at[1], at[2] + high], r * 0.15, BLACK_FABRIC);
}

/// Three or five arms in a row.
fn branched(b: &mut Build<'_>, metal: MaterialId) {
    let (x, y, h) = half_dims(b);
    let (arms, level) = (b.choose(&[3, 5]), h * 0.55);
    let r = (y * 0.12).min(x).min(0.014);
    let foot = x.min(y * 0.6);
    b.lathe(
        "foot",
        [0.0; 3],
        &[(foot, 0.0), (foot, h * 0.03), (foot * 0.3, h * 0.04), (r * 0.5, h * 0.07), (r * 0.5, level)],
        metal,
    );
    let mut shell = MeshBuilder::default();
    for i in 0..arms {
        let side = i as f32 / (arms - 1) as f32 * 2.0 - 1.0;
        let end = [0.0, side * (y - r * 1.2), level];
        if side.abs() > 0.1 {
            let low = [0.0, side * (y - r) * 0.6, level - h * 0.14 * side.abs() - h * 0.05];
            let root = [0.0, 0.0, level - h * 0.18];
            shell.tube(&spline(&[root, low, [0.0, end[1], level - h * 0.05], end], 4), r * 0.35);
        }
        b.lathe(
            "cup",
            [0.0, end[1], level - h * 0.01],
            &[(r * 0.4, 0.0), (r * 1.2, h * 0.02), (r * 1.2, h * 0.05), (r * 0.8, h * 0.05), (r * 0.8, h * 0.03)],
            metal,
        );
        taper(b, [0.0, end[1], level + h * 0.02], r * 0.75, h - level - h * 0.02);
    }
    shell.put(b, "arm", metal);
    let knob = oval(Axis::Z, [0.0, 0.0, level - h * 0.18], (r * 0.5, r * 0.5), 0, 12);
    crate::solid::hoop(b, "knob", &knob, r * 0.3, metal);
    b.top("plate", [-foot * 0.64, 0.0, h * 0.035], (foot * 0.25, foot * 0.3));
}
