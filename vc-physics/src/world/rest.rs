//! How things come to rest: rolling and rocking are slowed down, trembling things may sleep.
//!
//! The engine has no rolling resistance, and it lets bodies sleep by how far they move
//! in a single step. Things on small feet can tremble for long, to and fro by less than
//! a millimetre. They are watched: what stays about where it is counts as at rest.

use rapier3d::dynamics::{RigidBodyActivation, RigidBodyHandle};
use rapier3d::math::Pose as EnginePose;
use serde::{Deserialize, Serialize};
use vc_graph::portable::Portable;

use super::World;
use crate::group;

/// Least lever of rolling resistance, however hard a thing is, metres: 0.2 to 0.5 mm for steel and wood
/// on wood in handbooks of mechanics.
const FLATTENED: f32 = 0.0005;
/// Greatest lever for things that are not round, metres: with a longer one a thing could stay up with its
/// middle beyond the edge that it stands on.
const TIPS: f32 = 0.001;
/// Below which spin nothing is slowed down, radians a second.
const SLOW: f32 = 0.05;
/// Time between looks at where things are, seconds.
const LOOK: f32 = 0.1;
/// Within which distance a thing counts as where it was, metres.
const ABOUT: f32 = 0.02;
/// After how many looks it may tremble and sleep all the same.
const LOOKS: u8 = 4;
/// How fast what stays where it is may tremble, metres a second.
const TREMBLES: f32 = 1.0;

/// Where a thing is and how it is turned.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Spot([f32; 7]);

impl Spot {
    pub(super) fn of(pose: &EnginePose) -> Self {
        Self(std::array::from_fn(|i| match i {
            0..3 => pose.translation.to_array()[i],
            _ => pose.rotation.to_array()[i - 3],
        }))
    }

    /// How far a thing of a size is from another spot with any of its points, about, metres.
    pub(super) fn distance(&self, other: &Self, size: f32) -> f32 {
        let far = |from: usize, to: usize| (from..to).map(|i| (self.0[i] - other.0[i]).raised(2)).sum::<f32>().sqrt();
        // A turn by an angle moves the imaginary parts by half of it.
        far(0, 3) + 2.0 * far(3, 7) * size
    }
}

/// Where a thing was first seen that has not gone far since, and how often it has been
/// seen there.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Watch {
    at: Spot,
    looks: u8,
}

impl Watch {
    /// Looks again at a thing of a size; gives whether it has stayed.
    fn look(&mut self, pose: &EnginePose, size: f32) -> bool {
        let now = Spot::of(pose);
        if now.distance(&self.at, size) > ABOUT {
            (self.at, self.looks) = (now, 0);
        }
        self.looks = self.looks.saturating_add(1);
        self.looks > LOOKS
    }
}

impl World {
    /// Lets what only trembles sleep.
    pub(crate) fn watch(&mut self) {
        let every = (LOOK / self.settings.dt).round().max(1.0) as u64;
        if !self.ticks.is_multiple_of(every) {
            return;
        }
        let awake: Vec<RigidBodyHandle> = self.engine.awake_bodies().collect();
        self.stop_what_fell(&awake);
        for handle in awake {
            let Some(body) = self.engine.bodies.get(handle).filter(|b| b.is_dynamic()) else { continue };
            let (pose, (id, link)) = (*body.position(), group::marked(body.user_data));
            let body_limit = body.activation().normalized_linear_threshold;
            let Some(thing) = self.thing_mut(id).ok().filter(|_| link == 0) else { continue };
            let (low, high) = thing.form.extent;
            let calm = thing.state.watch.look(&pose, (high - low).norm() / 2.0);
            let limit = if calm { TREMBLES } else { RigidBodyActivation::default_normalized_linear_threshold() };
            if body_limit != limit
                && let Some(body) = self.engine.bodies.get_mut(handle)
            {
                body.activation_mut().normalized_linear_threshold = limit;
            }
        }
    }

    /// Slows down things that turn on something: rolling takes force, and rocking dies away.
    ///
    /// The torque against it is the weight times a lever: a part of the radius, and half a millimetre
    /// at least, as nothing is quite hard; for things that are not round, so little that they tip all
    /// the same.
    pub(crate) fn resist_rolling(&mut self) {
        let (dt, gravity) = (self.engine.dt(), self.settings.gravity.abs());
        let rolling: Vec<RigidBodyHandle> = self.engine.awake_bodies().filter(|&b| self.rolls(b)).collect();
        for handle in rolling {
            let Some(body) = self.engine.bodies.get(handle) else { continue };
            let Ok(thing) = self.thing(group::marked(body.user_data).0) else { continue };
            let (low, high) = thing.form.extent;
            let soft = thing.state.rolling * (high - low).min() / 2.0;
            let round = thing.form.links[0].rolls();
            let lever = if round { soft.max(FLATTENED) } else { (soft + FLATTENED).min(TIPS) };
            let (spin, speed) = (body.angvel(), body.angvel().length());
            let axis = spin / speed;
            let ease = (body.mass_properties().effective_world_inv_inertia * axis).dot(axis);
            let kept = (1.0 - lever * body.mass() * gravity * ease * dt / speed).max(0.0);
            if let Some(body) = self.engine.bodies.get_mut(handle) {
                body.set_angvel(spin * kept, false);
            }
        }
    }

    /// Whether a body is free to turn, does so, and touches something.
    fn rolls(&self, handle: RigidBodyHandle) -> bool {
        let Some(body) = self.engine.bodies.get(handle).filter(|b| b.is_dynamic()) else { return false };
        let turns = group::marked(body.user_data).1 == 0 && body.angvel().length_squared() > SLOW * SLOW;
        let touches = || body.colliders().iter().flat_map(|&c| self.engine.narrow.contact_pairs_with(c));
        turns && touches().any(|pair| pair.has_any_active_contact())
    }
}
