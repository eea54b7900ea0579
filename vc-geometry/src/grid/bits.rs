//! A grid of bits with words for rows.

use std::ops::Range;

/// A bit for each cell of a grid, in rows of 64-bit words: what is asked of many cells costs a few operations
/// for each word.
///
/// Cells are numbered by column and row from zero. Rectangles are columns `x.0..x.1` and rows `y.0..y.1`,
/// clipped to the grid. Bits outside of the grid are never set. Two grids that are combined have the same size.
///
/// ```
/// use vc_geometry::grid::BitGrid;
/// let mut free = BitGrid::new(200, 50);
/// free.fill((10, 190), (5, 45), true);
/// free.fill((100, 101), (0, 50), false);
/// assert_eq!(free.count(), 179 * 40);
/// assert_eq!(free.flood(20, 20).count(), 90 * 40);
/// assert_eq!(free.runs(20).collect::<Vec<_>>(), [(10, 100), (101, 190)]);
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BitGrid {
    /// Number of words in a row.
    pub(super) words: usize,
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) rows: Vec<u64>,
}

impl BitGrid {
    /// A grid of so many columns and rows with no bit set.
    pub fn new(width: usize, height: usize) -> Self {
        let words = width.div_ceil(64).max(1);
        Self { words, width, height, rows: vec![0; words * height] }
    }

    /// A grid of the same size with no bit set.
    pub fn empty(&self) -> Self {
        Self { rows: vec![0; self.rows.len()], ..*self }
    }

    /// Number of columns.
    #[inline]
    pub fn width(&self) -> usize {
        self.width
    }

    /// Number of rows.
    #[inline]
    pub fn height(&self) -> usize {
        self.height
    }

    /// Whether a cell's bit is set; outside of the grid none is.
    #[inline]
    pub fn get(&self, x: usize, y: usize) -> bool {
        x < self.width && y < self.height() && self.rows[y * self.words + x / 64] >> (x % 64) & 1 == 1
    }

    /// Sets a cell's bit; outside of the grid there is none.
    #[inline]
    pub fn set(&mut self, x: usize, y: usize) {
        if x < self.width && y < self.height {
            self.rows[y * self.words + x / 64] |= 1 << (x % 64);
        }
    }

    /// Clears all bits.
    pub fn clear(&mut self) {
        self.rows.fill(0);
    }

    /// Sets or clears a rectangle, clipped to the grid.
    ///
    /// ```
    /// let mut walls = vc_geometry::grid::BitGrid::new(20, 10);
    /// walls.fill((-5, 3), (8, 50), true);
    /// assert_eq!(walls.count(), 3 * 2); // Clipped to the grid.
    /// ```
    pub fn fill(&mut self, x: (i32, i32), y: (i32, i32), value: bool) {
        let Some((words, rows)) = self.cut(x, y) else { return };
        for (word, mask) in words {
            for row in rows.clone() {
                let bits = &mut self.rows[row * self.words + word];
                *bits = if value { *bits | mask } else { *bits & !mask };
            }
        }
    }

    /// Sets or clears the columns `from..to` of a row, clipped to the grid.
    ///
    /// ```
    /// let mut row = vc_geometry::grid::BitGrid::new(100, 1);
    /// row.fill_row(0, 60, 70, true);
    /// assert!(row.get(60, 0) && row.get(69, 0) && !row.get(70, 0));
    /// ```
    pub fn fill_row(&mut self, row: usize, from: usize, to: usize, value: bool) {
        let to = to.min(self.width);
        if from >= to || row >= self.height {
            return;
        }
        let words = &mut self.rows[row * self.words..(row + 1) * self.words];
        for (at, word) in words.iter_mut().enumerate().take(to.div_ceil(64)).skip(from / 64) {
            let mask = span(from.max(at * 64) - at * 64, to.min(at * 64 + 64) - at * 64);
            *word = if value { *word | mask } else { *word & !mask };
        }
    }

    /// The columns and rows of a rectangle that are in the grid.
    #[inline]
    pub(super) fn clipped(&self, x: (i32, i32), y: (i32, i32)) -> (Range<usize>, Range<usize>) {
        let cut = |v: i32, most: usize| v.clamp(0, most as i32) as usize;
        (cut(x.0, self.width)..cut(x.1, self.width), cut(y.0, self.height)..cut(y.1, self.height))
    }

    /// Clips a rectangle to the grid: its words with the mask of each, and its rows; `None` if
    /// nothing is left.
    #[inline]
    fn cut(
        &self,
        x: (i32, i32),
        y: (i32, i32),
    ) -> Option<(impl Iterator<Item = (usize, u64)> + Clone + use<>, Range<usize>)> {
        let (columns, rows) = self.clipped(x, y);
        if columns.is_empty() || rows.is_empty() {
            return None;
        }
        let (x0, x1) = (columns.start, columns.end);
        let (first, last) = (x0 / 64, (x1 - 1) / 64);
        let words = (first..=last).map(move |word| {
            let low = if word == first { u64::MAX << (x0 % 64) } else { u64::MAX };
            let high = if word == last { u64::MAX >> (63 - (x1 - 1) % 64) } else { u64::MAX };
            (word, low & high)
        });
        Some((words, rows))
    }

    /// Whether any bit of a rectangle is set.
    ///
    /// ```
    /// let mut free = vc_geometry::grid::BitGrid::new(10, 10);
    /// free.set(4, 7);
    /// assert!(free.any((0, 5), (7, 8)) && !free.any((5, 10), (0, 10)));
    /// ```
    pub fn any(&self, x: (i32, i32), y: (i32, i32)) -> bool {
        self.first(x, y).is_some()
    }

    /// The number of set bits.
    pub fn count(&self) -> usize {
        self.rows.iter().map(|w| w.count_ones() as usize).sum()
    }

    /// Runs of set bits in a row: the first column of each, and one past its last.
    ///
    /// ```
    /// let mut free = vc_geometry::grid::BitGrid::new(10, 1);
    /// free.fill((1, 3), (0, 1), true);
    /// free.fill((5, 9), (0, 1), true);
    /// assert_eq!(free.runs(0).collect::<Vec<_>>(), [(1, 3), (5, 9)]);
    /// ```
    pub fn runs(&self, row: usize) -> impl Iterator<Item = (u32, u32)> + '_ {
        let inside = row < self.height;
        let words = if inside { &self.rows[row * self.words..(row + 1) * self.words] } else { &[] };
        let mut at = 0_usize;
        std::iter::from_fn(move || {
            let from = next(words, at, true)?;
            let to = next(words, from, false).unwrap_or(words.len() * 64);
            at = to;
            Some((from as u32, to as u32))
        })
    }

    /// The cells whose bits are set, row by row: column and row.
    ///
    /// ```
    /// let mut free = vc_geometry::grid::BitGrid::new(10, 10);
    /// free.fill((2, 4), (3, 4), true);
    /// assert_eq!(free.cells().collect::<Vec<_>>(), [(2, 3), (3, 3)]);
    /// ```
    pub fn cells(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        (0..self.height)
            .flat_map(|y| self.runs(y).flat_map(move |(from, to)| (from as usize..to as usize).map(move |x| (x, y))))
    }

    /// The first set bit of a rectangle.
    ///
    /// ```
    /// let mut free = vc_geometry::grid::BitGrid::new(10, 10);
    /// free.fill((3, 5), (6, 8), true);
    /// assert_eq!(free.first((4, 10), (0, 10)), Some((4, 6)));
    /// ```
    pub fn first(&self, x: (i32, i32), y: (i32, i32)) -> Option<(usize, usize)> {
        let (words, mut rows) = self.cut(x, y)?;
        rows.find_map(|row| {
            words.clone().find_map(|(word, mask)| {
                let bits = self.rows[row * self.words + word] & mask;
                (bits != 0).then(|| (word * 64 + bits.trailing_zeros() as usize, row))
            })
        })
    }

    /// Clears what an operation on words has set beyond the last column.
    pub(super) fn trim(&mut self) {
        let last = self.words - 1;
        let mask = span(0, self.width - (last * 64).min(self.width));
        if mask != u64::MAX {
            self.rows.chunks_mut(self.words).for_each(|row| row[last] &= mask);
        }
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

/// A mask of the bits from `from` up to, but excluding, `to`.
pub(super) fn span(from: usize, to: usize) -> u64 {
    if to <= from {
        return 0;
    }
    (u64::MAX >> (64 - (to - from))) << from
}

/// The largest integer not greater than a number, as the cell that contains a coordinate; the least or the greatest
/// integer for a number beyond these, zero for NaN. Avoids the function call that rounding costs on baseline x86-64.
///
/// ```
/// use vc_geometry::grid::{ceiling, floor};
/// assert_eq!((floor(2.5), floor(-2.5), ceiling(2.5), ceiling(-2.5)), (2, -3, 3, -2));
/// ```
#[inline]
pub fn floor(v: f32) -> i32 {
    let whole = v as i32;
    whole.saturating_sub(i32::from(whole as f32 > v))
}

/// The smallest integer not less than a number; see [`floor`].
#[inline]
pub fn ceiling(v: f32) -> i32 {
    let whole = v as i32;
    whole.saturating_add(i32::from((whole as f32) < v))
}
