//! Where light is found, and where it is taken from neighbours.
//!
//! Light is found at every fourth pixel of every fourth row. Of the pixels between, those get
//! the mean of their neighbours' that see the same plane of the same thing under nearly the
//! same light; for the others it is found as well. So smooth walls cost little, and edges of
//! shadows and things lose nothing.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

use super::planes::{LIGHT, Planes, ROWS};

/// How far inverse depth may be from its neighbours' mean, as a share.
const FLAT: f32 = 0.01;
/// The same where there is a neighbour on one side only.
const LONE: f32 = 0.05;
/// Largest share by which neighbours' light may differ.
const ALIKE: f32 = 0.10;

/// Pixels of a strip: row and column, sixteen bits each.
pub(super) type Spots = Vec<u32>;

#[inline(always)]
pub(super) fn spot(row: usize, x: usize) -> u32 {
    (row << 16 | x) as u32
}

/// A pixel and the two it lies between.
#[derive(Clone, Copy)]
struct Three {
    own: usize,
    before: usize,
    after: usize,
}

impl Planes {
    /// Fills in a row between its pixels that are known: those at odd multiples of `step`.
    #[inline(always)]
    pub(super) fn along(&mut self, row: usize, step: usize, spots: &mut Spots) {
        let first = row * self.width;
        let inner = (self.width.saturating_sub(step + 1)) / (2 * step);
        let three = |k: usize| first + step + 2 * step * k;
        let mut alike = std::mem::take(&mut self.alike);
        for (k, alike) in alike[..inner].iter_mut().enumerate() {
            let own = three(k);
            *alike = self.agree(Three { own, before: own - step, after: own + step });
        }
        for k in 0..inner {
            let own = three(k);
            self.mean(Three { own, before: own - step, after: own + step });
        }
        for (k, alike) in alike[..inner].iter().enumerate() {
            if !alike {
                spots.push(spot(row, step + 2 * step * k));
            }
        }
        // The last one may have a neighbour on one side only.
        let x = step + 2 * step * inner;
        if x < self.width {
            let (own, before) = (first + x, first + x - step);
            if self.agree(Three { own, before, after: before }) {
                self.mean(Three { own, before, after: before });
            } else {
                spots.push(spot(row, x));
            }
        }
        self.alike = alike;
    }

    /// Fills in a row between rows above and below, at multiples of `step`.
    #[inline(always)]
    pub(super) fn between(&mut self, row: usize, (above, below): (usize, usize), step: usize, spots: &mut Spots) {
        let width = self.width;
        let three = |x: usize| Three { own: row * width + x, before: above * width + x, after: below * width + x };
        let count = width.div_ceil(step);
        let mut alike = std::mem::take(&mut self.alike);
        if step == 1 {
            self.rows_agree([row, above, below].map(|r: usize| r * width), &mut alike[..width]);
        } else {
            for (k, alike) in alike[..count].iter_mut().enumerate() {
                *alike = self.agree(three(step * k));
            }
        }
        for (k, alike) in alike[..count].iter().enumerate() {
            if !alike {
                spots.push(spot(row, step * k));
            }
        }
        self.alike = alike;
        for plane in &mut self.light {
            mean(plane, (row * width, above * width, below * width), width);
        }
        self.drift.copy_within(above * width..(above + 1) * width, row * width);
    }

    /// [`Self::agree`] for all pixels of a row and those of two others, which begin there.
    #[inline(always)]
    fn rows_agree(&self, [own, before, after]: [usize; 3], alike: &mut [bool]) {
        let width = alike.len();
        let slack = if before == after { LONE } else { FLAT };
        let (l0, l1, l2) =
            (rows(&self.look, own, width), rows(&self.look, before, width), rows(&self.look, after, width));
        let depth = &self.inverse;
        let (v0, v1, v2) = (rows(depth, own, width), rows(depth, before, width), rows(depth, after, width));
        let (green, sheen) = (&self.light[1], &self.light[LIGHT - 2]);
        let (g1, g2) = (rows(green, before, width), rows(green, after, width));
        let (s1, s2) = (rows(sheen, before, width), rows(sheen, after, width));
        for x in 0..width {
            let same = (l1[x] == l0[x]) & (l2[x] == l0[x]);
            let flat = (2.0 * v0[x] - v1[x] - v2[x]).abs() <= slack * v0[x];
            let (a, b) = (0.2 * g1[x] + s1[x], 0.2 * g2[x] + s2[x]);
            alike[x] = same & flat & ((a - b).abs() <= ALIKE * (a + b) * 0.5);
        }
    }

    #[inline(always)]
    fn agree(&self, Three { own, before, after }: Three) -> bool {
        let look = self.look[own];
        let same = (self.look[before] == look) & (self.look[after] == look);
        let slack = if before == after { LONE } else { FLAT };
        let flat =
            (2.0 * self.inverse[own] - self.inverse[before] - self.inverse[after]).abs() <= slack * self.inverse[own];
        let bright = |at: usize| 0.2 * self.light[1][at] + self.light[LIGHT - 2][at];
        let (a, b) = (bright(before), bright(after));
        same & flat & ((a - b).abs() <= ALIKE * (a + b) * 0.5)
    }

    #[inline(always)]
    fn mean(&mut self, Three { own, before, after }: Three) {
        for plane in &mut self.light {
            plane[own] = 0.5 * (plane[before] + plane[after]);
        }
        self.drift[own] = self.drift[before];
    }
}

/// A row of a plane, from where it begins on.
#[inline(always)]
fn rows<T>(plane: &[T], at: usize, width: usize) -> &[T] {
    &plane[at..at + width]
}

/// Writes the mean of two rows of a plane into a third.
#[inline(always)]
fn mean(plane: &mut [f32], (own, above, below): (usize, usize, usize), width: usize) {
    let (low, high) = plane.split_at_mut(own);
    let (out, high) = high.split_at_mut(width);
    let other = |at: usize| if at < own { &low[at..at + width] } else { &high[at - own - width..at - own] };
    for ((out, a), b) in out.iter_mut().zip(other(above)).zip(other(below)) {
        *out = 0.5 * (a + b);
    }
}

/// The row half way to the next that is known, and those around it, of a strip with so
/// many rows after the first.
pub(super) fn neighbours(row: usize, step: usize, last: usize) -> (usize, usize) {
    let (above, below) = (row - step, row + step);
    (above, if below <= last.min(ROWS) { below } else { above })
}
