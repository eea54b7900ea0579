//! Parasols and their bases.

use std::f32::consts::TAU;

use super::seat::CLOTHS;
use crate::material::*;
use crate::solid::{Build, P, at_least, mix, polygon};

/// A parasol on its pole: open, a cone of panels with a valance.
pub(super) fn parasol(b: &mut Build<'_>) {
    at_least(b, [0.8, 0.8, 1.0]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let (cloth, second) = (b.one_of(CLOTHS), b.one_of(CLOTHS));
    let second = if b.rng.chance(0.5) { cloth } else { second };
    let pole = b.choose(&[PINE, WHITE_METAL, ALUMINIUM, ANTHRACITE, TEAK]);
    let ribs = b.choose(&[6, 8, 8, 4]);
    let rise = r * b.vary(0.22, 0.4);
    let eaves = h - rise - 0.06;
    b.cylinder("foot", [0.0; 3], 0.2_f32.min(r * 0.3), 0.03, CONCRETE);
    b.cylinder("pole", [0.0, 0.0, 0.02], 0.02, h - 0.05, pole);
    let turn = if ribs == 4 { TAU / 8.0 } else { 0.0 };
    let reach = if ribs == 4 { r * 2.0_f32.sqrt() } else { r };
    let corners = polygon(ribs, reach, turn);
    let top: P = [0.0, 0.0, h - 0.06];
    for i in 0..ribs {
        let ((x0, y0), (x1, y1)) = (corners[i], corners[(i + 1) % ribs]);
        let mat = if i % 2 == 0 { cloth } else { second };
        let (a, c) = ([x0, y0, eaves], [x1, y1, eaves]);
        let within = |p: P| [p[0] * 0.997, p[1] * 0.997, p[2]];
        let rim = [top, within(a), within(c)];
        b.hull("panel", &rim.iter().flat_map(|&p| [p, [p[0], p[1], p[2] + 0.008]]).collect::<Vec<P>>(), mat);
        let drop = 0.12_f32.min(h * 0.06);
        let valance: Vec<P> = [a, c]
            .into_iter()
            .flat_map(|p| [[p[0], p[1], p[2] + 0.006], [p[0], p[1], p[2] - drop]])
            .flat_map(|p| [p, [p[0] * 0.994, p[1] * 0.994, p[2]]])
            .collect();
        b.hull("valance", &valance, mat);
        let rib = mix(top, a, 0.97);
        b.rod("rib", [0.0, 0.0, top[2] - 0.02], [rib[0], rib[1], rib[2] - 0.012], 0.006, pole);
        b.rod(
            "strut",
            [0.0, 0.0, eaves - r * 0.25],
            mix([0.0, 0.0, top[2] - 0.02], [rib[0], rib[1], rib[2] - 0.012], 0.5),
            0.005,
            pole,
        );
    }
    b.cylinder("runner", [0.0, 0.0, eaves - r * 0.25 - 0.04], 0.03, 0.08, pole);
    b.lathe("finial", [0.0, 0.0, h - 0.062], &[(0.05, 0.0), (0.03, 0.02), (0.015, 0.05), (0.0, 0.062)], pole);
    b.rod("crank", [0.02, 0.0, h * 0.5], [0.07, 0.0, h * 0.5], 0.012, BLACK_PLASTIC);
}

/// A parasol's base with its tube: a slab, a filled drum or a cross with stones.
pub(super) fn parasol_base(b: &mut Build<'_>) {
    at_least(b, [0.15, 0.15, 0.06]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let mat = b.choose(&[CONCRETE, GRANITE, BLACK_PLASTIC, IRON, WHITE_PLASTIC, GREEN_PLASTIC]);
    let low = (h * b.vary(0.2, 0.4)).min(0.12);
    match b.rng.below(3) {
        0 => b.lathe(
            "slab",
            [0.0; 3],
            &[(r, 0.0), (r, low * 0.7), (r * 0.9, low), (0.027, low), (0.027, low * 0.4), (0.0, low * 0.4)],
            mat,
        ),
        1 => {
            for (sx, sy) in [(1.0_f32, 1.0_f32), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)] {
                let (from, to) = (0.032, r);
                let (x0, x1) = ((sx * from).min(sx * to), (sx * from).max(sx * to));
                let (y0, y1) = ((sy * from).min(sy * to), (sy * from).max(sy * to));
                b.block("stone", [x0, y0, 0.004], [x1, y1, low], CONCRETE);
            }
            b.block("bar", [-r, -0.03, 0.0], [r, 0.03, 0.02_f32.min(low * 0.6)], IRON);
            b.block("bar", [-0.03, -r, 0.0], [0.03, r, 0.019_f32.min(low * 0.55)], IRON);
        }
        _ => b.lathe(
            "drum",
            [0.0; 3],
            &[(r * 0.95, 0.0), (r, low * 0.3), (r * 0.8, low), (0.027, low), (0.027, low * 0.4), (0.0, low * 0.4)],
            mat,
        ),
    }
    let floor = low * 0.5;
    b.lathe("tube", [0.0; 3], &[(0.03, 0.002), (0.03, h), (0.025, h), (0.025, floor), (0.0, floor)], b.style.metal);
    b.rod("screw", [0.028, 0.0, (low + h) / 2.0], [(r * 0.8).min(0.07), 0.0, (low + h) / 2.0], 0.008, BLACK_PLASTIC);
    b.inside("slot", [0.0, 0.0, floor], (0.016, 0.016), h);
}
