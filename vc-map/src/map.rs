//! The built map: immutable, indexed, cheap to share.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::sync::Arc;

use crate::index::PointIndex;
use crate::parts::{Junction, Lane, Movement, Road, RoadCrossing, WalkEdge, WalkNode};
use crate::places::{Entrance, Stop};
use crate::signal::Signal;
use crate::size::Holds;
use crate::{
    BuildingId, CrossingId, DrivingSide, EntranceId, JunctionId, LaneId, MapDraft, MovementId, Origin, Point, RoadId,
    SignalId, Users, WalkEdgeId, WalkNodeId,
};

/// A map: streets with lanes, junctions with movements, signals, a walkable network, places. It does not change; clones
/// share everything.
///
/// ```
/// use vc_map::{Control, CrossSection, MapDraft, RoadClass, Strip};
/// let mut draft = MapDraft::new("corner", 48.1, 11.6);
/// let ends = [[-100.0, 0.0], [100.0, 0.0], [0.0, 100.0]].map(|at| draft.junction(at, Control::Edge));
/// let middle = draft.junction([0.0, 0.0], Control::Priority);
/// let side = vec![Strip::driving(2.75, 8.3), Strip::pavement(2.4)];
/// for end in ends {
///     let section = CrossSection { forward: side.clone(), backward: side.clone(), median: 0.0 };
///     draft.road(end, middle, RoadClass::Residential, section);
/// }
/// let map = draft.build()?;
/// assert_eq!(map.lanes().len(), 12);
/// // From each of three arms into the two others.
/// assert_eq!(map.junction(middle).map(|junction| junction.movements.len()), Some(6));
/// # Ok::<(), vc_map::MapError>(())
/// ```
#[derive(Clone)]
pub struct StreetMap {
    pub(crate) inner: Arc<Inner>,
}

pub(crate) struct Inner {
    pub(crate) draft: MapDraft,
    pub(crate) junctions: Vec<Junction>,
    pub(crate) roads: Vec<Road>,
    pub(crate) lanes: Vec<Lane>,
    pub(crate) movements: Vec<Movement>,
    pub(crate) signals: Vec<Signal>,
    pub(crate) crossings: Vec<RoadCrossing>,
    pub(crate) walk_nodes: Vec<WalkNode>,
    pub(crate) walk_edges: Vec<WalkEdge>,
    pub(crate) walk_at: Vec<Vec<WalkEdgeId>>,
    pub(crate) entrances: Vec<Entrance>,
    pub(crate) stops: Vec<Stop>,
    pub(crate) lane_index: PointIndex,
    pub(crate) walk_index: PointIndex,
}

macro_rules! lists {
    ($($(#[$doc:meta])* $all:ident, $one:ident: $id:ident => $item:ident;)*) => {$(
        $(#[$doc])*
        pub fn $all(&self) -> &[$item] {
            &self.inner.$all
        }

        #[doc = concat!("One of [`Self::", stringify!($all), "`]; `None` beyond the last. Costs a look at the list.")]
        pub fn $one(&self, id: $id) -> Option<&$item> {
            self.inner.$all.get(id.index())
        }
    )*};
}

impl StreetMap {
    lists! {
        /// Its junctions.
        junctions, junction: JunctionId => Junction;
        /// Its roads.
        roads, road: RoadId => Road;
        /// Its lanes: all strips that somebody uses.
        lanes, lane: LaneId => Lane;
        /// Its movements.
        movements, movement: MovementId => Movement;
        /// Its signals.
        signals, signal: SignalId => Signal;
        /// Its crossings.
        crossings, crossing: CrossingId => RoadCrossing;
        /// The nodes of its walkable network.
        walk_nodes, walk_node: WalkNodeId => WalkNode;
        /// The edges of its walkable network.
        walk_edges, walk_edge: WalkEdgeId => WalkEdge;
        /// The doors of its buildings.
        entrances, entrance: EntranceId => Entrance;
    }

    /// The description that it was built from.
    pub fn draft(&self) -> &MapDraft {
        &self.inner.draft
    }

    /// Its name.
    pub fn name(&self) -> &str {
        &self.inner.draft.name
    }

    /// The place of the world that its point zero is.
    pub fn origin(&self) -> Origin {
        self.inner.draft.origin
    }

    /// The side on which vehicles drive.
    pub fn side(&self) -> DrivingSide {
        self.inner.draft.side
    }

    /// Its buildings; [`Self::entrances`] are their doors.
    pub fn buildings(&self) -> &[crate::Building] {
        &self.inner.draft.buildings
    }

    /// One of [`Self::buildings`]; `None` beyond the last.
    pub fn building(&self, id: BuildingId) -> Option<&crate::Building> {
        self.buildings().get(id.index())
    }

    /// Its areas: green, water, squares, lots.
    pub fn areas(&self) -> &[crate::Area] {
        &self.inner.draft.areas
    }

    /// Its stops.
    pub fn stops(&self) -> &[Stop] {
        &self.inner.stops
    }

    /// The lane for some users that is nearest to a point, within a distance in metres, with the station there. Costs the
    /// logarithm of the number of lanes and a look at those near by.
    ///
    /// ```
    /// # use vc_map::{Control, CrossSection, MapDraft, RoadClass, Strip, Users};
    /// # let mut draft = MapDraft::new("street", 48.1, 11.6);
    /// # let ends = [[0.0, 0.0], [100.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
    /// # let side = vec![Strip::driving(3.0, 8.3), Strip::pavement(2.0)];
    /// # let section = CrossSection { forward: side.clone(), backward: side, median: 0.0 };
    /// # draft.road(ends[0], ends[1], RoadClass::Residential, section);
    /// # let map = draft.build()?; // a street of 100 m along X
    /// let (lane, station) = map.lane_near(&[30.0, -2.0].into(), Users::CAR, 10.0).ok_or("none")?;
    /// assert!(map.lane(lane).is_some_and(|lane| lane.forward) && (station - 30.0).abs() < 1e-9);
    /// assert_eq!(map.lane_near(&[30.0, 90.0].into(), Users::CAR, 10.0), None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn lane_near(&self, point: &Point, users: Users, within: f64) -> Option<(LaneId, f64)> {
        let lane =
            |id: u32| self.inner.lanes.get(id as usize).filter(|lane| lane.users.any(users)).map(|lane| &lane.line);
        self.inner.lane_index.nearest(point, within, lane).map(|(id, station)| (LaneId(id), station))
    }

    /// The edge of the walkable network that is nearest to a point, within a distance in metres, with the station there.
    /// Costs as [`Self::lane_near`]; [`Self::pavement_near`] leaves corners and crossings out.
    ///
    /// ```
    /// # use vc_map::{Control, CrossSection, MapDraft, RoadClass, Strip};
    /// # let mut draft = MapDraft::new("street", 48.1, 11.6);
    /// # let ends = [[0.0, 0.0], [100.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
    /// # let side = vec![Strip::driving(3.0, 8.3), Strip::pavement(2.0)];
    /// # let section = CrossSection { forward: side.clone(), backward: side, median: 0.0 };
    /// # draft.road(ends[0], ends[1], RoadClass::Residential, section);
    /// # let map = draft.build()?; // a street of 100 m along X
    /// let (edge, station) = map.walk_near(&[30.0, 9.0].into(), 10.0).ok_or("none")?;
    /// assert_eq!(map.walk_edge(edge).map(|edge| edge.line.at(station)), Some([30.0, 4.0].into()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn walk_near(&self, point: &Point, within: f64) -> Option<(WalkEdgeId, f64)> {
        self.walk_edge_near(point, within, |_| true)
    }

    pub(crate) fn walk_edge_near(
        &self,
        point: &Point,
        within: f64,
        of: impl Fn(&WalkEdge) -> bool,
    ) -> Option<(WalkEdgeId, f64)> {
        let edge = |id: u32| self.inner.walk_edges.get(id as usize).filter(|edge| of(edge)).map(|edge| &edge.line);
        self.inner.walk_index.nearest(point, within, edge).map(|(id, station)| (WalkEdgeId(id), station))
    }

    /// The lanes whose middles come within a distance of a point, metres, with how near they come.
    pub(crate) fn lanes_around(&self, point: &Point, within: f64) -> impl Iterator<Item = (LaneId, f64)> + use<> {
        let near = self.inner.lane_index.each(point, within, |id| &self.inner.lanes[id as usize].line);
        near.into_iter().map(|(id, near)| (LaneId(id), near.left.abs()))
    }

    /// The lanes whose middles a straight way crosses.
    pub(crate) fn lanes_crossed(&self, way: [Point; 2]) -> impl Iterator<Item = LaneId> + use<> {
        self.inner.lane_index.crossed(way, |id| &self.inner.lanes[id as usize].line).into_iter().map(LaneId)
    }

    /// The pavements and paths that come within a distance of a point, metres, each with the station that is nearest.
    pub(crate) fn pavements_around(&self, point: &Point, within: f64) -> Vec<(WalkEdgeId, f64)> {
        let near = self.inner.walk_index.each(point, within, |id| &self.inner.walk_edges[id as usize].line);
        let pavement = |id: u32| self.inner.walk_edges[id as usize].kind.is_pavement();
        near.into_iter().filter(|(id, _)| pavement(*id)).map(|(id, near)| (WalkEdgeId(id), near.station)).collect()
    }

    /// Whether lights rule the end of a lane.
    pub(crate) fn is_lit(&self, lane: &Lane) -> bool {
        let junction = lane.next.first().and_then(|id| self.movement(*id)).and_then(|m| self.junction(m.junction));
        junction.is_some_and(|junction| junction.signal.is_some())
    }

    /// The lanes that lights rule at a junction.
    pub(crate) fn lit_lanes(&self, junction: &Junction) -> BTreeSet<LaneId> {
        let lit = junction.signal.map(|_| junction.movements.iter().filter_map(|id| self.movement(*id)));
        lit.into_iter().flatten().map(|movement| movement.from).collect()
    }

    /// The streets and paths with names, each by its longest road.
    pub(crate) fn named(&self) -> BTreeMap<&str, &Road> {
        let mut longest: BTreeMap<&str, &Road> = BTreeMap::new();
        for road in self.roads().iter().filter(|road| !road.draft.class.is_rail()) {
            let Some(name) = road.draft.name.as_deref() else { continue };
            let known = longest.entry(name).or_insert(road);
            if road.line.length() > known.line.length() {
                *known = road;
            }
        }
        longest
    }

    /// The edges of the walkable network at a node; none if the map does not have it. Costs a look at a list.
    pub fn walk_edges_at(&self, node: WalkNodeId) -> &[WalkEdgeId] {
        self.inner.walk_at.get(node.index()).map_or(&[], Vec::as_slice)
    }

    /// The length of all lanes for which something holds, metres. Costs one pass over the lanes.
    ///
    /// ```
    /// # use vc_map::{Control, CrossSection, MapDraft, RoadClass, Strip, Users};
    /// # let mut draft = MapDraft::new("street", 48.1, 11.6);
    /// # let ends = [[0.0, 0.0], [100.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
    /// # let section = CrossSection { forward: vec![Strip::driving(3.0, 8.3)], ..CrossSection::default() };
    /// # draft.road(ends[0], ends[1], RoadClass::Residential, section);
    /// # let map = draft.build()?; // a one-way street of 100 m
    /// assert_eq!(map.length_of(|lane, road| lane.users.has(Users::CAR) && road.draft.class.is_through()), 100.0);
    /// # Ok::<(), vc_map::MapError>(())
    /// ```
    pub fn length_of(&self, lanes: impl Fn(&Lane, &Road) -> bool) -> f64 {
        let holds = |lane: &&Lane| self.road(lane.road).is_some_and(|road| lanes(lane, road));
        self.lanes().iter().filter(holds).map(|lane| lane.line.length()).sum()
    }

    /// The memory that it takes with its description, bytes. Costs one pass over everything.
    pub fn bytes(&self) -> usize {
        let Inner { draft, junctions, roads, lanes, movements, signals, crossings, .. } = &*self.inner;
        let Inner { walk_nodes, walk_edges, walk_at, entrances, stops, lane_index, walk_index, .. } = &*self.inner;
        let lists = [junctions.held(), roads.held(), lanes.held(), movements.held(), signals.held(), crossings.held()];
        let walk = [walk_nodes.held(), walk_edges.held(), walk_at.held(), entrances.held(), stops.held()];
        let held: usize = lists.into_iter().chain(walk).sum();
        draft.bytes() + held + lane_index.bytes() + walk_index.bytes()
    }

    /// The smallest box around all roads, buildings and areas, metres: lower left, upper right. `None` for an empty map. Costs
    /// one pass over their points.
    pub fn bounds(&self) -> Option<[Point; 2]> {
        let roads = self.roads().iter().flat_map(|road| road.line.points().iter().copied());
        let rings = self.buildings().iter().map(|b| &b.outline).chain(self.areas().iter().map(|a| &a.outline));
        let all = roads.chain(rings.flatten().map(|at| Point::from(*at)));
        all.fold(None, |bounds: Option<[Point; 2]>, p| {
            let [low, high] = bounds.unwrap_or([p, p]);
            Some([low.inf(&p), high.sup(&p)])
        })
    }
}

/// The name and the size: a whole map would fill a screen with every street.
impl fmt::Debug for StreetMap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (roads, junctions) = (self.roads().len(), self.junctions().len());
        write!(f, "StreetMap({:?}, {roads} roads, {junctions} junctions)", self.name())
    }
}

/// Maps are equal if they were built from equal descriptions. Costs one pass over these, for clones nothing.
impl PartialEq for StreetMap {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.inner, &other.inner) || self.inner.draft == other.inner.draft
    }
}
