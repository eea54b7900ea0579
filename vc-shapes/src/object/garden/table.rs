//! Garden tables.

use std::f32::consts::TAU;

use super::seat::{METALS, WOODS};
use crate::material::*;
use crate::object::joinery::legs;
use crate::solid::{Axis, Build, at_least, polar, spaced};

/// A garden or bistro table: slats, a plate or glass, on legs or a central foot.
pub(super) fn table(b: &mut Build<'_>) {
    at_least(b, [0.25, 0.25, 0.33]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let bistro = b.class == "bistro_table" || (y < 0.5 && b.rng.chance(0.4));
    let (wood, metal) = (b.one_of(WOODS), b.one_of(METALS));
    let round = if bistro { b.rng.chance(0.75) } else { (x - y).abs() < 0.12 && b.rng.chance(0.6) };
    let t = b.vary(0.018, 0.03);
    let r = x.min(y);
    let top = b.rng.below(3);
    if round {
        let mat = b.choose(&[wood, metal, FROSTED_GLASS, GRANITE]);
        b.lathe("top", [0.0, 0.0, h - t], &[(r - 0.005, 0.0), (r, t * 0.3), (r, t), (0.0, t)], mat);
        b.top("top", [0.0, 0.0, h], (r * 0.69, r * 0.69));
    } else {
        match top {
            0 => {
                let slats = ((2.0 * x / b.vary(0.07, 0.12)) as usize).clamp(3, 14);
                let half = x / slats as f32;
                for cx in spaced(slats, -x + half, x - half) {
                    b.block("slat", [cx - half + 0.004, -y, h - t], [cx + half - 0.004, y, h], wood);
                }
                for cy in [-y * 0.75, 0.0, y * 0.75] {
                    b.block(
                        "batten",
                        [-x + 0.03, cy - 0.03, h - t - 0.022],
                        [x - 0.03, cy + 0.03, h - t + 0.004],
                        wood,
                    );
                }
            }
            1 => {
                b.block("rim", [-x, -y, h - t - 0.015], [x, y, h - 0.004], metal);
                b.block("glass", [-x + 0.025, -y + 0.025, h - 0.009], [x - 0.025, y - 0.025, h], FROSTED_GLASS);
            }
            _ => b.rounded_block("top", [-x, -y, h - t], [x, y, h], 0.008, wood),
        }
        b.top("top", [0.0, 0.0, h], (x - 0.03, y - 0.03));
    }
    let under = h - t - if !round && top == 1 { 0.012 } else { -0.003 };
    if bistro {
        let spread = r * b.vary(0.6, 0.8);
        foot(b, spread, under, metal);
        return;
    }
    let mat = if top == 1 { metal } else { wood };
    let leg = b.vary(0.04, 0.07);
    let half = if round { (r * 0.68, r * 0.68) } else { (x - 0.03, y - 0.03) };
    let round_legs = b.rng.chance(0.4);
    legs(b, half, under, leg, round_legs, mat);
    let rail = (half.0 - leg * 0.5, half.1 - leg * 0.5);
    for s in [-1.0, 1.0] {
        b.block("apron", [-rail.0, s * rail.1 - 0.011, under - 0.08], [rail.0, s * rail.1 + 0.011, under - 0.002], mat);
        b.block(
            "apron",
            [s * rail.0 - 0.011, -rail.1, under - 0.078],
            [s * rail.0 + 0.011, rail.1, under - 0.003],
            mat,
        );
    }
}

/// A column on three or four feet, or on a disc.
fn foot(b: &mut Build<'_>, r: f32, top: f32, metal: MaterialId) {
    b.cylinder("column", [0.0, 0.0, 0.012], 0.025, top - 0.012, metal);
    b.cylinder("plate", [0.0, 0.0, top - 0.012], r * 0.45, 0.012, metal);
    match b.rng.below(3) {
        0 => b.lathe("foot", [0.0; 3], &[(r, 0.0), (r, 0.012), (r * 0.3, 0.03), (0.025, 0.06)], metal),
        n => {
            let count = n + 2;
            for i in 0..count {
                let (px, py) = polar(TAU * i as f32 / count as f32 + 0.4, r - 0.017);
                b.cylinder("pad", [px, py, 0.0], 0.017, 0.014, BLACK_PLASTIC);
                b.pipe(
                    "foot",
                    &[[0.0, 0.0, top * 0.25], [px * 0.5, py * 0.5, top * 0.14], [px, py, 0.021]],
                    0.012,
                    metal,
                );
            }
        }
    }
}

/// A picnic table with benches along both sides.
pub(super) fn picnic_table(b: &mut Build<'_>) {
    at_least(b, [0.7, 0.75, 0.35]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = b.choose(&[PINE, OAK, TEAK, GREY_OAK, GREEN_PLASTIC, BROWN_PLASTIC]);
    let t = 0.035;
    let (top, seat) = (x * b.vary(0.46, 0.52), (h * 0.6).min(0.46));
    let bench = x * b.vary(0.15, 0.19);
    let boards = b.rng.count(4, 6);
    let half = top / boards as f32;
    for cx in spaced(boards, -top + half, top - half) {
        b.block("top", [cx - half + 0.004, -y, h - t], [cx + half - 0.004, y, h], mat);
    }
    b.top("top", [0.0, 0.0, h], (top - 0.02, y - 0.02));
    for s in [-1.0, 1.0] {
        let cx = s * (x - bench);
        for k in [-0.5, 0.5] {
            b.block(
                "bench",
                [cx + k * bench - bench * 0.47, -y, seat - t],
                [cx + k * bench + bench * 0.47, y, seat],
                mat,
            );
        }
        let name = if s > 0.0 { "seat_front" } else { "seat_rear" };
        b.top(name, [cx, 0.0, seat], (bench * 0.85, y - 0.04));
    }
    for cy in [-y * 0.7, y * 0.7] {
        b.block(
            "beam",
            [-x + bench * 0.4, cy - 0.02, seat - t - 0.09],
            [x - bench * 0.4, cy + 0.02, seat - t + 0.002],
            mat,
        );
        b.block("beam", [-top + 0.02, cy - 0.02, h - t - 0.08], [top - 0.02, cy + 0.02, h - t + 0.002], mat);
        for s in [-1.0_f32, 1.0] {
            let (foot, head) = (s * x * 0.72, s * top * 0.55);
            let leg = [(foot, 0.0), (foot - s * 0.1, 0.0), (head - s * 0.1, h - t - 0.001), (head, h - t - 0.001)];
            let out = if cy > 0.0 { 0.019 } else { -0.054 };
            b.prism("leg", Axis::Y, [0.0, cy + out, 0.0], &leg, 0.035, mat);
        }
    }
    b.block("stretcher", [-0.02, -y * 0.7, seat - 0.12], [0.02, y * 0.7, seat - 0.05], mat);
}
