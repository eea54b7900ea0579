//! Open passages between rooms that no door connects.
//!
//! A scene of boxes has no hole in a wall, so a passage without a door or frame in it is lost. Rooms that are cut
//! off from the rest get one where it is likeliest: from a room with many doors, in the widest stretch of wall before
//! which nothing stands on either side.

use std::collections::BTreeMap;

use vc_graph::{Aabb, Node, NodeId, NodeKind, ObjectRole, SceneGraph};

use crate::opening::{DOORWAY, WallOpening, size, thin};

/// Distance up to which the walls of two rooms are the two sides of one wall, metres between their middles.
const DOUBLE: f32 = 0.35;
/// Narrowest and widest passage, metres.
const NARROW: f32 = 0.75;
const WIDE: f32 = 1.4;
/// Wall that is left on either side of a passage, metres.
const POST: f32 = 0.06;
/// Floor before a passage on which nothing stands, metres.
const BEFORE: f32 = 0.45;
/// Things that are lower, such as rugs, do not bar a passage, metres.
const LOW: f32 = 0.06;
/// Distance from an opening at which the floor of a room is looked for, metres.
const BESIDE: f32 = 0.4;

/// The passages that connect rooms which `openings` leave cut off, the likeliest first.
pub(crate) fn passages(graph: &SceneGraph, openings: &[WallOpening]) -> Vec<WallOpening> {
    let mut parts = Parts::new(graph);
    for opening in openings.iter().filter(|o| o.is_doorway) {
        parts.join(&rooms_beside(graph, opening));
    }
    if parts.count() < 2 {
        return Vec::new();
    }
    let walls: Vec<Side> = graph.of_role(ObjectRole::Wall).filter_map(|wall| Side::new(graph, wall)).collect();
    let pairs = walls.iter().enumerate().flat_map(|(i, a)| walls[i + 1..].iter().map(move |b| (a, b)));
    let apart: Vec<(&Side, &Side)> = pairs.filter(|(a, b)| !parts.are_joined(a.room, b.room)).collect();
    let mut found: Vec<WallOpening> = apart.into_iter().filter_map(|(a, b)| between(graph, a, b)).collect();
    // Rooms with many doors are those that one goes through; a bathroom is not.
    let doors = |o: &WallOpening| openings.iter().flat_map(|door| &door.rooms).filter(|r| o.rooms.contains(r)).count();
    let width = |o: &WallOpening| size(&o.clear, 1 - o.across);
    found.sort_by(|p, q| doors(q).cmp(&doors(p)).then(width(q).total_cmp(&width(p))).then(p.door.cmp(&q.door)));
    found.retain(|o| parts.join(&o.rooms));
    found
}

/// A thin wall of a room.
struct Side {
    wall: NodeId,
    room: NodeId,
    axis: usize,
    aabb: Aabb,
}

impl Side {
    fn new(graph: &SceneGraph, wall: &Node) -> Option<Self> {
        let aabb = wall.aabb().filter(|_| crate::is_bare(wall))?;
        Some(Self { wall: wall.id(), room: graph.room_of(wall.id())?, axis: thin(&aabb)?, aabb })
    }
}

/// The widest passage through two walls, if they are the two sides of one.
fn between(graph: &SceneGraph, a: &Side, b: &Side) -> Option<WallOpening> {
    let (across, along) = (a.axis, 1 - a.axis);
    if b.axis != across || (a.aabb.centre()[across] - b.aabb.centre()[across]).abs() > DOUBLE {
        return None;
    }
    let mut clear = a.aabb;
    for axis in [along, 2] {
        (clear.min[axis], clear.max[axis]) =
            (a.aabb.min[axis].max(b.aabb.min[axis]), a.aabb.max[axis].min(b.aabb.max[axis]));
    }
    (clear.min[across], clear.max[across]) =
        (a.aabb.min[across].min(b.aabb.min[across]), a.aabb.max[across].max(b.aabb.max[across]));
    if size(&clear, along) < NARROW || size(&clear, 2) < DOORWAY {
        return None;
    }
    clear.max.z = clear.min.z + DOORWAY;
    let (from, to) = widest(&barred(graph, [a.wall, b.wall], &clear, across), clear.min[along], clear.max[along])?;
    (clear.min[along], clear.max[along]) = (from, to);
    Some(WallOpening { door: a.wall, clear, across, rooms: vec![a.room, b.room], is_doorway: true })
}

/// The stretches of a wall before which something stands, sorted.
fn barred(graph: &SceneGraph, walls: [NodeId; 2], clear: &Aabb, across: usize) -> Vec<(f32, f32)> {
    let mut before = *clear;
    before.min[across] -= BEFORE;
    before.max[across] += BEFORE;
    before.min.z += LOW;
    let along = 1 - across;
    let stands = |node: &&Node| {
        let covers = matches!(node.role(), ObjectRole::Floor | ObjectRole::Ceiling) || walls.contains(&node.id());
        node.kind() == NodeKind::Object && !covers
    };
    let meets = |aabb: &Aabb| (0..3).all(|i| aabb.min[i] < before.max[i] && before.min[i] < aabb.max[i]);
    let met = graph.nodes().filter(stands).filter_map(Node::aabb).filter(meets);
    let mut barred: Vec<(f32, f32)> = met.map(|aabb| (aabb.min[along], aabb.max[along])).collect();
    barred.sort_by(|p, q| p.0.total_cmp(&q.0));
    barred
}

/// The widest stretch between two ends that is free, with its posts taken off, if one can walk through it.
fn widest(barred: &[(f32, f32)], from: f32, to: f32) -> Option<(f32, f32)> {
    let (mut at, mut best) = (from, (from, from));
    for &(low, high) in barred.iter().chain(&[(to, to)]) {
        let end = low.min(to);
        if end - at > best.1 - best.0 {
            best = (at, end);
        }
        at = at.max(high);
    }
    let (middle, wide) = (f32::midpoint(best.0, best.1), (best.1 - best.0 - 2.0 * POST).min(WIDE));
    (wide >= NARROW).then_some((middle - wide / 2.0, middle + wide / 2.0))
}

/// The rooms that a doorway connects: those the scene says, else those whose floors are on its two sides.
fn rooms_beside(graph: &SceneGraph, opening: &WallOpening) -> Vec<NodeId> {
    if opening.rooms.len() > 1 {
        return opening.rooms.clone();
    }
    let (centre, axis) = (opening.clear.centre(), opening.across);
    let reach = size(&opening.clear, axis) / 2.0 + BESIDE;
    let beside = |by: f32| {
        let mut point = centre;
        point[axis] += by;
        let holds = |aabb: &Aabb| (0..2).all(|i| (aabb.min[i]..=aabb.max[i]).contains(&point[i]));
        let floors = graph.of_role(ObjectRole::Floor).filter_map(|n| Some((n.id(), n.aabb()?)));
        let area = |aabb: &Aabb| size(aabb, 0) * size(aabb, 1);
        // The box of a floor with corners is also around its neighbours, so the smaller one is the room's.
        let smallest = floors.filter(|(_, aabb)| holds(aabb)).min_by(|p, q| area(&p.1).total_cmp(&area(&q.1)));
        smallest.and_then(|(id, _)| graph.room_of(id))
    };
    [-reach, reach].into_iter().filter_map(beside).chain(opening.rooms.iter().copied()).collect()
}

/// Rooms with a floor, and which of them are connected: each room has the least of its part.
struct Parts(BTreeMap<NodeId, NodeId>);

impl Parts {
    fn new(graph: &SceneGraph) -> Self {
        Self(graph.of_role(ObjectRole::Floor).filter_map(|floor| graph.room_of(floor.id())).map(|r| (r, r)).collect())
    }

    fn count(&self) -> usize {
        self.0.iter().filter(|(room, part)| room == part).count()
    }

    fn are_joined(&self, a: NodeId, b: NodeId) -> bool {
        match (self.0.get(&a), self.0.get(&b)) {
            (Some(a), Some(b)) => a == b,
            _ => true,
        }
    }

    /// Joins rooms; returns whether any of them were apart.
    fn join(&mut self, rooms: &[NodeId]) -> bool {
        let parts: Vec<NodeId> = rooms.iter().filter_map(|room| self.0.get(room)).copied().collect();
        let Some(least) = parts.iter().min().copied() else { return false };
        self.0.values_mut().filter(|part| parts.contains(part)).for_each(|part| *part = least);
        parts.iter().any(|part| *part != least)
    }
}
