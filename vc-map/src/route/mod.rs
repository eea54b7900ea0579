//! Routes for cars, bicycles and people on foot over one map, with costs for turns.
//!
//! ```
//! use vc_map::route::{Mode, Router};
//! use vc_map::{Building, BuildingId, Control, CrossSection, EntranceDraft, MapDraft, RoadClass, Strip};
//! let mut draft = MapDraft::new("street", 48.1, 11.6);
//! let ends = [[0.0, 0.0], [100.0, 0.0], [200.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
//! let side = vec![Strip::driving(3.0, 10.0), Strip::pavement(2.0)];
//! for pair in ends.windows(2) {
//!     let section = CrossSection { forward: side.clone(), backward: side.clone(), median: 0.0 };
//!     draft.road(pair[0], pair[1], RoadClass::Residential, section);
//! }
//! let outline = vec![[150.0, 8.0], [160.0, 8.0], [160.0, 18.0], [150.0, 18.0]];
//! draft.buildings.push(Building::new(outline, 3));
//! draft.entrances.push(EntranceDraft { building: BuildingId(0), at: [155.0, 8.0], kind: "main".into(), source: 0 });
//! let map = draft.build()?;
//!
//! let walk = Router::new(&map, Mode::Foot).to_entrance(&[10.0, -3.0].into(), vc_map::EntranceId(0));
//! let walk = walk.ok_or("a way")?;
//! assert_eq!(walk.line.end(), [155.0, 8.0].into());
//! let drive = Router::new(&map, Mode::Car).route(&[10.0, -1.5].into(), &[190.0, -1.5].into());
//! assert!(drive.is_some_and(|drive| (drive.metres - 180.0).abs() < 1.0 && drive.seconds < 20.0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod graph;
mod landmarks;
mod network;
mod search;

use std::fmt;

use graph::Graph;
use network::Ground;

use crate::{EntranceId, Point, Polyline, RoadId, StreetMap, WalkEdgeId};

/// A point is at most this far from the network that one starts from, metres.
const NEAR: f64 = 200.0;

/// How somebody travels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Mode {
    /// By car.
    Car,
    /// By bicycle.
    Bicycle,
    /// On foot.
    Foot,
}

impl fmt::Display for Mode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Car => "by car",
            Self::Bicycle => "by bicycle",
            Self::Foot => "on foot",
        })
    }
}

/// A part of a route.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Leg {
    /// Along a road, with its line or against it.
    Road(RoadId, bool),
    /// Along an edge of the walkable network, from its first end or from its second.
    Walk(WalkEdgeId, bool),
}

/// A way from one point to another.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Route {
    /// Its parts.
    pub legs: Vec<Leg>,
    /// Its line.
    pub line: Polyline,
    /// Its length, metres.
    pub metres: f64,
    /// The time that it takes, seconds, waiting at lights and turns included.
    pub seconds: f64,
}

/// Finds the fastest routes of one mode on a map: an A* search with landmarks (Goldberg and Harrelson, 2005). Making it
/// costs sixteen searches over the whole map.
///
/// Vehicles enter private roads only where they start or end, or where there is no other way within ten minutes; cars do the
/// same with service roads and tracks. People walk wherever they may.
#[derive(Debug)]
pub struct Router {
    map: StreetMap,
    mode: Mode,
    graph: Graph,
    ground: Ground,
}

impl Router {
    /// A router for a mode. Costs sixteen searches over the map: milliseconds for some square kilometres, so that one is made for
    /// many routes.
    pub fn new(map: &StreetMap, mode: Mode) -> Self {
        let (ground, graph) = network::network(map, mode);
        Self { map: map.clone(), mode, graph, ground }
    }

    /// A router on foot for those who do not like to go along some edges of the walkable network: each seems longer by some seconds, infinity
    /// where nobody goes if there is another way. These seconds are part of those of the routes. Costs as [`Self::new`].
    ///
    /// ```
    /// # use vc_map::route::{Mode, Router};
    /// # use vc_map::{Control, CrossSection, MapDraft, RoadClass, Strip, WalkKind};
    /// # let mut draft = MapDraft::new("street", 48.1, 11.6);
    /// # let ends = [[0.0, 0.0], [100.0, 0.0], [200.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
    /// # let side = vec![Strip::driving(3.0, 10.0), Strip::pavement(2.0)];
    /// # for pair in ends.windows(2) {
    /// #     let section = CrossSection { forward: side.clone(), backward: side.clone(), median: 0.0 };
    /// #     draft.road(pair[0], pair[1], RoadClass::Residential, section);
    /// # }
    /// # let map = draft.build()?; // a street along X with pavements on both sides
    /// // Those who would rather walk half a minute more than along the first pavement go along the other one.
    /// let ends = [[10.0, -4.0], [190.0, -4.0]].map(|at| at.into());
    /// let usual = Router::new(&map, Mode::Foot).route(&ends[0], &ends[1]).ok_or("no way")?;
    /// let wet = map.pavement_near(&[150.0, -4.0].into(), 1.0).ok_or("no pavement")?.0;
    /// let router = Router::on_foot(&map, |edge| if edge == wet { 30.0 } else { 0.0 });
    /// let dry = router.route(&ends[0], &ends[1]).ok_or("no way")?;
    /// assert!(usual.seconds < dry.seconds && dry.seconds <= usual.seconds + 30.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn on_foot(map: &StreetMap, longer: impl Fn(WalkEdgeId) -> f64) -> Self {
        let (ground, graph) = network::walking(map, longer);
        Self { map: map.clone(), mode: Mode::Foot, graph, ground }
    }

    /// The fastest route from a point to a point, each at the nearest lane or pavement within 200 m. Where no way leads from
    /// lane to lane, because one leaves the map for example, it begins or ends on the other side of the road. `None` without a way.
    /// Costs a look at the roads between, and memory for each road of the map while it lasts.
    ///
    /// ```
    /// # use vc_map::route::{Mode, Router};
    /// # use vc_map::{Control, CrossSection, MapDraft, RoadClass, Strip};
    /// # let mut draft = MapDraft::new("street", 48.1, 11.6);
    /// # let ends = [[0.0, 0.0], [100.0, 0.0], [200.0, 0.0]].map(|at| draft.junction(at, Control::Edge));
    /// # let side = vec![Strip::driving(3.0, 10.0)];
    /// # for pair in ends.windows(2) {
    /// #     let section = CrossSection { forward: side.clone(), backward: side.clone(), median: 0.0 };
    /// #     draft.road(pair[0], pair[1], RoadClass::Residential, section);
    /// # }
    /// # let map = draft.build()?; // a street along X that leaves the map at both ends
    /// // The lane to the north leads west, out of the map; the one to the south leads east.
    /// let drive = Router::new(&map, Mode::Car).route(&[20.0, 4.0].into(), &[180.0, 4.0].into()).ok_or("no way")?;
    /// assert_eq!(drive.line.start(), [20.0, -1.5].into());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn route(&self, from: &Point, to: &Point) -> Option<Route> {
        let (start, end) = (self.ground.near(&self.map, from, NEAR)?, self.ground.near(&self.map, to, NEAR)?);
        let between = |start: network::Place, end: network::Place| self.between(start, end, [None, None]);
        between(start, end).or_else(|| {
            let (from, to) = (self.ground.opposite(&start), self.ground.opposite(&end));
            let sides = [(from, Some(end)), (Some(start), to), (from, to)];
            let routes = sides.into_iter().filter_map(|(start, end)| between(start?, end?));
            routes.min_by(|a, b| a.seconds.total_cmp(&b.seconds))
        })
    }

    /// The fastest way on foot from a point within 200 m of the walkable network to a door. `None` for other modes and without
    /// a way. Costs as [`Self::route`].
    pub fn to_entrance(&self, from: &Point, to: EntranceId) -> Option<Route> {
        let start = self.ground.near(&self.map, from, NEAR)?;
        let (end, door) = self.door(to)?;
        self.between(start, end, [None, Some(door)])
    }

    /// The fastest way on foot from a door to a door. `None` for other modes and without a way. Costs as [`Self::route`].
    ///
    /// ```
    /// # use vc_map::route::{Mode, Router};
    /// # use vc_map::{Building, BuildingId, Control, CrossSection, EntranceDraft, EntranceId, MapDraft, RoadClass, Strip};
    /// # let mut draft = MapDraft::new("street", 48.1, 11.6);
    /// # let ends = [[0.0, 0.0], [200.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
    /// # let side = vec![Strip::driving(3.0, 10.0), Strip::pavement(2.0)];
    /// # let section = CrossSection { forward: side.clone(), backward: side, median: 0.0 };
    /// # draft.road(ends[0], ends[1], RoadClass::Residential, section);
    /// # for x in [50.0, 150.0] {
    /// #     draft.buildings.push(Building::new(vec![[x, 6.0], [x + 9.0, 6.0], [x, 16.0]], 3));
    /// #     let building = BuildingId(draft.buildings.len() as u32 - 1);
    /// #     draft.entrances.push(EntranceDraft { building, at: [x, 6.0], kind: "main".into(), source: 0 });
    /// # }
    /// # let map = draft.build()?; // a street with two houses on one side, 100 m from each other
    /// let walk = Router::new(&map, Mode::Foot).between_entrances(EntranceId(0), EntranceId(1)).ok_or("no way")?;
    /// assert_eq!(walk.metres, 104.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn between_entrances(&self, from: EntranceId, to: EntranceId) -> Option<Route> {
        let ((start, first), (end, last)) = (self.door(from)?, self.door(to)?);
        self.between(start, end, [Some(first), Some(last)])
    }

    fn door(&self, id: EntranceId) -> Option<(network::Place, Point)> {
        let entrance = self.map.entrance(id).filter(|_| self.mode == Mode::Foot)?;
        Some((network::Place { item: entrance.edge?.index(), station: entrance.station }, entrance.door))
    }

    fn search(&self, start: &network::Place, end: &network::Place) -> Option<(graph::Cost, Vec<u32>)> {
        let (starts, ends) = (self.ground.starts(start), self.ground.ends(end));
        if self.mode == Mode::Foot || start.item != end.item {
            return search::search(&self.graph, &starts, &ends);
        }
        // Ends that lie behind on the same side of a road are reached by way of the next one.
        let behind = starts.iter().map(|(_, cost)| *cost).min().unwrap_or(0);
        let next: Vec<_> =
            self.graph.from(start.item as u32).iter().map(|(to, cost)| (*to, cost.saturating_add(behind))).collect();
        let (cost, mut nodes) = search::search(&self.graph, &next, &ends)?;
        nodes.insert(0, start.item as u32);
        Some((cost, nodes))
    }

    fn between(&self, start: network::Place, end: network::Place, doors: [Option<Point>; 2]) -> Option<Route> {
        let found = match self.ground.direct(&start, &end) {
            Some(cost) => (cost, Vec::new()),
            None => self.search(&start, &end)?,
        };
        self.ground.route(&self.map, start, end, found, doors)
    }
}
