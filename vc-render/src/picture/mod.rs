//! Buffers as pictures that people can look at, and PNG files of them.

mod canvas;
mod colours;
mod encode;

pub use canvas::Picture;
pub use colours::{Palette, classes, depth, flow, instances, masks, normals, parts, rgb, with_boxes};
pub use encode::{apng, png};
