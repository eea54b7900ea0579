//! What pieces cover of the floor, made once for all that stand upright.

use nalgebra::Point3;

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

/// Footprints of pieces, given as their corners. Costs the square of their number.
pub(super) fn of(pieces: &[Vec<Point3<f32>>]) -> Vec<Footprint> {
    let footprint = |corners: &Vec<Point3<f32>>| {
        let (low, high) = levels(corners);
        Footprint { outline: hull(corners.iter().copied()), low, high, within: None }
    };
    let mut all: Vec<Footprint> = pieces.iter().map(footprint).collect();
    for i in 0..all.len() {
        // Of two that cover each other the first one counts.
        let covers = |j: usize, i: usize| contains(&all[j].outline, &all[i].outline);
        let other = (0..all.len()).find(|&j| j != i && covers(j, i) && (j < i || !covers(i, j)));
        all[i].within = other;
    }
    all
}

/// Least and greatest height of points.
pub(crate) fn levels(points: &[Point3<f32>]) -> (f32, f32) {
    let start = (f32::INFINITY, f32::NEG_INFINITY);
    points.iter().fold(start, |(low, high), p| (low.min(p.z), high.max(p.z)))
}
