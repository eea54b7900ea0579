//! Connections and crossings.

use std::collections::BTreeSet;
use std::fmt::Display;

use super::edges::{classes, name, number, points, side};
use super::{Metres, NodeName};
use crate::format::xml::Xml;
use crate::parts::{Junction, Movement, RoadCrossing};
use crate::{Control, CrossingKind, RoadId, StreetMap, Users};

/// On a road shorter than this, metres, no vehicle has room between the two junctions that netconvert makes at its ends: who
/// kept the first one clear would wait for the second as well, and for ever where their lights take turns.
const ROOM: f64 = 25.0;

/// The edges and lanes of a movement: from, to, and the numbers of the lanes.
pub(super) fn ends(map: &StreetMap, movement: &Movement) -> Option<[String; 4]> {
    let (road, forward, lane) = number(map, movement.from)?;
    let (next, ahead, onto) = number(map, movement.to)?;
    Some([name(road, forward), name(next, ahead), lane.to_string(), onto.to_string()])
}

/// The edges over which a crossing leads: not those on which people only walk.
pub(super) fn crossed(map: &StreetMap, crossing: &RoadCrossing) -> String {
    let mut edges = Vec::new();
    for road in &crossing.roads {
        let Some(found) = map.road(*road) else { continue };
        let driven = |forward: &bool| {
            side(map, found, *forward).iter().any(|(_, lane)| lane.users.without(Users::FOOT) != Users::NONE)
        };
        edges.extend([true, false].into_iter().filter(driven).map(|forward| name(*road, forward)));
    }
    edges.join(" ")
}

pub(super) fn connections(map: &StreetMap) -> String {
    let mut xml = Xml::new("connections", &[]);
    let mut left: BTreeSet<(RoadId, bool)> = BTreeSet::new();
    for movement in map.movements() {
        connection(map, &mut xml, movement);
        left.extend(map.lane(movement.from).map(|lane| (lane.road, lane.forward)));
    }
    // An edge of which nothing is said would get connections by rule.
    for (index, road) in map.roads().iter().enumerate() {
        let id = RoadId::of(index);
        for forward in [true, false] {
            let driven = side(map, road, forward).iter().any(|(_, lane)| !lane.users.without(Users::FOOT).is_empty());
            if driven && !left.contains(&(id, forward)) {
                xml.tag("connection", &[("from", &name(id, forward))]);
            }
        }
    }
    map.junctions().iter().for_each(|junction| prohibitions(map, &mut xml, junction));
    let on_street = |road: &RoadId| map.road(*road).is_some_and(|road| road.draft.class.is_street());
    // SUMO has no crossings over rails alone: people walk over these in its walking areas.
    let crossings = map.crossings().iter().filter(|crossing| crossing.roads.iter().any(on_street));
    crossings.for_each(|crossing| self::crossing(map, &mut xml, crossing));
    xml.finish()
}

/// The right of way where signs or a mini-roundabout tell, since netconvert goes by classes alone.
fn prohibitions(map: &StreetMap, xml: &mut Xml, junction: &Junction) {
    if junction.draft.control != Control::MiniRoundabout && super::signs(map, junction).next().is_none() {
        return;
    }
    let own: Vec<&Movement> = junction.movements.iter().filter_map(|id| map.movement(*id)).collect();
    let way = |movement: &Movement| ends(map, movement).map(|[from, to, ..]| format!("{from}->{to}"));
    let ways: Vec<Option<String>> = own.iter().map(|movement| way(movement)).collect();
    let mut told = BTreeSet::new();
    for (movement, later) in own.iter().zip(&ways) {
        for first in movement.yields.iter().filter_map(|other| ways.get(*other as usize)) {
            let (Some(first), Some(later)) = (first, later) else { continue };
            if told.insert((first, later)) && !told.contains(&(later, first)) {
                xml.tag("prohibition", &[("prohibitor", first), ("prohibited", later)]);
            }
        }
    }
}

fn connection(map: &StreetMap, xml: &mut Xml, movement: &Movement) {
    let Some([from, to, lane, onto]) = ends(map, movement) else { return };
    let mut attributes: Vec<(&str, &dyn Display)> =
        vec![("from", &from), ("to", &to), ("fromLane", &lane), ("toLane", &onto)];
    let lanes = || [movement.from, movement.to].into_iter().filter_map(|id| map.lane(id));
    let both = lanes().map(|lane| lane.users).reduce(Users::and).unwrap_or_default().without(Users::FOOT);
    let private = lanes().any(|lane| map.road(lane.road).is_some_and(|road| road.draft.private));
    let allow = classes(movement.users, private);
    if movement.users != both {
        attributes.push(("allow", &allow));
    }
    if map.lane(movement.to).and_then(|lane| map.road(lane.road)).is_some_and(|road| road.line.length() < ROOM) {
        attributes.push(("keepClear", &false));
    }
    let round = map.junction(movement.junction).filter(|at| at.draft.control == Control::MiniRoundabout);
    let shape = round.map(|_| points(&movement.line));
    attributes.extend(shape.as_ref().map(|shape| ("shape", shape as &dyn Display)));
    xml.tag("connection", &attributes);
}

fn crossing(map: &StreetMap, xml: &mut Xml, crossing: &RoadCrossing) {
    let edges = crossed(map, crossing);
    if edges.is_empty() {
        return;
    }
    let (node, row, width) = (NodeName(crossing.junction), row(map, crossing), Metres(crossing.width));
    // SUMO asks for it where lights rule.
    let priority = crossing.kind != CrossingKind::Unmarked || row.is_some();
    let mut attributes: Vec<(&str, &dyn Display)> =
        vec![("node", &node), ("edges", &edges), ("priority", &priority), ("width", &width)];
    attributes.extend(row.as_ref().map(|row| ("linkIndex", row as &dyn Display)));
    xml.tag("crossing", &attributes);
}

/// The position of a crossing in the phases of its signal.
fn row(map: &StreetMap, crossing: &RoadCrossing) -> Option<usize> {
    let junction = map.junction(crossing.junction)?;
    junction.signal?;
    let position = junction.crossings.iter().position(|id| map.crossing(*id) == Some(crossing))?;
    Some(junction.movements.len() + position)
}
