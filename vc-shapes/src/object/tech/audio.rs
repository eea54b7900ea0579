//! Loudspeakers, headphones and microphones.

use std::f32::consts::PI;

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, arc, blocks, half_dims, hoop, loft, ngon, oval, spline, tube};

/// A driver in a front at `x`: a rim, a cone and a dust cap.
fn driver(b: &mut Build<'_>, at: P, r: f32, cone: MaterialId) {
    let to = [at[0] + 1.0, at[1], at[2]];
    let d = (r * 0.12).min(0.006);
    b.lathe_along(
        "rim",
        at,
        to,
        &[(r, -d), (r, d * 0.6), (r * 0.92, d), (r * 0.84, d * 0.5), (r * 0.8, -d), (r, -d)],
        SILVER_METAL,
    );
    b.lathe_along(
        "cone",
        at,
        to,
        &[(r * 0.86, -d), (r * 0.86, d * 0.2), (r * 0.72, d * 0.7), (r * 0.62, d * 0.1), (r * 0.3, -d * 0.6)],
        cone,
    );
    b.lathe_along("cap", at, to, &[(r * 0.3, -d), (r * 0.22, d * 0.1), (0.0, d * 0.4)], BLACK_PLASTIC);
}

/// A loudspeaker for shelf or floor, or a subwoofer.
pub(super) fn speaker(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[BLACK, WALNUT, b.style.wood, WHITE, OAK, BLACK_PLASTIC]);
    let cone = b.choose(&[RUBBER, YELLOW, GREY, RUBBER]);
    let out = (y * 0.1).min(0.007);
    let (front, foot) = (x - out, if b.class == "speaker" { 0.0 } else { (h * 0.03).min(0.03) });
    let round = b.vary(0.002, 0.012);
    let wide = if foot > 0.0 { y * 0.94 } else { y };
    b.rounded_block("case", [-x, -wide, foot], [front - out * 0.4, wide, h], round, body);
    b.block(
        "front",
        [front - out * 0.6, -wide * 0.97, foot + h * 0.01],
        [front, wide * 0.97, h * 0.99],
        if body == WHITE { WHITE } else { BLACK },
    );
    let z = |t: f32| foot + (h - foot) * t;
    match b.class {
        "subwoofer" => driver(b, [front, 0.0, z(0.52)], (wide * 0.82).min((h - foot) * 0.42), cone),
        "floor_speaker" => {
            let count = b.rng.count(2, 3);
            let r = (wide * 0.72).min((h - foot) * 0.28 / count as f32);
            for i in 0..count {
                driver(b, [front, 0.0, z(0.95) - r * (2.5 + 2.15 * i as f32)], r, cone);
            }
            driver(b, [front, 0.0, z(0.95) - r * 0.7], r * 0.4, RUBBER);
            b.rod("port", [front - 0.002, 0.0, z(0.1)], [front + 0.0012, 0.0, z(0.1)], wide * 0.3, SCREEN);
        }
        _ => {
            let r = (wide * 0.74).min((h - foot) * 0.3);
            driver(b, [front, 0.0, z(0.06) + r], r, cone);
            driver(b, [front, 0.0, z(0.94) - r * 0.55], r * 0.5, RUBBER);
        }
    }
    if foot > 0.0 {
        let mut spikes = MeshBuilder::default();
        for (sx, sy) in [(-0.85, -0.9), (-0.85, 0.9), (0.85, -0.9), (0.85, 0.9)] {
            spikes.tapered(&[[x * sx, (y - foot) * sy, foot * 1.3], [x * sx, (y - foot) * sy, 0.0]], |t| {
                foot * (0.45 - 0.25 * t)
            });
        }
        spikes.put(b, "spike", b.style.metal);
        b.block("plinth", [-x * 0.985, -y, foot * 0.7], [x * 0.955, y, foot * 1.2], BLACK);
    } else {
        let mark = ([front - 0.001, -y * 0.15, h * 0.02], [front + h * 0.002, y * 0.15, h * 0.035]);
        blocks(b, "mark", &[mark], SILVER_METAL);
    }
}

/// A sound bar behind cloth, with keys on top.
pub(super) fn soundbar(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[BLACK_PLASTIC, WHITE_PLASTIC, GREY_PLASTIC]);
    let cloth = b.choose(&[CHARCOAL_FABRIC, BLACK_FABRIC, GREY_FABRIC]);
    b.rounded_block("body", [-x, -y, 0.0], [x * 0.9, y, h * 0.97], h * 0.25, body);
    b.rounded_block("cloth", [x * 0.3, -y * 0.985, h * 0.06], [x, y * 0.985, h * 0.9], h * 0.2, cloth);
    let keys: Vec<(P, P)> = (0..4)
        .map(|i| y * (-0.06 + 0.035 * i as f32))
        .map(|a| ([-x * 0.3, a, h * 0.9], [0.0, a + y * 0.022, h]))
        .collect();
    blocks(b, "key", &keys, GREY_PLASTIC);
    b.block("light", [x * 0.9, y * 0.02, h * 0.4], [x + 0.0006, y * 0.05, h * 0.46], LED);
}

/// A portable or smart speaker: a lying or standing drum, a puck, a block.
pub(super) fn portable(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let cloth = b.choose(&[CHARCOAL_FABRIC, RED_FABRIC, BLUE_FABRIC, GREY_FABRIC, TEAL_FABRIC, MUSTARD_FABRIC]);
    let r = x.min(y);
    if y > 1.4 * x {
        let ring = |t: f32, s: f32| oval(Axis::Y, [0.0, y * t, h / 2.0], (x * s, h / 2.0 * s), 1, 20);
        loft(b, "body", &[ring(-0.97, 0.9), ring(-0.85, 1.0), ring(0.85, 1.0), ring(0.97, 0.9)], cloth);
        loft(b, "end", &[ring(-1.0, 0.7), ring(-0.96, 0.8)], RUBBER);
        loft(b, "end", &[ring(0.96, 0.8), ring(1.0, 0.7)], RUBBER);
        let keys: Vec<(P, P)> = (0..3)
            .map(|i| y * (-0.2 + 0.15 * i as f32))
            .map(|a| ([-x * 0.15, a, h * 0.93], [x * 0.15, a + y * 0.08, h + 0.0008]))
            .collect();
        return blocks(b, "key", &keys, RUBBER);
    }
    let low = h < 1.1 * r;
    let bulge = if low { 0.9 } else { b.vary(0.85, 1.0) };
    let glow = b.choose(&[PICTURE_SKY, LED, COOL_BULB]);
    b.lathe("base", [0.0; 3], &[(r * bulge * 0.9, 0.0), (r * bulge, h * 0.05), (r * bulge, h * 0.08)], RUBBER);
    b.lathe(
        "body",
        [0.0, 0.0, h * 0.06],
        &[(r * bulge, 0.0), (r, h * 0.4), (r * 0.97, h * 0.75), (r * 0.85, h * 0.88)],
        cloth,
    );
    b.lathe("light", [0.0, 0.0, h * 0.93], &[(r * 0.84, 0.0), (r * 0.82, h * 0.03)], glow);
    b.lathe("top", [0.0, 0.0, h * 0.94], &[(r * 0.74, 0.0), (r * 0.72, h * 0.05), (r * 0.6, h * 0.06)], BLACK_PLASTIC);
    let dots = [(0.4, 0.0), (-0.4, 0.0), (0.0, 0.4), (0.0, -0.4)]
        .map(|(a, c)| ([r * (a - 0.06), r * (c - 0.06), h * 0.99], [r * (a + 0.06), r * (c + 0.06), h + 0.0008]));
    blocks(b, "key", &dots, WHITE_PLASTIC);
}

/// A guitar amplifier: cloth front, knobs, corners and a handle.
pub(super) fn guitar_amplifier(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let skin = b.choose(&[BLACK_LEATHER, BROWN_LEATHER, RED_FABRIC, WHITE_LEATHER]);
    let cloth = b.choose(&[BEIGE_FABRIC, GREY_FABRIC, BLACK_FABRIC, BROWN_FABRIC]);
    let (grip, knob) = (h * 0.08, (x * 0.08).min(0.014));
    let (top, front) = (h - grip, x - knob);
    b.rounded_block("case", [-x, -y, 0.0], [front, y, top], x * 0.06, skin);
    b.block("cloth", [front - 0.002, -y * 0.9, top * 0.06], [front + 0.0012, y * 0.9, top * 0.72], cloth);
    let edge = [
        [front + 0.001, -y * 0.9, top * 0.06],
        [front + 0.001, y * 0.9, top * 0.06],
        [front + 0.001, y * 0.9, top * 0.72],
        [front + 0.001, -y * 0.9, top * 0.72],
    ];
    hoop(b, "piping", &edge, knob * 0.3, GOLD);
    b.block("panel", [front - 0.002, -y * 0.9, top * 0.78], [front + 0.001, y * 0.9, top * 0.94], b.style.metal);
    let r = (y * 0.05).min(top * 0.05);
    for i in 0..6 {
        let py = -y * 0.75 + y * 0.25 * i as f32;
        b.rod("knob", [front, py, top * 0.86], [x, py, top * 0.86], r, BLACK_PLASTIC);
    }
    b.rod("light", [front, y * 0.78, top * 0.86], [front + knob * 0.5, y * 0.78, top * 0.86], r * 0.6, SIGNAL_RED);
    let thick = (grip * 0.22).min(x * 0.1);
    let handle = [
        [-x * 0.1, -y * 0.35, top - thick],
        [-x * 0.1, -y * 0.26, h - thick * 1.9],
        [-x * 0.1, y * 0.26, h - thick * 1.9],
        [-x * 0.1, y * 0.35, top - thick],
    ];
    tube(b, "handle", &spline(&handle, 4), thick, RUBBER);
    let mut corners = MeshBuilder::default();
    for (sx, sy) in [(-1.0_f32, -1.0_f32), (-1.0, 1.0)] {
        for z in [top * 0.03, top * 0.97] {
            corners.egg(
                [sx * (x - x * 0.06), sy * (y - y * 0.045), z.max(top * 0.045).min(top * 0.955)],
                [x * 0.06, y * 0.045, top * 0.045],
            );
        }
    }
    corners.put(b, "corner", BLACK_METAL);
}

/// Headphones: band, two cups with pads, and sometimes a microphone.
pub(super) fn headset(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let shell = b.choose(&[BLACK_PLASTIC, WHITE_PLASTIC, SILVER_METAL, RED_PLASTIC, NAVY]);
    let pad = b.choose(&[BLACK_LEATHER, BROWN_LEATHER, GREY_FABRIC]);
    let cup = (x * 0.95).min(h * 0.25);
    let band = (x * 0.2).min(y * 0.08);
    let reach = y - band * 1.2;
    let line = arc(Axis::X, [0.0, 0.0, cup], (reach, h - cup - band), (0.0, PI), 16);
    let mut hoop_ = MeshBuilder::default();
    hoop_.leaf(&line, |_| band * 1.6, 0.0);
    hoop_.tube(&line, band * 0.5);
    hoop_.put(b, "band", shell);
    let upper: Vec<P> = line[5..12].iter().map(|p| [p[0], p[1] * 0.92, cup + (p[2] - cup) * 0.945]).collect();
    tube(b, "cushion", &upper, band * 0.85, pad);
    for side in [-1.0_f32, 1.0] {
        let at = |o: f32| [0.0, side * (reach - o), cup];
        let deep = y * 0.16;
        let (from, to) = (at(-band * 0.9), at(deep));
        b.lathe_along("cup", from, to, &[(cup * 0.75, 0.0), (cup * 0.97, deep * 0.3), (cup * 0.97, deep * 0.8)], shell);
        b.lathe_along(
            "pad",
            at(deep * 0.5),
            at(deep * 2.0),
            &[
                (cup * 0.9, 0.0),
                (cup, deep * 0.35),
                (cup * 0.9, deep * 0.9),
                (cup * 0.5, deep * 0.9),
                (cup * 0.45, deep * 0.5),
            ],
            pad,
        );
    }
    if b.rng.chance(0.4) {
        let r = band * 0.3;
        let arm =
            [[x * 0.2, reach, cup * 0.9], [x * 0.75, reach * 0.85, cup * 0.5], [x - r * 3.0, reach * 0.45, r * 3.0]];
        tube(b, "arm", &spline(&arm, 4), r, BLACK_PLASTIC);
        let mut tip = MeshBuilder::default();
        tip.egg([x - r * 3.0, reach * 0.42, r * 3.0], [r * 2.5, r * 3.0, r * 2.8]);
        tip.put(b, "microphone", RUBBER);
    }
}

/// Ear buds: two in a case, or on a cable.
pub(super) fn earphone(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[WHITE_PLASTIC, BLACK_PLASTIC, RED_PLASTIC, NAVY]);
    let mut buds = MeshBuilder::default();
    let r = (h * 0.32).min(y * 0.2).min(x * 0.4);
    for side in [-1.0, 1.0] {
        let at = [x - r, side * (y - r * 1.3), r];
        buds.egg(at, [r, r * 0.9, r]);
        buds.tapered(
            &[[at[0], at[1], r], [at[0] - r * 0.4, at[1], r * 0.8], [(at[0] - r * 3.0).max(-x), at[1], r * 0.5]],
            |_| r * 0.4,
        );
    }
    buds.put(b, "bud", body);
    if b.rng.chance(0.5) {
        b.rounded_block(
            "case",
            [-x, r * 1.2 - y, 0.0],
            [(x - r * 2.4).max(-x * 0.3), y - r * 1.2, h],
            (h * 0.45).min(r),
            body,
        );
    } else {
        let wire = r * 0.14;
        let line: Vec<P> = (0..=36)
            .map(|i| i as f32 / 36.0)
            .map(|t| {
                let (s, c) = (t * 12.0).sine_cosine();
                [
                    (x * 0.75) * c * (0.7 + 0.2 * t) - x * 0.1,
                    (y * 0.8) * s * (0.7 + 0.2 * t),
                    wire + (h * 0.6 - wire) * t,
                ]
            })
            .collect();
        let line: Vec<P> = line.into_iter().chain([[x - r * 2.0, y - r * 1.3, r * 0.7]]).collect();
        tube(b, "cable", &line, wire, body);
    }
}

/// A microphone on a stand, or a hand-held one standing on its end.
pub(super) fn microphone(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    let body = b.choose(&[BLACK_METAL, SILVER_METAL, GREY_PLASTIC, RED_METAL]);
    if b.rng.chance(0.5) {
        let ball = h * 0.2;
        let size = r.min(ball);
        b.lathe("body", [0.0; 3], &[(r * 0.42, 0.0), (r * 0.5, h * 0.02), (r * 0.7, h - ball * 2.0)], body);
        b.lathe(
            "collar",
            [0.0, 0.0, h - ball * 2.1],
            &[(size * 0.8, 0.0), (size * 0.98, ball * 0.3), (size * 0.98, ball * 0.5)],
            SILVER_METAL,
        );
        b.lathe(
            "grille",
            [0.0, 0.0, h - ball * 1.7],
            &[
                (size * 0.9, 0.0),
                (size, ball * 0.6),
                (size * 0.8, ball * 1.3),
                (size * 0.4, ball * 1.65),
                (0.0, ball * 1.7),
            ],
            GREY_PLASTIC,
        );
        b.block("switch", [r * 0.4, -r * 0.15, h * 0.45], [r * 0.72, r * 0.15, h * 0.55], SILVER_METAL);
        return;
    }
    b.lathe(
        "foot",
        [0.0; 3],
        &[(r, 0.0), (r, h * 0.03), (r * 0.3, h * 0.07), (r * 0.16, h * 0.1), (r * 0.16, h * 0.4)],
        BLACK_METAL,
    );
    let ring = |z: f32, s: f32| oval(Axis::Z, [0.0, 0.0, h * z], (r * 0.8 * s, r * 0.8 * s), 1, 18);
    loft(b, "body", &[ring(0.36, 0.8), ring(0.4, 0.95), ring(0.62, 0.95)], body);
    loft(b, "grille", &[ring(0.61, 1.0), ring(0.9, 1.0), ring(0.97, 0.85), ring(1.0, 0.45)], SILVER_METAL);
    let band = ngon((r * 0.78, r * 0.78), 18);
    b.prism("band", Axis::Z, [0.0, 0.0, h * 0.6], &band, h * 0.025, BLACK_PLASTIC);
    b.rod("knob", [r * 0.5, 0.0, h * 0.5], [r * 0.85, 0.0, h * 0.5], r * 0.16, BLACK_PLASTIC);
}
