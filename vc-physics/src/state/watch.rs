//! The watch over a thing that may be at rest: how long it has been at about the same pose.

use nalgebra::Point3;
use rapier3d::math::{Pose as EnginePose, Vector};
use serde::{Deserialize, Serialize};

/// The largest distance of a thing that counts as not moved, metres.
pub(crate) const ABOUT: f32 = 0.02;

/// Number of checks after which a trembling thing may sleep.
const CHECKS: u8 = 4;

/// Minimal and maximal corner of a thing in its own frame.
type Extent = (Point3<f32>, Point3<f32>);

/// The pose of a thing.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Spot(EnginePose);

impl Spot {
    pub(crate) fn new(pose: &EnginePose) -> Self {
        Self(*pose)
    }

    /// The largest distance of a corner of a thing from its position at another spot, metres. For a rotation
    /// about the thing's axis this is at most its diagonal across the axis.
    pub(crate) fn distance(&self, other: &Self, (low, high): Extent) -> f32 {
        let corner =
            |i: usize| Vector::from_array(std::array::from_fn(|k| if i >> k & 1 == 0 { low[k] } else { high[k] }));
        let far = |p: Vector| (self.0 * p).distance(other.0 * p);
        (0..8).map(|i| far(corner(i))).fold(0.0, f32::max)
    }
}

/// The spot at which a thing was first seen, if it has not gone far since or has been slow all the time, and
/// the number of checks since.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Watch {
    at: Spot,
    checks: u8,
}

impl Watch {
    /// Updates the watch with a thing's present pose.
    pub(crate) fn update(&mut self, pose: &EnginePose, extent: Extent, slow: bool) {
        let now = Spot::new(pose);
        if now.distance(&self.at, extent) > ABOUT {
            (self.at, self.checks) = (now, if slow { self.checks } else { 0 });
        }
        self.checks = self.checks.saturating_add(1);
    }

    /// Whether the thing has stayed in place, or been slow, for long enough.
    pub(crate) fn is_still(&self) -> bool {
        self.checks > CHECKS
    }
}
