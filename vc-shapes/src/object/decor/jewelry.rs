//! Jewelry and watches.

use std::f32::consts::TAU;

use vc_graph::portable::Portable;

use super::clock::{dial, digits};
use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, half_dims, hoop, ngon, oval};

const GEMS: [MaterialId; 5] = [CLEAR_PLASTIC, RED_GLAZE, BLUE_GLAZE, GREEN_GLAZE, PORCELAIN];

fn precious(b: &mut Build<'_>) -> MaterialId {
    b.choose(&[GOLD, GOLD, SILVER_METAL, CHROME])
}

/// A finger ring lying flat, with a stone.
pub(super) fn ring(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let metal = precious(b);
    let stone = b.choose(&GEMS);
    let t = (x * 0.12).min(h / 2.0);
    let gem = (x * 0.25).min(h / 2.0);
    let back = x - gem;
    let line = oval(Axis::Z, [-gem * 0.5, 0.0, t], ((back - t).max(t), y - t), 0, 28);
    hoop(b, "ring", &line, t, metal);
    let mut shell = MeshBuilder::default();
    shell.egg([x - gem, 0.0, gem], [gem, gem, gem]);
    shell.put(b, "stone", stone);
}

/// A chain laid in a loop, with a pendant.
pub(super) fn necklace(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let metal = precious(b);
    let (pearls, r) = (b.rng.chance(0.5), h * 0.5);
    let chain = (r * 0.6).min(x * 0.02);
    let wave = b.vary(0.0, TAU);
    let count = if pearls { ((x + y) * 3.0 / (2.0 * r)).clamp(14.0, 22.0) as usize } else { 36 };
    let line: Vec<P> = (0..count)
        .map(|i| {
            let a = TAU * i as f32 / count as f32;
            let s = 0.92 + 0.08 * (3.0 * a + wave).sine();
            [(x - r) * a.cosine() * s, (y - r) * a.sine() * s, if pearls { r } else { chain }]
        })
        .collect();
    if pearls {
        let mut shell = MeshBuilder::default();
        line.iter().for_each(|&p| shell.egg(p, [r, r, r]));
        shell.put(b, "pearl", PORCELAIN);
    } else {
        hoop(b, "chain", &line, chain, metal);
        let stone = b.choose(&GEMS);
        let mut shell = MeshBuilder::default();
        shell.egg([x - r * 2.0, 0.0, r], [r * 1.8, r * 1.4, r]);
        shell.put(b, "pendant", stone);
    }
}

/// A pair of earrings: hoops or drops.
pub(super) fn earrings(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let metal = precious(b);
    let stone = b.choose(&GEMS);
    let hoops = b.rng.chance(0.5);
    for side in [-1.0_f32, 1.0] {
        let r = (y * 0.45).min(x);
        let at = [0.0, side * (y - r), 0.0];
        if hoops {
            let t = r * 0.1;
            let s = (h / 2.0).min(r) - t;
            hoop(b, "hoop", &oval(Axis::Y, [at[0], at[1], h / 2.0], ((x - t).max(t), s.max(t)), 0, 24), t, metal);
        } else {
            let gem = r.min(h * 0.25);
            let mut shell = MeshBuilder::default();
            shell.egg([0.0, at[1], gem], [gem, gem, gem]);
            shell.put(b, "stone", stone);
            b.rod("wire", [0.0, at[1], gem * 1.8], [0.0, at[1], h], gem * 0.15, metal);
        }
    }
}

/// A bangle, or a bracelet of beads.
pub(super) fn bracelet(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let t = (h / 2.0).min(x * 0.15);
    if b.rng.chance(0.5) {
        let metal = precious(b);
        let r = x.min(y);
        let ring =
            [(r, h * 0.1), (r, h * 0.9), (r * 0.97, h), (r * 0.9, h), (r * 0.9, 0.0), (r * 0.97, 0.0), (r, h * 0.1)];
        return b.lathe("bangle", [0.0; 3], &ring, metal);
    }
    let (first, second) = (b.choose(&GEMS), precious(b));
    let count = ((x - t) * 3.1 / t) as usize;
    let line = oval(Axis::Z, [0.0, 0.0, t], (x - t, y - t), 0, count.clamp(10, 24));
    let mut beads = [MeshBuilder::default(), MeshBuilder::default()];
    for (i, &p) in line.iter().enumerate() {
        beads[usize::from(i % 4 == 0)].egg(p, [t, t, t]);
    }
    let [many, few] = beads;
    many.put(b, "bead", first);
    few.put(b, "bead", second);
}

/// A wrist watch with its strap closed in a loop that stands on its edge; the dial faces the front.
pub(super) fn watch(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let smart = b.class == "smart_watch";
    let strap = b.choose(&[BROWN_LEATHER, BLACK_LEATHER, STEEL, NAVY_FABRIC, RUBBER, TAN_LEATHER]);
    // If it were solid metal, a smart watch would be too heavy for its strap.
    let cases: &[MaterialId] =
        if smart { &[BLACK_PLASTIC, GREY_PLASTIC, ANTHRACITE] } else { &[STEEL, GOLD, BLACK_METAL, SILVER_METAL] };
    let case = b.one_of(cases);
    let wide = if smart { y } else { y.min(h * 0.6) };
    let t = x * 0.1;
    let loop_ = |s: f32| oval(Axis::Y, [-t, 0.0, h / 2.0], ((x - t) * s, h / 2.0 * s), 0, 24);
    let (mut outer, mut inner) = (loop_(1.0), loop_(0.86));
    // It stands on its clasp, not on its case.
    let clasp = h * if smart { 0.16 } else { 0.055 };
    outer.iter_mut().for_each(|p| p[2] = p[2].max(clasp));
    inner.iter_mut().for_each(|p| p[2] = p[2].max(clasp + h * 0.015));
    let half = wide * 0.55;
    let mut shell = MeshBuilder::default();
    let side = |p: &P, s: f32| [p[0], s * half, p[2]];
    let rings: Vec<Vec<P>> = (0..24)
        .map(|i| vec![side(&outer[i], -1.0), side(&outer[i], 1.0), side(&inner[i], 1.0), side(&inner[i], -1.0)])
        .collect();
    shell.torus(&rings);
    shell.put(b, "strap", strap);
    let (back, front) = (x - 3.0 * t, x);
    let r = (wide * 0.92).min(h * if smart { 0.33 } else { 0.44 });
    // Steel, so that the clasp balances the case.
    b.block("clasp", [-x, -half * 0.7, h / 2.0 - 3.0 * t], [1.4 * t - x, half * 0.7, h / 2.0 + 3.0 * t], STEEL);
    if smart {
        b.rounded_block("case", [back, -r, h / 2.0 - r], [front - t * 0.8, r, h / 2.0 + r], r * 0.3, case);
        b.block(
            "screen",
            [front - t, -r * 0.8, h / 2.0 - r * 0.8],
            [front - t * 0.5, r * 0.8, h / 2.0 + r * 0.8],
            SCREEN,
        );
        digits(b, [front - t * 0.6, 0.0, h / 2.0], (r * 0.7, r * 0.35), t * 0.6, COOL_BULB);
        return;
    }
    let outline = ngon((r, r), 28);
    b.prism("case", Axis::X, [back, 0.0, h / 2.0], &outline, 2.3 * t, case);
    let face = b.choose(&[
        (WHITE_PAPER, BLACK_PLASTIC),
        (BLACK_PLASTIC, WHITE_PLASTIC),
        (NAVY, SILVER_METAL),
        (CREAM_PAPER, GOLD),
    ]);
    dial(b, [back + 2.25 * t, 0.0, h / 2.0], r * 0.88, t * 0.7, face);
    b.rod("crown", [back + t, r * 0.95, h / 2.0], [back + t, (r * 1.12).min(y), h / 2.0], t * 0.5, case);
}
