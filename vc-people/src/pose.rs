//! Poses: from what a body does to where its bones are.

use nalgebra::{Point3, UnitQuaternion, Vector3};
use vc_graph::portable::Portable;
use vc_graph::{Motion, Pose};

use super::ADULT;
use super::activity::{Activity, BodyPosture};
use super::bone::{BodySide, Bone, LEG};
use super::reach::{Reach, TrunkBend};
use super::shape::palm;
use super::skeleton::{Skeleton, pitch};

/// Length of a step of two feet, metres.
const STRIDE: f32 = 1.4;
/// The greatest turn of a head to the side, and up or down, radians.
const NECK: (f32, f32) = (1.2, 1.4);
/// Share of the way from following a bent trunk to hanging straight down, for a free arm.
const HANGS: f32 = 0.7;
/// The downward pitch of the head of a person who carries something, radians.
const GLANCE: f32 = 0.3;
/// The greatest angle from the middle of the view of a point that is kept in view, radians.
const ASIDE: f32 = 0.3;
/// From the ankle to the ball of the foot, metres.
const SOLE: f32 = 0.13;

impl Skeleton {
    /// The pose of a body: its posture, what it does, and where its hands are to be, all in
    /// its own frame.
    pub fn new(posture: BodyPosture, activity: &Activity, hands: [Option<Point3<f32>>; 2]) -> Self {
        let mut skeleton = Self::rest();
        match posture {
            BodyPosture::Standing => skeleton.stand(activity, hands.iter().any(Option::is_some)),
            BodyPosture::Sitting(height) => skeleton.sit(height, activity),
            BodyPosture::Lying => skeleton.lie(),
        }
        BodySide::BOTH.into_iter().for_each(|side| skeleton.swing_arm(side, activity));
        if let Some((from, share)) = &activity.transition {
            skeleton = from.towards(&skeleton, *share);
        }
        for (side, point) in BodySide::BOTH.into_iter().zip(hands).filter_map(|(side, hand)| Some((side, hand?))) {
            skeleton.put_hand(side, point);
        }
        for (side, palm) in BodySide::BOTH.into_iter().zip(activity.palms).filter_map(|(s, palm)| Some((s, palm?))) {
            skeleton.put_palm(side, &palm);
        }
        skeleton
    }

    fn stand(&mut self, activity: &Activity, carries: bool) {
        let stoop = TrunkBend::of(activity, None);
        let bob = activity.walked.map_or(0.0, |way| 0.018 * (1.0 - (2.0 * phase(way)).cosine()));
        let hips = stoop.hips();
        self.carry(Pose::translation(hips.x, 0.0, hips.z - bob));
        let forward = if activity.walked.is_some() { pitch(0.06) } else { UnitQuaternion::identity() };
        self.turn(Bone::Chest, stoop.chest() * forward);
        let glance = if carries { GLANCE } else { 0.0 };
        self.turn(Bone::Head, pitch(glance - 0.4 * stoop.bend));
        if let Some(point) = activity.gaze {
            self.turn_head(point, glance, ASIDE);
        }
        self.look(activity);
        for side in BodySide::BOTH {
            let ankle = step(side, activity.walked) + Vector3::z() * stoop.toes();
            self.put_foot(side, ankle, (stoop.toes() / SOLE).arc_sine());
        }
        self.dance(activity);
    }

    /// Turns the head towards what is reached for, as far as a neck turns, and upright however the
    /// chest is bent.
    fn look(&mut self, activity: &Activity) {
        if let Some((left, up)) = activity.head {
            let chest = self.motion(Bone::Chest).rotation.inverse();
            let yaw = left.clamp(-NECK.0, NECK.0);
            return self.turn(Bone::Head, chest * head(yaw, -up.clamp(-NECK.1, NECK.1)));
        }
        let Some(Reach { point, gaze, .. }) = activity.reach.filter(|reach| reach.gaze > 0.0) else { return };
        let own = |s: &Self| s.motion(Bone::Chest).rotation.inverse() * s.motion(Bone::Head).rotation;
        let rest = own(self);
        self.turn_head(point, 0.0, 0.0);
        let there = own(self);
        self.turn(Bone::Head, rest.try_slerp(&there, gaze, 1e-6).unwrap_or(there));
    }

    /// Turns the head upright from looking ahead and so far down just so far that a point is at most an angle from the
    /// middle of the view, to the side and up or down, radians.
    fn turn_head(&mut self, point: Point3<f32>, glance: f32, aside: f32) {
        let chest = self.motion(Bone::Chest).rotation.inverse();
        let towards = |from: f32, to: f32, most: f32| from.clamp(to - aside, to + aside).clamp(-most, most);
        // The eyes move as the head turns.
        for _ in 0..3 {
            let way = point - self.eyes().translation.vector;
            // A point below a bent head, or behind it, is looked at by looking down.
            let ahead = way.x.max(0.2 * way.coords.norm());
            let yaw = towards(0.0, way.y.angle_to(ahead), NECK.0);
            let down = towards(glance, (-way.z).angle_to(ahead.hypotenuse(way.y)), NECK.1);
            self.turn(Bone::Head, chest * head(yaw, down));
        }
    }

    /// Rolls the trunk in a gesture of the whole body.
    fn dance(&mut self, activity: &Activity) {
        if let Some((Motion::Dance | Motion::Exercise | Motion::Stretch, time)) = activity.gesture {
            let roll = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), 0.18 * (6.0 * time).sine());
            self.turn(Bone::Chest, roll);
        }
    }

    fn sit(&mut self, height: f32, activity: &Activity) {
        let seat = Pose::translation(-0.1, 0.0, 0.09 - Bone::Pelvis.anchor().z);
        let stoop = TrunkBend::of(activity, Some(seat));
        self.carry(seat);
        self.turn(Bone::Chest, stoop.chest() * pitch(-0.08));
        self.look(activity);
        for side in BodySide::BOTH {
            let knee = LEG[0] - 0.1;
            let floor = (ADULT.ankle - height).max(0.09 - LEG[1]);
            self.put_foot(side, Point3::new(knee + 0.03, 0.11 * side.sign(), floor), 0.0);
        }
    }

    fn lie(&mut self) {
        let turn = UnitQuaternion::from_axis_angle(&Vector3::y_axis(), -std::f32::consts::FRAC_PI_2);
        self.carry(Pose::from_parts(nalgebra::Translation3::new(ADULT.stature / 2.0, 0.0, 0.12), turn));
    }

    /// Poses an arm that holds nothing: it reaches, makes a gesture, or swings.
    fn swing_arm(&mut self, side: BodySide, activity: &Activity) {
        if let Some(reach) = activity.reach.filter(|reach| reach.side == side) {
            let rest = self.motion(Bone::Chest) * palm(side);
            return self.put_hand(side, rest + (reach.point - rest) * reach.share);
        }
        if let Some(point) = activity.gesture.and_then(|g| gesture(side, g)) {
            // Gestures are those of one who stands, and go with the chest.
            return self.put_hand(side, self.motion(Bone::Chest) * point);
        }
        let swing = activity.walked.map_or(0.0, |way| 0.42 * (phase(way)).sine() * side.sign());
        let own = pitch(swing) * roll(0.08 * side.sign());
        // While the other one reaches it hangs down.
        let reaches = activity.reach.is_some() || activity.palms.iter().any(Option::is_some);
        let down = if reaches { self.motion(Bone::Chest).rotation.inverse() } else { own };
        self.turn(Bone::UpperArm(side), own.slerp(&down, HANGS));
        self.turn(Bone::Forearm(side), pitch(-0.25 - 0.5 * (-swing).max(0.0)));
    }
}

/// The direction of a head that is turned to the left and down from straight ahead.
fn head(left: f32, down: f32) -> UnitQuaternion<f32> {
    UnitQuaternion::from_axis_angle(&Vector3::z_axis(), left) * pitch(down)
}

fn roll(angle: f32) -> UnitQuaternion<f32> {
    UnitQuaternion::from_axis_angle(&Vector3::x_axis(), angle)
}

fn phase(walked: f32) -> f32 {
    std::f32::consts::TAU * walked / STRIDE
}

/// The position of an ankle in the course of a stride: back with the ground, forth through the air.
fn step(side: BodySide, walked: Option<f32>) -> Point3<f32> {
    let rest = Bone::Foot(side).anchor();
    let Some(walked) = walked else { return rest };
    let own = phase(walked) + if side == BodySide::Left { std::f32::consts::PI } else { 0.0 };
    let (sine, cosine) = (own.sine(), own.cosine());
    rest + Vector3::new(0.25 * STRIDE * sine, 0.0, 0.1 * cosine.max(0.0))
}

/// The position of a hand in a gesture that is the body's alone.
fn gesture(side: BodySide, (motion, time): (Motion, f32)) -> Option<Point3<f32>> {
    let beat = (7.0 * time).sine();
    let at = |x: f32, y: f32, z: f32| Some(Point3::new(x, y * side.sign(), z));
    match (motion, side) {
        (Motion::Wave, BodySide::Right) => at(0.2, 0.38 + 0.1 * beat, 1.72),
        (Motion::Dance, _) => at(0.3, 0.35, 1.25 + 0.15 * beat * side.sign()),
        (Motion::Exercise, _) => at(0.1, 0.4 + 0.2 * beat, 1.5 + 0.25 * beat),
        (Motion::Stretch, _) => at(0.0, 0.25, 1.95),
        (Motion::Play, _) => at(0.36, 0.12, 1.1 + 0.01 * beat),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reach(point: Point3<f32>) -> Reach {
        Reach { side: BodySide::Right, point, share: 1.0, gaze: 1.0 }
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
        let activities = [
            Activity::default(),
            Activity { walked: Some(0.4), ..Activity::default() },
            Activity { gesture: Some((Motion::Dance, 0.3)), ..Activity::default() },
            Activity { reach: Some(reach(Point3::new(0.5, 0.0, 0.2))), ..Activity::default() },
        ];
        for posture in [BodyPosture::Standing, BodyPosture::Sitting(0.45), BodyPosture::Lying] {
            for activity in &activities {
                let hand = Point3::new(0.35, 0.2, 1.1);
                let skeleton = Skeleton::new(posture, activity, [None, Some(hand)]);
                assert!(joined(&skeleton), "{posture:?} {activity:?}");
                if posture == BodyPosture::Standing && activity.reach.is_none() && activity.gesture.is_none() {
                    let own = skeleton.motion(Bone::Hand(BodySide::Left)) * palm(BodySide::Left);
                    assert!((own - hand).norm() < 0.01, "{own:?} instead of {hand:?}");
                }
            }
        }
    }

    /// A person who waves has the hand beside the head, seated too.
    #[test]
    fn gestures_go_with_the_body() {
        for posture in [BodyPosture::Standing, BodyPosture::Sitting(0.45)] {
            let activity = Activity { gesture: Some((Motion::Wave, 0.0)), ..Activity::default() };
            let skeleton = Skeleton::new(posture, &activity, [None, None]);
            let hand = skeleton.motion(Bone::Hand(BodySide::Right)) * palm(BodySide::Right);
            let far = (hand.coords - skeleton.eyes().translation.vector).norm();
            assert!(far < 0.55, "{posture:?}: {far} m from the eyes");
        }
    }

    /// A person who reaches for something looks at it: it is well within the view.
    #[test]
    fn eyes_follow_the_hand() {
        for point in [Point3::new(0.5, 0.0, 0.3), Point3::new(0.4, -0.3, 1.0), Point3::new(0.35, 0.2, 1.9)] {
            let activity = Activity { reach: Some(reach(point)), ..Activity::default() };
            let eyes = Skeleton::new(BodyPosture::Standing, &activity, [None, None]).eyes();
            let way = eyes.inverse() * point;
            let off = (way.coords.normalize() - Vector3::x()).norm();
            assert!(off < 0.45, "{point}: {way}");
        }
    }

    /// Feet of one who stands or walks are on the floor or above it.
    #[test]
    fn feet_are_not_in_the_floor() {
        for i in 0..40 {
            let activity = Activity { walked: Some(i as f32 * 0.05), ..Activity::default() };
            let skeleton = Skeleton::new(BodyPosture::Standing, &activity, [None, None]);
            for side in BodySide::BOTH {
                let ankle = skeleton.motion(Bone::Foot(side)) * Bone::Foot(side).anchor();
                assert!(ankle.z > ADULT.ankle - 0.02, "{ankle:?}");
            }
        }
    }
}
