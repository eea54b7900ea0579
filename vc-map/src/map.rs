//! The built map: immutable, indexed, cheap to share.

use std::sync::Arc;

use crate::index::PointIndex;
use crate::parts::{Bay, Entrance, Junction, Lane, Movement, Road, RoadCrossing, Stop, WalkEdge, WalkNode};
use crate::signal::Signal;
use crate::{
    BuildingId, CrossingId, DrivingSide, EntranceId, JunctionId, LaneId, MapDraft, MovementId, Origin, Point, Polyline,
    RoadId, SignalId, Users, WalkEdgeId, WalkNodeId,
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
#[derive(Debug, Clone)]
pub struct StreetMap {
    pub(crate) inner: Arc<Inner>,
}

#[derive(Debug)]
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
    pub(crate) bays: Vec<Bay>,
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

        #[doc = concat!("One of [`Self::", stringify!($all), "`].")]
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

    /// One of [`Self::buildings`].
    pub fn building(&self, id: BuildingId) -> Option<&crate::Building> {
        self.buildings().get(id.index())
    }

    /// Its areas: green, water, squares, lots.
    pub fn areas(&self) -> &[crate::Area] {
        &self.inner.draft.areas
    }

    /// Its parking bays.
    pub fn bays(&self) -> &[Bay] {
        &self.inner.bays
    }

    /// Its stops.
    pub fn stops(&self) -> &[Stop] {
        &self.inner.stops
    }

    /// The lane for some users that is nearest to a point, within a distance in metres, with the station there.
    pub fn lane_near(&self, point: &Point, users: Users, within: f64) -> Option<(LaneId, f64)> {
        let lane =
            |id: u32| self.inner.lanes.get(id as usize).filter(|lane| lane.users.any(users)).map(|lane| &lane.line);
        self.inner.lane_index.nearest(point, within, lane).map(|(id, station, _)| (LaneId(id), station))
    }

    /// The edge of the walkable network that is nearest to a point, within a distance in metres, with the station there.
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
        self.inner.walk_index.nearest(point, within, edge).map(|(id, station, _)| (WalkEdgeId(id), station))
    }

    /// The edges of the walkable network at a node.
    pub fn walk_edges_at(&self, node: WalkNodeId) -> &[WalkEdgeId] {
        self.inner.walk_at.get(node.index()).map_or(&[], Vec::as_slice)
    }

    /// The length of all lanes for which something holds, metres.
    pub fn length_of(&self, lanes: impl Fn(&Lane, &Road) -> bool) -> f64 {
        let holds = |lane: &&Lane| self.road(lane.road).is_some_and(|road| lanes(lane, road));
        self.lanes().iter().filter(holds).map(|lane| lane.line.length()).sum()
    }

    /// The smallest box around all roads, buildings and areas, metres: lower left, upper right. `None` for an empty map.
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

/// Maps are equal if they were built from equal descriptions.
impl PartialEq for StreetMap {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.inner, &other.inner) || self.inner.draft == other.inner.draft
    }
}

/// A list of line-like things by the squares that they pass.
impl PointIndex {
    /// The nearest line: its number, the station there and the distance.
    fn nearest<'a>(
        &self,
        point: &Point,
        within: f64,
        line: impl Fn(u32) -> Option<&'a Polyline>,
    ) -> Option<(u32, f64, f64)> {
        let mut best: Option<(u32, f64, f64)> = None;
        self.around(point, within, |id| {
            let Some(near) = line(id).map(|line| line.project(point)) else { return f64::INFINITY };
            let away = (near.point - point).norm();
            if away <= within && best.is_none_or(|(known, _, least)| away < least || (away == least && id < known)) {
                best = Some((id, near.station, away));
            }
            best.map_or(f64::INFINITY, |(_, _, least)| least)
        });
        best
    }
}
