//! The positions where a person can stand, and the objects within reach from there.

use nalgebra::{Point2, Point3};
use vc_geometry::grid::{BitGrid, Disc};
use vc_graph::{Aabb, Anthropometry, AssetLibrary, Node, NodeId, NodeKind, ObjectRole, SceneGraph, Stream};

use super::solid::part_boxes;

/// The number of cells a metre.
const CELLS: f32 = 20.0;
/// The person for whom the floor is to be walkable.
const PERSON: Anthropometry = Anthropometry::ADULT;
/// The radius of a person, in cells, and that of the disc in which no centre of an obstacle's cell is.
const BODY: i32 = (PERSON.clearance * CELLS + 0.5) as i32;
const CLEAR: f32 = 4.5;
/// The largest number of a cell.
const FARTHEST: f32 = 1e8;

/// The floor as a grid: its largest connected walkable part.
#[derive(Debug, Clone)]
pub(super) struct Walk {
    low: Point2<i32>,
    /// The room of each cell, counted from one; zero where there is no floor.
    room: Vec<u16>,
    rooms: Vec<NodeId>,
    standing: BitGrid,
}

/// Columns and rows of cells.
type Span = ((i32, i32), (i32, i32));

impl Walk {
    /// Builds the grid of a scene; `None` where no room has a bounding box, or where there are more rooms or cells than
    /// a grid has numbers for. Doors are no obstacle.
    ///
    /// Costs about a millisecond for a home.
    pub(super) fn new(graph: &SceneGraph, assets: &AssetLibrary) -> Option<Self> {
        let mut walk = Self::floors(graph, assets)?;
        let mut open = walk.standing.empty();
        for (y, row) in walk.room.chunks(walk.width()).enumerate() {
            row.iter().enumerate().filter(|(_, room)| **room > 0).for_each(|(x, _)| open.set(x, y));
        }
        for node in graph.nodes().filter(|n| hinders(n)) {
            let built = node.role().is_built_in();
            let whole = node.aabb().filter(|_| !built);
            let parts = built.then(|| part_boxes(node, assets)).into_iter().flatten();
            let boxes = parts.chain(whole).filter(|b| b.min.z < PERSON.stature && b.max.z > PERSON.flat);
            for (x, y) in boxes.map(|b| walk.span(&b)) {
                open.fill(x, y, false);
            }
        }
        walk.standing = open.inverted().dilated(&Disc::within(CLEAR)).inverted().largest();
        Some(walk)
    }

    fn floors(graph: &SceneGraph, assets: &AssetLibrary) -> Option<Self> {
        let hulls = graph.rooms().iter().filter_map(|&r| graph.node(r)?.aabb());
        let hull = hulls.reduce(|a, b| a.joined(&b))?;
        let cell = |v: f32| (v * CELLS).floor().clamp(-FARTHEST, FARTHEST) as i32;
        let low = Point2::new(cell(hull.min.x) - BODY, cell(hull.min.y) - BODY);
        let (width, depth) = (cell(hull.max.x) + BODY + 1 - low.x, cell(hull.max.y) + BODY + 1 - low.y);
        const LARGEST: i64 = 1 << 24;
        // Rooms are numbered from one in sixteen bits.
        let too_many = graph.rooms().len() >= usize::from(u16::MAX);
        if too_many || width <= 0 || depth <= 0 || i64::from(width) * i64::from(depth) > LARGEST {
            return None;
        }
        let standing = BitGrid::new(width as usize, depth as usize);
        let room = vec![0; (width * depth) as usize];
        let mut walk = Self { low, room, rooms: graph.rooms().to_vec(), standing };
        for index in 0..walk.rooms.len() {
            let room = walk.rooms[index];
            let floors: Vec<&Node> =
                graph.in_room(room).filter_map(|id| graph.node(id)).filter(|n| n.role() == ObjectRole::Floor).collect();
            let slabs: Vec<Aabb> = floors.iter().flat_map(|n| part_boxes(n, assets)).collect();
            let own = graph.node(room).and_then(Node::aabb).filter(|_| slabs.is_empty());
            for slab in slabs.into_iter().chain(own) {
                walk.cells(&slab).for_each(|(x, y)| walk.room[y * width as usize + x] = index as u16 + 1);
            }
        }
        Some(walk)
    }

    /// The cells that a box touches, seen from above.
    fn span(&self, aabb: &Aabb) -> Span {
        const SLACK: f32 = 0.02;
        let from = |v: f32, low: i32| ((v * CELLS + SLACK).floor() as i32).saturating_sub(low).max(0);
        let to = |v: f32, low: i32| ((v * CELLS - SLACK).ceil() as i32).saturating_sub(low).max(0);
        let along = |axis: usize| (from(aabb.min[axis], self.low[axis]), to(aabb.max[axis], self.low[axis]));
        (along(0), along(1))
    }

    fn width(&self) -> usize {
        self.standing.width()
    }

    /// The room of a cell, counted from one.
    fn room_at(&self, (x, y): (usize, usize)) -> u16 {
        self.room[y * self.width() + x]
    }

    /// The cells that a box touches one by one, row by row.
    fn cells(&self, aabb: &Aabb) -> impl Iterator<Item = (usize, usize)> + use<> {
        let (x, y) = self.span(aabb);
        let (width, depth) = (self.width(), self.standing.height());
        let columns = x.0 as usize..(x.1 as usize).min(width);
        (y.0 as usize..(y.1 as usize).min(depth)).flat_map(move |y| columns.clone().map(move |x| (x, y)))
    }

    /// Whether a person in a room can reach a box.
    pub(super) fn reaches(&self, aabb: &Aabb, room: Option<NodeId>) -> bool {
        if aabb.min.z > PERSON.overhead {
            return false;
        }
        let index = room.and_then(|room| self.rooms.iter().position(|&r| r == room)).map(|i| i as u16 + 1);
        let grown = aabb.grown(PERSON.ahead, PERSON.ahead);
        let here =
            |&(x, y): &(usize, usize)| self.standing.get(x, y) && index.is_none_or(|i| self.room_at((x, y)) == i);
        self.cells(&grown).filter(here).any(|cell| self.distance(cell, aabb) <= PERSON.ahead)
    }

    fn middle(&self, (x, y): (usize, usize)) -> Point2<f32> {
        Point2::new((x as i32 + self.low.x) as f32 + 0.5, (y as i32 + self.low.y) as f32 + 0.5) / CELLS
    }

    fn distance(&self, cell: (usize, usize), aabb: &Aabb) -> f32 {
        let at = self.middle(cell);
        let nearest = aabb.nearest(&Point3::new(at.x, at.y, 0.0));
        (nearest.xy() - at).norm()
    }

    /// The rooms a person can stand in.
    pub(super) fn entered(&self) -> Vec<NodeId> {
        let inside = |index: usize| self.standing.cells().any(|cell| self.room_at(cell) == index as u16 + 1);
        (0..self.rooms.len()).filter(|&i| inside(i)).map(|i| self.rooms[i]).collect()
    }

    /// Samples a place to stand, if given in one room and within reach of a box.
    pub(super) fn spot(&self, room: Option<NodeId>, near: Option<&Aabb>, stream: &mut Stream) -> Option<Point2<f32>> {
        let index = room.and_then(|room| self.rooms.iter().position(|&r| r == room)).map(|i| i as u16 + 1);
        let fits = |&cell: &(usize, usize)| {
            let here = index.is_none_or(|i| self.room_at(cell) == i);
            here && near.is_none_or(|aabb| self.distance(cell, aabb) <= PERSON.ahead)
        };
        let cells: Vec<(usize, usize)> = self.standing.cells().filter(fits).collect();
        cells.get(stream.below(cells.len())).map(|&cell| self.middle(cell))
    }
}

/// Whether an object can be an obstacle: floors, doors and people cannot.
fn hinders(node: &Node) -> bool {
    node.kind() == NodeKind::Object && !matches!(node.role(), ObjectRole::Floor | ObjectRole::Door)
}
