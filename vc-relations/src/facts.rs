//! Facts known beside the geometry: from joints, contacts and hands.

use std::collections::{BTreeMap, BTreeSet};

use vc_graph::{Edge, NodeId, Relation, SceneGraph};

use crate::evidence::Evidence;

/// The evidence, arranged for look-ups.
#[derive(Debug, Clone, Default)]
pub(crate) struct Facts {
    pub(crate) attached: BTreeMap<NodeId, Vec<NodeId>>,
    /// The inverse: for each parent the things attached to it.
    hinged: BTreeMap<NodeId, Vec<NodeId>>,
    /// Upward impulse on each thing by each other.
    pub(crate) pushed: BTreeMap<NodeId, BTreeMap<NodeId, f32>>,
    /// Edges of holding and wearing, by thing.
    held: BTreeMap<NodeId, Vec<Edge>>,
    holding: BTreeMap<NodeId, Vec<Edge>>,
    /// Everything that moves with somebody's hands, if that is known.
    carried: Option<BTreeSet<NodeId>>,
}

impl Facts {
    /// Collects the evidence, and the graph's edges of holding and wearing.
    pub(crate) fn from_scene(graph: &SceneGraph, evidence: &Evidence) -> Self {
        let mut facts = Self::new(evidence);
        graph.agents().iter().flat_map(|&agent| hands_of(graph, agent)).for_each(|edge| facts.hold(edge));
        facts
    }

    fn new(evidence: &Evidence) -> Self {
        let mut facts = Self::default();
        // A door with two hinges is attached to its wall once.
        for a in evidence.attachments.iter().collect::<BTreeSet<_>>() {
            facts.attached.entry(a.child).or_default().push(a.parent);
            facts.hinged.entry(a.parent).or_default().push(a.child);
        }
        for contact in &evidence.contacts {
            let (first, second) = contact.between;
            if contact.impulse.z.is_finite() && first != second {
                *facts.pushed.entry(second).or_default().entry(first).or_default() += contact.impulse.z;
                *facts.pushed.entry(first).or_default().entry(second).or_default() -= contact.impulse.z;
            }
        }
        for edge in &evidence.held {
            facts.hold(*edge);
        }
        facts.carried.clone_from(&evidence.carried);
        facts
    }

    /// Adds an edge of holding or wearing; other relations are ignored.
    pub(crate) fn hold(&mut self, edge: Edge) {
        let thing = match edge.relation {
            Relation::HoldsRight | Relation::HoldsLeft => edge.to,
            Relation::WornBy => edge.from,
            _ => return,
        };
        for (map, key) in [(&mut self.held, thing), (&mut self.holding, edge.from)] {
            let list = map.entry(key).or_default();
            if !list.contains(&edge) {
                list.push(edge);
            }
        }
    }

    /// Removes all edges of holding and wearing at a node, and returns them.
    pub(crate) fn forget(&mut self, id: NodeId) -> Vec<Edge> {
        let mut forgotten = Vec::new();
        for map in [&mut self.held, &mut self.holding] {
            map.retain(|_, edges| {
                let is_its_own = |e: &mut Edge| e.from == id || e.to == id;
                forgotten.extend(edges.extract_if(.., is_its_own));
                !edges.is_empty()
            });
        }
        forgotten
    }

    /// The nodes that may rest on a node by joint or contact, wherever they are.
    pub(crate) fn carried(&self, id: NodeId) -> impl Iterator<Item = NodeId> + '_ {
        let hinged = self.hinged.get(&id).into_iter().flatten().copied();
        hinged.chain(self.pushed.get(&id).into_iter().flat_map(|others| others.keys().copied()))
    }

    /// Takes from evidence whether a node moves with somebody's hands.
    pub(crate) fn read_carried(&mut self, id: NodeId, evidence: &Evidence) {
        if let (Some(ours), Some(all)) = (&mut self.carried, &evidence.carried) {
            if all.contains(&id) {
                ours.insert(id)
            } else {
                ours.remove(&id)
            };
        }
    }

    /// Whether a thing is known to move with somebody's hands.
    pub(crate) fn is_carried(&self, thing: NodeId) -> bool {
        self.carried.as_ref().is_some_and(|all| all.contains(&thing))
    }

    /// Whether a thing is known to move with nobody's hands.
    pub(crate) fn is_left(&self, thing: NodeId) -> bool {
        self.carried.as_ref().is_some_and(|all| !all.contains(&thing))
    }

    /// The edges by which a thing is held or worn.
    pub(crate) fn held(&self, thing: NodeId) -> &[Edge] {
        self.held.get(&thing).map_or(&[], Vec::as_slice)
    }

    /// Edges of holding and wearing that start at a node.
    pub(crate) fn holding(&self, from: NodeId) -> &[Edge] {
        self.holding.get(&from).map_or(&[], Vec::as_slice)
    }
}

/// Edges of holding and wearing at a node, in either direction.
pub(crate) fn hands_of(graph: &SceneGraph, id: NodeId) -> impl Iterator<Item = Edge> + '_ {
    let kinds = [Relation::HoldsRight, Relation::HoldsLeft, Relation::WornBy];
    let out = move |relation| graph.related(id, relation).map(move |to| Edge::new(id, relation, to));
    let inc = move |relation| graph.relating(relation, id).map(move |from| Edge::new(from, relation, id));
    kinds.into_iter().flat_map(move |relation| out(relation).chain(inc(relation)))
}
