//! Roads between junctions.

use std::fmt::Display;

use super::{Fixed, plan_view, road_number};
use crate::format::xml::Xml;
use crate::parts::{Lane, Road};
use crate::{DrivingSide, LaneId, Light, Polyline, RoadClass, RoadId, StreetMap, Strip, StripKind, Users};

/// The part of a road between its junctions.
pub(super) fn middle(road: &Road) -> Polyline {
    let part = road.line.part(road.cuts[0], road.line.length() - road.cuts[1]);
    part.unwrap_or_else(|| road.line.clone())
}

/// The number of a lane: negative to the right of the reference line.
pub(super) fn lane_number(map: &StreetMap, lane: &Lane) -> i64 {
    let right = lane.forward == (map.side() == DrivingSide::Right);
    let number = lane.index as i64 + 1;
    if right { -number } else { number }
}

pub(super) fn road(map: &StreetMap, xml: &mut Xml, id: RoadId) {
    let Some(road) = map.road(id) else { return };
    let line = middle(road);
    let draft = &road.draft;
    let name = draft.name.clone().unwrap_or_default();
    let rule = if map.side() == DrivingSide::Right { "RHT" } else { "LHT" };
    let length = Fixed(line.length());
    let number = road_number(id);
    xml.open("road", &[("name", &name), ("length", &length), ("id", &number), ("junction", &-1), ("rule", &rule)]);
    xml.open("link", &[]);
    let meets =
        |junction: crate::JunctionId| map.junction(junction).is_some_and(|junction| !junction.movements.is_empty());
    for (tag, junction) in [("predecessor", draft.from), ("successor", draft.to)] {
        if meets(junction) {
            xml.tag(tag, &[("elementType", &"junction"), ("elementId", &junction.0)]);
        }
    }
    xml.close();
    let town = if draft.class == RoadClass::Motorway { "motorway" } else { "town" };
    let limit = draft.section.strips().map(|(_, strip)| strip.limit).fold(0.1, f64::max);
    xml.open("type", &[("s", &Fixed(0.0)), ("type", &town)]);
    xml.tag("speed", &[("max", &Fixed(limit)), ("unit", &"m/s")]);
    xml.close();
    plan_view(xml, &line);
    lanes(map, xml, road);
    signals(map, xml, road, &line);
    xml.close();
}

fn lanes(map: &StreetMap, xml: &mut Xml, road: &Road) {
    let section = &road.draft.section;
    xml.open("lanes", &[]);
    // The reference line is the middle of the carriageway; lanes are counted from the divider.
    let offset = Fixed(map.side().sign() * section.shift());
    let zero = Fixed(0.0);
    xml.tag("laneOffset", &[("s", &zero), ("a", &offset), ("b", &zero), ("c", &zero), ("d", &zero)]);
    xml.open("laneSection", &[("s", &zero)]);
    let right_hand = map.side() == DrivingSide::Right;
    let [left, right] = if right_hand { [false, true] } else { [true, false] };
    side(xml, "left", section.side(left).iter().enumerate().rev().map(|(i, strip)| (i as i64 + 1, strip)));
    xml.open("center", &[]);
    xml.open("lane", &[("id", &0), ("type", &"none"), ("level", &"false")]);
    mark(xml, if section.forward.is_empty() || section.backward.is_empty() { "solid" } else { "broken" });
    xml.close();
    xml.close();
    side(xml, "right", section.side(right).iter().enumerate().map(|(i, strip)| (-(i as i64) - 1, strip)));
    xml.close();
    xml.close();
}

fn side<'a>(xml: &mut Xml, name: &'static str, strips: impl Iterator<Item = (i64, &'a Strip)>) {
    let mut strips = strips.peekable();
    if strips.peek().is_none() {
        return;
    }
    xml.open(name, &[]);
    for (number, strip) in strips {
        xml.open("lane", &[("id", &number), ("type", &kind(strip)), ("level", &"false")]);
        let zero = Fixed(0.0);
        xml.tag("width", &[("sOffset", &zero), ("a", &Fixed(strip.width)), ("b", &zero), ("c", &zero), ("d", &zero)]);
        mark(xml, if strip.kind == StripKind::Driving { "broken" } else { "solid" });
        xml.tag("speed", &[("sOffset", &zero), ("max", &Fixed(strip.limit)), ("unit", &"m/s")]);
        xml.close();
    }
    xml.close();
}

fn mark(xml: &mut Xml, kind: &str) {
    let attributes: [(&str, &dyn Display); 4] =
        [("sOffset", &Fixed(0.0)), ("type", &kind), ("weight", &"standard"), ("color", &"standard")];
    xml.tag("roadMark", &attributes);
}

/// The type of a lane in OpenDRIVE 1.7.
pub(super) fn kind(strip: &Strip) -> &'static str {
    match strip.kind {
        StripKind::Driving if strip.users.has(Users::CAR) => "driving",
        StripKind::Driving if strip.users.has(Users::BUS) => "bus",
        StripKind::Driving => "restricted",
        StripKind::Cycle => "biking",
        StripKind::Parking => "parking",
        StripKind::Pavement => "sidewalk",
        StripKind::Verge => "shoulder",
        StripKind::Path if strip.users.has(Users::FOOT) => "sidewalk",
        StripKind::Path => "biking",
        StripKind::Track if strip.users.has(Users::TRAM) => "tram",
        StripKind::Track => "rail",
    }
}

/// A signal for each lane that ends at lights, and an object for each crossing over the road.
fn signals(map: &StreetMap, xml: &mut Xml, road: &Road, line: &Polyline) {
    let lit: Vec<(LaneId, &Lane)> =
        road.lanes.iter().filter_map(|id| Some((*id, map.lane(*id)?))).filter(|(_, lane)| is_lit(map, lane)).collect();
    if lit.is_empty() {
        return;
    }
    xml.open("signals", &[]);
    for (id, lane) in lit {
        let back = lane.line.length() - lane.stop_line.unwrap_or(lane.line.length());
        let s = if lane.forward { line.length() - back } else { back }.clamp(0.0, line.length());
        let orientation = if lane.forward { "+" } else { "-" };
        let t = Fixed(line.project(&lane.line.at(lane.line.length() - back)).left);
        let number = lane_number(map, lane);
        let attributes: [(&str, &dyn Display); 10] = [
            ("s", &Fixed(s)),
            ("t", &t),
            ("id", &id.0),
            ("name", &format!("signal of lane {}", id.0)),
            ("dynamic", &"yes"),
            ("orientation", &orientation),
            ("zOffset", &Fixed(5.3)),
            ("country", &"OpenDRIVE"),
            ("type", &"1000001"),
            ("subtype", &"-1"),
        ];
        xml.open("signal", &attributes);
        xml.tag("validity", &[("fromLane", &number), ("toLane", &number)]);
        xml.close();
    }
    xml.close();
}

/// Whether lights rule the movements of a lane.
pub(super) fn is_lit(map: &StreetMap, lane: &Lane) -> bool {
    let light = |light: &Light| *light != Light::Red;
    let junction =
        lane.next.first().and_then(|id| map.movement(*id)).and_then(|movement| map.junction(movement.junction));
    let signal = junction.and_then(|junction| junction.signal).and_then(|id| map.signal(id));
    signal.is_some_and(|signal| signal.phases.iter().any(|phase| phase.lights.iter().any(light)))
}
