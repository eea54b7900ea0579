//! Floors and ceilings whose boxes overlap: the box around one with corners is also around its neighbours.

use std::cmp::Reverse;

use nalgebra::Point3;
use vc_graph::{Aabb, Node, NodeId, NodeKind, ObjectRole, Relation, SceneGraph};

use crate::block::{Block, Piece, cut};
use crate::opening::{size, thin};

/// Two boxes that share less than this in one direction only meet, metres: in the wall between their rooms.
const SHARED: f32 = 0.5;
/// A wall nearer than this to the edge of a box stands on it, metres.
const WALL: f32 = 0.3;
/// Lines nearer than this to each other are one, metres.
const SAME: f32 = 1e-3;
/// Greatest difference of height of two floors that can share anything, metres.
const STEP: f32 = 0.05;

/// The pieces of a box of a floor or ceiling that are not its neighbours'.
pub(crate) fn own_pieces(graph: &SceneGraph, node: &Node, block: &Block, whole: Piece) -> Vec<Piece> {
    let lost = if block.is_along() { lost(graph, node) } else { Vec::new() };
    let through = |region: &Aabb| {
        let (mut low, mut high) = block.local(region);
        (low.z, high.z) = (f32::NEG_INFINITY, f32::INFINITY);
        (low, high)
    };
    let left = lost.iter().fold(vec![whole], |pieces, region| {
        let hole = through(region);
        pieces.into_iter().flat_map(|piece| cut(piece, &hole)).collect()
    });
    if left.is_empty() { vec![whole] } else { left }
}

/// A floor or ceiling: its number, its room and its box.
type Slab = (NodeId, NodeId, Aabb);

/// The regions of a node's box that belong to those of other rooms: where boxes overlap, that room's which has most
/// things there.
fn lost(graph: &SceneGraph, node: &Node) -> Vec<Aabb> {
    let slab = |id: NodeId| Some((id, graph.room_of(id)?, graph.node(id)?.aabb()?));
    let Some(own) = slab(node.id()) else { return Vec::new() };
    let all: Vec<Slab> = graph.of_role(node.role()).filter_map(|other| slab(other.id())).collect();
    let is_level = |other: &Slab| (other.2.max.z - own.2.max.z).abs() < STEP;
    let rivals: Vec<Slab> = all.iter().copied().filter(is_level).filter(|o| both(&own.2, &o.2).is_some()).collect();
    if rivals.iter().all(|rival| rival.1 == own.1) {
        return Vec::new();
    }
    let of_another = |cell: &Aabb| {
        let covers = |slab: &&Slab| over(&slab.2, &cell.centre());
        // Where things do not tell, the larger box is the one around a corner.
        let weight = |slab: &&Slab| (things_in(graph, slab.1, cell), Reverse(area(&slab.2)), Reverse(slab.0));
        rivals.iter().filter(covers).max_by_key(weight).is_some_and(|winner| winner.1 != own.1)
    };
    let mut cells = cells(graph, &own.2, &all);
    cells.retain(of_another);
    cells
}

/// A box, cut at the edges of other boxes and at the walls that stand in it: the borders of rooms are among these.
fn cells(graph: &SceneGraph, own: &Aabb, all: &[Slab]) -> Vec<Aabb> {
    let walls: Vec<Aabb> = graph.of_role(ObjectRole::Wall).filter_map(Node::aabb).collect();
    let lines = |axis: usize| {
        let mut lines: Vec<f32> = all.iter().flat_map(|(.., b)| [b.min[axis], b.max[axis]]).collect();
        let edges = lines.clone();
        let apart = |at: &f32| edges.iter().all(|edge| (at - edge).abs() > WALL);
        let middles = walls.iter().filter(|w| thin(w) == Some(axis)).map(|w| w.centre()[axis]);
        lines.extend(middles.filter(apart));
        lines.retain(|at| *at > own.min[axis] && *at < own.max[axis]);
        lines.extend([own.min[axis], own.max[axis]]);
        lines.sort_by(f32::total_cmp);
        lines.dedup_by(|a, b| (*a - *b).abs() < SAME);
        lines
    };
    let (xs, ys) = (lines(0), lines(1));
    let cell = |x: &[f32], y: &[f32]| {
        let mut cell = *own;
        (cell.min.x, cell.max.x, cell.min.y, cell.max.y) = (x[0], x[1], y[0], y[1]);
        cell
    };
    xs.windows(2).flat_map(|x| ys.windows(2).map(move |y| cell(x, y))).collect()
}

/// Whether a point is over a box.
fn over(aabb: &Aabb, at: &Point3<f32>) -> bool {
    (0..2).all(|i| (aabb.min[i]..=aabb.max[i]).contains(&at[i]))
}

/// The region that two boxes share, seen from above.
fn both(one: &Aabb, other: &Aabb) -> Option<Aabb> {
    let shared = Aabb { min: one.min.sup(&other.min), max: one.max.inf(&other.max) };
    (size(&shared, 0) > SHARED && size(&shared, 1) > SHARED).then_some(shared)
}

/// How many things of a room have their middle over a region.
fn things_in(graph: &SceneGraph, room: NodeId, region: &Aabb) -> usize {
    let is_over = |node: &&Node| node.aabb().is_some_and(|b| over(region, &b.centre()));
    let things = graph.relating(Relation::InRoom, room).filter_map(|id| graph.node(id));
    things.filter(|n| n.kind() == NodeKind::Object && !n.is_building()).filter(is_over).count()
}

/// In square millimetres.
fn area(aabb: &Aabb) -> i64 {
    (size(aabb, 0) * size(aabb, 1) * 1e6) as i64
}

#[cfg(test)]
mod tests {
    use vc_graph::{Bounds, Draft, EditError, Pose, SceneBuilder};

    use super::*;

    /// The box around the floor of a hall with a corner is also around the closet in that corner.
    #[test]
    fn a_box_around_a_corner_leaves_out_what_is_there() -> Result<(), EditError> {
        let mut scene = SceneBuilder::new("two rooms");
        let [hall, closet] = [scene.add(Draft::new("hallway"))?, scene.add(Draft::new("storage_room"))?];
        let slab = |x: f32, y: f32| Draft::new("floor").bounds(Bounds::standing([x, y, 0.1].into()));
        let outer = scene.add_in(hall, slab(4.0, 4.0).at(Pose::identity()))?;
        let inner = scene.add_in(closet, slab(1.0, 1.0).at(Pose::translation(1.5, 1.5, 0.0)))?;
        let scene = scene.build();
        let pieces = |id| {
            let node = scene.node(id)?;
            let block = Block::new(node)?;
            Some(own_pieces(&scene, node, &block, (block.low, block.high)))
        };
        let areas = |id| pieces(id).map(|all| all.iter().map(|(low, high)| (high - low).xy().product()).sum::<f32>());
        assert!(areas(outer).is_some_and(|a| (a - 15.0).abs() < 1e-3), "{:?}", pieces(outer));
        assert!(areas(inner).is_some_and(|a| (a - 1.0).abs() < 1e-3), "{:?}", pieces(inner));
        Ok(())
    }
}
