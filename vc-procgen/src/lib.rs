//! Objects and apartments from a seed.

mod apartment;
mod bits;
pub mod catalogue;
pub mod check;
mod clutter;
mod error;
mod fingerprint;
pub mod furnish;
pub mod gltf;
pub mod material;
pub mod object;
pub mod picture;
pub mod plan;
mod reach;
mod scene;
mod specification;
pub mod statistics;
mod structure;
mod style;

pub use apartment::Apartment;
pub use error::Impossible;
pub use fingerprint::Fingerprint;
pub use specification::Specification;
pub use style::Style;
