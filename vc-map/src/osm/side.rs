//! Where a map lies: its frame, and the side on which vehicles drive there.

use super::data::Node;
use super::{Element, Guessed, ImportReport, OsmData};
use crate::geo::Frame;
use crate::polyline::area;
use crate::{DrivingSide, Origin, Point};

/// Boxes around places where one drives on the left: south, west, north, east, degrees. They are rough; roundabouts tell
/// better.
const LEFT: [[f64; 4]; 12] = [
    // Great Britain and Ireland, Malta, Cyprus.
    [49.8, -11.0, 61.0, 1.8],
    [35.7, 14.1, 36.2, 14.7],
    [34.5, 32.2, 35.8, 34.7],
    // Japan; Hong Kong; Thailand and Malaya; Indonesia; India and its neighbours.
    [30.0, 129.4, 45.7, 146.0],
    [22.1, 113.8, 22.6, 114.5],
    [-1.0, 97.3, 20.5, 105.0],
    [-11.2, 95.0, 6.0, 141.1],
    [5.8, 66.5, 30.5, 92.5],
    // Australia and New Zealand; southern and eastern Africa; Jamaica and the Bahamas.
    [-48.0, 112.0, -10.0, 179.9],
    [-35.0, 15.5, -8.0, 41.0],
    [-8.0, 29.5, 4.5, 42.0],
    [17.6, -78.5, 18.6, -76.1],
];

impl Node {
    /// Degrees of latitude and longitude.
    pub(super) fn degrees(&self) -> [f64; 2] {
        self.at.map(|tiny| f64::from(tiny) / 1e7)
    }
}

impl OsmData {
    /// The frame around the middle of the file's bounds, or else of its nodes. `None` without ways.
    pub(super) fn frame(&self) -> Option<Frame> {
        let used = self.ways.iter().any(|way| self.refs(way).iter().any(|id| self.node(*id).is_some()));
        let ends = |axis: usize| {
            let low = self.nodes.iter().map(|node| node.at[axis]).min()?;
            let high = self.nodes.iter().map(|node| node.at[axis]).max()?;
            Some((f64::from(low) + f64::from(high)) / 2e7)
        };
        let middle = match self.bounds {
            Some([south, west, north, east]) => [(south + north) / 2.0, (west + east) / 2.0],
            None => [ends(0)?, ends(1)?],
        };
        let origin = Origin { latitude: middle[0].clamp(-85.0, 85.0), longitude: middle[1] };
        used.then(|| Frame::new(origin))
    }

    /// The side on which vehicles drive: as told, else as most roundabouts turn, else by the place.
    pub(super) fn side(&self, told: Option<DrivingSide>, report: &mut ImportReport) -> DrivingSide {
        told.unwrap_or_else(|| {
            let side = self.side_by_roundabouts().or_else(|| self.side_by_place()).unwrap_or_default();
            let first = self.ways.first().map_or(0, |way| way.id);
            report.guess(Element::Way(first), Guessed::Side(side));
            side
        })
    }

    fn side_by_roundabouts(&self) -> Option<DrivingSide> {
        let turn = |way: &super::data::Way| -> Option<f64> {
            let refs = self.refs(way);
            if !self.way_tags(way).is("junction", "roundabout|circular")
                || refs.len() < 4
                || refs.first() != refs.last()
            {
                return None;
            }
            let at = |id: &i64| self.node(*id).map(|index| self.nodes[index].degrees());
            let ring: Option<Vec<Point>> =
                refs.iter().map(|id| at(id).map(|[lat, lon]| Point::new(lon, lat))).collect();
            ring.map(|ring| area(&ring).signum())
        };
        let sum: f64 = self.ways.iter().filter_map(turn).sum();
        (sum != 0.0).then_some(if sum > 0.0 { DrivingSide::Right } else { DrivingSide::Left })
    }

    fn side_by_place(&self) -> Option<DrivingSide> {
        let origin = self.frame()?.origin;
        let within = |[south, west, north, east]: &[f64; 4]| {
            (south..=north).contains(&&origin.latitude) && (west..=east).contains(&&origin.longitude)
        };
        Some(if LEFT.iter().any(within) { DrivingSide::Left } else { DrivingSide::Right })
    }
}
