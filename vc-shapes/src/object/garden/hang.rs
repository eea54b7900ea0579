//! Garden furniture that hangs: hammocks, swings and chairs.

use std::f32::consts::{PI, TAU};

use vc_graph::portable::Portable;

use super::seat::{CLOTHS, METALS};
use crate::material::*;
use crate::solid::{Axis, Build, P, at_least, limb, spaced};

/// A hammock between the hooks of a stand, or lying with its spreader bars.
pub(super) fn hammock(b: &mut Build<'_>) {
    at_least(b, [0.9, 0.38, 0.14]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (cloth, second) = (b.one_of(CLOTHS), b.one_of(CLOTHS));
    let wood = b.choose(&[PINE, TEAK, OAK, IRON]);
    let beam = (h * 0.08).clamp(0.015, 0.04);
    let (hook, tip) = (h - beam, x - beam * 1.2);
    // A stand: two feet, a bowed beam in segments.
    for s in [-1.0, 1.0] {
        b.block("foot", [s * x * 0.55 - beam, -y * 0.8, 0.0], [s * x * 0.55 + beam, y * 0.8, 1.6 * beam], wood);
        let post = limb([s * x * 0.5, 0.0, beam * 1.3], [s * tip, 0.0, hook], beam * 1.1, beam * 0.9);
        let keep = |p: P| [p[0].max(-x).min(x), p[1], p[2].max(0.0).min(h)];
        b.hull("post", &post.into_iter().map(keep).collect::<Vec<P>>(), wood);
    }
    b.block("beam", [-x * 0.55, -beam * 0.9, 0.004], [x * 0.55, beam * 0.9, 1.5 * beam], wood);
    let (end, sag) = (x * 0.68, h * 0.38);
    let rim = h * 0.82;
    let steps = 9;
    let z = |t: f32| rim - sag * (1.0 - t * t);
    let strips = 6;
    let half = y * 0.92 / strips as f32;
    for (i, cy) in spaced(strips, -y * 0.92 + half, y * 0.92 - half).enumerate() {
        let dip = 0.12 * sag * (1.0 - (cy / y).raised(2));
        let upper: Vec<(f32, f32)> = spaced(steps, -1.0, 1.0).map(|t| (end * t, z(t) - dip * (1.0 - t * t))).collect();
        let outline: Vec<(f32, f32)> =
            upper.iter().copied().chain(upper.iter().rev().map(|p| (p.0, p.1 - 0.012))).collect();
        b.prism(
            "bed",
            Axis::Y,
            [0.0, cy - half, 0.0],
            &outline,
            2.0 * half - 0.0004,
            if i % 2 == 0 { cloth } else { second },
        );
    }
    for s in [-1.0, 1.0] {
        b.rod("bar", [s * end, -y, rim - 0.012], [s * end, y, rim - 0.012], 0.012, wood);
        for cy in spaced(5, -y * 0.9, y * 0.9) {
            b.rod("cord", [s * end, cy, rim - 0.012], [s * (tip - beam * 0.3), 0.0, hook - beam * 0.5], 0.004, WOOL);
        }
    }
}

/// A swing seat under a canopy on a standing frame.
pub(super) fn porch_swing(b: &mut Build<'_>) {
    at_least(b, [0.55, 0.8, 0.75]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (metal, cloth) = (b.one_of(METALS), b.one_of(CLOTHS));
    let r = 0.022;
    let top = h - 0.14;
    for s in [-1.0, 1.0] {
        let cy = s * (y - 0.04);
        b.rod("foot", [-x, cy, r], [x, cy, r], r, metal);
        for fx in [-x * 0.9, x * 0.9] {
            b.rod("post", [fx, cy, r], [fx * 0.03, cy, top], r, metal);
        }
    }
    b.rod("beam", [0.0, -y + 0.02, top], [0.0, y - 0.02, top], r * 1.1, metal);
    b.taper("canopy", [0.0, 0.0, h - 0.1], (x * 0.97, y), (x * 0.4, y * 0.96), 0.1, cloth);
    for s in [-1.0, 1.0] {
        b.block("valance", [s * (x * 0.965) - 0.004, -y, h - 0.2], [s * (x * 0.965) + 0.004, y, h - 0.096], cloth);
        b.rod("bracket", [0.0, s * y * 0.9, top], [s * x * 0.9, s * y * 0.9, h - 0.11], 0.01, metal);
        b.rod("bracket", [0.0, s * y * 0.9, top], [-s * x * 0.9, s * y * 0.9, h - 0.11], 0.01, metal);
    }
    let (seat, half, deep) = ((h * 0.3).min(0.5), y - 0.14, x * 0.42);
    let pad = 0.08_f32.min(h * 0.06);
    b.jointed(vc_graph::asset::JointKind::Hinge, [0.0, 0.0, top], [0.0, 1.0, 0.0], (-0.12, 0.12), |b| {
        b.block("seat", [-deep, -half, seat - pad - 0.03], [deep, half, seat - pad], metal);
        b.rounded_block(
            "cushion",
            [-deep + 0.01, -half + 0.01, seat - pad + 0.001],
            [deep, half - 0.01, seat],
            0.03,
            cloth,
        );
        let lean = deep * 0.5;
        let outline = [
            (-deep, seat - pad),
            (-deep + 0.09, seat),
            (-deep - lean + 0.08, seat + h * 0.27),
            (-deep - lean, seat + h * 0.27),
        ];
        b.prism("back", Axis::Y, [0.0, -half, 0.0], &outline, 2.0 * half, cloth);
        for s in [-1.0, 1.0] {
            let cy = s * (half - 0.012);
            b.rod("arm", [-deep - lean * 0.3, cy, seat + 0.2], [deep, cy, seat + 0.2], 0.014, metal);
            b.rod("arm", [deep, cy, seat - pad - 0.015], [deep, cy, seat + 0.205], 0.014, metal);
            b.rod("chain", [deep * 0.9, cy, seat + 0.2], [0.0, cy, top - r], 0.006, STEEL);
            b.rod("chain", [-deep - lean * 0.3, cy, seat + 0.2], [0.0, cy, top - r], 0.006, STEEL);
        }
        b.ledge("seat", [deep * 0.35, 0.0, seat], (deep * 0.5, half - 0.06), h * 0.35);
    });
}

/// An egg-shaped chair of bars hanging from a bowed stand.
pub(super) fn hanging_chair(b: &mut Build<'_>) {
    at_least(b, [0.45, 0.45, 0.85]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let r = x.min(y);
    let (metal, wicker, cloth) =
        (b.one_of(METALS), b.choose(&[WICKER, GREY_PLASTIC, WHITE_PLASTIC, ANTHRACITE]), b.one_of(CLOTHS));
    let tube = 0.025;
    b.lathe("foot", [0.0; 3], &[(r, 0.0), (r, 0.03), (r - 0.06, 0.03), (r - 0.06, 0.0), (r, 0.0)], metal);
    b.block("foot", [-r + 0.02, -0.03, 0.002], [r - 0.02, 0.03, 0.026], metal);
    let spine = -r + tube;
    let stand: Vec<P> = (0..=6)
        .map(|i| PI * 0.5 * i as f32 / 6.0)
        .map(|a| [spine * a.cosine().max(0.0).power(0.6), 0.0, h * 0.6 + (h * 0.4 - tube * 1.1) * a.sine()])
        .collect();
    b.pipe("stand", &[[spine, 0.0, 0.03], [spine, 0.0, h * 0.6]], tube, metal);
    b.pipe("stand", &stand, tube, metal);
    let (low, high) = (h * 0.2, h * 0.9);
    let (middle, half) = ((low + high) / 2.0, (high - low) / 2.0);
    let (wide, cx) = (r * 0.86, (r * 0.86 - r + 3.0 * tube).max(0.0) * 0.6);
    b.rod("chain", [0.0, 0.0, h - tube * 2.0], [cx.max(spine + 2.2 * tube), 0.0, high], 0.008, STEEL);
    // Meridians around the back and the sides, open in front.
    let egg = |a: f32, t: f32| {
        let s = (PI * t).sine();
        [
            (cx + wide * 0.8 * s * a.cosine()).max(spine + 2.2 * tube),
            wide * s * a.sine(),
            middle + half * (PI * t).cosine(),
        ]
    };
    for i in 0..9 {
        let a = 1.0 + (TAU - 2.0) * i as f32 / 8.0;
        let points: Vec<P> = (0..=7).map(|k| egg(a, k as f32 / 7.0)).collect();
        for pair in points.windows(2) {
            b.rod("weave", pair[0], pair[1], if i == 0 || i == 8 { 0.014 } else { 0.007 }, wicker);
        }
    }
    for t in [0.3, 0.45, 0.6, 0.75] {
        let ring: Vec<P> = (0..=10).map(|k| egg(1.0 + (TAU - 2.0) * k as f32 / 10.0, t)).collect();
        for pair in ring.windows(2) {
            b.rod("weave", pair[0], pair[1], 0.007, wicker);
        }
    }
    let seat = low + half * 0.62;
    let deep = wide * 0.62;
    b.lathe(
        "cushion",
        [cx, 0.0, seat - half * 0.34],
        &[(deep * 0.6, 0.0), (deep, half * 0.2), (deep, half * 0.3), (deep * 0.9, half * 0.34)],
        cloth,
    );
    b.rod("post", [cx, 0.0, low - 0.004], [cx, 0.0, seat - half * 0.3], 0.02, wicker);
    b.rounded_block(
        "cushion",
        [cx - wide * 0.72, -wide * 0.4, seat - 0.02],
        [cx - wide * 0.45, wide * 0.4, seat + half * 0.75],
        0.05,
        cloth,
    );
    b.ledge("seat", [cx + wide * 0.1, 0.0, seat], (wide * 0.3, wide * 0.3), half * 0.6);
}
