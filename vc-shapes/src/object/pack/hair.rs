//! Hair care tools.

use crate::material::*;
use crate::solid::{Axis, Build, P, dims, loft_columns, rounded_ring, sweep};

/// A comb lying flat: a back with coarse and fine teeth.
pub(super) fn comb(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.choose(&[BLACK_PLASTIC, BROWN_PLASTIC, BLUE_PLASTIC, BAMBOO]);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let handled = b.rng.chance(0.4);
    let start = if handled { -hy * 0.2 } else { -hy };
    let count = 26;
    let pitch = (hy - start) / count as f32;
    let mut outline = vec![(-hx, start), (-hx * 0.9, hy), (hx, hy)];
    for i in 0..count {
        let at = hy - pitch * (i as f32 + 0.35);
        outline.extend([
            (hx, at),
            (-hx * 0.25, at - pitch * 0.05),
            (-hx * 0.25, at - pitch * 0.5),
            (hx, at - pitch * 0.55),
        ]);
    }
    outline.push((hx, start));
    b.prism("comb", Axis::Z, [0.0; 3], &outline, z, mat);
    if handled {
        let grip = [
            (-hx * 0.9, start + hy * 0.02),
            (hx * 0.3, start + hy * 0.02),
            (0.0, -hy * 0.95),
            (-hx * 0.4, -hy),
            (-hx * 0.8, -hy * 0.95),
        ];
        b.prism("grip", Axis::Z, [0.0, 0.0, z * 0.1], &grip, z * 0.8, mat);
    }
}

/// Brushes for hair and body lie on their back, scrubbing brushes on their bristles.
pub(super) fn brush(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let scrub = b.class == "scrubbing_brush";
    let (back, bristle) = if scrub {
        (b.choose(&[BEECH, WHITE_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC]), b.choose(&[HAY, WHITE_PLASTIC, BLACK_PLASTIC]))
    } else {
        (b.choose(&[BEECH, BLACK_PLASTIC, PINK_PLASTIC, WALNUT, BAMBOO]), b.choose(&[BLACK_PLASTIC, HAY]))
    };
    let (hx, hy) = (x / 2.0, y / 2.0);
    let handled = y > x * 2.6;
    let head = if handled { hy * 0.1 } else { -hy };
    let (mid, half) = (f32::midpoint(head, hy), (hy - head) / 2.0);
    let body = z * 0.42;
    let shift = |ring: Vec<P>| -> Vec<P> { ring.into_iter().map(|p| [p[0], p[1] + mid, p[2]]).collect() };
    let lift = if scrub { z - body } else { 0.0 };
    let at = |z: f32, k: f32| shift(rounded_ring(z + lift, (hx * k, half * k), 0.9));
    loft_columns(b, "back", &[at(0.0, 0.9), at(body * 0.4, 1.0), at(body * 0.8, 0.98), at(body, 0.88)], back);
    if !scrub {
        let pad = shift(rounded_ring(body * 0.95, (hx * 0.8, half * 0.85), 1.0));
        let top = shift(rounded_ring(body * 1.2, (hx * 0.65, half * 0.72), 1.0));
        loft_columns(b, "pad", &[pad, top], RED_RUBBER);
    }
    let (rows, columns) = (4, 7);
    let (low, high) = if scrub { (0.0, lift + body * 0.1) } else { (body, z) };
    for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
        let (u, v) = (i as f32 / (rows - 1) as f32 * 2.0 - 1.0, j as f32 / (columns - 1) as f32 * 2.0 - 1.0);
        if u * u * 0.6 + v * v * 0.6 > 1.0 {
            continue;
        }
        let (cx, cy) = (hx * 0.62 * u, mid + half * 0.75 * v);
        let w = if scrub { hx * 0.13 } else { hx * 0.035 };
        b.block("bristle", [cx - w, cy - w, low], [cx + w, cy + w, high], bristle);
    }
    if handled {
        let (r, level_) = ((body * 0.5).min(hx * 0.4), lift + body * 0.5);
        let path = [
            ([0.0, -hy, level_], r * 0.6, r * 0.6),
            ([0.0, -hy * 0.95, level_], r * 1.1, r * 0.9),
            ([0.0, -hy * 0.5, level_], r * 1.3, r * 0.98),
            ([0.0, head - hy * 0.08, level_], r * 0.8, r * 0.8),
            ([0.0, head + half * 0.2, level_], r, r * 0.8),
        ];
        sweep(b, "grip", &path, [1.0, 0.0, 0.0], back);
    }
}

/// A hair dryer lying on its side edge: barrel, nozzle and grip.
pub(super) fn hair_dryer(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let body = b.choose(&[BLACK_PLASTIC, WHITE_PLASTIC, PINK_PLASTIC, PURPLE_PLASTIC, RED_PLASTIC]);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let r = hx.min(z * 0.24);
    let axis = z - r;
    let barrel: Vec<_> = [(0.65, 0.008), (0.95, 0.1), (1.0, 0.3), (0.9, 0.6), (0.7, 0.75), (0.68, 0.8)]
        .iter()
        .map(|p| (p.0 * r, p.1 * y))
        .collect();
    b.lathe_along("barrel", [0.0, -hy, axis], [0.0, hy, axis], &barrel, body);
    let nozzle: Vec<_> = [(0.6, 0.78), (0.75, 0.8), (0.66, 1.0)].iter().map(|p| (p.0 * r, p.1 * y)).collect();
    b.lathe_along("nozzle", [0.0, -hy, axis], [0.0, hy, axis], &nozzle, BLACK_PLASTIC);
    b.rod("grille", [0.0, -hy, axis], [0.0, -hy + y * 0.015, axis], r * 0.5, GREY_PLASTIC);
    let w = r * 0.42;
    let path = [
        ([0.0, -hy * 0.25, axis - r * 0.5], w, w * 1.2),
        ([0.0, -hy * 0.3, z * 0.45], w * 0.9, w * 1.1),
        ([0.0, -hy * 0.38, z * 0.12], w, w * 1.2),
        ([0.0, -hy * 0.4, 0.0], w * 0.8, w),
    ];
    sweep(b, "grip", &path, [1.0, 0.0, 0.0], body);
    b.block(
        "switch",
        [-w * 0.3, -hy * 0.3 + w * 0.9, z * 0.36],
        [w * 0.3, -hy * 0.3 + w * 1.3, z * 0.46],
        GREY_PLASTIC,
    );
}

/// A lying hair straightener: two long jaws with plates.
pub(super) fn hair_straightener(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let body = b.choose(&[BLACK_PLASTIC, WHITE_PLASTIC, PINK_PLASTIC, PURPLE_PLASTIC]);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let t = z * 0.36;
    for up in [false, true] {
        let arm = |k: f32, open: f32, w: f32, thick: f32| {
            let level_ = if up { t / 2.0 + (z - t) * open } else { t / 2.0 };
            ([0.0, -hy + y * k, level_], hx * w, t / 2.0 * thick)
        };
        let path = [
            arm(0.0, 0.45, 0.6, 0.6),
            arm(0.05, 0.5, 0.9, 1.0),
            arm(0.45, 0.75, 1.0, 1.0),
            arm(0.55, 0.8, 1.0, 1.0),
            arm(0.97, 1.0, 0.95, 0.9),
            arm(1.0, 1.0, 0.6, 0.6),
        ];
        sweep(b, "arm", &path, [1.0, 0.0, 0.0], body);
        let (z0, z1) = if up { (z - t * 1.1, z - t * 0.6) } else { (t * 0.6, t * 1.1) };
        b.block("plate", [-hx * 0.8, hy * 0.2, z0], [hx * 0.8, hy * 0.88, z1], CHROME);
    }
    b.rod("hinge", [-hx * 0.9, -hy * 0.9, z * 0.42], [hx * 0.9, -hy * 0.9, z * 0.42], t * 0.5, GREY_PLASTIC);
}
