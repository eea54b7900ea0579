//! Junctions: a connecting road for each movement, and controllers of signals.

use std::fmt::Display;

use super::roads::{is_lit, lane_number};
use super::{Fixed, connecting_number, plan_view, road_number};
use crate::format::xml::Xml;
use crate::{LaneId, MovementId, StreetMap, Users};

/// The contact point of a road at an end of one of its lanes.
fn contact(at_end: bool) -> &'static str {
    if at_end { "end" } else { "start" }
}

/// The road of a movement: its line, one lane to its right, linked with the lanes that it joins.
pub(super) fn connecting_road(map: &StreetMap, xml: &mut Xml, id: MovementId) {
    let Some(movement) = map.movement(id) else { return };
    let (Some(from), Some(to)) = (map.lane(movement.from), map.lane(movement.to)) else { return };
    let zero = Fixed(0.0);
    let number = connecting_number(map, id);
    let length = Fixed(movement.line.length());
    let rule = if map.side() == crate::DrivingSide::Right { "RHT" } else { "LHT" };
    xml.open(
        "road",
        &[("name", &""), ("length", &length), ("id", &number), ("junction", &movement.junction.0), ("rule", &rule)],
    );
    xml.open("link", &[]);
    for (tag, lane, at_end) in [("predecessor", from, from.forward), ("successor", to, !to.forward)] {
        let (road, point) = (road_number(lane.road), contact(at_end));
        xml.tag(tag, &[("elementType", &"road"), ("elementId", &road), ("contactPoint", &point)]);
    }
    xml.close();
    plan_view(xml, &movement.line);
    // The line is the middle of the lane, which lies on the side on which one drives.
    let sign = if rule == "RHT" { 1.0 } else { -1.0 };
    let change = Fixed((to.width - from.width) / movement.line.length().max(0.01));
    xml.open("lanes", &[]);
    let slope = Fixed(sign * (to.width - from.width) / 2.0 / movement.line.length().max(0.01));
    let begin = Fixed(sign * from.width / 2.0);
    xml.tag("laneOffset", &[("s", &zero), ("a", &begin), ("b", &slope), ("c", &zero), ("d", &zero)]);
    xml.open("laneSection", &[("s", &zero)]);
    let (name, own) = if rule == "RHT" { ("right", -1) } else { ("left", 1) };
    let center = |xml: &mut Xml| {
        xml.open("center", &[]);
        xml.tag("lane", &[("id", &0), ("type", &"none"), ("level", &"false")]);
        xml.close();
    };
    if own < 0 {
        center(xml);
    }
    xml.open(name, &[]);
    let kind = match () {
        () if movement.users.has(Users::CAR) => "driving",
        () if movement.users.has(Users::BUS) => "bus",
        () if movement.users.has(Users::TRAM) => "tram",
        () if movement.users.has(Users::TRAIN) => "rail",
        () => "biking",
    };
    xml.open("lane", &[("id", &own), ("type", &kind), ("level", &"false")]);
    xml.open("link", &[]);
    xml.tag("predecessor", &[("id", &lane_number(map, from))]);
    xml.tag("successor", &[("id", &lane_number(map, to))]);
    xml.close();
    xml.tag("width", &[("sOffset", &zero), ("a", &Fixed(from.width)), ("b", &change), ("c", &zero), ("d", &zero)]);
    let limit = Fixed(from.limit.min(to.limit));
    xml.tag("speed", &[("sOffset", &zero), ("max", &limit), ("unit", &"m/s")]);
    xml.close();
    xml.close();
    if own > 0 {
        center(xml);
    }
    xml.close();
    xml.close();
    xml.close();
}

/// A controller for each signal: the lanes whose lights it switches.
pub(super) fn controllers(map: &StreetMap, xml: &mut Xml) {
    for (index, signal) in map.signals().iter().enumerate() {
        let lanes = lit_lanes(map, signal.junction);
        xml.open("controller", &[("id", &(index + 1)), ("name", &format!("signal {index}")), ("sequence", &0)]);
        for lane in lanes {
            xml.tag("control", &[("signalId", &lane.0), ("type", &"0")]);
        }
        xml.close();
    }
}

fn lit_lanes(map: &StreetMap, junction: crate::JunctionId) -> Vec<LaneId> {
    let movements = map.junction(junction).into_iter().flat_map(|junction| &junction.movements);
    let mut lanes: Vec<LaneId> = movements.filter_map(|id| map.movement(*id)).map(|movement| movement.from).collect();
    lanes.sort_unstable();
    lanes.dedup();
    lanes.retain(|id| map.lane(*id).is_some_and(|lane| is_lit(map, lane)));
    lanes
}

pub(super) fn junctions(map: &StreetMap, xml: &mut Xml) {
    for (index, junction) in map.junctions().iter().enumerate().filter(|(_, junction)| !junction.movements.is_empty()) {
        xml.open("junction", &[("id", &index), ("name", &format!("junction {index}")), ("type", &"default")]);
        for (position, id) in junction.movements.iter().enumerate() {
            let Some(movement) = map.movement(*id) else { continue };
            let Some(from) = map.lane(movement.from) else { continue };
            let (incoming, connecting) = (road_number(from.road), connecting_number(map, *id));
            let attributes: [(&str, &dyn Display); 4] = [
                ("id", &position),
                ("incomingRoad", &incoming),
                ("connectingRoad", &connecting),
                ("contactPoint", &"start"),
            ];
            xml.open("connection", &attributes);
            let own = if map.side() == crate::DrivingSide::Right { -1 } else { 1 };
            xml.tag("laneLink", &[("from", &lane_number(map, from)), ("to", &own)]);
            xml.close();
        }
        if let Some(signal) = junction.signal {
            xml.tag("controller", &[("id", &(signal.index() + 1)), ("type", &"0"), ("sequence", &0)]);
        }
        xml.close();
    }
}
