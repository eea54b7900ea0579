//! Faces of the network of streets, and what becomes of one that is cut.

use nalgebra::Vector2;
use vc_map::Point;

use super::convex::{Beyond, Convex};

/// A part of the plan between streets; side `i` begins at corner `i`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Face {
    pub(super) corners: Vec<usize>,
    pub(super) streets: Vec<usize>,
}

/// A place at which a cut ends.
#[derive(Clone, Copy)]
pub(super) struct End {
    pub(super) side: usize,
    pub(super) at: Point,
    /// The junction, if there is one already.
    pub(super) known: Option<usize>,
}

impl Face {
    pub(super) fn polygon(&self, points: &[Point]) -> Convex {
        let beyond = self.streets.iter().map(|street| Beyond::Street(*street)).collect();
        Convex::new(self.corners.iter().map(|corner| points[*corner]).collect(), beyond)
    }
}

/// The two points at which a line leaves a polygon.
pub(super) fn hits(polygon: &Convex, through: &Point, along: &Vector2<f64>) -> Option<[End; 2]> {
    let side_of = |p: &Point| along.perp(&(p - through));
    let mut found = Vec::with_capacity(2);
    for (side, (a, b, _)) in polygon.sides().enumerate() {
        let (from, to) = (side_of(&a), side_of(&b));
        if (from > 0.0) != (to > 0.0) {
            found.push(End { side, at: a + (b - a) * (from / (from - to)), known: None });
        }
    }
    <[End; 2]>::try_from(found).ok()
}

/// The part of a face from one end of a cut to the other, counter-clockwise.
pub(super) fn piece(face: &Face, (from, start): (usize, usize), (to, end): (usize, usize), street: usize) -> Face {
    let count = face.corners.len();
    let mut part = Face { corners: vec![start], streets: vec![face.streets[from]] };
    let mut side = (from + 1) % count;
    loop {
        part.corners.push(face.corners[side]);
        part.streets.push(face.streets[side]);
        if side == to {
            break;
        }
        side = (side + 1) % count;
    }
    part.corners.push(end);
    part.streets.push(street);
    part
}
