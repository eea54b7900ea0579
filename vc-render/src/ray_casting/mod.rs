//! Ray casting in a snapshot.

mod cast;
mod layer;
mod scene;

pub use cast::{RayCaster, RayHit};
pub(crate) use scene::{SurfaceHit, Tracer};
