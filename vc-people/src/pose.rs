//! Poses: from what a body does to where its bones are.
//!
//! Limbs of two bones are bent by the law of cosines; everything else is a chain of turns.

use nalgebra::{Point3, UnitQuaternion, Vector3};
use vc_graph::portable::Portable;
use vc_graph::{Pose, Verb};

use super::bone::{ANKLE, ARM, Bone, LEG, Side};
use super::reach::{Reach, TrunkBend};
use super::shape::palm;

/// Length of a step of two feet, metres.
const STRIDE: f32 = 1.4;
/// How far an arm is stretched at most, as a share of its length.
pub(super) const STRETCH: f32 = 0.985;
/// Where the eyes are from the neck: before the face.
const EYES: Vector3<f32> = Vector3::new(0.14, 0.0, 0.13);
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
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Doing {
    /// How far it has walked, metres.
    pub walked: Option<f32>,
    /// A gesture, and since when, seconds.
    pub gesture: Option<(Verb, f32)>,
    /// The point that it keeps in view while it stands.
    pub attends: Option<Point3<f32>>,
    /// What a hand reaches for.
    pub reach: Option<Reach>,
    /// From which pose it comes into this one, and how far it has got, 0 to 1.
    pub settles: Option<(Skeleton, f32)>,
}

/// How a body is: in its own frame, whose origin is between the feet, or on the seat.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Attitude {
    /// On its feet.
    Standing,
    /// With the floor so far below the seat, metres.
    Sitting(f32),
    /// On its back.
    Lying,
}

/// Where the bones are: how each has moved from where the asset has it.
#[derive(Debug, Clone, PartialEq)]
pub struct Skeleton {
    bones: [Pose; Bone::ALL.len()],
}

impl Skeleton {
    /// The pose of a body: its attitude, what it does, and where its hands are to be, all in
    /// its own frame.
    pub fn new(attitude: Attitude, doing: &Doing, hands: [Option<Point3<f32>>; 2]) -> Self {
        let mut skeleton = Self { bones: [Pose::identity(); Bone::ALL.len()] };
        match attitude {
            Attitude::Standing => skeleton.stand(doing, hands.iter().any(Option::is_some)),
            Attitude::Sitting(height) => skeleton.sit(height, doing),
            Attitude::Lying => skeleton.lie(),
        }
        Side::BOTH.into_iter().for_each(|side| skeleton.swing_arm(side, doing));
        if let Some((from, share)) = &doing.settles {
            skeleton = from.towards(&skeleton, *share);
        }
        for (side, point) in Side::BOTH.into_iter().zip(hands).filter_map(|(side, hand)| Some((side, hand?))) {
            skeleton.put_hand(side, point);
        }
        skeleton
    }

    /// A share of the way to another pose: hips go straight, joints turn.
    fn towards(&self, to: &Self, share: f32) -> Self {
        let mut between = Self { bones: [Pose::identity(); Bone::ALL.len()] };
        for bone in Bone::ALL {
            let base = |s: &Self| bone.parent().map_or_else(Pose::identity, |parent| s.motion(parent));
            let [from, end] = [self, to].map(|s| base(s).inverse() * s.motion(bone));
            let turn = from.rotation.try_slerp(&end.rotation, share, 1e-6).unwrap_or(end.rotation);
            let anchor = bone.anchor();
            let at = (from * anchor).coords.lerp(&(end * anchor).coords, share);
            let own = Pose::from_parts((at - turn * anchor.coords).into(), turn);
            between.bones[bone.index()] = sound(base(&between) * own);
        }
        between
    }

    /// The same pose seen from a body's frame that has moved; `moved` is where that was.
    pub fn seen_after(&self, moved: &Pose) -> Self {
        Self { bones: self.bones.map(|bone| sound(moved * bone)) }
    }

    /// How a bone has moved.
    pub fn motion(&self, bone: Bone) -> Pose {
        self.bones[bone.index()]
    }

    /// Where the eyes are, looking along X: before the face, so that it is not seen.
    pub fn eyes(&self) -> Pose {
        let eyes = Bone::Head.anchor() + EYES;
        self.motion(Bone::Head) * Pose::translation(eyes.x, eyes.y, eyes.z)
    }

    /// Turns a bone at its anchor against what it hangs on; what hangs on it follows.
    fn turn(&mut self, bone: Bone, turn: UnitQuaternion<f32>) {
        let base = bone.parent().map_or_else(Pose::identity, |p| self.motion(p));
        self.bones[bone.index()] = sound(base * about(bone.anchor(), turn));
        for child in Bone::ALL.into_iter().filter(|b| b.parent() == Some(bone)) {
            self.turn(child, UnitQuaternion::identity());
        }
    }

    /// Moves the pelvis, and everything with it.
    fn carry(&mut self, pose: Pose) {
        self.bones[Bone::Pelvis.index()] = pose;
        for child in [Bone::Chest, Bone::Thigh(Side::Right), Bone::Thigh(Side::Left)] {
            self.turn(child, UnitQuaternion::identity());
        }
    }

    fn stand(&mut self, doing: &Doing, carries: bool) {
        let stoop = doing.reach.map_or_else(TrunkBend::default, |reach| TrunkBend::to(&reach, None));
        let bob = doing.walked.map_or(0.0, |way| 0.018 * (1.0 - (2.0 * phase(way)).cosine()));
        let hips = stoop.hips();
        self.carry(Pose::translation(hips.x, 0.0, hips.z - bob));
        let forward = if doing.walked.is_some() { pitch(0.06) } else { UnitQuaternion::identity() };
        self.turn(Bone::Chest, stoop.chest() * forward);
        let glance = if carries { GLANCE } else { 0.0 };
        self.turn(Bone::Head, pitch(glance - 0.4 * stoop.bend));
        if let Some(point) = doing.attends {
            self.turn_head(point, glance, ASIDE);
        }
        self.look(doing);
        for side in Side::BOTH {
            let ankle = step(side, doing.walked) + Vector3::z() * stoop.toes();
            self.put_foot(side, ankle, (stoop.toes() / SOLE).arc_sine());
        }
        self.dance(doing);
    }

    /// Turns the head towards what is reached for, as far as a neck turns, and upright however the
    /// chest is bent.
    fn look(&mut self, doing: &Doing) {
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
    fn dance(&mut self, doing: &Doing) {
        if let Some((Verb::Dance | Verb::Exercise | Verb::Stretch, time)) = doing.gesture {
            let roll = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), 0.18 * (6.0 * time).sine());
            self.turn(Bone::Chest, roll);
        }
    }

    fn sit(&mut self, height: f32, doing: &Doing) {
        let seat = Pose::translation(-0.1, 0.0, 0.09 - Bone::Pelvis.anchor().z);
        let stoop = doing.reach.map_or_else(TrunkBend::default, |reach| TrunkBend::to(&reach, Some(seat)));
        self.carry(seat);
        self.turn(Bone::Chest, stoop.chest() * pitch(-0.08));
        self.look(doing);
        for side in Side::BOTH {
            let knee = LEG[0] - 0.1;
            let floor = (ANKLE - height).max(0.09 - LEG[1]);
            self.put_foot(side, Point3::new(knee + 0.03, 0.11 * side.sign(), floor), 0.0);
        }
    }

    fn lie(&mut self) {
        let turn = UnitQuaternion::from_axis_angle(&Vector3::y_axis(), -std::f32::consts::FRAC_PI_2);
        self.carry(Pose::from_parts(nalgebra::Translation3::new(0.85, 0.0, 0.12), turn));
    }

    /// Bends a leg so that the ankle is at a point of the body's frame, toes down by an angle.
    fn put_foot(&mut self, side: Side, ankle: Point3<f32>, tip: f32) {
        let base = self.motion(Bone::Pelvis);
        let way = base.inverse() * ankle - Bone::Thigh(side).anchor();
        let (bend, turn) = two_bones(&way, LEG, -1.0);
        self.turn(Bone::Thigh(side), turn);
        self.turn(Bone::Shin(side), pitch(bend));
        // The sole stays level, however the leg is.
        let level = self.motion(Bone::Shin(side)).rotation.inverse();
        self.turn(Bone::Foot(side), level * pitch(tip));
    }

    /// Bends an arm so that the palm is at a point of the body's frame, or as near as it gets.
    fn put_hand(&mut self, side: Side, point: Point3<f32>) {
        let base = self.motion(Bone::Chest);
        let way = base.inverse() * point - Bone::UpperArm(side).anchor();
        let (bend, turn) = two_bones(&way, ARM, 1.0);
        self.turn(Bone::UpperArm(side), turn);
        self.turn(Bone::Forearm(side), pitch(bend));
        self.turn(Bone::Hand(side), UnitQuaternion::identity());
    }

    /// What an arm does that holds nothing.
    fn swing_arm(&mut self, side: Side, doing: &Doing) {
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

/// The pose with its rotation brought back to unit length, which products of many rotations lose.
fn sound(pose: Pose) -> Pose {
    Pose::from_parts(pose.translation, UnitQuaternion::new_normalize(pose.rotation.into_inner()))
}

/// A turn at a point.
pub(super) fn about(anchor: Point3<f32>, turn: UnitQuaternion<f32>) -> Pose {
    Pose::from_parts((anchor.coords - turn * anchor.coords).into(), turn)
}

/// A turn around Y: forwards from above, backwards from below.
pub(super) fn pitch(angle: f32) -> UnitQuaternion<f32> {
    UnitQuaternion::from_axis_angle(&Vector3::y_axis(), angle)
}

fn roll(angle: f32) -> UnitQuaternion<f32> {
    UnitQuaternion::from_axis_angle(&Vector3::x_axis(), angle)
}

fn phase(walked: f32) -> f32 {
    std::f32::consts::TAU * walked / STRIDE
}

/// Where an ankle is in the course of a stride: back with the ground, forth through the air.
fn step(side: Side, walked: Option<f32>) -> Point3<f32> {
    let rest = Bone::Foot(side).anchor();
    let Some(walked) = walked else { return rest };
    let own = phase(walked) + if side == Side::Left { std::f32::consts::PI } else { 0.0 };
    let (sine, cosine) = (own.sine(), own.cosine());
    rest + Vector3::new(0.25 * STRIDE * sine, 0.0, 0.1 * cosine.max(0.0))
}

/// Bends a limb that hangs straight down so that its end is a way from its root: how far
/// its joint is bent (elbows forwards, knees backwards), and how it is turned at its root.
fn two_bones(way: &Vector3<f32>, [upper, lower]: [f32; 2], forwards: f32) -> (f32, UnitQuaternion<f32>) {
    let far = way.norm().clamp((upper - lower).abs() + 0.02, (upper + lower) * STRETCH);
    let cosine = ((upper * upper + lower * lower - far * far) / (2.0 * upper * lower)).clamp(-1.0, 1.0);
    let bend = -forwards * (std::f32::consts::PI - cosine.arc_cosine());
    let end = Vector3::new(0.0, 0.0, -upper) + pitch(bend) * Vector3::new(0.0, 0.0, -lower);
    let turn = UnitQuaternion::rotation_between(&end, way).unwrap_or_else(UnitQuaternion::identity);
    (bend, turn)
}

/// Where a hand is in a gesture that is the body's alone.
fn gesture(side: Side, (verb, time): (Verb, f32)) -> Option<Point3<f32>> {
    let beat = (7.0 * time).sine();
    let at = |x: f32, y: f32, z: f32| Some(Point3::new(x, y * side.sign(), z));
    match (verb, side) {
        (Verb::Wave | Verb::Greet, Side::Right) => at(0.2, 0.38 + 0.1 * beat, 1.72),
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
        Reach { side: Side::Right, point, share: 1.0, looks: 1.0 }
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
            Doing::default(),
            Doing { walked: Some(0.4), ..Doing::default() },
            Doing { gesture: Some((Verb::Dance, 0.3)), ..Doing::default() },
            Doing { reach: Some(reach(Point3::new(0.5, 0.0, 0.2))), ..Doing::default() },
        ];
        for attitude in [Attitude::Standing, Attitude::Sitting(0.45), Attitude::Lying] {
            for doing in &doings {
                let hand = Point3::new(0.35, 0.2, 1.1);
                let skeleton = Skeleton::new(attitude, doing, [None, Some(hand)]);
                assert!(joined(&skeleton), "{attitude:?} {doing:?}");
                if attitude == Attitude::Standing && doing.reach.is_none() && doing.gesture.is_none() {
                    let own = skeleton.motion(Bone::Hand(Side::Left)) * palm(Side::Left);
                    assert!((own - hand).norm() < 0.01, "{own:?} instead of {hand:?}");
                }
            }
        }
    }

    /// Who waves has the hand beside the head, seated too.
    #[test]
    fn gestures_go_with_the_body() {
        for attitude in [Attitude::Standing, Attitude::Sitting(0.45)] {
            let doing = Doing { gesture: Some((Verb::Wave, 0.0)), ..Doing::default() };
            let skeleton = Skeleton::new(attitude, &doing, [None, None]);
            let hand = skeleton.motion(Bone::Hand(Side::Right)) * palm(Side::Right);
            let far = (hand.coords - skeleton.eyes().translation.vector).norm();
            assert!(far < 0.55, "{attitude:?}: {far} m from the eyes");
        }
    }

    /// Who reaches for something looks at it: it is well within the view.
    #[test]
    fn eyes_follow_the_hand() {
        for point in [Point3::new(0.5, 0.0, 0.3), Point3::new(0.4, -0.3, 1.0), Point3::new(0.35, 0.2, 1.9)] {
            let doing = Doing { reach: Some(reach(point)), ..Doing::default() };
            let eyes = Skeleton::new(Attitude::Standing, &doing, [None, None]).eyes();
            let way = eyes.inverse() * point;
            let off = (way.coords.normalize() - Vector3::x()).norm();
            assert!(off < 0.45, "{point}: {way}");
        }
    }

    /// Feet of one who stands or walks are on the floor or above it.
    #[test]
    fn feet_are_not_in_the_floor() {
        for i in 0..40 {
            let doing = Doing { walked: Some(i as f32 * 0.05), ..Doing::default() };
            let skeleton = Skeleton::new(Attitude::Standing, &doing, [None, None]);
            for side in Side::BOTH {
                let ankle = skeleton.motion(Bone::Foot(side)) * Bone::Foot(side).anchor();
                assert!(ankle.z > ANKLE - 0.02, "{ankle:?}");
            }
        }
    }
}
