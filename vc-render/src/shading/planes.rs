//! A strip of rows in structure-of-arrays layout, one list for each attribute of a pixel.

use super::interpolate::{BEYOND, LIGHT, PART};
use crate::math::simd::whole;
use crate::surface::SPAN;

/// Surface attributes at every pixel of a strip's rows, and of the row after it.
#[derive(Default)]
pub(crate) struct Planes(pub(super) Vec<Row>);

/// Surface attributes and light at every pixel of a row. Lists extend past its end, so that pixels can be
/// written in whole spans and parts; excess values are overwritten by the next ones.
#[derive(Default)]
pub(crate) struct Row {
    pub(super) width: usize,
    pub(super) colour: [Vec<f32>; 3],
    /// Roughness and metallic share, see [`gloss_of`].
    pub(super) gloss: Vec<u32>,
    /// Tilt of the normal by the texture, see [`packed`].
    pub(super) lean: Vec<u32>,
    pub(super) cells: Cells,
}

/// Attributes from which light is interpolated.
#[derive(Default)]
pub(crate) struct Cells {
    /// Index of the group.
    pub(super) group: Vec<u32>,
    /// Inverse depth; zero where nothing is visible.
    pub(super) inverse: Vec<f32>,
    pub(super) light: [Vec<f32>; LIGHT],
    /// Change of light with the tilt of the normal, see [`packed`].
    pub(super) drift: Vec<u32>,
}

/// Packs roughness and metallic share into a byte each.
#[inline(always)]
pub(super) fn gloss_of(roughness: f32, metallic: f32) -> u32 {
    whole(roughness.clamp(0.05, 1.0) * 255.0) | whole(metallic * 255.0) << 8
}

/// Unpacks roughness and metallic share from [`gloss_of`].
#[inline(always)]
pub(super) fn gloss(v: u32) -> (f32, f32) {
    let part = |byte: u32| (v >> byte & 255) as i32 as f32 * (1.0 / 255.0);
    (part(0), part(8))
}

/// Packs three numbers between -1 and 1 into ten bits each.
#[inline(always)]
pub(super) fn packed(v: [f32; 3]) -> u32 {
    let part = |x: f32| whole(x.clamp(-1.0, 1.0) * 511.0) & 1023;
    part(v[0]) | part(v[1]) << 10 | part(v[2]) << 20
}

/// Unpacks the numbers from [`packed`].
#[inline(always)]
pub(super) fn unpacked(v: u32) -> [f32; 3] {
    let part = |shift: u32| ((v << shift) as i32 >> 22) as f32 * (1.0 / 511.0);
    [part(22), part(12), part(2)]
}

impl Cells {
    /// Allocates `count` entries.
    pub(super) fn prepare(&mut self, count: usize) {
        for list in [&mut self.group, &mut self.drift] {
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
    /// The groups of its pixels.
    #[inline(always)]
    pub(super) fn groups(&self) -> &[u32] {
        &self.cells.group[..self.width]
    }
}

impl Planes {
    /// Allocates `rows` rows of this width, and one more.
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

    /// Moves the last row to the first.
    pub(super) fn turn(&mut self) {
        let last = self.0.len() - 1;
        self.0.swap(0, last);
    }
}
