//! Closed rings from ways, and areas with holes from multipolygons.

use std::collections::BTreeMap;

use super::data::{Relation, Way};
use super::{Element, OsmData};
use crate::Point;
use crate::polyline::{area, inside};

/// Rings of a smaller area are none, square metres.
const SMALLEST: f64 = 0.5;

/// An area with holes: its outer ring counter-clockwise, holes clockwise.
pub(super) struct Shape {
    pub(super) outline: Vec<Point>,
    pub(super) holes: Vec<Vec<Point>>,
    /// The nodes of the outer ring, by their ids.
    pub(super) nodes: Vec<i64>,
}

fn turned(mut ring: Vec<Point>, counter_clockwise: bool) -> Option<Vec<Point>> {
    ring.dedup_by(|a, b| (*a - *b).norm() < 1e-3);
    let size = area(&ring);
    if (size > 0.0) != counter_clockwise {
        ring.reverse();
    }
    (ring.len() >= 3 && size.abs() >= SMALLEST).then_some(ring)
}

impl OsmData {
    /// The area that a closed way encloses; also one that lacks only the node that closes it.
    pub(super) fn ring(&self, way: &Way, points: &[Point]) -> Option<Shape> {
        let refs = self.refs(way);
        let nodes = refs.strip_suffix(&[*refs.first()?]).filter(|nodes| nodes.len() >= 3)?;
        self.shape(nodes, points)
    }

    fn shape(&self, nodes: &[i64], points: &[Point]) -> Option<Shape> {
        let ring: Option<Vec<Point>> = nodes.iter().map(|id| self.node(*id).map(|at| points[at])).collect();
        Some(Shape { outline: turned(ring?, true)?, holes: Vec::new(), nodes: nodes.to_vec() })
    }

    /// The areas of a multipolygon: members joined to rings, each hole in the outer ring around it.
    pub(super) fn multipolygon(&self, relation: &Relation, points: &[Point]) -> Vec<Shape> {
        let ways = |inner: bool| -> Vec<Vec<i64>> {
            let fits = |role: &str| (role == "inner") == inner && matches!(role, "inner" | "outer" | "outline" | "");
            let members = self.members(relation).iter().filter(|member| fits(self.role(**member)));
            members
                .filter_map(|member| match member.element {
                    Element::Way(id) => self.way(id).map(|way| self.refs(way).to_vec()),
                    _ => None,
                })
                .collect()
        };
        let closed = |inner| joined(ways(inner)).into_iter().filter_map(|nodes| self.shape(&nodes, points));
        let mut shapes: Vec<Shape> = closed(false).collect();
        for hole in closed(true) {
            let around = shapes.iter_mut().find(|shape| inside(&shape.outline, &hole.outline[0]));
            if let (Some(shape), Some(ring)) = (around, turned(hole.outline, false)) {
                shape.holes.push(ring);
            }
        }
        shapes
    }
}

/// Rings of nodes, made of lines that go on from each other; lines that close no ring are left out. The first node is not
/// repeated.
fn joined(lines: Vec<Vec<i64>>) -> Vec<Vec<i64>> {
    let mut at: BTreeMap<i64, Vec<usize>> = BTreeMap::new();
    for (index, line) in lines.iter().enumerate() {
        for end in [line.first(), line.last()].into_iter().flatten() {
            at.entry(*end).or_default().push(index);
        }
    }
    let mut used = vec![false; lines.len()];
    let mut rings = Vec::new();
    for first in 0..lines.len() {
        if used[first] || lines[first].len() < 2 {
            continue;
        }
        used[first] = true;
        let mut ring = lines[first].clone();
        while ring.first() != ring.last() {
            let Some(end) = ring.last().copied() else { break };
            let next =
                at.get(&end).into_iter().flatten().copied().find(|index| !used[*index] && lines[*index].len() > 1);
            let Some(next) = next else { break };
            used[next] = true;
            let line = &lines[next];
            if line.first() == Some(&end) {
                ring.extend(&line[1..]);
            } else {
                ring.extend(line.iter().rev().skip(1));
            }
        }
        if ring.len() > 3 && ring.first() == ring.last() {
            ring.pop();
            rings.push(ring);
        }
    }
    rings
}
