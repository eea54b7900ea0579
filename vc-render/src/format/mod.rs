//! Files that other programs read: numpy's arrays and COCO's labels.

mod coco;
mod npy;

pub use coco::coco;
pub use npy::{Number, npy};
