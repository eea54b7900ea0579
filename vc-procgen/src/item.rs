//! Placed objects, and their supports.

use std::sync::Arc;

use nalgebra::{Point3, Translation3, UnitQuaternion, Vector3};
use vc_graph::{Pose, Seed, State};
use vc_shapes::object::Object;

use crate::area::{Area, Facing};

/// The support of an item.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Support {
    /// The floor.
    Floor,
    /// A wall: the item is fixed to it.
    Wall,
    /// The ceiling: the item hangs from it.
    Ceiling,
    /// The item is part of the building, such as doors and windows.
    Built,
    /// On another item: its index, and that of the surface in its asset's list.
    On(usize, usize),
    /// Inside another item, on one of its surfaces.
    Inside(usize, usize),
}

/// A placed object.
///
/// ```
/// use vc_graph::Seed;
/// use vc_procgen::{Layout, Specification};
/// let layout = Layout::generate(&Specification::with_bedrooms(1), Seed(1))?;
/// let bed = layout.furniture.iter().find(|item| item.object.class.ends_with("bed")).ok_or("no bed")?;
/// let (low, high) = bed.corners();
/// assert!(low.z.abs() < 0.01 && high.z > 0.2);
/// assert_eq!(layout.plan.rooms[bed.room].kind.class(), "bedroom");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Item {
    /// The object with its asset.
    pub object: Arc<Object>,
    /// The pose.
    pub pose: Pose,
    /// The support.
    pub support: Support,
    /// The index of its room in the plan.
    pub room: usize,
    /// Its states in addition to the initial ones of its class.
    pub states: Vec<State>,
    /// For a door, the other room it belongs to.
    pub between: Option<usize>,
    /// Whether its room requires it.
    pub required: bool,
}

impl Item {
    /// Its bounding box: smallest and largest corner, metres.
    pub fn corners(&self) -> (Point3<f32>, Point3<f32>) {
        let aabb = self.object.bounds.aabb(&self.pose);
        (aabb.min, aabb.max)
    }

    /// Its footprint seen from above, metres.
    pub fn area(&self) -> Area {
        let (low, high) = self.corners();
        Area { x0: low.x, y0: low.y, x1: high.x, y1: high.y }
    }

    /// Its own seed, by class and place: what else a home has does not change it.
    pub(crate) fn seed(&self, of: Seed) -> Seed {
        let place = self.pose.translation.vector.map(|metres| u64::from(metres.to_bits()));
        place.iter().fold(of.child(self.object.class), |seed, number| seed.nth(*number))
    }

    /// The item moved.
    pub(crate) fn moved(self, by: [f32; 3]) -> Self {
        Self { pose: Translation3::from(by) * self.pose, ..self }
    }

    /// The direction of its front, if it is aligned with an axis.
    pub fn facing(&self) -> Facing {
        let front = self.pose.rotation * Vector3::x();
        match (front.x.abs() >= front.y.abs(), front.x >= 0.0, front.y >= 0.0) {
            (true, true, _) => Facing(0),
            (true, false, _) => Facing(2),
            (false, _, true) => Facing(1),
            (false, _, false) => Facing(3),
        }
    }
}

/// The pose of an object whose bounding box is centred above a point, its base at `z`.
pub(crate) fn standing(object: &Object, centre: (f32, f32), z: f32, yaw: f32) -> Pose {
    let turn = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), yaw);
    let bounds = &object.bounds;
    let offset = turn * Vector3::new(bounds.offset.x, bounds.offset.y, 0.0);
    let base = bounds.offset.z - bounds.half.z;
    Pose::from_parts(Vector3::new(centre.0 - offset.x, centre.1 - offset.y, z - base).into(), turn)
}
