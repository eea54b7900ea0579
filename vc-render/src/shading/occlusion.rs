//! Ambient occlusion by nearby things, at half the resolution or a quarter.
//!
//! Depths around a pixel are compared with the plane that is visible there (after Bavoil and Sainz 2009). This
//! needs only depth: inverse depth is linear over a plane's image.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

use std::ops::Range;
use std::sync::LazyLock;

use rayon::prelude::*;

use crate::camera::Camera;
use crate::math::simd;
use crate::math::simd::whole;
use crate::rasterization::Layers;

/// Distance up to which things occlude ambient light, metres.
const REACH: f32 = 0.45;
/// Number of comparisons for each point; sixteen neighbours use different directions.
const TAPS: usize = 6;
/// Number of points processed together.
const LANES: usize = 64;
/// Number of rows given to a thread at a time.
const ROWS: usize = 8;

/// Images with fewer rows use the finer resolution.
const LARGE: u32 = 240;

/// Inverse depth and openness (0 to 1) at every second or fourth pixel of every such row.
#[derive(Default)]
pub(crate) struct Openness {
    /// Distance between the points, pixels.
    step: usize,
    across: usize,
    down: usize,
    inverse: Vec<f32>,
    depth: Vec<f32>,
    open: Vec<f32>,
    blurred: Vec<f32>,
}

/// For each of four rows, offsets of the comparisons of each point, in radii.
static SPIRALS: LazyLock<Vec<[[[f32; LANES]; 2]; TAPS]>> = LazyLock::new(|| {
    use vc_graph::portable::Portable;
    let tap = |turn: usize, k: usize| {
        let (s, c) = (2.399_963_2 * k as f32 + std::f32::consts::FRAC_PI_8 * turn as f32).sine_cosine();
        let far = ((k as f32 + 0.3 + (turn * 7 % 16) as f32 / 22.0) / TAPS as f32).sqrt().min(1.0);
        [far * c, far * s]
    };
    let turn = |x: usize, y: usize| (x % 4 * 5 + y * 7) % 16;
    let row =
        |y: usize| std::array::from_fn(|k| [0, 1].map(|axis: usize| std::array::from_fn(|x| tap(turn(x, y), k)[axis])));
    (0..4).map(row).collect()
});

impl Openness {
    /// Computes openness for all bands.
    pub(super) fn find<'a>(&mut self, camera: &Camera, bands: impl Iterator<Item = (&'a Layers, Range<i32>)>) {
        let (width, height) = (camera.width as usize, camera.height as usize);
        self.step = if camera.height < LARGE { 2 } else { 4 };
        (self.across, self.down) = (width.div_ceil(self.step), height.div_ceil(self.step));
        self.inverse.clear();
        for (layers, rows) in bands {
            let solid = layers.solid();
            for y in rows.filter(|y| y % self.step as i32 == 0) {
                self.inverse.extend(solid.inverse_row(y).iter().step_by(self.step));
            }
        }
        self.depth.clear();
        self.depth.extend(self.inverse.iter().map(|v| 1.0 / v.max(1e-6)));
        self.open.resize(self.across * self.down, 1.0);
        self.blurred.resize(self.across * self.down, 1.0);
        let spirals = &*SPIRALS;
        let around = Surroundings {
            share: 1.0 / self.step as f32,
            inverse: &self.inverse,
            depth: &self.depth,
            across: self.across,
            down: self.down,
            camera,
        };
        let each = self.across * ROWS;
        self.open.par_chunks_mut(each).enumerate().for_each(|(chunk, rows)| {
            simd::widest(
                #[inline(always)]
                || {
                    for (i, row) in rows.chunks_mut(around.across).enumerate() {
                        let y = chunk * ROWS + i;
                        for (j, out) in row.chunks_mut(LANES).enumerate() {
                            around.open(j * LANES, y, &spirals[y % 4], out);
                        }
                    }
                },
            );
        });
        self.blur(across);
        self.blur(down);
    }

    /// Averages over neighbours at the same depth along an axis, whose comparisons have different directions.
    fn blur(&mut self, means: impl Fn(&Self, usize, &mut [f32]) + Sync) {
        let mut blurred = std::mem::take(&mut self.blurred);
        blurred.par_chunks_mut(self.across * ROWS).enumerate().for_each(|(chunk, rows)| {
            simd::widest(
                #[inline(always)]
                || {
                    for (i, out) in rows.chunks_mut(self.across).enumerate() {
                        means(self, chunk * ROWS + i, out);
                    }
                },
            );
        });
        self.blurred = std::mem::replace(&mut self.open, blurred);
    }

    /// Inverse depth and openness of a row.
    #[inline(always)]
    fn row(&self, y: usize) -> (&[f32], &[f32]) {
        let at = y * self.across..(y + 1) * self.across;
        (&self.inverse[at.clone()], &self.open[at])
    }

    /// Openness at a pixel: that of the one of the four surrounding points whose depth is nearest.
    #[inline(always)]
    pub(super) fn at(&self, x: usize, y: usize, inverse: f32) -> f32 {
        let (x0, y0) = (x / self.step, y / self.step);
        let (x1, y1) = (x.div_ceil(self.step).min(self.across - 1), y.div_ceil(self.step).min(self.down - 1));
        let (mut best, mut open) = (f32::INFINITY, 1.0);
        for at in [y0 * self.across + x0, y0 * self.across + x1, y1 * self.across + x0, y1 * self.across + x1] {
            let apart = (self.inverse[at] - inverse).abs();
            (best, open) = if apart < best { (apart, self.open[at]) } else { (best, open) };
        }
        open
    }
}

/// Number of points averaged, and their weights: the directions of comparisons repeat at that distance.
const WINDOW: usize = 5;
const WEIGHTS: [f32; WINDOW] = [0.5, 1.0, 1.0, 1.0, 0.5];

/// Start of the window around a point among `count`; near the ends it is shifted.
#[inline(always)]
fn window(at: usize, count: usize) -> usize {
    at.saturating_sub(WINDOW / 2).min(count.saturating_sub(WINDOW))
}

/// Averages along a row.
#[inline(always)]
fn across(all: &Openness, y: usize, out: &mut [f32]) {
    let ((inverse, open), count) = (all.row(y), out.len());
    let mut part = |at: usize, length: usize| {
        let first = |k: usize| (window(at, count) + k).min(count - length);
        let lists = [inverse, open].map(|list| std::array::from_fn(|k| &list[first(k)..][..length]));
        means(&inverse[at..at + length], lists, &mut out[at..at + length]);
    };
    let edge = (WINDOW / 2).min(count);
    let middle = count.saturating_sub(2 * edge);
    (0..edge).chain(edge + middle..count).for_each(|at| part(at, 1));
    part(edge, middle);
}

/// Averages along columns, for a row.
#[inline(always)]
fn down(all: &Openness, y: usize, out: &mut [f32]) {
    let from = window(y, all.down);
    let rows: [_; WINDOW] = std::array::from_fn(|k| all.row((from + k).min(all.down - 1)));
    means(all.row(y).0, [rows.map(|row| row.0), rows.map(|row| row.1)], out);
}

/// Writes weighted means of lists, over entries at the same depth as the own points.
#[inline(always)]
fn means(own: &[f32], [inverse, open]: [[&[f32]; WINDOW]; 2], out: &mut [f32]) {
    let count = own.len().min(out.len());
    for i in 0..count {
        let (mut sum, mut all) = (0.0, 0.0);
        for k in 0..WINDOW {
            let near = (inverse[k][i] - own[i]).abs() <= 0.04 * own[i];
            let share = if near { WEIGHTS[k] } else { 0.0 };
            (sum, all) = (sum + share * open[k][i], all + share);
        }
        out[i] = sum / all;
    }
}

struct Surroundings<'a> {
    /// Points for each pixel.
    share: f32,
    inverse: &'a [f32],
    depth: &'a [f32],
    across: usize,
    down: usize,
    camera: &'a Camera,
}

impl Surroundings<'_> {
    /// Computes the openness of some points of a row.
    #[inline(always)]
    fn open(&self, x0: usize, y: usize, taps: &[[[f32; LANES]; 2]; TAPS], out: &mut [f32]) {
        let count = out.len().min(LANES);
        let last = [self.across as i32 - 1, self.down as i32 - 1];
        let focal = self.share * self.camera.focal.0;
        let centre = [self.share * self.camera.centre.0, self.share * self.camera.centre.1];
        // Whole vectors are processed; lanes past the end are not used.
        let lanes = count.next_multiple_of(8).min(LANES);
        let mut here = [1.0_f32; LANES];
        let mut slope = [[0.0_f32; LANES]; 2];
        self.slopes(x0, y, (&mut here, &mut slope), count);
        let (mut over, mut radius, mut kept) = ([0.0_f32; LANES], [0.0_f32; LANES], [0.0_f32; LANES]);
        let down = y as f32 + 0.5 * self.share - centre[1];
        for i in 0..lanes {
            let across = (x0 + i) as i32 as f32 + 0.5 * self.share - centre[0];
            let [gx, gy] = [slope[0][i], slope[1][i]];
            let n = [gx * focal, gy * focal, here[i] - gx * across - gy * down];
            over[i] = 1.0 / (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]).sqrt();
            let wanted = focal * here[i] * REACH;
            radius[i] = wanted.min(0.2 * last[1] as f32).max(1.5);
        }
        let (mut at, mut there) = ([0_u32; LANES], [0.0_f32; LANES]);
        let (mut dx, mut dy) = ([0.0_f32; LANES], [0.0_f32; LANES]);
        let mut depth = [0.0_f32; LANES];
        for i in 0..lanes {
            depth[i] = 1.0 / here[i].max(1e-6);
        }
        let wide = 1.0 / focal;
        for tap in taps {
            for i in 0..lanes {
                let (x, y) = ((x0 + i) as i32 as f32, y as i32 as f32);
                let tx = (x + tap[0][i] * radius[i]).max(0.0).min(last[0] as f32);
                let ty = (y + tap[1][i] * radius[i]).max(0.0).min(last[1] as f32);
                let (column, row) = (whole(tx), whole(ty));
                (dx[i], dy[i]) = (column as i32 as f32 - x, row as i32 as f32 - y);
                at[i] = row * self.across as u32 + column;
            }
            for i in 0..lanes {
                there[i] = self.depth[at[i] as usize];
            }
            for i in 0..lanes {
                let other = there[i];
                // Height above the plane, metres, and squared distance.
                let rise = (1.0 - other * (here[i] + slope[0][i] * dx[i] + slope[1][i] * dy[i])) * over[i];
                let (flat, deep) = (depth[i] * wide, other - depth[i]);
                let square = (dx[i] * dx[i] + dy[i] * dy[i]) * flat * flat + deep * deep + 1e-8;
                let sine = rise / square.sqrt() - 0.06;
                let near = 1.0 - square * (1.0 / (REACH * REACH));
                let (sine, near) = (if sine > 0.0 { sine } else { 0.0 }, if near > 0.0 { near } else { 0.0 });
                kept[i] += if sine < 1.0 { sine } else { 1.0 } * near;
            }
        }
        for i in 0..count {
            out[i] = (1.0 - 1.7 / TAPS as f32 * kept[i]).max(0.08);
        }
    }

    /// Inverse depths, and their gradients to the right and down over the visible surface.
    #[inline(always)]
    fn slopes(&self, x0: usize, y: usize, (here, slope): (&mut [f32; LANES], &mut [[f32; LANES]; 2]), count: usize) {
        let row = |y: usize| &self.inverse[y * self.across..(y + 1) * self.across];
        let (above, own, below) = (row(y.saturating_sub(1)), row(y), row((y + 1).min(self.down - 1)));
        let lesser = |a: f32, b: f32| if a.abs() < b.abs() { a } else { b };
        for i in 0..count {
            let x = x0 + i;
            let v = own[x];
            here[i] = v;
            let (left, right) = (own[x.saturating_sub(1)], own[(x + 1).min(self.across - 1)]);
            slope[0][i] = if x == 0 {
                right - v
            } else if x + 1 == self.across {
                v - left
            } else {
                lesser(right - v, v - left)
            };
            let (up, down) = (v - above[x], below[x] - v);
            slope[1][i] = if y == 0 {
                down
            } else if y + 1 == self.down {
                up
            } else {
                lesser(down, up)
            };
        }
    }
}
