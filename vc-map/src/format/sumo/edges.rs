//! Edges and their lanes.

use std::fmt::Display;

use super::{Metres, NodeName};
use crate::format::xml::Xml;
use crate::parts::{Lane, Road};
use crate::{LaneId, Polyline, RoadId, StreetMap, Users};

/// The vehicle classes of SUMO for each kind of users, and for cars where only those may go who have something to do there.
const CLASSES: [(Users, &str); 6] = [
    (
        Users::CAR,
        "private emergency authority army vip passenger hov taxi coach delivery truck trailer motorcycle moped evehicle custom1 custom2",
    ),
    (Users::BUS, "bus"),
    (Users::BICYCLE, "bicycle"),
    (Users::FOOT, "pedestrian"),
    (Users::TRAM, "tram"),
    (Users::TRAIN, "rail rail_urban rail_electric rail_fast subway"),
];
const PRIVATE: &str = "private emergency authority army vip delivery";

/// The vehicle classes of some users, on private ground or not.
pub(super) fn classes(users: Users, private: bool) -> String {
    let words = |(flag, words): &(Users, &'static str)| if private && *flag == Users::CAR { PRIVATE } else { words };
    CLASSES.iter().filter(|(flag, _)| users.has(*flag)).map(words).collect::<Vec<_>>().join(" ")
}

/// The name of an edge.
pub(super) fn name(road: RoadId, forward: bool) -> String {
    format!("{}r{}", if forward { "" } else { "-" }, road.0)
}

/// The lanes of a side that SUMO knows, from the outer edge.
pub(super) fn side<'a>(map: &'a StreetMap, road: &'a Road, forward: bool) -> Vec<(LaneId, &'a Lane)> {
    let lanes = road.lanes.iter().filter_map(|id| Some((*id, map.lane(*id)?)));
    let mut side: Vec<_> = lanes.filter(|(_, lane)| lane.forward == forward && !lane.users.is_empty()).collect();
    side.reverse();
    side
}

/// The number of a lane on its edge.
pub(super) fn number(map: &StreetMap, id: LaneId) -> Option<(RoadId, bool, usize)> {
    let lane = map.lane(id)?;
    let position = side(map, map.road(lane.road)?, lane.forward).iter().position(|(other, _)| *other == id)?;
    Some((lane.road, lane.forward, position))
}

pub(super) fn edges(map: &StreetMap) -> String {
    let mut xml = Xml::new("edges", &[]);
    for (index, road) in map.roads().iter().enumerate() {
        for forward in [true, false] {
            let lanes = side(map, road, forward);
            if !lanes.is_empty() {
                edge(map, &mut xml, RoadId::of(index), forward, &lanes);
            }
        }
    }
    xml.finish()
}

fn edge(map: &StreetMap, xml: &mut Xml, id: RoadId, forward: bool, lanes: &[(LaneId, &Lane)]) {
    let Some(road) = map.road(id) else { return };
    let draft = &road.draft;
    let [from, to] = if forward { [draft.from, draft.to] } else { [draft.to, draft.from] };
    let shape = shape(map, road, forward);
    let speed = lanes.iter().map(|(_, lane)| lane.limit).fold(0.0, f64::max);
    let (id, from, to, speed) = (name(id, forward), NodeName(from), NodeName(to), Metres(speed));
    let priority = 2 * draft.class.rank() - u8::from(draft.slip);
    let (kind, count) = (draft.class.word(), lanes.len());
    let mut attributes: Vec<(&str, &dyn Display)> = vec![
        ("id", &id),
        ("from", &from),
        ("to", &to),
        ("priority", &priority),
        ("type", &kind),
        ("numLanes", &count),
        ("speed", &speed),
        ("shape", &shape),
        ("spreadType", &"right"),
    ];
    if let Some(label) = draft.name.as_ref().filter(|name| !name.is_empty()) {
        attributes.push(("name", label));
    }
    xml.open("edge", &attributes);
    for (index, (_, lane)) in lanes.iter().enumerate() {
        let (allow, width, speed) =
            (classes(lane.users, draft.private), Metres(lane.width), Metres(lane.limit.max(0.1)));
        xml.tag("lane", &[("index", &index), ("allow", &allow), ("width", &width), ("speed", &speed)]);
    }
    xml.close();
}

/// The line along which the lanes of a side begin, in the direction of travel; SUMO lays them out from there.
fn shape(map: &StreetMap, road: &Road, forward: bool) -> String {
    let section = &road.draft.section;
    let turned = if forward { 1.0 } else { -1.0 };
    let inner = road.line.offset(-map.side().sign() * turned * (section.median / 2.0 - turned * section.shift()));
    let inner = if forward { inner } else { inner.reversed() };
    points(&inner)
}

/// The points of a line.
pub(super) fn points(line: &Polyline) -> String {
    let points: Vec<String> = line.points().iter().map(|p| format!("{},{}", Metres(p.x), Metres(p.y))).collect();
    points.join(" ")
}
