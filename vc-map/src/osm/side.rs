//! Where a map lies: its frame, and the side on which vehicles drive there.

use super::data::{Node, Way};
use super::tags::Source;
use super::{Guessed, ImportReport};
use crate::geo::{Frame, turned};
use crate::polyline::area;
use crate::{DrivingSide, Origin, Point};

/// Boxes around places with the side on which one drives there. Roundabouts tell better.
const PLACES: &str = include_str!("../../data/sides.txt");

impl Node {
    /// How far it lies within the edges of a box, metres.
    pub(super) fn within(&self, [south, west, north, east]: [f64; 4]) -> f64 {
        let [latitude, longitude] = self.degrees();
        let inside = [latitude - south, north - latitude, turned(longitude - west), turned(east - longitude)];
        inside.into_iter().fold(f64::INFINITY, f64::min) * 111_000.0
    }
}

impl Source<'_> {
    /// The frame around the middle of the file's bounds, or else of the nodes of its streets and buildings. `None` without ways.
    pub(super) fn frame(&self) -> Option<Frame> {
        let used = self.ways.iter().any(|way| self.refs(way).iter().any(|id| self.node(*id).is_some()));
        let drawn = |way: &&Way| ["highway", "railway", "building"].iter().any(|key| self.way_tags(way).has(key));
        let [latitude, longitude] = match self.bounds {
            // An eastern edge that is less than the western lies beyond the date line.
            Some([south, west, north, east]) => {
                let span = if east < west { east + 360.0 - west } else { east - west };
                [(south + north) / 2.0, turned(west + span / 2.0)]
            }
            None => self.middle(drawn).or_else(|| self.middle(|_| true))?,
        };
        used.then(|| Frame::new(Origin { latitude: latitude.clamp(-85.0, 85.0), longitude }))
    }

    /// The medians of the degrees of the nodes of some ways: a few that are far away do not move them.
    fn middle(&self, ways: impl Fn(&&Way) -> bool) -> Option<[f64; 2]> {
        let refs = self.ways.iter().filter(ways).flat_map(|way| self.refs(way));
        let mut at: Vec<[i32; 2]> = refs.filter_map(|id| self.node(*id)).map(|index| self.nodes[index].at).collect();
        let half = at.len() / 2;
        let mut median = |axis: usize| -> Option<f64> {
            (half < at.len()).then(|| f64::from(at.select_nth_unstable_by_key(half, |at| at[axis]).1[axis]) / 1e7)
        };
        Some([median(0)?, median(1)?])
    }

    /// The side on which vehicles drive: as told, else as most roundabouts turn, else by the place.
    pub(super) fn side(&self, told: Option<DrivingSide>, origin: Origin, report: &mut ImportReport) -> DrivingSide {
        told.unwrap_or_else(|| {
            let side = self.side_by_roundabouts().unwrap_or_else(|| side_by_place(origin));
            report.general.push(Guessed::Side(side));
            side
        })
    }

    fn side_by_roundabouts(&self) -> Option<DrivingSide> {
        let turn = |way: &Way| -> Option<f64> {
            let refs = self.refs(way);
            if !self.way_tags(way).is("junction", "roundabout|circular")
                || refs.len() < 4
                || refs.first() != refs.last()
            {
                return None;
            }
            let ring: Option<Vec<Point>> = refs.iter().map(|id| self.near(*id).map(|at| self.point(at))).collect();
            ring.map(|ring| area(&ring).signum())
        };
        let sum: f64 = self.ways.iter().filter_map(turn).sum();
        (sum != 0.0).then_some(if sum > 0.0 { DrivingSide::Right } else { DrivingSide::Left })
    }
}

/// The side of the first box around a place.
fn side_by_place(origin: Origin) -> DrivingSide {
    let side = |line: &str| -> Option<DrivingSide> {
        let mut words = line.split_whitespace();
        let side = if words.next()? == "left" { DrivingSide::Left } else { DrivingSide::Right };
        let mut edge = || words.next()?.parse::<f64>().ok();
        let [south, west, north, east] = [edge()?, edge()?, edge()?, edge()?];
        let within = (south..=north).contains(&origin.latitude) && (west..=east).contains(&origin.longitude);
        within.then_some(side)
    };
    PLACES.lines().find_map(side).unwrap_or_default()
}
