//! Desk accessories: keyboards, mice, USB sticks and cables.

use vc_graph::portable::Portable;

use super::{case, grid};
use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, blocks, half_dims, lengthwise, loft, oval, spline, tube};

/// A keyboard: sloping, with rows of keys and a number pad where it is wide.
pub(super) fn keyboard(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let body = case(b);
    let dark = body == BLACK_PLASTIC;
    let keys = if dark { ANTHRACITE } else { b.choose(&[WHITE_PLASTIC, LIGHT_GREY, BLACK_PLASTIC]) };
    let (front, back, key) = (h * 0.4, h * 0.72, h * 0.26);
    let slope = [(-x, 0.0), (x, 0.0), (x, front), (-x, back)];
    b.prism("body", Axis::Y, [0.0, -y, 0.0], &slope, 2.0 * y, body);
    let at = |px: f32| front + (back - front) * (x - px) / (2.0 * x);
    let pad = y > 0.19;
    let main = if pad { 0.66 * 2.0 * y } else { 1.94 * y };
    let rest = b.vary(0.0, 0.12);
    let (x0, y0) = (-x * 0.93, -y * 0.97);
    let (px, py) = ((1.88 - rest) * x / 5.0, main / 14.0);
    let cap = |i: f32, j: f32, wide: f32| {
        let (a, c) = (x0 + px * i, y0 + py * j);
        ([a, c, at(a + px) - key * 0.4], [a + px * 0.84, c + py * (wide - 0.16), at(a) + key])
    };
    let mut list = grid((4, 14), |i, j| cap(i, j, 1.0));
    list.extend([
        cap(4.0, 0.0, 1.5),
        cap(4.0, 1.6, 1.3),
        cap(4.0, 3.0, 6.0),
        cap(4.0, 9.1, 1.5),
        cap(4.0, 10.7, 1.5),
        cap(4.0, 12.4, 1.6),
    ]);
    if pad {
        let start = y0 + main + py * 0.4;
        let side = (y * 0.97 - start) / py;
        let columns = (side / 1.0).floor().clamp(3.0, 5.0);
        let wide = side / columns;
        list.extend(grid((5, columns as usize), |i, j| {
            let (l, h) = cap(i, 0.0, wide);
            ([l[0], l[1] - y0 + start + py * wide * j, l[2]], [h[0], h[1] - y0 + start + py * wide * j, h[2]])
        }));
    }
    let colour = b.choose(&[RED_PLASTIC, keys, keys, ORANGE_PLASTIC]);
    let escape = list.remove(0);
    blocks(b, "keys", &list, keys);
    blocks(b, "keys", &[escape], colour);
    if b.rng.chance(0.3) {
        blocks(b, "light", &[([x0, y * 0.8, back * 0.8], [x0 + x * 0.04, y * 0.9, back * 0.99])], LED);
    }
}

/// A mouse: a hump with two buttons and a wheel, with or without a cable.
pub(super) fn mouse(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[BLACK_PLASTIC, WHITE_PLASTIC, GREY_PLASTIC, RED_PLASTIC, ANTHRACITE]);
    let trim = if body == BLACK_PLASTIC { GREY_PLASTIC } else { BLACK_PLASTIC };
    let (peak, wide) = (b.vary(-0.2, 0.25), b.vary(0.8, 0.92));
    let wheel = h * 0.05;
    let top = h - wheel;
    let ring = |t: f32, w: f32, z: f32| oval(Axis::X, [x * t, 0.0, top * z / 2.0], (y * w, top * z / 2.0), 1, 18);
    let rings = [
        ring(-1.0, wide * 0.45, 0.25),
        ring(-0.9, wide * 0.8, 0.45),
        ring(-0.5, 1.0, 0.75),
        ring(peak, wide, 1.0),
        ring(0.6, wide, 0.85),
        ring(0.9, 0.9 * wide, 0.66),
        ring(1.0, wide * 0.7, 0.48),
    ];
    loft(b, "body", &rings.map(|r| r.iter().map(|p| [-p[0], p[1], p[2]]).collect()), body);
    let mut lines = MeshBuilder::default();
    let line: Vec<P> = [(-0.97, 0.52), (-0.88, 0.68), (-0.6, 0.86), (-0.25, 0.95)]
        .iter()
        .map(|&(t, z)| [x * t, 0.0, top * z])
        .collect();
    lines.tube(&spline(&line, 3), h * 0.025);
    lines.put(b, "seam", trim);
    b.rod(
        "wheel",
        [-x * 0.55, -y * 0.12, top * 0.8],
        [-x * 0.55, y * 0.12, top * 0.8],
        (top * 0.14).min(x * 0.12),
        trim,
    );
    if b.rng.chance(0.4) {
        let glow = b.choose(&[SIGNAL_RED, PICTURE_SKY, LED]);
        b.prism(
            "logo",
            Axis::Z,
            [x * 0.5, 0.0, top * 0.5],
            &crate::solid::ngon((x * 0.08, x * 0.08), 8),
            top * 0.32,
            glow,
        );
    }
}

/// A drawing tablet with its pen.
pub(super) fn graphic_tablet(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let pen = (h * 0.25).min(x * 0.04);
    let top = h - 2.0 * pen;
    b.rounded_block("body", [-x, -y, 0.0], [x, y, top], top * 0.4, BLACK_PLASTIC);
    b.block("surface", [-x * 0.9, -y * 0.72, top * 0.5], [x * 0.9, y * 0.92, top + h * 0.05], GREY_PLASTIC);
    let keys: Vec<(P, P)> = (0..6)
        .map(|i| x * (-0.75 + 0.25 * i as f32))
        .map(|a| ([a, -y * 0.93, top * 0.5], [a + x * 0.18, -y * 0.8, top + h * 0.12]))
        .collect();
    blocks(b, "key", &keys, SILVER_METAL);
    let turn = b.vary(0.1, 0.5);
    let (s, c) = turn.sine_cosine();
    let long = x.min(y) * 0.55;
    let mid = [x * 0.1, y * 0.3, top + pen];
    let mut shell = MeshBuilder::default();
    shell.tapered(
        &[
            [mid[0] - long * s, mid[1] - long * c, mid[2]],
            [mid[0] + long * s * 0.85, mid[1] + long * c * 0.85, mid[2]],
            [mid[0] + long * s, mid[1] + long * c, mid[2]],
        ],
        |t| pen * if t > 0.9 { 0.15 } else { 0.95 },
    );
    shell.put(b, "pen", ANTHRACITE);
}

/// A memory stick with its plug.
pub(super) fn usb_stick(b: &mut Build<'_>) {
    lengthwise(b, |b, x, y, h| {
        let body = b.choose(&[RED_PLASTIC, BLUE_PLASTIC, BLACK_PLASTIC, SILVER_METAL, GREEN_PLASTIC]);
        let split = y * b.vary(0.35, 0.5);
        b.rounded_block("body", [-x, -y, 0.0], [x, split, h], h * 0.3, body);
        b.block("plug", [-x * 0.7, split - y * 0.1, h * 0.2], [x * 0.7, y, h * 0.8], STEEL);
        blocks(
            b,
            "hole",
            &[-0.35, 0.35].map(|s| ([x * s - x * 0.15, y * 0.75, h * 0.7], [x * s + x * 0.15, y * 0.88, h * 0.87])),
            BLACK_PLASTIC,
        );
        b.block("label", [-x * 0.6, -y * 0.8, h * 0.5], [x * 0.6, 0.0, h + 0.0006], WHITE_PAPER);
    });
}

/// A charger: a block with two pins and a lead.
pub(super) fn charger(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[WHITE_PLASTIC, BLACK_PLASTIC]);
    let pins = y * 0.35;
    let split = y - pins;
    b.rounded_block("block", [-x, -y * 0.97, 0.0], [x, split, h], x.min(h) * 0.25, body);
    for s in [-0.35, 0.35] {
        b.rod("pin", [x * s, split - y * 0.05, h / 2.0], [x * s, y, h / 2.0], (x * 0.1).min(h * 0.1), STEEL);
    }
    b.block("port", [-x * 0.35, -y, h * 0.4], [x * 0.35, -y * 0.9, h * 0.55], SCREEN);
    b.block("mark", [-x * 0.3, -y * 0.5, h * 0.9], [x * 0.3, -y * 0.2, h + 0.0006], GREY_PLASTIC);
}

/// A coiled cable with its plugs.
pub(super) fn cable(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let colour = b.choose(&[BLACK_PLASTIC, WHITE_PLASTIC, GREY_PLASTIC, RED_FABRIC]);
    let r = (h * 0.14).min(x * 0.08);
    let turns = 3.0;
    let line: Vec<P> = (0..=48)
        .map(|i| {
            let t = i as f32 / 48.0;
            let (s, c) = (t * turns * std::f32::consts::TAU).sine_cosine();
            let reach = 1.0 - 0.18 * (t * 9.0).sine().abs();
            [(x - r) * c * reach, (y - r) * s * reach, r + (h - 2.0 * r) * t]
        })
        .chain([[x * 0.2, -y * 0.3, r * 1.5]])
        .collect();
    tube(b, "cable", &line, r, colour);
    let plug = (x * 0.14).min(h * 0.3);
    b.rounded_block(
        "plug",
        [-plug + x * 0.2, -y * 0.35, 0.0],
        [plug + x * 0.2, y * 0.05, plug * 1.2],
        plug * 0.3,
        colour,
    );
    b.block("plug", [-plug * 0.6 + x * 0.2, y * 0.03, plug * 0.3], [plug * 0.6 + x * 0.2, y * 0.25, plug * 0.9], STEEL);
    let tie = oval(Axis::X, [0.0, -y + r * 2.6, h / 2.0], (r * 2.1, h / 2.0 - r * 0.4), 0, 12);
    crate::solid::hoop(b, "tie", &tie, r * 0.4, BLACK_FABRIC);
}
