//! Tools for grating, peeling, opening and cutting.

use std::f32::consts::TAU;

use vc_graph::portable::Portable;

use super::utensils::{ACROSS, grip, grip_mat};
use crate::material::*;
use crate::solid::{
    Axis, Build, P, arch, dims, level_oval, loft_columns, planar_tube, rounded_by_share, rounded_ring, sweep,
};

/// Graters: four-sided boxes, or flat ones with a grip.
pub(super) fn grater(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let handle = b.choose(&[BLACK_PLASTIC, RED_PLASTIC, STEEL, GREEN_PLASTIC]);
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
    crate::solid::tub(b, "frame", &[(0.0, hx, hy), (z * 0.05, hx, hy)], 0.2, t * 3.0, handle);
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
    planar_tube(b, "grip", &loop_, r, ACROSS, handle);
}

/// A mandoline: a board with a blade across, standing on a foot.
pub(super) fn mandoline(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let mat = b.choose(&[WHITE_PLASTIC, BLACK_PLASTIC, GREEN_PLASTIC, STEEL]);
    let t = (z * 0.2).min(0.012);
    let slab = |b: &mut Build<'_>, name: &str, x: f32, (y0, y1): (f32, f32), lift: f32, thick: f32, mat: MaterialId| {
        // The rails protrude at the top and at the bottom.
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
            planar_tube(
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
        planar_tube(b, "yoke", &[[-hx * 0.35, fork, mid], [hx * 0.35, fork, mid]], z * 0.3, [0.0, 0.0, 1.0], STEEL);
        grip(b, [0.0, -y / 2.0, mid], [0.0, fork, mid], (x * 0.2, mid), handle);
    } else {
        let hx = x / 2.0;
        let outline = [(-hx, 0.0), (hx, 0.0), (hx, y * 0.36), (0.0, y * 0.44), (-hx, y * 0.36)];
        b.prism("blade", Axis::Z, [0.0, y * 0.06, mid - z * 0.1], &outline, z * 0.2, STEEL);
        b.prism(
            "slot",
            Axis::Z,
            [0.0, y * 0.1, mid - z * 0.2],
            &rounded_by_share((hx * 0.2, hx * 0.2), 1.0),
            z * 0.4,
            BLACK_PLASTIC,
        );
        grip(b, [0.0, -y / 2.0, mid], [0.0, y * 0.1, mid], (hx * 0.95, mid), handle);
    }
}

/// Tools with two levers: can openers, garlic presses and scissors.
pub(super) fn levers(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let handle = b.choose(&[BLACK_PLASTIC, RED_PLASTIC, STEEL, GREEN_PLASTIC]);
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
        b.rounded_block("key", [-hx * 0.95, y * 0.24, z * 0.8], [hx * 0.95, y * 0.32, z], z * 0.1, handle);
    } else {
        b.taper("press", [0.0, y * 0.36, 0.0], (hx * 0.7, y * 0.12), (hx * 0.8, y * 0.13), z * 0.8, STEEL);
        b.cylinder("plunger", [0.0, y * 0.36, z * 0.7], hx * 0.45, z * 0.3, STEEL);
        b.rod("pin", [-hx, y * 0.49, mid], [hx, y * 0.49, mid], (z * 0.12).min(y * 0.01), STEEL);
    }
}

fn scissors(b: &mut Build<'_>, handle: MaterialId) {
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
        let mut bow = level_oval(centre, (ox, oy));
        bow.push(bow[0]);
        planar_tube(b, "bow", &bow, r, [0.0, 0.0, 1.0], handle);
        planar_tube(
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

/// A bottle opener: a bar with a claw for crown caps.
pub(super) fn bottle_opener(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.choose(&[STEEL, CHROME, BRASS, BLACK_METAL]);
    let handle = b.choose(&[mat, b.style.wood, BLACK_PLASTIC, RED_PLASTIC]);
    let t = (z * 0.3).min(x * 0.12);
    let (hx, mid) = (x / 2.0, z / 2.0);
    let mut ring = level_oval([0.0, y / 2.0 - hx, mid], (hx - t, hx - t));
    ring.push(ring[0]);
    planar_tube(b, "ring", &ring, t, [0.0, 0.0, 1.0], mat);
    b.block("claw", [-hx * 0.5, y / 2.0 - x * 0.95, mid - t * 0.5], [hx * 0.5, y / 2.0 - x * 0.75, mid + t * 0.5], mat);
    grip(b, [0.0, -y / 2.0, mid], [0.0, y / 2.0 - x * 0.92, mid], (hx * 0.7, mid), handle);
}

/// A corkscrew: a spiral on a cross grip.
pub(super) fn corkscrew(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let handle = b.choose(&[b.style.wood, BLACK_PLASTIC, WALNUT, CHROME]);
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
    loft_columns(b, "screw", &rings, STEEL);
}

/// A pizza cutter: a wheel on a grip.
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

/// A cookie cutter: a strip of metal bent to a star, a heart, a man or a ring.
pub(super) fn cookie_cutter(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.choose(&[STEEL, ALUMINIUM, COPPER, RED_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC]);
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
    crate::solid::ring_skin(b, "cutter", &rings, mat);
}

/// A cutting board of wood or plastic with a groove, a hole or a handle.
pub(super) fn cutting_board(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let mat = b.choose(&[b.style.wood, BAMBOO, BEECH, MAPLE, WHITE_PLASTIC, GREEN_PLASTIC, SLATE_TILE]);
    let round = b.choose(&[0.1, 0.2, 0.4]);
    let handled = b.rng.chance(0.4);
    let end = if handled { hy - y * 0.2 } else { hy };
    let shift = end - hy;
    let outline: Vec<_> =
        rounded_by_share((hx, (end + hy) / 2.0), round).iter().map(|p| (p.0, p.1 + shift / 2.0)).collect();
    let plate = if b.rng.chance(0.3) { z * 0.8 } else { z };
    b.prism("board", Axis::Z, [0.0; 3], &outline, plate, mat);
    let groove = 0.0008_f32.min(z * 0.1);
    if plate < z {
        let half = (hx, (end + hy) / 2.0);
        let ring = |z: f32, k: f32| {
            rounded_ring(z, (half.0 - k, half.1 - k), round)
                .into_iter()
                .map(|p| [p[0], p[1] + shift / 2.0, p[2]])
                .collect::<Vec<P>>()
        };
        let (k, w) = (x * 0.03, x * 0.055);
        let low = plate - groove;
        crate::solid::ring_skin(b, "edge", &[ring(low, k), ring(z, k), ring(z, w), ring(low, w), ring(low, k)], mat);
    }
    if handled {
        let neck: Vec<_> =
            rounded_by_share((hx * 0.22, y * 0.13), 0.9).iter().map(|p| (p.0, p.1 + hy - y * 0.13)).collect();
        b.prism("handle", Axis::Z, [0.0, 0.0, z * 0.01], &neck, plate * 0.97, mat);
        b.cylinder("hole", [0.0, hy - y * 0.05, plate * 0.9], hx * 0.07, plate * 0.09, BLACK_PLASTIC);
    } else if b.rng.chance(0.5) {
        let slot: Vec<_> = rounded_by_share((hx * 0.07, y * 0.07), 1.0);
        b.prism("slot", Axis::Z, [hx * 0.82, 0.0, plate - groove], &slot, 2.0 * groove, BLACK_PLASTIC);
    }
    b.top("top", [0.0, shift / 2.0, plate], ((hx - x * 0.06).min(hx * 0.7), (end + hy) / 2.0 * 0.86));
}

/// A knife sharpener with slots, or a honing steel with a grip.
pub(super) fn knife_sharpener(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let handle = b.choose(&[BLACK_PLASTIC, RED_PLASTIC, b.style.wood]);
    if y > 0.26 {
        let r = x.min(z) / 2.0;
        b.rod("steel", [0.0, -y * 0.12, r], [0.0, y / 2.0, r], r * 0.35, STEEL);
        b.rod("guard", [0.0, -y * 0.13, r], [0.0, -y * 0.11, r], r, STEEL);
        return grip(b, [0.0, -y / 2.0, r], [0.0, -y * 0.12, r], (r * 0.85, r * 0.85), handle);
    }
    b.rounded_block("base", [-x / 2.0, -y / 2.0, 0.0], [x / 2.0, y / 2.0, z * 0.3], z * 0.1, handle);
    b.rounded_block("head", [-x * 0.45, 0.0, z * 0.2], [x * 0.45, y * 0.45, z], z * 0.15, STEEL);
    for i in 0..3 {
        let at = y * (0.09 + 0.13 * i as f32);
        b.block("slot", [-x * 0.46, at - y * 0.012, z * 0.55], [x * 0.46, at + y * 0.012, z * 0.98], BLACK_PLASTIC);
    }
    let loop_ = arch([0.0, -y * 0.22, z * 0.25], [0.0, y * 0.2, 0.0], [0.0, 0.0, z * 0.5]);
    planar_tube(b, "handle", &loop_, (z * 0.12).min(x * 0.3), ACROSS, handle);
}
