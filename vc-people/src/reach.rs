//! The trunk's motion for a reaching hand: it bends, turns, leans forward, squats or rises on its toes.

use nalgebra::{Point3, UnitQuaternion, Vector3};
use vc_graph::Pose;

use super::ADULT;
use super::bone::{ARM, BodySide, Bone, LEG};
use super::skeleton::{STRETCH, about, pitch};

/// Backward motion of the hips per metre of a squat.
const BACK: f32 = 0.2;
/// Number of steps in which each motion is tried.
const STEPS: usize = 16;

/// A reaching hand; the body bends as far as necessary, and the eyes follow.
///
/// ```
/// use nalgebra::Point3;
/// use vc_people::{Activity, BodyPosture, BodySide, Bone, Reach, Skeleton, palm};
/// let point = Point3::new(0.5, -0.2, 1.1);
/// let reach = Reach { side: BodySide::Right, point, share: 1.0, gaze: 1.0 };
/// let activity = Activity { reach: Some(reach), ..Activity::default() };
/// let skeleton = Skeleton::new(BodyPosture::Standing, &activity, [None, None]);
/// let hand = skeleton.motion(Bone::Hand(BodySide::Right)) * palm(BodySide::Right);
/// assert!((hand - point).norm() < 0.02);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reach {
    /// The hand that reaches.
    pub side: BodySide,
    /// The point that it reaches for, in the body's frame.
    pub point: Point3<f32>,
    /// Progress of the hand, 0 to 1.
    pub share: f32,
    /// Progress of the eyes' turn towards the point, 0 to 1.
    pub gaze: f32,
}

/// The configuration of the trunk for a reaching hand.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct TrunkBend {
    /// Radians, at the waist and around the spine.
    pub(super) bend: f32,
    twist: f32,
    /// Motion of the hips forward and up, metres.
    lean: f32,
    rise: f32,
}

/// The variants of stooping: their end configurations, and the stages in which the hips move forward and
/// vertically; bending and turning happen in the first stage.
const WAYS: [(TrunkBend, [usize; 2]); 4] = [
    // Squat, then lean; or lean first.
    (LOWEST, [2, 1]),
    (LOWEST, [1, 2]),
    // On the toes, upright or bent over something.
    (TrunkBend { bend: 0.0, rise: ADULT.tiptoe, ..LOWEST }, [1, 0]),
    (TrunkBend { bend: ADULT.bend / 2.0, rise: ADULT.tiptoe, ..LOWEST }, [1, 0]),
];
const LOWEST: TrunkBend = TrunkBend { bend: ADULT.bend, twist: ADULT.twist, lean: ADULT.sway, rise: -ADULT.squat };

impl TrunkBend {
    /// The smallest stoop with which the hand reaches a point, or the one that brings the hand nearest. The
    /// hips of a seated figure stay where they are.
    pub(super) fn to(reach: &Reach, seat: Option<Pose>) -> Self {
        let length = (ARM[0] + ARM[1]) * STRETCH;
        let tried = (0..=3 * STEPS).flat_map(|i| WAYS.map(|(end, stages)| end.after(i, stages)));
        let tried = tried.map(|stoop| match seat {
            Some(_) => Self { lean: 0.0, rise: 0.0, ..stoop },
            None => stoop,
        });
        let tried = tried.map(|stoop| Self { twist: -reach.side.sign() * stoop.twist, ..stoop });
        let short = |stoop: &Self| (reach.point - stoop.shoulder(reach.side, seat.as_ref())).norm().max(length);
        let best = tried.min_by(|a, b| short(a).total_cmp(&short(b)));
        let Self { bend, twist, lean, rise } = best.unwrap_or_default();
        let share = reach.share;
        Self { bend: bend * share, twist: twist * share, lean: lean * share, rise: rise * share }
    }

    /// The intermediate configuration after a number of steps.
    fn after(self, steps: usize, [forward, up]: [usize; 2]) -> Self {
        let share = |stage: usize| (steps.saturating_sub(stage * STEPS) as f32 / STEPS as f32).min(1.0);
        let Self { bend, twist, lean, rise } = self;
        Self { bend: bend * share(0), twist: twist * share(0), lean: lean * share(forward), rise: rise * share(up) }
    }

    /// The motion of a standing figure's hips that keeps the feet on the floor.
    pub(super) fn hips(&self) -> Vector3<f32> {
        let forward = self.lean + BACK * self.rise.min(0.0);
        let (leg, bent) = (LEG[0] + LEG[1], (LEG[0] + LEG[1]) * STRETCH);
        let lowest = (bent * bent - forward * forward).max(0.0).sqrt() - leg;
        Vector3::new(forward, 0.0, self.rise.min(lowest) + self.toes())
    }

    /// Height of the heels above the floor, metres.
    pub(super) fn toes(&self) -> f32 {
        self.rise.max(0.0)
    }

    /// The rotation of the chest.
    pub(super) fn chest(&self) -> UnitQuaternion<f32> {
        pitch(self.bend) * UnitQuaternion::from_axis_angle(&Vector3::z_axis(), self.twist)
    }

    fn shoulder(&self, side: BodySide, seat: Option<&Pose>) -> Point3<f32> {
        let bent = about(Bone::Chest.anchor(), self.chest()) * Bone::UpperArm(side).anchor();
        seat.map_or_else(|| bent + self.hips(), |seat| seat * bent)
    }
}
