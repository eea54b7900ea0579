//! Objects and apartments from a seed: the same bytes on every machine.
//!
//! [`Apartment::from_seed`] makes a home: rooms with doors and windows, furniture,
//! small things where people keep them. [`Apartment::generate`] makes one after a
//! [`Specification`], or says which wish cannot be met. [`Apartment::scene`] is its
//! scene graph with poses, relations, states and assets, [`Apartment::check`] lists
//! whatever is wrong with it (nothing, for those that are returned), and
//! `Apartment::floor_plan` draws it. [`Layout`] is rooms and furniture alone, as boxes.
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
//! [`object::generator`] finds the generator of a class, [`catalogue`] lists instances
//! of all of them, [`dress`] makes scenes of boxes look like homes, and [`gltf`] writes any asset or scene and
//! reads models from elsewhere.

#![warn(clippy::disallowed_methods)]

mod apartment;
mod bits;
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
