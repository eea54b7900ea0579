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
mod labels;
mod light;
mod math;
mod mesh;
mod modality;
mod path_tracing;
pub mod picture;
mod rasterization;
mod ray_casting;
mod renderer;
mod scene;
mod shading;
mod shot;
mod surface;

pub use camera::Camera;
pub use error::RenderError;
pub use frame::{Box3, BoxLabel, Frame, Mask, PixelBox, Rle};
pub use light::{Daylight, Lighting, Source};
pub use modality::{Modalities, Modality, NO_LABEL, NOTHING};
pub use path_tracing::{PathTracing, ReferencePicture, RenderProgress};
pub use ray_casting::{RayCaster, RayHit};
pub use renderer::Renderer;
pub use scene::Snapshot;
pub use shot::{Adaptation, Shot, View};
pub use surface::Coat;
