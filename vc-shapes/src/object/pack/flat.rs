//! Packages with flat sides: boxes, cartons, bags, tubes.

use std::f32::consts::FRAC_PI_2;

use nalgebra::{Isometry3, Vector3};
use vc_graph::portable::Portable;

use super::label::panel;
use super::look::{Look, look};
use crate::material::*;
use crate::solid::{Axis, Build, P, arch, dims, loft_columns, planar_tube, rounded_ring, tub, turn};

/// The protrusion of a panel.
pub(super) const PANEL: f32 = 0.0019;

/// Builds on the top as if it were the front: the up direction of the object is -X here.
fn on_top(b: &mut Build<'_>, build: impl FnOnce(&mut Build<'_>)) {
    b.posed(Isometry3::rotation(Vector3::y() * -FRAC_PI_2), build);
}

/// Cardboard boxes, printed on their front, or on top if they lie flat.
pub(super) fn carton_box(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mut look = look(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let lying = z < x * 0.75 && z < y;
    if matches!(b.class, "band_aids" | "painkillers") {
        look.body = b.choose(&[WHITE_PAPER, CREAM_PAPER, YELLOW_CARD]);
        look.paper = b.choose(&[BLUE_CARD, RED_CARD, GREEN_CARD, TEAL_CARD]);
        look.ink = WHITE_PAPER;
    }
    let g = PANEL.min(x.min(z) * 0.1);
    if lying {
        b.rounded_block("box", [-hx, -hy, 0.0], [hx, hy, z - g], (z * 0.08).min(0.0015), look.body);
        on_top(b, |b| panel(b, z - g, (0.0, hy * 0.9), (-hx * 0.85, hx * 0.85), look.label()));
        return;
    }
    b.rounded_block("box", [-hx + g, -hy, 0.0], [hx - g, hy, z], (x * 0.03).min(0.0015), look.body);
    let frame = b.vary(0.8, 0.95);
    let (low, high) = (z * b.vary(0.05, 0.2), z * b.vary(0.75, 0.95));
    panel(b, hx - g, (0.0, hy * frame), (low, high), look.label());
    b.at([0.0; 3], std::f32::consts::PI, |b| {
        panel(b, hx - g, (0.0, hy * 0.8), (z * 0.1, z * 0.9), (look.paper, look.ink))
    });
    match b.class {
        "cereal" => {
            // A bowl on the front.
            let bowl: Vec<_> = (0..=8)
                .map(|i| {
                    let (s, c) = (std::f32::consts::PI * i as f32 / 8.0).sine_cosine();
                    (hy * 0.5 * c, -z * 0.12 * s)
                })
                .collect();
            b.prism("picture", Axis::X, [hx - g, 0.0, low + (high - low) * 0.35], &bowl, g, BLUE_CARD);
        }
        "dry_pasta" | "rice" => {
            b.block(
                "window",
                [hx - g, -hy * 0.4, low + (high - low) * 0.08],
                [hx + g * 0.1, hy * 0.4, low + (high - low) * 0.4],
                HAY,
            );
        }
        _ => {}
    }
}

/// Cartons for milk and juice: a gable or a slanted top, a cap.
pub(super) fn gable(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    if b.rng.chance(0.3) {
        return super::round::bottle(b);
    }
    let look = look(b);
    let g = PANEL.min(x * 0.05);
    let (hx, hy) = (x / 2.0 - g, y / 2.0 - 0.0006_f32.min(y * 0.01));
    let body = z * b.vary(0.76, 0.82);
    b.block("carton", [-hx, -hy, 0.0], [hx, hy, body], look.body);
    let crest = z * 0.93;
    if b.rng.chance(0.65) {
        let slope =
            [[-hx, -hy, body], [hx, -hy, body], [-hx, hy, body], [hx, hy, body], [0.0, -hy, crest], [0.0, hy, crest]];
        b.hull("gable", &slope, look.body);
        b.block("crest", [-x * 0.015, -hy * 0.985, crest - z * 0.01], [x * 0.015, hy * 0.985, z], look.body);
        let (sx, sz) = (hx * 0.5, f32::midpoint(body, crest));
        let up = (z - sz) * 0.35;
        b.rod(
            "cap",
            [sx - up * 0.2, 0.0, sz - up * 0.2],
            [sx + up * 0.7, 0.0, sz + up * 0.8],
            (hx * 0.3).min(hy * 0.4),
            look.cap,
        );
    } else {
        b.taper("shoulder", [0.0, 0.0, body], (hx, hy), (hx * 0.8, hy * 0.8), z * 0.06, look.body);
        b.cylinder("cap", [0.0, 0.0, body + z * 0.055], (hx * 0.5).min(hy * 0.5), z - body - z * 0.055, look.cap);
    }
    panel(b, hx, (0.0, hy * 0.92), (z * 0.06, body * 0.92), look.label());
    b.block("stripe", [-hx - 0.0005, -hy - 0.0005, body * 0.2], [hx - 0.0005, hy + 0.0005, body * 0.3], look.ink);
}

/// Bags: pillow bags sealed at both ends, and paper bags with a folded top.
pub(super) fn bag(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let look = look(b);
    let (hx, hy) = (x / 2.0 - PANEL.min(x * 0.05), y / 2.0);
    let foil = matches!(b.class, "chips" | "candy" | "nuts" | "popcorn" | "pet_food" | "coffee_beans" | "raisins");
    let paper = matches!(b.class, "flour" | "sugar" | "rice" | "oatmeal");
    let at = |z: f32, kx: f32, ky: f32| rounded_ring(z, (hx * kx, hy * ky), 0.35);
    if paper {
        let h = z * 0.9;
        loft_columns(
            b,
            "bag",
            &[
                at(0.0, 0.94, 0.96),
                at(z * 0.05, 1.0, 1.0),
                at(h * 0.9, 1.0, 1.0),
                at(h, 0.8, 0.97),
                at(h * 1.005, 0.7, 0.95),
            ],
            look.body,
        );
        b.hull(
            "fold",
            &[
                [-hx * 0.6, -hy * 0.95, h * 0.99],
                [hx * 0.6, -hy * 0.95, h * 0.99],
                [-hx * 0.6, hy * 0.95, h * 0.99],
                [hx * 0.6, hy * 0.95, h * 0.99],
                [-hx * 0.1, -hy * 0.95, z],
                [-hx * 0.1, hy * 0.95, z],
                [hx * 0.15, -hy * 0.95, z],
                [hx * 0.15, hy * 0.95, z],
            ],
            look.body,
        );
        panel(b, hx, (0.0, hy * 0.8), (h * 0.15, h * 0.8), look.label());
        return;
    }
    let foot = if foil { 0.2 } else { 0.85 };
    // A pillow bag of a few centimetres would not stand on its seam.
    let stand = matches!(b.class, "candy" | "nuts" | "raisins" | "coffee_beans" | "pet_food" | "ground_coffee");
    let base = if stand { 0.9 } else { foot };
    loft_columns(
        b,
        "bag",
        &[
            at(0.0, base, 0.97),
            at(z * 0.06, if stand { 0.98 } else { 0.35 }, 1.0),
            at(z * 0.3, 0.97, 0.96),
            at(z * 0.5, 1.0, 0.94),
            at(z * 0.7, 0.85, 0.95),
            at(z * 0.9, 0.3, 0.99),
            at(z * 0.94, 0.08, 1.0),
            at(z, 0.06, 1.0),
        ],
        look.body,
    );
    // A slightly bulging patch: a print that follows the belly.
    let py = hy * 0.62;
    let depth = |k: f32| hx * if k < 0.5 { 0.97 + 0.15 * (k - 0.3) } else { 1.0 - 0.75 * (k - 0.5) };
    patch(b, &[0.3, 0.5, 0.68].map(|k| (depth(k) + 0.0006, z * k)), py, look.paper);
    patch(b, &[0.5, 0.62].map(|k| (depth(k) + 0.0012, z * k)), py * 0.75, look.ink);
}

/// A patch on a bulging front, given by its depth at several heights and its half width.
fn patch(b: &mut Build<'_>, front: &[(f32, f32)], half: f32, mat: MaterialId) {
    let corners = |&(x, z): &(f32, f32)| [[x, -half, z], [x, half, z], [x * 0.5, -half, z], [x * 0.5, half, z]];
    b.hull("print", &front.iter().flat_map(corners).collect::<Vec<P>>(), mat);
}

/// Tubes standing on their cap, flat at the other end.
pub(super) fn squeeze_tube(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let look = look(b);
    let g = 0.0012_f32.min(x.min(y) * 0.03);
    let hy = y / 2.0 - g;
    let hx = (x / 2.0 - g).min(hy);
    let cap = z * b.vary(0.13, 0.2);
    let r = hx.min(hy);
    turn(b, "cap", [0.0; 3], (r, cap), &[(0.95, 0.0), (0.95, 0.9), (0.85, 1.0)], look.cap);
    let at = |z: f32, kx: f32, y: f32| rounded_ring(z, (hx * kx, y), 1.0);
    let rings = [
        at(cap * 0.98, 0.75, r * 0.75),
        at(cap + z * 0.03, 1.0, r),
        at(z * 0.5, 0.85, f32::midpoint(r, hy)),
        at(z * 0.93, 0.15, hy * 0.97),
        at(z * 0.94, 0.08, hy),
        at(z, 0.08, hy),
    ];
    loft_columns(b, "tube", &rings, look.body);
    let belly = cap / z + 0.03;
    for (low, high, mat) in [(0.44, 0.56, look.paper), (0.62, 0.7, look.ink)] {
        let ring = |k: f32| {
            // Interpolates between the ring below the middle and the flat end.
            let middle = f32::midpoint(r, hy);
            let (hk, wide) = if k < 0.5 {
                let share = (k - belly) / (0.5 - belly);
                (1.0 - 0.15 * share, r + (middle - r) * share)
            } else {
                let share = (k - 0.5) / 0.43;
                (0.85 - 0.7 * share, middle + (hy * 0.97 - middle) * share)
            };
            rounded_ring(z * k, (hx * hk + g, wide.min(hy) + g), 1.0)
        };
        loft_columns(b, "print", &[ring(low), ring(0.5_f32.max(low).min(high)), ring(high)], mat);
    }
}

/// Wrapped bars with crimped ends: chocolate, snacks, gum.
pub(super) fn bar(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let look = look(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let g = (z * 0.1).min(0.0008);
    if matches!(b.class, "chewing_gum") {
        b.rounded_block(
            "pack",
            [-hx + PANEL.min(x * 0.05), -hy, 0.0],
            [hx - PANEL.min(x * 0.05), hy, z * 0.85],
            x * 0.1,
            look.body,
        );
        b.rounded_block("foil", [-hx * 0.7, -hy * 0.85, z * 0.8], [hx * 0.7, hy * 0.85, z], x * 0.05, SILVER_METAL);
        return panel(b, hx - PANEL.min(x * 0.05), (0.0, hy * 0.85), (z * 0.1, z * 0.75), look.label());
    }
    let open = b.class == "chocolate" && b.rng.chance(0.5);
    let end = if open { hy * 0.2 } else { hy * 0.9 };
    b.rounded_block("bar", [-hx * 0.97, -hy * 0.9, 0.0], [hx * 0.97, end, z - 2.0 * g], z * 0.3, look.body);
    if open {
        let (rows, pitch) = (3, (hy * 0.95 - end) / 3.0);
        b.block("slab", [-hx * 0.9, end - hy * 0.05, z * 0.08], [hx * 0.9, hy, z * 0.55], CHOCOLATE);
        for i in 0..rows * 4 {
            let (cx, cy) = (-hx * 0.675 + hx * 0.45 * (i % 4) as f32, end + pitch * (i / 4) as f32 + pitch * 0.5);
            b.taper(
                "piece",
                [cx, cy, z * 0.5],
                (hx * 0.2, pitch * 0.44),
                (hx * 0.15, pitch * 0.34),
                z * 0.33,
                CHOCOLATE,
            );
        }
        b.block("foil", [-hx * 0.99, end - hy * 0.02, z * 0.03], [hx * 0.99, end + hy * 0.06, z * 0.93], SILVER_METAL);
    } else {
        b.block("crimp", [-hx * 0.95, hy * 0.86, z * 0.35], [hx * 0.95, hy, z * 0.5], look.body);
    }
    b.block("crimp", [-hx * 0.95, -hy, z * 0.35], [hx * 0.95, -hy * 0.86, z * 0.5], look.body);
    let (from, to) = (-hy * 0.8, end - hy * 0.1);
    b.block("label", [-hx * 0.75, from, z * 0.7], [hx * 0.75, to, z - g], look.paper);
    b.block(
        "print",
        [-hx * 0.35, from + (to - from) * 0.1, z * 0.8],
        [hx * 0.35, from + (to - from) * 0.75, z],
        look.ink,
    );
    b.block(
        "print",
        [hx * 0.45, from + (to - from) * 0.1, z * 0.8],
        [hx * 0.62, from + (to - from) * 0.6, z],
        look.ink,
    );
}

/// Butter in paper or foil, cream cheese in a tub with a lid: low and rectangular.
pub(super) fn block_pack(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let look = look(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let g = PANEL.min(z * 0.05);
    if b.class == "butter" && b.rng.chance(0.7) {
        b.rounded_block("block", [-hx, -hy * 0.985, 0.0], [hx, hy * 0.985, z - g], z * 0.08, look.body);
        for side in [-1.0_f32, 1.0] {
            let (y0, y1) = if side < 0.0 { (-hy * 1.0, -hy * 0.9) } else { (hy * 0.9, hy) };
            b.hull(
                "fold",
                &[
                    [0.0, y0, z * 0.15],
                    [0.0, y1, z * 0.15],
                    [hx * 0.9, y0, z * 0.75],
                    [hx * 0.9, y1, z * 0.75],
                    [-hx * 0.9, y0, z * 0.75],
                    [-hx * 0.9, y1, z * 0.75],
                ],
                look.body,
            );
        }
        on_top(b, |b| panel(b, z - g, (0.0, hy * 0.85), (-hx * 0.8, hx * 0.8), look.label()));
        return;
    }
    let h = z * 0.86;
    let (body, lid) = (
        b.choose(&[WHITE_PLASTIC, YELLOW_PLASTIC, CREAM_PAPER]),
        b.choose(&[WHITE_PLASTIC, YELLOW_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC]),
    );
    let at = |z: f32, k: f32| rounded_ring(z, (hx * k, hy * k), 0.5);
    loft_columns(b, "tub", &[at(0.0, 0.82), at(h, 0.95)], body);
    loft_columns(b, "lid", &[at(h * 0.97, 0.97), at(h * 0.99, 1.0), at(z - g * 1.2, 1.0), at(z - g, 0.97)], lid);
    on_top(b, |b| panel(b, z - g, (0.0, hy * 0.7), (-hx * 0.65, hx * 0.65), look.label()));
}

/// Ready meals in a sleeve and noodles in a packet: flat with a picture on top.
pub(super) fn sleeve(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let look = look(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let g = PANEL.min(z * 0.05);
    if b.class == "noodles" {
        b.rounded_block("packet", [-hx, -hy * 0.9, 0.0], [hx, hy * 0.9, z - g], z * 0.35, look.body);
        for side in [-1.0_f32, 1.0] {
            let (y0, y1) = if side < 0.0 { (-hy, -hy * 0.8) } else { (hy * 0.8, hy) };
            b.block("crimp", [-hx * 0.95, y0, z * 0.42], [hx * 0.95, y1, z * 0.5], look.body);
        }
    } else {
        tub(
            b,
            "tray",
            &[(0.0, hx * 0.85, hy * 0.87), (z * 0.7, hx * 0.97, hy), (z * 0.75, hx * 0.97, hy)],
            0.2,
            z * 0.04,
            BLACK_PLASTIC,
        );
        b.block("sleeve", [-hx, -hy * 0.8, z * 0.3], [hx, hy * 0.8, z - g], look.body);
    }
    let (px, py) = (hx * 0.75, hy * 0.65);
    on_top(b, |b| panel(b, z - g, (-py * 0.4, py * 0.55), (-px, px), look.label()));
    b.cylinder("picture", [0.0, py * 0.62, z - g * 1.5], (py * 0.4).min(px), g * 1.2, TOMATO);
}

/// A folded takeaway box with a wire handle, or a bucket of popcorn.
pub(super) fn takeaway(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    if b.class == "popcorn" {
        if z < 0.13 {
            return bag(b);
        }
        let at = |z: f32, k: f32| rounded_ring(z, (hx * k, hy * k), 0.25);
        let h = z * 0.85;
        loft_columns(b, "bucket", &[at(0.0, 0.72), at(h, 0.97)], WHITE_PAPER);
        for i in 0..4 {
            let (y0, y1) = (-0.85 + 0.46 * i as f32, -0.62 + 0.46 * i as f32);
            for side in [-1.0, 1.0] {
                let edge =
                    |k: f32, z: f32, y: f32| [[side * hx * k, hy * k * y, z], [side * hx * k * 0.9, hy * k * y, z]];
                let points: Vec<P> = [
                    edge(0.728, z * 0.005, y0),
                    edge(0.728, z * 0.005, y1),
                    edge(0.979, h * 0.995, y0),
                    edge(0.979, h * 0.995, y1),
                ]
                .concat();
                b.hull("stripe", &points, RED_CARD);
            }
        }
        crate::solid::lump(b, "popcorn", [0.0, 0.0, h], [hx * 0.8, hy * 0.8, (z - h) * 0.8], 0.08, CREAM_FOOD);
        for i in 0..18 {
            let (s, c) = (2.4 * i as f32).sine_cosine();
            let k = 0.8 * ((i as f32 + 0.5) / 18.0).sqrt();
            let r = hx * 0.17;
            super::super::food::berry(
                b,
                [(hx - r) * k * c, (hy - r) * k * s, z - r - (z - h) * 0.8 * k * k],
                r,
                if i % 3 == 0 { PALE_FLESH } else { CREAM_FOOD },
            );
        }
        return;
    }
    let paper = b.choose(&[WHITE_PAPER, CREAM_PAPER, RED_CARD]);
    let h = z * 0.8;
    b.taper("box", [0.0; 3], (hx * 0.72, hy * 0.72), (hx * 0.95, hy * 0.92), h, paper);
    for side in [-1.0, 1.0] {
        b.hull(
            "flap",
            &[
                [side * hx * 0.94, -hy * 0.85, h * 0.99],
                [side * hx * 0.94, hy * 0.85, h * 0.99],
                [side * hx * 0.1, -hy * 0.7, h * 1.08],
                [side * hx * 0.1, hy * 0.7, h * 1.08],
                [side * hx * 0.5, 0.0, h],
            ],
            paper,
        );
    }
    let ink = if paper == RED_CARD { WHITE_PAPER } else { RED_CARD };
    b.hull(
        "print",
        &[
            [hx * 0.82, -hy * 0.35, h * 0.3],
            [hx * 0.82, hy * 0.35, h * 0.3],
            [hx * 0.9, -hy * 0.35, h * 0.65],
            [hx * 0.9, hy * 0.35, h * 0.65],
            [hx * 0.7, 0.0, h * 0.5],
        ],
        ink,
    );
    let w = (hx * 0.03).min(0.001);
    let bail = arch([0.0, 0.0, h * 0.85], [0.0, hy - w, 0.0], [0.0, 0.0, z - h * 0.85 - w]);
    planar_tube(b, "bail", &bail, w, [1.0, 0.0, 0.0], STEEL);
}

/// A larger bag or a can of pet food.
pub(super) fn pet_food(b: &mut Build<'_>) {
    if b.size.z < 0.16 && b.size.y < 0.16 { super::round::can(b) } else { bag(b) }
}

/// Ground coffee in a bag, a jar or a tin; flour and tea in bags or boxes.
pub(super) fn either(b: &mut Build<'_>) {
    match (b.class, b.rng.below(3)) {
        ("ground_coffee", 0) | ("baking_powder", 0) => super::round::jar(b),
        ("baking_powder" | "tea_leaves", _) => carton_box(b),
        ("salt", 0) => bag(b),
        ("oatmeal", 0 | 1) => carton_box(b),
        ("mayonnaise" | "mustard" | "honey", 0) => super::round::jar(b),
        ("mayonnaise" | "mustard" | "honey", _) => super::flask::oval_bottle(b),
        ("dry_pasta" | "raisins", 0) => carton_box(b),
        ("hair_product" | "deodorant", 0 | 1) => super::round::aerosol(b),
        ("hair_product", _) => super::round::jar(b),
        ("deodorant", _) => stick(b),
        ("painkillers", 0) => super::round::jar(b),
        ("painkillers", _) => carton_box(b),
        _ => bag(b),
    }
}

/// A deodorant: an oval stick with a high cap.
fn stick(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let Look { body, paper, ink, cap } = look(b);
    let g = PANEL.min(x * 0.04);
    let (hx, hy) = (x / 2.0 - g, y / 2.0);
    let at = |z: f32, k: f32| rounded_ring(z, (hx * k, hy * k), 1.0);
    loft_columns(b, "stick", &[at(0.0, 0.95), at(z * 0.02, 1.0), at(z * 0.6, 1.0)], body);
    loft_columns(b, "cap", &[at(z * 0.605, 0.99), at(z * 0.93, 0.95), at(z, 0.75)], cap);
    panel(b, hx, (0.0, hy * 0.4), (z * 0.12, z * 0.52), (paper, ink));
}
