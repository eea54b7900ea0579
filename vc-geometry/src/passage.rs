//! Open passages between rooms that no door connects.
//!
//! A scene of boxes has no hole in a wall, so a passage without a door or frame in it is lost. Rooms that are cut
//! off from the rest get one where it is likeliest: from the room with most doors, to a large room, in the widest
//! stretch of wall before which nothing stands on either side, and from where one gets farther into both rooms.

use std::collections::BTreeMap;

use nalgebra::{Point2, Point3};
use vc_graph::{Aabb, Node, NodeId, NodeKind, ObjectRole, SceneGraph};

use crate::grid::Raster;
use crate::opening::{DOORWAY, WallOpening, overlap, size, thin};
use crate::outline::{Outline, rectangle};

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
/// Side of a cell and distance kept from things when it is asked how far one gets beyond a passage, metres.
const CELL: f32 = 0.1;
const BODY: f32 = 0.25;
/// Floor that one has to get to beyond a passage, cells, and the share of a small room that is enough: a pocket beside
/// a fridge is less.
const BEYOND: usize = 100;
const SHARE: usize = 2;
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
    let mut floors = BTreeMap::new();
    let ranked = |opening: WallOpening| (Rank::new(graph, (openings, &parts), &opening, &mut floors), opening);
    let mut found: Vec<(Rank, WallOpening)> = candidates(graph, &parts).into_iter().map(ranked).collect();
    found.sort_by(|(p, a), (q, b)| p.order(q).then(a.door.cmp(&b.door)));
    let mut chosen: Vec<WallOpening> = found.into_iter().map(|(_, opening)| opening).collect();
    chosen.retain(|o| parts.join(&o.rooms));
    chosen.iter_mut().for_each(narrow);
    chosen
}

/// The widest passage through each wall, single or double, between rooms that are not connected.
fn candidates(graph: &SceneGraph, parts: &Parts) -> Vec<WallOpening> {
    let walls: Vec<Side> = graph.of_role(ObjectRole::Wall).filter_map(|wall| Side::new(graph, wall)).collect();
    let pairs = walls.iter().enumerate().flat_map(|(i, a)| walls[i + 1..].iter().map(move |b| (a, b)));
    let double = pairs.filter(|(a, b)| !parts.are_joined(a.room, b.room)).filter_map(|(a, b)| between(graph, a, b));
    let single = walls.iter().filter_map(|wall| alone(graph, wall));
    double.chain(single.filter(|o| !parts.are_joined(o.rooms[0], o.rooms[1]))).collect()
}

/// How likely a passage is to be one of the home.
struct Rank {
    /// It ends in a pocket of one of its rooms.
    dead_end: bool,
    /// It is not from the hall, which has most doors, but from a bedroom, say.
    doubtful: bool,
    /// Area of its rooms, square metres: large ones are open more often than small ones.
    area: f32,
    width: f32,
}

impl Rank {
    fn new(
        graph: &SceneGraph,
        (openings, parts): (&[WallOpening], &Parts),
        passage: &WallOpening,
        floors: &mut BTreeMap<NodeId, Option<Raster>>,
    ) -> Self {
        let aside = |room: &NodeId| parts.is_in_largest(*room) && !is_hub(openings, parts, *room);
        Self {
            dead_end: !leads_on(graph, passage, floors),
            doubtful: passage.rooms.iter().any(aside),
            area: passage.rooms.iter().map(|room| floor_area(graph, *room)).sum(),
            width: size(&passage.clear, 1 - passage.across),
        }
    }

    /// The likelier first.
    fn order(&self, other: &Self) -> std::cmp::Ordering {
        let doubts = |rank: &Self| (rank.dead_end, rank.doubtful);
        let sizes = other.area.total_cmp(&self.area).then(other.width.total_cmp(&self.width));
        doubts(self).cmp(&doubts(other)).then(sizes)
    }
}

/// Whether no room of its part has more doors.
fn is_hub(openings: &[WallOpening], parts: &Parts, room: NodeId) -> bool {
    let doors = |room: NodeId| openings.iter().filter(|o| o.is_doorway && o.rooms.contains(&room)).count();
    parts.0.keys().all(|other| !parts.are_joined(*other, room) || doors(*other) <= doors(room))
}

/// The area of the boxes of a room's floors, square metres.
fn floor_area(graph: &SceneGraph, room: NodeId) -> f32 {
    let floors = graph.of_role(ObjectRole::Floor).filter(|n| graph.room_of(n.id()) == Some(room));
    floors.filter_map(Node::aabb).map(|aabb| size(&aabb, 0) * size(&aabb, 1)).sum()
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
    through(graph, &[a.wall, b.wall], vec![a.room, b.room], (clear, across))
}

/// The widest passage through a wall that stands alone between the floors of two rooms.
fn alone(graph: &SceneGraph, side: &Side) -> Option<WallOpening> {
    let centre = side.aabb.centre();
    let reach = size(&side.aabb, side.axis) / 2.0 + BESIDE;
    let mut rooms: Vec<NodeId> =
        beside(&centre, side.axis, reach).iter().filter_map(|p| room_under(graph, p)).collect();
    rooms.sort_by_key(|room| *room != side.room);
    let between = rooms.len() == 2 && rooms[0] != rooms[1];
    between.then(|| through(graph, &[side.wall], rooms, (side.aabb, side.axis)))?
}

/// The widest passage through walls between two rooms, in the space that these share.
fn through(
    graph: &SceneGraph,
    walls: &[NodeId],
    rooms: Vec<NodeId>,
    (mut clear, across): (Aabb, usize),
) -> Option<WallOpening> {
    let along = 1 - across;
    if size(&clear, along) < NARROW || size(&clear, 2) < DOORWAY {
        return None;
    }
    clear.max.z = clear.min.z + DOORWAY;
    let (from, to) = widest(&barred(graph, walls, &clear, across), clear.min[along], clear.max[along])?;
    (clear.min[along], clear.max[along]) = (from, to);
    Some(WallOpening { door: walls[0], clear, across, rooms, is_doorway: true })
}

/// The stretches of a wall before which something stands, sorted.
fn barred(graph: &SceneGraph, walls: &[NodeId], clear: &Aabb, across: usize) -> Vec<(f32, f32)> {
    let mut before = *clear;
    before.min[across] -= BEFORE;
    before.max[across] += BEFORE;
    before.min.z += LOW;
    let along = 1 - across;
    let stands = |node: &&Node| {
        let covers = matches!(node.role(), ObjectRole::Floor | ObjectRole::Ceiling) || walls.contains(&node.id());
        node.kind() == NodeKind::Object && !covers
    };
    let met = graph.nodes().filter(stands).filter_map(Node::aabb).filter(|aabb| overlap(aabb, &before));
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
    let (from, to) = (best.0 + POST, best.1 - POST);
    (to - from >= NARROW).then_some((from, to))
}

/// Makes a passage no wider than passages are.
fn narrow(passage: &mut WallOpening) {
    let (clear, along) = (&mut passage.clear, 1 - passage.across);
    let (middle, wide) = (clear.centre()[along], size(clear, along).min(WIDE));
    (clear.min[along], clear.max[along]) = (middle - wide / 2.0, middle + wide / 2.0);
}

/// Whether one gets on from a passage in each of its rooms.
fn leads_on(graph: &SceneGraph, opening: &WallOpening, floors: &mut BTreeMap<NodeId, Option<Raster>>) -> bool {
    let (centre, axis) = (opening.clear.centre(), opening.across);
    let reach = size(&opening.clear, axis) / 2.0 + BESIDE;
    let beside = beside(&centre, axis, reach);
    opening.rooms.iter().all(|room| {
        let Some(floor) = floors.entry(*room).or_insert_with(|| free_floor(graph, *room)) else { return false };
        let all = floor.cells().count();
        let gets_on = |(x, y)| floor.cells().get(x, y) && floor.cells().flood(x, y).count() >= BEYOND.min(all / SHARE);
        beside.iter().filter_map(|point| floor.cell_of(point)).any(gets_on)
    })
}

/// The floor of a room on which a person can stand, as if all doors were shut.
fn free_floor(graph: &SceneGraph, room: NodeId) -> Option<Raster> {
    let aabb = |node: &Node| Some((node.role(), node.aabb()?));
    let in_room = graph.of_role(ObjectRole::Floor).filter(|n| graph.room_of(n.id()) == Some(room));
    let floors: Vec<Aabb> = in_room.filter_map(Node::aabb).collect();
    let around = floors.iter().copied().reduce(|a, b| Aabb { min: a.min.inf(&b.min), max: a.max.sup(&b.max) })?;
    let mut free = Raster::over(around.min.xy(), around.max.xy(), CELL)?;
    floors.iter().for_each(|floor| free.paint(&footprint(floor), 0.0, true));
    let (low, high) = (around.max.z + LOW, around.max.z + DOORWAY);
    for (role, aabb) in graph.nodes().filter(|n| n.kind() == NodeKind::Object).filter_map(aabb) {
        let stands = !matches!(role, ObjectRole::Floor | ObjectRole::Ceiling);
        if stands && aabb.min.z < high && aabb.max.z > low {
            free.paint(&footprint(&aabb), BODY, false);
        }
    }
    Some(free)
}

fn footprint(aabb: &Aabb) -> Outline {
    rectangle(&aabb.min.xy(), &aabb.max.xy())
}

/// The rooms that a doorway connects: those the scene says, else those whose floors are on its two sides.
fn rooms_beside(graph: &SceneGraph, opening: &WallOpening) -> Vec<NodeId> {
    if opening.rooms.len() > 1 {
        return opening.rooms.clone();
    }
    let reach = size(&opening.clear, opening.across) / 2.0 + BESIDE;
    let sides = beside(&opening.clear.centre(), opening.across, reach);
    sides.iter().filter_map(|point| room_under(graph, point)).chain(opening.rooms.iter().copied()).collect()
}

/// The points on both sides of one along an axis.
fn beside(centre: &Point3<f32>, axis: usize, reach: f32) -> [Point2<f32>; 2] {
    [-reach, reach].map(|by| {
        let mut point = centre.xy();
        point[axis] += by;
        point
    })
}

/// The room whose floor is below a point. The box of a floor with corners is also around its neighbours, so the smallest
/// counts.
fn room_under(graph: &SceneGraph, point: &Point2<f32>) -> Option<NodeId> {
    let holds = |aabb: &Aabb| (0..2).all(|i| (aabb.min[i]..=aabb.max[i]).contains(&point[i]));
    let area = |aabb: &Aabb| size(aabb, 0) * size(aabb, 1);
    let floors = graph.of_role(ObjectRole::Floor).filter_map(|n| Some((n.id(), n.aabb()?)));
    let smallest = floors.filter(|(_, aabb)| holds(aabb)).min_by(|p, q| area(&p.1).total_cmp(&area(&q.1)));
    smallest.and_then(|(id, _)| graph.room_of(id))
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

    /// Whether a room is in the part with most rooms.
    fn is_in_largest(&self, room: NodeId) -> bool {
        let rooms = |part: &NodeId| self.0.values().filter(|p| *p == part).count();
        let most = self.0.values().map(rooms).max();
        self.0.get(&room).map(rooms) == most
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
