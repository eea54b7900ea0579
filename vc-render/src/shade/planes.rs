//! A strip of rows as lists of numbers, one list for each thing that is known of a pixel.

use super::lattice::{BEYOND, LIGHT, PART};
use crate::simd::whole;
use crate::surface::SPAN;

/// What is seen at every pixel of the rows of a strip, and of the row after it.
#[derive(Default)]
pub(crate) struct Planes(pub(super) Vec<Row>);

/// What is seen at every pixel of a row, and the light there. Lists go on past its end, so that pixels are
/// written in whole spans and parts: the next ones write over what was too much.
#[derive(Default)]
pub(crate) struct Row {
    pub(super) width: usize,
    pub(super) colour: [Vec<f32>; 3],
    /// Roughness and metal, [`gloss_of`].
    pub(super) gloss: Vec<u32>,
    /// How the texture leans the normal, [`packed`].
    pub(super) lean: Vec<u32>,
    pub(super) cells: Cells,
}

/// What light between pixels is found from.
#[derive(Default)]
pub(crate) struct Cells {
    /// Which of the looks they have.
    pub(super) look: Vec<u32>,
    /// One over depth; zero where there is nothing.
    pub(super) inverse: Vec<f32>,
    pub(super) light: [Vec<f32>; LIGHT],
    /// By how much more light falls on what leans one way than another, [`packed`].
    pub(super) drift: Vec<u32>,
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

impl Cells {
    /// Makes room for so many.
    pub(super) fn prepare(&mut self, count: usize) {
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

impl Row {
    /// The looks of its pixels.
    #[inline(always)]
    pub(super) fn looks(&self) -> &[u32] {
        &self.cells.look[..self.width]
    }
}

impl Planes {
    /// Makes room for so many rows of this width, and one more.
    pub(super) fn prepare(&mut self, width: usize, rows: usize) {
        self.0.resize_with(rows + 1, Row::default);
        let count = width.next_multiple_of(PART) + SPAN;
        for row in &mut self.0 {
            row.width = width;
            [&mut row.gloss, &mut row.lean].into_iter().for_each(|list| list.resize(count, 0));
            row.colour.iter_mut().for_each(|list| list.resize(count, 0.0));
            row.cells.prepare(count);
        }
    }

    /// Makes the last row the first.
    pub(super) fn turn(&mut self) {
        let last = self.0.len() - 1;
        self.0.swap(0, last);
    }
}
