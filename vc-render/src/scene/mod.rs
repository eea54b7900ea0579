//! The scene as the renderer holds it: bodies and their poses.

mod body;
mod change;
mod classes;
mod cover;
mod extent;
mod join;
mod liquid;
mod snapshot;
mod store;
mod untied;

pub(crate) use body::{Body, Gives, Ground, Instance, NO_ROOM, Stands};
pub use snapshot::Snapshot;
pub(crate) use store::{MOST_SURFACES, Store};
