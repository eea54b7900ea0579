//! Cutlery and knives: they lie flat along Y with the grip at the low end.

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Axis, Build, dims, level_oval, loft_columns, sweep, turn};

const ACROSS: [f32; 3] = [1.0, 0.0, 0.0];

/// The bowl of a spoon: an oval hollow with its rim at `z + depth`.
pub(super) fn scoop(b: &mut Build<'_>, centre: [f32; 3], half: (f32, f32), depth: f32, t: f32, mat: MaterialId) {
    let at = |rise: f32, k: f32, thin: f32| {
        level_oval(
            [centre[0], centre[1], centre[2] + depth * rise + thin],
            (half.0 * k - thin * 0.7, half.1 * k - thin * 0.7),
        )
    };
    let rings = [
        at(0.0, 0.35, 0.0),
        at(0.2, 0.7, 0.0),
        at(0.55, 0.92, 0.0),
        at(1.0, 1.0, 0.0),
        at(1.0, 1.0, t * 0.5),
        at(0.55, 0.92, t),
        at(0.2, 0.7, t),
        at(0.0, 0.35, t),
    ];
    loft_columns(b, "bowl", &rings, mat);
}

/// The handle of cutlery: from its tail at -Y, which rests there, over a rise to the head.
fn shaft(
    b: &mut Build<'_>,
    (tail, head): (f32, f32),
    (top, end): (f32, f32),
    half: (f32, f32),
    flare: f32,
    mat: MaterialId,
) {
    let (w, t) = half;
    let at = |k: f32, z: f32| [0.0, tail + (head - tail) * k, z];
    let path = [
        (at(0.0, t), w * flare * 0.6, t * 0.8),
        (at(0.08, t + top * 0.1), w * flare, t),
        (at(0.3, top * 0.5), w * 0.85, t),
        (at(0.55, top * 0.85), w * 0.65, t),
        (at(0.75, top), w * 0.45, t),
        (at(0.9, f32::midpoint(top, end)), w * 0.42, t),
        (at(1.0, end), w * 0.5, t),
    ];
    sweep(b, "handle", &path, ACROSS, mat);
}

fn metal(b: &mut Build<'_>) -> MaterialId {
    b.choose(&[STEEL, STEEL, STEEL, CHROME, GOLD, BLACK_METAL])
}

/// A table fork with three or four tines.
pub(super) fn fork(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = metal(b);
    let t = (z * 0.09).min(0.0016);
    let (tail, tip) = (-y / 2.0, y / 2.0);
    let neck = y * b.vary(0.14, 0.18);
    let flare = b.vary(0.8, 1.1);
    shaft(b, (tail, neck), (z - t, z * 0.55), (x * 0.36, t), flare, mat);
    let root = neck + y * 0.1;
    let path = [
        ([0.0, neck - y * 0.01, z * 0.55], x * 0.18, t),
        ([0.0, neck + y * 0.04, z * 0.2], x * 0.44, t),
        ([0.0, root, t * 1.2], x / 2.0, t),
    ];
    sweep(b, "head", &path, ACROSS, mat);
    let tines = b.choose(&[4, 4, 3]);
    let (pitch, w) = (x / tines as f32, x / tines as f32 * 0.28);
    for i in 0..tines {
        let at = -x / 2.0 + pitch * (i as f32 + 0.5);
        let (y0, y1) = (root - y * 0.01, f32::midpoint(root, tip));
        let lift = z * 0.3;
        let edge = |x: f32, y: f32, z: f32, w: f32| {
            [[x - w, y, z], [x + w, y, z], [x - w, y, z + t * 1.6], [x + w, y, z + t * 1.6]]
        };
        let low: Vec<_> = edge(at, y0, t * 0.3, w).into_iter().chain(edge(at, y1, t * 0.2, w)).collect();
        let high: Vec<_> = edge(at, y1, t * 0.2, w).into_iter().chain(edge(at, tip, lift, w * 0.5)).collect();
        b.hull("tine", &low, mat);
        b.hull("tine", &high, mat);
    }
}

/// Spoons for soup, dessert and tea.
pub(super) fn spoon(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = metal(b);
    let t = (z * 0.08).min(0.0015);
    let length = (x * b.vary(1.35, 1.6)).min(y * 0.4);
    let centre = y / 2.0 - length / 2.0;
    let depth = z * 0.42;
    scoop(b, [0.0, centre, 0.0], (x / 2.0, length / 2.0), depth, t, mat);
    let flare = b.vary(0.7, 1.0);
    shaft(b, (-y / 2.0, centre - length * 0.46), (z - t, depth * 0.95), (x * 0.24, t), flare, mat);
}

/// The outline of a blade as fractions of its width and length; the edge is at low X.
const TABLE: &[(f32, f32)] = &[(0.6, 0.0), (0.6, 1.0), (0.2, 0.97), (-0.3, 0.85), (-0.6, 0.6), (-0.6, 0.1), (0.0, 0.0)];
const CHEF: &[(f32, f32)] =
    &[(1.0, 0.0), (1.0, 0.75), (0.85, 0.93), (0.72, 1.0), (0.0, 0.85), (-0.6, 0.6), (-0.95, 0.3), (-1.0, 0.0)];
const LONG: &[(f32, f32)] = &[(0.8, 0.0), (0.8, 0.9), (0.5, 1.0), (-0.4, 0.95), (-0.8, 0.8), (-0.8, 0.0)];
const SMALL: &[(f32, f32)] = &[(0.8, 0.0), (0.8, 0.7), (0.6, 1.0), (-0.2, 0.75), (-0.7, 0.4), (-0.8, 0.05)];
const SPREAD: &[(f32, f32)] = &[(0.3, 0.0), (0.8, 0.4), (0.7, 0.85), (0.0, 1.0), (-0.7, 0.8), (-0.8, 0.4), (-0.3, 0.0)];
const CLEAVER: &[(f32, f32)] = &[(1.0, 0.0), (1.0, 0.97), (0.93, 1.0), (-0.95, 1.0), (-1.0, 0.95), (-1.0, 0.0)];

/// Table and kitchen knives: a flat blade and a grip.
pub(super) fn knife(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (outline, share) = match b.class {
        "chef_knife" => (CHEF, b.vary(0.58, 0.65)),
        "bread_knife" => (LONG, b.vary(0.6, 0.66)),
        "paring_knife" => (SMALL, b.vary(0.42, 0.5)),
        "steak_knife" => (SMALL, b.vary(0.48, 0.54)),
        "butter_knife" => (SPREAD, b.vary(0.45, 0.55)),
        "cleaver" => (CLEAVER, b.vary(0.58, 0.64)),
        _ => (TABLE, b.vary(0.46, 0.52)),
    };
    let root = y / 2.0 - y * share;
    let wide = x / 2.0 / outline.iter().fold(0.1_f32, |most, p| most.max(p.0.abs()));
    let t = (z * 0.16).min(0.0022);
    let plain = matches!(b.class, "knife" | "butter_knife");
    let grip = if plain {
        b.choose(&[STEEL, STEEL, CHROME, BLACK_PLASTIC])
    } else {
        b.choose(&[BLACK_PLASTIC, BLACK_PLASTIC, WALNUT, WENGE, RED_PLASTIC, STEEL])
    };
    let blade: Vec<_> = outline.iter().map(|p| (p.0 * wide, p.1 * y * share)).collect();
    b.prism("blade", Axis::Z, [0.0, root, z * 0.5 - t * 0.5], &blade, t, STEEL);
    if b.class == "bread_knife" {
        let teeth = 14;
        for i in 0..teeth {
            let at = root + y * share * 0.78 * (i as f32 + 0.5) / teeth as f32;
            let (edge, half) = (-x / 2.0, y * share * 0.39 / teeth as f32);
            let points = [
                [edge, at, z * 0.5],
                [edge * 0.85, at - half, z * 0.5 - t * 0.4],
                [edge * 0.85, at + half, z * 0.5 - t * 0.4],
                [edge * 0.85, at, z * 0.5 + t * 0.4],
            ];
            b.hull("tooth", &points, STEEL);
        }
    }
    let (spine, w) = (wide * outline[0].0, (x * if plain { 0.38 } else { 0.34 }).min(y * 0.045));
    let middle = if b.class == "cleaver" || b.class == "chef_knife" { spine - w } else { 0.0 };
    let at = |k: f32| [middle, root + (-y / 2.0 - root) * k, z / 2.0];
    let h = z / 2.0;
    let path = [
        (at(-0.02), w * 0.8, h * 0.7),
        (at(0.12), w * 0.75, h * 0.85),
        (at(0.5), w * 0.95, h),
        (at(0.85), w, h),
        (at(0.97), w * 0.9, h * 0.9),
        (at(1.0), w * 0.5, h * 0.5),
    ];
    sweep(b, "handle", &path, ACROSS, grip);
    if !plain && grip != STEEL {
        b.block(
            "bolster",
            [middle - w * 0.97, root - y * 0.015, h * 0.2],
            [middle + w * 0.97, root + y * 0.015, z - h * 0.2],
            STEEL,
        );
        for k in [0.3, 0.55, 0.8] {
            let p = at(k);
            b.cylinder("rivet", [p[0], p[1], z * 0.02], w * 0.16, z * 0.96, STEEL);
        }
    }
}

/// Chopsticks: two sticks side by side.
pub(super) fn chopsticks(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.choose(&[BAMBOO, WENGE, RED, BLACK, CHERRY]);
    let thick = z.min(x * 0.4) / 2.0;
    for side in [-1.0, 1.0] {
        let at = |k: f32, r: f32| ([side * (x / 2.0 - thick), y * k, thick], r, r);
        sweep(b, "stick", &[at(-0.5, thick * 0.95), at(0.0, thick * 0.85), at(0.5, thick * 0.5)], ACROSS, mat);
        if side > 0.0 || mat == BLACK {
            let band = thick;
            b.rod(
                "band",
                [side * (x / 2.0 - thick), -y * 0.42, thick],
                [side * (x / 2.0 - thick), -y * 0.36, thick],
                band,
                GOLD,
            );
        }
    }
}

/// A striped straw, straight or bent at one end.
pub(super) fn drinking_straw(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(z) / 2.0;
    let (mat, stripe) = (
        b.choose(&[WHITE_PAPER, WHITE_PLASTIC, STEEL, BAMBOO]),
        b.choose(&[RED_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC, PINK_PLASTIC]),
    );
    let profile = [(0.82, 0.0), (0.82, 1.0), (0.56, 1.0), (0.56, 0.0), (0.82, 0.0)];
    let from = [0.0, -y / 2.0, r];
    let straw: Vec<_> = profile.iter().map(|p| (p.0 * r, p.1 * y)).collect();
    b.lathe_along("straw", from, [0.0, y / 2.0, r], &straw, mat);
    if mat != STEEL && mat != BAMBOO {
        let stripes = b.rng.count(4, 9);
        for i in 0..stripes {
            let at = y * (i as f32 + 0.3) / stripes as f32;
            let wide = y * 0.4 / stripes as f32;
            let ring = [(r * 0.72, at), (r, at), (r, at + wide), (r * 0.72, at + wide), (r * 0.72, at)];
            b.lathe_along("stripe", from, [0.0, y / 2.0, r], &ring, stripe);
        }
    }
}

/// Toothpicks in a small round box.
pub(super) fn toothpick(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let mat = b.choose(&[CLEAR_PLASTIC, b.style.wood, BAMBOO, WHITE_PLASTIC]);
    let outside = [(r * 0.92, 0.0), (r, z * 0.05), (r, z * 0.75)];
    b.lathe("box", [0.0; 3], &crate::solid::vessel_profile(&outside, r * 0.1), mat);
    for i in 0..9 {
        let (s, c) = (2.4 * i as f32).sine_cosine();
        let out = r * 0.22 * (i as f32).sqrt();
        let at = [out * c, out * s];
        let long = z * b.vary(0.9, 1.0) - r * 0.1;
        turn(
            b,
            "pick",
            [at[0], at[1], r * 0.1],
            (r * 0.06, long.max(z * 0.1)),
            &[(0.3, 0.0), (1.0, 0.1), (1.0, 0.9), (0.1, 1.0)],
            PINE,
        );
    }
}
