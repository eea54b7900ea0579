//! Readers and writers for tasks and goals, in the formats of others and our own.
//!
//! | module | contents |
//! |---|---|
//! | [`thesis`] | a predicate and its count: `On(apple, kitchentable), 3` |
//! | [`bddl`] | activities of BEHAVIOR: objects, initial facts, the goal |
//! | [`watch_and_help`] | goals of Watch-And-Help: `{"on_plate_kitchentable": 2}` |
//! | [`eai`] | goals and formulas of the Embodied Agent Interface |
//! | [`alfred`] | the seven types of tasks of ALFRED |
//! | [`pddl`] | domains, problems and plans |
//! | [`json`] | our own file format for tasks |
//! | [`sexpr`] | the s-expressions of BDDL and PDDL |
//!
//! [`vc_graph::Goal`] itself reads and writes goals in our own notation.
//!
//! No reader panics or recurses without bound; the size of the result is proportional to that of
//! the text. Every error is a [`ReadError`] with the place, what was expected and what was found. A
//! writer refuses a goal that its format cannot express ([`Unwritable`]); the text it writes reads
//! back as an equal goal.

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
