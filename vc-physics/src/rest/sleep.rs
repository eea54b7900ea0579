//! Early sleep for things that are certainly at rest.
//!
//! The engine lets a body sleep only after it has been slow for a while, because a slow body may be about to
//! tip. For most things statics decides at once: a thing cannot tip if its centre of mass is over the middle of
//! its supporting points and nothing presses on it beside them. And a thing that is where it was at rest,
//! between things for which the same holds, is at rest: books that lean on each other.

use std::collections::BTreeMap;

use nalgebra::Point2;
use rapier3d::dynamics::{RigidBody, RigidBodyHandle};
use vc_geometry::outline::{Outline, hull, turn};

use crate::contact::Touch;
use crate::state::{Spot, Thing};
use crate::world::PhysicsWorld;
use crate::{BodyRole, convert, group};

/// The largest speed of a thing at rest, including its rim, metres per second.
const SLOW: f32 = 0.03;
/// The largest speed of a thing that has not been moved, metres per second, and its largest distance from its
/// former position, metres.
const STILL: f32 = 0.01;
const SAME: f32 = 0.0005;
/// The smallest distance of a thing's centre of mass inside its supporting points, metres; for small things, as
/// a fraction of their size.
const WITHIN: (f32, f32) = (0.004, 0.05);
/// The largest distance beside the supporting points at which something may press, metres: edges of stacked
/// things lie on each other.
const BESIDE: f32 = 0.004;
/// The cosine of the slope from which on a thing may slide.
const LEVEL: f32 = 0.94;
/// The vertical component of a normal below which a contact is lateral.
const UPRIGHT: f32 = 0.2;
/// The largest gap at which a point carries, metres.
const CARRIES: f32 = 0.0015;
/// The overlap from which on things are pushed apart, metres.
const DEEP: f32 = 0.003;

impl PhysicsWorld {
    /// Puts the things to sleep that are certainly at rest: they are slow, and they and all awake things that
    /// they touch stand on their supports such that they cannot tip. All others stay awake. Call it a few steps
    /// after things were placed: things in the air are falling by then.
    ///
    /// Costs a few microseconds for each awake thing.
    pub fn put_to_sleep(&mut self) {
        let awake: Vec<RigidBodyHandle> = self.engine.awake_bodies().collect();
        let moves =
            |b: &RigidBodyHandle| self.engine.bodies.get(*b).is_some_and(|b| b.is_dynamic() && !b.is_sleeping());
        let awake: Vec<RigidBodyHandle> = awake.into_iter().filter(moves).collect();
        let number: BTreeMap<u32, usize> = (0..).zip(&awake).map(|(i, b)| (b.into_raw_parts().0, i)).collect();
        let near: Vec<Vec<usize>> = awake.iter().map(|b| self.touched(*b, &number)).collect();
        let mut restless: Vec<usize> = (0..awake.len()).filter(|&i| !self.certainly_rests(awake[i])).collect();
        let mut stays = vec![false; awake.len()];
        restless.iter().for_each(|&i| stays[i] = true);
        while let Some(i) = restless.pop() {
            for &j in &near[i] {
                if !std::mem::replace(&mut stays[j], true) {
                    restless.push(j);
                }
            }
        }
        for (body, _) in awake.into_iter().zip(stays).filter(|(_, stays)| !stays) {
            // The engine's rest timer is set to its limit. If a single body of an island were put to sleep
            // directly, it would wake again and fall for a step before its contacts are known.
            if let Some(rigid) = self.engine.body_mut(body) {
                let activation = rigid.activation_mut();
                activation.time_since_can_sleep = activation.time_until_sleep;
            }
        }
    }

    /// The bodies in a set that a body touches or is about to touch.
    fn touched(&self, body: RigidBodyHandle, number: &BTreeMap<u32, usize>) -> Vec<usize> {
        self.bodies_touched(body).filter_map(|b| number.get(&b.into_raw_parts().0).copied()).collect()
    }

    /// The bodies that a body touches or is about to touch.
    pub(super) fn bodies_touched(&self, body: RigidBodyHandle) -> impl Iterator<Item = RigidBodyHandle> + '_ {
        let parent = |c| self.engine.colliders.get(c).and_then(|c| c.parent());
        let pairs = self.pairs_of(body).filter(|p| p.has_any_active_contact());
        let bodies = pairs.flat_map(move |p| [parent(p.collider1), parent(p.collider2)]).flatten();
        bodies.filter(move |b| *b != body)
    }

    fn certainly_rests(&self, body: RigidBodyHandle) -> bool {
        let Some(rigid) = self.engine.bodies.get(body) else { return false };
        let (id, link) = group::marked(rigid.user_data);
        let Ok(thing) = self.thing(id) else { return false };
        let (low, high) = thing.form.extent;
        let size = (high - low).norm() / 2.0;
        if rigid.linvel().length() + rigid.angvel().length() * size > SLOW {
            return false;
        }
        if link > 0 {
            // Friction holds the door; otherwise it would be faster by now.
            return !self.is_driven(id);
        }
        if self.is_where_it_slept(thing, rigid, size) {
            return true;
        }
        let alone = thing.state.role == BodyRole::Loose && thing.state.moving.iter().all(|m| m.body.is_none());
        alone && self.stands(body, rigid, size)
    }

    /// Records the poses of bodies that have fallen asleep.
    pub(crate) fn record_sleepers(&mut self, were_awake: &[RigidBodyHandle]) {
        for &handle in were_awake {
            let Some(body) = self.engine.bodies.get(handle).filter(|b| b.is_dynamic() && b.is_sleeping()) else {
                continue;
            };
            let (spot, (id, link)) = (Spot::new(body.position()), group::marked(body.user_data));
            if let Some(thing) = self.thing_mut(id).ok().filter(|_| link == 0) {
                thing.state.slept = Some(spot);
            }
        }
    }

    /// Whether a thing is still where it was at rest. The same is tested for the things that it touches, so it
    /// is supported as before.
    fn is_where_it_slept(&self, thing: &Thing, rigid: &RigidBody, size: f32) -> bool {
        let still = rigid.linvel().length() + rigid.angvel().length() * size <= STILL;
        let now = Spot::new(rigid.position());
        still && thing.state.slept.is_some_and(|spot| spot.distance(&now, thing.form.extent) <= SAME)
    }

    /// Whether a body cannot tip, by the test in the module's description.
    fn stands(&self, body: RigidBodyHandle, rigid: &RigidBody, size: f32) -> bool {
        let (mut carry, mut press) = (Vec::new(), Vec::new());
        for pair in self.pairs_of(body).filter(|p| p.has_any_active_contact()) {
            let first = self.engine.colliders.get(pair.collider1).and_then(|c| c.parent()) == Some(body);
            for Touch { normal, at, gap, .. } in self.touches(pair) {
                let up = if first { -normal.z } else { normal.z };
                match up {
                    _ if gap < -DEEP => return false,
                    _ if up >= LEVEL => carry.extend((gap <= CARRIES).then_some(at)),
                    _ if up <= -LEVEL => press.push(at.xy()),
                    _ if up.abs() > UPRIGHT => return false,
                    _ => {}
                }
            }
        }
        let base = hull(carry.iter().map(|at| at.xy()));
        let centre = convert::point3(rigid.center_of_mass()).xy();
        let margin = WITHIN.0.min(WITHIN.1 * size);
        is_within(&base, &centre, margin) && press.iter().all(|p| is_within(&base, p, -BESIDE))
    }
}

/// Whether a point is within a convex outline by a margin.
fn is_within(outline: &Outline, point: &Point2<f32>, margin: f32) -> bool {
    let edges = outline.iter().zip(outline.iter().cycle().skip(1));
    let inside = |(a, b): (&Point2<f32>, &Point2<f32>)| turn(a, b, point) >= margin * (b - a).norm();
    outline.len() > 2 && edges.into_iter().all(inside)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_near_an_edge_is_not_within() {
        let square: Outline = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| Point2::new(x, y)).into();
        assert!(is_within(&square, &Point2::new(0.5, 0.5), 0.1));
        assert!(!is_within(&square, &Point2::new(0.95, 0.5), 0.1));
        assert!(is_within(&square, &Point2::new(1.05, 0.5), -0.1));
        assert!(!is_within(&square[..2].to_vec(), &Point2::new(0.5, 0.0), 0.0));
    }
}
