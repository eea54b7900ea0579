//! Utensils for stirring, turning and pressing: long ones lie along Y with the grip at the low end.

use std::f32::consts::PI;

use vc_graph::portable::Portable;

use super::cutlery::scoop;
use crate::material::*;
use crate::solid::{Axis, Build, P, dims, flat_ring, planar_tube, sweep, vessel_profile};

pub(super) const ACROSS: P = [1.0, 0.0, 0.0];

/// Materials of grips.
pub(super) fn grip_mat(b: &mut Build<'_>) -> MaterialId {
    b.choose(&[BLACK_PLASTIC, BLACK_PLASTIC, STEEL, BEECH, RED_PLASTIC, GREY_PLASTIC, GREEN_PLASTIC])
}

/// A grip along Y from its butt at `from` to its end, thickest near the butt.
pub(super) fn grip(b: &mut Build<'_>, from: P, to: P, half: (f32, f32), mat: MaterialId) {
    let at = |k: f32| [0, 1, 2].map(|i| from[i] + (to[i] - from[i]) * k);
    let (w, t) = half;
    let path = [
        (at(0.0), w * 0.5, t * 0.5),
        (at(0.04), w * 0.9, t * 0.9),
        (at(0.3), w, t),
        (at(0.7), w * 0.75, t * 0.8),
        (at(1.0), w * 0.6, t * 0.6),
    ];
    sweep(b, "grip", &path, ACROSS, mat);
}

/// A spoon carved from one piece of wood.
pub(super) fn wooden_spoon(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.choose(&[BEECH, OAK, BAMBOO, CHERRY, MAPLE]);
    let length = (x * b.vary(1.3, 1.6)).min(y * 0.35);
    let r = (z * 0.3).min(x * 0.15);
    scoop(b, [0.0, y / 2.0 - length / 2.0, 0.0], (x / 2.0, length / 2.0), z * 0.75, z * 0.2, mat);
    let head = y / 2.0 - length * 0.95;
    grip(b, [0.0, -y / 2.0, r], [0.0, head, z * 0.6], (r * 1.2, r), mat);
}

/// A broad blade, slotted or of rubber, on a long grip.
pub(super) fn spatula(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let soft = b.class == "rubber_spatula";
    let mat = if soft {
        b.choose(&[RED_RUBBER, GREY_RUBBER, WHITE_PLASTIC, BLUE_PLASTIC])
    } else {
        b.choose(&[BLACK_PLASTIC, STEEL, BEECH])
    };
    let handle = grip_mat(b);
    let length = y * b.vary(0.26, 0.34);
    let t = (z * if soft { 0.35 } else { 0.1 }).min(0.006);
    let (root, tip, hx) = (y / 2.0 - length, y / 2.0, x / 2.0);
    if soft {
        let blade = [(-hx, 0.0), (hx, 0.0), (hx, length * 0.75), (hx * 0.5, length), (-hx, length)];
        b.prism("blade", Axis::Z, [0.0, root, z / 2.0 - t / 2.0], &blade, t, mat);
    } else {
        // Four bars between the ends leave three slots.
        for k in [-0.84, -0.29, 0.29, 0.84] {
            b.block(
                "blade",
                [hx * k - hx * 0.14, root + length * 0.2, 0.0],
                [hx * k + hx * 0.14, tip - length * 0.15, t],
                mat,
            );
        }
        b.block("blade", [-hx, tip - length * 0.2, t * 0.25], [hx, tip, t * 0.75], mat);
        let fan = [(-hx * 0.2, 0.0), (hx * 0.2, 0.0), (hx, length * 0.25), (-hx, length * 0.25)];
        b.prism("blade", Axis::Z, [0.0, root, t * 0.15], &fan, t * 0.65, mat);
    }
    let r = (z * 0.28).min(0.008);
    let lift = if soft { z / 2.0 } else { z - r };
    let neck = r * 0.45;
    planar_tube(
        b,
        "neck",
        &[
            [0.0, root + length * 0.1, z.min(t * 2.0) * 0.5],
            [0.0, root - y * 0.04, lift * 0.6],
            [0.0, root - y * 0.2, lift],
        ],
        neck,
        ACROSS,
        if soft { handle } else { mat },
    );
    grip(b, [0.0, -y / 2.0, lift.min(z - r)], [0.0, root - y * 0.15, lift], (r * 1.4, r), handle);
}

/// Ladles and skimmers: a round head, either deep or flat with holes.
pub(super) fn ladle(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (mat, handle) = (b.choose(&[STEEL, STEEL, BLACK_PLASTIC]), b.choose(&[STEEL, BLACK_PLASTIC, BEECH]));
    let r = x / 2.0;
    let centre = y / 2.0 - r;
    let neck = (z * 0.1).min(0.005);
    if b.class == "ladle" {
        let depth = z * b.vary(0.5, 0.65);
        let outside: Vec<_> =
            [(0.35, 0.0), (0.7, 0.18), (0.92, 0.5), (1.0, 1.0)].iter().map(|p| (p.0 * r, p.1 * depth)).collect();
        b.lathe("bowl", [0.0, centre, 0.0], &vessel_profile(&outside, (r * 0.05).min(0.002)), mat);
        b.inside("inside", [0.0, centre, r * 0.05], (r * 0.2, r * 0.2), depth * 0.9);
        let path =
            [[0.0, centre - r * 0.95, depth * 0.8], [0.0, centre - r * 1.2, depth], [0.0, -y * 0.1, z - neck * 2.0]];
        planar_tube(b, "neck", &path, neck, ACROSS, mat);
        grip(b, [0.0, -y / 2.0, z - neck * 2.0], [0.0, -y * 0.05, z - neck * 2.0], (neck * 2.2, neck * 1.8), handle);
    } else {
        let t = (z * 0.1).min(0.002);
        let rim = z * 0.3;
        hoop_at(b, [0.0, centre, 0.0], (t, rim), (r * 0.9, r), mat);
        for i in 0..9 {
            let at = r * 0.92 * (i as f32 / 4.0 - 1.0);
            let reach = ((r * 0.925).raised(2) - at * at).max(0.0).sqrt().max(r * 0.1);
            b.block("wire", [at - r * 0.05, centre - reach, t * 0.5], [at + r * 0.05, centre + reach, t * 1.5], mat);
            b.block(
                "wire",
                [-reach * 0.98, centre + at - r * 0.03, 0.0],
                [reach * 0.98, centre + at + r * 0.03, t],
                mat,
            );
        }
        planar_tube(b, "neck", &[[0.0, centre - r * 0.95, rim * 0.6], [0.0, -y * 0.1, z - neck]], neck, ACROSS, mat);
        grip(b, [0.0, -y / 2.0, z - neck], [0.0, -y * 0.05, z - neck], (neck * 1.8, neck), handle);
    }
}

pub(super) fn hoop_at(b: &mut Build<'_>, base: P, z: (f32, f32), r: (f32, f32), mat: MaterialId) {
    b.at(base, 0.0, |b| flat_ring(b, "rim", z, r, mat));
}

/// A whisk: wire loops on a grip.
pub(super) fn whisk(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let handle = grip_mat(b);
    let r = x.min(z) / 2.0;
    let w = (r * 0.05).min(0.0012);
    let (root, tip) = (0.0, y / 2.0);
    let mid = z / 2.0;
    for i in 0..4 {
        let (s, c) = (PI * i as f32 / 4.0).sine_cosine();
        let at =
            |side: f32, out: f32, k: f32| [side * out * r * c, root + (tip - root - w) * k, mid + side * out * r * s];
        let half = [(0.1, 0.0), (0.55, 0.25), (0.97 - 2.0 * w / r, 0.62), (0.75, 0.9), (0.3, 0.99)];
        let points: Vec<P> = half
            .iter()
            .map(|p| at(1.0, p.0, p.1))
            .chain([at(0.0, 0.0, 1.0)])
            .chain(half.iter().rev().map(|p| at(-1.0, p.0, p.1)))
            .collect();
        thin_wire(b, &points, w, [-s, 0.0, c]);
    }
    let t = (r * 0.4).min(mid);
    grip(b, [0.0, -y / 2.0, mid], [0.0, root + y * 0.02, mid], (t * 0.9, t * 0.9), handle);
}

/// A wire of square section through points of a plane.
pub(super) fn thin_wire(b: &mut Build<'_>, points: &[P], w: f32, side: P) {
    let path: Vec<_> = points.iter().map(|&p| (p, w, w)).collect();
    sweep(b, "wire", &path, side, STEEL);
}

/// Tongs: two arms joined at one end.
pub(super) fn kitchen_tongs(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (mat, tip_mat) = (STEEL, b.choose(&[STEEL, RED_RUBBER, BLACK_PLASTIC, GREEN_PLASTIC]));
    let t = (z * 0.05).min(0.0012);
    let hx = x / 2.0;
    for side in [-1.0, 1.0] {
        let at = |k: f32, open: f32| [side * hx * open, y * (k - 0.5), z / 2.0];
        let path = [
            (at(0.0, 0.15), z * 0.3, t),
            (at(0.25, 0.45), z * 0.25, t),
            (at(0.8, 0.8), z * 0.2, t),
            (at(0.88, 0.85), z * 0.3, t),
        ];
        sweep(b, "arm", &path, [0.0, 0.0, 1.0], mat);
        let path = [
            (at(0.86, 0.84), z * 0.28, t * 2.0),
            (at(0.93, 0.82), z * 0.49, t * 2.2),
            (at(1.0, 0.6), z * 0.35, t * 2.0),
        ];
        sweep(b, "tip", &path, [0.0, 0.0, 1.0], tip_mat);
    }
    b.block("hinge", [-hx * 0.3, -y * 0.49, z * 0.2], [hx * 0.3, -y * 0.46, z * 0.8], mat);
}

/// A potato masher: a bent wire or a plate with holes, on a grip.
pub(super) fn potato_masher(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let handle = grip_mat(b);
    let (hx, hz) = (x / 2.0, z / 2.0);
    let w = (hx * 0.08).min(0.004);
    let plate = y / 2.0 - w;
    if b.rng.chance(0.5) {
        let points: Vec<P> = (0..=6)
            .flat_map(|i| {
                let at = (hx - w) * (i as f32 / 3.0 - 1.0);
                let end = (hz - w) * (1.0 - 0.4 * (i as f32 / 3.0 - 1.0).abs());
                let side = if i % 2 == 0 { 1.0 } else { -1.0 };
                [[at, plate, hz - side * end], [at, plate, hz + side * end]]
            })
            .collect();
        planar_tube(b, "wire", &points, w, [0.0, 1.0, 0.0], STEEL);
    } else {
        let disc = [(0.35, 0.0), (1.0, 0.0), (1.0, 1.0), (0.35, 1.0), (0.35, 0.0)];
        let disc: Vec<_> = disc.iter().map(|p| (p.0 * hx.min(hz), p.1 * w * 2.0)).collect();
        b.lathe_along("plate", [0.0, plate - w, hz], [0.0, y, hz], &disc, STEEL);
        b.block("web", [-hx * 0.9, plate - w * 0.5, hz - w], [hx * 0.9, plate + w * 0.8, hz + w], STEEL);
    }
    for side in [-1.0, 1.0] {
        planar_tube(
            b,
            "arm",
            &[[side * (hx - w) * 0.93, plate, hz], [side * hx * 0.7, y * 0.2, hz], [0.0, 0.0, hz]],
            w,
            [0.0, 0.0, 1.0],
            STEEL,
        );
    }
    let r = (hz * 0.4).min(0.014);
    grip(b, [0.0, -y / 2.0, hz], [0.0, y * 0.03, hz], (r, r), handle);
}

/// A rolling pin with two grips.
pub(super) fn rolling_pin(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.choose(&[BEECH, MAPLE, MARBLE, b.style.wood, STEEL]);
    let handle = b.choose(&[BEECH, mat, RED, BLACK_PLASTIC]);
    let r = x.min(z) / 2.0;
    let roll = y * b.vary(0.56, 0.64);
    let (from, to) = ([0.0, -y / 2.0, r], [0.0, y / 2.0, r]);
    let side = (y - roll) / 2.0;
    let profile = [(r * 0.9, side), (r, side + r * 0.15), (r, y - side - r * 0.15), (r * 0.9, y - side)];
    b.lathe_along("roller", from, to, &profile, mat);
    for flip in [false, true] {
        let grip: Vec<_> = [(0.3, 0.0), (0.55, 0.1), (0.6, 0.4), (0.35, 0.85), (0.3, 1.02)]
            .iter()
            .map(|p| (p.0 * r, p.1 * side))
            .collect();
        if flip {
            b.lathe_along("grip", to, from, &grip, handle)
        } else {
            b.lathe_along("grip", from, to, &grip, handle)
        }
    }
}

/// A flat pastry brush.
pub(super) fn pastry_brush(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let hair = b.choose(&[WAX, RED_RUBBER, WHITE_PLASTIC, BLUE_PLASTIC]);
    let handle = b.choose(&[BEECH, BAMBOO, WHITE_PLASTIC, STEEL]);
    let (mid, root) = (z / 2.0, y * 0.22);
    b.rounded_block("ferrule", [-x / 2.0, y * 0.12, 0.0], [x / 2.0, root + y * 0.02, z], z * 0.2, STEEL);
    for i in 0..7 {
        let at = x * 0.42 * (i as f32 / 3.0 - 1.0);
        b.block(
            "bristles",
            [at - x * 0.055, root, z * 0.1],
            [at + x * 0.055, y * (0.5 - 0.012 * (i % 3) as f32), z * 0.9],
            hair,
        );
    }
    grip(b, [0.0, -y / 2.0, mid], [0.0, y * 0.14, mid], (x * 0.36, mid * 0.9), handle);
}
