//! Connected parts of a bit grid.

use super::BitGrid;
use super::bits::span;

impl BitGrid {
    /// The set bits connected to a given one by steps along the axes; empty if that bit is not set.
    ///
    /// Spreads from row to row, whole runs of a row at once, alternately up and down the grid: costs a few
    /// operations for each word of the rows reached, times the number of turns of the region's longest way.
    ///
    /// ```
    /// let mut free = vc_geometry::grid::BitGrid::new(20, 10);
    /// free.fill((0, 20), (0, 10), true);
    /// free.fill((10, 11), (0, 10), false); // A wall without a door.
    /// assert_eq!(free.flood(2, 2).count(), 10 * 10);
    /// ```
    pub fn flood(&self, x: usize, y: usize) -> Self {
        let mut seen = self.empty();
        if !self.get(x, y) {
            return seen;
        }
        seen.set(x, y);
        seen.fill_runs(self, y);
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

    /// The largest connected part; of parts of one size the one that begins first, row by row.
    ///
    /// Joins the runs of neighbouring rows (union-find; Tarjan 1975), nearly linear in their number.
    ///
    /// ```
    /// let mut free = vc_geometry::grid::BitGrid::new(20, 10);
    /// free.fill((0, 6), (0, 10), true);
    /// free.fill((8, 20), (0, 10), true);
    /// assert_eq!(free.largest().count(), 12 * 10);
    /// ```
    pub fn largest(&self) -> Self {
        let runs: Vec<(usize, u32, u32)> =
            (0..self.height()).flat_map(|y| self.runs(y).map(move |(from, to)| (y, from, to))).collect();
        let mut first: Vec<usize> = (0..runs.len()).collect();
        let (mut below, mut above) = (0, 0);
        while above < runs.len() {
            let ((lower, from, to), (upper, left, right)) = (runs[below], runs[above]);
            if lower + 1 == upper && from < right && left < to {
                join(&mut first, below, above);
            }
            // The run that ends first meets no later one.
            if lower + 1 < upper || (lower + 1 == upper && to <= right) {
                below += 1;
            } else {
                above += 1;
            }
        }
        let mut sizes = vec![0; runs.len()];
        for (run, &(_, from, to)) in runs.iter().enumerate() {
            sizes[root(&mut first, run)] += (to - from) as usize;
        }
        let largest = sizes.iter().copied().max().and_then(|most| sizes.iter().position(|size| *size == most));
        let mut out = self.empty();
        for (run, &(y, from, to)) in runs.iter().enumerate() {
            if Some(root(&mut first, run)) == largest {
                out.fill_row(y, from as usize, to as usize, true);
            }
        }
        out
    }

    /// Whether the set bits within a distance of a rectangle are connected there, in columns and rows: then a
    /// walker whose path crossed the rectangle can walk around it.
    ///
    /// ```
    /// let mut free = vc_geometry::grid::BitGrid::new(20, 20);
    /// free.fill((0, 20), (0, 20), true);
    /// free.fill((9, 11), (9, 11), false);
    /// assert!(free.is_whole_around((9, 11), (9, 11), 3)); // One can walk around a post.
    /// free.fill((0, 20), (9, 11), false);
    /// assert!(!free.is_whole_around((9, 11), (9, 11), 3)); // A wall cuts the floor in two.
    /// ```
    pub fn is_whole_around(&self, x: (i32, i32), y: (i32, i32), far: usize) -> bool {
        let far = i32::try_from(far).unwrap_or(i32::MAX);
        let grown = |(low, high): (i32, i32)| (low.saturating_sub(far), high.saturating_add(far));
        let window = (grown(x), grown(y));
        if let Some((near, count)) = self.small_window(window.0, window.1) {
            return is_whole(&near[..count]);
        }
        let near = self.window(window.0, window.1);
        let all = ((0, near.width() as i32), (0, near.height() as i32));
        let Some((x, y)) = near.first(all.0, all.1) else { return true };
        near.flood(x, y) == near
    }

    /// A rectangle, clipped to the grid, as one word for each row, and the number of rows; `None` if it is not
    /// small.
    fn small_window(&self, x: (i32, i32), y: (i32, i32)) -> Option<([u64; SMALL], usize)> {
        let (x, y) = self.clipped(x, y);
        if x.len() > 64 || y.len() > SMALL {
            return None;
        }
        let (word, shift, mask) = (x.start / 64, x.start % 64, span(0, x.len()));
        let mut near = [0; SMALL];
        let rows = self.rows.chunks_exact(self.words).take(y.end).skip(y.start);
        for (to, row) in near.iter_mut().zip(rows) {
            let over = if shift > 0 { row.get(word + 1).map_or(0, |w| w << (64 - shift)) } else { 0 };
            *to = (row.get(word).map_or(0, |w| w >> shift) | over) & mask;
        }
        Some((near, y.len()))
    }

    /// A rectangle, clipped to the grid, as a grid of its own.
    fn window(&self, x: (i32, i32), y: (i32, i32)) -> Self {
        let (x, y) = self.clipped(x, y);
        let mut out = Self::new(x.len(), y.len());
        let (skip, shift) = (x.start / 64, x.start % 64);
        for (to, from) in out.rows.chunks_mut(out.words).zip(self.rows.chunks(self.words).skip(y.start)) {
            for (i, word) in to.iter_mut().enumerate() {
                let at = |k: usize| from.get(skip + i + k).copied().unwrap_or(0);
                *word = at(0) >> shift | if shift > 0 { at(1) << (64 - shift) } else { 0 };
            }
        }
        out.trim();
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
    fn fill_runs(&mut self, free: &Self, row: usize) {
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
}

/// The most rows of a small window: it is kept off the heap.
const SMALL: usize = 96;

/// The first run of the part that a run belongs to.
fn root(first: &mut [usize], mut run: usize) -> usize {
    while first[run] != run {
        first[run] = first[first[run]];
        run = first[run];
    }
    run
}

/// Joins the parts of two runs.
fn join(first: &mut [usize], one: usize, other: usize) {
    let (one, other) = (root(first, one), root(first, other));
    first[one.max(other)] = one.min(other);
}

/// Whether the bits of at most [`SMALL`] rows of one word each are connected.
fn is_whole(rows: &[u64]) -> bool {
    let Some(first) = rows.iter().position(|row| *row != 0) else { return true };
    let mut seen = [0; SMALL];
    let seen = &mut seen[..rows.len()];
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

/// The bits of `open` from `seeds` upwards to the ends of their runs, and whether the last run
/// continues in the next word. Adding a bit to a run of ones carries to the run's end.
fn run_up(seeds: u64, open: u64, carry: bool) -> (u64, bool) {
    let (sum, first) = open.overflowing_add(seeds);
    let (sum, second) = sum.overflowing_add(u64::from(carry));
    (((sum ^ open) & open) | seeds, first || second)
}
