//! Light: sun, sky, lamps, and indirect light in rooms.
//!
//! Radiance is in units of an overcast sky's, about 5000 candela per square metre.

mod ambient;
mod cloth;
mod even;
mod extent;
mod flux;
mod follow;
mod grid;
mod lamp;
mod lighting;
mod lookup;
mod meter;
mod pane;
mod penumbra;
mod room;
mod shadow;
mod side;
mod sky;
mod source;

pub(crate) use ambient::Ambient;
pub(crate) use cloth::through;
pub(crate) use lamp::Lamp;
pub use lighting::Lighting;
pub(crate) use lookup::Points;
pub(crate) use meter::{Patch, Spot};
pub(crate) use pane::{INDEX, fresnel, passes, straight, tint};
pub use sky::Daylight;
pub use source::Source;
