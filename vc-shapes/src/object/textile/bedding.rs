//! Textiles on beds and sofas.

use vc_graph::portable::Portable;

use super::{Fold, folded};
use crate::material::*;
use crate::solid::{self, Build, CORNERS, MeshBuilder, P, blocks, half_dims, sheet};

/// Folded and stacked sheets or pillow cases.
pub(super) fn sheets(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let count = if b.class == "sheets" { b.rng.count(1, 3) } else { b.rng.count(1, 2) };
    let mut z = 0.0;
    for i in 0..count {
        let cloth = if i == 0 {
            b.style.linen
        } else {
            b.choose(&[WHITE_COTTON, LINEN, BLUE_FABRIC, ROSE_FABRIC, GREY_FABRIC])
        };
        let high = h * (i + 1) as f32 / count as f32;
        let inset = b.vary(0.0, 0.06) * i as f32;
        let (dx, dy) = (x * (1.0 - inset), y * (1.0 - inset));
        let layers = b.rng.count(2, 3);
        folded(b, "sheet", Fold { low: [-dx, -dy, z], high: [dx, dy, high], layers, soft: 0.3 }, cloth);
        z = high;
    }
}

/// A bed pillow, with piping or plain.
pub(super) fn pillow(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let cloth = if b.rng.chance(0.6) { b.style.linen } else { WHITE_COTTON };
    let pinch = b.vary(0.02, 0.06);
    let seam = b.rng.chance(0.4);
    let border = if seam { 0.94 } else { 1.0 };
    solid::cushion(b, "pillow", [0.0, 0.0, h / 2.0], [x * border, y * border, h / 2.0], pinch, cloth);
    if seam {
        let flat = (h * 0.03).min(0.004);
        b.block("border", [-x, -y, h / 2.0 - flat], [x, y, h / 2.0 + flat], cloth);
    }
    dent(b, cloth);
}

/// A fold at the open end of the pillow case.
fn dent(b: &mut Build<'_>, cloth: MaterialId) {
    let (x, y, h) = half_dims(b);
    let side = b.choose(&[-1.0_f32, 1.0]);
    let mut shell = MeshBuilder::default();
    patch(&mut shell, [x, y, h / 2.0], 0.03, (-0.9, 0.9), (side * 0.72, side * 0.78));
    shell.put(b, "hem", cloth);
}

/// A strip on the upper side of a cushion of half extents `half`, over a part of its depth and
/// width (-1 to 1).
fn patch(shell: &mut MeshBuilder, half: P, pinch: f32, (u0, u1): (f32, f32), (v0, v1): (f32, f32)) {
    let bulge = |t: f32| (1.0 - t * t).max(0.0);
    shell.sheet((8, 3), |s, t| {
        let (u, v) = (u0 + (u1 - u0) * s, v0 + (v1 - v0) * t);
        let x = half[0] * u * (1.0 - pinch * bulge(v));
        let y = half[1] * v * (1.0 - pinch * bulge(u));
        let z = half[2] * (bulge(u) * bulge(v)).sqrt();
        ([x, y, half[2] + (z + 0.0012).min(half[2])], [x, y, half[2] + z * 0.9])
    });
}

/// A cushion: plain, striped, crossed, checked or buttoned.
pub(super) fn cushion(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let cloths = [b.style.accent, b.style.upholstery, LINEN, MUSTARD_FABRIC, TEAL_FABRIC, ROSE_FABRIC, NAVY_FABRIC];
    let cloth = b.choose(&cloths);
    let other = b.choose(&[WHITE_COTTON, LINEN, CHARCOAL_FABRIC, RUST_FABRIC, GREEN_FABRIC, b.style.accent]);
    let pinch = b.vary(0.04, 0.1);
    let half = [x, y, h / 2.0];
    solid::cushion(b, "cushion", [0.0, 0.0, h / 2.0], [x, y, h / 2.0 - 0.001], pinch, cloth);
    let mut shell = MeshBuilder::default();
    match b.rng.below(5) {
        0 => {
            let stripes = b.rng.count(2, 4);
            for i in 0..stripes {
                let v = -0.7 + 1.4 * (i as f32 + 0.5) / stripes as f32;
                patch(&mut shell, half, pinch, (-0.96, 0.96), (v - 0.09, v + 0.09));
            }
        }
        1 => {
            patch(&mut shell, half, pinch, (-0.96, 0.96), (-0.12, 0.12));
            patch(&mut shell, half, pinch, (-0.12, 0.12), (-0.96, -0.14));
            patch(&mut shell, half, pinch, (-0.12, 0.12), (0.14, 0.96));
        }
        2 => {
            for (i, j) in (0..9).map(|k| (k % 3, k / 3)).filter(|(i, j)| (i + j) % 2 == 0) {
                let at = |k: i32| -0.66 + 0.44 * k as f32;
                patch(&mut shell, half, pinch, (at(i), at(i) + 0.42), (at(j), at(j) + 0.42));
            }
        }
        3 => {
            let (u, v) = (b.vary(0.3, 0.6), b.vary(0.3, 0.6));
            patch(&mut shell, half, pinch, (-u, u), (-v, v));
        }
        _ => shell.egg([0.0, 0.0, h - h * 0.06], [x * 0.07, y * 0.07, h * 0.06]),
    }
    shell.put(b, "pattern", other);
    if b.rng.chance(0.3) {
        tassels(b, other);
    }
}

/// A tassel at every corner.
fn tassels(b: &mut Build<'_>, mat: MaterialId) {
    let (x, y, h) = half_dims(b);
    let r = x.min(h) * 0.05;
    let mut shell = MeshBuilder::default();
    for (sx, sy) in CORNERS {
        shell.egg([sx * (x - 2.0 * r), sy * (y - 2.0 * r), h / 2.0], [r * 2.0, r * 2.0, r * 1.6]);
    }
    shell.put(b, "tassel", mat);
}

/// A duvet: spread out if the size is flat, otherwise folded.
pub(super) fn duvet(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let cloth = b.style.linen;
    let lining = b.choose(&[WHITE_COTTON, LINEN, GREY_FABRIC, b.style.accent]);
    if h > 0.5 * x.min(y) {
        let layers = b.rng.count(2, 3);
        folded(b, "duvet", Fold { low: [-x, -y, 0.0], high: [x, y, h], layers, soft: 1.0 }, cloth);
        return;
    }
    spread(b, 1.0, cloth);
    let back = b.vary(0.16, 0.24) * x;
    let wave = b.vary(0.0, 6.0);
    let top = |u: f32, v: f32| {
        let end = (1.0 - (2.0 * u - 1.0).raised(4)) * (1.0 - (2.0 * v - 1.0).raised(8));
        let z = h * (0.93 + 0.07 * (wave + 9.0 * v).sine()) * end.max(0.0).sqrt();
        let (px, py) = (-x + back * 2.0 * u, y * (2.0 * v - 1.0));
        ([px, py, z.max(h * 0.62)], [px, py, h * 0.6])
    };
    sheet(b, "turned_back", (6, 16), top, lining);
}

/// A soft slab over the whole rectangle, quilted or wavy, up to the fraction `share` of the height.
fn spread(b: &mut Build<'_>, share: f32, cloth: MaterialId) {
    let (x, y, h) = half_dims(b);
    let h = h * share;
    let (a, c) = (b.vary(0.0, 6.0), b.vary(0.0, 6.0));
    let quilted = b.rng.chance(0.4);
    let (nx, ny) = ((x * 10.0).clamp(8.0, 18.0), (y * 10.0).clamp(8.0, 20.0));
    let height = move |u: f32, v: f32| {
        let (p, q) = (2.0 * u - 1.0, 2.0 * v - 1.0);
        let edge = ((1.0 - p.raised(8)) * (1.0 - q.raised(8))).max(0.0).sqrt();
        let waves = if quilted {
            0.75 + 0.17 * (u * 18.0).sine().abs() * (v * 18.0).sine().abs()
        } else {
            0.8 + 0.07 * (a + 5.0 * u + 4.0 * v).sine() + 0.05 * (c + 9.0 * v - 3.0 * u).sine()
        };
        h * (0.25 + edge * (waves - 0.25))
    };
    let at = move |u: f32, v: f32| {
        let (px, py) = (x * (2.0 * u - 1.0), y * (2.0 * v - 1.0));
        ([px, py, height(u, v)], [px, py, 0.0])
    };
    sheet(b, "cover", (nx as usize, ny as usize), at, cloth);
}

/// A blanket: spread out if the size is flat, otherwise folded; with fringes or stripes.
pub(super) fn blanket(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let cloth =
        b.choose(&[b.style.accent, b.style.accent, WOOL, GREY_FABRIC, MUSTARD_FABRIC, RUST_FABRIC, NAVY_FABRIC]);
    let other = b.choose(&[WOOL, WHITE_COTTON, CHARCOAL_FABRIC, BROWN_FABRIC]);
    if h < 0.12 * x.min(y) {
        spread(b, 0.98, cloth);
        let list: Vec<(P, P)> =
            [0.7, 0.8, 0.9].map(|s| ([x * s, -y * 0.9, h * 0.3], [x * (s + 0.04), y * 0.9, h])).to_vec();
        return blocks(b, "stripe", &list, other);
    }
    let layers = b.rng.count(2, 4);
    let fringe = if b.rng.chance(0.5) { y * 0.08 } else { 0.0 };
    let low = [-x, -y + fringe, 0.0];
    folded(b, "blanket", Fold { low, high: [x, y - fringe, h - 0.001], layers, soft: 0.8 }, cloth);
    let thick = h / layers as f32;
    if fringe > 0.0 {
        let mut list = Vec::new();
        for (layer, i) in (0..layers).flat_map(|l| (0..10).map(move |i| (l, i))) {
            let z = thick * (layer as f32 + 0.45);
            let px = -x * 0.9 + x * 1.7 * i as f32 / 9.0;
            let strand = |y0: f32, y1: f32| ([px, y0, z], [px + x * 0.06, y1, z + thick * 0.12]);
            list.extend([strand(-y, -y + fringe * 1.4), strand(y - fringe * 1.4, y)]);
        }
        blocks(b, "fringe", &list, other);
    } else {
        let list = [0.5, 0.62].map(|s| ([-x * 0.8, y * s, h - thick * 0.4], [x - thick * 0.55, y * (s + 0.07), h]));
        blocks(b, "stripe", &list, other);
    }
}
