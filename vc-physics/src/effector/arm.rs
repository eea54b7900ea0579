//! The arm: it pulls a hand along the way to its goal, with a limited force.

use nalgebra::{Quaternion, UnitQuaternion};
use rapier3d::dynamics::{GenericJoint, JointAxesMask, JointAxis, MotorModel};
use vc_graph::portable::Portable;
use vc_graph::{NodeId, Pose};

use crate::convert;
use crate::state::{Effector, Hand, PUSH};
use crate::world::PhysicsWorld;

/// The largest speed of a hand on its way, metres and radians per second.
const SPEED: f32 = 1.0;
const TURN: f32 = 4.0;
/// How far a hand that is stopped stays behind the point to which it is pulled, at most, metres.
const LEASH: f32 = 0.1;
/// Stiffness and damping of joints that pull, newtons and newton seconds per metre: a hand is critically damped.
const STIFFNESS: f32 = 2e4;
const DAMPING: f32 = 400.0;

/// The joint of an arm, which pulls to a set point. The orientation of the hand is kept whatever the hand meets, as the
/// force that moves it is limited.
pub(super) fn joint(set_point: &Pose) -> GenericJoint {
    let mut data = GenericJoint::new(JointAxesMask::ANG_AXES);
    data.set_local_frame1(convert::pose(set_point)).set_contacts_enabled(false);
    pull(&mut data, PUSH);
    data
}

/// Lets a joint pull its two frames together, with at most a force along each axis, newtons.
pub(super) fn pull(data: &mut GenericJoint, force: f32) {
    for axis in [JointAxis::LinX, JointAxis::LinY, JointAxis::LinZ] {
        data.set_motor_model(axis, MotorModel::ForceBased);
        data.set_motor(axis, 0.0, 0.0, STIFFNESS, DAMPING);
        data.set_motor_max_force(axis, force);
    }
}

impl Effector {
    /// The next point on the way to the goal; a hand that is stopped is waited for.
    fn advanced(&self, dt: f32) -> Pose {
        let (from, is) = (self.set_point.translation.vector, self.at.translation.vector);
        let way = self.goal.pose.translation.vector - from;
        let next = from + way * (SPEED * dt / way.norm().max(SPEED * dt));
        let waits = (next - is).norm() > LEASH.max((from - is).norm());
        let turn = turned(&self.set_point.rotation, &self.goal.pose.rotation, TURN * dt);
        Pose::from_parts(if waits { from } else { next }.into(), turn)
    }
}

impl PhysicsWorld {
    /// Pulls a hand on.
    pub(super) fn pull_hand(&mut self, agent: NodeId, hand: Hand) {
        let dt = self.settings.dt;
        let Some(effector) = self.effectors.get_mut(&(agent, hand)) else { return };
        let (next, force) = (effector.advanced(dt), effector.goal.force);
        effector.set_point = next;
        let Some(feet) = self.agents.get(&agent).map(|agent| agent.feet) else { return };
        let (frame, arm) = (convert::pose(&(feet * next)), effector.arm);
        // A hand that is at its goal may sleep.
        let moves = self.engine.joints.get(arm).is_some_and(|joint| joint.data.local_frame1 != frame);
        if let Some(joint) = self.engine.joints.get_mut(arm, moves).filter(|_| moves) {
            joint.data.set_local_frame1(frame);
        }
        if let Some(joint) = effector.grasp.and_then(|grasp| self.engine.joints.get_mut(grasp.joint, moves)) {
            pull(&mut joint.data, force);
        }
    }
}

/// A rotation on the shortest way to another one, at most an angle farther, radians.
fn turned(from: &UnitQuaternion<f32>, to: &UnitQuaternion<f32>, most: f32) -> UnitQuaternion<f32> {
    let between = from.inverse() * to;
    let sign = if between.w < 0.0 { -1.0 } else { 1.0 };
    let (sine, cosine) = (between.imag() * sign, between.w * sign);
    if 2.0 * sine.norm().angle_to(cosine) <= most {
        return *to;
    }
    let axis = sine.try_normalize(1e-9).unwrap_or_default();
    let (sin, cos) = (most / 2.0).sine_cosine();
    UnitQuaternion::new_normalize(
        (from * UnitQuaternion::new_normalize(Quaternion::from_parts(cos, axis * sin))).into_inner(),
    )
}
