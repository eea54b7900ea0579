//! Shadow-map lookups for many points at once.
//!
//! Where no depth near a point's texel lies across the point's own, one lookup decides; elsewhere the point is
//! at the edge of a shadow (`penumbra`).

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

use super::shadow::{BLOCK, CLEAR, Cube, ShadowMap, WIDEST};
use crate::math::simd::whole;
use crate::math::{self, dot, three};

pub(super) const LANES: usize = 16;

/// Offset of lookups from surfaces, metres.
const OFF: f32 = 0.015;

/// Surface points: positions and normals.
#[derive(Clone, Copy)]
pub(crate) struct Points<'a, const N: usize> {
    pub(crate) at: &'a [[f32; N]; 3],
    pub(crate) normal: &'a [[f32; N]; 3],
}

impl<const N: usize> Points<'_, N> {
    /// Passes a selection of the points on in groups of contiguous lanes.
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

/// Points projected into a shadow map.
struct Places<const N: usize> {
    x: [f32; N],
    y: [f32; N],
    depth: [f32; N],
    /// Depth gradient of the surface to the right and down, metres for each texel.
    slope: [[f32; N]; 2],
    texel: [u32; N],
    block: [u32; N],
    /// One for points within the map.
    inside: [u32; N],
}

/// A value above any share of light: not yet known.
const UNKNOWN: f32 = 2.0;

impl ShadowMap {
    /// The share of light that reaches a surface point.
    #[inline(always)]
    pub(crate) fn lit(&self, at: [f32; 3], normal: [f32; 3]) -> f32 {
        let (at, normal) = (three(|k| [at[k]]), three(|k| [normal[k]]));
        self.shares(&Points { at: &at, normal: &normal }, 1)[0]
    }

    /// Writes the share of light that reaches the selected points.
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

    /// The share of light that reaches the first `count` points.
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
            // Points that are already decided all fetch the first texel, which costs no distant memory access.
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

    /// Projects points into the map.
    #[inline(always)]
    fn places<const N: usize>(&self, points: &Points<'_, N>) -> Places<N> {
        let (zero, none) = ([0.0; N], [0; N]);
        let mut all =
            Places { x: zero, y: zero, depth: zero, slope: [zero; 2], texel: none, block: none, inside: none };
        let (most, centre, over_focal) = (self.side as f32 - 1.0, 0.5 * self.side as f32, 1.0 / self.focal);
        for i in 0..N {
            let normal = three(|k| points.normal[k][i]);
            let [x, y, z] = math::point(&self.map, three(|k| points.at[k][i] + OFF * normal[k]));
            let over = 1.0 / z;
            let (x, y) = (x * over, y * over);
            let inside = (z > 0.0) & (x >= 1.0) & (x < most) & (y >= 1.0) & (y < most);
            let (column, row) = if inside { (whole(x.floor()), whole(y.floor())) } else { (0, 0) };
            (all.x[i], all.y[i], all.depth[i], all.inside[i]) = (x, y, z, u32::from(inside));
            all.texel[i] = self.row(row) + self::column(column);
            all.block[i] = row / BLOCK * (self.side / BLOCK) + column / BLOCK;
            let along = three(|k| dot(self.axes[k], normal));
            // Distance of the surface's plane over depth.
            let facing = (along[0] * (x - centre) + along[1] * (y - centre)) * over_focal + along[2];
            let scale = if facing < -0.05 { -z * over_focal / facing } else { 0.0 };
            (all.slope[0][i], all.slope[1][i]) = (along[0] * scale, along[1] * scale);
        }
        all
    }

    /// The share of light at a depth that is entirely in front of or behind all depths around; otherwise
    /// unknown.
    #[inline(always)]
    fn far(&self, z: f32, [least, greatest]: [f32; 2]) -> f32 {
        let decided = if greatest < z - 4.0 * self.slack { 0.0 } else { UNKNOWN };
        if least >= z - self.slack { 1.0 } else { decided }
    }

    /// The share of light at a point where one lookup decides; otherwise unknown.
    #[inline(always)]
    fn plain<const N: usize>(&self, all: &Places<N>, i: usize, found: f32, least: f32) -> f32 {
        let z = all.depth[i];
        // One lookup decides if all texels within reach show one plane and the point is on it or clearly behind
        // it.
        let clear = (found.to_bits() & CLEAR) as i32 as f32 >= self.edge(z, least) + 2.0;
        let by = [all.x[i].floor() + 0.5 - all.x[i], all.y[i].floor() + 0.5 - all.y[i]];
        let limit = z + by[0] * all.slope[0][i] + by[1] * all.slope[1][i] - self.slack;
        let behind = if found < limit - 3.0 * self.slack { 0.0 } else { UNKNOWN };
        let decided = if found >= limit { 1.0 } else { behind };
        if clear { decided } else { UNKNOWN }
    }

    /// Radius of a shadow's edge, texels, for a blocker at the given depth.
    #[inline(always)]
    pub(super) fn edge(&self, z: f32, blocker: f32) -> f32 {
        (self.source * (z - blocker) / blocker * self.focal / z).clamp(1.0, WIDEST)
    }

    /// Offset of a row in the array of depths.
    #[inline(always)]
    pub(super) fn row(&self, y: u32) -> u32 {
        (y & !(BLOCK - 1)) * self.side + (y & (BLOCK - 1)) * BLOCK
    }
}

/// Offset of a column in the array of depths, relative to its row.
#[inline(always)]
pub(super) fn column(x: u32) -> u32 {
    (x & !(BLOCK - 1)) * BLOCK + (x & (BLOCK - 1))
}

impl Cube {
    /// The share of light that reaches a surface point from a lamp at `eye`.
    #[inline(always)]
    pub(crate) fn lit(&self, eye: [f32; 3], at: [f32; 3], normal: [f32; 3]) -> f32 {
        self.0[face(three(|k| at[k] - eye[k])) as usize].lit(at, normal)
    }

    /// Writes the share of a lamp's light that reaches the selected points.
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

/// The cube face in whose direction a vector points.
#[inline(always)]
fn face(from: [f32; 3]) -> u32 {
    let [x, y, z] = from.map(f32::abs);
    let upright = if y >= z { 1 } else { 2 };
    let axis = if (x >= y) & (x >= z) { 0 } else { upright };
    let far = if axis == 1 { from[1] } else { from[2] };
    let along = if axis == 0 { from[0] } else { far };
    if along >= 0.0 { axis } else { axis + 3 }
}
