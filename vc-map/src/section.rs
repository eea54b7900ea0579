//! Cross-sections: the strips of a street with their widths, limits and users.

use serde::{Deserialize, Serialize};

use crate::{Turns, Users};

/// The class of a road, by the values of OpenStreetMap's key `highway`.
///
/// ```
/// use vc_map::RoadClass;
/// assert!(RoadClass::Primary.rank() > RoadClass::Residential.rank());
/// assert!(RoadClass::Service.is_street() && !RoadClass::Service.is_through());
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum RoadClass {
    /// A motorway.
    Motorway,
    /// A road for through traffic outside towns.
    Trunk,
    /// A main road.
    Primary,
    /// A road of second rank.
    Secondary,
    /// A road of third rank.
    Tertiary,
    /// A minor road.
    Minor,
    /// A street on which people live.
    Residential,
    /// A street that people on foot and vehicles share.
    Living,
    /// A drive, an alley, an aisle of a car park.
    Service,
    /// A farm or forest track.
    Track,
    /// A street for people on foot.
    Pedestrian,
    /// A way for bicycles.
    Cycleway,
    /// A footway or path.
    Path,
    /// Steps.
    Steps,
    /// Rails of a tram.
    Tram,
    /// Rails of trains.
    Rail,
}

impl RoadClass {
    /// All of them, the most important first.
    pub const ALL: [Self; 16] = [
        Self::Motorway,
        Self::Trunk,
        Self::Primary,
        Self::Secondary,
        Self::Tertiary,
        Self::Minor,
        Self::Residential,
        Self::Living,
        Self::Service,
        Self::Track,
        Self::Pedestrian,
        Self::Cycleway,
        Self::Path,
        Self::Steps,
        Self::Tram,
        Self::Rail,
    ];

    /// How important it is at a junction: the greater goes first.
    pub fn rank(self) -> u8 {
        16 - self as u8
    }

    /// Whether vehicles on tyres drive on it, other than bicycles.
    pub fn is_street(self) -> bool {
        self <= Self::Track
    }

    /// Whether cars go through on it; service roads and tracks lead to a place only.
    pub fn is_through(self) -> bool {
        self <= Self::Living
    }

    /// Whether trams or trains go on it.
    pub fn is_rail(self) -> bool {
        self >= Self::Tram
    }

    /// The word in files and pictures.
    pub fn word(self) -> &'static str {
        match self {
            Self::Motorway => "motorway",
            Self::Trunk => "trunk",
            Self::Primary => "primary",
            Self::Secondary => "secondary",
            Self::Tertiary => "tertiary",
            Self::Minor => "minor",
            Self::Residential => "residential",
            Self::Living => "living",
            Self::Service => "service",
            Self::Track => "track",
            Self::Pedestrian => "pedestrian",
            Self::Cycleway => "cycleway",
            Self::Path => "path",
            Self::Steps => "steps",
            Self::Tram => "tram",
            Self::Rail => "rail",
        }
    }
}

/// The kind of a strip.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum StripKind {
    /// A lane of the carriageway.
    Driving,
    /// A lane for bicycles.
    Cycle,
    /// A lane in which vehicles stand.
    Parking,
    /// A pavement.
    Pavement,
    /// A strip of green or a hard shoulder, on which nobody goes.
    Verge,
    /// A way of its own for people on foot, bicycles or both.
    Path,
    /// Rails.
    Track,
}

/// A strip along a road.
///
/// ```
/// use vc_map::{Strip, StripKind, Turns, Users};
/// // A lane for those who turn left at 50 km/h, and one for buses.
/// let left = Strip { turns: Turns::LEFT, ..Strip::driving(3.0, 13.9) };
/// let bus = Strip::new(StripKind::Driving, 3.5, Users::BUS, 13.9);
/// assert!(left.users.has(Users::CAR) && !bus.users.has(Users::CAR));
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Strip {
    /// Its kind.
    pub kind: StripKind,
    /// Its width, metres.
    pub width: f64,
    /// Those who may use it.
    pub users: Users,
    /// Its speed limit, metres per second.
    pub limit: f64,
    /// The directions that are marked on it.
    #[serde(default, skip_serializing_if = "unmarked")]
    pub turns: Turns,
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "serde asks for a reference")]
fn unmarked(turns: &Turns) -> bool {
    turns.is_empty()
}

impl Strip {
    /// A strip for some users, with a width in metres and a limit in metres per second.
    pub fn new(kind: StripKind, width: f64, users: Users, limit: f64) -> Self {
        Self { kind, width, users, limit, turns: Turns::NONE }
    }

    /// A pavement of a width in metres.
    pub fn pavement(width: f64) -> Self {
        Self::new(StripKind::Pavement, width, Users::FOOT, 1.4)
    }

    /// A lane for all vehicles on tyres, with a width in metres and a limit in metres per second.
    pub fn driving(width: f64, limit: f64) -> Self {
        Self::new(StripKind::Driving, width, Users::TRAFFIC, limit)
    }
}

/// The strips of a road on both sides of its divider, each side from the divider outward. A pavement along a one-way
/// street lies on the side of its outer edge; the strips of `backward` run against the road's line.
///
/// ```
/// use vc_map::{CrossSection, Strip};
/// let side = vec![Strip::driving(2.75, 8.3), Strip::pavement(2.4)];
/// let street = CrossSection { forward: side.clone(), backward: side, median: 0.0 };
/// assert_eq!(street.width(), 10.3);
/// ```
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CrossSection {
    /// The strips of those who go along the line.
    pub forward: Vec<Strip>,
    /// The strips of those who go against it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub backward: Vec<Strip>,
    /// The width of the divider, metres.
    #[serde(default)]
    pub median: f64,
}

impl CrossSection {
    /// The strips of one side, from the divider outward.
    pub fn side(&self, forward: bool) -> &[Strip] {
        if forward { &self.forward } else { &self.backward }
    }

    /// The width from outer edge to outer edge, metres.
    pub fn width(&self) -> f64 {
        self.side_width(true) + self.side_width(false) + self.median
    }

    /// The width of one side, metres.
    pub fn side_width(&self, forward: bool) -> f64 {
        self.side(forward).iter().map(|strip| strip.width).sum()
    }

    /// The width of the carriageway of one side: everything but pavements and verges, metres.
    pub fn carriageway(&self, forward: bool) -> f64 {
        let road = |strip: &&Strip| !matches!(strip.kind, StripKind::Pavement | StripKind::Verge);
        self.side(forward).iter().filter(road).map(|strip| strip.width).sum()
    }

    /// The width of both carriageways with the divider between them, metres.
    pub fn surface(&self) -> f64 {
        self.carriageway(true) + self.carriageway(false) + self.median
    }

    /// How far the divider lies from the middle of the carriageway, metres, towards the side of `backward`.
    pub fn shift(&self) -> f64 {
        (self.carriageway(true) - self.carriageway(false)) / 2.0
    }

    /// The strips of both sides with whether they run forward.
    pub fn strips(&self) -> impl Iterator<Item = (bool, &Strip)> {
        self.forward.iter().map(|strip| (true, strip)).chain(self.backward.iter().map(|strip| (false, strip)))
    }

    /// Everybody who may use one side.
    pub fn users(&self, forward: bool) -> Users {
        self.side(forward).iter().fold(Users::NONE, |all, strip| all | strip.users)
    }
}
