//! Shadow maps: depth as a light sees it.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

use crate::affine::{self, Narrow, three};
use crate::camera::Camera;
use crate::raster::{Drawing, Frustum, Layers, Target};
use crate::renderer::Renderer;
use crate::scene::Snapshot;
use crate::simd::whole;

/// Depth over an image plane, as seen from the middle of a round light.
#[derive(Debug, Clone)]
pub(crate) struct ShadowMap {
    /// From the world to pixels times depth, and depth.
    map: Narrow,
    /// The image's axes in the world.
    axes: [[f32; 3]; 3],
    focal: f32,
    side: i32,
    /// Block by block, as texels that are looked at together are near each other. The lowest bits say how many
    /// texels around show the same plane, [`CLEAR`] at most.
    depth: Vec<f32>,
    /// Least and greatest depth in every block and the eight around it.
    blocks: Vec<[f32; 2]>,
    /// Radius of the light, metres.
    source: f32,
    /// What counts as in front, metres.
    slack: f32,
}

/// Maps in all six directions.
#[derive(Debug, Clone)]
pub(crate) struct Cube(Vec<ShadowMap>);

/// Side of the sun's map, and of one of a lamp's, texels.
const SUN: u32 = 2048;
const LAMP: u32 = 256;
/// Side of a block of texels.
const BLOCK: i32 = 8;
/// Widest edge of a shadow, texels; less than a block.
const WIDEST: f32 = 6.0;
/// Greatest clearance of a texel: bits of a depth, less than a millimetre.
const CLEAR: u32 = 15;
/// How far the eye of the sun's map is, metres; its rays are as good as parallel.
const FAR: f32 = 400.0;
/// The sun's radius at that distance, and half as much again for haze.
const DISC: f32 = 0.0047 * 1.5 * FAR;

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

impl ShadowMap {
    fn new(
        renderer: &Renderer,
        snapshot: &Snapshot,
        which: impl Iterator<Item = u32>,
        camera: &Camera,
        (source, slack): (f32, f32),
    ) -> Self {
        let side = camera.height as i32;
        let frustum = Frustum::new(camera, &(0..side));
        let drawing = Drawing { instances: &snapshot.instances, frustum, detail: renderer.detail.max(0.5) };
        let mut layers = Layers::default();
        layers.draw_solid(&drawing, which, (side as usize, 0..side));
        let depth = blockwise(&depths(&layers.front, side, slack), side as usize);
        let turn = camera.pose.rotation.to_rotation_matrix();
        let axes = three(|c| turn.matrix().column(c).into());
        let blocks = widened(&blocks(&depth), (side / BLOCK) as usize);
        Self { map: frustum.map.narrow(), axes, focal: camera.focal.0, side, depth, blocks, source, slack }
    }

    /// The sun's, over everything within a ball.
    pub(super) fn sun(
        renderer: &Renderer,
        snapshot: &Snapshot,
        towards: Vector3<f32>,
        middle: Point3<f32>,
        radius: f32,
    ) -> Self {
        let eye = middle + towards * FAR;
        let focal = 0.5 * SUN as f32 * (FAR - radius) / radius;
        let centre = 0.5 * SUN as f32;
        let camera = Camera { near: 1.0, ..Camera::with_intrinsics(SUN, SUN, (focal, focal), (centre, centre)) };
        let all = 0..snapshot.instances.len() as u32;
        Self::new(renderer, snapshot, all, &camera.looking(eye, middle), (DISC, 0.015))
    }

    /// The share of light that comes to a point of a surface.
    ///
    /// Where nothing near the point's texel lies across its depth, one look tells; else the
    /// width of the shadow's edge is found from what is in the way (Fernando 2005).
    #[inline(always)]
    pub(crate) fn lit(&self, at: [f32; 3], normal: [f32; 3]) -> f32 {
        let off = three(|i| at[i] + 0.015 * normal[i]);
        let [x, y, z] = affine::point(&self.map, off);
        let over = 1.0 / z;
        let place = [x * over, y * over];
        let most = self.side as f32 - 1.0;
        let inside = z > 0.0 && place.iter().all(|p| (1.0..most).contains(p));
        if !inside {
            return 1.0;
        }
        let block =
            (place[1] as usize / BLOCK as usize) * (self.side / BLOCK) as usize + place[0] as usize / BLOCK as usize;
        let [least, greatest] = self.blocks[block];
        if least >= z - self.slack {
            return 1.0;
        }
        if greatest < z - 4.0 * self.slack {
            return 0.0;
        }
        let slope = self.slope(off, normal, z);
        let texel = self.row(place[1] as u32) + column(place[0] as u32);
        let found = self.depth[texel as usize];
        // Where all that is looked at is one plane, which the point is on or clearly behind, one look tells.
        if (found.to_bits() & CLEAR) as f32 >= self.edge(z, least) + 2.0 {
            let by = [place[0].floor() + 0.5 - place[0], place[1].floor() + 0.5 - place[1]];
            let limit = z + by[0] * slope[0] + by[1] * slope[1] - self.slack;
            if found >= limit || found < limit - 3.0 * self.slack {
                return if found >= limit { 1.0 } else { 0.0 };
            }
        }
        self.share(place, z, slope, least)
    }

    /// How depth changes along a surface, to the right and down, metres for a texel.
    #[inline(always)]
    fn slope(&self, at: [f32; 3], normal: [f32; 3], z: f32) -> [f32; 2] {
        let along = |v: [f32; 3], w: [f32; 3]| v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
        let [a, b, c] = three(|axis| along(self.axes[axis], normal));
        let [x, y, _] = affine::point(&self.map, at);
        let centre = 0.5 * self.side as f32;
        let (u, v) = ((x / z - centre) / self.focal, (y / z - centre) / self.focal);
        // The plane's distance over depth.
        let facing = a * u + b * v + c;
        let scale = if facing < -0.05 { -z / (self.focal * facing) } else { 0.0 };
        [a * scale, b * scale]
    }

    #[inline(always)]
    fn share(&self, place: [f32; 2], z: f32, slope: [f32; 2], least: f32) -> f32 {
        let reach = self.edge(z, least) + 1.0;
        let (mut at, mut found) = ([0_u32; LANES], [f32::INFINITY; LANES]);
        let [x, y] = Self::around(place, reach, 0.0, self.side as f32 - 1.0);
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
        self.softened(place, width, &self.limits(z, slope, width))
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

    /// The mean over a disc of comparisons with four texels each, smooth from texel to texel.
    #[inline(always)]
    fn softened(&self, place: [f32; 2], width: f32, limits: &Lanes) -> f32 {
        let [x, y] = Self::around([place[0] - 0.5, place[1] - 0.5], width, 0.0, (self.side - 2) as f32);
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
        sums[..POINTS].iter().sum::<f32>() * (1.0 / POINTS as f32)
    }

    /// Radius of a shadow's edge, texels, where what throws it is at a depth.
    #[inline(always)]
    fn edge(&self, z: f32, blocker: f32) -> f32 {
        (self.source * (z - blocker) / blocker * self.focal / z).clamp(1.0, WIDEST)
    }

    /// Where a row begins in the list of depths.
    #[inline(always)]
    fn row(&self, y: u32) -> u32 {
        (y & !(BLOCK as u32 - 1)) * self.side as u32 + (y & (BLOCK as u32 - 1)) * BLOCK as u32
    }
}

/// Where a column begins in the list of depths, from its row on.
#[inline(always)]
fn column(x: u32) -> u32 {
    (x & !(BLOCK as u32 - 1)) * BLOCK as u32 + (x & (BLOCK as u32 - 1))
}

/// Texels row by row to texels block by block.
fn blockwise(rows: &[f32], side: usize) -> Vec<f32> {
    let block = BLOCK as usize;
    let mut all = Vec::with_capacity(rows.len());
    for rows in rows.chunks(side * block) {
        for x in (0..side).step_by(block) {
            rows.chunks(side).for_each(|row| all.extend_from_slice(&row[x..x + block]));
        }
    }
    all
}

/// Depths row by row, with their clearance in the lowest bits.
fn depths(target: &Target, side: i32, slack: f32) -> Vec<f32> {
    let width = side as usize;
    let mut clear = vec![0; width * width];
    clear.par_chunks_mut(width).zip(0..side).filter(|(_, y)| (1..side - 1).contains(y)).for_each(|(out, y)| {
        let [above, own, below] = [y - 1, y, y + 1].map(|y| target.inverse_row(y));
        crate::simd::widest(
            #[inline(always)]
            || even([above, own, below], 0.05 * slack, out),
        );
    });
    let clear = spread(&spread(&clear, 1), width);
    let inverse = (0..side).flat_map(|y| target.inverse_row(y));
    let depth = |(v, clear): (&f32, u8)| f32::from_bits((1.0 / v.max(1e-12)).to_bits() & !CLEAR | u32::from(clear));
    inverse.zip(clear).map(depth).collect()
}

/// Marks texels of a row which lie between their neighbours, up to so many metres.
#[inline(always)]
fn even([above, own, below]: [&[f32]; 3], slack: f32, out: &mut [u8]) {
    let count = out.len() - 2;
    let out = &mut out[1..=count];
    let (left, middle, right) = (&own[..count], &own[1..=count], &own[2..]);
    let (above, below) = (&above[1..=count], &below[1..=count]);
    for x in 0..count {
        let twice = 2.0 * middle[x];
        let bends = ((left[x] + right[x] - twice).abs()).max((above[x] + below[x] - twice).abs());
        // How inverse depth changes with depth.
        out[x] = if bends <= slack * middle[x] * middle[x] { CLEAR as u8 } else { 0 };
    }
}

/// How far the nearest zero is along an axis, if it is nearer than a number says.
fn spread(from: &[u8], stride: usize) -> Vec<u8> {
    const PART: usize = 4096;
    let mut near = from.to_vec();
    near.par_chunks_mut(PART).enumerate().for_each(|(part, near)| {
        let (start, end) = (part * PART, part * PART + near.len());
        for by in 1..=WIDEST as usize + 2 {
            // Texels at the border are zero, so none beyond is missed.
            let after = from.get(start + by * stride..).unwrap_or(&[]);
            let missing = (by * stride).saturating_sub(start).min(near.len());
            let before = &from[(start + missing).saturating_sub(by * stride)..end.saturating_sub(by * stride)];
            crate::simd::widest(
                #[inline(always)]
                || {
                    lower(near, after, by as u8);
                    lower(&mut near[missing..], before, by as u8);
                },
            );
        }
    });
    near
}

/// Lowers numbers to others, which count for no less than so much.
#[inline(always)]
fn lower(these: &mut [u8], others: &[u8], least: u8) {
    these.iter_mut().zip(others).for_each(|(this, other)| *this = (*this).min((*other).max(least)));
}

/// Least and greatest depth of every block.
fn blocks(depth: &[f32]) -> Vec<[f32; 2]> {
    let ends = |texels: &[f32]| {
        texels.iter().fold([f32::INFINITY, 0.0], |[least, greatest], v| [v.min(least), v.max(greatest)])
    };
    depth.par_chunks((BLOCK * BLOCK) as usize).map(ends).collect()
}

/// The same of every block and those around it.
fn widened(blocks: &[[f32; 2]], across: usize) -> Vec<[f32; 2]> {
    let around = |at: usize| at.saturating_sub(1)..(at + 2).min(across);
    let wide = |i: usize| {
        let near = around(i / across).flat_map(|y| around(i % across).map(move |x| blocks[y * across + x]));
        near.fold([f32::INFINITY, 0.0], |a: [f32; 2], b| [a[0].min(b[0]), a[1].max(b[1])])
    };
    (0..blocks.len()).map(wide).collect()
}

impl Cube {
    pub(super) fn new(renderer: &Renderer, snapshot: &Snapshot, which: &[u32], at: [f32; 3], radius: f32) -> Self {
        let eye = Point3::from(at);
        // A little more than a right angle, so that samples at the border stay within.
        let focal = 0.5 * LAMP as f32 * 0.95;
        let centre = 0.5 * LAMP as f32;
        let camera = Camera { near: 0.02, ..Camera::with_intrinsics(LAMP, LAMP, (focal, focal), (centre, centre)) };
        let face = |axis: usize| {
            let towards = Vector3::ith(axis % 3, if axis < 3 { 1.0 } else { -1.0 });
            let camera = camera.looking(eye, eye + towards);
            ShadowMap::new(renderer, snapshot, which.iter().copied(), &camera, (radius, 0.025))
        };
        Self((0..6).map(face).collect())
    }

    /// The share of light that comes to a point, which is so far from the lamp.
    #[inline(always)]
    pub(crate) fn lit(&self, from: [f32; 3], at: [f32; 3], normal: [f32; 3]) -> f32 {
        let size = from.map(f32::abs);
        let axis = if size[0] >= size[1] && size[0] >= size[2] {
            0
        } else if size[1] >= size[2] {
            1
        } else {
            2
        };
        let face = if from[axis] >= 0.0 { axis } else { axis + 3 };
        self.0[face].lit(at, normal)
    }
}
