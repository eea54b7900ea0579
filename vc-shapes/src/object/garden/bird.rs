//! Baths, tables and houses for birds.

use std::f32::consts::TAU;

use crate::material::*;
use crate::solid::{Axis, Build, P, at_least, blob, polar, polygon, torus_profile};

/// A bird bath: a basin with water on a foot.
pub(super) fn bird_bath(b: &mut Build<'_>) {
    at_least(b, [0.15, 0.15, 0.22]);
    let r = b.size.x.min(b.size.y) / 2.0;
    let guest = if b.rng.chance(0.3) { 0.03_f32.min(r * 0.2) } else { 0.0 };
    let h = b.size.z - guest * 0.8;
    let mat = b.choose(&[CONCRETE, SANDSTONE, GRANITE, POTTERY, BLUE_GLAZE, COPPER, MARBLE]);
    let deep = (h * 0.16).min(r * 0.45);
    let (base, waist) = (r * b.vary(0.55, 0.75), r * b.vary(0.18, 0.35));
    let low = h - deep;
    let mut column = vec![(base, 0.0), (base, h * 0.05), (base * 0.75, h * 0.09), (waist, h * 0.16)];
    if b.rng.chance(0.5) {
        column.extend([(waist * 1.1, h * 0.4), (waist * 1.5, h * 0.46), (waist * 1.1, h * 0.52)]);
    }
    column.extend([(waist * 0.85, low * 0.9), (waist * 1.3, low + 0.005)]);
    b.lathe("foot", [0.0; 3], &column, mat);
    let full = b.vary(0.45, 0.8);
    basin(b, [0.0, 0.0, low], (r, deep), full, mat);
    if guest > 0.0 {
        let (px, py) = polar(b.vary(0.0, TAU), r - 0.025);
        bird(b, [px, py, h], guest);
    }
}

/// A bowl with water standing on a point; its surface is a surface inside.
fn basin(b: &mut Build<'_>, at: P, (r, deep): (f32, f32), full: f32, mat: MaterialId) {
    let t = (deep * 0.22).clamp(0.006, 0.04);
    let profile = [
        (r * 0.35, 0.0),
        (r * 0.85, deep * 0.5),
        (r, deep * 0.85),
        (r, deep),
        (r - t, deep),
        (r * 0.82 - t * 0.5, deep * 0.55),
        (r * 0.3, t),
        (0.0, t),
    ];
    b.lathe("basin", at, &profile, mat);
    let level = t + (deep - t) * full;
    let wide = (r - t) * if full > 0.6 { 0.9 } else { 0.75 };
    b.lathe("water", at, &[(r * 0.3, t * 0.6), (wide, level - 0.004), (wide, level)], WATER);
    b.inside("basin", [at[0], at[1], at[2] + level], (wide * 0.6, wide * 0.6), deep - level + 0.05);
}

/// A small bird standing on a point.
fn bird(b: &mut Build<'_>, at: P, size: f32) {
    let points = blob(b, [at[0], at[1], at[2] + size * 0.3], [size * 0.6, size, size * 0.5], 18, 0.05);
    let low = at[2] - 0.004;
    b.hull("bird", &points.into_iter().map(|p| [p[0], p[1], p[2].max(low)]).collect::<Vec<P>>(), BROWN_SKIN);
}

/// A bird table on a post, or a feeder that hangs or stands.
pub(super) fn bird_feeder(b: &mut Build<'_>) {
    at_least(b, [0.07, 0.07, 0.11]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (wood, roof) = (b.choose(&[PINE, OAK, TEAK, GREY_OAK, SAGE]), b.choose(&[RED, ASPHALT, GREEN, POTTERY, PINE]));
    let low = if h > 0.6 { h - (2.2 * x.max(y)).min(h * 0.45) } else { 0.0 };
    if low > 0.0 {
        let post = 0.022_f32.min(x * 0.25);
        b.block("post", [-post, -post, 0.01], [post, post, low + 0.004], wood);
        for (dx, dy) in [(1.0, 0.0), (0.0, 1.0)] {
            let (lx, ly) = (x * 0.9 * dx + post * 0.8 * dy, y * 0.9 * dy + post * 0.8 * dx);
            b.block("foot", [-lx, -ly, 0.0], [lx, ly, 0.03 - 0.002 * dx], wood);
        }
    }
    let (t, eaves) = (0.01, low + (h - low) * 0.6);
    b.block("tray", [-x * 0.9, -y * 0.9, low], [x * 0.9, y * 0.9, low + t], wood);
    let lip = low + t + 0.018;
    for side in [-1.0, 1.0] {
        let (cx, cy) = (side * (x * 0.9 - t / 2.0), side * (y * 0.9 - t / 2.0));
        b.block("lip", [cx - t / 2.0, -y * 0.9, low + t], [cx + t / 2.0, y * 0.9, lip], wood);
        b.block("lip", [-x * 0.9 + t, cy - t / 2.0, low + t], [x * 0.9 - t, cy + t / 2.0, lip - 0.002], wood);
        for sx in [-1.0, 1.0] {
            let cx = sx * (x * 0.9 - t * 1.6);
            let cy = side * (y * 0.9 - t * 1.6);
            b.cylinder("post", [cx, cy, low + t * 0.5], t * 0.55, eaves - low, wood);
        }
    }
    let hang = if low > 0.0 { 0.0 } else { 0.03_f32.min(h * 0.1) };
    let ridge = h - hang;
    let slope = |s: f32| [(s * y, eaves), (s * y, eaves + t), (0.0, ridge), (0.0, ridge - t * 1.4)];
    for s in [-1.0, 1.0] {
        b.prism("roof", Axis::X, [-x, 0.0, 0.0], &slope(s), 2.0 * x, roof);
    }
    for cx in [-x * 0.9 + t * 1.6, x * 0.9 - t * 1.6] {
        b.block("tie", [cx - t * 0.4, -y * 0.88, eaves - 0.004], [cx + t * 0.4, y * 0.88, eaves + t * 0.8], wood);
        b.block("king", [cx - t * 0.35, -t * 0.5, eaves], [cx + t * 0.35, t * 0.5, ridge - t * 0.6], wood);
    }
    if hang > 0.0 {
        b.lathe_along(
            "ring",
            [0.0, -0.003, ridge + hang * 0.45],
            [0.0, 1.0, ridge + hang * 0.45],
            &torus_profile(hang * 0.42, 0.003),
            IRON,
        );
    }
    b.inside("compartment", [0.0, 0.0, low + t], (x * 0.9 - 3.0 * t, y * 0.9 - 3.0 * t), eaves - low - t - 0.01);
}

/// A nesting box: a hole in front, a perch, a roof.
pub(super) fn bird_house(b: &mut Build<'_>) {
    at_least(b, [0.07, 0.06, 0.1]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, roof) = (
        b.choose(&[PINE, OAK, BIRCH, SKY, SAGE, RED, YELLOW, GREY_OAK]),
        b.choose(&[RED, ASPHALT, FOREST, PINE, WHITE, RUST]),
    );
    let t = 0.01;
    let gable = b.rng.chance(0.5);
    let eaves = h * if gable { b.vary(0.62, 0.72) } else { 0.82 };
    let (bx, by) = (x - 0.025, y * 0.82);
    let back = -x;
    b.block("back", [back, -by, 0.0], [back + t, by, eaves], mat);
    b.block("floor", [back + t, -by, 0.002], [bx, by, 0.002 + t], mat);
    for side in [-1.0, 1.0] {
        let cy = side * (by - t / 2.0);
        b.block("side", [back + t, cy - t / 2.0, 0.002 + t], [bx - t, cy + t / 2.0, eaves], mat);
    }
    // The front, in pieces around its hole.
    let (r, z) = ((by * 0.36).min(0.025), eaves * b.vary(0.58, 0.66));
    let ring: Vec<(f32, f32)> = polygon(12, r, 0.0).into_iter().map(|(py, pz)| (py, z + pz)).collect();
    let half = |s: f32| -> Vec<(f32, f32)> {
        let mut outline = vec![(0.0, 0.002 + t), (s * by, 0.002 + t), (s * by, eaves)];
        outline.push((0.0, eaves));
        outline.extend(ring.iter().copied().filter(|p| p.0 * s > -1e-4).collect::<Vec<_>>().into_iter().fold(
            Vec::new(),
            |mut sorted: Vec<(f32, f32)>, p| {
                let at = sorted.iter().position(|q| q.1 < p.1).unwrap_or(sorted.len());
                sorted.insert(at, p);
                sorted
            },
        ));
        outline
    };
    for s in [-1.0, 1.0] {
        b.prism("front", Axis::X, [bx - t, 0.0, 0.0], &half(s), t, mat);
    }
    b.rod("perch", [bx - 0.004, 0.0, z - r - 0.018], [x - 0.002, 0.0, z - r - 0.018], 0.004, b.style.wood);
    if gable {
        for s in [-1.0, 1.0] {
            b.prism(
                "roof",
                Axis::X,
                [-x + 0.002, 0.0, 0.0],
                &[(0.0, h - t * 1.3), (s * y, eaves - t), (s * y, eaves), (0.0, h)],
                2.0 * x - 0.004,
                roof,
            );
        }
        for cx in [back + 0.002, bx - t - 0.002] {
            b.prism(
                "gable",
                Axis::X,
                [cx + 0.001, 0.0, 0.0],
                &[(-by, eaves - 0.002), (by, eaves - 0.002), (0.0, h - t * 1.3)],
                t * 0.9,
                mat,
            );
        }
    } else {
        b.prism(
            "roof",
            Axis::Y,
            [0.0, -y, 0.0],
            &[(-x + 0.002, h - t), (-x + 0.002, h), (x, eaves + t), (x, eaves - 0.001), (-x + 0.002, eaves - 0.001)],
            2.0 * y,
            roof,
        );
    }
    b.inside(
        "compartment",
        [(back + bx) / 2.0, 0.0, 0.002 + t],
        ((bx - back) / 2.0 - t - 0.004, by - t - 0.004),
        eaves - t - 0.01,
    );
}
