//! Roofs on posts, awnings and clotheslines.

use std::f32::consts::PI;

use super::shed::House;
use crate::material::*;
use crate::solid::{Axis, Build, CORNERS, at_least, spaced};

/// A carport: posts, beams and a flat, sloping or gabled roof over paved ground.
pub(super) fn carport(b: &mut Build<'_>) {
    at_least(b, [2.4, 1.4, 1.1]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = b.choose(&[PINE, OAK, GREY_OAK, ANTHRACITE, WHITE_METAL, GALVANISED]);
    let roof = b.choose(&[ROOF_TILE, ANTHRACITE, ASPHALT, CLEAR_PLASTIC, GALVANISED]);
    let post = b.vary(0.05, 0.08);
    let design = b.rng.below(3);
    let eaves = h - 0.1 - if design == 0 { 0.0 } else { h * 0.12 };
    b.block("ground", [-x + 0.1, -y + 0.1, 0.0], [x - 0.1, y - 0.1, 0.02], GRAVEL);
    let count = b.rng.count(2, 4);
    for cx in spaced(count, -x + 0.2, x - 0.2) {
        for side in [-1.0, 1.0] {
            let cy = side * (y - 0.16);
            b.block("post", [cx - post, cy - post, 0.0], [cx + post, cy + post, eaves + 0.01], mat);
            if b.rng.chance(0.6) {
                let brace = [(cx, eaves - 0.5), (cx + 0.06, eaves - 0.5), (cx + 0.56, eaves), (cx + 0.5, eaves)];
                if cx + 0.56 < x - 0.2 {
                    b.prism("brace", Axis::Y, [0.0, cy - 0.03, 0.0], &brace, 0.06, mat);
                }
            }
        }
    }
    for side in [-1.0, 1.0] {
        let cy = side * (y - 0.16);
        b.block("beam", [-x + 0.03, cy - 0.05, eaves], [x - 0.03, cy + 0.05, eaves + 0.08], mat);
    }
    let rafters = ((2.0 * x / 0.9) as usize).clamp(3, 8);
    match design {
        0 => b.block("roof", [-x, -y, eaves + 0.06], [x, y, h], roof),
        1 => {
            let fall = h - eaves - 0.1;
            let slope = [(-y, eaves + 0.07), (y, eaves + 0.07 + fall), (y, h), (-y, eaves + 0.1)];
            b.prism("roof", Axis::X, [-x, 0.0, 0.0], &slope, 2.0 * x, roof);
            b.block("beam", [-x + 0.03, y - 0.21, eaves + 0.07], [x - 0.03, y - 0.11, eaves + 0.02 + fall], mat);
        }
        _ => {
            let house = House { x, y: y - 0.11, low: 0.0, eaves: eaves + 0.06, ridge: h - 0.04, t: 0.0 };
            house.roof(b, (x, y, h), roof);
        }
    }
    for cx in spaced(rafters, -x + 0.15, x - 0.15) {
        b.block("rafter", [cx - 0.03, -y + 0.12, eaves + 0.02], [cx + 0.03, y - 0.12, eaves + 0.075], mat);
    }
    b.inside("compartment", [0.0, 0.0, 0.02], (x - 0.3, y - 0.3), eaves - 0.06);
}

/// A gazebo: posts under a tent or a hipped roof.
pub(super) fn gazebo(b: &mut Build<'_>) {
    at_least(b, [1.2, 1.2, 1.1]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let cloth = b.rng.chance(0.4);
    let mat = b.one_of(if cloth { &[WHITE_METAL, ANTHRACITE, GALVANISED] } else { &[PINE, OAK, TEAK, WHITE] });
    let roof = b.one_of(if cloth {
        &[WHITE_COTTON, GREEN_FABRIC, BEIGE_FABRIC, NAVY_FABRIC]
    } else {
        &[ROOF_TILE, ASPHALT, PINE, ANTHRACITE]
    });
    let open = !cloth && b.rng.chance(0.35);
    let eaves = h * if open { b.vary(0.88, 0.92) } else { b.vary(0.68, 0.78) };
    let post = if cloth { 0.025 } else { b.vary(0.045, 0.07) };
    for (sx, sy) in CORNERS {
        let (cx, cy) = (sx * (x - 0.12), sy * (y - 0.12));
        b.block("post", [cx - post, cy - post, 0.0], [cx + post, cy + post, eaves + 0.01], mat);
        b.block("foot", [cx - post - 0.02, cy - post - 0.02, 0.0], [cx + post + 0.02, cy + post + 0.02, 0.03], mat);
    }
    let beam = if open { h - 0.085 } else { eaves + 0.1_f32.min(h - eaves - 0.06) };
    for side in [-1.0, 1.0] {
        b.block("beam", [-x + 0.05, side * (y - 0.12) - 0.04, eaves], [x - 0.05, side * (y - 0.12) + 0.04, beam], mat);
    }
    if open {
        // A pergola: rafters across the beams.
        for cx in spaced(b.rng.count(6, 11), -x + 0.04, x - 0.04) {
            b.block("rafter", [cx - 0.025, -y, h - 0.09], [cx + 0.025, y, h], mat);
        }
        return;
    }
    for side in [-1.0, 1.0] {
        b.block(
            "beam",
            [side * (x - 0.12) - 0.035, -y + 0.06, eaves + 0.002],
            [side * (x - 0.12) + 0.035, y - 0.06, eaves + 0.07],
            mat,
        );
    }
    let knob = h * 0.03;
    b.taper("roof", [0.0, 0.0, eaves + 0.04], (x, y), (x * 0.12, y * 0.12), h - eaves - 0.04 - knob, roof);
    b.taper("roof", [0.0, 0.0, h - knob - 0.01], (x * 0.14, y * 0.14), (0.01, 0.01), knob + 0.01, roof);
    if cloth {
        for side in [-1.0, 1.0] {
            b.block(
                "valance",
                [side * (x - 0.004) - 0.003, -y, eaves - 0.12],
                [side * (x - 0.004) + 0.003, y, eaves + 0.045],
                roof,
            );
            b.block(
                "valance",
                [-x + 0.008, side * (y - 0.004) - 0.003, eaves - 0.12],
                [x - 0.008, side * (y - 0.004) + 0.003, eaves + 0.045],
                roof,
            );
        }
    }
}

/// An awning: a roller at the wall, with cloth on folding arms over the full depth.
pub(super) fn awning(b: &mut Build<'_>) {
    at_least(b, [0.1, 1.0, 0.07]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let cloth = b.choose(&[RED_FABRIC, BEIGE_FABRIC, NAVY_FABRIC, GREEN_FABRIC, MUSTARD_FABRIC, GREY_FABRIC]);
    let second = b.choose(&[WHITE_COTTON, cloth, WHITE_COTTON, BEIGE_FABRIC]);
    let (case, deep) = (b.choose(&[WHITE_METAL, ANTHRACITE, SILVER_METAL]), 0.16_f32.min(2.0 * x * 0.8));
    let box_z = h - deep.min(h * 0.7);
    b.rounded_block("case", [-x, -y, box_z], [-x + deep, y, h], 0.03, case);
    let (from, low) = (-x + deep, 0.0);
    let reach = 2.0 * x - deep;
    if reach < 0.25 {
        b.slide([1.0, 0.0, 0.0], 0.02, |b| {
            b.rounded_block(
                "bar",
                [from - 0.01, -y + 0.02, box_z + 0.01],
                [x, y - 0.02, box_z + 0.06_f32.min(h - box_z - 0.01)],
                0.01,
                case,
            )
        });
        return;
    }
    let stripes = b.rng.count(6, 12);
    let (z0, z1) = (box_z + 0.04, low + 0.09_f32.min(h * 0.3));
    let half = (y - 0.03) / stripes as f32;
    for (i, cy) in spaced(stripes, -y + 0.03 + half, y - 0.03 - half).enumerate() {
        let mat = if i % 2 == 0 { cloth } else { second };
        b.prism(
            "cloth",
            Axis::Y,
            [0.0, cy - half, 0.0],
            &[(from - 0.02, z0), (from - 0.02, z0 + 0.006), (x - 0.02, z1 + 0.006), (x - 0.02, z1)],
            2.0 * half - 0.001,
            mat,
        );
    }
    b.slide([1.0, 0.0, 0.0], 0.01, |b| {
        b.block("bar", [x - 0.05, -y + 0.01, z1 - 0.01], [x - 0.011, y - 0.01, z1 + 0.025], case);
        for (i, cy) in spaced(stripes, -y + 0.03 + half, y - 0.03 - half).enumerate() {
            let mat = if i % 2 == 0 { cloth } else { second };
            b.block("valance", [x - 0.012, cy - half, low], [x - 0.006, cy + half - 0.001, z1 + 0.02], mat);
        }
    });
    for side in [-1.0, 1.0] {
        let (root, elbow, tip) = (
            [from - 0.01, side * y * 0.85, box_z + 0.015],
            [(from + x) / 2.0, side * y * 0.45, f32::midpoint(box_z, z1)],
            [x - 0.063, side * y * 0.85, z1],
        );
        b.pipe("arm", &[root, elbow, tip], 0.015, case);
    }
}

/// A clothesline: a rotary dryer, or lines between two posts.
pub(super) fn clothesline(b: &mut Build<'_>) {
    at_least(b, [0.8, 0.8, 0.8]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let metal = b.choose(&[ALUMINIUM, GALVANISED, GREEN_METAL, PINE]);
    let cord = b.choose(&[WHITE_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC]);
    let thin = 0.004;
    if b.rng.chance(0.6) {
        b.lathe("pole", [0.0; 3], &[(0.035, 0.0), (0.035, 0.2), (0.024, 0.22), (0.024, h)], metal);
        let level = h - 0.05;
        let corners: Vec<(f32, f32)> =
            [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)].map(|(a, c)| (a * (x - 0.02), c * (y - 0.02))).to_vec();
        b.jointed(vc_graph::asset::JointKind::Hinge, [0.0; 3], [0.0, 0.0, 1.0], (-PI, PI), |b| {
            for &(cx, cy) in &corners {
                // They end at the pole, around which they rotate.
                let share = 0.031 / (cx.abs() + cy.abs());
                b.rod("arm", [cx * share, cy * share, h * 0.7], [cx, cy, level], 0.012, metal);
                b.rod(
                    "brace",
                    [cx * share * 0.87, cy * share * 0.87, level],
                    [cx * 0.5, cy * 0.5, h * 0.7 + (level - h * 0.7) * 0.49],
                    0.008,
                    metal,
                );
            }
            for (i, share) in [0.35, 0.55, 0.75, 0.97].into_iter().enumerate() {
                let z = h * 0.7 + (level - h * 0.7) * share;
                for k in 0..4 {
                    let ((x0, y0), (x1, y1)) = (corners[k], corners[(k + 1) % 4]);
                    b.rod("line", [x0 * share, y0 * share, z], [x1 * share, y1 * share, z], thin, cord);
                }
                b.hook(&format!("rod_{}", i + 1), [x * share * 0.5, y * share * 0.5, z], z - 0.1);
            }
            let z = level - (level - h * 0.7) * 0.03 + thin;
            b.inside("line", [-x * 0.47, y * 0.47, z], (0.06, 0.06), 0.2);
        });
    } else {
        for side in [-1.0, 1.0] {
            let cy = side * (y - 0.04);
            b.cylinder("post", [0.0, cy, 0.0], 0.035, h - 0.03, metal);
            b.rod("arm", [-x, cy, h - 0.05], [x, cy, h - 0.05], 0.022, metal);
        }
        let top = h - 0.05 + 0.02;
        for (i, cx) in spaced(4, -x + 0.05, x - 0.05).enumerate() {
            b.rod("line", [cx, -y + 0.04, top], [cx, y - 0.04, top], thin, cord);
            b.hook(&format!("rod_{}", i + 1), [cx, 0.0, top], top - 0.1);
        }
        b.inside("line", [-x + 0.05, 0.0, top + thin], (0.04, y * 0.5), 0.2);
        let cx = (x - 0.05) / 3.0;
        b.jointed(vc_graph::asset::JointKind::Hinge, [cx, 0.0, top], [0.0, 1.0, 0.0], (-0.5, 0.5), |b| {
            let bag = [(cx - 0.008, top), (cx + 0.008, top), (cx + 0.03, top - 0.18), (cx - 0.03, top - 0.18)];
            let bag = bag.map(|p| (p.0, p.1 - thin));
            b.prism("peg_bag", Axis::Y, [0.0, -y + 0.12, 0.0], &bag, 0.2, JUTE);
        });
    }
}
