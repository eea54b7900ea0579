//! Grids of bits over the floor: free cells and obstacles, and the ways that connect them.
//!
//! | item | answers |
//! |---|---|
//! | [`BitGrid`] | a bit for each cell, 64 cells in a word: rectangles, discs around cells, connected parts |
//! | [`Disc`] | which cells around a cell belong to a disc: how a walker's width and a hand's reach are counted |
//! | [`Raster`] | a grid with a place on the floor, in metres, painted with convex outlines |
//!
//! A person of five cells' radius passes a gap of eleven cells in a wall, not one of ten:
//!
//! ```
//! use vc_geometry::grid::{BitGrid, Disc};
//! let passes = |gap: i32| {
//!     let mut walls = BitGrid::new(60, 60);
//!     walls.fill((0, 60), (30, 31), true);
//!     walls.fill((20, 20 + gap), (30, 31), false);
//!     let free = walls.dilated(&Disc::touching(5)).inverted();
//!     free.flood(25, 10).get(25, 50)
//! };
//! assert!(passes(11) && !passes(10));
//! ```

mod bits;
mod disc;
mod flood;
mod raster;
mod sets;
mod spans;

pub use bits::{BitGrid, ceiling, floor};
pub use disc::Disc;
pub use raster::Raster;
