//! Places beside streets: buildings with their doors, areas, stops, as they are described and as the map has them, and bays.

use serde::{Deserialize, Serialize};

use crate::{BuildingId, LaneId, Point, Polyline, WalkEdgeId};

/// A building: its outline and heights.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Building {
    /// Its outer ring, counter-clockwise, metres; the first point is not repeated.
    pub outline: Vec<[f64; 2]>,
    /// Its courts, clockwise.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub courts: Vec<Vec<[f64; 2]>>,
    /// The height of its top above the ground, metres.
    pub height: f64,
    /// The height at which it begins, metres: above zero for a part that hangs over.
    #[serde(default)]
    pub base: f64,
    /// Its storeys above the ground.
    pub storeys: u32,
    /// Its kind, as mapped: `apartments`, `retail`, `yes`.
    pub kind: String,
    /// Its name.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Its address: street and number.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub address: Option<String>,
    /// Whether it is a part of another.
    #[serde(default)]
    pub part: bool,
    /// The number of the way or relation that it was made from; 0 if there is none.
    #[serde(default)]
    pub source: i64,
}

impl Building {
    /// A building of an outline in metres and a number of storeys, each 3.1 m high.
    ///
    /// ```
    /// let house = vc_map::Building::new(vec![[0.0, 0.0], [10.0, 0.0], [10.0, 8.0], [0.0, 8.0]], 2);
    /// assert_eq!((house.height, house.base, house.kind.as_str()), (6.2, 0.0, "yes"));
    /// ```
    pub fn new(outline: Vec<[f64; 2]>, storeys: u32) -> Self {
        Self {
            outline,
            courts: Vec::new(),
            height: f64::from(storeys.max(1)) * 3.1,
            base: 0.0,
            storeys,
            kind: "yes".to_owned(),
            name: None,
            address: None,
            part: false,
            source: 0,
        }
    }

    /// Its outline and its courts as closed lines.
    pub(crate) fn walls(&self) -> impl Iterator<Item = Polyline> {
        let rings = std::iter::once(&self.outline).chain(&self.courts);
        rings.filter_map(|ring| Polyline::new(ring.iter().chain(ring.first()).copied()))
    }
}

/// A door of a building.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EntranceDraft {
    /// The building.
    pub building: BuildingId,
    /// Its place on the outline, metres.
    pub at: [f64; 2],
    /// Its kind, as mapped: `main`, `yes`, `service`.
    pub kind: String,
    /// The number of the node that it was made from; 0 if it was guessed.
    #[serde(default)]
    pub source: i64,
}

/// The kind of an area.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum AreaKind {
    /// Parks, grass, woods, gardens.
    Green,
    /// Lakes, ponds, rivers with banks.
    Water,
    /// Squares and other areas for walking.
    Square,
    /// Car parks.
    Parking,
    /// Platforms of stations and stops.
    Platform,
    /// Ground that belongs to one owner.
    Lot,
}

impl AreaKind {
    /// The word in files and pictures.
    pub fn word(self) -> &'static str {
        match self {
            Self::Green => "green",
            Self::Water => "water",
            Self::Square => "square",
            Self::Parking => "parking",
            Self::Platform => "platform",
            Self::Lot => "lot",
        }
    }
}

/// An area, or the line of a stream.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Area {
    /// Its kind.
    pub kind: AreaKind,
    /// Its outer ring, metres; the first point is not repeated.
    pub outline: Vec<[f64; 2]>,
    /// Its holes.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub holes: Vec<Vec<[f64; 2]>>,
    /// Its name.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// The number of the way or relation that it was made from; 0 if there is none.
    #[serde(default)]
    pub source: i64,
}

/// The kind of a stop.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum StopKind {
    /// A stop of buses.
    Bus,
    /// A stop of trams.
    Tram,
    /// A stop of trains, underground ones included.
    Train,
}

/// A stop of public transport.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StopDraft {
    /// Its kind.
    pub kind: StopKind,
    /// Where people wait, metres.
    pub at: [f64; 2],
    /// Its name.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// The number of the node that it was made from; 0 if there is none.
    #[serde(default)]
    pub source: i64,
}

/// A door of a building and the point of the walkable network before it.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Entrance {
    /// The building.
    pub building: BuildingId,
    /// The door.
    pub door: Point,
    /// The edge of the walkable network before the door, if one is within 200 m.
    pub edge: Option<WalkEdgeId>,
    /// Where on that edge, metres from its first end.
    pub station: f64,
    /// Whether the door was guessed.
    pub guessed: bool,
}

/// A parking bay along a road.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Bay {
    /// The lane of bays.
    pub lane: LaneId,
    /// Its middle.
    pub at: Point,
    /// The heading of a vehicle that stands in it, radians.
    pub heading: f64,
    /// The length and width of such a vehicle's place, metres.
    pub size: [f64; 2],
}

/// A stop with the lanes before it.
///
/// ```
/// use vc_map::{StopDraft, StopKind};
/// # use vc_map::{Control, CrossSection, MapDraft, RoadClass, Strip};
/// # let mut draft = MapDraft::new("street", 48.1, 11.6);
/// # let ends = [[0.0, 0.0], [100.0, 0.0], [200.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
/// # let side = vec![Strip::driving(3.0, 8.3), Strip::pavement(2.0)];
/// # for pair in ends.windows(2) {
/// #     let section = CrossSection { forward: side.clone(), backward: side.clone(), median: 0.0 };
/// #     draft.road(pair[0], pair[1], RoadClass::Residential, section);
/// # }
/// // a street along X
/// draft.stops.push(StopDraft { kind: StopKind::Bus, at: [40.0, -4.0], name: None, source: 0 });
/// let map = draft.build()?;
/// let stop = &map.stops()[0];
/// assert!(stop.lane.is_some_and(|(_, station)| station > 0.0) && stop.walk.is_some());
/// # Ok::<(), vc_map::MapError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Stop {
    /// Its kind.
    pub kind: StopKind,
    /// Its name.
    pub name: Option<String>,
    /// Where people wait.
    pub at: Point,
    /// The lane in which vehicles stop and the station there, metres, if one is within 25 m.
    pub lane: Option<(LaneId, f64)>,
    /// The edge of the walkable network before it and the station there, metres, if one is within 50 m.
    pub walk: Option<(WalkEdgeId, f64)>,
}
