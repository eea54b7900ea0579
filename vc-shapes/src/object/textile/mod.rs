//! Towels, bedding, cushions, rugs and mats.

mod bedding;
mod rug;

use std::f32::consts::PI;

use vc_graph::portable::Portable;

use super::{Generator, indoor};
use crate::material::*;
use crate::solid::{self, Axis, Build, MeshBuilder, P, blocks, half_dims, loft};

pub(super) const GENERATORS: &[Generator] = &[
    indoor("towel", 6, towel),
    indoor("bath_towel", 6, towel),
    indoor("rolled_towel", 4, rolled_towel),
    indoor("washcloth", 3, towel),
    indoor("bath_mat", 6, rug::mat),
    indoor("sheets", 3, bedding::sheets),
    indoor("pillow", 6, bedding::pillow),
    indoor("pillowcase", 2, bedding::sheets),
    indoor("cushion", 12, bedding::cushion),
    indoor("duvet", 5, bedding::duvet),
    indoor("blanket", 6, bedding::blanket),
    indoor("rug", 16, rug::rug),
    indoor("mat", 4, rug::mat),
    indoor("doormat", 6, rug::mat),
];

/// The folding of a piece of cloth: corners of its box, number of layers, and roundness of its ends
/// (0 cut, 1 soft).
#[derive(Clone, Copy)]
pub(super) struct Fold {
    pub(super) low: P,
    pub(super) high: P,
    pub(super) layers: usize,
    pub(super) soft: f32,
}

/// Cloth folded into layers, rounded at the front of each layer where it folds.
pub(super) fn folded(b: &mut Build<'_>, name: &str, fold: Fold, mat: MaterialId) {
    let Fold { low, high, layers, soft } = fold;
    let mut shell = MeshBuilder::default();
    let thick = (high[2] - low[2]) / layers.max(1) as f32;
    for i in 0..layers.max(1) {
        let back = (high[0] - low[0]) * b.vary(0.0, 0.03);
        let z = low[2] + thick * (i as f32 + 0.5);
        let (round, depth) = (thick * 0.48, high[0] - low[0] - back);
        let ring = |y: f32, size: f32| {
            let r = round * size;
            let front = high[0] - r.min(depth * 0.4);
            let turn = solid::arc(Axis::Y, [front, y, z], (r.min(depth * 0.4), r), (-1.57, 1.57), 6);
            let mut ring = vec![[low[0] + back, y, z + r], [low[0] + back, y, z - r]];
            ring.extend(turn);
            ring
        };
        let reach = (high[1] - low[1]) * 0.04 * soft;
        let inset = [(0.0, 1.0 - 0.5 * soft), (reach * 0.3, 1.0 - 0.15 * soft), (reach.max(1e-4), 1.0)];
        let left = inset.iter().map(|&(d, s)| ring(low[1] + d, s));
        let right = inset.iter().rev().map(|&(d, s)| ring(high[1] - d, s));
        let rings: Vec<Vec<P>> = left.chain(right).collect();
        shell.loft(&rings);
    }
    shell.put(b, name, mat);
}

/// A folded towel with a woven border; it hangs over a rail if it is higher than wide.
fn towel(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let cloth = if b.rng.chance(0.7) {
        b.style.towel
    } else {
        b.choose(&[TOWEL_WHITE, TOWEL_BLUE, TOWEL_GREEN, TOWEL_ROSE, GREY_FABRIC])
    };
    let border = b.choose(&[WHITE_COTTON, GREY_FABRIC, BEIGE_FABRIC, NAVY_FABRIC, TEAL_FABRIC]);
    if h > 2.0 * x.max(y) {
        return hung(b, cloth, border);
    }
    let layers = if b.class == "washcloth" { 2 } else { b.rng.count(2, 4) };
    let trim = (h * 0.03).min(0.001);
    folded(b, "towel", Fold { low: [-x, -y, 0.0], high: [x, y, h - trim], layers, soft: 0.5 }, cloth);
    let stripes = b.rng.count(1, 3);
    let at = b.vary(0.45, 0.7);
    let thick = h / layers as f32;
    let list: Vec<(P, P)> = (0..stripes)
        .map(|i| {
            let y0 = y * (at - 0.12 * i as f32);
            ([-x * 0.85, y0, h - thick * 0.2], [x - thick * 0.55, y0 + y * 0.05, h])
        })
        .collect();
    blocks(b, "border", &list, border);
}

/// A towel over a rail that runs along Y through its top.
fn hung(b: &mut Build<'_>, cloth: MaterialId, border: MaterialId) {
    let (x, y, h) = half_dims(b);
    let back = h * b.vary(0.0, 0.3);
    let (outer, inner) = (x * 0.96, x * 0.4);
    let over = solid::arc(Axis::Y, [0.0, 0.0, h - outer], (outer, outer), (0.0, PI), 8);
    let under = solid::arc(Axis::Y, [0.0, 0.0, h - outer], (inner, inner), (PI, 0.0), 8);
    let outline: Vec<(f32, f32)> = [(inner, 0.0), (outer, 0.0)]
        .into_iter()
        .chain(over.iter().map(|p| (p[0], p[2])))
        .chain([(-outer, back), (-inner, back)])
        .chain(under.iter().map(|p| (p[0], p[2])))
        .collect();
    b.prism("towel", Axis::Y, [0.0, -y, 0.0], &outline, 2.0 * y, cloth);
    let band = |z: f32| ([outer - 0.001, -y * 0.99, z], [x, y * 0.99, z + h * 0.03]);
    blocks(b, "border", &[band(h * 0.06), band(h * 0.12)], border);
}

/// A rolled-up towel with its spiral visible at both ends.
fn rolled_towel(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let cloth = b.style.towel;
    let turns = b.vary(3.0, 4.5);
    let wide = x.min(h / 2.0);
    let pitch = wide / turns * 0.96;
    let steps = 60;
    let point = |i: usize, thick: f32| {
        let turn = turns * i as f32 / steps as f32;
        let (s, c) = (turn * std::f32::consts::TAU).sine_cosine();
        let r = (wide - pitch * turn - thick).max(0.0);
        (r * c * x / wide, h / 2.0 + r * s * h / 2.0 / wide)
    };
    let outer = (0..steps).map(|i| point(i, 0.0));
    let inner = (0..steps).rev().map(|i| point(i, pitch * 0.9));
    let spiral: Vec<(f32, f32)> = outer.chain(inner).collect();
    b.prism("towel", Axis::Y, [0.0, -y, 0.0], &spiral, 2.0 * y, cloth);
    let core = solid::oval(Axis::Y, [0.0, -y * 0.98, h / 2.0], (x * 0.9, h * 0.45), 0, 16);
    let end = core.iter().map(|p| [p[0], y * 0.98, p[2]]).collect();
    loft(b, "towel", &[core, end], cloth);
    if b.rng.chance(0.5) {
        let band = b.choose(&[JUTE, NAVY_FABRIC, WHITE_COTTON, RUST_FABRIC]);
        let ring = |y: f32| solid::oval(Axis::Y, [0.0, y, h / 2.0], (x, h / 2.0), 0, 20);
        loft(b, "band", &[ring(-y * 0.08), ring(y * 0.08)], band);
    }
}
