//! Frames: where a region is in the world, and how it is turned.

use nalgebra::{Isometry3, Point3, Translation3, UnitQuaternion, Vector3};

use crate::Pose;
use crate::portable::Portable;

/// The origin and heading of a region in the world. Poses in a region are `f32` from this origin, so that a kitchen four
/// kilometres away is as exact as one at zero; frames are `f64` and stand upright.
///
/// ```
/// use vc_graph::Pose;
/// use vc_graph::space::RegionFrame;
/// let (home, street) = (RegionFrame::new([4000.0, 0.0, 3.0], 0.0), RegionFrame::new([4000.0, 5.0, 0.0], 0.0));
/// let seen = home.to(&street) * Pose::translation(1.0, 0.0, 0.0);
/// assert_eq!(seen.translation.vector.as_slice(), [1.0, -5.0, 3.0]);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(from = "([f64; 3], f64)", into = "([f64; 3], f64)")]
pub struct RegionFrame {
    /// The origin, metres.
    pub origin: Point3<f64>,
    /// The direction of its X axis, radians to the left of the world's.
    pub heading: f64,
}

impl RegionFrame {
    /// The world's own frame.
    pub const WORLD: Self = Self { origin: Point3::new(0.0, 0.0, 0.0), heading: 0.0 };

    /// A frame at an origin, metres, turned by a heading, radians.
    pub fn new(origin: [f64; 3], heading: f64) -> Self {
        Self { origin: origin.into(), heading }
    }

    /// The frame of which this one is inside another: a flat's in its building's.
    #[must_use]
    pub fn within(&self, outer: &Self) -> Self {
        Self { origin: outer.point(&self.origin), heading: outer.heading + self.heading }
    }

    /// A point of this frame in the world.
    pub fn point(&self, point: &Point3<f64>) -> Point3<f64> {
        self.origin + turned(self.heading, &point.coords)
    }

    /// A pose in this frame as one in the world.
    pub fn pose(&self, pose: &Pose) -> Isometry3<f64> {
        self.isometry() * nalgebra::convert::<_, Isometry3<f64>>(*pose)
    }

    /// The transformation that takes poses of this frame to another frame. It is worked out in `f64`, and exact to
    /// `f32` of the distance between the two, wherever both are.
    pub fn to(&self, other: &Self) -> Pose {
        let between = turned(-other.heading, &(self.origin - other.origin));
        let turn = rotation(self.heading - other.heading);
        nalgebra::convert::<Isometry3<f64>, Pose>(Isometry3::from_parts(Translation3::from(between), turn))
    }

    /// Whether all its numbers are finite.
    pub fn is_finite(&self) -> bool {
        self.heading.is_finite() && self.origin.iter().all(|value| value.is_finite())
    }

    fn isometry(&self) -> Isometry3<f64> {
        Isometry3::from_parts(self.origin.coords.into(), rotation(self.heading))
    }
}

/// Origin and heading.
impl From<([f64; 3], f64)> for RegionFrame {
    fn from((origin, heading): ([f64; 3], f64)) -> Self {
        Self::new(origin, heading)
    }
}

impl From<RegionFrame> for ([f64; 3], f64) {
    fn from(frame: RegionFrame) -> Self {
        (frame.origin.coords.into(), frame.heading)
    }
}

impl Default for RegionFrame {
    fn default() -> Self {
        Self::WORLD
    }
}

fn turned(heading: f64, vector: &Vector3<f64>) -> Vector3<f64> {
    let (sine, cosine) = heading.sine_cosine();
    Vector3::new(cosine * vector.x - sine * vector.y, sine * vector.x + cosine * vector.y, vector.z)
}

/// The turn by a heading about the upward axis.
fn rotation(heading: f64) -> UnitQuaternion<f64> {
    let (sine, cosine) = (heading / 2.0).sine_cosine();
    UnitQuaternion::new_unchecked(nalgebra::Quaternion::new(cosine, 0.0, 0.0, sine))
}
