//! The belief of an agent under partial observability.

mod chances;
mod draw;
#[cfg(test)]
mod filter;
mod hiding;
mod places;
mod sight;

use std::collections::BTreeMap;
use std::sync::Arc;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use vc_graph::{
    Node, NodeId, NodeKind, Observation, Place, Property, Relation, SceneGraph, State, StateSet, Vocabulary,
};

use crate::prior::{Kinds, Supposed, Tidiness};
use crate::{KnownNodes, Prior};

/// An agent's belief: the places of things that it knows, and a guess for the others.
///
/// An agent in a known home knows its plan: the rooms, the fixed things, and which movable things
/// exist. It does not know the places of the movable things, nor which things are open or on. For each movable
/// thing, every place (every surface and container, and the floor of each room) is as likely as its [`Prior`]
/// says until the place has been seen without the thing (the thesis's section 4.3, where all places are equally
/// likely). Containers that can be carried become places when they are first seen. The guess is a sample, kept
/// until an observation disproves it; when every place has been seen without the thing, the belief widens to
/// all places again, because the thing must have been moved meanwhile.
///
/// An update costs a look at each node seen and at each thing still missing.
#[derive(Debug, Clone)]
pub struct Belief {
    agent: NodeId,
    /// The sampled state: the known part of the scene, and guesses for the rest.
    graph: SceneGraph,
    known: KnownNodes,
    /// The possible places of things; `seen` says which of them have been looked at.
    places: Vec<Place>,
    seen: Vec<bool>,
    /// The room of each place, and the kind of each place.
    rooms: Vec<Option<NodeId>>,
    kinds: Kinds,
    prior: Prior,
    /// The hypothesis about each class of missing things.
    supposed: BTreeMap<Arc<str>, Supposed>,
    tidiness: Tidiness,
    /// The things not yet found, with the guessed place of each.
    missing: Vec<(NodeId, usize)>,
    last: Option<Observation>,
    /// Whether the agent knows nothing about the contents of the home at first: it learns them by observation.
    in_unknown_home: bool,
    /// Nodes whose guess the agent's own last action has changed.
    touched: Vec<NodeId>,
    /// The nodes that it cannot reach.
    excluded: Vec<NodeId>,
    /// Affordances that are no longer expected of things.
    barred: Vec<(NodeId, Property)>,
    widened: usize,
    rng: ChaCha8Rng,
}

/// The information gained from an observation.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Learned {
    /// Things seen for the first time.
    pub found: Vec<NodeId>,
    /// Things whose guessed place was disproved.
    pub disproved: Vec<NodeId>,
}

impl Belief {
    /// The belief of an agent that knows only the plan of a home, to which all places are equally likely. `graph`
    /// is the true scene: rooms and fixed things are taken from it; the places of movable things and all states
    /// are forgotten.
    pub fn in_known_home(graph: &SceneGraph, agent: NodeId, seed: u64) -> Self {
        Self::with_prior(graph, agent, seed, Prior::Uniform)
    }

    /// As [`Belief::in_known_home`], with a prior.
    pub fn with_prior(graph: &SceneGraph, agent: NodeId, seed: u64, prior: Prior) -> Self {
        let mut belief = Self::with(graph, agent, seed);
        belief.prior = prior;
        belief.look_for_places(graph);
        let held: Vec<NodeId> = graph.carried_with(agent);
        let movable =
            |n: &&Node| n.kind() == NodeKind::Object && n.affords(Property::Graspable) && !held.contains(&n.id());
        let hidden: Vec<NodeId> = graph.nodes().filter(movable).map(Node::id).collect();
        belief.forget(&hidden);
        hidden.iter().for_each(|&id| belief.weigh(id));
        for id in hidden {
            let place = belief.sample(id);
            belief.missing.push((id, place));
            belief.suppose(id, place);
        }
        let seen_before = graph.nodes().filter(|n| n.kind() == NodeKind::Room).map(Node::id);
        belief.known = seen_before.chain(held).collect();
        belief
    }

    /// The belief of an agent that knows only the rooms, neither the furniture nor which things exist: it adds
    /// what it sees, and surfaces and containers become places once seen.
    pub fn in_unknown_home(graph: &SceneGraph, agent: NodeId, seed: u64, prior: Prior) -> Self {
        let mut belief = Self::with(graph, agent, seed);
        (belief.prior, belief.in_unknown_home) = (prior, true);
        let carried = graph.carried_with(agent);
        let mut edit = belief.graph.edit();
        let unknown = |n: &&Node| n.kind() == NodeKind::Object && !carried.contains(&n.id());
        for id in graph.nodes().filter(unknown).map(Node::id) {
            // The node exists, so it can be removed.
            let _ = edit.remove(id);
        }
        edit.commit();
        let rooms = belief.graph.clone();
        belief.look_for_places(&rooms);
        belief.known = graph.rooms().iter().copied().chain(carried).collect();
        belief
    }

    /// The belief of an agent that knows everything.
    pub(crate) fn oracle(graph: &SceneGraph, agent: NodeId) -> Self {
        let mut belief = Self::with(graph, agent, 0);
        belief.known = graph.nodes().map(Node::id).collect();
        belief
    }

    fn with(graph: &SceneGraph, agent: NodeId, seed: u64) -> Self {
        Self {
            agent,
            graph: graph.clone(),
            known: KnownNodes::default(),
            places: Vec::new(),
            seen: Vec::new(),
            rooms: Vec::new(),
            kinds: Kinds::default(),
            prior: Prior::Uniform,
            supposed: BTreeMap::new(),
            tidiness: Tidiness::default(),
            missing: Vec::new(),
            last: None,
            in_unknown_home: false,
            touched: Vec::new(),
            excluded: Vec::new(),
            barred: Vec::new(),
            widened: 0,
            rng: ChaCha8Rng::seed_from_u64(seed),
        }
    }

    /// The sampled state: a whole scene in which the agent can plan.
    pub fn graph(&self) -> &SceneGraph {
        &self.graph
    }

    /// The sampled state, on which a planner can try actions and take them back, and the set of known nodes.
    pub(crate) fn sampled_and_known(&mut self) -> (&mut SceneGraph, &KnownNodes) {
        (&mut self.graph, &self.known)
    }

    /// The nodes that the agent has seen.
    pub fn known(&self) -> &KnownNodes {
        &self.known
    }

    /// How often the belief has widened after a search of all places.
    pub fn widened(&self) -> usize {
        self.widened
    }

    /// The places where missing things can still be.
    pub fn possible_places(&self) -> impl Iterator<Item = Place> + '_ {
        self.places.iter().zip(&self.seen).filter(|(_, seen)| !**seen).map(|(place, _)| *place)
    }

    /// The number of places where missing things can still be.
    pub fn open_places(&self) -> usize {
        self.seen.iter().filter(|seen| !**seen).count()
    }

    pub(crate) fn sites(&self) -> impl Iterator<Item = (usize, Place, Option<NodeId>)> + '_ {
        let open = self.places.iter().enumerate().filter(|(i, _)| !self.seen[*i]);
        open.map(|(i, place)| (i, *place, self.rooms[i]))
    }

    /// Whether the scene has neither a room nor a place for things.
    pub(crate) fn has_no_place(&self) -> bool {
        self.places.is_empty()
    }

    pub(crate) fn places_known(&self) -> usize {
        self.places.len()
    }

    /// Whether the place of a thing is only a guess.
    pub fn is_missing(&self, id: NodeId) -> bool {
        self.missing.iter().any(|&(missing, _)| missing == id)
    }

    /// Whether nothing has to be guessed, as for an oracle.
    pub(crate) fn knows_all(&self) -> bool {
        self.places.is_empty()
    }

    /// Whether a node was in view in the last observation.
    pub(crate) fn sees(&self, id: NodeId) -> bool {
        self.last.as_ref().is_some_and(|seen| seen.sees(id))
    }

    /// Whether there may be things that the agent does not know of.
    pub(crate) fn is_in_unknown_home(&self) -> bool {
        self.in_unknown_home
    }

    fn suppose(&mut self, id: NodeId, place: usize) {
        let Some(place) = self.places.get(place).copied() else { return };
        let mut edit = self.graph.edit();
        let _ = match place.relation {
            Relation::InRoom => edit.detach(id).and_then(|()| edit.move_to_room(id, place.at)),
            _ => edit.place(id, place),
        };
        edit.commit();
    }

    /// Forgets the places of things and the states of all things.
    fn forget(&mut self, hidden: &[NodeId]) {
        let states: Vec<(NodeId, StateSet)> = self
            .graph
            .nodes()
            .filter(|n| n.kind() == NodeKind::Object)
            .map(|n| (n.id(), presumed(self.graph.vocabulary(), n)))
            .collect();
        let near = [Relation::Near, Relation::NearFront, Relation::NearBack, Relation::NearLeft, Relation::NearRight];
        let mut edit = self.graph.edit();
        for (id, states) in states {
            let _ = edit.set_states(id, states);
        }
        for &id in hidden {
            let _ = edit.detach(id);
            let _ = edit.unrelate(id, &near);
            let _ = edit.unrelate(id, &[Relation::Facing, Relation::PouredInto]);
            let _ = edit.set_pose(id, None);
            if edit.graph().node(id).is_some_and(|n| n.contents().is_some()) {
                let _ = edit.fill(id, None);
            }
        }
        edit.commit();
    }
}

/// The presumed state of an object before it has been seen: closed, off and clean.
fn presumed(words: &Vocabulary, node: &Node) -> StateSet {
    let mut states = node.states();
    if states.contains(State::Dirty) {
        states = words.entering(states, State::Clean);
    }
    for (property, state) in [(Property::Openable, State::Closed), (Property::Switchable, State::Off)] {
        if node.affords(property) {
            states = words.entering(states, state);
        }
    }
    states
}
