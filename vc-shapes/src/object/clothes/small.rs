//! Small clothes: scarves, socks, underwear, ties, belts, gloves, and a heap.

use std::f32::consts::TAU;

use vc_graph::portable::Portable;

use super::super::textile::{Fold, folded};
use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, arc, blocks, facing, half_dims, hoop, oval, spline, tube};

const COLOURS: [MaterialId; 10] = [
    RED_FABRIC,
    NAVY_FABRIC,
    MUSTARD_FABRIC,
    WHITE_COTTON,
    GREY_FABRIC,
    TEAL_FABRIC,
    BLACK_FABRIC,
    ROSE_FABRIC,
    GREEN_FABRIC,
    PURPLE_FABRIC,
];

/// A folded scarf with stripes and a fringe.
pub(super) fn scarf(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let (cloth, trim) = (b.choose(&COLOURS), b.choose(&COLOURS));
    let fringe = x * 0.2;
    let layers = b.rng.count(2, 4);
    folded(b, "scarf", Fold { low: [-x + fringe, -y, 0.0], high: [x, y, h - 0.001], layers, soft: 0.6 }, cloth);
    let thick = h / layers as f32;
    let (z0, z1) = (h - thick * 0.6, h - thick * 0.35);
    let strands: Vec<(P, P)> = (0..14)
        .map(|i| y * (-0.95 + 0.138 * i as f32))
        .map(|a| ([-x, a, z0], [-x + fringe * 1.4, a + y * 0.07, z1]))
        .collect();
    blocks(b, "fringe", &strands, cloth);
    let stripes = [-0.45, -0.2, 0.05].map(|a| ([x * a, -y * 0.9, h - thick * 0.3], [x * (a + 0.12), y * 0.9, h]));
    blocks(b, "stripe", &stripes, trim);
}

/// A pair of socks laid on each other, with cuff, heel and toe in a second colour.
pub(super) fn socks(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let (cloth, trim) = (b.choose(&COLOURS), b.choose(&COLOURS));
    // Samples along the sock: position along it, centre across, half width.
    let shape = [
        (-1.0, -0.12, 0.72),
        (-0.92, -0.12, 0.8),
        (-0.25, -0.12, 0.78),
        (0.0, -0.08, 0.86),
        (0.15, 0.0, 0.99),
        (0.3, 0.04, 0.86),
        (0.45, 0.08, 0.74),
        (0.8, 0.1, 0.72),
        (0.94, 0.1, 0.56),
        (1.0, 0.1, 0.2),
    ];
    for i in 0..2 {
        let (low, high) = (h * 0.5 * i as f32, h * (0.5 * i as f32 + 0.49));
        let slip = y * 0.05 * i as f32;
        let ring = |k: usize, grow: f32| {
            let (t, mid, wide): (f32, f32, f32) = shape[k];
            let along = if grow < 1.0 { 0.92 } else { 0.95 };
            let at = [-x * mid, (y * t * along + slip).min(y), f32::midpoint(low, high)];
            oval(Axis::Y, at, ((x * wide).min(x - (x * mid).abs()) * grow, (high - low) / 2.0 * grow), 1, 12)
        };
        let all: Vec<Vec<P>> = (0..shape.len()).map(|k| ring(k, 0.94)).collect();
        let mut sock = MeshBuilder::default();
        sock.loft(&all);
        sock.put(b, "sock", cloth);
        let mut bands = MeshBuilder::default();
        bands.loft(&[ring(0, 1.0), ring(1, 1.0)]);
        bands.loft(&[ring(3, 1.0), ring(4, 1.0), ring(5, 1.0)]);
        bands.loft(&[ring(7, 1.0), ring(8, 1.0), ring(9, 1.0)]);
        bands.put(b, "cuff", trim);
    }
}

/// Briefs or trunks; a one-piece if the size is high.
pub(super) fn briefs(b: &mut Build<'_>) {
    facing(b, |b, t, w, h| {
        let (cloth, trim) = (b.choose(&COLOURS), b.choose(&COLOURS));
        let (x, y) = (t / 2.0, w / 2.0);
        let outline: Vec<(f32, f32)> = if h > 1.3 * w {
            [
                (-0.15, 0.0),
                (0.15, 0.0),
                (0.95, 0.22),
                (0.7, 0.5),
                (0.9, 0.72),
                (0.6, 0.98),
                (0.45, 1.0),
                (0.3, 0.75),
                (-0.3, 0.75),
                (-0.45, 1.0),
                (-0.6, 0.98),
                (-0.9, 0.72),
                (-0.7, 0.5),
                (-0.95, 0.22),
            ]
            .to_vec()
        } else if b.rng.chance(0.5) {
            vec![(-0.15, 0.0), (0.15, 0.0), (1.0, 0.6), (0.95, 1.0), (-0.95, 1.0), (-1.0, 0.6)]
        } else {
            vec![(-1.0, 0.0), (-0.1, 0.0), (0.0, 0.25), (0.1, 0.0), (1.0, 0.0), (0.85, 1.0), (-0.85, 1.0)]
        };
        let points: Vec<(f32, f32)> = outline.iter().map(|&(a, z)| (a * y, z * h * 0.995)).collect();
        b.prism("cloth", Axis::X, [-x * 0.8, 0.0, 0.0], &points, x * 1.6, cloth);
        if h <= 1.3 * w {
            b.block("band", [-x, -y * 0.86, h * 0.88], [x, y * 0.86, h], trim);
        } else {
            b.block("stripe", [-x, -y * 0.68, h * 0.46], [x, y * 0.68, h * 0.52], trim);
        }
    });
}

/// A brassiere: two cups, band and straps.
pub(super) fn bra(b: &mut Build<'_>) {
    facing(b, |b, t, w, h| {
        let cloth = b.choose(&[BLACK_FABRIC, WHITE_COTTON, ROSE_FABRIC, RED_FABRIC]);
        let (x, y) = (t / 2.0, w / 2.0);
        let mut cups = MeshBuilder::default();
        for side in [-1.0, 1.0] {
            cups.egg([0.0, side * y * 0.42, h * 0.36], [x, y * 0.4, h * 0.36]);
            let r = (y * 0.03).min(x * 0.2);
            cups.tube(
                &spline(
                    &[
                        [x * 0.3, side * y * 0.5, h * 0.65],
                        [0.0, side * y * 0.45, h - r],
                        [-x + r, side * y * 0.4, h * 0.4],
                    ],
                    4,
                ),
                r,
            );
        }
        cups.put(b, "cup", cloth);
        let band: Vec<P> = arc(Axis::Z, [0.0, 0.0, h * 0.15], (x * 0.9, y * 0.97), (1.2, 5.08), 14);
        tube(b, "band", &band, (x * 0.1).min(h * 0.06), cloth);
    });
}

/// A knotted tie: loop, knot and blade.
pub(super) fn tie(b: &mut Build<'_>) {
    facing(b, |b, t, w, h| {
        let (cloth, trim) = (
            b.choose(&[NAVY_FABRIC, RED_FABRIC, BLACK_FABRIC, PURPLE_FABRIC, GREEN_FABRIC]),
            b.choose(&[WHITE_COTTON, MUSTARD_FABRIC, GREY_FABRIC]),
        );
        let (x, y) = (t / 2.0, w / 2.0);
        let r = (x * 0.8).min(y * 0.2);
        let knot = h * 0.72;
        let ring = oval(Axis::X, [0.0, 0.0, f32::midpoint(knot, h)], (y - r, (h - knot) / 2.0 - r), 0, 24);
        hoop(b, "loop", &ring, r, cloth);
        let blade = [(0.0, 0.0), (y, h * 0.04), (y * 0.35, knot), (-y * 0.35, knot), (-y, h * 0.04)];
        b.prism("blade", Axis::X, [-x * 0.4, 0.0, 0.0], &blade, x * 0.9, cloth);
        b.taper("knot", [0.0, 0.0, knot - h * 0.01], (x * 0.8, y * 0.32), (x, y * 0.5), h * 0.035, cloth);
        for i in 0..7 {
            let z = h * (0.06 + 0.085 * i as f32);
            let half = y * (0.85 - 0.55 * z / knot);
            b.prism(
                "stripe",
                Axis::X,
                [0.0, 0.0, z],
                &[(-half, 0.0), (half, h * 0.03), (half, h * 0.045), (-half, h * 0.015)],
                x * 0.7,
                trim,
            );
        }
    });
}

/// A rolled-up belt with its buckle outside.
pub(super) fn belt(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let leather = b.choose(&[BROWN_LEATHER, BLACK_LEATHER, TAN_LEATHER]);
    let wide = y.min(h / 2.0);
    let buckle = wide * 0.08;
    let turns = 3.2;
    let point = |i: usize, inset: f32| {
        let turn = turns * i as f32 / 54.0;
        let (s, c) = (turn * TAU).sine_cosine();
        let r = (wide - buckle) * (1.0 - 0.2 * turn) - inset;
        (r * c * (y - buckle) / (wide - buckle), h / 2.0 + r * s * (h / 2.0 - buckle) / (wide - buckle))
    };
    let thin = wide * 0.07;
    let spiral: Vec<(f32, f32)> = (0..54).map(|i| point(i, 0.0)).chain((0..54).rev().map(|i| point(i, thin))).collect();
    b.prism("strap", Axis::X, [-x * 0.85, 0.0, 0.0], &spiral, x * 1.7, leather);
    let metal = b.choose(&[BRASS, STEEL]);
    let at = [(x, h * 0.42), (-x, h * 0.42), (-x, h * 0.75), (x, h * 0.75)];
    let r = buckle * 0.5;
    let frame: Vec<P> = at.iter().map(|&(a, z)| [a - r * a.signum(), y - r, z]).collect();
    hoop(b, "buckle", &frame, r, metal);
}

/// A pair of gloves, one in front of the other.
pub(super) fn gloves(b: &mut Build<'_>) {
    facing(b, |b, t, w, h| {
        let cloth = b.choose(&[BLACK_LEATHER, BROWN_LEATHER, GREY_FABRIC, RED_FABRIC, NAVY_FABRIC]);
        let cuff = b.choose(&[cloth, WHITE_COTTON, BLACK_FABRIC]);
        let mut hands = MeshBuilder::default();
        for (i, side) in [(0, 1.0_f32), (1, -1.0)] {
            let px = t * (0.25 - 0.5 * i as f32);
            let deep = t * 0.24;
            let ring = |z: f32, a: f32| oval(Axis::Z, [px, 0.0, h * z], (deep, w * a), 0, 12);
            hands.loft(&[ring(0.02, 0.36), ring(0.25, 0.3), ring(0.45, 0.36), ring(0.6, 0.37), ring(0.66, 0.3)]);
            let r = deep.min(w * 0.09);
            for (k, top) in [0.9, 0.99, 0.97, 0.86].into_iter().enumerate() {
                let py = side * w * (-0.27 + 0.18 * k as f32);
                hands.tapered(&[[px, py * 0.9, h * 0.55], [px, py, h * (top - 0.06)], [px, py, h * top]], |t| {
                    r * if t > 0.9 { 0.5 } else { 1.0 }
                });
            }
            let thumb = -side * w * (0.5 - 0.09);
            hands
                .tapered(&[[px, -side * w * 0.2, h * 0.35], [px, thumb * 0.95, h * 0.5], [px, thumb, h * 0.66]], |t| {
                    r * (1.0 - 0.3 * t)
                });
            b.block("cuff", [px - deep, -w * 0.37, 0.0], [px + deep, w * 0.37, h * 0.1], cuff);
        }
        hands.put(b, "hand", cloth);
    });
}

/// A heap of clothes.
pub(super) fn pile(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let count = b.rng.count(4, 6);
    for i in 0..count {
        let cloth = b.choose(&COLOURS);
        let level = i as f32 / count as f32;
        let reach = 1.0 - 0.55 * level;
        let (px, py) = (x * b.vary(-0.3, 0.3) * level.min(0.8), y * b.vary(-0.3, 0.3) * level.min(0.8));
        let (dx, dy) = ((x - px.abs()) * reach, (y - py.abs()) * reach);
        let (z0, z1) = (h * level * 0.75, (h * (level * 0.75 + 0.36)).min(h));
        let (p, q) = (b.vary(0.0, 6.0), b.vary(0.0, 6.0));
        let mut shell = MeshBuilder::default();
        shell.sheet((7, 10), |u, v| {
            let (a, r) = (TAU * v, u);
            let wobble = 0.86 + 0.14 * (3.0 * a + p).sine();
            let at = [px + dx * r * a.cosine() * wobble, py + dy * r * a.sine() * wobble];
            let crumple = 0.7 + 0.3 * (7.0 * a + 9.0 * r + q).sine() * r;
            let z = z0 + (z1 - z0) * (1.0 - r * r).max(0.0).sqrt() * crumple;
            ([at[0], at[1], z.max(z0)], [at[0], at[1], z0])
        });
        shell.put(b, "garment", cloth);
    }
    let cloth = b.choose(&COLOURS);
    let r = h * 0.09;
    let arm = [[x * 0.3, -y * 0.2, h * 0.5], [x * 0.6, -y * 0.5, h * 0.35], [x * 0.8, -y * 0.6, r]];
    tube(b, "sleeve", &spline(&arm, 4), r, cloth);
}
