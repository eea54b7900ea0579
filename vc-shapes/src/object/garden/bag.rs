//! Garden goods in bags, bottles and packets.

use std::f32::consts::TAU;

use crate::material::*;
use crate::solid::{Axis, Build, P, at_least, polygon, star};

/// A full bag with a label: soil, charcoal, fertiliser.
pub(super) fn bag(b: &mut Build<'_>) {
    at_least(b, [0.03, 0.05, 0.11]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mats, labels): (&[MaterialId], &[MaterialId]) = match b.class {
        "charcoal_bag" => (&[BROWN_SKIN, CARDBOARD, BLACK_PLASTIC, RED_CARD], &[RED, YELLOW, BLACK, ORANGE]),
        "potting_soil" => {
            (&[GREEN_PLASTIC, BROWN_PLASTIC, BLACK_PLASTIC, PURPLE_PLASTIC], &[YELLOW, LIGHT_LEAF, WHITE, ORANGE])
        }
        _ => (&[WHITE_PLASTIC, GREEN_PLASTIC, YELLOW_PLASTIC, BLUE_PLASTIC], &[GREEN, RED, BLUE, ORANGE]),
    };
    let (mat, label, second) = (b.one_of(mats), b.one_of(labels), b.one_of(labels));
    if b.class == "fertilizer" && b.rng.chance(0.4) {
        return bottle(b, (x.min(y), h), mat, label);
    }
    let neck = h * b.vary(0.86, 0.93);
    let (belly, slump) = (h * b.vary(0.25, 0.45), b.vary(0.82, 0.95));
    let ring = |sx: f32, sy: f32, z: f32| {
        [
            [sx, sy * 0.9, z],
            [sx * 0.6, sy, z],
            [-sx * 0.6, sy, z],
            [-sx, sy * 0.9, z],
            [-sx, -sy * 0.9, z],
            [-sx * 0.6, -sy, z],
            [sx * 0.6, -sy, z],
            [sx, -sy * 0.9, z],
        ]
    };
    let body = [
        ring(x * 0.85, y * 0.9, 0.0),
        ring(x, y, belly * 0.5),
        ring(x * 0.97, y * 0.98, belly),
        ring(x * 0.7, y * slump, neck * 0.85),
        ring(x * 0.2, y * slump, neck),
    ]
    .concat();
    b.hull("bag", &body, mat);
    b.block("seam", [-x * 0.08, -y * slump, neck - 0.005], [x * 0.08, y * slump, h], mat);
    // Labels lie on the front, which leans back above the bulge.
    let front = |z: f32| if z < belly { x } else { x - (x * 0.3) * (z - belly) / (neck * 0.85 - belly) };
    for (low, high, wide, mat, out) in
        [(0.3, 0.62, 0.62, label, 0.003), (0.42, 0.52, 0.5, second, 0.005), (0.68, 0.74, 0.45, label, 0.003)]
    {
        let (z0, z1) = (h * low, h * high);
        let points: Vec<P> = [-1.0, 1.0]
            .into_iter()
            .flat_map(|s| [z0, z1].map(|z| (s, z)))
            .flat_map(|(s, z)| [[(front(z) + out).min(x + 0.0009), s * y * wide, z], [front(z) * 0.8, s * y * wide, z]])
            .collect();
        b.hull("label", &points, mat);
    }
}

/// A bottle with a screw cap and a label.
fn bottle(b: &mut Build<'_>, (r, h): (f32, f32), mat: MaterialId, label: MaterialId) {
    let body = r - 0.0008;
    b.lathe(
        "bottle",
        [0.0; 3],
        &[(r * 0.9, 0.0), (body, h * 0.03), (body, h * 0.65), (r * 0.4, h * 0.82), (r * 0.4, h * 0.88)],
        mat,
    );
    b.cylinder("label", [0.0, 0.0, h * 0.15], r, h * 0.4, label);
    b.jointed(vc_graph::asset::JointKind::Hinge, [0.0; 3], [0.0, 0.0, 1.0], (0.0, TAU), |b| {
        b.cylinder("cap", [0.0, 0.0, h * 0.86], r * 0.46, h * 0.14, label)
    });
}

/// A packet of seeds with a flower on its front.
pub(super) fn seed_packet(b: &mut Build<'_>) {
    at_least(b, [0.001, 0.03, 0.05]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let paper = b.choose(&[WHITE_PAPER, CREAM_PAPER, GREEN_CARD, YELLOW_CARD]);
    let petal = b.choose(&[PETAL_RED, PETAL_YELLOW, PETAL_PINK, PETAL_BLUE, RED_SKIN, ORANGE_SKIN]);
    let flap = h * b.vary(0.08, 0.15);
    b.block("packet", [-x * 0.7, -y, 0.0], [0.0, y, h - flap * 0.3], paper);
    let lid = [(-y, h - flap), (-y * 0.8, h), (y * 0.8, h), (y, h - flap)];
    b.prism("flap", Axis::X, [-x, 0.0, 0.0], &lid, x * 0.8, paper);
    b.block("title", [-x * 0.1, -y * 0.8, h * 0.72], [x * 0.4, y * 0.8, h * 0.82], b.style.accent);
    let points = b.rng.count(5, 8);
    let (size, z) = (y * b.vary(0.55, 0.75), h * b.vary(0.36, 0.46));
    b.prism("flower", Axis::X, [-x * 0.1, 0.0, z], &star(points, size, size * 0.4), x * 0.75, petal);
    b.prism("flower", Axis::X, [0.0, 0.0, z], &polygon(10, size * 0.3, 0.0), x, PETAL_YELLOW);
    b.block("stem", [-x * 0.1, -y * 0.04, h * 0.05], [x * 0.3, y * 0.04, z], LEAF);
}
