//! Bus shelters, bicycle racks and phone booths.

use super::sign::poster;
use crate::material::*;
use crate::solid::{Axis, Build, CORNERS, P, at_least, polygon, spaced};
use std::f32::consts::{FRAC_PI_2, PI};
use vc_graph::portable::Portable;

/// A bus shelter: glass walls, a roof, a bench, a poster and the stop's sign.
pub(super) fn bus_stop(b: &mut Build<'_>) {
    at_least(b, [0.6, 1.25, 1.15]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let metal = b.choose(&[ANTHRACITE, GALVANISED, GREEN_METAL, SILVER_METAL]);
    let (roof, post) = (b.vary(0.06, 0.14), 0.035);
    let under = h - roof;
    if b.rng.chance(0.5) {
        b.block("roof", [-x, -y, under], [x, y, h], metal);
    } else {
        let arc: Vec<(f32, f32)> = (0..=8)
            .map(|i| PI * i as f32 / 8.0)
            .map(|a| (x * a.cosine(), roof * (0.3 + 0.7 * a.sine())))
            .chain([(-x, 0.0), (x, 0.0)])
            .collect();
        b.prism("roof", Axis::Y, [0.0, -y, under], &arc, 2.0 * y, metal);
    }
    let (back, depth) = (-x + 0.12, x * b.vary(0.1, 0.6));
    let bays = ((2.0 * y / 1.3) as usize).clamp(2, 4);
    for cy in spaced(bays + 1, -y + 0.1, y - 0.1) {
        b.block("post", [back - post, cy - post, 0.0], [back + post, cy + post, under], metal);
    }
    let step = (2.0 * y - 0.2) / bays as f32;
    for cy in spaced(bays, -y + 0.1 + step / 2.0, y - 0.1 - step / 2.0) {
        b.block(
            "glass",
            [back - 0.006, cy - step / 2.0 + post, 0.15],
            [back + 0.006, cy + step / 2.0 - post, under - 0.1],
            GLASS,
        );
    }
    let poster_side = if b.rng.chance(0.5) { 1.0 } else { -1.0 };
    for side in [-1.0, 1.0] {
        let cy = side * (y - 0.1);
        b.block("post", [depth - post, cy - post, 0.0], [depth + post, cy + post, under], metal);
        let thick = if side == poster_side { 0.05 } else { 0.006 };
        let mat = if side == poster_side { metal } else { GLASS };
        b.block("side", [back + post, cy - thick, 0.15], [depth - post, cy + thick, under - 0.15], mat);
    }
    let wide = (depth - back) / 2.0 - 0.15;
    b.at([(back + depth) / 2.0, poster_side * (y - 0.15), under * 0.5], -poster_side * FRAC_PI_2, |b| {
        poster(b, [0.0; 3], (wide.max(0.1), under * 0.38), 0.02);
    });
    let (seat, reach) = (0.45, y * b.vary(0.35, 0.6));
    let wood = b.choose(&[b.style.wood, STEEL, GALVANISED, TEAK]);
    b.rounded_block(
        "seat",
        [back + post - 0.004, -reach, seat - 0.04],
        [back + 0.45_f32.min(x * 0.7), reach, seat],
        0.01,
        wood,
    );
    for cy in [-reach * 0.8, reach * 0.8] {
        b.block(
            "leg",
            [back + 0.2_f32.min(x * 0.4), cy - 0.03, 0.0],
            [back + 0.27_f32.min(x * 0.5), cy + 0.03, seat - 0.035],
            metal,
        );
    }
    let room = under - seat - 0.02;
    b.ledge("seat", [back + 0.04 + 0.225_f32.min(x * 0.35), 0.0, seat], (0.15_f32.min(x * 0.2), reach * 0.95), room);
    let cy = -poster_side * (y - 0.04);
    b.cylinder("pole", [x - 0.06, cy, 0.0], 0.025, under + 0.01, GALVANISED);
    b.prism(
        "sign",
        Axis::X,
        [x - 0.045, cy - cy.signum() * 0.16, under - 0.3],
        &polygon(20, 0.16, 0.0),
        0.01,
        b.style.metal,
    );
    b.prism("sign", Axis::X, [x - 0.038, cy - cy.signum() * 0.16, under - 0.3], &polygon(20, 0.13, 0.0), 0.005, YELLOW);
    b.block(
        "timetable",
        [x - 0.036, cy - 0.12_f32.min(0.03), 1.2_f32.min(under * 0.5)],
        [x - 0.03, cy + 0.03, 1.6_f32.min(under * 0.7)],
        WHITE_PAPER,
    );
}

/// A rack for bicycles: hoops, or slots for front wheels.
pub(super) fn bicycle_rack(b: &mut Build<'_>) {
    at_least(b, [0.17, 0.4, 0.12]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let metal = b.choose(&[GALVANISED, STEEL, ANTHRACITE, GREEN_METAL, IRON]);
    let r = (x * 0.08).clamp(0.008, 0.025);
    let count = ((2.0 * y / b.vary(0.45, 0.75)) as usize).clamp(2, 6);
    let hoops = h > 0.5 || b.rng.chance(0.4);
    for side in [-1.0, 1.0] {
        b.block("rail", [side * (x - r) - r, -y, 0.0], [side * (x - r) + r, y, 2.0 * r * 0.9], metal);
    }
    let gap = (2.0 * y - 2.0 * r) / (count - 1) as f32;
    let slim = if hoops { 0.0 } else { (gap * 0.12).min(0.03) };
    let round = b.rng.chance(0.5);
    for cy in spaced(count, -y + r + slim, y - r - slim) {
        let offsets: &[f32] = if hoops { &[0.0] } else { &[-1.0, 1.0] };
        for side in offsets {
            let cy = cy + side * slim;
            let points: Vec<P> = if round {
                let arc = (0..=6).map(|i| PI * i as f32 / 6.0);
                arc.map(|a| [(x - 2.0 * r) * a.cosine(), cy, r + (h - 2.5 * r) * a.sine()]).collect()
            } else {
                let (e, t) = (x - 1.2 * r, h - 1.5 * r);
                let cut = (x * 0.35).min(h * 0.35);
                vec![[e, cy, r], [e, cy, t - cut], [e - cut, cy, t], [-e + cut, cy, t], [-e, cy, t - cut], [-e, cy, r]]
            };
            b.pipe("hoop", &points, r, metal);
        }
    }
    b.block("plate", [-x + 2.0 * r, -y + 0.02, 0.0], [x - 2.0 * r, y - 0.02, 0.006], metal);
    for (i, cy) in spaced(count - 1, -y + r + gap / 2.0, y - r - gap / 2.0).enumerate() {
        let half = gap / 2.0 - r - 2.0 * slim - 0.012;
        b.inside(&format!("rack_{}", i + 1), [0.0, cy, 0.006], (x - 2.0 * r - 0.01, half.max(0.02)), h);
    }
}

/// A phone booth: a kiosk of small panes with a crowned roof, or a plain glass one.
pub(super) fn phone_booth(b: &mut Build<'_>) {
    at_least(b, [0.42, 0.42, 1.1]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let classic = b.rng.chance(0.6);
    let mat = b.one_of(if classic {
        &[RED_METAL, RED_METAL, GREEN_METAL, BLACK_METAL]
    } else {
        &[SILVER_METAL, BLUE_METAL, ANTHRACITE, YELLOW_METAL]
    });
    let (roof, floor, w) = (h * b.vary(0.1, 0.15), 0.06, 0.035);
    let top = h - roof;
    b.block("floor", [-x, -y, 0.0], [x, y, floor], CONCRETE);
    for (sx, sy) in CORNERS {
        let (cx, cy) = (sx * (x - w - 0.012), sy * (y - w - 0.012));
        b.block("post", [cx - w, cy - w, floor], [cx + w, cy + w, top], mat);
    }
    let rows = if classic { b.rng.count(5, 8) } else { b.rng.count(0, 2) };
    let edge = y - 0.012 - 2.0 * w;
    let pane = |b: &mut Build<'_>, half: f32, low: f32| {
        b.block("glass", [-0.004, -half, low], [0.004, half, top - 0.02], GLASS);
        b.block("rail", [-0.018, -half, floor], [0.018, half, low], mat);
        b.block("rail", [-0.018, -half, top - 0.07], [0.018, half, top - 0.002], mat);
        for z in spaced(rows + 2, low, top - 0.07).skip(1).take(rows) {
            b.block("bar", [-0.011, -half, z - 0.01], [0.011, half, z + 0.01], mat);
        }
        if classic {
            for cy in [-half * 0.6, half * 0.6] {
                b.block("bar", [-0.009, cy - 0.009, low], [0.009, cy + 0.009, top - 0.05], mat);
            }
        }
    };
    let low = floor + (top - floor) * b.vary(0.06, 0.3);
    for side in [-1.0, 1.0] {
        b.at([0.0, side * (y - 0.012 - w), 0.0], FRAC_PI_2, |b| pane(b, x - 0.012 - 2.0 * w, low));
    }
    let solid = -x + 0.012 + w;
    b.block("back", [solid - 0.015, -edge, floor], [solid + 0.015, edge, top - 0.002], mat);
    let front = x - 0.012 - w;
    b.hinge([front + 0.02, edge, 0.0], [0.0, 0.0, 1.0], FRAC_PI_2, |b| {
        b.at([front, 0.0, 0.0], 0.0, |b| pane(b, edge - 0.004, low));
        b.rod("handle", [front + 0.033, -edge * 0.8, h * 0.4], [front + 0.033, -edge * 0.8, h * 0.5], 0.01, STEEL);
        b.block("plate", [front - 0.003, -edge * 0.85, h * 0.44], [front + 0.036, -edge * 0.75, h * 0.46], STEEL);
    });
    b.block("lintel", [-x, -y, top - 0.003], [x - 0.006, y, top + roof * 0.45], mat);
    b.block("sign", [x - 0.01, -edge, top + roof * 0.08], [x, edge, top + roof * 0.38], WHITE_PLASTIC);
    if classic {
        b.taper("roof", [0.0, 0.0, top + roof * 0.44], (x * 0.95, y * 0.95), (x * 0.6, y * 0.6), roof * 0.55, mat);
    } else {
        b.block("roof", [-x * 0.95, -y * 0.95, top + roof * 0.44], [x * 0.95, y * 0.95, h], mat);
    }
    let (face, z) = (solid + 0.014, h * 0.52);
    b.rounded_block("phone", [face, -0.12, z], [face + 0.1, 0.12, z + 0.32], 0.015, BLACK_PLASTIC);
    b.bar("handset", [face + 0.12, -0.16, z + 0.1], [face + 0.12, -0.16, z + 0.26], 0.025, BLACK_PLASTIC);
    b.block("cradle", [face + 0.05, -0.17, z + 0.16], [face + 0.12, -0.11, z + 0.2], BLACK_PLASTIC);
    let half = ((front - face - 0.2) / 2.0, edge - 0.03);
    b.inside("compartment", [face + 0.16 + half.0, 0.0, floor], half, top - floor - 0.02);
}
