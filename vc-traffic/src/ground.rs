//! The ground on which people walk: the edges of the walkable network, moved off the lanes of vehicles where these lie on them, and the
//! parts on which that does not help.

use std::collections::BTreeMap;
use std::sync::Arc;

use vc_map::{EntranceId, Point, Polyline, StreetMap, StripKind, Turn, Users, WalkEdge, WalkEdgeId, WalkKind};

use crate::network::Network;

/// Lines are looked at in steps of so many metres.
const STEP: f64 = 0.5;
/// The middle of a way keeps so far off lanes, so that two pass each other, and so far off the ways over junctions, metres; these are so wide, and
/// more in turns, where vehicles cut the corner.
const CLEAR: f64 = 0.45;
const CLEAR_OF_WAYS: f64 = 0.25;
const WIDE: f64 = 2.5;
const TURN: f64 = 3.3;
/// Ways are moved aside by steps of this, and at most so far, metres; a metre on a lane is as bad as so many aside, and so is a door on the other side.
const ASIDE: f64 = 0.25;
const MOST_ASIDE: u32 = 24;
const ON_LANE: f64 = 4.0;
const DOOR: f64 = 2.0;
/// The least width of a way, and those of corners, edges of streets without pavements, and ways to doors, metres.
const NARROWEST: f64 = 0.9;
const CORNER: f64 = 2.0;
const EDGE: f64 = 1.5;
const TO_DOOR: f64 = 1.2;
/// Nobody walks at the sides of a crossing, where vehicles turn and corners are narrower, metres.
const AT_SIDES: f64 = 2.0;
/// Links are found in cells of this size, metres, by points so far apart.
const CELL: f64 = 4.0;
const APART: f64 = 1.0;
/// Somebody who crosses takes so much of a lane before and behind them, metres.
const TAKES: f64 = 1.2;
/// Parts on lanes that are nearer to each other are one, metres: nobody waits between them.
const TOGETHER: f32 = 1.0;
/// Whoever finds a way rather walks for so long than crosses where there is no crossing, seconds, and so much longer for each metre on a lane.
const RATHER: f64 = 15.0;
const RATHER_A_METRE: f64 = 3.0;

/// A part of a link, metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Span {
    pub(crate) link: u32,
    pub(crate) from: f32,
    pub(crate) to: f32,
}

/// A part of a way that lies where vehicles go, between two stations in metres.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Over {
    pub(crate) from: f32,
    pub(crate) to: f32,
    pub(crate) spans: Vec<Span>,
}

/// Where people walk along an edge of the walkable network, or to a door.
#[derive(Debug, Clone)]
pub(crate) struct Path {
    pub(crate) line: Polyline,
    pub(crate) width: f32,
    pub(crate) over: Vec<Over>,
    /// How much of its line comes before that of the edge, metres: nothing but at crossings.
    pub(crate) before: f32,
}

/// Where people walk on a map.
pub(crate) struct Ground {
    /// By the edges of the map.
    pub(crate) paths: Vec<Path>,
    links: Arc<Links>,
}

impl Ground {
    /// Costs a look at the links around each half metre of the walkable network.
    pub(crate) fn new(network: &Network, links: Arc<Links>) -> Self {
        let map = &network.map;
        let mut doors: BTreeMap<usize, Vec<Point>> = BTreeMap::new();
        for door in map.entrances() {
            doors.entry(door.edge.map_or(usize::MAX, vc_map::WalkEdgeId::index)).or_default().push(door.door);
        }
        let mut lines: Vec<Polyline> = map.walk_edges().iter().map(|edge| edge.line.clone()).collect();
        let mut ends: Vec<Point> = map.walk_nodes().iter().map(|node| node.at).collect();
        for (number, edge) in map.walk_edges().iter().enumerate() {
            if !matches!(edge.kind, WalkKind::Lane(_) | WalkKind::Shared(_)) {
                continue;
            }
            let moved = links.moved(&edge.line, &layers(map, edge), doors.get(&number).map_or(&[], Vec::as_slice));
            (ends[edge.ends[0].index()], ends[edge.ends[1].index()]) = (moved.start(), moved.end());
            lines[number] = moved;
        }
        let path = |(edge, line): (&WalkEdge, Polyline)| {
            let [from, to] = edge.ends.map(|node| ends[node.index()]);
            links.path(map, edge, line, [from, to])
        };
        let paths = map.walk_edges().iter().zip(lines).map(path).collect();
        Self { paths, links }
    }

    /// The way from a door to the edge before it, with the station there.
    pub(crate) fn door(&self, map: &StreetMap, id: EntranceId) -> Option<(Option<Path>, f64)> {
        let (number, station) = self.before(map, id)?;
        let (edge, path) = (map.walk_edge(number)?, self.paths.get(number.index())?);
        let line = Polyline::new([map.entrance(id)?.door, path.line.at(station)]);
        let path = line.map(|line| self.links.along(line, TO_DOOR, &layers(map, edge)));
        Some((path, station))
    }

    /// The edge before a door, with the station there, metres.
    pub(crate) fn before(&self, map: &StreetMap, id: EntranceId) -> Option<(WalkEdgeId, f64)> {
        let entrance = map.entrance(id)?;
        let number = entrance.edge?;
        let (edge, path) = (map.walk_edge(number)?, self.paths.get(number.index())?);
        let part = (entrance.station / edge.line.length().max(1e-6)).clamp(0.0, 1.0);
        Some((number, part * path.line.length()))
    }

    /// By how much longer an edge seems than its length takes, seconds.
    pub(crate) fn reluctance(&self, edge: usize) -> f64 {
        let of = |over: &Over| RATHER + RATHER_A_METRE * f64::from(over.to - over.from);
        self.paths.get(edge).map_or(0.0, |path| path.over.iter().map(of).sum())
    }
}

/// The layers on which vehicles come in the way of an edge.
fn layers(map: &StreetMap, edge: &WalkEdge) -> Vec<i8> {
    let of = |road: vc_map::RoadId| map.road(road).map(|road| road.draft.layer);
    match edge.kind {
        WalkKind::Lane(id) => map.lane(id).and_then(|lane| of(lane.road)).into_iter().collect(),
        WalkKind::Shared(road) => of(road).into_iter().collect(),
        WalkKind::Corner(id) => map
            .junction(id)
            .map(|junction| junction.arms.iter().filter_map(|arm| of(arm.road)).collect())
            .unwrap_or_default(),
        _ => Vec::new(),
    }
}

/// The links of motor vehicles, to be found by their places.
pub(crate) struct Links {
    cells: BTreeMap<[i32; 2], Vec<u32>>,
    /// For each link its line, half its width, how far ways keep off it, and its layer.
    lines: Vec<Option<(Polyline, f64, f64, i8)>>,
}

/// A link as it is near a point.
struct Near {
    link: u32,
    /// How far its edge is from the point, metres; negative within it.
    off: f64,
    /// Whether people walk there.
    clear: bool,
    station: f64,
}

impl Links {
    pub(crate) fn new(network: &Network) -> Self {
        let map = &network.map;
        let driven = |users: Users| users.any(Users::CAR | Users::BUS);
        let layer = |lane: vc_map::LaneId| {
            map.lane(lane).and_then(|lane| map.road(lane.road)).map_or(0, |road| road.draft.layer)
        };
        let lanes = map.lanes().iter().map(|lane| {
            let here = driven(lane.users) && lane.kind == StripKind::Driving;
            let layer = map.road(lane.road).map_or(0, |road| road.draft.layer);
            here.then(|| (lane.line.clone(), lane.width / 2.0, CLEAR, layer))
        });
        let movements = map.movements().iter().map(|movement| {
            let wide = if movement.turn == Turn::Through { WIDE } else { TURN };
            driven(movement.users).then(|| (movement.line.clone(), wide / 2.0, CLEAR_OF_WAYS, layer(movement.from)))
        });
        let lines: Vec<_> = lanes.chain(movements).collect();
        let mut cells: BTreeMap<[i32; 2], Vec<u32>> = BTreeMap::new();
        for (number, line) in lines.iter().enumerate() {
            let Some((line, ..)) = line else { continue };
            for station in stations(line.length(), APART) {
                let cell = cells.entry(cell(&line.at(station))).or_default();
                if cell.last() != Some(&(number as u32)) {
                    cell.push(number as u32);
                }
            }
        }
        Self { cells, lines }
    }

    /// The links around a point on some layers.
    fn around(&self, at: &Point, layers: &[i8]) -> Vec<Near> {
        let [x, y] = cell(at);
        let places = (x - 1..=x + 1).flat_map(|x| (y - 1..=y + 1).map(move |y| [x, y]));
        let mut near: Vec<u32> = places.filter_map(|place| self.cells.get(&place)).flatten().copied().collect();
        near.sort_unstable();
        near.dedup();
        let of = |link: u32| {
            let (line, half, clear, _) = self.lines[link as usize].as_ref().filter(|of| layers.contains(&of.3))?;
            let place = line.project(at);
            let off = (place.point - at).norm() - half;
            Some(Near { link, off, clear: off >= *clear, station: place.station })
        };
        near.into_iter().filter_map(of).collect()
    }

    /// The links on some layers of which the middle comes within some metres of a point, at most 3.5, with the stations there.
    pub(crate) fn within(&self, at: &Point, layers: &[i8], metres: f64) -> Vec<(u32, f64)> {
        let half = |link: u32| self.lines[link as usize].as_ref().map_or(0.0, |(_, half, ..)| *half);
        let near = self.around(at, layers).into_iter().filter(|near| near.off + half(near.link) < metres);
        near.map(|near| (near.link, near.station)).collect()
    }

    /// A line beside another that is clear of vehicles as far as possible, and not farther aside than it takes.
    fn moved(&self, line: &Polyline, layers: &[i8], doors: &[Point]) -> Polyline {
        let on = |line: &Polyline| {
            let bad = |station: &f64| self.around(&line.at(*station), layers).iter().any(|near| !near.clear);
            let near = stations(line.length(), STEP).filter(bad);
            near.count() as f64 * STEP
        };
        if on(line) == 0.0 {
            return line.clone();
        }
        let mut best = (on(line) * ON_LANE, line.clone());
        for step in 1..=MOST_ASIDE {
            for side in [1.0, -1.0] {
                let aside = f64::from(step) * ASIDE;
                let beyond = doors.iter().filter(|door| line.project(door).left * side < 0.0).count();
                let rest = aside + beyond as f64 * DOOR;
                if rest < best.0 {
                    let moved = line.offset(aside * side);
                    let cost = on(&moved) * ON_LANE + rest;
                    if cost < best.0 {
                        best = (cost, moved);
                    }
                }
            }
        }
        best.1
    }

    /// Where people walk along an edge, of which the line has been moved, and the ends.
    fn path(&self, map: &StreetMap, edge: &WalkEdge, line: Polyline, [from, to]: [Point; 2]) -> Path {
        let wide = match edge.kind {
            WalkKind::Lane(id) => map.lane(id).map_or(0.0, |lane| lane.width),
            WalkKind::Corner(_) => CORNER,
            WalkKind::Crossing(id) => return self.crossing(map, id, line, [from, to]),
            _ => EDGE,
        };
        let straight = |line: Polyline| Polyline::new([from, to]).unwrap_or(line);
        let same = line.start() == from && line.end() == to;
        let line = if same { line } else { straight(line) };
        self.along(line, wide, &layers(map, edge))
    }

    /// A path over a crossing, with the parts of it on which vehicles go that do not heed it: those of other junctions.
    fn crossing(&self, map: &StreetMap, id: vc_map::CrossingId, line: Polyline, [from, to]: [Point; 2]) -> Path {
        let Some(crossing) = map.crossing(id) else {
            return Path { line, width: EDGE as f32, over: Vec::new(), before: 0.0 };
        };
        let before = (from - line.start()).norm() as f32;
        let line = Polyline::new([from].into_iter().chain(line.points().iter().copied()).chain([to])).unwrap_or(line);
        let layers: Vec<i8> =
            crossing.roads.iter().filter_map(|id| map.road(*id)).map(|road| road.draft.layer).collect();
        let lanes = map.lanes().len();
        let others = |link: u32| match map.lanes().get(link as usize) {
            Some(lane) => !crossing.roads.contains(&lane.road),
            None => map.movements()[link as usize - lanes].junction != crossing.junction,
        };
        let path = self.along_others(line, 0.0, &layers, others);
        Path { width: (crossing.width - AT_SIDES).max(EDGE) as f32, before, ..path }
    }

    /// A path along a line that is at most so wide, metres.
    fn along(&self, line: Polyline, wide: f64, layers: &[i8]) -> Path {
        self.along_others(line, wide, layers, |_| true)
    }

    /// The same, where only some links count.
    fn along_others(&self, line: Polyline, wide: f64, layers: &[i8], counts: impl Fn(u32) -> bool) -> Path {
        let mut over: Vec<Over> = Vec::new();
        let mut room = f64::INFINITY;
        let length = line.length();
        for station in stations(length, STEP) {
            let mut around = self.around(&line.at(station), layers);
            around.retain(|near| counts(near.link));
            if around.iter().all(|near| near.clear) {
                room = around.iter().map(|near| near.off).fold(room, f64::min);
                continue;
            }
            let (from, to) = ((station - STEP).max(0.0) as f32, (station + STEP).min(length) as f32);
            let taken = around.into_iter().filter(|near| near.off < TAKES);
            let spans = taken.map(|Near { link, station, .. }| Span {
                link,
                from: (station - TAKES) as f32,
                to: (station + TAKES) as f32,
            });
            let part = Over { from, to, spans: spans.collect() };
            if !over.last_mut().is_some_and(|last| last.join(&part)) {
                over.push(part);
            }
        }
        let width = wide.min(2.0 * room).max(NARROWEST) as f32;
        Path { line, width, over, before: 0.0 }
    }
}

impl Over {
    /// Adds a part that follows, if nobody would wait between them.
    pub(crate) fn join(&mut self, part: &Self) -> bool {
        let together = part.from - self.to < TOGETHER;
        if together {
            self.to = self.to.max(part.to);
            for span in &part.spans {
                match self.spans.iter_mut().find(|other| other.link == span.link) {
                    Some(other) => (other.from, other.to) = (other.from.min(span.from), other.to.max(span.to)),
                    None => self.spans.push(*span),
                }
            }
        }
        together
    }
}

/// Stations along a line, with its end.
fn stations(length: f64, step: f64) -> impl Iterator<Item = f64> {
    (0..=(length / step).ceil() as u32).map(move |number| (f64::from(number) * step).min(length))
}

fn cell(at: &Point) -> [i32; 2] {
    [at.x, at.y].map(|metres| (metres / CELL).floor() as i32)
}
