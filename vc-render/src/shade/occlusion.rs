//! How much light from all sides nearby things keep away, at half the resolution.
//!
//! By comparison with the plane that is seen at a pixel (after Bavoil and Sainz 2009), which
//! needs no more than depth: inverse depth is linear over a plane's image.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

use std::sync::LazyLock;

use rayon::prelude::*;

use crate::camera::Camera;
use crate::frame::Band;
use crate::simd;
use crate::simd::whole;

/// How far things keep light away, metres.
const REACH: f32 = 0.45;
/// Comparisons for each point; sixteen neighbours look in different directions.
const TAPS: usize = 6;
/// Points that are found at once.
const LANES: usize = 64;
/// Rows given to a thread at a time.
const ROWS: usize = 8;

/// Half the picture: inverse depth, and how open every point is, 0 to 1.
#[derive(Default)]
pub(crate) struct Openness {
    across: usize,
    down: usize,
    inverse: Vec<f32>,
    depth: Vec<f32>,
    open: Vec<f32>,
    blurred: Vec<f32>,
}

/// For each of four rows: where each comparison of a point looks, in radii.
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
    /// Finds it for what has been drawn in all bands.
    pub(super) fn find(&mut self, camera: &Camera, bands: &[Band]) {
        let (width, height) = (camera.width as usize, camera.height as usize);
        (self.across, self.down) = (width.div_ceil(2), height.div_ceil(2));
        self.inverse.clear();
        for band in bands {
            let solid = band.layers.solid();
            for y in band.rows.clone().filter(|y| y % 2 == 0) {
                let (pairs, last) = solid.inverse_row(y).as_chunks::<2>();
                self.inverse.extend(pairs.iter().map(|pair| pair[0]));
                self.inverse.extend(last);
            }
        }
        self.depth.clear();
        self.depth.extend(self.inverse.iter().map(|v| 1.0 / v.max(1e-6)));
        self.open.resize(self.across * self.down, 1.0);
        self.blurred.resize(self.across * self.down, 1.0);
        let spirals = &*SPIRALS;
        let look = Look { inverse: &self.inverse, depth: &self.depth, across: self.across, down: self.down, camera };
        let each = self.across * ROWS;
        self.open.par_chunks_mut(each).enumerate().for_each(|(chunk, rows)| {
            simd::widest(
                #[inline(always)]
                || {
                    for (i, row) in rows.chunks_mut(look.across).enumerate() {
                        let y = chunk * ROWS + i;
                        for (j, out) in row.chunks_mut(LANES).enumerate() {
                            look.open(j * LANES, y, &spirals[y % 4], out);
                        }
                    }
                },
            );
        });
        self.blur(1);
        self.blur(self.across);
    }

    /// The mean over four neighbours along an axis, whose directions differ, where they are as deep.
    fn blur(&mut self, step: usize) {
        let (across, inverse, open) = (self.across, &self.inverse, &self.open);
        self.blurred.par_chunks_mut(across * ROWS).enumerate().for_each(|(chunk, rows)| {
            simd::widest(
                #[inline(always)]
                || blur(inverse, open, (chunk * across * ROWS, step), rows),
            );
        });
        std::mem::swap(&mut self.open, &mut self.blurred);
    }

    /// How open a pixel is: of the four points around it the one at its depth counts.
    #[inline(always)]
    pub(super) fn at(&self, x: usize, y: usize, inverse: f32) -> f32 {
        let (x0, y0) = (x / 2, y / 2);
        let (x1, y1) = (x.div_ceil(2).min(self.across - 1), y.div_ceil(2).min(self.down - 1));
        let (mut best, mut open) = (f32::INFINITY, 1.0);
        for at in [y0 * self.across + x0, y0 * self.across + x1, y1 * self.across + x0, y1 * self.across + x1] {
            let apart = (self.inverse[at] - inverse).abs();
            (best, open) = if apart < best { (apart, self.open[at]) } else { (best, open) };
        }
        open
    }
}

/// Writes means of rows, the first of which begins at `first`.
#[inline(always)]
fn blur(inverse: &[f32], open: &[f32], (first, step): (usize, usize), out: &mut [f32]) {
    // At the image's border, what would be beyond is left as it is.
    let low = (2 * step).saturating_sub(first).min(out.len());
    let high = (inverse.len().saturating_sub(first + 2 * step)).min(out.len()).max(low);
    out[..low].copy_from_slice(&open[first..first + low]);
    let end = first + out.len();
    out[high..].copy_from_slice(&open[first + high..end]);
    let count = high - low;
    if count == 0 {
        return;
    }
    let from = first + low;
    let [d0, d1, d2, d3, d4] = [0, 1, 2, 3, 4].map(|k: usize| &inverse[from + k * step - 2 * step..][..count]);
    let [o0, o1, o2, o3, o4] = [0, 1, 2, 3, 4].map(|k: usize| &open[from + k * step - 2 * step..][..count]);
    let out = &mut out[low..high];
    for i in 0..count {
        let slack = 0.04 * d2[i];
        let share = |d: f32, most: f32| if (d - d2[i]).abs() <= slack { most } else { 0.0 };
        let [a, b, c, d] = [share(d0[i], 0.5), share(d1[i], 1.0), share(d3[i], 1.0), share(d4[i], 0.5)];
        let sum = a * o0[i] + b * o1[i] + o2[i] + c * o3[i] + d * o4[i];
        out[i] = sum / (1.0 + a + b + c + d);
    }
}

struct Look<'a> {
    inverse: &'a [f32],
    depth: &'a [f32],
    across: usize,
    down: usize,
    camera: &'a Camera,
}

impl Look<'_> {
    /// How open some points of a row are.
    #[inline(always)]
    fn open(&self, x0: usize, y: usize, taps: &[[[f32; LANES]; 2]; TAPS], out: &mut [f32]) {
        let count = out.len().min(LANES);
        let last = [self.across as i32 - 1, self.down as i32 - 1];
        let focal = 0.5 * self.camera.focal.0;
        let centre = [0.5 * self.camera.centre.0, 0.5 * self.camera.centre.1];
        let mut here = [1.0_f32; LANES];
        let mut slope = [[0.0_f32; LANES]; 2];
        self.slopes(x0, y, (&mut here, &mut slope), count);
        let (mut over, mut radius, mut kept) = ([0.0_f32; LANES], [0.0_f32; LANES], [0.0_f32; LANES]);
        let down = y as f32 + 0.25 - centre[1];
        for i in 0..LANES {
            let across = (x0 + i) as f32 + 0.25 - centre[0];
            let [gx, gy] = [slope[0][i], slope[1][i]];
            let n = [gx * focal, gy * focal, here[i] - gx * across - gy * down];
            over[i] = 1.0 / (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]).sqrt();
            let wanted = focal * here[i] * REACH;
            radius[i] = wanted.min(0.2 * last[1] as f32).max(1.5);
        }
        let (mut at, mut there) = ([0_u32; LANES], [0.0_f32; LANES]);
        let (mut dx, mut dy) = ([0.0_f32; LANES], [0.0_f32; LANES]);
        let mut depth = [0.0_f32; LANES];
        for i in 0..LANES {
            depth[i] = 1.0 / here[i].max(1e-6);
        }
        let wide = 1.0 / focal;
        for tap in taps {
            for i in 0..LANES {
                let (x, y) = ((x0 + i) as f32, y as f32);
                let tx = (x + tap[0][i] * radius[i]).max(0.0).min(last[0] as f32);
                let ty = (y + tap[1][i] * radius[i]).max(0.0).min(last[1] as f32);
                let (column, row) = (whole(tx), whole(ty));
                (dx[i], dy[i]) = (column as i32 as f32 - x, row as i32 as f32 - y);
                at[i] = row * self.across as u32 + column;
            }
            for i in 0..LANES {
                there[i] = self.depth[at[i] as usize];
            }
            for i in 0..LANES {
                let other = there[i];
                // How high it is over the plane, metres, and how far away.
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

    /// Inverse depths, and how they change to the right and down over the surface seen.
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
