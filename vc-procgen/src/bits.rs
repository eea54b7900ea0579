//! A grid of bits with words for rows, used by the reachability check.

use std::ops::Range;

use smallvec::SmallVec;

/// A bit grid, stored row by row.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Bits {
    words: usize,
    width: usize,
    height: usize,
    rows: Vec<u64>,
}

impl Bits {
    pub(crate) fn new(width: usize, height: usize) -> Self {
        let words = width.div_ceil(64).max(1);
        Self { words, width, height, rows: vec![0; words * height] }
    }

    /// A grid of the same size with no bit set.
    pub(crate) fn empty(&self) -> Self {
        Self { rows: vec![0; self.rows.len()], ..*self }
    }

    #[inline]
    pub(crate) fn height(&self) -> usize {
        self.height
    }

    #[inline]
    pub(crate) fn get(&self, x: usize, y: usize) -> bool {
        x < self.width && y < self.height() && self.rows[y * self.words + x / 64] >> (x % 64) & 1 == 1
    }

    #[inline]
    pub(crate) fn set(&mut self, x: usize, y: usize) {
        self.rows[y * self.words + x / 64] |= 1 << (x % 64);
    }

    /// Sets or clears a rectangle, clipped to the grid.
    pub(crate) fn fill(&mut self, x: (i32, i32), y: (i32, i32), value: bool) {
        let Some((words, rows)) = self.cut(x, y) else { return };
        for (word, mask) in words {
            for row in rows.clone() {
                let bits = &mut self.rows[row * self.words + word];
                *bits = if value { *bits | mask } else { *bits & !mask };
            }
        }
    }

    /// Clips a rectangle to the grid: its words with the mask of each, and its rows; `None` if
    /// nothing is left.
    #[inline]
    fn cut(
        &self,
        x: (i32, i32),
        y: (i32, i32),
    ) -> Option<(impl Iterator<Item = (usize, u64)> + Clone + use<>, Range<usize>)> {
        let cut = |v: i32, most: usize| v.clamp(0, most as i32) as usize;
        let (x0, x1) = (cut(x.0, self.width), cut(x.1, self.width));
        let rows = cut(y.0, self.height)..cut(y.1, self.height);
        if x0 >= x1 || rows.is_empty() {
            return None;
        }
        let (first, last) = (x0 / 64, (x1 - 1) / 64);
        let words = (first..=last).map(move |word| {
            let low = if word == first { u64::MAX << (x0 % 64) } else { u64::MAX };
            let high = if word == last { u64::MAX >> (63 - (x1 - 1) % 64) } else { u64::MAX };
            (word, low & high)
        });
        Some((words, rows))
    }

    /// Whether any bit of a rectangle is set.
    pub(crate) fn any(&self, x: (i32, i32), y: (i32, i32)) -> bool {
        self.first(x, y).is_some()
    }

    /// A set bit within a distance of a rectangle.
    pub(crate) fn first_within(&self, x: (i32, i32), y: (i32, i32), distance: usize) -> Option<(usize, usize)> {
        let far = distance as i32;
        // The rows of the rectangle dilated by a disc, nearest first.
        self.first((x.0 - far, x.1 + far), y).or_else(|| {
            (1..=far).find_map(|off| {
                let half = ((far * far - off * off) as f32).sqrt() as i32;
                let x = (x.0 - half, x.1 + half);
                let below = self.first(x, (y.0 - off, y.0 - off + 1));
                below.or_else(|| self.first(x, (y.1 + off - 1, y.1 + off)))
            })
        })
    }

    /// Whether a disc centred at some set bit would overlap a rectangle.
    pub(crate) fn meets_within(&self, x: (i32, i32), y: (i32, i32), radius: usize) -> bool {
        self.any((x.0 - radius as i32, x.1 + radius as i32), y)
            || (1..=radius as i32).any(|off| {
                let half = meeting(radius, off as usize) as i32;
                let x = (x.0 - half, x.1 + half);
                self.any(x, (y.0 - off, y.0 - off + 1)) || self.any(x, (y.1 + off - 1, y.1 + off))
            })
    }

    /// Clears all bits at which a centred disc would overlap a rectangle.
    pub(crate) fn clear_within(&mut self, x: (i32, i32), y: (i32, i32), radius: usize) {
        self.fill((x.0 - radius as i32, x.1 + radius as i32), y, false);
        for off in 1..=radius as i32 {
            let half = meeting(radius, off as usize) as i32;
            let x = (x.0 - half, x.1 + half);
            self.fill(x, (y.0 - off, y.0 - off + 1), false);
            self.fill(x, (y.1 + off - 1, y.1 + off), false);
        }
    }

    /// The number of set bits.
    pub(crate) fn count(&self) -> usize {
        self.rows.iter().map(|w| w.count_ones() as usize).sum()
    }

    /// The bits at which a centred disc would overlap a set one.
    ///
    /// Costs a few operations for each word and each row of the disc.
    pub(crate) fn dilated(&self, radius: usize) -> Self {
        let mut out = self.empty();
        let mut wide = self.clone();
        let mut reach = 0;
        // From the disc's outer rows inwards the span only grows.
        for dy in (0..=radius).rev() {
            let half = meeting(radius, dy);
            while reach < half {
                wide.widen();
                reach += 1;
            }
            // Shifts all rows at once up and down by this many.
            let skip = (dy * self.words).min(wide.rows.len());
            out.rows.iter_mut().zip(&wide.rows[skip..]).for_each(|(a, b)| *a |= b);
            out.rows[skip..].iter_mut().zip(&wide.rows).for_each(|(a, b)| *a |= b);
        }
        out
    }

    /// Sets the left and right neighbours of every set bit.
    fn widen(&mut self) {
        for row in self.rows.chunks_mut(self.words) {
            let mut carry = 0;
            for i in 0..row.len() {
                let word = row[i];
                let next = row.get(i + 1).copied().unwrap_or(0);
                row[i] = word | word << 1 | carry | word >> 1 | next << 63;
                carry = word >> 63;
            }
        }
    }

    /// The set bits connected to a given one by steps along the axes; empty if that bit is not set.
    ///
    /// Spreads from row to row, whole runs of a row at once, alternately up and down the grid: the
    /// number of turns depends on how winding the region is.
    pub(crate) fn flood(&self, x: usize, y: usize) -> Self {
        let mut seen = self.empty();
        if !self.get(x, y) {
            return seen;
        }
        seen.set(x, y);
        seen.fill_row(self, y);
        let height = self.height();
        // The rows whose latest bits have not yet been passed on upwards, and downwards.
        let (mut up, mut down) = (vec![false; height], vec![false; height]);
        (up[y], down[y]) = (true, true);
        // Rows outside this range have nothing to pass on.
        let (mut low, mut high) = (y, y);
        loop {
            let mut grew = false;
            let mut row = low;
            while row <= high && row + 1 < height {
                if std::mem::take(&mut up[row]) && seen.spread(self, row + 1, row) {
                    (up[row + 1], down[row + 1], grew) = (true, true, true);
                    high = high.max(row + 1);
                }
                row += 1;
            }
            for row in (1..=high).rev() {
                if row < low {
                    break;
                }
                if std::mem::take(&mut down[row]) && seen.spread(self, row - 1, row) {
                    (up[row - 1], down[row - 1], grew) = (true, true, true);
                    low = low.min(row - 1);
                }
            }
            if !grew {
                return seen;
            }
        }
    }

    /// Whether the set bits within a distance of a rectangle are connected there: then a person
    /// whose path crossed the rectangle can walk around it.
    pub(crate) fn is_whole_around(&self, x: (i32, i32), y: (i32, i32), far: usize) -> bool {
        let far = far as i32;
        let window = ((x.0 - far, x.1 + far), (y.0 - far, y.1 + far));
        if let Some(near) = self.small_window(window.0, window.1) {
            return is_whole(&near);
        }
        let near = self.window(window.0, window.1);
        let all = ((0, near.width as i32), (0, near.height() as i32));
        let Some((x, y)) = near.first(all.0, all.1) else { return true };
        near.flood(x, y) == near
    }

    /// A rectangle, clipped to the grid, as one word per row, if it is small enough.
    fn small_window(&self, x: (i32, i32), y: (i32, i32)) -> Option<SmallVec<[u64; SMALL]>> {
        let cut = |v: i32, most: usize| v.clamp(0, most as i32) as usize;
        let (x0, x1) = (cut(x.0, self.width), cut(x.1, self.width));
        let (y0, y1) = (cut(y.0, self.height), cut(y.1, self.height));
        if x1.saturating_sub(x0) > 64 {
            return None;
        }
        let (word, shift, mask) = (x0 / 64, x0 % 64, span(0, x1.saturating_sub(x0)));
        let rows = self.rows.chunks_exact(self.words).take(y1).skip(y0).map(|row| {
            let over = if shift > 0 { row.get(word + 1).map_or(0, |w| w << (64 - shift)) } else { 0 };
            (row.get(word).map_or(0, |w| w >> shift) | over) & mask
        });
        Some(rows.collect())
    }

    /// A rectangle, clipped to the grid, as a grid of its own.
    fn window(&self, x: (i32, i32), y: (i32, i32)) -> Self {
        let cut = |v: i32, most: usize| v.clamp(0, most as i32) as usize;
        let (x0, x1) = (cut(x.0, self.width), cut(x.1, self.width));
        let (y0, y1) = (cut(y.0, self.height()), cut(y.1, self.height()));
        let mut out = Self::new(x1 - x0, y1 - y0);
        let (skip, shift) = (x0 / 64, x0 % 64);
        for (to, from) in out.rows.chunks_mut(out.words).zip(self.rows.chunks(self.words).skip(y0)) {
            for (i, word) in to.iter_mut().enumerate() {
                let at = |k: usize| from.get(skip + i + k).copied().unwrap_or(0);
                *word = at(0) >> shift | if shift > 0 { at(1) << (64 - shift) } else { 0 };
            }
            if out.width % 64 > 0 {
                to[out.words - 1] &= span(0, out.width % 64);
            }
        }
        out
    }

    /// Adds the bits of a row reached from a neighbouring row, extended to their runs of `free`;
    /// returns whether any was new.
    fn spread(&mut self, free: &Self, row: usize, from: usize) -> bool {
        let (at, from) = (row * self.words, from * self.words);
        let (mut news, mut carry) = (false, false);
        for i in 0..self.words {
            let (open, seen) = (free.rows[at + i], self.rows[at + i]);
            let seeds = self.rows[from + i] & open & !seen;
            if seeds != 0 || carry {
                let (filled, over) = run_up(seeds, open, carry);
                (self.rows[at + i], carry, news) = (seen | filled, over, true);
            }
        }
        if news {
            self.fill_down(free, row);
        }
        news
    }

    /// Extends the set bits of a row to both ends of their runs of `free`.
    fn fill_row(&mut self, free: &Self, row: usize) {
        let mut carry = false;
        for i in row * self.words..(row + 1) * self.words {
            (self.rows[i], carry) = run_up(self.rows[i], free.rows[i], carry);
        }
        self.fill_down(free, row);
    }

    /// Extends the set bits of a row, which already reach the upper ends of their runs of `free`,
    /// to the lower ends.
    fn fill_down(&mut self, free: &Self, row: usize) {
        let mut carry = false;
        for i in (row * self.words..(row + 1) * self.words).rev() {
            // There is nothing to add where all or nothing is set.
            if self.rows[i] != free.rows[i] && (self.rows[i] != 0 || carry) {
                let (filled, over) = run_up(self.rows[i].reverse_bits(), free.rows[i].reverse_bits(), carry);
                (self.rows[i], carry) = (filled.reverse_bits(), over);
            } else {
                carry = self.rows[i] & 1 == 1;
            }
        }
    }

    /// The bits that are the lower-left corner of a square of set bits with the given side.
    pub(crate) fn squares(&self, side: usize) -> Self {
        let mut out = self.clone();
        for row in out.rows.chunks_mut(self.words) {
            for _ in 1..side {
                for i in 0..row.len() {
                    let next = row.get(i + 1).copied().unwrap_or(0);
                    row[i] &= row[i] >> 1 | next << 63;
                }
            }
        }
        for at in 0..out.rows.len() {
            let above = |k: usize| out.rows.get(at + k * self.words).copied().unwrap_or(0);
            out.rows[at] = (1..side).fold(out.rows[at], |bits, k| bits & above(k));
        }
        out
    }

    /// The union of the squares whose lower-left corners are set: the inverse of [`Bits::squares`].
    pub(crate) fn covered(&self, side: usize) -> Self {
        let mut out = self.clone();
        for row in out.rows.chunks_mut(self.words) {
            for _ in 1..side {
                for i in (0..row.len()).rev() {
                    let before = if i > 0 { row[i - 1] } else { 0 };
                    row[i] |= row[i] << 1 | before >> 63;
                }
            }
        }
        for at in (0..out.rows.len()).rev() {
            let below = |k: usize| at.checked_sub(k * self.words).map_or(0, |at| out.rows[at]);
            out.rows[at] = (1..side).fold(out.rows[at], |bits, k| bits | below(k));
        }
        out
    }

    /// Whether every set bit is also set in another grid of the same size.
    pub(crate) fn is_within(&self, other: &Self) -> bool {
        self.rows.iter().zip(&other.rows).all(|(a, b)| a & !b == 0)
    }

    /// The intersection with another grid of the same size.
    pub(crate) fn and(&self, other: &Self) -> Self {
        let rows = self.rows.iter().zip(&other.rows).map(|(a, b)| a & b).collect();
        Self { rows, ..*self }
    }

    /// The first set bit of a rectangle.
    pub(crate) fn first(&self, x: (i32, i32), y: (i32, i32)) -> Option<(usize, usize)> {
        let (words, mut rows) = self.cut(x, y)?;
        rows.find_map(|row| {
            words.clone().find_map(|(word, mask)| {
                let bits = self.rows[row * self.words + word] & mask;
                (bits != 0).then(|| (word * 64 + bits.trailing_zeros() as usize, row))
            })
        })
    }

    /// The complement.
    pub(crate) fn inverted(&self) -> Self {
        let mut out = Self { rows: self.rows.iter().map(|w| !w).collect(), ..*self };
        let tail = self.width % 64;
        if tail > 0 {
            out.rows.chunks_mut(self.words).for_each(|row| row[self.words - 1] &= span(0, tail));
        }
        out
    }
}

/// The number of rows of a window that are kept off the heap.
const SMALL: usize = 96;

/// Whether the bits of a grid with one word per row are connected.
fn is_whole(rows: &[u64]) -> bool {
    let Some(first) = rows.iter().position(|row| *row != 0) else { return true };
    let mut seen: SmallVec<[u64; SMALL]> = SmallVec::from_elem(0, rows.len());
    seen[first] = filled(rows[first] & rows[first].wrapping_neg(), rows[first]);
    // Passes down and up until every bit is reached or nothing new is found.
    loop {
        let mut news = 0;
        let mut pass = |from: usize, to: usize| {
            let more = seen[from] & rows[to] & !seen[to];
            if more != 0 {
                news |= more;
                seen[to] = filled(seen[to] | more, rows[to]);
            }
        };
        (1..rows.len()).for_each(|y| pass(y - 1, y));
        (1..rows.len()).rev().for_each(|y| pass(y, y - 1));
        if seen[..] == *rows {
            return true;
        }
        if news == 0 {
            return false;
        }
    }
}

/// Extends bits of a row to both ends of the runs of `open` that contain them.
fn filled(seeds: u64, open: u64) -> u64 {
    let (up, _) = run_up(seeds, open, false);
    let (down, _) = run_up(up.reverse_bits(), open.reverse_bits(), false);
    down.reverse_bits()
}

/// The greatest column offset at which a disc centred in a bit still overlaps a bit in a row at the
/// given offset.
fn meeting(radius: usize, rows: usize) -> usize {
    // The distance between the nearest points of two bits at this offset, in half cells.
    let near = |bits: usize| (2 * bits).saturating_sub(1);
    let meets = |columns: &usize| near(*columns).pow(2) + near(rows).pow(2) < (2 * radius).pow(2);
    (0..=radius).rev().find(meets).unwrap_or(0)
}

/// The bits of `open` from `seeds` upwards to the ends of their runs, and whether the last run
/// continues in the next word. Adding a bit to a run of ones carries to the run's end.
fn run_up(seeds: u64, open: u64, carry: bool) -> (u64, bool) {
    let (sum, first) = open.overflowing_add(seeds);
    let (sum, second) = sum.overflowing_add(u64::from(carry));
    (((sum ^ open) & open) | seeds, first || second)
}

/// A mask of the bits from `from` up to, but excluding, `to`.
fn span(from: usize, to: usize) -> u64 {
    if to <= from {
        return 0;
    }
    (u64::MAX >> (64 - (to - from))) << from
}

/// The largest integer not greater than a number. Avoids the function call that rounding costs on
/// baseline x86-64.
#[inline]
pub(crate) fn floor(v: f32) -> i32 {
    let whole = v as i32;
    whole - i32::from(whole as f32 > v)
}

/// The smallest integer not less than a number.
#[inline]
pub(crate) fn ceiling(v: f32) -> i32 {
    let whole = v as i32;
    whole + i32::from((whole as f32) < v)
}
