//! Lines by the boxes around their parts, in a packed tree (Leutenegger and others, 1997), to find what is near a point.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet, BinaryHeap};
use std::ops::Range;

use crate::{Point, Polyline, Projection};

/// The most pieces of a line in one box.
const RUN: usize = 16;
/// The boxes that one of the level above holds.
const FAN: usize = 8;
/// Distances to boxes and to lines are computed in two ways, and differ by less than this, metres.
const ROUNDING: f64 = 1e-6;

/// A box with sides along the axes.
#[derive(Debug, Clone, Copy)]
struct Around {
    low: Point,
    high: Point,
}

impl Around {
    fn points(points: &[Point]) -> Self {
        let none = Self { low: [f64::INFINITY; 2].into(), high: [f64::NEG_INFINITY; 2].into() };
        points.iter().fold(none, |all, point| all.with(&Self { low: *point, high: *point }))
    }

    fn with(&self, other: &Self) -> Self {
        Self { low: self.low.inf(&other.low), high: self.high.sup(&other.high) }
    }

    fn middle(&self, axis: usize) -> f64 {
        self.low[axis] + self.high[axis]
    }

    /// The distance from a point to the box, zero inside.
    fn away(&self, point: &Point) -> f64 {
        let nearest = point.sup(&self.low).inf(&self.high);
        (point - nearest).norm()
    }
}

/// A part of a line.
#[derive(Debug, Clone, Copy)]
struct Part {
    line: u32,
    /// The first of its pieces, at most [`RUN`].
    piece: u32,
}

/// Takes memory by the number of points, whatever the lengths of lines.
#[derive(Debug, Default)]
pub(crate) struct PointIndex {
    parts: Vec<Part>,
    /// Boxes around the parts, then around eight each of the level below, until there is one.
    levels: Vec<Vec<Around>>,
}

impl PointIndex {
    /// The index of some lines, with their numbers.
    pub(crate) fn new<'a>(lines: impl Iterator<Item = (u32, &'a Polyline)>) -> Self {
        let runs = |(line, of): (u32, &'a Polyline)| {
            let pieces = of.points().len() - 1;
            (0..pieces).step_by(RUN).map(move |piece| {
                let points = &of.points()[piece..=(piece + RUN).min(pieces)];
                (Part { line, piece: piece as u32 }, Around::points(points))
            })
        };
        Self::packed(lines.flat_map(runs).collect())
    }

    /// The index of some points, whose numbers are their positions.
    pub(crate) fn of_points<'a>(points: impl Iterator<Item = &'a Point>) -> Self {
        let part = |(line, at): (usize, &'a Point)| (Part { line: line as u32, piece: 0 }, Around::points(&[*at]));
        Self::packed(points.enumerate().map(part).collect())
    }

    /// The index of some boxes, lower left and upper right, whose numbers are their positions.
    pub(crate) fn of_boxes(boxes: impl Iterator<Item = [Point; 2]>) -> Self {
        let part =
            |(line, [low, high]): (usize, [Point; 2])| (Part { line: line as u32, piece: 0 }, Around { low, high });
        Self::packed((0usize..).zip(boxes).map(part).collect())
    }

    /// Sorts by squares ("sort, tile, recurse"), and puts boxes around eight neighbours each.
    fn packed(mut parts: Vec<(Part, Around)>) -> Self {
        let by =
            |axis: usize| move |a: &(Part, Around), b: &(Part, Around)| a.1.middle(axis).total_cmp(&b.1.middle(axis));
        parts.sort_by(by(0));
        let tiles = (parts.len() as f64 / FAN as f64).sqrt().ceil() as usize;
        parts.chunks_mut((tiles * FAN).max(1)).for_each(|slice| slice.sort_by(by(1)));
        let (parts, boxes): (Vec<Part>, Vec<Around>) = parts.into_iter().unzip();
        let mut levels = vec![boxes];
        while let Some(below) = levels.last().filter(|level| level.len() > 1) {
            let joined = |group: &[Around]| group[1..].iter().fold(group[0], |all, one| all.with(one));
            let above = below.chunks(FAN).map(joined).collect();
            levels.push(above);
        }
        Self { parts, levels }
    }

    /// The memory that it takes, bytes.
    pub(crate) fn bytes(&self) -> usize {
        let boxes: usize = self.levels.iter().map(Vec::capacity).sum();
        self.parts.capacity() * size_of::<Part>() + boxes * size_of::<Around>()
    }

    /// Visits everything near a point, the nearest boxes first, until all that is nearer than the visitor's answer (the
    /// distance of the best so far) or within a distance has been seen. A line may be visited once for each of its parts.
    pub(crate) fn around(&self, point: &Point, within: f64, mut visit: impl FnMut(u32) -> f64) {
        self.parts_around(point, within, |part| visit(part.line));
    }

    fn parts_around(&self, point: &Point, within: f64, mut visit: impl FnMut(Part) -> f64) {
        let mut best = within;
        // Distances are not negative, so that their bits are in their order.
        let entry =
            |level: usize, place: usize| Reverse((self.levels[level][place].away(point).to_bits(), level, place));
        let top = self.levels.len().saturating_sub(1);
        let mut open: BinaryHeap<_> = (!self.parts.is_empty()).then(|| entry(top, 0)).into_iter().collect();
        while let Some(Reverse((bits, level, place))) = open.pop() {
            if f64::from_bits(bits) > best + ROUNDING {
                return;
            }
            match level.checked_sub(1) {
                None => best = best.min(visit(self.parts[place])),
                Some(below) => {
                    let last = ((place + 1) * FAN).min(self.levels[below].len());
                    open.extend((place * FAN..last).map(|place| entry(below, place)));
                }
            }
        }
    }

    /// The nearest point of each line within a distance.
    pub(crate) fn each<'a>(
        &self,
        point: &Point,
        within: f64,
        line: impl Fn(u32) -> &'a Polyline,
    ) -> BTreeMap<u32, Projection> {
        let mut found: BTreeMap<u32, Projection> = BTreeMap::new();
        self.parts_around(point, within, |part| {
            let near = line(part.line).project_on(point, part.pieces());
            let known = found.entry(part.line).or_insert(near);
            if near.left.abs() < known.left.abs() {
                *known = near;
            }
            f64::INFINITY
        });
        found.retain(|_, near| near.left.abs() <= within);
        found
    }

    /// The nearest line within a distance, and the first of several: its number and the station there.
    pub(crate) fn nearest<'a>(
        &self,
        point: &Point,
        within: f64,
        line: impl Fn(u32) -> Option<&'a Polyline>,
    ) -> Option<(u32, f64)> {
        let mut best: Option<(f64, u32, f64)> = None;
        self.parts_around(point, within, |part| {
            if let Some(near) = line(part.line).map(|line| line.project_on(point, part.pieces())) {
                let found = (near.left.abs(), part.line, near.station);
                if found.0 <= within && best.is_none_or(|known| found < known) {
                    best = Some(found);
                }
            }
            best.map_or(f64::INFINITY, |(away, ..)| away)
        });
        best.map(|(_, line, station)| (line, station))
    }
}

impl PointIndex {
    /// The lines that the straight way between two points crosses.
    pub(crate) fn crossed<'a>(&self, way: [Point; 2], line: impl Fn(u32) -> &'a Polyline) -> BTreeSet<u32> {
        let [from, to] = way;
        let mut crossed = BTreeSet::new();
        self.parts_around(&nalgebra::center(&from, &to), (to - from).norm() / 2.0, |part| {
            if line(part.line).is_crossed_by(part.pieces(), way) {
                crossed.insert(part.line);
            }
            f64::INFINITY
        });
        crossed
    }

    /// Whether the straight way between two points crosses some lines.
    pub(crate) fn is_crossed<'a>(&self, way: [Point; 2], line: impl Fn(u32) -> Option<&'a Polyline>) -> bool {
        let [from, to] = way;
        let mut crossed = false;
        self.parts_around(&nalgebra::center(&from, &to), (to - from).norm() / 2.0, |part| {
            crossed |= line(part.line).is_some_and(|line| line.is_crossed_by(part.pieces(), way));
            if crossed { 0.0 } else { f64::INFINITY }
        });
        crossed
    }
}

impl Part {
    fn pieces(self) -> Range<usize> {
        self.piece as usize..self.piece as usize + RUN
    }
}
