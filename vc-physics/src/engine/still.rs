//! Stillness: bodies are put where they were recorded at rest, and nobody can tell how often that was done.

use rapier3d::dynamics::{RigidBody, RigidBodyHandle};
use rapier3d::math::{Pose as EnginePose, Rotation, Vector};

use super::Engine;
use crate::convert;

/// Rounds after which bodies that do not stay where they are put never will. One is the rule.
const ROUNDS: usize = 8;

impl Engine {
    /// Puts bodies to sleep where they were recorded at rest, and all others that are free to move where they are;
    /// returns whether they stay there. A step has to find the contacts before.
    ///
    /// A pose that is written counts as a change by the user, and the next step wakes all that is near. Therefore a step of
    /// no length takes the change up, then all fall asleep, a step without gravity sorts the sleepers, and two steps show
    /// whether anything still stirs.
    pub(crate) fn still_at(&mut self, poses: &[(RigidBodyHandle, EnginePose)]) -> bool {
        (0..ROUNDS).any(|_| {
            poses.iter().for_each(|(body, pose)| self.write_back(*body, pose));
            self.advance(0.0, self.gravity);
            let awake: Vec<RigidBodyHandle> = self.awake_bodies().collect();
            self.put_to_sleep(&awake);
            self.advance(self.parameters.dt, 0.0);
            self.step();
            self.step();
            let is_there = |(body, pose): &(RigidBodyHandle, EnginePose)| {
                self.bodies.get(*body).is_none_or(|b| same_rest(b.position(), pose))
            };
            self.is_at_rest() && poses.iter().all(is_there)
        })
    }

    /// The bodies that are free to move, and their poses.
    pub(crate) fn free_bodies(&self) -> Vec<(RigidBodyHandle, EnginePose)> {
        let free = self.bodies.iter().filter(|(_, body)| body.is_dynamic() && body.is_enabled());
        free.map(|(handle, body)| (handle, *body.position())).collect()
    }

    /// Writes a recorded pose, unless the body sleeps there.
    fn write_back(&mut self, body: RigidBodyHandle, pose: &EnginePose) {
        let moved = |b: &RigidBody| !same_rest(b.position(), pose) || (b.is_dynamic() && !b.is_sleeping());
        if self.bodies.get(body).is_some_and(moved)
            && let Some(rigid) = self.body_mut(body)
        {
            rigid.set_position(resting_pose(pose), false);
            rigid.set_linvel(Vector::ZERO, false);
            rigid.set_angvel(Vector::ZERO, false);
        }
    }

    /// Puts those of some bodies to sleep that are free to move.
    pub(crate) fn put_to_sleep(&mut self, bodies: &[RigidBodyHandle]) {
        for body in bodies {
            if let Some(rigid) = self.body_mut(*body).filter(|b| b.is_dynamic()) {
                rigid.sleep();
            }
        }
    }
}

/// The pose next to a given one, at most a few units in the last place away, whose rotation neither a step nor a
/// conversion changes: each of them normalizes it.
pub(crate) fn resting_pose(pose: &EnginePose) -> EnginePose {
    let rotation = pose.rotation.normalize();
    let components = rotation.to_array();
    let nudged = |(axis, by): (usize, i32)| {
        let mut near = components;
        near[axis] = f32::from_bits(near[axis].to_bits().wrapping_add_signed(by));
        Rotation::from_array(near)
    };
    let near = (0..4).rev().flat_map(|axis| (1..=5).flat_map(move |by| [(axis, by), (axis, -by)]));
    let stays = |rotation: &Rotation| {
        let there = EnginePose { rotation: *rotation, ..*pose };
        let bits = |r: Rotation| r.to_array().map(f32::to_bits);
        let back = convert::pose(&convert::isometry(&there)).rotation;
        bits(rotation.normalize()) == bits(*rotation) && bits(back) == bits(*rotation)
    };
    let mut candidates = std::iter::once(rotation).chain(near.map(nudged));
    EnginePose { rotation: candidates.find(stays).unwrap_or(rotation), ..*pose }
}

/// Whether two poses are the same for bodies at rest.
pub(crate) fn same_rest(one: &EnginePose, other: &EnginePose) -> bool {
    one == other || resting_pose(one) == resting_pose(other)
}
