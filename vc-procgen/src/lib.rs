//! Objects and apartments from a seed.

pub mod catalogue;
mod error;
pub mod material;
pub mod object;
pub mod picture;
pub mod plan;
mod specification;
mod style;

pub use error::Impossible;
pub use specification::Specification;
pub use style::Style;
