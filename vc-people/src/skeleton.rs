//! Skeletons: where each bone is, and limbs bent so that a hand or a foot is at a point.
//!
//! Limbs of two bones are bent by the law of cosines; everything else is a chain of turns.

use nalgebra::{Point3, UnitQuaternion, Vector3};
use vc_graph::Pose;
use vc_graph::portable::Portable;

use super::bone::{ARM, BodySide, Bone, LEG};
use super::shape::palm;

/// The greatest stretch of an arm, as a share of its length.
pub(super) const STRETCH: f32 = 0.985;
/// Length from the elbow to the wrist, and from there to the palm, metres.
pub(super) const FOREARM: f32 = ARM[1] - WRIST;
const WRIST: f32 = 0.08;
/// The eyes' place from the neck: before the face.
const EYES: Vector3<f32> = Vector3::new(0.14, 0.0, 0.13);

/// The places of the bones: the motion of each from its place in the asset.
#[derive(Debug, Clone, PartialEq)]
pub struct Skeleton {
    bones: [Pose; Bone::ALL.len()],
}

impl Skeleton {
    /// The asset's own pose.
    pub(super) fn rest() -> Self {
        Self { bones: [Pose::identity(); Bone::ALL.len()] }
    }

    /// A share of the way to another pose: hips go straight, joints turn.
    pub(super) fn towards(&self, to: &Self, share: f32) -> Self {
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
    pub fn transformed(&self, moved: &Pose) -> Self {
        Self { bones: self.bones.map(|bone| sound(moved * bone)) }
    }

    /// The motion of a bone from its place in the asset.
    pub fn motion(&self, bone: Bone) -> Pose {
        self.bones[bone.index()]
    }

    /// The eyes' pose, looking along X: before the face, so that it is not seen.
    ///
    /// ```
    /// use vc_people::{Activity, BodyPosture, Skeleton};
    /// let skeleton = Skeleton::new(BodyPosture::Standing, &Activity::default(), [None, None]);
    /// let eyes = skeleton.eyes();
    /// assert!(eyes.translation.x > 0.0 && (1.5..1.8).contains(&eyes.translation.z));
    /// ```
    pub fn eyes(&self) -> Pose {
        let eyes = Bone::Head.anchor() + EYES;
        self.motion(Bone::Head) * Pose::translation(eyes.x, eyes.y, eyes.z)
    }

    /// Turns a bone at its anchor against its parent. The bones that hang on it follow, and lose turns of their own.
    pub(super) fn turn(&mut self, bone: Bone, turn: UnitQuaternion<f32>) {
        let base = bone.parent().map_or_else(Pose::identity, |p| self.motion(p));
        self.bones[bone.index()] = sound(base * about(bone.anchor(), turn));
        for child in Bone::ALL.into_iter().filter(|b| b.parent() == Some(bone)) {
            self.turn(child, UnitQuaternion::identity());
        }
    }

    /// Moves the pelvis, and everything with it.
    pub(super) fn carry(&mut self, pose: Pose) {
        self.bones[Bone::Pelvis.index()] = pose;
        for child in [Bone::Chest, Bone::Thigh(BodySide::Right), Bone::Thigh(BodySide::Left)] {
            self.turn(child, UnitQuaternion::identity());
        }
    }

    /// Bends a leg so that the ankle is at a point of the body's frame, toes down by an angle.
    pub(super) fn put_foot(&mut self, side: BodySide, ankle: Point3<f32>, tip: f32) {
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
    pub(super) fn put_hand(&mut self, side: BodySide, point: Point3<f32>) {
        self.bend_arm(side, point, ARM);
    }

    /// Bends an arm and turns the hand so that the palm has a pose in the body's frame, or as near as the arm gets.
    pub(super) fn put_palm(&mut self, side: BodySide, palm: &Pose) {
        self.bend_arm(side, wrist(side, palm), [ARM[0], FOREARM]);
        let forearm = self.motion(Bone::Forearm(side)).rotation.inverse();
        self.turn(Bone::Hand(side), forearm * palm.rotation * hanging(side).inverse());
    }

    /// The pose of a palm in the body's frame: the point in its middle, X along the fingers, Z out of the back of the
    /// hand.
    ///
    /// ```
    /// use vc_graph::Pose;
    /// use vc_people::{Activity, BodyPosture, BodySide, Skeleton};
    /// let ahead = Pose::translation(0.4, -0.2, 1.1);
    /// let activity = Activity { palms: [Some(ahead), None], ..Activity::default() };
    /// let skeleton = Skeleton::new(BodyPosture::Standing, &activity, [None, None]);
    /// let palm = skeleton.palm(BodySide::Right);
    /// assert!((palm.translation.vector - ahead.translation.vector).norm() < 0.01);
    /// assert!(palm.rotation.angle_to(&ahead.rotation) < 0.01);
    /// ```
    pub fn palm(&self, side: BodySide) -> Pose {
        let motion = self.motion(Bone::Hand(side));
        let rotation = UnitQuaternion::new_normalize((motion.rotation * hanging(side)).into_inner());
        Pose::from_parts((motion * palm(side)).coords.into(), rotation)
    }

    fn bend_arm(&mut self, side: BodySide, end: Point3<f32>, bones: [f32; 2]) {
        let base = self.motion(Bone::Chest);
        let way = base.inverse() * end - Bone::UpperArm(side).anchor();
        let (bend, turn) = two_bones(&way, bones, 1.0);
        self.turn(Bone::UpperArm(side), turn);
        self.turn(Bone::Forearm(side), pitch(bend));
        self.turn(Bone::Hand(side), UnitQuaternion::identity());
    }
}

/// The wrist of a palm.
pub(super) fn wrist(side: BodySide, at: &Pose) -> Point3<f32> {
    let to_wrist = Bone::Hand(side).anchor() - palm(side);
    at * Point3::from(hanging(side).inverse() * to_wrist)
}

/// The orientation of a hand that hangs down: its fingers point down, its back outwards.
fn hanging(side: BodySide) -> UnitQuaternion<f32> {
    let quarter = std::f32::consts::FRAC_PI_2;
    pitch(quarter) * UnitQuaternion::from_axis_angle(&Vector3::x_axis(), -side.sign() * quarter)
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

/// Bends a limb that hangs straight down so that its end is a way from its root: the bend of
/// its joint (elbows forwards, knees backwards), and the turn at its root.
fn two_bones(way: &Vector3<f32>, [upper, lower]: [f32; 2], forwards: f32) -> (f32, UnitQuaternion<f32>) {
    let far = way.norm().clamp((upper - lower).abs() + 0.02, (upper + lower) * STRETCH);
    let cosine = ((upper * upper + lower * lower - far * far) / (2.0 * upper * lower)).clamp(-1.0, 1.0);
    let bend = -forwards * (std::f32::consts::PI - cosine.arc_cosine());
    let end = Vector3::new(0.0, 0.0, -upper) + pitch(bend) * Vector3::new(0.0, 0.0, -lower);
    let turn = UnitQuaternion::rotation_between(&end, way).unwrap_or_else(UnitQuaternion::identity);
    (bend, turn)
}
