//! Pieces that go on alike, as one.

use super::network::{Network, Piece};
use crate::RoadClass;

impl Network<'_> {
    /// Joins pieces that go on alike where nothing else meets them.
    pub(super) fn merge(&mut self) {
        let nodes: Vec<u32> = self.at.keys().copied().collect();
        for node in nodes {
            let pieces = self.at.get(&node).map(Vec::as_slice).unwrap_or_default();
            let Ok([one, other]) = <[usize; 2]>::try_from(pieces) else { continue };
            if one == other || self.marks.get(&node).is_some_and(|marks| marks.cuts()) {
                continue;
            }
            let Some((before, after)) = self.order(one, other, node) else { continue };
            if let (Some(mut joined), Some(rest)) = (self.pieces[before].take(), self.pieces[after].take()) {
                joined.nodes.extend(&rest.nodes[1..]);
                joined.length += rest.length;
                joined.ways.extend(rest.ways);
                self.at.remove(&node);
                let pieces = self.at.get_mut(&joined.last()).into_iter().flatten();
                pieces.filter(|piece| **piece == after).for_each(|piece| *piece = before);
                self.pieces[before] = Some(joined);
            }
        }
    }

    /// The first and the second of two pieces, if they are of the same kind and direction.
    fn order(&self, one: usize, other: usize, node: u32) -> Option<(usize, usize)> {
        let (a, b) = (self.pieces[one].as_ref()?, self.pieces[other].as_ref()?);
        let (before, after) = match (a.last() == node, b.first() == node) {
            (true, true) => (one, other),
            (false, false) if a.first() == node && b.last() == node => (other, one),
            _ => return None,
        };
        let closed = [a, b].iter().any(|piece| piece.first() == piece.last())
            || self.pieces[before].as_ref()?.first() == self.pieces[after].as_ref()?.last();
        (self.is_alike(a, b) && !closed).then_some((before, after))
    }

    fn is_alike(&self, one: &Piece, other: &Piece) -> bool {
        let (a, b) = (self.street(one), self.street(other));
        a.class == b.class
            && a.section == b.section
            && a.layer == b.layer
            && (a.structure == b.structure || a.class >= RoadClass::Path)
            && a.name == b.name
            && a.roundabout == b.roundabout
            && a.slip == b.slip
            && a.private == b.private
    }
}
