//! Lines on roads, crossings, signals, names.

use std::collections::BTreeSet;

use super::legend::{MARK, SIGNAL};
use super::{Drawing, Text, layers::square};
use crate::polyline::normal;
use crate::{CrossingKind, LaneId, StreetMap, StripKind, Users};

/// The width of lines and the lengths of dashes and gaps, metres, as German rules for towns have them (RMS-1).
const LINE: f64 = 0.15;
const DASH: [f64; 2] = [2.0, 4.0];
/// Names on carriageways, and on what is light.
const LIGHT: [u8; 3] = [250, 250, 245];
const DARK: [u8; 3] = [20, 20, 24];
/// Bars of zebras and the gaps between them, metres.
const ZEBRA: [f64; 2] = [0.5, 0.5];

/// Lines between lanes, divider and stop lines of the roads of a layer.
pub(super) fn roads(map: &StreetMap, drawing: &mut Drawing, layer: i8) {
    for lane in map.lanes().iter().filter(|lane| lane.kind == StripKind::Driving) {
        let Some(road) = map.road(lane.road).filter(|road| road.draft.layer == layer && road.draft.class.is_street())
        else {
            continue;
        };
        // The inner edge is to the left of those who drive on the right.
        let edge = lane.line.offset(map.side().sign() * lane.width / 2.0);
        let drives = |id: LaneId| map.lane(id).is_some_and(|lane| lane.kind == StripKind::Driving);
        let both = !road.draft.section.forward.is_empty() && road.draft.section.users(false).any(Users::TRAFFIC);
        if lane.inner.is_some_and(drives) || (lane.forward && lane.index == 0 && both) {
            drawing.dashes(MARK, LINE, DASH, edge.points());
        }
        if let Some(at) = lane.stop_line.filter(|at| *at > 0.5) {
            let (point, along) = (lane.line.at(at), lane.line.direction(at));
            let across = normal(along) * (lane.width / 2.0);
            drawing.line(MARK, 0.3, &[point - across, point + across]);
        }
    }
}

/// Zebras as bars along the traffic; crossings at lights as two lines.
pub(super) fn crossings(map: &StreetMap, drawing: &mut Drawing) {
    for crossing in map.crossings() {
        match crossing.kind {
            CrossingKind::Marked => drawing.dashes(MARK, crossing.width, ZEBRA, crossing.line.points()),
            CrossingKind::Signals => {
                for side in [-0.5, 0.5] {
                    drawing.dashes(MARK, 0.25, [0.8, 0.4], crossing.line.offset(side * crossing.width).points());
                }
            }
            CrossingKind::Unmarked => drawing.dashes([150, 152, 156], 0.2, [0.4, 1.2], crossing.line.points()),
        }
    }
}

/// A red square beside each lane that has lights.
pub(super) fn signals(map: &StreetMap, drawing: &mut Drawing) {
    let lanes = map.junctions().iter().flat_map(|junction| map.lit_lanes(junction)).filter_map(|id| map.lane(id));
    for lane in lanes.filter(|lane| lane.users.any(Users::TRAFFIC)) {
        let at = lane.line.at(lane.stop_line.unwrap_or(lane.line.length()));
        drawing.fill(SIGNAL, vec![square(&at, 0.7)]);
    }
}

/// The name of each street along its longest road, unless it would lie on another.
pub(super) fn names(map: &StreetMap, drawing: &mut Drawing) {
    let mut taken: BTreeSet<[i64; 2]> = BTreeSet::new();
    for (name, road) in map.named().into_iter().filter(|(_, road)| road.line.length() > 25.0) {
        let middle = road.line.length() / 2.0;
        let along = road.line.direction(middle);
        let along = if along.x < 0.0 { -along } else { along };
        let heading = vc_graph::portable::Portable::angle_to(along.y, along.x);
        let size = 3.2;
        // The base line lies a little below the middle of the road.
        let at = road.line.at(middle) - normal(along) * (0.35 * size);
        let half = name.chars().count() as f64 * size / 2.0;
        let steps = (2.0 * half / size).ceil() as i64;
        let cell = |step: i64| {
            let point = at + along * (step as f64 * size - half);
            [point.x, point.y].map(|value| (value / size).floor() as i64)
        };
        let cells: BTreeSet<[i64; 2]> = (0..=steps).map(cell).collect();
        if cells.is_disjoint(&taken) {
            taken.extend(cells);
            let dark = road.draft.class.is_street() && road.draft.section.surface() > size;
            let colour = if dark { LIGHT } else { DARK };
            drawing.texts.push(Text { at, heading, size, colour, text: name.to_owned() });
        }
    }
}
