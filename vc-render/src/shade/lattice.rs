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

use super::planes::ROWS;
use super::surfel::BENT;

/// Light at a pixel: what falls on it (red, green, blue) and its sheen towards the eye.
pub(super) const LIGHT: usize = 6;
/// Combs of a row.
pub(super) const STEP: usize = 4;
/// How far inverse depth may be from its neighbours' mean, as a share.
const FLAT: f32 = 0.01;
/// The same where there is a neighbour on one side only.
const LONE: f32 = 0.05;
/// Largest share by which neighbours' light may differ.
const ALIKE: f32 = 0.10;
/// Look of what is past a row's end.
const BEYOND: u32 = u32::MAX;

/// Pixels of a strip: row and column, sixteen bits each.
pub(super) type Spots = Vec<u32>;

#[inline(always)]
pub(super) fn spot(row: usize, x: usize) -> u32 {
    (row << 16 | x) as u32
}

/// Every fourth pixel of a row.
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
    pub(super) rows: [[Comb; STEP]; ROWS + 1],
    /// What is next to pixels where there is nothing.
    none: Comb,
    /// The shares of the two neighbours; memory to work in.
    shares: [Vec<f32>; 2],
}

/// Pixels that lie between others.
#[derive(Clone, Copy)]
struct Between {
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
    /// Makes room for rows of this width.
    pub(super) fn prepare(&mut self, width: usize) {
        self.width = width;
        let count = width.div_ceil(STEP) + 1;
        self.rows.iter_mut().flatten().chain([&mut self.none]).for_each(|comb| comb.prepare(count));
        self.shares.iter_mut().for_each(|list| list.resize(count - 1, 0.0));
    }

    /// Makes the last row the first.
    pub(super) fn turn(&mut self) {
        self.rows.swap(0, ROWS);
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

    /// Fills in a row half way between its first pixels.
    #[inline(always)]
    pub(super) fn half(&mut self, row: usize, spots: &mut Spots) {
        self.fill(Between { row, comb: 2, before: (row, 0), after: Some((row, 0, 1)), close: false }, spots);
    }

    /// Fills in the rest of a row.
    #[inline(always)]
    pub(super) fn quarters(&mut self, row: usize, spots: &mut Spots) {
        for (comb, after) in [(1, (row, 2, 0)), (3, (row, 0, 1))] {
            self.fill(Between { row, comb, before: (row, comb - 1), after: Some(after), close: true }, spots);
        }
    }

    /// Fills in some combs of a row between those above and below it, as far from it as that; there may be
    /// no row below.
    #[inline(always)]
    pub(super) fn between(&mut self, row: usize, by: usize, last: usize, spots: &mut Spots) {
        for comb in (0..STEP).step_by(by) {
            let after = (row + by <= last).then_some((row + by, comb, 0));
            self.fill(Between { row, comb, before: (row - by, comb), after, close: by == 1 }, spots);
        }
    }

    #[inline(always)]
    fn fill(&mut self, which: Between, spots: &mut Spots) {
        let Between { row, comb, before, after, close } = which;
        let mut own = std::mem::take(&mut self.rows[row][comb]);
        let mut shares = std::mem::take(&mut self.shares);
        let before = &self.rows[before.0][before.1];
        let (after, further) = after.map_or((&self.none, 0), |(row, comb, by)| (&self.rows[row][comb], by));
        weigh(&own, before, (after, further), close, &mut shares);
        mix(&mut own, before, (after, further), &shares);
        let count = self.width.saturating_sub(comb).div_ceil(STEP);
        missing(&shares, count, |k| spots.push(spot(row, STEP * k + comb)));
        self.rows[row][comb] = own;
        self.shares = shares;
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

/// Finds what share neighbours have in the light of pixels between them: none where it is to be found.
#[inline(always)]
fn weigh(own: &Comb, a: &Comb, (b, further): (&Comb, usize), close: bool, shares: &mut [Vec<f32>; 2]) {
    let [first, second] = shares;
    let count = first.len();
    let second = &mut second[..count];
    let (l0, l1, l2) = (&own.look[..count], &a.look[..count], &b.look[further..][..count]);
    let (v0, v1, v2) = (&own.inverse[..count], &a.inverse[..count], &b.inverse[further..][..count]);
    let (g1, s1) = (&a.light[1][..count], &a.light[LIGHT - 2][..count]);
    let (g2, s2) = (&b.light[1][further..][..count], &b.light[LIGHT - 2][further..][..count]);
    for i in 0..count {
        let (same, other, straight) = (l1[i] == l0[i], l2[i] == l0[i], l0[i] & BENT == 0);
        let flat = (2.0 * v0[i] - v1[i] - v2[i]).abs() <= FLAT * v0[i];
        let (p, q) = (0.2 * g1[i] + s1[i], 0.2 * g2[i] + s2[i]);
        let alike = (close & straight) | ((p - q).abs() <= ALIKE * (p + q) * 0.5);
        let both = same & other & flat & alike;
        let near = |v: f32| straight & ((v0[i] - v).abs() <= LONE * v0[i]);
        let lone = |yes: bool| if yes { 1.0 } else { 0.0 };
        first[i] = if both { 0.5 } else { lone(same & !other & near(v1[i])) };
        second[i] = if both { 0.5 } else { lone(other & !same & near(v2[i])) };
    }
}

/// Writes means by shares.
#[inline(always)]
fn mix(own: &mut Comb, a: &Comb, (b, further): (&Comb, usize), shares: &[Vec<f32>; 2]) {
    let [first, second] = shares;
    let count = first.len();
    let second = &second[..count];
    for c in 0..LIGHT {
        let (out, a, b) = (&mut own.light[c][..count], &a.light[c][..count], &b.light[c][further..][..count]);
        for i in 0..count {
            out[i] = first[i] * a[i] + second[i] * b[i];
        }
    }
    let (out, a, b) = (&mut own.drift[..count], &a.drift[..count], &b.drift[further..][..count]);
    for i in 0..count {
        out[i] = if first[i] > 0.0 { a[i] } else { b[i] };
    }
}

/// Goes through those that have no neighbour.
#[inline(always)]
fn missing([first, second]: &[Vec<f32>; 2], count: usize, mut each: impl FnMut(usize)) {
    const PART: usize = 8;
    let (first, second) = (&first[..count], &second[..count]);
    for (part, (a, b)) in first.chunks(PART).zip(second.chunks(PART)).enumerate() {
        let mut least = 1.0_f32;
        for (a, b) in a.iter().zip(b) {
            least = least.min(a + b);
        }
        if least == 0.0 {
            for k in (0..a.len()).filter(|k| a[*k] + b[*k] == 0.0) {
                each(part * PART + k);
            }
        }
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
