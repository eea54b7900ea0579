//! Shadow maps: depth as a light sees it.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

use crate::affine::{Narrow, three};
use crate::camera::Camera;
use crate::raster::{Drawing, Frustum, Layers, Target};
use crate::renderer::Renderer;
use crate::scene::Snapshot;

/// Depth over an image plane, as seen from the middle of a round light.
#[derive(Debug, Clone)]
pub(crate) struct ShadowMap {
    /// From the world to pixels times depth, and depth.
    pub(super) map: Narrow,
    /// The image's axes in the world.
    pub(super) axes: [[f32; 3]; 3],
    pub(super) focal: f32,
    pub(super) side: u32,
    /// Block by block, as texels that are looked at together are near each other. The lowest bits say how many
    /// texels around show the same plane, [`CLEAR`] at most.
    pub(super) depth: Vec<f32>,
    /// Least and greatest depth in every block and the eight around it.
    pub(super) blocks: Vec<[f32; 2]>,
    /// Radius of the light, metres.
    pub(super) source: f32,
    /// What counts as in front, metres.
    pub(super) slack: f32,
}

/// Maps in all six directions.
#[derive(Debug, Clone)]
pub(crate) struct Cube(pub(super) Vec<ShadowMap>);

/// Side of the sun's map, and of one of a lamp's, texels.
const SUN: u32 = 2048;
const LAMP: u32 = 256;
/// Side of a block of texels.
pub(super) const BLOCK: u32 = 8;
/// Widest edge of a shadow, texels; less than a block.
pub(super) const WIDEST: f32 = 6.0;
/// Greatest clearance of a texel: bits of a depth, less than a millimetre.
pub(super) const CLEAR: u32 = 15;
/// How far the eye of the sun's map is, metres; its rays are as good as parallel.
const FAR: f32 = 400.0;
/// The sun's radius at that distance, and half as much again for haze.
const DISC: f32 = 0.0047 * 1.5 * FAR;

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
        let blocks = widened(&blocks(&depth), side as usize / BLOCK as usize);
        Self {
            map: frustum.map.narrow(),
            axes,
            focal: camera.focal.0,
            side: camera.height,
            depth,
            blocks,
            source,
            slack,
        }
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
}
