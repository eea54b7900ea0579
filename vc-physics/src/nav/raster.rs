//! A grid of bits, one for each cell of the floor.

use std::ops::Range;

use nalgebra::Point2;

use super::outline::Outline;
use super::spans::{Spans, ceil};

/// The largest number of cells in a grid; larger floors get larger cells.
const MOST: f32 = 4.0e6;

/// Cells in rows; `low` is the corner of the first cell.
#[derive(Debug, Clone)]
pub(crate) struct Raster {
    pub(crate) low: Point2<f32>,
    pub(crate) cell: f32,
    pub(crate) columns: usize,
    pub(crate) rows: usize,
    /// Number of words in a row.
    words: usize,
    bits: Vec<u64>,
    /// Kept to reuse its memory.
    spans: Spans,
}

impl Raster {
    /// An empty grid over a rectangle; `None` if the rectangle is empty or not finite.
    pub(crate) fn over(low: Point2<f32>, high: Point2<f32>, cell: f32) -> Option<Self> {
        let size = high - low;
        if !(size.x > 0.0 && size.y > 0.0 && size.x.is_finite() && size.y.is_finite() && cell > 0.0) {
            return None;
        }
        let cell = cell.max((size.x / MOST * size.y).sqrt()).max(size.max() / MOST);
        let count = |length: f32| (length / cell).ceil() as usize + 1;
        let (columns, rows) = (count(size.x), count(size.y));
        let words = columns.div_ceil(64);
        Some(Self { low, cell, columns, rows, words, bits: vec![0; words * rows], spans: Spans::default() })
    }

    pub(crate) fn clear(&mut self) {
        self.bits.fill(0);
    }

    /// Sets or clears the cells whose centres are within an outline grown by a radius.
    pub(crate) fn paint(&mut self, outline: &Outline, radius: f32, value: bool) {
        let level = |pick: fn(f32, f32) -> f32| outline.iter().map(|p| p.y).reduce(pick);
        let (Some(bottom), Some(top)) = (level(f32::min), level(f32::max)) else { return };
        let first = self.index(bottom - radius - self.low.y, self.rows);
        let last = self.index(top + radius - self.low.y, self.rows);
        let middle = self.low.y + (first as f32 + 0.5) * self.cell;
        let mut spans = std::mem::take(&mut self.spans);
        spans.trace(outline, radius, middle, self.cell, last - first);
        for (row, (left, right)) in spans.covered() {
            let from = self.index(left - self.low.x, self.columns);
            let to = self.index(right - self.low.x, self.columns);
            self.set(first + row, from, to, value);
        }
        self.spans = spans;
    }

    /// The first cell whose centre is not before an offset.
    fn index(&self, offset: f32, most: usize) -> usize {
        ceil(offset / self.cell - 0.5).min(most)
    }

    fn set(&mut self, row: usize, from: usize, to: usize, value: bool) {
        if from >= to {
            return;
        }
        let words = &mut self.bits[row * self.words..(row + 1) * self.words];
        for (at, word) in words.iter_mut().enumerate().take(to.div_ceil(64)).skip(from / 64) {
            let (first, last) = (from.max(at * 64) - at * 64, to.min(at * 64 + 64) - at * 64);
            let mask = (u64::MAX >> (64 - (last - first))) << first;
            *word = if value { *word | mask } else { *word & !mask };
        }
    }

    pub(crate) fn get(&self, column: usize, row: usize) -> bool {
        column < self.columns && row < self.rows && self.bits[row * self.words + column / 64] >> (column % 64) & 1 == 1
    }

    /// Runs of set cells in a row: the first cell, and one past the last.
    pub(crate) fn runs(&self, row: usize) -> impl Iterator<Item = (u32, u32)> + '_ {
        let words = &self.bits[row * self.words..(row + 1) * self.words];
        let mut at = 0_usize;
        std::iter::from_fn(move || {
            let from = next(words, at, true)?;
            let to = next(words, from, false).unwrap_or(words.len() * 64);
            at = to;
            Some((from as u32, to as u32))
        })
    }

    /// Sets the cells of a rectangle.
    pub(crate) fn fill(&mut self, columns: Range<usize>, rows: Range<usize>) {
        rows.for_each(|row| self.set(row, columns.start, columns.end, true));
    }

    /// Number of set cells.
    pub(crate) fn count(&self) -> usize {
        self.count_of(|word, _| word)
    }

    /// Number of bits in what is made of each word and its position.
    pub(crate) fn count_of(&self, make: impl Fn(u64, usize) -> u64) -> usize {
        self.bits.iter().enumerate().map(|(i, word)| make(*word, i).count_ones() as usize).sum()
    }

    /// The word at a position.
    pub(crate) fn word(&self, index: usize) -> u64 {
        self.bits[index]
    }

    /// A point in units of cells.
    pub(crate) fn cells(&self, p: &Point2<f32>) -> (f64, f64) {
        (f64::from(p.x - self.low.x) / f64::from(self.cell), f64::from(p.y - self.low.y) / f64::from(self.cell))
    }

    /// The point of a position in cells, metres.
    pub(crate) fn point(&self, (x, y): (f64, f64)) -> Point2<f32> {
        let at = |low: f32, n: f64| (f64::from(low) + n * f64::from(self.cell)) as f32;
        Point2::new(at(self.low.x, x), at(self.low.y, y))
    }

    /// The cell that contains a point.
    pub(crate) fn cell_of(&self, p: &Point2<f32>) -> Option<(usize, usize)> {
        let (x, y) = self.cells(p);
        let inside = x >= 0.0 && y >= 0.0 && x < self.columns as f64 && y < self.rows as f64;
        inside.then_some((x as usize, y as usize))
    }

    /// Whether the cell of a point is set.
    pub(crate) fn holds(&self, p: &Point2<f32>) -> bool {
        self.cell_of(p).is_some_and(|(x, y)| self.get(x, y))
    }

    /// The centre of the nearest set cell within a distance; the point itself if its own cell is set.
    pub(crate) fn nearest(&self, p: &Point2<f32>, within: f32) -> Option<Point2<f32>> {
        if self.holds(p) {
            return Some(*p);
        }
        let (x, y) = self.cells(p);
        let reach = (within.max(0.0) / self.cell).min(1e9) as i64 + 1;
        let rows = (y as i64 - reach).max(0)..(y as i64 + reach + 1).min(self.rows as i64);
        let columns = (x as i64 - reach).max(0)..(x as i64 + reach + 1).min(self.columns as i64);
        let cells = rows.flat_map(|r| columns.clone().map(move |c| (c as usize, r as usize)));
        let middle = |(c, r): (usize, usize)| self.point((c as f64 + 0.5, r as f64 + 0.5));
        let free = cells.filter(|&(c, r)| self.get(c, r)).map(middle).map(|m| ((m - p).norm(), m));
        free.filter(|(d, _)| *d <= within).min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, m)| m)
    }
}

/// The position of the first bit with a value, at or after a position.
fn next(words: &[u64], from: usize, value: bool) -> Option<usize> {
    let wanted = |word: u64| if value { word } else { !word };
    let mut word = from / 64;
    let mut rest = wanted(*words.get(word)?) & (u64::MAX << (from % 64));
    while rest == 0 {
        word += 1;
        rest = wanted(*words.get(word)?);
    }
    Some(word * 64 + rest.trailing_zeros() as usize)
}
