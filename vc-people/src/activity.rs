//! The activity and the posture of a body, from which its pose is made.

use nalgebra::Point3;
use vc_graph::{Motion, Pose};

use super::reach::Reach;
use super::skeleton::Skeleton;

/// The activity of a body beside standing, sitting or lying.
///
/// ```
/// use vc_people::{Activity, BodyPosture, Bone, BodySide, Skeleton};
/// // In the middle of a step the feet are at different places.
/// let walking = Activity { walked: Some(0.35), ..Activity::default() };
/// let skeleton = Skeleton::new(BodyPosture::Standing, &walking, [None, None]);
/// let ankle = |side| skeleton.motion(Bone::Foot(side)) * Bone::Foot(side).anchor();
/// assert!((ankle(BodySide::Left).x - ankle(BodySide::Right).x).abs() > 0.3);
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Activity {
    /// The distance walked so far, metres.
    pub walked: Option<f32>,
    /// A gesture, and the time since it began, seconds.
    pub gesture: Option<(Motion, f32)>,
    /// The point that it keeps in view while it stands.
    pub gaze: Option<Point3<f32>>,
    /// A reaching hand.
    pub reach: Option<Reach>,
    /// The poses of the palms of hands that are guided, the right one first: the middle of the palm, X along the fingers,
    /// Z out of the back of the hand. The trunk bends for them in place of `reach`.
    pub palms: [Option<Pose>; 2],
    /// The direction of a head that is turned on purpose: to the left and up from straight ahead, radians.
    pub head: Option<(f32, f32)>,
    /// The pose from which it comes into this one, and the share of the way done, 0 to 1.
    pub transition: Option<(Skeleton, f32)>,
}

/// The posture of a body, in its own frame: the origin is between the feet, or on the seat.
///
/// ```
/// use vc_people::{Activity, BodyPosture, Skeleton};
/// let height = |posture| Skeleton::new(posture, &Activity::default(), [None, None]).eyes().translation.z;
/// assert!(height(BodyPosture::Standing) > 1.5);
/// // The frame of a seated body is on the seat.
/// assert!(height(BodyPosture::Sitting(0.45)) < 1.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum BodyPosture {
    /// On its feet.
    Standing,
    /// On a seat at this height above the floor, metres.
    Sitting(f32),
    /// On its back.
    Lying,
}
