//! Shadow maps: depth as a light sees it.

use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

use crate::affine::{self, Narrow};
use crate::camera::Camera;
use crate::raster::{Drawing, Frustum, Layers, Target};
use crate::renderer::Renderer;
use crate::scene::Snapshot;

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

/// Points strewn evenly over a disc (Vogel's spiral).
const DISC_POINTS: [[f32; 2]; 12] = [
    [0.20412, 0.00000],
    [-0.26070, 0.23882],
    [0.03990, -0.45469],
    [0.32859, 0.42859],
    [-0.60301, -0.10666],
    [0.57122, -0.36337],
    [-0.19106, 0.71075],
    [-0.36438, -0.70159],
    [0.79056, 0.28871],
    [-0.82244, 0.33949],
    [0.39647, -0.84724],
    [0.29298, 0.93407],
];

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
        let axes = [0, 1, 2].map(|c: usize| turn.matrix().column(c).into());
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
        let off = [0, 1, 2].map(|i: usize| at[i] + 0.015 * normal[i]);
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
        let found = self.depth[self.texel(place[0], place[1])];
        // Where all that is looked at is one plane, which the point is on or clearly behind, one look tells.
        if (found.to_bits() & CLEAR) as f32 >= self.edge(z, least) + 2.0 {
            let by = place.map(|p| p.floor() + 0.5 - p);
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
        let [a, b, c] = self.axes.map(|axis| along(axis, normal));
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
        let (mut depth, mut count) = (0.0, 0);
        for [x, y] in DISC_POINTS {
            let by = [x * reach, y * reach];
            let limit = z + by[0] * slope[0] + by[1] * slope[1] - self.slack;
            let found = self.depth[self.texel(place[0] + by[0], place[1] + by[1])];
            depth += if found < limit { found } else { 0.0 };
            count += i32::from(found < limit);
        }
        if count == 0 || count == DISC_POINTS.len() as i32 {
            return if count == 0 { 1.0 } else { 0.0 };
        }
        let width = self.edge(z, depth / count as f32);
        let mut sum = 0.0;
        for [x, y] in DISC_POINTS {
            let by = [x * width, y * width];
            let limit = z + by[0] * slope[0] + by[1] * slope[1] - self.slack;
            sum += self.between(place[0] + by[0], place[1] + by[1], limit);
        }
        sum * (1.0 / DISC_POINTS.len() as f32)
    }

    /// Radius of a shadow's edge, texels, where what throws it is at a depth.
    #[inline(always)]
    fn edge(&self, z: f32, blocker: f32) -> f32 {
        (self.source * (z - blocker) / blocker * self.focal / z).clamp(1.0, WIDEST)
    }

    #[inline(always)]
    fn texel(&self, x: f32, y: f32) -> usize {
        let within = |v: f32| (v as i32).clamp(0, self.side - 1) as usize;
        self.row(within(y)) + column(within(x))
    }

    /// Where a row begins in the list of depths.
    #[inline(always)]
    fn row(&self, y: usize) -> usize {
        const SIDE: usize = BLOCK as usize;
        y / SIDE * (self.side as usize * SIDE) + y % SIDE * SIDE
    }

    /// The mean of four comparisons, smooth from texel to texel.
    #[inline(always)]
    fn between(&self, x: f32, y: f32, limit: f32) -> f32 {
        let most = (self.side - 2) as f32;
        let (x, y) = ((x - 0.5).max(0.0).min(most), (y - 0.5).max(0.0).min(most));
        let (cx, cy) = (x as usize, y as usize);
        let (fx, fy) = (x - cx as f32, y - cy as f32);
        let (left, right) = (column(cx), column(cx + 1));
        let lit = |at: usize| if self.depth[at] >= limit { 1.0 } else { 0.0 };
        let (upper, lower) = (self.row(cy), self.row(cy + 1));
        let above = lit(upper + left) * (1.0 - fx) + lit(upper + right) * fx;
        let below = lit(lower + left) * (1.0 - fx) + lit(lower + right) * fx;
        above * (1.0 - fy) + below * fy
    }
}

/// Where a column begins in the list of depths, from its row on.
#[inline(always)]
fn column(x: usize) -> usize {
    const SIDE: usize = BLOCK as usize;
    x / SIDE * (SIDE * SIDE) + x % SIDE
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
