//! Utensils to stir, turn, grate, open and press with: long ones lie along Y, the
//! grip at the low end.

use std::f32::consts::{PI, TAU};

use nalgebra::{Isometry3, Vector3};

use super::cutlery::scoop;
use super::form::{arch, dims, ear, hoop, level, loft, oval, rounded, shell, sweep, tube, turn, vessel};
use crate::material::*;
use crate::object::build::{Axis, Build, P};
use vc_graph::portable::Portable;

const ACROSS: P = [1.0, 0.0, 0.0];

/// What grips are made of.
fn grip_mat(b: &mut Build<'_>) -> Mat {
    b.one(&[BLACK_PLASTIC, BLACK_PLASTIC, STEEL, BEECH, RED_PLASTIC, GREY_PLASTIC, GREEN_PLASTIC])
}

/// A grip along Y from its butt at `from` to where it ends, thickest near the butt.
fn grip(b: &mut Build<'_>, from: P, to: P, half: (f32, f32), mat: Mat) {
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

/// A spoon cut from one piece of wood.
pub(super) fn wooden_spoon(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.one(&[BEECH, OAK, BAMBOO, CHERRY, MAPLE]);
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
        b.one(&[RED_RUBBER, GREY_RUBBER, WHITE_PLASTIC, BLUE_PLASTIC])
    } else {
        b.one(&[BLACK_PLASTIC, STEEL, BEECH])
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
        b.block("blade", [-hx, tip - length * 0.2, 0.0], [hx, tip, t * 0.8], mat);
        let fan = [(-hx * 0.2, 0.0), (hx * 0.2, 0.0), (hx, length * 0.25), (-hx, length * 0.25)];
        b.prism("blade", Axis::Z, [0.0, root, t * 0.15], &fan, t * 0.65, mat);
    }
    let r = (z * 0.28).min(0.008);
    let lift = if soft { z / 2.0 } else { z - r };
    let neck = r * 0.45;
    tube(
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

/// Ladles and skimmers: a round head, deep or flat with holes.
pub(super) fn ladle(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (mat, handle) = (b.one(&[STEEL, STEEL, BLACK_PLASTIC]), b.one(&[STEEL, BLACK_PLASTIC, BEECH]));
    let r = x / 2.0;
    let centre = y / 2.0 - r;
    let neck = (z * 0.1).min(0.005);
    if b.class == "ladle" {
        let depth = z * b.vary(0.5, 0.65);
        let outside: Vec<_> =
            [(0.35, 0.0), (0.7, 0.18), (0.92, 0.5), (1.0, 1.0)].iter().map(|p| (p.0 * r, p.1 * depth)).collect();
        b.lathe("bowl", [0.0, centre, 0.0], &shell(&outside, (r * 0.05).min(0.002)), mat);
        b.inside("inside", [0.0, centre, r * 0.05], (r * 0.2, r * 0.2), depth * 0.9);
        let path =
            [[0.0, centre - r * 0.95, depth * 0.8], [0.0, centre - r * 1.2, depth], [0.0, -y * 0.1, z - neck * 2.0]];
        tube(b, "neck", &path, neck, ACROSS, mat);
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
        tube(b, "neck", &[[0.0, centre - r * 0.95, rim * 0.6], [0.0, -y * 0.1, z - neck]], neck, ACROSS, mat);
        grip(b, [0.0, -y / 2.0, z - neck], [0.0, -y * 0.05, z - neck], (neck * 1.8, neck), handle);
    }
}

fn hoop_at(b: &mut Build<'_>, base: P, z: (f32, f32), r: (f32, f32), mat: Mat) {
    b.at(base, 0.0, |b| hoop(b, "rim", z, r, mat));
}

/// Loops of wire on a grip.
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
fn thin_wire(b: &mut Build<'_>, points: &[P], w: f32, side: P) {
    let path: Vec<_> = points.iter().map(|&p| (p, w, w)).collect();
    sweep(b, "wire", &path, side, STEEL);
}

/// Two arms that meet at one end.
pub(super) fn kitchen_tongs(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (mat, tip_mat) = (STEEL, b.one(&[STEEL, RED_RUBBER, BLACK_PLASTIC, GREEN_PLASTIC]));
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

/// Graters: boxes with four sides, or flat ones with a grip.
pub(super) fn grater(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let handle = b.one(&[BLACK_PLASTIC, RED_PLASTIC, STEEL, GREEN_PLASTIC]);
    if b.class == "zester" {
        let t = z * 0.2;
        b.block("blade", [-x / 2.0, -y * 0.08, z * 0.5], [x / 2.0, y / 2.0, z * 0.5 + t], STEEL);
        for i in 0..12 {
            let at = -y * 0.05 + y * 0.52 * i as f32 / 12.0;
            b.hull(
                "tooth",
                &[
                    [-x * 0.4, at, z * 0.5 + t],
                    [x * 0.4, at, z * 0.5 + t],
                    [0.0, at + y * 0.02, z * 0.5 + t],
                    [0.0, at, z * 0.9],
                ],
                STEEL,
            );
        }
        grip(b, [0.0, -y / 2.0, z / 2.0], [0.0, -y * 0.05, z / 2.0], (x * 0.45, z / 2.0), handle);
        return;
    }
    let (hx, hy, h) = (x / 2.0, y / 2.0, z * 0.82);
    let (tx, ty) = (hx * 0.62, hy * 0.62);
    let t = x * 0.02;
    super::form::tub(b, "frame", &[(0.0, hx, hy), (z * 0.05, hx, hy)], 0.2, t * 3.0, handle);
    for (sx, sy) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0_f32)] {
        let face = |k: f32, z: f32, thin: f32| {
            let (ox, oy) = ((hx * 0.96 + (tx - hx * 0.96) * k) - thin, (hy * 0.96 + (ty - hy * 0.96) * k) - thin);
            if sy == 0.0 { [[sx * ox, -oy, z], [sx * ox, oy, z]] } else { [[-ox, sy * oy, z], [ox, sy * oy, z]] }
        };
        let points: Vec<P> =
            [face(0.0, z * 0.02, 0.0), face(1.0, h, 0.0), face(0.0, z * 0.02, t), face(1.0, h, t)].concat();
        b.hull("face", &points, STEEL);
        let rows = 7;
        for row in 1..rows {
            let k = 0.08 + 0.8 * row as f32 / rows as f32;
            let [p, q] = face(k, h * k, 0.0);
            let lerp = |m: f32| [p[0] + (q[0] - p[0]) * m, p[1] + (q[1] - p[1]) * m, p[2]];
            let big = sx > 0.0;
            for m in if big { vec![0.2, 0.4, 0.6, 0.8] } else { vec![0.3, 0.7] } {
                let c = lerp(m);
                let s = x * if big { 0.025 } else { 0.05 };
                let out = [c[0] + sx * s * 0.4, c[1] + sy * s * 0.4, c[2] - s * 0.3];
                b.hull(
                    "tooth",
                    &[
                        [c[0] - sy.abs() * s, c[1] - sx.abs() * s, c[2]],
                        [c[0] + sy.abs() * s, c[1] + sx.abs() * s, c[2]],
                        [c[0], c[1], c[2] - s * 1.4],
                        out,
                        [c[0] - sx * s * 0.3, c[1] - sy * s * 0.3, c[2]],
                    ],
                    STEEL,
                );
            }
        }
    }
    b.block("top", [-tx, -ty, h - t], [tx, ty, h + t], handle);
    let r = (z - h) * 0.15;
    let loop_ = arch([0.0, 0.0, h], [0.0, ty * 0.85, 0.0], [0.0, 0.0, z - h - r]);
    tube(b, "grip", &loop_, r, ACROSS, handle);
}

/// A board with a blade across, that stands on a foot.
pub(super) fn mandoline(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let mat = b.one(&[WHITE_PLASTIC, BLACK_PLASTIC, GREEN_PLASTIC, STEEL]);
    let t = (z * 0.2).min(0.012);
    let slab = |b: &mut Build<'_>, name: &str, x: f32, (y0, y1): (f32, f32), lift: f32, thick: f32, mat: Mat| {
        // The rails stand out above and below.
        let high = if name == "rail" { z } else { z * 0.96 };
        let height = |y: f32| (high - thick - lift) * (y / hy + 1.0) / 2.0 + lift;
        let points: Vec<P> = [(y0, 0.0), (y0, thick), (y1, 0.0), (y1, thick)]
            .iter()
            .flat_map(|&(y, up)| [[-x, y, height(y) + up], [x, y, height(y) + up]])
            .collect();
        b.hull(name, &points, mat);
    };
    slab(b, "board", hx * 0.85, (-hy * 0.985, hy * 0.1), t * 0.15, t * 0.6, mat);
    slab(b, "board", hx * 0.85, (hy * 0.16, hy * 0.985), t * 0.15, t * 0.6, mat);
    slab(b, "blade", hx * 0.84, (hy * 0.08, hy * 0.18), t * 0.4, t * 0.5, STEEL);
    for side in [-1.0, 1.0] {
        b.at([side * hx * 0.92, 0.0, 0.0], 0.0, |b| slab(b, "rail", hx * 0.08, (-hy, hy), 0.0, t, mat));
        b.block(
            "leg",
            [side * hx * 0.8 - hx * 0.06, hy * 0.86, 0.0],
            [side * hx * 0.8 + hx * 0.06, hy * 0.95, z * 0.9],
            BLACK_PLASTIC,
        );
    }
    b.rod("foot", [-hx * 0.85, hy * 0.9, t * 0.4], [hx * 0.85, hy * 0.9, t * 0.4], t * 0.4, RUBBER);
}

/// A peeler: straight with its blade at the end, or with the blade across.
pub(super) fn peeler(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let handle = grip_mat(b);
    let mid = z / 2.0;
    if x > 0.045 {
        let (hx, fork) = (x / 2.0, y * 0.22);
        for side in [-1.0, 1.0] {
            tube(
                b,
                "fork",
                &[
                    [side * hx * 0.3, fork, mid],
                    [side * (hx - z * 0.3) * 0.95, y * 0.32, mid],
                    [side * (hx - z * 0.3), y / 2.0, mid],
                ],
                z * 0.28,
                [0.0, 0.0, 1.0],
                STEEL,
            );
        }
        b.block("blade", [-hx, y * 0.42, mid - z * 0.1], [hx, y * 0.48, mid + z * 0.1], STEEL);
        tube(b, "yoke", &[[-hx * 0.35, fork, mid], [hx * 0.35, fork, mid]], z * 0.3, [0.0, 0.0, 1.0], STEEL);
        grip(b, [0.0, -y / 2.0, mid], [0.0, fork, mid], (x * 0.2, mid), handle);
    } else {
        let hx = x / 2.0;
        let outline = [(-hx, 0.0), (hx, 0.0), (hx, y * 0.36), (0.0, y * 0.44), (-hx, y * 0.36)];
        b.prism("blade", Axis::Z, [0.0, y * 0.06, mid - z * 0.1], &outline, z * 0.2, STEEL);
        b.prism(
            "slot",
            Axis::Z,
            [0.0, y * 0.1, mid - z * 0.2],
            &rounded((hx * 0.2, hx * 0.2), 1.0),
            z * 0.4,
            BLACK_PLASTIC,
        );
        grip(b, [0.0, -y / 2.0, mid], [0.0, y * 0.1, mid], (hx * 0.95, mid), handle);
    }
}

/// Things of two levers: can openers, garlic presses and scissors.
pub(super) fn levers(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let handle = b.one(&[BLACK_PLASTIC, RED_PLASTIC, STEEL, GREEN_PLASTIC]);
    let (hx, mid) = (x / 2.0, z / 2.0);
    let head = y * if b.class == "garlic_press" { 0.26 } else { 0.18 };
    let thick = (z * 0.25).min(x * 0.12);
    if b.class == "kitchen_scissors" {
        return scissors(b, handle);
    }
    for side in [-1.0, 1.0] {
        let at = |k: f32, open: f32| [side * (hx - thick) * open, -y / 2.0 + (head + y / 2.0) * k, mid];
        let path = [
            (at(0.0, 0.9), thick * 0.7, thick * 0.7),
            (at(0.06, 1.0), thick, thick),
            (at(0.7, 0.75), thick, thick),
            (at(1.0, 0.25), thick * 0.8, thick * 0.8),
        ];
        sweep(b, "lever", &path, [0.0, 0.0, 1.0], handle);
    }
    if b.class == "can_opener" {
        b.block("head", [-hx * 0.45, head - y * 0.06, mid - z * 0.12], [hx * 0.45, y / 2.0, mid + z * 0.12], STEEL);
        b.cylinder("wheel", [-hx * 0.1, y * 0.36, mid], hx * 0.35, z * 0.3, STEEL);
        b.cylinder("axle", [0.0, y * 0.28, 0.0], hx * 0.15, z * 0.85, STEEL);
        b.soft("key", [-hx * 0.95, y * 0.24, z * 0.8], [hx * 0.95, y * 0.32, z], z * 0.1, handle);
    } else {
        b.taper("press", [0.0, y * 0.36, 0.0], (hx * 0.7, y * 0.12), (hx * 0.8, y * 0.13), z * 0.8, STEEL);
        b.cylinder("plunger", [0.0, y * 0.36, z * 0.7], hx * 0.45, z * 0.3, STEEL);
        b.rod("pin", [-hx, y * 0.49, mid], [hx, y * 0.49, mid], (z * 0.12).min(y * 0.01), STEEL);
    }
}

fn scissors(b: &mut Build<'_>, handle: Mat) {
    let (x, y, z) = dims(b);
    let (hx, t) = (x / 2.0, z * 0.22);
    let pivot = y * 0.02;
    for side in [-1.0_f32, 1.0] {
        let low = z / 2.0 + if side > 0.0 { 0.0003 } else { -t - 0.0003 };
        let blade = [
            (side * hx * 0.22, -y * 0.06),
            (side * hx * 0.3, pivot),
            (side * hx * 0.28, y * 0.25),
            (0.0, y * 0.475),
            (-side * hx * 0.04, y * 0.475),
            (-side * hx * 0.15, pivot),
            (-side * hx * 0.1, -y * 0.06),
        ];
        b.prism("blade", Axis::Z, [0.0, pivot, low], &blade, t, STEEL);
        let r = (hx * 0.13).min(z * 0.45);
        let (ox, oy) = ((hx * 0.5 - r).max(r * 0.2), y * 0.17);
        let centre = [-side * (hx - ox - r), -y / 2.0 + oy + r, z / 2.0];
        let mut bow = oval(centre, (ox, oy));
        bow.push(bow[0]);
        tube(b, "bow", &bow, r, [0.0, 0.0, 1.0], handle);
        tube(
            b,
            "shank",
            &[
                [-side * hx * 0.1, pivot, z / 2.0],
                [-side * hx * 0.3, -y * 0.1, z / 2.0],
                [-side * hx * 0.35, -y * 0.18, z / 2.0],
            ],
            r,
            [0.0, 0.0, 1.0],
            handle,
        );
    }
    b.cylinder("pivot", [0.0, pivot * 1.5, z * 0.2], hx * 0.1, z * 0.6, CHROME);
}

/// A bar with a claw for crown caps.
pub(super) fn bottle_opener(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.one(&[STEEL, CHROME, BRASS, BLACK_METAL]);
    let handle = b.one(&[mat, b.style.wood, BLACK_PLASTIC, RED_PLASTIC]);
    let t = (z * 0.3).min(x * 0.12);
    let (hx, mid) = (x / 2.0, z / 2.0);
    let mut ring = oval([0.0, y / 2.0 - hx, mid], (hx - t, hx - t));
    ring.push(ring[0]);
    tube(b, "ring", &ring, t, [0.0, 0.0, 1.0], mat);
    b.block("claw", [-hx * 0.5, y / 2.0 - x * 0.95, mid - t * 0.5], [hx * 0.5, y / 2.0 - x * 0.75, mid + t * 0.5], mat);
    grip(b, [0.0, -y / 2.0, mid], [0.0, y / 2.0 - x * 0.92, mid], (hx * 0.7, mid), handle);
}

/// A spiral on a cross grip.
pub(super) fn corkscrew(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let handle = b.one(&[b.style.wood, BLACK_PLASTIC, WALNUT, CHROME]);
    let mid = z / 2.0;
    let r = (z * 0.3).min(x * 0.2);
    let w = r * 0.25;
    let (top, tip) = (-y / 2.0 + z, y / 2.0 - w);
    let turns = 24;
    let points: Vec<P> = (0..=turns)
        .map(|i| {
            let k = i as f32 / turns as f32;
            let (s, c) = (TAU * 4.0 * k).sine_cosine();
            let thin = r * 0.7 * (1.0 - 0.5 * k);
            [thin * c, top + (tip - top) * (0.35 + 0.65 * k), mid + thin * s]
        })
        .collect();
    helix(b, &points, mid, w);
    b.rod("shaft", [0.0, top - z * 0.2, mid], [0.0, top + (tip - top) * 0.37, mid], w * 1.6, STEEL);
    let hx = x / 2.0;
    let path = [
        ([-hx, -y / 2.0 + mid, mid], mid * 0.6, mid * 0.6),
        ([-hx * 0.85, -y / 2.0 + mid, mid], mid * 0.95, mid * 0.95),
        ([0.0, -y / 2.0 + mid, mid], mid * 0.8, mid * 0.8),
        ([hx * 0.85, -y / 2.0 + mid, mid], mid * 0.95, mid * 0.95),
        ([hx, -y / 2.0 + mid, mid], mid * 0.6, mid * 0.6),
    ];
    sweep(b, "grip", &path, [0.0, 0.0, 1.0], handle);
}

/// A wire wound around the Y axis at height `mid`.
fn helix(b: &mut Build<'_>, points: &[P], mid: f32, w: f32) {
    let ring = |p: &P| {
        let (x, z) = (p[0], p[2] - mid);
        let out = x.hypotenuse(z).max(1e-6);
        let point = |k: usize| {
            let (s, c) = (TAU * k as f32 / 6.0).sine_cosine();
            [p[0] + x / out * w * c, p[1] + w * s, p[2] + z / out * w * c]
        };
        (0..6).map(point).collect()
    };
    let rings: Vec<Vec<P>> = points.iter().map(ring).collect();
    loft(b, "screw", &rings, STEEL);
}

/// A bent wire or a plate with holes, on a grip.
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
        tube(b, "wire", &points, w, [0.0, 1.0, 0.0], STEEL);
    } else {
        let disc = [(0.35, 0.0), (1.0, 0.0), (1.0, 1.0), (0.35, 1.0), (0.35, 0.0)];
        let disc: Vec<_> = disc.iter().map(|p| (p.0 * hx.min(hz), p.1 * w * 2.0)).collect();
        b.lathe_along("plate", [0.0, plate - w, hz], [0.0, y, hz], &disc, STEEL);
        b.block("web", [-hx * 0.9, plate - w * 0.5, hz - w], [hx * 0.9, plate + w * 0.8, hz + w], STEEL);
    }
    for side in [-1.0, 1.0] {
        tube(
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

/// A wheel on a grip.
pub(super) fn pizza_cutter(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let handle = grip_mat(b);
    let r = x / 2.0;
    let mid = z / 2.0;
    let centre = y / 2.0 - r;
    b.cylinder("wheel", [0.0, centre, mid - z * 0.04], r, z * 0.08, STEEL);
    b.cylinder("hub", [0.0, centre, mid - z * 0.25], r * 0.22, z * 0.5, CHROME);
    for side in [-1.0_f32, 1.0] {
        b.block(
            "fork",
            [-r * 0.16, centre - r * 1.3, mid + side * z * 0.15 - z * 0.05],
            [r * 0.16, centre + r * 0.1, mid + side * z * 0.15 + z * 0.05],
            STEEL,
        );
    }
    grip(b, [0.0, -y / 2.0, mid], [0.0, centre - r * 1.1, mid], (r * 0.4, mid), handle);
}

/// A roller with two grips.
pub(super) fn rolling_pin(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.one(&[BEECH, MAPLE, MARBLE, b.style.wood, STEEL]);
    let handle = b.one(&[BEECH, mat, RED, BLACK_PLASTIC]);
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

/// A flat brush for glazing.
pub(super) fn pastry_brush(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let hair = b.one(&[WAX, RED_RUBBER, WHITE_PLASTIC, BLUE_PLASTIC]);
    let handle = b.one(&[BEECH, BAMBOO, WHITE_PLASTIC, STEEL]);
    let (mid, root) = (z / 2.0, y * 0.22);
    b.soft("ferrule", [-x / 2.0, y * 0.12, 0.0], [x / 2.0, root + y * 0.02, z], z * 0.2, STEEL);
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

/// A strip of metal bent to a star, a heart, a man or a ring.
pub(super) fn cookie_cutter(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.one(&[STEEL, ALUMINIUM, COPPER, RED_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC]);
    let kind = b.rng.below(4);
    let n = 40;
    let radius = |angle: f32| match kind {
        0 => 0.75 + 0.25 * (5.0 * angle).cosine(),
        1 => 0.72 + 0.28 * angle.sine().abs().power(0.4) - if angle.sine() > 0.9 { 0.25 } else { 0.0 },
        2 => 0.85 + 0.15 * (6.0 * angle).cosine(),
        _ => 1.0,
    };
    let ring = |z: f32, thin: f32| -> Vec<P> {
        (0..n)
            .map(|i| {
                let angle = TAU * i as f32 / n as f32;
                let (s, c) = angle.sine_cosine();
                let k = radius(angle) - thin;
                [x / 2.0 * k * c, y / 2.0 * k * s, z]
            })
            .collect()
    };
    let rings = [ring(0.0, 0.0), ring(z, 0.0), ring(z, 0.05), ring(0.0, 0.05), ring(0.0, 0.0)];
    super::dishes::ring_skin(b, "cutter", &rings, mat);
}

/// A cone of cloth with a nozzle, standing on it.
pub(super) fn piping_bag(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.one(&[WHITE_COTTON, CLEAR_PLASTIC, BLUE_FABRIC]);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let cone = [
        level(z * 0.12, (hx * 0.25, hx * 0.25), 1.0),
        level(z * 0.7, (hx, hy * 0.75), 1.0),
        level(z * 0.98, (hx * 0.6, hy), 1.0),
        level(z, (hx * 0.35, hy * 0.97), 1.0),
    ];
    loft(b, "bag", &cone, mat);
    turn(b, "nozzle", [0.0; 3], (hx * 0.3, z * 0.14), &[(0.35, 0.0), (1.0, 1.0)], STEEL);
}

/// A jug with a scale.
pub(super) fn measuring_cup(b: &mut Build<'_>) {
    let (x, y, h) = dims(b);
    let r = (x / 2.0).min(y * 0.4);
    let (mat, ink) =
        (b.one(&[GLASS, CLEAR_PLASTIC, STEEL, WHITE_PLASTIC]), b.one(&[RED_PLASTIC, BLUE_PLASTIC, BLACK_PLASTIC]));
    vessel(
        b,
        "cup",
        (r - 0.0008, h),
        &[(0.82, 0.0), (0.86, 0.03), (0.95, 0.7), (1.0, 1.0)],
        (r * 0.05).min(0.004),
        mat,
    );
    ear(b, (r * 0.88, y - r * 1.13), (h * 0.25, h * 0.93), r * 0.1, mat);
    let lip = [
        [r * 0.35, -r * 0.92, h * 0.992],
        [-r * 0.35, -r * 0.92, h * 0.992],
        [0.0, -r * 1.12, h * 0.992],
        [0.0, -r * 0.9, h * 0.82],
    ];
    b.hull("lip", &lip, mat);
    for i in 1..6 {
        let z = h * 0.14 * i as f32;
        let wide = r * if i % 2 == 0 { 0.3 } else { 0.18 };
        let face = r * (0.86 + 0.1 * z / h);
        b.block("mark", [face - r * 0.1, -wide, z], [face + 0.0006, wide, z + h * 0.012], ink);
    }
}

/// A small scoop, or a set of them on a ring.
pub(super) fn measuring_spoon(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.one(&[STEEL, WHITE_PLASTIC, COPPER, RED_PLASTIC, BLUE_PLASTIC]);
    let r = x / 2.0;
    let centre = y / 2.0 - r;
    let outside: Vec<_> =
        [(0.5, 0.0), (0.85, 0.25), (0.98, 0.7), (1.0, 1.0)].iter().map(|p| (p.0 * r, p.1 * z)).collect();
    b.lathe("bowl", [0.0, centre, 0.0], &shell(&outside, (r * 0.08).min(0.0015)), mat);
    b.inside(
        "inside",
        [0.0, centre, (r * 0.08).min(0.0015)],
        ((r * 0.28).max(0.0042), (r * 0.28).max(0.0042)),
        z * 0.9,
    );
    let t = (z * 0.08).min(0.0015);
    let at = |k: f32| [0.0, -y / 2.0 + (centre - r * 0.93 + y / 2.0) * k, z - t];
    let path = [(at(0.0), x * 0.1, t), (at(0.05), x * 0.2, t), (at(0.6), x * 0.16, t), (at(1.0), x * 0.2, t)];
    sweep(b, "handle", &path, ACROSS, mat);
}

/// A bowl of holes with two grips.
pub(super) fn colander(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = (x / 2.0).min(y * 0.44);
    let mat = b.one(&[STEEL, WHITE_METAL, RED_METAL, WHITE_PLASTIC, GREEN_PLASTIC]);
    let (foot, t) = (z * 0.1, (r * 0.02).min(0.002));
    let h = z - foot;
    b.at([0.0, 0.0, foot], 0.0, |b| {
        vessel(b, "bowl", (r, h), &[(0.4, 0.0), (0.68, 0.2), (0.9, 0.6), (1.0, 1.0)], t, mat)
    });
    hoop(b, "foot", (0.0, foot + t * 0.4), (r * 0.36, r * 0.42), mat);
    for row in 0..4 {
        let (k, rise) = ([0.62, 0.76, 0.86, 0.93][row], [0.16, 0.34, 0.5, 0.68][row]);
        let holes = 12;
        for i in 0..holes {
            let angle = TAU * (i as f32 + 0.5 * (row % 2) as f32) / holes as f32;
            b.at([0.0; 3], angle, |b| {
                let (at, z) = (r * k, foot + h * rise);
                b.hull(
                    "hole",
                    &[
                        [at - r * 0.02, -r * 0.03, z],
                        [at - r * 0.02, r * 0.03, z],
                        [at + r * 0.03, 0.0, z - r * 0.02],
                        [at - r * 0.01, 0.0, z + r * 0.05],
                        [at + r * 0.025, 0.0, z + r * 0.03],
                    ],
                    BLACK_PLASTIC,
                );
            });
        }
    }
    for side in [-1.0, 1.0] {
        let w = (r * 0.04).min(0.005);
        let path = arch(
            [0.0, side * r * 0.94, z - w],
            [r * 0.3, 0.0, 0.0],
            [0.0, side * (y / 2.0 - r * 0.94 - w).max(1e-3), 0.0],
        );
        tube(b, "handle", &path, w, [0.0, 0.0, 1.0], mat);
    }
}

/// A bowl of mesh in a ring with a handle: for flour, pasta or tea.
pub(super) fn sieve(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = (x / 2.0).min(y * 0.35);
    let centre = y / 2.0 - r;
    let handle = b.one(&[STEEL, BLACK_PLASTIC, BEECH]);
    let h = z * 0.92;
    let outside: Vec<_> =
        [(0.3, 0.0), (0.7, 0.25), (0.92, 0.6), (0.97, 0.95)].iter().map(|p| (p.0 * r, p.1 * z)).collect();
    b.lathe("mesh", [0.0, centre, 0.0], &shell(&outside, (r * 0.03).min(0.0015)), ALUMINIUM);
    hoop_at(b, [0.0, centre, 0.0], (h, z), (r * 0.9, r), STEEL);
    if b.class == "sieve" {
        b.inside("inside", [0.0, centre, (r * 0.03).min(0.0015)], (r * 0.17, r * 0.17), z * 0.9);
    }
    for i in 0..4 {
        let (s, c) = (PI * i as f32 / 4.0).sine_cosine();
        let point = |k: f32, h: f32| [r * k * c, centre + r * k * s, z * h];
        let points = [
            point(-0.985, 0.95),
            point(-0.94, 0.6),
            point(-0.72, 0.24),
            point(-0.3, 0.005),
            point(0.3, 0.005),
            point(0.72, 0.24),
            point(0.94, 0.6),
            point(0.985, 0.95),
        ];
        thin_wire(b, &points.map(|p| [p[0], p[1], p[2].max(r * 0.008)]), r * 0.008, [-s, c, 0.0]);
    }
    let w = (z - h) / 2.0;
    grip(b, [0.0, -y / 2.0, z - w], [0.0, centre - r * 0.95, z - w], ((r * 0.14).max(w), w), handle);
}

/// A cone with a tube, standing on its rim or on its tube.
pub(super) fn funnel(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let mat = b.one(&[STEEL, WHITE_PLASTIC, RED_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC]);
    let (neck, rise) = (b.vary(0.16, 0.24), b.vary(0.4, 0.5));
    let t = (r * 0.03).min(0.002) / r;
    let (n, w) = (neck * 0.6, rise);
    // Rim down, so that it stands.
    let profile = [
        (1.0, 0.0),
        (1.0, 0.04),
        (neck, 1.0 - w),
        (n, 1.0),
        (n - t, 1.0),
        (neck - t, 1.0 - w),
        (1.0 - t, 0.03),
        (1.0 - t, 0.0),
        (1.0, 0.0),
    ];
    turn(b, "funnel", [0.0; 3], (r, z), &profile, mat);
}

/// A bowl with a basket in it and a lid with a crank.
pub(super) fn salad_spinner(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let (bowl, cap) = (
        b.one(&[CLEAR_PLASTIC, WHITE_PLASTIC, GREEN_PLASTIC]),
        b.one(&[WHITE_PLASTIC, GREEN_PLASTIC, RED_PLASTIC, BLACK_PLASTIC]),
    );
    let h = z * 0.8;
    vessel(b, "bowl", (r, h), &[(0.7, 0.0), (0.85, 0.1), (0.97, 0.6), (1.0, 1.0)], (r * 0.025).min(0.003), bowl);
    b.slide([0.0, 0.0, 1.0], z * 1.2, |b| {
        turn(
            b,
            "lid",
            [0.0, 0.0, h + 0.0004],
            (r, (z - h) * 0.6),
            &[(1.0, 0.0), (1.0, 0.3), (0.85, 0.8), (0.4, 1.0)],
            cap,
        );
        b.block(
            "crank",
            [-r * 0.08, -r * 0.1, h + (z - h) * 0.55],
            [r * 0.08, r * 0.6, h + (z - h) * 0.75],
            BLACK_PLASTIC,
        );
        b.cylinder("knob", [0.0, r * 0.5, h + (z - h) * 0.7], r * 0.09, (z - h) * 0.3, BLACK_PLASTIC);
    });
}

/// A board to cut on: of wood or plastic, with a groove, a hole or a handle.
pub(super) fn cutting_board(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let mat = b.one(&[b.style.wood, BAMBOO, BEECH, MAPLE, WHITE_PLASTIC, GREEN_PLASTIC, SLATE_TILE]);
    let round = b.one(&[0.1, 0.2, 0.4]);
    let handled = b.rng.chance(0.4);
    let end = if handled { hy - y * 0.2 } else { hy };
    let shift = end - hy;
    let outline: Vec<_> = rounded((hx, (end + hy) / 2.0), round).iter().map(|p| (p.0, p.1 + shift / 2.0)).collect();
    let plate = if b.rng.chance(0.3) { z * 0.8 } else { z };
    b.prism("board", Axis::Z, [0.0; 3], &outline, plate, mat);
    let groove = 0.0008_f32.min(z * 0.1);
    if plate < z {
        let half = (hx, (end + hy) / 2.0);
        let ring = |z: f32, k: f32| {
            level(z, (half.0 - k, half.1 - k), round)
                .into_iter()
                .map(|p| [p[0], p[1] + shift / 2.0, p[2]])
                .collect::<Vec<P>>()
        };
        let (k, w) = (x * 0.03, x * 0.055);
        let low = plate - groove;
        super::dishes::ring_skin(b, "edge", &[ring(low, k), ring(z, k), ring(z, w), ring(low, w), ring(low, k)], mat);
    }
    if handled {
        let neck: Vec<_> = rounded((hx * 0.22, y * 0.13), 0.9).iter().map(|p| (p.0, p.1 + hy - y * 0.13)).collect();
        b.prism("handle", Axis::Z, [0.0, 0.0, z * 0.01], &neck, plate * 0.97, mat);
        b.cylinder("hole", [0.0, hy - y * 0.05, plate * 0.9], hx * 0.07, plate * 0.09, BLACK_PLASTIC);
    } else if b.rng.chance(0.5) {
        let slot: Vec<_> = rounded((hx * 0.07, y * 0.07), 1.0);
        b.prism("slot", Axis::Z, [hx * 0.82, 0.0, plate - groove], &slot, 2.0 * groove, BLACK_PLASTIC);
    }
    b.top("top", [0.0, shift / 2.0, plate], ((hx - x * 0.06).min(hx * 0.7), (end + hy) / 2.0 * 0.86));
}

/// A sharpener with slots, or a rod of steel with a grip.
pub(super) fn knife_sharpener(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let handle = b.one(&[BLACK_PLASTIC, RED_PLASTIC, b.style.wood]);
    if y > 0.26 {
        let r = x.min(z) / 2.0;
        b.rod("steel", [0.0, -y * 0.12, r], [0.0, y / 2.0, r], r * 0.35, STEEL);
        b.rod("guard", [0.0, -y * 0.13, r], [0.0, -y * 0.11, r], r, STEEL);
        return grip(b, [0.0, -y / 2.0, r], [0.0, -y * 0.12, r], (r * 0.85, r * 0.85), handle);
    }
    b.soft("base", [-x / 2.0, -y / 2.0, 0.0], [x / 2.0, y / 2.0, z * 0.3], z * 0.1, handle);
    b.soft("head", [-x * 0.45, 0.0, z * 0.2], [x * 0.45, y * 0.45, z], z * 0.15, STEEL);
    for i in 0..3 {
        let at = y * (0.09 + 0.13 * i as f32);
        b.block("slot", [-x * 0.46, at - y * 0.012, z * 0.55], [x * 0.46, at + y * 0.012, z * 0.98], BLACK_PLASTIC);
    }
    let loop_ = arch([0.0, -y * 0.22, z * 0.25], [0.0, y * 0.2, 0.0], [0.0, 0.0, z * 0.5]);
    tube(b, "handle", &loop_, (z * 0.12).min(x * 0.3), ACROSS, handle);
}

/// Timers: an egg, a dial or a box with a display.
pub(super) fn kitchen_timer(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.one(&[WHITE_PLASTIC, RED_PLASTIC, STEEL, YELLOW_PLASTIC, BLACK_PLASTIC]);
    if b.rng.chance(0.4) {
        return dial_timer(b, mat);
    }
    if x > 0.05 {
        let r = x.min(y) / 2.0;
        let (waist, tip) = (b.vary(0.28, 0.45), b.vary(0.6, 0.75));
        turn(
            b,
            "egg",
            [0.0; 3],
            (r, z),
            &[(0.6, 0.0), (0.92, 0.15), (1.0, waist), (0.93, 0.6), (tip, 0.85), (0.35, 0.97), (0.0, 1.0)],
            mat,
        );
        hoop(b, "dial", (z * 0.38, z * 0.42), (r * 0.9, r * 1.0), BLACK_PLASTIC);
        return;
    }
    b.soft("case", [-x / 2.0, -y / 2.0, 0.0], [x / 2.0 - x * 0.05, y / 2.0, z], x * 0.3, mat);
    let face = x * 0.45;
    b.block("display", [face - x * 0.2, -y * 0.36, z * 0.55], [face + x * 0.02, y * 0.36, z * 0.85], SCREEN);
    for i in 0..3 {
        let at = y * 0.26 * (i as f32 - 1.0);
        b.rod(
            "button",
            [face - x * 0.2, at, z * 0.28],
            [face + x * 0.05, at, z * 0.28],
            y * 0.09,
            [RED_PLASTIC, GREY_PLASTIC, GREEN_PLASTIC][i],
        );
    }
}

/// A round timer that stands: a plate with marks and a grip across its dial.
fn dial_timer(b: &mut Build<'_>, mat: Mat) {
    let (x, y, z) = dims(b);
    let (r, hx) = (y.min(z) / 2.0, x / 2.0);
    let at = |px: f32| [px, 0.0, r];
    b.lathe_along("case", at(-hx), at(hx), &[(r * 0.95, 0.0), (r, x * 0.1), (r, x * 0.45), (r * 0.9, x * 0.6)], mat);
    let dial = r * b.vary(0.66, 0.8);
    b.rod("dial", at(hx * 0.1), at(hx * 0.4), dial, WHITE_PLASTIC);
    for i in 0..12 {
        b.posed(Isometry3::new(Vector3::new(0.0, 0.0, r), Vector3::x() * (TAU * i as f32 / 12.0)), |b| {
            let wide = r * if i % 3 == 0 { 0.04 } else { 0.02 };
            b.block("mark", [hx * 0.3, -wide, dial * 0.78], [hx * 0.45, wide, dial * 0.94], BLACK_PLASTIC);
        });
    }
    b.rod("knob", at(hx * 0.3), at(hx * 0.6), dial * 0.55, mat);
    b.soft("grip", [hx * 0.4, -dial * 0.12, r - dial * 0.5], [hx, dial * 0.12, r + dial * 0.5], dial * 0.1, mat);
}

/// A dial on a needle.
pub(super) fn meat_thermometer(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(z) / 2.0;
    let (from, to) = ([0.0, -y / 2.0, r], [0.0, y / 2.0, r]);
    let depth = (y * 0.08).min(r);
    b.lathe_along(
        "dial",
        from,
        to,
        &[(r * 0.95, depth * 0.08), (r, depth * 0.2), (r, depth), (r * 0.5, depth * 1.5), (r * 0.15, depth * 2.5)],
        STEEL,
    );
    b.rod("face", [0.0, -y / 2.0 - 0.0, r], [0.0, -y / 2.0 + depth * 0.2, r], r * 0.82, WHITE_PAPER);
    b.lathe_along("needle", from, to, &[(r * 0.12, depth), (r * 0.12, y * 0.92), (0.0, y)], STEEL);
}

/// A bucket for ice with a lid and a bail.
pub(super) fn ice_bucket(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = (x / 2.0).min(y * 0.44);
    let mat = b.one(&[STEEL, CHROME, COPPER, CLEAR_PLASTIC]);
    let h = z * 0.8;
    vessel(b, "bucket", (r, h), &[(0.78, 0.0), (0.8, 0.03), (0.97, 0.95), (1.0, 1.0)], (r * 0.04).min(0.004), mat);
    for side in [-1.0, 1.0] {
        let w = (r * 0.06).min(0.006);
        let path = arch(
            [0.0, side * r * 0.92, h * 0.75],
            [0.0, 0.0, h * 0.12],
            [0.0, side * (y / 2.0 - r * 0.92 - w).max(1e-3), 0.0],
        );
        tube(b, "handle", &path, w, ACROSS, BRASS);
    }
    b.slide([0.0, 0.0, 1.0], z, |b| {
        turn(
            b,
            "lid",
            [0.0, 0.0, h + 0.0004],
            (r * 0.99, z * 0.1),
            &[(1.0, 0.0), (1.0, 0.2), (0.6, 0.9), (0.1, 1.0)],
            mat,
        );
        turn(b, "knob", [0.0, 0.0, h + z * 0.09], (r * 0.16, z * 0.11), super::dishes::KNOB, BRASS);
    });
}

/// A tray with a row of cups for ice.
pub(super) fn ice_cube_tray(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let mat = b.one(&[WHITE_PLASTIC, BLUE_PLASTIC, CLEAR_PLASTIC, PINK_PLASTIC]);
    let t = (x * 0.02).min(z * 0.1);
    super::form::tub(b, "tray", &[(0.0, hx * 0.92, hy * 0.95), (z, hx, hy)], 0.15, t, mat);
    let columns = ((y / x * 2.2).round() as usize).clamp(3, 7);
    b.block("rib", [-t, -hy * 0.95, t * 0.5], [t, hy * 0.95, z * 0.9], mat);
    for i in 1..columns {
        let at = hy * (2.0 * i as f32 / columns as f32 - 1.0) * 0.95;
        b.block("rib", [-hx * 0.93, at - t, t * 0.5], [hx * 0.93, at + t, z * 0.92], mat);
    }
    let cell = (hx * 0.92 - 3.0 * t, hy * 1.9 / columns as f32 - 4.0 * t);
    let first = -hy * 0.95 + hy * 0.95 / columns as f32;
    b.inside("cup_1", [hx * 0.46, first, t * 1.01], ((cell.0 * 0.4).max(1e-4), (cell.1 * 0.3).max(1e-4)), z * 0.85);
}
