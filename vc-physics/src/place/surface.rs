//! Surfaces of a world that hold things, and whether a thing is at one.

use nalgebra::{Point3, Vector3};
use vc_graph::asset::{Hold, Surface};
use vc_graph::{NodeId, Pose};

use super::way::TURNTABLE;
use super::{BESIDE, GAP};
use crate::state::Thing;
use crate::world::PhysicsWorld;

/// The largest height above a surface of the bottom of a thing that is on it, metres.
const LOW: f32 = 0.02;

/// A surface of a node that holds things, in the world's frame in the present state.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct SupportSurface {
    /// The node it belongs to.
    pub id: NodeId,
    /// Its position in the asset's list.
    pub surface: usize,
    /// How it holds things.
    pub hold: Hold,
    /// Its middle; X and Y along its sides.
    pub pose: Pose,
    /// Half lengths along its X and Y, metres.
    pub half: (f32, f32),
    /// Free height above it, metres, if something is above.
    pub clearance: Option<f32>,
}

impl SupportSurface {
    /// The height of a point above the surface, metres; `None` if it is below it or beside it.
    pub(crate) fn height_under(&self, point: &Point3<f32>) -> Option<f32> {
        let own = self.pose.inverse_transform_point(point);
        (own.x.abs() <= self.half.0 && own.y.abs() <= self.half.1 && own.z >= -GAP).then_some(own.z)
    }
}

/// # Surfaces that hold things
impl PhysicsWorld {
    /// The surfaces of a thing in the present state.
    pub(crate) fn surfaces(&self, thing: &Thing) -> Vec<SupportSurface> {
        (0..thing.form.surfaces.len()).filter_map(|s| self.surface_of(thing, s)).collect()
    }

    fn surface_of(&self, thing: &Thing, surface: usize) -> Option<SupportSurface> {
        let of: &Surface = thing.form.surfaces.get(surface)?;
        let moved = of.joint.map_or_else(Pose::identity, |j| self.part_motion(thing, &j));
        let pose =
            self.engine.pose(thing.state.base)? * moved * Pose::translation(of.centre.x, of.centre.y, of.centre.z);
        Some(SupportSurface { id: thing.id, surface, hold: of.hold, pose, half: of.half, clearance: of.clearance })
    }

    /// The surface of another thing on which a thing is, or the one over which it is inside the other.
    pub(crate) fn shelf_of(&self, thing: &Thing, at: NodeId, inside: bool) -> Option<SupportSurface> {
        let (aabb, pose) = (self.aabb(thing.id)?, self.pose(thing.id)?);
        let (low, high) = thing.form.extent;
        let middle = pose * nalgebra::center(&low, &high);
        let margin = if inside { -BESIDE } else { BESIDE };
        let over = |shelf: &SupportSurface, point: Point3<f32>, margin: f32| {
            let own = shelf.pose.inverse_transform_point(&point);
            let across = own.x.abs() <= shelf.half.0 + margin && own.y.abs() <= shelf.half.1 + margin;
            across.then_some(own.z)
        };
        let within = |shelf: &SupportSurface, point: Point3<f32>, margin: f32| {
            let top = shelf.clearance.unwrap_or(f32::INFINITY);
            over(shelf, point, margin).is_some_and(|height| (-GAP..=top).contains(&height))
        };
        let corner = |i: usize| {
            let at = |axis: usize| if i >> axis & 1 == 0 { low[axis] } else { high[axis] };
            pose * Point3::new(at(0), at(1), at(2))
        };
        // A thing that is wider than a turntable reaches over its edges.
        let reaches = |shelf: &SupportSurface| {
            let over = |half: f32, room: f32| (half - room).clamp(0.0, TURNTABLE.over * half);
            let half = (aabb.max - aabb.min) / 2.0;
            over(half.x.min(half.y), shelf.half.0.min(shelf.half.1))
                .max(over(half.x.max(half.y), shelf.half.0.max(shelf.half.1)))
        };
        let holds = |shelf: &SupportSurface| match shelf.hold {
            Hold::Inside => {
                let corners = (0..8).filter(|i| within(shelf, corner(*i), reaches(shelf))).count();
                inside && within(shelf, middle, margin) && corners >= 4
            }
            Hold::On => {
                let above = aabb.min.z - shelf.pose.translation.z;
                !inside && over(shelf, middle, margin).is_some() && above.abs() <= LOW
            }
            Hold::Hook => false,
        };
        self.surfaces(self.thing(at).ok()?).into_iter().find(holds)
    }

    /// The surfaces of a thing that hold things in a way.
    pub(crate) fn surfaces_that(&self, thing: &Thing, hold: Hold) -> Vec<SupportSurface> {
        let all = (0..thing.form.surfaces.len()).filter_map(|s| self.surface_of(thing, s));
        all.filter(|s| s.hold == hold).collect()
    }

    /// Whether nothing stands or lies on a surface.
    pub(super) fn is_bare(&self, shelf: &SupportSurface) -> bool {
        let half = Vector3::new(shelf.half.0, shelf.half.1, LOW / 2.0);
        self.is_free(half, &(shelf.pose * Pose::translation(0.0, 0.0, GAP + half.z)))
    }
}
