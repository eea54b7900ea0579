//! Where light is found, and where it is taken from neighbours.
//!
//! Light is found at every fourth pixel of every fourth row. Of the pixels between, those get
//! the mean of their neighbours' that see the same plane of the same thing under nearly the
//! same light, those at the edge of a flat thing that of the one which does; for the others it is found as
//! well. So smooth walls cost little, and edges of shadows and things lose nothing. Right beside
//! pixels whose light is known, flat things get the mean however much the two differ: so shadows
//! have smooth edges.
//!
//! Every fourth pixel of a row lies side by side in memory, in four combs, so that neighbours do.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

mod between;

use self::between::{Near, PART, missing, mix, weigh};
use crate::simd::widest;

/// Light at a pixel: what falls on it (red, green, blue) and its sheen towards the eye.
pub(super) const LIGHT: usize = 6;
/// Combs of a row; and light is found in one row of so many.
pub(super) const STEP: usize = 4;
/// Look of what is past a row's end.
const BEYOND: u32 = u32::MAX;

/// Pixels of a strip: row and column, sixteen bits each.
pub(super) type Spots = Vec<u32>;

#[inline(always)]
pub(super) fn spot(row: usize, x: usize) -> u32 {
    (row << 16 | x) as u32
}

/// Every fourth pixel of a row. Lists go on past its end, to whole parts and one more.
#[derive(Default)]
pub(super) struct Comb {
    pub(super) look: Vec<u32>,
    /// One over depth; zero where there is nothing.
    pub(super) inverse: Vec<f32>,
    pub(super) light: [Vec<f32>; LIGHT],
    /// By how much more light falls on what leans one way than another, packed.
    pub(super) drift: Vec<u32>,
}

/// The light in a strip.
#[derive(Default)]
pub(crate) struct Lattice {
    width: usize,
    pub(super) rows: Vec<[Comb; STEP]>,
    /// What is next to pixels where there is nothing.
    none: Comb,
}

/// Pixels that lie between others.
#[derive(Clone, Copy)]
pub(super) struct Between {
    row: usize,
    comb: usize,
    /// Rows and combs of the neighbours; the second may be one further on in its comb, or not be there.
    before: (usize, usize),
    after: Option<(usize, usize, usize)>,
    /// Whether it is right beside them.
    close: bool,
}

impl Comb {
    fn prepare(&mut self, count: usize) {
        for list in [&mut self.look, &mut self.drift] {
            list.clear();
            list.resize(count, BEYOND);
        }
        for list in [&mut self.inverse].into_iter().chain(&mut self.light) {
            list.clear();
            list.resize(count, 0.0);
        }
    }
}

impl Lattice {
    /// Makes room for so many rows of this width, and one more.
    pub(super) fn prepare(&mut self, width: usize, rows: usize) {
        self.width = width;
        self.rows.resize_with(rows + 1, Default::default);
        let count = width.div_ceil(STEP).next_multiple_of(PART) + 1;
        self.rows.iter_mut().flatten().chain([&mut self.none]).for_each(|comb| comb.prepare(count));
    }

    /// Makes the last row the first.
    pub(super) fn turn(&mut self) {
        let last = self.rows.len() - 1;
        self.rows.swap(0, last);
    }

    /// Takes note of what is seen in a row.
    #[inline(always)]
    pub(super) fn write(&mut self, row: usize, look: &[u32], inverse: &[f32]) {
        comb(look, self.rows[row].each_mut().map(|comb| comb.look.as_mut_slice()));
        comb(inverse, self.rows[row].each_mut().map(|comb| comb.inverse.as_mut_slice()));
    }

    /// The pixels of a row that come first.
    pub(super) fn first(&self, row: usize, spots: &mut Spots) {
        spots.extend((0..self.width).step_by(STEP).map(|x| spot(row, x)));
    }

    /// The pixels of a row half way between its first.
    pub(super) fn half(row: usize) -> Between {
        Between { row, comb: 2, before: (row, 0), after: Some((row, 0, 1)), close: false }
    }

    /// The rest of a row.
    pub(super) fn quarters(row: usize) -> [Between; 2] {
        let quarter = |comb, after| Between { row, comb, before: (row, comb - 1), after: Some(after), close: true };
        [quarter(1, (row, 2, 0)), quarter(3, (row, 0, 1))]
    }

    /// Some combs of a row between those above and below it, as far from it as that; there may be no row below.
    pub(super) fn between(row: usize, by: usize, last: usize) -> impl Iterator<Item = Between> {
        (0..STEP).step_by(by).map(move |comb| {
            let after = (row + by <= last).then_some((row + by, comb, 0));
            Between { row, comb, before: (row - by, comb), after, close: by == 1 }
        })
    }

    /// Fills in pixels between others, and notes those whose light is to be found.
    pub(super) fn fill(&mut self, which: Between, spots: &mut Spots) {
        let Between { row, comb, before, after, close } = which;
        let mut own = std::mem::take(&mut self.rows[row][comb]);
        let near = |(row, comb, further): (usize, usize, usize)| Near { comb: &self.rows[row][comb], further };
        let after = after.map_or(Near { comb: &self.none, further: 0 }, near);
        let beside = [near((before.0, before.1, 0)), after];
        let count = self.width.saturating_sub(comb).div_ceil(STEP);
        widest(
            #[inline(always)]
            || {
                for from in (0..count).step_by(PART) {
                    let shares = weigh(&own, beside, close, from);
                    mix(&mut own, beside, from, &shares);
                    missing(
                        &shares,
                        count - from,
                        #[inline(always)]
                        |i| spots.push(spot(row, STEP * (from + i) + comb)),
                    );
                }
            },
        );
        self.rows[row][comb] = own;
    }

    /// Light of some pixels of a row in their order.
    #[inline(always)]
    pub(super) fn light<const N: usize>(&self, row: usize, first: usize, light: &mut [[f32; N]; LIGHT]) {
        for (c, out) in light.iter_mut().enumerate() {
            uncomb(self.rows[row].each_ref().map(|comb| fours(&comb.light[c], first, N)), out);
        }
    }

    /// How it drifts.
    #[inline(always)]
    pub(super) fn drift<const N: usize>(&self, row: usize, first: usize, drift: &mut [u32; N]) {
        uncomb(self.rows[row].each_ref().map(|comb| fours(&comb.drift, first, N)), drift);
    }
}

/// The part of a comb that is in some pixels of a row.
#[inline(always)]
fn fours<T>(comb: &[T], first: usize, count: usize) -> &[T] {
    &comb[first / STEP..comb.len().min((first + count) / STEP)]
}

/// Deals numbers out to four lists in turn.
#[inline(always)]
fn comb<T: Copy>(from: &[T], [a, b, c, d]: [&mut [T]; STEP]) {
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

/// Puts together what [`comb`] has dealt out.
#[inline(always)]
fn uncomb<T: Copy>([a, b, c, d]: [&[T]; STEP], out: &mut [T]) {
    let fours = out.as_chunks_mut::<STEP>().0;
    let count = a.len().min(fours.len());
    let (a, b, c, d, fours) = (&a[..count], &b[..count], &c[..count], &d[..count], &mut fours[..count]);
    for i in 0..count {
        fours[i] = [a[i], b[i], c[i], d[i]];
    }
}
