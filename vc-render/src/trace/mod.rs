//! Rays through a snapshot.

mod build;
mod bvh;
mod scene;

pub(crate) use bvh::Ray;
pub(crate) use scene::{Met, Tracer};
