//! Journeys, and what happens to those who make them.

use serde::{Deserialize, Serialize};
use vc_map::{EntranceId, RoadId};

/// The number of a vehicle: that of its trip in the list that was given; in a timetable that of the person whose car it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(transparent)]
pub struct VehicleId(pub u32);

impl std::fmt::Display for VehicleId {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "vehicle {}", self.0)
    }
}

/// The number of a person: that of their walk in the list that was given; in a timetable their position in the demand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(transparent)]
pub struct PersonId(pub u32);

impl std::fmt::Display for PersonId {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "person {}", self.0)
    }
}

/// A place beside a road, on the side of one direction.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Kerb {
    /// The road.
    pub road: RoadId,
    /// Whether it lies on the side of those who go along the road's line.
    pub forward: bool,
    /// How far along the lanes of that side, metres.
    pub station: f32,
}

impl Kerb {
    /// The number of the road's side.
    pub(crate) fn side(&self) -> u32 {
        self.road.0 * 2 + u32::from(!self.forward)
    }
}

/// A journey by vehicle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Trip {
    /// The kind of vehicle: its position in the table of classes.
    pub class: u8,
    /// When it begins, seconds.
    pub departs: f32,
    /// Where it begins.
    pub from: Kerb,
    /// Where it ends.
    pub to: Kerb,
}

/// A walk from door to door.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Walk {
    /// When it begins, seconds.
    pub departs: f32,
    /// Where it begins.
    pub from: EntranceId,
    /// Where it ends.
    pub to: EntranceId,
}

/// Something that happened in a step.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum TrafficEvent {
    /// A vehicle has set out.
    Departed {
        /// The vehicle.
        vehicle: VehicleId,
    },
    /// A vehicle has arrived and left the road.
    Arrived {
        /// The vehicle.
        vehicle: VehicleId,
        /// The time since it set out, seconds.
        seconds: f32,
        /// The way that it went, metres.
        metres: f32,
    },
    /// A trip cannot be made: no way leads there, or its kind of vehicle may not begin there.
    NoWay {
        /// The vehicle.
        vehicle: VehicleId,
    },
    /// Somebody on foot has left their door.
    SetOff {
        /// The person.
        person: PersonId,
    },
    /// Somebody on foot has reached the door.
    Reached {
        /// The person.
        person: PersonId,
        /// The time since they set off, seconds.
        seconds: f32,
        /// The length of the way, metres.
        metres: f32,
    },
    /// Somebody on foot has not come on for five minutes, other than at a crossing.
    StuckOnFoot {
        /// The person.
        person: PersonId,
    },
    /// A walk cannot be made: no way leads there.
    NoWalk {
        /// The person.
        person: PersonId,
    },
    /// A vehicle that did not get into the lane of its way goes another one.
    Rerouted {
        /// The vehicle.
        vehicle: VehicleId,
    },
    /// A vehicle has driven to where its lane led, off the map or to a dead end, because it did not get into the lane of its way, and no way
    /// leads from there to its destination. It is gone.
    Lost {
        /// The vehicle.
        vehicle: VehicleId,
    },
    /// A vehicle has stood for five minutes.
    Stuck {
        /// The vehicle.
        vehicle: VehicleId,
        /// The reason.
        reason: Waiting,
    },
}

/// The reason for which a vehicle stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Waiting {
    /// Somebody stands before it.
    Queue,
    /// Its light is red.
    Light,
    /// Others are in the way at the junction, or go first.
    Others,
    /// There is no room behind the junction.
    NoRoom,
    /// Somebody crosses the road before it, or an obstacle is there.
    Blocked,
    /// It is not in a lane of its way.
    WrongLane,
}
