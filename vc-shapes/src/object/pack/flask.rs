//! Bottles of non-round section: oval ones, jugs, sprays.

use super::flat::{self, PANEL};
use super::label::panel;
use super::look::look;
use crate::material::*;
use crate::solid::{Axis, Build, P, dims, loft_columns, planar_tube, rounded_ring, sweep, turn};

/// Oval bottles for bath and kitchen: with a flip cap, upside down on their cap, or with a pump.
pub(super) fn oval_bottle(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let look = look(b);
    let g = PANEL.min(x * 0.04);
    let (hx, hy) = (x / 2.0 - g, y / 2.0);
    let pump = match b.class {
        "hand_soap" => true,
        "lotion_bottle" | "shampoo" | "conditioner" => b.rng.chance(0.4),
        _ => false,
    };
    let round = b.choose(&[1.0, 0.8, 0.5]);
    let h = z * if pump { 0.72 } else { b.vary(0.84, 0.9) };
    let at = |z: f32, kx: f32, ky: f32| rounded_ring(z, (hx * kx, hy * ky), round);
    let inverted = !pump
        && matches!(b.class, "ketchup" | "mayonnaise" | "conditioner" | "hair_product" | "sunscreen")
        && b.rng.chance(0.5);
    let neck = (hx * 0.5).min(hy * 0.42);
    let ring = |z: f32, r: f32| rounded_ring(z, (r, r), 1.0);
    if inverted {
        let low = z - h;
        loft_columns(b, "cap", &[at(0.0, 0.85, 0.8), at(low, 0.88, 0.84)], look.cap);
        loft_columns(
            b,
            "bottle",
            &[
                at(low, 0.84, 0.8),
                at(low + h * 0.1, 0.97, 0.95),
                at(low + h * 0.5, 1.0, 1.0),
                at(z * 0.93, 0.9, 0.95),
                at(z, 0.6, 0.75),
            ],
            look.body,
        );
        return panel(b, hx, (0.0, hy * 0.55), (low + h * 0.25, low + h * 0.72), look.label());
    }
    let waist = if b.class == "dish_soap" { 0.8 } else { b.vary(0.9, 1.0) };
    let shoulder = b.vary(0.72, 0.86);
    loft_columns(
        b,
        "bottle",
        &[
            at(0.0, 0.92, 0.95),
            at(h * 0.03, 1.0, 1.0),
            at(h * 0.35, 1.0, 1.0),
            at(h * 0.6, 1.0, waist),
            at(h * shoulder, 0.97, waist),
            at(h * 0.93, 0.7, 0.62),
            ring(h * 0.96, neck),
            ring(h, neck),
        ],
        look.body,
    );
    panel(b, hx, (0.0, hy * (waist - 1.0 + 0.6)), (h * 0.12, h * 0.6), look.label());
    if pump {
        return pump_head(b, (neck, h, z), look.cap);
    }
    let cap = match b.class {
        "dish_soap" | "mustard" | "ketchup" | "condiment_bottle" | "chocolate_syrup" => vec![
            ring(h * 0.99, neck * 1.2),
            ring(h + (z - h) * 0.45, neck * 1.1),
            ring(h + (z - h) * 0.5, neck * 0.5),
            ring(z, neck * 0.3),
        ],
        _ => vec![ring(h * 0.99, neck * 1.25), ring(z * 0.99, neck * 1.2), ring(z, neck * 1.1)],
    };
    loft_columns(b, "cap", &cap, look.cap);
}

/// A pump on a neck: collar, rod and spout to the front.
fn pump_head(b: &mut Build<'_>, (neck, h, z): (f32, f32, f32), mat: MaterialId) {
    let room = z - h;
    b.cylinder("collar", [0.0, 0.0, h * 0.98], neck * 1.15, room * 0.3, mat);
    b.cylinder("rod", [0.0, 0.0, h], neck * 0.35, room * 0.75, mat);
    b.cylinder("head", [0.0, 0.0, z - room * 0.32], neck * 0.7, room * 0.3, mat);
    let reach = (b.size.x / 2.0).min(neck * 3.0).max(neck * 0.8);
    let w = (neck * 0.25).min(room * 0.12);
    let path = [
        ([0.0, 0.0, z - w], w * 1.5, w),
        ([reach * 0.6, 0.0, z - w], w, w),
        ([reach - w, 0.0, z - w * 2.4], w * 0.8, w * 0.8),
    ];
    sweep(b, "spout", &path, [0.0, 1.0, 0.0], mat);
}

/// Spray bottles with a trigger.
pub(super) fn trigger_spray(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let look = look(b);
    let g = PANEL.min(x * 0.04);
    let (hx, hy) = (x / 2.0 - g, y / 2.0);
    let h = z * 0.74;
    let round = b.choose(&[0.9, 0.6]);
    let at = |z: f32, kx: f32, ky: f32| rounded_ring(z, (hx * kx, hy * ky), round);
    let neck = (hx * 0.55).min(hy * 0.35);
    let ring = |z: f32, r: f32| rounded_ring(z, (r, r), 1.0);
    loft_columns(
        b,
        "bottle",
        &[
            at(0.0, 0.93, 0.9),
            at(h * 0.03, 1.0, 0.96),
            at(h * 0.55, 1.0, 0.96),
            at(h * 0.75, 0.85, 0.6),
            at(h * 0.85, 0.8, 0.5),
            ring(h * 0.97, neck),
            ring(h, neck),
        ],
        look.body,
    );
    panel(b, hx, (0.0, hy * 0.55), (h * 0.1, h * 0.55), look.label());
    b.cylinder("collar", [0.0, 0.0, h * 0.98], neck * 1.2, z * 0.115, look.cap);
    // The nozzle points to +Y, along the longer side.
    let w = neck * 0.75;
    let top = z - h;
    let head = [
        (-hy * 0.55, h + top * 0.35),
        (hy * 0.2, h + top * 0.35),
        (hy * 0.75, h + top * 0.6),
        (hy * 0.75, z - top * 0.05),
        (-hy * 0.2, z),
        (-hy * 0.6, z - top * 0.2),
    ];
    b.prism("head", Axis::X, [-w, 0.0, 0.0], &head, 2.0 * w, look.cap);
    b.rod("nozzle", [0.0, hy * 0.7, z - top * 0.22], [0.0, hy, z - top * 0.22], (top * 0.15).min(w), look.ink);
    let t = w * 0.35;
    sweep(
        b,
        "trigger",
        &[
            ([0.0, hy * 0.55, h + top * 0.5], w * 0.6, t),
            ([0.0, hy * 0.62, h + top * 0.1], w * 0.6, t),
            ([0.0, hy * 0.85, h - top * 0.25], w * 0.5, t),
        ],
        [1.0, 0.0, 0.0],
        look.cap,
    );
}

/// Large bottles with a grip: detergent, softener, bleach.
pub(super) fn jug_bottle(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    if b.class == "laundry_detergent" && b.rng.chance(0.3) {
        return flat::carton_box(b);
    }
    let look = look(b);
    let g = PANEL.min(x * 0.04);
    let (hx, hy) = (x / 2.0 - g, y / 2.0);
    let h = z * 0.84;
    let at = |z: f32, kx: f32, (y0, y1): (f32, f32)| {
        rounded_ring(z, (hx * kx, hy * (y1 - y0) / 2.0), 0.45)
            .into_iter()
            .map(|p| [p[0], p[1] + hy * (y0 + y1) / 2.0, p[2]])
            .collect::<Vec<P>>()
    };
    // The grip is on the +Y side of the upper half; the neck leans to -Y.
    let rings = [
        at(0.0, 0.93, (-0.95, 0.95)),
        at(h * 0.03, 1.0, (-1.0, 1.0)),
        at(h * 0.52, 1.0, (-1.0, 1.0)),
        at(h * 0.62, 0.97, (-1.0, 0.35)),
        at(h * 0.82, 0.9, (-1.0, 0.3)),
        at(h * 0.97, 0.5, (-0.75, 0.05)),
        at(h, 0.45, (-0.7, 0.0)),
    ];
    loft_columns(b, "bottle", &rings, look.body);
    let w = (hx * 0.32).min(hy * 0.18);
    let path = [
        [0.0, hy * 0.05, h * 0.88],
        [0.0, hy * 0.55, h * 0.9],
        [0.0, hy - w, h * 0.8],
        [0.0, hy - w, h * 0.62],
        [0.0, hy * 0.8, h * 0.5],
    ];
    planar_tube(b, "grip", &path, w, [1.0, 0.0, 0.0], look.body);
    let (cy, r) = (-hy * 0.35, (hx * 0.62).min(hy * 0.42));
    turn(
        b,
        "cap",
        [0.0, cy, h * 0.99],
        (r, z - h * 0.99),
        &[(0.95, 0.0), (1.0, 0.1), (0.88, 0.95), (0.8, 1.0)],
        look.cap,
    );
    panel(b, hx, (-hy * 0.1, hy * 0.65), (h * 0.08, h * 0.48), look.label());
}

/// The toilet cleaner bottle with a bent neck that reaches under a rim.
pub(super) fn bent_bottle(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let look = look(b);
    let g = PANEL.min(x * 0.04);
    let (hx, hy) = (x / 2.0 - g, y / 2.0);
    let at = |z: f32, kx: f32, shift: f32, ky: f32| {
        rounded_ring(z, (hx * kx, hy * ky), 0.8)
            .into_iter()
            .map(|p| [p[0], p[1] + hy * shift, p[2]])
            .collect::<Vec<P>>()
    };
    let rings = [
        at(0.0, 0.93, -0.14, 0.8),
        at(z * 0.03, 1.0, -0.14, 0.86),
        at(z * 0.5, 1.0, -0.14, 0.86),
        at(z * 0.68, 0.75, -0.1, 0.55),
        at(z * 0.8, 0.5, 0.1, 0.34),
    ];
    loft_columns(b, "bottle", &rings, look.body);
    let r = (hx * 0.45).min(hy * 0.3);
    let path = [
        ([0.0, hy * 0.08, z * 0.78], r, r),
        ([0.0, hy * 0.2, z * 0.84], r * 1.05, r),
        ([0.0, hy * 0.55, z * 0.92], r * 0.9, r * 0.85),
        ([0.0, hy * 0.86, z * 0.965], r * 0.55, r * 0.45),
    ];
    sweep(b, "cap", &path, [1.0, 0.0, 0.0], look.cap);
    b.block("crest", [-r * 0.3, hy * 0.2, z * 0.9], [r * 0.3, hy * 0.5, z], look.cap);
    panel(b, hx, (-hy * 0.14, hy * 0.55), (z * 0.1, z * 0.48), look.label());
}
