//! Procedural generation of objects and apartments from a seed: the same bytes on every machine.
//!
//! [`Apartment::from_seed`] generates a home: rooms with doors and windows, furniture, and clutter in its
//! habitual places. [`Apartment::generate`] generates one for a [`Specification`], or reports the
//! requirement that cannot be fulfilled. [`Apartment::scene`] is its scene graph with poses, relations, states
//! and assets, [`Apartment::check`] lists its violations (none for the apartments returned), and
//! `Apartment::floor_plan` draws it. [`Layout`] has only the rooms and the furniture, as boxes.
//!
//! ```
//! use vc_graph::Seed;
//! use vc_procgen::{Apartment, Specification};
//! let wishes = Specification { bedrooms: Some(2), study: Some(true), ..Specification::default() };
//! let home = Apartment::generate(&wishes, Seed(7))?;
//! assert!(home.check().is_empty());
//! assert!(home.scene().of_class("bed").len() >= 2);
//! # Ok::<(), vc_procgen::Impossible>(())
//! ```
//!
//! [`object::generator`] finds the generator of a class, [`catalogue`] enumerates instances of all classes,
//! [`dress`] gives scenes of boxes the look of homes, and [`gltf`] exports any asset or scene and imports
//! models from elsewhere.

#![warn(clippy::disallowed_methods)]

mod apartment;
pub mod catalogue;
pub mod check;
mod clutter;
pub mod dress;
mod error;
mod fingerprint;
pub mod furnish;
pub mod gltf;
mod layout;
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
pub use layout::Layout;
pub use specification::Specification;
pub use style::Style;
