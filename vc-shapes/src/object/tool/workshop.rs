//! Toolboxes, cans, cords and household supplies.

use std::f32::consts::FRAC_PI_2;

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{
    Axis, Build, MeshBuilder, P, arc, blocks, half_dims, hoop, lengthwise, longwise, oval, spline, tube, walled_tray,
};

/// A toolbox: a hinged lid with a handle over a compartment, and a drawer below.
pub(super) fn toolbox(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let (body, lid) = b.choose(&[
        (RED_METAL, RED_METAL),
        (BLUE_METAL, BLUE_METAL),
        (BLACK_PLASTIC, YELLOW_PLASTIC),
        (GREY_PLASTIC, ORANGE_PLASTIC),
        (BLACK_PLASTIC, RED_PLASTIC),
    ]);
    let t = (x * 0.03).min(0.004);
    let latch = (x * 0.05).min(0.008);
    let (grip, split) = (h * 0.14, h * 0.34);
    let (rim, top) = (h * 0.66, h - grip);
    b.at([-latch / 2.0, 0.0, 0.0], 0.0, |b| {
        let half = x - latch / 2.0;
        walled_tray(b, (half, y), (split, rim), t, body);
        b.inside("compartment", [0.0, 0.0, split + t], (half - 2.0 * t, y - 2.0 * t), rim - split - t);
        let list = [
            ([t * 0.2 - half, t * 0.2 - y, 0.0], [half - t * 0.2, y - t * 0.2, t]),
            ([t * 0.2 - half, t * 0.2 - y, t * 0.9], [half - t * 0.2, -y + t, split + t * 0.3]),
            ([t * 0.2 - half, y - t, t * 0.9], [half - t * 0.2, y - t * 0.2, split + t * 0.3]),
            ([t * 0.2 - half, -y + t * 0.9, t * 0.9], [-half + t, y - t * 0.9, split + t * 0.3]),
        ];
        blocks(b, "base", &list, body);
        b.slide([1.0, 0.0, 0.0], x * 1.2, |b| {
            let (back, ahead, w) = (-half + 2.0 * t, half - h * 0.002, y - 1.6 * t);
            let (z0, z1) = (1.5 * t, split - t * 0.6);
            let walls = [
                ([back, -w, z0], [ahead - t, w, z0 + t]),
                ([ahead - 1.1 * t, -w, z0], [ahead, w, z1]),
                ([back, -w, z0 + t * 0.9], [ahead - t, -w + t, z1 * 0.95]),
                ([back, w - t, z0 + t * 0.9], [ahead - t, w, z1 * 0.95]),
                ([back, -w + t * 0.9, z0 + t * 0.9], [back + t, w - t * 0.9, z1 * 0.95]),
            ];
            blocks(b, "drawer", &walls, lid);
            b.inside(
                "drawer",
                [(back + ahead) / 2.0, 0.0, z0 + t],
                ((ahead - back) / 2.0 - 2.0 * t, w - 2.0 * t),
                (z1 - z0 - 2.0 * t).max(0.0),
            );
            b.block(
                "pull",
                [ahead - t * 0.5, -y * 0.2, split * 0.55],
                [half + latch * 0.9, y * 0.2, split * 0.7],
                STEEL,
            );
        });
        b.hinge([-half, 0.0, rim], [0.0, -1.0, 0.0], 1.8, |b| {
            b.rounded_block("lid", [-half, -y, rim + h * 0.002], [half, y, top], (top - rim) * 0.35, lid);
            for side in [-0.6, 0.6] {
                b.block(
                    "latch",
                    [half - 0.002, y * side - y * 0.06, rim - h * 0.05],
                    [half + latch * 0.9, y * side + y * 0.06, rim + h * 0.08],
                    STEEL,
                );
            }
            let r = (grip * 0.2).min(x * 0.1);
            let handle =
                [[0.0, -y * 0.35, top - r], [0.0, -y * 0.3, h - r], [0.0, y * 0.3, h - r], [0.0, y * 0.35, top - r]];
            tube(b, "handle", &handle, r, BLACK_PLASTIC);
        });
    });
}

/// A can of paint: rim, label, drips and a wire handle.
pub(super) fn paint_can(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    let paint = b.choose(&[RED, BLUE, WHITE, SAGE, MUSTARD, TERRACOTTA, NAVY]);
    let label = b.choose(&[WHITE_PAPER, CREAM_PAPER, BLUE_CARD]);
    let ear = r * 0.06;
    let r = r - ear;
    let can = [
        (r, 0.0),
        (r, h * 0.03),
        (r * 0.97, h * 0.05),
        (r * 0.97, h * 0.94),
        (r, h * 0.96),
        (r, h),
        (r * 0.88, h),
        (r * 0.86, h * 0.97),
    ];
    b.lathe("can", [0.0; 3], &can, SILVER_METAL);
    b.lathe("label", [0.0, 0.0, h * 0.12], &[(r * 0.98, 0.0), (r * 0.98, h * 0.7)], label);
    b.lathe("band", [0.0, 0.0, h * 0.35], &[(r * 0.99, 0.0), (r * 0.99, h * 0.22)], paint);
    b.lathe("lid", [0.0, 0.0, h * 0.96], &[(r * 0.85, 0.0), (r * 0.8, h * 0.03), (r * 0.6, h * 0.02)], SILVER_METAL);
    let mut drips = MeshBuilder::default();
    for i in 0..3 {
        let (s, c) = (0.8 * i as f32 + 0.3).sine_cosine();
        drips.egg([r * 0.97 * c, r * 0.97 * s, h * 0.84], [r * 0.05, r * 0.05, h * b.vary(0.06, 0.14)]);
    }
    drips.put(b, "drip", paint);
    let bail = arc(Axis::Z, [0.0, 0.0, h * 0.86], (r + ear * 0.5, r + ear * 0.5), (FRAC_PI_2, 3.0 * FRAC_PI_2), 14);
    let bail: Vec<P> = bail.iter().map(|p| [p[0], p[1], p[2] + p[0] * 0.5]).collect();
    tube(b, "bail", &bail, ear * 0.35, STEEL);
}

/// The height of a coil from 0 to 1 at the fraction `t` of its turns: the first turn lies on the
/// ground.
pub(super) fn risen(t: f32, turns: f32) -> f32 {
    ((t * turns - 0.8) / (turns - 0.8).max(0.1)).clamp(0.0, 1.0)
}

/// A coil of rope.
pub(super) fn rope(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = (h / 5.0).min(x * 0.12).max(h * 0.08);
    let mat = b.choose(&[JUTE, WHITE_COTTON, BLUE_FABRIC, ORANGE_PLASTIC]);
    let turns = ((h - 2.0 * r) / (1.6 * r)).clamp(1.0, 5.0).round();
    let coil: Vec<P> = (0..=(turns as usize * 20))
        .map(|i| {
            let t = i as f32 / (turns * 20.0);
            let (s, c) = (t * turns * std::f32::consts::TAU).sine_cosine();
            let wobble = 0.92 + 0.06 * (t * 40.0).sine();
            [(x - r) * c * wobble, (y - r) * s * wobble, r + (h - 2.0 * r) * risen(t, turns)]
        })
        .collect();
    tube(b, "rope", &coil, r, mat);
    let tie = oval(Axis::Y, [x - r * 1.8, 0.0, h / 2.0], ((r * 1.4).min(x * 0.3), h / 2.0 - r * 0.35), 0, 14);
    hoop(b, "tie", &tie, r * 0.3, mat);
}

/// A fire extinguisher: red bottle, hose, gauge and a handle.
pub(super) fn extinguisher(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let side = y * 0.22;
    let r = x.min(y - side) * 0.98;
    let shift = -(y - r * 1.04);
    let body =
        [(r * 0.9, 0.0), (r, h * 0.02), (r, h * 0.68), (r * 0.8, h * 0.76), (r * 0.35, h * 0.8), (r * 0.3, h * 0.86)];
    b.lathe("bottle", [0.0, shift, 0.0], &body, RED_METAL);
    b.lathe("label", [0.0, shift, h * 0.25], &[(r * 1.02, 0.0), (r * 1.02, h * 0.25)], b.style.joinery);
    b.block("valve", [-r * 0.3, shift - r * 0.3, h * 0.84], [r * 0.3, shift + r * 0.3, h * 0.92], BLACK_METAL);
    b.block("lever", [-r * 0.2, shift - r * 0.9, h * 0.965], [r * 0.2, shift + r * 0.4, h], BLACK_METAL);
    b.block("grip", [-r * 0.2, shift - r * 0.8, h * 0.9], [r * 0.2, shift + r * 0.2, h * 0.925], BLACK_METAL);
    b.block("post", [-r * 0.15, shift + r * 0.1, h * 0.9], [r * 0.15, shift + r * 0.35, h * 0.97], BLACK_METAL);
    b.rod("gauge", [r * 0.25, shift, h * 0.88], [r * 0.45, shift, h * 0.88], r * 0.22, WHITE_METAL);
    let hose_radius = (side * 0.35).min(r * 0.14);
    let out = y - hose_radius;
    let hose =
        [[0.0, shift + r * 0.25, h * 0.88], [0.0, out * 0.9, h * 0.86], [0.0, out, h * 0.6], [0.0, out, h * 0.35]];
    tube(b, "hose", &hose, hose_radius * 0.8, RUBBER);
    b.lathe("nozzle", [0.0, out, h * 0.2], &[(hose_radius, 0.0), (hose_radius * 0.7, h * 0.17)], BLACK_PLASTIC);
    b.block("bracket", [-r * 0.1, out - hose_radius - side, h * 0.3], [r * 0.1, out, h * 0.33], BLACK_METAL);
}

/// A lighter, small or long-necked.
pub(super) fn lighter(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let colour = b.choose(&[RED_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC, YELLOW_PLASTIC, BLACK_PLASTIC]);
    let ring = |z: f32, s: f32| oval(Axis::Z, [0.0, 0.0, z], (x * s, y * s), 1, 16);
    let mut body = MeshBuilder::default();
    let (split, neck) = if h > 0.13 { (h * 0.45, 0.3) } else { (h * 0.78, 0.92) };
    body.loft(&[ring(0.0, 0.94), ring(h * 0.03, 1.0), ring(split, 1.0), ring(split * 1.02, 0.7)]);
    body.put(b, "body", colour);
    b.cylinder("hood", [0.0, 0.0, split], x.min(y) * neck, h - split, STEEL);
    b.block("wheel", [-x * 0.5, y * 0.2, split], [x * 0.5, y * 0.9, split + h * 0.06], IRON);
}

/// A matchbox with striking sides; its tray slides out.
pub(super) fn matches(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let card = b.choose(&[RED_CARD, BLUE_CARD, YELLOW_CARD, GREEN_CARD]);
    let (t, e) = (h * 0.06, h * 0.03);
    let list = [
        ([-x + e, -y, 0.0], [x - e, y, t]),
        ([-x + e, -y, h - t - e], [x - e, y, h - e]),
        ([-x + e * 1.01, -y * 0.999, t * 0.9], [-x + e + t, y * 0.999, h - t * 0.9 - e]),
        ([x - e - t, -y * 0.999, t * 0.9], [x - e * 1.01, y * 0.999, h - t * 0.9 - e]),
    ];
    blocks(b, "sleeve", &list, card);
    b.block("label", [-x * 0.6, -y * 0.7, h - 2.0 * e], [x * 0.6, y * 0.7, h], CREAM_PAPER);
    blocks(
        b,
        "striker",
        &[
            ([-x, -y * 0.95, h * 0.2], [-x + 2.0 * e, y * 0.95, h * 0.75]),
            ([x - 2.0 * e, -y * 0.95, h * 0.2], [x, y * 0.95, h * 0.75]),
        ],
        BROWN_SKIN,
    );
    b.slide([0.0, 1.0, 0.0], y * 1.4, |b| {
        let w = x - e - 1.3 * t;
        b.block("tray", [-w * 0.97, -y * 0.97, t * 1.3], [w * 0.97, y * 0.97, t * 2.2], WHITE_PAPER);
        let ends = [
            ([-w, -y * 0.99, t * 2.0], [w, -y * 0.99 + t, h - e - t * 1.3]),
            ([-w, y * 0.99 - t, t * 2.0], [w, y * 0.99, h - e - t * 1.3]),
        ];
        blocks(b, "tray", &ends, WHITE_PAPER);
        let sticks: Vec<(P, P)> = (0..7)
            .map(|i| -w * 0.9 + w * 0.27 * i as f32)
            .map(|a| ([a, -y * 0.9, t * 2.1], [a + w * 0.12, y * 0.8, t * 4.0]))
            .collect();
        blocks(b, "match", &sticks, PINE);
        let heads: Vec<(P, P)> = sticks.iter().map(|&(l, h)| ([l[0], y * 0.8, l[2]], [h[0], y * 0.92, h[2]])).collect();
        blocks(b, "head", &heads, RED_PLASTIC);
    });
}

/// A power strip or extension lead: sockets in a row, a switch, a cord.
pub(super) fn power_strip(b: &mut Build<'_>) {
    lengthwise(b, |b, x, y, h| {
        let case = b.choose(&[WHITE_PLASTIC, BLACK_PLASTIC, WHITE_PLASTIC]);
        let dark = if case == BLACK_PLASTIC { GREY_PLASTIC } else { LIGHT_GREY };
        let cord = (x * 0.1).min(0.005);
        let tail = (y * 0.25).min(0.05);
        let (w, end) = (x.min(h * 0.8), y - tail);
        let relief = (h * 0.05).min(0.002);
        b.rounded_block("case", [-w, -y, 0.0], [w, end, h - relief], h * 0.2, case);
        let count = (((y + end) / 0.055) as usize).clamp(2, 7);
        let pitch = (y + end) * 0.9 / (count + 1) as f32;
        let r = (pitch * 0.42).min(w * 0.75);
        for i in 0..count {
            let at = -y + (y + end) * 0.06 + pitch * (i as f32 + 0.5);
            b.lathe(
                "socket",
                [0.0, at, h * 0.7],
                &[(r, 0.0), (r, h * 0.3), (r * 0.85, h * 0.3), (r * 0.85, h * 0.05)],
                case,
            );
            let holes = [-0.4, 0.4]
                .map(|s| ([r * s - r * 0.1, at - r * 0.1, h * 0.72], [r * s + r * 0.1, at + r * 0.1, h * 0.78]));
            blocks(b, "hole", &holes, BLACK_PLASTIC);
        }
        let lamp = if b.rng.chance(0.5) { SIGNAL_RED } else { dark };
        b.block("switch", [-w * 0.4, end - pitch * 0.75, h * 0.7], [w * 0.4, end - pitch * 0.3, h], lamp);
        let lead = [
            [0.0, end * 0.98, cord * 2.0],
            [w * 0.3, end + tail * 0.3, cord],
            [-w * 0.4, end + tail * 0.6, cord],
            [0.0, y - cord, cord],
        ];
        tube(b, "cord", &spline(&lead, 5), cord, case);
    });
}

/// A battery: a round cell with its cap, or a block with two terminals.
pub(super) fn battery(b: &mut Build<'_>) {
    longwise(b, |b, t, w, l| {
        let (x, y) = (t / 2.0, w / 2.0);
        let (wrap, end) = b.choose(&[
            (BLACK_PLASTIC, COPPER),
            (RED_PLASTIC, BLACK_PLASTIC),
            (YELLOW_PLASTIC, BLACK_PLASTIC),
            (BLUE_PLASTIC, SILVER_METAL),
        ]);
        let cap = l * b.vary(0.945, 0.97);
        let band = l * b.vary(0.55, 0.75);
        if y > 1.3 * x || x > 1.3 * y {
            b.block("case", [-x, -y, 0.0], [x, y, band], wrap);
            b.block("top", [-x, -y, band], [x, y, cap], end);
            let r = x.min(y) * 0.4;
            let offset = if y > x { [0.0, y * 0.5] } else { [x * 0.5, 0.0] };
            for s in [-1.0, 1.0] {
                b.cylinder("pole", [offset[0] * s, offset[1] * s, cap], r, l - cap, STEEL);
            }
            return;
        }
        let r = x.min(y);
        b.lathe("case", [0.0; 3], &[(r * 0.96, 0.0), (r, l * 0.02), (r, band)], wrap);
        b.lathe("top", [0.0, 0.0, band], &[(r, 0.0), (r, cap - band - l * 0.02), (r * 0.95, cap - band)], end);
        b.cylinder("pole", [0.0, 0.0, cap - l * 0.01], r * 0.35, l - cap + l * 0.01, STEEL);
    });
}
