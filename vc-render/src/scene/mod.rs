//! What is to be seen: bodies and where they are.

mod body;
mod change;
mod classes;
mod cover;
mod extent;
mod liquid;
mod snapshot;
mod store;
mod untied;

pub(crate) use body::{Body, Instance, NO_ROOM, Stands, turned};
pub use snapshot::Snapshot;
pub(crate) use store::Store;
