//! Ground-truth labels, read from the visible triangle of every pixel.

mod amodal;
mod boxes;
mod depth;
mod flow;
mod hidden;
mod ids;
mod normal;

pub(crate) use amodal::amodal;
pub(crate) use boxes::{Tally, boxes};
pub(crate) use depth::depths;
pub(crate) use flow::{Motions, flows};
pub(crate) use hidden::{Faces, Other, hidden};
pub(crate) use ids::{Run, ids, runs};
pub(crate) use normal::{Bent, bent, normals};
