//! Ray casting in a snapshot.

mod build;
mod bvh;
mod cast;
mod layer;
mod scene;
mod walk;

pub(crate) use bvh::{Bvh, Ray};
pub use cast::{RayCaster, RayHit};
pub(crate) use scene::{Met, Tracer};
