//! Roads between junctions.

use std::collections::BTreeSet;
use std::fmt::Display;

use super::{Fine, Fixed, plan_view, road_number};
use crate::format::xml::Xml;
use crate::parts::{Lane, Road};
use crate::{
    CrossSection, DrivingSide, LaneId, Polyline, RoadClass, RoadId, SignKind, StreetMap, Strip, StripKind, Users,
};

/// The number of a lane: negative to the right of the reference line. A divider that is a strip is the first lane of each
/// side.
pub(super) fn lane_number(map: &StreetMap, lane: &Lane) -> i64 {
    let median = map.road(lane.road).is_some_and(|road| road.draft.section.median > 0.0);
    let right = lane.forward == (map.side() == DrivingSide::Right);
    let number = lane.index as i64 + 1 + i64::from(median);
    if right { -number } else { number }
}

pub(super) fn road(map: &StreetMap, xml: &mut Xml, id: RoadId) {
    let Some(road) = map.road(id) else { return };
    let line = road.middle();
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
    objects(map, xml, id, &line);
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
    side(xml, "left", (1..).zip(written(section, left)).collect::<Vec<_>>().into_iter().rev());
    xml.open("center", &[]);
    xml.open("lane", &[("id", &0), ("type", &"none"), ("level", &"false")]);
    mark(xml, if section.forward.is_empty() || section.backward.is_empty() { "solid" } else { "broken" });
    xml.close();
    xml.close();
    side(xml, "right", (1..).zip(written(section, right)).map(|(number, lane)| (-number, lane)));
    xml.close();
    xml.close();
}

/// A lane as it is written.
struct Written {
    kind: &'static str,
    width: f64,
    limit: Option<f64>,
    mark: &'static str,
}

/// The lanes of a side from the divider outward: half of the divider first, if it has a width.
fn written(section: &CrossSection, forward: bool) -> Vec<Written> {
    let lane = |strip: &Strip| {
        let mark = if strip.kind == StripKind::Driving { "broken" } else { "solid" };
        Written { kind: kind(strip), width: strip.width, limit: Some(strip.limit), mark }
    };
    let half = || Written { kind: "median", width: section.median / 2.0, limit: None, mark: "solid" };
    let strips = section.side(forward);
    let divider = (section.median > 0.0 && !strips.is_empty()).then(half);
    divider.into_iter().chain(strips.iter().map(lane)).collect()
}

/// Writes the lanes of a side from the left to the right, with numbers that grow to the left.
fn side(xml: &mut Xml, name: &'static str, lanes: impl Iterator<Item = (i64, Written)>) {
    let mut lanes = lanes.peekable();
    if lanes.peek().is_none() {
        return;
    }
    xml.open(name, &[]);
    for (number, lane) in lanes {
        xml.open("lane", &[("id", &number), ("type", &lane.kind), ("level", &"false")]);
        let zero = Fixed(0.0);
        xml.tag("width", &[("sOffset", &zero), ("a", &Fixed(lane.width)), ("b", &zero), ("c", &zero), ("d", &zero)]);
        mark(xml, lane.mark);
        if let Some(limit) = lane.limit.map(Fixed) {
            xml.tag("speed", &[("sOffset", &zero), ("max", &limit), ("unit", &"m/s")]);
        }
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

/// An object for each crossing, at the first of the roads that it crosses.
fn objects(map: &StreetMap, xml: &mut Xml, id: RoadId, line: &Polyline) {
    let ends: BTreeSet<_> = map.road(id).map(|road| [road.draft.from, road.draft.to]).into_iter().flatten().collect();
    let near = ends.into_iter().filter_map(|end| map.junction(end)).flat_map(|junction| &junction.crossings);
    let crossings = near.filter_map(|number| Some((number.0, map.crossing(*number)?)));
    let own: Vec<_> = crossings.filter(|(_, crossing)| crossing.roads.first() == Some(&id)).collect();
    if own.is_empty() {
        return;
    }
    xml.open("objects", &[]);
    for (number, crossing) in own {
        let length = crossing.line.length();
        let near = line.project(&crossing.line.at(length / 2.0));
        let heading = Fine(crossing.line.heading(length / 2.0) - line.heading(near.station));
        let name = format!("crossing {number}");
        let attributes: [(&str, &dyn Display); 11] = [
            ("type", &"crosswalk"),
            ("id", &name),
            ("name", &name),
            ("s", &Fixed(near.station)),
            ("t", &Fixed(near.left)),
            ("zOffset", &Fixed(0.0)),
            ("orientation", &"none"),
            ("hdg", &heading),
            ("length", &Fixed(length)),
            ("width", &Fixed(crossing.width)),
            ("height", &Fixed(0.0)),
        ];
        xml.tag("object", &attributes);
    }
    xml.close();
}

/// A signal for each lane that ends at lights, and a sign for each that has one.
fn signals(map: &StreetMap, xml: &mut Xml, road: &Road, line: &Polyline) {
    let lanes = road.lanes.iter().filter_map(|id| Some((*id, map.lane(*id)?)));
    let light = |id: LaneId| Post { id: id.0.to_string(), name: format!("signal of lane {}", id.0), ..Post::LIGHT };
    let sign = |id: LaneId, kind| Post {
        id: format!("sign{}", id.0),
        name: format!("sign of lane {}", id.0),
        kind: if kind == SignKind::Stop { "206" } else { "205" },
        ..Post::SIGN
    };
    let posts: Vec<(Post, &Lane)> = lanes
        .flat_map(|(id, lane)| {
            [map.is_lit(lane).then(|| light(id)), lane.sign.map(|kind| sign(id, kind))].map(|post| (post, lane))
        })
        .filter_map(|(post, lane)| Some((post?, lane)))
        .collect();
    if posts.is_empty() {
        return;
    }
    xml.open("signals", &[]);
    posts.iter().for_each(|(post, lane)| signal(map, xml, line, post, lane));
    xml.close();
}

/// A light or a sign at the end of a lane, by its number in OpenDRIVE or among German signs.
struct Post {
    id: String,
    name: String,
    kind: &'static str,
    country: &'static str,
    dynamic: &'static str,
    height: f64,
}

impl Post {
    const LIGHT: Self = Self::new("1000001", "OpenDRIVE", "yes", 5.3);
    const SIGN: Self = Self::new("205", "DE", "no", 2.0);

    const fn new(kind: &'static str, country: &'static str, dynamic: &'static str, height: f64) -> Self {
        Self { id: String::new(), name: String::new(), kind, country, dynamic, height }
    }
}

fn signal(map: &StreetMap, xml: &mut Xml, line: &Polyline, post: &Post, lane: &Lane) {
    let back = lane.line.length() - lane.stop_line.unwrap_or(lane.line.length());
    let s = if lane.forward { line.length() - back } else { back }.clamp(0.0, line.length());
    let orientation = if lane.forward { "+" } else { "-" };
    let t = Fixed(line.project(&lane.line.at(lane.line.length() - back)).left);
    let number = lane_number(map, lane);
    let attributes: [(&str, &dyn Display); 10] = [
        ("s", &Fixed(s)),
        ("t", &t),
        ("id", &post.id),
        ("name", &post.name),
        ("dynamic", &post.dynamic),
        ("orientation", &orientation),
        ("zOffset", &Fixed(post.height)),
        ("country", &post.country),
        ("type", &post.kind),
        ("subtype", &"-1"),
    ];
    xml.open("signal", &attributes);
    xml.tag("validity", &[("fromLane", &number), ("toLane", &number)]);
    xml.close();
}
