//! Shadow maps: depth as a light sees it.

use nalgebra::{Point3, Vector3};

use crate::affine::{self, Narrow};
use crate::camera::Camera;
use crate::raster::{Drawing, Frustum, Layers};
use crate::renderer::Renderer;
use crate::scene::Snapshot;

/// Depth over an image plane.
#[derive(Debug, Clone)]
pub(crate) struct ShadowMap {
    /// From the world to pixels times depth, and depth.
    map: Narrow,
    side: i32,
    depth: Vec<f32>,
    /// What counts as in front, metres.
    slack: f32,
}

/// Maps in all six directions.
#[derive(Debug, Clone)]
pub(crate) struct Cube(Vec<ShadowMap>);

/// Side of the sun's map, and of one of a lamp's, pixels.
const SUN: u32 = 2048;
const LAMP: u32 = 256;

/// How far the eye of the sun's map is, metres; its rays are as good as parallel.
const FAR: f32 = 400.0;

impl ShadowMap {
    fn new(
        renderer: &Renderer,
        snapshot: &Snapshot,
        which: impl Iterator<Item = u32>,
        camera: &Camera,
        slack: f32,
    ) -> Self {
        let side = camera.height as i32;
        let frustum = Frustum::new(camera, &(0..side));
        let drawing = Drawing { instances: &snapshot.instances, frustum, detail: renderer.detail.max(0.5) };
        let mut layers = Layers::default();
        crate::simd::widest(
            #[inline(always)]
            || layers.draw_solid(&drawing, which, (side as usize, 0..side)),
        );
        let depth = (0..side).flat_map(|y| layers.front.inverse_row(y)).map(|v| 1.0 / v).collect();
        Self { map: frustum.map.narrow(), side, depth, slack }
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
        Self::new(renderer, snapshot, all, &camera.looking(eye, middle), 0.02)
    }

    /// The share of light that comes to a point: the mean of nine comparisons, smooth
    /// from texel to texel.
    #[inline(always)]
    pub(crate) fn lit(&self, at: [f32; 3]) -> f32 {
        let [x, y, z] = affine::point(&self.map, at);
        let over = 1.0 / z;
        let (x, y) = (x * over - 0.5, y * over - 0.5);
        let (cx, cy) = (x.floor(), y.floor());
        let (fx, fy) = (x - cx, y - cy);
        let (cx, cy) = (cx as i32 - 1, cy as i32 - 1);
        if z <= 0.0 || cx < 0 || cy < 0 || cx + 4 > self.side || cy + 4 > self.side {
            return 1.0;
        }
        let nearer = z - self.slack;
        let weights = [1.0 - fx, 1.0, 1.0, fx];
        let mut sum = 0.0;
        for (row, weight) in [1.0 - fy, 1.0, 1.0, fy].into_iter().enumerate() {
            let start = (cy as usize + row) * self.side as usize + cx as usize;
            let four = &self.depth[start..start + 4];
            let line: f32 = (0..4).map(|i| if four[i] >= nearer { weights[i] } else { 0.0 }).sum();
            sum += weight * line;
        }
        sum * (1.0 / 9.0)
    }
}

impl Cube {
    pub(super) fn new(renderer: &Renderer, snapshot: &Snapshot, which: &[u32], at: [f32; 3]) -> Self {
        let eye = Point3::from(at);
        // A little more than a right angle, so that samples at the border stay within.
        let focal = 0.5 * LAMP as f32 * 0.97;
        let centre = 0.5 * LAMP as f32;
        let camera = Camera { near: 0.02, ..Camera::with_intrinsics(LAMP, LAMP, (focal, focal), (centre, centre)) };
        let face = |axis: usize| {
            let towards = Vector3::ith(axis % 3, if axis < 3 { 1.0 } else { -1.0 });
            ShadowMap::new(renderer, snapshot, which.iter().copied(), &camera.looking(eye, eye + towards), 0.03)
        };
        Self((0..6).map(face).collect())
    }

    /// The share of light that comes to a point, which is so far from the lamp.
    #[inline(always)]
    pub(crate) fn lit(&self, from: [f32; 3], at: [f32; 3]) -> f32 {
        let size = from.map(f32::abs);
        let axis = if size[0] >= size[1] && size[0] >= size[2] {
            0
        } else if size[1] >= size[2] {
            1
        } else {
            2
        };
        let face = if from[axis] >= 0.0 { axis } else { axis + 3 };
        self.0[face].lit(at)
    }
}
