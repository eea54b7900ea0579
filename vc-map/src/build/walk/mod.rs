//! The walkable network: pavements and paths, joined at the corners of junctions and by crossings.

mod round;

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::Vector2;
use petgraph::unionfind::UnionFind;

use self::round::Pair;
use super::budget::Budget;
use super::crossing_rule::CrossingRule;
use crate::parts::{Arm, Junction, Lane, Movement, Road, RoadCrossing, WalkEdge, WalkKind, WalkNode};
use crate::{
    CrossingId, CrossingKind, JunctionId, LaneId, MapDraft, MapError, Point, Polyline, RoadClass, RoadId, StripKind,
    Users, WalkNodeId,
};

/// Widths of crossings at streets of a higher class and of a lower one, metres.
const WIDTHS: [f64; 2] = [4.0, 3.0];
/// A crossing begins this far from the junction, metres, and takes at most this part of a pavement.
const BEHIND: f64 = 1.0;
const LARGEST_PART: f64 = 0.4;
/// Nobody crosses without marks nearer than this to another crossing of the same road, metres.
const TWIN: f64 = 8.0;

pub(super) struct Network {
    pub(super) nodes: Vec<WalkNode>,
    pub(super) edges: Vec<WalkEdge>,
    pub(super) crossings: Vec<RoadCrossing>,
}

impl Network {
    /// Gives back the memory that its lists keep in reserve.
    pub(super) fn shrink(&mut self) {
        self.nodes.shrink_to_fit();
        self.edges.shrink_to_fit();
        self.crossings.shrink_to_fit();
    }
}

pub(super) fn network(
    draft: &MapDraft,
    junctions: &mut [Junction],
    (roads, lanes, movements): (&[Road], &[Lane], &[Movement]),
    budget: &mut Budget,
) -> Result<Network, MapError> {
    let net = Network { nodes: Vec::new(), edges: Vec::new(), crossings: Vec::new() };
    let rule = CrossingRule::new(draft);
    let mut walk =
        Walk { draft, roads, lanes, movements, unmarked: Vec::new(), through: Vec::new(), net, feet: Vec::new(), rule };
    for (index, junction) in junctions.iter_mut().enumerate() {
        let (id, edges, crossings) = (JunctionId::of(index), walk.net.edges.len(), walk.net.crossings.len());
        walk.junction(id, junction);
        budget.take(id, &walk.net.edges[edges..])?;
        budget.take(id, &walk.net.crossings[crossings..])?;
        budget.take_bytes(id, junction.crossings.capacity() * size_of::<CrossingId>())?;
    }
    let before = walk.net.crossings.len();
    walk.unmarked(junctions);
    budget.take("crossings without marks", &walk.net.crossings[before..])?;
    walk.along_roads(budget)?;
    let before = walk.net.edges.len();
    walk.through();
    budget.take("the walkable network", &walk.net.edges[before..])?;
    // The lists of edges at nodes, which have room for four when they begin.
    let lists = walk.net.nodes.len() * (size_of::<Vec<u32>>() + 16) + walk.net.edges.len() * 16;
    budget.take("the walkable network", &walk.net.nodes)?;
    budget.take_bytes("the walkable network", lists)?;
    Ok(walk.net)
}

/// The strip along a road on which one walks.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Footway {
    Lane(LaneId),
    Shared(RoadId),
}

/// The place of a node of the network: an end of a footway, or a ramp a little before it.
#[derive(Clone, Copy)]
struct Foot {
    way: Footway,
    /// Whether it is the start of the road's line.
    start: bool,
    /// The end of the footway.
    end: Point,
    /// How far it lies before the end, metres.
    back: f64,
}

struct Walk<'a> {
    draft: &'a MapDraft,
    roads: &'a [Road],
    lanes: &'a [Lane],
    movements: &'a [Movement],
    /// Guessed crossings without marks, with their widths, metres.
    unmarked: Vec<(JunctionId, Pair, f64)>,
    /// Corners that lead through junctions of several nodes, among those who drive there.
    through: Vec<([WalkNodeId; 2], JunctionId, [Point; 4])>,
    net: Network,
    /// The places of the nodes.
    feet: Vec<Foot>,
    rule: CrossingRule<'a>,
}

impl Walk<'_> {
    fn junction(&mut self, id: JunctionId, junction: &mut Junction) {
        let at = self.rule.at(id, junction);
        let mut pairs = self.pairs(id, junction);
        pairs.retain_mut(|pair| self.fits(id, junction, pair));
        let (corners, mut over): (Vec<Pair>, Vec<Pair>) = pairs.into_iter().partition(|pair| pair.over.is_empty());
        let ends = |pair: &Pair| (pair.ends[0].min(pair.ends[1]), pair.ends[0].max(pair.ends[1]));
        let round: BTreeSet<_> = corners.iter().map(ends).collect();
        // Those that the map has come first: where it has one, none is guessed between two roads, or beside it.
        over.sort_by_key(|pair| self.rule.given(&at, &pair.over).is_none());
        let mut joined = BTreeSet::new();
        over.retain(|pair| joined.insert(ends(pair)));
        let anywhere = over.iter().all(|pair| self.rule.given(&at, &pair.over).is_none());
        let mut through = anywhere.then(|| self.rule.through(&at, junction)).flatten();
        let mut chosen = Vec::new();
        for pair in over {
            let known = self.rule.given(&at, &pair.over).or_else(|| through.take());
            // Around a dead end one walks along its edge.
            let first = chosen.is_empty();
            let guess = !round.contains(&ends(&pair)) && self.leads_across(junction, &pair);
            let guessed = || guess.then(|| self.rule.guess(&at, &pair.over, first)).flatten();
            if let Some((kind, island)) = known.or_else(guessed) {
                let width = self.ramps(id, junction, &pair);
                chosen.push((pair, width, (kind, island, known.is_none())));
            }
        }
        // A ramp may be one of two crossings: their lines lead from where it stands in the end.
        for (pair, width, kind) in chosen {
            // Where people cross without marks they would not beside a crossing of the next junction.
            if kind == (CrossingKind::Unmarked, false, true) {
                self.unmarked.push((id, pair, width));
            } else {
                self.cross(id, junction, pair, width, kind);
            }
        }
        let mut joined = BTreeSet::new();
        for corner in corners.iter().filter(|pair| joined.insert(ends(pair))) {
            let [from, to] = corner.ends.map(|node| (self.net.nodes[node.index()].at, self.feet[node.index()].end));
            let points = [from.0, from.1, to.1, to.0];
            if self.is_wide(junction) && self.is_driven_over(junction, &points) {
                self.through.push((corner.ends, id, points));
            } else {
                self.link(corner.ends, WalkKind::Corner(id), &points);
            }
        }
    }

    /// Adds the crossings without marks that have no other beside them.
    fn unmarked(&mut self, junctions: &mut [Junction]) {
        let mut over: BTreeMap<RoadId, Vec<Point>> = BTreeMap::new();
        let middle = |line: &Polyline| line.at(line.length() / 2.0);
        for crossing in &self.net.crossings {
            crossing.roads.iter().for_each(|road| over.entry(*road).or_default().push(middle(&crossing.line)));
        }
        for (id, pair, width) in std::mem::take(&mut self.unmarked) {
            let [from, to] = pair.ends.map(|ramp| self.net.nodes[ramp.index()].at);
            let here = nalgebra::center(&from, &to);
            let beside =
                |road: &RoadId| over.get(road).is_some_and(|all| all.iter().any(|at| (at - here).norm() < TWIN));
            if !pair.over.iter().any(beside) {
                pair.over.iter().for_each(|road| over.entry(*road).or_default().push(here));
                self.cross(id, &mut junctions[id.index()], pair, width, (CrossingKind::Unmarked, false, true));
            }
        }
    }

    /// Adds those corners through junctions without which nobody would come from one of their ends to the other: pavements that
    /// are mapped apart mostly lead around.
    fn through(&mut self) {
        let mut parts = UnionFind::<usize>::new(self.net.nodes.len());
        self.net.edges.iter().for_each(|edge| _ = parts.union(edge.ends[0].index(), edge.ends[1].index()));
        for (ends, id, points) in std::mem::take(&mut self.through) {
            if parts.union(ends[0].index(), ends[1].index()) {
                self.link(ends, WalkKind::Corner(id), &points);
            }
        }
    }

    /// Whether cars drive over a way at a junction.
    fn is_driven_over(&self, junction: &Junction, way: &[Point]) -> bool {
        let movements = junction.movements.iter().map(|id| &self.movements[id.index()]);
        let mut cars = movements.filter(|movement| movement.users.has(Users::CAR));
        Polyline::new(way.iter().copied()).is_some_and(|way| cars.any(|movement| movement.line.crosses(&way)))
    }

    fn pavement(&self, road: RoadId, forward: bool) -> Option<LaneId> {
        let fits = |lane: &Lane| lane.forward == forward && lane.kind == StripKind::Pavement;
        self.roads[road.index()].lanes.iter().copied().find(|id| fits(&self.lanes[id.index()]))
    }

    /// The lane of a path on which people walk.
    fn walked(&self, road: RoadId) -> Option<LaneId> {
        self.roads[road.index()].lanes.iter().copied().find(|id| self.lanes[id.index()].users.has(Users::FOOT))
    }

    /// The line of a footway from the start of its road to the end.
    fn line(&self, way: Footway) -> Polyline {
        match way {
            Footway::Lane(id) => {
                let lane = &self.lanes[id.index()];
                if lane.forward { lane.line.clone() } else { lane.line.reversed() }
            }
            Footway::Shared(id) => self.roads[id.index()].middle(),
        }
    }

    /// The node at an end of a footway.
    fn end(&mut self, junction: JunctionId, arm: &Arm, way: Footway) -> WalkNodeId {
        let line = self.line(way);
        let at = if arm.start { line.start() } else { line.end() };
        self.net.nodes.push(WalkNode { at, junction });
        self.feet.push(Foot { way, start: arm.start, end: at, back: 0.0 });
        WalkNodeId::of(self.feet.len() - 1)
    }

    fn link(&mut self, ends: [WalkNodeId; 2], kind: WalkKind, points: &[Point]) {
        // Ends at one place are joined by an edge of a centimetre.
        let short = || Polyline::new([points[0], points[0] + Vector2::new(0.01, 0.0)]);
        let line = Polyline::new(points.iter().copied()).or_else(short);
        self.net.edges.extend(line.map(|line| WalkEdge { ends, kind, line, steps: false }));
    }

    /// Sets the ramps of a crossing along the pavements, and tells its width, metres.
    fn ramps(&mut self, id: JunctionId, junction: &Junction, Pair { ends, over, .. }: &Pair) -> f64 {
        let major = over.iter().any(|road| self.roads[road.index()].draft.class <= RoadClass::Secondary);
        let width = if major { WIDTHS[0] } else { WIDTHS[1] };
        if ends.iter().all(|node| self.is_pavement_of(*node, over)) && !self.is_mapped_at(id, junction, over) {
            ends.iter().for_each(|node| self.set_back(*node, BEHIND + width / 2.0));
        }
        width
    }

    fn cross(
        &mut self,
        id: JunctionId,
        junction: &mut Junction,
        Pair { ends, over: roads, via, .. }: Pair,
        width: f64,
        (kind, island, guessed): (CrossingKind, bool, bool),
    ) {
        let [from, to] = ends.map(|ramp| self.net.nodes[ramp.index()].at);
        let points: Vec<Point> = [Some(from), via, Some(to)].into_iter().flatten().collect();
        let Some(line) = Polyline::new(points.iter().copied()) else { return };
        let crossing = CrossingId::of(self.net.crossings.len());
        self.net.crossings.push(RoadCrossing { junction: id, roads, kind, island, line, width, ramps: ends, guessed });
        junction.crossings.push(crossing);
        self.link(ends, WalkKind::Crossing(crossing), &points);
    }

    /// Whether a node lies on a pavement of one of some roads.
    fn is_pavement_of(&self, node: WalkNodeId, roads: &[RoadId]) -> bool {
        let Footway::Lane(lane) = self.feet[node.index()].way else { return false };
        let lane = &self.lanes[lane.index()];
        lane.kind == StripKind::Pavement && roads.contains(&lane.road)
    }

    /// Moves a node from the end of its footway to a ramp along it, so that crossings lie outside the junction.
    fn set_back(&mut self, node: WalkNodeId, metres: f64) {
        let foot = self.feet[node.index()];
        let line = self.line(foot.way);
        let back = metres.min(line.length() * LARGEST_PART).max(foot.back);
        self.feet[node.index()].back = back;
        self.net.nodes[node.index()].at = line.at(if foot.start { back } else { line.length() - back });
    }

    /// An edge along each footway.
    fn along_roads(&mut self, budget: &mut Budget) -> Result<(), MapError> {
        let mut ends: BTreeMap<Footway, [Option<WalkNodeId>; 2]> = BTreeMap::new();
        for (node, foot) in self.feet.iter().enumerate() {
            ends.entry(foot.way).or_default()[usize::from(!foot.start)] = Some(WalkNodeId::of(node));
        }
        for (way, ends) in ends {
            let [Some(from), Some(to)] = ends else { continue };
            let line = self.line(way);
            let [start, end] = [from, to].map(|node| self.feet[node.index()].back);
            let line = line.part(start, line.length() - end).unwrap_or(line);
            let (kind, road) = match way {
                Footway::Lane(lane) => (WalkKind::Lane(lane), self.lanes[lane.index()].road),
                Footway::Shared(road) => (WalkKind::Shared(road), road),
            };
            let steps = self.roads[road.index()].draft.class == RoadClass::Steps;
            self.net.edges.push(WalkEdge { ends: [from, to], kind, line, steps });
            budget.take(road, &self.net.edges[self.net.edges.len() - 1..])?;
        }
        Ok(())
    }
}
