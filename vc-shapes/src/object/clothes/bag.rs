//! Bags with handles.

use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, arc, blocks, half_dims, loft, oval, spline};

/// Builds an open bag between two heights, wider at the top by `spread`, and returns its inner
/// bottom.
fn pouch(b: &mut Build<'_>, (x, y): (f32, f32), high: f32, spread: f32, mat: MaterialId) {
    let t = (x * 0.04).min(0.004).min(high * 0.05);
    let ring = |z: f32, s: f32, t: f32| oval(Axis::Z, [0.0, 0.0, z], (x * s - t, y * s - t), 2, 28);
    let (low, top) = (1.0_f32.min(1.0 - spread), 1.0_f32.min(1.0 + spread));
    let rings = [
        ring(0.0, low * 0.96, 0.0),
        ring(high * 0.06, low, 0.0),
        ring(high * 0.5, f32::midpoint(low, top), 0.0),
        ring(high, top, 0.0),
        ring(high, top, t),
        ring(high * 0.5, f32::midpoint(low, top), t),
        ring(2.0 * t, low * 0.95, t),
    ];
    loft(b, "bag", &rings, mat);
    let narrow = low.min(top);
    b.inside(
        "compartment",
        [0.0, 0.0, 2.0 * t],
        ((x * narrow - 2.0 * t) * 0.85, (y * narrow - 2.0 * t) * 0.85),
        high - 2.0 * t,
    );
}

/// Two handles over the opening, at the front and the back.
fn handles(b: &mut Build<'_>, (x, y): (f32, f32), (low, high): (f32, f32), r: f32, mat: MaterialId) {
    let mut shell = MeshBuilder::default();
    for side in [-1.0_f32, 1.0] {
        let px = side * x;
        let round = arc(Axis::X, [px, 0.0, low], (y, high - low - r), (0.0, std::f32::consts::PI), 12);
        let line: Vec<P> =
            round.iter().map(|p| [p[0] * (1.0 - 0.5 * (p[2] - low) / (high - low)), p[1], p[2]]).collect();
        shell.tube(&line, r);
    }
    shell.put(b, "handle", mat);
}

/// A handbag with a flap and a clasp.
pub(super) fn handbag(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let leather =
        b.choose(&[BROWN_LEATHER, BLACK_LEATHER, TAN_LEATHER, RED_FABRIC, NAVY_FABRIC, WHITE_LEATHER, b.style.accent]);
    let metal = b.choose(&[GOLD, SILVER_METAL, BRASS]);
    let (body, clasp) = (h * b.vary(0.58, 0.7), x * 0.05);
    let spread = b.vary(-0.22, 0.0);
    let deep = x - clasp;
    pouch(b, (deep * 0.98, y), body, spread, leather);
    let top = 1.0 + spread;
    let t = h * 0.012;
    let edge = deep * top;
    let drop = body * b.vary(0.3, 0.6);
    let r = (y * 0.035).min(0.007).min(deep * 0.2);
    let carried = b.class == "purse" || b.rng.chance(0.4);
    b.hinge([-edge, 0.0, body], [0.0, -1.0, 0.0], 2.4, |b| {
        b.block("flap", [-edge, -y * top, body + h * 0.002], [deep, y * top, body + t], leather);
        let front = [
            (-y * top, body + t * 0.5),
            (y * top, body + t * 0.5),
            (y * top * 0.9, body - drop * 0.7),
            (0.0, body - drop),
            (-y * top * 0.9, body - drop * 0.7),
        ];
        b.prism("flap", Axis::X, [deep * 0.99, 0.0, 0.0], &front, deep * 0.01 + clasp * 0.4, leather);
        b.block("clasp", [deep, -y * 0.1, body - drop * 0.85], [x, y * 0.1, body - drop * 0.6], metal);
        if carried {
            let strap = [
                [0.0, -y * top * 0.9, body + t * 0.5],
                [0.0, -y * top * 0.8, body + (h - body) * 0.6],
                [0.0, 0.0, h - r * 1.2],
                [0.0, y * top * 0.8, body + (h - body) * 0.6],
                [0.0, y * top * 0.9, body + t * 0.5],
            ];
            let mut shell = MeshBuilder::default();
            shell.tube(&spline(&strap, 5), r);
            shell.put(b, "strap", leather);
        } else {
            handles(b, (deep * 0.5, y * 0.5), (body, h), r, leather);
        }
        let rings = [-1.0, 1.0].map(|s| {
            ([-x * 0.06, s * y * 0.6 - y * 0.02, body + t * 0.5], [x * 0.06, s * y * 0.6 + y * 0.02, body + t * 2.0])
        });
        blocks(b, "ring", &rings, metal);
    });
}

/// An open bag of cloth or paper for shopping or laundry.
pub(super) fn tote(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let mat = if b.class == "laundry_bag" {
        b.choose(&[LINEN, GREY_FABRIC, WHITE_COTTON, NAVY_FABRIC])
    } else {
        b.choose(&[CARDBOARD, LINEN, WHITE_PAPER, GREEN_CARD, RED_FABRIC, JUTE, BLUE_PLASTIC])
    };
    let body = h * if b.class == "laundry_bag" { 0.86 } else { b.vary(0.66, 0.78) };
    let spread = b.vary(-0.1, 0.12);
    pouch(b, (x * 0.985, y), body, spread, mat);
    let ink = b.choose(&[RED_CARD, BLACK_CARD, GREEN_CARD, WHITE_PAPER]);
    let low = x * 0.985 * (1.0 - spread.max(0.0) * 0.6);
    b.block("print", [low * 0.8, -y * 0.35, body * 0.35], [x, y * 0.35, body * 0.6], ink);
    let wide = 1.0_f32.min(1.0 + spread);
    if b.class == "laundry_bag" {
        let (lx, ly) = (x * 0.985 * wide, y * wide);
        b.hinge([-lx, 0.0, body], [0.0, -1.0, 0.0], 2.2, |b| {
            b.rounded_block("lid", [-lx, -ly, body + h * 0.002], [lx, ly, body + (h - body) * 0.45], h * 0.01, mat);
            let grip = [
                [0.0, -ly * 0.4, body + (h - body) * 0.4],
                [0.0, -ly * 0.3, body + (h - body) * 0.8],
                [0.0, ly * 0.3, body + (h - body) * 0.8],
                [0.0, ly * 0.4, body + (h - body) * 0.4],
            ];
            let mut shell = MeshBuilder::default();
            shell.tube(&spline(&grip, 4), (h - body) * 0.12);
            shell.put(b, "handle", ink);
        });
        return;
    }
    let r = (y * 0.03).min(0.006);
    handles(b, (x * 0.985 * wide - r * 1.2, y * 0.42), (body * 0.92, h), r, mat);
}
