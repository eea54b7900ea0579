//! The free floor as bands: rectangles as wide as the free floor there.
//!
//! On the left and right of a band there is always an obstacle, so paths leave it only across its lower and
//! upper sides.

use crate::grid::BitGrid;

/// A rectangle of free cells: columns `x0..x1`, rows `y0..y1`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Band {
    pub(super) x0: u32,
    pub(super) x1: u32,
    pub(super) y0: u32,
    pub(super) y1: u32,
    /// Its gates: their first index and number in the lists of downward and upward gates.
    below: (u32, u32),
    above: (u32, u32),
}

/// A passage from one band to the next: columns `from..to` of their common side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Gate {
    pub(super) band: u32,
    pub(super) from: u32,
    pub(super) to: u32,
}

/// The free cells of a grid as bands, and their gates: the mesh on which [`shortest`](super::shortest) searches.
///
/// ```
/// use vc_geometry::grid::BitGrid;
/// let mut free = BitGrid::new(20, 10);
/// free.fill((0, 20), (0, 10), true);
/// assert_eq!(vc_geometry::walk::Bands::new(&free).len(), 1);
/// free.fill((8, 12), (4, 6), false); // A post: below it, above it, and to both sides.
/// assert_eq!(vc_geometry::walk::Bands::new(&free).len(), 4);
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Bands {
    pub(super) all: Vec<Band>,
    up: Vec<Gate>,
    down: Vec<Gate>,
    /// For each row, its range in `in_rows`, which lists its bands by column.
    rows: Vec<(u32, u32)>,
    in_rows: Vec<u32>,
}

impl Bands {
    /// The bands of the set cells. Costs some operations for each run of cells in a row.
    pub fn new(free: &BitGrid) -> Self {
        let mut bands = Self::default();
        let mut before: Vec<u32> = Vec::new();
        for row in 0..free.height() {
            let current = bands.row(free, row as u32, &before);
            bands.rows.push((bands.in_rows.len() as u32, current.len() as u32));
            bands.in_rows.extend(&current);
            before = current;
        }
        bands.join();
        bands
    }

    /// The bands of a row: continued bands of the row before, and new ones.
    fn row(&mut self, free: &BitGrid, row: u32, before: &[u32]) -> Vec<u32> {
        let mut old = before.iter().copied().peekable();
        let mut current = Vec::new();
        for (x0, x1) in free.runs(row as usize) {
            while old.next_if(|&b| self.all[b as usize].x0 < x0).is_some() {}
            let same = old.peek().copied().filter(|&b| (self.all[b as usize].x0, self.all[b as usize].x1) == (x0, x1));
            current.push(same.unwrap_or(self.all.len() as u32));
            match same {
                Some(band) => self.all[band as usize].y1 = row + 1,
                None => self.all.push(Band { x0, x1, y0: row, y1: row + 1, below: (0, 0), above: (0, 0) }),
            }
        }
        current
    }

    /// Finds the gates: bands that end at a row, next to bands that begin there. The gates of one band on one
    /// side are found consecutively.
    fn join(&mut self) {
        let Self { all, up, down, rows, in_rows } = self;
        for pair in rows.windows(2) {
            let slice = |(from, count): (u32, u32)| &in_rows[from as usize..(from + count) as usize];
            let (lower, upper) = (slice(pair[0]), slice(pair[1]));
            let (mut i, mut j) = (0, 0);
            while let (Some(&a), Some(&b)) = (lower.get(i), upper.get(j)) {
                let (one, two) = (&all[a as usize], &all[b as usize]);
                let (from, to) = (one.x0.max(two.x0), one.x1.min(two.x1));
                if one.x1 < two.x1 {
                    i += 1
                } else {
                    j += 1
                }
                if from < to && a != b {
                    extend(&mut all[a as usize].above, up, Gate { band: b, from, to });
                    extend(&mut all[b as usize].below, down, Gate { band: a, from, to });
                }
            }
        }
    }

    /// Number of bands.
    pub fn len(&self) -> usize {
        self.all.len()
    }

    /// Whether no cell is free.
    pub fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// The gates of a band on its upper or its lower side.
    pub(super) fn gates(&self, band: u32, up: bool) -> &[Gate] {
        let band = &self.all[band as usize];
        let ((from, count), gates) = if up { (band.above, &self.up) } else { (band.below, &self.down) };
        &gates[from as usize..(from + count) as usize]
    }

    /// The band of a cell.
    pub(super) fn at(&self, column: usize, row: usize) -> Option<u32> {
        let &(from, count) = self.rows.get(row)?;
        let row = &self.in_rows[from as usize..(from + count) as usize];
        let after = row.partition_point(|&b| self.all[b as usize].x0 as usize <= column);
        let band = *row.get(after.checked_sub(1)?)?;
        (column < self.all[band as usize].x1 as usize).then_some(band)
    }
}

/// Appends a gate to a list, and extends the range of a band in it.
fn extend((from, count): &mut (u32, u32), list: &mut Vec<Gate>, gate: Gate) {
    if *count == 0 {
        *from = list.len() as u32;
    }
    *count += 1;
    list.push(gate);
}
