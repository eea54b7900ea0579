//! Points by cells of a grid, for whatever is near.

use std::collections::BTreeMap;

use vc_map::Point;

/// The side of a cell, metres.
const CELL: f64 = 24.0;

/// Numbered points, found by place.
#[derive(Default)]
pub(crate) struct Near {
    cells: BTreeMap<(i32, i32), Vec<(usize, Point)>>,
}

fn cell(point: &Point) -> (i32, i32) {
    ((point.x / CELL).floor() as i32, (point.y / CELL).floor() as i32)
}

impl Near {
    pub(crate) fn of<'a>(points: impl IntoIterator<Item = &'a Point>) -> Self {
        let mut near = Self::default();
        points.into_iter().enumerate().for_each(|(number, point)| near.add(number, *point));
        near
    }

    pub(super) fn add(&mut self, number: usize, point: Point) {
        self.cells.entry(cell(&point)).or_default().push((number, point));
    }

    /// The numbers of the points within a distance in metres of another one, in the order of cells.
    pub(crate) fn around<'a>(&'a self, at: &Point, within: f64) -> impl Iterator<Item = usize> + use<'a> {
        self.found(at, within).map(|(number, _)| number)
    }

    /// The same with their distances, metres.
    pub(crate) fn found<'a>(&'a self, at: &Point, within: f64) -> impl Iterator<Item = (usize, f64)> + use<'a> {
        let at = *at;
        let [low, high] = [-within, within].map(|away| cell(&Point::new(at.x + away, at.y + away)));
        let columns = (low.0..=high.0).flat_map(move |x| self.cells.range((x, low.1)..=(x, high.1)));
        let points = columns.flat_map(|(_, points)| points);
        points.map(move |(number, point)| (*number, (point - at).norm())).filter(move |(_, away)| *away <= within)
    }
}
