//! Rasterization into a visibility buffer: the visible triangle at every pixel.
//!
//! Clusters of triangles are culled against the frustum, by the cone of their normals and against a coarse
//! depth buffer (Greene, Kass and Miller 1993), nearest bodies first. Vertices are snapped to 1/256 pixel, and
//! edge functions (Pineda 1988) are integers with a tie-breaking rule, so triangles that share an edge leave no
//! gap and do not overlap. Depth is stored as its inverse, which is linear in the image, and the triangle as
//! its number (a visibility buffer, Burns and Hunt 2013).

mod clip;
mod cull;
mod draw;
mod fill;
mod project;
mod setup;
mod target;

pub(crate) use cull::Frustum;
pub(crate) use draw::{Drawing, Layers};
pub(crate) use target::{NONE, Solid, Target, Visible, refill};
