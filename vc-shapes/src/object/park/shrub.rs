//! Bushes, hedges, rocks and stumps.

use std::f32::consts::TAU;

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Build, CORNERS, P, Sketch, blob, limb, polar, spaced};

const PETALS: &[MaterialId] = &[PETAL_RED, PETAL_WHITE, PETAL_YELLOW, PETAL_PINK, PETAL_BLUE];

/// A bush: loose, trimmed to a ball or a cone, or in flower.
pub(super) fn bush(b: &mut Build<'_>) {
    let leaves = b.choose(&[LEAF, DARK_LEAF, LIGHT_LEAF, GRASS, LEAF, AUTUMN_LEAF]);
    let mut sketch = Sketch::default();
    let design = b.rng.below(6);
    match design {
        0 => trimmed(b, &mut sketch, leaves),
        _ => loose(b, &mut sketch, leaves),
    }
    if design == 1 || design == 2 {
        let (mat, last) = (b.one_of(PETALS), sketch.count());
        let radius = b.size.min() * b.vary(0.03, 0.05);
        for _ in 0..b.rng.count(12, 30) {
            let mut any = || sketch.point(b.rng.below(last), b.rng.below(64));
            let (first, second) = (any(), any());
            let at = if first[2] > second[2] { first } else { second };
            let points = blob(b, at, [radius; 3], 10, 0.1);
            sketch.add("flower", points, mat);
        }
    }
    sketch.fill(b);
}

/// Several blobs that lean away from the centre.
fn loose(b: &mut Build<'_>, sketch: &mut Sketch, leaves: MaterialId) {
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (count, start) = (b.rng.count(4, 11), b.vary(0.0, TAU));
    for i in 0..count {
        let out = if i == 0 { 0.0 } else { b.vary(0.35, 0.6) };
        let (dx, dy) = polar(start + 2.399_963 * i as f32, out);
        let (wide, tall) = (b.vary(0.35, 0.55), b.vary(0.28, 0.42));
        let z = h * (tall + (1.0 - 2.0 * tall) * if i == 0 { 0.9 } else { b.vary(0.0, 0.8) });
        let points = b.rng.count(22, 36);
        let points = blob(b, [dx * x, dy * y, z], [wide * x, wide * y, tall * h], points, 0.35);
        sketch.add("leaves", points, leaves);
        sketch.add("stem", limb([0.0; 3], [dx * x, dy * y, z], 0.014, 0.008), BARK);
    }
}

/// A bush trimmed to a ball, an egg, a cone or stacked balls.
fn trimmed(b: &mut Build<'_>, sketch: &mut Sketch, leaves: MaterialId) {
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let stem = h * b.vary(0.03, 0.25);
    sketch.add("stem", limb([0.0; 3], [0.0, 0.0, h * 0.6], 0.03, 0.02), BARK);
    let count = b.rng.count(1, 3);
    let mut low = stem;
    for i in 0..count {
        let tall = (h - stem) / count as f32;
        let wide = 1.0 - 0.25 * i as f32;
        let points = blob(b, [0.0, 0.0, low + tall / 2.0], [x * wide, y * wide, tall * 0.55], 42, 0.04);
        sketch.add("leaves", points, leaves);
        low += tall;
    }
}

/// A rose bush: thorny stems, few leaves, large flowers.
pub(super) fn rose_bush(b: &mut Build<'_>) {
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (petal, leaves) = (b.one_of(PETALS), b.choose(&[LEAF, DARK_LEAF]));
    let mut sketch = Sketch::default();
    let (count, start) = (b.rng.count(5, 10), b.vary(0.0, TAU));
    let rose = b.size.min() * b.vary(0.07, 0.11);
    for i in 0..count {
        let (dx, dy) = polar(start + 2.399_963 * i as f32, if i == 0 { 0.1 } else { b.vary(0.5, 0.85) });
        let head = [dx * x, dy * y, h * b.vary(0.65, 0.92)];
        sketch.add("stem", limb([0.0; 3], head, 0.011, 0.006), LEAF);
        let half = [head[0] * 0.75, head[1] * 0.75, head[2] * b.vary(0.45, 0.75)];
        let points = blob(b, half, [x * 0.3, y * 0.3, h * 0.14], 18, 0.4);
        sketch.add("leaves", points, leaves);
        let points = blob(b, head, [rose, rose, rose * 0.8], 20, 0.15);
        sketch.add("rose", points, petal);
        let points = blob(b, [head[0], head[1], head[2] + rose * 0.5], [rose * 0.55, rose * 0.55, rose * 0.6], 12, 0.1);
        sketch.add("rose", points, petal);
    }
    sketch.fill(b);
}

/// A hedge: trimmed square, tapered or rounded, or left to grow.
pub(super) fn hedge(b: &mut Build<'_>) {
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let leaves = b.choose(&[LEAF, DARK_LEAF, DARK_LEAF, LIGHT_LEAF]);
    let section: &[(f32, f32)] = match b.rng.below(4) {
        0 => &[(1.0, 0.0), (1.0, 1.0), (-1.0, 1.0), (-1.0, 0.0)],
        1 => &[(1.0, 0.0), (0.7, 1.0), (-0.7, 1.0), (-1.0, 0.0)],
        2 => &[(0.9, 0.0), (1.0, 0.5), (0.75, 0.85), (0.3, 1.0), (-0.3, 1.0), (-0.75, 0.85), (-1.0, 0.5), (-0.9, 0.0)],
        _ => &[(0.8, 0.0), (1.0, 0.3), (0.9, 0.8), (0.4, 1.0), (-0.4, 1.0), (-0.9, 0.8), (-1.0, 0.3), (-0.8, 0.0)],
    };
    let rough = b.vary(0.02, 0.09);
    let count = ((2.0 * y / b.vary(0.35, 0.6)) as usize).clamp(3, 24);
    let step = 2.0 * y / count as f32;
    let mut sketch = Sketch::default();
    for cy in spaced(count, -y + step / 2.0, y - step / 2.0) {
        let mut points: Vec<P> = Vec::new();
        for side in [-0.56, 0.0, 0.56] {
            let bulge = if side == 0.0 { 1.0 } else { 1.0 - rough };
            for &(sx, sz) in section {
                let jitter = 1.0 - b.vary(0.0, rough);
                let z = if sz == 0.0 { 0.0 } else { sz * h * jitter * bulge };
                points.push([sx * x * jitter * bulge, cy + side * step, z]);
            }
        }
        sketch.add("leaves", points, leaves);
    }
    sketch.fill(b);
}

/// A rock, or a large one with smaller ones beside it; its top is flat enough to support an object.
pub(super) fn rock(b: &mut Build<'_>) {
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = b.choose(&[ROCK, ROCK, GRANITE, SANDSTONE, GRAVEL, BLACK_GRANITE]);
    let main = if b.rng.chance(0.3) { b.vary(0.7, 0.82) } else { 1.0 };
    let flat = (x * main * b.vary(0.25, 0.45), y * main * b.vary(0.25, 0.45));
    let (points, dent) = (b.rng.count(14, 40), b.vary(0.1, 0.4));
    let centre = [-x * (1.0 - main), -y * (1.0 - main), h * b.vary(0.3, 0.45)];
    let mut points = blob(b, centre, [x * main, y * main, h * 0.6], points, dent);
    points.iter_mut().for_each(|p| p[2] = p[2].max(0.0).min(h * 0.97));
    // These points reach the extents whatever the dents.
    points.extend([-1.0_f32, 1.0].map(|s| [centre[0] + s * x * main, centre[1], centre[2]]));
    points.extend([-1.0_f32, 1.0].map(|s| [centre[0], centre[1] + s * y * main, centre[2]]));
    for (sx, sy) in CORNERS {
        points.push([centre[0] + sx * flat.0, centre[1] + sy * flat.1, h]);
        points.push([centre[0] + sx * x * main * 0.6, centre[1] + sy * y * main * 0.6, 0.0]);
    }
    b.hull("rock", &points, mat);
    b.top("top", [centre[0], centre[1], h], (flat.0 * 0.95, flat.1 * 0.95));
    if main < 1.0 {
        // The small rocks lean on the large one.
        let (r, c) = (1.5 * (1.0 - main), main - 1.0);
        for (sx, sy) in [(1.0 - r, c), (c, 1.0 - r)] {
            let tall = h * b.vary(0.35, 0.55);
            let mut points = blob(b, [sx * x, sy * y, tall * 0.4], [r * x, r * y, tall * 0.6], 20, 0.25);
            points.iter_mut().for_each(|p| p[2] = p[2].max(0.0));
            points.push([c * x + (sx - c) * x * 0.5, c * y + (sy - c) * y * 0.5, h * 0.1]);
            b.hull("rock", &points, mat);
        }
    }
}

/// A tree stump: flared over roots, or a plain chopping block.
pub(super) fn stump(b: &mut Build<'_>) {
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let bark = b.choose(&[BARK, BARK, PALE_BARK]);
    let wood = b.choose(&[PINE, OAK, BEECH]);
    let rooted = b.rng.chance(0.6);
    let top = if rooted { r * b.vary(0.6, 0.72) } else { r };
    let waist = top * b.vary(0.9, 0.99);
    let foot = if rooted { r * 0.85 } else { r * 0.98 };
    let flare = h * b.vary(0.2, 0.45);
    b.lathe("bark", [0.0; 3], &[(foot, 0.0), (waist, flare), (waist, h * 0.8), (top, h - 0.006)], bark);
    for (share, level, mat) in [(0.93, 0.017, wood), (0.72, 0.018, BEECH), (0.5, 0.019, wood), (0.25, 0.02, BEECH)] {
        b.cylinder("ring", [0.0, 0.0, h - 0.02], top * share, level, mat);
    }
    if rooted {
        let (count, start) = (b.rng.count(3, 7), b.vary(0.0, TAU));
        for i in 0..count {
            let angle = start + TAU * i as f32 / count as f32;
            let ((x0, y0), (x1, y1)) = (polar(angle, waist * 0.75), polar(angle, r * b.vary(0.88, 0.95)));
            let thick = r * 0.16;
            let mut points = limb([x0, y0, h * b.vary(0.25, 0.5)], [x1, y1, thick * 0.3], thick, thick * 0.3);
            let reach = |p: &mut P| {
                p[2] = p[2].max(0.0);
                let out = p[0].hypotenuse(p[1]);
                let cut = (r / out.max(1e-6)).min(1.0);
                (p[0], p[1]) = (p[0] * cut, p[1] * cut);
            };
            points.iter_mut().for_each(reach);
            b.hull("root", &points, bark);
        }
    }
    b.top("top", [0.0, 0.0, h], (top * 0.6, top * 0.6));
}
