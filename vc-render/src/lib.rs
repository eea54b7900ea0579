#![doc = include_str!("../FRONT.md")]
#![warn(clippy::disallowed_methods)]

// Lets the tests' shared module refer to the crate by its public name, as users do.
#[cfg(test)]
extern crate self as vc_render;
#[cfg(test)]
#[path = "../tests/common/mod.rs"]
mod common;

mod bvh;
pub mod camera;
mod colour;
mod error;
pub mod format;
mod frame;
mod label;
mod light;
mod math;
mod mesh;
mod modality;
mod path_tracing;
pub mod picture;
mod raster;
mod renderer;
mod scene;
mod shade;
mod surface;
mod trace;
mod view;

pub use camera::Camera;
pub use error::RenderError;
pub use frame::{Box3, BoxLabel, Frame, Mask, PixelBox, Rle};
pub use light::{Daylight, Lighting, Source};
pub use modality::{Modalities, Modality, NO_LABEL, NOTHING};
pub use path_tracing::{PathTracing, ReferencePicture, RenderProgress};
pub use renderer::Renderer;
pub use scene::Snapshot;
pub use surface::Coat;
pub use trace::{RayCaster, RayHit};
pub use view::{Adaptation, Shot, View};
