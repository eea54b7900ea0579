//! Queries about distances: which objects an agent is near, and which it faces.

use super::SceneGraph;
use crate::node::{Node, NodeKind};
use crate::{Edge, NodeId, Place, Relation};

/// The distance up to which an object counts as near: within reach of an agent's step and arm, metres.
/// VirtualHome's CLOSE uses the same value.
pub const NEAR: f32 = 1.5;

impl SceneGraph {
    /// Whether an agent is near an object. It is if the agent holds or wears it or rests on it; if the graph
    /// says so; if poses are known, the room is the same and its box is within [`NEAR`] metres; or if the
    /// object rests on or in something near, or is near the same object as the agent (VirtualHome's rule).
    ///
    /// The last case does not reach into the next room: if poses and rooms are known, a picture on the other
    /// side of the wall that the agent stands at is not near.
    pub fn near(&self, agent: NodeId, id: NodeId) -> bool {
        let (Some(body), Some(node)) = (self.node(agent), self.node(id)) else { return false };
        if node.affords(crate::Property::BodyPart) || body.has(Relation::Near, id) {
            return true;
        }
        if node.kind() == NodeKind::Room {
            return self.room_of(agent) == Some(id);
        }
        if self.within_reach(body, node) {
            return true;
        }
        let here = !self.is_next_door(body, node);
        let at_hand = |p: Place| p.at == agent || (here && body.has(Relation::Near, p.at));
        self.climb(id, &mut { at_hand }).is_some() || self.rests_at(agent, id) || (here && body.is_near_what(node))
    }

    /// Whether the object is known to be in another room, by poses and rooms: then the object that both are
    /// near is the door or the wall between them.
    fn is_next_door(&self, agent: &Node, node: &Node) -> bool {
        let rooms = (self.room_of(agent.id), self.room_of(node.id));
        agent.pose.is_some() && node.pose.is_some() && rooms.0.is_some() && rooms.1.is_some() && rooms.0 != rooms.1
    }

    fn within_reach(&self, agent: &Node, node: &Node) -> bool {
        self.room_of(agent.id) == self.room_of(node.id) && self.distance(agent.id, node.id).is_some_and(|d| d <= NEAR)
    }

    /// Horizontal distance from a node's position to another's box (to its position, if it has no box), metres;
    /// `None` without poses.
    pub fn distance(&self, from: NodeId, to: NodeId) -> Option<f32> {
        let start = self.node(from)?.position()?;
        let target = self.node(to)?;
        let nearest = match target.aabb() {
            Some(aabb) => aabb.nearest(&start),
            None => target.position()?,
        };
        Some((nearest - start).xy().norm())
    }

    /// Whether an agent faces an object, directly or through one intermediate object (a computer screen that
    /// the agent faces may itself face the object).
    pub fn facing(&self, agent: NodeId, id: NodeId) -> bool {
        self.has(Edge::new(agent, Relation::Facing, id))
            || self.related(agent, Relation::Facing).any(|n| self.has(Edge::new(n, Relation::Facing, id)))
    }
}
