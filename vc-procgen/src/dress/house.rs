//! What stands where in a scene of boxes: floors, walls, openings, furniture.

use std::collections::BTreeMap;
use std::sync::Arc;

use nalgebra::Point2;
use vc_graph::{Aabb, ClassTable, Kind, Node, NodeId, Property, SceneGraph};

use super::holders;
use super::shell::{self, Opening};

/// A scene's geometry, as far as it says how things look and which way they face.
pub(super) struct House<'g> {
    pub(super) graph: &'g SceneGraph,
    /// Floors, with their rooms.
    pub(super) floors: Vec<(Aabb, Option<NodeId>)>,
    /// Straight pieces of wall.
    pub(super) walls: Vec<Aabb>,
    /// Holes in walls for doors and windows.
    pub(super) openings: Vec<Opening>,
    /// What stands in the way of somebody who walks.
    standing: Vec<(NodeId, Aabb)>,
    /// For each thing what it rests on or in.
    holders: BTreeMap<NodeId, Vec<NodeId>>,
}

/// Heights over the floor between which things stand in the way, metres.
const WAY: (f32, f32) = (0.12, 1.6);

impl<'g> House<'g> {
    pub(super) fn of(graph: &'g SceneGraph) -> Self {
        let objects = || graph.nodes().filter(|n| n.kind() == Kind::Object);
        let of_class = |class: &'static str| objects().filter(move |n| &**n.class() == class);
        let boxed = |n: &Node| Some((n.aabb()?, graph.room_of(n.id())));
        let mut house = Self {
            graph,
            floors: of_class("floor").filter_map(boxed).collect(),
            walls: Vec::new(),
            openings: Vec::new(),
            standing: Vec::new(),
            holders: BTreeMap::new(),
        };
        house.walls = of_class("wall").flat_map(|n| shell::arms(&house, n)).collect();
        house.openings = shell::openings(&house);
        house.standing = objects().filter(|n| stands(graph.classes(), n)).filter_map(|n| Some((n.id(), n.aabb()?))).collect();
        let chain = |n: &Node| (n.id(), holders(graph, n.id()).map(Node::id).collect());
        house.holders = objects().map(chain).collect();
        house
    }

    /// What a thing rests on or in, the nearest first.
    pub(super) fn holders_of(&self, id: NodeId) -> &[NodeId] {
        self.holders.get(&id).map_or(&[], Vec::as_slice)
    }

    /// The height of the floor below a thing, metres.
    pub(super) fn level(&self, around: &Aabb) -> f32 {
        let centre = around.centre();
        let below = self.floors.iter().filter(|(f, _)| covers(f, centre.xy()) && f.max.z < centre.z);
        let under = below.map(|(f, _)| f.max.z).reduce(f32::max);
        under.or_else(|| self.floors.iter().map(|(f, _)| f.max.z).reduce(f32::min)).unwrap_or(around.min.z)
    }

    /// Whether there is floor at a point that one can stand on, whatever `who` and what holds it
    /// or rests at it take of it.
    pub(super) fn is_free(&self, at: Point2<f32>, level: f32, who: NodeId) -> bool {
        let in_way = |b: &Aabb| covers(b, at) && b.min.z < level + WAY.1 && b.max.z > level + WAY.0;
        let apart = |id: NodeId| {
            id != who && !self.holders_of(who).contains(&id) && !self.holders_of(id).contains(&who)
        };
        self.floors.iter().any(|(f, _)| covers(f, at))
            && !self.walls.iter().any(|w| covers(w, at))
            && !self.standing.iter().any(|(id, b)| in_way(b) && apart(*id))
    }

    /// Boxes of things of a kind, with what they are.
    pub(super) fn of_kind<'a>(&'a self, kind: &'a str) -> impl Iterator<Item = (NodeId, &'a Arc<str>, Aabb)> + 'a {
        let classes = self.graph.classes();
        let of_kind = move |n: &&Node| n.kind() == Kind::Object && classes.is_a(n.class(), kind);
        self.graph.nodes().filter(of_kind).filter_map(|n| Some((n.id(), n.class(), n.aabb()?)))
    }
}

/// Whether a thing is neither building nor carried nor moved aside nor lain on the floor.
fn stands(classes: &ClassTable, node: &Node) -> bool {
    use vc_graph::class::Category;
    let category = classes.get(node.class()).map(|c| c.category);
    let builds = matches!(category, Some(Category::Structure | Category::Door | Category::Window));
    let carried = node.affords(Property::Graspable);
    !builds && !carried && !is_seat(classes, node.class())
}

/// What is drawn up to a table.
pub(super) fn is_seat(classes: &ClassTable, class: &str) -> bool {
    ["chair", "stool", "bench"].iter().any(|kind| classes.is_a(class, kind))
}

fn covers(b: &Aabb, at: Point2<f32>) -> bool {
    (b.min.x..=b.max.x).contains(&at.x) && (b.min.y..=b.max.y).contains(&at.y)
}
