//! Procedural objects: a generator for each class, the table of materials, and styles; the same bytes on every
//! machine.
//!
//! A generator makes an [`Asset`](vc_graph::Asset) of a class from a size, a [`Style`] and a seed: parts with
//! joints, and surfaces on which other things can be put. Nothing is loaded from files.
//!
//! ```
//! use vc_graph::Seed;
//! use vc_shapes::{Style, object};
//! let seed = Seed(7);
//! let chair = object::generator("chair").ok_or("no generator")?.object(&Style::from_seed(seed), seed);
//! assert!(chair.size().z > 0.6);
//! assert!(chair.asset.parts.iter().any(|part| &*part.name == "seat"));
//! # Ok::<(), &str>(())
//! ```
//!
//! [`Generators::register`] adds an object class of your own. [`solid`] is the vocabulary from which generators build;
//! [`object`] has the built-in ones, [`catalogue`] enumerates instances of all classes, and
//! [`material::library`] is the library with the materials of all of them.

#![warn(clippy::disallowed_methods)]

pub mod catalogue;
mod facts;
pub mod material;
pub mod object;
pub mod solid;
mod style;

pub use object::{Generator, Generators, Object, Realm, RegisterError};
pub use solid::{Axis, Build};
pub use style::Style;
