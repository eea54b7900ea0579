//! Files for other programs: NumPy arrays, OpenEXR floats, COCO labels and PLY point clouds.

mod coco;
mod exr;
mod npy;
mod ply;

pub use coco::{Coco, CocoPicture};
pub use exr::exr;
pub use npy::{NpyNumber, npy};
pub use ply::ply;
