//! Desk items other than paper.

use std::f32::consts::PI;

use crate::material::*;
use crate::solid::{
    Axis, Build, MeshBuilder, arc, blocks, half_dims, hoop, loft, mix, oval, spline, tube, walled_tray,
};

const BRIGHT: [MaterialId; 7] =
    [RED_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC, BLACK_PLASTIC, GREY_PLASTIC, YELLOW_PLASTIC, WHITE_PLASTIC];

/// A soft pencil case with a zip along its top, which opens like a lid.
pub(super) fn pencil_case(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let cloth = b.choose(&[DENIM, RED_FABRIC, TEAL_FABRIC, BLACK_FABRIC, PURPLE_FABRIC, MUSTARD_FABRIC]);
    let t = x.min(h) * 0.08;
    let lid = h * 0.7;
    walled_tray(b, (x, y), (0.0, lid), t, cloth);
    b.inside("compartment", [0.0, 0.0, t], (x - 2.0 * t, y - 2.0 * t), lid - t);
    b.hinge([-x, 0.0, lid], [0.0, -1.0, 0.0], 1.6, |b| {
        b.rounded_block("lid", [-x, -y, lid], [x, y, h * 0.97], h * 0.2, cloth);
        blocks(b, "zip", &[([x * 0.1, -y * 0.9, (lid + h) * 0.5], [x * 0.2, y * 0.9, h])], STEEL);
    });
}

/// A cup for pens: round, square or of mesh.
pub(super) fn pencil_holder(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[BLACK_METAL, b.style.wood, WHITE_PLASTIC, POTTERY, BLUE_GLAZE, TAN_LEATHER, STEEL]);
    let r = x.min(y);
    let t = r * 0.08;
    if b.rng.chance(0.6) {
        let foot = r * b.vary(0.75, 1.0);
        b.lathe("cup", [0.0; 3], &[(foot, 0.0), (r, h), (r - t, h), (foot - t, t * 1.5)], mat);
        let rim = oval(Axis::Z, [0.0, 0.0, h * 0.3], (r * 0.985, r * 0.985), 0, 24);
        if foot > r * 0.99 {
            hoop(b, "band", &rim, r * 0.015, b.style.metal);
        }
        b.inside("slot", [0.0, 0.0, t * 1.5], ((foot - t) * 0.65, (foot - t) * 0.65), h - t * 1.5);
    } else {
        walled_tray(b, (x, y), (0.0, h), t, mat);
        b.inside("slot", [0.0, 0.0, t], (x - 1.5 * t, y - 1.5 * t), h - t);
    }
}

/// A stapler: base, magazine and a hinged arm.
pub(super) fn stapler(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let colour = b.choose(&BRIGHT);
    b.rounded_block("base", [-x, -y, 0.0], [x, y, h * 0.14], h * 0.05, BLACK_PLASTIC);
    b.block("anvil", [-x * 0.5, y * 0.6, h * 0.12], [x * 0.5, y * 0.9, h * 0.17], STEEL);
    b.block("post", [-x * 0.7, -y * 0.95, h * 0.1], [x * 0.7, -y * 0.6, h * 0.42], colour);
    b.hinge([0.0, -y * 0.85, h * 0.45], [1.0, 0.0, 0.0], 0.4, |b| {
        b.block("magazine", [-x * 0.6, -y * 0.8, h * 0.4], [x * 0.6, y * 0.95, h * 0.58], STEEL);
        let arm = [(-y, 0.45), (-y * 0.96, 0.8), (-y * 0.3, 1.0), (y * 0.75, 0.85), (y * 0.97, 0.68), (y * 0.97, 0.56)];
        let outline: Vec<(f32, f32)> = arm.iter().map(|p| (p.0, p.1 * h)).collect();
        b.prism("arm", Axis::X, [-x * 0.8, 0.0, 0.0], &outline, x * 1.6, colour);
    });
}

/// A hole punch: tray, two plungers and a lever.
pub(super) fn hole_punch(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let colour = b.choose(&BRIGHT);
    b.rounded_block("tray", [-x, -y, 0.0], [x, y, h * 0.15], h * 0.05, BLACK_PLASTIC);
    b.block("bridge", [-x * 0.5, -y * 0.9, h * 0.1], [x * 0.1, y * 0.9, h * 0.5], STEEL);
    for side in [-0.65, 0.65] {
        b.cylinder("plunger", [-x * 0.1, y * side, h * 0.3], x * 0.12, h * 0.4, STEEL);
    }
    let lever =
        [(-x * 0.9, h * 0.4), (x * 0.8, h * 0.78), (x * 0.75, h * 1.0), (-x * 0.2, h * 0.85), (-x * 0.9, h * 0.55)];
    b.prism("lever", Axis::Y, [0.0, -y * 0.85, 0.0], &lever, y * 1.7, colour);
}

/// A lying roll of tape; with a dispenser if high.
pub(super) fn tape(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    let duct = b.class == "duct_tape";
    let colour = if duct {
        b.choose(&[SILVER_METAL, GREY_PLASTIC, BLACK_PLASTIC])
    } else {
        b.choose(&[CLEAR_PLASTIC, BROWN_PLASTIC, CREAM_PAPER])
    };
    let core = r * b.vary(0.55, 0.68);
    let ring =
        |outer: f32, inner: f32, z0: f32, z1: f32| [(outer, z0), (outer, z1), (inner, z1), (inner, z0), (outer, z0)];
    b.lathe("tape", [0.0; 3], &ring(r, core, h * 0.02, h * 0.98), colour);
    b.lathe("core", [0.0; 3], &ring(core * 1.01, core * 0.93, 0.0, h), CARDBOARD);
    b.block("end", [r * 0.55, -r * 0.72, h * 0.08], [r * 0.62, -r * 0.5, h * 0.92], colour);
}

/// A glue stick or bottle.
pub(super) fn glue(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    let (label, cap) =
        (b.choose(&[YELLOW_CARD, BLUE_CARD, RED_CARD]), b.choose(&[RED_PLASTIC, ORANGE_PLASTIC, BLUE_PLASTIC]));
    if b.rng.chance(0.5) {
        b.cylinder("tube", [0.0; 3], r * 0.93, h * 0.7, WHITE_PLASTIC);
        b.lathe("label", [0.0, 0.0, h * 0.08], &[(r, 0.0), (r, h * 0.55)], label);
        b.lathe("cap", [0.0, 0.0, h * 0.69], &[(r * 0.95, 0.0), (r * 0.92, h * 0.29), (r * 0.8, h * 0.31)], cap);
        return;
    }
    let ring = |z: f32, s: f32| oval(Axis::Z, [0.0, 0.0, z * h], (x * s, y * s), 1, 16);
    loft(b, "bottle", &[ring(0.0, 0.9), ring(0.02, 0.93), ring(0.6, 0.93), ring(0.72, 0.4)], WHITE_PLASTIC);
    loft(b, "label", &[ring(0.12, 1.0), ring(0.5, 1.0)], label);
    b.lathe(
        "cap",
        [0.0, 0.0, h * 0.7],
        &[(r * 0.45, 0.0), (r * 0.4, h * 0.12), (r * 0.15, h * 0.16), (r * 0.1, h * 0.3)],
        cap,
    );
}

/// Scissors: two blades that cross, two rings.
pub(super) fn scissors(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let grip = b.choose(&[RED_PLASTIC, BLACK_PLASTIC, ORANGE_PLASTIC, BLUE_PLASTIC, STEEL]);
    let r = h * 0.42;
    let ring = (x * 0.48 - r, y * 0.27);
    for (side, z) in [(-1.0_f32, h * 0.3), (1.0, h * 0.7)] {
        let blade = [
            (side * x * 0.02, y),
            (-side * x * 0.12, y * 0.9),
            (-side * x * 0.16, 0.0),
            (side * x * 0.3, -y * 0.52),
            (side * x * 0.62, -y * 0.46),
            (side * x * 0.08, 0.1 * y),
        ];
        b.prism("blade", Axis::Z, [0.0, 0.0, z - h * 0.12], &blade, h * 0.24, STEEL);
        let loop_ = oval(Axis::Z, [side * (x - ring.0 - r), -y + ring.1 + r, h / 2.0], (ring.0 * 0.98, ring.1), 0, 18);
        hoop(b, "grip", &loop_, r, grip);
    }
    b.cylinder("screw", [0.0; 3], x * 0.08, h * 0.9, STEEL);
}

/// A folder of card with papers in it, or a ring binder if thick.
pub(super) fn folder(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let card = b.choose(&[RED_CARD, BLUE_CARD, GREEN_CARD, YELLOW_CARD, CARDBOARD, BLACK_CARD, TEAL_CARD]);
    let t = (h * 0.12).min(0.002);
    let binder = h > 0.03;
    b.block("back", [-x, -y, 0.0], [x, y * 0.99, t], card);
    b.block("spine", [-x, -y, t * 0.9], [x, -y + t.max(0.001), h - t * 0.9], card);
    b.inside("pocket", [0.0, 0.0, t], (x * 0.95, y * 0.95), (h - 2.0 * t).max(0.0));
    b.hinge([0.0, -y, h - t], [1.0, 0.0, 0.0], 2.8, |b| {
        b.block("cover", [-x, -y, h - t], [x, y * 0.98, h], card);
    });
    if binder {
        b.block("label", [-x * 0.3, -y - 0.0004, h * 0.25], [x * 0.4, -y + t * 0.5, h * 0.75], WHITE_PAPER);
        let r = h * 0.3;
        for side in [-0.4, 0.4] {
            let ring = oval(Axis::X, [x * side, -y + r + 2.0 * t, h / 2.0], (r, r), 0, 14);
            hoop(b, "ring", &ring, h * 0.02, STEEL);
        }
    } else {
        b.block("tab", [-x * 0.9, y * 0.98, 0.0], [-x * 0.5, y, t + h * 0.15], card);
    }
}

/// Stacked letter trays, with some paper.
pub(super) fn paper_tray(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[BLACK_METAL, GREY_PLASTIC, CLEAR_PLASTIC, b.style.wood, WHITE_PLASTIC]);
    let count = ((h / 0.07).round() as usize).clamp(1, 3);
    let t = (h * 0.04).min(0.003);
    let pitch = h / count as f32;
    let rim = pitch * if count == 1 { 1.0 } else { 0.5 };
    for i in 0..count {
        let z = pitch * i as f32;
        let list = [
            ([-x, -y, z], [x, y, z + t]),
            ([-x * 0.999, -y, z + t * 0.9], [x * 0.999, -y + t, z + rim]),
            ([-x * 0.999, y - t, z + t * 0.9], [x * 0.999, y, z + rim]),
            ([-x * 0.998, -y + t * 1.01, z + t * 0.9], [-x + t, y - t * 1.01, z + rim]),
        ];
        blocks(b, "tray", &list, mat);
        let half = (x - 2.0 * t, y - 2.0 * t);
        let (name, last) = (format!("compartment_{}", i + 1), i + 1 == count);
        b.inside(&name, [0.0, 0.0, z + t], half, if last { rim } else { pitch - t });
        if last {
            b.top("top", [0.0, 0.0, z + t], half);
        }
    }
    if count > 1 {
        let post = |sx: f32, sy: f32| {
            (
                [sx * x * 0.9 - t, sy * (y - t * 1.5) - t * 0.5, t * 0.3],
                [sx * x * 0.9 + t, sy * (y - t * 1.5) + t * 0.5, h],
            )
        };
        blocks(b, "post", &[post(-1.0, -1.0), post(-1.0, 1.0), post(0.6, -1.0), post(0.6, 1.0)], STEEL);
    }
}

/// A clipboard with its clip and a few sheets.
pub(super) fn clipboard(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let board = b.choose(&[OAK, BROWN_PLASTIC, BLACK_PLASTIC, CLEAR_PLASTIC, BLUE_PLASTIC]);
    let t = (h * 0.3).min(0.004);
    b.rounded_block("board", [-x, -y, 0.0], [x, y, t], t * 0.4, board);
    b.block("paper", [-x * 0.82, -y * 0.92, t], [x * 0.92, y * 0.92, t + (h * 0.1).min(0.001)], WHITE_PAPER);
    b.block("clip", [-x * 0.97, -y * 0.4, t * 0.9], [-x * 0.75, y * 0.4, h * 0.7], STEEL);
    let grip = arc(Axis::Y, [-x * 0.9, -y * 0.25, h * 0.6], (x * 0.06, h * 0.38), (0.0, PI), 6);
    let outline: Vec<(f32, f32)> = grip.iter().map(|p| (p[0] + x * 0.9, p[2] - h * 0.6)).collect();
    b.prism("clip", Axis::Y, [-x * 0.9, -y * 0.25, h * 0.6], &outline, y * 0.5, STEEL);
    b.top("board", [x * 0.08, 0.0, t + (h * 0.1).min(0.001)], (x * 0.8, y * 0.9));
}

/// A pocket or desk calculator.
pub(super) fn calculator(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let case = b.choose(&[BLACK_PLASTIC, GREY_PLASTIC, WHITE_PLASTIC, BLUE_PLASTIC]);
    let face = h * 0.85;
    b.rounded_block("case", [-x, -y, 0.0], [x, y, face], h * 0.25, case);
    b.block("display", [-x * 0.85, -y * 0.85, face * 0.8], [-x * 0.5, y * 0.85, face + h * 0.06], SAGE);
    b.block("solar", [-x * 0.96, y * 0.2, face * 0.8], [-x * 0.89, y * 0.8, face + h * 0.04], SCREEN);
    let (rows, columns) = (b.rng.count(4, 5), b.rng.count(4, 5));
    let (px, py) = (1.3 * x / rows as f32, 1.75 * y / columns as f32);
    let mut keys = [MeshBuilder::default(), MeshBuilder::default()];
    for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
        let (a, c) = (-0.38 * x + px * i as f32, -0.87 * y + py * j as f32);
        keys[usize::from(j + 1 == columns)].block([a, c, face * 0.8], [a + px * 0.75, c + py * 0.78, h]);
    }
    let [plain, signs] = keys;
    plain.put(b, "keys", if case == GREY_PLASTIC { BLACK_PLASTIC } else { LIGHT_GREY });
    signs.put(b, "keys", ORANGE_PLASTIC);
}

/// A mouse pad, with a rim or a wrist rest.
pub(super) fn mousepad(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let cloth = b.choose(&[BLACK_FABRIC, NAVY_FABRIC, GREY_FABRIC, RED_FABRIC, TEAL_FABRIC]);
    b.rounded_block("rubber", [-x, -y, 0.0], [x, y, h * 0.6], h * 0.2, RUBBER);
    b.block("cloth", [-x * 0.985, -y * 0.985, h * 0.4], [x * 0.985, y * 0.985, h * 0.76], cloth);
    let glow = b.choose(&[WHITE_COTTON, RED_FABRIC, BLUE_FABRIC]);
    b.block("logo", [x * 0.6, y * 0.55, h * 0.6], [x * 0.8, y * 0.85, h], glow);
    b.top("top", [0.0, 0.0, h * 0.76], (x * 0.95, y * 0.95));
}

/// A paper shredder: a head with a slot on a bin.
pub(super) fn paper_shredder(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let case = b.choose(&[BLACK_PLASTIC, GREY_PLASTIC]);
    let t = 0.004_f32.min(x * 0.1);
    let split = h * b.vary(0.68, 0.76);
    let wall = |s: f32| (x * s, y * s);
    let bin = if b.rng.chance(0.5) { CLEAR_PLASTIC } else { case };
    walled_tray(b, wall(0.94), (0.0, split), t, bin);
    b.inside("bin", [0.0, 0.0, t], (x * 0.94 - 2.0 * t, y * 0.94 - 2.0 * t), split - t);
    let top = h * 0.995;
    b.rounded_block("head", [-x, -y, split], [x, y, top], h * 0.04, case);
    b.block("slot", [-x * 0.12, -y * 0.75, top * 0.99], [x * 0.02, y * 0.75, top + h * 0.002], SCREEN);
    b.block("panel", [x * 0.4, -y * 0.4, top * 0.99], [x * 0.75, y * 0.4, top + h * 0.003], GREY_PLASTIC);
    b.cylinder("light", [x * 0.55, y * 0.25, top], x * 0.05, h - top, LED);
    let cord = [
        [-x * 0.9, 0.0, split + 0.02],
        mix([-x * 0.95, 0.0, split], [-x * 0.95, y * 0.3, 0.0], 0.5),
        [-x * 0.93, y * 0.4, split * 0.03],
    ];
    tube(b, "cord", &spline(&cord, 4), (x * 0.02).min(0.003), BLACK_PLASTIC);
}
