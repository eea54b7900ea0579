//! The walkable network: pavements and paths, joined at the corners of junctions and by crossings.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::Vector2;
use vc_graph::portable::Portable;

use super::budget::Budget;
use super::crossing_rule::CrossingRule;
use crate::parts::{Arm, Junction, Lane, Road, RoadCrossing, WalkEdge, WalkKind, WalkNode};
use crate::{
    Control, CrossingId, CrossingKind, DrivingSide, JunctionId, LaneId, MapDraft, MapError, Point, Polyline, RoadClass,
    RoadId, StripKind, Users, WalkNodeId,
};

/// Widths of crossings at streets of a higher class and of a lower one, metres.
const WIDTHS: [f64; 2] = [4.0, 3.0];
/// A crossing begins this far from the junction, metres, and takes at most this part of a pavement.
const BEHIND: f64 = 1.0;
const LARGEST_PART: f64 = 0.4;
/// The order of what leaves a junction is that on a circle so far outside of it, metres, found in so many steps.
const OUTSIDE: f64 = 6.0;
/// A crossing leads over a road, or comes so near to its end, metres; a corner that leads over one so far outside of the junction
/// is a crossing. Beyond this no way at a junction is looked for.
const BESIDE: f64 = 1.5;
const INSIDE: f64 = 0.5;
const REACH: f64 = 60.0;
/// Arms lie on each other if they leave in nearly one direction: its cosine, for 17 degrees.
const NEARLY: f64 = 0.955;
const STEPS: u32 = 64;

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
    roads: &[Road],
    lanes: &[Lane],
    budget: &mut Budget,
) -> Result<Network, MapError> {
    let net = Network { nodes: Vec::new(), edges: Vec::new(), crossings: Vec::new() };
    let rule = CrossingRule::new(draft);
    let mut walk = Walk { draft, roads, lanes, net, feet: Vec::new(), rule };
    for (index, junction) in junctions.iter_mut().enumerate() {
        let (id, edges, crossings) = (JunctionId::of(index), walk.net.edges.len(), walk.net.crossings.len());
        walk.junction(id, junction);
        budget.take(id, &walk.net.edges[edges..])?;
        budget.take(id, &walk.net.crossings[crossings..])?;
        budget.take_bytes(id, junction.crossings.capacity() * size_of::<CrossingId>())?;
    }
    walk.along_roads(budget)?;
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

/// Two ends of footways that follow each other around a junction, and the carriageways between them.
struct Pair {
    ends: [WalkNodeId; 2],
    over: Vec<RoadId>,
    /// The angle between their arms, counter-clockwise.
    angle: f64,
}

/// Met on a round about a junction: an end of a footway, or a carriageway.
enum Item {
    End(WalkNodeId),
    Carriageway(RoadId),
}

struct Walk<'a> {
    draft: &'a MapDraft,
    roads: &'a [Road],
    lanes: &'a [Lane],
    net: Network,
    /// The places of the nodes.
    feet: Vec<Foot>,
    rule: CrossingRule<'a>,
}

impl Walk<'_> {
    fn junction(&mut self, id: JunctionId, junction: &mut Junction) {
        let at = self.rule.at(id, junction);
        let mut pairs = self.pairs(id, junction);
        pairs.retain_mut(|pair| self.fits(junction, pair));
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
            let guessed = || (!round.contains(&ends(&pair))).then(|| self.rule.guess(&at, &pair.over, first)).flatten();
            if let Some((kind, island)) = known.or_else(guessed) {
                let width = self.ramps(&pair);
                chosen.push((pair, width, (kind, island, known.is_none())));
            }
        }
        // A ramp may be one of two crossings: their lines lead from where it stands in the end.
        for (pair, width, kind) in chosen {
            self.cross(id, junction, pair, width, kind);
        }
        let mut joined = BTreeSet::new();
        for corner in corners.iter().filter(|pair| joined.insert(ends(pair))) {
            let [from, to] = corner.ends.map(|node| (self.net.nodes[node.index()].at, self.feet[node.index()].end));
            self.link(corner.ends, WalkKind::Corner(id), [from.0, from.1, to.1, to.0]);
        }
    }

    /// Sets the roads over which the straight way between two ends leads, and tells whether it is one: where a street has a
    /// pavement on one side only, the way around its other side crosses nothing.
    fn fits(&self, junction: &Junction, pair: &mut Pair) -> bool {
        let [from, to] = pair.ends.map(|node| self.net.nodes[node.index()].at);
        let Some(way) = Polyline::new([from, to]) else { return pair.over.is_empty() };
        let corner = pair.over.is_empty();
        // Of roads that meet in one point the order around it tells what lies between; of several nodes it does not.
        if corner && !self.is_wide(junction) {
            return true;
        }
        let crossed = |arm: &&Arm| {
            let road = &self.roads[arm.road.index()];
            let carriageway = self.has_carriageway(arm.road);
            let expected = pair.over.contains(&arm.road);
            carriageway && crosses(road, arm.start, &way, expected)
        };
        pair.over = junction.arms.iter().filter(crossed).map(|arm| arm.road).collect();
        corner || !pair.over.is_empty()
    }

    /// Whether the roads of a junction begin at several points.
    fn is_wide(&self, junction: &Junction) -> bool {
        let begin = |arm: &Arm| {
            let line = &self.roads[arm.road.index()].line;
            if arm.start { line.start() } else { line.end() }
        };
        junction.arms.iter().any(|arm| (begin(arm) - junction.at).norm() > 1.0)
    }

    /// Whether a road has a carriageway on which people do not walk.
    fn has_carriageway(&self, id: RoadId) -> bool {
        let road = &self.roads[id.index()];
        let paved = [true, false].iter().any(|forward| self.pavement(id, *forward).is_some());
        let users = road.draft.section.users(true) | road.draft.section.users(false);
        let walked = !paved && users.has(Users::FOOT);
        !walked && (road.draft.class.is_street() || road.draft.class.is_rail())
    }

    /// The ends of footways around a junction, each with the next one. At the edge of the map nobody walks on its outside,
    /// which is where arms are farthest from each other.
    fn pairs(&mut self, id: JunctionId, junction: &Junction) -> Vec<Pair> {
        let items = self.around(id, junction);
        let ends: Vec<(usize, Vector2<f64>, WalkNodeId)> = items
            .iter()
            .enumerate()
            .filter_map(|(place, (away, item))| match item {
                Item::End(node) => Some((place, *away, *node)),
                Item::Carriageway(_) => None,
            })
            .collect();
        let mut pairs = Vec::new();
        for (position, (place, away, node)) in ends.iter().enumerate() {
            let (next, there, other) = ends[(position + 1) % ends.len()];
            let between = (place + 1..).map(|i| i % items.len()).take_while(|i| *i != next);
            let over: Vec<RoadId> = between
                .filter_map(|i| match items[i].1 {
                    Item::Carriageway(road) => Some(road),
                    Item::End(_) => None,
                })
                .collect();
            if *node != other {
                pairs.push(Pair { ends: [*node, other], over, angle: between_arms(away, &there) });
            }
        }
        if junction.draft.control == Control::Edge {
            let corners = pairs.iter().enumerate().filter(|(_, pair)| pair.over.is_empty());
            let outer = corners.max_by(|a, b| a.1.angle.total_cmp(&b.1.angle)).map(|(position, _)| position);
            outer.map(|position| pairs.remove(position));
        }
        pairs
    }

    /// The ends of footways and the carriageways around a junction, counter-clockwise. Where arms lie on each other or begin at
    /// several points, they come in the order in which they leave a circle around it: rails in a street between its pavements.
    fn around(&mut self, id: JunctionId, junction: &Junction) -> Vec<(Vector2<f64>, Item)> {
        let taken = |arm: &Arm| {
            let road = &self.roads[arm.road.index()];
            let cut = road.cuts[usize::from(!arm.start)];
            (road.line.at(if arm.start { cut } else { road.line.length() - cut }) - junction.at).norm()
        };
        let radius = junction.arms.iter().map(taken).fold(0.0, f64::max) + OUTSIDE;
        let mut items = Vec::new();
        for arm in &junction.arms {
            for item in self.items(id, arm) {
                let line = match &item {
                    Item::End(node) => self.line(self.feet[node.index()].way),
                    Item::Carriageway(road) => self.roads[road.index()].line.clone(),
                };
                let line = if arm.start { line } else { line.reversed() };
                items.push((leaves(&line, &junction.at, radius), arm.away, item));
            }
        }
        if self.is_wide(junction) || are_beside(&junction.arms) {
            let middle = junction.at;
            items.sort_by_cached_key(|(place, ..)| {
                let seen = place - middle;
                // The bits of an angle that is not negative are in its order.
                (seen.y.angle_to(seen.x) + std::f64::consts::TAU).to_bits()
            });
        }
        items.into_iter().map(|(_, away, item)| (away, item)).collect()
    }

    /// The ends of footways of an arm and its carriageway, counter-clockwise.
    fn items(&mut self, id: JunctionId, arm: &Arm) -> Vec<Item> {
        let road = &self.roads[arm.road.index()];
        let class = road.draft.class;
        let sides = [true, false].map(|forward| self.pavement(arm.road, forward));
        // Seen away from the junction, those who go along the line are on the right where one drives on the right.
        let right_first = (self.draft.side == DrivingSide::Right) == arm.start;
        let [right, left] = if right_first { sides } else { [sides[1], sides[0]] };
        let users = road.draft.section.users(true) | road.draft.section.users(false);
        let path = (!class.is_street()).then(|| self.walked(arm.road)).flatten();
        if let Some(lane) = path {
            return vec![Item::End(self.end(id, arm, Footway::Lane(lane)))];
        }
        if right.is_none() && left.is_none() && users.has(Users::FOOT) {
            return vec![Item::End(self.end(id, arm, Footway::Shared(arm.road)))];
        }
        let mut items = Vec::new();
        items.extend(right.map(|lane| Item::End(self.end(id, arm, Footway::Lane(lane)))));
        items.extend(self.has_carriageway(arm.road).then_some(Item::Carriageway(arm.road)));
        items.extend(left.map(|lane| Item::End(self.end(id, arm, Footway::Lane(lane)))));
        items
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

    fn link<const N: usize>(&mut self, ends: [WalkNodeId; 2], kind: WalkKind, points: [Point; N]) {
        // Ends at one place are joined by an edge of a centimetre.
        let short = || Polyline::new([points[0], points[0] + Vector2::new(0.01, 0.0)]);
        let line = Polyline::new(points).or_else(short);
        self.net.edges.extend(line.map(|line| WalkEdge { ends, kind, line, steps: false }));
    }

    /// Sets the ramps of a crossing along the pavements, and tells its width, metres.
    fn ramps(&mut self, Pair { ends, over, .. }: &Pair) -> f64 {
        let major = over.iter().any(|road| self.roads[road.index()].draft.class <= RoadClass::Secondary);
        let width = if major { WIDTHS[0] } else { WIDTHS[1] };
        if ends.iter().all(|node| self.is_pavement_of(*node, over)) {
            ends.iter().for_each(|node| self.set_back(*node, BEHIND + width / 2.0));
        }
        width
    }

    fn cross(
        &mut self,
        id: JunctionId,
        junction: &mut Junction,
        Pair { ends, over: roads, .. }: Pair,
        width: f64,
        (kind, island, guessed): (CrossingKind, bool, bool),
    ) {
        let [from, to] = ends.map(|ramp| self.net.nodes[ramp.index()].at);
        let Some(line) = Polyline::new([from, to]) else { return };
        let crossing = CrossingId::of(self.net.crossings.len());
        self.net.crossings.push(RoadCrossing { junction: id, roads, kind, island, line, width, ramps: ends, guessed });
        junction.crossings.push(crossing);
        self.link(ends, WalkKind::Crossing(crossing), [from, to]);
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

/// Whether a way leads over a road at a junction: one that is expected to anywhere along it or close to its end, another outside of
/// the junction.
fn crosses(road: &Road, start: bool, way: &Polyline, expected: bool) -> bool {
    let length = road.line.length();
    let (near, far) = (if expected { 0.0 } else { road.cuts[usize::from(!start)] + INSIDE }, REACH.min(length));
    let part = if start { road.line.part(near, far) } else { road.line.part(length - far, length - near) };
    let begin = if start { road.line.start() } else { road.line.end() };
    let touches = || expected && (way.project(&begin).point - begin).norm() < BESIDE;
    part.is_some_and(|part| part.crosses(way)) || touches()
}

/// Whether two neighbours of some arms leave in nearly one direction.
fn are_beside(arms: &[Arm]) -> bool {
    let next = arms.iter().cycle().skip(1);
    arms.len() > 1 && arms.iter().zip(next).any(|(a, b)| a.away.dot(&b.away) > NEARLY)
}

/// The point at which a line leaves a circle, or its end.
fn leaves(line: &Polyline, middle: &Point, radius: f64) -> Point {
    let outside = |station: &f64| (line.at(*station) - middle).norm() >= radius;
    let steps = (0..=STEPS).map(|step| radius * 2.0 * f64::from(step) / f64::from(STEPS));
    line.at(steps.take_while(|station| *station < line.length()).find(outside).unwrap_or(line.length()))
}

/// The angle from one arm to another, counter-clockwise; a whole turn from an arm to itself.
fn between_arms(from: &Vector2<f64>, to: &Vector2<f64>) -> f64 {
    let angle = from.perp(to).angle_to(from.dot(to));
    if angle > 0.0 { angle } else { angle + std::f64::consts::TAU }
}
