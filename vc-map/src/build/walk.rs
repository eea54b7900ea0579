//! The walkable network: pavements and paths, joined at the corners of junctions and by crossings.

use std::collections::{BTreeMap, BTreeSet};

use crate::parts::{Arm, Junction, Lane, Road, RoadCrossing, WalkEdge, WalkKind, WalkNode};
use crate::{
    Control, CrossingId, CrossingKind, DrivingSide, JunctionId, LaneId, MapDraft, Polyline, RoadClass, RoadId,
    StripKind, Users, WalkNodeId,
};

/// Widths of crossings at streets of a higher class and of a lower one, metres.
const WIDTHS: [f64; 2] = [4.0, 3.0];
/// Vehicles stop this far before a crossing, and before the junction itself where there is none, metres.
const STOP: [f64; 2] = [1.5, 1.0];
/// People cross without marks where the carriageway is narrower than this, metres, and the limit lower, metres per second.
const NARROW: f64 = 12.0;
const SLOW: f64 = 14.0;

pub(super) struct Network {
    pub(super) nodes: Vec<WalkNode>,
    pub(super) edges: Vec<WalkEdge>,
    pub(super) crossings: Vec<RoadCrossing>,
}

pub(super) fn network(draft: &MapDraft, junctions: &mut [Junction], roads: &[Road], lanes: &mut [Lane]) -> Network {
    let mut walk = Walk {
        draft,
        roads,
        lanes,
        net: Network { nodes: Vec::new(), edges: Vec::new(), crossings: Vec::new() },
        ends: BTreeMap::new(),
        given: BTreeMap::new(),
    };
    for crossing in &draft.crossings {
        let kind = walk.given.entry((crossing.at, crossing.road)).or_insert((crossing.kind, crossing.island));
        *kind = (kind.0.min(crossing.kind), kind.1 || crossing.island);
    }
    for (index, junction) in junctions.iter_mut().enumerate() {
        walk.junction(JunctionId::of(index), junction);
    }
    walk.along_roads();
    walk.net
}

/// The ground on which one walks along a road.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Ground {
    Lane(LaneId),
    Shared(RoadId),
}

/// Met on a round about a junction: an end of walkable ground, or a carriageway.
enum Item {
    End(WalkNodeId),
    Carriageway(RoadId),
}

/// The facts that decide on crossings at a junction.
struct At {
    id: JunctionId,
    control: Control,
    /// The number of its streets, and whether paths end there.
    streets: usize,
    paths: bool,
}

struct Walk<'a> {
    draft: &'a MapDraft,
    roads: &'a [Road],
    lanes: &'a mut [Lane],
    net: Network,
    /// The nodes at the ends of walkable ground, by whether it is the start of the road.
    ends: BTreeMap<(Ground, bool), WalkNodeId>,
    given: BTreeMap<(JunctionId, RoadId), (CrossingKind, bool)>,
}

impl Walk<'_> {
    fn junction(&mut self, id: JunctionId, junction: &mut Junction) {
        let arms = junction.arms.clone();
        let items: Vec<Item> = arms.iter().flat_map(|arm| self.items(id, arm)).collect();
        let classes = || arms.iter().map(|arm| self.roads[arm.road.index()].draft.class);
        let streets = classes().filter(|class| class.is_street()).count();
        let paths = classes().any(|class| !class.is_street() && !class.is_rail());
        let at = At { id, control: junction.draft.control, streets, paths };
        let ends: Vec<usize> = (0..items.len()).filter(|i| matches!(items[*i], Item::End(_))).collect();
        let mut joined = BTreeSet::new();
        let mut guessed = 0;
        for (position, first) in ends.iter().enumerate() {
            let next = ends[(position + 1) % ends.len()];
            let (Item::End(from), Item::End(to)) = (&items[*first], &items[next]) else { continue };
            let between = (first + 1..).map(|i| i % items.len()).take_while(|i| *i != next);
            let over: Vec<RoadId> = between
                .filter_map(|i| match items[i] {
                    Item::Carriageway(road) => Some(road),
                    Item::End(_) => None,
                })
                .collect();
            let open_end = junction.draft.control == Control::Edge && position + 1 == ends.len();
            if from == to || open_end || !joined.insert((*from.min(to), *from.max(to), over.is_empty())) {
                continue;
            }
            if over.is_empty() {
                self.link([*from, *to], WalkKind::Corner(id));
            } else if let Some((kind, island, given)) = self.kind(&at, &over, guessed) {
                guessed += usize::from(!given);
                self.cross(id, junction, [*from, *to], over, (kind, island, !given));
            }
        }
        self.stop_lines(junction);
    }

    /// The end or ends of walkable ground of an arm and its carriageway, counter-clockwise.
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
            return vec![Item::End(self.end(id, arm, Ground::Lane(lane)))];
        }
        if right.is_none() && left.is_none() && users.has(Users::FOOT) {
            return vec![Item::End(self.end(id, arm, Ground::Shared(arm.road)))];
        }
        let mut items = Vec::new();
        items.extend(right.map(|lane| Item::End(self.end(id, arm, Ground::Lane(lane)))));
        if class.is_street() || class.is_rail() {
            items.push(Item::Carriageway(arm.road));
        }
        items.extend(left.map(|lane| Item::End(self.end(id, arm, Ground::Lane(lane)))));
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

    fn ground(&self, ground: Ground) -> (Polyline, bool) {
        match ground {
            Ground::Lane(id) => (self.lanes[id.index()].line.clone(), self.lanes[id.index()].forward),
            Ground::Shared(id) => {
                let road = &self.roads[id.index()];
                let line = road.line.part(road.cuts[0], road.line.length() - road.cuts[1]);
                (line.unwrap_or_else(|| road.line.clone()), true)
            }
        }
    }

    /// The node at an end of walkable ground.
    fn end(&mut self, junction: JunctionId, arm: &Arm, ground: Ground) -> WalkNodeId {
        let (line, forward) = self.ground(ground);
        let at = if forward == arm.start { line.start() } else { line.end() };
        let id = WalkNodeId::of(self.net.nodes.len());
        self.net.nodes.push(WalkNode { at, junction });
        self.ends.insert((ground, arm.start), id);
        id
    }

    fn link(&mut self, ends: [WalkNodeId; 2], kind: WalkKind) {
        let [from, to] = ends.map(|id| self.net.nodes[id.index()].at);
        // Ends at one place are joined by an edge of a centimetre.
        let line =
            Polyline::new([from, to]).or_else(|| Polyline::new([from, from + nalgebra::Vector2::new(0.01, 0.0)]));
        self.net.edges.extend(line.map(|line| WalkEdge { ends, kind, line, steps: false }));
    }

    /// How one crosses some roads here: as the map says, else by rule, or not at all.
    fn kind(&self, at: &At, over: &[RoadId], guessed: usize) -> Option<(CrossingKind, bool, bool)> {
        let At { id, control, streets, paths } = *at;
        let given = over.iter().filter_map(|road| self.given.get(&(id, *road))).min();
        if let Some((kind, island)) = given {
            let lights = control == Control::Signals && *kind != CrossingKind::Unmarked;
            return Some((if lights { CrossingKind::Signals } else { *kind }, *island, true));
        }
        let roads = || over.iter().map(|road| &self.roads[road.index()].draft);
        let banned = roads().any(|road| road.class == RoadClass::Motorway);
        let only_rail = roads().all(|road| road.class.is_rail());
        if control == Control::Signals && streets > 2 && !banned {
            return Some((CrossingKind::Signals, false, false));
        }
        let width: f64 = roads().map(|road| road.section.carriageway(true) + road.section.carriageway(false)).sum();
        let fast = roads().flat_map(|road| road.section.strips()).any(|(_, strip)| strip.limit > SLOW);
        let easy = width < NARROW && (only_rail || !fast) && !banned;
        let enough = streets <= 2 && guessed > 0 && !only_rail;
        // Where two streets only meet end to end, people do not cross for that.
        let asked = streets != 2 || paths || only_rail;
        (easy && !enough && asked).then_some((CrossingKind::Unmarked, false, false))
    }

    fn cross(
        &mut self,
        id: JunctionId,
        junction: &mut Junction,
        ramps: [WalkNodeId; 2],
        roads: Vec<RoadId>,
        (kind, island, guessed): (CrossingKind, bool, bool),
    ) {
        let crossing = CrossingId::of(self.net.crossings.len());
        let [from, to] = ramps.map(|ramp| self.net.nodes[ramp.index()].at);
        let Some(line) = Polyline::new([from, to]) else { return };
        let major = roads.iter().any(|road| self.roads[road.index()].draft.class <= RoadClass::Secondary);
        let width = if major { WIDTHS[0] } else { WIDTHS[1] };
        self.net.crossings.push(RoadCrossing { junction: id, roads, kind, island, line, width, ramps, guessed });
        junction.crossings.push(crossing);
        self.link(ramps, WalkKind::Crossing(crossing));
    }

    /// Stop lines of the lanes that end at a junction: before its crossings, and at lights.
    fn stop_lines(&mut self, junction: &Junction) {
        for arm in &junction.arms {
            let crossing = junction.crossings.iter().map(|id| &self.net.crossings[id.index()]);
            let before = crossing.filter(|crossing| crossing.roads.contains(&arm.road)).map(|c| c.width + STOP[0]);
            let lights = (junction.draft.control == Control::Signals).then_some(STOP[1]);
            let Some(back) = before.reduce(f64::max).or(lights) else { continue };
            for lane in &self.roads[arm.road.index()].lanes {
                let lane = &mut self.lanes[lane.index()];
                if lane.forward != arm.start && lane.users.any(Users::TRAFFIC) {
                    lane.stop_line = Some((lane.line.length() - back).max(0.0));
                }
            }
        }
    }

    /// An edge along all walkable ground.
    fn along_roads(&mut self) {
        let starts: Vec<(Ground, WalkNodeId)> =
            self.ends.iter().filter(|((_, start), _)| *start).map(|((ground, _), node)| (*ground, *node)).collect();
        for (ground, from) in starts {
            let Some(to) = self.ends.get(&(ground, false)).copied() else { continue };
            let (line, forward) = self.ground(ground);
            let line = if forward { line } else { line.reversed() };
            let (kind, road) = match ground {
                Ground::Lane(lane) => (WalkKind::Lane(lane), self.lanes[lane.index()].road),
                Ground::Shared(road) => (WalkKind::Shared(road), road),
            };
            let steps = self.roads[road.index()].draft.class == RoadClass::Steps;
            self.net.edges.push(WalkEdge { ends: [from, to], kind, line, steps });
        }
    }
}
