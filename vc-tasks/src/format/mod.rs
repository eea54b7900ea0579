//! Tasks and goals as others and we write them.
//!
//! | module | what |
//! |---|---|
//! | [`thesis`] | a predicate and how often: `On(apple, kitchentable), 3` |
//! | [`bddl`] | activities of BEHAVIOR: objects, what holds at the start, the goal |
//! | [`watch_and_help`] | goals of Watch-And-Help: `{"on_plate_kitchentable": 2}` |
//! | [`eai`] | goals and formulas of the Embodied Agent Interface |
//! | [`alfred`] | the seven types of tasks of ALFRED |
//! | [`pddl`] | domains, problems and plans |
//! | [`json`] | our own file of tasks |
//! | [`sexpr`] | the bracketed text BDDL and PDDL are made of |
//!
//! Goals in our own notation are read and written by [`vc_graph::Goal`] itself.
//!
//! No reader panics or recurses without bound; what is built is proportional to
//! the text. Every error is a [`ReadError`]: it says where, what was expected and
//! what was found. A writer refuses what its format has no word for
//! ([`Unwritable`]), and what it writes reads back equal.

pub mod alfred;
pub mod bddl;
pub mod eai;
mod error;
pub mod json;
pub mod pddl;
pub mod sexpr;
pub mod thesis;
pub mod watch_and_help;

pub use error::{ReadError, Unwritable};
