//! The floor plan of a scene of boxes: floors, walls, openings, furniture.

use std::collections::BTreeMap;
use std::sync::Arc;

use nalgebra::Point2;
use vc_geometry::WallOpening;
use vc_graph::{
    Aabb, Asset, Bounds, BoundsFrame, ClassTable, Node, NodeId, NodeKind, ObjectRole, Property, SceneGraph,
};
use vc_shapes::Generators;

use super::holders;

/// The geometry of a scene that matters for the appearance and orientation of objects.
pub(super) struct House<'g> {
    pub(super) graph: &'g SceneGraph,
    pub(super) generators: &'g Generators,
    /// Floors.
    pub(super) floors: Vec<Aabb>,
    /// Straight pieces of wall.
    pub(super) walls: Vec<Aabb>,
    /// Doors, door frames and windows.
    pub(super) openings: Vec<WallOpening>,
    /// The shapes that `vc-geometry` gives to walls, floors, ceilings and counters around corners.
    pub(super) shapes: BTreeMap<NodeId, Asset>,
    /// The objects that are in the way of a walking person.
    standing: Vec<(NodeId, Aabb)>,
    /// The supports and containers of each object.
    holders: BTreeMap<NodeId, Vec<NodeId>>,
}

/// The heights above the floor between which objects obstruct a walking person, metres.
const WAY: (f32, f32) = (0.12, 1.6);

impl<'g> House<'g> {
    pub(super) fn new(graph: &'g SceneGraph, generators: &'g Generators) -> Self {
        let objects = || graph.nodes().filter(|n| n.kind() == NodeKind::Object);
        let mut shapes = vc_geometry::shapes(graph);
        let (floor, wall, ceiling) = (ObjectRole::Floor, ObjectRole::Wall, ObjectRole::Ceiling);
        let built = |n: &Node| [floor, wall, ceiling].contains(&n.role()) || goes_around(n);
        shapes.retain(|id, _| graph.node(*id).is_some_and(built));
        let pieces = |n: &Node| shapes.get(&n.id()).map_or_else(Vec::new, |asset| pieces(n, asset));
        let mut house = Self {
            graph,
            generators,
            floors: graph.of_role(floor).filter_map(Node::aabb).collect(),
            walls: graph.of_role(wall).flat_map(pieces).collect(),
            openings: vc_geometry::openings(graph),
            shapes: BTreeMap::new(),
            standing: Vec::new(),
            holders: BTreeMap::new(),
        };
        house.shapes = shapes;
        house.standing =
            objects().filter(|n| stands(graph.classes(), n)).filter_map(|n| Some((n.id(), n.aabb()?))).collect();
        let chain = |n: &Node| (n.id(), holders(graph, n.id()).map(Node::id).collect());
        house.holders = objects().map(chain).collect();
        house
    }

    /// Whether a node is a door frame.
    pub(super) fn is_frame(&self, id: NodeId) -> bool {
        self.graph.node(id).is_some_and(|n| n.role() == ObjectRole::DoorFrame)
    }

    /// The supports and containers of an object, the nearest first.
    pub(super) fn holders_of(&self, id: NodeId) -> &[NodeId] {
        self.holders.get(&id).map_or(&[], Vec::as_slice)
    }

    /// The height of the floor below an object, metres.
    pub(super) fn level(&self, around: &Aabb) -> f32 {
        let centre = around.centre();
        let below = self.floors.iter().filter(|f| covers(f, centre.xy()) && f.max.z < centre.z);
        let under = below.map(|f| f.max.z).reduce(f32::max);
        under.or_else(|| self.floors.iter().map(|f| f.max.z).reduce(f32::min)).unwrap_or(around.min.z)
    }

    /// Whether a point is above a floor.
    pub(super) fn has_floor(&self, at: Point2<f32>) -> bool {
        self.floors.iter().any(|f| covers(f, at))
    }

    /// Whether there is free floor to stand on at a point. The node `who`, its holders and its load do not
    /// count as in the way.
    pub(super) fn is_free(&self, at: Point2<f32>, level: f32, who: NodeId) -> bool {
        let in_way = |b: &Aabb| covers(b, at) && b.min.z < level + WAY.1 && b.max.z > level + WAY.0;
        let apart =
            |id: NodeId| id != who && !self.holders_of(who).contains(&id) && !self.holders_of(id).contains(&who);
        self.has_floor(at)
            && !self.walls.iter().any(|w| covers(w, at))
            && !self.standing.iter().any(|(id, b)| in_way(b) && apart(*id))
    }

    /// The objects of a class and its subclasses, with their classes and bounding boxes.
    pub(super) fn of_kind<'a>(&'a self, kind: &'a str) -> impl Iterator<Item = (NodeId, &'a Arc<str>, Aabb)> + 'a {
        let classes = self.graph.classes();
        let of_kind = move |n: &&Node| n.kind() == NodeKind::Object && classes.is_a(n.class(), kind);
        self.graph.nodes().filter(of_kind).filter_map(|n| Some((n.id(), n.class(), n.aabb()?)))
    }
}

/// Whether an object obstructs a walking person: it is neither part of the building, nor graspable, nor a seat that can
/// be moved aside.
fn stands(classes: &ClassTable, node: &Node) -> bool {
    !node.role().is_built_in() && !node.affords(Property::Graspable) && !is_seat(classes, node.class())
}

/// Whether the box of a worktop goes around a corner and so contains the objects that stand there.
pub(super) fn goes_around(node: &Node) -> bool {
    const DEEPEST: f32 = 1.5;
    let size = node.aabb().map(|b| b.max - b.min);
    &**node.class() == "kitchen_counter" && size.is_some_and(|s| s.x.min(s.y) > DEEPEST)
}

/// Whether a class is a seat that is drawn up to a table.
pub(super) fn is_seat(classes: &ClassTable, class: &str) -> bool {
    ["chair", "stool", "bench"].iter().any(|kind| classes.is_a(class, kind))
}

fn covers(b: &Aabb, at: Point2<f32>) -> bool {
    (b.min.x..=b.max.x).contains(&at.x) && (b.min.y..=b.max.y).contains(&at.y)
}

/// The parts of an object as boxes in the world.
fn pieces(node: &Node, asset: &Asset) -> Vec<Aabb> {
    let Some(pose) = node.pose() else { return Vec::new() };
    let placed = |part: &vc_graph::asset::Part| {
        let (low, high) = part.extent();
        let half = (high - low) / 2.0;
        let bounds = Bounds { offset: nalgebra::center(&low, &high).coords, half, frame: BoundsFrame::Object };
        bounds.aabb(pose)
    };
    asset.parts.iter().map(placed).collect()
}
