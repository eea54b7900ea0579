//! Round packages: bottles, jars, cans, tubs and spray tins.

use vc_graph::portable::Portable;

use super::label::{GROWTH, wrap};
use super::look::{Look, look};
use crate::material::*;
use crate::solid::{Build, dims, flat_ring, turn, vessel_profile};

/// Outlines of bottles without caps, as fractions of radius and height, and the heights of their
/// label.
type Bottle = (&'static [(f32, f32)], (f32, f32));

const WINE: Bottle = (
    &[(0.94, 0.0), (1.0, 0.015), (1.0, 0.58), (0.9, 0.66), (0.45, 0.76), (0.37, 0.84), (0.37, 0.99), (0.4, 1.0)],
    (0.15, 0.48),
);
const HOCK: Bottle =
    (&[(0.94, 0.0), (1.0, 0.015), (1.0, 0.4), (0.85, 0.55), (0.45, 0.78), (0.36, 0.88), (0.36, 1.0)], (0.1, 0.36));
const SPARKLING: Bottle = (
    &[(0.94, 0.0), (1.0, 0.02), (1.0, 0.42), (0.85, 0.56), (0.4, 0.8), (0.34, 0.92), (0.4, 0.94), (0.36, 1.0)],
    (0.12, 0.38),
);
const BEER: Bottle =
    (&[(0.92, 0.0), (1.0, 0.03), (1.0, 0.55), (0.8, 0.66), (0.44, 0.78), (0.4, 0.98), (0.42, 1.0)], (0.14, 0.46));
const SPIRIT: Bottle = (&[(0.95, 0.0), (1.0, 0.02), (1.0, 0.66), (0.85, 0.74), (0.4, 0.8), (0.38, 1.0)], (0.14, 0.56));
const PET: Bottle = (
    &[
        (0.75, 0.0),
        (0.95, 0.05),
        (1.0, 0.12),
        (1.0, 0.3),
        (0.93, 0.34),
        (0.93, 0.6),
        (1.0, 0.64),
        (0.95, 0.75),
        (0.4, 0.94),
        (0.36, 1.0),
    ],
    (0.36, 0.58),
);
const PET_STRAIGHT: Bottle =
    (&[(0.8, 0.0), (0.97, 0.04), (0.97, 0.72), (0.8, 0.82), (0.42, 0.93), (0.38, 1.0)], (0.3, 0.6));
const SAUCE: Bottle = (&[(0.9, 0.0), (1.0, 0.04), (1.0, 0.55), (0.75, 0.72), (0.48, 0.84), (0.45, 1.0)], (0.12, 0.48));
const SQUAT: Bottle = (&[(0.9, 0.0), (1.0, 0.05), (1.0, 0.7), (0.8, 0.86), (0.5, 0.92), (0.5, 1.0)], (0.16, 0.6));

/// The radius of a body whose label stays within depth and width.
fn body_radius(x: f32, y: f32) -> f32 {
    let half = x.min(y) / 2.0;
    half - GROWTH.min(half * 0.1)
}

/// Bottles of glass and plastic with a cap or a foil.
pub(super) fn bottle(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let can = match b.class {
        "soda" => z < 0.18,
        "beer" => z < 0.17,
        "energy_drink" => true,
        _ => false,
    };
    if can {
        return drink_can(b);
    }
    let look = look(b);
    let r = body_radius(x, y);
    let outline: Bottle = match b.class {
        "wine" => b.choose(&[WINE, WINE, HOCK]),
        "champagne" => SPARKLING,
        "beer" => BEER,
        "whiskey" | "vodka" | "alcohol" => b.choose(&[SPIRIT, SPIRIT, WINE]),
        "bottled_water" | "soda" | "lemonade" | "iced_tea" | "juice" | "orange_juice" => b.choose(&[PET, PET_STRAIGHT]),
        "cough_syrup" | "mouthwash" => SQUAT,
        "oil" => b.choose(&[PET_STRAIGHT, HOCK, PET]),
        _ => b.choose(&[SAUCE, SAUCE, SQUAT]),
    };
    let foil = matches!(b.class, "wine" | "champagne");
    let h = if foil { z - 0.0008_f32.min(z * 0.01) } else { z * b.vary(0.91, 0.94) };
    let (profile, (low, high)) = outline;
    turn(b, "bottle", [0.0; 3], (r, h), profile, look.body);
    if let Some(drink) = content(look.body) {
        let level = (radius_at(profile, 0.7), 0.7);
        let below = profile.iter().copied().filter(|p| p.1 < level.1).chain([level]);
        let inner: Vec<_> = below.map(|p| (p.0 * 0.92, 0.02 + p.1 * 0.98)).collect();
        turn(b, "content", [0.0; 3], (r, h), &inner, drink);
    }
    let neck = profile.last().map_or(0.4, |p| p.0) * r;
    if foil {
        foil_cap(b, (r, h, z), profile, look.cap);
    } else {
        let grip = if b.class == "beer" { 1.35 } else { 1.18 };
        turn(
            b,
            "cap",
            [0.0, 0.0, h * 0.985],
            (neck * grip, z - h * 0.985),
            &[(1.0, 0.0), (1.0, 0.85), (0.9, 1.0)],
            look.cap,
        );
    }
    let within = profile.iter().filter(|p| p.1 > low && p.1 < high).map(|p| p.0);
    let widest = within.chain([low, high].map(|z| radius_at(profile, z))).fold(0.0, f32::max) * r;
    // A label in a waist must not coincide with the belly's radius.
    let near = |out: f32| (widest + out - r).abs() < 0.0008;
    let lift = if near(GROWTH) || near(GROWTH * 0.45) { 0.0016_f32.min(r * 0.04) } else { 0.0 };
    wrap(b, widest + lift, (h * low, h * high), look.label());
}

/// The radius of a profile at a height.
fn radius_at(profile: &[(f32, f32)], z: f32) -> f32 {
    let between = profile.windows(2).find(|p| p[0].1 <= z && z <= p[1].1);
    between.map_or(1.0, |p| p[0].0 + (p[1].0 - p[0].0) * (z - p[0].1) / (p[1].1 - p[0].1).max(1e-6))
}

/// The material visible through glass; its colour matches the bottle's, which distinguishes the
/// contents.
fn content(glass: MaterialId) -> Option<MaterialId> {
    match glass {
        GREEN_GLASS => Some(FOREST),
        BROWN_GLASS => Some(BROWN_PLASTIC),
        BLUE_GLASS => Some(BLUE_PLASTIC),
        GLASS | CLEAR_PLASTIC | FROSTED_GLASS => Some(WATER),
        _ => None,
    }
}

/// The foil over a cork and the neck.
fn foil_cap(b: &mut Build<'_>, (r, h, z): (f32, f32, f32), profile: &[(f32, f32)], mat: MaterialId) {
    let from = profile.iter().position(|p| p.1 > 0.75).unwrap_or(0);
    let grow = r * 0.03;
    let mut outline: Vec<_> = profile[from..].iter().map(|p| (p.0 * r + grow, p.1 * h)).collect();
    outline.push((profile.last().map_or(0.4, |p| p.0) * r, z));
    b.lathe("foil", [0.0; 3], &outline, mat);
}

/// A drinks can.
fn drink_can(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let look = look(b);
    let r = body_radius(x, y);
    let skin = if b.class == "beer" { b.choose(&[GREEN_METAL, RED_METAL, BLUE_METAL, WHITE_METAL]) } else { look.body };
    turn(b, "can", [0.0; 3], (r, z), &[(0.8, 0.0), (0.82, 0.015), (1.0, 0.08), (1.0, 0.88), (0.86, 0.96)], skin);
    flat_ring(b, "rim", (z * 0.955, z), (r * 0.78, r * 0.87), ALUMINIUM);
    b.cylinder("lid", [0.0, 0.0, z * 0.94], r * 0.8, z * 0.03, ALUMINIUM);
    b.block("tab", [-r * 0.1, -r * 0.16, z * 0.965], [r * 0.5, r * 0.16, z * 0.98], STEEL);
    wrap(b, r, (z * 0.2, z * 0.75), (skin, look.paper));
}

/// Food cans: high or flat, with ribs or a paper band, some with a pull ring.
pub(super) fn can(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let look = look(b);
    let r = body_radius(x, y);
    let rim = (z * 0.05).min(0.003);
    let k = 1.0 - (0.0028 / r).min(0.12);
    turn(
        b,
        "can",
        [0.0; 3],
        (r, z),
        &[
            (1.0, 0.0),
            (1.0, rim / z),
            (k, rim / z * 1.6),
            (k, 1.0 - rim / z * 1.6),
            (1.0, 1.0 - rim / z),
            (1.0, 1.0),
            (0.93, 1.0),
            (0.93, 1.0 - rim / z),
        ],
        look.body,
    );
    b.block("tab", [r * 0.1, -r * 0.2, z - rim * 1.1], [r * 0.85, r * 0.2, z - rim * 0.5], STEEL);
    let colour = if look.paper == WHITE_PAPER || b.rng.chance(0.5) { look.label() } else { (look.ink, look.paper) };
    wrap(b, r * k, (rim * 2.0, z - rim * 2.0), colour);
}

/// Jars with their content, a lid and a label.
pub(super) fn jar(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let look = look(b);
    let r = body_radius(x, y);
    let small = matches!(b.class, "spices" | "vitamins");
    let flat = b.class == "face_cream";
    let share = if flat { 0.55 } else { b.vary(0.8, 0.88) };
    let (h, rim) = (z * share, if flat { 1.0 } else { b.vary(0.82, 0.95) });
    let neck = rim * 0.92;
    let shape: [(f32, f32); 5] = if small || flat {
        [(0.92, 0.0), (0.97, 0.03), (0.97, 0.9), (rim * 0.88, 0.96), (rim * 0.88, 1.0)]
    } else {
        b.choose(&[
            [(0.88, 0.0), (1.0, 0.08), (1.0, 0.75), (neck, 0.93), (neck, 1.0)],
            [(0.82, 0.0), (1.0, 0.3), (0.98, 0.6), (neck, 0.92), (neck, 1.0)],
            [(0.95, 0.0), (1.0, 0.03), (1.0, 0.85), (neck, 0.95), (neck, 1.0)],
        ])
    };
    turn(b, "jar", [0.0; 3], (r - 0.0006_f32.min(r * 0.2), h), &shape, look.body);
    if let Some(pills) = content(look.body) {
        turn(
            b,
            "content",
            [0.0, 0.0, h * 0.02],
            (r * 0.94, h * 0.6),
            &[(shape[0].0, 0.0), (1.0, 0.1), (1.0, 1.0)],
            pills,
        );
    }
    let lid = (rim * 1.06).min(1.0) * r;
    turn(b, "lid", [0.0, 0.0, h * 0.97], (lid, z - h * 0.97), &[(1.0, 0.0), (1.0, 0.8), (0.95, 1.0)], look.cap);
    let round_ = shape[2].0.min(shape[1].0);
    if shape[1].1 < 0.2 {
        wrap(b, r * round_, (h * 0.2, h * 0.7), look.label());
    } else {
        wrap(b, r * 0.985, (h * 0.36, h * 0.58), look.label());
    }
}

/// Cups with a foil lid: yogurt, cream, dips.
pub(super) fn cup(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let look = look(b);
    let r = x.min(y) / 2.0;
    let foot = b.vary(0.72, 0.8);
    let rim = (z * 0.04).min(0.003) / z;
    turn(
        b,
        "cup",
        [0.0; 3],
        (r, z),
        &[(foot, 0.0), (0.95, 1.0 - 2.0 * rim), (1.0, 1.0 - 2.0 * rim), (1.0, 1.0 - rim)],
        look.body,
    );
    b.cylinder("lid", [0.0, 0.0, z * (1.0 - rim)], r * 0.99, z * rim, look.cap);
    // The band follows the slanted wall.
    let raised = 0.0014_f32.min(r * 0.042);
    let wall = |k: f32| r * (foot + (0.95 - foot) * k) + raised;
    let band = |low: f32, high: f32| {
        [
            (wall(low), z * low),
            (wall(high), z * high),
            (wall(high) * 0.95, z * high),
            (wall(low) * 0.95, z * low),
            (wall(low), z * low),
        ]
    };
    b.lathe("label", [0.0; 3], &band(0.12, 0.82), look.paper);
    let grow = |p: [(f32, f32); 5]| p.map(|(a, h)| (a + raised, h));
    b.lathe("print", [0.0; 3], &grow(band(0.6, 0.74)), look.ink);
    b.lathe("print", [0.0; 3], &grow(band(0.2, 0.34)), look.ink);
}

/// Spray cans: a shoulder, and a cap or a nozzle.
pub(super) fn aerosol(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let look = look(b);
    let r = body_radius(x, y);
    let h = z * b.vary(0.76, 0.82);
    turn(b, "can", [0.0; 3], (r, h), &[(0.97, 0.0), (1.0, 0.015), (1.0, 0.9), (0.85, 0.97), (0.6, 1.0)], look.body);
    let nozzle: &[(f32, f32)] = if b.class == "whipped_cream" {
        &[(0.6, 0.0), (0.6, 0.15), (0.35, 0.3), (0.22, 1.0)]
    } else {
        &[(0.84, 0.0), (0.84, 0.8), (0.76, 1.0)]
    };
    turn(b, "cap", [0.0, 0.0, h * 0.96], (r, z - h * 0.96), nozzle, look.cap);
    wrap(b, r, (h * 0.15, h * 0.8), look.label());
}

/// Shakers and mills for salt and pepper.
pub(super) fn shaker(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let wood = b.style.wood;
    match (b.class, b.rng.below(3)) {
        ("salt", 0) => {
            let card = Look { body: BLUE_CARD, ..look(b) };
            turn(b, "drum", [0.0; 3], (r - GROWTH.min(r * 0.1), z), &[(1.0, 0.0), (1.0, 0.97), (0.97, 1.0)], card.body);
            b.hull(
                "spout",
                &[
                    [r * 0.3, -r * 0.12, z * 0.985],
                    [r * 0.3, r * 0.12, z * 0.985],
                    [r * 0.7, -r * 0.12, z * 0.985],
                    [r * 0.7, r * 0.12, z * 0.985],
                    [r * 0.35, 0.0, z],
                ],
                STEEL,
            );
            wrap(b, r - GROWTH.min(r * 0.1), (z * 0.2, z * 0.8), card.label());
        }
        ("condiment_shaker" | "salt", _) => {
            let (body, content) = (b.choose(&[GLASS, GLASS, PORCELAIN, STEEL]), b.choose(&[PETAL_WHITE, BLACK]));
            let outside: Vec<_> =
                [(0.9, 0.0), (1.0, 0.05), (0.85, 0.72), (0.8, 0.78)].iter().map(|p| (p.0 * r, p.1 * z)).collect();
            b.lathe("glass", [0.0; 3], &vessel_profile(&outside, r * 0.1), body);
            turn(b, "content", [0.0, 0.0, z * 0.04], (r, z * 0.5), &[(0.78, 0.0), (0.85, 0.1), (0.75, 1.0)], content);
            turn(
                b,
                "cap",
                [0.0, 0.0, z * 0.76],
                (r * 0.88, z * 0.235),
                &[(1.0, 0.0), (1.0, 0.5), (0.7, 0.9), (0.0, 1.0)],
                STEEL,
            );
            for i in 0..5 {
                let (s, c) = (std::f32::consts::TAU * i as f32 / 5.0).sine_cosine();
                b.cylinder("hole", [r * 0.3 * c, r * 0.3 * s, z * 0.96], r * 0.06, z * 0.028, BLACK_PLASTIC);
            }
        }
        _ => {
            let mat = b.choose(&[wood, WALNUT, BLACK_PLASTIC, BEECH]);
            let mill = [
                (0.95, 0.0),
                (1.0, 0.03),
                (0.95, 0.12),
                (0.62, 0.35),
                (0.75, 0.6),
                (0.8, 0.66),
                (0.55, 0.7),
                (0.85, 0.76),
                (0.9, 0.86),
                (0.6, 0.95),
            ];
            turn(b, "mill", [0.0; 3], (r, z), &mill, mat);
            flat_ring(b, "band", (z * 0.665, z * 0.69), (r * 0.4, r * 0.72), STEEL);
            turn(b, "knob", [0.0, 0.0, z * 0.94], (r * 0.3, z * 0.06), &[(0.6, 0.0), (1.0, 0.5), (0.5, 1.0)], STEEL);
        }
    }
}
