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

use super::surfel::BENT;
use crate::simd::widest;

/// Light at a pixel: what falls on it (red, green, blue) and its sheen towards the eye.
pub(super) const LIGHT: usize = 6;
/// Combs of a row; and light is found in one row of so many.
pub(super) const STEP: usize = 4;
/// How far inverse depth may be from its neighbours' mean, as a share.
const FLAT: f32 = 0.01;
/// The same where there is a neighbour on one side only.
const LONE: f32 = 0.05;
/// Largest share by which neighbours' light may differ.
const ALIKE: f32 = 0.10;
/// Pixels of a comb that are filled in at once.
const PART: usize = 32;
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

/// A comb whose pixels are next to others, from so far on.
#[derive(Clone, Copy)]
struct Near<'a> {
    comb: &'a Comb,
    further: usize,
}

/// Combs on both sides.
type Beside<'a> = [Near<'a>; 2];

impl<'a> Near<'a> {
    #[inline(always)]
    fn look(self, from: usize) -> &'a [u32; PART] {
        part(&self.comb.look, from + self.further)
    }

    #[inline(always)]
    fn inverse(self, from: usize) -> &'a [f32; PART] {
        part(&self.comb.inverse, from + self.further)
    }

    #[inline(always)]
    fn light(self, c: usize, from: usize) -> &'a [f32; PART] {
        part(&self.comb.light[c], from + self.further)
    }

    #[inline(always)]
    fn drift(self, from: usize) -> &'a [u32; PART] {
        part(&self.comb.drift, from + self.further)
    }

    /// Green light as a matt surface throws it, and sheen.
    #[inline(always)]
    fn brightness(self, from: usize) -> [f32; PART] {
        let (falls, sheen, mut all) = (self.light(1, from), self.light(LIGHT - 2, from), [0.0; PART]);
        for i in 0..PART {
            all[i] = 0.2 * falls[i] + sheen[i];
        }
        all
    }
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

    /// Light of some pixels of a row in their order, and how it drifts.
    #[inline(always)]
    pub(super) fn read<const N: usize>(
        &self,
        row: usize,
        first: usize,
        light: &mut [[f32; N]; LIGHT],
        drift: &mut [u32; N],
    ) {
        let combs = &self.rows[row];
        let part = first / STEP..combs[0].drift.len().min((first + N) / STEP);
        for (c, out) in light.iter_mut().enumerate() {
            let comb = |k: usize| &combs[k].light[c][part.clone()];
            uncomb([comb(0), comb(1), comb(2), comb(3)], out);
        }
        let comb = |k: usize| &combs[k].drift[part.clone()];
        uncomb([comb(0), comb(1), comb(2), comb(3)], drift);
    }
}

/// Some pixels of a list.
#[inline(always)]
fn part<T>(list: &[T], from: usize) -> &[T; PART] {
    list[from..].first_chunk().expect("combs go on past their end")
}

/// The same to write to.
#[inline(always)]
fn part_mut<T>(list: &mut [T], from: usize) -> &mut [T; PART] {
    list[from..].first_chunk_mut().expect("combs go on past their end")
}

/// All bits where it holds: what is put together of such needs no jumps.
#[inline(always)]
fn bits(holds: bool) -> u32 {
    0_u32.wrapping_sub(u32::from(holds))
}

/// Finds what share neighbours have in the light of pixels between them: none where it is to be found.
#[inline(always)]
fn weigh(own: &Comb, [a, b]: Beside<'_>, close: bool, from: usize) -> [[f32; PART]; 2] {
    let (l0, l1, l2) = (part(&own.look, from), a.look(from), b.look(from));
    let (v0, v1, v2) = (part(&own.inverse, from), a.inverse(from), b.inverse(from));
    let (p, q) = (a.brightness(from), b.brightness(from));
    let (half, one, close) = (0.5_f32.to_bits(), 1.0_f32.to_bits(), bits(close));
    let (mut first, mut second) = ([0.0; PART], [0.0; PART]);
    for i in 0..PART {
        let (same, other, straight) = (bits(l1[i] == l0[i]), bits(l2[i] == l0[i]), bits(l0[i] & BENT == 0));
        let flat = bits((2.0 * v0[i] - v1[i] - v2[i]).abs() <= FLAT * v0[i]);
        let alike = bits((p[i] - q[i]).abs() <= ALIKE * (p[i] + q[i]) * 0.5);
        let both = same & other & flat & (alike | close & straight);
        let near = |v: f32| straight & bits((v0[i] - v).abs() <= LONE * v0[i]);
        first[i] = f32::from_bits(both & half | same & !other & near(v1[i]) & one);
        second[i] = f32::from_bits(both & half | other & !same & near(v2[i]) & one);
    }
    [first, second]
}

/// Writes means by shares.
#[inline(always)]
fn mix(own: &mut Comb, [a, b]: Beside<'_>, from: usize, [first, second]: &[[f32; PART]; 2]) {
    for (c, own) in own.light.iter_mut().enumerate() {
        let (a, b, mut out) = (a.light(c, from), b.light(c, from), [0.0; PART]);
        for i in 0..PART {
            out[i] = first[i] * a[i] + second[i] * b[i];
        }
        *part_mut(own, from) = out;
    }
    let (a, b, mut out) = (a.drift(from), b.drift(from), [0; PART]);
    for i in 0..PART {
        let before = bits(first[i] > 0.0);
        out[i] = a[i] & before | b[i] & !before;
    }
    *part_mut(&mut own.drift, from) = out;
}

/// Goes through those of the first so many that have no neighbour.
#[inline(always)]
fn missing([first, second]: &[[f32; PART]; 2], count: usize, mut each: impl FnMut(usize)) {
    let (mut none, mut any) = ([0_u32; PART], 0);
    for i in 0..PART {
        none[i] = bits(first[i] + second[i] == 0.0);
        any |= none[i];
    }
    if any != 0 {
        (0..count.min(PART)).filter(|i| none[*i] != 0).for_each(&mut each);
    }
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
