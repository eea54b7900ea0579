//! Queries about relations: edges, hands, supports and containers.

use super::SceneGraph;
use crate::node::Node;
use crate::visit_order::VisitOrder;
use crate::{Edge, NodeId, Place, Relation};

impl SceneGraph {
    /// The nodes that a relation leads to from a node.
    pub fn related(&self, from: NodeId, relation: Relation) -> impl Iterator<Item = NodeId> + '_ {
        self.node(from).into_iter().flat_map(move |n| n.out(relation))
    }

    /// The nodes from which a relation leads to a node.
    pub fn relating(&self, relation: Relation, to: NodeId) -> impl Iterator<Item = NodeId> + '_ {
        self.node(to).into_iter().flat_map(move |n| n.inc(relation))
    }

    /// Whether a relation holds as an edge of the graph.
    ///
    /// ```
    /// use vc_graph::{Draft, Edge, Relation, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let graph = scene.build();
    /// assert!(graph.has(Edge::new(apple, Relation::On, table)));
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    pub fn has(&self, edge: Edge) -> bool {
        self.node(edge.from).is_some_and(|n| n.has(edge.relation, edge.to))
    }

    /// All relations, ordered by start, kind and end; symmetric relations occur in both directions.
    pub fn edges(&self) -> impl Iterator<Item = Edge> + '_ {
        self.nodes().flat_map(|n| n.out.iter().map(|l| Edge::new(n.id, l.relation(), l.node())))
    }

    /// The objects that an agent holds, the right hand first.
    pub fn held(&self, agent: NodeId) -> impl Iterator<Item = NodeId> + '_ {
        Relation::hands().into_iter().flat_map(move |hand| self.related(agent, hand))
    }

    /// A free hand of an agent, the right one first.
    ///
    /// ```
    /// use vc_graph::{Draft, Relation, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let mut graph = scene.build();
    /// assert_eq!(graph.free_hand(me), Some(Relation::HoldsRight));
    /// let mut edit = graph.edit();
    /// edit.hold(me, apple)?;
    /// edit.commit();
    /// assert_eq!(graph.free_hand(me), Some(Relation::HoldsLeft));
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    pub fn free_hand(&self, agent: NodeId) -> Option<Relation> {
        Relation::hands().into_iter().find(|&hand| self.related(agent, hand).next().is_none())
    }

    /// The agent that holds an object, and the hand.
    pub fn holder(&self, id: NodeId) -> Option<Place> {
        self.node(id)?.holders().next()
    }

    /// All direct placements of a node.
    pub fn places(&self, id: NodeId) -> impl Iterator<Item = Place> + '_ {
        let node = self.node(id);
        let holders = node.into_iter().flat_map(Node::holders);
        holders.chain(node.into_iter().flat_map(Node::resting))
    }

    /// The direct placement of a node; in nested containers the innermost. `None` for an object that stands in
    /// the room itself.
    ///
    /// If placements contradict each other, as in real scenes in which a pot is on a table and in a closed
    /// dishwasher beside it, containment wins: a support counts only if it is inside the same containers.
    ///
    /// ```
    /// use vc_graph::{Draft, Relation, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let milk = scene.add_in(fridge, Draft::new("milk"))?;
    /// let graph = scene.build();
    /// let place = graph.place(milk).ok_or("no place")?;
    /// assert_eq!((place.relation, place.at), (Relation::Inside, fridge));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn place(&self, id: NodeId) -> Option<Place> {
        let depth = |p: &Place| self.related(p.at, Relation::Inside).count();
        let within = |p: &Place| {
            p.relation == Relation::Inside
                || self.related(id, Relation::Inside).all(|c| c == p.at || self.rests_at(p.at, c))
        };
        let mut best: Option<(usize, Place)> = None;
        for place in self.places(id).filter(within) {
            let rank = depth(&place) + if place.relation == Relation::Inside { 0 } else { 1000 };
            if best.is_none_or(|(r, _)| rank > r) {
                best = Some((rank, place));
            }
        }
        best.map(|(_, place)| place)
    }

    /// Everything that directly rests on, in or with a node, or is held by it.
    pub fn resting_at(&self, id: NodeId) -> impl Iterator<Item = NodeId> + '_ {
        self.node(id).into_iter().flat_map(Node::carried)
    }

    /// The node and everything that moves with it, itself first.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let graph = scene.build();
    /// assert_eq!(graph.carried_with(table), [table, apple]);
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    pub fn carried_with(&self, id: NodeId) -> Vec<NodeId> {
        let mut met = VisitOrder::default();
        met.add(id);
        let mut next = 0;
        while let Some(node) = met.get(next) {
            next += 1;
            for child in self.resting_at(node) {
                met.add(child);
            }
        }
        met.into_vec()
    }

    /// The supports and containers of a node, direct and indirect, nearest first.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let graph = scene.build();
    /// assert!(graph.support_chain(apple).contains(&table));
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    pub fn support_chain(&self, id: NodeId) -> Vec<NodeId> {
        let mut chain = Vec::new();
        self.climb(id, &mut |place| {
            chain.push(place.at);
            false
        });
        chain
    }

    /// Visits the placements of a node upwards, nearest first, until `stop` returns `true`. The data may be
    /// cyclic and chains may have any length.
    pub(crate) fn climb(&self, id: NodeId, stop: &mut impl FnMut(Place) -> bool) -> Option<NodeId> {
        let mut met = VisitOrder::default();
        let (mut node, mut next) = (Some(id), 0);
        while let Some(from) = node {
            for place in self.places(from) {
                if met.add(place.at) && stop(place) {
                    return Some(place.at);
                }
            }
            node = met.get(next);
            next += 1;
        }
        None
    }

    /// The closed container that hides a node, the nearest if several do. A container that by the relations is
    /// inside itself, directly or indirectly, does not hide itself.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let milk = scene.add_in(fridge, Draft::new("milk"))?;
    /// let graph = scene.build();
    /// assert_eq!(graph.hidden_in(milk), Some(fridge)); // fridges start closed
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    pub fn hidden_in(&self, id: NodeId) -> Option<NodeId> {
        let shut = |p: Place| p.relation == Relation::Inside && self.node(p.at).is_some_and(Node::hides_contents);
        let closed = |p: Place| shut(p) && p.at != id && !self.rests_at(p.at, id);
        self.climb(id, &mut { closed })
    }

    /// Whether `id` rests on or in `at`, directly or through other objects.
    pub fn rests_at(&self, id: NodeId, at: NodeId) -> bool {
        self.climb(id, &mut |p| p.at == at).is_some()
    }
}
