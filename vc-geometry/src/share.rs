//! Floors and ceilings whose boxes overlap: the box around one with corners is also around its neighbours.

use vc_graph::{Aabb, Kind, Node, NodeId, Relation, SceneGraph};

use crate::block::{Block, Piece, cut};
use crate::opening::size;

/// Two boxes that share less than this in one direction only meet, metres: in the wall between their rooms.
const SHARED: f32 = 0.5;
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

/// The regions of a node's box that belong to those of other rooms.
fn lost(graph: &SceneGraph, node: &Node) -> Vec<Aabb> {
    let (Some(own), Some(room)) = (node.aabb(), graph.room_of(node.id())) else { return Vec::new() };
    let others = graph.of_class(node.class()).into_iter().filter(|id| *id != node.id());
    let others = others.filter_map(|id| Some((id, graph.room_of(id).filter(|r| *r != room)?, graph.node(id)?.aabb()?)));
    let level = others.filter(|(.., other)| (other.max.z - own.max.z).abs() < STEP);
    let shared = level.filter_map(|(id, of, other)| Some((id, of, other, both(&own, &other)?)));
    let goes = |(id, of, other, shared): (NodeId, NodeId, Aabb, Aabb)| {
        let (here, there) = (things_in(graph, room, &shared), things_in(graph, of, &shared));
        // Where things do not tell, the larger box is the one around a corner.
        let loses = here < there || here == there && (area(&own), node.id()) > (area(&other), id);
        loses.then_some(shared)
    };
    shared.filter_map(goes).collect()
}

/// The region that two boxes share, seen from above.
fn both(one: &Aabb, other: &Aabb) -> Option<Aabb> {
    let shared = Aabb { min: one.min.sup(&other.min), max: one.max.inf(&other.max) };
    (size(&shared, 0) > SHARED && size(&shared, 1) > SHARED).then_some(shared)
}

/// How many things of a room have their middle over a region.
fn things_in(graph: &SceneGraph, room: NodeId, region: &Aabb) -> usize {
    let is_over = |node: &&Node| {
        let at = node.aabb().map(|b| b.centre());
        at.is_some_and(|at| (0..2).all(|i| (region.min[i]..=region.max[i]).contains(&at[i])))
    };
    let things = graph.relating(Relation::InRoom, room).filter_map(|id| graph.node(id));
    things.filter(|n| n.kind() == Kind::Object && !n.is_building()).filter(is_over).count()
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
        let [hall, closet] = [scene.add(Draft::new("hallway"))?, scene.add(Draft::new("closet_room"))?];
        let slab = |x: f32, y: f32| Draft::new("floor").bounds(Bounds::standing([x, y, 0.1].into()));
        let outer = scene.add_in(hall, slab(4.0, 4.0).at(Pose::identity()))?;
        let inner = scene.add_in(closet, slab(1.0, 1.0).at(Pose::translation(1.5, 1.5, 0.0)))?;
        let scene = scene.build();
        let pieces = |id| {
            let node = scene.node(id)?;
            let block = Block::of(node)?;
            Some(own_pieces(&scene, node, &block, (block.low, block.high)))
        };
        let areas = |id| pieces(id).map(|all| all.iter().map(|(low, high)| (high - low).xy().product()).sum::<f32>());
        assert!(areas(outer).is_some_and(|a| (a - 15.0).abs() < 1e-3), "{:?}", pieces(outer));
        assert!(areas(inner).is_some_and(|a| (a - 1.0).abs() < 1e-3), "{:?}", pieces(inner));
        Ok(())
    }
}
