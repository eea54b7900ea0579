//! Periodic noise, so that tiles fit together.

/// A hash of a lattice point as a number from 0 to 1 (multiply-xorshift).
pub(super) fn hash(x: i32, y: i32, seed: u32) -> f32 {
    let mut h =
        (x as u32).wrapping_mul(0x9e37_79b1) ^ (y as u32).wrapping_mul(0x85eb_ca77) ^ seed.wrapping_mul(0xc2b2_ae3d);
    h = (h ^ (h >> 15)).wrapping_mul(0x2c1b_3c6d);
    h = (h ^ (h >> 12)).wrapping_mul(0x297a_2d39);
    ((h ^ (h >> 15)) >> 8) as f32 / (1 << 24) as f32
}

/// Smooth periodic noise from 0 to 1 over the unit square, with `across` by `down` cells.
pub(super) fn value(u: f32, v: f32, (across, down): (i32, i32), seed: u32) -> f32 {
    let (x, y) = (u * across as f32, v * down as f32);
    let (cx, cy) = (x.floor(), y.floor());
    let ease = |t: f32| t * t * (3.0 - 2.0 * t);
    let (fx, fy) = (ease(x - cx), ease(y - cy));
    let at = |i: i32, j: i32| hash((cx as i32 + i).rem_euclid(across), (cy as i32 + j).rem_euclid(down), seed);
    let mix = |a: f32, b: f32, t: f32| a + (b - a) * t;
    mix(mix(at(0, 0), at(1, 0), fx), mix(at(0, 1), at(1, 1), fx), fy)
}

/// A sum of octaves of [`value`], each twice as fine and half as strong; 0 to 1.
pub(super) fn octaves(u: f32, v: f32, (across, down): (i32, i32), count: u32, seed: u32) -> f32 {
    let (mut sum, mut weight, mut total) = (0.0, 1.0, 0.0);
    for octave in 0..count {
        let scale = 1 << octave;
        sum += weight * value(u, v, (across * scale, down * scale), seed + octave);
        total += weight;
        weight *= 0.5;
    }
    sum / total
}

/// Distances to the nearest and the second nearest of random points, one in each cell (Worley noise); periodic.
pub(super) fn cells(u: f32, v: f32, count: i32, seed: u32) -> (f32, f32) {
    let (x, y) = (u * count as f32, v * count as f32);
    let (cx, cy) = (x.floor() as i32, y.floor() as i32);
    let mut best = (9.0_f32, 9.0_f32);
    for (i, j) in (-1..=1).flat_map(|i| (-1..=1).map(move |j| (i, j))) {
        let (gx, gy) = ((cx + i).rem_euclid(count), (cy + j).rem_euclid(count));
        let dx = (cx + i) as f32 + hash(gx, gy, seed) - x;
        let dy = (cy + j) as f32 + hash(gx, gy, seed + 1) - y;
        let d = (dx * dx + dy * dy).sqrt();
        best = if d < best.0 { (d, best.0) } else { (best.0, best.1.min(d)) };
    }
    best
}
