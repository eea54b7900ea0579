//! A scene as VirtualHome's simulator sees it.

use super::order::walked;
use crate::node::NodeKind;
use crate::{Edge, Node, NodeId, Property, Relation, SceneGraph, State};

/// The relations that VirtualHome's actions use.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Link {
    On,
    Inside,
    Close,
    Facing,
    HoldsRight,
    HoldsLeft,
}

impl Link {
    pub(super) const HANDS: [Self; 2] = [Self::HoldsRight, Self::HoldsLeft];

    /// The corresponding relations of VirtualCity: in VirtualHome an agent that sits on something is `ON` it,
    /// and an object in a room is `INSIDE` it.
    pub(super) fn relations(self) -> &'static [Relation] {
        use Relation::{
            Facing, HoldsLeft, HoldsRight, InRoom, Inside, LyingOn, Near, On, PouredInto, SittingOn, WornBy,
        };
        match self {
            Self::On => &[On, WornBy, SittingOn, LyingOn],
            Self::Inside => &[Inside, InRoom, PouredInto],
            Self::Close => &[Near],
            Self::Facing => &[Facing],
            Self::HoldsRight => &[HoldsRight],
            Self::HoldsLeft => &[HoldsLeft],
        }
    }
}

/// A scene, and the acting agent.
#[derive(Clone, Copy)]
pub(super) struct View<'a> {
    pub(super) graph: &'a SceneGraph,
    pub(super) agent: NodeId,
}

impl<'a> View<'a> {
    /// The nodes to which a relation leads, in the iteration order of a Python set.
    pub(super) fn targets(self, id: NodeId, link: Link) -> Vec<NodeId> {
        let mut all: Vec<u32> = link.relations().iter().flat_map(|&r| self.graph.related(id, r)).map(|n| n.0).collect();
        // VirtualHome inserts new relations before old ones, and an agent's are new.
        all.sort_unstable_by_key(|&n| (!self.graph.agents().contains(&NodeId(n)), n));
        walked(all).map(NodeId).collect()
    }

    /// The nodes from which a relation comes.
    pub(super) fn sources(self, link: Link, id: NodeId) -> Vec<NodeId> {
        let mut all: Vec<NodeId> = link.relations().iter().flat_map(|&r| self.graph.relating(r, id)).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    pub(super) fn has(self, from: NodeId, link: Link, to: NodeId) -> bool {
        link.relations().iter().any(|&r| self.graph.has(Edge::new(from, r, to)))
    }

    pub(super) fn node(self, id: NodeId) -> Option<&'a Node> {
        self.graph.node(id)
    }

    pub(super) fn is_room(self, id: NodeId) -> bool {
        self.node(id).is_some_and(|n| n.kind() == NodeKind::Room)
    }

    /// Whether an object's own properties, as written, include one of these.
    pub(super) fn is_any(self, id: NodeId, properties: &[Property]) -> bool {
        self.node(id).is_some_and(|n| properties.iter().any(|&p| n.spec().properties.contains(p)))
    }

    /// The class as written.
    pub(super) fn name(self, id: NodeId) -> &'a str {
        self.node(id).map_or("", |n| &n.spec().spelling)
    }

    pub(super) fn is(self, id: NodeId, state: State) -> bool {
        self.node(id).is_some_and(|n| n.is(state))
    }

    /// The room of an object: the first that it is directly inside.
    pub(super) fn room(self, id: NodeId) -> Option<NodeId> {
        if self.is_room(id) {
            return Some(id);
        }
        self.targets(id, Link::Inside).into_iter().find(|&n| self.is_room(n))
    }

    pub(super) fn held(self) -> Vec<NodeId> {
        Link::HANDS.into_iter().flat_map(|hand| self.targets(self.agent, hand)).collect()
    }

    pub(super) fn holds(self, id: NodeId) -> bool {
        Link::HANDS.into_iter().any(|hand| self.has(self.agent, hand, id))
    }

    pub(super) fn free_hand(self) -> Option<Link> {
        Link::HANDS.into_iter().find(|&hand| self.targets(self.agent, hand).is_empty())
    }

    /// Whether an object is close to the agent, close to something close, or on it.
    pub(super) fn near(self, id: NodeId) -> bool {
        let through = |at: NodeId| self.has(at, Link::Close, id) || self.has(id, Link::On, at);
        self.has(self.agent, Link::Close, id) || self.graph.related(self.agent, Relation::Near).any(through)
    }

    /// Whether the agent faces an object, directly or through an object that it faces.
    pub(super) fn faces(self, id: NodeId) -> bool {
        self.has(self.agent, Link::Facing, id)
            || self.targets(self.agent, Link::Facing).into_iter().any(|at| self.has(at, Link::Facing, id))
    }

    /// The closed container that directly contains an object.
    pub(super) fn shut_in(self, id: NodeId) -> Option<NodeId> {
        self.targets(id, Link::Inside).into_iter().find(|&at| !self.is_room(at) && self.is(at, State::Closed))
    }

    /// The node from which an object is grabbed: the first one, except rooms, that it is on, else inside, else
    /// close to.
    pub(super) fn origin(self, id: NodeId) -> Option<(NodeId, Link)> {
        [Link::On, Link::Inside, Link::Close]
            .into_iter()
            .find_map(|link| Some((self.targets(id, link).into_iter().find(|&at| !self.is_room(at))?, link)))
    }
}
