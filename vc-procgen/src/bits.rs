//! A grid of bits, a row a run of words: what the reachability check computes with.

/// Bits in rows.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Bits {
    words: usize,
    width: usize,
    rows: Vec<u64>,
}

impl Bits {
    pub(crate) fn new(width: usize, height: usize) -> Self {
        let words = width.div_ceil(64).max(1);
        Self { words, width, rows: vec![0; words * height] }
    }

    pub(crate) fn height(&self) -> usize {
        self.rows.len() / self.words
    }

    pub(crate) fn get(&self, x: usize, y: usize) -> bool {
        x < self.width && y < self.height() && self.rows[y * self.words + x / 64] >> (x % 64) & 1 == 1
    }

    pub(crate) fn set(&mut self, x: usize, y: usize) {
        self.rows[y * self.words + x / 64] |= 1 << (x % 64);
    }

    /// Sets or clears a rectangle, cut to the grid.
    pub(crate) fn fill(&mut self, x: (i32, i32), y: (i32, i32), value: bool) {
        let cut = |v: i32, most: usize| v.clamp(0, most as i32) as usize;
        let (x0, x1) = (cut(x.0, self.width), cut(x.1, self.width));
        for row in cut(y.0, self.height())..cut(y.1, self.height()) {
            for word in x0 / 64..x1.div_ceil(64) {
                let mask = span(x0.max(word * 64) - word * 64, x1.min(word * 64 + 64).max(word * 64) - word * 64);
                let bits = &mut self.rows[row * self.words + word];
                *bits = if value { *bits | mask } else { *bits & !mask };
            }
        }
    }

    /// Whether any bit of a rectangle is set.
    pub(crate) fn any(&self, x: (i32, i32), y: (i32, i32)) -> bool {
        let cut = |v: i32, most: usize| v.clamp(0, most as i32) as usize;
        let (x0, x1) = (cut(x.0, self.width), cut(x.1, self.width));
        (cut(y.0, self.height())..cut(y.1, self.height())).any(|row| {
            (x0 / 64..x1.div_ceil(64)).any(|word| {
                let mask = span(x0.max(word * 64) - word * 64, x1.min(word * 64 + 64).max(word * 64) - word * 64);
                self.rows[row * self.words + word] & mask != 0
            })
        })
    }

    /// How many bits are set.
    pub(crate) fn count(&self) -> usize {
        self.rows.iter().map(|w| w.count_ones() as usize).sum()
    }

    /// The bits within a distance of set ones (Minkowski sum with a disc).
    ///
    /// Costs a few operations for each word and each row of the disc.
    pub(crate) fn dilated(&self, radius: usize) -> Self {
        let mut out = Self { rows: vec![0; self.rows.len()], ..*self };
        let height = self.height();
        let mut wide = self.clone();
        let mut reach = 0;
        // From the disc's rim rows inwards the span only grows.
        for dy in (0..=radius).rev() {
            let half = ((radius * radius - dy * dy) as f32).sqrt() as usize;
            while reach < half {
                wide.widen();
                reach += 1;
            }
            for row in 0..height {
                let from = &wide.rows[row * self.words..(row + 1) * self.words];
                for target in [row.checked_sub(dy), Some(row + dy).filter(|&t| t < height)].into_iter().flatten() {
                    let to = &mut out.rows[target * self.words..(target + 1) * self.words];
                    to.iter_mut().zip(from).for_each(|(a, b)| *a |= b);
                }
            }
        }
        out
    }

    /// Every set bit's neighbours left and right.
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

    /// Everything that can be reached from a set bit over set bits, by steps along
    /// the axes; nothing from a bit that is not set.
    pub(crate) fn flood(&self, x: usize, y: usize) -> Self {
        let mut seen = Self { rows: vec![0; self.rows.len()], ..*self };
        if !self.get(x, y) {
            return seen;
        }
        seen.set(x, y);
        let mut open = vec![(x, y)];
        while let Some((x, y)) = open.pop() {
            let steps = [(x + 1, y), (x.wrapping_sub(1), y), (x, y + 1), (x, y.wrapping_sub(1))];
            for (x, y) in steps {
                if self.get(x, y) && !seen.get(x, y) {
                    seen.set(x, y);
                    open.push((x, y));
                }
            }
        }
        seen
    }

    /// The first set bit of a rectangle.
    pub(crate) fn first(&self, x: (i32, i32), y: (i32, i32)) -> Option<(usize, usize)> {
        let cut = |v: i32, most: usize| v.clamp(0, most as i32) as usize;
        let columns = cut(x.0, self.width)..cut(x.1, self.width);
        (cut(y.0, self.height())..cut(y.1, self.height()))
            .find_map(|y| columns.clone().find(|&x| self.get(x, y)).map(|x| (x, y)))
    }

    /// The bits that are not set.
    pub(crate) fn inverted(&self) -> Self {
        let mut out = Self { rows: self.rows.iter().map(|w| !w).collect(), ..*self };
        let tail = self.width % 64;
        if tail > 0 {
            out.rows.chunks_mut(self.words).for_each(|row| row[self.words - 1] &= span(0, tail));
        }
        out
    }
}

/// The bits from `from` up to `to`, `to` excluded, of a word.
fn span(from: usize, to: usize) -> u64 {
    if to <= from {
        return 0;
    }
    (u64::MAX >> (64 - (to - from))) << from
}
