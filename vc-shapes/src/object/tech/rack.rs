//! Flat boxes with fronts: players, amplifiers, consoles, drives and routers.

use super::super::decor::clock::digits;
use super::{case, grid};
use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, blocks, half_dims, lengthwise};

/// A rack component: feet, a front with a display, knobs or a disc tray.
pub(super) fn rack(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[BLACK_METAL, SILVER_METAL, BLACK_METAL, GREY_PLASTIC]);
    let dark = if body == SILVER_METAL { BLACK_PLASTIC } else { GREY_PLASTIC };
    let foot = (h * 0.1).min(0.01);
    let out = (x * 0.08).min(0.018);
    let front = x - out;
    if b.class == "console" && b.rng.chance(0.5) {
        return swept(b);
    }
    b.block("case", [-x, -y * 0.99, foot + h * 0.03], [front - out * 0.4, y * 0.99, h], body);
    let z = |t: f32| foot + (h - foot) * t;
    let slot = match b.class {
        "stereo" => Some(((-y * 0.85, -y * 0.28), (z(0.55), z(0.8)))),
        "dvd_player" | "console" => Some(((-y * 0.7, y * 0.1), (z(0.5), z(0.75)))),
        _ => None,
    };
    let face = if body == BLACK_METAL { BLACK_PLASTIC } else { body };
    panel(b, ([front - out * 0.5, -y, foot], [front, y, h * 0.98]), slot, face);
    let mut feet = MeshBuilder::default();
    for (sx, sy) in [(-0.8, -0.85), (-0.8, 0.85), (0.7, -0.85), (0.7, 0.85)] {
        feet.block([x * sx - foot, y * sy - foot, 0.0], [x * sx + foot, y * sy + foot, foot + h * 0.035]);
    }
    feet.put(b, "foot", RUBBER);
    b.top("top", [-out * 0.7, 0.0, h], (x - out, y * 0.95));
    let glow = b.choose(&[PICTURE_SKY, LED, SIGNAL_RED, COOL_BULB]);
    let window = ([front - out * 0.3, -y * 0.2, z(0.45)], [front + 0.0006, y * 0.3, z(0.85)]);
    match b.class {
        "audio_amplifier" | "stereo" => {
            let r = (h * 0.2).min(y * 0.12);
            let knob = |b: &mut Build<'_>, py: f32, pz: f32, r: f32| {
                b.lathe_along(
                    "knob",
                    [front - 0.001, py, pz],
                    [x, py, pz],
                    &[(r, 0.0), (r * 0.95, out * 0.9), (r * 0.85, out)],
                    SILVER_METAL,
                );
            };
            knob(b, y * 0.7, z(0.5), r * 1.3);
            for i in 0..b.rng.count(3, 5) {
                knob(b, -y * 0.75 + y * 0.22 * i as f32, z(0.28), r * 0.5);
            }
            blocks(b, "window", &[window], SCREEN);
            digits(b, [front, y * 0.05, z(0.65)], (y * 0.2, (h - foot) * 0.12), 0.0014, glow);
            if b.class == "stereo" {
                tray(b, (front, out), slot, dark);
            }
            let vents = grid((1, 9), |_, j| {
                ([-x * 0.7, -y * 0.8 + y * 0.18 * j, h - 0.003], [x * 0.4, -y * 0.72 + y * 0.18 * j, h + 0.0006])
            });
            blocks(b, "vent", &vents, SCREEN);
        }
        class => {
            let disc = class == "dvd_player" || class == "console";
            if disc {
                tray(b, (front, out), slot, dark);
            }
            let narrow = ([front - out * 0.3, y * 0.25, z(0.4)], [front + 0.0006, y * 0.8, z(0.85)]);
            blocks(b, "window", &[narrow], SCREEN);
            digits(b, [front, y * 0.52, z(0.62)], (y * 0.2, (h - foot) * 0.14), 0.0014, glow);
            let keys = grid((1, 4), |_, j| {
                (
                    [front - out * 0.3, -y * 0.6 + y * 0.12 * j, z(0.18)],
                    [front + out * 0.4, -y * 0.53 + y * 0.12 * j, z(0.3)],
                )
            });
            blocks(b, "key", &keys, dark);
        }
    }
    b.rod(
        "power",
        [front - 0.001, -y * 0.88, z(0.3)],
        [front + out * 0.5, -y * 0.88, z(0.3)],
        (h * 0.07).min(y * 0.05),
        SILVER_METAL,
    );
}

/// The opening of a front: ranges of width and height.
type Slot = Option<((f32, f32), (f32, f32))>;

/// A front panel with or without a slot.
fn panel(b: &mut Build<'_>, (low, high): (P, P), slot: Slot, mat: MaterialId) {
    let Some(((y0, y1), (z0, z1))) = slot else { return b.block("front", low, high, mat) };
    let list = [
        (low, [high[0], high[1], z0]),
        ([low[0], low[1], z1], high),
        ([low[0], low[1], z0 * 0.999], [high[0], y0, z1 * 1.001]),
        ([low[0], y1, z0 * 0.999], [high[0], high[1], z1 * 1.001]),
    ];
    blocks(b, "front", &list, mat);
}

/// A tray for discs that slides out of the slot in the front.
fn tray(b: &mut Build<'_>, (front, out): (f32, f32), slot: Slot, mat: MaterialId) {
    let Some(((y0, y1), (z0, z1))) = slot else { return };
    let deep = b.size.x * 0.45;
    let (gap, drop) = ((y1 - y0) * 0.01, (z1 - z0) * 0.03);
    b.slide([1.0, 0.0, 0.0], deep * 0.8, |b| {
        b.block("tray", [front - out * 0.45, y0 + gap, z0 + drop], [front + out * 0.15, y1 - gap, z1 - drop], mat);
        let low = [front - deep, y0 + 2.0 * gap, z0 + (z1 - z0) * 0.1];
        b.block("tray", low, [front - out * 0.4, y1 - 2.0 * gap, z0 + (z1 - z0) * 0.4], BLACK_PLASTIC);
    });
}

/// A lying game console with curved plates around a dark core.
fn swept(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let plate = b.choose(&[WHITE_PLASTIC, BLACK_PLASTIC, WHITE_PLASTIC]);
    b.block("core", [-x * 0.94, -y * 0.97, h * 0.12], [x * 0.96, y * 0.97, h * 0.88], SCREEN);
    for (z, flip) in [(h, -1.0_f32), (0.0, 1.0)] {
        let bend = |t: f32| z + flip * h * (0.2 - 0.2 * t);
        let curve = [(-1.0, 0.4), (-0.5, 0.95), (0.0, 1.0), (0.5, 0.85), (1.0, 0.2)];
        let outer = curve.iter().map(|&(u, t)| (u * x, bend(t)));
        let inner = curve.iter().rev().map(|&(u, t)| (u * x, bend(t) + flip * h * 0.12));
        let outline: Vec<(f32, f32)> = outer.chain(inner).collect();
        b.prism("plate", Axis::Y, [0.0, -y, 0.0], &outline, 2.0 * y, plate);
    }
    b.block("light", [x * 0.9, -y * 0.9, h * 0.7], [x * 0.97, y * 0.9, h * 0.74], PICTURE_SKY);
    b.top("top", [0.0, 0.0, h], (x * 0.3, y * 0.9));
    b.slide([1.0, 0.0, 0.0], 0.1_f32.min(x), |b| {
        b.block("disc", [x * 0.1, -y * 0.5, h * 0.415], [x * 0.968, 0.0, h * 0.435], SILVER_METAL);
    });
}

/// A small box with ports or lights: dock, drive, switch, power bank.
pub(super) fn small(b: &mut Build<'_>) {
    lengthwise(b, |b, x, y, h| {
        let body = case(b);
        let relief = (x * 0.03).min(0.0015);
        b.rounded_block("case", [-x, -y, 0.0], [x - relief, y, h - relief], h * 0.25, body);
        let front = x - relief;
        let (dark, glow) = (if body == BLACK_PLASTIC { SCREEN } else { BLACK_PLASTIC }, b.choose(&[LED, PICTURE_SKY]));
        let count = match b.class {
            "network_switch" => ((y * 2.0 / 0.022) as usize).clamp(4, 10),
            "docking_station" => 5,
            _ => 2,
        };
        let pitch = y * 1.6 / count as f32;
        let ports = grid((1, count), |_, j| {
            (
                [front - relief, -y * 0.8 + pitch * j, h * 0.25],
                [front + relief * 0.5, -y * 0.8 + pitch * (j + 0.72), h * 0.68],
            )
        });
        blocks(b, "port", &ports, if body == BLACK_PLASTIC { GREY_PLASTIC } else { SCREEN });
        if b.class == "network_switch" {
            let lights = grid((1, count), |_, j| {
                ([front - relief, -y * 0.8 + pitch * (j + 0.2), h * 0.76], [x, -y * 0.8 + pitch * (j + 0.4), h * 0.86])
            });
            blocks(b, "light", &lights, LED);
        } else {
            let lights = grid((1, 4), |_, j| {
                ([-x * 0.8, -y * 0.7 + y * 0.1 * j, h - relief * 2.0], [-x * 0.7, -y * 0.65 + y * 0.1 * j, h])
            });
            blocks(b, "light", &lights, glow);
        }
        let mark = ([-x * 0.3, -y * 0.3, h - relief * 2.0], [x * 0.3, y * 0.3, h - relief * 0.3]);
        blocks(b, "mark", &[mark], dark);
    });
}

/// A router: a flat or upright box with antennas and lights.
pub(super) fn router(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[WHITE_PLASTIC, BLACK_PLASTIC]);
    let trim = if body == WHITE_PLASTIC { LIGHT_GREY } else { GREY_PLASTIC };
    let tall = if h > 0.09 { (h * 0.28).min(0.045) } else { h };
    let relief = (x * 0.02).min(0.001);
    b.rounded_block("case", [-x * 0.94, -y, 0.0], [x - relief, y, tall], tall * 0.3, body);
    let lights: Vec<(P, P)> = (0..5)
        .map(|i| y * (-0.4 + 0.2 * i as f32))
        .map(|a| ([x - relief * 3.0, a, tall * 0.4], [x, a + y * 0.06, tall * 0.55]))
        .collect();
    blocks(b, "light", &lights, LED);
    let vents = grid((1, 7), |_, j| {
        ([-x * 0.5, -y * 0.62 + y * 0.18 * j, tall - 0.002], [x * 0.5, -y * 0.56 + y * 0.18 * j, tall + relief * 0.6])
    });
    blocks(b, "vent", &vents, trim);
    if tall < h {
        let r = (y * 0.045).min(0.006).min(x * 0.05);
        let count = b.rng.count(2, 4);
        for i in 0..count {
            let py = y * (-0.85 + 1.7 * i as f32 / (count - 1) as f32);
            b.cylinder("joint", [-x * 0.94, py, tall * 0.3], r * 1.15, tall * 0.5, body);
            b.lathe(
                "aerial",
                [-x * 0.94, py, tall * 0.7],
                &[(r, 0.0), (r * 0.9, (h - tall * 0.7) * 0.95), (r * 0.5, h - tall * 0.7)],
                body,
            );
        }
    }
}
