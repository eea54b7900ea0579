//! What pieces cover of the floor, made once for all that stand upright.

use nalgebra::{Point2, Point3};

use crate::nav::outline::{Outline, contains, hull};

/// What a piece covers of the floor while its asset stands upright.
pub(crate) struct Footprint {
    /// In the asset's frame, seen from above.
    pub(crate) outline: Outline,
    /// From where to where it reaches along Z, metres.
    pub(crate) low: f32,
    pub(crate) high: f32,
    /// Another piece that covers all of it: a table's top its legs.
    pub(crate) within: Option<usize>,
}

/// By how much an outline's box may reach beyond that of one that covers it, metres: rounding.
const SLACK: f32 = 1e-3;

/// Footprints of pieces, given as their corners. Costs the square of their number.
pub(super) fn of(pieces: &[Vec<Point3<f32>>]) -> Vec<Footprint> {
    let footprint = |corners: &Vec<Point3<f32>>| {
        let (low, high) = levels(corners);
        Footprint { outline: hull(corners.iter().copied()), low, high, within: None }
    };
    let mut all: Vec<Footprint> = pieces.iter().map(footprint).collect();
    let boxes: Vec<_> = all.iter().map(|f| around(&f.outline)).collect();
    for i in 0..all.len() {
        let is_around = |j: usize, i: usize| {
            let ((low, high), (own_low, own_high)) = (boxes[j], boxes[i]);
            (0..2).all(|k| low[k] <= own_low[k] + SLACK && high[k] + SLACK >= own_high[k])
        };
        // Of two that cover each other the first one counts.
        let covers = |j: usize, i: usize| is_around(j, i) && contains(&all[j].outline, &all[i].outline);
        let other = (0..all.len()).find(|&j| j != i && covers(j, i) && (j < i || !covers(i, j)));
        all[i].within = other;
    }
    all
}

/// Least and greatest corner of an outline.
fn around(outline: &Outline) -> (Point2<f32>, Point2<f32>) {
    let start = (Point2::from([f32::INFINITY; 2]), Point2::from([f32::NEG_INFINITY; 2]));
    outline.iter().fold(start, |(low, high), p| (low.inf(p), high.sup(p)))
}

/// Least and greatest height of points.
pub(crate) fn levels(points: &[Point3<f32>]) -> (f32, f32) {
    let start = (f32::INFINITY, f32::NEG_INFINITY);
    points.iter().fold(start, |(low, high), p| (low.min(p.z), high.max(p.z)))
}
