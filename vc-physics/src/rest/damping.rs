//! Coming to rest: rolling and rocking are damped, and trembling things may sleep.
//!
//! The engine has no rolling resistance, and decides about sleep by the motion of a body in a single step.
//! Things on small feet can tremble for long, to and fro by less than a millimetre; things with small rims
//! creep on, as their contact points jump. Therefore things are watched: a thing counts as at rest if it stays
//! at about the same pose, or is slow for so long that rolling resistance would have stopped it.

use rapier3d::dynamics::{RigidBody, RigidBodyActivation, RigidBodyHandle};
use rapier3d::math::Vector;
use vc_graph::NodeId;

use crate::group;
use crate::state::{ABOUT, Thing};
use crate::world::PhysicsWorld;

/// The smallest lever of rolling resistance, however hard a thing is, metres: handbooks of mechanics give 0.2
/// to 0.5 mm for steel and wood on wood.
const FLATTENED: f32 = 0.0005;
/// The largest lever for things that are not round, metres: with a longer one a thing could stay up with its
/// middle beyond the edge on which it stands.
const TIPS: f32 = 0.001;
/// The spin below which nothing is damped, radians per second.
const SLOW: f32 = 0.05;
/// Time between two checks of the poses, seconds.
const CHECK: f32 = 0.1;
/// The largest trembling speed of a thing that stays where it is, metres per second.
const TREMBLES: f32 = 1.0;

impl PhysicsWorld {
    /// Lets things sleep that merely tremble.
    pub(crate) fn watch(&mut self) {
        let every = (CHECK / self.settings.dt).round().max(1.0) as u64;
        if !self.ticks.is_multiple_of(every) {
            return;
        }
        let awake: Vec<RigidBodyHandle> = self.engine.awake_bodies().collect();
        self.stop_fallen(&awake);
        for handle in awake {
            let Some(body) = self.engine.bodies.get(handle).filter(|b| b.is_dynamic()) else { continue };
            let (pose, (id, link)) = (*body.position(), group::marked(body.user_data));
            let body_limit = body.activation().normalized_linear_threshold;
            let slow = self.thing(id).is_ok_and(|thing| self.would_have_stopped(thing));
            let Some(thing) = self.thing_mut(id).ok().filter(|_| link == 0) else { continue };
            thing.state.watch.update(&pose, thing.form.extent, slow);
            let still = thing.state.watch.is_still();
            let limit = if still { TREMBLES } else { RigidBodyActivation::default_normalized_linear_threshold() };
            if body_limit != limit
                && let Some(body) = self.engine.body_mut(handle)
            {
                body.activation_mut().normalized_linear_threshold = limit;
            }
            if still && slow && self.rolls(handle) {
                self.halt(id);
            }
        }
    }

    /// Damps things that turn on a support: rolling meets resistance, and rocking dies away.
    ///
    /// The resisting torque is the weight times a lever. The lever is a fraction of the radius, and at least
    /// half a millimetre, since nothing is perfectly hard; for things that are not round it is so small that
    /// they still tip.
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
            if let Some(body) = self.engine.body_mut(handle) {
                body.set_angvel(spin * kept, false);
            }
        }
    }

    /// Whether the kinetic energy of a thing and its parts is no more than rolling resistance would take from
    /// it over a negligible distance: a thing that has so little for long is kept moving by the engine alone.
    fn would_have_stopped(&self, thing: &Thing) -> bool {
        let bodies = || thing.bodies().filter_map(|b| self.engine.bodies.get(b));
        let weight = bodies().map(RigidBody::mass).sum::<f32>() * self.settings.gravity.abs();
        // A thing that is not round rolls no more easily than a round one.
        let part = thing.state.rolling.max(lever(thing) / radius(thing));
        bodies().map(RigidBody::kinetic_energy).sum::<f32>() <= part * weight * ABOUT
    }

    /// Stops a creeping thing, and sets the engine's rest timer to its limit.
    fn halt(&mut self, id: NodeId) {
        let bodies: Vec<RigidBodyHandle> = self.thing(id).map_or_else(|_| Vec::new(), |t| t.bodies().collect());
        for handle in bodies {
            let Some(body) = self.engine.body_mut(handle).filter(|b| b.is_dynamic()) else { continue };
            body.set_linvel(Vector::ZERO, false);
            body.set_angvel(Vector::ZERO, false);
            let activation = body.activation_mut();
            activation.time_since_can_sleep = activation.time_until_sleep;
        }
    }

    /// Whether a body is free to turn, turns, and touches something.
    fn rolls(&self, handle: RigidBodyHandle) -> bool {
        let Some(body) = self.engine.bodies.get(handle).filter(|b| b.is_dynamic()) else { return false };
        let turns = group::marked(body.user_data).1 == 0 && body.angvel().length_squared() > SLOW * SLOW;
        let touches = || body.colliders().iter().flat_map(|&c| self.engine.narrow.contact_pairs_with(c));
        turns && touches().any(|pair| pair.has_any_active_contact())
    }
}

/// The lever of a thing's rolling resistance, metres.
fn lever(thing: &Thing) -> f32 {
    let soft = thing.state.rolling * radius(thing);
    if thing.form.links[0].round { soft.max(FLATTENED) } else { (soft + FLATTENED).min(TIPS) }
}

/// The radius of a thing that rolls on its side: half of its smallest extent, metres.
fn radius(thing: &Thing) -> f32 {
    let (low, high) = thing.form.extent;
    (high - low).min() / 2.0
}
