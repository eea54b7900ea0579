//! The room of a thing, also if rooms are not rectangles.

use std::collections::BTreeMap;

use nalgebra::{Matrix3, Vector3};
use vc_geometry::tree::BoxTree;
use vc_graph::{Aabb, NodeId, ObjectRole, Relation, SceneGraph};

use crate::body::Body;
use crate::solid::{Round, Solid};
use crate::threshold::{BESIDE_DOOR, DOOR_SQUARE, ROOM_MARGIN, STOREY};

/// Rooms as oriented boxes above their floors.
#[derive(Debug, Clone, Default)]
pub(crate) struct Rooms {
    boxes: Vec<(Solid, NodeId)>,
    tree: BoxTree,
    /// The room of each floor.
    floors: BTreeMap<NodeId, NodeId>,
}

/// A point beside a door, and the room there.
pub(crate) type Beyond = (Vector3<f32>, Option<NodeId>);

impl Rooms {
    /// A room extends over its floors, otherwise over its own shape, otherwise over its box.
    pub(crate) fn new(graph: &SceneGraph, body: impl Fn(NodeId) -> Option<Body>) -> Self {
        let (mut boxes, mut of_rooms) = (Vec::new(), BTreeMap::new());
        for &room in graph.rooms() {
            let own = body(room);
            let height = own.as_ref().map(|b| (b.region.min.z, b.region.max.z));
            let floors: Vec<Body> = floors_of(graph, room).filter_map(&body).collect();
            of_rooms.extend(floors.iter().map(|floor| (floor.id, room)));
            let mut put = |s: &Solid, storey: (f32, f32)| boxes.push((over(s, height.unwrap_or(storey)), room));
            if floors.is_empty() {
                own.iter().flat_map(|b| &b.solids).for_each(|s| put(s, (s.low.z, s.high.z)));
            } else {
                floors.iter().flat_map(|b| &b.solids).for_each(|s| put(s, (s.high.z, s.high.z + STOREY)));
            }
        }
        let reach = |b: &(Solid, NodeId)| b.0.region().grown(ROOM_MARGIN, ROOM_MARGIN);
        let tree = BoxTree::new(&boxes.iter().map(reach).collect::<Vec<_>>());
        Self { boxes, tree, floors: of_rooms }
    }

    /// The room of a thing: the one that contains its reference point. A floor belongs to its own room, as the
    /// centre of an L-shaped one can be in the next.
    pub(crate) fn room_of(&self, body: &Body) -> Option<NodeId> {
        self.floors.get(&body.id).copied().or_else(|| self.at(&body.midst()))
    }

    /// Whether a node is a room with an extent.
    pub(crate) fn has(&self, id: NodeId) -> bool {
        self.boxes.iter().any(|b| b.1 == id)
    }

    /// The room of a point: if it is in several, the one in which it is deepest; if it is in none, the nearest
    /// one within the thickness of a wall.
    pub(crate) fn at(&self, point: &Vector3<f32>) -> Option<NodeId> {
        let mut best: Option<(f32, NodeId)> = None;
        self.tree.for_each(&Aabb { min: (*point).into(), max: (*point).into() }, |index| {
            let (over, room) = &self.boxes[index];
            let (depth, room) = (depth(over, point), *room);
            if best.is_none_or(|(d, r)| depth > d || (depth == d && room < r)) {
                best = Some((depth, room));
            }
        });
        best.filter(|(depth, _)| *depth >= -ROOM_MARGIN).map(|(_, room)| room)
    }

    /// Depth of a point in each room, metres, negative outside; the deepest first.
    pub(crate) fn depths(&self, point: &Vector3<f32>) -> Vec<(NodeId, f32)> {
        let mut depths: BTreeMap<NodeId, f32> = BTreeMap::new();
        for (over, room) in &self.boxes {
            let deepest = depths.entry(*room).or_insert(f32::NEG_INFINITY);
            *deepest = deepest.max(depth(over, point));
        }
        let mut depths: Vec<(NodeId, f32)> = depths.into_iter().collect();
        depths.sort_by(|a, b| b.1.total_cmp(&a.1));
        depths
    }

    /// The rooms on the two sides of a door, the smaller number first; only one if the other side is outside.
    pub(crate) fn beside(&self, door: &Body) -> Vec<NodeId> {
        let mut rooms: Vec<NodeId> = self.sides(door).into_iter().filter_map(|s| s.1).collect();
        rooms.sort_unstable();
        rooms.dedup();
        rooms
    }

    /// The points and rooms on the two sides of a door. The box around a leaf that stands open is about as
    /// thick as wide and does not show which way the door leads; then the axis with a room at both ends is
    /// taken.
    pub(crate) fn sides(&self, door: &Body) -> [Beyond; 2] {
        let half = &door.whole.half;
        let thin = usize::from(half.x > half.y);
        let across = self.along(door, thin);
        if joins_two(&across) || half[thin] < DOOR_SQUARE * half[1 - thin] {
            return across;
        }
        let other = self.along(door, 1 - thin);
        if joins_two(&other) { other } else { across }
    }

    /// The points and rooms at the two ends of an axis of a door.
    fn along(&self, door: &Body, axis: usize) -> [Beyond; 2] {
        let whole = &door.whole;
        let across: Vector3<f32> = whole.axes.column(axis).into();
        let way = across * (whole.half[axis] + BESIDE_DOOR);
        [whole.centre + way, whole.centre - way].map(|at| (at, self.at(&at)))
    }
}

fn joins_two([one, other]: &[Beyond; 2]) -> bool {
    one.1.is_some() && other.1.is_some() && one.1 != other.1
}

/// The box above a piece of floor from one height to another; for a tilted piece, its world-aligned box.
fn over(floor: &Solid, (low, high): (f32, f32)) -> Solid {
    let lying = (Matrix3::identity(), (floor.high - floor.low) / 2.0);
    let (axes, half) = if floor.upright { (floor.axes, floor.half) } else { lying };
    let centre = Vector3::new(floor.centre.x, floor.centre.y, f32::midpoint(low, high));
    Solid::new(centre, axes, Vector3::new(half.x, half.y, (high - low) / 2.0), Round::No)
}

fn floors_of(graph: &SceneGraph, room: NodeId) -> impl Iterator<Item = NodeId> + '_ {
    let is_floor = |id: &NodeId| graph.node(*id).is_some_and(|n| n.role() == ObjectRole::Floor);
    graph.relating(Relation::InRoom, room).filter(is_floor)
}

/// Distance of a point from the sides of a box that contains it; outside, the negative distance to the box.
fn depth(over: &Solid, point: &Vector3<f32>) -> f32 {
    let inner = over.half - over.axes.tr_mul(&(point - over.centre)).abs();
    let outside = inner.inf(&Vector3::zeros()).norm();
    if outside > 0.0 { -outside } else { inner.x.min(inner.y) }
}
