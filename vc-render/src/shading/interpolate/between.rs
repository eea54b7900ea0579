//! Interpolation of light at pixels between others.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

use super::LIGHT;
use crate::shading::planes::Cells;
use crate::shading::surfel::BENT;

/// Greatest relative deviation of inverse depth from its neighbours' mean.
const FLAT: f32 = 0.01;
/// Greatest relative deviation from a single neighbour.
const LONE: f32 = 0.05;
/// Greatest relative difference between the light of two neighbours.
const ALIKE: f32 = 0.10;
/// Number of pixels interpolated together.
pub(in crate::shading) const PART: usize = 32;

/// Neighbouring pixels, from an offset on.
#[derive(Clone, Copy)]
pub(super) struct Near<'a> {
    pub(super) cells: &'a Cells,
    pub(super) further: usize,
}

/// Neighbours on both sides.
pub(super) type Beside<'a> = [Near<'a>; 2];

impl<'a> Near<'a> {
    #[inline(always)]
    fn group(self, from: usize) -> &'a [u32; PART] {
        part(&self.cells.group, from + self.further)
    }

    #[inline(always)]
    fn inverse(self, from: usize) -> &'a [f32; PART] {
        part(&self.cells.inverse, from + self.further)
    }

    #[inline(always)]
    fn light(self, c: usize, from: usize) -> &'a [f32; PART] {
        part(&self.cells.light[c], from + self.further)
    }

    #[inline(always)]
    fn drift(self, from: usize) -> &'a [u32; PART] {
        part(&self.cells.drift, from + self.further)
    }

    /// Green light reflected by a matt surface, and its gloss.
    #[inline(always)]
    fn luminance(self, from: usize) -> [f32; PART] {
        let (falls, sheen, mut all) = (self.light(1, from), self.light(LIGHT - 2, from), [0.0; PART]);
        for i in 0..PART {
            all[i] = 0.2 * falls[i] + sheen[i];
        }
        all
    }
}

/// Some entries of a list.
#[inline(always)]
fn part<T>(list: &[T], from: usize) -> &[T; PART] {
    list[from..].first_chunk().expect("lists go on past their end")
}

/// Some mutable entries of a list.
#[inline(always)]
fn part_mut<T>(list: &mut [T], from: usize) -> &mut [T; PART] {
    list[from..].first_chunk_mut().expect("lists go on past their end")
}

/// All bits set if the condition holds: combining such masks needs no branches.
#[inline(always)]
fn bits(holds: bool) -> u32 {
    0_u32.wrapping_sub(u32::from(holds))
}

/// Weights of the two neighbours in the light of the pixels between them: both zero where the light must be
/// computed.
#[inline(always)]
pub(super) fn weigh(own: &Cells, [a, b]: Beside<'_>, close: bool, from: usize) -> [[f32; PART]; 2] {
    let (l0, l1, l2) = (part(&own.group, from), a.group(from), b.group(from));
    let (v0, v1, v2) = (part(&own.inverse, from), a.inverse(from), b.inverse(from));
    let (p, q) = (a.luminance(from), b.luminance(from));
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

/// Writes the weighted means.
#[inline(always)]
pub(super) fn mix(own: &mut Cells, [a, b]: Beside<'_>, from: usize, [first, second]: &[[f32; PART]; 2]) {
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

/// Visits those of the first `count` pixels that have no weights.
#[inline(always)]
pub(super) fn missing([first, second]: &[[f32; PART]; 2], count: usize, mut each: impl FnMut(usize)) {
    let (mut none, mut any) = ([0_u32; PART], 0);
    for i in 0..PART {
        none[i] = bits(first[i] + second[i] == 0.0);
        any |= none[i];
    }
    if any != 0 {
        (0..count.min(PART)).filter(|i| none[*i] != 0).for_each(&mut each);
    }
}
