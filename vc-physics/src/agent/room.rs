//! Room for a standing body.

use nalgebra::Point3;
use rapier3d::geometry::{Collider, ColliderHandle, SharedShape};
use rapier3d::math::Pose as EnginePose;
use rapier3d::parry::query;
use rapier3d::parry::shape::Capsule;
use rapier3d::pipeline::QueryFilter;
use vc_graph::{NodeId, Pose};

use crate::state::{Agent, BodyPlan, Posture, Thing};
use crate::world::PhysicsWorld;
use crate::{PhysicsError, convert, group};

/// How much of its radius is the middle of a body.
const SLIM: f32 = 0.5;

/// # Room for a body
impl PhysicsWorld {
    /// Whether an agent stands in a thing: the thing meets its middle, and not only its sides.
    pub(crate) fn is_stuck(&self, body: &Agent) -> bool {
        let slim = BodyPlan { radius: SLIM * body.plan.radius, ..body.plan };
        let thing = |c: &Collider| !self.agents.contains_key(&group::marked(c.user_data).0);
        body.posture == Posture::Standing && !self.has_room(&slim, &body.feet, thing)
    }

    /// The things and agents that an agent would overlap with its feet at a pose.
    pub(crate) fn obstacles_at(&self, body: &Agent, feet: &Pose) -> Vec<NodeId> {
        let mut found: Vec<NodeId> = self.overlapped_at(body, feet).into_iter().map(|(id, _)| id).collect();
        found.dedup();
        found
    }

    /// Whether an agent would stand free with its feet at a pose while the moving parts of a node are open by each of
    /// some fractions of their range.
    pub(crate) fn fits_with_open(
        &self,
        body: &Agent,
        feet: &Pose,
        id: NodeId,
        open: &[f32],
    ) -> Result<bool, PhysicsError> {
        for part in 0..self.thing(id)?.state.moving.len() {
            for &open in open {
                if self.meets_part(body, feet, id, part, open)? {
                    return Ok(false);
                }
            }
        }
        Ok(self.fits_but(body, feet, Some(id)))
    }

    /// Whether a body with its feet at a pose would overlap a part of a node that is open by a fraction.
    pub(super) fn meets_part(
        &self,
        body: &Agent,
        feet: &Pose,
        id: NodeId,
        part: usize,
        open: f32,
    ) -> Result<bool, PhysicsError> {
        let Some((solid, pose)) = self.part_at(id, part, open)? else { return Ok(false) };
        let (shape, at) = standing_capsule(&body.plan, feet);
        let between = at.inv_mul(&pose);
        let result = rapier3d::parry::query::intersection_test(&EnginePose::IDENTITY, &shape, &between, &*solid);
        Ok(result.is_ok_and(|result| result.intersecting))
    }

    /// Whether an agent's capsule is free at a spot, a little above the floor.
    pub(crate) fn fits(&self, body: &Agent, spot: &Pose) -> bool {
        self.fits_but(body, spot, None)
    }

    /// As `fits`, ignoring the moving parts of one node.
    fn fits_but(&self, body: &Agent, spot: &Pose, but: Option<NodeId>) -> bool {
        self.has_room(&body.plan, spot, |c| {
            let (id, link) = group::marked(c.user_data);
            c.parent() != Some(body.body) && (link == 0 || Some(id) != but)
        })
    }

    /// Whether nothing that counts is where a body would stand.
    fn has_room(&self, plan: &BodyPlan, spot: &Pose, counts: impl Fn(&Collider) -> bool) -> bool {
        let (shape, at) = standing_capsule(plan, spot);
        let solid = |_: ColliderHandle, c: &Collider| group::is_solid(c) && counts(c);
        let queries = self.engine.queries(QueryFilter::default().exclude_sensors().predicate(&solid));
        queries.intersect_shape(at, &shape).next().is_none()
    }

    /// Whether a thing at a pose would be clear of a body that stands with its feet somewhere.
    pub(crate) fn is_clear_of_body(&self, body: &Agent, feet: &Pose, thing: &Thing, pose: &Pose) -> bool {
        let (shape, at) = standing_capsule(&body.plan, feet);
        let mut solid = thing.form.links.iter().filter_map(|link| link.solid.as_ref());
        let meets = |part: &(SharedShape, EnginePose)| {
            let between = at.inv_mul(&(convert::pose(pose) * part.1));
            let contact = query::contact(&EnginePose::IDENTITY, &shape, &between, &*part.0, 0.0);
            contact.ok().flatten().is_some()
        };
        !solid.any(meets)
    }

    /// Whether an agent stands beside all floors, where there is no ground below.
    pub(crate) fn is_off_floor(&self, body: &Agent) -> bool {
        let middle = body.feet * Point3::new(0.0, 0.0, body.plan.height / 2.0);
        body.posture == Posture::Standing && self.is_over_nothing(&middle, body.body)
    }
}

/// The capsule of a standing agent, a little above the floor, and its pose.
pub(super) fn standing_capsule(plan: &BodyPlan, feet: &Pose) -> (Capsule, EnginePose) {
    let lift = 0.02;
    let half = (plan.height / 2.0 - plan.radius - lift).max(0.01);
    let at = convert::pose(&(feet * Pose::translation(0.0, 0.0, plan.height / 2.0 + lift)));
    (Capsule::new_z(half, plan.radius), at)
}
