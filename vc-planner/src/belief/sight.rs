//! Updates of the sampled state by observations, messages and actions.

use vc_graph::{
    Action, Change, ChangeSet, Edge, Node, NodeId, NodeKind, Observation, Place, Property, Relation, SceneGraph, rule,
};

use super::{Belief, Learned};

impl Belief {
    /// Applies the expected effects of the agent's own action.
    pub fn expect(&mut self, action: &Action) {
        let changes = rule::step(&mut self.graph, self.agent, action);
        self.touched = changes.as_ref().map(touched).unwrap_or_default();
    }

    /// Updates the belief with the agent's observation.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder, Scope};
    /// use vc_planner::Agent;
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let milk = scene.add_in(fridge, Draft::new("milk"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let graph = scene.build();
    /// let agent = Agent::in_known_home(&graph, me, "Holds(milk)".parse()?, 1);
    /// let mut belief = agent.belief().clone();
    /// belief.observe(&graph.observe(me, Scope::Whole));
    /// assert!(belief.most_likely(milk).is_some());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn observe(&mut self, seen: &Observation) -> Learned {
        let mut learned = Learned::default();
        self.meet(seen);
        self.take_over(seen, &mut learned);
        self.take_in(seen, &mut learned);
        self.last = Some(seen.clone());
        learned
    }

    /// Updates the belief with an observation that another agent tells, except for the agent's own node.
    pub(crate) fn hear(&mut self, report: &Observation) -> Learned {
        let mut learned = Learned::default();
        let me = self.agent;
        self.meet(report);
        for node in report.nodes().filter(|n| n.id() != me) {
            let id = node.id();
            if self.known.insert(id) && node.kind() != NodeKind::Room {
                learned.found.push(id);
                self.learn_places(node, report.room_of(id));
            }
            self.take_over_node(report, node);
        }
        self.take_in(report, &mut learned);
        // The message may be newer than the agent's own last observation.
        self.last = None;
        learned
    }

    /// Removes an affordance from a thing; returns whether the thing had it.
    pub(crate) fn bar(&mut self, id: NodeId, property: Property) -> bool {
        let affords = self.graph.node(id).is_some_and(|n| n.affords(property));
        let mut edit = self.graph.edit();
        let barred = affords && edit.bar(id, property).is_ok();
        edit.commit();
        if barred {
            self.barred.push((id, property));
        }
        barred
    }

    /// How many affordances have been taken from things.
    pub(crate) fn bars(&self) -> usize {
        self.barred.len()
    }

    /// Gives back all affordances that were taken from things but the first so many, and expects again to get at
    /// everything.
    pub(crate) fn unbar(&mut self, kept: usize) {
        if self.barred.len() <= kept {
            return;
        }
        self.excluded.clear();
        let mut edit = self.graph.edit();
        for (id, property) in self.barred.drain(kept..) {
            // It was taken from a node that is there.
            let _ = edit.allow(id, property);
        }
        edit.commit();
    }

    /// Adds the nodes that an agent in an unknown home sees for the first time.
    fn meet(&mut self, seen: &Observation) {
        if !self.in_unknown_home {
            return;
        }
        let new: Vec<&Node> = seen.nodes().filter(|n| self.graph.node(n.id()).is_none()).collect();
        let mut edit = self.graph.edit();
        for node in new {
            // The node is new, and all its data are taken from the observation.
            let _ = edit.add_as_seen(node);
        }
        edit.commit();
    }

    /// Makes the sampled state agree with an observation.
    fn take_over(&mut self, seen: &Observation, learned: &mut Learned) {
        let last = self.last.take();
        for node in seen.nodes() {
            let id = node.id();
            // Snapshots share unchanged nodes, so an identical node need not be compared.
            let same = last.as_ref().and_then(|l| l.get(id)).is_some_and(|old| std::ptr::eq(old, node));
            if same && !self.touched.contains(&id) {
                continue;
            }
            if self.known.insert(id) && node.kind() != NodeKind::Room {
                learned.found.push(id);
                self.learn_places(node, seen.room_of(id));
            }
            self.take_over_node(seen, node);
        }
        self.take_over_agents(seen);
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
        // Observations are consistent; if two contradict each other, the later one counts.
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

    /// Updates which things the agent itself, and other visible agents, are near and face.
    fn take_over_agents(&mut self, seen: &Observation) {
        for agent in self.graph.agents().to_vec() {
            if agent == self.agent || seen.sees(agent) {
                self.take_over_nearness(agent, seen);
            }
        }
    }

    fn take_over_nearness(&mut self, agent: NodeId, seen: &Observation) {
        let kinds = [Relation::Near, Relation::Facing];
        let links = |graph: &SceneGraph| -> Vec<Edge> {
            kinds.iter().flat_map(|&r| graph.related(agent, r).map(move |to| Edge::new(agent, r, to))).collect()
        };
        let before = links(&self.graph);
        let mut now: Vec<Edge> = kinds.iter().flat_map(|&r| seen.related(agent, r)).collect();
        // The belief remembers a faced thing that is out of view.
        now.extend(before.iter().filter(|e| e.relation == Relation::Facing && !seen.sees(e.to)));
        if before == now {
            return;
        }
        let mut edit = self.graph.edit();
        let _ = edit.unrelate(agent, &kinds);
        for edge in now {
            let _ = edit.relate(edge);
        }
        edit.commit();
    }
}

/// The nodes that a change set concerns.
fn touched(changes: &ChangeSet) -> Vec<NodeId> {
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
