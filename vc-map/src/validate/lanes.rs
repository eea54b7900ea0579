//! Lanes: continuous, and connected.

use petgraph::algo::kosaraju_scc;
use petgraph::graph::{DiGraph, NodeIndex};

use super::MapViolation;
use crate::{Control, LaneId, Movement, MovementId, StreetMap, Users};

/// Lanes begin and end at most this far from the middle of their junction, metres: nodes that lie so far apart are one
/// junction, and arms are cut back.
const REACH: f64 = 75.0;
/// Movements of less than this have no direction to speak of, metres.
const SHORT: f64 = 0.5;

pub(super) fn violations(map: &StreetMap) -> Vec<MapViolation> {
    let mut found: Vec<MapViolation> = gaps(map).collect();
    found.extend(dead(map));
    found.extend(kinks(map));
    found.extend(cut_off(map));
    found
}

fn gaps(map: &StreetMap) -> impl Iterator<Item = MapViolation> + '_ {
    map.lanes().iter().enumerate().flat_map(move |(index, lane)| {
        let ends = map.road(lane.road).map(|road| [road.draft.from, road.draft.to]);
        let points =
            if lane.forward { [lane.line.start(), lane.line.end()] } else { [lane.line.end(), lane.line.start()] };
        ends.into_iter().flatten().zip(points).filter_map(move |(junction, point)| {
            let metres = (map.junction(junction)?.at - point).norm();
            (metres > REACH).then_some(MapViolation::Gap { junction, lane: LaneId::of(index), metres })
        })
    })
}

/// Movements that begin or end against the direction of their lanes.
fn kinks(map: &StreetMap) -> impl Iterator<Item = MapViolation> + '_ {
    let against = |movement: &Movement| {
        let (Some(from), Some(to)) = (map.lane(movement.from), map.lane(movement.to)) else { return false };
        let line = &movement.line;
        let leaves = from.line.direction(from.line.length()).dot(&line.direction(0.0));
        let arrives = line.direction(line.length()).dot(&to.line.direction(0.0));
        line.length() > SHORT && leaves.min(arrives) < 0.0
    };
    let kinks = map.movements().iter().enumerate().filter(move |(_, movement)| against(movement));
    kinks.map(|(index, _)| MapViolation::Kink { movement: MovementId::of(index) })
}

/// Lanes for cars and buses that end without a way on, other than at the edge of the map.
fn dead(map: &StreetMap) -> impl Iterator<Item = MapViolation> {
    map.lanes()
        .iter()
        .enumerate()
        .filter(|(_, lane)| {
            let end = map
                .road(lane.road)
                .and_then(|road| map.junction(if lane.forward { road.draft.to } else { road.draft.from }));
            let edge = end.is_none_or(|junction| junction.draft.control == Control::Edge);
            lane.users.any(Users::CAR | Users::BUS) && lane.next.is_empty() && !edge
        })
        .map(|(index, _)| MapViolation::DeadLane { lane: LaneId::of(index) })
}

/// Lanes as nodes, joined by the movements of cars and to their neighbours. Those from and to the edge of the map are taken to be
/// joined beyond it, in one node more.
fn driven(map: &StreetMap) -> DiGraph<(), ()> {
    let mut graph: DiGraph<(), ()> = DiGraph::with_capacity(map.lanes().len() + 1, map.movements().len());
    map.lanes().iter().for_each(|_| _ = graph.add_node(()));
    let beyond = graph.add_node(());
    let node = |id: LaneId| NodeIndex::new(id.index());
    for movement in map.movements().iter().filter(|movement| movement.users.has(Users::CAR)) {
        graph.add_edge(node(movement.from), node(movement.to), ());
    }
    for (index, lane) in map.lanes().iter().enumerate() {
        let id = LaneId::of(index);
        if let Some(inner) = lane.inner.filter(|inner| map.lane(*inner).is_some_and(|lane| lane.users.has(Users::CAR)))
        {
            graph.add_edge(node(id), node(inner), ());
            graph.add_edge(node(inner), node(id), ());
        }
        let Some(road) = map.road(lane.road) else { continue };
        let is_edge = |id| map.junction(id).is_some_and(|junction| junction.draft.control == Control::Edge);
        let [start, end] =
            if lane.forward { [road.draft.from, road.draft.to] } else { [road.draft.to, road.draft.from] };
        if is_edge(start) {
            graph.add_edge(beyond, node(id), ());
        }
        if is_edge(end) {
            graph.add_edge(node(id), beyond, ());
        }
    }
    graph
}

/// Parts of the network for cars that are not one with the largest part.
fn cut_off(map: &StreetMap) -> Vec<MapViolation> {
    let drives = |index: &NodeIndex| map.lanes().get(index.index()).is_some_and(|lane| lane.users.has(Users::CAR));
    let mut parts: Vec<Vec<NodeIndex>> =
        kosaraju_scc(&driven(map)).into_iter().map(|part| part.into_iter().filter(drives).collect()).collect();
    parts.retain(|part: &Vec<NodeIndex>| !part.is_empty());
    parts.sort_by_key(|part| (std::cmp::Reverse(part.len()), part.iter().min().copied()));
    let lost = parts.iter().skip(1);
    lost.filter_map(|part| {
        Some(MapViolation::CutOff { lane: LaneId::of(part.iter().min()?.index()), lanes: part.len() })
    })
    .collect()
}
