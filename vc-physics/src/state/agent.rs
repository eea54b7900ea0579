//! The state of an agent: where it stands, walks or sits, and the things in its hands.

use nalgebra::{Point3, Quaternion, UnitQuaternion, Vector3};
use rapier3d::dynamics::RigidBodyHandle;
use serde::{Deserialize, Serialize};
use vc_graph::hash::Digester;
use vc_graph::{NodeId, Pose};

use super::body_plan::{BodyPlan, Posture};
use super::hand::{Hand, Held};
use super::motion::Motion;
use crate::convert::facing;

/// Position of the hands that hold things: ahead of the body and to its side, metres, and height as a share of the
/// body's height. They are before the chest, in view of the eyes.
const AHEAD: f32 = 0.3;
const ASIDE: f32 = 0.2;
const CHEST: f32 = 0.74;
/// Height of a hand that hangs down as a share of the body's height, its height above a seat, and its distance from the
/// middle of the body, metres.
const DOWN: f32 = 0.42;
const ON_SEAT: f32 = 0.15;
const BESIDE: f32 = 0.27;

/// An agent's body.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Agent {
    pub(crate) plan: BodyPlan,
    pub(crate) body: RigidBodyHandle,
    /// The pose of its feet, X being its front; for a seated agent, of its place on the seat.
    #[serde(with = "crate::serial::pose")]
    pub(crate) feet: Pose,
    /// Its pose when it was added.
    #[serde(with = "crate::serial::pose")]
    pub(crate) written: Pose,
    pub(crate) posture: Posture,
    /// The pose of the feet before it sat or lay down.
    #[serde(with = "crate::serial::pose")]
    pub(crate) stood: Pose,
    pub(crate) hands: [Option<Held>; 2],
    pub(crate) walk: Motion,
    /// Velocity over the floor in the last step, metres a second.
    pub(crate) velocity: [f32; 2],
    /// Falling speed, metres a second; `grounded` tells whether it stands on something.
    pub(crate) fall: f32,
    pub(crate) grounded: bool,
    /// Height of the floor it last stood on, metres.
    pub(crate) floor: f32,
}

impl Agent {
    pub(crate) fn pose(&self) -> Pose {
        self.feet
    }

    /// Whether it stands where it was added, apart from the descent to the floor.
    pub(crate) fn has_only_landed(&self) -> bool {
        let way = self.feet.translation.vector - self.written.translation.vector;
        let turn = self.feet.rotation.angle_to(&upright(&self.written).rotation);
        self.posture == Posture::Standing && way.xy().norm() < 1e-3 && way.z.abs() < self.plan.step && turn < 1e-2
    }

    /// Whether a step leaves it where it is: it neither walks nor falls.
    pub(crate) fn is_still(&self) -> bool {
        let stops = matches!(self.walk, Motion::Still | Motion::Stuck) && self.velocity == [0.0; 2];
        self.posture != Posture::Standing || (self.grounded && stops)
    }

    pub(crate) fn shoulder(&self) -> Point3<f32> {
        let height = match self.posture {
            Posture::Standing => self.plan.shoulder(),
            // From the seat up.
            Posture::Sitting(..) => 0.55 * self.plan.shoulder(),
            Posture::Lying(..) => 0.15,
        };
        self.feet * Point3::new(0.0, 0.0, height)
    }

    pub(crate) fn feed(&self, id: NodeId, hash: &mut Digester) {
        hash.word(u64::from(id.0));
        hash.reals(self.feet.translation.vector.iter().copied());
        hash.reals(self.feet.rotation.coords.iter().copied());
        hash.reals([self.velocity[0], self.velocity[1], self.fall]);
        for held in &self.hands {
            hash.word(held.as_ref().map_or(0, |h| u64::from(h.id.0) + 1));
        }
        hash.word(self.posture.seat().map_or(0, |(id, place)| (u64::from(id.0) << 32) | (u64::from(place) + 1)));
    }

    /// All carried things with their poses.
    pub(crate) fn holdings(&self) -> Vec<(NodeId, Pose)> {
        let held = self.hands.iter().flatten();
        let each = |held: &Held| {
            let at = self.feet * self.lap() * held.grip;
            let load: Vec<_> = held.load.iter().map(|l| (l.id, at * l.at)).collect();
            std::iter::once((held.id, at)).chain(load)
        };
        held.flat_map(each).collect()
    }

    /// The displacement of the hands of an agent that sits or lies, relative to a standing one: they stay before its
    /// chest.
    pub(crate) fn lap(&self) -> Pose {
        match self.posture {
            Posture::Standing => Pose::identity(),
            Posture::Sitting(..) => Pose::translation(0.05, 0.0, -0.44 * self.plan.height),
            Posture::Lying(..) => Pose::translation(-0.5, 0.0, -0.44 * self.plan.height),
        }
    }

    /// Position of a hand relative to the feet: before the chest.
    pub(crate) fn hand(&self, hand: Hand) -> Point3<f32> {
        Point3::new(self.plan.radius + AHEAD, ASIDE * hand.side(), CHEST * self.plan.height)
    }

    /// The pose relative to the feet of a hand that carries something: its fingers point ahead.
    pub(crate) fn hand_pose(&self, hand: Hand) -> Pose {
        let at = self.hand(hand);
        self.lap() * Pose::translation(at.x, at.y, at.z)
    }

    /// The pose relative to the feet, or to the seat, of a hand at the end of an arm that hangs down: its fingers point
    /// down.
    pub(crate) fn arm_down(&self, hand: Hand) -> Pose {
        let low = if self.posture == Posture::Standing { DOWN * self.plan.height } else { ON_SEAT };
        let turn = UnitQuaternion::from_quaternion(Quaternion::new(0.5, -0.5 * hand.side(), 0.5, 0.5 * hand.side()));
        Pose::from_parts([0.0, BESIDE * hand.side(), low].into(), turn)
    }

    /// Whether two bodies are in one place; an agent and itself are.
    pub(crate) fn is_with(&self, other: &Self) -> bool {
        let between = self.feet.translation.vector - other.feet.translation.vector;
        let high = if between.z > 0.0 { other.plan.height } else { self.plan.height };
        between.xy().norm() < self.plan.radius + other.plan.radius && between.z.abs() < high
    }
}

/// A pose without pitch and roll.
pub(crate) fn upright(pose: &Pose) -> Pose {
    let front = pose.rotation * Vector3::x();
    Pose::from_parts(pose.translation, facing(front.x, front.y))
}
