//! Junctions: a connecting road for each movement, and controllers of signals.

use std::fmt::Display;

use super::roads::lane_number;
use super::{Fixed, connecting_number, plan_view, road_number};
use crate::format::xml::Xml;
use crate::parts::{Junction, Lane, Movement};
use crate::{DrivingSide, MovementId, StreetMap, Users};

/// The contact point of a road at an end of one of its lanes.
fn contact(at_end: bool) -> &'static str {
    if at_end { "end" } else { "start" }
}

/// The road of a movement: its line, one lane to its right, linked with the lanes that it joins.
pub(super) fn connecting_road(map: &StreetMap, xml: &mut Xml, id: MovementId) {
    let Some(movement) = map.movement(id) else { return };
    let (Some(from), Some(to)) = (map.lane(movement.from), map.lane(movement.to)) else { return };
    let (number, length) = (connecting_number(map, id), Fixed(movement.line.length()));
    let rule = if map.side() == DrivingSide::Right { "RHT" } else { "LHT" };
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
    xml.open("lanes", &[]);
    // The line is the middle of the lane, which lies on the side on which one drives.
    let sign = map.side().sign() / 2.0;
    let slope = sign * (to.width - from.width) / movement.line.length().max(0.01);
    let (zero, begin, slope) = (Fixed(0.0), Fixed(sign * from.width), Fixed(slope));
    xml.tag("laneOffset", &[("s", &zero), ("a", &begin), ("b", &slope), ("c", &zero), ("d", &zero)]);
    xml.open("laneSection", &[("s", &zero)]);
    let centre = |xml: &mut Xml| {
        xml.open("center", &[]);
        xml.tag("lane", &[("id", &0), ("type", &"none"), ("level", &"false")]);
        xml.close();
    };
    if map.side() == DrivingSide::Right {
        centre(xml);
        only_lane(map, xml, movement, "right", [from, to]);
    } else {
        only_lane(map, xml, movement, "left", [from, to]);
        centre(xml);
    }
    (0..3).for_each(|_| xml.close());
}

/// The lane of a connecting road, which grows from one width to the other.
fn only_lane(map: &StreetMap, xml: &mut Xml, movement: &Movement, name: &'static str, [from, to]: [&Lane; 2]) {
    let kind = match () {
        () if movement.users.has(Users::CAR) => "driving",
        () if movement.users.has(Users::BUS) => "bus",
        () if movement.users.has(Users::TRAM) => "tram",
        () if movement.users.has(Users::TRAIN) => "rail",
        () => "biking",
    };
    xml.open(name, &[]);
    xml.open("lane", &[("id", &own_lane(map)), ("type", &kind), ("level", &"false")]);
    xml.open("link", &[]);
    xml.tag("predecessor", &[("id", &lane_number(map, from))]);
    xml.tag("successor", &[("id", &lane_number(map, to))]);
    xml.close();
    let (zero, begin) = (Fixed(0.0), Fixed(from.width));
    let slope = Fixed((to.width - from.width) / movement.line.length().max(0.01));
    xml.tag("width", &[("sOffset", &zero), ("a", &begin), ("b", &slope), ("c", &zero), ("d", &zero)]);
    let limit = Fixed(from.limit.min(to.limit));
    xml.tag("speed", &[("sOffset", &zero), ("max", &limit), ("unit", &"m/s")]);
    xml.close();
    xml.close();
}

/// The right of way by connecting roads, where no lights rule.
fn priorities(map: &StreetMap, xml: &mut Xml, junction: &Junction) {
    let own = |id: &&MovementId| map.movement(**id).is_some();
    for id in junction.movements.iter().filter(own).filter(|_| junction.signal.is_none()) {
        let first = map.movement(*id).into_iter().flat_map(|movement| &movement.yields);
        for high in first.filter_map(|position| junction.movements.get(*position as usize)) {
            let [high, low] = [*high, *id].map(|id| connecting_number(map, id));
            xml.tag("priority", &[("high", &high), ("low", &low)]);
        }
    }
}

/// The number of the lane of a connecting road.
fn own_lane(map: &StreetMap) -> i64 {
    if map.side() == DrivingSide::Right { -1 } else { 1 }
}

/// A controller for each signal: the lanes whose lights it switches.
pub(super) fn controllers(map: &StreetMap, xml: &mut Xml) {
    for (index, signal) in map.signals().iter().enumerate() {
        let lanes = map.junction(signal.junction).map(|junction| map.lit_lanes(junction)).unwrap_or_default();
        xml.open("controller", &[("id", &(index + 1)), ("name", &format!("signal {index}")), ("sequence", &0)]);
        for lane in lanes {
            xml.tag("control", &[("signalId", &lane.0), ("type", &"0")]);
        }
        xml.close();
    }
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
            xml.tag("laneLink", &[("from", &lane_number(map, from)), ("to", &own_lane(map))]);
            xml.close();
        }
        priorities(map, xml, junction);
        if let Some(signal) = junction.signal {
            xml.tag("controller", &[("id", &(signal.index() + 1)), ("type", &"0"), ("sequence", &0)]);
        }
        xml.close();
    }
}
