//! Discs of cells, and what is within a disc of bits or of a rectangle: dilation and distance.

use super::BitGrid;

/// The cells around a cell that belong to a disc: half the disc's width in each row.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Disc {
    /// The greatest column offset in the rows at offset 0, 1, 2...
    halves: Vec<usize>,
}

impl Disc {
    /// The cells that a disc overlaps whose centre may be anywhere in the middle cell; `radius` in cells. A
    /// walker keeps so far from cells with an obstacle.
    pub fn touching(radius: usize) -> Self {
        // The distance between the nearest points of two cells at an offset, in half cells.
        let near = |offset: usize| (2 * offset).saturating_sub(1);
        let meets = |row: usize, column: usize| near(column).pow(2) + near(row).pow(2) < (2 * radius).pow(2);
        let half = |row: usize| (0..=radius).rev().find(|column| meets(row, *column)).unwrap_or(0);
        Self { halves: (0..=radius).map(half).collect() }
    }

    /// The cells whose centres are at most `radius` cells from the centre of the middle cell; the middle cell
    /// alone if the radius is below one or no number.
    ///
    /// ```
    /// use vc_geometry::grid::{BitGrid, Disc};
    /// let mut reach = BitGrid::new(11, 11);
    /// reach.set(5, 5);
    /// assert_eq!(reach.dilated(&Disc::within(1.0)).count(), 5);
    /// assert_eq!(reach.dilated(&Disc::within(1.5)).count(), 9);
    /// ```
    pub fn within(radius: f32) -> Self {
        let inside = |row: usize, column: usize| (row * row + column * column) as f32 <= radius * radius;
        let most = radius.clamp(0.0, 1e4) as usize;
        let half = |row: usize| (0..=most).rev().find(|column| inside(row, *column)).unwrap_or(0);
        Self { halves: (0..=most).map(half).collect() }
    }

    /// The rows of a rectangle grown by the disc, nearest first: columns and rows.
    fn around(&self, x: (i32, i32), y: (i32, i32)) -> impl Iterator<Item = ((i32, i32), (i32, i32))> + '_ {
        let wide = move |half: usize| (x.0.saturating_sub(half as i32), x.1.saturating_add(half as i32));
        let whole = self.halves.iter().take(1).map(move |&half| (wide(half), y));
        let rows = (1_i32..).zip(self.halves.iter().skip(1));
        whole.chain(rows.flat_map(move |(off, &half)| {
            let (below, above) = (y.0.saturating_sub(off), y.1.saturating_add(off));
            [(wide(half), (below, below.saturating_add(1))), (wide(half), (above.saturating_sub(1), above))]
        }))
    }
}

impl BitGrid {
    /// A set bit within a disc of some cell of a rectangle: in the rectangle's own rows if there is one, else in
    /// the nearest row.
    pub fn first_near(&self, x: (i32, i32), y: (i32, i32), disc: &Disc) -> Option<(usize, usize)> {
        disc.around(x, y).find_map(|(x, y)| self.first(x, y))
    }

    /// Clears all bits within a disc of a rectangle.
    ///
    /// ```
    /// use vc_geometry::grid::{BitGrid, Disc};
    /// let mut free = BitGrid::new(11, 1);
    /// free.fill((0, 11), (0, 1), true);
    /// free.clear_near((5, 6), (0, 1), &Disc::touching(2));
    /// assert_eq!(free.runs(0).collect::<Vec<_>>(), [(0, 3), (8, 11)]);
    /// ```
    pub fn clear_near(&mut self, x: (i32, i32), y: (i32, i32), disc: &Disc) {
        disc.around(x, y).for_each(|(x, y)| self.fill(x, y, false));
    }

    /// The bits within a disc of a set one: the grid dilated by the disc (Serra, "Image analysis and
    /// mathematical morphology", 1982).
    ///
    /// Costs a few operations for each word and each row of the disc.
    pub fn dilated(&self, disc: &Disc) -> Self {
        let mut out = self.empty();
        let mut wide = self.clone();
        let mut reach = 0;
        // From the disc's outer rows inwards the span only grows.
        for (dy, &half) in disc.halves.iter().enumerate().rev() {
            while reach < half {
                wide.widen();
                reach += 1;
            }
            // Shifts all rows at once up and down by this many.
            let skip = (dy * self.words).min(wide.rows.len());
            out.rows.iter_mut().zip(&wide.rows[skip..]).for_each(|(a, b)| *a |= b);
            out.rows[skip..].iter_mut().zip(&wide.rows).for_each(|(a, b)| *a |= b);
        }
        out.trim();
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
}
