//! Small vectors and maps of space, sample points, and loops for the processor's vector instructions.

mod affine;
mod bounds;
mod sampling;
pub(crate) mod simd;
mod vector;

pub(crate) use affine::{Affine, Narrow, composed, normal, point, vector};
pub(crate) use bounds::{Ball, Bounds};
pub(crate) use sampling::{basis, cosine_weighted, low_discrepancy};
pub(crate) use vector::{cross, dot, longest, scaled, three, unit, volume};
