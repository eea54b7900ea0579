//! Bones: their anchors and parents.

use nalgebra::{Point3, Vector3};
use vc_graph::asset::{Joint, JointKind};

use super::ADULT;

/// A bone of the figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Bone {
    /// The hips, on which everything hangs.
    Pelvis,
    /// The trunk above the waist.
    Chest,
    /// Head and neck.
    Head,
    /// From the shoulder to the elbow.
    UpperArm(Side),
    /// From the elbow to the wrist.
    Forearm(Side),
    /// The hand.
    Hand(Side),
    /// From the hip to the knee.
    Thigh(Side),
    /// From the knee to the ankle.
    Shin(Side),
    /// The foot.
    Foot(Side),
}

/// The side of the body, right or left.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Side {
    /// Right: negative Y.
    Right,
    /// Left: positive Y.
    Left,
}

impl Side {
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
pub(crate) const ARM: [f32; 2] = [0.29, 0.33];
/// Lengths of thigh and shin, metres.
pub(crate) const LEG: [f32; 2] = [0.40, 0.40];
/// Height of the ankles, metres.
pub(crate) const ANKLE: f32 = 0.08;

impl Bone {
    /// All bones, parents before children.
    pub const ALL: [Self; 15] = [
        Self::Pelvis,
        Self::Chest,
        Self::Head,
        Self::UpperArm(Side::Right),
        Self::UpperArm(Side::Left),
        Self::Forearm(Side::Right),
        Self::Forearm(Side::Left),
        Self::Hand(Side::Right),
        Self::Hand(Side::Left),
        Self::Thigh(Side::Right),
        Self::Thigh(Side::Left),
        Self::Shin(Side::Right),
        Self::Shin(Side::Left),
        Self::Foot(Side::Right),
        Self::Foot(Side::Left),
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
        let hip = ANKLE + LEG[0] + LEG[1];
        let shoulder = ADULT.shoulder * ADULT.stature;
        match self {
            Self::Pelvis => Point3::new(0.0, 0.0, hip),
            Self::Chest => Point3::new(0.0, 0.0, hip + 0.12),
            Self::Head => Point3::new(0.0, 0.0, shoulder + 0.06),
            Self::UpperArm(s) => Point3::new(0.0, 0.2 * s.sign(), shoulder),
            Self::Forearm(s) => Point3::new(0.0, 0.2 * s.sign(), shoulder - ARM[0]),
            Self::Hand(s) => Point3::new(0.0, 0.2 * s.sign(), shoulder - ARM[0] - ARM[1] + 0.08),
            Self::Thigh(s) => Point3::new(0.0, 0.095 * s.sign(), hip),
            Self::Shin(s) => Point3::new(0.0, 0.095 * s.sign(), hip - LEG[0]),
            Self::Foot(s) => Point3::new(0.0, 0.095 * s.sign(), ANKLE),
        }
    }

    /// The joint by which the asset identifies the bone.
    pub fn joint(self) -> Joint {
        Joint { kind: JointKind::Hinge, anchor: self.anchor(), axis: Vector3::y(), limits: (-3.0, 3.0) }
    }

    /// The bone of a joint.
    pub fn of(joint: &Joint) -> Option<Self> {
        Self::ALL.into_iter().find(|b| b.anchor() == joint.anchor)
    }
}
