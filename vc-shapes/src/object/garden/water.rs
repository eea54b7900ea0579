//! Watering equipment.

use std::f32::consts::TAU;

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Build, P, at_least, limb, polar, spaced};

/// A watering can with spout, rose and handles.
pub(super) fn watering_can(b: &mut Build<'_>) {
    at_least(b, [0.07, 0.17, 0.12]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = b.choose(&[GREEN_PLASTIC, GALVANISED, BLUE_PLASTIC, RED_METAL, COPPER, YELLOW_PLASTIC, GREY_PLASTIC]);
    let r = x.min(y * 0.5);
    let body = h * b.vary(0.62, 0.75);
    let cy = -y + r + y * b.vary(0.02, 0.2);
    let t = 0.004;
    let waist = b.vary(0.85, 1.0);
    let profile = [
        (r, 0.0),
        (r * waist, body * 0.9),
        (r * waist * 0.85, body),
        (r * waist * 0.85 - t, body),
        (r * waist - t, body * 0.9),
        (r - t, t),
        (0.0, t),
    ];
    b.lathe("body", [0.0, cy, 0.0], &profile, mat);
    let tip = [0.0, y - h * 0.07, h - h * 0.1];
    let spout = limb([0.0, cy + r * 0.8, body * 0.25], tip, r * 0.2, r * 0.1);
    b.hull("spout", &spout, mat);
    let rose = h * 0.06;
    b.hull(
        "rose",
        &limb(
            [0.0, tip[1] - rose * 0.3, tip[2] - rose * 0.25],
            [0.0, y - rose, h - rose * 0.95],
            rose * 0.3,
            rose * 0.95,
        ),
        b.style.metal,
    );
    let thin = (r * 0.1).clamp(0.004, 0.012);
    let (back, top) = (cy - r * waist * 0.8, h - thin * 1.3);
    if b.rng.chance(0.5) {
        let outer = (-y + thin * 1.6).min(cy - r);
        b.pipe(
            "handle",
            &[
                [0.0, cy + r * 0.5, body * 0.97],
                [0.0, cy + r * 0.2, top],
                [0.0, back, top],
                [0.0, outer, body * 0.75],
                [0.0, cy - r * 0.96, body * 0.3],
            ],
            thin,
            mat,
        );
    } else {
        b.pipe(
            "handle",
            &[
                [0.0, cy + r * 0.75, body * 0.95],
                [0.0, cy + r * 0.4, top],
                [0.0, cy - r * 0.4, top],
                [0.0, back, body * 0.95],
            ],
            thin,
            mat,
        );
        let low = body * 0.3;
        let outer = (-y + thin * 1.6).max(cy - r * 1.6).min(cy - r * 0.99);
        b.pipe(
            "handle",
            &[
                [0.0, cy - r * 0.93, body * 0.75],
                [0.0, outer, body * 0.65],
                [0.0, outer, low + 0.03],
                [0.0, cy - r * 0.96, low],
            ],
            thin,
            mat,
        );
    }
    let strut = (cy + r * waist * 0.8, body * 0.98);
    b.rod(
        "strut",
        [0.0, strut.0, strut.1 - 0.01],
        [0.0, f32::midpoint(strut.0, tip[1]), f32::midpoint(body * 0.25, tip[2])],
        thin * 0.5,
        mat,
    );
}

/// A coiled hose with its nozzle.
pub(super) fn garden_hose(b: &mut Build<'_>) {
    at_least(b, [0.17, 0.17, 0.06]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let mat = b.choose(&[GREEN_PLASTIC, YELLOW_PLASTIC, ORANGE_PLASTIC, BLUE_PLASTIC, BLACK_PLASTIC, GREY_PLASTIC]);
    let rings = b.rng.count(1, 2);
    let layers = if rings == 1 { b.rng.count(4, 6) } else { b.rng.count(3, 4) };
    let tube = (h * 0.97 / (2.0 * layers as f32)).min(0.016);
    for layer in 0..layers {
        for ring in 0..rings {
            let out = r - tube * (1.0 + 2.1 * ring as f32) - b.vary(0.0, 0.5) * tube;
            let (dx, dy) = polar(b.vary(0.0, TAU), tube * 0.3);
            let out = (out - tube * 0.3).max(tube * 2.0);
            b.lathe("hose", [dx, dy, layer as f32 * tube * 1.96], &coil(out, tube), mat);
        }
    }
    let z = tube * 1.96 * layers as f32 - tube;
    let out = r - 3.0 * tube;
    let start = b.vary(-0.6, 0.6);
    let at = |a: f32, d: f32| {
        let (px, py) = polar(start + a, d);
        [px, py, z.min(h - tube)]
    };
    b.bar("hose", at(0.4, out), at(0.0, out * 0.4), tube, mat);
    b.hull("nozzle", &limb(at(0.0, out * 0.42), at(2.6, out * 0.35), tube * 1.2, tube * 1.5), b.style.metal);
    let tip = at(2.6, out * 0.33);
    b.hull("nozzle", &limb(tip, [tip[0] * 1.4, tip[1] * 1.4, tip[2]], tube * 1.4, tube * 0.7), ORANGE_PLASTIC);
    if z + 2.0 * tube < h {
        b.pipe("hose", &[at(3.4, out), [0.0, 0.0, h - tube * 1.2], at(5.6, out)], tube, mat);
    }
}

/// The profile of a ring of hose, with fewer corners than that of a hoop.
fn coil(radius: f32, section: f32) -> Vec<(f32, f32)> {
    let corners = (0..=7).map(|i| polar(TAU * (i % 7) as f32 / 7.0, section));
    corners.map(|(r, z)| ((radius + r).max(0.0), z + section)).collect()
}

/// A hose on a reel: a frame, a drum with hose, a crank; tall ones have wheels.
pub(super) fn hose_reel(b: &mut Build<'_>) {
    at_least(b, [0.17, 0.2, 0.22]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (frame, hose) = (
        b.choose(&[GREY_PLASTIC, ANTHRACITE, GREEN_METAL, GALVANISED]),
        b.choose(&[GREEN_PLASTIC, YELLOW_PLASTIC, ORANGE_PLASTIC, BLUE_PLASTIC]),
    );
    let r = (x * 0.88).min(h * 0.36);
    let axle = (r + 0.04).max(h * 0.36);
    let inner = y - 0.06;
    b.hinge([0.0, 0.0, axle], [0.0, 1.0, 0.0], TAU * 8.0, |b| {
        for side in [-1.0, 1.0] {
            b.rod("flange", [0.0, side * (inner - 0.03), axle], [0.0, side * (inner - 0.016), axle], r, frame);
        }
        b.rod("drum", [0.0, -inner + 0.02, axle], [0.0, inner - 0.02, axle], r * 0.5, frame);
        let coils = b.rng.count(5, 9);
        let step = (2.0 * inner - 0.07) / coils as f32;
        let full = r * b.vary(0.7, 0.9);
        for cy in spaced(coils, -inner + 0.035 + step / 2.0, inner - 0.035 - step / 2.0) {
            b.rod("hose", [0.0, cy - step * 0.47, axle], [0.0, cy + step * 0.47, axle], full, hose);
        }
        b.rod("axle", [0.0, -y + 0.034, axle], [0.0, inner + 0.018, axle], 0.012, frame);
        b.rod("crank", [0.0, -y + 0.034, axle], [r * 0.55, -y + 0.034, axle], 0.009, frame);
        b.rod("crank", [r * 0.55, -y + 0.044, axle], [r * 0.55, -y, axle], 0.012, BLACK_PLASTIC);
    });
    let tube = 0.011;
    for side in [-1.0, 1.0] {
        let cy = side * (inner + 0.002);
        // The axle turns in a ring at which the tubes end.
        let ring = [(0.022, -0.012), (0.022, 0.012), (0.0125, 0.012), (0.0125, -0.012), (0.022, -0.012)];
        b.lathe_along("bearing", [0.0, cy, axle], [0.0, cy + 1.0, axle], &ring, frame);
        for (fx, fz) in [(-x + tube, tube), (x - tube, tube), (-x * 0.75, h - tube)] {
            let short = 0.02 / fx.hypotenuse(fz - axle).max(0.04);
            b.rod("frame", [fx, cy, fz], [fx * short, cy, axle + (fz - axle) * short], tube, frame);
        }
    }
    b.rod("handle", [-x * 0.75, -inner, h - tube], [-x * 0.75, inner, h - tube], tube, frame);
    for foot in [-x + tube, x - tube] {
        b.rod("foot", [foot, -inner - 0.02, tube], [foot, inner + 0.02, tube], tube, frame);
    }
}

/// A lawn sprinkler: spinning arms, an oscillating bar, or a spike with a head.
pub(super) fn sprinkler(b: &mut Build<'_>) {
    at_least(b, [0.06, 0.07, 0.035]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, second) = (
        b.choose(&[GREEN_PLASTIC, YELLOW_PLASTIC, ORANGE_PLASTIC, BLUE_PLASTIC]),
        b.choose(&[BLACK_PLASTIC, GREY_PLASTIC, BRASS]),
    );
    if y > 0.14 {
        let (bow, end) = ((h * 0.09).max(0.005), y - 0.0125);
        for side in [-1.0, 1.0] {
            b.block("foot", [-x, side * end - 0.012, 0.0], [x, side * end + 0.012, 0.02_f32.min(h * 0.3)], second);
            b.block("post", [-0.012, side * end - 0.011, 0.005], [0.012, side * end + 0.011, h * 0.55], second);
        }
        b.block("rail", [-0.01, -end, 0.004], [0.01, end, 0.016_f32.min(h * 0.25)], second);
        let points: Vec<P> = spaced(7, -1.0, 1.0)
            .map(|s| [0.0, s * (end - 0.008 - bow), h * 0.5 + (h * 0.48 - 2.0 * bow) * (1.0 - s * s)])
            .collect();
        b.jointed(vc_graph::asset::JointKind::Hinge, [0.0, 0.0, h * 0.5], [0.0, 1.0, 0.0], (-1.0, 1.0), |b| {
            b.pipe("bow", &points, bow, mat)
        });
        b.rod("coupling", [0.0, end, h * 0.3], [x * 0.6, end, h * 0.3], (bow * 1.6).min(0.0105), ORANGE_PLASTIC);
    } else {
        let r = x.min(y);
        b.lathe("base", [0.0; 3], &[(r, 0.0), (r, h * 0.08), (r * 0.35, h * 0.2), (r * 0.2, h * 0.7)], second);
        let arms = b.rng.count(2, 4);
        b.jointed(vc_graph::asset::JointKind::Hinge, [0.0; 3], [0.0, 0.0, 1.0], (-1e4, 1e4), |b| {
            b.lathe("head", [0.0, 0.0, h * 0.68], &[(r * 0.28, 0.0), (r * 0.28, h * 0.18), (r * 0.12, h * 0.32)], mat);
            for i in 0..arms {
                let (px, py) = polar(TAU * i as f32 / arms as f32, r * 0.9);
                b.rod("arm", [0.0, 0.0, h * 0.78], [px, py, h * 0.84], r * 0.08, mat);
            }
        });
    }
}
