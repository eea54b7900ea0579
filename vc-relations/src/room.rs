//! Which room something is in, also where rooms are not rectangles.

use nalgebra::Vector3;
use vc_graph::{Kind, NodeId, Relation, SceneGraph};

use crate::body::Body;
use crate::region::Region;
use crate::threshold::{BESIDE_DOOR, DOOR_SQUARE, ROOM_MARGIN, STOREY};
use crate::tree::Tree;

/// Rooms as boxes over their floors.
#[derive(Debug, Clone, Default)]
pub(crate) struct Rooms {
    boxes: Vec<(Region, NodeId)>,
    tree: Tree,
}

impl Rooms {
    /// A room is where its floors are, else its own shape, else its box.
    pub(crate) fn new(graph: &SceneGraph, body: impl Fn(NodeId) -> Option<Body>) -> Self {
        let mut boxes = Vec::new();
        for &room in graph.rooms() {
            let own = body(room);
            let height = own.as_ref().map(|b| (b.region.low.z, b.region.high.z));
            let mut put = |region: Region, floor: bool| {
                let storey =
                    if floor { (region.high.z, region.high.z + STOREY) } else { (region.low.z, region.high.z) };
                let (low, high) = height.unwrap_or(storey);
                let mut region = region;
                (region.low.z, region.high.z) = (low, high);
                boxes.push((region, room));
            };
            let floors: Vec<Body> = floors_of(graph, room).filter_map(&body).collect();
            if floors.is_empty() {
                let solids = own.iter().flat_map(|b| &b.solids);
                solids.for_each(|s| put(s.region(), false));
            } else {
                let solids = floors.iter().flat_map(|b| &b.solids);
                solids.for_each(|s| put(s.region(), true));
            }
        }
        let tree = Tree::new(&boxes.iter().map(|b| b.0.grown(ROOM_MARGIN, ROOM_MARGIN)).collect::<Vec<_>>());
        Self { boxes, tree }
    }

    /// The room of a point: of several the one in which it is deepest; of none the
    /// nearest, if it is within a wall's thickness.
    pub(crate) fn at(&self, point: &Vector3<f32>) -> Option<NodeId> {
        let mut best: Option<(f32, NodeId)> = None;
        self.tree.each(&Region { low: *point, high: *point }, |index| {
            let (region, room) = self.boxes[index];
            let depth = depth(&region, point);
            if best.is_none_or(|(d, r)| depth > d || (depth == d && room < r)) {
                best = Some((depth, room));
            }
        });
        best.filter(|(depth, _)| *depth >= -ROOM_MARGIN).map(|(_, room)| room)
    }

    /// The rooms on the two sides of a door, smaller number first; only one if the other side
    /// is outside. The box around a leaf that stands open is about as thick as wide and does
    /// not say which way the door leads: the way on which there are two rooms.
    pub(crate) fn beside(&self, door: &Body) -> Vec<NodeId> {
        let half = &door.whole.half;
        let thin = usize::from(half.x > half.y);
        let rooms = self.along(door, thin);
        if rooms.len() < 2 && half[thin] >= DOOR_SQUARE * half[1 - thin] {
            let other = self.along(door, 1 - thin);
            return if other.len() == 2 { other } else { rooms };
        }
        rooms
    }

    /// The rooms at the two ends of an axis of a door.
    fn along(&self, door: &Body, axis: usize) -> Vec<NodeId> {
        let whole = &door.whole;
        let across: Vector3<f32> = whole.axes.column(axis).into();
        let way = across * (whole.half[axis] + BESIDE_DOOR);
        let mut rooms: Vec<NodeId> = [way, -way].iter().filter_map(|w| self.at(&(whole.centre + w))).collect();
        rooms.sort_unstable();
        rooms.dedup();
        rooms
    }
}

fn floors_of(graph: &SceneGraph, room: NodeId) -> impl Iterator<Item = NodeId> + '_ {
    let is_floor = |id: &NodeId| {
        graph
            .node(*id)
            .is_some_and(|n| n.kind() == Kind::Object && (&**n.class() == "floor" || &*n.spec().category == "Floor"))
    };
    graph.relating(Relation::InRoom, room).filter(is_floor)
}

/// How far a point is from the sides of a region it is in; the negative distance to one it
/// is not in.
fn depth(region: &Region, point: &Vector3<f32>) -> f32 {
    let inner = (point - region.low).inf(&(region.high - point));
    let outside = inner.inf(&Vector3::zeros()).norm();
    if outside > 0.0 { -outside } else { inner.x.min(inner.y) }
}
