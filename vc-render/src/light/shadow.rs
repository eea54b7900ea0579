//! Shadow maps: depth as a light sees it.

use nalgebra::{Point3, Vector3};

use crate::affine::{self, Narrow};
use crate::camera::Camera;
use crate::raster::{Drawing, Frustum, Layers};
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
        let depth: Vec<f32> = (0..side).flat_map(|y| layers.front.inverse_row(y)).map(|v| 1.0 / v).collect();
        let turn = camera.pose.rotation.to_rotation_matrix();
        let axes = [0, 1, 2].map(|c: usize| turn.matrix().column(c).into());
        let blocks = widened(&blocks(&depth, side), (side / BLOCK) as usize);
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
        self.share(place, z, self.slope(off, normal, z), least)
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
        within(y) * self.side as usize + within(x)
    }

    /// The mean of four comparisons, smooth from texel to texel.
    #[inline(always)]
    fn between(&self, x: f32, y: f32, limit: f32) -> f32 {
        let most = (self.side - 2) as f32;
        let (x, y) = ((x - 0.5).max(0.0).min(most), (y - 0.5).max(0.0).min(most));
        let (cx, cy) = (x as usize, y as usize);
        let (fx, fy) = (x - cx as f32, y - cy as f32);
        let at = cy * self.side as usize + cx;
        let row = |at: usize| {
            let two = &self.depth[at..at + 2];
            let lit = |v: f32| if v >= limit { 1.0 } else { 0.0 };
            lit(two[0]) * (1.0 - fx) + lit(two[1]) * fx
        };
        row(at) * (1.0 - fy) + row(at + self.side as usize) * fy
    }
}

/// Least and greatest depth of every block.
fn blocks(depth: &[f32], side: i32) -> Vec<[f32; 2]> {
    let (side, block) = (side as usize, BLOCK as usize);
    let across = side / block;
    let mut all = vec![[f32::INFINITY, 0.0]; across * across];
    for (i, row) in depth.chunks(side).enumerate() {
        for (j, texels) in row.chunks(block).enumerate() {
            let [least, greatest] = &mut all[i / block * across + j];
            *least = texels.iter().fold(*least, |m, v| m.min(*v));
            *greatest = texels.iter().fold(*greatest, |m, v| m.max(*v));
        }
    }
    all
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
