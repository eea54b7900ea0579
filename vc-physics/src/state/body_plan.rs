//! The build and the posture of an agent.

use rapier3d::geometry::{InteractionGroups, SharedShape};
use rapier3d::math::{Pose as EnginePose, Vector};
use serde::{Deserialize, Serialize};
use vc_graph::{Anthropometry, NodeId};

use crate::group;

/// The person whose measures agents have.
pub(crate) const ADULT: Anthropometry = Anthropometry::ADULT;

/// The largest force with which a body pushes and pulls, newtons.
pub(crate) const PUSH: f32 = 150.0;

/// The build of an agent and its physical limits.
///
/// ```
/// use vc_physics::BodyPlan;
/// let child = BodyPlan { height: 1.2, ..BodyPlan::default() };
/// assert!(child.eye() < 1.2 && child.shoulder() < child.eye());
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct BodyPlan {
    /// Height, metres.
    pub height: f32,
    /// Radius of the capsule, metres.
    pub radius: f32,
    /// Distance from the shoulder to the middle of the hand, arm stretched, metres.
    pub reach: f32,
    /// Highest step it climbs, metres.
    pub step: f32,
    /// Steepest slope it climbs, radians.
    pub slope: f32,
    /// Heaviest thing it carries in one hand, kilograms.
    pub carries: f32,
    /// Heaviest thing it pushes aside when it walks, kilograms.
    pub pushes: f32,
    /// Walking speed, metres a second.
    pub walk: f32,
    /// Running speed, metres a second.
    pub run: f32,
}

impl Default for BodyPlan {
    /// A grown-up person.
    fn default() -> Self {
        Self {
            height: ADULT.stature,
            radius: ADULT.radius,
            reach: ADULT.reach,
            step: ADULT.climbs,
            slope: 0.7,
            carries: 15.0,
            pushes: 25.0,
            walk: 1.2,
            run: 3.0,
        }
    }
}

impl BodyPlan {
    /// Horizontal reach of a standing body from the middle of its feet, metres.
    pub fn stretch(&self) -> f32 {
        self.reach + ADULT.lean
    }

    /// Height of the shoulders above the feet, metres.
    pub fn shoulder(&self) -> f32 {
        ADULT.shoulder * self.height
    }

    /// Height of the eyes above the feet, metres.
    pub fn eye(&self) -> f32 {
        ADULT.eye * self.height
    }

    /// The capsule of a body in a posture, its pose relative to the feet or the seat, and its collision groups.
    pub(crate) fn body(&self, posture: Posture) -> (SharedShape, EnginePose, InteractionGroups) {
        let (half, middle) = (self.height / 2.0 - self.radius, self.height / 2.0);
        let above = |z: f32| EnginePose::from_translation(Vector::new(0.0, 0.0, z));
        match posture {
            Posture::Standing => (SharedShape::capsule_z(half, self.radius), above(middle), group::agent()),
            Posture::Sitting(..) => {
                let middle = ADULT.sitting * self.height / 2.0;
                let half = (middle - self.radius).max(0.01);
                (SharedShape::capsule_z(half, self.radius), above(middle), group::seated())
            }
            Posture::Lying(..) => (SharedShape::capsule_x(half, self.radius), above(self.radius), group::seated()),
        }
    }

    pub(crate) fn is_sound(&self) -> bool {
        let all = [self.height, self.radius, self.reach, self.step, self.slope, self.carries, self.pushes];
        let speeds = [self.walk, self.run];
        all.into_iter().chain(speeds).all(|v| v.is_finite() && v > 0.0) && self.height > 2.0 * self.radius
    }
}

/// The posture of an agent's body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Posture {
    /// It stands or walks.
    Standing,
    /// It sits on a place of a node.
    Sitting(NodeId, u32),
    /// It lies on a place of a node.
    Lying(NodeId, u32),
}

impl Posture {
    /// The posture as a word.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Standing => "standing",
            Self::Sitting(..) => "sitting",
            Self::Lying(..) => "lying",
        }
    }

    pub(crate) fn seat(self) -> Option<(NodeId, u32)> {
        match self {
            Self::Standing => None,
            Self::Sitting(id, place) | Self::Lying(id, place) => Some((id, place)),
        }
    }
}
