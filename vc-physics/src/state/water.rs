//! Still water: boxes of it, and the fill levels of containers.

use std::collections::BTreeMap;

use nalgebra::Point3;
use serde::{Deserialize, Serialize};
use vc_graph::hash::Digester;
use vc_graph::{Aabb, NodeId, Pose};

use crate::{PhysicsError, convert};

/// The largest depth of a body's centre below the bottom of the water, metres: the engine lets bodies on the
/// bottom sink in by some millimetres.
const BELOW: f32 = 0.05;

/// Still water in an upright box that may be rotated around the vertical; its surface is level.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct Water {
    /// Middle of its bottom.
    #[serde(with = "crate::serial::pose")]
    at: Pose,
    /// Half its lengths along X and Y, and its depth, metres.
    size: [f32; 3],
    /// The container that holds it.
    pub(crate) container: Option<NodeId>,
}

impl Water {
    pub(crate) fn new(at: Pose, size: [f32; 3], container: Option<NodeId>) -> Result<Self, PhysicsError> {
        let sound = convert::is_sound(&at) && size.iter().all(|s| s.is_finite() && *s > 0.0);
        let water = Self { at, size, container };
        if sound { Ok(water) } else { Err(PhysicsError::BadWater("its box is empty or not finite")) }
    }

    pub(crate) fn holds(&self, p: &Point3<f32>) -> bool {
        let p = self.at.inverse_transform_point(p);
        (0..2).all(|i| p[i].abs() <= self.size[i]) && p.z >= -BELOW
    }

    /// Height of its surface, metres.
    pub(crate) fn level(&self) -> f32 {
        self.at.translation.z + self.size[2]
    }

    /// The box around it along the world's axes.
    pub(crate) fn aabb(&self) -> Aabb {
        let [x, y, depth] = self.size;
        let sides = [(-x, -y), (-x, y), (x, -y), (x, y)];
        let corners = sides.iter().flat_map(|&(x, y)| [0.0, depth].map(|z| self.at * Point3::new(x, y, z)));
        let empty = (Point3::from([f32::INFINITY; 3]), Point3::from([f32::NEG_INFINITY; 3]));
        let (min, max) = corners.fold(empty, |(low, high), p| (low.inf(&p), high.sup(&p)));
        Aabb { min, max }
    }

    /// Adds the data that determine its forces to a hash.
    pub(crate) fn feed(&self, hash: &mut Digester) {
        hash.reals(self.at.translation.vector.iter().copied());
        hash.reals(self.at.rotation.coords.iter().copied());
        hash.reals(self.size);
    }
}

/// All water of a world.
#[derive(Clone, Default, Serialize, Deserialize)]
pub(crate) struct Waters {
    /// In the order in which it was added.
    pub(crate) all: Vec<Water>,
    /// The fill levels of containers, 0 to 1.
    pub(crate) levels: BTreeMap<NodeId, f32>,
}

impl Waters {
    /// The fill level of a container, 0 to 1; 0 if nobody has filled it.
    pub(crate) fn level(&self, container: NodeId) -> f32 {
        self.levels.get(&container).copied().unwrap_or(0.0)
    }

    /// The water around a point.
    pub(crate) fn around(&self, point: &Point3<f32>) -> Option<&Water> {
        self.all.iter().find(|water| water.holds(point))
    }

    /// Removes the water from a container; returns whether bodies may have been in it.
    pub(crate) fn drain(&mut self, container: NodeId) -> bool {
        self.levels.remove(&container);
        let before = self.all.len();
        self.all.retain(|water| water.container != Some(container));
        self.all.len() < before
    }

    /// Adds the levels, and the data that determine forces, to a hash.
    pub(crate) fn feed(&self, hash: &mut Digester) {
        for (id, level) in &self.levels {
            hash.word(u64::from(id.0));
            hash.reals([*level]);
        }
        self.all.iter().for_each(|water| water.feed(hash));
    }
}
