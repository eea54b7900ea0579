//! The street network: faces cut by streets, the largest first, until each is a block. Every cut goes straight from side to
//! side, so that faces stay convex, and ends well away from other junctions or in one, which then has four arms.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use nalgebra::Vector2;
use vc_graph::Seed;
use vc_map::Point;

use super::convex::{Beyond, Convex, left};
use super::face::{End, Face, hits, piece};
use super::field::{Field, StreetPattern};
use super::street_class::StreetClass;

/// A face that is larger is cut by a boulevard, and by an avenue, square metres.
const BOULEVARD: f64 = 650e3;
const AVENUE: f64 = 220e3;
/// Between the corners of two junctions along a street there are at least this many metres, room for crossings included.
const BETWEEN: f64 = 30.0;
/// Half the carriageway of the widest street that is no main one, metres: classes are given last.
const MINOR: f64 = 5.2;
/// The least sine of the angle at which streets meet: 52 degrees.
const STEEP: f64 = 0.788;
/// The least width and area of a face, metres and square metres.
const NARROW: f64 = 52.0;
const SMALL: f64 = 3_600.0;
/// Tries to place a cut.
const TRIES: u64 = 60;

/// A street: its class and the junctions along it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Line {
    pub(super) class: StreetClass,
    pub(super) along: Vec<usize>,
    /// Whether its end is its beginning.
    pub(super) closed: bool,
}

/// The streets of a city with the faces between them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Net {
    pub(super) points: Vec<Point>,
    pub(super) lines: Vec<Line>,
    pub(super) faces: Vec<Face>,
}

/// The dimensions of blocks with half of the streets around: short and long side, metres.
pub(super) type BlockSize = [f64; 2];

/// A face that waits to be cut: the largest first.
struct Waiting {
    area: f64,
    face: Face,
    number: u64,
}

impl PartialEq for Waiting {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}
impl Eq for Waiting {}
impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Waiting {
    fn cmp(&self, other: &Self) -> Ordering {
        self.area.total_cmp(&other.area).then(other.number.cmp(&self.number))
    }
}

/// Points are kept to a tenth of a millimetre, as maps are.
fn rounded(point: Point) -> Point {
    point.map(|value| (value * 1e4).round() / 1e4)
}

impl Net {
    /// The streets within an outline, which is a street itself.
    pub(super) fn within(
        outline: &[Point],
        field: &Field,
        pattern: StreetPattern,
        size: impl Fn(&Point) -> BlockSize,
        seed: Seed,
    ) -> Self {
        let points: Vec<Point> = outline.iter().map(|point| rounded(*point)).collect();
        let corners: Vec<usize> = (0..points.len()).collect();
        let ring = Line { class: StreetClass::Avenue, along: corners.clone(), closed: true };
        let mut net = Self { points, lines: vec![ring], faces: Vec::new() };
        let mut waiting = BinaryHeap::new();
        let first = Face { streets: vec![0; corners.len()], corners };
        waiting.push(Waiting { area: first.polygon(&net.points).area(), face: first, number: 0 });
        let mut number = 0;
        while let Some(next) = waiting.pop() {
            match net.cut(&next.face, field, pattern, &size, seed.child("cut").nth(next.number)) {
                Some(parts) => waiting.extend(parts.map(|face| {
                    number += 1;
                    Waiting { area: face.polygon(&net.points).area(), face, number }
                })),
                None => net.faces.push(next.face),
            }
        }
        net
    }

    /// Cuts a face in two, if it is larger than a block.
    fn cut(
        &mut self,
        face: &Face,
        field: &Field,
        pattern: StreetPattern,
        size: &impl Fn(&Point) -> BlockSize,
        seed: Seed,
    ) -> Option<[Face; 2]> {
        let polygon = face.polygon(&self.points);
        let middle = polygon.middle();
        let one = field.at(&middle);
        let other = left(one);
        let [short, long] = size(&middle);
        let lengths = [one, other].map(|along| polygon.length(&along));
        let wished = if lengths[0] > lengths[1] { [long, short] } else { [short, long] };
        let ratios = [lengths[0] / wished[0], lengths[1] / wished[1]];
        let area = polygon.area();
        // Main streets halve the longer side.
        let by_length = area > AVENUE && lengths[0].max(lengths[1]) > 1.25 * lengths[0].min(lengths[1]);
        let first = usize::from(if by_length { lengths[1] > lengths[0] } else { ratios[1] > ratios[0] });
        let class = match area {
            area if area > BOULEVARD => StreetClass::Boulevard,
            area if area > AVENUE => StreetClass::Avenue,
            _ => StreetClass::Residential,
        };
        for axis in [first, 1 - first] {
            if ratios[axis] < 1.42 {
                continue;
            }
            for attempt in 0..TRIES {
                let seed = seed.nth(axis as u64).nth(attempt);
                let along = [one, other][axis];
                if let Some(parts) =
                    self.try_cut(face, &polygon, (along, ratios[axis]), class, pattern, (seed, attempt))
                {
                    return Some(parts);
                }
            }
        }
        None
    }

    /// One try to cut a face across a direction, along which it has room for so many blocks.
    fn try_cut(
        &mut self,
        face: &Face,
        polygon: &Convex,
        (along, blocks): (Vector2<f64>, f64),
        class: StreetClass,
        pattern: StreetPattern,
        (seed, attempt): (Seed, u64),
    ) -> Option<[Face; 2]> {
        let mut stream = seed.stream();
        let pieces = blocks.round().max(2.0);
        let share = (pieces / 2.0).floor() / pieces;
        let wide = 0.1 / pieces * (1.0 + attempt as f64 / 3.0);
        let share = share + f64::from(stream.between(-1.0, 1.0)) * wide.min(0.3);
        let tilt = if pattern == StreetPattern::Grid { 0.02 } else { 0.06 } + 0.012 * attempt as f64;
        let tilt = f64::from(stream.between(-1.0, 1.0)) * tilt;
        let across = (left(along) + along * tilt).normalize();
        let [low, high] = polygon.extent(&along);
        let middle = polygon.middle();
        let through = middle + along * (low + (high - low) * share - middle.coords.dot(&along));
        let ends = hits(polygon, &through, &across)?;
        // The share of cuts that go on where one ends on the other side.
        let joins = match pattern {
            StreetPattern::Grid => 0.45,
            StreetPattern::Mixed => 0.45,
            StreetPattern::Radial => 0.45,
        };
        let mut found = [ends[0]; 2];
        for (slot, end) in found.iter_mut().zip(ends) {
            let joins = class.is_main() || stream.chance(joins);
            *slot = self.settle(face, end, class, (joins, &across))?;
        }
        self.apply(face, found, class)
    }

    /// Moves an end of a cut into a junction near by, or refuses it if it is too near to one.
    fn settle(&self, face: &Face, end: End, class: StreetClass, (joins, across): (bool, &Vector2<f64>)) -> Option<End> {
        let count = face.corners.len();
        let (from, to) = (face.corners[end.side], face.corners[(end.side + 1) % count]);
        let street = face.streets[end.side];
        let length = (self.points[to] - self.points[from]).norm();
        let between = self.between(street, from, to);
        let reach = if joins { (0.14 * length).clamp(45.0, 90.0) } else { 0.0 };
        let near = |v: &&usize| (self.points[**v] - end.at).norm();
        let nearest = between.iter().filter(|v| near(v) < reach).min_by(|a, b| near(a).total_cmp(&near(b)));
        let along = (self.points[to] - self.points[from]).normalize();
        let own = self.lines[street].class;
        let at = nearest.map_or(end.at, |known| self.points[*known]);
        let clear = |v: &&usize| {
            let reach = self.reach(**v, street, &along) + meeting(class, own, across, &along) + BETWEEN;
            Some(*v) == nearest || (self.points[**v] - at).norm() > reach
        };
        let free = between.iter().chain([&from, &to]).all(|v| clear(&v));
        // Four arms at most.
        let arms = |known: &usize| self.lines.iter().filter(|line| line.along.contains(known)).count();
        if let Some(known) = nearest {
            return (free && arms(known) < 3).then_some(End { at, known: Some(*known), ..end });
        }
        free.then_some(End { at: rounded(end.at), ..end })
    }

    /// How far the streets that meet another at a junction reach along it.
    fn reach(&self, vertex: usize, street: usize, along: &Vector2<f64>) -> f64 {
        let own = self.lines[street].class;
        let others = self.lines.iter().enumerate().filter(|(index, _)| *index != street);
        let reach = others.filter_map(|(_, line)| {
            let place = line.along.iter().position(|other| *other == vertex)?;
            let next = line.along[if place == 0 { 1 } else { place - 1 }];
            let across = (self.points[next] - self.points[vertex]).try_normalize(1e-3)?;
            Some(meeting(line.class, own, &across, along))
        });
        reach.fold(0.0, f64::max)
    }

    /// The junctions of a street between two, in order.
    fn between(&self, street: usize, from: usize, to: usize) -> Vec<usize> {
        let line = &self.lines[street];
        let place = |v: usize| line.along.iter().position(|other| *other == v);
        let (Some(a), Some(b)) = (place(from), place(to)) else { return Vec::new() };
        let count = line.along.len();
        match (a < b, line.closed) {
            (true, _) => line.along[a + 1..b].to_vec(),
            (false, false) => line.along[b + 1..a].iter().rev().copied().collect(),
            // Faces run counter-clockwise, as the ring does.
            (false, true) => (a + 1..count).chain(0..b).map(|i| line.along[i]).collect(),
        }
    }

    /// Carries a cut out, if both parts are large enough and the angles steep.
    fn apply(&mut self, face: &Face, ends: [End; 2], class: StreetClass) -> Option<[Face; 2]> {
        let [p, q] = ends;
        let along = (q.at - p.at).try_normalize(1.0)?;
        let polygon = face.polygon(&self.points);
        let steep = |end: &End| {
            let (a, b, _) = polygon.sides().nth(end.side)?;
            Some((b - a).normalize().perp(&along).abs() >= STEEP)
        };
        if !(steep(&p)? && steep(&q)?) {
            return None;
        }
        let fits = |part: &Convex| {
            let width =
                part.sides().map(|(a, b, _)| part.length(&left((b - a).normalize()))).fold(f64::INFINITY, f64::min);
            width > NARROW + 2.0 * (class.edge() - 7.25).max(0.0) && part.area() > SMALL
        };
        let parts = polygon.split(&p.at, &along, Beyond::Inside)?;
        if !parts.iter().all(fits) {
            return None;
        }
        let street = self.lines.len();
        let [from, to] = [p, q].map(|end| self.junction(face, end));
        self.lines.push(Line { class, along: vec![from, to], closed: false });
        Some([piece(face, (p.side, from), (q.side, to), street), piece(face, (q.side, to), (p.side, from), street)])
    }

    /// The junction of an end, made where there is none.
    fn junction(&mut self, face: &Face, end: End) -> usize {
        if let Some(known) = end.known {
            return known;
        }
        let (street, from) = (face.streets[end.side], face.corners[end.side]);
        let to = face.corners[(end.side + 1) % face.corners.len()];
        let vertex = self.points.len();
        self.points.push(end.at);
        let away = |v: usize| (self.points[v] - self.points[from]).norm();
        let mut before = from;
        for v in self.between(street, from, to) {
            if away(v) < away(vertex) {
                before = v;
            }
        }
        let line = &mut self.lines[street];
        let place = |v: usize| line.along.iter().position(|other| *other == v).unwrap_or(0);
        let forward = line.closed || place(from) < place(to);
        let at = place(before) + usize::from(forward);
        line.along.insert(at, vertex);
        vertex
    }

    /// The number of arms at each junction.
    pub(super) fn degrees(&self) -> Vec<usize> {
        let mut degrees = vec![0; self.points.len()];
        for line in &self.lines {
            let last = line.along.len() - 1;
            for (place, vertex) in line.along.iter().enumerate() {
                degrees[*vertex] += if !line.closed && (place == 0 || place == last) { 1 } else { 2 };
            }
        }
        degrees
    }
}

/// How far a street reaches along another that it meets: to where the edges of their carriageways meet.
fn meeting(class: StreetClass, along: StreetClass, across: &Vector2<f64>, direction: &Vector2<f64>) -> f64 {
    let (cosine, sine) = (across.dot(direction).abs(), across.perp(direction).abs().max(0.3));
    (class.kerb().max(MINOR) + along.kerb().max(MINOR) * cosine) / sine
}
