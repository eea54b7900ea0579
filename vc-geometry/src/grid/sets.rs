//! Operations on whole grids: squares of set bits, intersection, complement, inclusion.

use super::BitGrid;

impl BitGrid {
    /// The bits that are the lower-left corner of a square of set bits with the given side.
    ///
    /// ```
    /// let mut free = vc_geometry::grid::BitGrid::new(10, 10);
    /// free.fill((2, 6), (3, 5), true);
    /// // A square of two by two cells fits at three places.
    /// assert_eq!(free.squares(2).cells().collect::<Vec<_>>(), [(2, 3), (3, 3), (4, 3)]);
    /// assert_eq!(free.squares(2).covered(2), free);
    /// ```
    pub fn squares(&self, side: usize) -> Self {
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

    /// The union of the squares whose lower-left corners are set: the inverse of [`BitGrid::squares`].
    pub fn covered(&self, side: usize) -> Self {
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
        out.trim();
        out
    }

    /// Whether every set bit is also set in another grid of the same size.
    ///
    /// ```
    /// let mut room = vc_geometry::grid::BitGrid::new(10, 10);
    /// let mut rug = room.empty();
    /// room.fill((1, 9), (1, 9), true);
    /// rug.fill((2, 4), (2, 4), true);
    /// assert!(rug.is_within(&room) && !room.is_within(&rug));
    /// ```
    pub fn is_within(&self, other: &Self) -> bool {
        self.rows.iter().zip(&other.rows).all(|(a, b)| a & !b == 0)
    }

    /// The intersection with another grid of the same size.
    ///
    /// ```
    /// let mut one = vc_geometry::grid::BitGrid::new(10, 1);
    /// let mut other = one.empty();
    /// one.fill((0, 6), (0, 1), true);
    /// other.fill((4, 10), (0, 1), true);
    /// assert_eq!(one.and(&other).runs(0).collect::<Vec<_>>(), [(4, 6)]);
    /// ```
    pub fn and(&self, other: &Self) -> Self {
        let rows = self.rows.iter().zip(&other.rows).map(|(a, b)| a & b).collect();
        Self { rows, ..*self }
    }

    /// The complement.
    ///
    /// ```
    /// let mut walls = vc_geometry::grid::BitGrid::new(10, 1);
    /// walls.fill((4, 6), (0, 1), true);
    /// assert_eq!(walls.inverted().runs(0).collect::<Vec<_>>(), [(0, 4), (6, 10)]);
    /// ```
    pub fn inverted(&self) -> Self {
        let mut out = Self { rows: self.rows.iter().map(|w| !w).collect(), ..*self };
        out.trim();
        out
    }
}
