//! Penumbrae: the soft edges of shadows.
//!
//! The width of an edge is found from the blockers near a point (Fernando 2005); then depth comparisons all
//! over that width are averaged (Reeves, Salesin and Cook 1987).

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

use super::lookup::{LANES, column};
use super::shadow::ShadowMap;
use crate::math::simd::whole;

/// Number of points spread evenly over a disc.
const POINTS: usize = 12;
/// Vogel's spiral, padded with four points to fill vectors.
const DISC_POINTS: [[f32; LANES]; 2] = [
    [
        0.20412, -0.26070, 0.03990, 0.32859, -0.60301, 0.57122, -0.19106, -0.36438, 0.79056, -0.82244, 0.39647,
        0.29298, 0.0, 0.0, 0.0, 0.0,
    ],
    [
        0.00000, 0.23882, -0.45469, 0.42859, -0.10666, -0.36337, 0.71075, -0.70159, 0.28871, 0.33949, -0.84724,
        0.93407, 0.0, 0.0, 0.0, 0.0,
    ],
];
type Lanes = [f32; LANES];

/// Radius of the sharpest edges that the texels allow, texels.
const SHARP: f32 = 1.0;

impl ShadowMap {
    /// The share of light at a point whose neighbourhood is neither all in front of it nor all behind.
    #[inline(always)]
    pub(super) fn share(&self, place: [f32; 2], z: f32, slope: [f32; 2], least: f32) -> f32 {
        let widest = self.edge(z, least);
        if widest <= SHARP {
            return self.sharp(place, z, slope);
        }
        let reach = widest + 1.0;
        let (mut at, mut found) = ([0_u32; LANES], [f32::INFINITY; LANES]);
        let [x, y] = around(place, reach, 0.0, self.side as f32 - 1.0);
        for i in 0..LANES {
            at[i] = self.row(whole(y[i].floor())) + column(whole(x[i].floor()));
        }
        for i in 0..POINTS {
            found[i] = self.depth[at[i] as usize];
        }
        let limits = self.limits(z, slope, reach);
        let (mut depth, mut count) = ([0.0_f32; LANES / 2], [0_u32; LANES / 2]);
        for half in [0, LANES / 2] {
            for i in 0..LANES / 2 {
                let blocks = found[half + i] < limits[half + i];
                depth[i] += if blocks { found[half + i] } else { 0.0 };
                count[i] += u32::from(blocks);
            }
        }
        let count = count.iter().sum::<u32>() as usize;
        if count == 0 || count == POINTS {
            return if count == 0 { 1.0 } else { 0.0 };
        }
        let width = self.edge(z, depth.iter().sum::<f32>() / count as f32);
        if width <= SHARP {
            return self.sharp(place, z, slope);
        }
        self.softened(place, width, &self.limits(z, slope, width))
    }

    /// Depths below which a texel blocks the light, at the points of a disc.
    #[inline(always)]
    fn limits(&self, z: f32, slope: [f32; 2], radius: f32) -> Lanes {
        let mut limits = [0.0; LANES];
        for i in 0..LANES {
            let by = [DISC_POINTS[0][i] * radius, DISC_POINTS[1][i] * radius];
            limits[i] = z + by[0] * slope[0] + by[1] * slope[1] - self.slack;
        }
        limits
    }

    /// The mean of comparisons with four by four texels, weighted by a cubic B-spline: about that over a disc
    /// of a texel's radius.
    #[inline(always)]
    fn sharp(&self, place: [f32; 2], z: f32, slope: [f32; 2]) -> f32 {
        let (mut near, mut weights) = ([[0.0_f32; 4]; 2], [[0.0_f32; 4]; 2]);
        for axis in 0..2 {
            // Measured from the centre of the second of four texels.
            let at = place[axis] - 0.5;
            let (first, share) = (at.floor(), at - at.floor());
            weights[axis] = spline(share);
            for (k, near) in near[axis].iter_mut().enumerate() {
                *near = (first - 1.0 + k as f32).max(0.0).min(self.side as f32 - 1.0);
            }
        }
        let rows = near[1].map(|y| self.row(whole(y)));
        let columns = near[0].map(|x| column(whole(x)));
        let mut found = [0.0_f32; LANES];
        for i in 0..LANES {
            found[i] = self.depth[(rows[i / 4] + columns[i % 4]) as usize];
        }
        let mut sums = [0.0_f32; LANES];
        for i in 0..LANES {
            let by = [near[0][i % 4] + 0.5 - place[0], near[1][i / 4] + 0.5 - place[1]];
            let limit = z + by[0] * slope[0] + by[1] * slope[1] - self.slack;
            let weight = weights[0][i % 4] * weights[1][i / 4];
            sums[i] = if found[i] >= limit { weight } else { 0.0 };
        }
        total(sums)
    }

    /// The mean of comparisons with four texels each over a disc, bilinearly weighted to be smooth from texel
    /// to texel.
    #[inline(always)]
    fn softened(&self, place: [f32; 2], width: f32, limits: &Lanes) -> f32 {
        let [x, y] = around([place[0] - 0.5, place[1] - 0.5], width, 0.0, (self.side - 2) as f32);
        let (mut at, mut found) = ([[0_u32; LANES]; 4], [[0.0_f32; LANES]; 4]);
        let (mut right, mut down) = ([0.0_f32; LANES], [0.0_f32; LANES]);
        for i in 0..LANES {
            let (cx, cy) = (x[i].floor(), y[i].floor());
            (right[i], down[i]) = (x[i] - cx, y[i] - cy);
            let (cx, cy) = (whole(cx), whole(cy));
            let (upper, lower, first, second) = (self.row(cy), self.row(cy + 1), column(cx), column(cx + 1));
            (at[0][i], at[1][i], at[2][i], at[3][i]) = (upper + first, upper + second, lower + first, lower + second);
        }
        for (found, at) in found.iter_mut().zip(&at) {
            for i in 0..POINTS {
                found[i] = self.depth[at[i] as usize];
            }
        }
        let mut sums = [0.0_f32; LANES];
        for i in 0..LANES {
            let lit = |k: usize| if found[k][i] >= limits[i] { 1.0 } else { 0.0 };
            let above = lit(0) * (1.0 - right[i]) + lit(1) * right[i];
            let below = lit(2) * (1.0 - right[i]) + lit(3) * right[i];
            sums[i] = above * (1.0 - down[i]) + below * down[i];
        }
        sums[POINTS..].fill(0.0);
        total(sums) * (1.0 / POINTS as f32)
    }
}

/// The sum of all lanes, by halves, so that no addition waits for the one before it.
#[inline(always)]
fn total(mut lanes: Lanes) -> f32 {
    for half in [8, 4, 2, 1] {
        for i in 0..half {
            lanes[i] += lanes[half + i];
        }
    }
    lanes[0]
}

/// Cubic B-spline weights of four neighbours, at a fraction of the way from the second to the third.
#[inline(always)]
fn spline(share: f32) -> [f32; 4] {
    let rest = 1.0 - share;
    let near = |t: f32| (4.0 - 6.0 * t * t + 3.0 * t * t * t) * (1.0 / 6.0);
    [rest * rest * rest * (1.0 / 6.0), near(share), near(rest), share * share * share * (1.0 / 6.0)]
}

/// The points of a disc around a place, clamped to the map.
#[inline(always)]
fn around(place: [f32; 2], radius: f32, low: f32, high: f32) -> [Lanes; 2] {
    let mut all = DISC_POINTS;
    for (points, place) in all.iter_mut().zip(place) {
        for point in points {
            *point = (place + *point * radius).max(low).min(high);
        }
    }
    all
}
