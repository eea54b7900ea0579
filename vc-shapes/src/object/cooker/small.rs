//! Countertop appliances for drinks and bread: kettles, toasters, coffee machines.

use vc_graph::asset::JointKind;

use super::fitting::*;
use super::heat::foot_row;
use crate::material::*;
use crate::object::joinery::lid;
use crate::solid::{Axis, Build, cup_profile, fit, floor_of, half_dims, pit, plate_with_hole, round_floor};

/// A body with a spout and a handle on a base with a switch, its lid hinged.
pub(super) fn kettle(b: &mut Build<'_>) {
    let u = fit(b, [0.128, 0.192, 0.192]);
    let (x, y, h) = half_dims(b);
    let x = x.min(y * 0.86);
    let body = b.choose(&[STEEL, STEEL, WHITE_PLASTIC, BLACK_METAL, RED_METAL, GLASS]);
    let trim = b.choose(&[BLACK_PLASTIC, BLACK_PLASTIC, GREY_PLASTIC, WHITE_PLASTIC]);
    let foot = h * 0.09;
    let centre = [0.0, y * 0.12];
    let at = |z: f32| [centre[0], centre[1], z];
    b.lathe("base", [0.0, centre[1], 0.0], &[(x * 0.98, 0.0), (x, foot * 0.6), (x * 0.9, foot)], trim);
    let (tall, wall) = (h * 0.78, 0.004 * u);
    let (bottom, top) = (x * b.vary(0.88, 0.97), x * b.vary(0.6, 0.74));
    let middle = if b.rng.chance(0.5) { (bottom + top) / 2.0 } else { bottom * 0.98 };
    let shell = [
        (bottom, 0.0),
        (middle, tall * 0.5),
        (top, tall),
        (top - wall, tall),
        (middle - wall, tall * 0.5),
        (bottom - wall, wall),
    ];
    b.lathe("body", at(foot), &shell, body);
    round_floor(b, "water", at(foot + wall), top - wall, tall - 2.0 * wall);
    // The spout points to the left, the handle to the right.
    let (lip, root) = (foot + tall * 0.98, foot + tall * 0.66);
    let w = top * 0.32;
    let edge = centre[1] + top * 0.86;
    let spout = [
        [-w, edge, lip],
        [w, edge, lip],
        [0.0, edge, root],
        [0.0, y, lip],
        [-w * 0.5, edge, root],
        [w * 0.5, edge, root],
    ];
    b.hull("spout", &spout, if body == GLASS { trim } else { body });
    let reach = -y + 0.018 * u;
    let r = 0.011 * u;
    let grip = b.choose(&[0.12, 0.3]);
    let points = [
        [0.0, centre[1] - top * 0.92, foot + tall * 0.94],
        [0.0, reach, foot + tall * 0.9],
        [0.0, reach, foot + tall * (grip + 0.1)],
        [0.0, centre[1] - bottom * 0.9, foot + tall * grip],
    ];
    b.pipe("handle", &points, r, trim);
    b.block(
        "switch",
        [-0.01 * u, reach - 0.008 * u, foot + tall * 0.5],
        [0.01 * u, reach, foot + tall * 0.58],
        RED_PLASTIC,
    );
    b.hinge([0.0, centre[1] - top * 0.98, foot + tall], [1.0, 0.0, 0.0], 1.3, |b| {
        b.lathe("lid", at(foot + tall), &[(top * 0.98, 0.0), (top * 0.8, h * 0.05)], trim);
        b.lathe(
            "knob",
            at(foot + tall + h * 0.05),
            &[(top * 0.18, 0.0), (top * 0.24, h * 0.05), (top * 0.1, h * 0.08)],
            trim,
        );
    });
}

/// Slots between heated walls, a lever at the end, a dial.
pub(super) fn toaster(b: &mut Build<'_>) {
    let u = fit(b, [0.16, 0.24, 0.16]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[STEEL, STEEL, RED_METAL, WHITE_METAL, BLUE_METAL, BLACK_METAL, CREAM]);
    let trim = b.choose(&[BLACK_PLASTIC, body]);
    let (feet, cap) = (0.012 * u, y * b.vary(0.1, 0.22));
    foot_row(b, (x * 0.7, y * 0.75), 0.012 * u, feet);
    let end = y - 0.03 * u;
    let bottom = h * b.vary(0.22, 0.4);
    let (from, to) = (-y + cap, end - cap);
    b.block("body", [-x, from, feet], [x, to, bottom], body);
    let slots = if x < 0.07 { 1 } else { 2 };
    let step = 2.0 * x / slots as f32;
    for i in 0..slots {
        let x0 = -x + step * i as f32;
        let (a, z) = (x0 + step * 0.5 - (0.019 * u).min(step * 0.35), x0 + step * 0.5 + (0.019 * u).min(step * 0.35));
        let walls = ([x0, from, bottom], [x0 + step, to, h]);
        plate_with_hole(b, "wall", Axis::Z, walls, ((a, from + 0.008 * u), (z, to - 0.008 * u)), body);
        floor_of(b, &format!("slot_{}", i + 1), [a, from + 0.008 * u, bottom], [z, to - 0.008 * u, h]);
    }
    let radius = if b.rng.chance(0.6) { h * 0.22 } else { 0.01 * u };
    b.rounded_block("end", [-x, -y, feet], [x, from + 0.004 * u, h], radius, trim);
    b.rounded_block("end", [-x, to - 0.004 * u, feet], [x, end, h], radius, trim);
    let travel = h * 0.4;
    b.block("groove", [-0.004 * u, end - 0.001 * u, h * 0.3], [0.004 * u, end + 0.001 * u, h * 0.85], SCREEN);
    b.jointed(JointKind::Slide, [0.0; 3], [0.0, 0.0, -1.0], (0.0, travel), |b| {
        b.rounded_block(
            "lever",
            [-0.016 * u, end + 0.001 * u, h * 0.76],
            [0.016 * u, y, h * 0.83],
            0.004 * u,
            BLACK_PLASTIC,
        );
    });
    b.rod("dial", [-x * 0.5, end - 0.001 * u, h * 0.3], [-x * 0.5, end + 0.012 * u, h * 0.3], h * 0.08, STEEL);
}

/// A filter machine with a jug, a capsule machine, or a large automatic one.
pub(super) fn coffee_maker(b: &mut Build<'_>) {
    let u = fit(b, [0.16, 0.144, 0.24]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[BLACK_PLASTIC, WHITE_PLASTIC, STEEL, RED_PLASTIC, BLACK_METAL]);
    let base = h * 0.1;
    let back = -x + x * b.vary(0.65, 0.8);
    let head = h * b.vary(0.66, 0.72);
    let deck = b.rng.below(2) == 0;
    b.rounded_block("base", [-x, -y, 0.0], [x, y, base], 0.012 * u, body);
    b.block("column", [-x, -y * 0.98, base * 0.5], [back, y * 0.98, head + 0.002 * u], body);
    let wall = 0.012 * u;
    pit(b, "head", [-x, -y, head], [x * 0.96, y, h - wall], wall, body);
    let hollow = ([-x + wall, -y + wall, head + wall], [x * 0.96 - wall, y - wall, h - wall]);
    floor_of(b, "compartment_1", hollow.0, hollow.1);
    lid(b, [-x, 0.0, h], 1.4, |b| {
        b.block("lid", [-x + 0.002 * u, -y + 0.002 * u, h - wall + 0.001 * u], [x * 0.96, y - 0.002 * u, h], body);
        b.block("tab", [x * 0.96, -y * 0.2, h - wall], [x, y * 0.2, h], STEEL);
    });
    let centre = [f32::midpoint(back, x), 0.0];
    let room = (x - back) / 2.0;
    if deck {
        // A glass jug on a warm plate.
        let r = (room * 0.9).min(y * 0.8);
        b.cylinder("plate", [centre[0], 0.0, base - 0.001 * u], r * 0.95, 0.005 * u, BLACK_METAL);
        let tall = (head - base) * 0.86;
        let z = base + 0.005 * u;
        let wall = 0.003 * u;
        let shape = [
            (r * 0.86, 0.0),
            (r, tall * 0.3),
            (r * 0.72, tall * 0.85),
            (r * 0.78, tall),
            (r * 0.78 - wall, tall),
            (r * 0.72 - wall, tall * 0.85),
            (r - wall, tall * 0.3),
            (r * 0.86 - wall, wall),
        ];
        b.lathe("jug", [centre[0], 0.0, z], &shape, GLASS);
        b.lathe(
            "coffee",
            [centre[0], 0.0, z + wall],
            &[(r * 0.86 - wall * 1.5, 0.0), (r - wall * 1.6, tall * 0.29)],
            CHOCOLATE,
        );
        let ear = centre[0] + r * 0.7;
        let points = [
            [ear, 0.0, z + tall * 0.9],
            [x - 0.012 * u, 0.0, z + tall * 0.8],
            [x - 0.012 * u, 0.0, z + tall * 0.35],
            [ear + r * 0.2, 0.0, z + tall * 0.22],
        ];
        b.pipe("jug_handle", &points, 0.007 * u, BLACK_PLASTIC);
        b.cylinder(
            "filter",
            [centre[0], 0.0, head - (head - base) * 0.09],
            r * 0.5,
            (head - base) * 0.1,
            BLACK_PLASTIC,
        );
    } else {
        // A nozzle over a grid.
        let z = head - (head - base) * 0.3;
        b.block("group", [back - 0.002 * u, -y * 0.4, z], [x * 0.7, y * 0.4, head + 0.002 * u], BLACK_PLASTIC);
        for cy in [-y * 0.14, y * 0.14] {
            b.rod("nozzle", [centre[0], cy, z - 0.02 * u], [centre[0], cy, z], 0.008 * u, STEEL);
        }
        for i in 0..5 {
            let cx = back + 2.0 * room * (0.15 + 0.16 * i as f32);
            b.block("grid", [cx, -y * 0.8, base - 0.001 * u], [cx + room * 0.12, y * 0.8, base + 0.004 * u], STEEL);
        }
        b.block("drip_tray", [back, -y * 0.85, base * 0.2], [x + 0.0, y * 0.85, base * 0.8], STEEL);
    }
    display(b, x * 0.96, (-y * 0.3, h - (h - head) * 0.7), (y * 0.3, h - (h - head) * 0.4), COOL_BULB);
}

/// Brew groups with filter holders over a drip tray, a steam pipe, cups on top.
pub(super) fn espresso_machine(b: &mut Build<'_>) {
    let u = fit(b, [0.224, 0.192, 0.24]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[STEEL, STEEL, CHROME, RED_METAL, BLACK_METAL, CREAM]);
    let (feet, base) = (0.02 * u, h * 0.22);
    foot_row(b, (x * 0.8, y * 0.8), 0.018 * u, feet);
    let back = -x * 0.1;
    let head = h * 0.66;
    b.rounded_block("base", [-x, -y, feet], [x, y, base], 0.01 * u, body);
    b.block("column", [-x, -y * 0.98, base - 0.005 * u], [back, y * 0.98, head + 0.005 * u], body);
    let top = h - 0.025 * u;
    b.rounded_block("head", [-x, -y, head], [x * 0.72, y, top], 0.015 * u, body);
    for i in 0..7 {
        let cx = back + (x - back) * (0.1 + 0.12 * i as f32);
        b.block("grid", [cx, -y * 0.9, base - 0.002 * u], [cx + x * 0.05, y * 0.9, base + 0.004 * u], STEEL);
    }
    // A rail around the cup tray.
    plate_with_hole(
        b,
        "rail",
        Axis::Z,
        ([-x * 0.97, -y * 0.97, top - 0.005 * u], [x * 0.68, y * 0.97, h]),
        ((-x * 0.92, -y * 0.94), (x * 0.63, y * 0.94)),
        STEEL,
    );
    b.top("cup_rest", [-x * 0.145, 0.0, top], (x * 0.74, y * 0.9));
    let groups = (y / 0.16).clamp(1.0, 3.0) as usize;
    let step = 1.5 * y / groups as f32;
    let reach = (x * 0.42, x * 0.98);
    for i in 0..groups {
        let cy = step * (i as f32 + 0.5) - 0.75 * y;
        let r = 0.034 * u;
        b.cylinder("group", [reach.0, cy, head - 0.04 * u], r, 0.05 * u, CHROME);
        b.cylinder("basket", [reach.0, cy, head - 0.065 * u], r * 0.95, 0.026 * u, STEEL);
        b.rod(
            "holder",
            [reach.0, cy, head - 0.05 * u],
            [reach.1 - 0.01 * u, cy, head - 0.06 * u],
            0.011 * u,
            BLACK_PLASTIC,
        );
        b.rod("spout", [reach.0, cy, head - 0.09 * u], [reach.0, cy, head - 0.06 * u], 0.01 * u, STEEL);
        b.rod(
            "lever",
            [x * 0.71, cy, f32::midpoint(head, top)],
            [x * 0.71 + 0.012 * u, cy, f32::midpoint(head, top)],
            0.012 * u,
            BLACK_PLASTIC,
        );
    }
    let cy = -y * 0.86;
    let pipe = [[x * 0.6, cy, head + 0.005 * u], [x * 0.75, cy, head - 0.03 * u], [x * 0.82, cy, base + 0.05 * u]];
    b.pipe("steam_pipe", &pipe, 0.005 * u, STEEL);
    let z = f32::midpoint(head, top);
    b.lathe_along(
        "gauge",
        [x * 0.715, y * 0.82, z],
        [x, y * 0.82, z],
        &[((y * 0.1).min(0.025 * u), 0.0), ((y * 0.1).min(0.025 * u), 0.01 * u)],
        WHITE,
    );
    knob(b, [x * 0.715, -y * 0.86, z], (y * 0.09).min(0.022 * u), 0.02 * u, (BLACK_PLASTIC, WHITE));
}

/// A bean hopper on top, a chute, and a cup for the ground coffee at the bottom.
pub(super) fn coffee_grinder(b: &mut Build<'_>) {
    let u = fit(b, [0.08, 0.08, 0.144]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[STEEL, BLACK_METAL, RED_METAL, WHITE_METAL, BLACK_PLASTIC]);
    let r = x.min(y);
    let (cut, wall) = (h * b.vary(0.58, 0.66), 0.003 * u);
    if h > 0.24 {
        b.rounded_block("foot", [-x, -y, 0.0], [x, y, h * 0.07], 0.008 * u, body);
        b.rounded_block("body", [-x * 0.95, -y * 0.85, h * 0.06], [x * 0.2, y * 0.85, cut], 0.012 * u, body);
        b.block("chute", [x * 0.18, -y * 0.25, cut - h * 0.16], [x * 0.62, y * 0.25, cut - h * 0.05], BLACK_PLASTIC);
        b.lathe("cup", [x * 0.58, 0.0, h * 0.068], &cup_profile(r * 0.36, r * 0.4, h * 0.2, wall), CLEAR_PLASTIC);
    } else {
        b.lathe("body", [0.0; 3], &[(r * 0.92, 0.0), (r, h * 0.1), (r * 0.88, cut)], body);
        b.block("switch", [r * 0.8, -r * 0.2, cut * 0.5], [r * 0.98, r * 0.2, cut * 0.7], GREY_PLASTIC);
    }
    let (low, wide) = (r * 0.62, r * 0.9);
    let tall = h * 0.93 - cut;
    let at = [if h > 0.24 { -x * 0.3 } else { 0.0 }, 0.0, cut - 0.001 * u];
    let spread = if h > 0.24 { wide.min(x * 0.7) } else { wide };
    b.lathe("hopper", at, &cup_profile(low.min(spread), spread, tall, wall), CLEAR_PLASTIC);
    b.lathe(
        "beans",
        [at[0], 0.0, at[2] + wall],
        &[(low.min(spread) - wall * 2.0, 0.0), (spread * 0.86 - wall * 2.0, tall * 0.4)],
        CHOCOLATE,
    );
    round_floor(b, "compartment_1", [at[0], 0.0, at[2] + wall + tall * 0.4], low * 0.9, tall * 0.55);
    lid(b, [at[0] - spread, 0.0, h], 1.5, |b| {
        b.lathe("lid", [at[0], 0.0, cut + tall], &[(spread, 0.0), (spread * 0.96, h * 0.07)], BLACK_PLASTIC);
    });
}
