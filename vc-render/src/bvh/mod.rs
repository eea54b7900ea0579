//! Bounding volume hierarchies: trees of triangles or boxes for ray casting.

mod build;
mod tree;
mod walk;

pub(crate) use build::over;
pub(crate) use tree::{Bvh, Hit, Node, Ray};
pub(crate) use walk::{Beam, walk};
