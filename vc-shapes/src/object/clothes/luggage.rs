//! Rucksacks, suitcases and briefcases.

use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, arc, blocks, half_dims, loft, oval, spline, tube};

/// A rucksack: main bag with a lid, a front pocket, two side pockets, straps at the back.
pub(super) fn backpack(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let (cloth, trim) = b.choose(&[
        (NAVY_FABRIC, BROWN_LEATHER),
        (GREY_FABRIC, BLACK_FABRIC),
        (RED_FABRIC, BLACK_FABRIC),
        (OLIVE_FABRIC, BROWN_LEATHER),
        (TEAL_FABRIC, MUSTARD_FABRIC),
        (BLACK_FABRIC, GREY_FABRIC),
        (MUSTARD_FABRIC, NAVY_FABRIC),
        (PURPLE_FABRIC, ROSE_FABRIC),
    ]);
    let (back, front) = (-x + x * 0.24, x - x * 0.42);
    let (w, t, rim) = (y * 0.86, 0.003_f32.min(x * 0.04), h * 0.84);
    let at = f32::midpoint(back, front);
    let half = (front - back) / 2.0;
    let ring = |z: f32, s: f32, t: f32| oval(Axis::Z, [at, 0.0, z], (half * s - t, w * s - t), 2, 24);
    loft(
        b,
        "bag",
        &[
            ring(0.0, 0.94, 0.0),
            ring(h * 0.05, 1.0, 0.0),
            ring(rim, 0.96, 0.0),
            ring(rim, 0.96, t),
            ring(2.0 * t, 0.94, t),
        ],
        cloth,
    );
    b.inside("compartment", [at, 0.0, 2.0 * t], (half * 0.8, w * 0.85), rim - 2.0 * t);
    let pocket = (front - t, x, h * 0.1, h * b.vary(0.42, 0.52));
    b.rounded_block("pocket", [pocket.0, -w * 0.75, pocket.2], [pocket.1, w * 0.75, pocket.3], x * 0.15, cloth);
    b.block(
        "zip",
        [pocket.1 - x * 0.2, -w * 0.68, pocket.3 - h * 0.05],
        [pocket.1 + 0.0006, w * 0.68, pocket.3 - h * 0.035],
        trim,
    );
    for s in [-1.0_f32, 1.0] {
        let (a, c) = (s * w * 0.9, s * y);
        b.rounded_block(
            "side_pocket",
            [at - half * 0.7, a.min(c), h * 0.04],
            [at + half * 0.7, a.max(c), h * 0.32],
            x * 0.08,
            trim,
        );
    }
    let grip = h * 0.05;
    b.hinge([back, 0.0, rim], [0.0, -1.0, 0.0], 2.2, |b| {
        let lid = |z: f32, s: f32| oval(Axis::Z, [at, 0.0, z], (half * s, w * s), 2, 24);
        loft(b, "lid", &[lid(rim + h * 0.002, 1.0), lid(rim + h * 0.05, 1.0), lid(h - grip, 0.75)], cloth);
        let straps = [-0.4, 0.4].map(|s| {
            (
                [front - half * 0.05, w * s - w * 0.06, rim - h * 0.14],
                [front + x * 0.04, w * s + w * 0.06, rim + h * 0.04],
            )
        });
        blocks(b, "strap", &straps, trim);
        let r = (x * 0.05).min(grip * 0.3);
        let carry = arc(
            Axis::X,
            [back + half * 0.3, 0.0, h - grip * 1.2],
            (w * 0.25, grip * 1.2 - r),
            (0.0, std::f32::consts::PI),
            8,
        );
        tube(b, "handle", &carry, r, trim);
    });
    let mut straps = MeshBuilder::default();
    for s in [-1.0, 1.0] {
        let py = s * w * 0.45;
        let line = [
            [back + t, py * 0.6, rim * 0.97],
            [-x + x * 0.1, py * 0.9, rim * 0.82],
            [-x + x * 0.09, py * 1.2, h * 0.45],
            [back + t, py * 1.5, h * 0.08],
        ];
        straps.tapered(&spline(&line, 4), |t| x * (0.06 - 0.025 * t));
    }
    straps.put(b, "strap", trim);
}

/// A suitcase on wheels: two shells that open at the side, ribs, an extended handle.
pub(super) fn suitcase(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let shell =
        b.choose(&[NAVY, RED_PLASTIC, GREY_PLASTIC, BLACK_PLASTIC, TEAL_FABRIC, DUSTY_ROSE, MUSTARD, SILVER_METAL]);
    let wheel = (h * 0.06).min(x * 0.25);
    let (grip, t) = (h * 0.09, 0.004_f32.min(x * 0.05));
    let (low, top) = (wheel * 1.3, h - grip);
    let rib = (x * 0.04).min(0.006);
    let seam = 0.0;
    let half = |b: &mut Build<'_>, from: f32, to: f32, name: &str| {
        let face = if from.abs() > to.abs() { from } else { to };
        let inner = if face < 0.0 { face + t } else { face - t };
        let (in_y, in_z) = (t * 0.3, t * 0.3);
        b.block(name, [face.min(inner), -y + in_y, low + in_z], [face.max(inner), y - in_y, top - in_z], shell);
        let (a, c) = (from.min(to), from.max(to));
        let walls = [
            ([a, -y, low], [c, y, low + t]),
            ([a, -y, top - t], [c, y, top]),
            ([a, -y, low + t * 0.9], [c, -y + t, top - t * 0.9]),
            ([a, y - t, low + t * 0.9], [c, y, top - t * 0.9]),
        ];
        let trimmed: Vec<(P, P)> = walls
            .iter()
            .map(|(l, h)| ([l[0].max(-x + rib + t * 0.9), l[1], l[2]], [h[0].min(x - rib - t * 0.9), h[1], h[2]]))
            .collect();
        blocks(b, name, &trimmed, shell);
        for i in 0..5 {
            let py = y * (-0.72 + 0.36 * i as f32);
            let (r0, r1) = if face < 0.0 { (face - rib, face + t * 0.5) } else { (face - t * 0.5, face + rib) };
            b.block(
                "rib",
                [r0, py - y * 0.06, low + (top - low) * 0.06],
                [r1, py + y * 0.06, top - (top - low) * 0.06],
                shell,
            );
        }
    };
    half(b, -x + rib, seam - 0.0006, "shell");
    b.inside(
        "compartment",
        [-x * 0.5 + rib * 0.5, 0.0, low + t],
        ((x - rib) * 0.5 - 2.0 * t, y - 2.0 * t),
        top - low - 2.0 * t,
    );
    b.hinge([seam, y, low], [0.0, 0.0, 1.0], 2.6, |b| {
        half(b, seam + 0.0006, x - rib, "lid");
        b.block(
            "lock",
            [seam, -y - 0.0006, (low + top) * 0.5 - h * 0.03],
            [x * 0.3, -y + t * 0.5, (low + top) * 0.5 + h * 0.03],
            STEEL,
        );
    });
    let mut wheels = MeshBuilder::default();
    let mut forks = MeshBuilder::default();
    for (sx, sy) in [(-0.6, -0.8), (-0.6, 0.8), (0.6, -0.8), (0.6, 0.8)] {
        let (px, py) = (x * sx, y * sy);
        wheels.loft(
            &[-0.3, 0.3].map(|o| oval(Axis::Y, [px, py + wheel * o, wheel * 0.5], (wheel * 0.5, wheel * 0.5), 0, 12)),
        );
        forks.block(
            [px - wheel * 0.4, py - wheel * 0.4, wheel * 0.7],
            [px + wheel * 0.4, py + wheel * 0.4, low + t * 0.5],
        );
    }
    wheels.put(b, "wheel", RUBBER);
    forks.put(b, "fork", BLACK_PLASTIC);
    let r = (x * 0.05).min(grip * 0.2);
    let pull = [
        [-x * 0.6, -y * 0.35, top - t * 0.6],
        [-x * 0.6, -y * 0.35, h - r],
        [-x * 0.6, y * 0.35, h - r],
        [-x * 0.6, y * 0.35, top - t * 0.6],
    ];
    tube(b, "handle", &pull, r, STEEL);
    let carry = arc(Axis::X, [x * 0.25, 0.0, top - t], (y * 0.25, grip * 0.5), (0.0, std::f32::consts::PI), 8);
    b.hinge([seam, y, low], [0.0, 0.0, 1.0], 2.6, |b| tube(b, "grip", &carry, r, BLACK_PLASTIC));
}

/// An upright briefcase with a lid that opens towards the front and a handle on top.
pub(super) fn briefcase(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let leather = b.choose(&[BROWN_LEATHER, BLACK_LEATHER, TAN_LEATHER, SILVER_METAL]);
    let t = 0.004_f32.min(x * 0.08);
    let top = h * 0.86;
    let walls = [
        ([-x, -y, 0.0], [-x + t, y, top]),
        ([-x + t * 0.9, -y, 0.0], [x * 0.4, y, t]),
        ([-x + t * 0.9, -y, t * 0.9], [x * 0.4, -y + t, top]),
        ([-x + t * 0.9, y - t, t * 0.9], [x * 0.4, y, top]),
        ([-x + t * 0.9, -y + t * 0.9, top - t], [x * 0.4, y - t * 0.9, top - h * 0.002]),
    ];
    blocks(b, "case", &walls, leather);
    b.inside("compartment", [-x * 0.3, 0.0, t], (x * 0.7 - 2.0 * t, y - 2.0 * t), top - 2.5 * t);
    b.hinge([x * 0.4, 0.0, 0.0], [0.0, 1.0, 0.0], 1.5, |b| {
        b.rounded_block("lid", [x * 0.4 + h * 0.002, -y, 0.0], [x * 0.95, y, top], t, leather);
        let locks = [-0.6, 0.6].map(|s| ([x * 0.5, y * s - y * 0.05, top * 0.88], [x, y * s + y * 0.05, top * 0.97]));
        blocks(b, "lock", &locks, BRASS);
        b.block("seam", [x * 0.6, -y * 0.95, top * 0.6], [x * 0.95 + h * 0.002, y * 0.95, top * 0.62], BLACK_LEATHER);
    });
    let r = (h * 0.03).min(x * 0.3);
    let grip = [
        [-x * 0.2, -y * 0.25, top - t],
        [-x * 0.2, -y * 0.18, h - r * 1.9],
        [-x * 0.2, y * 0.18, h - r * 1.9],
        [-x * 0.2, y * 0.25, top - t],
    ];
    tube(b, "handle", &spline(&grip, 3), r, leather);
}
