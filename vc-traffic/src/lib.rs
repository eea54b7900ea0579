//! Vehicles and people on foot on a map of streets, for VirtualCity: car following, lane changes, right of way, lights, crossings.
//!
//! [`Traffic`] moves vehicles on a [`StreetMap`](vc_map::StreetMap) from where their trips begin to where these end, a tenth of a
//! second at a time: they follow each other by the intelligent driver model, change lanes by MOBIL, stop at red lights, give way, keep
//! junctions free, and go over junctions, which have length. Bodies never overlap; [`Traffic::overlaps`] checks that. People walk from
//! door to door ([`Traffic::with_walks`]), avoid each other ([`Crowd`]), and cross where they and vehicles leave the way to each other.
//! Nothing is random but the wishes of drivers and people, by seed. [`Timetable`] says where everybody in a city is at any tick, as a function of it.

mod advance;
mod block;
mod bytes;
mod change;
mod class;
mod crossing;
mod crowd;
mod depart;
mod drive;
mod fcd;
mod fleet;
mod follow;
mod foot;
mod ground;
mod hook;
mod journey;
mod lights;
mod measure;
mod network;
mod obstacle;
mod pose;
mod right_of_way;
mod roads;
mod save;
mod swept;
mod timetable;
mod traffic;
mod trip;

pub use class::{ClassError, VehicleClass};
pub use crowd::{Crowd, Walker, Way};
pub use fcd::Fcd;
pub use hook::{TakenPerson, TakenVehicle};
pub use measure::{Measures, NearMiss, Nearness, StreetMeasures};
pub use obstacle::Obstacle;
pub use pose::Pose;
pub use save::SaveError;
pub use timetable::{
    Demand, DemandError, Errand, Figures, LandUse, Outing, Resident, Timetable, TimetableError, TimetableOptions,
    Whereabouts,
};
pub use traffic::{Traffic, TrafficError, TrafficOptions};
pub use trip::{Kerb, PersonId, TrafficEvent, Trip, VehicleId, Waiting, Walk};
