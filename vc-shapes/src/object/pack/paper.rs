//! Paper, wadding and wipes.

use super::label::{GROWTH, panel, wrap};
use super::look::look;
use crate::material::*;
use crate::solid::{Axis, Build, arch, dims, flat_ring, loft_columns, planar_tube, rounded_by_share, rounded_ring};
use vc_graph::portable::Portable;

/// Rolls of paper for the toilet and the kitchen; sometimes two on top of each other.
pub(super) fn roll(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let kitchen = b.class == "paper_towel";
    let tube_r = if kitchen { r * 0.34 } else { r * 0.38 };
    let paper = b.choose(&[WHITE_PAPER, WHITE_PAPER, CREAM_PAPER]);
    let body = r * 0.985;
    let bulge = [
        (body * 0.985, 0.0),
        (body, z * 0.03),
        (body, z * 0.97),
        (body * 0.985, z),
        (tube_r, z),
        (tube_r, 0.0),
        (body * 0.985, 0.0),
    ];
    b.lathe("paper", [0.0; 3], &bulge, paper);
    flat_ring(b, "core", (z * 0.004, z * 0.996), (tube_r * 0.92, tube_r * 1.01), CARDBOARD);
    // The free end of the sheet.
    let flap: Vec<_> = (0..=6)
        .map(|k| {
            let (s, c) = (0.5 + 0.12 * k as f32).sine_cosine();
            (r * c, r * s)
        })
        .chain((0..=6).rev().map(|k| {
            let (s, c) = (0.5 + 0.12 * k as f32).sine_cosine();
            (body * 0.98 * c, body * 0.98 * s)
        }))
        .collect();
    b.prism("end", Axis::Z, [0.0, 0.0, z * 0.01], &flap, z * 0.98, paper);
    if kitchen && b.rng.chance(0.6) {
        let ink = b.choose(&[BLUE_CARD, GREEN_CARD, RED_CARD]);
        for i in 0..3 {
            let low = z * (0.2 + 0.28 * i as f32);
            flat_ring(b, "print", (low, low + z * 0.02), (body * 0.97, body + (r - body) * 0.6), ink);
        }
    }
}

/// A stack of cotton pads in a sleeve.
pub(super) fn cotton_pads(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let sleeve = b.choose(&[BLUE_PLASTIC, PINK_PLASTIC, GREEN_PLASTIC]);
    let count = ((z / 0.012) as usize).clamp(5, 8);
    let mut profile = vec![];
    for i in 0..count {
        let (low, t) = (z * 0.94 * i as f32 / count as f32, z * 0.94 / count as f32);
        profile.extend([
            (r * 0.86, low),
            (r * 0.92, low + t * 0.3),
            (r * 0.92, low + t * 0.7),
            (r * 0.86, low + t * 0.95),
        ]);
    }
    b.lathe("pads", [0.0; 3], &profile, WHITE_COTTON);
    wrap(b, r - GROWTH.min(r * 0.1), (z * 0.12, z * 0.55), (sleeve, WHITE_PAPER));
    let grip = arch([0.0, 0.0, z * 0.9], [0.0, r * 0.5, 0.0], [0.0, 0.0, z * 0.09]);
    planar_tube(b, "string", &grip, z * 0.006, [1.0, 0.0, 0.0], sleeve);
}

/// A box with tissues protruding from its slot.
pub(super) fn tissue_box(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let look = look(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let h = z * 0.75;
    let skin = b.choose(&[look.body, b.style.wood, WHITE_PAPER, look.ink]);
    let g = GROWTH.min(x * 0.01);
    b.rounded_block("box", [-hx, -hy, 0.0], [hx - g, hy, h], 0.0015, skin);
    b.prism(
        "slot",
        Axis::Z,
        [0.0, 0.0, h - z * 0.01],
        &rounded_by_share((hx * 0.35, hy * 0.55), 1.0),
        z * 0.03,
        BLACK_CARD,
    );
    let fold = |s: f32| {
        [
            [s * hx * 0.05, -hy * 0.4, h * 0.97],
            [s * hx * 0.05, hy * 0.4, h * 0.97],
            [s * hx * 0.4, hy * 0.3, z * 0.98],
            [s * hx * 0.25, -hy * 0.35, z * 0.94],
            [s * hx * 0.15, hy * 0.05, z],
            [0.0, -hy * 0.3, h],
            [0.0, hy * 0.3, h],
        ]
    };
    b.hull("tissue", &fold(1.0), WHITE_PAPER);
    b.hull("tissue", &fold(-1.0), WHITE_PAPER);
    if skin == look.body {
        panel(b, hx - g, (0.0, hy * 0.8), (h * 0.2, h * 0.8), look.label());
    }
}

/// A soft pack of wipes with a lid on top.
pub(super) fn wet_wipes(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let look = look(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let at = |z: f32, kx: f32, ky: f32| rounded_ring(z, (hx * kx, hy * ky), 0.35);
    loft_columns(
        b,
        "pack",
        &[at(0.0, 0.9, 0.9), at(z * 0.15, 1.0, 0.96), at(z * 0.7, 1.0, 0.96), at(z * 0.86, 0.88, 0.9)],
        look.body,
    );
    for side in [-1.0_f32, 1.0] {
        let (y0, y1) = if side < 0.0 { (-hy, -hy * 0.9) } else { (hy * 0.9, hy) };
        b.block("seam", [-hx * 0.95, y0, z * 0.42], [hx * 0.95, y1, z * 0.48], look.body);
    }
    b.hinge([-hx * 0.5, 0.0, z * 0.88], [0.0, -1.0, 0.0], 1.9, |b| {
        b.rounded_block("lid", [-hx * 0.5, -hy * 0.45, z * 0.845], [hx * 0.5, hy * 0.45, z], z * 0.05, look.cap);
    });
}

/// A folded, upright diaper.
pub(super) fn diaper(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let at = |z: f32, kx: f32, ky: f32| rounded_ring(z, (hx * kx, hy * ky), 0.7);
    loft_columns(
        b,
        "diaper",
        &[
            at(0.0, 0.6, 0.55),
            at(z * 0.06, 0.95, 0.7),
            at(z * 0.35, 1.0, 0.75),
            at(z * 0.7, 0.9, 0.95),
            at(z * 0.95, 0.75, 1.0),
            at(z, 0.6, 0.98),
        ],
        WHITE_COTTON,
    );
    let ink = b.choose(&[BLUE_FABRIC, ROSE_FABRIC, GREEN_FABRIC, MUSTARD_FABRIC]);
    for side in [-1.0, 1.0] {
        b.block(
            "tape",
            [hx * 0.5, side * hy * 0.7 - hy * 0.18, z * 0.8],
            [hx * 0.9, side * hy * 0.7 + hy * 0.18, z * 0.92],
            ink,
        );
    }
    b.block("band", [hx * 0.4, -hy * 0.5, z * 0.82], [hx * 0.86, hy * 0.5, z * 0.9], ink);
}
