//! Garden decoration: lights, wind chimes and weather vanes.

use std::f32::consts::{FRAC_PI_2, PI, TAU};

use crate::material::*;
use crate::solid::{Axis, Build, P, at_least, polar, polygon, star, torus_profile};

/// A lantern: panes in a frame around a candle, or a drum of paper-like cloth.
pub(super) fn lantern(b: &mut Build<'_>) {
    at_least(b, [0.05, 0.05, 0.08]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let metal = b.choose(&[IRON, BLACK_METAL, BRASS, COPPER, WHITE_METAL, RUST, GREY_OAK]);
    let (low, eaves) = (h * 0.07, h * b.vary(0.58, 0.66));
    let sides = b.choose(&[4, 4, 6]);
    let turn = PI / sides as f32;
    b.prism("base", Axis::Z, [0.0; 3], &fitted(sides, r, turn), low, metal);
    for (px, py) in fitted(sides, r * 0.88, turn) {
        b.rod("post", [px, py, low - 0.002], [px, py, eaves + 0.002], r * 0.07, metal);
    }
    b.prism("glass", Axis::Z, [0.0, 0.0, low], &fitted(sides, r * 0.84, turn), eaves - low, GLASS);
    let candle = (eaves - low) * b.vary(0.4, 0.7);
    b.cylinder("candle", [0.0, 0.0, low], r * 0.35, candle, WAX);
    b.lathe(
        "flame",
        [0.0, 0.0, low + candle - 0.003],
        &[(r * 0.06, 0.0), (r * 0.11, (eaves - low - candle) * 0.3), (0.0, (eaves - low - candle) * 0.8)],
        WARM_BULB,
    );
    let top = h * 0.83;
    let ring = |radius: f32, z: f32| fitted(sides, radius, turn).into_iter().map(move |(px, py)| [px, py, z]);
    b.hull("roof", &ring(r, eaves).chain(ring(r, eaves + 0.008)).chain(ring(r * 0.25, top)).collect::<Vec<P>>(), metal);
    b.cylinder("cap", [0.0, 0.0, top - 0.004], r * 0.2, h * 0.04, metal);
    let ring_r = (h - top - h * 0.03) / 2.0;
    let wire = (ring_r * 0.12).max(0.0015);
    b.lathe_along("ring", [0.0, -wire, h - ring_r], [0.0, 1.0, h - ring_r], &torus_profile(ring_r - wire, wire), metal);
}

/// A polygon that just fits into a square of half side `half`.
fn fitted(sides: usize, half: f32, turn: f32) -> Vec<(f32, f32)> {
    let share = if sides == 4 { 2.0_f32.sqrt() } else { 1.0 };
    polygon(sides, half * share, turn)
}

/// A solar light on a spike.
pub(super) fn solar_light(b: &mut Build<'_>) {
    at_least(b, [0.03, 0.03, 0.1]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let metal = b.choose(&[STEEL, BLACK_PLASTIC, COPPER, WHITE_METAL]);
    let head = (r * b.vary(1.4, 2.2)).min(h * 0.4);
    let low = h - head;
    let spike = h * 0.2;
    b.lathe("spike", [0.0; 3], &[(0.0, 0.0), (r * 0.16, spike * 0.7), (r * 0.1, spike)], BLACK_PLASTIC);
    b.cylinder("pole", [0.0, 0.0, spike - 0.005], r * 0.12, low - spike + 0.01, metal);
    match b.rng.below(3) {
        0 => b.lathe("lamp", [0.0, 0.0, low], &[(r * 0.45, 0.0), (r * 0.8, head * 0.8)], WARM_BULB),
        1 => b.cylinder("lamp", [0.0, 0.0, low], r * 0.6, head * 0.8, COOL_BULB),
        _ => b.ball("lamp", [0.0, 0.0, low + head * 0.42], (head * 0.42).min(r * 0.95), WARM_BULB),
    }
    b.lathe("cap", [0.0, 0.0, low + head * 0.78], &[(r, 0.0), (r, head * 0.07), (r * 0.75, head * 0.2)], metal);
    b.block("panel", [-r * 0.45, -r * 0.45, low + head * 0.96], [r * 0.45, r * 0.45, h], BLACK_GLASS);
}

/// A wind chime: tubes of decreasing length under a disc, a clapper, a sail.
pub(super) fn wind_chime(b: &mut Build<'_>) {
    at_least(b, [0.04, 0.04, 0.2]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let (metal, wood) = (b.choose(&[ALUMINIUM, BRASS, COPPER, BAMBOO]), b.choose(&[BEECH, WALNUT, BAMBOO, TEAK]));
    let disc = h * b.vary(0.78, 0.83);
    b.cylinder("disc", [0.0, 0.0, disc], r, 0.012_f32.min(h * 0.04), wood);
    let tubes = b.rng.count(4, 8);
    let radius = (r * 2.0 / tubes as f32).min(r * 0.25);
    let (longest, fall) = (h * b.vary(0.45, 0.55), b.vary(0.3, 0.6));
    for i in 0..tubes {
        let (px, py) = polar(TAU * i as f32 / tubes as f32, r - radius * 1.1);
        let long = longest * (1.0 - fall * i as f32 / tubes as f32);
        b.cylinder("tube", [px, py, disc - h * 0.07 - long], radius, long, metal);
        b.cylinder("cord", [px, py, disc - h * 0.075], 0.0015, h * 0.08, BLACK_FABRIC);
        b.rod("cord", [px, py, disc + 0.005], [0.0, 0.0, h - 0.02], 0.0015, BLACK_FABRIC);
    }
    let clapper = disc - longest * 0.5;
    b.cylinder("cord", [0.0, 0.0, h * 0.1], 0.0015, disc - h * 0.1 + 0.004, BLACK_FABRIC);
    b.cylinder("clapper", [0.0, 0.0, clapper], r * 0.35, 0.012_f32.min(h * 0.03), wood);
    b.prism(
        "sail",
        Axis::X,
        [-0.002, 0.0, 0.0],
        &[(0.0, h * 0.13), (r * 0.4, h * 0.07), (0.0, 0.0), (-r * 0.4, h * 0.07)],
        0.004,
        wood,
    );
    let ring = 0.01_f32.min(h * 0.03);
    b.lathe_along("ring", [0.0, -0.002, h - ring], [0.0, 1.0, h - ring], &torus_profile(ring - 0.002, 0.002), metal);
}

/// The letters N, W, S and E, as high as wide, centred at the origin.
const LETTERS: [&[(f32, f32)]; 4] = [
    &[
        (-1.0, -1.0),
        (-0.5, -1.0),
        (-0.5, 0.3),
        (0.5, -1.0),
        (1.0, -1.0),
        (1.0, 1.0),
        (0.5, 1.0),
        (0.5, -0.3),
        (-0.5, 1.0),
        (-1.0, 1.0),
    ],
    &[
        (-1.0, 1.0),
        (-0.65, -1.0),
        (-0.3, -1.0),
        (0.0, -0.1),
        (0.3, -1.0),
        (0.65, -1.0),
        (1.0, 1.0),
        (0.65, 1.0),
        (0.45, -0.3),
        (0.15, 0.5),
        (-0.15, 0.5),
        (-0.45, -0.3),
        (-0.65, 1.0),
    ],
    &[
        (-0.8, -1.0),
        (0.8, -1.0),
        (0.8, 0.2),
        (-0.35, 0.2),
        (-0.35, 0.6),
        (0.8, 0.6),
        (0.8, 1.0),
        (-0.8, 1.0),
        (-0.8, -0.2),
        (0.35, -0.2),
        (0.35, -0.6),
        (-0.8, -0.6),
    ],
    &[
        (-0.8, -1.0),
        (0.8, -1.0),
        (0.8, -0.6),
        (-0.35, -0.6),
        (-0.35, -0.2),
        (0.6, -0.2),
        (0.6, 0.2),
        (-0.35, 0.2),
        (-0.35, 0.6),
        (0.8, 0.6),
        (0.8, 1.0),
        (-0.8, 1.0),
    ],
];

/// A weather vane: a mast, letters of the compass, a rotating arrow with a figure.
pub(super) fn weather_vane(b: &mut Build<'_>) {
    at_least(b, [0.12, 0.12, 0.2]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let metal = b.choose(&[IRON, COPPER, RUST, BLACK_METAL, BRASS]);
    let r = x.min(y);
    let figure = (r * 1.1).min(h * 0.45);
    let arms = h - figure - h * 0.12;
    let thin = (h * 0.008).clamp(0.004, 0.012);
    b.lathe("foot", [0.0; 3], &[(r * 0.5, 0.0), (r * 0.45, h * 0.02), (thin * 2.0, h * 0.05)], metal);
    // The arrow turns on its tip.
    b.cylinder("mast", [0.0, 0.0, h * 0.03], thin * 1.3, h * 0.97 - figure - thin * 0.8 + 0.001, metal);
    for (i, letter) in LETTERS.iter().enumerate() {
        let (px, py) = polar(FRAC_PI_2 * i as f32, r * 0.86);
        b.rod("arm", [0.0, 0.0, arms], [px, py, arms], thin * 0.7, metal);
        let s = (r * 0.11).min(h * 0.05);
        let outline: Vec<(f32, f32)> = letter.iter().map(|&(u, v)| (py + s * u, arms + s * v)).collect();
        b.prism("letter", Axis::X, [px - s * 0.25, 0.0, 0.0], &outline, s * 0.5, metal);
    }
    b.ball("ball", [0.0, 0.0, arms + h * 0.04], thin * 2.5, BRASS);
    let z = h - figure;
    let turn = b.vary(-1.0, 1.0);
    b.jointed(vc_graph::asset::JointKind::Hinge, [0.0; 3], [0.0, 0.0, 1.0], (-1e4, 1e4), |b| {
        b.at([0.0; 3], turn, |b| {
            let reach = r * 0.97;
            b.rod("arrow", [0.0, -reach * 0.85, z], [0.0, reach * 0.85, z], thin * 0.8, metal);
            let (tip, w) = (reach * 0.97, figure * 0.13);
            b.prism(
                "arrow",
                Axis::X,
                [-thin * 0.5, 0.0, z],
                &[(reach * 0.72, -w), (tip, 0.0), (reach * 0.72, w)],
                thin,
                metal,
            );
            b.prism(
                "arrow",
                Axis::X,
                [-thin * 0.5, 0.0, z],
                &[(-tip, -w), (-reach * 0.7, -w * 0.2), (-reach * 0.7, w * 0.2), (-tip, w)],
                thin,
                metal,
            );
            cock(b, z, (figure, thin), metal);
        });
    });
}

/// The outline of a cock, a ship or a shooting star, standing at a height.
fn cock(b: &mut Build<'_>, z: f32, (tall, thin): (f32, f32), metal: MaterialId) {
    let cockerel = [
        (-0.08, 0.0),
        (0.08, 0.0),
        (0.1, 0.22),
        (0.28, 0.4),
        (0.36, 0.7),
        (0.5, 0.74),
        (0.37, 0.82),
        (0.33, 0.97),
        (0.2, 1.0),
        (0.17, 0.85),
        (0.1, 0.6),
        (-0.1, 0.5),
        (-0.3, 0.85),
        (-0.5, 0.88),
        (-0.58, 0.65),
        (-0.45, 0.4),
        (-0.2, 0.2),
    ];
    let ship = [
        (-0.05, 0.0),
        (0.3, 0.03),
        (0.45, 0.22),
        (0.06, 0.22),
        (0.06, 0.3),
        (0.4, 0.35),
        (0.06, 0.98),
        (-0.02, 0.98),
        (-0.35, 0.35),
        (-0.02, 0.3),
        (-0.02, 0.22),
        (-0.45, 0.22),
        (-0.3, 0.03),
    ];
    let scale = |points: &[(f32, f32)]| -> Vec<(f32, f32)> {
        points.iter().map(|&(py, pz)| (py * tall * 0.75, pz * tall)).collect()
    };
    let outline = match b.rng.below(3) {
        0 => scale(&cockerel),
        1 => scale(&ship),
        _ => star(b.rng.count(5, 9), tall * 0.5, tall * 0.22)
            .into_iter()
            .map(|(py, pz)| (py, pz * 0.99 + tall * 0.5))
            .collect(),
    };
    b.prism("figure", Axis::X, [-thin * 0.4, 0.0, z], &outline, thin * 0.8, metal);
}
