//! Painted lines, crossings, signals, names.

use std::collections::BTreeSet;

use super::legend::{MARK, SIGNAL};
use super::{Drawing, Text, layers::square};
use crate::polyline::normal;
use crate::{CrossingKind, Marking, StreetMap, Users};

/// Names on carriageways, and on what is light.
const LIGHT: [u8; 3] = [250, 250, 245];
const DARK: [u8; 3] = [20, 20, 24];

/// Lines painted on the roads of a layer, or those of crossings.
pub(super) fn painted(drawing: &mut Drawing, markings: &[Marking], layer: Option<i8>) {
    for marking in markings.iter().filter(|marking| marking.layer == layer) {
        match marking.dashes {
            Some(dashes) => drawing.dashes(MARK, marking.width, dashes, &marking.points),
            None => drawing.line(MARK, marking.width, &marking.points),
        }
    }
}

/// Where people cross though nothing is painted.
pub(super) fn unmarked(map: &StreetMap, drawing: &mut Drawing) {
    for crossing in map.crossings().iter().filter(|crossing| crossing.kind == CrossingKind::Unmarked) {
        drawing.dashes([150, 152, 156], 0.2, [0.4, 1.2], crossing.line.points());
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
