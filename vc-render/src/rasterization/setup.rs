//! Setup of triangles for rasterization, eight at once.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

use super::fill::{PIXEL, SMALL, tie};
use super::project::Points;
use super::target::{LANES, Target};
use crate::mesh::MOST;

/// Number of triangles set up together.
pub(super) const EIGHT: usize = 8;

/// Space for all triangles of a cluster, and for a candidate written after them.
pub(super) const SIFTED: usize = (MOST + 1).next_multiple_of(EIGHT);

/// Corners of eight triangles, as indices into one of a cluster's arrays.
type Corners = [[u8; EIGHT]; 3];

type Whole = [i32; EIGHT];
type Real = [f32; EIGHT];

/// Eight triangles set up for rasterization.
pub(super) struct Setup {
    /// First and last pixel of the bounding boxes.
    low: [Whole; 2],
    high: [Whole; 2],
    /// Edge functions at the first pixel of a triangle's first block and row, and their change from pixel to
    /// pixel and from row to row.
    pub(super) value: [Whole; 3],
    pub(super) across: [Whole; 3],
    pub(super) down: [Whole; 3],
    /// Reciprocal of the change from pixel to pixel; zero if there is no change.
    pub(super) over: [Real; 3],
    /// Gradient of inverse depth across and down, its value at the first pixel in the row of the first corner,
    /// and that row.
    pub(super) slope: [Real; 2],
    pub(super) start: Real,
    pub(super) top: Real,
    /// Least and greatest inverse depth.
    pub(super) least: Real,
    pub(super) most: Real,
    /// Zero for triangles not drawn, one for small ones, two for those too large for 32 bits.
    kinds: Whole,
}

impl Setup {
    pub(super) fn new() -> Self {
        let (whole, real) = ([0; EIGHT], [0.0; EIGHT]);
        Self {
            low: [whole; 2],
            high: [whole; 2],
            value: [whole; 3],
            across: [whole; 3],
            down: [whole; 3],
            over: [real; 3],
            slope: [real; 2],
            start: real,
            top: real,
            least: real,
            most: real,
            kinds: whole,
        }
    }

    /// First and last pixel of a triangle, both included.
    #[inline(always)]
    pub(super) fn span(&self, lane: usize) -> ([i32; 2], [i32; 2]) {
        ([self.low[0][lane], self.low[1][lane]], [self.high[0][lane], self.high[1][lane]])
    }

    /// Front-facing triangles that may cover a pixel centre, and whether they are small.
    #[inline(always)]
    pub(super) fn drawn(&self) -> impl Iterator<Item = (usize, bool)> + '_ {
        self.kinds.iter().enumerate().filter(|(_, kind)| **kind > 0).map(|(lane, kind)| (lane, *kind == 1))
    }

    /// Selects the triangles of a cluster to set up: most others face away or lie between pixel centres. Their
    /// corners are wound from the x axis towards the y axis.
    #[inline(always)]
    pub(super) fn sift<'a>(
        &mut self,
        (points, mirrored): (&Points, bool),
        triangles: &[[u8; 3]],
        target: &Target,
        kept: &'a mut [u8; SIFTED],
    ) -> &'a [u8] {
        let mut count = 0;
        for (eight, first) in triangles.chunks(EIGHT).zip((0..).step_by(EIGHT)) {
            self.cover((points, mirrored), eight.iter().copied(), target);
            for lane in 0..EIGHT {
                kept[count % SIFTED] = first + lane as u8;
                count += usize::from(self.kinds[lane] > 0);
            }
        }
        &kept[..count.min(SIFTED)]
    }

    /// Sets up the given triangles.
    #[inline(always)]
    pub(super) fn load(
        &mut self,
        (points, mirrored): (&Points, bool),
        triangles: impl Iterator<Item = [u8; 3]>,
        target: &Target,
    ) {
        let (at, [x, y]) = self.cover((points, mirrored), triangles, target);
        self.edges(&x, &y);
        let [u, v, w] =
            [&points.across, &points.down, &points.inverse].map(|list| at.map(|at| at.map(|at| list[usize::from(at)])));
        self.depths(&u, &v, &w);
    }

    /// Finds the bounding boxes of triangles, and returns their corners.
    #[inline(always)]
    fn cover(
        &mut self,
        (points, mirrored): (&Points, bool),
        triangles: impl Iterator<Item = [u8; 3]>,
        target: &Target,
    ) -> (Corners, [[Whole; 3]; 2]) {
        // Lanes without a triangle have three equal corners and cover nothing.
        let mut at = [[0; EIGHT]; 3];
        for (lane, [a, b, c]) in (0..EIGHT).zip(triangles) {
            // Counter-clockwise seen from outside becomes clockwise with y down.
            let corners = if mirrored { [a, b, c] } else { [a, c, b] };
            (0..3).for_each(|k| at[k][lane] = corners[k]);
        }
        let [x, y] = [&points.x, &points.y].map(|list| at.map(|at| at.map(|at| list[usize::from(at)])));
        self.bound(&x, &y, target);
        (at, [x, y])
    }

    /// Finds the bounding boxes of triangles. Triangles that contain no pixel centre or are seen from behind
    /// are not drawn, nor are lanes without a triangle, whose corners are equal.
    #[inline(always)]
    fn bound(&mut self, x: &[Whole; 3], y: &[Whole; 3], target: &Target) {
        let (width, rows) = (target.width as i32, target.rows.clone());
        for i in 0..EIGHT {
            let (low_x, high_x) = (x[0][i].min(x[1][i]).min(x[2][i]), x[0][i].max(x[1][i]).max(x[2][i]));
            let (low_y, high_y) = (y[0][i].min(y[1][i]).min(y[2][i]), y[0][i].max(y[1][i]).max(y[2][i]));
            self.low[0][i] = ((low_x + 127) >> 8).max(0);
            self.low[1][i] = ((low_y + 127) >> 8).max(rows.start);
            self.high[0][i] = ((high_x - 128) >> 8).min(width - 1);
            self.high[1][i] = ((high_y - 128) >> 8).min(rows.end - 1);
            let covers = (self.low[0][i] <= self.high[0][i]) & (self.low[1][i] <= self.high[1][i]);
            let small = (high_x - low_x <= SMALL) & (high_y - low_y <= SMALL);
            // The winding of large triangles is tested when they are drawn.
            let area = (x[1][i] - x[0][i])
                .wrapping_mul(y[2][i] - y[0][i])
                .wrapping_sub((y[1][i] - y[0][i]).wrapping_mul(x[2][i] - x[0][i]));
            let kind = if small { i32::from(area > 0) } else { 2 };
            self.kinds[i] = if covers { kind } else { 0 };
        }
    }

    /// Sets up the edge functions of small triangles.
    #[inline(always)]
    fn edges(&mut self, x: &[Whole; 3], y: &[Whole; 3]) {
        for (k, next) in [(0, 1), (1, 2), (2, 0)] {
            for i in 0..EIGHT {
                let (dx, dy) = (x[next][i] - x[k][i], y[next][i] - y[k][i]);
                let first = self.low[0][i] & !(LANES as i32 - 1);
                let right = first.wrapping_mul(PIXEL).wrapping_add(PIXEL / 2 - x[k][i]);
                let below = self.low[1][i].wrapping_mul(PIXEL).wrapping_add(PIXEL / 2 - y[k][i]);
                self.value[k][i] = dx.wrapping_mul(below).wrapping_sub(dy.wrapping_mul(right)) - tie(dx, dy);
                self.across[k][i] = dy.wrapping_mul(-PIXEL);
                self.down[k][i] = dx.wrapping_mul(PIXEL);
                self.over[k][i] = if dy == 0 { 0.0 } else { 1.0 / self.across[k][i] as f32 };
            }
        }
    }

    #[inline(always)]
    fn depths(&mut self, u: &[Real; 3], v: &[Real; 3], w: &[Real; 3]) {
        for i in 0..EIGHT {
            let (bx, by, bz) = (u[1][i] - u[0][i], v[1][i] - v[0][i], w[1][i] - w[0][i]);
            let (cx, cy, cz) = (u[2][i] - u[0][i], v[2][i] - v[0][i], w[2][i] - w[0][i]);
            let over = 1.0 / (bx * cy - by * cx);
            self.slope[0][i] = (bz * cy - cz * by) * over;
            self.slope[1][i] = (cz * bx - bz * cx) * over;
            let first = (self.low[0][i] & !(LANES as i32 - 1)) as f32;
            self.start[i] = w[0][i] + self.slope[0][i] * (first + 0.5 - u[0][i]);
            self.top[i] = v[0][i];
            let (least, most) = (w[0][i].min(w[1][i]).min(w[2][i]), w[0][i].max(w[1][i]).max(w[2][i]));
            (self.least[i], self.most[i]) = (least, most);
        }
    }
}
