//! Bodies that are displaced in a plan, while the world stays as it is: motions that follow each other are planned
//! without a copy of the world.

use rapier3d::dynamics::RigidBodyHandle;
use rapier3d::geometry::{Collider, ColliderHandle, SharedShape};
use rapier3d::math::Pose as EnginePose;
use rapier3d::parry::query::intersection_test;
use rapier3d::pipeline::QueryFilter;

use crate::world::PhysicsWorld;

/// Bodies, and the poses at which a plan has them.
#[derive(Default)]
pub(crate) struct Displaced(Vec<(RigidBodyHandle, EnginePose)>);

/// No body is displaced: the world as it is.
pub(crate) static NONE: Displaced = Displaced(Vec::new());

impl Displaced {
    /// Displaces a body to a pose.
    pub(crate) fn set(&mut self, body: RigidBodyHandle, pose: EnginePose) {
        self.0.retain(|(other, _)| *other != body);
        self.0.push((body, pose));
    }

    pub(crate) fn get(&self, body: RigidBodyHandle) -> Option<EnginePose> {
        self.0.iter().find(|(other, _)| *other == body).map(|(_, pose)| *pose)
    }

    fn has(&self, collider: &Collider) -> bool {
        !self.0.is_empty() && collider.parent().is_some_and(|body| self.get(body).is_some())
    }
}

impl PhysicsWorld {
    /// The pose of a body where some are displaced.
    pub(crate) fn body_pose(&self, body: RigidBodyHandle, displaced: &Displaced) -> Option<EnginePose> {
        displaced.get(body).or_else(|| self.engine.bodies.get(body).map(|b| *b.position()))
    }

    /// The pose of a collider where some bodies are displaced.
    pub(crate) fn collider_pose(&self, collider: ColliderHandle, displaced: &Displaced) -> Option<EnginePose> {
        let collider = self.engine.colliders.get(collider)?;
        let moved = collider.parent().and_then(|body| displaced.get(body));
        Some(moved.map_or_else(|| *collider.position(), |body| on_body(collider, &body)))
    }

    /// Calls `found` for each collider among some that a shape meets at a pose, with the collider's pose relative to
    /// the shape, until it returns false; returns whether it never did.
    pub(crate) fn each_met(
        &self,
        (shape, at): (&SharedShape, &EnginePose),
        among: &dyn Fn(&Collider) -> bool,
        displaced: &Displaced,
        found: &mut dyn FnMut(&Collider, EnginePose) -> bool,
    ) -> bool {
        let here = |_: ColliderHandle, c: &Collider| among(c) && !displaced.has(c);
        let queries = self.engine.queries(QueryFilter::default().exclude_sensors().predicate(&here));
        let mut near = queries.intersect_shape(*at, &**shape);
        let mut far = self.colliders_of_moved(displaced).filter(|(c, pose)| {
            let meets = || intersection_test(at, &**shape, pose, c.shape()).is_ok_and(|met| met.intersecting);
            among(c) && !c.is_sensor() && meets()
        });
        near.all(|(_, c)| found(c, at.inv_mul(c.position()))) && far.all(|(c, pose)| found(c, at.inv_mul(&pose)))
    }

    /// The colliders of bodies that are displaced, with their poses there.
    fn colliders_of_moved<'a>(
        &'a self,
        displaced: &'a Displaced,
    ) -> impl Iterator<Item = (&'a Collider, EnginePose)> + 'a {
        let moved = displaced.0.iter().filter_map(|(body, pose)| Some((self.engine.bodies.get(*body)?, pose)));
        let colliders = moved.flat_map(|(body, pose)| body.colliders().iter().map(move |c| (*c, pose)));
        colliders.filter_map(|(c, pose)| {
            let collider = self.engine.colliders.get(c)?;
            Some((collider, on_body(collider, pose)))
        })
    }
}

/// The pose of a collider with its body at a pose.
fn on_body(collider: &Collider, body: &EnginePose) -> EnginePose {
    *body * collider.position_wrt_parent().copied().unwrap_or_default()
}
