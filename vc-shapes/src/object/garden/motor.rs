//! Motorised garden tools.

use std::f32::consts::FRAC_PI_2;

use crate::material::*;
use crate::object::vehicle::wheel::{Rim, wheel};
use crate::solid::{Axis, Build, P, at_least, blob, polar, polygon, spaced};

/// A push mower: deck, motor, bag, handle, four wheels.
pub(super) fn lawnmower(b: &mut Build<'_>) {
    at_least(b, [0.6, 0.21, 0.42]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (paint, r) =
        (b.choose(&[RED_METAL, GREEN_METAL, ORANGE, YELLOW_METAL, BLACK_PLASTIC, BLUE_METAL]), h * b.vary(0.085, 0.11));
    let deck = x * b.vary(0.5, 0.58);
    let (rear, fore) = (x - 2.0 * deck + r, x - r - 0.01);
    let rim = Rim::plain(b);
    for (name, wx, side) in
        [("wheel_fl", fore, 1.0), ("wheel_fr", fore, -1.0), ("wheel_rl", rear, 1.0), ("wheel_rr", rear, -1.0)]
    {
        wheel(b, name, [wx, side * (y - y * 0.09), r], r, y * 0.16, side, rim);
    }
    for wx in [rear, fore] {
        b.rod("axle", [wx, -y * 0.85 - 0.002, r], [wx, y * 0.85 + 0.002, r], r * 0.15, IRON);
    }
    let (low, top) = (r * 0.45, r * 1.9);
    let (middle, half) = ((rear + fore) / 2.0, (fore - rear) / 2.0);
    b.taper("deck", [middle, 0.0, low], (half + r * 0.5, y * 0.8), (half, y * 0.7), top - low, paint);
    let motor = top + h * b.vary(0.1, 0.16);
    if b.rng.chance(0.5) {
        b.rounded_block(
            "motor",
            [middle - half * 0.45, -y * 0.45, top - 0.02],
            [middle + half * 0.6, y * 0.45, motor],
            0.03,
            paint,
        );
    } else {
        b.lathe(
            "motor",
            [middle + half * 0.1, 0.0, top - 0.01],
            &[(y * 0.5, 0.0), (y * 0.5, (motor - top) * 0.6), (y * 0.35, motor - top + 0.01)],
            BLACK_PLASTIC,
        );
        b.block(
            "tank",
            [middle - half * 0.3, y * 0.2, top - 0.01],
            [middle + half * 0.4, y * 0.62, motor * 0.93],
            RED_PLASTIC,
        );
    }
    let cloth = b.choose(&[BLACK_FABRIC, GREY_FABRIC, GREEN_PLASTIC]);
    let bag = [
        [rear - r * 0.9, 0.55, r * 1.1],
        [rear - r * 0.9, 0.5, motor],
        [rear - x * 0.5, 0.5, r * 0.8],
        [rear - x * 0.55, 0.45, motor * 1.05],
    ];
    b.hull(
        "bag",
        &bag.iter().flat_map(|p| [[p[0].max(-x), p[1] * y, p[2]], [p[0].max(-x), -p[1] * y, p[2]]]).collect::<Vec<P>>(),
        cloth,
    );
    b.block("chute", [rear - r * 1.0, -y * 0.45, r * 1.2], [rear + r * 0.5, y * 0.45, top * 1.1], BLACK_PLASTIC);
    let (tube, wide) = (0.012, y * 0.82);
    let grip = [-x + tube * 1.5, h - tube * 1.5];
    for side in [-1.0, 1.0] {
        b.bar(
            "handle",
            [rear, side * wide * 0.85, top * 0.8],
            [grip[0] + 0.08, side * wide, grip[1] - 0.02],
            tube,
            IRON,
        );
        b.bar(
            "handle",
            [grip[0] + 0.08, side * wide, grip[1] - 0.02],
            [grip[0], side * wide * 0.9, grip[1]],
            tube,
            IRON,
        );
    }
    b.rod("grip", [grip[0], -wide * 0.9, grip[1]], [grip[0], wide * 0.9, grip[1]], tube * 1.3, RUBBER);
    b.rod(
        "lever",
        [grip[0] + 0.05, -wide * 0.97, grip[1] - 0.026],
        [grip[0] + 0.05, wide * 0.97, grip[1] - 0.026],
        0.006,
        RED_PLASTIC,
    );
    let stay = [f32::midpoint(rear, grip[0] + 0.08), f32::midpoint(top * 0.8, grip[1] - 0.02)];
    b.rod("stay", [stay[0], -wide * 0.93, stay[1]], [stay[0], wide * 0.93, stay[1]], 0.009, IRON);
}

/// A ride-on mower: bonnet, seat, steering wheel, deck between the axles.
pub(super) fn ride_on_mower(b: &mut Build<'_>) {
    at_least(b, [0.85, 0.45, 0.5]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let paint = b.choose(&[GREEN_METAL, RED_METAL, ORANGE, YELLOW_METAL, BLUE_METAL]);
    let (big, small) = (h * b.vary(0.24, 0.27), h * b.vary(0.17, 0.19));
    let (rear, fore) = (-x + big + 0.02, x - small - 0.03);
    let rim = Rim::plain(b);
    for (name, wx, r, side) in [
        ("wheel_fl", fore, small, 1.0),
        ("wheel_fr", fore, small, -1.0),
        ("wheel_rl", rear, big, 1.0),
        ("wheel_rr", rear, big, -1.0),
    ] {
        let width = (r * 0.8).min(y * 0.4);
        wheel(b, name, [wx, side * (y * 0.86 - width / 2.0), r], r, width, side, rim);
    }
    for (wx, r) in [(rear, big), (fore, small)] {
        let end = y * 0.86 - (r * 0.8).min(y * 0.4) * 0.875 + 0.003;
        b.rod("axle", [wx, -end, r], [wx, end, r], 0.025, IRON);
    }
    let half = y * 0.42;
    let belt = big * 1.5;
    b.block("frame", [rear - big * 0.6, -half * 0.8, small], [fore + small * 0.5, half * 0.8, belt * 0.75], IRON);
    let dash = rear + (fore - rear) * 0.55;
    let hood: Vec<P> = [1.0, -1.0]
        .into_iter()
        .flat_map(|s| {
            [
                [dash, s * half, belt * 0.7],
                [dash, s * half * 0.95, h * 0.68],
                [x - 0.06, s * half * 0.85, h * 0.56],
                [x - 0.01, s * half * 0.8, small * 1.4],
                [x - 0.005, s * half * 0.75, h * 0.42],
            ]
        })
        .collect();
    b.hull("bonnet", &hood, paint);
    for side in [-1.0, 1.0] {
        b.block(
            "headlight",
            [x - 0.08, side * half * 0.5 - 0.05, h * 0.42],
            [x - 0.012, side * half * 0.5 + 0.05, h * 0.48],
            COOL_BULB,
        );
        let guard = [
            [rear - big * 0.9, belt],
            [rear - big * 0.5, big * 2.12],
            [rear + big * 0.7, big * 2.12],
            [rear + big * 1.15, belt],
        ];
        let (a, c) = (side * half * 0.7, side * y * 0.88);
        b.hull(
            "mudguard",
            &guard
                .iter()
                .flat_map(|p| [[p[0], a, p[1] + 0.03], [p[0], c, p[1] + 0.03], [p[0], a, p[1] + 0.05]])
                .filter(|p| p[2] > big * 2.0)
                .chain([[rear - big * 0.5, a, big * 2.1], [rear + big * 0.7, a, big * 2.1]])
                .collect::<Vec<P>>(),
            paint,
        );
    }
    b.block("base", [rear - big * 0.7, -half * 0.75, belt * 0.7], [rear + big * 0.8, half * 0.75, big * 2.14], paint);
    let seat = (big * 2.14 + 0.02).max(h * 0.55);
    b.block("post", [rear - 0.06, -0.1, big * 2.1], [rear + 0.1, 0.1, seat - 0.02], IRON);
    b.rounded_block(
        "seat",
        [rear - big * 0.3, -half * 0.75, seat - 0.03],
        [rear + big * 0.85, half * 0.75, seat + 0.05],
        0.04,
        BLACK_LEATHER,
    );
    b.rounded_block(
        "back",
        [rear - big * 0.55, -half * 0.7, seat],
        [rear - big * 0.2, half * 0.7, h],
        0.05,
        BLACK_LEATHER,
    );
    let hub = [dash - 0.12, 0.0, h * 0.82];
    let hold = ((h * 0.18 - 0.02) / 0.6).clamp(0.03, 0.15);
    let room = (big * 0.7).min(hub[0] - hold - 0.02 - rear).max(0.04);
    b.top("seat", [rear + room / 2.0, 0.0, seat + 0.05], (room / 2.0, half * 0.55));
    b.rod("column", [dash + 0.02, 0.0, h * 0.62], hub, 0.018, IRON);
    b.lathe_along(
        "steering_wheel",
        hub,
        [hub[0] - 0.6, hub[1], hub[2] + 0.8],
        &[(hold, 0.0), (hold, 0.02), (hold * 0.8, 0.02), (hold * 0.8, 0.0), (hold, 0.0)],
        BLACK_PLASTIC,
    );
    let across = hold * 0.87;
    b.rod("steering_wheel", [hub[0], -across, hub[2]], [hub[0], across, hub[2]], 0.01, BLACK_PLASTIC);
    let (d0, d1) = (rear + big * 1.05, fore - small * 1.1);
    b.taper(
        "deck",
        [(d0 + d1) / 2.0, 0.0, small * 0.45],
        ((d1 - d0) / 2.0, y),
        ((d1 - d0) / 2.0 * 0.85, y * 0.85),
        small * 0.7,
        paint,
    );
    b.block("footplate", [d0, -y * 0.8, small * 1.16], [d1, y * 0.8, small * 1.26], GREY_RUBBER);
    b.block("link", [d0, -half * 0.7, small * 1.1], [d1, half * 0.7, belt * 0.72], IRON);
}

/// A robot mower: a rounded shell on wheels.
pub(super) fn robot_mower(b: &mut Build<'_>) {
    at_least(b, [0.25, 0.18, 0.1]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (paint, r) = (
        b.choose(&[GREY_PLASTIC, ORANGE_PLASTIC, GREEN_PLASTIC, WHITE_PLASTIC, BLACK_PLASTIC]),
        h * b.vary(0.36, 0.42),
    );
    let rim = Rim::plain(b);
    let rear = -x + r + x * 0.15;
    for (name, side) in [("wheel_l", 1.0), ("wheel_r", -1.0)] {
        wheel(b, name, [rear, side * (y - y * 0.1), r], r, y * 0.2, side, rim);
    }
    b.rod("axle", [rear, -y * 0.85, r], [rear, y * 0.85, r], 0.012, IRON);
    let low = h * 0.16;
    b.taper("body", [0.0, 0.0, low], (x * 0.9, y * 0.76), (x * 0.85, y * 0.72), h * 0.4, BLACK_PLASTIC);
    let rows = [(0.98, 0.76, 0.42), (1.0, 0.78, 0.55), (0.8, 0.66, 0.85), (0.45, 0.45, 0.97)];
    let shell: Vec<P> = rows
        .into_iter()
        .flat_map(|(sx, sy, z)| {
            polygon(12, 1.0, 0.26)
                .into_iter()
                .map(move |(px, py)| [(px * 1.0353 * x * sx).clamp(-x, x), py * 1.0353 * y * sy, h * z])
        })
        .collect();
    b.hull("shell", &shell, paint);
    b.rod("button", [x * 0.05, 0.0, h * 0.95], [x * 0.05, 0.0, h], 0.035_f32.min(y * 0.25), SIGNAL_RED);
    b.block("panel", [-x * 0.35, -y * 0.25, h * 0.95], [-x * 0.1, y * 0.25, h * 0.982], SCREEN);
    for side in [-1.0, 1.0] {
        let at = [x * 0.65, side * y * 0.4, low];
        b.ball("caster", [at[0], at[1], low * 0.75], low * 0.75, RUBBER);
        b.cylinder("caster", [at[0], at[1], low * 0.8], 0.012, low, IRON);
    }
}

/// A hedge trimmer standing on its handles: a motor and a toothed bar.
pub(super) fn hedge_trimmer(b: &mut Build<'_>) {
    at_least(b, [0.07, 0.09, 0.4]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let paint = b.choose(&[ORANGE_PLASTIC, GREEN_PLASTIC, RED_PLASTIC, BLUE_PLASTIC, YELLOW_PLASTIC]);
    let body = h * b.vary(0.36, 0.42);
    let thin = (y * 0.12).min(0.016);
    b.rounded_block("motor", [-x * 0.75, -y * 0.45, h * 0.16], [x * 0.75, y * 0.45, body], 0.03, paint);
    b.pipe(
        "rear_grip",
        &[
            [-x * 0.6, 0.0, h * 0.18],
            [-x + thin * 1.3, 0.0, thin * 1.5],
            [x - thin * 1.3, 0.0, thin * 1.5],
            [x * 0.6, 0.0, h * 0.18],
        ],
        thin,
        BLACK_PLASTIC,
    );
    let z = body * 0.92;
    b.pipe(
        "front_grip",
        &[
            [x * 0.3, -y * 0.4, z],
            [x * 0.3, -y + thin * 1.4, z + 0.02],
            [x - thin * 1.5, -y + thin * 1.4, z + 0.03],
            [x - thin * 1.5, y - thin * 1.4, z + 0.03],
            [x * 0.3, y - thin * 1.4, z + 0.02],
            [x * 0.3, y * 0.4, z],
        ],
        thin,
        BLACK_PLASTIC,
    );
    b.block("bar", [-0.006, -0.016, body - 0.01], [0.006, 0.016, h], STEEL);
    let teeth = b.rng.count(10, 16);
    for tz in spaced(teeth, body + 0.05, h - 0.012) {
        b.block("tooth", [-0.004, -y * 0.42, tz - 0.005], [0.004, y * 0.42, tz + 0.005], STEEL);
    }
    b.block("shield", [-x * 0.6, -y * 0.85, body * 0.98], [-x * 0.6 + 0.006, y * 0.85, body * 1.15], CLEAR_PLASTIC);
    b.block("link", [-x * 0.61, -0.02, body * 0.9], [0.0, 0.02, body * 1.02], BLACK_PLASTIC);
}

/// A grass trimmer standing on its head: a guard, a shaft, a loop, a motor on top.
pub(super) fn grass_trimmer(b: &mut Build<'_>) {
    at_least(b, [0.1, 0.11, 0.5]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let paint = b.choose(&[ORANGE_PLASTIC, GREEN_PLASTIC, RED_PLASTIC, YELLOW_PLASTIC]);
    let r = x.min(y);
    let cut: Vec<(f32, f32)> = (0..=10)
        .map(|i| FRAC_PI_2 * (1.0 + 0.2 * i as f32))
        .map(|a| polar(a, r * 0.98))
        .chain([(0.0, -r * 0.98), (0.02, 0.0)])
        .collect();
    b.prism("guard", Axis::Z, [0.0, 0.0, 0.03], &cut, 0.02, BLACK_PLASTIC);
    b.cylinder("spool", [0.0; 3], r * 0.35, 0.055, BLACK_PLASTIC);
    b.rod("line", [0.0, 0.0, 0.012], [x - 0.004, 0.0, 0.012], 0.0015, ORANGE_PLASTIC);
    let (top, thin) = (h * b.vary(0.8, 0.86), 0.012);
    let back = -x * 0.35;
    b.bar("shaft", [0.0, 0.0, 0.06], [back, 0.0, top], thin, ALUMINIUM);
    b.rounded_block("motor", [back - x * 0.45, -y * 0.4, top - 0.03], [back + x * 0.45, y * 0.4, h], 0.03, paint);
    let z = h * b.vary(0.5, 0.62);
    let at = back * z / top;
    let loop_r = (y * 0.8).min(0.11);
    b.pipe(
        "loop",
        &[
            [at, -0.01, z],
            [at + x * 0.2, -loop_r, z + 0.02],
            [at + x * 0.55, -loop_r * 0.8, z + 0.1],
            [at + x * 0.55, loop_r * 0.8, z + 0.1],
            [at + x * 0.2, loop_r, z + 0.02],
            [at, 0.01, z],
        ],
        thin * 0.8,
        BLACK_PLASTIC,
    );
    b.rod("grip", [back * 0.88, 0.0, top * 0.86], [back, 0.0, top], thin * 1.6, RUBBER);
}

/// A leaf blower standing on the mouth of its tube.
pub(super) fn leaf_blower(b: &mut Build<'_>) {
    at_least(b, [0.07, 0.09, 0.4]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let paint = b.choose(&[ORANGE_PLASTIC, GREEN_PLASTIC, RED_PLASTIC, BLUE_PLASTIC, YELLOW_PLASTIC]);
    let body = h * b.vary(0.6, 0.66);
    let tube = x.min(y) * b.vary(0.32, 0.42);
    let at = x - tube * 1.35;
    b.lathe("tube", [at, 0.0, 0.0], &[(tube * 1.3, 0.0), (tube, h * 0.12), (tube * 1.1, body + 0.03)], BLACK_PLASTIC);
    b.rod(
        "housing",
        [at - x * 0.4, -y * 0.8, body + (h - body) * 0.4],
        [at - x * 0.4, y * 0.6, body + (h - body) * 0.4],
        ((h - body) * 0.4).min(x * 0.58),
        paint,
    );
    b.rod(
        "grille",
        [at - x * 0.4, y * 0.59, body + (h - body) * 0.4],
        [at - x * 0.4, y, body + (h - body) * 0.4],
        ((h - body) * 0.28).min(x * 0.4),
        BLACK_PLASTIC,
    );
    b.rounded_block(
        "motor",
        [at - x * 0.3, -y * 0.5, body],
        [at + tube * 0.7, y * 0.4, body + (h - body) * 0.75],
        0.02,
        paint,
    );
    let thin = (tube * 0.4).min(0.016);
    b.pipe(
        "handle",
        &[
            [at, 0.0, body + (h - body) * 0.7],
            [at, 0.0, h - thin * 1.1],
            [at - x * 0.7, 0.0, h - thin * 1.1],
            [at - x * 0.7, 0.0, body + (h - body) * 0.55],
        ],
        thin,
        BLACK_PLASTIC,
    );
}

/// A chainsaw lying on its base, its bar along Y.
pub(super) fn chainsaw(b: &mut Build<'_>) {
    at_least(b, [0.1, 0.3, 0.11]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let paint = b.choose(&[ORANGE, RED_METAL, YELLOW_METAL, GREEN_METAL]);
    let split = -y + 2.0 * y * b.vary(0.46, 0.52);
    let back = -y + 2.0 * y * 0.2;
    b.rounded_block("motor", [-x * 0.85, back, 0.0], [x * 0.6, split, h * 0.72], 0.03, paint);
    b.block("cover", [x * 0.58, back + 0.03, h * 0.08], [x * 0.85, split + 0.02, h * 0.5], BLACK_PLASTIC);
    let (z, half) = (h * 0.33, h * b.vary(0.13, 0.17));
    let bar = [
        (split - 0.02, z - half),
        (y - half, z - half),
        (y - half * 0.35, z - half * 0.7),
        (y, z),
        (y - half * 0.35, z + half * 0.7),
        (y - half, z + half),
        (split - 0.02, z + half),
    ];
    let chain: Vec<(f32, f32)> =
        bar.iter().map(|&(py, pz)| ((py - if py > split { half * 0.16 } else { 0.0 }), z + (pz - z) * 0.82)).collect();
    b.prism("chain", Axis::X, [x * 0.66, 0.0, 0.0], &bar, 0.006, IRON);
    b.prism("bar", Axis::X, [x * 0.66 - 0.002, 0.0, 0.0], &chain, 0.01, STEEL);
    let thin = (h * 0.05).min(0.014);
    b.pipe(
        "front_grip",
        &[
            [-x * 0.7, split - 0.05, h * 0.2],
            [-x + thin * 1.3, split - 0.05, h * 0.6],
            [-x * 0.6, split - 0.03, h - thin * 1.1],
            [x * 0.45, split - 0.02, h - thin * 1.1],
            [x * 0.5, split - 0.03, h * 0.6],
        ],
        thin,
        BLACK_PLASTIC,
    );
    b.pipe(
        "rear_grip",
        &[
            [0.0, back + 0.02, h * 0.62],
            [0.0, -y + thin * 2.0, h * 0.5],
            [0.0, -y + thin * 1.3, h * 0.1 + thin],
            [0.0, back + 0.02, h * 0.1 + thin],
        ],
        thin * 1.1,
        BLACK_PLASTIC,
    );
    b.block("hand_guard", [-x * 0.7, split + 0.006, h * 0.6], [x * 0.45, split + 0.014, h * 0.92], BLACK_PLASTIC);
    b.block("hand_guard", [-x * 0.3, split - 0.02, h * 0.55], [x * 0.2, split + 0.012, h * 0.66], BLACK_PLASTIC);
    let points = blob(b, [0.0, back + 0.05, h * 0.72], [x * 0.25, 0.03, h * 0.05], 12, 0.1);
    b.hull("cap", &points, BLACK_PLASTIC);
}
