//! Vases and table centrepieces.

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, half_dims, hoop, loft, mix, oval, spline};

const GLAZES: [MaterialId; 13] = [
    PORCELAIN,
    BLUE_GLAZE,
    GREEN_GLAZE,
    BLACK_GLAZE,
    RED_GLAZE,
    YELLOW_GLAZE,
    STONEWARE,
    POTTERY,
    GLASS,
    GREEN_GLASS,
    BLUE_GLASS,
    BROWN_GLASS,
    BRASS,
];

/// The outlines of vases: relative radius and height.
const OUTLINES: [&[(f32, f32)]; 8] = [
    &[(0.5, 0.0), (0.75, 0.15), (1.0, 0.4), (0.9, 0.62), (0.5, 0.82), (0.38, 0.92), (0.5, 1.0)],
    &[(0.85, 0.0), (1.0, 0.06), (1.0, 0.96), (0.97, 1.0)],
    &[(0.6, 0.0), (0.68, 0.2), (0.8, 0.6), (1.0, 1.0)],
    &[(0.55, 0.0), (0.9, 0.12), (1.0, 0.28), (0.85, 0.45), (0.3, 0.62), (0.24, 0.9), (0.32, 1.0)],
    &[(0.7, 0.0), (0.62, 0.04), (0.66, 0.1), (1.0, 0.7), (0.92, 0.88), (0.7, 0.94), (0.78, 1.0)],
    &[(0.6, 0.0), (0.95, 0.2), (1.0, 0.36), (0.6, 0.56), (0.5, 0.66), (0.66, 0.86), (0.8, 1.0)],
    &[(0.45, 0.0), (0.8, 0.18), (1.0, 0.5), (0.8, 0.82), (0.45, 1.0)],
    &[(0.9, 0.0), (1.0, 0.03), (0.62, 0.36), (0.5, 0.7), (0.56, 0.9), (0.8, 1.0)],
];

/// A vase: turned, faceted or square, with rings, handles or a glazed belly.
pub(super) fn vase(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    let mat = b.choose(&GLAZES);
    let outline = b.choose(&OUTLINES);
    let swell = b.vary(0.85, 1.1);
    let handles = b.rng.chance(0.2);
    let share = if handles { 0.85 } else { 1.0 };
    let wall: Vec<(f32, f32)> = outline.iter().map(|&(s, z)| (r * share * (1.0 + (s - 1.0) * swell), z * h)).collect();
    let t = (r * 0.08).clamp(0.0015, 0.008);
    if b.rng.chance(0.22) {
        faceted(b, &wall, t, mat);
    } else {
        let inner = wall.iter().rev().map(|&(s, z)| ((s - t).max(t), z.max(t * 2.0)));
        let profile: Vec<(f32, f32)> = smooth(&wall).into_iter().chain(inner).collect();
        b.lathe("vase", [0.0; 3], &profile, mat);
        trim(b, &wall, mat);
    }
    if handles {
        let widest = wall.iter().fold((0.0, 0.0), |m: (f32, f32), &p| if p.0 > m.0 { p } else { m });
        ears(b, &wall, widest.1, mat);
    }
}

/// The outline with its corners cut twice (Chaikin), keeping its ends.
fn smooth(wall: &[(f32, f32)]) -> Vec<(f32, f32)> {
    let mut line = wall.to_vec();
    for _ in 0..2 {
        let (Some(&first), Some(&last)) = (line.first(), line.last()) else { return line };
        let cut = line.windows(2).flat_map(|w| {
            let at = |t: f32| (w[0].0 + (w[1].0 - w[0].0) * t, w[0].1 + (w[1].1 - w[0].1) * t);
            [at(0.25), at(0.75)]
        });
        line = [first].into_iter().chain(cut).chain([last]).collect();
    }
    line
}

/// The radius of the outline at a height.
fn radius_at(wall: &[(f32, f32)], z: f32) -> f32 {
    let pair = wall.windows(2).find(|w| z <= w[1].1);
    pair.map_or(0.0, |w| w[0].0 + (w[1].0 - w[0].0) * (z - w[0].1) / (w[1].1 - w[0].1).max(1e-6))
}

/// A vase with flat sides, open at the top.
fn faceted(b: &mut Build<'_>, wall: &[(f32, f32)], t: f32, mat: MaterialId) {
    let n = b.choose(&[4, 6, 8]);
    let twist = b.vary(0.0, 0.25);
    let ring = |&(s, z): &(f32, f32), i: usize| -> Vec<P> {
        let turn = twist * i as f32;
        oval(Axis::Z, [0.0, 0.0, z], (s, s), 0, n)
            .into_iter()
            .map(|p| [p[0] * turn.cosine() - p[1] * turn.sine(), p[0] * turn.sine() + p[1] * turn.cosine(), z])
            .collect()
    };
    let outer = wall.iter().enumerate().map(|(i, p)| ring(p, i));
    let inner = wall.iter().enumerate().rev().map(|(i, &(s, z))| ring(&((s - t).max(t), z.max(2.0 * t)), i));
    let rings: Vec<Vec<P>> = outer.chain(inner).collect();
    loft(b, "vase", &rings, mat);
}

/// Rings around the body, in a second glaze.
fn trim(b: &mut Build<'_>, wall: &[(f32, f32)], mat: MaterialId) {
    if b.rng.chance(0.5) {
        return;
    }
    let h = b.size.z;
    let glaze = b.choose(&[GOLD, WHITE_METAL, BLUE_GLAZE, BLACK_GLAZE, RED_GLAZE]);
    if glaze == mat {
        return;
    }
    let (start, count) = (b.vary(0.15, 0.4), b.rng.count(1, 4));
    for i in 0..count {
        let z = h * (start + 0.07 * i as f32);
        let s = radius_at(wall, z);
        let wide = s * 0.03;
        hoop(b, "ring", &oval(Axis::Z, [0.0, 0.0, z], (s - wide * 0.7, s - wide * 0.7), 0, 24), wide, glaze);
    }
}

/// A handle at both sides.
fn ears(b: &mut Build<'_>, wall: &[(f32, f32)], belly: f32, mat: MaterialId) {
    let (_, y, h) = half_dims(b);
    let top = f32::midpoint(belly, h).max(h * 0.7);
    let thick = y * 0.06;
    let mut shell = MeshBuilder::default();
    for side in [-1.0_f32, 1.0] {
        let (low, high) = (radius_at(wall, belly * 0.95) * 0.95, radius_at(wall, top) * 0.95);
        let from = [0.0, side * low.min(y * 0.9), belly * 0.95];
        let to = [0.0, side * high.min(y * 0.9), top];
        let out = y - thick * 1.6;
        let points = [from, [0.0, side * out, mix(from, to, 0.4)[2]], [0.0, side * out, mix(from, to, 0.8)[2]], to];
        shell.tube(&spline(&points, 4), thick);
    }
    shell.put(b, "handle", mat);
}

/// A table centrepiece: a bowl of balls or fruit, or a tray with candles and twigs.
pub(super) fn centerpiece(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[b.style.wood, BRASS, PORCELAIN, BLACK_GLAZE, GLASS]);
    let low = h * 0.35;
    let ring = |z: f32, s: f32| oval(Axis::Z, [0.0, 0.0, z], (x * s, y * s), 1, 24);
    let t = 0.06;
    loft(b, "bowl", &[ring(0.0, 0.5), ring(low, 1.0), ring(low, 1.0 - t), ring(low * 0.2, 0.5 - t)], mat);
    let fill = b.choose(&[LEAF, PETAL_PINK, RED_SKIN, ORANGE_SKIN, GREEN_SKIN, GOLD]);
    let mut balls = MeshBuilder::default();
    for i in 0..9 {
        let a = i as f32 * 2.4;
        let reach = 0.62 * (i as f32 / 9.0).sqrt();
        let r = x.min(y).min(h) * b.vary(0.2, 0.26);
        let z = (low * 0.4 + r + (h * 0.45) * (0.6 - reach).max(0.0)).min(h - r);
        balls.egg([x * reach * a.cosine(), y * reach * a.sine(), z], [r, r, r]);
    }
    balls.put(b, "filling", fill);
    let mut leaves = MeshBuilder::default();
    for i in 0..10 {
        let a = i as f32 * 0.63;
        let tip = [x * 0.95 * a.cosine(), y * 0.95 * a.sine(), h * b.vary(0.5, 0.98)];
        let from = [tip[0] * 0.4, tip[1] * 0.4, low * 0.5];
        let over = [tip[0] * 0.75, tip[1] * 0.75, tip[2]];
        leaves.leaf(&[from, over, tip], |t| x.min(y) * 0.12 * (1.0 - (2.0 * t - 0.9).abs()).max(0.02), 0.3);
    }
    let green = b.choose(&[LEAF, DARK_LEAF, LIGHT_LEAF]);
    leaves.put(b, "leaf", green);
}
