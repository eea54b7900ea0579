//! Bones: their anchors and parents.

use nalgebra::{Point3, Vector3};
use vc_graph::asset::{Joint, JointKind};

use super::ADULT;

/// A bone of the figure.
///
/// ```
/// use vc_people::{Bone, BodySide};
/// assert_eq!(Bone::Hand(BodySide::Left).parent(), Some(Bone::Forearm(BodySide::Left)));
/// assert!(Bone::Head.anchor().z > Bone::Chest.anchor().z);
/// assert_eq!(Bone::from_joint(&Bone::Head.joint()), Some(Bone::Head));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Bone {
    /// The hips, on which everything hangs.
    Pelvis,
    /// The trunk above the waist.
    Chest,
    /// Head and neck.
    Head,
    /// From the shoulder to the elbow.
    UpperArm(BodySide),
    /// From the elbow to the wrist.
    Forearm(BodySide),
    /// The hand.
    Hand(BodySide),
    /// From the hip to the knee.
    Thigh(BodySide),
    /// From the knee to the ankle.
    Shin(BodySide),
    /// The foot.
    Foot(BodySide),
}

/// The side of the body, right or left.
///
/// ```
/// use vc_people::BodySide;
/// assert_eq!(BodySide::BOTH.map(BodySide::sign), [-1.0, 1.0]);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum BodySide {
    /// Right: negative Y.
    Right,
    /// Left: positive Y.
    Left,
}

impl BodySide {
    /// Both sides.
    pub const BOTH: [Self; 2] = [Self::Right, Self::Left];

    /// The sign of the side along Y: left is positive.
    pub fn sign(self) -> f32 {
        match self {
            Self::Right => -1.0,
            Self::Left => 1.0,
        }
    }
}

/// Lengths of the upper arm, and of the forearm to the palm, metres.
pub(crate) const ARM: [f32; 2] = [ADULT.upper_arm, ADULT.forearm];
/// Lengths of thigh and shin, metres.
pub(crate) const LEG: [f32; 2] = [(ADULT.hip() - ADULT.ankle) / 2.0; 2];

impl Bone {
    /// All bones, parents before children.
    pub const ALL: [Self; 15] = [
        Self::Pelvis,
        Self::Chest,
        Self::Head,
        Self::UpperArm(BodySide::Right),
        Self::UpperArm(BodySide::Left),
        Self::Forearm(BodySide::Right),
        Self::Forearm(BodySide::Left),
        Self::Hand(BodySide::Right),
        Self::Hand(BodySide::Left),
        Self::Thigh(BodySide::Right),
        Self::Thigh(BodySide::Left),
        Self::Shin(BodySide::Right),
        Self::Shin(BodySide::Left),
        Self::Foot(BodySide::Right),
        Self::Foot(BodySide::Left),
    ];

    pub(crate) fn index(self) -> usize {
        Self::ALL.iter().position(|b| *b == self).unwrap_or(0)
    }

    /// The parent bone.
    pub fn parent(self) -> Option<Self> {
        match self {
            Self::Pelvis => None,
            Self::Chest => Some(Self::Pelvis),
            Self::Head => Some(Self::Chest),
            Self::UpperArm(_) => Some(Self::Chest),
            Self::Forearm(side) => Some(Self::UpperArm(side)),
            Self::Hand(side) => Some(Self::Forearm(side)),
            Self::Thigh(_) => Some(Self::Pelvis),
            Self::Shin(side) => Some(Self::Thigh(side)),
            Self::Foot(side) => Some(Self::Shin(side)),
        }
    }

    /// The joint's position while the figure stands with its arms down, metres.
    pub fn anchor(self) -> Point3<f32> {
        let (hip, shoulder) = (ADULT.hip(), ADULT.shoulder * ADULT.stature);
        let (arms, legs) = (ADULT.half_shoulders, ADULT.half_hips);
        match self {
            Self::Pelvis => Point3::new(0.0, 0.0, hip),
            Self::Chest => Point3::new(0.0, 0.0, hip + 0.12),
            Self::Head => Point3::new(0.0, 0.0, shoulder + 0.06),
            Self::UpperArm(s) => Point3::new(0.0, arms * s.sign(), shoulder),
            Self::Forearm(s) => Point3::new(0.0, arms * s.sign(), shoulder - ARM[0]),
            Self::Hand(s) => Point3::new(0.0, arms * s.sign(), shoulder - ARM[0] - ARM[1] + 0.08),
            Self::Thigh(s) => Point3::new(0.0, legs * s.sign(), hip),
            Self::Shin(s) => Point3::new(0.0, legs * s.sign(), hip - LEG[0]),
            Self::Foot(s) => Point3::new(0.0, legs * s.sign(), ADULT.ankle),
        }
    }

    /// The joint by which the asset identifies the bone.
    pub fn joint(self) -> Joint {
        Joint { kind: JointKind::Hinge, anchor: self.anchor(), axis: Vector3::y(), limits: (-3.0, 3.0) }
    }

    /// The bone of a joint.
    pub fn from_joint(joint: &Joint) -> Option<Self> {
        Self::ALL.into_iter().find(|b| b.anchor() == joint.anchor)
    }
}
