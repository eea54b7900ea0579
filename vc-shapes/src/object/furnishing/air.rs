//! Fans, air conditioners, air purifiers, humidifiers and dehumidifiers.

use crate::material::*;
use crate::object::cooker::fitting::*;
use crate::object::joinery::lid;
use crate::solid::{Build, P, basket, case, circle, collar, fit, half_dims};

/// A cage with blades on a stand, low or tall; or a tower.
pub(super) fn fan(b: &mut Build<'_>) {
    let u = fit(b, [0.192, 0.24, 0.272]);
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[WHITE_PLASTIC, BLACK_PLASTIC, STEEL, COPPER]);
    if h > 0.7 && b.rng.chance(0.3) {
        return tower(b, u, mat);
    }
    let r = y.min(h * 0.45);
    let z = h - r;
    let foot = x.min(y * 0.8);
    b.lathe("foot", [0.0; 3], &[(foot, 0.0), (foot * 0.95, 0.02 * u), (foot * 0.2, 0.04 * u)], mat);
    b.cylinder("pole", [-x * 0.2, 0.0, 0.02 * u], 0.014 * u, z - 0.02 * u, mat);
    b.rod("motor", [-x * 0.5, 0.0, z], [x * 0.1, 0.0, z], r * 0.24, mat);
    let (back, front) = (-x * 0.02, x * 0.94);
    cage(b, (back, front), z, r, u);
    b.rod("hub", [x * 0.09, 0.0, z], [x * 0.8, 0.0, z], r * 0.16, mat);
    for i in 0..4 {
        let (s, c) = circle::part(i, 4);
        let at = |k: f32, w: f32, dx: f32| [x * 0.45 + dx, (c * k - s * w) * r, z + (s * k + c * w) * r];
        let points: Vec<P> = [(0.1, -0.08, 0.04), (0.1, 0.08, -0.04), (0.82, -0.22, 0.1), (0.82, 0.26, -0.1)]
            .into_iter()
            .flat_map(|(k, w, dx)| [at(k, w, dx * x), at(k, w, dx * x + 0.004 * u)])
            .collect();
        b.hull("blade", &points, mat);
    }
    knob(b, [foot * 0.5, 0.0, 0.025 * u], 0.012 * u, 0.02 * u, (GREY_PLASTIC, WHITE));
}

/// Rings and spokes around blades.
fn cage(b: &mut Build<'_>, (back, front): (f32, f32), z: f32, r: f32, u: f32) {
    let w = 0.003 * u;
    collar(
        b,
        "rim",
        ([(back + front) / 2.0 - 0.008 * u, 0.0, z], [(back + front) / 2.0 + 0.008 * u, 0.0, z]),
        (r * 0.97, r),
        CHROME,
    );
    let middle = (back + front) / 2.0;
    for (x, k) in [(front, 1.0), (back, 0.98)] {
        collar(b, "ring", ([x - w, 0.0, z], [x + w, 0.0, z]), (r * 0.6, r * 0.63), CHROME);
        b.rod("badge", [x - w, 0.0, z], [x + w * 1.5, 0.0, z], r * 0.2, CHROME);
        for i in 0..12 {
            let (s, c) = circle::part(i, 12);
            let at = |k: f32, x: f32| [x, c * r * k, z + s * r * k];
            b.rod("spoke", at(0.15, x), at(0.62, x), w * 0.7, CHROME);
            b.rod("spoke", at(0.62, x), at(0.98 * k, middle), w * 0.7, CHROME);
        }
    }
}

/// A slim column with slots.
fn tower(b: &mut Build<'_>, u: f32, mat: MaterialId) {
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    b.lathe("foot", [0.0; 3], &[(r, 0.0), (r * 0.96, 0.015 * u), (r * 0.4, 0.03 * u)], mat);
    let slim = r * 0.55;
    b.cylinder("tower", [0.0, 0.0, 0.02 * u], slim, h - 0.02 * u, mat);
    for i in 0..14 {
        let z = h * (0.2 + 0.048 * i as f32);
        b.block("slot", [slim * 0.6, -slim * 0.7, z], [slim * 0.99, slim * 0.7, z + h * 0.02], BLACK_PLASTIC);
    }
    b.cylinder("cap", [0.0, 0.0, h - 0.004 * u], slim * 0.7, 0.004, BLACK_PLASTIC);
    display(b, slim * 0.98, (-slim * 0.3, h * 0.92), (slim * 0.3, h * 0.95), COOL_BULB);
}

/// Blades around a motor on a rod, with a light beneath.
pub(super) fn ceiling_fan(b: &mut Build<'_>) {
    let u = fit(b, [0.64, 0.64, 0.224]);
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    let metal = b.choose(&[b.style.metal, WHITE_METAL, BRASS]);
    let wood = b.choose(&[b.style.wood, WHITE, b.style.wood]);
    let (low, motor) = (h * 0.3, h * 0.3);
    b.lathe("rose", [0.0, 0.0, h * 0.86], &[(0.03 * u, 0.0), (0.07 * u, h * 0.14)], metal);
    b.cylinder("rod", [0.0, 0.0, low + motor * 0.9], 0.012 * u, h * 0.87 - low - motor * 0.9, metal);
    b.lathe(
        "motor",
        [0.0, 0.0, low],
        &[(r * 0.13, 0.0), (r * 0.2, motor * 0.3), (r * 0.18, motor * 0.8), (r * 0.06, motor)],
        metal,
    );
    b.lathe(
        "light",
        [0.0; 3],
        &[(r * 0.05, 0.0), (r * 0.14, low * 0.3), (r * 0.18, low * 0.7), (r * 0.16, low + 0.002 * u)],
        WARM_BULB,
    );
    let count = b.rng.count(3, 5);
    let z = low + motor * 0.5;
    let t = 0.008 * u;
    for i in 0..count {
        let (s, c) = circle::part(i, count);
        let at = |k: f32, w: f32, z: f32| [c * r * k - s * r * w, s * r * k + c * r * w, z];
        let corners = [(0.3, -0.07), (0.3, 0.07), (0.97, -0.11), (0.97, 0.11), (0.99, 0.0)];
        let points: Vec<P> = corners
            .into_iter()
            .flat_map(|(k, w)| [at(k, w, z + w * r * 0.15), at(k, w, z + w * r * 0.15 + t)])
            .collect();
        b.hull("blade", &points, wood);
        b.bar("arm", at(0.14, 0.0, z), at(0.36, 0.0, z + t * 0.2), 0.008 * u, metal);
    }
}

/// A square or round grille on the wall.
pub(super) fn extractor_fan(b: &mut Build<'_>) {
    let u = fit(b, [0.064, 0.112, 0.112]);
    let (x, y, h) = half_dims(b);
    let z = h / 2.0;
    let r = y.min(z);
    b.rod("duct", [-x, 0.0, z], [x * 0.4, 0.0, z], r * 0.75, GREY_PLASTIC);
    if b.rng.chance(0.5) {
        b.rounded_block("plate", [x * 0.3, -y, 0.0], [x * 0.8, y, h], 0.008 * u, WHITE_PLASTIC);
        for i in 0..6 {
            let cz = z + r * 0.24 * (i as f32 - 2.5);
            b.block("slat", [x * 0.78, -y * 0.75, cz - r * 0.06], [x, y * 0.75, cz + r * 0.06], WHITE_PLASTIC);
        }
        b.block("dark", [x * 0.7, -y * 0.75, z - r * 0.7], [x * 0.82, y * 0.75, z + r * 0.7], BLACK_PLASTIC);
    } else {
        b.rounded_block("plate", [x * 0.3, -y, 0.0], [x * 0.7, y, h], 0.008 * u, WHITE_PLASTIC);
        b.rounded_block("cover", [x * 0.8, -y * 0.85, h * 0.075], [x, y * 0.85, h * 0.925], 0.006 * u, WHITE_PLASTIC);
        b.rod("post", [x * 0.6, 0.0, z], [x * 0.85, 0.0, z], r * 0.3, GREY_PLASTIC);
    }
}

/// A long case on the wall with a flap for the air flow.
pub(super) fn air_conditioner(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[WHITE_PLASTIC, WHITE_PLASTIC, GREY_PLASTIC]);
    let top = h - 0.002;
    let outline = [(-x, 0.0), (x * 0.5, 0.0), (x, h * 0.28), (x, h * 0.86), (x * 0.8, top), (-x, top)];
    b.prism("case", crate::solid::Axis::Y, [0.0, -y, 0.0], &outline, 2.0 * y, mat);
    b.hull(
        "flap",
        &[
            [x * 0.52, -y * 0.9, -0.0005],
            [x * 0.52, y * 0.9, -0.0005],
            [x - 0.001, -y * 0.9, h * 0.26],
            [x - 0.001, y * 0.9, h * 0.26],
            [x * 0.62, -y * 0.9, 0.0],
            [x * 0.62, y * 0.9, 0.0],
            [x, -y * 0.9, h * 0.22],
            [x, y * 0.9, h * 0.22],
        ],
        GREY_PLASTIC,
    );
    for i in 0..9 {
        let cx = -x * 0.8 + x * 0.16 * i as f32;
        b.block("slot", [cx, -y * 0.92, h - 0.004], [cx + x * 0.06, y * 0.92, h], BLACK_PLASTIC);
    }
    b.block("seam", [x - 0.001, -y * 0.99, h * 0.33], [x + 0.0005, y * 0.99, h * 0.34], GREY_PLASTIC);
    display(b, x - 0.0025, (y * 0.6, h * 0.4), (y * 0.75, h * 0.5), COOL_BULB);
    b.block("badge", [x - 0.001, -y * 0.06, h * 0.6], [x + 0.0008, y * 0.06, h * 0.65], SILVER_METAL);
}

/// A column or a box with fine slots and a ring of light.
pub(super) fn air_purifier(b: &mut Build<'_>) {
    let u = fit(b, [0.16, 0.16, 0.272]);
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[WHITE_PLASTIC, WHITE_PLASTIC, GREY_PLASTIC, BLACK_PLASTIC]);
    if (x - y).abs() < x * 0.35 && b.rng.chance(0.6) {
        let r = x.min(y);
        b.lathe(
            "case",
            [0.0; 3],
            &[(r * 0.94, 0.0), (r, h * 0.03), (r, h * 0.94), (r * 0.92, h), (r * 0.6, h), (r * 0.5, h * 0.96)],
            mat,
        );
        for i in 0..12 {
            let z = h * (0.06 + 0.05 * i as f32);
            collar(b, "slot", ([0.0, 0.0, z], [0.0, 0.0, z + h * 0.018]), (r * 0.9, r + 0.0004 * u), GREY_FABRIC);
        }
        collar(b, "ring", ([0.0, 0.0, h * 0.958], [0.0, 0.0, h * 0.965]), (r * 0.3, r * 0.4), LED);
    } else {
        b.rounded_block("case", [-x, -y, 0.0], [x, y, h], 0.03 * u, mat);
        for i in 0..14 {
            let z = h * (0.12 + 0.042 * i as f32);
            b.block("slot", [x - 0.002 * u, -y * 0.75, z], [x, y * 0.75, z + h * 0.016], BLACK_PLASTIC);
        }
        display(b, x - 0.0025 * u, (-y * 0.3, h * 0.82), (y * 0.3, h * 0.9), COOL_BULB);
        b.block("grille", [-x * 0.6, -y * 0.7, h - 0.002 * u], [x * 0.6, y * 0.7, h], BLACK_PLASTIC);
    }
}

/// A drop or a tank on a base with a nozzle.
pub(super) fn humidifier(b: &mut Build<'_>) {
    let u = fit(b, [0.112, 0.112, 0.16]);
    let (x, y, h) = half_dims(b);
    let r = (x - 0.006 * u).min(y);
    let mat = b.choose(&[WHITE_PLASTIC, BLUE_PLASTIC, PINK_PLASTIC, GREY_PLASTIC]);
    let base = h * 0.28;
    b.lathe("base", [0.0; 3], &[(r * 0.9, 0.0), (r, base * 0.4), (r * 0.96, base)], WHITE_PLASTIC);
    let tall = h * 0.86 - base;
    let wall = 0.003 * u;
    let drop = b.rng.chance(0.5);
    let top = if drop { r * 0.5 } else { r * 0.86 };
    let tank = [
        (r * 0.94, 0.0),
        (r * 0.96, tall * 0.35),
        (top, tall),
        (top - wall, tall),
        (r * 0.96 - wall, tall * 0.35),
        (r * 0.94 - wall, wall),
    ];
    b.lathe("tank", [0.0, 0.0, base - 0.001 * u], &tank, if drop { mat } else { CLEAR_PLASTIC });
    b.lathe(
        "water",
        [0.0, 0.0, base + wall - 0.0005 * u],
        &[(r * 0.94 - wall * 1.6, 0.0), (r * 0.95 - wall * 1.6, tall * 0.3)],
        WATER,
    );
    lid(b, [-top, 0.0, h * 0.86], 1.4, |b| {
        b.lathe(
            "lid",
            [0.0, 0.0, h * 0.86 - 0.001 * u],
            &[(top, 0.0), (top * 0.7, h * 0.07), (top * 0.25, h * 0.08), (top * 0.22, h * 0.14 + 0.001 * u)],
            mat,
        );
    });
    knob(b, [r * 0.96, 0.0, base * 0.5], base * 0.24, (x - r * 0.96 - 0.001).clamp(0.001, 0.02), (mat, WHITE));
    b.rod("light", [r * 0.9, r * 0.3, base * 0.5], [r * 0.965, r * 0.3, base * 0.5], base * 0.08, LED);
}

/// A case on castors with louvres and a bucket that slides out.
pub(super) fn dehumidifier(b: &mut Build<'_>) {
    let u = fit(b, [0.16, 0.208, 0.352]);
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[WHITE_PLASTIC, GREY_PLASTIC]);
    let (foot, split) = (0.03 * u, h * 0.38);
    for (sx, sy) in [(0.7, 0.75), (-0.7, 0.75), (-0.7, -0.75), (0.7, -0.75)] {
        b.ball("castor", [x * sx, y * sy, foot * 0.6], foot * 0.6, BLACK_PLASTIC);
    }
    let face = x - 0.012 * u;
    b.rounded_block("head", [-x, -y, split], [face, y, h - 0.0015], 0.02 * u, mat);
    let wall = 0.012 * u;
    case(b, [-x, -y, foot], [face, y, split + 0.005 * u], wall, mat);
    for i in 0..8 {
        let z = split + (h - split) * (0.12 + 0.075 * i as f32);
        b.block(
            "slot",
            [face - 0.002 * u, -y * 0.8, z],
            [face + 0.001, y * 0.8, z + (h - split) * 0.03],
            BLACK_PLASTIC,
        );
    }
    display(b, face - 0.001 * u, (-y * 0.3, h * 0.86), (y * 0.3, h * 0.92), LED);
    b.block("outlet", [-x * 0.6, -y * 0.7, h - 0.006 * u], [x * 0.3, y * 0.7, h], BLACK_PLASTIC);
    let (low, high) = ([-x + wall * 1.5, -y + wall * 1.5, foot + wall * 1.2], [face, y - wall * 1.5, split - wall]);
    b.jointed(vc_graph::asset::JointKind::Slide, low, [1.0, 0.0, 0.0], (0.0, x * 1.4), |b| {
        basket(b, "compartment_1", low, [high[0] - 0.001 * u, high[1], high[2] - 0.02 * u], 0.004 * u, CLEAR_PLASTIC);
        b.block(
            "bucket",
            [face, -y * 0.94, foot + wall * 0.5],
            [x - 0.002 * u, y * 0.94, split - wall * 0.4],
            BLUE_GLASS,
        );
        b.block("grip", [x - 0.003 * u, -y * 0.3, split - wall * 2.4], [x, y * 0.3, split - wall * 1.2], mat);
    });
}
