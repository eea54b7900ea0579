//! Fountains and ponds.

use std::f32::consts::TAU;

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Axis, Build, P, at_least, blob, limb, polar, tapered_tub};

/// A fountain: bowls on a column in a basin, or a basin with a spout.
pub(super) fn fountain(b: &mut Build<'_>) {
    at_least(b, [0.25, 0.25, 0.3]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let mat = b.choose(&[SANDSTONE, MARBLE, GRANITE, CONCRETE, POTTERY]);
    let rim = (h * b.vary(0.16, 0.28)).min(r * 0.6);
    let t = r * b.vary(0.08, 0.13);
    let sides = b.rng.below(3);
    if sides == 0 {
        tapered_tub(b, "basin", [0.0; 3], (r, r), (r, r), rim, t, mat);
    } else {
        let inner = r - t;
        b.lathe(
            "basin",
            [0.0; 3],
            &[
                (r * 0.95, 0.0),
                (r * 0.93, rim * 0.8),
                (r, rim * 0.85),
                (r, rim),
                (inner, rim),
                (inner, t * 0.6),
                (0.0, t * 0.6),
            ],
            mat,
        );
    }
    let level = rim * 0.8;
    b.cylinder("water", [0.0, 0.0, t * 0.4], r - t - 0.002 + 0.004, level - t * 0.4, WATER);
    let bowls = b.rng.count(1, 3);
    let column = r * b.vary(0.12, 0.18);
    let top = h * 0.93;
    b.lathe(
        "column",
        [0.0; 3],
        &[
            (column * 1.6, t * 0.3),
            (column * 1.6, level + 0.02),
            (column, level + 0.05_f32.min(h * 0.05)),
            (column * 0.7, top),
        ],
        mat,
    );
    for i in 0..bowls {
        let z = level + (top - level) * (i as f32 + 1.0) / bowls as f32;
        let wide = r * 0.62 * (1.0 - 0.28 * i as f32);
        let deep = (wide * 0.35).min((top - level) / bowls as f32 * 0.5);
        b.lathe(
            "bowl",
            [0.0, 0.0, z - deep],
            &[
                (column * 0.8, 0.0),
                (wide * 0.75, deep * 0.5),
                (wide, deep),
                (wide * 0.92, deep),
                (wide * 0.7, deep * 0.6),
                (0.0, deep * 0.55),
            ],
            mat,
        );
        b.lathe("water", [0.0, 0.0, z - deep], &[(wide * 0.68, deep * 0.57), (wide * 0.86, deep * 0.88)], WATER);
        let drops = 4;
        for k in 0..drops {
            let (px, py) = polar(TAU * (k as f32 + 0.5 * i as f32) / drops as f32, wide * 0.97);
            b.cylinder(
                "jet",
                [px, py, if i == 0 { level - 0.01 } else { z - deep * 1.2 - (top - level) / bowls as f32 * 0.6 }],
                r * 0.012 + 0.002,
                if i == 0 { z - level } else { (top - level) / bowls as f32 * 0.6 + deep * 1.1 },
                WATER,
            );
        }
    }
    b.lathe(
        "finial",
        [0.0, 0.0, top - 0.01],
        &[(column * 0.5, 0.0), (column * 0.8, (h - top) * 0.4), (column * 0.3, (h - top) * 0.9), (0.0, h - top + 0.01)],
        mat,
    );
    let inner = r - t;
    let (from, to) = ((column * 1.6).max(r * 0.64), inner * 0.97);
    b.inside(
        "basin",
        [f32::midpoint(from, to), 0.0, level],
        ((to - from) / 2.0 - 0.005, (inner * 0.2).max(0.005)),
        rim - level + 0.02,
    );
}

/// A pond: stones around water of an irregular outline, with lilies.
pub(super) fn pond(b: &mut Build<'_>) {
    at_least(b, [0.6, 0.75, 0.15]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let stones = b.rng.count(18, 30);
    let stone = b.choose(&[ROCK, GRANITE, SANDSTONE, GRAVEL]);
    let rim = x.min(y) * b.vary(0.12, 0.18);
    let (bank, level) = (h * 0.35, h * 0.45);
    let waves = (b.vary(0.0, TAU), b.vary(0.03, 0.12));
    let reach = |a: f32| 1.0 - waves.1 * (1.0 + (2.0 * a + waves.0).cosine());
    let outline = |inset: f32, n: usize| -> Vec<(f32, f32)> {
        (0..n)
            .map(|i| TAU * i as f32 / n as f32)
            .map(|a| ((x - inset) * reach(a) * a.cosine(), (y - inset) * reach(a) * a.sine()))
            .collect()
    };
    b.prism("ground", Axis::Z, [0.0; 3], &outline(rim * 0.5, 28), bank, SOIL);
    b.prism("water", Axis::Z, [0.0, 0.0, bank * 0.5], &outline(rim * 1.2, 28), level - bank * 0.5, POOL_WATER);
    let tallest = b.rng.below(stones);
    for i in 0..stones {
        let a = TAU * i as f32 / stones as f32;
        let r = rim * b.vary(0.75, 1.0);
        let tall = if i == tallest { h } else { (level + h * b.vary(0.08, 0.3)).min(h) };
        let (cx, cy) = ((x - rim) * reach(a) * a.cosine(), (y - rim) * reach(a) * a.sine());
        let mut points = blob(b, [cx, cy, tall * 0.45], [r, r, tall * 0.55], 16, 0.2);
        points.push([cx, cy, tall]);
        points.iter_mut().for_each(|p| *p = [p[0].max(-x).min(x), p[1].max(-y).min(y), p[2].max(0.0).min(tall)]);
        b.hull("stone", &points, stone);
    }
    for _ in 0..b.rng.count(2, 5) {
        let (a, d) = (b.vary(0.5, 2.6), b.vary(0.45, 0.6));
        let (cx, cy, r) = (x * d * a.cosine(), y * d * a.sine(), rim * b.vary(0.4, 0.7));
        b.cylinder("lily", [cx, cy, level - 0.004], r, 0.009, LEAF);
        let points = blob(b, [cx, cy, level + r * 0.2], [r * 0.35, r * 0.35, r * 0.25], 14, 0.3);
        b.hull("flower", &points, PETAL_PINK);
    }
    let reeds = b.rng.count(4, 9);
    for i in 0..reeds {
        let a = 1.3 + 0.06 * i as f32;
        let at = [(x - rim * 1.6) * reach(a) * a.cosine(), (y - rim * 1.6) * reach(a) * a.sine(), bank];
        let tip = [at[0] + b.vary(-0.05, 0.05), at[1], h * b.vary(0.85, 1.0)];
        b.hull(
            "reed",
            &limb(at, tip, 0.012, 0.004).into_iter().map(|p| [p[0], p[1], p[2].min(h)]).collect::<Vec<P>>(),
            GRASS,
        );
    }
    let room = (x.min(y) - rim * 2.0) * 0.4;
    b.inside("basin", [0.0, -y * 0.25, level], (room.max(0.02), room.max(0.02)), 0.3_f32.min(h - level + 0.2));
}
