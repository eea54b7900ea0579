//! Inflatables and floats for swimmers.

use std::f32::consts::{FRAC_PI_2, PI, TAU};

use vc_graph::portable::Portable;

use super::BRIGHT;
use crate::material::*;
use crate::solid::{Build, P, at_least, limb, polar, polygon, spaced, torus_profile};

/// An air mattress: tubes side by side, a pillow at the head.
pub(super) fn pool_float(b: &mut Build<'_>) {
    at_least(b, [0.3, 0.8, 0.06]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, second) = (b.one_of(BRIGHT), b.choose(&[WHITE_PLASTIC, YELLOW_PLASTIC, BLUE_PLASTIC, PINK_PLASTIC]));
    let pillow = h * b.vary(0.2, 0.35);
    let flat = h - pillow;
    let across = b.rng.chance(0.5);
    let count = b.rng.count(4, 7);
    let t = flat / 2.0;
    if across {
        let half = y / count as f32;
        for (i, cy) in spaced(count, -y + half * 1.02, y - half * 1.02).enumerate() {
            b.rounded_block(
                "tube",
                [-x, cy - half * 1.02, 0.0],
                [x, cy + half * 1.02, flat - 0.0015 * (i % 2) as f32],
                t * 0.9,
                if i % 2 == 0 { mat } else { second },
            );
        }
    } else {
        let half = x / count as f32;
        for (i, cx) in spaced(count, -x + half * 1.02, x - half * 1.02).enumerate() {
            b.rounded_block(
                "tube",
                [cx - half * 1.02, -y, 0.0],
                [cx + half * 1.02, y, flat - 0.0015 * (i % 2) as f32],
                t * 0.9,
                if i % 2 == 0 { mat } else { second },
            );
        }
    }
    b.rounded_block(
        "pillow",
        [-x * 0.95, y * 0.66, flat * 0.5],
        [x * 0.95, y * 0.99, h],
        (h - flat * 0.5) * 0.45,
        second,
    );
    b.cylinder("valve", [x * 0.8, y * 0.9, h - 0.006], 0.01, 0.006, WHITE_PLASTIC);
}

/// A swim ring with bands, or with a duck's head.
pub(super) fn swim_ring(b: &mut Build<'_>) {
    at_least(b, [0.25, 0.25, 0.07]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let (mat, second) = (b.one_of(BRIGHT), b.choose(&[WHITE_PLASTIC, YELLOW_PLASTIC, BLUE_PLASTIC]));
    let animal = h > 0.17 && b.rng.chance(0.5);
    let s = (if animal { h * 0.32 } else { h / 2.0 }).min(r * b.vary(0.27, 0.33));
    b.lathe("ring", [0.0; 3], &torus_profile(r - s, s), mat);
    if animal {
        let neck = [r - s, 0.0, s];
        let head = [r - 1.1 * s, 0.0, h - s * 0.62];
        b.hull("neck", &limb(neck, head, s * 0.6, s * 0.45), mat);
        b.ball("head", head, s * 0.6, mat);
        b.hull(
            "beak",
            &limb(
                [head[0] + s * 0.4, 0.0, head[2] - s * 0.1],
                [(head[0] + s * 1.05).min(r), 0.0, head[2] - s * 0.15],
                s * 0.28,
                s * 0.16,
            ),
            ORANGE_PLASTIC,
        );
        for side in [-1.0, 1.0] {
            b.ball("eye", [head[0] + s * 0.3, side * s * 0.4, head[2] + s * 0.22], s * 0.12, BLACK_PLASTIC);
        }
    } else {
        bands(b, r - s, s, second);
    }
    b.cylinder("valve", [-r + s, 0.0, 2.0 * s - 0.006], 0.012, 0.0055, WHITE_PLASTIC);
}

/// Sleeves in a second colour around a ring that lies flat.
fn bands(b: &mut Build<'_>, radius: f32, section: f32, mat: MaterialId) {
    let count = b.rng.count(4, 8);
    let share = PI / count as f32 * 0.5;
    for i in 0..count {
        let a = TAU * i as f32 / count as f32;
        let slice = |angle: f32| -> Vec<P> {
            let (ux, uy) = polar(angle, 1.0);
            polygon(10, section * 1.012 - 0.0005, 0.0)
                .into_iter()
                .map(|(r, z)| {
                    [
                        ux * (radius + r.min(section * 0.999)),
                        uy * (radius + r.min(section * 0.999)),
                        (section + z).max(0.0).min(2.0 * section),
                    ]
                })
                .collect()
        };
        b.hull("band", &[slice(a - share * 0.5), slice(a), slice(a + share * 0.5)].concat(), mat);
    }
}

/// A lifebuoy, upright, with a rope along its rim.
pub(super) fn buoy(b: &mut Build<'_>) {
    at_least(b, [0.03, 0.25, 0.25]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let r = y.min(h / 2.0);
    let (mat, second) =
        (b.choose(&[ORANGE_PLASTIC, WHITE_PLASTIC, RED_PLASTIC]), b.choose(&[WHITE_PLASTIC, RED_PLASTIC, NAVY]));
    let second = if second == mat { SILVER_METAL } else { second };
    let rope = 0.006;
    let (s, out) = (x * 0.94, r - 2.2 * rope);
    let section: Vec<(f32, f32)> = {
        let wide = out * b.vary(0.14, 0.19);
        let mut ring: Vec<_> = polygon(12, 1.0, 0.0).into_iter().map(|(a, c)| (out - wide + a * wide, c * s)).collect();
        ring.extend(ring.first().copied());
        ring
    };
    let from: P = [0.0, 0.0, r];
    b.lathe_along("ring", from, [1.0, 0.0, r], &section, mat);
    let wide = (section[0].0 - section[6].0) / 2.0;
    for i in 0..4 {
        let a = FRAC_PI_2 * i as f32 + FRAC_PI_2 / 2.0;
        let slice = |angle: f32| -> Vec<P> {
            let (uy, uz) = polar(angle, 1.0);
            polygon(12, 1.0, 0.0)
                .into_iter()
                .map(|(p, q)| (out - wide + p * wide * 1.04, q * x * 0.985))
                .map(|(d, px)| [px, uy * d, r + uz * d])
                .collect()
        };
        b.hull("band", &[slice(a - 0.16), slice(a), slice(a + 0.16)].concat(), second);
        let at = |angle: f32, d: f32| {
            let (py, pz) = polar(angle, d);
            [0.0, py, r + pz]
        };
        let rim = r - rope * 1.3;
        for k in 0..4 {
            let (a0, a1) = (a + FRAC_PI_2 * k as f32 / 4.0, a + FRAC_PI_2 * (k + 1) as f32 / 4.0);
            b.rod("rope", at(a0, rim), at(a1, rim), rope, WHITE_COTTON);
        }
    }
}

/// A lying foam noodle: a tube with a hole.
pub(super) fn pool_noodle(b: &mut Build<'_>) {
    at_least(b, [0.03, 0.4, 0.03]);
    let (r, y) = (b.size.x.min(b.size.z) / 2.0, b.size.y / 2.0);
    let mat = b.one_of(BRIGHT);
    let hole = r * b.vary(0.25, 0.4);
    b.lathe_along(
        "noodle",
        [0.0, -y, r],
        [0.0, y, r],
        &[(r, 0.0), (r, 2.0 * y), (hole, 2.0 * y), (hole, 0.0), (r, 0.0)],
        mat,
    );
}

/// A beach ball of coloured segments.
pub(super) fn beach_ball(b: &mut Build<'_>) {
    at_least(b, [0.1, 0.1, 0.1]);
    let r = b.size.min() / 2.0;
    let segments = b.choose(&[6, 8]);
    let (first, second) = (b.one_of(BRIGHT), b.choose(&[WHITE_PLASTIC, YELLOW_PLASTIC, BLUE_PLASTIC]));
    let third = b.one_of(BRIGHT);
    let cap = 0.18;
    for i in 0..segments {
        let mut points: Vec<P> = Vec::new();
        for a in spaced(4, 0.0, 1.0).map(|s| TAU * (i as f32 + s) / segments as f32) {
            for polar_angle in spaced(9, cap * 0.8, PI - cap * 0.8) {
                let (out, z) = (r * polar_angle.sine(), r * polar_angle.cosine());
                let (px, py) = polar(a, out);
                points.push([px, py, r + z]);
            }
        }
        points.extend([[0.0, 0.0, r * 0.2], [0.0, 0.0, r * 1.8]]);
        b.hull("segment", &points, [first, second, third, second][i % 4]);
    }
    let at = r * cap.cosine();
    b.lathe(
        "cap",
        [0.0, 0.0, r + at - 0.002],
        &[(r * cap.sine(), 0.0), (r * cap.sine() * 0.9, (r - at) * 0.5), (0.0, r - at + 0.002)],
        WHITE_PLASTIC,
    );
    b.lathe(
        "cap",
        [0.0; 3],
        &[(0.0, 0.0), (r * cap.sine() * 0.9, (r - at) * 0.5), (r * cap.sine(), r - at + 0.002)],
        WHITE_PLASTIC,
    );
}
