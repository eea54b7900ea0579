//! The ways within buildings: stairs and lifts, with the parts that they are made of.

pub(crate) mod cabin;
pub(crate) mod lift;
mod looks;
pub(crate) mod parts;
pub(crate) mod rail;
pub(crate) mod stairs;

pub(crate) use looks::Looks;
