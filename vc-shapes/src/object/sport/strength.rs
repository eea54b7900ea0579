//! Weight machines, benches and racks; a seated user faces the front.

use super::gear::dumbbell;
use crate::material::*;
use crate::solid::{Axis, Build, CORNERS, P, Proportional, SIDES};

const TUBE: f32 = 0.06;

/// A square tube between two positions.
fn beam(b: &mut Build<'_>, from: P, to: P, mat: MaterialId) {
    b.plank("frame", from, to, (TUBE, TUBE), mat);
}

/// A stack of weights on two guide rods within a cage; `x` and `y` are the extents of the cage.
fn stack(b: &mut Build<'_>, x: (f32, f32), y: (f32, f32), top: f32, frame: MaterialId) {
    let (mx, my) = ((x.0 + x.1) / 2.0, (y.0 + y.1) / 2.0);
    b.slab("stack_base", [x.0, y.0, 0.0], [x.1, y.1, 0.05], frame);
    b.slab("stack_top", [x.0, y.0, top - 0.04], [x.1, y.1, top], frame);
    for s in SIDES {
        let side = my + s * (y.1 - y.0) * 0.46;
        let half = (y.1 - y.0) * 0.04;
        b.slab("stack_side", [x.0 + 0.01, side - half, 0.05], [x.1 - 0.01, side + half, top - 0.04], frame);
        let rod = my + s * (y.1 - y.0) * 0.25;
        b.pole("guide", [mx, rod, 0.04], [mx, rod, top - 0.02], 0.012, CHROME);
    }
    let plates = 9;
    let pitch = (top * 0.5) / plates as f32;
    let pin = b.rng.below(plates);
    for i in 0..plates {
        let z = 0.06 + pitch * i as f32;
        b.slab(
            "weight",
            [x.0 + 0.02, y.0 + (y.1 - y.0) * 0.1, z],
            [x.1 - 0.02, y.1 - (y.1 - y.0) * 0.1, z + pitch * 0.9],
            IRON,
        );
        if i == pin {
            b.slab(
                "pin",
                [x.1 - 0.03, my - 0.02, z + pitch * 0.25],
                [x.1 + 0.03, my + 0.02, z + pitch * 0.65],
                RED_PLASTIC,
            );
        }
    }
    b.pole("cable", [mx, my, 0.06 + pitch * plates as f32 * 0.9], [mx, my, top - 0.02], 0.005, BLACK_PLASTIC);
}

/// A seat and a backrest on a post.
fn chair(b: &mut Build<'_>, x: f32, seat: f32, back: f32, (frame, hide): (MaterialId, MaterialId)) {
    let w = (0.36 / b.size.y).min(0.4);
    beam(b, [x, 0.0, 0.02], [x, 0.0, seat - 0.03], frame);
    b.pad("seat", [x - 0.22, -w, seat - 0.045], [x + 0.3, w, seat], 0.02, hide);
    if back > seat {
        beam(b, [x - 0.32, 0.0, 0.02], [x - 0.36, 0.0, back - 0.04], frame);
        beam(b, [x - 0.355, 0.0, back - 0.12], [x - 0.285, 0.0, back - 0.12], frame);
        b.plank("backrest", [x - 0.22, 0.0, seat + 0.03], [x - 0.3, 0.0, back], (w * b.size.y * 0.85, 0.06), hide);
    }
}

/// A seat with its weight stack and a moving part: arms, a leg roll or a high bar.
pub(super) fn station(b: &mut Build<'_>) {
    let (frame, hide) = (
        b.choose(&[BLACK_METAL, WHITE_METAL, SILVER_METAL, RED_METAL]),
        b.choose(&[BLACK_LEATHER, BLACK_LEATHER, BROWN_LEATHER, RED_FABRIC]),
    );
    let seat = 0.47 / b.size.z.max(1.0);
    let tall = b.size.z > 1.95;
    let top = if tall { 0.99 } else { 0.96 };
    let wide = (0.4 / b.size.y).min(0.5);
    for y in SIDES {
        beam(b, [-0.97, y * 0.92, 0.03], [0.9, y * 0.5, 0.03], frame);
    }
    for x in [-0.95, 0.2] {
        beam(b, [x, -0.96, 0.031], [x, 0.96, 0.031], frame);
    }
    beam(b, [-0.95, 0.0, 0.032], [0.85, 0.0, 0.032], frame);
    stack(b, (-0.98, -0.62), (-wide, wide), top, frame);
    match b.class {
        "leg_extension_machine" => {
            chair(b, 0.05, seat, 0.72, (frame, hide));
            let z = seat - 0.02;
            b.wheel("pivot", Axis::Y, [0.36, 0.0, z], (b.size.z * 0.05, b.size.y * 0.5), frame);
            b.plank("lever", [0.36, 0.0, z], [0.72, 0.0, 0.14], (0.05, 0.05), frame);
            b.pole("leg_roll", [0.78, -0.5, 0.16], [0.78, 0.5, 0.16], b.size.z * 0.05, hide);
            for y in SIDES {
                b.pole("handle", [-0.05, y * 0.5, seat - 0.022], [0.1, y * 0.5, seat + 0.06], 0.016, RUBBER);
                b.plank("handle", [-0.05, 0.0, seat - 0.05], [-0.05, y * 0.52, seat - 0.02], (0.03, 0.03), frame);
            }
        }
        "chest_press" => {
            chair(b, 0.0, seat, 0.78, (frame, hide));
            press_arms(b, frame, 0.62);
            beam(b, [-0.66, 0.0, top - 0.05], [-0.1, 0.0, top - 0.05], frame);
        }
        _ => {
            let row = b.class == "multi_gym";
            chair(b, 0.15, seat, if row { 0.6 } else { 0.0 }, (frame, hide));
            beam(b, [-0.7, 0.0, top - 0.025], [0.4, 0.0, top - 0.025], frame);
            if row {
                press_arms(b, frame, 0.5);
            } else {
                b.pole("knee_roll", [0.42, -0.4, seat + 0.1], [0.42, 0.4, seat + 0.1], b.size.z * 0.03, hide);
                beam(b, [0.42, 0.0, 0.03], [0.42, 0.0, seat + 0.1], frame);
            }
            let at = 0.36;
            b.wheel("pulley", Axis::Y, [at, 0.0, top - 0.03], (0.05, 0.03), BLACK_PLASTIC);
            b.pole("cable", [at, 0.0, top - 0.03], [at, 0.0, 0.82], 0.005, BLACK_PLASTIC);
            let span = (1.1 / b.size.y).min(0.96);
            b.pole("lat_bar", [at, -span * 0.7, 0.82], [at, span * 0.7, 0.82], 0.014, CHROME);
            for y in SIDES {
                b.pole("lat_grip", [at, y * span * 0.68, 0.82], [at, y * span, 0.785], 0.017, RUBBER);
            }
            b.plank("foot_bar", [0.85, 0.0, 0.03], [0.92, 0.0, 0.14], (b.size.y * 0.4, 0.03), BLACK_PLASTIC);
        }
    }
}

/// Two arms that reach forward beside the seat, with upright grips.
fn press_arms(b: &mut Build<'_>, frame: MaterialId, z: f32) {
    // As wide as the stack, whose sides support the arms.
    let wide = (0.4 / b.size.y).min(0.5);
    for y in SIDES {
        b.plank("arm", [-0.5, y * wide * 0.9, 0.84], [-0.2, y * 0.62, 0.84], (0.05, 0.05), frame);
        b.plank("arm", [-0.2, y * 0.62, 0.85], [0.3, y * 0.66, z], (0.05, 0.05), frame);
        b.pole("grip", [0.3, y * 0.66, z], [0.3, y * 0.3, z + 0.01], 0.018, RUBBER);
        b.pole("grip", [0.3, y * 0.66, z - 0.01], [0.3, y * 0.66, z + 0.1], 0.018, RUBBER);
    }
    b.plank("yoke", [-0.66, 0.0, 0.85], [-0.46, 0.0, 0.85], (b.size.y * wide, 0.06), frame);
}

/// A leg press: a sledge with plates on a slope, and a foot plate above a low seat.
pub(super) fn leg_press(b: &mut Build<'_>) {
    let (frame, hide) = (b.choose(&[BLACK_METAL, SILVER_METAL, RED_METAL, YELLOW_METAL]), BLACK_LEATHER);
    let w = 0.4;
    for y in SIDES {
        beam(b, [-0.95, y * w, 0.04], [0.95, y * w, 0.04], frame);
        b.pole("rail", [-0.35, y * w, 0.2], [0.88, y * w, 0.9], 0.025, CHROME);
        beam(b, [0.9, y * w, 0.04], [0.88, y * w, 0.93], frame);
        beam(b, [-0.35, y * w, 0.04], [-0.35, y * w, 0.24], frame);
    }
    for x in [-0.9, 0.86] {
        beam(b, [x, -w - 0.05, 0.046], [x, w + 0.05, 0.046], frame);
    }
    beam(b, [0.87, -w - 0.05, 0.93], [0.87, w + 0.05, 0.931], frame);
    b.layer("sledge", [0.0, 0.0, 0.399], [0.3, 0.0, 0.57], (b.size.y * (w + 0.06), 0.07), 0.057, frame);
    b.plank("foot_plate", [-0.06, 0.0, 0.62], [0.16, 0.0, 0.36], (b.size.y * 0.36, 0.04), GREY_PLASTIC);
    let (r, level) = ((b.size.z * 0.15).min(0.225), 0.513 + 0.05 / b.size.z);
    for y in SIDES {
        b.pole("horn", [0.2, y * 0.3, level], [0.2, y * 0.97, level], 0.024, CHROME);
        for i in 0..b.rng.count(1, 3) {
            let at = y * (0.6 + 0.09 * i as f32);
            b.wheel("weight", Axis::Y, [0.2, at, level], (r, b.size.y * 0.035), RUBBER);
        }
    }
    b.pad("seat", [-0.62, -0.32, 0.16], [-0.32, 0.32, 0.22], 0.02, hide);
    b.plank("backrest", [-0.6, 0.0, 0.22], [-0.94, 0.0, 0.5], (b.size.y * 0.32, 0.08), hide);
    beam(b, [-0.5, 0.0, 0.042], [-0.5, 0.0, 0.18], frame);
    b.plank("seat_beam", [-0.62, 0.0, 0.17], [-0.32, 0.0, 0.17], (b.size.y * w, 0.03), frame);
    beam(b, [-0.9, 0.0, 0.042], [-0.9, 0.0, 0.44], frame);
    for y in SIDES {
        b.pole("handle", [-0.5, y * 0.3, 0.19], [-0.4, y * 0.36, 0.34], 0.018, RUBBER);
    }
}

/// A cable machine: two towers with weights joined by a high beam, or one tower; cables with grips.
pub(super) fn cables(b: &mut Build<'_>) {
    let frame = b.choose(&[BLACK_METAL, WHITE_METAL, SILVER_METAL, RED_METAL]);
    let half = (0.45 / b.size.y).min(0.3);
    for y in SIDES {
        let (low, high) = ((y * 0.99).min(y * (0.99 - half)), (y * 0.99).max(y * (0.99 - half)));
        stack(b, (-0.98, -0.3), (low, high), 0.97, frame);
        b.slab("foot", [-0.3, low, 0.0], [0.98, low + (high - low) * 0.3, 0.03], frame);
        b.slab("foot", [-0.3, high - (high - low) * 0.3, 0.0], [0.98, high, 0.03], frame);
        let inner = y * (0.99 - half * 0.5);
        beam(b, [0.2, inner, 0.03], [0.2, inner, 0.95], frame);
        b.slab("foot", [0.1, low, 0.03], [0.3, high, 0.055], frame);
        b.slab("head", [-0.4, inner - half * 0.16, 0.93], [0.3, inner + half * 0.16, 0.965], frame);
        let z = b.vary(0.4, 0.8);
        b.slab("carriage", [0.1, inner - half * 0.2, z - 0.03], [0.34, inner + half * 0.2, z + 0.03], BLACK_PLASTIC);
        b.wheel("pulley", Axis::Y, [0.38, inner, z], (0.045, 0.03), GREY_PLASTIC);
        b.pole("cable", [0.4, inner, z], [0.46, inner, z - 0.11], 0.005, BLACK_PLASTIC);
        b.pole("grip", [0.46, inner - half * 0.22, z - 0.11], [0.46, inner + half * 0.22, z - 0.11], 0.016, RUBBER);
    }
    b.slab("bridge", [-0.7, half - 1.0, 0.968], [-0.6, 1.0 - half, 0.998], frame);
    let bar = 0.94;
    b.slab("bridge", [-0.72, half - 1.0, bar], [-0.58, 1.0 - half, bar + 0.028], frame);
    if b.size.y > 1.8 {
        b.pole("pull_up_bar", [-0.4, half - 1.02, 0.95], [-0.4, 1.02 - half, 0.95], 0.016, CHROME);
    }
}

/// A Smith machine: a bar that runs in two guides, with plates and a bench below.
pub(super) fn smith(b: &mut Build<'_>) {
    let frame = b.choose(&[BLACK_METAL, SILVER_METAL, RED_METAL]);
    let y = (1.2 / b.size.y).min(0.6);
    let z = b.vary(0.5, 0.62);
    cage(b, y, frame);
    for s in SIDES {
        b.pole("guide", [0.2, s * y, 0.02], [0.2, s * y, 0.985], 0.016, CHROME);
        for i in 1..8 {
            let at = 0.12 * i as f32;
            b.pole("peg", [0.2, s * y, at], [0.36, s * y, at], 0.012, STEEL);
        }
    }
    loaded_bar(b, [0.2, 0.0, z], 0.98);
    b.within([-0.7, -0.22, 0.0], [0.95, 0.22, 0.22], |b| flat_bench(b, frame));
    beam(b, [-0.95, 0.0, 0.022], [-0.45, 0.0, 0.022], frame);
}

/// Four uprights with beams at the bottom and at the top.
fn cage(b: &mut Build<'_>, y: f32, frame: MaterialId) {
    let x = 1.0 - 2.0 * TUBE / b.size.x;
    let top = 1.0 - TUBE / b.size.z;
    for (i, j) in CORNERS {
        beam(b, [i * x, j * y, 0.0], [i * x, j * y, top], frame);
    }
    for j in SIDES {
        beam(b, [-0.99, j * y, 0.02], [0.99, j * y, 0.02], frame);
        beam(b, [-0.98, j * y, top], [0.98, j * y, top], frame);
    }
    for i in [-x, x] {
        beam(b, [i, -y, top + 0.002], [i, y, top + 0.002], frame);
    }
    beam(b, [-x, -y, 0.022], [-x, y, 0.022], frame);
}

/// A bar with plates across the full width.
fn loaded_bar(b: &mut Build<'_>, at: P, half: f32) {
    let r = (b.size.z * 0.1).min(0.225);
    b.pole("bar", [at[0], -half, at[2]], [at[0], half, at[2]], 0.014, STEEL);
    let count = b.rng.count(1, 2);
    for s in SIDES {
        b.pole("sleeve", [at[0], s * half * 0.78, at[2]], [at[0], s * half, at[2]], 0.024, CHROME);
        for i in 0..count {
            let mat = [RUBBER, RED_RUBBER][i % 2];
            let y = s * half * (0.82 + 0.07 * i as f32);
            b.wheel("weight", Axis::Y, [at[0], y, at[2]], (r * (1.0 - 0.2 * i as f32), 0.035), mat);
        }
    }
}

/// A flat bench that fills the size.
fn flat_bench(b: &mut Build<'_>, frame: MaterialId) {
    b.pad("pad", [-0.98, -0.9, 0.82], [0.98, 0.9, 1.0], 0.03, BLACK_LEATHER);
    for x in [-0.75, 0.75] {
        b.slab("leg", [x - 0.06, -0.2, 0.06], [x + 0.06, 0.2, 0.83], frame);
        b.slab("foot", [x - 0.08, -0.98, 0.0], [x + 0.08, 0.98, 0.12], frame);
    }
    b.slab("spine", [-0.8, -0.15, 0.7], [0.8, 0.15, 0.825], frame);
}

/// A weight bench: flat, inclined, with uprights and a bar, or a sit-up board.
pub(super) fn bench(b: &mut Build<'_>) {
    let (frame, hide) = (
        b.choose(&[BLACK_METAL, SILVER_METAL, RED_METAL, WHITE_METAL]),
        b.choose(&[BLACK_LEATHER, BROWN_LEATHER, RED_FABRIC]),
    );
    if b.class == "sit_up_bench" {
        return sit_up(b, frame, hide);
    }
    let seat = (0.45 / b.size.z).min(0.98);
    if b.size.z < 0.62 {
        return flat_bench(b, frame);
    }
    let w = (0.3 / b.size.y).min(0.7);
    for x in [-0.8, 0.8] {
        b.slab("foot", [x - 0.06, -0.9, 0.0], [x + 0.06, 0.9, 0.06], frame);
    }
    beam(b, [-0.82, 0.0, 0.04], [0.82, 0.0, 0.04], frame);
    beam(b, [0.3, 0.0, 0.04], [0.3, 0.0, seat - 0.05], frame);
    b.pad("seat", [0.1, -w, seat - 0.08], [0.66, w, seat], 0.025, hide);
    let upright = b.rng.chance(0.5);
    let (end, high) = if upright { (-0.97, seat) } else { (-0.62, 0.99) };
    b.plank("backrest", [0.06, 0.0, seat - 0.04], [end + 0.05, 0.0, high - 0.05], (b.size.y * w, 0.06), hide);
    beam(b, [-0.5, 0.0, 0.04], [if upright { -0.5 } else { -0.3 }, 0.0, (seat + high) / 2.0 - 0.05], frame);
    if upright {
        for y in SIDES {
            b.slab("rack", [-0.68, y * 0.86 - 0.08, 0.0], [-0.58, y * 0.86 + 0.08, 0.96], frame);
            b.slab("cup", [-0.6, y * 0.86 - 0.07, 0.9], [-0.48, y * 0.86 + 0.07, 0.93], STEEL);
            b.slab("lip", [-0.51, y * 0.86 - 0.07, 0.92], [-0.47, y * 0.86 + 0.07, 1.0], STEEL);
        }
        b.slab("rack_tie", [-0.67, -0.85, 0.025], [-0.59, 0.85, 0.085], frame);
        let z = 0.93 + 0.013 / b.size.z;
        b.pole("bar", [-0.545, -0.98, z], [-0.545, 0.98, z], 0.014, CHROME);
    } else {
        b.pole("leg_roll", [0.8, -0.85, seat * 0.5], [0.8, 0.85, seat * 0.5], b.size.z * 0.045, hide);
        beam(b, [0.62, 0.0, seat - 0.04], [0.8, 0.0, seat * 0.45], frame);
    }
}

/// A sloping board with foam rolls for the feet.
fn sit_up(b: &mut Build<'_>, frame: MaterialId, hide: MaterialId) {
    b.layer("pad", [-0.88, 0.0, 0.258], [0.45, 0.0, 0.619], (b.size.y * 0.62, 0.05), 0.052, hide);
    beam(b, [-0.8, 0.0, 0.28], [0.6, 0.0, 0.66], frame);
    for (x, z) in [(-0.8, 0.3), (0.5, 0.62)] {
        beam(b, [x, 0.0, 0.02], [x, 0.0, z], frame);
        b.slab("foot", [x - 0.05, -0.95, 0.0], [x + 0.05, 0.95, 0.07], frame);
    }
    beam(b, [0.5, 0.0, 0.6], [0.82, 0.0, 0.92], frame);
    let r = b.size.z * 0.075;
    for (x, z) in [(0.55, 0.84), (0.88, 0.68)] {
        b.pole("roll", [x, -0.97, z], [x, 0.97, z], r, RUBBER);
        b.plank("roll_arm", [0.7, 0.0, 0.8], [x, 0.0, z], (0.04, 0.04), frame);
    }
    b.pole("handle", [0.82, -0.4, 0.93], [0.82, 0.4, 0.93], 0.018, RUBBER);
}

/// A squat stand or a power cage with hooks, pins and a bar.
pub(super) fn rack(b: &mut Build<'_>) {
    let frame = b.choose(&[BLACK_METAL, RED_METAL, BLUE_METAL, YELLOW_METAL, SILVER_METAL]);
    let y = (1.12 / b.size.y).min(0.8);
    let full = b.class == "power_rack";
    let bar = if full { b.vary(0.55, 0.66) } else { b.vary(0.72, 0.9) };
    if full {
        cage(b, y, frame);
        let post = 1.0 - 2.0 * TUBE / b.size.x;
        for s in SIDES {
            beam(b, [-post, s * y, 0.34], [post, s * y, 0.34], STEEL);
            b.slab("hook", [0.45, s * y - 0.03, bar - 0.06], [0.99, s * y + 0.03, bar - 0.014 / b.size.z], RED_PLASTIC);
        }
        b.pole("pull_up_bar", [0.94, -y, 0.95], [0.94, y, 0.95], 0.016, CHROME);
    } else {
        for s in SIDES {
            beam(b, [-0.97, s * y, 0.03], [0.97, s * y, 0.03], frame);
            beam(b, [-0.3, s * y, 0.0], [-0.3, s * y, 0.99], frame);
            beam(b, [0.5, s * y, 0.05], [-0.28, s * y, 0.34], frame);
            b.slab("hook", [-0.3, s * y - 0.04, bar - 0.04], [0.16, s * y + 0.04, bar - 0.014 / b.size.z], STEEL);
            b.slab("lip", [0.1, s * y - 0.04, bar - 0.02], [0.18, s * y + 0.04, bar + 0.03], STEEL);
            for i in 1..9 {
                b.wheel("hole", Axis::X, [-0.3, s * y, 0.1 * i as f32], (0.012, TUBE + 0.004), BLACK_PLASTIC);
            }
        }
        beam(b, [-0.9, -y, 0.032], [-0.9, y, 0.032], frame);
        if b.rng.chance(0.5) {
            beam(b, [-0.3, -y, 0.97], [-0.3, y, 0.97], frame);
        }
    }
    let x = if full { 0.55 } else { 0.0 };
    b.pole("bar", [x, -0.99, bar], [x, 0.99, bar], 0.014, CHROME);
    for s in SIDES {
        let at = s * (y + 1.0) * 0.5 + s * 0.03;
        b.wheel(
            "weight",
            Axis::Y,
            [x, at, bar],
            ((b.size.z * 0.09).min(b.size.x * 0.1).min(0.2), (1.0 - y) * b.size.y * 0.12),
            RUBBER,
        );
    }
}

/// Two or three sloping shelves with dumbbells in most positions.
pub(super) fn dumbbell_rack(b: &mut Build<'_>) {
    let frame = b.choose(&[BLACK_METAL, SILVER_METAL, WHITE_METAL]);
    let tiers = if b.size.z > 0.8 { 3 } else { 2 };
    for y in SIDES {
        let side = (y * 0.97 - 0.03, y * 0.97 + 0.03);
        b.side_outline(
            "side",
            side,
            &[(-0.98, 0.0), (0.98, 0.0), (0.98, 0.06), (0.1, 0.08), (-0.55, 0.99), (-0.8, 0.99), (-0.9, 0.08)],
            frame,
        );
    }
    for i in 0..tiers {
        let z = 0.18 + 0.66 * i as f32 / (tiers as f32 - 0.9);
        let (front, back) = (0.92 - 0.3 * i as f32, 0.1 - 0.42 * i as f32);
        b.slab("shelf", [back, -0.95, z - 0.025], [front, 0.95, z], frame);
        for y in SIDES {
            let at = y * 0.965;
            b.slab("bracket", [back - 0.16, at - 0.025, z - 0.05], [front - 0.02, at + 0.025, z - 0.006], frame);
        }
        b.slab("lip", [front - 0.03, -0.94, z], [front, 0.94, z + 0.025], frame);
        let centre = [(front + back) / 2.0 - 0.02, 0.0, z];
        let full = i + 1 < tiers;
        let wide = b.size.y * 0.94;
        let count = (wide / 0.2).floor().clamp(2.0, 8.0) as usize;
        let pitch = 1.86 / count as f32;
        let kept = if full { count } else { count / 2 };
        for k in 0..kept {
            let y = -0.93 + pitch * (k as f32 + 0.5);
            let heavy = (0.5 + 0.5 * k as f32 / count as f32) * (1.0 - 0.12 * i as f32);
            weight_on(b, [centre[0], y, z], heavy, pitch);
        }
        let name = format!("shelf_{}", i + 1);
        let free = 1.86 - pitch * kept as f32;
        let (middle, half) = (b.p([centre[0], 0.93 - free / 2.0, z]), (front - back) * b.size.x * 0.22);
        let room = b.size.z * 0.2;
        if free > 0.1 {
            b.ledge(&name, middle, (half, (free / 2.0 - 0.03) * b.size.y / 2.0), room);
        }
    }
}

/// A dumbbell across a shelf.
fn weight_on(b: &mut Build<'_>, at: P, heavy: f32, pitch: f32) {
    let outer = b.size;
    let place = b.p(at);
    let r = (pitch * outer.y * 0.22).min(outer.z * 0.09).min(0.09) * heavy.max(0.5);
    let long = (outer.x * 0.36).min(0.34) * (0.75 + 0.25 * heavy);
    b.at(place, std::f32::consts::FRAC_PI_2, |b| {
        b.size = nalgebra::Vector3::new(r * 2.0, long, r * 2.0);
        dumbbell(b);
    });
    b.size = outer;
}
