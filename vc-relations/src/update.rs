//! The incremental update of relations after moves and other changes.

use vc_graph::{Aabb, Edge, NodeId, SceneGraph};

use crate::error::{InputError, check_evidence, check_nodes, check_positions};
use crate::evidence::{Evidence, Known, NodeEvidence};
use crate::facts::{Facts, hands_of};
use crate::relations::Relations;
use crate::rule::RelationRule;
use crate::world::{Affected, Reading};

impl Relations {
    /// Replaces the evidence: contacts, joints and held things. Nodes whose joint positions have changed are
    /// read again.
    ///
    /// # Errors
    /// [`InputError`] if the evidence, or a node that has to be read, contains an invalid number; nothing is changed
    /// then.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut relations = vc_relations::Relations::new(&home.graph, Default::default(), Default::default())?;
    /// // The physics engine says that the drawer is open by 0.3 m.
    /// let open = vc_relations::Evidence::default().positioned(home.cabinet, 0, 0.3);
    /// relations.set_evidence(&home.graph, open.clone())?;
    /// assert_eq!(relations.evidence(), &open);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn set_evidence(&mut self, graph: &SceneGraph, evidence: Evidence) -> Result<(), InputError> {
        self.update_with(graph, &[], evidence).map(drop)
    }

    /// [`Self::set_evidence`] and [`Self::update`] in one step, which reads a door that has turned only once.
    /// Returns all nodes whose relations may have changed, by number.
    ///
    /// # Errors
    /// [`InputError`] if the evidence, or a node that has to be read, contains an invalid number; nothing is changed
    /// then.
    pub fn update_with(
        &mut self,
        graph: &SceneGraph,
        changed: &[NodeId],
        evidence: Evidence,
    ) -> Result<Vec<NodeId>, InputError> {
        check_evidence(graph, &evidence)?;
        let turned = |(key, position): (&(NodeId, u32), &f32), other: &Evidence| {
            (other.positions.get(key) != Some(position)).then_some(key.0)
        };
        let mut changed = changed.to_vec();
        changed.extend(self.evidence.positions.iter().filter_map(|p| turned(p, &evidence)));
        changed.extend(evidence.positions.iter().filter_map(|p| turned(p, &self.evidence)));
        check_nodes(graph, &changed)?;
        let before = (self.facts.clone(), std::mem::replace(&mut self.evidence, evidence));
        self.facts = Facts::from_scene(graph, &self.evidence);
        let done = self.update(graph, &changed);
        if done.is_err() {
            (self.facts, self.evidence) = before;
        }
        done
    }

    /// [`Self::update`] after the evidence about some nodes has changed. It equals [`Self::update_with`] with the whole
    /// evidence, and costs nothing for the nodes that are not named.
    ///
    /// # Errors
    /// As [`Self::update_with`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// use vc_relations::{Evidence, NodeEvidence, Relations};
    /// let mut relations = Relations::new(&home.graph, Default::default(), Evidence::default())?;
    /// let open = NodeEvidence { node: home.cabinet, positions: vec![0.3], is_carried: false };
    /// let met = relations.update_nodes(&home.graph, &[], &[open])?;
    /// assert!(met.contains(&home.cabinet));
    /// assert_eq!(relations.evidence(), &Evidence::default().positioned(home.cabinet, 0, 0.3));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn update_nodes(
        &mut self,
        graph: &SceneGraph,
        changed: &[NodeId],
        evidence: &[NodeEvidence],
    ) -> Result<Vec<NodeId>, InputError> {
        check_positions(graph, evidence)?;
        let before: Vec<Known> = evidence.iter().map(|said| self.evidence.of(said.node)).collect();
        let mut changed = changed.to_vec();
        changed.extend(evidence.iter().filter_map(|said| self.say(&said.into()).then_some(said.node)));
        let done = self.update(graph, &changed);
        if done.is_err() {
            for known in before.iter().rev() {
                self.say(known);
            }
        }
        done
    }

    /// Says something else of one node; whether it is something new.
    fn say(&mut self, now: &Known) -> bool {
        let is_new = self.evidence.say(now);
        self.facts.read_carried(now.node, &self.evidence);
        is_new
    }

    /// Reads nodes again that have moved, been added or removed, or changed their state or the things they
    /// hold, and returns all nodes whose relations may have changed, by number. If a thing changes hands,
    /// either the thing or its former and present holders must be given.
    ///
    /// The result is that of [`Self::rebuild`], bit for bit. A moved object with the usual number of neighbours
    /// costs about ten microseconds. Changes of rooms, parts of the building and new nodes cost a rebuild, as
    /// does any change under a rule other than [`RelationRule::Contacts`].
    ///
    /// # Errors
    /// [`InputError`] as for [`Self::new`], for the changed nodes and, where a rebuild is needed, for any node; nothing
    /// is changed then.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// use vc_graph::{Edge, Pose, Relation};
    /// # let mut graph = home.graph.clone();
    /// # let mut relations = vc_relations::Relations::new(&graph, Default::default(), Default::default())?;
    /// let mut edit = graph.edit();
    /// edit.set_pose(home.cup, Some(Pose::translation(0.0, -1.0, 0.001)))?;
    /// edit.commit();
    /// relations.update(&graph, &[home.cup])?;
    /// assert!(relations.has(Edge::new(home.cup, Relation::On, home.floor)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn update(&mut self, graph: &SceneGraph, changed: &[NodeId]) -> Result<Vec<NodeId>, InputError> {
        check_nodes(graph, changed)?;
        let mut changed = changed.to_vec();
        changed.sort_unstable();
        changed.dedup();
        if self.rule == RelationRule::Contacts
            && let Some(affected) = self.update_each(graph, &changed)
        {
            return Ok(affected);
        }
        self.rebuild(graph)?;
        Ok(self.world.ids.clone())
    }

    fn update_each(&mut self, graph: &SceneGraph, changed: &[NodeId]) -> Option<Vec<NodeId>> {
        let read = |&id: &NodeId| Some((id, self.world.read(graph, id, &self.evidence)?));
        // All are read before the first is put: where one asks for a rebuild, which may be refused, nothing has changed.
        let readings: Vec<(NodeId, Reading)> = changed.iter().map(read).collect::<Option<_>>()?;
        let mut affected = Affected::default();
        for (id, reading) in readings {
            let index = reading.index;
            let before = self.world.bodies[index].as_deref().map(|b| b.region);
            self.world.put(reading, &mut affected);
            affected.bound.push(index as u32);
            affected.beside.extend(self.watchers(index, before));
            let hands = self.read_hands(graph, id);
            affected.bound.extend(
                hands.iter().flat_map(|e| [e.from, e.to]).filter_map(|end| self.world.index(end)).map(|i| i as u32),
            );
        }
        Some(self.world.spread(affected, &self.facts))
    }

    /// Reads again the edges of holding and wearing at a node and at the other ends of these, as a thing it
    /// took may have been in another's hand. Returns all these edges, old and new: the supports of both ends
    /// may have changed.
    fn read_hands(&mut self, graph: &SceneGraph, id: NodeId) -> Vec<Edge> {
        let mut edges = self.read_hand(graph, id);
        for end in 0..edges.len() {
            let other = if edges[end].from == id { edges[end].to } else { edges[end].from };
            edges.extend(self.read_hand(graph, other));
        }
        edges
    }

    fn read_hand(&mut self, graph: &SceneGraph, id: NodeId) -> Vec<Edge> {
        let mut edges = self.facts.forget(id);
        let said = self.evidence.held.iter().copied().filter(|e| e.from == id || e.to == id);
        let now: Vec<Edge> = graph.node(id).into_iter().flat_map(|_| hands_of(graph, id)).chain(said).collect();
        now.iter().for_each(|edge| self.facts.hold(*edge));
        edges.extend(now);
        edges
    }

    /// The bodies that may face a body, at its old and new places.
    fn watchers(&self, index: usize, before: Option<Aabb>) -> Vec<u32> {
        let now = self.world.bodies[index].as_deref();
        let mut watchers = Vec::new();
        if now.is_some_and(|b| !b.traits.lookable) {
            return watchers;
        }
        let reach = crate::threshold::FACING_REACH;
        for region in now.map(|b| b.region).into_iter().chain(before) {
            self.world.tree.for_each(&region.grown(reach, reach), |other| {
                let traits = self.world.bodies[other].as_deref().map(|b| b.traits);
                if traits.is_some_and(|t| t.agent || t.sittable) {
                    watchers.push(other as u32);
                }
            });
        }
        watchers
    }
}
