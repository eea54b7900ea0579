//! The walkable floor as plain data.

use nalgebra::Point2;
use serde::{Deserialize, Serialize};

use super::Floor;

/// An occupancy grid of the walkable floor for other planners: rows of square cells along the world's axes.
///
/// Columns run along X and rows along Y, both upwards from `origin`; cells are listed row by row. A cell is
/// free if a person whose middle is at its centre keeps clear of everything, as [`FloorOptions`](crate::FloorOptions)
/// specifies: obstacles are already grown by the walker's radius, and people are not among them.
///
/// ```
/// use nalgebra::Point2;
/// use vc_physics::{Floor, FloorOptions};
/// let corner = |x: f32, y: f32| Point2::new(x, y);
/// let rectangle = |x0, y0, x1, y1| vec![corner(x0, y0), corner(x1, y0), corner(x1, y1), corner(x0, y1)];
/// let table = rectangle(1.5, 1.0, 2.5, 2.0);
/// let floor = Floor::from_outlines(&[rectangle(0.0, 0.0, 4.0, 3.0)], &[table], FloorOptions::default());
/// let grid = floor.occupancy();
/// assert_eq!((grid.origin, grid.free.len()), ([0.0, 0.0], grid.columns * grid.rows));
/// let (column, row) = grid.cell_of(corner(2.0, 1.5)).ok_or("outside")?;
/// assert!(!grid.is_free(column, row) && !floor.is_free(grid.centre(column, row)));
/// assert!(grid.cell_of(corner(0.3, 0.3)).is_some_and(|(column, row)| grid.is_free(column, row)));
/// # Ok::<(), &str>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Occupancy {
    /// The corner of the first cell, lowest along X and Y, metres.
    pub origin: [f32; 2],
    /// Side of a cell, metres.
    pub cell: f32,
    /// Number of cells along X.
    pub columns: usize,
    /// Number of cells along Y.
    pub rows: usize,
    /// Whether a walker can stand on each cell: cell (column, row) is at `row * columns + column`.
    pub free: Vec<bool>,
}

impl Occupancy {
    /// Whether a cell is free; a cell outside the grid is not.
    pub fn is_free(&self, column: usize, row: usize) -> bool {
        column < self.columns && row < self.rows && self.free.get(row * self.columns + column).is_some_and(|free| *free)
    }

    /// The centre of a cell, metres.
    pub fn centre(&self, column: usize, row: usize) -> Point2<f32> {
        let at = |low: f32, number: usize| low + (number as f32 + 0.5) * self.cell;
        Point2::new(at(self.origin[0], column), at(self.origin[1], row))
    }

    /// Column and row of the cell that contains a point; `None` outside the grid.
    pub fn cell_of(&self, point: Point2<f32>) -> Option<(usize, usize)> {
        let along = |value: f32, low: f32| (value - low) / self.cell;
        let (x, y) = (along(point.x, self.origin[0]), along(point.y, self.origin[1]));
        let inside = x >= 0.0 && y >= 0.0 && x < self.columns as f32 && y < self.rows as f32;
        inside.then_some((x as usize, y as usize))
    }
}

impl Floor {
    /// The floor's cells as plain data, free or not. Takes time linear in their number.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// let map = vc_physics::Floor::new(&world, vc_physics::FloorOptions::default()).occupancy();
    /// let (column, row) = map.cell_of(nalgebra::Point2::new(0.0, 0.0)).ok_or("outside")?;
    /// assert!(map.is_free(column, row));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn occupancy(&self) -> Occupancy {
        let cell = self.options.cell;
        let none = Occupancy { origin: [0.0; 2], cell, columns: 0, rows: 0, free: Vec::new() };
        let Some(raster) = &self.raster else { return none };
        let (columns, rows) = (raster.cells().width(), raster.cells().height());
        let free = (0..rows).flat_map(|row| (0..columns).map(move |column| raster.cells().get(column, row))).collect();
        Occupancy { origin: raster.low().into(), cell: raster.cell(), columns, rows, free }
    }
}
