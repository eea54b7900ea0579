//! VirtualHome's definitions, on the world-aligned boxes of nodes.
//!
//! They follow its Unity program's computation of edges, as far as boxes allow:
//!
//! | relation | rule |
//! |---|---|
//! | near (CLOSE) | at most 1.5 m from one's centre to the other's box, either way; centres at most 5 m apart; rooms excluded |
//! | inside | the other's box contains both corners; the other is not part of the building |
//! | on | a box cast 5 cm down from the bottom hits the other; the other's centre is no higher than the bottom; over half of the footprint is above it; neither contains the other |
//! | between | a door, or a jamb without a door, whose box overlaps exactly two rooms |
//! | in room | the room in whose box the centre is deepest |
//!
//! The boxes of a file are not the colliders that VirtualHome casts. For on and between, several readings of
//! its sources are possible; the ones used here agree best with the five scenes that they are tested on, so
//! their scores are not held-out ones.

use nalgebra::Point3;
use vc_geometry::tree::BoxTree;
use vc_graph::{Aabb, Edge, Node, NodeId, NodeKind, ObjectRole, Relation, SceneGraph};

use crate::threshold::{VH_CAST, VH_CLOSE, VH_FAR, VH_FOOTPRINT, VH_ROUNDING};

struct Item<'g> {
    id: NodeId,
    node: &'g Node,
    aabb: Aabb,
    centre: Point3<f32>,
}

impl Item<'_> {
    fn is_door(&self) -> bool {
        matches!(self.node.role(), ObjectRole::Door | ObjectRole::DoorFrame)
    }

    fn is_jamb(&self) -> bool {
        self.node.role() == ObjectRole::DoorFrame
    }

    fn meets(&self, other: &Self) -> bool {
        (0..3).all(|k| self.aabb.min[k] <= other.aabb.max[k] && self.aabb.max[k] >= other.aabb.min[k])
    }
}

/// All relations by VirtualHome's rules, sorted.
pub(crate) fn edges(graph: &SceneGraph) -> Vec<Edge> {
    let item = |node| {
        let aabb = Node::aabb(node).filter(|a| a.min.iter().chain(a.max.iter()).all(|v| v.is_finite()))?;
        Some(Item { id: node.id(), node, aabb, centre: aabb.centre() })
    };
    let items: Vec<Item<'_>> = graph.nodes().filter_map(item).collect();
    let (rooms, things): (Vec<Item<'_>>, Vec<Item<'_>>) =
        items.into_iter().partition(|i| i.node.kind() == NodeKind::Room);
    let mut edges = Vec::new();
    let tree = BoxTree::new(&things.iter().map(|i| i.aabb).collect::<Vec<_>>());
    for (i, a) in things.iter().enumerate() {
        tree.for_each(&a.aabb.grown(VH_CLOSE, VH_CLOSE), |j| {
            if i != j {
                pair(a, &things[j], &mut edges);
            }
        });
        in_room(a, &rooms, &mut edges);
        between(a, &things, &rooms, &mut edges);
    }
    edges.sort_unstable();
    edges
}

fn pair(a: &Item<'_>, b: &Item<'_>, edges: &mut Vec<Edge>) {
    let mut add = |relation| edges.push(Edge::new(a.id, relation, b.id));
    if close(a, b) {
        add(Relation::Near);
    }
    if contains(&b.aabb, &a.aabb) {
        if ![a, b].into_iter().any(|item| item.node.role().is_built_in()) {
            add(Relation::Inside);
        }
    } else if on(a, b) {
        add(Relation::On);
    }
}

fn close(a: &Item<'_>, b: &Item<'_>) -> bool {
    let near = a.aabb.distance(&b.centre) <= VH_CLOSE || b.aabb.distance(&a.centre) <= VH_CLOSE;
    near && nalgebra::distance(&a.centre, &b.centre) <= VH_FAR
}

fn contains(outer: &Aabb, inner: &Aabb) -> bool {
    outer.contains(&inner.min) && outer.contains(&inner.max)
}

/// The box cast also hits a thing that contains the bottom (a pillow on a sofa, whose box goes up to its back),
/// so that only the support's centre limits the depth.
fn on(a: &Item<'_>, b: &Item<'_>) -> bool {
    let bottom = a.aabb.min.z;
    let meets = bottom - b.aabb.max.z <= VH_CAST && b.centre.z <= bottom + VH_ROUNDING;
    meets && !contains(&a.aabb, &b.aabb) && footprint(&a.aabb, &b.aabb) > VH_FOOTPRINT
}

/// The share of the first's footprint that lies over the other.
fn footprint(a: &Aabb, b: &Aabb) -> f32 {
    let shared = (a.max.inf(&b.max) - a.min.sup(&b.min)).xy().sup(&nalgebra::Vector2::zeros());
    let area = |a: &Aabb| (a.max.x - a.min.x) * (a.max.y - a.min.y);
    shared.x * shared.y / area(a).max(1e-9)
}

fn in_room(a: &Item<'_>, rooms: &[Item<'_>], edges: &mut Vec<Edge>) {
    let depth = |room: &Item<'_>| {
        let inner = (a.centre - room.aabb.min).inf(&(room.aabb.max - a.centre));
        inner.min()
    };
    let deepest = rooms.iter().max_by(|p, q| depth(p).total_cmp(&depth(q)).then(q.id.cmp(&p.id)));
    edges.extend(deepest.map(|room| Edge::new(a.id, Relation::InRoom, room.id)));
}

/// A door, or a jamb without one, is between two rooms if its box overlaps exactly these.
fn between(door: &Item<'_>, things: &[Item<'_>], rooms: &[Item<'_>], edges: &mut Vec<Edge>) {
    let leaf = |other: &Item<'_>| other.is_door() && !other.is_jamb() && other.meets(door);
    if !door.is_door() || (door.is_jamb() && things.iter().any(leaf)) {
        return;
    }
    let met: Vec<&Item<'_>> = rooms.iter().filter(|room| room.meets(door)).collect();
    if met.len() == 2 {
        edges.extend(met.iter().map(|room| Edge::new(door.id, Relation::Between, room.id)));
    }
}
