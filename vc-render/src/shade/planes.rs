//! A strip of rows as lists of numbers, one list for each thing that is known of a pixel.

use crate::simd::whole;

/// Rows of a strip: the light is found in one row of so many, and the first row of
/// the next strip is the last of this one.
pub(super) const ROWS: usize = 4;

/// Light at a pixel: what falls on it (red, green, blue) and its sheen towards the eye.
pub(super) const LIGHT: usize = 6;

/// What is seen at every pixel of a strip, and the light there.
#[derive(Default)]
pub(crate) struct Planes {
    pub(super) width: usize,
    /// One over depth; zero where there is nothing.
    pub(super) inverse: Vec<f32>,
    /// Which of the [`Looks`] it has.
    pub(super) look: Vec<u32>,
    pub(super) colour: [Vec<f32>; 3],
    /// Roughness and metal, [`gloss_of`].
    pub(super) gloss: Vec<u32>,
    /// How the texture leans the normal, [`packed`].
    pub(super) lean: Vec<u32>,
    pub(super) light: [Vec<f32>; LIGHT],
    /// By how much more light falls on what leans one way than another, [`packed`].
    pub(super) drift: Vec<u32>,
    /// Which pixels of a row agree with their neighbours; memory to work in.
    pub(super) alike: Vec<bool>,
}

/// Roughness and metal in a byte each.
#[inline(always)]
pub(super) fn gloss_of(roughness: f32, metallic: f32) -> u32 {
    whole(roughness.clamp(0.05, 1.0) * 255.0) | whole(metallic * 255.0) << 8
}

/// Roughness and metal from what [`gloss_of`] has put together.
#[inline(always)]
pub(super) fn gloss(v: u32) -> (f32, f32) {
    let part = |byte: u32| (v >> byte & 255) as i32 as f32 * (1.0 / 255.0);
    (part(0), part(8))
}

/// Three numbers between -1 and 1 in ten bits each.
#[inline(always)]
pub(super) fn packed(v: [f32; 3]) -> u32 {
    let part = |x: f32| whole(x.clamp(-1.0, 1.0) * 511.0) & 1023;
    part(v[0]) | part(v[1]) << 10 | part(v[2]) << 20
}

/// What [`packed`] has put together.
#[inline(always)]
pub(super) fn unpacked(v: u32) -> [f32; 3] {
    let part = |shift: u32| ((v << shift) as i32 >> 22) as f32 * (1.0 / 511.0);
    [part(22), part(12), part(2)]
}

impl Planes {
    /// Makes room for rows of this width.
    pub(super) fn prepare(&mut self, width: usize) {
        self.width = width;
        self.alike.resize(width, false);
        let count = width * (ROWS + 1);
        for list in [&mut self.look, &mut self.gloss, &mut self.lean, &mut self.drift] {
            list.resize(count, 0);
        }
        let lists = [&mut self.inverse].into_iter().chain(&mut self.colour).chain(&mut self.light);
        lists.for_each(|list| list.resize(count, 0.0));
    }

    /// Makes the last row the first.
    pub(super) fn turn(&mut self) {
        let last = ROWS * self.width..(ROWS + 1) * self.width;
        for list in [&mut self.look, &mut self.gloss, &mut self.lean, &mut self.drift] {
            list.copy_within(last.clone(), 0);
        }
        let lists = [&mut self.inverse].into_iter().chain(&mut self.colour).chain(&mut self.light);
        lists.for_each(|list| list.copy_within(last.clone(), 0));
    }
}
