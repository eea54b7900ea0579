//! Files that other programs read: numpy's arrays, OpenEXR's floats and COCO's labels.

mod coco;
mod exr;
mod npy;

pub use coco::{Coco, CocoPicture};
pub use exr::exr;
pub use npy::{Number, npy};
