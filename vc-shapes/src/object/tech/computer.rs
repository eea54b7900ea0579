//! Laptops and towers.

use std::f32::consts::FRAC_PI_2;

use nalgebra::{Isometry3, Vector3};

use super::super::decor::picture::{Canvas, Inks, motif};
use super::{case, grid};
use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, blocks, half_dims, hoop, oval};

/// A laptop, closed: keys and touch pad on the base, a screen in the lid.
pub(super) fn laptop(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[SILVER_METAL, ANTHRACITE, BLACK_PLASTIC, ALUMINIUM, WHITE_PLASTIC, NAVY]);
    let keys = if body == BLACK_PLASTIC || body == ANTHRACITE { ANTHRACITE } else { BLACK_PLASTIC };
    let (gap, base) = ((h * 0.17).min(0.003), h * 0.54);
    b.rounded_block("base", [-x, -y, 0.0], [x, y, base], h * 0.2, body);
    let (x0, px, py) = (-x * 0.78, x * 0.9 / 5.0, y * 1.72 / 12.0);
    let key = |i: f32, j: f32| {
        let (a, c) = (x0 + px * i, -y * 0.86 + py * j);
        ([a, c, base - gap], [a + px * 0.86, c + py * 0.86, base + gap * 0.3])
    };
    blocks(b, "keys", &grid((5, 12), key), keys);
    let pad = y * b.vary(0.25, 0.38);
    b.block("touch_pad", [x * 0.28, -pad, base - gap], [x * 0.88, pad, base + gap * 0.15], GREY_PLASTIC);
    let lid = base + gap;
    b.hinge([-x, 0.0, base], [0.0, -1.0, 0.0], 2.0, |b| {
        b.rounded_block("lid", [-x, -y, lid], [x, y, h], h * 0.12, body);
        b.block("bezel", [-x * 0.97, -y * 0.98, lid - gap * 0.15], [x * 0.97, y * 0.98, lid + gap * 0.5], SCREEN);
        let under = Isometry3::new(Vector3::new(0.0, 0.0, lid - gap * 0.15), Vector3::y() * FRAC_PI_2);
        let canvas = Canvas { half: (y * 0.94, x * 0.9), step: gap * 0.13 };
        b.posed(under, |b| motif(b, canvas, [0.0; 3], Inks::screen()));
        let logo = b.vary(0.06, 0.1) * x;
        b.prism(
            "logo",
            Axis::Z,
            [0.0, 0.0, h - h * 0.05],
            &crate::solid::ngon((logo, logo), 6),
            h * 0.05 + 0.0006,
            CHROME,
        );
        b.rod(
            "hinge",
            [-x + h * 0.2, -y * 0.7, base + gap * 0.5],
            [-x + h * 0.2, y * 0.7, base + gap * 0.5],
            gap * 0.6,
            BLACK_PLASTIC,
        );
    });
}

/// A tower computer; with a glass side and coloured fans for gaming, with bays of disks for a
/// server.
pub(super) fn tower(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let (gaming, server) = (b.class == "gaming_computer", b.class == "server");
    let body = if gaming { b.choose(&[BLACK_METAL, WHITE_METAL, ANTHRACITE]) } else { case(b) };
    let foot = h * 0.03;
    let relief = (x * 0.02).min(0.004);
    let front = x - relief;
    let side = if gaming { y * 0.86 } else { y };
    b.block("case", [-x, -y, foot], [front * 0.9, side, h * 0.995], body);
    b.rounded_block(
        "front",
        [front * 0.9 - 0.001, -y * 0.995, foot],
        [front, y * 0.995, h],
        x * 0.05,
        if body == WHITE_METAL { WHITE_PLASTIC } else { BLACK_PLASTIC },
    );
    let mut feet = MeshBuilder::default();
    for (sx, sy) in [(-0.8, -0.7), (-0.8, 0.7), (0.75, -0.7), (0.75, 0.7)] {
        feet.block([x * sx - foot, y * sy - foot, 0.0], [x * sx + foot, y * sy + foot, foot * 1.2]);
    }
    feet.put(b, "foot", RUBBER);
    let at = |y0: f32, y1: f32, z0: f32, z1: f32| {
        ([front - relief, y * y0, foot + (h - foot) * z0], [x, y * y1, foot + (h - foot) * z1])
    };
    if server {
        let rows = ((h / 0.05) as usize).clamp(2, 6);
        let pitch = 0.8 / rows as f32;
        let columns = if y > 0.12 { 2 } else { 1 };
        let wide = 1.8 / columns as f32;
        blocks(
            b,
            "bay",
            &grid((rows, columns), |i, j| {
                at(-0.9 + wide * j, -0.92 + wide * (j + 1.0), 0.06 + pitch * i, 0.04 + pitch * (i + 1.0))
            }),
            GREY_PLASTIC,
        );
        let lights = grid((rows, columns), |i, j| {
            let (l, h) = at(-0.84 + wide * j, -0.78 + wide * j, 0.06 + pitch * (i + 0.3), 0.06 + pitch * (i + 0.6));
            (l, [h[0] + 0.0008, h[1], h[2]])
        });
        blocks(b, "light", &lights, LED);
        blocks(b, "panel", &[at(-0.9, 0.9, 0.9, 0.96)], SCREEN);
        return;
    }
    let glow = b.choose(&[PICTURE_SKY, SIGNAL_RED, LED, PICTURE_SUN, COOL_BULB]);
    if gaming {
        fans(b, (front, foot), relief, glow);
        window(b, side, foot, glow);
    } else {
        match b.rng.below(3) {
            0 => blocks(b, "drive", &[at(-0.85, 0.85, 0.84, 0.92), at(-0.85, 0.85, 0.73, 0.81)], GREY_PLASTIC),
            1 => {
                let slots: Vec<(P, P)> =
                    (0..10).map(|i| 0.1 + 0.055 * i as f32).map(|z| at(-0.7, 0.7, z, z + 0.025)).collect();
                blocks(b, "vent", &slots, SCREEN);
            }
            _ => blocks(b, "panel", &[at(-0.95, -0.5, 0.05, 0.97)], GREY_PLASTIC),
        }
        blocks(b, "port", &[at(-0.3, -0.1, 0.655, 0.675), at(0.1, 0.3, 0.655, 0.675)], SCREEN);
    }
    b.rod(
        "button",
        [front - relief, y * 0.6, foot + (h - foot) * 0.695],
        [x, y * 0.6, foot + (h - foot) * 0.695],
        y * 0.07,
        SILVER_METAL,
    );
    blocks(b, "light", &[at(0.35, 0.45, 0.68, 0.7)], glow);
}

/// Rings of light in the front.
fn fans(b: &mut Build<'_>, (front, foot): (f32, f32), relief: f32, glow: MaterialId) {
    let (_, y, h) = half_dims(b);
    let r = (y * 0.75).min((h - foot) * 0.1);
    for i in 0..3 {
        let at = [front, -y * 0.1, foot + (h - foot) * (0.14 + 0.21 * i as f32)];
        hoop(b, "fan", &oval(Axis::X, at, (r, r), 0, 20), relief * 0.95, glow);
        b.rod("hub", [front - relief, at[1], at[2]], [front + relief * 0.5, at[1], at[2]], r * 0.3, BLACK_PLASTIC);
    }
}

/// The interior visible through the glass side.
fn window(b: &mut Build<'_>, side: f32, foot: f32, glow: MaterialId) {
    let (x, y, h) = half_dims(b);
    let deep = y - side;
    let at = |x0: f32, x1: f32, z0: f32, z1: f32, d: f32| {
        ([x * x0, side - 0.001, foot + (h - foot) * z0], [x * x1, side + deep * d, foot + (h - foot) * z1])
    };
    blocks(b, "board", &[at(-0.85, 0.6, 0.25, 0.95, 0.1)], ANTHRACITE);
    blocks(b, "card", &[at(-0.8, 0.5, 0.4, 0.48, 0.7), at(-0.85, 0.75, 0.03, 0.2, 0.6)], BLACK_METAL);
    blocks(
        b,
        "memory",
        &[at(0.1, 0.14, 0.58, 0.85, 0.5), at(0.18, 0.22, 0.58, 0.85, 0.5), at(-0.8, 0.5, 0.485, 0.5, 0.6)],
        glow,
    );
    let r = (h - foot) * 0.09;
    for z in [0.72, 0.3] {
        let centre = [-x * 0.45, side + deep * 0.12, foot + (h - foot) * z];
        hoop(b, "fan", &oval(Axis::Y, centre, (r, r), 0, 18), deep * 0.14, glow);
    }
    b.block("window", [-x * 0.98, y - deep * 0.15, foot + h * 0.008], [x * 0.88, y, h * 0.985], CLEAR_PLASTIC);
}
