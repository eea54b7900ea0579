//! Poses: from what a body does to where its bones are.

use nalgebra::{Point3, UnitQuaternion, Vector3};
use vc_graph::portable::Portable;
use vc_graph::{Pose, Verb};

use super::bone::{ANKLE, BodySide, Bone, LEG};
use super::reach::{Reach, TrunkBend};
use super::shape::palm;
use super::skeleton::{Skeleton, pitch};

/// Length of a step of two feet, metres.
const STRIDE: f32 = 1.4;
/// How far a head turns to the side, and up or down, radians.
const NECK: (f32, f32) = (1.2, 1.4);
/// How much of the way a free arm comes to hang straight down from a bent trunk.
const HANGS: f32 = 0.7;
/// How far down one looks who carries something, radians.
const GLANCE: f32 = 0.3;
/// How far from the middle of the view something may be that is kept in view, radians.
const ASIDE: f32 = 0.3;
/// From the ankle to the ball of the foot, metres.
const SOLE: f32 = 0.13;

/// What a body is shown to do beside standing, sitting or lying.
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
    /// How far it has walked, metres.
    pub walked: Option<f32>,
    /// A gesture, and since when, seconds.
    pub gesture: Option<(Verb, f32)>,
    /// The point that it keeps in view while it stands.
    pub gaze: Option<Point3<f32>>,
    /// What a hand reaches for.
    pub reach: Option<Reach>,
    /// From which pose it comes into this one, and how far it has got, 0 to 1.
    pub transition: Option<(Skeleton, f32)>,
}

/// How a body is: in its own frame, whose origin is between the feet, or on the seat.
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
    /// With the floor so far below the seat, metres.
    Sitting(f32),
    /// On its back.
    Lying,
}

impl Skeleton {
    /// The pose of a body: its attitude, what it does, and where its hands are to be, all in
    /// its own frame.
    pub fn new(attitude: BodyPosture, doing: &Activity, hands: [Option<Point3<f32>>; 2]) -> Self {
        let mut skeleton = Self::rest();
        match attitude {
            BodyPosture::Standing => skeleton.stand(doing, hands.iter().any(Option::is_some)),
            BodyPosture::Sitting(height) => skeleton.sit(height, doing),
            BodyPosture::Lying => skeleton.lie(),
        }
        BodySide::BOTH.into_iter().for_each(|side| skeleton.swing_arm(side, doing));
        if let Some((from, share)) = &doing.transition {
            skeleton = from.towards(&skeleton, *share);
        }
        for (side, point) in BodySide::BOTH.into_iter().zip(hands).filter_map(|(side, hand)| Some((side, hand?))) {
            skeleton.put_hand(side, point);
        }
        skeleton
    }

    fn stand(&mut self, doing: &Activity, carries: bool) {
        let stoop = doing.reach.map_or_else(TrunkBend::default, |reach| TrunkBend::to(&reach, None));
        let bob = doing.walked.map_or(0.0, |way| 0.018 * (1.0 - (2.0 * phase(way)).cosine()));
        let hips = stoop.hips();
        self.carry(Pose::translation(hips.x, 0.0, hips.z - bob));
        let forward = if doing.walked.is_some() { pitch(0.06) } else { UnitQuaternion::identity() };
        self.turn(Bone::Chest, stoop.chest() * forward);
        let glance = if carries { GLANCE } else { 0.0 };
        self.turn(Bone::Head, pitch(glance - 0.4 * stoop.bend));
        if let Some(point) = doing.gaze {
            self.turn_head(point, glance, ASIDE);
        }
        self.look(doing);
        for side in BodySide::BOTH {
            let ankle = step(side, doing.walked) + Vector3::z() * stoop.toes();
            self.put_foot(side, ankle, (stoop.toes() / SOLE).arc_sine());
        }
        self.dance(doing);
    }

    /// Turns the head towards what is reached for, as far as a neck turns, and upright however the
    /// chest is bent.
    fn look(&mut self, doing: &Activity) {
        let Some(Reach { point, looks, .. }) = doing.reach.filter(|reach| reach.looks > 0.0) else { return };
        let own = |s: &Self| s.motion(Bone::Chest).rotation.inverse() * s.motion(Bone::Head).rotation;
        let rest = own(self);
        self.turn_head(point, 0.0, 0.0);
        let there = own(self);
        self.turn(Bone::Head, rest.try_slerp(&there, looks, 1e-6).unwrap_or(there));
    }

    /// Turns the head upright from looking ahead and so far down just so far that a point is at most an angle from the
    /// middle of the view, to the side and up or down, radians.
    fn turn_head(&mut self, point: Point3<f32>, glance: f32, aside: f32) {
        let chest = self.motion(Bone::Chest).rotation.inverse();
        let towards = |from: f32, to: f32, most: f32| from.clamp(to - aside, to + aside).clamp(-most, most);
        // The eyes move as the head turns.
        for _ in 0..3 {
            let way = point - self.eyes().translation.vector;
            // Of what is below a bent head, or behind it, one looks down.
            let ahead = way.x.max(0.2 * way.coords.norm());
            let yaw = towards(0.0, way.y.angle_to(ahead), NECK.0);
            let down = towards(glance, (-way.z).angle_to(ahead.hypotenuse(way.y)), NECK.1);
            self.turn(Bone::Head, chest * UnitQuaternion::from_axis_angle(&Vector3::z_axis(), yaw) * pitch(down));
        }
    }

    /// What a gesture does to the trunk.
    fn dance(&mut self, doing: &Activity) {
        if let Some((Verb::Dance | Verb::Exercise | Verb::Stretch, time)) = doing.gesture {
            let roll = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), 0.18 * (6.0 * time).sine());
            self.turn(Bone::Chest, roll);
        }
    }

    fn sit(&mut self, height: f32, doing: &Activity) {
        let seat = Pose::translation(-0.1, 0.0, 0.09 - Bone::Pelvis.anchor().z);
        let stoop = doing.reach.map_or_else(TrunkBend::default, |reach| TrunkBend::to(&reach, Some(seat)));
        self.carry(seat);
        self.turn(Bone::Chest, stoop.chest() * pitch(-0.08));
        self.look(doing);
        for side in BodySide::BOTH {
            let knee = LEG[0] - 0.1;
            let floor = (ANKLE - height).max(0.09 - LEG[1]);
            self.put_foot(side, Point3::new(knee + 0.03, 0.11 * side.sign(), floor), 0.0);
        }
    }

    fn lie(&mut self) {
        let turn = UnitQuaternion::from_axis_angle(&Vector3::y_axis(), -std::f32::consts::FRAC_PI_2);
        self.carry(Pose::from_parts(nalgebra::Translation3::new(0.85, 0.0, 0.12), turn));
    }

    /// What an arm does that holds nothing.
    fn swing_arm(&mut self, side: BodySide, doing: &Activity) {
        if let Some(reach) = doing.reach.filter(|reach| reach.side == side) {
            let rest = self.motion(Bone::Chest) * palm(side);
            return self.put_hand(side, rest + (reach.point - rest) * reach.share);
        }
        if let Some(point) = doing.gesture.and_then(|g| gesture(side, g)) {
            // Gestures are those of one who stands, and go with the chest.
            return self.put_hand(side, self.motion(Bone::Chest) * point);
        }
        let swing = doing.walked.map_or(0.0, |way| 0.42 * (phase(way)).sine() * side.sign());
        let own = pitch(swing) * roll(0.08 * side.sign());
        // While the other one reaches it hangs down.
        let down = if doing.reach.is_some() { self.motion(Bone::Chest).rotation.inverse() } else { own };
        self.turn(Bone::UpperArm(side), own.slerp(&down, HANGS));
        self.turn(Bone::Forearm(side), pitch(-0.25 - 0.5 * (-swing).max(0.0)));
    }
}

fn roll(angle: f32) -> UnitQuaternion<f32> {
    UnitQuaternion::from_axis_angle(&Vector3::x_axis(), angle)
}

fn phase(walked: f32) -> f32 {
    std::f32::consts::TAU * walked / STRIDE
}

/// Where an ankle is in the course of a stride: back with the ground, forth through the air.
fn step(side: BodySide, walked: Option<f32>) -> Point3<f32> {
    let rest = Bone::Foot(side).anchor();
    let Some(walked) = walked else { return rest };
    let own = phase(walked) + if side == BodySide::Left { std::f32::consts::PI } else { 0.0 };
    let (sine, cosine) = (own.sine(), own.cosine());
    rest + Vector3::new(0.25 * STRIDE * sine, 0.0, 0.1 * cosine.max(0.0))
}

/// Where a hand is in a gesture that is the body's alone.
fn gesture(side: BodySide, (verb, time): (Verb, f32)) -> Option<Point3<f32>> {
    let beat = (7.0 * time).sine();
    let at = |x: f32, y: f32, z: f32| Some(Point3::new(x, y * side.sign(), z));
    match (verb, side) {
        (Verb::Wave | Verb::Greet, BodySide::Right) => at(0.2, 0.38 + 0.1 * beat, 1.72),
        (Verb::Dance, _) => at(0.3, 0.35, 1.25 + 0.15 * beat * side.sign()),
        (Verb::Exercise, _) => at(0.1, 0.4 + 0.2 * beat, 1.5 + 0.25 * beat),
        (Verb::Stretch, _) => at(0.0, 0.25, 1.95),
        (Verb::Type | Verb::Play, _) => at(0.36, 0.12, 1.1 + 0.01 * beat),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reach(point: Point3<f32>) -> Reach {
        Reach { side: BodySide::Right, point, share: 1.0, looks: 1.0 }
    }

    fn joined(skeleton: &Skeleton) -> bool {
        Bone::ALL.into_iter().all(|bone| {
            let Some(parent) = bone.parent() else { return true };
            let own = skeleton.motion(bone) * bone.anchor();
            (own - skeleton.motion(parent) * bone.anchor()).norm() < 1e-4
        })
    }

    /// Limbs stay joined whatever the body does, and a hand is where it is to be.
    #[test]
    fn limbs_stay_joined_and_hands_arrive() {
        let doings = [
            Activity::default(),
            Activity { walked: Some(0.4), ..Activity::default() },
            Activity { gesture: Some((Verb::Dance, 0.3)), ..Activity::default() },
            Activity { reach: Some(reach(Point3::new(0.5, 0.0, 0.2))), ..Activity::default() },
        ];
        for attitude in [BodyPosture::Standing, BodyPosture::Sitting(0.45), BodyPosture::Lying] {
            for doing in &doings {
                let hand = Point3::new(0.35, 0.2, 1.1);
                let skeleton = Skeleton::new(attitude, doing, [None, Some(hand)]);
                assert!(joined(&skeleton), "{attitude:?} {doing:?}");
                if attitude == BodyPosture::Standing && doing.reach.is_none() && doing.gesture.is_none() {
                    let own = skeleton.motion(Bone::Hand(BodySide::Left)) * palm(BodySide::Left);
                    assert!((own - hand).norm() < 0.01, "{own:?} instead of {hand:?}");
                }
            }
        }
    }

    /// Who waves has the hand beside the head, seated too.
    #[test]
    fn gestures_go_with_the_body() {
        for attitude in [BodyPosture::Standing, BodyPosture::Sitting(0.45)] {
            let doing = Activity { gesture: Some((Verb::Wave, 0.0)), ..Activity::default() };
            let skeleton = Skeleton::new(attitude, &doing, [None, None]);
            let hand = skeleton.motion(Bone::Hand(BodySide::Right)) * palm(BodySide::Right);
            let far = (hand.coords - skeleton.eyes().translation.vector).norm();
            assert!(far < 0.55, "{attitude:?}: {far} m from the eyes");
        }
    }

    /// Who reaches for something looks at it: it is well within the view.
    #[test]
    fn eyes_follow_the_hand() {
        for point in [Point3::new(0.5, 0.0, 0.3), Point3::new(0.4, -0.3, 1.0), Point3::new(0.35, 0.2, 1.9)] {
            let doing = Activity { reach: Some(reach(point)), ..Activity::default() };
            let eyes = Skeleton::new(BodyPosture::Standing, &doing, [None, None]).eyes();
            let way = eyes.inverse() * point;
            let off = (way.coords.normalize() - Vector3::x()).norm();
            assert!(off < 0.45, "{point}: {way}");
        }
    }

    /// Feet of one who stands or walks are on the floor or above it.
    #[test]
    fn feet_are_not_in_the_floor() {
        for i in 0..40 {
            let doing = Activity { walked: Some(i as f32 * 0.05), ..Activity::default() };
            let skeleton = Skeleton::new(BodyPosture::Standing, &doing, [None, None]);
            for side in BodySide::BOTH {
                let ankle = skeleton.motion(Bone::Foot(side)) * Bone::Foot(side).anchor();
                assert!(ankle.z > ANKLE - 0.02, "{ankle:?}");
            }
        }
    }
}
