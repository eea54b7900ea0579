//! Procedural generation of apartments and small buildings from a seed: the same bytes on every machine.
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
//! # Ok::<(), vc_procgen::SpecificationError>(())
//! ```
//!
//! [`Building`] is a plan of regions, homes among them, and makes the scene of each. [`city`] plans cities: streets, blocks,
//! parcels, buildings with their units. [`House`] is one of these as regions, and [`Outdoors`] makes scenes of streets.
//!
//! Objects, materials and [`Style`](vc_shapes::Style)s are those of [`vc_shapes`]; [`dress`] gives shapes to scenes
//! of boxes.

#![warn(clippy::disallowed_methods)]

mod apartment;
mod area;
mod building;
mod check;
mod circulation;
pub mod city;
mod clutter;
mod draft;
pub mod dress;
mod dressing;
mod error;
mod facade;
mod fingerprint;
mod furnish;
mod generate;
mod house;
mod item;
mod layout;
mod outdoors;
pub mod picture;
pub mod plan;
mod reach;
mod room_kind;
mod scene;
mod solids;
mod specification;
pub mod statistics;
mod structure;
mod violation;

pub use apartment::Apartment;
pub use area::{Area, Facing};
pub use building::{Building, BuildingError, BuildingSpecification, BuildingStorey, BuildingViolation};
pub use dressing::{Dressing, DressingError, DressingFault};
pub use error::SpecificationError;
pub use fingerprint::{Fingerprint, FingerprintError};
pub use house::{House, HouseError, HouseStorey};
pub use item::{Item, Support};
pub use layout::Layout;
pub use outdoors::{Outdoors, OutdoorsError};
pub use specification::Specification;
pub use violation::{ApartmentViolation, ItemLabel};
