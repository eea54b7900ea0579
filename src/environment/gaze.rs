//! The eyes' target: whoever has done something at a thing keeps it in view.

use nalgebra::Point3;
use vc_graph::{NodeId, NodeKind, Pose};

use super::Environment;

/// Farthest distance of a thing that is kept in view, metres, and how far to the side it is at most, as a slope:
/// whoever turns away, or is steered away, looks ahead again.
const WITHIN: f32 = 2.0;
const ASIDE: f32 = 1.0;
/// How far ahead the eyes look along a wide thing, metres.
const AHEAD: f32 = 1.0;

impl Environment {
    /// The point that an agent at rest keeps in view: that of the last thing it acted on.
    pub(crate) fn attention(&self, agent: NodeId) -> Option<Point3<f32>> {
        let last = self.history().events().iter().rev().find(|event| event.agent == agent)?;
        self.attended(agent, last.action.things())
    }

    /// The point to keep in view of the first of some things that is before an agent.
    pub(super) fn attended(&self, agent: NodeId, things: impl IntoIterator<Item = NodeId>) -> Option<Point3<f32>> {
        let feet = self.world().pose(agent)?;
        things.into_iter().find_map(|id| self.middle_before(&feet, id))
    }

    /// The middle of a thing, or of the part of a wide one that is ahead of some feet. There is none for what is
    /// held or worn, behind or far away.
    fn middle_before(&self, feet: &Pose, id: NodeId) -> Option<Point3<f32>> {
        let node = self.graph().node(id).filter(|node| node.kind() == NodeKind::Object)?;
        if self.world().holder(id).is_some() {
            return None;
        }
        let (aabb, ahead) = (node.aabb()?, feet * Point3::new(AHEAD, 0.0, 0.0));
        let mut point = aabb.nearest(&ahead);
        point.z = aabb.centre().z;
        let own = feet.inverse_transform_point(&point);
        (own.y.abs() < ASIDE * own.x && own.xy().coords.norm() < WITHIN).then_some(point)
    }
}
