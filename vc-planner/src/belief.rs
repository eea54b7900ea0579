//! What an agent believes about a scene it sees only in part.

#[cfg(test)]
mod filter;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use vc_graph::{
    Action, ChangeSet, Edge, Kind, Node, NodeId, Observation, Place, Property, Relation, SceneGraph, State, StateSet,
    rule,
};

use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;

use crate::prior::{Supposed, Tidiness};
use crate::{Known, Prior};

/// Where things are, as far as an agent knows, and for the others a guess.
///
/// It is told the plan of the home when it moves in: the rooms, the fixed things
/// and which movable things exist. It is not told where the movable ones are, nor
/// what is open or on. For each of them every place, that is every surface and
/// container and the floor of each room, is as likely as its [`Prior`] says until it
/// has been seen without the thing (the thesis's section 4.3, where all are equally
/// likely). Containers that can be carried are places from when they are first seen. The guess is a sample, kept until
/// an observation proves it false; when every place has been seen without it, the
/// belief widens to all places again, because something was moved meanwhile.
///
/// Updating costs a look at each node seen and at each thing still missing.
#[derive(Debug, Clone)]
pub struct Belief {
    agent: NodeId,
    /// The sampled state: what is known, and guesses for the rest.
    graph: SceneGraph,
    known: Known,
    /// Where things can be; `seen` says which of them have been looked at.
    places: Vec<Place>,
    seen: Vec<bool>,
    /// The room of each place.
    rooms: Vec<Option<NodeId>>,
    prior: Prior,
    /// What is supposed about each class of missing things.
    supposed: BTreeMap<Arc<str>, Supposed>,
    tidiness: Tidiness,
    /// Things not yet found, with the place of their guess.
    missing: Vec<(NodeId, usize)>,
    last: Option<Observation>,
    /// Nodes whose guess the agent's own last action has changed.
    touched: Vec<NodeId>,
    widened: usize,
    rng: ChaCha8Rng,
}

/// What an observation taught.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Learned {
    /// Things seen for the first time.
    pub found: Vec<NodeId>,
    /// Things whose guessed place was proved false.
    pub disproved: Vec<NodeId>,
}

impl Belief {
    /// The belief of an agent that knows only the plan of a home. `graph` is the
    /// true scene: rooms and fixed things are taken from it, the places of movable
    /// things and all states are forgotten.
    pub fn of_newcomer(graph: &SceneGraph, agent: NodeId, seed: u64) -> Self {
        Self::by_prior(graph, agent, seed, Prior::Uniform)
    }

    /// As [`Belief::of_newcomer`], with a prior.
    pub fn by_prior(graph: &SceneGraph, agent: NodeId, seed: u64, prior: Prior) -> Self {
        let mut belief = Self::with(graph, agent, seed);
        belief.prior = prior;
        belief.places = places(graph);
        belief.seen = vec![false; belief.places.len()];
        belief.rooms = belief.places.iter().map(|p| graph.room_of(p.at)).collect();
        let held: Vec<NodeId> = graph.carried_with(agent);
        let movable = |n: &&Node| n.kind() == Kind::Object && n.affords(Property::Graspable) && !held.contains(&n.id());
        let hidden: Vec<NodeId> = graph.nodes().filter(movable).map(Node::id).collect();
        belief.forget(&hidden);
        hidden.iter().for_each(|&id| belief.weigh(id));
        for id in hidden {
            let place = belief.sample(id);
            belief.missing.push((id, place));
            belief.suppose(id, place);
        }
        let seen_before = graph.nodes().filter(|n| n.kind() == Kind::Room).map(Node::id);
        belief.known = seen_before.chain(held).collect();
        belief
    }

    /// The belief of an agent that knows everything.
    pub fn of_resident(graph: &SceneGraph, agent: NodeId) -> Self {
        let mut belief = Self::with(graph, agent, 0);
        belief.known = graph.nodes().map(Node::id).collect();
        belief
    }

    fn with(graph: &SceneGraph, agent: NodeId, seed: u64) -> Self {
        Self {
            agent,
            graph: graph.clone(),
            known: Known::default(),
            places: Vec::new(),
            seen: Vec::new(),
            rooms: Vec::new(),
            prior: Prior::Uniform,
            supposed: BTreeMap::new(),
            tidiness: Tidiness::default(),
            missing: Vec::new(),
            last: None,
            touched: Vec::new(),
            widened: 0,
            rng: ChaCha8Rng::seed_from_u64(seed),
        }
    }

    /// The sampled state: a whole scene in which the agent can plan.
    pub fn graph(&self) -> &SceneGraph {
        &self.graph
    }

    /// The sampled state, for a planner to try actions on and take them back, and
    /// what of it is known.
    pub(crate) fn sampled_and_known(&mut self) -> (&mut SceneGraph, &Known) {
        (&mut self.graph, &self.known)
    }

    /// What the agent has seen.
    pub fn known(&self) -> &Known {
        &self.known
    }

    /// How often everything had been searched and the belief widened.
    pub fn widened(&self) -> usize {
        self.widened
    }

    /// The places where something not yet found can be.
    pub fn possible_places(&self) -> impl Iterator<Item = Place> + '_ {
        self.places.iter().zip(&self.seen).filter(|(_, seen)| !**seen).map(|(place, _)| *place)
    }

    /// How many places there are where something not yet found can be.
    pub fn open_places(&self) -> usize {
        self.seen.iter().filter(|seen| !**seen).count()
    }

    pub(crate) fn sites(&self) -> impl Iterator<Item = (usize, Place, Option<NodeId>)> + '_ {
        let open = self.places.iter().enumerate().filter(|(i, _)| !self.seen[*i]);
        open.map(|(i, place)| (i, *place, self.rooms[i]))
    }

    pub(crate) fn places_known(&self) -> usize {
        self.places.len()
    }

    /// The chances of the places not seen for a missing thing.
    pub(crate) fn chances_of(&self, id: NodeId) -> Option<Chances<'_>> {
        let class = self.supposed.get(self.graph.node(id)?.class())?;
        let (each, by_habit) = self.tidiness.mix(class, self.unseen_share(), self.even());
        Some(Chances { each, by_habit, habit: class.habit.as_deref() })
    }

    /// The chance of a place where all are alike.
    fn even(&self) -> f64 {
        1.0 / self.places.len().max(1) as f64
    }

    fn unseen_share(&self) -> f64 {
        self.open_places() as f64 * self.even()
    }

    /// Supposes something about one more missing thing.
    fn weigh(&mut self, id: NodeId) {
        let Some(class) = self.graph.node(id).map(|n| n.class().clone()) else { return };
        if let Some(known) = self.supposed.get_mut(&class) {
            known.missing += 1;
            return;
        }
        let habit = self.prior.habit(&self.graph, id, &self.places).map(Into::into);
        self.supposed.insert(class, Supposed { habit, left: 1.0, missing: 1 });
    }

    /// Everywhere a thing can be, with the chance that it is there; likeliest first.
    /// They sum to one.
    pub fn distribution(&self, id: NodeId) -> Vec<(Place, f64)> {
        if !self.is_missing(id) {
            return self.graph.place(id).map(|p| (p, 1.0)).into_iter().collect();
        }
        let Some(chances) = self.chances_of(id) else { return Vec::new() };
        let mut all: Vec<(Place, f64)> = self.sites().map(|(i, place, _)| (place, chances.at(i))).collect();
        all.sort_by(|a, b| b.1.total_cmp(&a.1));
        all
    }

    /// Where a thing is most likely.
    pub fn most_likely(&self, id: NodeId) -> Option<Place> {
        self.distribution(id).first().map(|(place, _)| *place)
    }

    /// The state with every thing where it is most likely, and all that is known.
    pub fn most_likely_state(&self) -> SceneGraph {
        let mut likely = self.clone();
        for (id, _) in &self.missing {
            let at = self.most_likely(*id).and_then(|p| self.places.iter().position(|q| *q == p));
            if let Some(at) = at {
                likely.suppose(*id, at);
            }
        }
        likely.graph
    }

    /// A number that tells beliefs apart: what is missing, where it is guessed, what
    /// has been searched.
    pub fn digest(&self) -> u64 {
        let seen = self.seen.iter().enumerate().filter(|(_, s)| **s).map(|(i, _)| i as u64);
        let missing = self.missing.iter().map(|&(id, place)| u64::from(id.0) << 32 | place as u64);
        // FNV-1a over words.
        let add = |hash: u64, word: u64| (hash ^ word).wrapping_mul(0x100_0000_01b3);
        missing.chain(seen).fold(0xcbf2_9ce4_8422_2325, add)
    }

    /// Whether it is only guessed where a thing is.
    pub fn is_missing(&self, id: NodeId) -> bool {
        self.missing.iter().any(|&(missing, _)| missing == id)
    }

    /// How likely a thing is at a place, 0 to 1.
    pub fn probability(&self, id: NodeId, place: Place) -> f64 {
        if !self.is_missing(id) {
            return f64::from(u8::from(self.graph.places(id).any(|p| p == place)));
        }
        self.distribution(id).iter().find(|(p, _)| *p == place).map_or(0.0, |(_, chance)| *chance)
    }

    /// Expects what an action of the agent's own does.
    pub fn expect(&mut self, action: &Action) {
        let changes = rule::step(&mut self.graph, self.agent, action);
        self.touched = changes.as_ref().map(touched).unwrap_or_default();
    }

    /// Takes in what the agent sees.
    pub fn observe(&mut self, seen: &Observation) -> Learned {
        let mut learned = Learned::default();
        self.take_over(seen, &mut learned);
        self.look(seen, &mut learned);
        self.last = Some(seen.clone());
        learned
    }

    /// Takes in what another agent sees and tells: all but who sees it.
    pub fn hear(&mut self, told: &Observation) -> Learned {
        let mut learned = Learned::default();
        let me = self.agent;
        for node in told.nodes().filter(|n| n.id() != me) {
            let id = node.id();
            if self.known.insert(id) && node.kind() != Kind::Room {
                learned.found.push(id);
                self.learn_place(node);
            }
            self.take_over_node(told, node);
        }
        self.look(told, &mut learned);
        // What was told may be newer than what was seen last.
        self.last = None;
        learned
    }

    /// Whether there is nothing it would have to guess: it moved in long ago.
    pub fn knows_all(&self) -> bool {
        self.places.is_empty()
    }

    /// Brings the sampled state in line with what is seen.
    fn take_over(&mut self, seen: &Observation, learned: &mut Learned) {
        let last = self.last.take();
        for node in seen.nodes() {
            let id = node.id();
            // Snapshots share unchanged nodes: the same node need not be compared.
            let same = last.as_ref().and_then(|l| l.get(id)).is_some_and(|old| std::ptr::eq(old, node));
            if same && !self.touched.contains(&id) {
                continue;
            }
            if self.known.insert(id) && node.kind() != Kind::Room {
                learned.found.push(id);
                self.learn_place(node);
            }
            self.take_over_node(seen, node);
        }
        self.take_over_agent(seen);
    }

    /// A container that can be carried is a place from when it has been seen.
    fn learn_place(&mut self, node: &Node) {
        let opens = [Property::Graspable, Property::Container, Property::Openable];
        let place = Place { relation: Relation::Inside, at: node.id() };
        if self.missing.is_empty() || !opens.into_iter().all(|p| node.affords(p)) || self.places.contains(&place) {
            return;
        }
        self.places.push(place);
        self.seen.push(false);
        self.rooms.push(None);
        let share = self.even();
        for class in self.supposed.values_mut() {
            if let Some(habit) = &mut class.habit {
                *habit = habit.iter().map(|w| w * (1.0 - share)).chain([share]).collect();
                class.left = class.left * (1.0 - share) + share;
            }
        }
    }

    fn take_over_node(&mut self, seen: &Observation, node: &Node) {
        let id = node.id();
        let Some(believed) = self.graph.node(id) else { return };
        let states = node.states();
        let moved = !self.graph.places(id).eq(seen.places(id)) || self.graph.room_of(id) != seen.room_of(id);
        if believed.states() == states
            && !moved
            && believed.pose() == node.pose()
            && believed.contents() == node.contents()
        {
            return;
        }
        let places: Vec<Place> = if moved { seen.places(id).collect() } else { Vec::new() };
        let (pose, contents) = (node.pose().copied(), node.contents().cloned());
        let mut edit = self.graph.edit();
        // What is seen is sound; where two sightings contradict the later one wins.
        let _ = edit.set_states(id, states);
        let _ = edit.set_pose(id, pose);
        if edit.graph().node(id).is_some_and(|n| n.contents() != contents.as_ref()) {
            let _ = edit.fill(id, contents);
        }
        if moved {
            let _ = edit.place_as_seen(id, &places, seen.room_of(id));
        }
        edit.commit();
    }

    /// What the agent itself is near and faces.
    fn take_over_agent(&mut self, seen: &Observation) {
        let kinds = [Relation::Near, Relation::Facing];
        let links = |graph: &SceneGraph, agent: NodeId| -> Vec<Edge> {
            kinds.iter().flat_map(|&r| graph.related(agent, r).map(move |to| Edge::new(agent, r, to))).collect()
        };
        let mut now: Vec<Edge> = kinds.iter().flat_map(|&r| seen.related(self.agent, r)).collect();
        // It remembers having turned to something out of view.
        now.extend(
            links(&self.graph, self.agent).into_iter().filter(|e| e.relation == Relation::Facing && !seen.sees(e.to)),
        );
        if links(&self.graph, self.agent) == now {
            return;
        }
        let mut edit = self.graph.edit();
        let _ = edit.unrelate(self.agent, &kinds);
        for edge in now {
            let _ = edit.relate(edge);
        }
        edit.commit();
    }

    /// Notes what is found and which places are in view, and guesses anew what that
    /// disproves.
    fn look(&mut self, seen: &Observation, learned: &mut Learned) {
        let mut lost = self.lost(seen);
        if self.missing.is_empty() && lost.is_empty() {
            return;
        }
        let found: Vec<NodeId> = self.missing.iter().map(|(id, _)| *id).filter(|id| seen.sees(*id)).collect();
        found.iter().for_each(|&id| self.find(seen, id));
        // Both are in the order of numbers.
        self.missing.retain(|(id, _)| found.binary_search(id).is_err());
        if self.look_at_places(seen) || !found.is_empty() {
            self.tidiness.settle(self.supposed.values(), self.unseen_share());
        }
        self.resample(learned);
        lost.drain(..).for_each(|id| self.lose(id, learned));
    }

    /// Things that are not where they were: somebody else has taken them.
    fn lost(&self, seen: &Observation) -> Vec<NodeId> {
        let Some(room) = seen.room().filter(|_| !self.knows_all() && self.graph.agents().len() > 1) else {
            return Vec::new();
        };
        let gone = |id: &NodeId| {
            let movable =
                self.known.contains(*id) && self.graph.node(*id).is_some_and(|n| n.affords(Property::Graspable));
            let place = self.graph.place(*id).unwrap_or(Place { relation: Relation::InRoom, at: room });
            movable && !seen.sees(*id) && self.graph.holder(*id).is_none() && in_view(seen, &place)
        };
        self.graph.in_room(room).filter(gone).collect()
    }

    fn lose(&mut self, id: NodeId, learned: &mut Learned) {
        self.known.remove(id);
        self.weigh(id);
        let place = self.sample(id);
        let position = self.missing.partition_point(|(other, _)| *other < id);
        self.missing.insert(position, (id, place));
        self.suppose(id, place);
        learned.disproved.push(id);
    }

    /// A missing thing is found: it tells how tidy the home is.
    fn find(&mut self, seen: &Observation, id: NodeId) {
        let even = self.even();
        let place =
            seen.places(id).next().or_else(|| Some(Place { relation: Relation::InRoom, at: seen.room_of(id)? }));
        let at = place.and_then(|place| self.places.iter().position(|p| *p == place));
        let Some(class) = self.graph.node(id).and_then(|n| self.supposed.get_mut(n.class())) else { return };
        class.missing = class.missing.saturating_sub(1);
        // Where it is found again after it was moved says nothing.
        if let (Some(habit), Some(at)) = (&class.habit, at.filter(|&at| !self.seen[at])) {
            self.tidiness.found(habit[at], even);
        }
    }

    /// Notes which places are in view now; whether there are new ones.
    fn look_at_places(&mut self, seen: &Observation) -> bool {
        let mut new = false;
        for (index, place) in self.places.iter().enumerate() {
            if self.seen[index] || !in_view(seen, place) {
                continue;
            }
            (self.seen[index], new) = (true, true);
            for class in self.supposed.values_mut() {
                class.left -= class.habit.as_ref().map_or(0.0, |habit| habit[index]);
            }
        }
        new
    }

    fn resample(&mut self, learned: &mut Learned) {
        for index in 0..self.missing.len() {
            let (id, place) = self.missing[index];
            if self.seen[place] {
                let place = self.sample(id);
                self.missing[index].1 = place;
                self.suppose(id, place);
                learned.disproved.push(id);
            }
        }
    }

    /// A place that has not been looked at, by its chance; all again, when none is
    /// left.
    fn sample(&mut self, id: NodeId) -> usize {
        if self.seen.iter().all(|&seen| seen) {
            self.widen();
        }
        // 53 bits make a number from 0 up to 1.
        let mut draw = (self.rng.next_u64() >> 11) as f64 / (1u64 << 53) as f64;
        let Some(chances) = self.chances_of(id) else { return 0 };
        let mut last = 0;
        for (i, _, _) in self.sites() {
            last = i;
            draw -= chances.at(i);
            if draw < 0.0 {
                break;
            }
        }
        last
    }

    fn widen(&mut self) {
        self.seen.fill(false);
        self.widened += 1;
        self.supposed.values_mut().for_each(|class| class.left = 1.0);
        self.tidiness.settle(self.supposed.values(), 1.0);
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

    /// Forgets where things are and what state anything is in.
    fn forget(&mut self, hidden: &[NodeId]) {
        let states: Vec<(NodeId, StateSet)> =
            self.graph.nodes().filter(|n| n.kind() == Kind::Object).map(|n| (n.id(), presumed(n))).collect();
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

/// The chances of places for a thing.
pub(crate) struct Chances<'a> {
    each: f64,
    by_habit: f64,
    habit: Option<&'a [f64]>,
}

impl Chances<'_> {
    /// The chance of a place not seen, by its number.
    pub(crate) fn at(&self, place: usize) -> f64 {
        self.each + self.habit.map_or(0.0, |habit| self.by_habit * habit[place])
    }
}

/// What is missing, and where it is likeliest.
impl fmt::Display for Belief {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const SHOWN: usize = 3;
        writeln!(f, "{} things not found, {} places not searched", self.missing.len(), self.open_places())?;
        for (id, _) in &self.missing {
            write!(f, "{}:", self.graph.label(*id))?;
            for (place, chance) in self.distribution(*id).into_iter().take(SHOWN) {
                write!(f, " {:.0}% {} {}", 100.0 * chance, place.relation, self.graph.label(place.at))?;
            }
            writeln!(f)?;
        }
        Ok(())
    }
}

/// What is presumed of an object before it has been seen: closed, off and clean.
fn presumed(node: &Node) -> StateSet {
    let mut states = node.states();
    if states.contains(State::Dirty) {
        states = states.entering(State::Clean);
    }
    for (property, state) in [(Property::Openable, State::Closed), (Property::Switchable, State::Off)] {
        if node.affords(property) {
            states = states.entering(state);
        }
    }
    states
}

/// Every fixed surface and container, floors included; of a room without a floor
/// the room itself.
fn places(graph: &SceneGraph) -> Vec<Place> {
    let floors = graph.of_class("floor");
    let bare = |room: NodeId| !floors.iter().any(|&f| graph.room_of(f) == Some(room));
    let mut places = Vec::new();
    for node in graph.nodes() {
        let mut add = |relation| places.push(Place { relation, at: node.id() });
        match node.kind() {
            Kind::Room if bare(node.id()) => add(Relation::InRoom),
            Kind::Room => {}
            Kind::Agent => {}
            Kind::Object => {
                let fixed = !node.affords(Property::Graspable);
                let surface =
                    [Property::Surface, Property::Sittable, Property::Lieable].into_iter().any(|p| node.affords(p));
                if surface && fixed {
                    add(Relation::On);
                }
                if node.affords(Property::Container) && fixed {
                    add(Relation::Inside);
                }
            }
        }
    }
    places
}

/// Whether a place can be seen to hold what it holds.
fn in_view(seen: &Observation, place: &Place) -> bool {
    match place.relation {
        Relation::InRoom => seen.room() == Some(place.at),
        Relation::Inside => seen.get(place.at).is_some_and(|n| !n.hides_contents()),
        _ => seen.sees(place.at),
    }
}

/// The nodes a change set is about.
fn touched(changes: &ChangeSet) -> Vec<NodeId> {
    use vc_graph::Change;
    let mut all: Vec<NodeId> = Vec::new();
    for change in changes.changes() {
        match change {
            Change::States { id, .. } | Change::Pose { id, .. } | Change::Contents { id, .. } => all.push(*id),
            Change::Link(e) | Change::Unlink(e) => all.extend([e.from, e.to]),
            _ => {}
        }
    }
    all.sort_unstable();
    all.dedup();
    all
}
