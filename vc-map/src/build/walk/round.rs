//! Whatever lies around a junction for those who walk: ends of footways and carriageways, and which of them follow each other.

use nalgebra::Vector2;
use vc_graph::portable::Portable;

use super::{Footway, Walk};
use crate::build::crossing_rule::begins_at_crossing;
use crate::parts::{Arm, Junction, Road};
use crate::{Control, DrivingSide, JunctionId, Point, Polyline, RoadId, Users, WalkNodeId};

/// The order of what leaves a junction is that on a circle so far outside of it, metres, found in so many steps.
const OUTSIDE: f64 = 6.0;
const STEPS: u32 = 64;
/// A crossing leads over a road, or comes so near to its end, metres; a corner that leads over one so far outside of the junction
/// is a crossing. Beyond this no way at a junction is looked for.
const BESIDE: f64 = 1.5;
/// Paths from a point of a street lead over it there, though the straight way between their kerbs passes so far beside, metres.
const BENT: f64 = 8.0;
const SAME: f64 = 1.0;
/// A crossing bends where the straight way passes the point by more than this, metres.
const STRAIGHT: f64 = 0.5;
const INSIDE: f64 = 0.5;
const REACH: f64 = 60.0;
/// A guessed crossing leads across its roads: the cosine of its angle to them is at most this, for 45 degrees, and it is at most
/// so many times as long as they are wide, and so much longer, metres.
const ALONG: f64 = 0.71;
const LONGER: f64 = 1.5;
const LONGER_BY: f64 = 4.0;
/// Arms lie on each other if they leave in nearly one direction: its cosine, for 17 degrees.
const NEARLY: f64 = 0.955;

/// Two ends of footways that follow each other around a junction, and the carriageways between them.
pub(super) struct Pair {
    pub(super) ends: [WalkNodeId; 2],
    pub(super) over: Vec<RoadId>,
    /// The point of a street from which both their paths lead, if the straight way passes beside it.
    pub(super) via: Option<Point>,
    /// The angle between their arms, counter-clockwise.
    angle: f64,
}

/// Met on a round about a junction: an end of a footway, or a carriageway.
enum Item {
    End(WalkNodeId),
    Carriageway(RoadId),
}

impl Walk<'_> {
    /// Sets the roads over which the straight way between two ends leads, and tells whether it is one: where a street has a
    /// pavement on one side only, the way around its other side crosses nothing.
    pub(super) fn fits(&self, id: JunctionId, junction: &Junction, pair: &mut Pair) -> bool {
        let [from, to] = pair.ends.map(|node| self.net.nodes[node.index()].at);
        let Some(way) = Polyline::new([from, to]) else { return pair.over.is_empty() };
        let corner = pair.over.is_empty();
        // Where roads meet in one point their order around it tells what lies between, and at several nodes it does not.
        if corner && !self.is_wide(junction) {
            return true;
        }
        let crossed = |arm: &&Arm| {
            let road = &self.roads[arm.road.index()];
            let expected = pair.over.contains(&arm.road);
            let beside = || if self.leads_from(pair, arm) { BENT } else { BESIDE };
            let carriageway = self.has_carriageway(arm.road) || (expected && self.rule.is_given(id, arm.road));
            carriageway && crosses(road, arm.start, &way, expected.then(beside))
        };
        let over: Vec<&Arm> = junction.arms.iter().filter(crossed).collect();
        let away = |point: &Point| (way.project(point).point - point).norm();
        let mut from = over.iter().filter(|arm| self.leads_from(pair, arm)).map(|arm| self.begin(arm));
        let via = from.find(|begin| away(begin) > STRAIGHT);
        (pair.over, pair.via) = (over.into_iter().map(|arm| arm.road).collect(), via);
        corner || !pair.over.is_empty()
    }

    /// Whether the map has a crossing where one of some roads begins.
    pub(super) fn is_mapped_at(&self, id: JunctionId, junction: &Junction, roads: &[RoadId]) -> bool {
        let street = |arm: &&Arm| self.roads[arm.road.index()].draft.class.is_street();
        let streets = junction.arms.iter().filter(street).count();
        let begins = |arm: &Arm| begins_at_crossing(&self.begin(arm), &junction.at, streets);
        let own = junction.arms.iter().filter(|arm| roads.contains(&arm.road) && self.rule.is_given(id, arm.road));
        own.into_iter().any(begins)
    }

    /// Whether both ends are those of paths from the point where an arm begins.
    fn leads_from(&self, pair: &Pair, arm: &Arm) -> bool {
        pair.ends.iter().all(|node| self.is_path_from(*node, &self.begin(arm)))
    }

    /// Whether a node is an end of a path.
    fn is_path(&self, node: WalkNodeId) -> bool {
        let Footway::Lane(lane) = self.feet[node.index()].way else { return false };
        !self.roads[self.lanes[lane.index()].road.index()].draft.class.is_street()
    }

    /// Whether a node is the end of a path that begins at a point.
    fn is_path_from(&self, node: WalkNodeId, begin: &Point) -> bool {
        let foot = &self.feet[node.index()];
        let Footway::Lane(lane) = foot.way else { return false };
        let road = &self.roads[self.lanes[lane.index()].road.index()];
        let from = if foot.start { road.line.start() } else { road.line.end() };
        !road.draft.class.is_street() && (from - begin).norm() < SAME
    }

    /// Whether a way leads across its roads rather than along them, from edge to edge, and is not much longer than they are wide. Over
    /// rails one goes as the street does.
    pub(super) fn leads_across(&self, junction: &Junction, pair: &Pair) -> bool {
        if pair.over.iter().all(|road| self.roads[road.index()].draft.class.is_rail()) {
            return true;
        }
        let [from, to] = pair.ends.map(|node| self.net.nodes[node.index()].at);
        let way = to - from;
        let crossed = || junction.arms.iter().filter(|arm| pair.over.contains(&arm.road));
        let begins: Vec<Point> = crossed().map(|arm| self.begin(arm)).collect();
        let apart = begins.iter().flat_map(|a| begins.iter().map(move |b| (a - b).norm())).fold(0.0, f64::max);
        let width: f64 = crossed().map(|arm| self.roads[arm.road.index()].draft.section.width()).sum();
        let mean: Vector2<f64> = crossed().map(|arm| arm.away).sum();
        let along = way.dot(&mean.try_normalize(0.1).unwrap_or_else(Vector2::zeros)).abs();
        let within = |arm: &Arm| [from, to].iter().any(|end| self.roads[arm.road.index()].depth(end).is_some());
        along <= way.norm() * ALONG && way.norm() <= LONGER * (width + apart) + LONGER_BY && !crossed().any(within)
    }

    /// The point at which the line of an arm begins.
    fn begin(&self, arm: &Arm) -> Point {
        let line = &self.roads[arm.road.index()].line;
        if arm.start { line.start() } else { line.end() }
    }

    /// Whether the roads of a junction begin at several points.
    pub(super) fn is_wide(&self, junction: &Junction) -> bool {
        junction.arms.iter().any(|arm| (self.begin(arm) - junction.at).norm() > 1.0)
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
    pub(super) fn pairs(&mut self, id: JunctionId, junction: &Junction) -> Vec<Pair> {
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
                pairs.push(Pair { ends: [*node, other], over, via: None, angle: between_arms(away, &there) });
            }
        }
        // Where people walk in a street, and the map has a crossing, one crosses there, too.
        for (position, (_, away, node)) in ends.iter().enumerate() {
            let Footway::Shared(road) = self.feet[node.index()].way else { continue };
            let around = [ends.len() - 1, 1].map(|step| ends[(position + step) % ends.len()]);
            let paths = around.iter().all(|(_, _, end)| self.is_path(*end)) && around[0].0 != around[1].0;
            if paths && self.rule.is_given(id, road) {
                let [from, to] = around;
                pairs.push(Pair {
                    ends: [from.2, to.2],
                    over: vec![road],
                    via: None,
                    angle: between_arms(&from.1, away),
                });
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
}

/// Whether a way leads over a road at a junction: one that is expected to anywhere along it or so close to its end, another outside
/// of the junction.
fn crosses(road: &Road, start: bool, way: &Polyline, expected: Option<f64>) -> bool {
    let length = road.line.length();
    let near = if expected.is_some() { 0.0 } else { road.cuts[usize::from(!start)] + INSIDE };
    let far = REACH.min(length);
    let part = if start { road.line.part(near, far) } else { road.line.part(length - far, length - near) };
    let begin = if start { road.line.start() } else { road.line.end() };
    let touches = |away: f64| (way.project(&begin).point - begin).norm() < away;
    part.is_some_and(|part| part.crosses(way)) || expected.is_some_and(touches)
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
