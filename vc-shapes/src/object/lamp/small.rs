//! Bulbs, torches, night lights, light strings.

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Build, P, collar, half_dims};

/// A soft glowing shape: a moon, a mushroom, a cube, a cat's head.
pub(super) fn night_light(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    let base = b.choose(&[WHITE_PLASTIC, BEECH, PINK_PLASTIC, BLUE_PLASTIC]);
    let foot = h * 0.14;
    match b.rng.below(4) {
        0 => {
            let ball = r.min((h - foot) / 2.0);
            b.lathe("foot", [0.0; 3], &[(ball * 0.8, 0.0), (ball * 0.6, foot * 1.2)], base);
            b.ball("globe", [0.0, 0.0, h - ball], ball, WARM_BULB);
            b.cylinder("neck", [0.0, 0.0, foot], ball * 0.5, (h - 2.0 * ball - foot).max(0.0) + ball * 0.2, base);
        }
        1 => {
            b.lathe("stem", [0.0; 3], &[(r * 0.6, 0.0), (r * 0.4, h * 0.2), (r * 0.45, h * 0.5)], base);
            b.lathe(
                "cap",
                [0.0, 0.0, h * 0.45],
                &[(r, 0.0), (r * 0.9, h * 0.25), (r * 0.5, h * 0.48), (r * 0.1, h * 0.55)],
                WARM_BULB,
            );
        }
        2 => {
            b.rounded_block("light", [-x, -y, foot * 0.8], [x, y, h], r * 0.3, WARM_BULB);
            b.block("foot", [-x * 0.8, -y * 0.8, 0.0], [x * 0.8, y * 0.8, foot], base);
        }
        _ => {
            let body = h * 0.8;
            b.rounded_block("body", [-x, -y, 0.0], [x, y, body], r * 0.6, WARM_BULB);
            for side in [-1.0, 1.0] {
                b.taper(
                    "ear",
                    [0.0, side * y * 0.55, body * 0.85],
                    (x * 0.3, y * 0.3),
                    (x * 0.08, y * 0.06),
                    h - body * 0.85,
                    base,
                );
                b.ball("eye", [x * 0.93, side * y * 0.35, body * 0.55], r * 0.08, BLACK_PLASTIC);
            }
        }
    }
}

/// A string of small lights, coiled around a spool or in loose loops.
pub(super) fn string_lights(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let cable = b.choose(&[GREEN_PLASTIC, WHITE_PLASTIC, BLACK_PLASTIC]);
    let lights: &[MaterialId] =
        b.choose(&[&[WARM_BULB], &[SIGNAL_RED, SIGNAL_AMBER, SIGNAL_GREEN, WARM_BULB], &[COOL_BULB]]);
    let r = (h * 0.07).min(x * 0.12);
    let bead = (r * 2.0).min(h * 0.2);
    let count = 18;
    let mut before: Option<P> = None;
    for i in 0..count {
        let (s, c) = (std::f32::consts::TAU * i as f32 * 0.219).sine_cosine();
        let k = 0.55 + 0.35 * ((i * 7) % 5) as f32 / 5.0;
        let rise = ((i * 5) % 7) as f32 / 7.0;
        let at = [c * (x - bead) * k, s * (y - bead) * k, bead + (h - 2.0 * bead) * rise * (1.0 - k * 0.3)];
        if let Some(from) = before {
            b.rod("cable", from, at, r * 0.45, cable);
        }
        bead_light(b, at, bead * 0.8, lights[i % lights.len()]);
        before = Some(at);
    }
    let plug = [-x, -y * 0.2, 0.0];
    b.rounded_block("box", plug, [-x * 0.3, y * 0.2, (h * 0.3).min(x)], r * 0.5, cable);
    b.rod("cable", [-x * 0.5, 0.0, r], [x * 0.4, y * 0.3, r], r * 0.45, cable);
    let ends = [[0.0, y - bead, bead], [0.0, -y + bead, bead], [x - bead, 0.0, h - bead]];
    for end in ends {
        bead_light(b, end, bead, lights[0]);
    }
    b.rod("cable", ends[0], ends[1], r * 0.45, cable);
    b.rod("cable", ends[2], [0.0, 0.0, bead], r * 0.45, cable);
}

/// A bead-sized light with the facets of a gem.
fn bead_light(b: &mut Build<'_>, at: P, r: f32, mat: MaterialId) {
    let ring = |z: f32, out: f32, shift: f32| {
        (0..6).map(move |i| {
            let (s, c) = (std::f32::consts::TAU * (i as f32 + shift) / 6.0).sine_cosine();
            [at[0] + out * c, at[1] + out * s, at[2] + z]
        })
    };
    let tips = [[at[0], at[1], at[2] - r], [at[0], at[1], at[2] + r]];
    let points: Vec<P> = ring(-r * 0.4, r * 0.9, 0.0).chain(ring(r * 0.4, r * 0.9, 0.5)).chain(tips).collect();
    b.hull("bulb", &points, mat);
}

/// A bulb standing on its contact: pear, globe, candle or spiral shape on a screw thread.
pub(super) fn light_bulb(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    let (cap, thread) = (h * 0.3, r * 0.45);
    let profile = [
        (thread * 0.4, 0.0),
        (thread, h * 0.05),
        (thread * 0.9, h * 0.1),
        (thread, h * 0.14),
        (thread * 0.9, h * 0.19),
        (thread, h * 0.24),
        (thread * 0.95, cap),
    ];
    b.lathe("thread", [0.0; 3], &profile, ALUMINIUM);
    let glass = b.choose(&[WARM_BULB, COOL_BULB, WARM_BULB]);
    let tall = h - cap + 0.001;
    match b.rng.below(4) {
        0 => b.lathe(
            "bulb",
            [0.0, 0.0, cap - 0.001],
            &[
                (thread * 0.9, 0.0),
                (r * 0.75, tall * 0.3),
                (r, tall * 0.6),
                (r * 0.85, tall * 0.83),
                (r * 0.45, tall * 0.96),
                (0.0, tall),
            ],
            glass,
        ),
        1 => {
            b.lathe("collar", [0.0, 0.0, cap - 0.001], &[(thread, 0.0), (r * 0.8, tall * 0.35)], WHITE_PLASTIC);
            b.lathe(
                "bulb",
                [0.0, 0.0, cap + tall * 0.34],
                &[
                    (r * 0.8, 0.0),
                    (r, tall * 0.22),
                    (r * 0.85, tall * 0.46),
                    (r * 0.5, tall * 0.6),
                    (0.0, tall * 0.66 - 0.001),
                ],
                glass,
            );
        }
        2 => b.lathe(
            "bulb",
            [0.0, 0.0, cap - 0.001],
            &[(thread * 0.9, 0.0), (r, tall * 0.35), (r * 0.8, tall * 0.6), (r * 0.25, tall * 0.9), (0.0, tall)],
            glass,
        ),
        _ => {
            b.cylinder("base", [0.0, 0.0, cap - 0.001], r * 0.8, tall * 0.25, WHITE_PLASTIC);
            for (sx, sy) in [(0.5, 0.5), (-0.5, 0.5), (-0.5, -0.5), (0.5, -0.5)] {
                let (cx, cy, t) = (sx * r * 0.95, sy * r * 0.95, r * 0.27);
                b.bar("tube", [cx, cy, cap + tall * 0.2], [cx, cy, h - t], t, glass);
            }
            b.bar("tube", [r * 0.47, r * 0.47, h - r * 0.27], [-r * 0.47, r * 0.47, h - r * 0.27], r * 0.27, glass);
        }
    }
}

/// A torch standing on its end: a grip, a switch, a wide head with a lens.
pub(super) fn flashlight(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    let mat = b.choose(&[BLACK_METAL, ALUMINIUM, RED_METAL, YELLOW_PLASTIC, BLUE_METAL]);
    let slim = r * b.vary(0.6, 0.8);
    let head = h * b.vary(0.2, 0.3);
    let body = [
        (slim * 0.9, 0.0),
        (slim, h * 0.03),
        (slim, h - head * 1.4),
        (r, h - head),
        (r, h),
        (r * 0.85, h),
        (r * 0.8, h - head * 0.3),
    ];
    b.lathe("body", [0.0; 3], &body, mat);
    b.cylinder("lens", [0.0, 0.0, h - head * 0.4], r * 0.83, head * 0.25, WARM_BULB);
    for i in 0..3 {
        let z = h * (0.12 + 0.12 * i as f32);
        collar(b, "grip", ([0.0, 0.0, z], [0.0, 0.0, z + h * 0.05]), (slim * 0.9, (slim * 1.06).min(r)), RUBBER);
    }
    b.rounded_block(
        "switch",
        [slim * 0.9, -r * 0.25, h * 0.55],
        [(slim * 1.1).min(x), r * 0.25, h * 0.64],
        r * 0.08,
        RED_PLASTIC,
    );
}
