//! Footways that are mapped in pieces where they cross a street, as one up to its kerbs.

use std::collections::BTreeSet;

use super::network::{Network, Piece};
use crate::{RoadClass, Users};

/// A node lies in a carriageway up to this distance from its edge, metres.
const KERB: f64 = 1.0;
/// A way that turns by less than 45 degrees goes straight: the cosine of the angle between its pieces.
const STRAIGHT: f64 = -0.71;

impl Network<'_> {
    /// Joins the pieces of footways that meet in a carriageway with nothing else: a crossing leads from where a footway leaves the
    /// carriageway to where the next one does.
    pub(super) fn join_in_carriageways(&mut self) {
        let nodes: Vec<u32> = self.at.keys().copied().collect();
        for node in nodes {
            let reach = self.streets_at(node).map(|(_, piece)| self.street(piece).section.surface() / 2.0);
            let reach = reach.fold(0.0, f64::max);
            let streets: BTreeSet<usize> = self.streets_at(node).map(|(number, _)| number).collect();
            if streets.is_empty() {
                continue;
            }
            let pieces = self.at.get(&node).cloned().unwrap_or_default();
            for piece in pieces.into_iter().filter(|piece| !streets.contains(piece)) {
                while self.goes_on(piece, node, reach + KERB, &streets) {}
            }
        }
    }

    /// Joins a piece that begins at a node of a street with that in which it goes on, if it does within the carriageway.
    fn goes_on(&mut self, number: usize, node: u32, reach: f64, streets: &BTreeSet<usize>) -> bool {
        let Some(next) = self.next_in_carriageway(number, node, reach, streets) else { return false };
        let (Some(near), Some(mut far)) = (self.pieces[number].take(), self.pieces[next].take()) else { return false };
        let end = if near.first() == node { near.last() } else { near.first() };
        let mut nodes = near.nodes;
        if nodes.first() == Some(&end) {
            nodes.reverse();
        }
        // The outer piece tells what kind of way it is, and its direction.
        if far.first() == end {
            nodes.extend(&far.nodes[1..]);
            far.nodes = nodes;
        } else {
            nodes.reverse();
            far.nodes.extend(&nodes[1..]);
        }
        far.length += near.length;
        far.ways.extend(near.ways);
        self.at.remove(&end);
        let outer = far.ends();
        for at in outer {
            self.at
                .get_mut(&at)
                .into_iter()
                .flatten()
                .filter(|piece| **piece == next)
                .for_each(|piece| *piece = number);
        }
        self.pieces[number] = Some(far);
        true
    }

    /// The piece in which a footway from a node of a street goes on within the carriageway.
    fn next_in_carriageway(&self, number: usize, node: u32, reach: f64, streets: &BTreeSet<usize>) -> Option<usize> {
        let is_path = |piece: &Piece| {
            let street = self.street(piece);
            let users = street.section.users(true) | street.section.users(false);
            !street.class.is_street() && street.class != RoadClass::Steps && users.has(Users::FOOT)
        };
        let near = self.pieces[number].as_ref().filter(|piece| is_path(piece))?;
        let end = if near.first() == node { near.last() } else { near.first() };
        let &[one, other] = self.at.get(&end)?.as_slice() else { return None };
        let next = if one == number { other } else { one };
        let far = self.pieces[next].as_ref().filter(|piece| is_path(piece))?;
        let beyond = if far.first() == end { far.last() } else { far.first() };
        let point = self.point(end);
        let lines = streets.iter().filter_map(|street| self.line(&self.pieces[*street].as_ref()?.nodes));
        let away = lines.map(|line| (line.project(&point).point - point).norm()).fold(f64::INFINITY, f64::min);
        let ring = end == node || beyond == end || beyond == node;
        // At a corner the ways over two streets meet, and each of them ends there.
        let corner = self.streets_at(beyond).next().is_some() && !self.goes_straight(near, far, end);
        (next != number && !ring && !corner && away < reach).then_some(next)
    }

    /// Whether one piece goes on in another at a node without a turn.
    fn goes_straight(&self, one: &Piece, other: &Piece, node: u32) -> bool {
        let leaves = |piece: &Piece| {
            let nodes = &piece.nodes;
            let next = if piece.first() == node { nodes[1] } else { nodes[nodes.len() - 2] };
            (self.point(next) - self.point(node)).normalize()
        };
        leaves(one).dot(&leaves(other)) < STRAIGHT
    }
}
