//! Shortest walks over the free cells of a grid.
//!
//! ```
//! use vc_geometry::grid::BitGrid;
//! use vc_geometry::walk::{Bands, shortest};
//! let mut free = BitGrid::new(20, 10);
//! free.fill((0, 20), (0, 10), true);
//! free.fill((10, 11), (0, 6), false);
//! let (corners, length) = shortest(&Bands::new(&free), (2.0, 2.0), (19.0, 2.0)).ok_or("no way")?;
//! assert_eq!(corners, [(2.0, 2.0), (10.0, 6.0), (11.0, 6.0), (19.0, 2.0)]);
//! assert!((length - (2.0 * 80_f64.sqrt() + 1.0)).abs() < 1e-9);
//! # Ok::<(), &str>(())
//! ```

mod bands;
mod search;

pub use bands::Bands;
pub use search::{CellPoint, shortest};
