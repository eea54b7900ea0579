//! The walkable network: one part, and crossings at lights.

use petgraph::unionfind::UnionFind;

use super::MapViolation;
use crate::{
    Control, CrossingId, CrossingKind, JunctionId, LaneId, Movement, Point, RoadClass, RoadCrossing, RoadId, StreetMap,
    StripKind, Turn, Users, WalkEdge, WalkEdgeId, WalkKind, WalkNodeId,
};

/// Ends of edges are this near to their nodes, metres; edges between nodes at one place have a centimetre.
const APART: f64 = 0.05;
/// The last part of a lane, which a corner may touch, and how near a crossing comes to the end of a road, metres.
const END: f64 = 0.4;
const BESIDE: f64 = 2.0;
/// The ends of paths may lie so far in a street, metres.
const KERB: f64 = 1.0;

pub(super) fn violations(map: &StreetMap) -> Vec<MapViolation> {
    let mut found = cut_off(map);
    for (index, edge) in map.walk_edges().iter().enumerate() {
        let id = WalkEdgeId::of(index);
        found.extend(in_lane(map, edge).map(|lane| MapViolation::WalkInLane { edge: id, lane }));
        let metres = gap(map, edge);
        if metres > APART {
            found.push(MapViolation::WalkGap { edge: id, metres });
        }
    }
    for (index, crossing) in map.crossings().iter().enumerate() {
        let beside = crossing.roads.iter().filter(|road| !crosses(map, crossing, **road));
        let inside = ends_in(map, crossing);
        let crossing = CrossingId::of(index);
        found.extend(inside.map(|(road, metres)| MapViolation::CrossingInRoad { crossing, road, metres }));
        found.extend(beside.map(|road| MapViolation::CrossesNothing { crossing, road: *road }));
    }
    found.extend(lost(map));
    for (index, junction) in map.junctions().iter().enumerate() {
        if junction.draft.control == Control::Signals {
            found.extend(no_crossing(map, JunctionId::of(index)));
        }
        let differs = |id: &&CrossingId| {
            map.crossing(**id).is_some_and(|c| (c.kind == CrossingKind::Signals) != junction.signal.is_some())
        };
        found.extend(
            junction.crossings.iter().filter(differs).map(|crossing| MapViolation::Unlit { crossing: *crossing }),
        );
    }
    found
}

/// How far the ends of an edge are from its nodes, metres.
fn gap(map: &StreetMap, edge: &WalkEdge) -> f64 {
    let away = |node: WalkNodeId, point: Point| map.walk_node(node).map_or(0.0, |node| (node.at - point).norm());
    away(edge.ends[0], edge.line.start()).max(away(edge.ends[1], edge.line.end()))
}

/// A lane for cars over which a pavement, path or corner leads, or from which cars drive over a corner. Those who walk in a street without pavements come from its middle.
fn in_lane(map: &StreetMap, edge: &WalkEdge) -> Option<LaneId> {
    let shared = |node: &WalkNodeId| {
        let edges = map.walk_edges_at(*node).iter().filter_map(|id| map.walk_edge(*id));
        edges.map(|edge| edge.kind).any(|kind| matches!(kind, WalkKind::Shared(_)))
    };
    let levels: Vec<i8> = match edge.kind {
        WalkKind::Corner(id) if !edge.ends.iter().any(shared) => {
            let arms = map.junction(id)?.arms.iter().filter_map(|arm| map.road(arm.road));
            arms.map(|road| road.draft.layer).collect()
        }
        WalkKind::Lane(id) => {
            let lane = map.lane(id).filter(|lane| matches!(lane.kind, StripKind::Pavement | StripKind::Path))?;
            vec![map.road(lane.road)?.draft.layer]
        }
        _ => return None,
    };
    if let WalkKind::Corner(id) = edge.kind {
        // One goes around the middle of a small roundabout, close by its corners.
        let junction = map.junction(id).filter(|junction| junction.draft.control != Control::MiniRoundabout);
        let movements =
            junction.into_iter().flat_map(|junction| &junction.movements).filter_map(|id| map.movement(*id));
        // Those who turn back at a dead end go round before those who walk around it.
        let drives = |movement: &&Movement| movement.users.has(Users::CAR) && movement.turn != Turn::Back;
        let mut over = movements.filter(drives).filter(|movement| movement.line.crosses(&edge.line));
        if let Some(movement) = over.next() {
            return Some(movement.from);
        }
    }
    // A path may come close to a kerb that is not straight.
    let path = matches!(edge.kind, WalkKind::Lane(id) if map.lane(id).is_some_and(|lane| lane.kind == StripKind::Path));
    let way = if path { edge.line.part(KERB, edge.line.length() - KERB)? } else { edge.line.clone() };
    let [low, high] = way.bounds();
    let around = map.lanes_around(&nalgebra::center(&low, &high), (high - low).norm() / 2.0);
    let mut over = around.filter(|(id, _)| {
        map.lane(*id).is_some_and(|lane| {
            let level = map.road(lane.road).is_some_and(|road| levels.contains(&road.draft.layer));
            let drives = lane.users.has(Users::CAR) && !lane.users.has(Users::FOOT);
            // Around a dead end one walks along the end of its lanes.
            let inner = lane.line.part(END, lane.line.length() - END);
            drives && level && inner.is_some_and(|line| line.crosses(&way))
        })
    });
    over.next().map(|(id, _)| id)
}

/// Whether a crossing leads over a road, or past its end at the junction.
fn crosses(map: &StreetMap, crossing: &RoadCrossing, road: RoadId) -> bool {
    let Some(road) = map.road(road) else { return true };
    let end = if road.draft.from == crossing.junction { road.line.start() } else { road.line.end() };
    road.line.crosses(&crossing.line) || (crossing.line.project(&end).point - end).norm() < BESIDE
}

/// The crossings of the description over roads that no crossing of their junction leads over.
fn lost(map: &StreetMap) -> impl Iterator<Item = MapViolation> {
    let made = |at: JunctionId, road: RoadId| {
        let own = map.junction(at).into_iter().flat_map(|junction| &junction.crossings);
        let mut own = own.filter_map(|id| map.crossing(*id)).filter(|crossing| !crossing.guessed);
        own.any(|crossing| crossing.roads.contains(&road)) || (streets(map, at) <= 2 && has_crossing(map, at))
    };
    let given: std::collections::BTreeSet<_> = map.draft().crossings.iter().map(|c| (c.at, c.road)).collect();
    let lost = given.into_iter().filter(move |(at, road)| !made(*at, *road));
    lost.map(|(junction, road)| MapViolation::LostCrossing { junction, road })
}

/// The number of streets at a junction.
fn streets(map: &StreetMap, id: JunctionId) -> usize {
    let arms = map.junction(id).into_iter().flat_map(|junction| &junction.arms);
    arms.filter(|arm| map.road(arm.road).is_some_and(|road| road.draft.class.is_street())).count()
}

fn has_crossing(map: &StreetMap, id: JunctionId) -> bool {
    let own = map.junction(id).into_iter().flat_map(|junction| &junction.crossings);
    own.filter_map(|id| map.crossing(*id)).any(|crossing| !crossing.guessed)
}

/// The road within which a crossing begins or ends deepest, and how deep, metres.
fn ends_in(map: &StreetMap, crossing: &RoadCrossing) -> Option<(RoadId, f64)> {
    let ends = [crossing.line.start(), crossing.line.end()];
    let deep = |id: &RoadId| {
        let depths = ends.iter().filter_map(|end| map.road(*id)?.depth(end));
        depths.reduce(f64::max).map(|depth| (*id, depth))
    };
    crossing.roads.iter().filter_map(deep).max_by(|a, b| a.1.total_cmp(&b.1))
}

fn cut_off(map: &StreetMap) -> Vec<MapViolation> {
    map.walk_parts()
        .into_iter()
        .skip(1)
        .map(|(nodes, metres)| {
            let node = nodes.first().copied().unwrap_or(WalkNodeId(0));
            MapViolation::WalkCutOff { node, nodes: nodes.len(), metres }
        })
        .collect()
}

fn no_crossing(map: &StreetMap, id: JunctionId) -> Vec<MapViolation> {
    let Some(junction) = map.junction(id) else { return Vec::new() };
    let paved = |road: &crate::Road| {
        let sides = [true, false].map(|side| {
            road.draft.section.side(side).iter().any(|s| s.kind == StripKind::Pavement && s.users.has(Users::FOOT))
        });
        sides == [true; 2] && road.draft.class != RoadClass::Motorway
    };
    let crossed = |road| {
        let over = |id: &CrossingId| map.crossing(*id).is_some_and(|crossing| crossing.roads.contains(&road));
        junction.crossings.iter().any(over)
    };
    let alone = streets(map, id) <= 2;
    let lost = junction.arms.iter().filter(|arm| !alone && map.road(arm.road).is_some_and(paved) && !crossed(arm.road));
    let lost = lost.map(|arm| MapViolation::NoCrossing { junction: id, road: arm.road });
    lost.collect()
}

impl StreetMap {
    /// The parts of the walkable network that are not joined with each other, the longest first: nodes and metres. Costs one
    /// pass over the network.
    ///
    /// ```
    /// # use vc_map::{Control, CrossSection, MapDraft, RoadClass, Strip};
    /// # let mut draft = MapDraft::new("street", 48.1, 11.6);
    /// # let ends = [[0.0, 0.0], [100.0, 0.0]].map(|at| draft.junction(at, Control::Edge));
    /// # let side = vec![Strip::driving(3.0, 15.0), Strip::pavement(2.0)];
    /// # let section = CrossSection { forward: side.clone(), backward: side, median: 0.0 };
    /// # draft.road(ends[0], ends[1], RoadClass::Primary, section);
    /// # let map = draft.build()?; // a fast street of 100 m that leaves the map at both ends: nobody crosses it
    /// assert_eq!(map.walk_parts().iter().map(|(_, metres)| *metres).collect::<Vec<_>>(), [100.0, 100.0]);
    /// # Ok::<(), vc_map::MapError>(())
    /// ```
    pub fn walk_parts(&self) -> Vec<(Vec<WalkNodeId>, f64)> {
        let mut sets = UnionFind::<usize>::new(self.walk_nodes().len());
        for edge in self.walk_edges() {
            sets.union(edge.ends[0].index(), edge.ends[1].index());
        }
        let mut parts: std::collections::BTreeMap<usize, (Vec<WalkNodeId>, f64)> = std::collections::BTreeMap::new();
        for node in 0..self.walk_nodes().len() {
            parts.entry(sets.find_mut(node)).or_default().0.push(WalkNodeId::of(node));
        }
        for edge in self.walk_edges() {
            parts.entry(sets.find_mut(edge.ends[0].index())).or_default().1 += edge.line.length();
        }
        let mut parts: Vec<_> = parts.into_values().collect();
        parts.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
        parts
    }
}
