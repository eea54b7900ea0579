//! Walls: their boxes, cut where there are openings.

use nalgebra::{Point3, Vector3};
use vc_graph::asset::Part;
use vc_graph::{Node, ObjectRole, Relation, SceneGraph};

use crate::block::{Block, Piece, cut, part};
use crate::opening::WallOpening;

/// Thickness of the sides of a wall around a corner, metres.
const THICK: f32 = 0.06;
/// Depth from which on the box of a wall is that of a wall around a corner, metres.
const CORNER: f32 = 0.5;
/// How far from a side one looks whether there is floor, metres.
const BESIDE: f32 = 0.15;

/// The pieces of a wall.
pub(crate) fn parts(graph: &SceneGraph, node: &Node, block: &Block, openings: &[WallOpening]) -> Vec<Part> {
    let size = block.size();
    let is_corner = size.x.min(size.y) > CORNER;
    let mut pieces = if is_corner { sides(graph, node, block) } else { vec![(block.low, block.high)] };
    for opening in openings {
        let hole = through(block.local(&opening.clear), opening, block);
        pieces = pieces.into_iter().flat_map(|piece| cut(piece, &hole)).collect();
    }
    pieces.into_iter().map(|(low, high)| part("wall", low, high)).collect()
}

/// The hole that an opening cuts, somewhat deeper than the opening: a door's frame may be thinner than its
/// wall, and the walls of the two rooms may stand somewhat beside it.
fn through((mut low, mut high): Piece, opening: &WallOpening, block: &Block) -> Piece {
    let across = block.pose.rotation.inverse() * Vector3::ith(opening.across, 1.0);
    let axis = usize::from(across.y.abs() > across.x.abs());
    if opening.is_doorway {
        low.z = low.z.min(block.low.z.max(low.z - BESIDE));
    }
    low[axis] -= BESIDE;
    high[axis] += BESIDE;
    (low, high)
}

/// The sides of the box of a wall around a corner that stand where the floor ends: with floor of its
/// room on one side of them and none on the other.
fn sides(graph: &SceneGraph, node: &Node, block: &Block) -> Vec<Piece> {
    let floors: Vec<_> = graph
        .room_of(node.id())
        .into_iter()
        .flat_map(|room| graph.relating(Relation::InRoom, room))
        .filter_map(|id| graph.node(id).filter(|n| n.role() == ObjectRole::Floor)?.aabb())
        .collect();
    let is_floor = |point: Vector3<f32>| {
        let at = block.pose * Point3::from(point);
        floors.iter().any(|f| (f.min.x..=f.max.x).contains(&at.x) && (f.min.y..=f.max.y).contains(&at.y))
    };
    let middle = (block.low + block.high) / 2.0;
    let ends = |axis: usize, at: f32| {
        let beside = |by: f32| {
            let mut point = middle;
            point[axis] = at + by;
            is_floor(point)
        };
        beside(BESIDE) != beside(-BESIDE)
    };
    let side = |axis: usize, upper: bool| {
        let (mut low, mut high) = (block.low, block.high);
        if upper {
            low[axis] = high[axis] - THICK
        } else {
            high[axis] = low[axis] + THICK
        }
        ends(axis, if upper { block.high[axis] } else { block.low[axis] }).then_some((low, high))
    };
    [(0, false), (0, true), (1, false), (1, true)].into_iter().filter_map(|(axis, upper)| side(axis, upper)).collect()
}
