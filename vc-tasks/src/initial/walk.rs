//! The positions where a person can stand, and the objects within reach from there.

use nalgebra::{Point2, Point3};
use vc_graph::{Aabb, Anthropometry, AssetLibrary, Kind, Node, NodeId, ObjectRole, SceneGraph, Stream};

use super::solid::part_boxes;

/// The number of cells a metre.
const CELLS: f32 = 20.0;
/// The person for whom the floor is to be walkable.
const PERSON: Anthropometry = Anthropometry::ADULT;
/// The radius of a person, in cells.
const BODY: i32 = (PERSON.clearance * CELLS + 0.5) as i32;

/// The floor as a grid: its largest connected walkable part.
#[derive(Debug, Clone)]
pub(super) struct Walk {
    low: Point2<i32>,
    width: i32,
    depth: i32,
    /// The room of each cell, counted from one; zero where there is no floor.
    room: Vec<u16>,
    rooms: Vec<NodeId>,
    standing: Vec<bool>,
}

impl Walk {
    /// Builds the grid of a scene; `None` where no room has a bounding box. Doors are no obstacle.
    ///
    /// Costs about a millisecond for a home.
    pub(super) fn of(graph: &SceneGraph, assets: &AssetLibrary) -> Option<Self> {
        let mut walk = Self::floors(graph, assets)?;
        let mut blocked: Vec<bool> = walk.room.iter().map(|&room| room == 0).collect();
        for node in graph.nodes().filter(|n| hinders(n)) {
            let built = node.role().is_built_in();
            let whole = node.aabb().filter(|_| !built);
            let parts = built.then(|| part_boxes(node, assets)).into_iter().flatten();
            let boxes = parts.chain(whole).filter(|b| b.min.z < PERSON.stature && b.max.z > PERSON.flat);
            boxes.for_each(|b| walk.each_cell(&b, |cell| blocked[cell] = true));
        }
        walk.standing = walk.largest(&walk.free(&blocked));
        Some(walk)
    }

    fn floors(graph: &SceneGraph, assets: &AssetLibrary) -> Option<Self> {
        let hulls = graph.rooms().iter().filter_map(|&r| graph.node(r)?.aabb());
        let hull = hulls.reduce(|a, b| Aabb { min: a.min.inf(&b.min), max: a.max.sup(&b.max) })?;
        let cell = |v: f32| (v * CELLS).floor() as i32;
        let low = Point2::new(cell(hull.min.x) - BODY, cell(hull.min.y) - BODY);
        let (width, depth) = (cell(hull.max.x) + BODY + 1 - low.x, cell(hull.max.y) + BODY + 1 - low.y);
        const LARGEST: i64 = 1 << 24;
        if i64::from(width) * i64::from(depth) > LARGEST {
            return None;
        }
        let cells = (width * depth) as usize;
        let rooms = graph.rooms().to_vec();
        let mut walk = Self { low, width, depth, room: vec![0; cells], rooms, standing: Vec::new() };
        for index in 0..walk.rooms.len() {
            let room = walk.rooms[index];
            let floors: Vec<&Node> =
                graph.in_room(room).filter_map(|id| graph.node(id)).filter(|n| n.role() == ObjectRole::Floor).collect();
            let slabs: Vec<Aabb> = floors.iter().flat_map(|n| part_boxes(n, assets)).collect();
            let own = graph.node(room).and_then(Node::aabb).filter(|_| slabs.is_empty());
            for slab in slabs.into_iter().chain(own) {
                let mut cells = Vec::new();
                walk.each_cell(&slab, |cell| cells.push(cell));
                cells.into_iter().for_each(|cell| walk.room[cell] = index as u16 + 1);
            }
        }
        Some(walk)
    }

    /// Visits the cells that a box touches, seen from above.
    fn each_cell(&self, aabb: &Aabb, mut visit: impl FnMut(usize)) {
        const SLACK: f32 = 0.02;
        let from = |v: f32, low: i32| ((v * CELLS + SLACK).floor() as i32 - low).max(0);
        let to = |v: f32, low: i32, end: i32| ((v * CELLS - SLACK).ceil() as i32 - low).min(end);
        for y in from(aabb.min.y, self.low.y)..to(aabb.max.y, self.low.y, self.depth) {
            for x in from(aabb.min.x, self.low.x)..to(aabb.max.x, self.low.x, self.width) {
                visit((y * self.width + x) as usize);
            }
        }
    }

    /// The cells without an obstacle within a person's radius: a disc, tested row by row.
    fn free(&self, blocked: &[bool]) -> Vec<bool> {
        let (width, depth) = (self.width, self.depth);
        let mut sums = vec![0_u32; (width as usize + 1) * depth as usize];
        for y in 0..depth as usize {
            for x in 0..width as usize {
                let at = y * (width as usize + 1) + x;
                sums[at + 1] = sums[at] + u32::from(blocked[y * width as usize + x]);
            }
        }
        let clear = |x: i32, y: i32| {
            (-BODY..=BODY).all(|dy| {
                // A cell counts if its centre is within the disc.
                let reach = (0..=BODY).rev().find(|dx| dx * dx + dy * dy <= BODY * BODY - BODY).unwrap_or(-1);
                let row = y + dy;
                if reach < 0 || row < 0 || row >= depth {
                    return true;
                }
                let (from, to) = ((x - reach).max(0), (x + reach + 1).min(width));
                let at = row as usize * (width as usize + 1);
                sums[at + to as usize] == sums[at + from as usize]
            })
        };
        let cells = (0..depth).flat_map(|y| (0..width).map(move |x| (x, y)));
        cells.map(|(x, y)| !blocked[(y * width + x) as usize] && clear(x, y)).collect()
    }

    /// The largest connected set of free cells.
    fn largest(&self, free: &[bool]) -> Vec<bool> {
        let mut seen = vec![false; free.len()];
        let mut best: Vec<usize> = Vec::new();
        for start in 0..free.len() {
            if free[start] && !seen[start] {
                let found = self.flood(start, free, &mut seen);
                if found.len() > best.len() {
                    best = found;
                }
            }
        }
        let mut standing = vec![false; free.len()];
        best.into_iter().for_each(|cell| standing[cell] = true);
        standing
    }

    fn flood(&self, start: usize, free: &[bool], seen: &mut [bool]) -> Vec<usize> {
        let width = self.width as usize;
        let mut found = vec![start];
        seen[start] = true;
        let mut next = 0;
        while let Some(&cell) = found.get(next) {
            next += 1;
            let x = cell % width;
            let west = (x > 0).then(|| cell - 1);
            let east = (x + 1 < width).then_some(cell + 1);
            let around = [west, east, cell.checked_sub(width), Some(cell + width)];
            for cell in around.into_iter().flatten().filter(|&c| c < free.len()) {
                if free[cell] && !seen[cell] {
                    seen[cell] = true;
                    found.push(cell);
                }
            }
        }
        found
    }

    /// Whether a person in a room can reach a box.
    pub(super) fn reaches(&self, aabb: &Aabb, room: Option<NodeId>) -> bool {
        if aabb.min.z > PERSON.overhead {
            return false;
        }
        let index = room.and_then(|room| self.rooms.iter().position(|&r| r == room)).map(|i| i as u16 + 1);
        let grown = Aabb { min: aabb.min.map(|v| v - PERSON.ahead), max: aabb.max.map(|v| v + PERSON.ahead) };
        let mut reached = false;
        self.each_cell(&grown, |cell| {
            let here = self.standing[cell] && index.is_none_or(|i| self.room[cell] == i);
            reached = reached || (here && self.distance(cell, aabb) <= PERSON.ahead);
        });
        reached
    }

    fn middle(&self, cell: usize) -> Point2<f32> {
        let (x, y) = (cell as i32 % self.width, cell as i32 / self.width);
        Point2::new((x + self.low.x) as f32 + 0.5, (y + self.low.y) as f32 + 0.5) / CELLS
    }

    fn distance(&self, cell: usize, aabb: &Aabb) -> f32 {
        let at = self.middle(cell);
        let nearest = aabb.nearest(&Point3::new(at.x, at.y, 0.0));
        (nearest.xy() - at).norm()
    }

    /// The rooms a person can stand in.
    pub(super) fn entered(&self) -> Vec<NodeId> {
        let inside = |index: usize| {
            let number = index as u16 + 1;
            self.standing.iter().zip(&self.room).any(|(&standing, &room)| standing && room == number)
        };
        (0..self.rooms.len()).filter(|&i| inside(i)).map(|i| self.rooms[i]).collect()
    }

    /// Samples a place to stand, if given in one room and within reach of a box.
    pub(super) fn spot(&self, room: Option<NodeId>, near: Option<&Aabb>, stream: &mut Stream) -> Option<Point2<f32>> {
        let index = room.and_then(|room| self.rooms.iter().position(|&r| r == room)).map(|i| i as u16 + 1);
        let fits = |&cell: &usize| {
            let here = self.standing[cell] && index.is_none_or(|i| self.room[cell] == i);
            here && near.is_none_or(|aabb| self.distance(cell, aabb) <= PERSON.ahead)
        };
        let cells: Vec<usize> = (0..self.standing.len()).filter(fits).collect();
        cells.get(stream.below(cells.len())).map(|&cell| self.middle(cell))
    }
}

/// Whether an object can be an obstacle: floors, doors and people cannot.
fn hinders(node: &Node) -> bool {
    node.kind() == Kind::Object && !matches!(node.role(), ObjectRole::Floor | ObjectRole::Door)
}
