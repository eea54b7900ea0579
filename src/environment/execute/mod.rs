//! Actions as motions of bodies.
//!
//! The effects of the transition rule become [tasks](task), a [planner] makes motions of them by the world as it is, and
//! [bodies](perform) do those. The next ones are planned when they are done. The planner's parts: [`stand`] is about
//! where to stand, [`open`] about doors and drawers, [`put`] about hands, [`spot`] about where there is room, [`steady`]
//! about what would not stay where it was put, [`rest`] about seats, and [`aim`] about the
//! points, headings, slots and sides that an action asks for.

mod aim;
mod open;
mod perform;
mod planner;
mod put;
mod rest;
mod spot;
mod stand;
mod steady;
mod step;
mod task;

use nalgebra::{UnitQuaternion, Vector2, Vector3};

pub(super) use aim::off_aim;
pub(super) use open::WIDE;
pub(super) use perform::Bodies;
pub(super) use planner::{Plan, Planner};
pub(super) use put::{comes_along, load_of};
pub(super) use spot::FreeSpot;
pub(super) use stand::APART;
pub(super) use step::Step;
pub(super) use task::Task;

/// The rotation around the vertical that turns X to the given direction.
pub(in crate::environment) fn towards(way: Vector2<f32>) -> UnitQuaternion<f32> {
    use vc_graph::portable::Portable;
    UnitQuaternion::from_axis_angle(&Vector3::z_axis(), way.y.angle_to(way.x))
}
