//! The trunk's motion for a reaching hand: it bends, turns, leans forward, squats or rises on its toes.

use nalgebra::{Point3, UnitQuaternion, Vector3};
use vc_graph::Pose;

use super::ADULT;
use super::activity::Activity;
use super::bone::{ARM, BodySide, Bone, LEG};
use super::skeleton::{FOREARM, STRETCH, about, pitch, wrist};

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

/// A point that an arm of a length is to reach, metres.
#[derive(Debug, Clone, Copy)]
struct Stretch {
    side: BodySide,
    point: Point3<f32>,
    arm: f32,
}

impl TrunkBend {
    /// The stoop for what a body does with its hands. The hips of a seated figure stay where they are.
    pub(super) fn of(activity: &Activity, seat: Option<Pose>) -> Self {
        let placed = BodySide::BOTH.into_iter().zip(activity.palms);
        let mut all: Vec<Stretch> = placed.filter_map(|(side, palm)| Some(Stretch::to_wrist(side, &palm?))).collect();
        let share = activity.reach.filter(|_| all.is_empty()).map_or(1.0, |reach| reach.share);
        all.extend(activity.reach.filter(|_| all.is_empty()).map(|reach| Stretch::to_palm(&reach)));
        Self::to(&all, seat).scaled(share)
    }

    /// The smallest stoop with which the hands reach their points, or the one that brings them nearest.
    fn to(all: &[Stretch], seat: Option<Pose>) -> Self {
        let tried = (0..=3 * STEPS).flat_map(|i| WAYS.map(|(end, stages)| end.after(i, stages)));
        let tried = tried.map(|stoop| match seat {
            Some(_) => Self { lean: 0.0, rise: 0.0, ..stoop },
            None => stoop,
        });
        // The shoulder of the hand that reaches comes forward; two hands leave the trunk straight.
        let side: f32 = all.iter().map(|to| -to.side.sign()).sum();
        let tried = tried.map(|stoop| Self { twist: side * stoop.twist, ..stoop });
        let far = |stoop: &Self, to: &Stretch| (to.point - stoop.shoulder(to.side, seat.as_ref())).norm().max(to.arm);
        let short = |stoop: &Self| all.iter().map(|to| far(stoop, to)).sum::<f32>();
        tried.min_by(|a, b| short(a).total_cmp(&short(b))).unwrap_or_default()
    }

    fn scaled(self, share: f32) -> Self {
        let Self { bend, twist, lean, rise } = self;
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

impl Stretch {
    fn to_palm(reach: &Reach) -> Self {
        Self { side: reach.side, point: reach.point, arm: (ARM[0] + ARM[1]) * STRETCH }
    }

    /// A palm with an orientation is reached by its wrist.
    fn to_wrist(side: BodySide, palm: &Pose) -> Self {
        Self { side, point: wrist(side, palm), arm: (ARM[0] + FOREARM) * STRETCH }
    }
}
