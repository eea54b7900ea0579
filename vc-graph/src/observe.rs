//! Observations: the part of a scene that an agent sees.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::node::NodeKind;
use crate::{Edge, Node, NodeId, Place, Relation, SceneGraph};

/// The range of an observation.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder, Scope};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
/// let milk = scene.add_in(fridge, Draft::new("milk"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let graph = scene.build();
/// assert!(!graph.observe(me, Scope::Room).sees(milk), "the fridge is closed");
/// assert!(graph.observe(me, Scope::Whole).sees(milk));
/// # Ok::<(), vc_graph::EditError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
pub enum Scope {
    /// The agent's room, as in the thesis's belief.
    Room,
    /// A radius around the agent, metres; needs poses. A negative radius or NaN covers nothing: the agent sees
    /// only the rooms, itself and the objects it carries.
    Radius(f32),
    /// Everything, including the contents of closed containers: full observability.
    Whole,
}

/// An agent's observation: a snapshot that shares its nodes with the scene.
///
/// With the scopes room and radius the agent sees everything in range that is not inside a closed container,
/// and always all rooms, itself, and the objects it holds and wears. A relation is visible if both ends are.
#[derive(Debug, Clone)]
pub struct Observation {
    agent: NodeId,
    scope: Scope,
    room: Option<NodeId>,
    nodes: Vec<Arc<Node>>,
}

impl SceneGraph {
    /// The part of the scene that an agent sees; empty if there is no such node. Costs a check of each node in
    /// range.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder, Scope};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let milk = scene.add_in(fridge, Draft::new("milk"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let graph = scene.build();
    /// assert!(!graph.observe(me, Scope::Room).sees(milk)); // the fridge is closed
    /// assert!(graph.observe(me, Scope::Whole).sees(milk));
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    pub fn observe(&self, agent: NodeId, scope: Scope) -> Observation {
        let room = self.room_of(agent);
        if self.node(agent).is_none() {
            return Observation { agent, scope, room, nodes: Vec::new() };
        }
        let mut seen: Vec<NodeId> = match scope {
            Scope::Whole => self.nodes().map(Node::id).collect(),
            Scope::Room => room.into_iter().flat_map(|r| self.in_room(r)).filter(|&id| self.open_to_view(id)).collect(),
            Scope::Radius(radius) => self.seen_within(agent, radius),
        };
        if scope != Scope::Whole {
            seen.extend_from_slice(self.rooms());
            seen.extend(self.carried_with(agent).into_iter().filter(|&id| self.open_to_view(id)));
            seen.sort_unstable();
            seen.dedup();
        }
        let nodes = seen.into_iter().filter_map(|id| self.nodes.get(id)).cloned().collect();
        Observation { agent, scope, room, nodes }
    }

    /// The part of a room that somebody sees from elsewhere, such as through the open door of another scene: the room and
    /// those of its nodes for which `sees` holds, without what is inside closed containers. Costs a check of each node in the
    /// room.
    ///
    /// ```
    /// use vc_graph::{Draft, NodeId, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let milk = scene.add_in(fridge, Draft::new("milk"))?;
    /// let table = scene.add_in(kitchen, Draft::new("table"))?;
    /// let graph = scene.build();
    /// let seen = graph.glimpse(NodeId(900), kitchen, |node| node.id() != table);
    /// assert_eq!(seen.ids().collect::<Vec<_>>(), [kitchen, fridge]);
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    pub fn glimpse(&self, agent: NodeId, room: NodeId, sees: impl Fn(&Node) -> bool) -> Observation {
        let is_seen = |id: &NodeId| self.node(*id).is_some_and(&sees) && self.open_to_view(*id);
        let mut seen: Vec<NodeId> = self.in_room(room).filter(is_seen).collect();
        seen.extend(self.rooms().contains(&room).then_some(room));
        seen.sort_unstable();
        seen.dedup();
        let nodes = seen.into_iter().filter_map(|id| self.nodes.get(id)).cloned().collect();
        Observation { agent, scope: Scope::Room, room: Some(room), nodes }
    }

    fn open_to_view(&self, id: NodeId) -> bool {
        self.hidden_in(id).is_none()
    }

    fn seen_within(&self, agent: NodeId, radius: f32) -> Vec<NodeId> {
        let Some(centre) = self.node(agent).and_then(Node::position) else { return Vec::new() };
        self.within(centre, radius).into_iter().filter(|&id| self.open_to_view(id)).collect()
    }
}

impl Observation {
    /// The observing agent.
    pub fn agent(&self) -> NodeId {
        self.agent
    }

    /// The range of the observation.
    pub fn scope(&self) -> Scope {
        self.scope
    }

    /// The room that the agent is in; of a [glimpse](SceneGraph::glimpse) the one that it sees into.
    pub fn room(&self) -> Option<NodeId> {
        self.room
    }

    /// All visible nodes, in number order.
    pub fn ids(&self) -> impl Iterator<Item = NodeId> + '_ {
        self.nodes.iter().map(|n| n.id())
    }

    /// Number of visible nodes.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Whether nothing is visible.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// Whether a node is visible.
    pub fn sees(&self, id: NodeId) -> bool {
        self.get(id).is_some()
    }

    /// A visible node: its specification, states and pose. [`Observation::relations`] lists its relations.
    pub fn get(&self, id: NodeId) -> Option<&Node> {
        let position = self.nodes.binary_search_by_key(&id, |n| n.id()).ok()?;
        Some(&self.nodes[position])
    }

    /// All visible nodes, in number order.
    pub fn nodes(&self) -> impl Iterator<Item = &Node> {
        self.nodes.iter().map(Arc::as_ref)
    }

    /// The relations whose ends are both visible.
    pub fn relations(&self) -> impl Iterator<Item = Edge> + '_ {
        let edges = self.nodes().flat_map(|n| n.out.iter().map(|l| Edge::new(n.id, l.relation(), l.node())));
        edges.filter(|e| self.sees(e.to))
    }

    /// The relations of a kind from a visible node to visible nodes.
    pub fn related(&self, from: NodeId, relation: Relation) -> impl Iterator<Item = Edge> + '_ {
        let targets = self.get(from).into_iter().flat_map(move |n| n.out(relation));
        targets.filter(|&to| self.sees(to)).map(move |to| Edge::new(from, relation, to))
    }

    /// The visible placements of a visible object.
    pub fn places(&self, id: NodeId) -> impl Iterator<Item = Place> + '_ {
        let node = self.get(id);
        let holders = node.into_iter().flat_map(Node::holders);
        holders.chain(node.into_iter().flat_map(Node::resting)).filter(|p| self.sees(p.at))
    }

    /// The room of a visible object.
    pub fn room_of(&self, id: NodeId) -> Option<NodeId> {
        let node = self.get(id)?;
        if node.kind() == NodeKind::Room { Some(id) } else { node.out(Relation::InRoom).next() }
    }

    /// The visible part as a scene of its own.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder, Scope};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let milk = scene.add_in(fridge, Draft::new("milk"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let graph = scene.build();
    /// let seen = graph.observe(me, Scope::Room).to_graph(&graph);
    /// assert!(seen.node(fridge).is_some() && seen.node(milk).is_none());
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    pub fn to_graph(&self, of: &SceneGraph) -> SceneGraph {
        let mut part = SceneGraph::new(of.name.clone(), of.classes.clone());
        part.assets = of.assets.clone();
        for node in &self.nodes {
            let mut node = Node::clone(node);
            node.out.retain(|l| self.sees(l.node()));
            node.inc.retain(|l| self.sees(l.node()));
            part.insert(Arc::new(node));
        }
        part
    }
}
