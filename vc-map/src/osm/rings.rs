//! Closed rings from ways, and areas with holes from multipolygons.

use std::collections::{BTreeMap, BTreeSet};

use super::data::{Relation, Way};
use super::tags::Source;
use super::{Element, Reason};
use crate::Point;
use crate::index::PointIndex;
use crate::polyline::{area, inside};

/// Rings of a smaller area are none, square metres.
const SMALLEST: f64 = 0.5;
/// A hole is looked for in so many outer rings whose boxes are around it.
const MOST: usize = 64;

/// An area with holes: its outer ring counter-clockwise, holes clockwise.
pub(super) struct Surface {
    pub(super) outline: Vec<Point>,
    pub(super) holes: Vec<Vec<Point>>,
    /// The nodes of the outer ring, by their ids.
    pub(super) nodes: Vec<i64>,
}

impl Surface {
    /// The number of its points.
    pub(super) fn size(&self) -> usize {
        self.outline.len() + self.holes.iter().map(Vec::len).sum::<usize>()
    }
}

fn turned(mut ring: Vec<Point>, counter_clockwise: bool) -> Option<Vec<Point>> {
    ring.dedup_by(|a, b| (*a - *b).norm() < 1e-3);
    let size = area(&ring);
    if (size > 0.0) != counter_clockwise {
        ring.reverse();
    }
    (ring.len() >= 3 && size.abs() >= SMALLEST).then_some(ring)
}

/// The areas of a multipolygon, and why it is not whole.
pub(super) struct Multipolygon {
    pub(super) areas: Vec<Surface>,
    pub(super) lacks: BTreeSet<Reason>,
    /// The ways that it is made of.
    pub(super) ways: BTreeSet<i64>,
}

impl Source<'_> {
    /// The area that a closed way encloses.
    pub(super) fn ring(&self, way: &Way) -> Result<Surface, Reason> {
        let refs = self.refs(way);
        match self.lacks(refs) {
            Some(reason) => Err(reason),
            None => closed(refs).and_then(|nodes| self.surface(nodes)).ok_or(Reason::NoShape),
        }
    }

    fn surface(&self, nodes: &[i64]) -> Option<Surface> {
        let ring: Option<Vec<Point>> = nodes.iter().map(|id| self.near(*id).map(|at| self.point(at))).collect();
        Some(Surface { outline: turned(ring?, true)?, holes: Vec::new(), nodes: nodes.to_vec() })
    }

    /// The areas of a multipolygon: members joined to rings, each hole in the outer ring around it.
    pub(super) fn multipolygon(&self, relation: &Relation) -> Multipolygon {
        let mut found = Multipolygon { areas: Vec::new(), lacks: BTreeSet::new(), ways: BTreeSet::new() };
        let outer = self.surfaces(relation, false, &mut found);
        let holes = self.surfaces(relation, true, &mut found);
        let index = PointIndex::of_boxes(outer.iter().map(corners));
        found.areas = outer;
        for hole in holes {
            let at = hole.outline[0];
            let mut around: Option<u32> = None;
            // Areas do not overlap, so that the first is the only one, and few of their boxes lie on each other.
            let mut tried = 0;
            index.around(&at, 0.0, |area| {
                tried += 1;
                around = inside(&found.areas[area as usize].outline, &at).then_some(area);
                if around.is_some() || tried == MOST { f64::NEG_INFINITY } else { f64::INFINITY }
            });
            match (around, turned(hole.outline, false)) {
                (Some(area), Some(ring)) => found.areas[area as usize].holes.push(ring),
                _ => _ = found.lacks.insert(Reason::HoleOutside),
            }
        }
        found
    }

    /// The rings of the inner or outer members. A way that is named twice counts once.
    fn surfaces(&self, relation: &Relation, inner: bool, found: &mut Multipolygon) -> Vec<Surface> {
        let fits = |role: &str| (role == "inner") == inner && matches!(role, "inner" | "outer" | "outline" | "");
        let mut ways = BTreeSet::new();
        let mut lines: Vec<&[i64]> = Vec::new();
        for member in self.members(relation).iter().filter(|member| fits(self.role(**member))) {
            let Element::Way(id) = member.element else { continue };
            if !ways.insert(id) {
                continue;
            }
            let refs = self.way(id).map(|way| self.refs(way));
            match refs.map(|refs| self.lacks(refs)) {
                None => _ = found.lacks.insert(Reason::CutOff),
                Some(Some(reason)) => _ = found.lacks.insert(reason),
                Some(None) => lines.extend(refs),
            }
        }
        found.ways.append(&mut ways);
        let (rings, open) = joined(&lines);
        let count = rings.len();
        let surfaces: Vec<Surface> = rings.iter().filter_map(|nodes| self.surface(nodes)).collect();
        found.lacks.extend(open.then_some(Reason::OpenRing));
        found.lacks.extend((surfaces.len() < count).then_some(Reason::NoShape));
        surfaces
    }
}

fn corners(area: &Surface) -> [Point; 2] {
    let first = area.outline[0];
    area.outline.iter().fold([first; 2], |[low, high], point| [low.inf(point), high.sup(point)])
}

/// The nodes of a closed line, the first of which is not repeated.
fn closed(line: &[i64]) -> Option<&[i64]> {
    line.strip_suffix(&[*line.first()?]).filter(|nodes| nodes.len() >= 3)
}

/// Rings of nodes, made of lines that go on from each other, and whether lines are left that close none. The first node is
/// not repeated.
fn joined(lines: &[&[i64]]) -> (Vec<Vec<i64>>, bool) {
    let mut at: BTreeMap<i64, Vec<usize>> = BTreeMap::new();
    for (index, line) in lines.iter().enumerate() {
        for end in [line.first(), line.last()].into_iter().flatten() {
            at.entry(*end).or_default().push(index);
        }
    }
    let mut used = vec![false; lines.len()];
    let (mut rings, mut open) = (Vec::new(), false);
    for first in 0..lines.len() {
        if used[first] {
            continue;
        }
        used[first] = true;
        let mut ring = lines[first].to_vec();
        while ring.first() != ring.last() {
            let Some(next) = ring.last().and_then(|end| next(&mut at, *end, &used)) else { break };
            used[next] = true;
            let line = lines[next];
            if line.first() == ring.last() {
                ring.extend(&line[1..]);
            } else {
                ring.extend(line.iter().rev().skip(1));
            }
        }
        let whole = closed(&ring).map(<[i64]>::to_vec);
        open |= whole.is_none();
        rings.extend(whole);
    }
    (rings, open)
}

/// A line at a node that is not used yet. Those that are used are taken off the list.
fn next(at: &mut BTreeMap<i64, Vec<usize>>, end: i64, used: &[bool]) -> Option<usize> {
    let lines = at.get_mut(&end)?;
    lines.retain(|line| !used[*line]);
    lines.first().copied()
}
