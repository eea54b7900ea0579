//! Lines painted on roads: between lanes, where one stops, where people cross.

use crate::parts::Lane;
use crate::polyline::normal;
use crate::{CrossingKind, LaneId, Point, RoadCrossing, StreetMap, StripKind, Users};

/// The width of lines and the lengths of dashes and gaps, metres, as German rules for towns have them (RMS-1).
const LINE: f64 = 0.15;
const DASH: [f64; 2] = [2.0, 4.0];
/// The width of the line beside bays, metres.
const BAYS: f64 = 0.1;
/// The width of stop lines, metres.
const STOP: f64 = 0.3;
/// Bars of zebras and the gaps between them, metres.
const ZEBRA: [f64; 2] = [0.5, 0.5];
/// The lines along crossings at lights: width, dashes and gaps, metres.
const LIGHTS: (f64, [f64; 2]) = (0.25, [0.8, 0.4]);

/// A line painted on a road.
///
/// ```
/// # use vc_map::{Control, CrossSection, MapDraft, RoadClass, Strip};
/// # let mut draft = MapDraft::new("street", 48.1, 11.6);
/// # let ends = [[0.0, 0.0], [100.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
/// # let side = vec![Strip::driving(3.0, 8.3), Strip::pavement(2.0)];
/// # let section = CrossSection { forward: side.clone(), backward: side, median: 0.0 };
/// # draft.road(ends[0], ends[1], RoadClass::Residential, section);
/// # let map = draft.build()?; // a street with a lane in each direction
/// let middle = &map.markings()[0];
/// assert_eq!((middle.width, middle.dashes), (0.15, Some([2.0, 4.0])));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Marking {
    /// Its middle.
    pub points: Vec<Point>,
    /// Its width, metres.
    pub width: f64,
    /// The lengths of dashes and of the gaps between them, metres; `None` if there are none. Bars of a zebra are dashes.
    pub dashes: Option<[f64; 2]>,
    /// The layer of its road; crossings have none, and lie on top of all.
    pub layer: Option<i8>,
}

impl StreetMap {
    /// The lines painted on roads: lines between lanes and directions, beside bays, stop lines, crossings. Costs some for each lane.
    pub fn markings(&self) -> Vec<Marking> {
        let lines = self.lanes().iter().flat_map(|lane| match lane.kind {
            StripKind::Driving => self.lane_markings(lane),
            StripKind::Parking => self.inner_edge(lane, BAYS, None).into_iter().collect(),
            _ => Vec::new(),
        });
        lines.chain(self.crossings().iter().flat_map(crossing_markings)).collect()
    }

    /// A line between a lane and the next one towards the divider.
    fn inner_edge(&self, lane: &Lane, width: f64, dashes: Option<[f64; 2]>) -> Option<Marking> {
        let road = self.road(lane.road).filter(|road| road.draft.class.is_street())?;
        // The inner edge is to the left of those who drive on the right.
        let edge = lane.line.offset(self.side().sign() * lane.width / 2.0);
        Some(Marking { points: edge.points().to_vec(), width, dashes, layer: Some(road.draft.layer) })
    }

    fn lane_markings(&self, lane: &Lane) -> Vec<Marking> {
        let Some(road) = self.road(lane.road).filter(|road| road.draft.class.is_street()) else { return Vec::new() };
        let layer = Some(road.draft.layer);
        let drives = |id: LaneId| self.lane(id).is_some_and(|lane| lane.kind == StripKind::Driving);
        let both = !road.draft.section.forward.is_empty() && road.draft.section.users(false).any(Users::TRAFFIC);
        let is_divided = lane.inner.is_some_and(drives) || (lane.forward && lane.index == 0 && both);
        let stop = lane.stop_line.filter(|at| *at > 0.5).map(|at| {
            let (point, along) = (lane.line.at(at), lane.line.direction(at));
            let across = normal(along) * (lane.width / 2.0);
            Marking { points: vec![point - across, point + across], width: STOP, dashes: None, layer }
        });
        let divider = is_divided.then(|| self.inner_edge(lane, LINE, Some(DASH))).flatten();
        divider.into_iter().chain(stop).collect()
    }
}

/// Zebras as bars along the traffic; crossings at lights as two lines.
fn crossing_markings(crossing: &RoadCrossing) -> Vec<Marking> {
    let line = |points: &[Point], width: f64, dashes: [f64; 2]| Marking {
        points: points.to_vec(),
        width,
        dashes: Some(dashes),
        layer: None,
    };
    match crossing.kind {
        CrossingKind::Marked => vec![line(crossing.line.points(), crossing.width, ZEBRA)],
        CrossingKind::Signals => {
            let side = |side: f64| line(crossing.line.offset(side * crossing.width).points(), LIGHTS.0, LIGHTS.1);
            vec![side(-0.5), side(0.5)]
        }
        CrossingKind::Unmarked => Vec::new(),
    }
}
