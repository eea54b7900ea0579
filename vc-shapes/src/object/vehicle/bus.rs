//! Buses and motorhomes: a hollow box with seats or living space.

use std::f32::consts::{FRAC_PI_2, PI};

use vc_graph::portable::Portable;

use super::car::pane;
use super::chassis::{Chassis, PAINTS};
use super::wheel::{Rim, axled};
use crate::material::*;
use crate::solid::{Axis, Build, at_least, spaced};

/// A bus: windows all around, seats inside, a door on the right that opens.
pub(super) fn bus(b: &mut Build<'_>) {
    at_least(b, [4.0, 1.2, 1.4]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let paint = b.one_of(PAINTS);
    let second = b.choose(&[WHITE_METAL, paint, YELLOW_METAL, ANTHRACITE]);
    let wheel = h * b.vary(0.145, 0.16);
    let (low, floor) = (h * 0.1, h * b.vary(0.17, 0.24));
    let (sill, head) = (floor + (h - floor) * b.vary(0.26, 0.34), h * b.vary(0.86, 0.9));
    let axles = [x * b.vary(0.5, 0.62), -x * b.vary(0.48, 0.58)];
    let hinge = (x * 0.97).min(x - 0.13);
    let door = (hinge - 1.1_f32.min(x * 0.25), hinge);
    let side_half = y - 0.03;
    let t = 0.05;
    for side in [-1.0, 1.0] {
        // The lower wall, cut out above the wheels and at the door.
        let end = if side < 0.0 { door.0 } else { x - 0.03 };
        let mut outline = vec![(-x + 0.03, low), (-x + 0.03, sill), (end, sill), (end, low)];
        let r = wheel * 1.13;
        let start = ((low - wheel) / r).arc_sine();
        for c in axles {
            let from = if c + r > end { continue } else { start };
            outline.extend(
                (0..=8)
                    .map(|i| from + (PI - 2.0 * from) * i as f32 / 8.0)
                    .map(|a| (c + r * a.cosine(), wheel + r * a.sine())),
            );
        }
        let cy = side * (side_half - t / 2.0);
        b.prism("wall", Axis::Y, [0.0, cy - t / 2.0, 0.0], &outline, t, paint);
        let panes = b.rng.count(5, 8);
        let step = (end + x - 0.1) / panes as f32;
        for cx in spaced(panes, -x + 0.05 + step / 2.0, end - 0.05 - step / 2.0) {
            b.block(
                "window",
                [cx - step / 2.0 + 0.03, cy - 0.008, sill],
                [cx + step / 2.0 - 0.03, cy + 0.008, head],
                GLASS,
            );
        }
        for cx in spaced(panes + 1, -x + 0.06, end - 0.06) {
            b.block("pillar", [cx - 0.04, cy - t * 0.4, sill], [cx + 0.04, cy + t * 0.4, head], ANTHRACITE);
        }
        b.block(
            "stripe",
            [-x + 0.1, cy - t / 2.0 - 0.004, sill - 0.16],
            [end - 0.1, cy + t / 2.0 + 0.004, sill - 0.06],
            second,
        );
        for (axle, letter) in axles.into_iter().zip(["f", "r"]) {
            let rim = Rim::plain(b);
            let name = format!("wheel_{letter}{}", if side > 0.0 { 'l' } else { 'r' });
            let at = [axle, side * (side_half - 0.02 - y * 0.11), wheel];
            axled(b, &name, at, (wheel, y * 0.22), side, rim, (side_half - t) * 0.72 - 0.002);
        }
        let (near, far) = (side * (y - 0.035), side * y);
        b.block("mirror", [x - 0.1, near.min(far), head - 0.4], [x - 0.02, near.max(far), head + 0.03], BLACK_PLASTIC);
    }
    // Floor between the wheels, raised at the wheels.
    let inner = side_half - t;
    b.block("floor", [-x + 0.04, -inner * 0.72, low], [x - 0.08, inner * 0.72, floor], GREY_RUBBER);
    for (from, to) in [(-x + 0.04, axles[1] - wheel * 1.2), (axles[1] + wheel * 1.2, axles[0] - wheel * 1.2)] {
        for side in [-1.0, 1.0] {
            let (a, c) = (side * inner * 0.72, side * inner);
            b.block("floor", [from, a.min(c), floor - 0.08], [to, a.max(c), floor - 0.001], GREY_RUBBER);
        }
    }
    b.block("rear", [-x, -side_half, low], [-x + 0.06, side_half, h - 0.06], paint);
    b.block(
        "rear_window",
        [-x - 0.0 + 0.0, -side_half * 0.75, sill],
        [-x + 0.063, side_half * 0.75, head],
        BLACK_GLASS,
    );
    b.block("front", [x - 0.1, -side_half, low], [x - 0.02, side_half, sill], paint);
    b.block("windscreen", [x - 0.07, -side_half + 0.02, sill - 0.005], [x - 0.05, side_half - 0.02, head], GLASS);
    b.block("destination", [x - 0.09, -y * 0.7, head - 0.01], [x - 0.012, y * 0.7, h - 0.08], SCREEN);
    b.block("destination", [x - 0.03, -y * 0.5, head + 0.02], [x - 0.008, y * 0.4, h - 0.12], SIGNAL_AMBER);
    b.rounded_block("roof", [-x + 0.005, -side_half, head], [x - 0.02, side_half, h - 0.02], 0.05, second);
    b.block("vent", [-x * 0.5, -y * 0.4, h - 0.05], [-x * 0.1, y * 0.4, h], second);
    for side in [-1.0, 1.0] {
        let cy = side * side_half * 0.75;
        b.block("headlight", [x - 0.05, cy - 0.16, low + 0.15], [x - 0.005, cy + 0.16, low + 0.3], COOL_BULB);
        b.block("tail_light", [-x - 0.0 + 0.002, cy - 0.1, low + 0.2], [-x + 0.062, cy + 0.1, low + 0.5], SIGNAL_RED);
    }
    b.block("bumper", [x - 0.1, -side_half, low - 0.04], [x, side_half, low + 0.12], ANTHRACITE);
    let dy = -(side_half - t / 2.0);
    b.hinge([door.1, dy, 0.0], [0.0, 0.0, 1.0], FRAC_PI_2, |b| {
        b.block("door", [door.0 + 0.005, dy - 0.012, low + 0.05], [door.1, dy + 0.012, head - 0.01], GLASS);
        for dx in [door.0 + 0.033, (door.0 + door.1) / 2.0, door.1 - 0.04] {
            b.block("door", [dx - 0.03, dy - 0.02, low + 0.02], [dx + 0.03, dy + 0.02, head - 0.02], ANTHRACITE);
        }
    });
    let rows = ((axles[0] - axles[1] - 2.2 * wheel) / 0.85) as usize;
    let cloth = b.choose(&[BLUE_FABRIC, RED_FABRIC, GREEN_FABRIC, GREY_FABRIC]);
    let last = (axles[0] - wheel * 2.2).min(axles[0] - wheel * 1.2 - 0.42);
    for cx in spaced(rows.clamp(2, 7), axles[1] + wheel * 1.4, last) {
        for side in [-1.0, 1.0] {
            let (a, c) = (side * inner * 0.34, side * inner * 0.96);
            b.block("seat", [cx, a.min(c), floor - 0.005], [cx + 0.4, a.max(c), floor + 0.42], cloth);
            b.block(
                "seat",
                [cx - 0.08, a.min(c), floor],
                [cx + 0.02, a.max(c), floor + 1.0_f32.min((h - floor) * 0.45)],
                cloth,
            );
        }
    }
    b.inside(
        "compartment",
        [(axles[0] + axles[1]) / 2.0, 0.0, floor],
        ((axles[0] - axles[1]) / 2.0, inner * 0.3),
        head - floor - 0.03,
    );
}

/// A motorhome: a van's nose under a box with an alcove, windows and a side door.
pub(super) fn camper_van(b: &mut Build<'_>) {
    at_least(b, [2.7, 1.0, 1.25]);
    let (l, h) = (b.size.x, b.size.z);
    let (x, y) = (l / 2.0, b.size.y / 2.0);
    let (paint, wheel) = (b.choose(&[WHITE_METAL, CREAM, SILVER_METAL, WHITE_METAL]), h * 0.12);
    let chassis =
        Chassis { front: x, half: y * 0.94, wheel, deck: wheel * 2.2, cab: x - l * b.vary(0.27, 0.32), paint };
    chassis.build(b);
    let nose = h * b.vary(0.66, 0.72);
    let low = wheel * 0.8;
    let (front, half) = (x - 0.06, y * 0.9);
    let (bonnet, scuttle) = (front - l * 0.11, low + (nose - low) * 0.52);
    let (arch, r) = (chassis.axles()[0], wheel * 1.15);
    let start = ((low - wheel) / r).arc_sine();
    let mut outline = vec![
        (chassis.cab, low),
        (chassis.cab, nose),
        (bonnet - (nose - scuttle) * 0.7, nose),
        (bonnet, scuttle),
        (front, scuttle * 0.84),
        (front, low),
    ];
    outline.extend(
        (0..=8)
            .map(|i| start + (PI - 2.0 * start) * i as f32 / 8.0)
            .map(|a| ((arch + r * a.cosine()).max(chassis.cab + 0.01), wheel + r * a.sine())),
    );
    b.prism("cab", Axis::Y, [0.0, -half, 0.0], &outline, 2.0 * half, paint);
    let top = bonnet - (nose - scuttle) * 0.7;
    let screen = [[bonnet, -half, scuttle], [bonnet, half, scuttle], [top, half, nose], [top, -half, nose]];
    pane(b, "windscreen", screen, (0.06, 0.94, 0.06, 0.9), BLACK_GLASS);
    for side in [1.0, -1.0] {
        let cy = side * half;
        let (f, k, t) = ([bonnet - 0.1, cy, scuttle], [chassis.cab + 0.1, cy, scuttle], [top - 0.05, cy, nose]);
        let kt = [k[0], cy, nose];
        let face = if side > 0.0 { [f, k, kt, t] } else { [k, f, t, kt] };
        pane(b, "window", face, (0.05, 0.9, 0.05, 0.85), BLACK_GLASS);
        b.block(
            "headlight",
            [front - 0.05, cy * 0.75 - 0.12, low + 0.2],
            [front + 0.02, cy * 0.75 + 0.12, low + 0.34],
            COOL_BULB,
        );
        b.block(
            "tail_light",
            [-x + 0.003, cy * 0.85 - 0.08, h * 0.28],
            [-x + 0.05, cy * 0.85 + 0.08, h * 0.4],
            SIGNAL_RED,
        );
        b.block(
            "mirror",
            [bonnet - 0.2, (side * y * 0.99).min(cy), scuttle + 0.02],
            [bonnet - 0.1, (side * y * 0.99).max(cy), scuttle + 0.25],
            BLACK_PLASTIC,
        );
    }
    b.block("bumper", [front - 0.1, -half, low - 0.02], [x, half, low + 0.16], GREY);
    b.block("grille", [front - 0.02, -half * 0.4, low + 0.2], [front + 0.015, half * 0.4, low + 0.32], BLACK_PLASTIC);
    living_box(b, &chassis, nose, y);
}

/// The hollow living space, its alcove over the cab, door, windows and awning.
fn living_box(b: &mut Build<'_>, chassis: &Chassis, nose: f32, y: f32) {
    let (x0, x1, h, t) = (-chassis.front + 0.02, chassis.cab + 0.05, b.size.z - 0.06, 0.04);
    let (low, paint, side) = (chassis.deck - 0.05_f32.min(chassis.wheel * 0.12), chassis.paint, y * 0.97);
    let stripe = b.choose(&[BLUE, RED, GREY, TERRACOTTA, FOREST]);
    let door = (x0 + (x1 - x0) * b.vary(0.5, 0.62), 0.62_f32.min((x1 - x0) * 0.2));
    let alcove = b.vary(0.6, 1.0) * (chassis.front - x1) * 0.55;
    b.block("floor", [x0 + t, -side + t, low], [x1, side - t, low + 0.07], OAK);
    b.block("roof", [x0, -side, h - t], [x1, side, h], paint);
    b.block("rear", [x0, -side, low], [x0 + t, side, h - t], paint);
    b.block("wall", [x0 + t, side - t, low], [x1, side, h - t], paint);
    b.block("front", [x1 - t, -side + t, nose - 0.01], [x1, side - t, h - t], paint);
    let door_top = low + 0.05 + (h - low) * 0.78;
    for (from, to, z) in [(x0 + t, door.0, low), (door.0 + door.1, x1, low), (door.0, door.0 + door.1, door_top)] {
        b.block("wall", [from, -side, z], [to, -side + t, h - t], paint);
    }
    b.taper(
        "alcove",
        [x1 + alcove / 2.0 - 0.02, 0.0, nose - 0.002],
        (alcove / 2.0, side * 0.98),
        (alcove / 2.0 * 0.7, side * 0.96),
        h - nose,
        paint,
    );
    b.hinge([door.0, -side, 0.0], [0.0, 0.0, -1.0], FRAC_PI_2 * 1.5, |b| {
        b.block(
            "door",
            [door.0 + 0.004, -side, low + 0.01],
            [door.0 + door.1 - 0.004, -side + t * 0.9, door_top - 0.004],
            CREAM,
        );
        b.block(
            "window",
            [door.0 + door.1 * 0.25, -side - 0.004, door_top - 0.7_f32.min(h * 0.3)],
            [door.0 + door.1 * 0.75, -side + 0.01, door_top - 0.15],
            BLACK_GLASS,
        );
        b.block(
            "handle",
            [door.0 + door.1 * 0.8, -side - 0.015, h * 0.5],
            [door.0 + door.1 * 0.92, -side + 0.005, h * 0.53],
            BLACK_PLASTIC,
        );
    });
    let (z0, z1) = (low + (h - low) * 0.48, low + (h - low) * 0.75);
    for (cx, sy) in [(x0 + (x1 - x0) * 0.25, -1.0), (x0 + (x1 - x0) * 0.25, 1.0), (x0 + (x1 - x0) * 0.7, 1.0)] {
        let wide = (x1 - x0) * 0.13;
        b.block("window", [cx - wide, sy * side - 0.008, z0], [cx + wide, sy * side + 0.008, z1], BLACK_GLASS);
    }
    b.block("window", [x0 - 0.008, -side * 0.5, z0], [x0 + 0.01, side * 0.5, z1], BLACK_GLASS);
    for sy in [-1.0, 1.0] {
        let z = low + (h - low) * 0.3;
        let from = if sy < 0.0 { door.0 - 0.05 } else { x1 - 0.1 };
        b.block("stripe", [x0 + 0.1, sy * side - 0.004, z], [from, sy * side + 0.004, z + 0.12], stripe);
    }
    b.rod(
        "awning",
        [x0 + (x1 - x0) * 0.2, -y + 0.05, h - 0.12],
        [x1 - 0.2, -y + 0.05, h - 0.12],
        0.045_f32.min(y * 0.04),
        WHITE,
    );
    b.block("rooflight", [x0 + 0.6, -0.3, h - 0.005], [x0 + 1.2, 0.3, b.size.z], FROSTED_GLASS);
    let centre = [(x0 + x1) / 2.0, 0.0, low + 0.07];
    b.inside("compartment", centre, ((x1 - x0) / 2.0 - 0.1, side - t - 0.03), h - low - 0.07 - t - 0.02);
}
