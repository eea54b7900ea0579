//! Rays through a snapshot.

mod build;
mod bvh;
mod cast;
mod scene;

pub(crate) use bvh::Ray;
pub use cast::{RayCaster, RayHit};
pub(crate) use scene::{Met, Tracer};
