//! Small training equipment.

use std::f32::consts::PI;

use vc_graph::portable::Portable;

use crate::material::*;
use crate::object::palette::*;
use crate::solid::{Axis, Build, Proportional, SIDES, arc_outline, oval_outline, rounded_between};

/// A dumbbell: hexagonal heads, round ones, or plates on a bar, lying along Y.
pub(super) fn dumbbell(b: &mut Build<'_>) {
    let r = b.size.x.min(b.size.z) / 2.0;
    let half = b.size.y / 2.0;
    let head = (half * 0.42).max(half - 0.075);
    let mat = b.choose(&[RUBBER, BLACK_PLASTIC, BLUE_PLASTIC, PINK_PLASTIC, GREY_PLASTIC, PURPLE_PLASTIC]);
    let design = b.rng.below(3);
    let z = if design == 0 { r * 0.866 } else { r };
    for y in SIDES {
        let (inner, outer) = (y * (half - head), y * half);
        match design {
            0 => {
                let outline: Vec<_> = oval_outline((0.0, z), (r, r), 6);
                b.prism("head", Axis::Y, [0.0, inner.min(outer), 0.0], &outline, head * 0.93, mat);
                b.rod("cap", [0.0, inner, z], [0.0, outer, z], r * 0.6, mat);
            }
            1 => {
                let shape = [(r * 0.75, 0.0), (r, head * 0.2), (r, head * 0.8), (r * 0.75, head)];
                b.lathe_along("head", [0.0, inner, z], [0.0, outer, z], &shape, mat);
                b.rod("cap", [0.0, inner, z], [0.0, outer * 0.997, z], r * 0.5, STEEL);
            }
            _ => {
                for (i, share) in [1.0, 0.9, 0.72].into_iter().enumerate() {
                    let at = inner + y * head * (0.1 + 0.22 * i as f32);
                    b.rod("plate", [0.0, at, z], [0.0, at + y * head * 0.2, z], r * share, IRON);
                }
                b.rod("collar", [0.0, outer - y * head * 0.2, z], [0.0, outer - y * head * 0.05, z], r * 0.35, CHROME);
            }
        }
    }
    let grip = (r * 0.3).min(0.017);
    b.rod("grip", [0.0, -half * 0.98, z], [0.0, half * 0.98, z], grip, CHROME);
    b.rod("knurl", [0.0, head - half, z], [0.0, half - head, z], grip * 1.12, STEEL);
}

/// A kettlebell: a ball with a flat base and a thick handle.
pub(super) fn kettlebell(b: &mut Build<'_>) {
    let mat = b.choose(&[IRON, RUBBER, RED_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let ball = r.min(h * 0.36);
    let middle = ball * 0.92;
    let foot = (ball * ball - middle * middle).max(0.0).sqrt().max(ball * 0.35);
    let profile: Vec<_> = std::iter::once((foot, 0.0))
        .chain((0..9).map(|i| {
            let (s, c) = (-1.0 + 2.57 * i as f32 / 8.0_f32).sine_cosine();
            (ball * c, middle + ball * s)
        }))
        .collect();
    b.lathe("body", [0.0; 3], &profile, mat);
    let grip = (h * 0.075).min(r * 0.24);
    let (y, top) = (r - grip, h - grip);
    let bow = [
        [0.0, -ball * 0.5, middle + ball * 0.7],
        [0.0, -y * 0.9, top - h * 0.16],
        [0.0, -y * 0.66, top],
        [0.0, y * 0.66, top],
        [0.0, y * 0.9, top - h * 0.16],
        [0.0, ball * 0.5, middle + ball * 0.7],
    ];
    b.pipe("handle", &bow, grip, if mat == IRON { IRON } else { CHROME });
    b.rod("badge", [0.0, 0.0, middle], [ball * 1.005, 0.0, middle], ball * 0.4, WHITE_PLASTIC);
}

/// A barbell bar with sleeves.
pub(super) fn barbell(b: &mut Build<'_>) {
    let (r, half) = (b.size.x.min(b.size.z) / 2.0, b.size.y / 2.0);
    let (thin, sleeve) = (r * 0.56, half * 0.38);
    b.rod("bar", [0.0, -half * 0.99, r], [0.0, half * 0.99, r], thin, STEEL);
    for y in SIDES {
        b.rod("sleeve", [0.0, y * (half - sleeve), r], [0.0, y * half, r], r * 0.95, CHROME);
        b.rod("collar", [0.0, y * (half - sleeve), r], [0.0, y * (half - sleeve + 0.03), r], r, STEEL);
        b.rod("knurl", [0.0, y * half * 0.15, r], [0.0, y * half * 0.45, r], thin * 1.08, GREY_PLASTIC);
    }
}

/// A weight plate standing on its rim.
pub(super) fn weight_plate(b: &mut Build<'_>) {
    let (r, half) = (b.size.y.min(b.size.z) / 2.0, b.size.x / 2.0);
    let (mat, ring) = (
        b.choose(&[RUBBER, IRON, RED_RUBBER, BLUE_PLASTIC, YELLOW_PLASTIC, GREEN_PLASTIC]),
        b.choose(&[WHITE_PLASTIC, STEEL, GREY_PLASTIC]),
    );
    let bore = (r * 0.2).min(0.026);
    let profile = [
        (bore, -half * 0.6),
        (r * 0.3, -half),
        (r * 0.4, -half * 0.6),
        (r * 0.85, -half * 0.55),
        (r * 0.9, -half),
        (r, -half * 0.8),
        (r, half * 0.8),
        (r * 0.9, half),
        (r * 0.85, half * 0.55),
        (r * 0.4, half * 0.6),
        (r * 0.3, half),
        (bore, half * 0.6),
        (bore, -half * 0.6),
    ];
    b.lathe_along("plate", [0.0, 0.0, r], [1.0, 0.0, r], &profile, mat);
    let wide = [
        (r * 0.55, -half * 0.66),
        (r * 0.62, -half * 0.66),
        (r * 0.62, half * 0.66),
        (r * 0.55, half * 0.66),
        (r * 0.55, -half * 0.66),
    ];
    b.lathe_along("ring", [0.0, 0.0, r], [1.0, 0.0, r], &wide, ring);
}

/// An exercise mat, spread out or with one end still curled.
pub(super) fn yoga_mat(b: &mut Build<'_>) {
    let mat = b.choose(&[PURPLE_PLASTIC, TEAL_FABRIC, BLUE_FABRIC, PINK_PLASTIC, GREY_FABRIC, GREEN_FABRIC]);
    let line = b.choose(&[WHITE_PLASTIC, GREY_PLASTIC, CORK]);
    let h = (b.size.z * 0.8).max(b.size.z - 0.0015);
    let share = h / b.size.z;
    b.plan_outline("mat", (0.0, share), &rounded_between((-1.0, -1.0), (1.0, 1.0), (0.02, 0.06)), mat);
    for x in SIDES {
        b.slab("border", [x * 0.94 - 0.004, -0.9, share * 0.5], [x * 0.94 + 0.004, 0.9, 1.0], line);
    }
    b.slab("line", [-0.9, -0.01, share * 0.5], [0.9, 0.01, 0.5 + share / 2.0], line);
    b.deck("mat", [0.0, 0.0, 1.0], (0.95, 0.95));
}

/// A yoga block of foam or cork with rounded edges.
pub(super) fn yoga_block(b: &mut Build<'_>) {
    let mat = b.choose(&[CORK, PURPLE_PLASTIC, TEAL_FABRIC, GREY_FABRIC, ROSE_FABRIC, BLUE_FABRIC]);
    let round = b.size.z * b.vary(0.06, 0.2);
    b.pad("block", [-1.0, -1.0, 0.0], [1.0, 1.0, 0.985], round, mat);
    b.slab("label", [-0.4, -0.3, 0.97], [0.4, 0.3, 1.0], b.style.accent);
}

/// A foam roller, ribbed or smooth, hollow at its ends.
pub(super) fn foam_roller(b: &mut Build<'_>) {
    let (r, half) = (b.size.x.min(b.size.z) / 2.0, b.size.y / 2.0);
    let (mat, core) = (b.one_of(BRIGHT), BLACK_PLASTIC);
    let (ribbed, hole) = (b.rng.chance(0.6), r * 0.62);
    let body = if ribbed { r * 0.9 } else { r };
    let wall = [(hole, -half), (body, -half), (body, half), (hole, half), (hole, -half)];
    let middle = [0.0, 0.0, r];
    b.lathe_along("foam", middle, [0.0, 1.0, r], &wall, mat);
    let tube = [
        (hole * 0.9, -half * 0.99),
        (hole * 1.02, -half * 0.99),
        (hole * 1.02, half * 0.99),
        (hole * 0.9, half * 0.99),
        (hole * 0.9, -half * 0.99),
    ];
    b.lathe_along("core", middle, [0.0, 1.0, r], &tube, core);
    if ribbed {
        let count = (half / 0.03).clamp(4.0, 12.0) as usize;
        for i in 0..count {
            let y = half * (-1.0 + (2.0 * i as f32 + 1.0) / count as f32);
            let wide = half / count as f32 * 0.7;
            let rib = [
                (body * 0.98, y - wide),
                (r, y - wide * 0.7),
                (r, y + wide * 0.7),
                (body * 0.98, y + wide),
                (body * 0.98, y - wide),
            ];
            b.lathe_along("rib", middle, [0.0, 1.0, r], &rib, mat);
        }
    }
}

/// A hanging resistance band: a loop of rubber, or a tube with two handles.
pub(super) fn resistance_band(b: &mut Build<'_>) {
    let mat = b.one_of(BRIGHT);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let flat = b.rng.chance(0.5);
    let t = (y * 0.12).min(0.006);
    if flat {
        for (low, high) in [(0.0, PI), (PI, 2.0 * PI)] {
            let middle = |r: f32| arc_outline((0.0, if low > 0.0 { y } else { h - y }), (r, r), (low, high), 9);
            let half: Vec<_> = middle(y).into_iter().chain(middle(y - t).into_iter().rev()).collect();
            b.prism("bend", Axis::X, [-x, 0.0, 0.0], &half, 2.0 * x, mat);
        }
        for s in SIDES {
            b.block("band", [-x, (s * y).min(s * (y - t)), y], [x, (s * y).max(s * (y - t)), h - y], mat);
        }
        return;
    }
    let r = (x * 0.35).min(y * 0.12);
    for s in SIDES {
        b.rod("tube", [0.0, s * y * 0.6, h * 0.3], [0.0, s * y * 0.35, h - y * 0.4], r, mat);
        b.rod("strap", [0.0, s * y * 0.6, h * 0.32], [0.0, s * y * 0.25, h * 0.12], r * 0.8, BLACK_FABRIC);
        b.rod("strap", [0.0, s * y * 0.6, h * 0.32], [0.0, s * y * 0.92, h * 0.12], r * 0.8, BLACK_FABRIC);
        let grip = (x * 0.9).min(h * 0.06);
        b.rod("handle", [0.0, s * y * 0.2, grip], [0.0, s * y, grip], grip, RUBBER);
        b.rod("strap", [0.0, s * y * 0.3, grip], [0.0, s * y * 0.3, h * 0.14], r * 0.8, BLACK_FABRIC);
        b.rod("strap", [0.0, s * y * 0.9, grip], [0.0, s * y * 0.9, h * 0.14], r * 0.8, BLACK_FABRIC);
    }
    b.rod("tube", [0.0, -y * 0.36, h - y * 0.4 - r], [0.0, y * 0.36, h - y * 0.4 - r], r, mat);
    b.block("anchor", [-x, -y * 0.3, h - y * 0.5 - r * 2.0], [x, y * 0.3, h], BLACK_FABRIC);
}

/// A coiled skipping rope with its two handles on top.
pub(super) fn skipping_rope(b: &mut Build<'_>) {
    let (rope, grip) = (
        b.choose(&[BLACK_PLASTIC, RED_PLASTIC, WHITE_COTTON, JUTE, BLUE_PLASTIC]),
        b.choose(&[BEECH, BLACK_PLASTIC, RED, BLUE]),
    );
    let r = (b.size.z * 0.13).min(b.size.x * 0.06);
    let ring = b.size.x / 2.0 - r;
    for i in 0..3 {
        let z = (r + 1.7 * r * i as f32) / b.size.z;
        b.torus("coil", Axis::Z, [0.0, 0.08 * (i as f32 - 1.0), z], (ring - r * 0.4 * i as f32, r), rope);
    }
    let thick = (b.size.z - 5.6 * r).max(b.size.z * 0.2) / 2.0;
    for (x, tilt) in [(-0.3, 0.15), (0.35, -0.1)] {
        let z = (5.2 * r + thick * 0.9) / b.size.z;
        b.pole("handle", [x - tilt, -0.96, z], [x + tilt, 0.75, z], thick * 0.9, grip);
        b.pole("end", [x + tilt * 0.98, 0.73, z], [x + tilt * 1.05, 0.9, z], thick * 0.5, rope);
    }
}

/// A hand gripper: a spring between two grips.
pub(super) fn hand_gripper(b: &mut Build<'_>) {
    let (mat, r) = (b.one_of(BRIGHT), b.size.x / 2.0);
    let ring = r * 0.9;
    b.torus("spring", Axis::X, [0.0, 0.0, 1.0 - ring * 1.3 / b.size.z], (ring, ring * 0.28), STEEL);
    b.torus("spring", Axis::X, [0.4, 0.0, 1.0 - ring * 1.3 / b.size.z], (ring, ring * 0.28), STEEL);
    let grip = (b.size.y * 0.13).min(r);
    let edge = 1.0 - 2.0 * grip / b.size.y;
    for y in SIDES {
        b.pole(
            "wire",
            [0.0, y * ring * 0.9 / b.size.y * 2.0, 1.0 - ring * 1.3 / b.size.z],
            [0.0, y * edge * 0.8, 0.6],
            r * 0.25,
            STEEL,
        );
        b.plank("grip", [0.0, y * edge * 0.75, 0.65], [0.0, y * edge * 0.95, 0.02], (grip * 1.5, grip * 1.5), mat);
    }
}

/// An ab wheel: one or two wheels on an axle with grips.
pub(super) fn ab_wheel(b: &mut Build<'_>) {
    let (mat, r) = (b.one_of(BRIGHT), b.size.x.min(b.size.z) / 2.0);
    let half = b.size.y / 2.0;
    let grip = (r * 0.2).min(0.018);
    let double = b.rng.chance(0.5);
    for y in if double { vec![-half * 0.12, half * 0.12] } else { vec![0.0] } {
        let wide = half * if double { 0.08 } else { 0.12 };
        let wheel = [(r * 0.9, -wide), (r, -wide * 0.6), (r, wide * 0.6), (r * 0.9, wide)];
        b.lathe_along("tyre", [0.0, y, r], [0.0, y + 1.0, r], &wheel, RUBBER);
        b.rod("hub", [0.0, y - wide * 1.15, r], [0.0, y + wide * 1.15, r], r * 0.72, mat);
    }
    b.rod("axle", [0.0, -half * 0.97, r], [0.0, half * 0.97, r], grip * 0.5, STEEL);
    for y in SIDES {
        b.rod("grip", [0.0, y * half * 0.35, r], [0.0, y * half, r], grip, BLACK_FABRIC);
    }
}

/// A pair of push-up bars: handles on feet.
pub(super) fn push_up_bars(b: &mut Build<'_>) {
    let (mat, r) = (b.choose(&[BLACK_PLASTIC, STEEL, RED_PLASTIC]), (b.size.z * 0.12).min(0.017));
    for x in SIDES.map(|s| s * 0.5) {
        b.pole("grip", [x, -0.72, 1.0 - r / b.size.z], [x, 0.72, 1.0 - r / b.size.z], r, RUBBER);
        for y in SIDES {
            b.plank("leg", [x, y * 0.68, 0.98], [x, y * 0.86, 0.04], (r * 1.3, r * 1.3), mat);
            b.pad("foot", [x - 0.46, y * 0.9 - 0.1, 0.0], [x + 0.46, y * 0.9 + 0.1, 0.1], 0.004, RUBBER);
        }
    }
}

/// A stopwatch lying on its back with its knob to the front.
pub(super) fn stopwatch(b: &mut Build<'_>) {
    let case = b.choose(&[CHROME, BLACK_PLASTIC, YELLOW_PLASTIC]);
    let r = b.size.y.min(b.size.z * 0.84) / 2.0;
    let half = b.size.x / 2.0;
    let body = [(r * 0.9, -half), (r, -half * 0.4), (r, half * 0.4), (r * 0.9, half * 0.7)];
    b.lathe_along("case", [0.0, 0.0, r], [1.0, 0.0, r], &body, case);
    b.rod("dial", [0.0, 0.0, r], [half * 0.85, 0.0, r], r * 0.82, WHITE_PAPER);
    for i in 0..12 {
        let (s, c) = (PI * i as f32 / 6.0).sine_cosine();
        let at = |d: f32| [half * 0.86, r * d * s, r + r * d * c];
        b.rod("mark", at(0.68), at(0.78), half * 0.05, BLACK_PLASTIC);
    }
    b.rod("hand", [half * 0.92, 0.0, r], [half * 0.92, r * 0.4, r * 1.5], half * 0.07, RED_PLASTIC);
    let top = b.size.z;
    b.rod("knob", [0.0, 0.0, r * 1.9], [0.0, 0.0, top], (r * 0.2).min(half * 0.9), case);
    b.rod("knob", [0.0, r * 0.62, r * 1.66], [0.0, r * 0.78, (r * 1.85).min(top)], (r * 0.12).min(half * 0.8), case);
}

/// A flying disc with its rim down.
pub(super) fn frisbee(b: &mut Build<'_>) {
    let (mat, print) = (b.one_of(BRIGHT), b.choose(&[WHITE_PLASTIC, YELLOW_PLASTIC, BLACK_PLASTIC]));
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let t = h * 0.14;
    let shape = [
        (r * 0.96, 0.0),
        (r, h * 0.2),
        (r * 0.97, h * 0.6),
        (r * 0.85, h * 0.9),
        (r * 0.5, h * 0.98),
        (0.0, h * 0.98),
        (0.0, h - 2.0 * t),
        (r * 0.83, h * 0.9 - 2.0 * t),
        (r * 0.92, 0.0),
        (r * 0.96, 0.0),
    ];
    b.lathe("disc", [0.0; 3], &shape, mat);
    let ring = [(r * 0.3, h * 0.96), (r * 0.45, h * 0.96), (r * 0.45, h), (r * 0.3, h), (r * 0.3, h * 0.96)];
    b.lathe("print", [0.0; 3], &ring, print);
    b.cylinder("print", [0.0, 0.0, h * 0.95], r * 0.14, h * 0.05, print);
}
