//! A bit grid with a place on the floor.

use nalgebra::Point2;

use super::BitGrid;
use super::spans::{Spans, whole_up};

/// The largest number of cells in a grid; larger floors get larger cells.
const MOST: f32 = 4.0e6;

/// Square cells over a rectangle of the floor: columns along X, rows along Y, both upwards.
///
/// ```
/// use nalgebra::Point2;
/// use vc_geometry::grid::Raster;
/// let corner = |x: f32, y: f32| Point2::new(x, y);
/// let room = [corner(0.0, 0.0), corner(4.0, 0.0), corner(4.0, 3.0), corner(0.0, 3.0)];
/// let mut floor = Raster::over(room[0], room[2], 0.05).ok_or("empty")?;
/// floor.paint(&room, 0.0, true);
/// // Half a metre around a post of 20 cm.
/// let post = [corner(1.9, 1.4), corner(2.1, 1.4), corner(2.1, 1.6), corner(1.9, 1.6)];
/// floor.paint(&post, 0.5, false);
/// assert!(!floor.holds(&corner(2.0, 2.0)) && floor.holds(&corner(2.0, 2.2)));
/// let taken = 12.0 - floor.cells().count() as f32 * 0.05 * 0.05;
/// assert!((taken - (0.04 + 0.4 + 0.25 * std::f32::consts::PI)).abs() < 0.02);
/// # Ok::<(), &str>(())
/// ```
#[derive(Debug, Clone)]
pub struct Raster {
    low: Point2<f32>,
    cell: f32,
    cells: BitGrid,
    /// Kept to reuse its memory.
    spans: Spans,
}

impl Raster {
    /// A grid over a rectangle with no cell set; sides in metres. `None` if the rectangle is empty or not finite.
    /// A rectangle of more than four million cells gets larger ones.
    pub fn over(low: Point2<f32>, high: Point2<f32>, cell: f32) -> Option<Self> {
        let size = high - low;
        if !(size.x > 0.0 && size.y > 0.0 && size.x.is_finite() && size.y.is_finite() && cell > 0.0) {
            return None;
        }
        let cell = cell.max((size.x / MOST * size.y).sqrt()).max(size.max() / MOST);
        let count = |length: f32| (length / cell).ceil() as usize + 1;
        let cells = BitGrid::new(count(size.x), count(size.y));
        Some(Self { low, cell, cells, spans: Spans::default() })
    }

    /// The corner of the first cell, metres.
    pub fn low(&self) -> Point2<f32> {
        self.low
    }

    /// Side of a cell, metres.
    pub fn cell(&self) -> f32 {
        self.cell
    }

    /// The cells.
    pub fn cells(&self) -> &BitGrid {
        &self.cells
    }

    /// Clears all cells.
    pub fn clear(&mut self) {
        self.cells.clear();
    }

    /// Sets or clears the cells whose centres are within a convex outline grown by a radius, metres; its corners
    /// go counter-clockwise.
    ///
    /// Costs a few operations for each row that it crosses, and for each word of cells in it.
    pub fn paint(&mut self, outline: &[Point2<f32>], radius: f32, value: bool) {
        let level = |pick: fn(f32, f32) -> f32| outline.iter().map(|p| p.y).reduce(pick);
        let (Some(bottom), Some(top)) = (level(f32::min), level(f32::max)) else { return };
        let first = self.index(bottom - radius - self.low.y, self.cells.height());
        let last = self.index(top + radius - self.low.y, self.cells.height());
        let middle = self.low.y + (first as f32 + 0.5) * self.cell;
        let mut spans = std::mem::take(&mut self.spans);
        spans.trace(outline, radius, middle, self.cell, last.saturating_sub(first));
        for (row, (left, right)) in spans.covered() {
            let from = self.index(left - self.low.x, self.cells.width());
            let to = self.index(right - self.low.x, self.cells.width());
            self.cells.fill_row(first + row, from, to, value);
        }
        self.spans = spans;
    }

    /// The first cell whose centre is not before an offset.
    fn index(&self, offset: f32, most: usize) -> usize {
        whole_up(offset / self.cell - 0.5).min(most)
    }

    /// A point in units of cells from the first cell's corner.
    pub fn in_cells(&self, p: &Point2<f32>) -> (f64, f64) {
        (f64::from(p.x - self.low.x) / f64::from(self.cell), f64::from(p.y - self.low.y) / f64::from(self.cell))
    }

    /// The point of a position in units of cells, metres.
    pub fn point(&self, (x, y): (f64, f64)) -> Point2<f32> {
        let at = |low: f32, n: f64| (f64::from(low) + n * f64::from(self.cell)) as f32;
        Point2::new(at(self.low.x, x), at(self.low.y, y))
    }

    /// The cell that contains a point: column and row.
    ///
    /// ```
    /// use nalgebra::Point2;
    /// let floor = vc_geometry::grid::Raster::over(Point2::new(1.0, 1.0), Point2::new(3.0, 2.0), 0.1).ok_or("empty")?;
    /// assert_eq!(floor.cell_of(&Point2::new(1.25, 1.05)), Some((2, 0)));
    /// assert_eq!(floor.cell_of(&Point2::new(0.5, 1.05)), None);
    /// # Ok::<(), &str>(())
    /// ```
    pub fn cell_of(&self, p: &Point2<f32>) -> Option<(usize, usize)> {
        let (x, y) = self.in_cells(p);
        let inside = x >= 0.0 && y >= 0.0 && x < self.cells.width() as f64 && y < self.cells.height() as f64;
        inside.then_some((x as usize, y as usize))
    }

    /// Whether the cell of a point is set.
    pub fn holds(&self, p: &Point2<f32>) -> bool {
        self.cell_of(p).is_some_and(|(x, y)| self.cells.get(x, y))
    }

    /// The centre of the nearest set cell within a distance, metres; the point itself if its own cell is set. Costs
    /// some operations for each cell within the distance.
    ///
    /// ```
    /// use nalgebra::Point2;
    /// let corner = |x: f32, y: f32| Point2::new(x, y);
    /// let mut floor = vc_geometry::grid::Raster::over(corner(0.0, 0.0), corner(2.0, 1.0), 0.1).ok_or("empty")?;
    /// floor.paint(&[corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)], 0.0, true);
    /// let nearest = floor.nearest(&corner(1.5, 0.55), 1.0).ok_or("none")?;
    /// assert!((nearest - corner(0.95, 0.55)).norm() < 1e-4);
    /// # Ok::<(), &str>(())
    /// ```
    pub fn nearest(&self, p: &Point2<f32>, within: f32) -> Option<Point2<f32>> {
        if self.holds(p) {
            return Some(*p);
        }
        let (x, y) = self.in_cells(p);
        let reach = (within.max(0.0) / self.cell).min(1e9) as i64 + 1;
        let around = |middle: f64, most: usize| {
            let middle = middle as i64;
            middle.saturating_sub(reach).max(0)..middle.saturating_add(reach + 1).min(most as i64)
        };
        let (rows, columns) = (around(y, self.cells.height()), around(x, self.cells.width()));
        let cells = rows.flat_map(|r| columns.clone().map(move |c| (c as usize, r as usize)));
        let middle = |(c, r): (usize, usize)| self.point((c as f64 + 0.5, r as f64 + 0.5));
        let free = cells.filter(|&(c, r)| self.cells.get(c, r)).map(middle).map(|m| ((m - p).norm(), m));
        free.filter(|(d, _)| *d <= within).min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, m)| m)
    }
}
