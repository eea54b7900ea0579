//! Images without the renderer: drawings, and sketches of objects.
//!
//! [`Canvas`] is a drawing (floor plans, charts) that is written as SVG or PNG;
//! [`sketch()`] shows assets in perspective. Both need no font, no display and no
//! graphics card.

mod canvas;
mod floor_plan;
mod image;
mod sketch;
mod storey;
mod top;

pub use canvas::{Anchor, Canvas, Colour, Ink, Point};
pub use image::{Image, PictureError};
pub use sketch::{Projection, SketchView, sketch};
