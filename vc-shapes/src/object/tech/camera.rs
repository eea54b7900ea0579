//! Cameras and studio equipment.

use std::f32::consts::PI;

use vc_graph::portable::Portable;

use super::lens;
use crate::material::*;
use crate::solid::{Axis, Build, CORNERS, MeshBuilder, P, blocks, half_dims, hoop, oval, spline, tube};

/// A still camera: compact, reflex, instant or action camera.
pub(super) fn camera(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let (body, trim) = match b.class {
        "instant_camera" => b.choose(&[
            (WHITE_PLASTIC, BLACK_PLASTIC),
            (PINK_PLASTIC, WHITE_PLASTIC),
            (SKY, WHITE_PLASTIC),
            (YELLOW_PLASTIC, BLACK_PLASTIC),
        ]),
        "camera" => b.choose(&[
            (SILVER_METAL, BLACK_LEATHER),
            (BLACK_PLASTIC, BLACK_LEATHER),
            (RED_METAL, BLACK_PLASTIC),
            (SILVER_METAL, BROWN_LEATHER),
        ]),
        _ => (BLACK_PLASTIC, RUBBER),
    };
    let reflex = b.class == "dslr_camera";
    let hump = if reflex { h * 0.22 } else { h * 0.07 };
    let top = h - hump;
    let barrel = match b.class {
        "dslr_camera" => x * 1.1,
        "instant_camera" => x * 0.6,
        "action_camera" => x * 0.25,
        _ => x * b.vary(0.5, 0.8),
    };
    let front = x - barrel;
    b.rounded_block("body", [-x, -y, 0.0], [front, y, top], x.min(top) * 0.12, body);
    let mid = if b.class == "action_camera" { y * 0.4 } else { y * b.vary(-0.05, 0.15) };
    let r = (top * if b.class == "action_camera" { 0.28 } else { 0.42 }).min((y - mid.abs()) * 0.9);
    b.block("skin", [-x * 0.9, -y * 0.96, top * 0.15], [front + 0.0006, y * 0.96, top * 0.78], trim);
    lens(
        b,
        [front - 0.003, mid, top * 0.47],
        [x, mid, top * 0.47],
        r,
        if body == SILVER_METAL { SILVER_METAL } else { BLACK_PLASTIC },
    );
    if reflex {
        b.taper(
            "hump",
            [-x * 0.5, mid, top - hump * 0.05],
            (x * 0.35, y * 0.4),
            (x * 0.25, y * 0.22),
            hump * 0.95,
            BLACK_PLASTIC,
        );
        b.rounded_block(
            "grip",
            [-x * 0.94, -y * 0.96, top * 0.03],
            [(front + x * 0.25).min(x), -y * 0.55, top * 0.97],
            x * 0.1,
            RUBBER,
        );
        blocks(b, "shoe", &[([-x * 0.7, mid - y * 0.12, h - hump * 0.15], [-x * 0.35, mid + y * 0.12, h])], STEEL);
    } else {
        b.cylinder("shutter", [-x * 0.3, -y * 0.65, top - 0.001], (y * 0.1).min(x * 0.3), hump, SILVER_METAL);
    }
    blocks(
        b,
        "finder",
        &[([front - 0.002, -y * 0.75, top * 0.8], [front + 0.0012, -y * 0.45, top * 0.93])],
        BLACK_GLASS,
    );
    blocks(b, "flash", &[([front - 0.002, y * 0.55, top * 0.8], [front + 0.0014, y * 0.85, top * 0.95])], COOL_BULB);
    if b.class == "instant_camera" {
        blocks(b, "slot", &[([front - 0.002, -y * 0.75, top * 0.04], [front + 0.001, y * 0.75, top * 0.09])], SCREEN);
        let stripes = [(RED_PLASTIC, 0.0), (YELLOW_PLASTIC, 0.05), (BLUE_PLASTIC, 0.1)];
        for (mat, o) in stripes {
            blocks(
                b,
                "stripe",
                &[([front - 0.001, y * (0.62 + o), top * 0.16], [front + 0.0016, y * (0.66 + o), top * 0.7])],
                mat,
            );
        }
    }
    b.block("screen", [-x - 0.0004, -y * 0.6, top * 0.15], [-x + 0.003, y * 0.4, top * 0.8], SCREEN);
}

/// A camcorder: a barrel with a lens, a grip strap and a screen.
pub(super) fn video_camera(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[BLACK_PLASTIC, SILVER_METAL, GREY_PLASTIC]);
    let wide = y * 0.75;
    let r = wide.min(h * 0.36);
    b.rounded_block("body", [-x, -wide, h * 0.08], [x * 0.55, wide, h * 0.86], h * 0.2, body);
    lens(b, [x * 0.45, 0.0, h * 0.5], [x, 0.0, h * 0.5], r, BLACK_PLASTIC);
    b.rounded_block("finder", [-x, -wide * 0.4, h * 0.8], [-x * 0.4, wide * 0.4, h], h * 0.05, BLACK_PLASTIC);
    b.rounded_block("base", [-x * 0.7, -wide * 0.7, 0.0], [x * 0.4, wide * 0.7, h * 0.12], h * 0.03, BLACK_PLASTIC);
    let strap = [[-x * 0.7, -wide * 0.9, h * 0.45], [-x * 0.2, -y * 0.9, h * 0.45], [x * 0.3, -wide * 0.9, h * 0.45]];
    let mut shell = MeshBuilder::default();
    shell.tube(&spline(&strap, 4), (y - wide) * 0.3);
    shell.put(b, "strap", BLACK_FABRIC);
    b.hinge([x * 0.4, wide, 0.0], [0.0, 0.0, -1.0], 1.6, |b| {
        b.rounded_block(
            "display",
            [-x * 0.5, wide + (y - wide) * 0.04, h * 0.25],
            [x * 0.4, y, h * 0.75],
            h * 0.03,
            body,
        );
    });
    b.rod("microphone", [x * 0.1, 0.0, h * 0.9], [x * 0.6, 0.0, h * 0.9], h * 0.07, RUBBER);
    b.rod("light", [x * 0.5, wide * 0.6, h * 0.75], [x * 0.57, wide * 0.6, h * 0.75], h * 0.03, SIGNAL_RED);
}

/// A security camera: a dome or a barrel on a bracket.
pub(super) fn security(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = y.min(h * 0.5);
    if x < y * 1.3 {
        b.lathe("base", [0.0; 3], &[(x.min(y), 0.0), (x.min(y), h * 0.35), (x.min(y) * 0.85, h * 0.45)], WHITE_PLASTIC);
        let mut dome = MeshBuilder::default();
        let s = x.min(y) * 0.82;
        dome.egg([0.0, 0.0, h * 0.5], [s, s, h * 0.5]);
        dome.put(b, "dome", BLACK_GLASS);
        return;
    }
    let r = r * 0.8;
    b.lathe_along(
        "plate",
        [-x, 0.0, r.min(h * 0.4)],
        [0.0, 0.0, r.min(h * 0.4)],
        &[(r.min(h * 0.4), 0.0), (r.min(h * 0.4) * 0.9, x * 0.1)],
        WHITE_PLASTIC,
    );
    let arm = [[-x * 0.92, 0.0, h * 0.4], [-x * 0.6, 0.0, h * 0.4], [-x * 0.4, 0.0, h - r]];
    tube(b, "arm", &spline(&arm, 3), r * 0.25, WHITE_PLASTIC);
    b.rod("body", [-x * 0.6, 0.0, h - r], [x * 0.8, 0.0, h - r], r * 0.9, WHITE_PLASTIC);
    lens(b, [x * 0.6, 0.0, h - r], [x * 0.95, 0.0, h - r], r * 0.8, BLACK_PLASTIC);
    b.rounded_block("hood", [-x * 0.6, -y, h - r * 0.35], [x, y, h], r * 0.2, WHITE_PLASTIC);
}

/// A webcam on its clip.
pub(super) fn webcam(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[BLACK_PLASTIC, GREY_PLASTIC, WHITE_PLASTIC]);
    let low = h * 0.4;
    let (round, wide) = (b.vary(0.1, 0.3), y * b.vary(0.9, 1.0));
    b.rounded_block("body", [-x * 0.6, -wide, low], [x * 0.75, wide, h], h * round, body);
    lens(b, [x * 0.6, 0.0, (low + h) / 2.0], [x, 0.0, (low + h) / 2.0], (h - low) * 0.34, BLACK_PLASTIC);
    b.block("neck", [-x * 0.2, -y * 0.15, low * 0.5], [x * 0.2, y * 0.15, low * 1.2], body);
    b.block("clip", [-x * 0.97, -y * 0.44, 0.0], [x * 0.8, y * 0.44, low * 0.3], body);
    b.block("clip", [-x, -y * 0.45, low * 0.25], [-x * 0.8, y * 0.45, low * 0.9], body);
    b.block("clip", [-x * 0.9, -y * 0.4, low * 0.6], [x * 0.1, y * 0.4, low * 0.85], body);
    b.block("light", [x * 0.7, y * 0.4, h * 0.72], [x * 0.78, y * 0.5, h * 0.76], LED);
}

/// A folded tripod, standing on its three feet.
pub(super) fn tripod(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let metal = b.choose(&[BLACK_METAL, SILVER_METAL, ALUMINIUM]);
    let r = x.min(y);
    let (leg, crown) = (r * 0.2, h * 0.78);
    let spread = r * b.vary(0.7, 0.8);
    let (mut tubes, mut feet, mut clamps) = (MeshBuilder::default(), MeshBuilder::default(), MeshBuilder::default());
    for i in 0..3 {
        let (s, c) = (i as f32 * 2.094 + 1.05).sine_cosine();
        let at = |out: f32, z: f32| [out * c, out * s, z];
        tubes.tapered(&[at(spread, h * 0.02), at(spread * 0.85, h * 0.3), at(r * 0.35, crown)], |t| {
            leg * (0.6 + 0.35 * t)
        });
        clamps.tube(&[at(spread * 0.87, h * 0.28), at(spread * 0.83, h * 0.33)], leg * 1.05);
        clamps.tube(&[at(spread * 0.66, h * 0.5), at(spread * 0.63, h * 0.54)], leg * 1.15);
        feet.egg(at(spread, h * 0.02), [leg, leg, h * 0.02]);
    }
    tubes.put(b, "leg", metal);
    clamps.put(b, "clamp", BLACK_PLASTIC);
    feet.put(b, "foot", RUBBER);
    b.cylinder("column", [0.0, 0.0, h * 0.35], leg * 0.7, h * 0.55, metal);
    b.lathe(
        "crown",
        [0.0, 0.0, crown - h * 0.03],
        &[(r * 0.5, 0.0), (r * 0.55, h * 0.03), (r * 0.3, h * 0.07)],
        BLACK_PLASTIC,
    );
    b.block("head", [-r * 0.35, -r * 0.35, h * 0.88], [r * 0.35, r * 0.35, h * 0.96], BLACK_PLASTIC);
    b.block("plate", [-r * 0.45, -r * 0.42, h * 0.95], [r * 0.45, r * 0.42, h], GREY_PLASTIC);
    let handle = [[-r * 0.3, r * 0.2, h * 0.9], [-r * 0.6, r * 0.5, h * 0.75], [-r * 0.68, r * 0.55, h * 0.62]];
    tube(b, "handle", &handle, leg * 0.35, BLACK_PLASTIC);
}

/// A studio light: a softbox or a ring light on a stand.
pub(super) fn softbox(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let wide = y.min(h * 0.28);
    let middle = h - wide;
    let mut legs = MeshBuilder::default();
    let r = 0.011_f32.min(x * 0.06);
    for i in 0..3 {
        let (s, c) = (i as f32 * 2.094).sine_cosine();
        let reach = x.min(y) - r;
        legs.tube(&[[reach * c, reach * s, r], [0.0, 0.0, h * 0.22]], r);
        legs.tube(&[[reach * 0.5 * c, reach * 0.5 * s, h * 0.11], [0.0, 0.0, h * 0.07]], r * 0.6);
    }
    legs.tube(&[[0.0, 0.0, h * 0.06], [0.0, 0.0, middle]], r * 1.2);
    legs.put(b, "stand", BLACK_METAL);
    if b.rng.chance(0.35) {
        let ring = oval(Axis::X, [x * 0.1, 0.0, middle], (wide * 0.88, wide * 0.88), 0, 36);
        hoop(b, "ring", &ring, wide * 0.08, WHITE_PLASTIC);
        let glow = oval(Axis::X, [x * 0.1 + wide * 0.05, 0.0, middle], (wide * 0.88, wide * 0.88), 0, 36);
        hoop(b, "light", &glow, wide * 0.05, COOL_BULB);
        b.block("bridge", [-r, -r, middle - wide * 0.9], [x * 0.1, r, middle - wide * 0.8], BLACK_METAL);
        return;
    }
    let back = -x * 0.4;
    let ring = |px: f32, s: f32| CORNERS.map(|(a, c)| [px, wide * s * a, middle + wide * s * c]).to_vec();
    crate::solid::loft(b, "box", &[ring(back, 0.22), ring(x * 0.75, 1.0), ring(x * 0.85, 1.0)], BLACK_FABRIC);
    let panel = wide * 0.97;
    b.block("light", [x * 0.83, -panel, middle - panel], [x * 0.87, panel, middle + panel], COOL_BULB);
    b.rod("lamp", [back - x * 0.3, 0.0, middle], [back + 0.005, 0.0, middle], wide * 0.16, BLACK_PLASTIC);
}

/// A drone: body, four arms with rotors, a camera below.
pub(super) fn drone(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[WHITE_PLASTIC, GREY_PLASTIC, BLACK_PLASTIC, RED_PLASTIC]);
    let r = x.min(y) * b.vary(0.36, 0.44);
    let (deep, high) = (h * 0.3, h * 0.75);
    b.rounded_block("body", [-x * 0.55, -y * 0.24, deep], [x * 0.55, y * 0.24, h * 0.85], h * 0.2, body);
    let (mut arms, mut blades, mut feet) = (MeshBuilder::default(), MeshBuilder::default(), MeshBuilder::default());
    let guards = b.rng.chance(0.4);
    for (sx, sy) in [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)] {
        let at = [sx * (x - r), sy * (y - r)];
        let hub = [at[0], at[1], high];
        arms.tapered(&[[sx * x * 0.3, sy * y * 0.1, h * 0.6], hub], |t| h * (0.12 - 0.03 * t));
        arms.tube(&[[at[0], at[1], high - h * 0.1], [at[0], at[1], h * 0.92]], r * 0.14);
        feet.tapered(&[[at[0], at[1], high - h * 0.05], [at[0], at[1], 0.0]], |t| h * (0.07 - 0.03 * t));
        let turn = b.vary(0.0, PI);
        let (s, c) = turn.sine_cosine();
        let tip = |f: f32, z: f32| [at[0] + r * 0.98 * f * c, at[1] + r * 0.98 * f * s, z];
        blades.leaf(
            &[tip(-1.0, h * 0.95), tip(-0.5, h * 0.96), tip(0.0, h * 0.95), tip(0.5, h * 0.96), tip(1.0, h * 0.95)],
            |t| r * (0.06 + 0.16 * (t - 0.5).abs()),
            0.0,
        );
        if guards {
            arms.hoop(&oval(Axis::Z, [at[0], at[1], h * 0.94], (r * 0.96, r * 0.96), 0, 20), r * 0.035);
            arms.tube(&[hub, [at[0] + sx * r * 0.65, at[1] + sy * r * 0.65, h * 0.93]], r * 0.03);
        }
    }
    arms.put(b, "arm", body);
    blades.put(b, "blade", BLACK_PLASTIC);
    feet.put(b, "foot", BLACK_PLASTIC);
    lens(b, [x * 0.35, 0.0, deep * 0.75], [x * 0.62, 0.0, deep * 0.75], deep * 0.6, BLACK_PLASTIC);
    b.block("mount", [x * 0.3, -y * 0.05, deep * 0.7], [x * 0.4, y * 0.05, deep * 1.2], BLACK_PLASTIC);
    let lights: Vec<(P, P)> = [-1.0_f32, 1.0]
        .map(|s| ([x * 0.5, s * y * 0.15 - y * 0.03, h * 0.55], [x * 0.56, s * y * 0.15 + y * 0.03, h * 0.65]))
        .to_vec();
    blocks(b, "light", &lights, LED);
}
