//! Items for writing, drawing and erasing, and small stationery.

use std::f32::consts::TAU;

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, blocks, half_dims, hoop, longwise, ngon, spline, tube};

/// Pens, pencils, markers and brushes: shafts with a tip, along their longest side.
pub(super) fn stick(b: &mut Build<'_>) {
    longwise(b, |b, t, w, l| match b.class {
        "pencil" => pencil(b, t.min(w) / 2.0, l),
        "crayon" => crayon(b, t.min(w) / 2.0, l),
        "paintbrush" => brush(b, t / 2.0, w / 2.0, l),
        _ => pen(b, t.min(w) / 2.0, l),
    });
}

/// A section of the shaft as a solid of revolution.
fn turned(b: &mut Build<'_>, name: &str, profile: &[(f32, f32)], mat: MaterialId) {
    b.lathe(name, [0.0; 3], profile, mat);
}

fn pencil(b: &mut Build<'_>, r: f32, l: f32) {
    let paint = b.choose(&[YELLOW, RED, BLUE, GREEN, BLACK, OAK]);
    let rubber = b.rng.chance(0.6);
    let start = if rubber { l * 0.07 } else { 0.0 };
    b.prism("shaft", Axis::Z, [0.0, 0.0, start], &ngon((r, r), 6), l * 0.9 - start, paint);
    turned(b, "point", &[(r * 0.95, l * 0.9), (r * 0.3, l * 0.97), (r * 0.3, l * 0.968)], PINE);
    turned(b, "lead", &[(r * 0.3, l * 0.965), (0.0, l)], BLACK_PLASTIC);
    if rubber {
        turned(b, "ferrule", &[(r * 0.95, l * 0.025), (r * 0.95, l * 0.072)], BRASS);
        turned(b, "rubber", &[(r * 0.6, 0.0), (r * 0.85, l * 0.005), (r * 0.85, l * 0.03)], PINK_PLASTIC);
    }
}

fn crayon(b: &mut Build<'_>, r: f32, l: f32) {
    let (wax, card) = b.choose(&[
        (RED_PLASTIC, RED_CARD),
        (BLUE_PLASTIC, BLUE_CARD),
        (GREEN_PLASTIC, GREEN_CARD),
        (YELLOW_PLASTIC, YELLOW_CARD),
        (ORANGE_PLASTIC, ORANGE_CARD),
    ]);
    turned(b, "wax", &[(r * 0.86, 0.0), (r * 0.86, l * 0.86), (r * 0.5, l * 0.9), (r * 0.3, l)], wax);
    turned(b, "paper", &[(r, l * 0.06), (r, l * 0.82)], card);
}

fn brush(b: &mut Build<'_>, x: f32, y: f32, l: f32) {
    let handle = b.choose(&[OAK, RED, BLACK, BEECH, BLUE]);
    let (sx, sy) = (x.min(y) * 0.8, (y * 0.3).max(x.min(y) * 0.8));
    let ring = |z: f32, s: f32| crate::solid::oval(Axis::Z, [0.0, 0.0, z * l], (sx * s, sy * s), 0, 10);
    let mut shaft = MeshBuilder::default();
    shaft.loft(&[ring(0.0, 0.4), ring(0.02, 0.6), ring(0.35, 1.0), ring(0.62, 0.75)]);
    shaft.put(b, "handle", handle);
    b.block("ferrule", [-x, -y, l * 0.6], [x, y, l * 0.75], STEEL);
    b.taper("bristles", [0.0, 0.0, l * 0.745], (x * 0.8, y * 0.9), (x * 0.3, y * 0.85), l * 0.255, BLACK_FABRIC);
}

/// A pen, marker or pointer: barrel, cap or tip, clip.
fn pen(b: &mut Build<'_>, r: f32, l: f32) {
    let colours = [BLUE_PLASTIC, BLACK_PLASTIC, RED_PLASTIC, GREEN_PLASTIC, WHITE_PLASTIC, STEEL, PURPLE_PLASTIC];
    let (barrel, trim) = (b.choose(&colours), b.choose(&[STEEL, GOLD, BLACK_PLASTIC]));
    let clip = r * b.vary(0.2, 0.32);
    let body = r - clip;
    let (cap, slim) = (l * b.vary(0.52, 0.64), body * b.vary(0.8, 0.88));
    let (tip, clasp) = (l * b.vary(0.06, 0.13), l * b.vary(0.6, 0.72));
    if b.class == "marker" {
        turned(b, "barrel", &[(slim * 0.8, 0.0), (slim, l * 0.02), (slim, l * 0.66)], WHITE_PLASTIC);
        turned(b, "cap", &[(body, cap), (body, l * 0.97), (body * 0.8, l)], barrel);
        b.block("clip", [0.0, -clip, l * 0.68], [r, clip, l * 0.95], barrel);
        return;
    }
    if b.class == "laser_pointer" {
        turned(b, "barrel", &[(body, 0.0), (body, l * 0.985)], b.style.metal);
        turned(b, "lens", &[(body * 0.6, l * 0.98), (body * 0.5, l)], SIGNAL_RED);
        b.block("button", [0.0, -clip, l * 0.6], [r, clip, l * 0.68], GREY_PLASTIC);
        return;
    }
    turned(b, "tip", &[(r * 0.1, 0.0), (r * 0.2, l * 0.02), (slim * 0.85, tip)], trim);
    turned(b, "barrel", &[(slim * 0.84, tip * 0.95), (slim, tip + l * 0.05), (slim, l * 0.95)], barrel);
    if b.rng.chance(0.5) {
        turned(b, "button", &[(body * 0.5, l * 0.94), (body * 0.45, l)], trim);
    } else {
        turned(b, "cap", &[(body, cap), (body, l * 0.97), (body * 0.7, l)], barrel);
    }
    b.block("clip", [0.0, -clip * 0.5, clasp], [r, clip * 0.5, l * 0.94], trim);
}

/// An eraser in a paper sleeve, one end rounded by use.
pub(super) fn eraser(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let sleeve = b.choose(&[BLUE_CARD, GREEN_CARD, BLACK_CARD]);
    let edge = h * 0.06;
    b.rounded_block("rubber", [-x * 0.95, -y, edge], [x * 0.95, y, h - edge], h * 0.3, WHITE_PLASTIC);
    b.block("sleeve", [-x, -y * 0.9, 0.0], [x, y * 0.35, h], sleeve);
}

/// A ruler with its marks.
pub(super) fn ruler(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[PINE, CLEAR_PLASTIC, STEEL, YELLOW_PLASTIC, BEECH]);
    b.block("ruler", [-x, -y, 0.0], [x, y, h * 0.75], body);
    let marks: Vec<(P, P)> = (0..=30)
        .map(|i| {
            let at = y * (-0.95 + 1.88 * i as f32 / 30.0);
            let long = if i % 10 == 0 {
                0.9
            } else if i % 5 == 0 {
                0.6
            } else {
                0.4
            };
            ([-x * 0.97, at, h * 0.5], [-x * 0.97 + x * long, at + y * 0.012, h])
        })
        .collect();
    blocks(b, "mark", &marks, BLACK_PLASTIC);
}

/// A pencil sharpener: a metal wedge with a blade, or a tub.
pub(super) fn sharpener(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    if h > x {
        let tub = b.choose(&[RED_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC, CLEAR_PLASTIC]);
        let r = x.min(y);
        b.lathe("tub", [0.0; 3], &[(r * 0.9, 0.0), (r, h * 0.1), (r, h * 0.7)], tub);
        b.lathe(
            "top",
            [0.0, 0.0, h * 0.7],
            &[(r * 0.97, 0.0), (r * 0.8, h * 0.28), (r * 0.3, h * 0.3), (r * 0.2, h * 0.1)],
            BLACK_PLASTIC,
        );
        return;
    }
    b.taper("body", [0.0; 3], (x, y), (x * 0.7, y * 0.97), h * 0.85, ALUMINIUM);
    b.block("blade", [-x * 0.5, -y * 0.8, h * 0.8], [x * 0.3, y * 0.8, h * 0.95], STEEL);
    b.cylinder("screw", [-x * 0.1, 0.0, h * 0.85], x.min(y) * 0.2, h * 0.15, STEEL);
}

/// A paper clip: one bent wire.
pub(super) fn paper_clip(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = h / 2.0;
    let (x, y) = ((x - r).max(r), (y - r).max(r));
    let at = |u: f32, v: f32| [u * x * 0.96, v * y * 0.94, r];
    let bend = [
        at(-0.96, 0.4),
        at(-0.96, -0.6),
        at(-0.5, -1.0),
        at(0.4, -1.0),
        at(0.9, -0.6),
        at(0.9, 0.6),
        at(0.4, 1.0),
        at(-0.2, 1.0),
        at(-0.6, 0.7),
        at(-0.6, -0.4),
        at(-0.1, -0.7),
        at(0.4, -0.4),
        at(0.4, 0.5),
    ];
    let wire = b.choose(&[STEEL, STEEL, RED_PLASTIC, BLUE_PLASTIC]);
    tube(b, "wire", &spline(&bend, 2), r, wire);
}

/// A push pin with a waisted head, standing on its head.
pub(super) fn push_pin(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    let head = b.choose(&[RED_PLASTIC, BLUE_PLASTIC, YELLOW_PLASTIC, GREEN_PLASTIC, WHITE_PLASTIC]);
    let waist =
        [(r, 0.0), (r, h * 0.1), (r * 0.5, h * 0.15), (r * 0.45, h * 0.35), (r * 0.8, h * 0.4), (r * 0.8, h * 0.46)];
    b.lathe("head", [0.0; 3], &waist, head);
    b.lathe("pin", [0.0, 0.0, h * 0.45], &[(r * 0.1, 0.0), (r * 0.1, h * 0.45), (0.0, h * 0.55)], STEEL);
}

/// A rubber band lying in a loose loop.
pub(super) fn rubber_band(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = (h / 2.0).min(x * 0.4);
    let (wave, dent) = (b.vary(0.0, TAU), b.vary(0.0, 0.25));
    let points: Vec<P> = (0..32)
        .map(|i| {
            let a = TAU * i as f32 / 32.0;
            let s = 1.0 - dent * (0.5 + 0.5 * (2.0 * a + wave).sine());
            [(x - r) * a.cosine() * s, (y - r) * a.sine() * s, r]
        })
        .collect();
    let band = b.choose(&[RED_RUBBER, GREY_RUBBER, FOAM]);
    hoop(b, "band", &points, r, band);
}
