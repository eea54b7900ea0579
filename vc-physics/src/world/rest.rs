//! How things come to rest: rolling and rocking are slowed down, trembling things may sleep.
//!
//! The engine has no rolling resistance, and it lets bodies sleep by how far they move
//! in a single step. Things on small feet can tremble for long, to and fro by less than
//! a millimetre; things with small rims creep on, as their contact points jump. They are watched: what stays
//! about where it is, or is for long so slow that rolling resistance would have stopped it, counts as at rest.

use nalgebra::Point3;
use rapier3d::dynamics::{RigidBody, RigidBodyActivation, RigidBodyHandle};
use rapier3d::math::{Pose as EnginePose, Vector};
use serde::{Deserialize, Serialize};
use vc_graph::NodeId;

use super::{Thing, World};
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

/// Smallest and largest corner of a thing in its own frame.
type Extent = (Point3<f32>, Point3<f32>);

/// Where a thing is and how it is turned.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Spot(EnginePose);

impl Spot {
    pub(super) fn of(pose: &EnginePose) -> Self {
        Self(*pose)
    }

    /// The greatest distance of a corner of a thing from where it is at another spot, metres. If a thing only
    /// turns about its axis, that is at most its diagonal across the axis.
    pub(super) fn distance(&self, other: &Self, (low, high): Extent) -> f32 {
        let corner =
            |i: usize| Vector::from_array(std::array::from_fn(|k| if i >> k & 1 == 0 { low[k] } else { high[k] }));
        let far = |p: Vector| (self.0 * p).distance(other.0 * p);
        (0..8).map(|i| far(corner(i))).fold(0.0, f32::max)
    }
}

/// Where a thing was first seen that has not gone far since, or has been slow all the time, and how often
/// it has been seen so.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Watch {
    at: Spot,
    looks: u8,
}

impl Watch {
    /// Looks again at a thing.
    fn look(&mut self, pose: &EnginePose, extent: Extent, slow: bool) {
        let now = Spot::of(pose);
        if now.distance(&self.at, extent) > ABOUT {
            (self.at, self.looks) = (now, if slow { self.looks } else { 0 });
        }
        self.looks = self.looks.saturating_add(1);
    }

    /// Whether the thing is where it was, or has been slow, for long.
    fn is_calm(&self) -> bool {
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
            let slow = self.thing(id).is_ok_and(|thing| self.would_have_stopped(thing));
            let Some(thing) = self.thing_mut(id).ok().filter(|_| link == 0) else { continue };
            thing.state.watch.look(&pose, thing.form.extent, slow);
            let calm = thing.state.watch.is_calm();
            let limit = if calm { TREMBLES } else { RigidBodyActivation::default_normalized_linear_threshold() };
            if body_limit != limit
                && let Some(body) = self.engine.bodies.get_mut(handle)
            {
                body.activation_mut().normalized_linear_threshold = limit;
            }
            if calm && slow && self.rolls(handle) {
                self.halt(id);
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
            let (spin, speed) = (body.angvel(), body.angvel().length());
            let axis = spin / speed;
            let ease = (body.mass_properties().effective_world_inv_inertia * axis).dot(axis);
            let kept = (1.0 - lever(thing) * body.mass() * gravity * ease * dt / speed).max(0.0);
            if let Some(body) = self.engine.bodies.get_mut(handle) {
                body.set_angvel(spin * kept, false);
            }
        }
    }

    /// Whether a thing has no more energy, its parts with it, than rolling resistance takes from it on a way
    /// that is too short to count: whatever has so little for long is kept going by the engine alone.
    fn would_have_stopped(&self, thing: &Thing) -> bool {
        let bodies = || thing.bodies().filter_map(|b| self.engine.bodies.get(b));
        let weight = bodies().map(RigidBody::mass).sum::<f32>() * self.settings.gravity.abs();
        // A thing that is not round is no easier to roll than one that is.
        let part = thing.state.rolling.max(lever(thing) / radius(thing));
        bodies().map(RigidBody::kinetic_energy).sum::<f32>() <= part * weight * ABOUT
    }

    /// Stops a thing that creeps on, and tells the engine that it has been still for long enough.
    fn halt(&mut self, id: NodeId) {
        let bodies: Vec<RigidBodyHandle> = self.thing(id).map_or_else(|_| Vec::new(), |t| t.bodies().collect());
        for handle in bodies {
            let Some(body) = self.engine.bodies.get_mut(handle).filter(|b| b.is_dynamic()) else { continue };
            body.set_linvel(Vector::ZERO, false);
            body.set_angvel(Vector::ZERO, false);
            let activation = body.activation_mut();
            activation.time_since_can_sleep = activation.time_until_sleep;
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

/// The lever of rolling resistance of a thing, metres.
fn lever(thing: &Thing) -> f32 {
    let soft = thing.state.rolling * radius(thing);
    if thing.form.links[0].round { soft.max(FLATTENED) } else { (soft + FLATTENED).min(TIPS) }
}

/// The radius of a thing that rolls on its side: half of its least measure, metres.
fn radius(thing: &Thing) -> f32 {
    let (low, high) = thing.form.extent;
    (high - low).min() / 2.0
}
