//! Floating goals and nets.

use std::f32::consts::TAU;

use super::BRIGHT;
use crate::material::*;
use crate::solid::{Build, P, at_least, polar, spaced, torus_profile};

/// Floating tubes with a net above: rails along X and Y at the water's surface, and posts.
fn floats(b: &mut Build<'_>, (x, y): (f32, f32), r: f32, mat: MaterialId) {
    let keep = 1.2 * r;
    for s in [-1.0, 1.0] {
        b.bar("float", [-x + keep, s * (y - keep), keep], [x - keep, s * (y - keep), keep], r, mat);
    }
    b.bar("float", [-x + keep, -y + keep, keep], [-x + keep, y - keep, keep], r, mat);
}

/// Threads of a net over a parallelogram given by a corner and two sides.
fn net(b: &mut Build<'_>, at: P, u: P, v: P, (nu, nv): (usize, usize), r: f32, mat: MaterialId) {
    let point = |a: f32, c: f32| -> P { std::array::from_fn(|i| at[i] + u[i] * a + v[i] * c) };
    for a in spaced(nu, 0.0, 1.0) {
        b.rod("net", point(a, 0.0), point(a, 1.0), r, mat);
    }
    for c in spaced(nv, 0.0, 1.0) {
        b.rod("net", point(0.0, c), point(1.0, c), r, mat);
    }
}

/// A floating goal.
pub(super) fn pool_goal(b: &mut Build<'_>) {
    at_least(b, [0.2, 0.45, 0.3]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, second) = (b.one_of(BRIGHT), b.choose(&[WHITE_PLASTIC, YELLOW_PLASTIC, BLUE_PLASTIC]));
    let r = b.vary(0.035, 0.055).min(x * 0.2);
    floats(b, (x, y), r, mat);
    let (front, back) = (x - 2.2 * r, -x + 1.2 * r);
    let (side, top, post) = (y - 1.2 * r, h - r, r * 0.7);
    for s in [-1.0, 1.0] {
        b.bar("post", [front, s * side, 1.2 * r], [front, s * side, top], post, second);
        b.rod("stay", [back, s * side, 1.2 * r], [front, s * side, top], post * 0.4, second);
    }
    b.bar("crossbar", [front, -side, top], [front, side, top], post, second);
    net(
        b,
        [back, -side, 1.2 * r],
        [0.0, 2.0 * side, 0.0],
        [front - back, 0.0, top - 1.2 * r],
        (9, 6),
        0.003,
        WHITE_COTTON,
    );
}

/// A volleyball net on two floats.
pub(super) fn pool_volleyball(b: &mut Build<'_>) {
    at_least(b, [0.15, 1.2, 0.3]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, second) = (b.one_of(BRIGHT), b.choose(&[WHITE_PLASTIC, YELLOW_PLASTIC, BLUE_PLASTIC]));
    let r = b.vary(0.04, 0.06).min(x * 0.3);
    for s in [-1.0, 1.0] {
        let cy = s * (y - x.min(0.25));
        let half = x.min(0.25);
        b.lathe("float", [0.0, cy, 0.0], &torus_profile(half - r, r), mat);
        b.bar("spar", [-half + r, cy, r], [half - r, cy, r], r * 0.5, second);
        b.bar("post", [0.0, cy, r], [0.0, cy, h - r], r * 0.65, second);
    }
    let side = y - x.min(0.25);
    let low = h * b.vary(0.4, 0.5);
    net(b, [0.0, -side, low], [0.0, 2.0 * side, 0.0], [0.0, 0.0, h - 1.5 * r - low], (17, 4), 0.003, WHITE_COTTON);
    b.block("tape", [-0.004, -side, h - 1.8 * r], [0.004, side, h - r], second);
}

/// A floating basketball hoop.
pub(super) fn pool_basketball(b: &mut Build<'_>) {
    at_least(b, [0.25, 0.25, 0.3]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, ring_mat) = (b.one_of(BRIGHT), b.choose(&[ORANGE_PLASTIC, RED_PLASTIC, WHITE_PLASTIC]));
    let (half, r) = (x.min(y), b.vary(0.05, 0.07).min(x * 0.2));
    b.lathe("float", [0.0; 3], &torus_profile(half - r, r), mat);
    b.cylinder("floor", [0.0, 0.0, r * 0.8], half - r, 0.006, mat);
    let (back, board) = (-half + 2.0 * r, h * 0.42);
    for s in [-1.0, 1.0] {
        b.bar("post", [back, s * half * 0.3, r], [back, s * half * 0.3, h - board * 0.5], r * 0.35, ring_mat);
    }
    b.rounded_block(
        "board",
        [back + r * 0.2, -half * 0.75, h - board],
        [back + r * 0.2 + 0.03, half * 0.75, h],
        0.01,
        WHITE_PLASTIC,
    );
    let x0 = back + r * 0.2 + 0.028;
    b.block("target", [x0, -half * 0.25, h - board * 0.75], [x0 + 0.005, half * 0.25, h - board * 0.3], ring_mat);
    let rim = (half * 0.42).min((half - x0) / 2.0);
    let z = h - board * 0.85;
    b.lathe("rim", [x0 + rim, 0.0, z], &torus_profile(rim - 0.012, 0.012), ring_mat);
    for i in 0..8 {
        let (dx, dy) = polar(TAU * i as f32 / 8.0, 1.0);
        let (top, low) = (rim - 0.02, rim * 0.6);
        b.rod(
            "net",
            [x0 + rim + dx * top, dy * top, z + 0.008],
            [x0 + rim + dx * low, dy * low, z - h * 0.14],
            0.003,
            WHITE_COTTON,
        );
    }
    b.lathe("net", [x0 + rim, 0.0, z - h * 0.14 - 0.003], &torus_profile(rim * 0.6, 0.003), WHITE_COTTON);
}
