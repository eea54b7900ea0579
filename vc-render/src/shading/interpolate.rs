//! Sparse shading: light is computed at some pixels and interpolated at the others.
//!
//! Light is computed at every fourth pixel of every fourth row. A pixel in between gets the mean of its
//! neighbours, if these show the same plane of the same thing in nearly the same light; a pixel at the edge of
//! a flat thing gets the light of the neighbour on that thing; for all others light is computed as well. Smooth
//! walls therefore cost little, and edges of shadows and things stay exact. Pixels of flat things right beside
//! pixels with known light get the mean however much these differ, which gives shadows smooth edges.
//!
//! In rows that interpolate sideways, every fourth pixel is stored contiguously, in four combs, so that
//! neighbours are contiguous too. The rows between those interpolate vertically.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

mod between;

use self::between::{Near, missing, mix, weigh};
use super::planes::{Cells, Planes};
use crate::math::simd::widest;

pub(super) use self::between::PART;

/// Numbers of light at a pixel: diffuse illumination (red, green, blue), and glossy light towards the eye.
pub(super) const LIGHT: usize = 6;
/// Number of combs of a row, and the step between rows in which light is computed first.
pub(super) const STEP: usize = 4;
/// Group of pixels past a row's end.
pub(super) const BEYOND: u32 = u32::MAX;

/// Pixels of a strip: row and column, sixteen bits each.
pub(super) type Spots = Vec<u32>;

#[inline(always)]
pub(super) fn spot(row: usize, x: usize) -> u32 {
    (row << 16 | x) as u32
}

/// The light in a strip.
#[derive(Default)]
pub(crate) struct SampleGrid {
    width: usize,
    /// Combs of every second row.
    combs: Vec<[Cells; STEP]>,
    /// Neighbours of pixels that have none.
    none: Cells,
}

/// Pixels of a comb that are to be interpolated.
#[derive(Clone, Copy)]
pub(super) struct Between {
    row: usize,
    comb: usize,
    /// Rows and combs of the neighbours. The second neighbour may be shifted by one within its comb, or be
    /// absent.
    before: (usize, usize),
    after: Option<(usize, usize, usize)>,
    /// Whether the neighbours are adjacent pixels.
    close: bool,
}

impl SampleGrid {
    /// Allocates `rows` rows of this width, and one more.
    pub(super) fn prepare(&mut self, width: usize, rows: usize) {
        self.width = width;
        self.combs.resize_with(rows / 2 + 1, Default::default);
        let count = width.div_ceil(STEP).next_multiple_of(PART) + 1;
        self.combs.iter_mut().flatten().for_each(|comb| comb.prepare(count));
        self.none.prepare(width.next_multiple_of(PART));
    }

    /// Moves the last row to the first.
    pub(super) fn turn(&mut self) {
        let last = self.combs.len() - 1;
        self.combs.swap(0, last);
    }

    /// Stores a row's groups and inverse depths.
    #[inline(always)]
    pub(super) fn write(&mut self, row: usize, seen: &Cells) {
        if row.is_multiple_of(2) {
            let combs = &mut self.combs[row / 2];
            deal(&seen.group[..self.width], combs.each_mut().map(|comb| comb.group.as_mut_slice()));
            deal(&seen.inverse[..self.width], combs.each_mut().map(|comb| comb.inverse.as_mut_slice()));
        }
    }

    /// The pixels of a row whose light is computed first.
    pub(super) fn first(&self, row: usize, spots: &mut Spots) {
        spots.extend((0..self.width).step_by(STEP).map(|x| spot(row, x)));
    }

    /// The pixels of a row half way between the first ones.
    pub(super) fn half(row: usize) -> Between {
        Between { row, comb: 2, before: (row, 0), after: Some((row, 0, 1)), close: false }
    }

    /// The remaining pixels of a row.
    pub(super) fn quarters(row: usize) -> [Between; 2] {
        let quarter = |comb, after| Between { row, comb, before: (row, comb - 1), after: Some(after), close: true };
        [quarter(1, (row, 2, 0)), quarter(3, (row, 0, 1))]
    }

    /// Every second pixel of a row, between pixels two rows above and below; there may be no row below.
    pub(super) fn between(row: usize, last: usize) -> impl Iterator<Item = Between> {
        (0..STEP).step_by(2).map(move |comb| {
            let after = (row + 2 <= last).then_some((row + 2, comb, 0));
            Between { row, comb, before: (row - 2, comb), after, close: false }
        })
    }

    /// The list and index that hold a pixel's light.
    #[inline(always)]
    pub(super) fn cell<'a>(&'a mut self, planes: &'a mut Planes, row: usize, x: usize) -> (&'a mut Cells, usize) {
        match row.is_multiple_of(2) {
            true => (&mut self.combs[row / 2][x % STEP], x / STEP),
            false => (&mut planes.0[row].cells, x),
        }
    }

    /// Interpolates pixels of a comb, and collects those whose light must be computed.
    pub(super) fn fill(&mut self, which: Between, spots: &mut Spots) {
        let Between { row, comb, before, after, close } = which;
        let mut own = std::mem::take(&mut self.combs[row / 2][comb]);
        let near = |(row, comb, further): (usize, usize, usize)| Near { cells: &self.combs[row / 2][comb], further };
        let after = after.map_or(Near { cells: &self.none, further: 0 }, near);
        let beside = [near((before.0, before.1, 0)), after];
        let count = self.width.saturating_sub(comb).div_ceil(STEP);
        fill(
            &mut own,
            (beside, close),
            count,
            #[inline(always)]
            |i| spots.push(spot(row, STEP * i + comb)),
        );
        self.combs[row / 2][comb] = own;
    }

    /// Interpolates a whole row from the adjacent rows; there may be no row below.
    pub(super) fn fill_row(&self, planes: &mut Planes, (row, last): (usize, usize), spots: &mut Spots) {
        let mut own = std::mem::take(&mut planes.0[row].cells);
        let below = if row < last { &planes.0[row + 1].cells } else { &self.none };
        let beside = [&planes.0[row - 1].cells, below].map(|cells| Near { cells, further: 0 });
        fill(
            &mut own,
            (beside, true),
            self.width,
            #[inline(always)]
            |x| spots.push(spot(row, x)),
        );
        planes.0[row].cells = own;
    }

    /// Merges the light of a row's combs.
    pub(super) fn gather(&self, row: usize, cells: &mut Cells) {
        let (combs, count) = (&self.combs[row / 2], self.width.next_multiple_of(STEP));
        widest(
            #[inline(always)]
            || {
                for (c, light) in cells.light.iter_mut().enumerate() {
                    collect(combs.each_ref().map(|comb| comb.light[c].as_slice()), &mut light[..count]);
                }
                collect(combs.each_ref().map(|comb| comb.drift.as_slice()), &mut cells.drift[..count]);
            },
        );
    }
}

/// Interpolates the first `count` pixels, and visits those whose light must be computed.
fn fill(own: &mut Cells, (beside, close): ([Near<'_>; 2], bool), count: usize, mut each: impl FnMut(usize)) {
    widest(
        #[inline(always)]
        || {
            for from in (0..count).step_by(PART) {
                let shares = weigh(own, beside, close, from);
                mix(own, beside, from, &shares);
                missing(
                    &shares,
                    count - from,
                    #[inline(always)]
                    |i| each(from + i),
                );
            }
        },
    );
}

/// Deals numbers out to four lists in turn.
#[inline(always)]
fn deal<T: Copy>(from: &[T], [a, b, c, d]: [&mut [T]; STEP]) {
    let (fours, rest) = from.as_chunks::<STEP>();
    let count = fours.len();
    for (list, v) in [&mut *a, &mut *b, &mut *c].into_iter().zip(rest) {
        list[count] = *v;
    }
    let (a, b, c, d) = (&mut a[..count], &mut b[..count], &mut c[..count], &mut d[..count]);
    for i in 0..count {
        [a[i], b[i], c[i], d[i]] = fours[i];
    }
}

/// Merges the lists that [`deal`] filled.
#[inline(always)]
fn collect<T: Copy>([a, b, c, d]: [&[T]; STEP], out: &mut [T]) {
    let fours = out.as_chunks_mut::<STEP>().0;
    let count = fours.len();
    let (a, b, c, d) = (&a[..count], &b[..count], &c[..count], &d[..count]);
    for i in 0..count {
        fours[i] = [a[i], b[i], c[i], d[i]];
    }
}
