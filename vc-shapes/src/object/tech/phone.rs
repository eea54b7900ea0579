//! Phones, tablets, handsets and remote controls.

use vc_graph::portable::Portable;

use super::super::decor::picture::{Canvas, Inks, motif};
use super::grid;
use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, blocks, facing, half_dims, loft, oval, spline, tube};

/// A slab with a screen: tablet, phone, reader or player.
pub(super) fn slab(b: &mut Build<'_>) {
    let lies = b.size.z < b.size.x.min(b.size.y);
    facing(b, |b, t, w, h| {
        let body = b.choose(&[BLACK_PLASTIC, SILVER_METAL, WHITE_PLASTIC, NAVY, DUSTY_ROSE, ANTHRACITE]);
        let (x, y) = (t / 2.0, w / 2.0);
        let step = (t * 0.08).min(0.001);
        let face = x - step * 3.0;
        b.rounded_block("body", [-x * 0.9, -y, 0.0], [face, y, h], t * 0.3, body);
        let (low, edge) = match b.class {
            "cellphone" => (h * 0.02, w * 0.03),
            "mp3_player" => (h * 0.5, w * 0.1),
            "e_reader" => (h * 0.12, w * 0.07),
            _ => (h * 0.045, w * 0.05),
        };
        let middle = (low + h - edge) / 2.0;
        let half = (y - edge, (h - edge - low) / 2.0);
        b.block(
            "glass",
            [face - t * 0.1, -half.0 - edge * 0.3, low],
            [face + step, half.0 + edge * 0.3, h - edge],
            SCREEN,
        );
        let at = [face + step, 0.0, middle];
        if b.class == "e_reader" {
            let page = ([face, -half.0, low + h * 0.01], [face + step * 2.0, half.0, h - edge * 1.2]);
            blocks(b, "page", &[page], LIGHT_GREY);
            let rows = b.rng.count(7, 13);
            let pitch = h * 0.75 / rows as f32;
            let lines = grid((rows, 1), |i, _| {
                let at = low + h * 0.05 + pitch * i;
                ([face, -half.0 * 0.85, at], [x, half.0 * 0.85, at + pitch / 3.0])
            });
            blocks(b, "text", &lines, ANTHRACITE);
        } else {
            motif(b, Canvas { half: (half.0 * 0.98, half.1 * 0.98), step: step * 0.66 }, at, Inks::screen());
        }
        if b.class == "mp3_player" {
            let wheel = oval(Axis::X, [face, 0.0, h * 0.25], ((w * 0.28).min(h * 0.2), (w * 0.28).min(h * 0.2)), 0, 20);
            crate::solid::hoop(b, "wheel", &wheel, step.min(w * 0.05), GREY_PLASTIC);
        } else if !lies {
            let (y0, z0, size) = (y - w * 0.22, h - w * 0.24, w * 0.14);
            b.rounded_block(
                "camera",
                [-x, y0 - size * 0.5, z0],
                [-x * 0.8, y0 + size, z0 + size],
                t * 0.1,
                BLACK_GLASS,
            );
        }
        b.block("button", [-x * 0.3, y - 0.001, h * 0.6], [x * 0.2, y + 0.0008, h * 0.75], STEEL);
    });
}

/// The keys of a dial: four rows of three, protruding from a level plane.
fn dial_keys(x: (f32, f32), y: (f32, f32), z: (f32, f32)) -> Vec<(P, P)> {
    let (px, py) = ((x.1 - x.0) / 4.0, (y.1 - y.0) / 3.0);
    grid((4, 3), |i, j| ([x.0 + px * i, y.0 + py * j, z.0], [x.0 + px * (i + 0.75), y.0 + py * (j + 0.75), z.1]))
}

/// A telephone receiver along Y: a grip with two cups.
fn receiver(b: &mut Build<'_>, at: P, half: f32, thick: f32, mat: MaterialId) {
    let mut shell = MeshBuilder::default();
    let ear = half.min(b.size.x * 0.8);
    let line = [
        [at[0], at[1] - half * 0.8, at[2]],
        [at[0], at[1] - half * 0.4, at[2] + thick * 0.8],
        [at[0], at[1] + half * 0.4, at[2] + thick * 0.8],
        [at[0], at[1] + half * 0.8, at[2]],
    ];
    shell.tube(&spline(&line, 4), thick * 0.55);
    for s in [-0.78, 0.78] {
        let ring = |z: f32, r: f32| oval(Axis::Z, [at[0], at[1] + s * half, at[2] + z], (ear * r, ear * r), 0, 14);
        shell.loft(&[ring(-thick, 0.2), ring(-thick * 0.4, 0.22), ring(thick * 0.5, 0.16)]);
    }
    shell.put(b, "receiver", mat);
}

/// A telephone: with a receiver and keys or a dial, or a handset in its cradle.
pub(super) fn desk_phone(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[BLACK_PLASTIC, WHITE_PLASTIC, RED_PLASTIC, GREY_PLASTIC, GREEN_PLASTIC]);
    if y < 0.05 || h > 1.8 * y {
        return cradle(b, body);
    }
    let (thick, low) = ((h * 0.16).min(x * 0.5), h * 0.2);
    let slope = [(-x, 0.0), (x, 0.0), (x, low), (-x * 0.2, h * 0.6), (-x, h * 0.62)];
    b.prism("body", Axis::Y, [0.0, -y, 0.0], &slope, 2.0 * y, body);
    receiver(b, [-x * 0.62, 0.0, (h - thick * 1.6).min(h * 0.61 + thick * 0.9)], y * 0.98, thick, body);
    let angle = ((h * 0.6 - low) / (x * 1.2)).arc_tangent();
    let pose = nalgebra::Isometry3::new(
        nalgebra::Vector3::new(x * 0.4, 0.0, f32::midpoint(low, h * 0.6)),
        nalgebra::Vector3::y() * angle,
    );
    let reach = x * 0.5;
    if b.rng.chance(0.4) {
        let r = reach.min(y * 0.7);
        b.posed(pose, |b| {
            b.cylinder(
                "dial",
                [0.0, 0.0, -h * 0.02],
                r,
                h * 0.05,
                if body == BLACK_PLASTIC { SILVER_METAL } else { WHITE_PLASTIC },
            );
            let mut holes = MeshBuilder::default();
            for i in 0..10 {
                let (s, c) = (i as f32 * 0.52 + 0.6).sine_cosine();
                holes.egg([r * 0.7 * c, r * 0.7 * s, h * 0.03], [r * 0.13, r * 0.13, h * 0.01]);
            }
            holes.put(b, "hole", BLACK_PLASTIC);
        });
    } else {
        let keys = if body == WHITE_PLASTIC { GREY_PLASTIC } else { WHITE_PLASTIC };
        b.posed(pose, |b| {
            blocks(
                b,
                "keys",
                &dial_keys((-reach * 0.6, reach * 0.95), (-y * 0.55, y * 0.3), (-h * 0.03, h * 0.03)),
                keys,
            );
            blocks(b, "display", &[([-reach * 0.6, y * 0.45, -h * 0.03], [reach * 0.5, y * 0.9, h * 0.015])], SAGE);
        });
    }
}

/// A cordless handset standing in its cradle.
fn cradle(b: &mut Build<'_>, body: MaterialId) {
    let (x, y, h) = half_dims(b);
    let foot = h * 0.22;
    b.rounded_block("cradle", [-x, -y, 0.0], [x, y, foot], foot * 0.3, body);
    let (t, w) = (x * 0.32, y * 0.6);
    b.at([-x * 0.1, 0.0, foot * 0.5], 0.0, |b| upright(b, (t, w, h - foot * 0.5), body));
}

/// A handset with a display and keys, the centre of its base at the origin.
fn upright(b: &mut Build<'_>, (t, w, h): (f32, f32, f32), body: MaterialId) {
    b.rounded_block("handset", [-t, -w, 0.0], [t * 0.9, w, h], t * 0.5, body);
    let face = t * 0.9;
    b.block("display", [face - t * 0.2, -w * 0.7, h * 0.6], [face + t * 0.08, w * 0.7, h * 0.85], SAGE);
    let keys = grid((4, 3), |i, j| {
        let (y0, z0) = (-w * 0.72 + w * 0.5 * j, h * 0.08 + h * 0.115 * i);
        ([face - t * 0.2, y0, z0], [t, y0 + w * 0.4, z0 + h * 0.08])
    });
    blocks(b, "keys", &keys, if body == BLACK_PLASTIC { GREY_PLASTIC } else { BLACK_PLASTIC });
    blocks(b, "earpiece", &[([face - t * 0.2, -w * 0.35, h * 0.92], [face + t * 0.05, w * 0.35, h * 0.94])], SCREEN);
}

/// A two-way radio or a baby monitor: a handset with an antenna.
pub(super) fn handset(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[BLACK_PLASTIC, YELLOW_PLASTIC, WHITE_PLASTIC, BLUE_PLASTIC]);
    let tall = h * b.vary(0.62, 0.72);
    let r = (y * 0.14).min(x * 0.4);
    if b.class == "baby_monitor" {
        b.rounded_block("foot", [-x, -y, 0.0], [x, y, h * 0.1], h * 0.03, body);
    }
    let (t, w) = if b.class == "baby_monitor" { (x * 0.6, y * 0.9) } else { (x, y) };
    upright(b, (t, w, tall), body);
    let at = [-t * 0.2, y * 0.6, tall * 0.97];
    b.lathe(
        "aerial",
        at,
        &[(r, 0.0), (r * 0.7, (h - tall) * 0.6), (r * 0.6, h - at[2] - r * 0.3), (r * 0.3, h - at[2])],
        BLACK_PLASTIC,
    );
    b.cylinder("knob", [-t * 0.1, -y * 0.5, tall * 0.98], r * 0.9, h * 0.04, GREY_PLASTIC);
}

/// A wall telephone: receiver on its hook, keys, a curly cord.
pub(super) fn wall_phone(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[WHITE_PLASTIC, BLACK_PLASTIC, RED_PLASTIC, YELLOW_PLASTIC]);
    let front = x * 0.2;
    b.rounded_block("body", [-x, -y, h * 0.12], [front, y, h], x * 0.3, body);
    let wide = y * 0.3;
    let line = [
        [front, -y + wide, h * 0.2],
        [x * 0.62, -y + wide, h * 0.35],
        [x * 0.62, -y + wide, h * 0.8],
        [front, -y + wide, h * 0.93],
    ];
    let mut shell = MeshBuilder::default();
    shell.tube(&spline(&line, 4), (x * 0.24).min(wide * 0.9));
    shell.put(b, "receiver", body);
    let keys = grid((4, 3), |i, j| {
        let (y0, z0) = (-y * 0.2 + y * 0.36 * j, h * 0.32 + h * 0.13 * i);
        ([front - x * 0.1, y0, z0], [front + x * 0.12, y0 + y * 0.27, z0 + h * 0.09])
    });
    blocks(b, "keys", &keys, if body == WHITE_PLASTIC { GREY_PLASTIC } else { WHITE_PLASTIC });
    let r = (x * 0.1).min(y * 0.06);
    let cord: Vec<P> = (0..=60)
        .map(|i| {
            let t = i as f32 / 60.0;
            let (s, c) = (t * 75.0).sine_cosine();
            [
                -x * 0.2 + 2.0 * r * c,
                -y * 0.6 + y * 1.1 * t + r * s,
                h * (0.14 - 0.45 * t * (1.0 - t)) + 2.0 * r * s.abs(),
            ]
        })
        .map(|p| [p[0], p[1], p[2].max(r * 0.6)])
        .collect();
    tube(b, "cord", &cord, r * 0.6, body);
}

/// A lying remote control: rows of keys, some of them coloured.
pub(super) fn remote(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[BLACK_PLASTIC, BLACK_PLASTIC, GREY_PLASTIC, WHITE_PLASTIC, SILVER_METAL]);
    let key = h * 0.14;
    let top = h - key;
    let waist = b.vary(0.75, 1.0);
    let ring = |t: f32, w: f32| oval(Axis::X, [x * t, 0.0, top / 2.0], (y * w, top / 2.0), 2, 16);
    loft(
        b,
        "body",
        &[ring(-1.0, 0.8), ring(-0.96, 0.97), ring(-0.3, 1.0), ring(0.3, waist), ring(0.95, 0.97), ring(1.0, 0.8)],
        body,
    );
    let dark = if body == BLACK_PLASTIC { GREY_PLASTIC } else { BLACK_PLASTIC };
    let columns = 3;
    let rows = b.rng.count(4, 6);
    let (px, py) = (x * 0.75 / rows as f32, y * 0.5);
    let keys = grid((rows, columns), |i, j| {
        let (a, c) = (-x * 0.62 + px * i, -y * 0.7 + py * j);
        ([a, c, top * 0.7], [a + px * 0.6, c + py * 0.72, h - key * 0.2])
    });
    blocks(b, "keys", &keys, dark);
    let pad = (x * 0.17).min(y * 0.62);
    b.lathe(
        "pad",
        [x * 0.36, 0.0, top * 0.7],
        &[(pad, 0.0), (pad, h * 0.3 + key * 0.5), (pad * 0.5, h * 0.3 + key * 0.5), (pad * 0.48, h * 0.3)],
        dark,
    );
    let power = ([-x * 0.88, -y * 0.7, top * 0.7], [-x * 0.78, -y * 0.35, h]);
    blocks(b, "power", &[power], RED_PLASTIC);
    let colours = [RED_PLASTIC, GREEN_PLASTIC, YELLOW_PLASTIC, BLUE_PLASTIC];
    for (i, mat) in colours.into_iter().enumerate() {
        let c = y * (-0.72 + 0.38 * i as f32);
        blocks(b, "keys", &[([x * 0.66, c, top * 0.7], [x * 0.72, c + y * 0.28, h - key * 0.3])], mat);
    }
    b.rod("eye", [-x + top * 0.19, -y * 0.3, top * 0.5], [-x + top * 0.19, y * 0.3, top * 0.5], top * 0.2, BLACK_GLASS);
}
