//! Files for other programs: NumPy arrays, OpenEXR floats and COCO labels.

mod coco;
mod exr;
mod npy;

pub use coco::{Coco, CocoPicture};
pub use exr::exr;
pub use npy::{NpyNumber, npy};
