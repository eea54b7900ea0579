//! Walls: their boxes, cut where there are openings.

use nalgebra::{Point3, Vector3};
use vc_graph::asset::Part;
use vc_graph::{Node, Relation, SceneGraph};

use crate::block::{Block, part};
use crate::opening::Opening;

/// Thickness of the sides of a wall around a corner, metres.
const THICK: f32 = 0.06;
/// Depth from which on the box of a wall is that of a wall around a corner, metres.
const CORNER: f32 = 0.5;
/// How far from a side one looks whether there is floor, metres.
const BESIDE: f32 = 0.15;
/// Pieces of wall that are narrower are left out, metres.
const SLIVER: f32 = 0.005;

/// A box by its corners.
type Piece = (Vector3<f32>, Vector3<f32>);

/// The pieces of a wall.
pub(crate) fn parts(graph: &SceneGraph, node: &Node, block: &Block, openings: &[Opening]) -> Vec<Part> {
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
fn through((mut low, mut high): Piece, opening: &Opening, block: &Block) -> Piece {
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
        .filter_map(|id| graph.node(id).filter(|n| &**n.class() == "floor")?.aabb())
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

/// The pieces of a box that are left without another: beside it, above and below.
fn cut((low, high): Piece, (from, to): &Piece) -> Vec<Piece> {
    if (0..3).any(|i| from[i] >= high[i] || to[i] <= low[i]) {
        return vec![(low, high)];
    }
    let (mut rest, mut left) = ((low, high), Vec::new());
    for axis in 0..3 {
        if from[axis] > rest.0[axis] + SLIVER {
            let mut below = rest;
            below.1[axis] = from[axis];
            left.push(below);
            rest.0[axis] = from[axis];
        }
        if to[axis] < rest.1[axis] - SLIVER {
            let mut above = rest;
            above.0[axis] = to[axis];
            left.push(above);
            rest.1[axis] = to[axis];
        }
    }
    left
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_doorway_leaves_both_sides_and_the_lintel() {
        let wall = (Vector3::new(0.0, 0.0, 0.0), Vector3::new(0.1, 4.0, 2.5));
        let left = cut(wall, &(Vector3::new(-1.0, 1.0, 0.0), Vector3::new(1.0, 2.0, 2.0)));
        let volume: f32 = left.iter().map(|(low, high)| (high - low).product()).sum();
        assert_eq!(left.len(), 3);
        assert!((volume - (0.1 * 4.0 * 2.5 - 0.1 * 1.0 * 2.0)).abs() < 1e-5);
        assert_eq!(cut(wall, &(Vector3::repeat(5.0), Vector3::repeat(6.0))), [wall]);
    }
}
