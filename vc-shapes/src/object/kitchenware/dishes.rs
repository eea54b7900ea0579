//! Plates, bowls and other tableware.

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{
    Build, arch, dims, ear, flat_ring, loft_columns, planar_tube, ring_skin, rounded_ring, tub, turn, vessel,
    vessel_profile,
};

/// Plates and saucers: with or without a rim, or square; some with a coloured ring.
pub(super) fn plate(b: &mut Build<'_>) {
    let (x, y, h) = dims(b);
    let r = x.min(y) / 2.0;
    let t = (h * 0.2).min(0.004);
    let mat = b.style.crockery;
    let saucer = b.class == "saucer";
    if !saucer && b.rng.chance(0.15) {
        tub(b, "plate", &[(0.0, x * 0.32, y * 0.32), (h * 0.3, x * 0.4, y * 0.4), (h, x / 2.0, y / 2.0)], 0.25, t, mat);
        b.top("top", [0.0, 0.0, t], (x * 0.27, y * 0.27));
        return;
    }
    let deep = b.class == "soup_plate";
    let flat = b.vary(0.56, 0.66);
    let coupe = b.rng.chance(0.4);
    let outside: Vec<(f32, f32)> = match (deep, coupe) {
        (true, _) => vec![(flat * 0.8, 0.0), (flat, 0.3), (flat + 0.1, 0.75), (1.0, 1.0)],
        (_, true) => vec![(flat, 0.0), (0.85, 0.3), (0.95, 0.65), (1.0, 1.0)],
        _ => vec![(flat, 0.0), (flat + 0.08, 0.3), (flat + 0.13, 0.55), (1.0, 1.0)],
    };
    let painted = b.rng.chance(0.4);
    let rim = if painted { (h * 0.06).min(0.0008) } else { 0.0 };
    let outside: Vec<_> = outside.into_iter().map(|p| (p.0 * (r - rim), p.1 * (h - rim))).collect();
    b.lathe("plate", [0.0; 3], &vessel_profile(&outside, t), mat);
    if painted {
        let colour = b.choose(&[BLUE_GLAZE, GREEN_GLAZE, RED_GLAZE, YELLOW_GLAZE, BLACK_GLAZE]);
        flat_ring(b, "ring", (h * 0.88, h), (r * 0.955, r), colour);
    }
    if saucer {
        let well = flat * 0.7 * r;
        flat_ring(b, "well", (t * 0.8, t + h * 0.1), (well * 0.92, well), mat);
        b.top("top", [0.0, 0.0, t], (well * 0.62, well * 0.62));
        return;
    }
    let inner = outside[0].0 - t;
    b.top("top", [0.0, 0.0, t], (inner * 0.68, inner * 0.68));
    if deep {
        b.inside("inside", [0.0, 0.0, t], (inner * 0.6, inner * 0.6), (h - t).max(0.0));
    }
}

/// Outlines of bowls as fractions of their radius and height.
const BOWLS: [&[(f32, f32)]; 4] = [
    &[(0.45, 0.0), (0.47, 0.07), (0.72, 0.25), (0.9, 0.55), (1.0, 1.0)],
    &[(0.5, 0.0), (0.52, 0.06), (0.95, 0.95), (1.0, 1.0)],
    &[(0.62, 0.0), (0.85, 0.12), (0.96, 0.4), (1.0, 1.0)],
    &[(0.4, 0.0), (0.42, 0.12), (0.62, 0.2), (0.85, 0.45), (0.95, 0.75), (1.0, 1.0)],
];

/// Bowls of every size, from ramekins to salad bowls.
pub(super) fn bowl(b: &mut Build<'_>) {
    let (x, y, h) = dims(b);
    let r = x.min(y) / 2.0 - 0.0006;
    let mat = match b.class {
        "mixing_bowl" => b.choose(&[STEEL, WHITE_PLASTIC, GREEN_PLASTIC, PORCELAIN, GLASS]),
        "salad_bowl" => b.choose(&[b.style.wood, GLASS, b.style.crockery, BAMBOO, STEEL]),
        "ramekin" => b.choose(&[PORCELAIN, PORCELAIN, STONEWARE, RED_GLAZE, BLUE_GLAZE]),
        _ => b.style.crockery,
    };
    let t = (r * 0.05).min(h * 0.08).clamp(1e-4, 0.006);
    if b.class == "ramekin" {
        let mut outside = vec![(0.9, 0.0)];
        for i in 0..5 {
            let z = 0.06 + 0.16 * i as f32;
            outside.extend([(0.9, z), (0.94, z + 0.05)]);
        }
        outside.extend([(0.95, 0.88), (1.0, 0.92), (1.0, 1.0)]);
        vessel(b, "bowl", (r, h), &outside, t, mat);
        return;
    }
    let shape = b.choose(&BOWLS);
    let rimmed = b.rng.chance(0.5);
    let body = if rimmed { h - (h * 0.03).min(0.0008) } else { h };
    vessel(b, "bowl", (r, body), shape, t, mat);
    if rimmed {
        let colour = b.choose(&[mat, BLUE_GLAZE, GREEN_GLAZE, RED_GLAZE, STONEWARE]);
        flat_ring(b, "rim", (h * 0.93, h), (r - t * 1.3, r + 0.0005), colour);
    }
}

/// A fruit bowl of wood or ceramic, or a wire basket.
pub(super) fn fruit_bowl(b: &mut Build<'_>) {
    let (x, y, h) = dims(b);
    let t = (x.min(y) * 0.02).min(h * 0.06);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let metal = b.style.metal;
    if b.rng.chance(0.4) {
        let wire = (h * 0.03).min(0.003);
        let (gx, gy) = (hx - wire, hy - wire);
        loft_columns(
            b,
            "floor",
            &[rounded_ring(0.0, (gx * 0.5, gy * 0.5), 1.0), rounded_ring(wire, (gx * 0.52, gy * 0.52), 1.0)],
            metal,
        );
        for i in 0..12 {
            let (s, c) = (std::f32::consts::TAU * i as f32 / 12.0).sine_cosine();
            let at = |k: f32, z: f32| [gx * k * c, gy * k * s, z];
            let points = [at(0.48, wire), at(0.75, h * 0.15), at(0.93, h * 0.5), at(0.99, h - wire)];
            planar_tube(b, "wire", &points, wire, [-s, c, 0.0], metal);
        }
        let rim = [(h - 2.0 * wire, hx - wire, hy - wire), (h, hx, hy)];
        let ring = |z: f32, k: f32| crate::solid::level_oval([0.0, 0.0, z], (hx - k, hy - k));
        let (low, high) = (rim[0].0, rim[1].0);
        let rings = [ring(low, 0.0), ring(high, 0.0), ring(high, 2.5 * wire), ring(low, 2.5 * wire), ring(low, 0.0)];
        ring_skin(b, "rim", &rings, metal);
        b.inside("inside", [0.0, 0.0, wire], (gx * 0.34, gy * 0.34), (h - wire).max(0.0));
        b.top("top", [0.0, 0.0, wire], (gx * 0.34, gy * 0.34));
        return;
    }
    let mat = b.choose(&[b.style.wood, b.style.crockery, BAMBOO, STEEL, GLASS]);
    let sides =
        [(0.0, hx * 0.5, hy * 0.5), (h * 0.2, hx * 0.75, hy * 0.75), (h * 0.6, hx * 0.94, hy * 0.94), (h, hx, hy)];
    tub(b, "bowl", &sides, 1.0, t, mat);
    b.inside("inside", [0.0, 0.0, t], (hx * 0.32, hy * 0.32), (h - t).max(0.0));
    b.top("top", [0.0, 0.0, t], (hx * 0.32, hy * 0.32));
}

/// Long dishes: serving platters and trays.
pub(super) fn tray(b: &mut Build<'_>) {
    let (x, y, h) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let platter = b.class == "serving_platter";
    let mat =
        if platter { b.style.crockery } else { b.choose(&[b.style.wood, b.style.cabinet, BAMBOO, STEEL, BLACK_METAL]) };
    let round = if platter { b.choose(&[1.0, 0.9, 0.3]) } else { b.choose(&[0.1, 0.35, 0.15]) };
    let t = (h * 0.2).min(0.006);
    let grips = !platter && h > 0.03 && b.rng.chance(0.6);
    let rim = if grips { h * 0.6 } else { h };
    let foot = if platter { 0.68 } else { 0.93 };
    let sides = [(0.0, hx * foot, hy * foot), (rim * 0.35, hx * (foot + 0.04), hy * (foot + 0.04)), (rim, hx, hy)];
    tub(b, "tray", &sides, round, t, mat);
    if grips {
        let metal = b.style.metal;
        for side in [-1.0, 1.0] {
            let centre = [0.0, side * (hy - t * 0.7), rim - t];
            let radius = (t * 0.7).min((h - rim) * 0.3);
            let path = arch(centre, [hx * 0.4, 0.0, 0.0], [0.0, 0.0, h - rim + t - radius]);
            planar_tube(b, "grip", &path, radius, [0.0, 1.0, 0.0], metal);
        }
    }
    b.top("top", [0.0, 0.0, t], (hx * foot * 0.82 - t, hy * foot * if platter { 0.7 } else { 0.9 } - t));
}

/// A gravy boat: an oval bowl on a foot with a lip and a handle.
pub(super) fn gravy_boat(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, length) = (x / 2.0, y * 0.8);
    let t = (hx * 0.08).min(0.004);
    let mat = b.style.crockery;
    let outside = [
        (0.0, 0.45, 0.35, 0.0),
        (0.1, 0.42, 0.33, 0.0),
        (0.3, 0.75, 0.6, 0.0),
        (0.65, 0.95, 0.85, -0.05),
        (0.85, 1.0, 1.0, -0.12),
    ];
    let ring = |&(h, across, along, shift): &(f32, f32, f32, f32), thin: f32| {
        let half = (hx * across - thin, length / 2.0 * along - thin);
        let mut ring = crate::solid::level_oval([0.0, length * shift, (z * h).max(thin)], half);
        if h > 0.6 {
            // The lip is stretched outwards and upwards.
            ring.iter_mut().for_each(|p| {
                let lip = (-p[1] / length * 2.0 - 0.2).max(0.0);
                p[0] *= 1.0 - 0.5 * lip.min(1.0);
                p[2] += z * 0.12 * lip.min(1.25);
            });
        }
        ring
    };
    let rings: Vec<_> = outside.iter().map(|s| ring(s, 0.0)).chain(outside.iter().rev().map(|s| ring(s, t))).collect();
    loft_columns(b, "boat", &rings, mat);
    ear(b, (length * 0.36, length * 0.36 + y * 0.22), (z * 0.25, z * 0.85), t, mat);
    b.inside("inside", [0.0, 0.0, t], (hx * 0.24, length * 0.1), (z * 0.7).max(0.0));
}

/// A butter dish with a cover.
pub(super) fn butter_dish(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let t = (z * 0.06).min(0.004);
    let mat = b.choose(&[PORCELAIN, b.style.crockery, GLASS, STEEL]);
    let cover = b.choose(&[mat, b.style.wood, GLASS]);
    let (base, top) = (z * 0.2, z * 0.8);
    tub(b, "dish", &[(0.0, hx * 0.85, hy * 0.88), (base, hx, hy)], 0.3, t, mat);
    b.slide([0.0, 0.0, 1.0], z, |b| {
        let (cx, cy) = (hx * 0.8, hy * 0.84);
        let wall = |z: f32, k: f32, thin: f32| rounded_ring(z, (cx * k - thin, cy * k - thin), 0.3);
        let rings =
            [wall(t + 0.0005, 1.0, t), wall(t + 0.0005, 1.0, 0.0), wall(top * 0.9, 0.95, 0.0), wall(top, 0.85, 0.0)];
        let under = wall(top - t, 0.85, t);
        let rings: Vec<_> = [under].into_iter().chain(rings).collect();
        loft_columns(b, "cover", &rings, cover);
        turn(b, "knob", [0.0, 0.0, top - 0.001], (hx * 0.18, z - top + 0.001), KNOB, cover);
    });
    b.inside("inside", [0.0, 0.0, t], (hx * 0.62 - t, hy * 0.66 - t), (top * 0.85 - 2.0 * t).max(0.0));
}

/// A knob on a stem, as fractions of its radius and height.
pub(super) const KNOB: &[(f32, f32)] = &[(0.5, 0.0), (0.45, 0.35), (1.0, 0.6), (0.95, 0.85), (0.5, 1.0)];

/// A round sugar pot with a lid and two handles.
pub(super) fn sugar_bowl(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = (x / 2.0).min(y * 0.4);
    let mat = b.style.crockery;
    let t = (r * 0.08).min(0.004);
    let h = z * 0.7;
    let shape = b.choose(&[
        [(0.6, 0.0), (0.95, 0.3), (1.0, 0.6), (0.85, 1.0)],
        [(0.8, 0.0), (0.85, 0.1), (0.95, 0.5), (1.0, 1.0)],
        [(0.9, 0.0), (1.0, 0.08), (1.0, 0.5), (1.0, 1.0)],
    ]);
    vessel(b, "bowl", (r, h), &shape, t, mat);
    let rim = shape[3].0 * r;
    b.slide([0.0, 0.0, 1.0], z, |b| {
        turn(b, "lid", [0.0, 0.0, h + 0.0005], (rim, z * 0.12), &[(1.0, 0.0), (1.0, 0.2), (0.6, 0.8), (0.1, 1.0)], mat);
        turn(b, "knob", [0.0, 0.0, h + z * 0.11], (r * 0.22, z * 0.19), KNOB, mat);
    });
    let reach = y / 2.0 - r * 0.93;
    if reach > 0.01 {
        for turned in [0.0, std::f32::consts::PI] {
            b.at([0.0; 3], turned, |b| ear(b, (r * 0.93, y / 2.0), (h * 0.3, h * 0.8), r * 0.08, mat));
        }
    }
}

/// An egg cup: a small cup on a foot.
pub(super) fn egg_cup(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let mat = b.choose(&[b.style.crockery, PORCELAIN, YELLOW_GLAZE, b.style.wood, STEEL]);
    let foot = b.vary(0.7, 0.9);
    let profile = [
        (foot, 0.0),
        (foot * 0.95, 0.05),
        (0.35, 0.18),
        (0.3, 0.35),
        (0.75, 0.55),
        (0.97, 0.8),
        (1.0, 1.0),
        (0.88, 1.0),
        (0.8, 0.75),
        (0.5, 0.55),
    ];
    turn(b, "cup", [0.0; 3], (r, z), &profile, mat);
    b.inside("inside", [0.0, 0.0, z * 0.55], (r * 0.33, r * 0.33), z * 0.45);
}

/// A cake stand: a plate on a foot.
pub(super) fn cake_stand(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let mat = b.choose(&[b.style.crockery, PORCELAIN, GLASS, b.style.wood, MARBLE]);
    let (foot, waist) = (b.vary(0.4, 0.6), b.vary(0.08, 0.16));
    let plate = (0.015 / z).min(0.15);
    let profile = [
        (foot, 0.0),
        (foot * 0.9, 0.06),
        (waist * 1.4, 0.2),
        (waist, 0.5),
        (waist * 1.6, 1.0 - 2.0 * plate),
        (0.95, 1.0 - 1.2 * plate),
        (1.0, 1.0),
        (0.97, 1.0),
        (0.95, 1.0 - 0.5 * plate),
    ];
    turn(b, "stand", [0.0; 3], (r, z), &profile, mat);
    b.top("top", [0.0, 0.0, z * (1.0 - 0.5 * plate)], (r * 0.64, r * 0.64));
}
