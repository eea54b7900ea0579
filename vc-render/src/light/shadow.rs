//! Shadow maps: depth as seen from a light.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

use std::ops::Range;
use std::sync::Arc;

use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

use crate::camera::Camera;
use crate::math::{Narrow, three};
use crate::rasterization::{Drawing, Frustum, Layers, Target};
use crate::scene::Store;
use crate::scene::{Instance, Snapshot};

use super::lookup::column;

/// Depth over an image plane, seen from the centre of a spherical light.
#[derive(Debug, Clone)]
pub(crate) struct ShadowMap {
    camera: Camera,
    /// The map from the world to pixels times depth, and depth.
    pub(super) map: Narrow,
    /// The image's axes in the world.
    pub(super) axes: [[f32; 3]; 3],
    pub(super) focal: f32,
    pub(super) side: u32,
    /// Depths, stored block by block to keep texels that are used together close in memory. The lowest bits are
    /// the clearance: how many texels around show the same plane, [`CLEAR`] at most.
    pub(super) depth: Vec<f32>,
    /// Least and greatest depth in every block and the eight around it.
    pub(super) blocks: Vec<[f32; 2]>,
    /// Radius of the light, metres.
    pub(super) source: f32,
    /// Depth tolerance within which nothing counts as in front, metres.
    pub(super) slack: f32,
}

/// Shadow maps in all six axis directions.
#[derive(Debug, Clone)]
pub(crate) struct Cube(pub(super) Vec<Arc<ShadowMap>>);

/// Side of the sun's map, and of each face of a lamp's, texels.
const SUN: u32 = 2048;
const LAMP: u32 = 256;
/// Side of a block of texels.
pub(super) const BLOCK: u32 = 8;
/// Greatest radius of a shadow's edge, texels; less than a block.
pub(super) const WIDEST: f32 = 6.0;
/// Greatest clearance of a texel: the bits of a depth that hold it are worth less than a millimetre.
pub(super) const CLEAR: u32 = 15;
/// Reach of clearances, texels.
const REACH: i32 = WIDEST as i32 + 2;
/// Distance of the eye of the sun's map, metres; its rays are nearly parallel.
const FAR: f32 = 400.0;
/// The sun's radius at that distance, and half as much again for haze.
const DISC: f32 = 0.0047 * 1.5 * FAR;

impl ShadowMap {
    fn new(
        store: &Store,
        snapshot: &Snapshot,
        which: impl Iterator<Item = u32>,
        camera: &Camera,
        (source, slack): (f32, f32),
    ) -> Self {
        let (side, across) = (camera.height as usize, (camera.height / BLOCK) as usize);
        let turn = camera.pose.rotation.to_rotation_matrix();
        let mut made = Self {
            camera: *camera,
            map: Frustum::new(camera, &(0..side as i32)).map.narrow(),
            axes: three(|c| turn.matrix().column(c).into()),
            focal: camera.focal.0,
            side: camera.height,
            depth: vec![0.0; side * side],
            blocks: vec![[0.0; 2]; across * across],
            source,
            slack,
        };
        made.draw(store, snapshot, which, &(0..side as i32));
        made
    }

    /// Redraws some rows and everything that depends on them; the other rows are up to date.
    fn draw(&mut self, store: &Store, snapshot: &Snapshot, which: impl Iterator<Item = u32>, rows: &Range<i32>) {
        let side = self.side as i32;
        // The rows whose clearance may have changed, and the rows that are needed to compute it.
        let changed = grown(rows, REACH + 1, side);
        let drawn = grown(&changed, REACH + 1, side);
        let frustum = Frustum::new(&self.camera, &drawn);
        let drawing = Drawing { instances: &snapshot.instances, frustum, detail: store.detail.max(0.5) };
        let mut layers = Layers::default();
        layers.draw_solid(&drawing, which, (side as usize, drawn.clone()));
        let depths = depths(&layers.front, (side, &drawn), self.slack);
        for (y, depths) in drawn.zip(depths.chunks(side as usize)).filter(|(y, _)| changed.contains(y)) {
            for (x, texels) in (0..self.side).step_by(BLOCK as usize).zip(depths.chunks(BLOCK as usize)) {
                let at = (self.row(y as u32) + column(x)) as usize;
                self.depth[at..at + texels.len()].copy_from_slice(texels);
            }
        }
        self.measure(&changed);
    }

    /// Updates the depth ranges of the blocks in and around some rows of texels.
    fn measure(&mut self, rows: &Range<i32>) {
        let (block, across) = (BLOCK as i32, (self.side / BLOCK) as i32);
        let changed = grown(&(rows.start / block..(rows.end + block - 1) / block), 1, across);
        let around = grown(&changed, 1, across);
        let at = |row: i32| (row * across) as usize;
        let texels = (BLOCK * BLOCK) as usize;
        let found = blocks(&self.depth[at(around.start) * texels..at(around.end) * texels]);
        let found = widened(&found, across as usize);
        let first = at(changed.start - around.start);
        let count = at(changed.end - changed.start);
        self.blocks[at(changed.start)..at(changed.end)].copy_from_slice(&found[first..first + count]);
    }

    /// The map at another moment, at which some instances have moved; `None` if the map is unchanged.
    pub(super) fn followed(
        &self,
        store: &Store,
        moments: [&Snapshot; 2],
        moved: &[u32],
        which: impl Iterator<Item = u32>,
    ) -> Option<Self> {
        let frustum = Frustum::new(&self.camera, &(0..self.side as i32));
        let rows = |index: &u32| moments.map(|moment| self.rows_of(&frustum, &moment.instances[*index as usize]));
        let rows = moved.iter().flat_map(rows).flatten();
        let rows = rows.reduce(|a, b| a.start.min(b.start)..a.end.max(b.end))?;
        let mut map = self.clone();
        map.draw(store, moments[1], which, &rows);
        Some(map)
    }

    /// The rows in which an instance may be the nearest; `None` if something else is nearer everywhere.
    fn rows_of(&self, frustum: &Frustum, instance: &Instance) -> Option<Range<i32>> {
        if frustum.misses(&instance.ball) {
            return None;
        }
        let map = frustum.map.after(&instance.world).narrow();
        let seen = frustum.extent(&map, &instance.link.levels[0].bounds)?;
        let across = self.side / BLOCK;
        let [low, high] = [seen.low, seen.high].map(|at| at.map(|v| v as u32 / BLOCK));
        let hides = |x: u32, y: u32| self.blocks[(y * across + x) as usize][1] < seen.nearest - self.slack;
        let hidden = (low[1]..=high[1]).all(|y| (low[0]..=high[0]).all(|x| hides(x, y)));
        (!hidden).then_some(seen.low[1]..seen.high[1] + 1)
    }

    /// The sun's map of everything within a sphere.
    pub(super) fn sun(
        store: &Store,
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
        Self::new(store, snapshot, all, &camera.looking(eye, middle), (DISC, 0.015))
    }
}

/// A range of rows extended by `by` on each side, within all there are.
fn grown(rows: &Range<i32>, by: i32, all: i32) -> Range<i32> {
    (rows.start - by).max(0)..(rows.end + by).min(all)
}

/// Depths row by row, with clearances in the lowest bits; a clearance is correct only as far as it does not
/// reach beyond the rows.
fn depths(target: &Target, (side, rows): (i32, &Range<i32>), slack: f32) -> Vec<f32> {
    let width = side as usize;
    let mut clear = vec![0; width * rows.len()];
    let inner = (rows.start + 1).max(1)..(rows.end - 1).min(side - 1);
    clear.par_chunks_mut(width).zip(rows.clone()).filter(|(_, y)| inner.contains(y)).for_each(|(out, y)| {
        let [above, own, below] = [y - 1, y, y + 1].map(|y| target.inverse_row(y));
        crate::math::simd::widest(
            #[inline(always)]
            || even([above, own, below], 0.05 * slack, out),
        );
    });
    let clear = spread(&spread(&clear, 1), width);
    let inverse = rows.clone().flat_map(|y| target.inverse_row(y));
    let depth = |(v, clear): (&f32, u8)| f32::from_bits((1.0 / v.max(1e-12)).to_bits() & !CLEAR | u32::from(clear));
    inverse.zip(clear).map(depth).collect()
}

/// Marks texels of a row whose depth is the mean of their neighbours', up to a tolerance in metres.
#[inline(always)]
fn even([above, own, below]: [&[f32]; 3], slack: f32, out: &mut [u8]) {
    let count = out.len() - 2;
    let out = &mut out[1..=count];
    let (left, middle, right) = (&own[..count], &own[1..=count], &own[2..]);
    let (above, below) = (&above[1..=count], &below[1..=count]);
    for x in 0..count {
        let twice = 2.0 * middle[x];
        let bends = ((left[x] + right[x] - twice).abs()).max((above[x] + below[x] - twice).abs());
        // The derivative of inverse depth with respect to depth.
        out[x] = if bends <= slack * middle[x] * middle[x] { CLEAR as u8 } else { 0 };
    }
}

/// Distance to the nearest zero along an axis, if it is less than the number there.
fn spread(from: &[u8], stride: usize) -> Vec<u8> {
    const PART: usize = 4096;
    let mut near = from.to_vec();
    near.par_chunks_mut(PART).enumerate().for_each(|(part, near)| {
        let (start, end) = (part * PART, part * PART + near.len());
        for by in 1..=REACH as usize {
            // Texels at the border are zero, so a zero beyond them need not be found.
            let after = from.get(start + by * stride..).unwrap_or(&[]);
            let missing = (by * stride).saturating_sub(start).min(near.len());
            let before = &from[(start + missing).saturating_sub(by * stride)..end.saturating_sub(by * stride)];
            crate::math::simd::widest(
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

/// Lowers numbers to others, which count as no less than `least`.
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

/// Least and greatest depth of every block and its neighbours.
fn widened(blocks: &[[f32; 2]], across: usize) -> Vec<[f32; 2]> {
    let around = |at: usize, count: usize| at.saturating_sub(1)..(at + 2).min(count);
    let wide = |i: usize| {
        let rows = around(i / across, blocks.len() / across);
        let near = rows.flat_map(|y| around(i % across, across).map(move |x| blocks[y * across + x]));
        near.fold([f32::INFINITY, 0.0], |a: [f32; 2], b| [a[0].min(b[0]), a[1].max(b[1])])
    };
    (0..blocks.len()).map(wide).collect()
}

impl Cube {
    pub(super) fn new(store: &Store, snapshot: &Snapshot, which: &[u32], at: [f32; 3], radius: f32) -> Self {
        let eye = Point3::from(at);
        // The field of view is a little more than a right angle, so that samples at the border stay within.
        let focal = 0.5 * LAMP as f32 * 0.95;
        let centre = 0.5 * LAMP as f32;
        let camera = Camera { near: 0.02, ..Camera::with_intrinsics(LAMP, LAMP, (focal, focal), (centre, centre)) };
        let face = |axis: usize| {
            let towards = Vector3::ith(axis % 3, if axis < 3 { 1.0 } else { -1.0 });
            let camera = camera.looking(eye, eye + towards);
            Arc::new(ShadowMap::new(store, snapshot, which.iter().copied(), &camera, (radius, 0.025)))
        };
        Self((0..6).map(face).collect())
    }

    /// The maps at another moment, as [`ShadowMap::followed`] makes them.
    pub(super) fn followed(
        &self,
        store: &Store,
        moments: [&Snapshot; 2],
        moved: &[u32],
        which: impl Iterator<Item = u32> + Clone,
    ) -> Self {
        let face = |map: &Arc<ShadowMap>| {
            map.followed(store, moments, moved, which.clone()).map_or_else(|| map.clone(), Arc::new)
        };
        Self(self.0.iter().map(face).collect())
    }
}
