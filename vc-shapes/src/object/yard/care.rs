//! Equipment for cleaning pools.

use std::f32::consts::{FRAC_PI_2, PI};

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Axis, Build, at_least};

/// A net on an upright pole, with the net at the bottom.
pub(super) fn pool_skimmer(b: &mut Build<'_>) {
    at_least(b, [0.025, 0.17, 0.5]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, cloth) =
        (b.choose(&[BLUE_PLASTIC, SKY, WHITE_PLASTIC, GREEN_PLASTIC]), b.choose(&[BLUE_FABRIC, WHITE_COTTON]));
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

/// A pool-cleaning robot: a body on tracks or brushes with a handle on top.
pub(super) fn pool_robot(b: &mut Build<'_>) {
    at_least(b, [0.17, 0.17, 0.1]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, second) = (
        b.choose(&[BLUE_PLASTIC, WHITE_PLASTIC, GREY_PLASTIC, ORANGE_PLASTIC]),
        b.choose(&[BLACK_PLASTIC, GREY_PLASTIC, NAVY]),
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

/// A pump on a base with its filter: a cartridge or a ball of sand.
pub(super) fn pool_pump(b: &mut Build<'_>) {
    at_least(b, [0.15, 0.15, 0.2]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, second) = (
        b.choose(&[GREY_PLASTIC, BLACK_PLASTIC, BLUE_PLASTIC, WHITE_PLASTIC]),
        b.choose(&[SKY, GREY_PLASTIC, WHITE_PLASTIC]),
    );
    let foot = 0.03;
    b.rounded_block("foot", [-x, -y, 0.0], [x, y, foot], 0.01, BLACK_PLASTIC);
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
