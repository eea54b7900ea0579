//! Parking bays, doors and stops, each beside its lane or pavement.

use crate::index::PointIndex;
use crate::parts::Lane;
use crate::places::{Bay, Entrance, Stop};
use crate::{BuildingId, LaneId, Point, Polyline, StopKind, StreetMap, StripKind, Users, WalkEdgeId};

/// An edge of the walkable network and a station on it, metres.
type Place = (WalkEdgeId, f64);

/// The length and width of a bay along the kerb, metres.
const ALONG: [f64; 2] = [5.75, 2.1];
/// A parking lane that is wider has bays across, metres.
const ACROSS: f64 = 3.5;
/// The width of a bay across, metres.
const ACROSS_WIDTH: f64 = 2.5;
/// No bay is nearer to a junction, metres.
const CLEAR: f64 = 5.0;
/// A door is at most this far from the walkable network, metres.
const DOOR: f64 = 200.0;
/// The way from a door begins this far before its wall; another pavement is looked for so much further than twice as far as the
/// nearest, metres.
const DOORSTEP: f64 = 0.3;
const AROUND: f64 = 20.0;
/// A stop is at most this far from its lane, metres.
const STOP: f64 = 25.0;

/// The bays of a lane for parking.
fn row(id: LaneId, lane: &Lane) -> impl Iterator<Item = Bay> {
    let across = lane.width > ACROSS;
    let size = if across { [lane.width, ACROSS_WIDTH] } else { [ALONG[0], lane.width] };
    let (step, turn) = if across { (ACROSS_WIDTH, std::f64::consts::FRAC_PI_2) } else { (ALONG[0], 0.0) };
    let count = ((lane.line.length() - 2.0 * CLEAR) / step).max(0.0) as u32;
    (0..count).map(move |i| {
        let station = CLEAR + (f64::from(i) + 0.5) * step;
        Bay { lane: id, at: lane.line.at(station), heading: lane.line.heading(station) + turn, size }
    })
}

pub(super) fn entrances(map: &StreetMap) -> Vec<Entrance> {
    let walls = Walls::new(map);
    let entrance = |draft: &crate::EntranceDraft| {
        let door = Point::from(draft.at);
        let near = map.pavement_near(&door, DOOR).map(|near| walls.free(map, draft.building, &door, near));
        Entrance {
            building: draft.building,
            door,
            edge: near.map(|(edge, _)| edge),
            station: near.map_or(0.0, |(_, station)| station),
            guessed: draft.source == 0,
        }
    };
    map.draft().entrances.iter().map(entrance).collect()
}

/// The walls of buildings, by place.
struct Walls {
    /// Outlines and courts, each with its building.
    lines: Vec<(BuildingId, Polyline)>,
    index: PointIndex,
}

impl Walls {
    fn new(map: &StreetMap) -> Self {
        let walls = map.buildings().iter().enumerate();
        let lines: Vec<_> =
            walls.flat_map(|(id, building)| building.walls().map(move |wall| (BuildingId::of(id), wall))).collect();
        let index = PointIndex::new(lines.iter().enumerate().map(|(id, (_, line))| (id as u32, line)));
        Self { lines, index }
    }

    /// The place on a pavement to which one comes from a door without going through its building: the nearest if there the way is
    /// free, or another not much further away.
    fn free(&self, map: &StreetMap, building: BuildingId, door: &Point, nearest: Place) -> Place {
        let at = |(edge, station): Place| map.walk_edge(edge).map(|edge| edge.line.at(station));
        let crosses = |place: &Place, all: bool| {
            let Some(way) = at(*place).map(|at| at - door) else { return true };
            // A door lies on its wall.
            let begin = door + way.cap_magnitude(DOORSTEP);
            self.index.is_crossed([begin, door + way], |id| {
                let (of, line) = &self.lines[id as usize];
                (all || *of == building).then_some(line)
            })
        };
        if !crosses(&nearest, true) {
            return nearest;
        }
        let away = |place: &Place| at(*place).map_or(f64::INFINITY, |at| (at - door).norm());
        let others = map.pavements_around(door, 2.0 * away(&nearest) + AROUND);
        let first = |all: bool| {
            let free = others.iter().filter(|place| !crosses(place, all));
            free.min_by(|a, b| away(a).total_cmp(&away(b)).then(a.0.cmp(&b.0))).copied()
        };
        // Where houses stand all around, a way through none of them but its own is wanted least.
        first(true).or_else(|| first(false)).unwrap_or(nearest)
    }
}

pub(super) fn stops(map: &StreetMap) -> Vec<Stop> {
    let stop = |draft: &crate::StopDraft| {
        let at = Point::from(draft.at);
        let users = match draft.kind {
            StopKind::Bus => Users::BUS,
            StopKind::Tram => Users::TRAM,
            StopKind::Train => Users::TRAIN,
        };
        let lane = map.lane_near(&at, users, STOP);
        Stop { kind: draft.kind, name: draft.name.clone(), at, lane, walk: map.pavement_near(&at, 2.0 * STOP) }
    };
    map.draft().stops.iter().map(stop).collect()
}

impl StreetMap {
    /// Its parking bays, in the order of their lanes. They are worked out while one goes through them: a map of long roads
    /// has many, and does not hold them.
    ///
    /// ```
    /// use vc_map::{Control, CrossSection, MapDraft, RoadClass, Strip, StripKind, Users};
    /// let mut draft = MapDraft::new("street", 48.1, 11.6);
    /// let ends = [[0.0, 0.0], [100.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
    /// let parking = Strip::new(StripKind::Parking, 2.1, Users::NONE, 8.3);
    /// let section = CrossSection { forward: vec![Strip::driving(3.0, 8.3), parking], ..CrossSection::default() };
    /// draft.road(ends[0], ends[1], RoadClass::Residential, section);
    /// assert_eq!(draft.build()?.bays().count(), 15);
    /// # Ok::<(), vc_map::MapError>(())
    /// ```
    pub fn bays(&self) -> impl Iterator<Item = Bay> + '_ {
        let parking = self.lanes().iter().enumerate().filter(|(_, lane)| lane.kind == StripKind::Parking);
        parking.flat_map(|(index, lane)| row(LaneId::of(index), lane))
    }

    /// The pavement, path or shared street that is nearest to a point, within a distance in metres, with the station there.
    /// Costs as [`Self::lane_near`].
    ///
    /// ```
    /// # use vc_map::{Control, CrossSection, MapDraft, RoadClass, Strip, WalkKind};
    /// # let mut draft = MapDraft::new("street", 48.1, 11.6);
    /// # let ends = [[0.0, 0.0], [100.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
    /// # let side = vec![Strip::driving(3.0, 8.3), Strip::pavement(2.0)];
    /// # let section = CrossSection { forward: side.clone(), backward: side, median: 0.0 };
    /// # draft.road(ends[0], ends[1], RoadClass::Residential, section);
    /// # let map = draft.build()?; // a street of 100 m along X
    /// let (edge, _) = map.pavement_near(&[30.0, 9.0].into(), 10.0).ok_or("none")?;
    /// assert!(matches!(map.walk_edge(edge).map(|edge| edge.kind), Some(WalkKind::Lane(_))));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn pavement_near(&self, point: &Point, within: f64) -> Option<(crate::WalkEdgeId, f64)> {
        self.walk_edge_near(point, within, |edge| edge.kind.is_pavement())
    }

    /// The doors of a building. Costs one pass over all doors.
    pub fn entrances_of(&self, building: crate::BuildingId) -> Vec<crate::EntranceId> {
        let own = |(_, entrance): &(usize, &Entrance)| entrance.building == building;
        self.entrances().iter().enumerate().filter(own).map(|(index, _)| crate::EntranceId::of(index)).collect()
    }
}
