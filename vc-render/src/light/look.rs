//! Looks into shadow maps, for many points at once.
//!
//! Where nothing near a point's texel lies across its depth, one look tells; else the width of
//! the shadow's edge is found from what is in the way (Fernando 2005).

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

use super::lighting::dot;
use super::shadow::{BLOCK, CLEAR, Cube, ShadowMap, WIDEST};
use crate::affine::{self, three};
use crate::simd::whole;

/// Points strewn evenly over a disc.
const POINTS: usize = 12;
/// Vogel's spiral, and four points that only fill vectors.
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
const LANES: usize = 16;
type Lanes = [f32; LANES];

/// Radius of shadows' edges that are as sharp as texels allow, texels.
const SHARP: f32 = 1.0;

/// How far from surfaces looks begin, metres.
const OFF: f32 = 0.015;

/// Points of surfaces: places and normals.
#[derive(Clone, Copy)]
pub(crate) struct Points<'a, const N: usize> {
    pub(crate) at: &'a [[f32; N]; 3],
    pub(crate) normal: &'a [[f32; N]; 3],
}

impl<const N: usize> Points<'_, N> {
    /// Goes through some of the points, so many at a time that are then side by side.
    #[inline(always)]
    fn some(&self, which: &[u32], mut each: impl FnMut(&Points<'_, LANES>, &[u32])) {
        for which in which.chunks(LANES) {
            let (mut at, mut normal) = ([[0.0; LANES]; 3], [[0.0; LANES]; 3]);
            for (i, point) in which.iter().enumerate().take(LANES) {
                let point = *point as usize % N;
                for k in 0..3 {
                    (at[k][i], normal[k][i]) = (self.at[k][point], self.normal[k][point]);
                }
            }
            each(&Points { at: &at, normal: &normal }, which);
        }
    }
}

/// Points as a map has them.
struct Places<const N: usize> {
    x: [f32; N],
    y: [f32; N],
    depth: [f32; N],
    /// How depth changes along the surface, to the right and down, metres for a texel.
    slope: [[f32; N]; 2],
    texel: [u32; N],
    block: [u32; N],
    /// One for points within the map.
    inside: [u32; N],
}

/// More than it can be: the share of light is not known yet.
const UNKNOWN: f32 = 2.0;

impl ShadowMap {
    /// The share of light that comes to a point of a surface.
    #[inline(always)]
    pub(crate) fn lit(&self, at: [f32; 3], normal: [f32; 3]) -> f32 {
        let (at, normal) = (three(|k| [at[k]]), three(|k| [normal[k]]));
        self.shares(&Points { at: &at, normal: &normal }, 1)[0]
    }

    /// Writes the share of light that comes to some points.
    #[inline(always)]
    pub(crate) fn light<const N: usize>(&self, points: &Points<'_, N>, which: &[u32], share: &mut [f32; N]) {
        points.some(
            which,
            #[inline(always)]
            |points, which| {
                for (point, found) in which.iter().zip(self.shares(points, which.len())) {
                    share[*point as usize % N] = found;
                }
            },
        );
    }

    /// The share of light that comes to the first points, so many.
    #[inline(always)]
    fn shares<const N: usize>(&self, points: &Points<'_, N>, count: usize) -> [f32; N] {
        let places = self.places(points);
        let (mut found, mut least, mut greatest) = ([0.0_f32; N], [0.0_f32; N], [0.0_f32; N]);
        for i in 0..count.min(N) {
            [least[i], greatest[i]] = self.blocks[places.block[i] as usize];
        }
        let (mut share, mut texel) = ([1.0_f32; N], [0_u32; N]);
        for i in 0..N {
            share[i] = self.far(places.depth[i], [least[i], greatest[i]]);
            // What has been told need not be fetched from far away.
            texel[i] = if share[i] == UNKNOWN { places.texel[i] } else { 0 };
        }
        for i in 0..count.min(N) {
            found[i] = self.depth[texel[i] as usize];
        }
        for i in 0..N {
            let plain = self.plain(&places, i, found[i], least[i]);
            let plain = if share[i] == UNKNOWN { plain } else { share[i] };
            share[i] = if places.inside[i] == 1 { plain } else { 1.0 };
        }
        for i in 0..count.min(N) {
            if share[i] == UNKNOWN {
                let slope = [places.slope[0][i], places.slope[1][i]];
                share[i] = self.share([places.x[i], places.y[i]], places.depth[i], slope, least[i]);
            }
        }
        share
    }

    /// Where points are in the map.
    #[inline(always)]
    fn places<const N: usize>(&self, points: &Points<'_, N>) -> Places<N> {
        let (zero, none) = ([0.0; N], [0; N]);
        let mut all =
            Places { x: zero, y: zero, depth: zero, slope: [zero; 2], texel: none, block: none, inside: none };
        let (most, centre, over_focal) = (self.side as f32 - 1.0, 0.5 * self.side as f32, 1.0 / self.focal);
        for i in 0..N {
            let normal = three(|k| points.normal[k][i]);
            let [x, y, z] = affine::point(&self.map, three(|k| points.at[k][i] + OFF * normal[k]));
            let over = 1.0 / z;
            let (x, y) = (x * over, y * over);
            let inside = (z > 0.0) & (x >= 1.0) & (x < most) & (y >= 1.0) & (y < most);
            let (column, row) = if inside { (whole(x.floor()), whole(y.floor())) } else { (0, 0) };
            (all.x[i], all.y[i], all.depth[i], all.inside[i]) = (x, y, z, u32::from(inside));
            all.texel[i] = self.row(row) + self::column(column);
            all.block[i] = row / BLOCK * (self.side / BLOCK) + column / BLOCK;
            let along = three(|k| dot(self.axes[k], normal));
            // The plane's distance over depth.
            let facing = (along[0] * (x - centre) + along[1] * (y - centre)) * over_focal + along[2];
            let scale = if facing < -0.05 { -z * over_focal / facing } else { 0.0 };
            (all.slope[0][i], all.slope[1][i]) = (along[0] * scale, along[1] * scale);
        }
        all
    }

    /// The share of light at a depth which all around is in front of, or behind.
    #[inline(always)]
    fn far(&self, z: f32, [least, greatest]: [f32; 2]) -> f32 {
        let told = if greatest < z - 4.0 * self.slack { 0.0 } else { UNKNOWN };
        if least >= z - self.slack { 1.0 } else { told }
    }

    /// The share of light at a point where one look tells.
    #[inline(always)]
    fn plain<const N: usize>(&self, all: &Places<N>, i: usize, found: f32, least: f32) -> f32 {
        let z = all.depth[i];
        // Where all that is looked at is one plane, which the point is on or clearly behind.
        let clear = (found.to_bits() & CLEAR) as i32 as f32 >= self.edge(z, least) + 2.0;
        let by = [all.x[i].floor() + 0.5 - all.x[i], all.y[i].floor() + 0.5 - all.y[i]];
        let limit = z + by[0] * all.slope[0][i] + by[1] * all.slope[1][i] - self.slack;
        let behind = if found < limit - 3.0 * self.slack { 0.0 } else { UNKNOWN };
        let told = if found >= limit { 1.0 } else { behind };
        if clear { told } else { UNKNOWN }
    }

    /// The share of light at a point whose neighbourhood is not all in front of it or behind.
    #[inline(always)]
    fn share(&self, place: [f32; 2], z: f32, slope: [f32; 2], least: f32) -> f32 {
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

    /// What is before these depths at the points of a disc is in the way.
    #[inline(always)]
    fn limits(&self, z: f32, slope: [f32; 2], radius: f32) -> Lanes {
        let mut limits = [0.0; LANES];
        for i in 0..LANES {
            let by = [DISC_POINTS[0][i] * radius, DISC_POINTS[1][i] * radius];
            limits[i] = z + by[0] * slope[0] + by[1] * slope[1] - self.slack;
        }
        limits
    }

    /// The mean of comparisons with four by four texels, weighted by a cubic B-spline: of a disc of about a texel.
    #[inline(always)]
    fn sharp(&self, place: [f32; 2], z: f32, slope: [f32; 2]) -> f32 {
        let (mut near, mut weights) = ([[0.0_f32; 4]; 2], [[0.0_f32; 4]; 2]);
        for axis in 0..2 {
            // From the middle of the second of four texels.
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

    /// The mean over a disc of comparisons with four texels each, smooth from texel to texel.
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

    /// Radius of a shadow's edge, texels, where what throws it is at a depth.
    #[inline(always)]
    fn edge(&self, z: f32, blocker: f32) -> f32 {
        (self.source * (z - blocker) / blocker * self.focal / z).clamp(1.0, WIDEST)
    }

    /// Where a row begins in the list of depths.
    #[inline(always)]
    fn row(&self, y: u32) -> u32 {
        (y & !(BLOCK - 1)) * self.side + (y & (BLOCK - 1)) * BLOCK
    }
}

/// Where a column begins in the list of depths, from its row on.
#[inline(always)]
fn column(x: u32) -> u32 {
    (x & !(BLOCK - 1)) * BLOCK + (x & (BLOCK - 1))
}

/// The sum of all, in halves that wait for nothing.
#[inline(always)]
fn total(mut lanes: Lanes) -> f32 {
    for half in [8, 4, 2, 1] {
        for i in 0..half {
            lanes[i] += lanes[half + i];
        }
    }
    lanes[0]
}

/// Weights of four neighbours by a cubic B-spline, at a place so far from the second to the third.
#[inline(always)]
fn spline(share: f32) -> [f32; 4] {
    let rest = 1.0 - share;
    let near = |t: f32| (4.0 - 6.0 * t * t + 3.0 * t * t * t) * (1.0 / 6.0);
    [rest * rest * rest * (1.0 / 6.0), near(share), near(rest), share * share * share * (1.0 / 6.0)]
}

/// The points of a disc around a place, within the map.
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

impl Cube {
    /// The share of light that comes to a point of a surface, for a lamp at `eye`.
    #[inline(always)]
    pub(crate) fn lit(&self, eye: [f32; 3], at: [f32; 3], normal: [f32; 3]) -> f32 {
        self.0[face(three(|k| at[k] - eye[k])) as usize].lit(at, normal)
    }

    /// Writes the share of a lamp's light that comes to some points.
    #[inline(always)]
    pub(crate) fn light<const N: usize>(
        &self,
        eye: [f32; 3],
        points: &Points<'_, N>,
        which: &[u32],
        share: &mut [f32; N],
    ) {
        let mut faces = [0_u32; N];
        for i in 0..N {
            faces[i] = face(three(|k| points.at[k][i] - eye[k]));
        }
        let (mut lists, mut counts) = ([[0_u32; N]; FACES], [0_usize; FACES]);
        for point in which {
            let face = faces[*point as usize % N] as usize;
            lists[face][counts[face] % N] = *point;
            counts[face] += 1;
        }
        for (map, (list, count)) in self.0.iter().zip(lists.iter().zip(counts)) {
            if count > 0 {
                map.light(points, &list[..count], share);
            }
        }
    }
}

/// Faces of a cube.
const FACES: usize = 6;

/// The face of a cube to which something lies.
#[inline(always)]
fn face(from: [f32; 3]) -> u32 {
    let [x, y, z] = from.map(f32::abs);
    let upright = if y >= z { 1 } else { 2 };
    let axis = if (x >= y) & (x >= z) { 0 } else { upright };
    let far = if axis == 1 { from[1] } else { from[2] };
    let along = if axis == 0 { from[0] } else { far };
    if along >= 0.0 { axis } else { axis + 3 }
}
