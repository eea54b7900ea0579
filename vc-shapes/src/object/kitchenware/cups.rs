//! Cups, glasses, jugs and bottles.

use vc_graph::portable::Portable;

use super::dishes::KNOB;
use crate::material::*;
use crate::solid::{Build, arch, dims, ear, flat_ring, planar_tube, sweep, turn, vessel};

/// Glazes and paints of mugs.
const COLOURS: [MaterialId; 9] =
    [PORCELAIN, STONEWARE, BLUE_GLAZE, GREEN_GLAZE, RED_GLAZE, YELLOW_GLAZE, BLACK_GLAZE, WHITE_METAL, BLUE_METAL];

/// Cups, mugs and small jugs: a body with a handle.
pub(super) fn cup(b: &mut Build<'_>) {
    let (x, y, h) = dims(b);
    let milk = b.class == "milk_jug";
    let r = (x / 2.0).min(y * if milk { 0.34 } else { 0.39 }) * 0.99;
    let t = (r * 0.09).clamp(1e-4, 0.0045);
    let mug = b.class == "mug";
    let mat = b.style.crockery;
    let mat = if mug && b.rng.chance(0.6) { b.choose(&COLOURS) } else { mat };
    let shape: &[(f32, f32)] = match (b.class, b.rng.below(3)) {
        ("mug", 0) => &[(0.92, 0.0), (1.0, 0.06), (1.0, 0.5), (1.0, 1.0)],
        ("mug", 1) => &[(0.75, 0.0), (0.8, 0.03), (0.95, 0.6), (1.0, 1.0)],
        ("mug", _) => &[(0.65, 0.0), (0.9, 0.15), (1.0, 0.45), (0.92, 0.8), (0.96, 1.0)],
        ("milk_jug", _) => &[(0.7, 0.0), (0.95, 0.2), (1.0, 0.4), (0.72, 0.78), (0.85, 1.0)],
        (_, 0) => &[(0.5, 0.0), (0.5, 0.06), (0.8, 0.25), (0.94, 0.6), (1.0, 1.0)],
        (_, 1) => &[(0.55, 0.0), (0.6, 0.05), (0.85, 0.6), (1.0, 1.0)],
        _ => &[(0.7, 0.0), (0.92, 0.12), (0.98, 0.5), (1.0, 1.0)],
    };
    vessel(b, b.class, (r, h), shape, t, mat);
    // The radius at which the handle leaves the body, from the outline there.
    let wall = shape.iter().filter(|p| p.1 > 0.15 && p.1 < 0.9).fold(1.0_f32, |least, p| least.min(p.0)) * r;
    let (low, high) = if mug { (0.18, 0.86) } else { (0.3, 0.88) };
    let reach = (y - r * if milk { 1.32 } else { 1.02 }).min(r * 2.4);
    ear(b, (wall - t * 0.5, reach), (h * low, h * high), (r * 0.11).min(0.006), mat);
    if b.class == "milk_jug" {
        spout(b, (shape[4].0 * r, h), r * 0.3, mat);
    } else if shape[3].0 == 1.0 && shape[1].0 == 1.0 && b.rng.chance(0.6) {
        let band = b.choose(&COLOURS);
        let (z, wide) = (b.vary(0.2, 0.5) * h, b.vary(0.1, 0.35) * h);
        flat_ring(b, "band", (z, z + wide), (r * 0.97, r + 0.0006), band);
    }
}

/// A lip on the -Y side of a vessel's rim.
fn spout(b: &mut Build<'_>, (r, h): (f32, f32), reach: f32, mat: MaterialId) {
    let (y, h) = (-r * 0.9, h * 0.992);
    let points = [
        [r * 0.4, y, h],
        [-r * 0.4, y, h],
        [0.0, -r - reach, h],
        [0.0, y, h * 0.8],
        [r * 0.3, y, h * 0.95],
        [-r * 0.3, y, h * 0.95],
    ];
    b.hull("lip", &points, mat);
}

/// Glasses without a stem or handle.
pub(super) fn tumbler(b: &mut Build<'_>) {
    let (x, y, h) = dims(b);
    let r = x.min(y) / 2.0;
    let t = (r * 0.07).clamp(1e-4, 0.0035);
    let mat = b.choose(&[GLASS, GLASS, GLASS, BLUE_GLASS, GREEN_GLASS]);
    let shape: &[(f32, f32)] = match b.rng.below(4) {
        0 => &[(0.8, 0.0), (0.84, 0.03), (0.95, 0.7), (1.0, 1.0)],
        1 => &[(0.97, 0.0), (1.0, 0.03), (1.0, 0.5), (1.0, 1.0)],
        2 => &[(0.7, 0.0), (0.95, 0.25), (1.0, 0.5), (0.93, 1.0)],
        _ => &[(0.78, 0.0), (0.8, 0.45), (0.95, 0.52), (1.0, 1.0)],
    };
    vessel(b, "glass", (r, h), shape, if b.class == "shot_glass" { h * 0.08 } else { t }, mat);
}

/// Stem glasses: for wine, and narrow ones for champagne.
pub(super) fn stemmed(b: &mut Build<'_>) {
    let (x, y, h) = dims(b);
    let r = x.min(y) / 2.0;
    let t = (0.0018 / r).min(0.1);
    let flute = b.class == "champagne_flute";
    let (stem, belly, mouth) =
        if flute { (b.vary(0.3, 0.4), 0.95, b.vary(0.7, 0.95)) } else { (b.vary(0.38, 0.48), 1.0, b.vary(0.72, 0.9)) };
    let foot = if flute { 1.0 } else { b.vary(0.8, 0.95) };
    let thin = (0.004 / r).min(0.12);
    let rise = 1.0 - stem;
    let bulge = if flute { 0.55 } else { b.vary(0.3, 0.45) };
    let profile = [
        (foot, 0.0),
        (foot, 0.008),
        (thin * 2.0, 0.03),
        (thin, 0.08),
        (thin, stem - 0.02),
        (belly * 0.45, stem + rise * 0.06),
        (belly * 0.88, stem + rise * bulge * 0.55),
        (belly, stem + rise * bulge),
        (mouth, 1.0),
        (mouth - t, 1.0),
        (belly - t, stem + rise * bulge),
        (belly * 0.88 - t, stem + rise * bulge * 0.57),
        (belly * 0.4, stem + rise * 0.09),
    ];
    turn(b, "glass", [0.0; 3], (r, h), &profile, GLASS);
    let floor = h * (stem + rise * 0.09);
    b.inside(
        "inside",
        [0.0, 0.0, floor],
        ((r * belly * 0.26).max(0.0042), (r * belly * 0.26).max(0.0042)),
        (h - floor).max(0.0),
    );
}

/// Beer glasses: mugs of thick glass with a handle, or tall glasses.
pub(super) fn beer_glass(b: &mut Build<'_>) {
    let (x, y, h) = dims(b);
    if y < x * 1.2 {
        return tumbler(b);
    }
    let r = (x / 2.0).min(y * 0.4);
    let t = r * 0.12;
    vessel(b, "glass", (r, h), &[(0.95, 0.0), (1.0, 0.05), (0.95, 0.5), (0.97, 1.0)], t, GLASS);
    for i in 0..8 {
        let angle = std::f32::consts::TAU * i as f32 / 8.0;
        b.at([0.0; 3], angle, |b| {
            let middle = r * 0.9;
            b.rounded_block(
                "facet",
                [middle - t * 0.4, -r * 0.2, h * 0.15],
                [r * 0.985, r * 0.2, h * 0.7],
                t * 0.3,
                GLASS,
            );
        });
    }
    ear(b, (r * 0.9, y - r), (h * 0.15, h * 0.85), r * 0.14, GLASS);
}

/// Jugs: a belly, a neck, a lip and a large handle.
pub(super) fn jug(b: &mut Build<'_>) {
    let (x, y, h) = dims(b);
    let r = (x / 2.0).min(y * 0.38);
    let t = (r * 0.06).min(0.005);
    let mat = b.choose(&[GLASS, GLASS, b.style.crockery, STEEL, BLUE_GLAZE, WHITE_PLASTIC]);
    let shape: &[(f32, f32)] = match b.rng.below(3) {
        0 => &[(0.7, 0.0), (0.95, 0.15), (1.0, 0.35), (0.68, 0.75), (0.72, 0.9), (0.85, 1.0)],
        1 => &[(0.92, 0.0), (1.0, 0.04), (0.95, 0.4), (0.88, 0.8), (0.88, 0.92), (0.92, 1.0)],
        _ => &[(0.75, 0.0), (0.8, 0.03), (0.88, 0.4), (0.95, 0.7), (0.98, 0.9), (1.0, 1.0)],
    };
    vessel(b, "jug", (r, h), shape, t, mat);
    let wall = shape[3].0.min(shape[4].0) * r;
    ear(b, (wall - t, r + (y - 2.0 * r) * 0.75), (h * 0.3, h * 0.92), r * 0.11, mat);
    spout(b, (shape[5].0 * r, h), (y - 2.0 * r) * 0.22 + r - shape[5].0 * r, mat);
}

/// Carafes and decanters; decanters have a stopper.
pub(super) fn carafe(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let stopper = b.rng.chance(0.4);
    let h = if stopper { z * 0.85 } else { z };
    let shape: &[(f32, f32)] = match b.rng.below(3) {
        0 => &[(0.85, 0.0), (1.0, 0.1), (0.9, 0.35), (0.35, 0.65), (0.3, 0.85), (0.45, 1.0)],
        1 => &[(0.9, 0.0), (0.95, 0.05), (0.95, 0.5), (0.5, 0.68), (0.45, 0.85), (0.55, 1.0)],
        _ => &[(0.7, 0.0), (1.0, 0.2), (0.95, 0.32), (0.3, 0.55), (0.26, 0.8), (0.36, 1.0)],
    };
    vessel(b, "carafe", (r, h), shape, (r * 0.05).min(0.003), GLASS);
    if stopper {
        let (neck, plug) = (shape[4].0 * r * 0.85, h * 0.06);
        let cork = b.choose(&[CORK, BLACK_PLASTIC]);
        b.slide([0.0, 0.0, 1.0], z * 0.3, |b| {
            b.cylinder("plug", [0.0, 0.0, h - plug], neck * 0.9, plug, cork);
            let knob = [(1.0, 0.0), (1.0, 0.15), (0.6, 0.25), (0.95, 0.7), (0.5, 1.0)];
            turn(b, "stopper", [0.0, 0.0, h + 0.0003], (shape[5].0 * r * 0.98, z - h), &knob, cork);
        });
    }
}

/// Teapots: a belly with a spout, a handle and a lid.
pub(super) fn teapot(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = (x / 2.0).min(y * 0.33);
    let h = z * 0.78;
    let t = (r * 0.06).min(0.004);
    let mat = b.choose(&[b.style.crockery, PORCELAIN, BLUE_GLAZE, BLACK_METAL, GREEN_GLAZE, POTTERY, STEEL]);
    let shape: &[(f32, f32)] = match b.rng.below(3) {
        0 => &[(0.55, 0.0), (0.9, 0.2), (1.0, 0.5), (0.85, 0.8), (0.45, 1.0)],
        1 => &[(0.85, 0.0), (0.98, 0.1), (0.95, 0.5), (0.8, 0.9), (0.5, 1.0)],
        _ => &[(0.6, 0.0), (0.62, 0.06), (1.0, 0.4), (0.9, 0.75), (0.5, 1.0)],
    };
    vessel(b, "teapot", (r, h), shape, t, mat);
    lid(b, shape[4].0 * r * 1.12, h, z, mat);
    let spare = (y - 2.0 * r) / 2.0;
    ear(b, (r * 0.84, r + spare), (h * 0.3, h * 0.88), r * 0.1, mat);
    let s = r * 0.12;
    let path = [
        ([0.0, -r * 0.8, h * 0.3], s * 1.9, s * 1.9),
        ([0.0, -r * 1.05, h * 0.45], s * 1.4, s * 1.4),
        ([0.0, -r - spare * 0.55, h * 0.7], s, s),
        ([0.0, -r - spare + s * 0.6, h * 0.95], s * 0.8, s * 0.8),
    ];
    sweep(b, "spout", &path, [1.0, 0.0, 0.0], mat);
}

/// A removable lid with a knob, from the rim at `z.0` up to `top`.
fn lid(b: &mut Build<'_>, r: f32, rim: f32, top: f32, mat: MaterialId) {
    let rise = (top - rim) * 0.45;
    b.slide([0.0, 0.0, 1.0], top * 0.4, |b| {
        turn(b, "lid", [0.0, 0.0, rim + 0.0003], (r, rise), &[(1.0, 0.0), (1.0, 0.15), (0.7, 0.7), (0.1, 1.0)], mat);
        turn(b, "knob", [0.0, 0.0, rim + rise * 0.93], (r * 0.28, top - rim - rise * 0.93), KNOB, mat);
    });
}

/// A French press: a glass beaker in a frame with a plunger.
pub(super) fn french_press(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = (x / 2.0).min(y * 0.38);
    let (metal, dark) = (b.choose(&[CHROME, STEEL, COPPER, BLACK_METAL]), b.choose(&[BLACK_PLASTIC, b.style.wood]));
    let h = z * 0.72;
    let g = r * 0.94;
    vessel(b, "beaker", (g, h), &[(0.98, 0.0), (1.0, 0.02), (1.0, 0.5), (1.0, 1.0)], (r * 0.05).min(0.0025), GLASS);
    flat_ring(b, "band", (h * 0.03, h * 0.12), (g * 0.99, r), metal);
    flat_ring(b, "band", (h * 0.82, h * 0.9), (g * 0.99, r), metal);
    for i in 0..4 {
        b.at([0.0; 3], std::f32::consts::FRAC_PI_4 + std::f32::consts::FRAC_PI_2 * i as f32, |b| {
            b.block("strut", [g * 0.995, -r * 0.08, h * 0.1], [r * 0.995, r * 0.08, h * 0.84], metal);
        });
    }
    ear(b, (r * 0.97, y - r), (h * 0.1, h * 0.88), r * 0.13, dark);
    b.slide([0.0, 0.0, 1.0], z, |b| {
        turn(b, "lid", [0.0, 0.0, h + 0.0005], (r, z * 0.08), &[(1.0, 0.0), (1.0, 0.3), (0.5, 0.9), (0.1, 1.0)], metal);
        b.cylinder("rod", [0.0, 0.0, h + z * 0.07], r * 0.05, z * 0.15, metal);
        b.ball("knob", [0.0, 0.0, z - r * 0.2], r * 0.2, dark);
    });
}

/// Flasks, shakers and drinking bottles: a body, a shoulder and a cap.
pub(super) fn flask(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let (body, cap) = match b.class {
        "thermos" => {
            (b.choose(&[STEEL, RED_METAL, BLUE_METAL, GREEN_METAL, BLACK_METAL]), b.choose(&[STEEL, BLACK_PLASTIC]))
        }
        "baby_bottle" => (CLEAR_PLASTIC, b.choose(&[BLUE_PLASTIC, PINK_PLASTIC, WHITE_PLASTIC, YELLOW_PLASTIC])),
        "cocktail_shaker" => {
            let m = b.choose(&[STEEL, CHROME, COPPER, BRASS]);
            (m, m)
        }
        _ => (
            b.choose(&[STEEL, CLEAR_PLASTIC, BLUE_PLASTIC, GREEN_METAL, RED_METAL, PINK_PLASTIC, BLACK_METAL]),
            b.choose(&[BLACK_PLASTIC, STEEL, WHITE_PLASTIC, BAMBOO]),
        ),
    };
    let neck = if b.class == "thermos" { 0.85 } else { b.vary(0.55, 0.8) };
    let top = b.vary(0.76, 0.84);
    let outside = [(0.93, 0.0), (1.0, 0.02), (1.0, top * 0.85), (neck, top * 0.97), (neck, top)];
    vessel(
        b,
        "body",
        (r, z),
        &[outside[0], outside[1], outside[2], outside[3], outside[4]],
        (r * 0.06).min(0.003),
        body,
    );
    let (base, high) = (z * top, z * (1.0 - top));
    let c = (neck * r * 1.06).min(r);
    b.slide([0.0, 0.0, 1.0], z * 0.4, |b| match b.class {
        "baby_bottle" => {
            b.cylinder("collar", [0.0, 0.0, base + 0.0003], c, high * 0.35, cap);
            let teat = [(0.75, 0.0), (0.6, 0.3), (0.35, 0.55), (0.38, 0.85), (0.2, 1.0)];
            turn(b, "teat", [0.0, 0.0, base + high * 0.34], (c, high * 0.66), &teat, WAX);
        }
        "cocktail_shaker" => {
            turn(
                b,
                "cap",
                [0.0, 0.0, base + 0.0003],
                (c, high - 0.0003),
                &[(1.0, 0.0), (0.95, 0.3), (0.6, 0.45), (0.58, 0.95), (0.5, 1.0)],
                cap,
            );
        }
        _ => {
            turn(b, "cap", [0.0, 0.0, base + 0.0003], (c, high - 0.0003), &[(1.0, 0.0), (1.0, 0.85), (0.85, 1.0)], cap);
        }
    });
    match b.class {
        "baby_bottle" => {
            for i in 1..5 {
                let at = z * top * 0.16 * i as f32;
                b.block("mark", [r * 0.97, -r * 0.2, at], [r, r * 0.2, at + z * 0.004], BLACK_PLASTIC);
            }
        }
        "thermos" if y > x * 1.05 => ear(b, (r * 0.95, y - r), (z * 0.35, z * 0.75), r * 0.12, BLACK_PLASTIC),
        "water_bottle" if b.rng.chance(0.5) => b.slide([0.0, 0.0, 1.0], z * 0.4, |b| {
            let loop_ = arch([0.0, 0.0, z * 0.97], [0.0, c * 0.6, 0.0], [0.0, 0.0, z * 0.025]);
            planar_tube(b, "strap", &loop_, z * 0.005, [1.0, 0.0, 0.0], cap);
        }),
        _ => {}
    }
}

/// An octagonal moka pot, or a tall pot for filter coffee.
pub(super) fn coffee_pot(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = (x / 2.0).min(y * 0.32);
    let mat = b.choose(&[ALUMINIUM, ALUMINIUM, STEEL, RED_METAL, b.style.crockery]);
    let spare = y - 2.0 * r;
    let (waist, h) = (0.45 * z, z * 0.82);
    let ring = |k: f32, z: f32| {
        let point = |i: usize| {
            let (s, c) = (std::f32::consts::TAU * (i as f32 + 0.5) / 8.0).sine_cosine();
            [r * k * c * 1.08, r * k * s * 1.08, z]
        };
        (0..8).map(point).collect::<Vec<_>>()
    };
    let lower = [ring(0.93, 0.0), ring(0.98, z * 0.02), ring(0.7, waist)];
    crate::solid::loft_columns(b, "base", &lower, mat);
    flat_ring(b, "collar", (waist - z * 0.03, waist + z * 0.03), (r * 0.3, r * 0.76), mat);
    let wall = (r * 0.08).min(0.004);
    let floor = waist + z * 0.06;
    let inner = |k: f32, z: f32| ring(k - wall / r, z);
    let rings = [ring(0.62, waist), ring(0.95, h), inner(0.95, h), inner(0.7, floor)];
    crate::solid::loft_columns(b, "jug", &rings, mat);
    b.inside("inside", [0.0, 0.0, floor], (r * 0.4, r * 0.4), (h - floor - 0.002).max(0.0));
    b.slide([0.0, 0.0, 1.0], z * 0.5, |b| {
        let rings = [ring(0.94, h + 0.0003), ring(0.94, h + z * 0.02), ring(0.2, z * 0.93)];
        crate::solid::loft_columns(b, "lid", &rings, mat);
        turn(b, "knob", [0.0, 0.0, z * 0.92], (r * 0.2, z * 0.08), KNOB, BLACK_PLASTIC);
    });
    let points = [
        [r * 0.3, -r * 0.8, h * 0.992],
        [-r * 0.3, -r * 0.8, h * 0.992],
        [0.0, -r - spare * 0.2, h * 0.992],
        [0.0, -r * 0.8, h * 0.8],
    ];
    b.hull("lip", &points, mat);
    let (g, out) = (r * 0.11, r + spare * 0.8 - r * 0.11);
    let path = [
        ([0.0, r * 0.85, h * 0.92], g, g),
        ([0.0, out * 0.93, h * 0.94], g, g),
        ([0.0, out, h * 0.85], g, g),
        ([0.0, out * 0.98, waist], g, g * 0.8),
    ];
    sweep(b, "handle", &path, [1.0, 0.0, 0.0], BLACK_PLASTIC);
}
