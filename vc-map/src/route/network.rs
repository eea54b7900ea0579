//! The ground that a mode travels on: sides of roads, or the walkable network.

use std::collections::BTreeMap;

use super::graph::{Cost, Graph};
use super::{Leg, Mode, Route};
use crate::parts::{Lane, Movement};
use crate::{Control, CrossingKind, Light, Point, Polyline, RoadId, SignKind, StreetMap, Users, WalkEdgeId, WalkKind};

/// Speeds on foot and by bicycle, metres per second.
const WALKING: f64 = 1.34;
const CYCLING: f64 = 5.0;
/// The time that a turn over the other side of the road takes, and a crossing without lights, seconds.
const TURNING: f64 = 5.0;
const CROSSING: f64 = 3.0;
/// How much longer steps take than level ground.
const STEPS: f64 = 1.6;
/// The time that one would rather lose than drive through where only those may go who have something to do there, seconds.
/// Whoever ends there enters once on every way.
const ENTERING: f64 = 600.0;

/// A place on an item of the ground: a side of a road or an edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Place {
    pub(super) item: usize,
    pub(super) station: f64,
}

/// The items on which a mode travels. By vehicle a node of the graph is the end of an item; on foot nodes are those of the
/// walkable network.
#[derive(Debug)]
pub(super) enum Ground {
    Sides { users: Users, sides: Vec<Side>, of: BTreeMap<(RoadId, bool), usize> },
    Edges { ends: Vec<[u32; 2]>, lengths: Vec<f64>, costs: Vec<Cost> },
}

/// A side of a road with a lane for the mode.
#[derive(Debug)]
pub(super) struct Side {
    road: RoadId,
    forward: bool,
    length: f64,
    speed: f64,
    line: Polyline,
    /// Whether one drives through.
    open: bool,
}

fn cost(seconds: f64) -> Cost {
    (seconds * 1000.0).clamp(0.0, 1e9) as Cost
}

pub(super) fn network(map: &StreetMap, mode: Mode) -> (Ground, Graph) {
    match mode {
        Mode::Foot => walking(map, |_| 0.0),
        Mode::Car => driving(map, Users::CAR),
        Mode::Bicycle => driving(map, Users::BICYCLE),
    }
}

fn driving(map: &StreetMap, users: Users) -> (Ground, Graph) {
    let (sides, of) = sides(map, users);
    let mut edges = Vec::new();
    let rows = map.junctions().iter().flat_map(|junction| junction.movements.iter().enumerate());
    for (row, movement) in rows.filter_map(|(row, id)| Some((row, map.movement(*id)?))) {
        let side = |lane| map.lane(lane).and_then(|lane| of.get(&(lane.road, lane.forward)).copied());
        let (Some(from), Some(to)) = (side(movement.from), side(movement.to)) else { continue };
        if movement.users.has(users) {
            let metres = movement.line.length() + sides[to].length;
            let seconds = metres / sides[to].speed + waiting(map, movement, row) + entering(&sides[from], &sides[to]);
            edges.push((from as u32, to as u32, cost(seconds)));
        }
    }
    let places: Vec<Point> = sides.iter().map(|side| side.line.end()).collect();
    (Ground::Sides { users, sides, of }, Graph::new(&places, edges))
}

/// The sides of roads with a lane for some users, and their positions.
fn sides(map: &StreetMap, users: Users) -> (Vec<Side>, BTreeMap<(RoadId, bool), usize>) {
    let (mut sides, mut of): (Vec<Side>, _) = (Vec::new(), BTreeMap::new());
    for lane in map.lanes().iter().filter(|lane| lane.users.has(users)) {
        let speed = if users == Users::BICYCLE { CYCLING.min(lane.limit) } else { lane.limit };
        let through = |road: &crate::RoadDraft| !road.private && (users == Users::BICYCLE || road.class.is_through());
        let index = *of.entry((lane.road, lane.forward)).or_insert_with(|| {
            let open = map.road(lane.road).is_some_and(|road| through(&road.draft));
            let (road, forward, line) = (lane.road, lane.forward, lane.line.clone());
            sides.push(Side { road, forward, length: line.length(), speed, line, open });
            sides.len() - 1
        });
        // The outermost lane stands for its side.
        let side = &mut sides[index];
        (side.speed, side.line, side.length) = (side.speed.max(speed), lane.line.clone(), lane.line.length());
    }
    (sides, of)
}

/// The time that entering a side is taken to cost.
fn entering(from: &Side, to: &Side) -> f64 {
    if from.open && !to.open { ENTERING } else { 0.0 }
}

/// The time that one loses at a junction: half of red, and turning over the other side.
fn waiting(map: &StreetMap, movement: &Movement, row: usize) -> f64 {
    let junction = map.junction(movement.junction);
    let red = half_red(map, movement.junction, row);
    let sign = map.lane(movement.from).is_some_and(|lane| lane.sign == Some(SignKind::Stop));
    let stop = sign || junction.is_some_and(|junction| junction.draft.control == Control::AllWayStop);
    let turning = if movement.turn.crosses_divider(map.side()) { TURNING } else { 0.0 };
    red + turning + if stop { CROSSING } else { 0.0 }
}

/// Half the time for which a row of a signal has red.
fn half_red(map: &StreetMap, junction: crate::JunctionId, row: usize) -> f64 {
    let signal = map.junction(junction).and_then(|junction| junction.signal).and_then(|id| map.signal(id));
    let red = |light: Option<&Light>| matches!(light, Some(Light::Red | Light::Yellow));
    signal.map_or(0.0, |signal| {
        signal.phases.iter().filter(|phase| red(phase.lights.get(row))).map(|phase| phase.seconds).sum::<f64>() / 2.0
    })
}

/// The walkable network, of which some edges seem longer by some seconds.
pub(super) fn walking(map: &StreetMap, longer: impl Fn(WalkEdgeId) -> f64) -> (Ground, Graph) {
    let edges = map.walk_edges();
    let costs: Vec<Cost> = edges
        .iter()
        .enumerate()
        .map(|(number, edge)| {
            let pace = if edge.steps { STEPS } else { 1.0 };
            let wait = match edge.kind {
                WalkKind::Crossing(id) => {
                    map.crossing(id).map_or(0.0, |crossing| match (crossing.kind, map.junction(crossing.junction)) {
                        (CrossingKind::Signals, Some(junction)) => {
                            let position = junction.crossings.iter().position(|other| *other == id).unwrap_or(0);
                            half_red(map, crossing.junction, junction.movements.len() + position)
                        }
                        _ => CROSSING,
                    })
                }
                _ => 0.0,
            };
            cost(edge.line.length() * pace / WALKING + wait + longer(WalkEdgeId::of(number)))
        })
        .collect();
    let ends: Vec<[u32; 2]> = edges.iter().map(|edge| edge.ends.map(|node| node.0)).collect();
    let both = ends.iter().zip(&costs).flat_map(|([a, b], cost)| [(*a, *b, *cost), (*b, *a, *cost)]).collect();
    let places: Vec<Point> = map.walk_nodes().iter().map(|node| node.at).collect();
    let lengths = edges.iter().map(|edge| edge.line.length()).collect();
    (Ground::Edges { ends, lengths, costs }, Graph::new(&places, both))
}

impl Ground {
    /// The place of the ground that is nearest to a point.
    pub(super) fn near(&self, map: &StreetMap, point: &Point, within: f64) -> Option<Place> {
        match self {
            Self::Sides { users, sides, of } => {
                let (lane, _) = map.lane_near(point, *users, within)?;
                let item = map.lane(lane).and_then(|lane: &Lane| of.get(&(lane.road, lane.forward)).copied())?;
                Some(Place { item, station: sides[item].line.project(point).station })
            }
            Self::Edges { .. } => {
                map.pavement_near(point, within).map(|(edge, station)| Place { item: edge.index(), station })
            }
        }
    }

    /// The same place of a road on its other side, if one drives there.
    pub(super) fn opposite(&self, place: &Place) -> Option<Place> {
        let Self::Sides { sides, of, .. } = self else { return None };
        let side = &sides[place.item];
        let item = *of.get(&(side.road, !side.forward))?;
        Some(Place { item, station: sides[item].line.project(&side.line.at(place.station)).station })
    }

    /// The cost of going along one item, if both places lie on it one after the other.
    pub(super) fn direct(&self, start: &Place, end: &Place) -> Option<Cost> {
        let ahead = end.station - start.station;
        match self {
            Self::Sides { sides, .. } if start.item == end.item && ahead >= 0.0 => {
                Some(cost(ahead / sides[start.item].speed))
            }
            Self::Edges { .. } if start.item == end.item => Some(self.part(start.item, ahead.abs())),
            _ => None,
        }
    }

    /// The cost of a part of an edge.
    fn part(&self, item: usize, metres: f64) -> Cost {
        match self {
            Self::Edges { lengths, costs, .. } => {
                (f64::from(costs[item]) * (metres / lengths[item].max(1e-6)).min(1.0)) as Cost
            }
            Self::Sides { sides, .. } => cost(metres / sides[item].speed),
        }
    }

    /// The nodes that one reaches first, with their costs.
    pub(super) fn starts(&self, place: &Place) -> Vec<(u32, Cost)> {
        match self {
            Self::Sides { sides, .. } => {
                vec![(place.item as u32, self.part(place.item, (sides[place.item].length - place.station).max(0.0)))]
            }
            Self::Edges { .. } => self.ends(place),
        }
    }

    /// The nodes before a place, with the cost from there. The end of a side lies behind the place: its cost has to be one
    /// that is not negative, so that the nodes are those from which one comes.
    pub(super) fn ends(&self, place: &Place) -> Vec<(u32, Cost)> {
        match self {
            Self::Sides { .. } => vec![(place.item as u32, 0)],
            Self::Edges { ends, lengths, .. } => {
                let [first, second] = ends[place.item];
                let rest = lengths[place.item] - place.station;
                vec![(first, self.part(place.item, place.station)), (second, self.part(place.item, rest))]
            }
        }
    }

    /// The route over some nodes.
    pub(super) fn route(
        &self,
        map: &StreetMap,
        start: Place,
        end: Place,
        (cost, nodes): (Cost, Vec<u32>),
        doors: [Option<Point>; 2],
    ) -> Option<Route> {
        let mut way = Way { line: doors[0].into_iter().collect(), legs: Vec::new() };
        let seconds = f64::from(cost) / 1000.0;
        let seconds = match self {
            Self::Sides { sides, .. } => seconds - way.drive(sides, start, end, &nodes),
            Self::Edges { costs, .. } => {
                way.walk(map, costs, start, end, &nodes);
                seconds
            }
        };
        let Way { mut line, legs } = way;
        line.extend(doors[1]);
        let at = line.first().copied()?;
        // Start and end may be one place.
        let line = Polyline::new(line).or_else(|| Polyline::new([at, at + nalgebra::Vector2::new(0.01, 0.0)]))?;
        Some(Route { legs, metres: line.length(), line, seconds: seconds.max(0.0) })
    }
}

/// A way that is put together.
struct Way {
    line: Vec<Point>,
    legs: Vec<Leg>,
}

impl Way {
    /// Adds a part of a line, backward if it ends before it begins.
    fn push(&mut self, of: &Polyline, from: f64, to: f64) {
        match of.part(from.min(to), from.max(to)) {
            Some(part) if from <= to => self.line.extend(part.points()),
            Some(part) => self.line.extend(part.points().iter().rev()),
            None => self.line.push(of.at(to)),
        }
    }

    /// Adds the sides of roads, and tells how many seconds of the cost are none of the way's time: those behind the end, and
    /// those for entering.
    fn drive(&mut self, sides: &[Side], start: Place, end: Place, nodes: &[u32]) -> f64 {
        let items: Vec<usize> =
            if nodes.is_empty() { vec![start.item] } else { nodes.iter().map(|node| *node as usize).collect() };
        for (index, item) in items.iter().enumerate() {
            let side = &sides[*item];
            let from = if index == 0 { start.station } else { 0.0 };
            let to = if index + 1 == items.len() { end.station } else { side.length };
            self.legs.push(Leg::Road(side.road, side.forward));
            self.push(&side.line, from, to);
        }
        let last = &sides[end.item];
        let behind = if nodes.is_empty() { 0.0 } else { (last.length - end.station).max(0.0) / last.speed };
        behind + items.windows(2).map(|pair| entering(&sides[pair[0]], &sides[pair[1]])).sum::<f64>()
    }

    /// Adds the edges between some nodes: the fastest of those that join two.
    fn walk(&mut self, map: &StreetMap, costs: &[Cost], start: Place, end: Place, nodes: &[u32]) {
        let edges = map.walk_edges();
        let mut along = |item: usize, from: f64, to: f64| {
            // Whoever starts or ends at a node goes along one edge less.
            if from == to && !nodes.is_empty() {
                return self.push(&edges[item].line, from, to);
            }
            self.legs.push(Leg::Walk(WalkEdgeId::of(item), from <= to));
            self.push(&edges[item].line, from, to);
        };
        let (Some(first), Some(last)) = (nodes.first(), nodes.last()) else {
            return along(start.item, start.station, end.station);
        };
        let at = |item: usize, node: u32| if edges[item].ends[0].0 == node { 0.0 } else { edges[item].line.length() };
        along(start.item, start.station, at(start.item, *first));
        for pair in nodes.windows(2) {
            let joins = |id: &&WalkEdgeId| edges[id.index()].ends.iter().any(|node| node.0 == pair[1]);
            let between = map.walk_edges_at(crate::WalkNodeId(pair[0])).iter().filter(joins);
            if let Some(id) = between.min_by_key(|id| (costs[id.index()], **id)) {
                along(id.index(), at(id.index(), pair[0]), at(id.index(), pair[1]));
            }
        }
        along(end.item, at(end.item, *last), end.station);
    }
}
