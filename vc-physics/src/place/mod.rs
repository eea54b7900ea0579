//! Placement: surfaces that hold things, free spots on them, overlaps, and things in one place.

mod close;
mod crowd;
mod fault;
mod former;
mod lower;
mod overlap;
mod raster;
mod search;
mod surface;
mod way;
mod wish;

pub use fault::SpotFault;
pub(crate) use overlap::{SKIN, distance};
pub use search::{Packing, SpotOrder, SpotSearch};
pub use surface::SupportSurface;
pub use wish::SpotWish;

/// Gap that is left between a thing and its support, metres: the thing is at rest after a millimetre's fall.
const GAP: f32 = 0.001;
/// Clearance around a thing that is put down, metres: rims of plates do not touch, which are wider than the polygons
/// that stand for them here.
const AROUND: f32 = 0.015;
/// How far beside a surface the middle of a thing may be that is on it, metres.
const BESIDE: f32 = 0.005;
