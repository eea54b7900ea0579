//! Objects and apartments from a seed.

pub mod material;
pub mod object;
mod style;

pub use style::Style;
