//! Chairs that rock, fold or lift a child to the table.

use super::chair::Chair;
use crate::material::*;
use crate::object::table::frame::Lean;
use crate::solid::{Axis, Build, CORNERS, Cut, at_least, leg, ribbon};

/// A chair with arms and a spindle back on two bent runners.
pub(super) fn rocking_chair(b: &mut Build<'_>) {
    let mut c = Chair::new(b);
    c.seat = (c.h * 0.42).min(0.44);
    c.rake = (c.x * 0.3).min((c.h - c.seat) * 0.4);
    let (r, lift) = (c.post * 0.42, c.h * 0.035);
    let (front, rear) = (c.x * 0.55, -c.x * 0.55 + c.rake * 0.2);
    let runner = |x: f32| lift * (x / c.x) * (x / c.x);
    // At its ends the runner's underside extends further than its upper side.
    let end = c.x - 4.0 * r * lift / c.x - 0.004;
    for side in [-1.0, 1.0] {
        let y = side * (c.y - r);
        let line: Vec<(f32, f32)> = (0..=8)
            .map(|i| {
                let x = end * (1.0 - i as f32 / 4.0);
                (x, runner(x) + 2.0 * r)
            })
            .collect();
        ribbon(b, "runner", &line, 2.0 * r * 0.98, (y - r, y + r), c.wood);
        let arm = c.seat + (c.h - c.seat) * 0.36;
        leg(b, "leg", ([front, y, runner(front) + r], r), ([front, y, arm - 0.02], r * 0.9), Cut::Round, c.wood);
        leg(b, "leg", ([rear, y, runner(rear) + r], r), ([rear + 0.02, y, c.seat], r), Cut::Round, c.wood);
        let back = -c.x + c.rake * 0.7;
        b.rounded_block("arm", [back, y - r, arm - 0.022], [front + 0.04, y + r, arm], 0.009, c.wood);
        leg(b, "post", ([rear, y * 0.96, c.seat - 0.03], r), ([-c.x + r, y * 0.96, c.h], r * 0.9), Cut::Round, c.wood);
    }
    let (z, half) = (c.seat, c.y - 2.0 * r);
    let t = 0.03_f32.min(c.seat * 0.1);
    b.rounded_block("seat", [rear - 0.03, -c.y + r * 0.6, z - t], [front + 0.02, c.y - r * 0.6, z], 0.01, c.wood);
    b.rod("rung", [front, -half, z * 0.5], [front, half, z * 0.5], r * 0.6, c.wood);
    b.rod("rung", [rear + 0.01, -half, z * 0.45], [rear + 0.01, half, z * 0.45], r * 0.6, c.wood);
    let x = |h: f32| rear + (r - c.x - rear) * ((h - z) / (c.h - z));
    let crest = c.h - (c.h - z) * 0.12;
    let count = b.rng.count(5, 8);
    for i in 0..count {
        let y = half * 0.9 * (2.0 * (i as f32 + 0.5) / count as f32 - 1.0);
        b.rod("spindle", [x(z - 0.01), y, z - 0.01], [x(crest), y, crest + 0.01], r * 0.4, c.wood);
    }
    let outline = [
        (x(crest) - r * 0.8, crest),
        (x(crest) + r * 0.8, crest),
        (x(c.h) + r * 0.8, c.h - 0.002),
        (x(c.h) - r * 0.8, c.h - 0.002),
    ];
    b.prism("crest", Axis::Y, [0.0, -half - r, 0.0], &outline, 2.0 * (half + r), c.wood);
    if b.rng.chance(0.6) {
        b.rounded_block(
            "cushion",
            [rear + 0.03, -half * 0.92, z],
            [front - 0.01, half * 0.92, z + 0.045],
            0.02,
            c.cloth,
        );
    }
}

/// A chair whose legs cross and swing together.
pub(super) fn folding_chair(b: &mut Build<'_>) {
    let c = Chair::new(b);
    let metal = b.rng.chance(0.5);
    let frame = if metal { b.choose(&[BLACK_METAL, GALVANISED, WHITE_METAL]) } else { c.wood };
    let seat = if metal { b.choose(&[frame, BLACK_PLASTIC, c.cloth]) } else { c.wood };
    let r = if metal { 0.01 } else { c.post * 0.36 };
    let cut = if metal { Cut::Round } else { Cut::Square };
    for side in [-1.0, 1.0] {
        let (outer, inner) = (side * (c.y - r), side * (c.y - 3.2 * r));
        leg(b, "leg", ([c.x - r, outer, 0.0], r), ([r - c.x, outer, c.h], r), cut, frame);
        leg(b, "leg", ([r - c.x, inner, 0.0], r), ([c.x * 0.7, inner, c.seat - 0.02], r), cut, frame);
    }
    b.rod("rung", [c.x * 0.86, r - c.y, c.h * 0.08], [c.x * 0.86, c.y - r, c.h * 0.08], r * 0.8, frame);
    b.rod(
        "rung",
        [-c.x * 0.82, 3.0 * r - c.y, c.seat * 0.12],
        [-c.x * 0.82, c.y - 3.0 * r, c.seat * 0.12],
        r * 0.8,
        frame,
    );
    let y = c.y - 2.0 * r - 0.002;
    // The point where the legs, which run from the front foot to the top of the back, pass the
    // seat.
    let pass = c.x - r - 2.0 * (c.x - r) * (c.seat / c.h);
    let from = pass - 0.03;
    if metal || b.rng.chance(0.4) {
        b.rounded_block("seat", [from, -y, c.seat - 0.025], [c.x * 0.95, y, c.seat], 0.01, seat);
    } else {
        let pitch = (c.x * 0.95 - from) / 5.0;
        for i in 0..5 {
            let x = from + pitch * i as f32;
            b.block("slat", [x, -y, c.seat - 0.018], [x + pitch * 0.86, y, c.seat], seat);
        }
        for side in [-1.0_f32, 1.0] {
            let cy = side * (y - 0.015);
            b.block("rail", [from + 0.01, cy - 0.01, c.seat - 0.04], [c.x * 0.9, cy + 0.01, c.seat - 0.017], seat);
        }
    }
    let (first, last) = (pass + r * 2.0 + 0.02, c.x * 0.93);
    b.top("seat", [f32::midpoint(first, last), 0.0, c.seat], ((last - first) / 2.0, y - 0.01));
    let line = |z: f32| c.x - r - 2.0 * (c.x - r) * (z / c.h);
    for (z0, z1) in [(0.78, 0.86), (0.9, 0.985)] {
        let (z0, z1) = (c.h * z0, c.h * z1);
        let t = r * 0.9;
        let outline = [(line(z0) + t, z0), (line(z1) + t, z1), (line(z1) - t, z1), (line(z0) - t, z0)];
        b.prism("slat", Axis::Y, [0.0, -y - r, 0.0], &outline, 2.0 * (y + r), seat);
    }
}

/// A small seat on tall splayed legs with a tray and a footrest.
pub(super) fn high_chair(b: &mut Build<'_>) {
    at_least(b, [0.26, 0.23, 0.42]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let body = b.choose(&[WHITE_PLASTIC, GREY_PLASTIC, b.style.wood, WHITE]);
    let legs = b.choose(&[b.style.wood, WHITE_METAL, BEECH]);
    let pad = b.choose(&[b.style.accent, BLUE_FABRIC, GREEN_FABRIC, ROSE_FABRIC]);
    let (seat, half, r) = (h * 0.56, y * 0.62, 0.018_f32.min(y * 0.08));
    let (rear, front) = (-x * 0.5, x * 0.2);
    for (sx, sy) in CORNERS {
        let foot = [sx * (x - r), sy * (y - r), 0.0];
        let head = [f32::midpoint(rear, front) + sx * (front - rear) * 0.42, sy * (half - r), seat - 0.01];
        leg(b, "leg", (foot, r * 0.8), (head, r), Cut::Round, legs);
    }
    b.rounded_block("seat", [rear, -half, seat - 0.03], [front + 0.02, half, seat], 0.012, body);
    b.rounded_block("pad", [rear + 0.03, 0.03 - half, seat - 0.001], [front, half - 0.03, seat + 0.018], 0.008, pad);
    let lean = Lean { back: rear - x * 0.25, z: (seat - 0.02, h), thickness: 0.03, tilt: 0.16 };
    lean.pad(b, "back", (-half, half), 0.014, body);
    lean.posed(b, |b, length, _| {
        b.rounded_block("pad", [-0.004, 0.03 - half, 0.04], [0.014, half - 0.03, length * 0.9], 0.008, pad);
    });
    let tray = seat + 0.2_f32.min((h - seat) * 0.5);
    let (from, to) = (lean.front(seat) + 0.03, front - 0.01);
    let free = (((to - from) / 2.0).max(0.01), half - 0.05);
    b.ledge("seat", [f32::midpoint(from, to), 0.0, seat + 0.018], free, (tray - seat - 0.03).max(0.02));
    for side in [-1.0_f32, 1.0] {
        let cy = side * (half - 0.012);
        let line = [
            (lean.front(tray) - 0.02, seat - 0.01),
            (front, seat - 0.01),
            (front + 0.06, tray),
            (lean.front(tray) - 0.02, tray),
        ];
        b.prism("side", Axis::Y, [0.0, cy - 0.008, 0.0], &line, 0.016, body);
    }
    let (t0, t1) = (front - 0.03, x);
    b.rounded_block("tray", [t0, -y, tray], [t1, y, tray + 0.014], 0.006, WHITE_PLASTIC);
    for (low, high) in [
        ([t0, -y, tray + 0.004], [t1, 0.012 - y, tray + 0.028]),
        ([t0, y - 0.012, tray + 0.004], [t1, y, tray + 0.028]),
        ([t1 - 0.012, 0.012 - y, tray + 0.004], [t1, y - 0.012, tray + 0.028]),
    ] {
        b.block("rim", low, high, WHITE_PLASTIC);
    }
    b.top("tray", [f32::midpoint(t0, t1 - 0.012), 0.0, tray + 0.014], ((t1 - t0 - 0.012) / 2.0 - 0.01, y - 0.022));
    let z = seat * 0.55;
    let reach = x * 0.62;
    b.rounded_block("footrest", [front - 0.02, -half * 0.85, z], [reach, half * 0.85, z + 0.018], 0.006, body);
    for side in [-1.0, 1.0] {
        let cy = side * half * 0.75;
        b.rod("bracket", [front - 0.01, cy, z + 0.009], [front - 0.01, cy, seat - 0.02], 0.009, legs);
    }
}
