//! Writing relations back into the scene they were read from.

use std::collections::BTreeMap;

use vc_graph::{Aabb, ChangeSet, Edge, EditError, NodeId, NodeKind, ObjectRole, Place, Relation, SceneGraph};

use crate::relations::Relations;
use crate::threshold::OUTSIDE_GAP;

/// Relations that are read from geometry anew each time, beside supports and rooms.
const FREE: [Relation; 9] = [
    Relation::Under,
    Relation::Touching,
    Relation::Near,
    Relation::NearFront,
    Relation::NearBack,
    Relation::NearLeft,
    Relation::NearRight,
    Relation::Facing,
    Relation::Between,
];

impl Relations {
    /// Whether a relation is read from geometry anew each time, beside supports and rooms: near, under, facing ...
    ///
    /// ```
    /// use vc_graph::Relation;
    /// use vc_relations::Relations;
    /// assert!(Relations::reads(Relation::Near) && !Relations::reads(Relation::On));
    /// ```
    pub fn reads(relation: Relation) -> bool {
        FREE.contains(&relation)
    }

    /// Writes the relations that start at some nodes into the graph, in place of its present ones; holding and
    /// wearing stay. Pass the nodes that [`Self::update`] returned, or all nodes. A thing without any known
    /// support keeps its place.
    ///
    /// # Errors
    /// [`EditError`] if the graph is not the one the relations were read from; nothing is changed then.
    ///
    /// ```
    /// use vc_graph::{Bounds, Draft, NodeId, Pose, SceneBuilder};
    /// use vc_relations::{Evidence, Relations, RelationRule};
    /// let size = |x, y, z| Bounds::standing(nalgebra::Vector3::new(x, y, z));
    /// let mut scene = SceneBuilder::new("corner");
    /// let table = scene.add(Draft::new("table").bounds(size(0.8, 1.2, 0.75)).at(Pose::identity()))?;
    /// let cup = Draft::new("cup").bounds(size(0.08, 0.08, 0.1)).at(Pose::translation(0.0, 0.0, 0.75));
    /// let cup = scene.add(cup)?;
    /// let mut graph = scene.build();
    /// let relations = Relations::new(&graph, RelationRule::Contacts, Evidence::default())?;
    /// relations.write(&mut graph, &[table, cup])?;
    /// assert_eq!(graph.place(cup).map(|p| p.at), Some(table));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn write(&self, graph: &mut SceneGraph, nodes: &[NodeId]) -> Result<ChangeSet, EditError> {
        self.write_except(graph, nodes, |_, _| None)
    }

    /// Like [`Self::write`], for callers that know the places of some things regardless of geometry: `known` is
    /// given the original graph and a node, and returns its places. Such a thing stays in its room of the
    /// graph.
    ///
    /// # Errors
    /// Those of [`Self::write`].
    pub fn write_except(
        &self,
        graph: &mut SceneGraph,
        nodes: &[NodeId],
        known: impl Fn(&SceneGraph, NodeId) -> Option<Vec<Place>>,
    ) -> Result<ChangeSet, EditError> {
        let mut edit = graph.edit();
        let there = |id: &NodeId| graph_has(edit.graph(), *id);
        let there: Vec<NodeId> = nodes.iter().copied().filter(there).collect();
        let mut own = self.edges_of_each(&there);
        for (id, edges) in &mut own {
            if let Some(places) = known(edit.graph(), *id) {
                edges.retain(|e| !rests(e) && e.relation != Relation::InRoom);
                edges.extend(places.into_iter().map(|p| Edge::new(*id, p.relation, p.at)));
            }
        }
        let own = carriers_first(own);
        // All things that move leave their old places first, so that no old place turns a new one into a cycle.
        let mut left: BTreeMap<NodeId, Vec<Place>> = BTreeMap::new();
        for (id, edges) in &own {
            let leaves = edges.iter().any(rests) || is_outside(edit.graph(), *id);
            if leaves && !is_held(edit.graph(), *id) && !is_placed(edit.graph(), *id, edges) {
                left.insert(*id, edit.graph().places(*id).collect());
                edit.detach(*id)?;
            }
        }
        for (id, edges) in &own {
            if !is_held(edit.graph(), *id) && !is_placed(edit.graph(), *id, edges) {
                put(&mut edit, *id, edges, left.remove(id).unwrap_or_default())?;
            }
            FREE.into_iter().try_for_each(|relation| replace(&mut edit, *id, relation, edges))?;
        }
        Ok(edit.commit())
    }
}

/// Orders nodes so that each comes after the ones it rests on: a thing that changes rooms together with its
/// support then finds it there already, and stays on it.
fn carriers_first(own: Vec<(NodeId, Vec<Edge>)>) -> Vec<(NodeId, Vec<Edge>)> {
    let mut open: Vec<(NodeId, Option<Vec<Edge>>)> = own.iter().rev().map(|(id, _)| (*id, None)).collect();
    let mut left: BTreeMap<NodeId, Vec<Edge>> = own.into_iter().collect();
    let mut ordered = Vec::with_capacity(left.len());
    while let Some((id, edges)) = open.pop() {
        if let Some(edges) = edges {
            ordered.push((id, edges));
        } else if let Some(edges) = left.remove(&id) {
            let carriers: Vec<NodeId> = edges.iter().filter(|e| rests(e)).map(|e| e.to).collect();
            open.push((id, Some(edges)));
            open.extend(carriers.into_iter().map(|at| (at, None)));
        }
    }
    ordered
}

/// Writes the relations of one kind that start at a node, if the graph has others. Symmetric ones may already
/// exist from the other end.
fn replace(edit: &mut vc_graph::Edit<'_>, id: NodeId, relation: Relation, edges: &[Edge]) -> Result<(), EditError> {
    // Both are sorted, and mostly there is nothing to do.
    let new = || edges.iter().filter(|e| e.relation == relation).map(|e| e.to);
    if edit.graph().related(id, relation).eq(new()) {
        return Ok(());
    }
    let (mut old, new): (Vec<NodeId>, Vec<NodeId>) = (edit.graph().related(id, relation).collect(), new().collect());
    if old.iter().any(|to| new.binary_search(to).is_err()) {
        edit.unrelate(id, &[relation])?;
        old.clear();
    }
    let added = new.into_iter().filter(|to| old.binary_search(to).is_err());
    added.map(|to| Edge::new(id, relation, to)).try_for_each(|edge| edit.relate(edge))
}

/// Whether a graph has a node in the room and at the places that the edges give, with these places in the same
/// room.
fn is_placed(graph: &SceneGraph, id: NodeId, edges: &[Edge]) -> bool {
    let (mut new, room) = whereabouts(graph, edges);
    let mut old: Vec<Place> = graph.places(id).collect();
    new.sort_unstable();
    old.sort_unstable();
    let is_here = |at: NodeId| room.is_none() || graph.room_of(at) == room;
    // A thing that rests on nothing for a moment keeps its place.
    let keeps = new.is_empty() && !is_outside(graph, id);
    (new == old || keeps) && is_here(id) && old.iter().all(|p| is_here(p.at))
}

/// The places and the room that edges give. A thing across a threshold is in a room whose floor carries it, on that floor.
fn whereabouts(graph: &SceneGraph, edges: &[Edge]) -> (Vec<Place>, Option<NodeId>) {
    let over = edges.iter().find(|e| e.relation == Relation::InRoom).map(|e| e.to);
    let mut places: Vec<Place> = edges.iter().filter(|e| rests(e)).map(place).collect();
    let is_floor = |at: NodeId| graph.node(at).is_some_and(|node| node.role() == ObjectRole::Floor);
    let floors: Vec<Option<NodeId>> = places.iter().filter(|p| is_floor(p.at)).map(|p| graph.room_of(p.at)).collect();
    let room = if floors.contains(&over) { over } else { floors.first().copied().unwrap_or(over) };
    places.retain(|p| !is_floor(p.at) || graph.room_of(p.at) == room);
    (places, room)
}

/// Whether a thing is outside something that it is inside by the graph.
fn is_outside(graph: &SceneGraph, id: NodeId) -> bool {
    let bounds = |id: NodeId| graph.node(id).and_then(vc_graph::Node::aabb);
    let is_out = |at: NodeId| {
        let middle = bounds(id).map(|own| own.centre());
        middle.zip(bounds(at)).is_some_and(|(at, outer)| outer.gap(&Aabb { min: at, max: at }) > OUTSIDE_GAP)
    };
    graph.related(id, Relation::Inside).any(is_out)
}

fn place(edge: &Edge) -> Place {
    Place { relation: edge.relation, at: edge.to }
}

fn graph_has(graph: &SceneGraph, id: NodeId) -> bool {
    graph.node(id).is_some_and(|n| n.kind() != NodeKind::Room)
}

fn is_held(graph: &SceneGraph, id: NodeId) -> bool {
    graph.holder(id).is_some() || graph.related(id, Relation::WornBy).next().is_some()
}

fn rests(edge: &Edge) -> bool {
    Relation::places().contains(&edge.relation) && edge.relation != Relation::WornBy
}

/// Puts a thing where edges have it, or where it was if these all rest on the thing itself.
fn put(edit: &mut vc_graph::Edit<'_>, id: NodeId, edges: &[Edge], was: Vec<Place>) -> Result<(), EditError> {
    let (new, room) = whereabouts(edit.graph(), edges);
    // The graph may have a thing that keeps its place resting on this one.
    let carried = |p: &Place| edit.graph().rests_at(p.at, id);
    let mut places: Vec<Place> = new.iter().copied().filter(|p| !carried(p)).collect();
    if places.is_empty() && !new.is_empty() {
        places = was.into_iter().filter(|p| !carried(p)).collect();
    }
    if !places.is_empty() {
        edit.place_as_seen(id, &places, None)?;
    }
    room.map_or(Ok(()), |room| edit.move_to_room(id, room))
}
