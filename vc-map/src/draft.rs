//! Maps as they are described: plain data from which a [`StreetMap`](crate::StreetMap) is built.

use serde::{Deserialize, Serialize};

use crate::places::{Area, Building, EntranceDraft, StopDraft};
use crate::rules::{CrossingDraft, SignDraft, TurnBan};
use crate::{CrossSection, JunctionId, RoadClass, RoadId};

/// The side of the road on which vehicles drive.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum DrivingSide {
    /// As in Munich and New York.
    #[default]
    Right,
    /// As in Leeds.
    Left,
}

impl DrivingSide {
    /// One for the right, minus one for the left.
    pub(crate) fn sign(self) -> f64 {
        if self == Self::Right { 1.0 } else { -1.0 }
    }
}

/// Whether a way lies on the ground.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Structure {
    /// On the ground.
    #[default]
    Ground,
    /// On a bridge.
    Bridge,
    /// In a tunnel or a covered passage.
    Tunnel,
}

/// The right of way at a junction.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Control {
    /// Whoever has no sign goes first, then the more important road; among equals those who turn give way to oncoming traffic,
    /// and all others to whom comes from the right.
    #[default]
    Priority,
    /// Everybody stops.
    AllWayStop,
    /// One goes around the middle, and whoever does goes first.
    MiniRoundabout,
    /// Traffic lights.
    Signals,
    /// The road ends at the edge of the map.
    Edge,
}

/// A point of the world: degrees of latitude and longitude (WGS 84).
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Origin {
    /// Degrees north.
    pub latitude: f64,
    /// Degrees east.
    pub longitude: f64,
}

/// A place where roads meet or end.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct JunctionDraft {
    /// Its middle, metres.
    pub at: [f64; 2],
    /// The right of way.
    #[serde(default)]
    pub control: Control,
    /// The numbers of the nodes that it was made from, of OpenStreetMap for example.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub source: Vec<i64>,
}

/// A road between two junctions.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RoadDraft {
    /// Where its line begins.
    pub from: JunctionId,
    /// Where its line ends.
    pub to: JunctionId,
    /// The middle of its carriageway, metres.
    pub line: Vec<[f64; 2]>,
    /// Its class.
    pub class: RoadClass,
    /// Its name.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Its strips.
    pub section: CrossSection,
    /// Its level: 0 on the ground, greater above.
    #[serde(default)]
    pub layer: i8,
    /// Whether it lies on a bridge or in a tunnel.
    #[serde(default)]
    pub structure: Structure,
    /// Whether it is part of a roundabout.
    #[serde(default)]
    pub roundabout: bool,
    /// Whether it is a slip road, which gives way to others of its class.
    #[serde(default, skip_serializing_if = "is_false")]
    pub slip: bool,
    /// Whether only those may drive on it who have something to do there.
    #[serde(default)]
    pub private: bool,
    /// The numbers of the ways that it was made from, of OpenStreetMap for example.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub source: Vec<i64>,
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "serde asks for a reference")]
fn is_false(value: &bool) -> bool {
    !value
}

/// A map as it is described. Whatever follows from this (lanes, movements, conflicts, phases, the walkable network) is
/// worked out by [`MapDraft::build`](crate::MapDraft::build), the same on every machine. Metres, X east and Y north from the
/// origin; metres per second.
///
/// ```
/// use vc_map::{Control, CrossSection, CrossingDraft, CrossingKind, MapDraft, RoadClass, Strip, TurnBan};
/// let mut draft = MapDraft::new("corner", 48.1, 11.6);
/// let middle = draft.junction([0.0, 0.0], Control::Priority);
/// let [west, _, north] = [[-100.0, 0.0], [100.0, 0.0], [0.0, 100.0]].map(|at| {
///     let (end, side) = (draft.junction(at, Control::Edge), vec![Strip::driving(3.0, 8.3), Strip::pavement(2.4)]);
///     let section = CrossSection { forward: side.clone(), backward: side, median: 0.0 };
///     draft.road(end, middle, RoadClass::Residential, section)
/// });
/// // Nobody turns from the west to the north, where people cross on a zebra.
/// draft.bans.push(TurnBan::new(west, middle, north));
/// draft.crossings.push(CrossingDraft { at: middle, road: north, kind: CrossingKind::Marked, island: false, source: 0 });
/// let map = draft.build()?;
/// assert_eq!(map.junction(middle).map(|junction| junction.movements.len()), Some(5));
/// assert!(map.crossings().iter().any(|crossing| crossing.kind == CrossingKind::Marked && !crossing.guessed));
/// # Ok::<(), vc_map::MapError>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MapDraft {
    /// Its name.
    pub name: String,
    /// The place of the world that its point zero is.
    pub origin: Origin,
    /// The side on which vehicles drive.
    #[serde(default)]
    pub side: DrivingSide,
    /// Its junctions.
    #[serde(default)]
    pub junctions: Vec<JunctionDraft>,
    /// Its roads: streets, paths and rails.
    #[serde(default)]
    pub roads: Vec<RoadDraft>,
    /// Turns that are not allowed.
    #[serde(default)]
    pub bans: Vec<TurnBan>,
    /// Crossings.
    #[serde(default)]
    pub crossings: Vec<CrossingDraft>,
    /// Signs that tell who gives way; without one the classes of roads do.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub signs: Vec<SignDraft>,
    /// Buildings.
    #[serde(default)]
    pub buildings: Vec<Building>,
    /// Doors of buildings.
    #[serde(default)]
    pub entrances: Vec<EntranceDraft>,
    /// Areas.
    #[serde(default)]
    pub areas: Vec<Area>,
    /// Stops.
    #[serde(default)]
    pub stops: Vec<StopDraft>,
}

impl MapDraft {
    /// An empty map of a name, at a place of the world: degrees north and east.
    pub fn new(name: impl Into<String>, latitude: f64, longitude: f64) -> Self {
        Self { name: name.into(), origin: Origin { latitude, longitude }, ..Self::default() }
    }

    /// Adds a junction at a point, metres.
    pub fn junction(&mut self, at: [f64; 2], control: Control) -> JunctionId {
        self.junctions.push(JunctionDraft { at, control, source: Vec::new() });
        JunctionId::of(self.junctions.len() - 1)
    }

    /// Adds a straight road between two junctions; [`Self::roads`] can be changed to bend it. Junctions that there are not are
    /// found when the map is built.
    pub fn road(&mut self, from: JunctionId, to: JunctionId, class: RoadClass, section: CrossSection) -> RoadId {
        let place = |id: JunctionId| self.junctions.get(id.index()).map_or([f64::NAN; 2], |junction| junction.at);
        let line = vec![place(from), place(to)];
        self.roads.push(RoadDraft {
            from,
            to,
            line,
            class,
            name: None,
            section,
            layer: 0,
            structure: Structure::Ground,
            roundabout: false,
            slip: false,
            private: false,
            source: Vec::new(),
        });
        RoadId::of(self.roads.len() - 1)
    }
}
